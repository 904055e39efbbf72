/* strokegen: traces strokes on surfaces along a direction field, nested by density. */
#include <math.h>
#include <string.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "field/field.h"
#include "io/glb/glb.h"
#include "placement/style.h"
#include "scene/extent.h"
#include "scene/pose.h"
#include "shared/field.h"
#include "shared/needs/fit.h"
#include "shared/surface.h"
#include "trace/finer.h"
#include "trace/trace.h"

#define PI 3.14159265358979323846
/* Strokes side by side, of all levels, over a gap of the finest. There are more, but render-gl judges by the nearest
 * corner of the box around a mesh, and wider strokes make lighter tones. */
#define STROKES_PER_GAP 0.7
#define NARROW_STROKES_MAX 1e5
#define HALVINGS_MAX 40u  /* of the gap on a mesh that is smaller than it */
#define LEVELS_DEFORMED 9 /* by needs, on a mesh on which render-gl traces no finer ones */

static double gap = 0.08, length = 40, hard_deg = 40;
static int64_t levels = 6;
static const char *angles = "0,60", *needs_path;
static bool gap_given;

static const struct cmd_option options[] = {
    {'g', "gap", CMD_REAL, 1e-6, 1, "SHARE",
     "gap between the strokes of the coarsest level, as a share of the scene's diagonal (default 0.08)", &gap, NULL,
     &gap_given},
    {'l', "levels", CMD_INT, 1, HATCH_CURVE_LEVELS_MAX, "N",
     "levels, each with half the gaps of the one before (default 6)", &levels, NULL, NULL},
    {'N', "needs", CMD_TEXT, 0, 0, "FILE", "make no finer levels than views need (render-gl --needs), at most 6",
     &needs_path, NULL, NULL},
    {'a', "angles", CMD_TEXT, 0, 0, "LIST",
     "angles in degrees from the field to the strokes of each family, with commas (default 0,60)", &angles, NULL, NULL},
    {'L', "length", CMD_REAL, 2, HATCH_CURVE_LENGTH_MAX, "GAPS",
     "greatest length of a stroke, in gaps of its level (default 40)", &length, NULL, NULL},
    {'H', "hard", CMD_REAL, 0, 180, "DEGREES", "strokes end at edges sharper than this (default 40)", &hard_deg, NULL,
     NULL},
    {0},
};

static const struct cmd_rule rules[] = {
    {"levels", "!needs", "which finds the number"},
    {NULL, NULL, NULL},
};

static const char *const examples[] = {
    "meshgen torus | dirfield | strokegen -o torus.glb",
    "strokegen --levels 4 --angles 0,90 model.glb -o model-strokes.glb",
    NULL,
};

static const struct cmd_program program = {
    .name = "strokegen",
    .operands = "[FILE]",
    .summary = "trace strokes on surfaces along a direction field, nested by density",
    .examples = examples,
    .options = options,
    .rules = rules,
    .operands_min = 0,
    .operands_max = 1,
    .seeded = true,
    .binary = true,
};

/* Reads the list of angles; returns their number. */
static uint32_t read_angles(float angle_rad[HATCH_CURVE_FAMILIES_MAX])
{
    uint32_t count = 0;
    for (const char *at = angles; at; count++) {
        const char *end = strchr(at, ',');
        double degrees;
        if (count == HATCH_CURVE_FAMILIES_MAX)
            cmd_usage("--angles: more than %u", HATCH_CURVE_FAMILIES_MAX);
        if (!hatch_text_number((struct hatch_text){at, end ? (size_t)(end - at) : strlen(at)}, &degrees) ||
            !(fabs(degrees) <= 360))
            cmd_usage("--angles: '%s' is not a list of numbers from -360 to 360", angles);
        angle_rad[count] = (float)(degrees * (PI / 180));
        at = end ? end + 1 : NULL;
    }
    return count;
}

/* How the strokes of a mesh are made. */
struct density {
    uint32_t levels;
    double stretch; /* factor of the gap */
    bool must;      /* views need more: it gets strokes even if it is too small for these gaps */
};

/* Finds the meshes that a skin or morph targets deform somewhere: render-gl traces no finer strokes on them.
 *   deformed  out: one per mesh */
static void find_deformed(const struct hatch_scene *scene, bool *deformed)
{
    for (uint32_t n = 0; n < scene->node_count; n++)
        for (uint32_t i = 0; i < scene->nodes[n].mesh_count; i++) {
            uint32_t mesh = scene->nodes[n].first_mesh + i;
            deformed[mesh] = deformed[mesh] || hatch_pose_deforms(scene, n, &scene->meshes[mesh].mesh);
        }
}

/* Finds how dense strokes must be: they need not get wider than render-gl lets them before it traces finer ones. A mesh
 * on which it traces none gets more levels than `levels`, where views need them. Gaps are stretched until the finest
 * level is no finer than that, unless --gap is given. Strokes have the default width of pictures.
 *   gap        between the strokes of the coarsest level, in scene units
 *   densities  out: per mesh */
static void find_densities(struct cmd_args *args, const char *name, const struct hatch_needs *needs, uint32_t families,
                           double first_gap, const struct hatch_scene *scene, struct density *densities)
{
    struct hatch_style style;
    struct hatch_err err;
    double *mesh_px;
    bool *deformed;
    uint32_t least = LEVELS_DEFORMED, most = 1;
    cmd_check(HATCH_ALLOC(&args->keep, &mesh_px, scene->mesh_count, &err), NULL, &err);
    cmd_check(HATCH_ALLOC(&args->keep, &deformed, scene->mesh_count, &err), NULL, &err);
    cmd_mesh_px(args, name, needs, scene, mesh_px);
    find_deformed(scene, deformed);
    hatch_style_default(&style);
    style.pen.width_px = style.width_px;
    for (uint32_t i = 0; i < scene->mesh_count; i++) {
        double wanted = hatch_needs_strokes(needs, mesh_px[i], &style.pen, families) * first_gap;
        double widest = HATCH_FINER_START * STROKES_PER_GAP;
        uint32_t count = 1, limit = deformed[i] ? LEVELS_DEFORMED : (uint32_t)levels;
        while (count < limit && wanted > widest * ldexp(1, (int)count - 1))
            count++;
        double spare = widest * ldexp(1, (int)count - 1) / fmax(wanted, 1e-30);
        densities[i] = (struct density){count, gap_given ? 1 : fmin(fmax(spare, 1), 2), spare < 1};
        if (scene->meshes[i].unseen_tolerance > 0)
            continue;
        least = count < least ? count : least;
        most = count > most ? count : most;
    }
    if (least < most)
        cmd_note("%u to %u of %d levels are needed", least, most, most > levels ? LEVELS_DEFORMED : (int)levels);
    else
        cmd_note("%u of %d levels are needed", most, most > levels ? LEVELS_DEFORMED : (int)levels);
    levels = most;
}

static void report_share(void *context, double share)
{
    (void)context;
    cmd_progress("strokes", share);
}

/* Returns whether each family has strokes. */
static bool has_all(const struct hatch_curves *curves, uint32_t families)
{
    uint32_t found = 0;
    for (uint32_t s = 0; s < curves->set_count; s++)
        found |= (curves->sets[s].count > 0 ? 1u : 0u) << curves->sets[s].family;
    return found == (1u << families) - 1;
}

/* Traces strokes. A mesh that is too small for those of a family gets one level, with the widest gap at which it has
 * some: render-gl traces finer ones only of families that a file has. One that is so long and narrow that this would
 * take more than about NARROW_STROKES_MAX strokes keeps what it has.
 *   how   its gap is in mesh units
 *   must  false: strokes that are too few are enough */
static void trace_some(struct cmd_args *args, const char *name, const struct hatch_surface *surface,
                       const struct hatch_frames *frames, const double *direction,
                       const struct hatch_trace_options *how, bool must, struct hatch_scene_mesh *mesh)
{
    struct hatch_trace_options local = *how;
    struct hatch_err err;
    double area = 0;
    for (uint32_t f = 0; f < mesh->mesh.face_count; f++)
        area += hatch_mesh_face_area(&mesh->mesh, f);
    for (uint32_t i = 0; i <= HALVINGS_MAX; i++) {
        cmd_check(hatch_trace_make(surface, &mesh->mesh, frames, direction, &local, cmd_pool(args), &args->keep,
                                   &args->scratch, &mesh->curves, &err),
                  name, &err);
        if (has_all(&mesh->curves, how->family_count) || !must)
            break;
        local.gap = ldexp(local.gap, -(int)local.levels);
        local.levels = 1;
        if (area > NARROW_STROKES_MAX * local.gap * local.gap)
            break;
    }
}

/* Makes a mesh anew that has a direction field, if its surface has other faces, or other vertices of faces. Returns
 * whether it has. */
static bool repair(struct cmd_args *args, const char *name, const struct hatch_surface *surface,
                   struct hatch_scene_mesh *mesh)
{
    struct hatch_err err;
    struct hatch_mesh made;
    uint32_t *vertex_point;
    struct hatch_arena_mark mark = hatch_arena_mark(&args->keep);
    cmd_check(hatch_surface_to_mesh(surface, &mesh->mesh, &args->keep, &args->scratch, &made, &vertex_point, &err),
              name, &err);
    const size_t indices = 3 * (size_t)made.face_count;
    if (made.face_count == mesh->mesh.face_count && made.vertex_count == mesh->mesh.vertex_count &&
        memcmp(made.indices, mesh->mesh.indices, indices * sizeof *made.indices) == 0) {
        hatch_arena_rewind(&args->keep, mark);
        return false;
    }
    mesh->mesh = made;
    mesh->curves = (struct hatch_curves){0}; /* they lie on the old faces */
    return true;
}

/* Traces the strokes of a mesh, whose direction field is computed if it has none.
 *   surface  of the mesh; NULL: not made yet
 *   scale    scene units per unit of the mesh
 *   how      its gap is in scene units
 *   must     as for trace_some */
static void trace(struct cmd_args *args, const char *name, const struct hatch_surface *surface, double scale,
                  const struct hatch_trace_options *how, bool must, struct hatch_scene_mesh *mesh)
{
    struct hatch_err err;
    struct hatch_surface cut;
    struct hatch_surface_notes notes;
    struct hatch_frames frames;
    struct hatch_trace_options local = *how;
    double *direction, *confidence;
    local.gap /= scale;
    if (!(local.gap > 0 && isfinite(local.gap)))
        cmd_check(hatch_fail(&err, HATCH_BAD_INPUT, "the size of a mesh in the scene is zero or infinite"), name, &err);
    if (surface && hatch_mesh_find(&mesh->mesh, "_HATCH_DIR", 4) && !repair(args, name, surface, mesh)) {
        cut = *surface;
    } else {
        if (surface && !hatch_mesh_find(&mesh->mesh, "_HATCH_DIR", 4))
            cmd_add_field(args, name, surface, mesh); /* which makes the mesh anew */
        cmd_check(hatch_surface_make_cut(&mesh->mesh, &args->keep, &args->scratch, &cut, &notes, &err), name, &err);
    }
    cmd_check(hatch_frames_make(&cut, &args->keep, &args->scratch, &frames, &err), name, &err);
    cmd_check(HATCH_ALLOC(&args->keep, &direction, 3 * (size_t)cut.point_count, &err), name, &err);
    cmd_check(HATCH_ALLOC(&args->keep, &confidence, cut.point_count, &err), name, &err);
    hatch_field_of_mesh(&cut, &frames, &mesh->mesh, direction, confidence);
    trace_some(args, name, &cut, &frames, direction, &local, must, mesh);
}

/* Warns of meshes that have no strokes though views may need them. */
static void warn_bare(const char *name, const struct hatch_scene *scene)
{
    uint32_t bare = 0;
    for (uint32_t i = 0; i < scene->mesh_count; i++)
        bare += scene->meshes[i].curves.count == 0 && scene->meshes[i].mesh.face_count > 0;
    if (bare > 0 && !needs_path)
        cmd_warn(name, "%u %s no strokes: too narrow for any", bare, cmd_plural(bare, "mesh has", "meshes have"));
}

int main(int argc, char **argv)
{
    struct cmd_args args;
    struct hatch_scene scene;
    struct hatch_scene_extent extent;
    struct hatch_err err;
    struct hatch_needs needs;
    float angle_rad[HATCH_CURVE_FAMILIES_MAX];
    const struct hatch_surface *surfaces = NULL;
    const struct hatch_progress progress = {report_share, NULL};
    cmd_begin(&program, argc, argv, &args);
    uint32_t families = read_angles(angle_rad), strokes = 0, points = 0;
    struct density *densities;
    const char *input = args.operand_count ? args.operands[0] : NULL, *name = cmd_input_name(input);
    struct cmd_output *output = cmd_open_output(args.output, "glb", true);

    cmd_read_scene_to_write(&args, input, true, &scene);
    cmd_refuse_lapped(name, &scene);
    if (needs_path) {
        cmd_read_needs_and_regions(&args, needs_path, &needs);
        cmd_fit_meshes(&args, input, needs_path, &needs, &scene);
    } else
        surfaces = cmd_make_surfaces(&args, input, &scene);
    cmd_check(hatch_scene_find_extent(&scene, &args.keep, &args.scratch, &extent, &err), name, &err);
    cmd_check(HATCH_ALLOC(&args.keep, &densities, scene.mesh_count, &err), name, &err);
    for (uint32_t i = 0; i < scene.mesh_count; i++)
        densities[i] = (struct density){(uint32_t)levels, 1, true};
    if (needs_path)
        find_densities(&args, name, &needs, families, gap * extent.diagonal, &scene, densities);
    struct hatch_trace_options how = {.family_count = families,
                                      .angle_rad = angle_rad,
                                      .length = length,
                                      .hard_rad = hard_deg * (PI / 180),
                                      .seed = args.seed,
                                      .progress = &progress};
    for (uint32_t i = 0; i < scene.mesh_count; i++) {
        how.levels = densities[i].levels;
        how.gap = gap * extent.diagonal * densities[i].stretch;
        if (scene.meshes[i].unseen_tolerance > 0)
            continue;
        trace(&args, name, surfaces ? &surfaces[i] : NULL, extent.scale[i], &how, densities[i].must, &scene.meshes[i]);
        if (needs_path && !densities[i].must) {
            scene.meshes[i].curves.needs = (float)needs.tolerance;
            scene.meshes[i].curves.finest = (float)ldexp(how.gap / extent.scale[i], 1 - (int)how.levels);
        }
        strokes += scene.meshes[i].curves.count;
        points += scene.meshes[i].curves.point_count;
    }
    warn_bare(name, &scene);
    cmd_note("%u %s, %u points", strokes, cmd_plural(strokes, "stroke", "strokes"), points);

    char comment[256];
    snprintf(comment, sizeof comment,
             "strokegen --gap %.9g --levels %u --angles %.100s --length %.9g --hard %.9g --seed %llu", gap,
             (unsigned)levels, angles, length, hard_deg, (unsigned long long)args.seed);
    struct hatch_buffer file = {.arena = &args.keep};
    cmd_check(hatch_glb_write_scene(&scene, comment, &args.scratch, &file, &err), name, &err);
    cmd_write(output, file.data, file.size);
    return cmd_end(&args, HATCH_OK);
}
