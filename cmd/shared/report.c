#include "shared/report.h"

#include <assert.h>
#include <math.h>

#include "base/json.h"

static void add_text(struct cmd_report *report, const char *text)
{
    struct hatch_err err;
    cmd_check(hatch_buffer_print(&report->text, &err, "%s", text), NULL, &err);
}

/* Adds a text with control characters replaced by '?'. */
static void add_plain(struct cmd_report *report, const char *text)
{
    size_t before = report->text.size;
    add_text(report, text);
    add_text(report, "\n"); /* ends the last character */
    report->text.size--;
    hatch_utf8_make_plain((char *)report->text.data + before, report->text.size - before);
}

struct cmd_output *cmd_open_report(const struct cmd_args *args, const char *path)
{
    return cmd_open_output(path, args->json ? "json txt" : "tsv txt", false);
}

void cmd_report_begin(struct cmd_report *report, struct cmd_args *args, const char *const *columns)
{
    *report = (struct cmd_report){.columns = columns, .text = {.arena = &args->keep}, .json = args->json};
    while (columns[report->column_count])
        report->column_count++;
    assert(report->column_count > 0 && report->column_count <= CMD_REPORT_COLUMNS_MAX);
    if (args->json) {
        add_text(report, "[");
        return;
    }
    for (uint32_t i = 0; i < report->column_count; i++) {
        add_text(report, i ? "\t" : "");
        add_text(report, columns[i]);
    }
    add_text(report, "\n");
}

static void begin_cell(struct cmd_report *report)
{
    bool first = report->next == 0;
    if (!report->json) {
        add_text(report, first ? "" : "\t");
        return;
    }
    add_text(report, !first ? ", " : report->any_row ? ",\n {" : "\n {");
    add_text(report, "\"");
    add_text(report, report->columns[report->next]);
    add_text(report, "\": ");
}

static void end_cell(struct cmd_report *report)
{
    report->any_row = true;
    if (++report->next < report->column_count)
        return;
    report->next = 0;
    add_text(report, report->json ? "}" : "\n");
}

void cmd_report_text(struct cmd_report *report, const char *text)
{
    struct hatch_err err;
    begin_cell(report);
    if (report->json)
        cmd_check(hatch_json_add_string(&report->text, text, &err), NULL, &err);
    else
        add_plain(report, text);
    end_cell(report);
}

void cmd_report_number(struct cmd_report *report, double number)
{
    struct hatch_err err;
    begin_cell(report);
    if (!isfinite(number))
        add_text(report, report->json ? "null" : isnan(number) ? "nan" : number < 0 ? "-inf" : "inf");
    else
        cmd_check(hatch_buffer_print(&report->text, &err, "%.9g", number), NULL, &err);
    end_cell(report);
}

void cmd_report_numbers(struct cmd_report *report, const double *numbers, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++)
        cmd_report_number(report, numbers ? numbers[i] : (double)NAN);
}

void cmd_report_integer(struct cmd_report *report, uint64_t number)
{
    struct hatch_err err;
    begin_cell(report);
    cmd_check(hatch_buffer_print(&report->text, &err, "%llu", (unsigned long long)number), NULL, &err);
    end_cell(report);
}

struct hatch_bytes cmd_report_end(struct cmd_report *report)
{
    assert(report->next == 0);
    add_text(report, report->json ? "\n]\n" : "");
    return (struct hatch_bytes){report->text.data, report->text.size};
}

void cmd_report_write(struct cmd_report *report, struct cmd_output *output)
{
    struct hatch_bytes table = cmd_report_end(report);
    cmd_write(output, table.data, table.size);
}
