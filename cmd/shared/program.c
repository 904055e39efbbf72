#define _GNU_SOURCE
#include "base/text.h"
#include "shared/private.h"

#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

const struct cmd_program *cmd_current_program;
bool cmd_is_quiet, cmd_is_verbose;

/* Warnings that wait for cmd_show_warnings, as lines. Those that find no room are printed at once. */
static char held[1 << 16];
static size_t held_bytes;

static struct timespec begun, last_progress;
static bool progress_shown;

/* Opens those of the descriptors 0, 1 and 2 that are closed. Otherwise the next file opened would get such a
 * descriptor, and with it the output meant for the standard stream. They are opened in the wrong direction, so that
 * their use fails. */
static void keep_standard_descriptors(void)
{
    for (int descriptor = 0; descriptor <= 2; descriptor++)
        if (fcntl(descriptor, F_GETFD) < 0 && errno == EBADF)
            if (open("/dev/null", descriptor == 0 ? O_WRONLY : O_RDONLY) != descriptor)
                _exit(HATCH_IO);
}

void cmd_begin(const struct cmd_program *program, int argc, char **argv, struct cmd_args *args)
{
    keep_standard_descriptors();
    clock_gettime(CLOCK_MONOTONIC, &begun);
    cmd_current_program = program;
    cmd_parse(program, argc, argv, args);
    cmd_is_quiet = args->quiet;
    cmd_is_verbose = args->verbose && !args->quiet;
    hatch_arena_init(&args->keep, (size_t)args->max_memory);
    hatch_arena_init(&args->scratch, (size_t)args->max_memory);
    hatch_arena_init(&args->pool_arena, (size_t)args->max_memory);
    cmd_install_signal_handlers();
}

struct hatch_pool *cmd_pool(struct cmd_args *args)
{
    if (!args->pool) {
        struct hatch_err err;
        /* New threads inherit blocked signals, so only the first thread runs the handlers. */
        cmd_block_signals(true);
        enum hatch_status status = hatch_pool_make(args->threads, &args->pool_arena, &args->pool, &err);
        cmd_block_signals(false);
        cmd_check(status, NULL, &err);
    }
    return args->pool;
}

int cmd_end(struct cmd_args *args, enum hatch_status status)
{
    cmd_clear_progress();
    hatch_pool_free(args->pool);
    hatch_arena_free(&args->pool_arena);
    hatch_arena_free(&args->scratch);
    hatch_arena_free(&args->keep);
    cmd_discard_outputs();
    cmd_close_stdout();
    cmd_show_warnings();
    return (int)status;
}

enum hatch_status cmd_fail_errno(struct hatch_err *err, const char *sentence, int error_number)
{
    char reason[HATCH_ERR_TEXT_MAX];
    snprintf(reason, sizeof reason, "%s", strerror(error_number));
    reason[0] = (char)tolower((unsigned char)reason[0]);
    return hatch_fail(err, error_number == ENOMEM ? HATCH_LIMIT : HATCH_IO, "%s: %s", sentence, reason);
}

/* Writes a line to standard error, in one write, so that lines of several processes do not mix; or holds it for
 * cmd_show_warnings. Control characters become '?'. */
static void print_line(bool hold, const char *file, const char *kind, const char *sentence)
{
    char line[PATH_MAX + 2 * HATCH_ERR_TEXT_MAX];
    int length = snprintf(line, sizeof line - 1, "%s: %s%s%s%s", cmd_current_program->name, file ? file : "",
                          file ? ": " : "", kind, sentence);
    size_t size = length < (int)sizeof line - 1 ? (size_t)length : sizeof line - 2;
    line[size] = '\n';
    hatch_utf8_make_plain(line, size);
    if (hold && size + 1 <= sizeof held - held_bytes) {
        memcpy(held + held_bytes, line, size + 1);
        held_bytes += size + 1;
        return;
    }
    cmd_clear_progress();
    fwrite(line, 1, size + 1, stderr);
}

void cmd_show_warnings(void)
{
    if (held_bytes > 0)
        cmd_clear_progress();
    fwrite(held, 1, held_bytes, stderr);
    held_bytes = 0;
}

noreturn void cmd_die(const char *file, const struct hatch_err *err)
{
    cmd_discard_outputs();
    print_line(false, file, "", err->text);
    if (err->status == HATCH_USAGE)
        fprintf(stderr, "try '%s --help'\n", cmd_current_program->name);
    exit((int)err->status);
}

void cmd_check(enum hatch_status status, const char *file, const struct hatch_err *err)
{
    if (status != HATCH_OK)
        cmd_die(file, err);
}

static void print_formatted(bool hold, const char *file, const char *kind, const char *format, va_list args)
{
    struct hatch_err sentence;
    vsnprintf(sentence.text, sizeof sentence.text, format, args);
    print_line(hold, file, kind, sentence.text);
}

noreturn void cmd_usage(const char *format, ...)
{
    struct hatch_err sentence = {.status = HATCH_USAGE};
    va_list args;
    va_start(args, format);
    vsnprintf(sentence.text, sizeof sentence.text, format, args);
    va_end(args);
    cmd_die(NULL, &sentence);
}

int cmd_find_name(const char *const *names, const char *word)
{
    for (int i = 0; names[i]; i++)
        if (strcmp(names[i], word) == 0)
            return i;
    return -1;
}

noreturn void cmd_refuse_name(const char *what, const char *word, const char *const *names, const char *more)
{
    struct hatch_text text = {word, strlen(word)};
    const char *near = NULL;
    char all[HATCH_ERR_TEXT_MAX] = "";
    for (int i = 0; names[i]; i++) {
        size_t used = strlen(all);
        snprintf(all + used, sizeof all - used, "%s%s", i ? ", " : "", names[i]);
        near = hatch_text_is_near(text, names[i]) ? names[i] : near;
    }
    cmd_usage("%s: '%s' is not one of %s%s%s%s%s", what, word, all, more ? ", and not " : "", more ? more : "",
              near ? "; perhaps " : "", near ? near : "");
}

void cmd_warn(const char *file, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    if (!cmd_is_quiet)
        print_formatted(true, file, "warning: ", format, args);
    va_end(args);
}

void cmd_note(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    if (cmd_is_verbose)
        print_formatted(false, NULL, "", format, args);
    va_end(args);
}

void cmd_say(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    print_formatted(false, NULL, "", format, args);
    va_end(args);
}

static double seconds_between(struct timespec from, struct timespec to)
{
    return (double)(to.tv_sec - from.tv_sec) + 1e-9 * (double)(to.tv_nsec - from.tv_nsec);
}

double cmd_elapsed_ms(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return 1e3 * seconds_between(begun, now);
}

void cmd_progress(const char *what, double share)
{
    static int on_terminal = -1;
    if (on_terminal < 0)
        on_terminal = isatty(STDERR_FILENO);
    if (!on_terminal || cmd_is_quiet)
        return;
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    if (seconds_between(begun, now) < 1 || (progress_shown && seconds_between(last_progress, now) < 0.1))
        return;
    fprintf(stderr, "\r%s: %s %d %%", cmd_current_program->name, what, (int)(100 * share));
    last_progress = now;
    progress_shown = true;
}

static void report_share(void *context, double share)
{
    cmd_progress(context, share);
}

struct hatch_progress cmd_progress_of(const char *what)
{
    return (struct hatch_progress){report_share, (void *)what};
}

void cmd_clear_progress(void)
{
    if (progress_shown)
        fputs("\r\033[K", stderr);
    progress_shown = false;
}
