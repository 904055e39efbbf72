/* Other commands of hatch, run as child processes in a temporary folder. */
#ifndef SHARED_CHILD_CHILD_H
#define SHARED_CHILD_CHILD_H

#include "shared/cmd.h"

#define CMD_CHILD_WORDS_MAX 192

/* A command line under construction; the words are in args->keep. */
struct cmd_child_words {
    struct cmd_args *args;
    const char *output; /* path of the file that its standard output goes to; NULL: nowhere */
    uint32_t count;
    const char *at[CMD_CHILD_WORDS_MAX + 1]; /* ends with NULL */
};

/* How a child ended. */
struct cmd_child_end {
    int status;                        /* exit status; -1: a signal ended it */
    int signal;                        /* that signal */
    double seconds;                    /* processor time */
    char sentence[HATCH_ERR_TEXT_MAX]; /* its first message, without its name; empty: it printed nothing */
};

/* Begins a command line, and adds a word. Die when memory does not suffice, and for too many words. */
void cmd_child_begin(struct cmd_child_words *words, struct cmd_args *args, const char *command);
void cmd_child_add(struct cmd_child_words *words, const char *format, ...) HATCH_PRINTF(2, 3);

/* Adds the words of a text, separated by spaces; words may be quoted with ' or ". Dies with HATCH_USAGE if a quotation
 * mark is missing.
 *   option  name of the option whose value the text is */
void cmd_child_add_all(struct cmd_child_words *words, const char *option, const char *text);

/* Makes the temporary folder, in $TMPDIR or /tmp. It is removed when the command ends, also by a signal. Dies on
 * failure. */
void cmd_child_make_folder(void);

/* Returns the path of a file in that folder. */
const char *cmd_child_path(struct cmd_args *args, const char *format, ...) HATCH_PRINTF(2, 3);

/* Writes a file into that folder and makes it the standard input of this command. Returns its path. */
const char *cmd_child_keep_input(struct cmd_args *args, struct hatch_bytes file);

/* Returns the processor time of this command and its children so far, in seconds. */
double cmd_child_processor_s(void);

/* Runs a command, the one in the folder of this one or else the one on PATH, and waits for its end. Its standard input
 * is empty. Dies if it cannot be run.
 *   limit_s  processor time after which it is ended, in seconds; INFINITY: none */
void cmd_child_run(const struct cmd_child_words *words, double limit_s, struct cmd_child_end *end);

/* Dies with the words and the status of a child that failed.
 *   command  its name */
noreturn void cmd_child_die(const char *command, const struct cmd_child_end *end);

#endif
