/* hatchstat coarse FULL COARSE ...: measures how coarse meshes differ from a full one in pictures. */
#include "shared/scene.h"
#include "shared/views/views.h"
#include "measure/coarse/coarse_figures.h"
#include "subject.h"

static const char *const columns[] = {
    "file",       "faces_full", "faces", "displacement_px", "displacement_p999_px", "outline_px", "outline_p999_px",
    "normal_deg", NULL};

enum hatch_status stat_coarse(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output)
{
    const char *name = args->operands[1];
    struct cmd_view_options chosen = CMD_VIEW_OPTIONS;
    struct hatch_scene scene;
    struct hatch_mesh full, coarse;
    struct hatch_pose pose;
    struct hatch_bounds bounds;
    struct hatch_view_set views;
    struct cmd_report report;
    struct hatch_err err;
    chosen.size_px[0] = options->size_px[0];
    chosen.size_px[1] = options->size_px[1];
    cmd_read_scene(args, name, CMD_SCENE_AS_IS, &scene);
    cmd_make_views(args, name, &scene, &chosen, &pose, &bounds, &views);
    cmd_check(hatch_scene_flatten(&scene, bounds.center, true, &args->keep, &args->scratch, &full, &err), name, &err);
    cmd_report_begin(&report, args, args->operand_count > 3 ? columns : columns + 1);
    for (int i = 2; i < args->operand_count; i++) {
        struct hatch_coarse_figures f;
        struct hatch_arena_mark keep = hatch_arena_mark(&args->keep), scratch = hatch_arena_mark(&args->scratch);
        cmd_read_scene(args, args->operands[i], CMD_SCENE_AS_IS, &scene);
        cmd_check(hatch_scene_flatten(&scene, bounds.center, true, &args->keep, &args->scratch, &coarse, &err),
                  args->operands[i], &err);
        cmd_check(hatch_measure_coarse(&full, &coarse, &views, NULL, cmd_pool(args), &args->scratch, &f, &err),
                  args->operands[i], &err);
        hatch_arena_rewind(&args->scratch, scratch);
        hatch_arena_rewind(&args->keep, keep);
        const double figures[] = {f.displacement_px, f.displacement_p999_px, f.outline_px, f.outline_p999_px,
                                  f.normal_deg};
        if (report.columns == columns)
            cmd_report_text(&report, args->operands[i]);
        cmd_report_integer(&report, full.face_count);
        cmd_report_integer(&report, coarse.face_count);
        cmd_report_numbers(&report, figures, sizeof figures / sizeof *figures);
    }
    cmd_report_write(&report, output);
    return HATCH_OK;
}
