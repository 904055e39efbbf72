/* What the files of cmd/cmd*.c share among themselves; commands include cmd.h only. */
#ifndef HATCH_CMD_PRIVATE_H
#define HATCH_CMD_PRIVATE_H

#include "shared/cmd.h"

/* Set by cmd_begin; valid for the rest of the process. */
extern const struct cmd_program *cmd_current_program;
extern bool cmd_is_quiet, cmd_is_verbose;

/* cmd_options.c: fills args and the program's values; prints and exits for --help, --version and
 * --options-table; dies on wrong usage. */
void cmd_parse(const struct cmd_program *program, int argc, char **argv, struct cmd_args *args);

/* cmd_output.c */
void cmd_catch_signals(void);
void cmd_discard_outputs(void);
/* Blocks (true) or lets through (false) the signals that end the process. */
void cmd_hold_signals(bool hold);
/* Flushes and closes standard output; dies when it did not take everything. */
void cmd_close_stdout(void);

/* cmd.c */
void cmd_clear_progress(void);
/* err's status and "sentence: the system's reason for error_number". */
enum hatch_status cmd_fail_errno(struct hatch_err *err, const char *sentence, int error_number);

#endif
