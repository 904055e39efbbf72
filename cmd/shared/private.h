/* Shared by the files of cmd/shared; commands include cmd.h instead. */
#ifndef SHARED_PRIVATE_H
#define SHARED_PRIVATE_H

#include "shared/cmd.h"

/* Set by cmd_begin for the rest of the process. */
extern const struct cmd_program *cmd_current_program;
extern bool cmd_is_quiet, cmd_is_verbose;

/* Parses the command line into args and the values of the options. Prints and exits for --help, --version and
 * --options-table; dies on wrong usage. */
void cmd_parse(const struct cmd_program *program, int argc, char **argv, struct cmd_args *args);

/* Returns whether a number is one that an option takes (cmd_set_option). */
bool cmd_in_range(const struct cmd_option *option, double value);

/* A command line that has been parsed. */
struct cmd_line {
    const struct cmd_option *options; /* count entries: the command's own and the common ones */
    bool *given;                      /* per option: whether it is on the command line */
    size_t count;
    const char *operand; /* the first one, or NULL */
};

/* Dies with HATCH_USAGE for the first option that is given without what it needs. Keeps the arrays of the line by
 * reference, for cmd_imply_option. */
void cmd_check_rules(const struct cmd_rule *rules, const struct cmd_line *line);

/* Prints the conditions of all rules for an option, separated by spaces. */
void cmd_print_needs(const struct cmd_rule *rules, const char *name);

/* Installs handlers that remove unfinished outputs when a signal ends the process. */
void cmd_install_signal_handlers(void);

/* Removes unfinished outputs. */
void cmd_discard_outputs(void);

/* Blocks (true) or unblocks (false) the signals that end the process, except those of crashes. */
void cmd_block_signals(bool block);

/* Flushes and closes standard output; dies on failure. */
void cmd_close_stdout(void);

/* Erases the progress line. */
void cmd_clear_progress(void);

/* Fills err with HATCH_IO and "sentence: the system's message for error_number"; returns HATCH_IO. When the system has
 * no memory (ENOMEM), the status is HATCH_LIMIT. */
enum hatch_status cmd_fail_errno(struct hatch_err *err, const char *sentence, int error_number);

#endif
