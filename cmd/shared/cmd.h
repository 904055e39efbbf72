/* Code that all commands share: options, help, messages, input, output and exit. No other code prints or exits. A
 * command works in this order: it parses its options, reads, checks, computes and writes.
 *
 * Every command has -h --help, -V --version, -v --verbose, -q --quiet, -o --output, -j --threads and --max-memory; it
 * has -s --seed and --json if its struct cmd_program says so. One table per command feeds the parser, --help, the check
 * of the manual and the completions (--options-table prints it as TSV).
 *
 * A function that dies prints a message and exits with the status of the error. */
#ifndef SHARED_CMD_H
#define SHARED_CMD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdnoreturn.h>

#include "base/arena.h"
#include "base/bytes.h"
#include "base/parallel.h"
#include "base/progress.h"

#define HATCH_VERSION "0.1.0"

/* Type of an option's value. */
enum cmd_type {
    CMD_FLAG,   /* bool: true when given */
    CMD_INT,    /* int64_t */
    CMD_REAL,   /* double */
    CMD_SIZE,   /* uint64_t bytes: a whole number with an optional suffix K, M or G (1024-based) */
    CMD_TEXT,   /* const char * */
    CMD_TEXTS,  /* struct cmd_texts: the option may be repeated */
    CMD_CHOICE, /* int: index into choices */
    CMD_PAIR,   /* double[2]: "A:B" or "AxB" */
    CMD_WHOLES  /* the same, of whole numbers */
};

#define CMD_TEXTS_MAX 64

struct cmd_texts {
    int count;
    const char *at[CMD_TEXTS_MAX];
};

/* A table of options ends with an entry without a name. Values out of range, and NaN, are rejected. */
struct cmd_option {
    char letter;      /* 0: long form only */
    const char *name; /* without dashes */
    enum cmd_type type;
    double minimum, maximum;  /* range of INT, REAL, SIZE and of each number of PAIR */
    const char *metavariable; /* such as "N", "PX", "DEGREES" or "FILE"; NULL for a flag */
    const char *help; /* one line, with the default; if it begins with '+', --help lists only the option's name, after
                         the other options, so that the help fits a screen */
    void *value;      /* in: the default, or a value that means "not given": NULL, a choice of -1, a number outside the
                         range; out: the value given; its type as in enum cmd_type */
    const char *const *choices; /* names that a CHOICE accepts, or a TEXT among others, NULL-terminated */
    bool *given;                /* set to true when the option is on the command line; may be NULL */
};

/* A rule tells what options need to have an effect; without it they are refused. An option that is given with its
 * default value counts as given. A table of rules ends with an entry without options.
 *
 * The conditions of a rule are separated by spaces, and all must hold; the alternatives of a condition are separated by
 * '|', and one must hold: "NAME", option NAME is given; "!NAME", it is not given; "NAME=A,B", the value of NAME, a
 * choice or a text, is A or B; "NAME!=A", it is not A; "NAME=*.svg", the value ends in .svg or .SVG. A name in capitals
 * is that of the first operand. */
struct cmd_rule {
    const char *options; /* names, separated by spaces */
    const char *needs;   /* conditions */
    const char *reason;  /* ends the message: "which computes the share"; may be NULL */
};

struct cmd_program {
    const char *name;            /* such as "tamgen" */
    const char *operands;        /* such as "[FILE]" or "A B"; "": none; several forms are separated by newlines */
    const char *summary;         /* one line or several */
    const char *const *examples; /* shell commands, NULL-terminated; about two */
    const struct cmd_option *options;
    const struct cmd_rule *rules;   /* may be NULL */
    const char *const *names;       /* names that the first operand accepts, NULL-terminated; NULL: it is a file */
    int operands_min, operands_max; /* operands_max -1: any number */
    bool seeded;                    /* has -s --seed */
    bool reports;                   /* has --json */
    bool binary;                    /* its output is binary and never written to a terminal */
};

/* Values of the common options, and the operands. */
struct cmd_args {
    const char *output;  /* NULL or "-": standard output */
    uint32_t threads;    /* 1 .. 256; default: number of processors */
    uint64_t max_memory; /* bytes, for each of keep and scratch; default 4 GiB */
    uint64_t seed;       /* random seed; default 1 */
    bool json, verbose, quiet;
    int operand_count;
    int name; /* index of the first operand in struct cmd_program's names */
    char **operands;
    struct hatch_arena keep;       /* arena that lives until cmd_end; its limit is max_memory */
    struct hatch_arena scratch;    /* scratch arena with the same lifetime and limit */
    struct hatch_pool *pool;       /* private: see cmd_pool */
    struct hatch_arena pool_arena; /* private: holds the pool, which may be made after a mark of keep */
};

/* Parses the command line. Prints help or version and exits with 0; prints two lines and exits with 2 on wrong usage.
 * Installs handlers that remove unfinished outputs when a signal ends the process. Call it first. */
void cmd_begin(const struct cmd_program *program, int argc, char **argv, struct cmd_args *args);

/* Sets the value of an option as if it stood on the command line; dies on an invalid value. */
void cmd_set_option(const struct cmd_option *option, const char *text);

/* Checks the program's rules again as if an option stood on the command line, too: it is one that others set. Dies as
 * cmd_begin does. */
void cmd_imply_option(const struct cmd_option *option);

/* Returns the thread pool, made on the first call. */
struct hatch_pool *cmd_pool(struct cmd_args *args);

/* Reads a whole file into args->keep. Dies on failure: HATCH_IO for a missing or unreadable file, HATCH_BAD_INPUT for a
 * directory.
 *   path  NULL or "-": standard input, at most once */
struct hatch_bytes cmd_read(struct cmd_args *args, const char *path);

/* Does the same into an arena. */
struct hatch_bytes cmd_read_into(struct hatch_arena *arena, const char *path);

/* Reads a whole file like cmd_read, but returns the status instead of dying. For companion files, such as the .bin file
 * of a glTF. */
enum hatch_status cmd_try_read(struct hatch_arena *arena, const char *path, struct hatch_bytes *bytes,
                               struct hatch_err *err) HATCH_MUST_USE;

/* Returns, in args->keep, the path of a file that is installed with the commands: the relative path, taken from the
 * parent of the folder that holds the executable. The build tree has the same layout as an installation. The file may
 * not exist.
 *   relative  such as "share/hatch/styles/ink.style" or "lib/hatch/hatch-oiio.so" */
const char *cmd_installed_path(struct cmd_args *args, const char *relative);

/* Returns the name of an input for messages: path, or "standard input" for NULL or "-". */
const char *cmd_input_name(const char *path);

#define CMD_OUTPUTS_MAX 4097 /* the most frames of render-gl, and their times */

struct cmd_output;

/* Opens an output before the work is done, so that a missing or read-only folder fails at once. Makes a hidden file
 * beside path; if path is a device or a pipe, opens it instead. Names such as /dev/stdout and /dev/fd/3 are open
 * descriptors, to which the output is added. Dies on failure, when binary data would go to a terminal, for a second
 * output to the same file or pipe, and as cmd_check_ending does.
 *   path     NULL or "-", or any name of the same file or pipe: standard output
 *   endings  as in cmd_check_ending */
struct cmd_output *cmd_open_output(const char *path, const char *endings, bool binary);

/* Dies with HATCH_USAGE if a file name has the ending of a known format that is not among the allowed ones. Other
 * endings, and names without one, are allowed.
 *   path     may be NULL
 *   endings  allowed endings, without dots, separated by spaces, such as "png exr" */
void cmd_check_ending(const char *path, const char *endings);

/* An output and its content: size bytes of data, followed by the pieces. */
struct cmd_file {
    struct cmd_output *output;
    const void *data;
    size_t size;
    const struct hatch_bytes *pieces; /* piece_count entries */
    size_t piece_count;
};

/* Writes and closes all files, then renames the hidden files to their targets and frees the outputs. Dies on failure;
 * if writing failed, no old file has changed. */
void cmd_write_all(const struct cmd_file *files, size_t count);

/* Writes the content of one file early, so that it need not be kept in memory. A later cmd_write_all, without data for
 * this output, renames it. Returns false, without doing anything, if the output is not a regular file. Dies on
 * failure. */
bool cmd_write_ahead(const struct cmd_file *file);

/* Writes a single output like cmd_write_all. */
void cmd_write(struct cmd_output *output, const void *data, size_t size);

/* Has a function called when the command ends: by cmd_end, by a message that exits, or by a signal. It may be called
 * several times, and calls only what is safe in a signal handler. */
void cmd_on_end(void (*clean_up)(void));

/* Ends the command: frees everything, checks that standard output was written, and returns status for main. */
int cmd_end(struct cmd_args *args, enum hatch_status status);

/* Prints "tamgen: FILE: sentence" to standard error, followed by "try 'tamgen --help'" for HATCH_USAGE; removes
 * unfinished outputs and exits with the status of err.
 *   file  may be NULL */
noreturn void cmd_die(const char *file, const struct hatch_err *err);

/* Dies if status is not HATCH_OK. Used as cmd_check(f(..., &err), path, &err). */
void cmd_check(enum hatch_status status, const char *file, const struct hatch_err *err);

/* Dies with HATCH_USAGE. */
noreturn void cmd_usage(const char *format, ...) HATCH_PRINTF(1, 2);

/* Returns the index of a word among names, which end with NULL; -1 if it is none of them. */
int cmd_find_name(const char *const *names, const char *word);

/* Dies with HATCH_USAGE for a word that is none of the names: lists them, and suggests one that differs by one typing
 * error.
 *   what  what the word stands for, such as "--uv" or "style"
 *   more  what else is accepted, such as "a file"; NULL: nothing */
noreturn void cmd_refuse_name(const char *what, const char *word, const char *const *names, const char *more);

/* Keeps "tamgen: FILE: warning: sentence" for standard error, unless --quiet. Warnings are printed when the command has
 * succeeded; one that fails prints its refusal alone.
 *   file  may be NULL */
void cmd_warn(const char *file, const char *format, ...) HATCH_PRINTF(2, 3);

/* Prints the warnings so far: for a command that goes on for as long as its user likes. cmd_end prints the others. */
void cmd_show_warnings(void);

/* Prints "tamgen: sentence" to standard error with --verbose. */
void cmd_note(const char *format, ...) HATCH_PRINTF(1, 2);

/* Prints "tamgen: sentence" to standard error, even with --quiet. */
void cmd_say(const char *format, ...) HATCH_PRINTF(1, 2);

/* Returns the form of a noun that fits a count: "1 patch", "2 patches". */
static inline const char *cmd_plural(uint64_t count, const char *one, const char *many)
{
    return count == 1 ? one : many;
}

/* Returns the milliseconds since cmd_begin, by a monotonic clock. */
double cmd_elapsed_ms(void);

/* Prints a progress line to standard error, but only if that is a terminal, and only after a second.
 *   what   things that are counted, such as "patches"
 *   share  0 .. 1 */
void cmd_progress(const char *what, double share);

/* Returns the progress of a computation in libhatch, for which cmd_progress is called.
 *   what  as in cmd_progress; kept by reference */
struct hatch_progress cmd_progress_of(const char *what);

#endif
