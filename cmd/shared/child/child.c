#define _GNU_SOURCE
#include "shared/child/child.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <math.h>
#include <signal.h>
#include <spawn.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "shared/private.h"

#define LIMIT_MOST_S 1e9 /* longer limits are cut to this */

extern char **environ;

/* Read by clean_up, which a signal handler calls. */
static char folder[PATH_MAX];
static int folder_descriptor = -1;
static volatile pid_t running; /* the child; 0: none */

/* Ends the child, which then removes its own unfinished files, and removes the folder. Calls only what is safe in a
 * signal handler. */
static void clean_up(void)
{
    static char entries[1 << 14] __attribute__((aligned(16)));
    int before = errno;
    if (running > 0 && kill(running, SIGTERM) == 0)
        while (waitpid(running, NULL, 0) < 0 && errno == EINTR)
            continue;
    running = 0;
    if (folder_descriptor < 0)
        return;
    for (bool any = true; any;) { /* an entry may be passed over while others are removed */
        any = false;
        lseek(folder_descriptor, 0, SEEK_SET);
        ssize_t bytes;
        while ((bytes = getdents64(folder_descriptor, entries, sizeof entries)) > 0)
            for (ssize_t at = 0; at < bytes;) {
                const struct dirent64 *entry = (const void *)(entries + at);
                any = unlinkat(folder_descriptor, entry->d_name, 0) == 0 || any; /* fails for "." and ".." */
                at += entry->d_reclen;
            }
    }
    rmdir(folder);
    close(folder_descriptor);
    folder_descriptor = -1;
    errno = before;
}

void cmd_child_make_folder(void)
{
    const char *parent = getenv("TMPDIR");
    struct hatch_err err;
    parent = parent && *parent ? parent : "/tmp";
    int length = snprintf(folder, sizeof folder, "%s/%s-XXXXXX", parent, cmd_current_program->name);
    if (length >= (int)sizeof folder || strchr(folder, '%'))
        cmd_check(hatch_fail(&err, HATCH_IO, "no folder for temporary files: set TMPDIR to one without %%"), parent,
                  &err);
    cmd_block_signals(true);
    bool made = mkdtemp(folder) != NULL;
    int reason = errno;
    if (made)
        folder_descriptor = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    cmd_on_end(clean_up);
    cmd_block_signals(false);
    if (!made)
        cmd_check(cmd_fail_errno(&err, "cannot make a temporary folder there: set TMPDIR", reason), parent, &err);
}

/* Prints a text into args->keep. */
static char *print(struct cmd_args *args, const char *format, va_list values)
{
    struct hatch_err err;
    va_list again;
    va_copy(again, values);
    int length = vsnprintf(NULL, 0, format, again);
    va_end(again);
    char *text = HATCH_NEW(&args->keep, char, (size_t)length + 1, &err);
    cmd_check(text ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    vsnprintf(text, (size_t)length + 1, format, values);
    return text;
}

const char *cmd_child_path(struct cmd_args *args, const char *format, ...)
{
    struct cmd_child_words words = {.args = args};
    va_list values;
    va_start(values, format);
    const char *name = print(args, format, values);
    va_end(values);
    cmd_child_add(&words, "%s/%s", folder, name);
    return words.at[0];
}

void cmd_child_begin(struct cmd_child_words *words, struct cmd_args *args, const char *command)
{
    *words = (struct cmd_child_words){.args = args};
    cmd_child_add(words, "%s", command);
}

void cmd_child_add(struct cmd_child_words *words, const char *format, ...)
{
    va_list values;
    if (words->count == CMD_CHILD_WORDS_MAX)
        cmd_usage("more than %d words for one command", CMD_CHILD_WORDS_MAX);
    va_start(values, format);
    words->at[words->count++] = print(words->args, format, values);
    va_end(values);
}

void cmd_child_add_all(struct cmd_child_words *words, const char *option, const char *text)
{
    struct hatch_err err;
    char *word = HATCH_NEW(&words->args->keep, char, strlen(text) + 1, &err);
    cmd_check(word ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    while (*(text += strspn(text, " ")) != '\0') {
        size_t used = 0;
        char mark = '\0';
        for (; *text && (mark || *text != ' '); text++)
            if (*text == mark)
                mark = '\0';
            else if (!mark && (*text == '\'' || *text == '"'))
                mark = *text;
            else
                word[used++] = *text;
        word[used] = '\0';
        if (mark)
            cmd_usage("--%s: the last %c is missing", option, mark);
        cmd_child_add(words, "%s", word);
    }
}

const char *cmd_child_keep_input(struct cmd_args *args, struct hatch_bytes file)
{
    const char *path = cmd_child_path(args, "input");
    struct hatch_err err;
    int descriptor = open(path, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    bool written = descriptor >= 0;
    for (size_t at = 0; written && at < file.size;) {
        ssize_t bytes = write(descriptor, file.data + at, file.size - at);
        written = bytes > 0 || (bytes < 0 && errno == EINTR);
        at += bytes > 0 ? (size_t)bytes : 0;
    }
    if (!written || lseek(descriptor, 0, SEEK_SET) < 0 || dup2(descriptor, STDIN_FILENO) < 0)
        cmd_check(cmd_fail_errno(&err, "cannot write", errno), folder, &err);
    close(descriptor);
    return path;
}

static double seconds_of(const struct rusage *usage)
{
    return (double)(usage->ru_utime.tv_sec + usage->ru_stime.tv_sec) +
           1e-6 * (double)(usage->ru_utime.tv_usec + usage->ru_stime.tv_usec);
}

double cmd_child_processor_s(void)
{
    struct rusage own, children;
    getrusage(RUSAGE_SELF, &own);
    getrusage(RUSAGE_CHILDREN, &children);
    return seconds_of(&own) + seconds_of(&children);
}

/* Takes the first line of what a child has printed, without its name.
 *   size  bytes of the text, which changes */
static void take_sentence(const char *command, char *text, size_t size, char *sentence)
{
    size_t named = strlen(command);
    text[size] = '\0';
    text[strcspn(text, "\n")] = '\0';
    if (strncmp(text, command, named) == 0 && strncmp(text + named, ": ", 2) == 0)
        text += named + 2;
    snprintf(sentence, HATCH_ERR_TEXT_MAX, "%s", text);
}

/* Starts a child and sets `running`. Returns an error number of the system, 0 on success.
 *   words  file that its messages go to */
static int start(const struct cmd_child_words *line, int words)
{
    const char *path = cmd_installed_path(line->args, "bin/");
    struct cmd_child_words beside = {.args = line->args};
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    sigset_t none;
    pid_t pid = 0;
    cmd_child_add(&beside, "%s%s", path, line->at[0]);
    sigemptyset(&none);
    if (posix_spawn_file_actions_init(&files))
        return ENOMEM;
    if (posix_spawnattr_init(&attributes)) {
        posix_spawn_file_actions_destroy(&files);
        return ENOMEM;
    }
    int failed = posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
    failed = failed ? failed
                    : posix_spawn_file_actions_addopen(&files, 1, line->output ? line->output : "/dev/null",
                                                       O_WRONLY | O_CREAT | O_TRUNC, 0600);
    failed = failed ? failed : posix_spawn_file_actions_adddup2(&files, words, 2);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
    cmd_block_signals(true);
    if (!failed)
        failed = posix_spawnp(&pid, access(beside.at[0], X_OK) == 0 ? beside.at[0] : line->at[0], &files, &attributes,
                              (char *const *)line->at, environ);
    running = failed ? 0 : pid;
    cmd_block_signals(false);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    return failed;
}

static void limit_time(double limit_s)
{
    const rlim_t seconds = (rlim_t)fmin(fmax(ceil(limit_s), 1), LIMIT_MOST_S);
    const struct rlimit limit = {seconds, seconds + 1};
    prlimit(running, RLIMIT_CPU, &limit, NULL);
}

/* Waits for the child. */
static void wait_for_end(struct cmd_child_end *end)
{
    struct rusage usage;
    siginfo_t info;
    int status = 0;
    while (waitid(P_PID, (id_t)running, &info, WEXITED | WNOWAIT) < 0 && errno == EINTR)
        continue;
    cmd_block_signals(true); /* clean_up must not end another process that gets the child's number */
    wait4(running, &status, 0, &usage);
    running = 0;
    cmd_block_signals(false);
    end->status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    end->signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    end->seconds = seconds_of(&usage);
}

void cmd_child_run(const struct cmd_child_words *words, double limit_s, struct cmd_child_end *end)
{
    char text[HATCH_ERR_TEXT_MAX];
    struct hatch_err err;
    int descriptor = openat(folder_descriptor, "words", O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (descriptor < 0)
        cmd_check(cmd_fail_errno(&err, "cannot write", errno), folder, &err);
    int failed = start(words, descriptor);
    if (failed)
        cmd_check(cmd_fail_errno(&err, "cannot run this command of hatch", failed), words->at[0], &err);
    if (!isinf(limit_s))
        limit_time(limit_s);
    wait_for_end(end);
    ssize_t size = pread(descriptor, text, sizeof text - 1, 0);
    close(descriptor);
    take_sentence(words->at[0], text, size > 0 ? (size_t)size : 0, end->sentence);
}

noreturn void cmd_child_die(const char *command, const struct cmd_child_end *end)
{
    struct hatch_err err;
    if (end->status >= 0)
        hatch_fail(&err, end->status ? (enum hatch_status)end->status : HATCH_IO, "%s", end->sentence);
    else
        hatch_fail(&err, HATCH_LIMIT, "signal %d ended it", end->signal);
    cmd_die(command, &err);
}
