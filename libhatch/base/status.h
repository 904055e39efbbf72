/* How anything that can fail says so: a status as the value, a sentence in the struct.
 *
 * A function that can fail returns enum hatch_status and takes a struct hatch_err last. On failure
 * it fills the struct, where the fault was seen, and leaves its other outputs unchanged. A caller's
 * mistake (a null pointer, an index out of range) is an assert; what a file or a user may get wrong
 * is a status. Nothing in libhatch prints or exits. Where a comment names no status, HATCH_LIMIT is the
 * only one: memory or a size did not suffice.
 */
#ifndef HATCH_BASE_STATUS_H
#define HATCH_BASE_STATUS_H

/* The values are the exit statuses of the commands (hatch(7)). */
enum hatch_status {
    HATCH_OK = 0,
    HATCH_DIFFERS = 1,   /* a check or a comparison said no */
    HATCH_USAGE = 2,     /* options or arguments are wrong */
    HATCH_BAD_INPUT = 3, /* a file's content is wrong: trying again will not help */
    HATCH_IO = 4,        /* reading or writing failed: trying again may help */
    HATCH_LIMIT = 5      /* memory or a size limit was reached */
};

#define HATCH_ERR_TEXT_MAX 320

/* text: one sentence with the place, lower case, no full stop, no program and no file name
 * ("row 12: 3 fields, want 4"); it is complete enough to print as it stands. */
struct hatch_err {
    enum hatch_status status;
    char text[HATCH_ERR_TEXT_MAX];
};

#if defined(__GNUC__)
#define HATCH_MUST_USE __attribute__((warn_unused_result))
#define HATCH_PRINTF(f, a) __attribute__((format(printf, f, a)))
#else
#define HATCH_MUST_USE
#define HATCH_PRINTF(f, a)
#endif

/* Fills err with status and the formatted sentence, cut to fit; control bytes become '?', so that
 * text from a hostile file is safe on a terminal. Returns status. err may be NULL. */
enum hatch_status hatch_fail(struct hatch_err *err, enum hatch_status status, const char *format, ...)
    HATCH_PRINTF(3, 4);

/* Puts a formatted prefix before err's sentence ("tone.003: " + ...) and returns err's status. */
enum hatch_status hatch_fail_at(struct hatch_err *err, const char *format, ...) HATCH_PRINTF(2, 3);

/* Returns from the calling function when expr is not HATCH_OK. For functions without clean-up. */
#define HATCH_TRY(expr)                                                                                                \
    do {                                                                                                               \
        enum hatch_status hatch_try_status_ = (expr);                                                                  \
        if (hatch_try_status_ != HATCH_OK)                                                                             \
            return hatch_try_status_;                                                                                  \
    } while (0)

#endif
