/* hatchstat lapped [FILE]: measures coverage and distortion of lapped textures. */
#include "shared/scene.h"
#include "io/png/png.h"
#include "measure/lapped_figures.h"
#include "subject.h"

#define SEED 1 /* random seed of the samples; fixed, so that measuring a file again gives the same figures */

static const char *const columns[] = {
    "patches",        "hidden",         "faces",          "patch_faces", "overlap",     "samples",     "covered",
    "opacity",        "flipped",        "stretch_p50",    "stretch_p95", "stretch_p99", "stretch_max", "area_p50",
    "area_p95",       "area_p99",       "area_max",       "angle_p50",   "angle_p95",   "angle_p99",   "angle_max",
    "angle_area_p50", "angle_area_p95", "angle_area_p99", NULL};

/* Reads the outline images of the patches. Returns one image per texture of the scene, with pixels NULL where the
 * texture is not an outline. */
static struct hatch_image *read_masks(struct cmd_args *args, const char *name, const struct hatch_scene *scene)
{
    struct hatch_err err;
    struct hatch_image *masks;
    cmd_check(HATCH_ALLOC(&args->keep, &masks, scene->texture_count, &err), name, &err);
    for (uint32_t m = 0; m < scene->material_count; m++) {
        uint32_t t = scene->materials[m].base.texture;
        if (!scene->materials[m].outline || t == HATCH_NONE || !scene->textures[t].data || masks[t].pixels)
            continue;
        struct hatch_bytes file = {scene->textures[t].data, scene->textures[t].size};
        if (hatch_png_read(file, &args->keep, &args->scratch, &masks[t], &err) != HATCH_OK) {
            hatch_fail_at(&err, "outline of material %u: ", m);
            cmd_die(name, &err);
        }
    }
    return masks;
}

static void put(struct cmd_report *report, const struct hatch_lapped_figures *f)
{
    const double *const lists[] = {f->stretch, f->area, f->angle_deg};
    cmd_report_integer(report, f->patches);
    cmd_report_integer(report, f->hidden);
    cmd_report_integer(report, f->faces);
    cmd_report_integer(report, f->patch_faces);
    cmd_report_number(report, f->overlap);
    cmd_report_integer(report, f->samples);
    cmd_report_number(report, f->covered);
    cmd_report_number(report, f->opacity_min);
    cmd_report_integer(report, f->flipped);
    for (size_t i = 0; i < sizeof lists / sizeof *lists; i++)
        cmd_report_numbers(report, lists[i], HATCH_LAPPED_SHARES);
    cmd_report_numbers(report, f->angle_area_deg, HATCH_LAPPED_MAX);
}

/* Warns of each limit that is exceeded; NaN exceeds every limit. Returns whether all limits are met. */
static bool check_limits(const char *name, const struct hatch_lapped_figures *f)
{
    const struct {
        const char *what;
        double value, max;
    } limits[] = {
        {"uncovered share of the samples", 1 - f->covered, 0},
        {"overlap", f->overlap, 1.5},
        {"flipped faces", f->flipped, 0},
        {"stretch_p99", f->stretch[HATCH_LAPPED_P99], 1.5},
        {"angle_p50", f->angle_deg[HATCH_LAPPED_P50], 1.5},
        {"angle_p95", f->angle_deg[HATCH_LAPPED_P95], 8},
    };
    bool all = true;
    for (size_t i = 0; i < sizeof limits / sizeof *limits; i++)
        if (!(limits[i].value <= limits[i].max)) {
            cmd_warn(name, "%s: %.6g, want %g at most", limits[i].what, limits[i].value, limits[i].max);
            all = false;
        }
    return all;
}

enum hatch_status stat_lapped(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output)
{
    const char *path = args->operand_count > 1 ? args->operands[1] : NULL, *name = cmd_input_name(path);
    struct hatch_scene scene;
    struct hatch_lapped_figures figures;
    struct cmd_report report;
    struct hatch_err err;
    cmd_read_scene(args, path, CMD_SCENE_AS_IS, &scene);
    const struct hatch_image *masks = read_masks(args, name, &scene);
    const struct hatch_progress progress = cmd_progress_of("samples");
    cmd_check(hatch_measure_lapped(&scene, masks, (uint32_t)options->samples, SEED, &progress, &args->scratch, &figures,
                                   &err),
              name, &err);
    cmd_report_begin(&report, args, columns);
    put(&report, &figures);
    cmd_report_write(&report, output);
    return !options->check || check_limits(name, &figures) ? HATCH_OK : HATCH_DIFFERS;
}
