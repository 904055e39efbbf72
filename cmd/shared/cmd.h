/* What the commands share: the option table, help, messages, input, output, exit. The only code that
 * prints or exits. A command reads: options, read, check, compute, write.
 *
 * Every command has -h --help, -V --version, -v --verbose, -q --quiet, -o --output, -j --threads and
 * --max-memory without naming them; -s --seed and --json where its program says so. One table per
 * command feeds the parser, --help, the manual's check and the completions (--options-table prints it
 * as TSV).
 */
#ifndef HATCH_CMD_H
#define HATCH_CMD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdnoreturn.h>

#include "base/arena.h"
#include "base/bytes.h"
#include "base/parallel.h"

#define HATCH_VERSION "0.1.0"

enum cmd_type {
    CMD_FLAG,   /* bool: true when given */
    CMD_INT,    /* int64_t */
    CMD_REAL,   /* double; K, M and G suffixes are not taken */
    CMD_SIZE,   /* uint64_t bytes: a whole number with an optional K, M or G (1024-based) */
    CMD_TEXT,   /* const char * */
    CMD_TEXTS,  /* struct cmd_texts: the option may be repeated */
    CMD_CHOICE, /* int: the index into choices */
    CMD_PAIR    /* double[2]: "A:B" or "AxB" */
};

#define CMD_TEXTS_MAX 64

struct cmd_texts {
    int count;
    const char *at[CMD_TEXTS_MAX];
};

/* Terminated by an entry without a name. A value outside minimum .. maximum is refused, never
 * clamped, and the ranges are written so that NaN fails. */
struct cmd_option {
    char letter;      /* 0: long form only */
    const char *name; /* without dashes */
    enum cmd_type type;
    double minimum, maximum;    /* INT, REAL, SIZE, PAIR */
    const char *metavariable;   /* "N", "PX", "DEGREES", "FILE"; NULL for a flag */
    const char *help;           /* one line, with the default; where it begins with '+', --help only names the
                                   option, after the others: it is to fit a screen */
    void *value;                /* holds the default on entry, or what none means: NULL, a choice of -1, a number
                                   outside the range; see enum cmd_type */
    const char *const *choices; /* CHOICE: NULL-terminated */
    bool *given;                /* may be NULL: set when the option stood on the command line */
};

struct cmd_program {
    const char *name;            /* "tamgen" */
    const char *operands;        /* "[FILE]", "A B", "" */
    const char *summary;         /* one line: what it does */
    const char *const *examples; /* NULL-terminated shell lines, two or so */
    const struct cmd_option *options;
    int operands_min, operands_max; /* max -1: any number */
    bool seeded;                    /* takes -s --seed */
    bool reports;                   /* takes --json */
    bool binary;                    /* its output is binary: never written to a terminal */
};

/* What the common options said, and the operands. */
struct cmd_args {
    const char *output;  /* NULL or "-": standard output */
    uint32_t threads;    /* 1 .. 256; default: the processors at hand */
    uint64_t max_memory; /* bytes, for each of keep and scratch; default 4 GiB */
    uint64_t seed;       /* default 1 */
    bool json, verbose, quiet;
    int operand_count;
    char **operands;
    struct hatch_arena keep, scratch; /* initialised with max_memory */
    struct hatch_pool *pool;          /* made on the first cmd_pool() */
};

/* Parses; prints help or version and exits 0, or two lines and exits 2. Installs the handlers that
 * remove unfinished output on SIGINT, SIGTERM and SIGHUP. Call first. */
void cmd_begin(const struct cmd_program *program, int argc, char **argv, struct cmd_args *args);

/* Gives an option a value, as if it had stood on the command line; dies as that would. */
void cmd_take(const struct cmd_option *option, const char *text);

/* The pool of args->threads threads. */
struct hatch_pool *cmd_pool(struct cmd_args *args);

/* Whole content of a file ("-" or NULL: standard input, which is never seeked), in args->keep. A
 * missing or unreadable file is HATCH_IO, a directory HATCH_BAD_INPUT. Dies on failure. */
struct hatch_bytes cmd_read(struct cmd_args *args, const char *path);

/* The same, failing by status; for companions of a file (a glTF's .bin). */
enum hatch_status cmd_try_read(struct hatch_arena *arena, const char *path, struct hatch_bytes *bytes,
                               struct hatch_err *err) HATCH_MUST_USE;

/* The path of a file that comes with the commands, in args->keep: "share/hatch/styles/ink.style",
 * "lib/hatch/hatch-oiio.so". It is looked for beside the folder that holds the executable, which is the
 * same in the build tree and after an installation, wherever that was moved. It may not exist. */
const char *cmd_own_file(struct cmd_args *args, const char *relative);

/* How messages name an input: "standard input" for "-" or NULL. */
const char *cmd_input_name(const char *path);

#define CMD_OUTPUTS_MAX 4096

struct cmd_output;

/* Opens an output before the work is done, so that a missing or read-only folder fails at once: a
 * hidden file beside path, or the file itself where it is no regular file, or standard output. Refuses
 * a terminal for binary data, and a second output in the same place. Dies on failure. path: NULL or
 * "-" is standard output. */
struct cmd_output *cmd_open_output(const char *path, bool binary);

/* Refuses, as wrong usage, a name that ends like a file of another format than those listed ("png exr"):
 * a picture called teapot.jpg that holds PNG misleads. Other names, and NULL, pass. */
void cmd_check_ending(const char *path, const char *endings);

/* An output and all that goes into it: size bytes of data, and after them pieces, if there are any. */
struct cmd_file {
    struct cmd_output *output;
    const void *data;
    size_t size;
    const struct hatch_bytes *pieces;
    size_t piece_count;
};

/* Writes every file whole, closes it and checks each step; only when all of them are on disk do hidden
 * files take their names. Dies on failure, and then every old file is as it was. The outputs are gone
 * afterwards. */
void cmd_write_all(const struct cmd_file *files, size_t count);

/* Writes a file's bytes before the others are there, so that they need not be kept; it gets its name with them,
 * from cmd_write_all, which wants it without data then. false, and nothing is done, where the output is no file
 * but a pipe or a device. Dies on failure. */
bool cmd_write_ahead(const struct cmd_file *file);

/* The same for one output. A command that makes several writes them together, after all are encoded. */
void cmd_write(struct cmd_output *output, const void *data, size_t size);

/* Ends the command: frees, checks that standard output took everything, returns status for main. */
int cmd_end(struct cmd_args *args, enum hatch_status status);

/* "tamgen: FILE: sentence" on standard error, and exit with err's status; unfinished outputs go. file
 * may be NULL. Wrong usage has a second line, "try --help". */
noreturn void cmd_die(const char *file, const struct hatch_err *err);

/* Dies when status is not HATCH_OK: cmd_check(f(..., &err), path, &err). */
void cmd_check(enum hatch_status status, const char *file, const struct hatch_err *err);

/* Two lines on standard error, the sentence and "try --help"; exit 2. */
noreturn void cmd_usage(const char *format, ...) HATCH_PRINTF(1, 2);

/* "tamgen: FILE: warning: sentence", unless --quiet. */
void cmd_warn(const char *file, const char *format, ...) HATCH_PRINTF(2, 3);

/* "tamgen: sentence", only with --verbose. */
void cmd_note(const char *format, ...) HATCH_PRINTF(1, 2);

/* The noun that goes with a count: "1 patch", "2 patches". */
static inline const char *cmd_noun(uint64_t count, const char *one, const char *many)
{
    return count == 1 ? one : many;
}

/* "render-gl: sentence": what somebody in front of a window asked for. */
void cmd_say(const char *format, ...) HATCH_PRINTF(1, 2);

/* Milliseconds since cmd_begin, of a clock that only runs forward. */
double cmd_elapsed_ms(void);

/* A progress line on standard error, only on a terminal and only after a second. share: 0 .. 1. */
void cmd_progress(const char *what, double share);

#endif
