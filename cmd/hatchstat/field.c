/* hatchstat field FILE ...: measures direction fields; the report has one row per file. */
#include "shared/scene.h"
#include "measure/field_figures.h"
#include "subject.h"

static const char *const columns[] = {
    "file",       "points",         "faces",          "components",     "euler",      "index_sum",    "singularities",
    "smoothness", "confidence_p25", "confidence_p50", "confidence_p75", "uv_deg_p50", "uv_deg_p75",   "uv_deg_p95",
    "compared",   "deg_p50",        "deg_p75",        "deg_p95",        "deg_max",    "axis_deg_p50", "axis_deg_p95",
    NULL};

static void report_row(struct cmd_report *report, const char *name, const struct hatch_field_figures *f)
{
    if (report->columns == columns)
        cmd_report_text(report, name);
    cmd_report_integer(report, f->points);
    cmd_report_integer(report, f->faces);
    cmd_report_integer(report, f->components);
    cmd_report_number(report, (double)f->euler);
    cmd_report_number(report, f->index_sum);
    cmd_report_integer(report, f->singularities);
    cmd_report_number(report, f->smoothness);
    cmd_report_numbers(report, f->confidence, 3);
    cmd_report_numbers(report, f->uv_degrees, 3);
    cmd_report_integer(report, f->compared);
    cmd_report_numbers(report, f->degrees, 4);
    cmd_report_numbers(report, f->axis_degrees, 2);
}

static void measure(struct cmd_args *args, const struct stat_options *options, const char *path,
                    const struct hatch_scene *reference, struct cmd_report *report)
{
    const char *name = cmd_input_name(path);
    struct hatch_scene scene;
    struct hatch_err err;
    struct hatch_field_sum sum = {.arena = &args->keep, .scratch = &args->scratch};
    struct hatch_field_figures figures;
    struct hatch_arena_mark keep = hatch_arena_mark(&args->keep), scratch = hatch_arena_mark(&args->scratch);
    cmd_read_scene(args, path, CMD_SCENE_AS_IS, &scene);
    if (reference && reference->mesh_count != scene.mesh_count) {
        hatch_fail(&err, HATCH_BAD_INPUT, "%u primitives with faces, the reference has %u", scene.mesh_count,
                   reference->mesh_count);
        cmd_die(name, &err);
    }
    for (uint32_t i = 0; i < scene.mesh_count; i++) {
        enum hatch_status status =
            hatch_measure_field_add(&sum, &scene.meshes[i].mesh, reference ? &reference->meshes[i].mesh : NULL, &err);
        if (status != HATCH_OK && scene.mesh_count > 1)
            hatch_fail_at(&err, "primitive %u: ", i);
        cmd_check(status, sum.reference_failed ? cmd_input_name(options->reference) : name, &err);
    }
    cmd_check(hatch_measure_field_end(&sum, options->share, &figures, &err), name, &err);
    hatch_arena_rewind(&args->scratch, scratch);
    hatch_arena_rewind(&args->keep, keep);
    report_row(report, name, &figures);
}

enum hatch_status stat_field(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output)
{
    struct cmd_report report;
    struct hatch_scene reference;
    if (options->reference)
        cmd_read_scene(args, options->reference, CMD_SCENE_AS_IS, &reference);
    /* The name column is omitted for a single file, so that the output does not depend on its path. */
    cmd_report_begin(&report, args, args->operand_count > 2 ? columns : columns + 1);
    for (int i = 1; i < args->operand_count || i == 1; i++)
        measure(args, options, i < args->operand_count ? args->operands[i] : NULL,
                options->reference ? &reference : NULL, &report);
    cmd_report_write(&report, output);
    return HATCH_OK;
}
