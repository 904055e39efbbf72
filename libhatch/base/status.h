/* Error handling: a status as the return value, a message in a struct.
 *
 * A function that can fail returns enum hatch_status and takes a struct hatch_err last. On failure it fills the struct
 * and leaves its other outputs unchanged. Programming errors (a null pointer, an index out of range) are asserted;
 * errors in files or options are statuses. Nothing in libhatch prints or exits. Where a comment names no status, the
 * only one besides HATCH_OK is HATCH_LIMIT: memory ran out, or a size limit was exceeded. */
#ifndef HATCH_BASE_STATUS_H
#define HATCH_BASE_STATUS_H

#include <stddef.h>

/* The values are the exit statuses of the commands (hatch(7)). */
enum hatch_status {
    HATCH_OK = 0,
    HATCH_DIFFERS = 1,   /* a check or a comparison failed */
    HATCH_USAGE = 2,     /* options or arguments are wrong */
    HATCH_BAD_INPUT = 3, /* the content of a file is wrong: trying again will not help */
    HATCH_IO = 4,        /* reading or writing failed: trying again may help */
    HATCH_LIMIT = 5      /* memory or a size limit was reached */
};

#define HATCH_ERR_TEXT_MAX 512

struct hatch_err {
    enum hatch_status status;
    char text[HATCH_ERR_TEXT_MAX]; /* complete message with the place, but no program or file name; lower case, no full
                                      stop: "row 12: 3 fields, want 4" */
};

#if defined(__GNUC__)
#define HATCH_MUST_USE __attribute__((warn_unused_result))
#define HATCH_PRINTF(f, a) __attribute__((format(printf, f, a)))
#else
#define HATCH_MUST_USE
#define HATCH_PRINTF(f, a)
#endif

/* Fills err with a status and a formatted message, cut to fit; returns the status. Control characters become '?', so
 * that text from a hostile file is safe on a terminal.
 *   err  may be NULL */
enum hatch_status hatch_fail(struct hatch_err *err, enum hatch_status status, const char *format, ...)
    HATCH_PRINTF(3, 4);

/* Puts a formatted prefix before err's message ("tone.003: "); returns err's status. */
enum hatch_status hatch_fail_at(struct hatch_err *err, const char *format, ...) HATCH_PRINTF(2, 3);

/* Like hatch_fail, with the message of another library after a sentence of one's own: "the PNG is damaged: CRC error".
 * Of that message, only the first line is taken, with a small first letter and without a full stop.
 *   text  the message; NULL or empty: the sentence stands alone */
enum hatch_status hatch_fail_quoting(struct hatch_err *err, enum hatch_status status, const char *text,
                                     const char *format, ...) HATCH_PRINTF(4, 5);

/* Evaluates expr and returns its status from the calling function, unless the status is HATCH_OK. */
#define HATCH_TRY(expr)                                                                                                \
    do {                                                                                                               \
        enum hatch_status hatch_try_status_ = (expr);                                                                  \
        if (hatch_try_status_ != HATCH_OK)                                                                             \
            return hatch_try_status_;                                                                                  \
    } while (0)

/* Returns the length of the UTF-8 character at the start of a text: 1 to 4; 0 if the text begins with no character.
 * Overlong forms, surrogates and numbers over 0x10ffff are none (RFC 3629, section 4).
 *   text  ends with a byte that continues no character, such as 0 */
size_t hatch_utf8_length(const char *text);

/* Replaces the bytes of control characters by '?', so that a terminal shows the text and obeys none of it: U+0000 to
 * U+001F, U+007F to U+009F, and bytes 80 to 9f that belong to no character. The text may contain zeros.
 *   text  length bytes, and one more, which ends it */
void hatch_utf8_make_plain(char *text, size_t length);

#endif
