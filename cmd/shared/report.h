/* A report: a table of figures, written as TSV with a header line, or as JSON, an array with one
 * object a row. */
#ifndef HATCH_CMD_REPORT_H
#define HATCH_CMD_REPORT_H

#include "shared/cmd.h"

#define CMD_REPORT_COLUMNS_MAX 64

struct cmd_report {
    const char *const *columns; /* NULL-terminated */
    struct hatch_buffer text;
    uint32_t column_count, next; /* next: the column that the next cell goes to */
    bool json, any_row;
};

/* Begins a table in args->keep; --json says in which form. columns must live as long. */
void cmd_report_begin(struct cmd_report *report, struct cmd_args *args, const char *const *columns);

/* The next cell, row by row from the left. Control bytes in text become '?'. A number is written
 * with nine digits; one that is not finite is nan, inf or -inf in TSV and null in JSON. */
void cmd_report_text(struct cmd_report *report, const char *text);
void cmd_report_number(struct cmd_report *report, double number);
void cmd_report_whole(struct cmd_report *report, uint64_t number);

/* The table's bytes, in args->keep; the last row must be full. For a report beside other outputs. */
struct hatch_bytes cmd_report_end(struct cmd_report *report);

/* Ends the table and writes it. */
void cmd_report_write(struct cmd_report *report, struct cmd_output *output);

#endif
