/* hatchstat mesh FILE ...: measures meshes and scenes; the report has one row per file. */
#include "math/vector.h"
#include "measure/mesh_figures.h"
#include "scene/pose.h"
#include "shared/scene.h"
#include "subject.h"

/* clang-format off */
static const char *const columns[] = {
    "file",           "vertices",        "faces",           "points",
    "unused",         "components",      "boundary_loops",  "euler",
    "genus",          "nonmanifold_edges", "nonmanifold_points", "degenerate",
    "duplicates",     "contrary_edges",  "area",            "low_x",
    "low_y",          "low_z",           "high_x",          "high_y",
    "high_z",         "edge_min",        "edge_mean",       "edge_max",
    "uv",             "uv_degenerate",   "uv_mirrored",     "angle_p5",
    "angle_p50",      "angle_p95",       "texels_p5",       "texels_p50",
    "texels_p95",     NULL};
/* clang-format on */

#define FAR 2 /* distance from the origin, in radii, at which a scene is measured around a point of its own */

/* Finds a place near which floats keep the precision of a scene that is far from the origin. A mesh file there is read
 * as a mesh around the origin whose node has a translation, which is that place.
 *   origin  out: 0 0 0 for a scene of several nodes near the origin */
static void find_origin(struct cmd_args *args, const char *name, const struct hatch_scene *scene, double origin[3])
{
    const struct hatch_pose_span rest = {.animation = HATCH_NONE, .moments = 1};
    const struct hatch_node *node = scene->nodes;
    bool single = scene->node_count == 1 && !node->has_matrix && node->skin == HATCH_NONE;
    struct hatch_pose pose;
    struct hatch_bounds bounds;
    struct hatch_err err;
    cmd_check(hatch_pose_make(scene, &args->keep, &pose, &err), name, &err);
    cmd_check(hatch_pose_bounds(&pose, &rest, &args->scratch, &bounds, &err), name, &err);
    bool far = !bounds.empty && hatch_vec_length(bounds.center) > FAR * bounds.radius;
    for (int k = 0; k < 3; k++)
        origin[k] = single ? node->translation[k] : far ? bounds.center[k] : 0;
}

static void report_row(struct cmd_report *report, const char *name, uint32_t file_vertices, const double origin[3],
                       const struct hatch_mesh_figures *f)
{
    const uint32_t counts[] = {file_vertices,      f->faces,      f->points,
                               f->unused_vertices, f->components, f->boundary_loops};
    const uint32_t faults[] = {f->non_manifold_edges, f->non_manifold_points, f->degenerate_faces, f->duplicate_faces,
                               f->contrary_edges};
    if (report->columns == columns)
        cmd_report_text(report, name);
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++)
        cmd_report_integer(report, counts[i]);
    cmd_report_number(report, (double)f->euler);
    cmd_report_number(report, (double)f->genus);
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++)
        cmd_report_integer(report, faults[i]);
    cmd_report_number(report, f->area);
    for (int k = 0; k < 3; k++)
        cmd_report_number(report, origin[k] + (double)f->low[k]);
    for (int k = 0; k < 3; k++)
        cmd_report_number(report, origin[k] + (double)f->high[k]);
    cmd_report_number(report, f->edge_min);
    cmd_report_number(report, f->edge_mean);
    cmd_report_number(report, f->edge_max);
    cmd_report_integer(report, f->has_uv);
    cmd_report_number(report, f->uv.degenerate_share);
    cmd_report_number(report, f->uv.mirrored_share);
    cmd_report_numbers(report, f->uv.angle, 3);
    cmd_report_numbers(report, f->uv.area, 3);
}

static void measure(struct cmd_args *args, const char *path, struct cmd_report *report)
{
    const char *name = cmd_input_name(path);
    struct hatch_scene scene;
    struct hatch_mesh mesh;
    struct hatch_mesh_figures figures;
    struct hatch_mesh_notes notes = {0};
    struct hatch_err err;
    double origin[3];
    struct hatch_arena_mark keep = hatch_arena_mark(&args->keep), scratch = hatch_arena_mark(&args->scratch);
    cmd_read_scene(args, path, CMD_SCENE_AS_IS, &scene);
    find_origin(args, name, &scene, origin);
    cmd_check(hatch_scene_flatten(&scene, origin, false, &args->keep, &args->scratch, &mesh, &err), name, &err);
    cmd_check(hatch_measure_mesh(&mesh, &args->scratch, &figures, &err), name, &err);
    uint32_t added = 0;
    for (uint32_t n = 0; n < scene.node_count; n++)
        for (uint32_t m = 0; m < scene.nodes[n].mesh_count; m++) {
            const struct hatch_scene_mesh *part = &scene.meshes[scene.nodes[n].first_mesh + m];
            added += part->mesh.vertex_count > part->file_vertices ? part->mesh.vertex_count - part->file_vertices : 0;
        }
    /* Warns of the faults that a command that cleans its input would repair. */
    cmd_check(hatch_mesh_clean(&args->keep, &args->scratch, &mesh, &notes, &err), name, &err);
    cmd_warn_mesh(name, &notes);
    hatch_arena_rewind(&args->scratch, scratch);
    hatch_arena_rewind(&args->keep, keep);
    report_row(report, name, figures.vertices - added, origin, &figures);
}

enum hatch_status stat_mesh(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output)
{
    (void)options;
    struct cmd_report report;
    /* The name column is omitted for a single file, so that the output does not depend on its path. */
    cmd_report_begin(&report, args, args->operand_count > 2 ? columns : columns + 1);
    if (args->operand_count == 1)
        measure(args, NULL, &report);
    for (int i = 1; i < args->operand_count; i++)
        measure(args, args->operands[i], &report);
    cmd_report_write(&report, output);
    return HATCH_OK;
}
