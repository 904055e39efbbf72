/* Reports are tables of figures, written as TSV with a header line, or as JSON, an array with one object per row. */
#ifndef SHARED_REPORT_H
#define SHARED_REPORT_H

#include "shared/cmd.h"

#define CMD_REPORT_COLUMNS_MAX 64

struct cmd_report {
    const char *const *columns; /* names, NULL-terminated */
    struct hatch_buffer text;
    uint32_t column_count;
    uint32_t next; /* column of the next cell */
    bool json, any_row;
};

/* Opens the output of a report like cmd_open_output, for names that end in .tsv, with --json in .json. */
struct cmd_output *cmd_open_report(const struct cmd_args *args, const char *path);

/* Begins a table in args->keep, as JSON with --json.
 *   columns  names, NULL-terminated; kept by reference */
void cmd_report_begin(struct cmd_report *report, struct cmd_args *args, const char *const *columns);

/* Each function adds the next cell, row by row. Control characters in texts become '?' in TSV; in JSON texts are
 * escaped, and bytes that are not UTF-8 become U+FFFD. Numbers have nine significant digits; those that are not finite
 * are nan, inf or -inf in TSV and null in JSON. */
void cmd_report_text(struct cmd_report *report, const char *text);
void cmd_report_number(struct cmd_report *report, double number);
void cmd_report_numbers(struct cmd_report *report, const double *numbers, uint32_t count); /* NULL: all are nan */
void cmd_report_integer(struct cmd_report *report, uint64_t number);

/* Ends the table after a full row and returns it, for a command with other outputs. */
struct hatch_bytes cmd_report_end(struct cmd_report *report);

/* Ends the table and writes it. */
void cmd_report_write(struct cmd_report *report, struct cmd_output *output);

#endif
