#define _GNU_SOURCE
#include "base/random.h"
#include "shared/names/descriptor.h"
#include "shared/private.h"

#include <assert.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

/* Hidden files with fixed names that one target may have at the same time, each with a living writer. */
#define SLOTS 8

/* An output is either a stream (standard output, another open descriptor, a device, a pipe) or a hidden file beside the
 * target.
 *
 * The hidden file has one of SLOTS names that follow from the target's, and is locked for as long as its writer lives.
 * Where a process was killed, its file stays, and the next writer of the target locks and overwrites it. A file with
 * such a name that is locked, is no plain file, has a second name or belongs to another user is left alone. A process
 * with so many outputs that half of its descriptors are in use gives the others a random name, and closes them until
 * they are written; nothing removes such a file when the process is killed. */
struct cmd_output {
    char *name;     /* for messages */
    char *hidden;   /* path of the hidden file; NULL: a stream */
    char *target;   /* path to which the hidden file is renamed; NULL: a stream */
    bool filled;    /* the content is already in the hidden file */
    bool locked;    /* the hidden file is locked through descriptor */
    int descriptor; /* -1: the hidden file is closed */
    struct location {
        dev_t device;
        ino_t folder;
        const char *name; /* name in the folder; NULL: unknown */
    } location;           /* of the target; the same for all spellings of its path */
    struct identity {
        bool known; /* false: there is no file yet, or it is a device, which may take several outputs */
        dev_t device;
        ino_t number;
    } file;                  /* that was there before */
    struct cmd_output *next; /* of all that are open */
};

static struct cmd_output *open_outputs;

/* Paths of the hidden files that exist, or NULL; read by a signal handler. */
static char *volatile unfinished[CMD_OUTPUTS_MAX];

/* Called with the removal of unfinished outputs, or NULL. */
static void (*volatile also_at_end)(void);

static const int ending_signals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU};
#define ENDING_SIGNALS (sizeof ending_signals / sizeof *ending_signals)

/* Signals of crashes: a graphics driver that runs out of memory may crash, and hidden files are removed even then.
 * cmd_block_signals leaves these signals alone. */
static const int crashes[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

static bool stdout_closed;

void cmd_block_signals(bool block)
{
    sigset_t set;
    sigemptyset(&set);
    for (size_t i = 0; i < ENDING_SIGNALS; i++)
        sigaddset(&set, ending_signals[i]);
    pthread_sigmask(block ? SIG_BLOCK : SIG_UNBLOCK, &set, NULL);
}

static void remove_unfinished(void)
{
    for (size_t i = 0; i < CMD_OUTPUTS_MAX; i++)
        if (unfinished[i])
            unlink(unfinished[i]);
    if (also_at_end)
        also_at_end();
}

void cmd_on_end(void (*clean_up)(void))
{
    also_at_end = clean_up;
}

/* Signal handler. Raises the signal again with its default action, which ends the process when the handler returns. */
static void clean_up_and_end(int signal_number)
{
    remove_unfinished();
    signal(signal_number, SIG_DFL);
    raise(signal_number);
}

/* Installs the handler, unless the parent process ignores the signal or a sanitizer handles it. */
static void install_handler(int signal_number)
{
    struct sigaction action = {.sa_handler = clean_up_and_end}, before;
    sigemptyset(&action.sa_mask);
    sigaction(signal_number, NULL, &before);
    if (before.sa_handler == SIG_DFL)
        sigaction(signal_number, &action, NULL);
}

void cmd_install_signal_handlers(void)
{
    for (size_t i = 0; i < ENDING_SIGNALS; i++)
        install_handler(ending_signals[i]);
    for (size_t i = 0; i < sizeof crashes / sizeof *crashes; i++)
        install_handler(crashes[i]);
    signal(SIGXFSZ, SIG_IGN); /* a write past ulimit -f then fails with an error */
}

void cmd_discard_outputs(void)
{
    cmd_block_signals(true);
    remove_unfinished();
    cmd_block_signals(false);
}

static noreturn void die_errno(const char *name, const char *sentence, int error_number)
{
    struct hatch_err err;
    cmd_fail_errno(&err, sentence, error_number);
    cmd_die(name, &err);
}

static void *allocate(size_t size)
{
    void *block = calloc(1, size);
    if (!block) {
        struct hatch_err err;
        cmd_check(hatch_fail(&err, HATCH_LIMIT, "out of memory"), NULL, &err);
    }
    return block;
}

static char *copy_text(const char *text)
{
    size_t size = strlen(text) + 1;
    return memcpy(allocate(size), text, size);
}

static void refuse_terminal(int descriptor, bool binary)
{
    if (binary && isatty(descriptor))
        cmd_usage("binary data is not written to a terminal: use -o FILE or a pipe");
}

/* Returns the path of the file to replace, with symbolic links resolved, so that the rename replaces the file and not
 * the link. */
static char *final_path(const char *path, bool exists)
{
    char *resolved = NULL;
    struct stat info;
    if (exists)
        resolved = realpath(path, NULL);
    else if (lstat(path, &info) == 0)
        die_errno(path, "symbolic link to nothing", ENOENT);
    if (!resolved && exists && errno == ENOMEM)
        die_errno(path, "cannot write", errno);
    return resolved ? resolved : copy_text(path);
}

static mode_t mode_for(const struct stat *existing)
{
    if (existing)
        return existing->st_mode & 0777;
    mode_t mask = umask(0);
    umask(mask);
    return 0666 & ~mask;
}

static struct location locate(const char *target)
{
    const char *slash = strrchr(target, '/');
    char folder[PATH_MAX] = ".";
    if (slash)
        snprintf(folder, sizeof folder, "%.*s/", (int)(slash - target), target);
    struct stat info;
    if (stat(folder, &info) < 0)
        return (struct location){.name = NULL};
    return (struct location){info.st_dev, info.st_ino, slash ? slash + 1 : target};
}

static struct identity identify(const struct stat *info)
{
    return (struct identity){!S_ISCHR(info->st_mode), info->st_dev, info->st_ino};
}

static bool is_same_file(const struct identity *a, const struct identity *b)
{
    return a->known && b->known && a->device == b->device && a->number == b->number;
}

static bool is_standard(const struct cmd_output *output)
{
    return output->descriptor == STDOUT_FILENO;
}

/* Whether two outputs would overwrite each other, or mix. */
static bool collide(const struct cmd_output *a, const struct cmd_output *b)
{
    const struct location *here = &a->location, *there = &b->location;
    if (a->target && b->target)
        return here->name && there->name && here->folder == there->folder && here->device == there->device &&
               strcmp(here->name, there->name) == 0;
    return is_same_file(&a->file, &b->file) || (is_standard(a) && is_standard(b));
}

/* Adds an output to the open ones; dies if it collides with one of them. */
static struct cmd_output *admit(struct cmd_output *output)
{
    for (const struct cmd_output *other = open_outputs; other; other = other->next)
        if (collide(output, other))
            cmd_usage("two outputs go to %s", output->name);
    output->next = open_outputs;
    open_outputs = output;
    return output;
}

/* Makes the path of a hidden file of a target: the target's folder and a hash of its name, so that the length of the
 * path is limited.
 *   ending  number of the slot, or XXXXXX for mkstemp */
static char *hidden_path(const char *target, const char *ending)
{
    const char *slash = strrchr(target, '/');
    int folder_length = slash ? (int)(slash - target) + 1 : 0;
    uint64_t hash = 0;
    for (const char *c = target + folder_length; *c; c++)
        hash = hatch_random_mix(hash + (unsigned char)*c + 1);
    size_t size = (size_t)folder_length + 40;
    char *path = allocate(size);
    snprintf(path, size, "%.*s.hatch-%016llx-%s", folder_length, target, (unsigned long long)hash, ending);
    return path;
}

/* Returns whether a path still names the open file, and this is a plain file with no second name. */
static bool is_named(int descriptor, const char *path, struct stat *opened)
{
    struct stat named;
    return fstat(descriptor, opened) == 0 && lstat(path, &named) == 0 && opened->st_dev == named.st_dev &&
           opened->st_ino == named.st_ino && S_ISREG(opened->st_mode) && opened->st_nlink == 1;
}

/* Opens and locks a hidden file, unless it has a living writer or is not ours; returns its descriptor, or -1. Another
 * process may open, lock, rename or remove it at any moment, so that its name is compared again under the lock. A file
 * that was just created is ours, whoever a file system says owns it. */
static int lock_hidden(const char *path, bool create)
{
    const int flags = O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
    int descriptor = create ? open(path, flags | O_CREAT | O_EXCL, 0600) : -1;
    bool created = descriptor >= 0;
    if (!created)
        descriptor = open(path, flags);
    if (descriptor < 0)
        return -1;
    struct stat opened;
    bool locked = flock(descriptor, LOCK_EX | LOCK_NB) == 0, others = !locked && errno == EWOULDBLOCK;
    bool named = is_named(descriptor, path, &opened);
    if (locked && named && (created || opened.st_uid == geteuid()))
        return descriptor;
    if (created && named && !others) /* a file system without locks */
        unlink(path);
    close(descriptor);
    return -1;
}

/* Removes the hidden files of killed writers from the slots that are not in use. */
static void remove_stale(const char *target)
{
    for (int slot = 0; slot < SLOTS; slot++) {
        char *path = hidden_path(target, (char[]){(char)('0' + slot), '\0'});
        int descriptor = lock_hidden(path, false);
        if (descriptor >= 0) {
            unlink(path);
            close(descriptor);
        }
        free(path);
    }
}

static bool has_spare_descriptors(void)
{
    static rlim_t locked;
    struct rlimit limit;
    return getrlimit(RLIMIT_NOFILE, &limit) == 0 && locked++ < limit.rlim_cur / 2;
}

/* Makes the hidden file of an output: in a slot, or with a random name. Returns its descriptor, or -1 with errno. */
static int make_file(struct cmd_output *output)
{
    int descriptor = -1;
    bool lock = has_spare_descriptors();
    for (int slot = 0; slot < SLOTS && lock && descriptor < 0; slot++) {
        free(output->hidden);
        output->hidden = hidden_path(output->target, (char[]){(char)('0' + slot), '\0'});
        descriptor = lock_hidden(output->hidden, true);
    }
    output->locked = descriptor >= 0;
    if (output->locked)
        return descriptor;
    free(output->hidden);
    output->hidden = hidden_path(output->target, "XXXXXX");
    return mkstemp(output->hidden);
}

static void make_hidden(struct cmd_output *output, const struct stat *existing)
{
    size_t slot = 0;
    while (slot < CMD_OUTPUTS_MAX && unfinished[slot])
        slot++;
    assert(slot < CMD_OUTPUTS_MAX);
    cmd_block_signals(true);
    int descriptor = make_file(output);
    int error_number = errno;
    if (descriptor >= 0)
        unfinished[slot] = output->hidden;
    cmd_block_signals(false);
    if (descriptor < 0)
        die_errno(output->name, "cannot write", error_number);
    if (fchmod(descriptor, mode_for(existing)) < 0 || ftruncate(descriptor, 0) < 0 ||
        (!output->locked && close(descriptor) < 0))
        die_errno(output->name, "cannot write", errno);
    output->descriptor = output->locked ? descriptor : -1;
    if (output->locked)
        remove_stale(output->target);
}

/* Opens what is neither a plain file nor standard output; for a name of an open descriptor, a copy of that. */
static int open_stream(const char *path, int descriptor)
{
    if (descriptor >= 0 && (fcntl(descriptor, F_GETFL) & O_ACCMODE) == O_RDONLY)
        die_errno(path, "cannot write", EBADF);
    int opened = descriptor >= 0 ? fcntl(descriptor, F_DUPFD_CLOEXEC, 0) : open(path, O_WRONLY | O_CLOEXEC | O_NOCTTY);
    if (opened < 0)
        die_errno(path, "cannot write", errno);
    return opened;
}

static struct cmd_output *open_standard_output(struct cmd_output *output, bool binary)
{
    refuse_terminal(STDOUT_FILENO, binary);
    output->name = copy_text("standard output");
    output->descriptor = STDOUT_FILENO;
    return admit(output);
}

struct cmd_output *cmd_open_output(const char *path, const char *endings, bool binary)
{
    cmd_check_ending(path, endings);
    struct cmd_output *output = allocate(sizeof *output);
    struct stat info;
    struct identity standard = {0};
    if (fstat(STDOUT_FILENO, &info) == 0)
        standard = identify(&info);
    bool named = path && strcmp(path, "-") != 0, exists = named && stat(path, &info) == 0;
    output->file = !named ? standard : exists ? identify(&info) : output->file;
    if (!named || is_same_file(&output->file, &standard))
        return open_standard_output(output, binary);
    output->name = copy_text(path);
    output->descriptor = -1;
    if (exists && S_ISDIR(info.st_mode))
        die_errno(path, "cannot write", EISDIR);
    int descriptor = exists ? cmd_descriptor_of(path) : -1;
    if (exists && descriptor < 0 && access(path, W_OK) < 0)
        die_errno(path, "cannot write", errno);
    if (exists && (descriptor >= 0 || !S_ISREG(info.st_mode))) {
        output->descriptor = open_stream(path, descriptor);
        refuse_terminal(output->descriptor, binary);
        return admit(output);
    }
    output->target = final_path(path, exists);
    output->location = locate(output->target);
    admit(output);
    make_hidden(output, exists ? &info : NULL);
    return output;
}

static void write_all(const struct cmd_output *output, const char *data, size_t size)
{
    while (size) {
        ssize_t written = write(output->descriptor, data, size);
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            die_errno(output->name, "cannot write", errno);
        data += written;
        size -= (size_t)written;
    }
}

static void write_file(const struct cmd_file *file)
{
    struct cmd_output *output = file->output;
    if (output->filled)
        return;
    if (output->hidden && !output->locked)
        output->descriptor = open(output->hidden, O_WRONLY | O_CLOEXEC);
    if (output->descriptor < 0)
        die_errno(output->name, "cannot write", errno);
    write_all(output, file->data, file->size);
    for (size_t i = 0; i < file->piece_count; i++)
        write_all(output, (const char *)file->pieces[i].data, file->pieces[i].size);
    /* Closing reports errors that writing did not. A locked file stays open until it is renamed: a copy is closed. */
    int closed = output->locked ? dup(output->descriptor) : output->descriptor;
    if (closed < 0 || (closed != STDOUT_FILENO && close(closed) < 0))
        die_errno(output->name, "cannot write", errno);
}

bool cmd_write_ahead(const struct cmd_file *file)
{
    if (!file->output->hidden)
        return false;
    write_file(file);
    file->output->filled = true;
    return true;
}

static void rename_hidden(const struct cmd_output *output)
{
    if (rename(output->hidden, output->target) < 0)
        die_errno(output->name, "cannot write", errno);
    for (size_t i = 0; i < CMD_OUTPUTS_MAX; i++)
        if (unfinished[i] == output->hidden)
            unfinished[i] = NULL;
    if (output->locked)
        close(output->descriptor);
}

static void free_output(struct cmd_output *output)
{
    struct cmd_output **at = &open_outputs;
    while (*at != output)
        at = &(*at)->next;
    *at = output->next;
    free(output->hidden);
    free(output->target);
    free(output->name);
    free(output);
}

/* Writing, which may fail, comes before any old file is replaced. Pipes are written after the files, since output to a
 * pipe cannot be undone. */
void cmd_write_all(const struct cmd_file *files, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (files[i].output->hidden)
            write_file(&files[i]);
    for (size_t i = 0; i < count; i++)
        if (!files[i].output->hidden)
            write_file(&files[i]);
    cmd_block_signals(true);
    for (size_t i = 0; i < count; i++)
        if (files[i].output->hidden)
            rename_hidden(files[i].output);
    cmd_block_signals(false);
    for (size_t i = 0; i < count; i++)
        free_output(files[i].output);
}

void cmd_write(struct cmd_output *output, const void *data, size_t size)
{
    cmd_write_all(&(struct cmd_file){.output = output, .data = data, .size = size}, 1);
}

void cmd_close_stdout(void)
{
    if (stdout_closed)
        return;
    stdout_closed = true;
    bool failed = fflush(stdout) != 0;
    int error_number = errno;
    /* EBADF: the command was started with its standard output closed, and has written nothing to it. */
    if (!failed && close(STDOUT_FILENO) < 0 && errno != EBADF) {
        failed = true;
        error_number = errno;
    }
    if (failed)
        die_errno("standard output", "cannot write", error_number);
}
