/* lapped-param: covers surfaces with overlapping patches whose texture coordinates follow a direction field. */
#include <math.h>
#include <stdio.h>

#include "shared/needs/fit.h"
#include "shared/surface.h"
#include "io/glb/glb.h"
#include "lapped_param.h"
#include "scene/extent.h"

#define PX_PER_TEXEL 4      /* pixels of a picture that a texel of the mask may cover: borders of patches are soft */
#define FEATHER_PX 11       /* of the mask, so that three quarters of the soft border are left in it */
#define UNEVENNESS_MAX 1.1  /* of the scales of a mesh, before a warning */
#define TILE_RANGE 1e6      /* largest ratio of a tile to the scene's diagonal, or of that to a tile */
#define TILES_ON_DIAGONAL 4 /* default ratio of the scene's diagonal to the side of a tile */

static double size, curved = 0.5, stretch = 1.5, turn_deg = 14, tile, roughness = 0.3, feather = 0.045;
static int64_t mask_size = 1024;
static bool atlas, mask_given;
static const char *needs_path;

static const struct cmd_option options[] = {
    {'S', "size", CMD_REAL, 0.001, 1, "SHARE",
     "diameter of a patch as a share of the scene's diagonal (default: chosen for each mesh)", &size, NULL, NULL},
    {'c', "curved", CMD_REAL, 0, 1, "SHARE",
     "how far patches shrink where the surface is curved, 0 (not) to 1 (default 0.5)", &curved, NULL, NULL},
    {'e', "stretch", CMD_REAL, 1.01, 10, "RATIO", "limit of the texture's stretch on a face (default 1.5)", &stretch,
     NULL, NULL},
    {'a', "turn", CMD_REAL, 0.6, 90, "DEGREES", "limit of the angle between strokes and field (default 14)", &turn_deg,
     NULL, NULL},
    {'t', "tile", CMD_REAL, 1e-30, 1e30, "LENGTH",
     "side of a tile of hatching, in the scene's units (default: 1/4 of the diagonal)", &tile, NULL, NULL},
    {'r', "roughness", CMD_REAL, 0, 1, "SHARE", "irregularity of the outline; 0: a circle (default 0.3)", &roughness,
     NULL, NULL},
    {'f', "feather", CMD_REAL, 0.01, 0.3, "SHARE",
     "width of a patch's soft border, as a fraction of the mask's width (default 0.045)", &feather, NULL, NULL},
    {'m', "mask-size", CMD_INT, HATCH_OUTLINE_PX_MIN, 4096, "PX",
     "width and height of the mask, the image of the outline (default 1024)", &mask_size, NULL, &mask_given},
    {'N', "needs", CMD_TEXT, 0, 0, "FILE",
     "no finer meshes, no patches that views do not show, no larger mask (render-gl --needs)", &needs_path, NULL, NULL},
    {'A', "atlas", CMD_FLAG, 0, 0, NULL, "make one atlas of texture coordinates per mesh instead of patches", &atlas,
     NULL, NULL},
    {0},
};

static const struct cmd_rule rules[] = {
    {"tile mask-size", "!atlas", NULL},
    {NULL, NULL, NULL},
};

static const char *const examples[] = {
    "meshgen torus | dirfield | lapped-param -v -o torus.glb",
    "lapped-param --atlas model.glb -o atlas.glb",
    NULL,
};

static const struct cmd_program program = {
    .name = "lapped-param",
    .operands = "[FILE]",
    .summary = "cover surfaces with overlapping patches whose texture coordinates follow a direction field",
    .examples = examples,
    .options = options,
    .rules = rules,
    .operands_min = 0,
    .operands_max = 1,
    .seeded = true,
    .binary = true,
};

static void read_options(const struct cmd_args *args, struct lapped_param_options *settings)
{
    *settings = (struct lapped_param_options){
        .lapped = {.size = size,
                   .curved = curved,
                   .stretch_max = stretch,
                   .turn_max_rad = fmin(turn_deg, 90) * (3.14159265358979323846 / 180),
                   .seed = args->seed},
        .tile = tile,
        .roughness = roughness,
        .feather = feather,
        .mask_px = (uint32_t)mask_size,
        .atlas = atlas,
    };
}

/* Sets the sizes of a part: converts lengths in the scene to the units of its mesh, which a node may scale. In a scene
 * that nodes shrink to a point, a mesh has the sizes that it has alone. */
static void set_sizes(const struct lapped_param_options *settings, const struct hatch_scene_extent *extent,
                      uint32_t index, struct lapped_param_part *part)
{
    float low[3] = {0}, high[3] = {0};
    double diagonal = 0, scale = extent->scale[index];
    hatch_mesh_bounds(&part->mesh->mesh, low, high);
    for (int k = 0; k < 3; k++)
        diagonal = hypot(diagonal, (double)high[k] - (double)low[k]);
    double whole = extent->diagonal > 0 ? extent->diagonal : diagonal * scale;
    part->tile = (settings->tile > 0 ? settings->tile : whole / TILES_ON_DIAGONAL) / scale;
    part->size = settings->lapped.size > 0 ? fmin(settings->lapped.size * whole / (diagonal * scale), 1) : 0;
}

/* Warns of nodes that stretch the patches. */
static void warn_uneven(const char *name, const struct hatch_scene_extent *extent, uint32_t count)
{
    double most = 1;
    for (uint32_t i = 0; i < count; i++)
        most = fmax(most, extent->unevenness[i]);
    if (most > UNEVENNESS_MAX)
        cmd_warn(
            name,
            "nodes scale a mesh by up to %.3g times more along one direction than along another, and stretch strokes "
            "by as much: apply the scale to the mesh first",
            most);
}

/* The progress of all meshes. */
struct shares {
    double done, part; /* shares of all faces: in finished meshes, in the present one */
};

static void report_share(void *context, double share)
{
    const struct shares *shares = context;
    cmd_progress("patches", shares->done + share * shares->part);
}

static struct lapped_param_part *cover(struct cmd_args *args, const char *input,
                                       const struct lapped_param_options *settings, const struct hatch_outline *outline,
                                       struct hatch_scene *scene)
{
    struct hatch_err err;
    struct hatch_scene_extent extent;
    const struct hatch_surface *surfaces = cmd_make_surfaces(args, input, scene);
    struct lapped_param_part *parts;
    cmd_check(HATCH_ALLOC(&args->keep, &parts, scene->mesh_count, &err), NULL, &err);
    cmd_check(hatch_scene_find_extent(scene, &args->keep, &args->scratch, &extent, &err), NULL, &err);
    warn_uneven(cmd_input_name(input), &extent, scene->mesh_count);
    if (extent.diagonal > 0 && settings->tile > 0 &&
        (settings->tile > TILE_RANGE * extent.diagonal || settings->tile * TILE_RANGE < extent.diagonal))
        cmd_check(hatch_fail(&err, HATCH_BAD_INPUT, "--tile %g: want a millionth to a million times the diagonal, %.3g",
                             settings->tile, extent.diagonal),
                  cmd_input_name(input), &err);
    double faces = 0;
    for (uint32_t i = 0; i < scene->mesh_count; i++)
        faces += scene->meshes[i].mesh.face_count;
    struct shares shares = {0};
    const struct hatch_progress progress = {report_share, &shares};
    struct lapped_param_options reporting = *settings;
    reporting.lapped.progress = &progress;
    for (uint32_t i = 0; i < scene->mesh_count; i++) {
        struct lapped_param_part *part = &parts[i];
        *part = (struct lapped_param_part){
            .name = cmd_input_name(input), .mesh = &scene->meshes[i], .surface = &surfaces[i]};
        set_sizes(settings, &extent, i, part);
        if (!(part->tile > 0 && isfinite(part->tile)))
            cmd_check(hatch_fail(&err, HATCH_BAD_INPUT, "primitive %u: its size in the scene is zero or infinite", i),
                      part->name, &err);
        shares.part = part->mesh->mesh.face_count / faces;
        if (part->mesh->unseen_tolerance > 0)
            lapped_param_keep(args, part);
        else
            lapped_param_cover(args, &reporting, outline, part);
        part->outline_side *= extent.scale[i];
        part->atlas_side *= extent.scale[i];
        shares.done += shares.part;
    }
    return parts;
}

static void print_notes(const struct lapped_param_part *parts, uint32_t count)
{
    uint32_t patches = 0, cut = 0, enlarged = 0;
    double faces = 0, patch_faces = 0, solved_faces = 0;
    for (uint32_t i = 0; i < count; i++) {
        patches += parts[i].patches;
        cut += parts[i].cut;
        enlarged += parts[i].enlarged;
        faces += parts[i].faces;
        patch_faces += parts[i].patch_faces;
        solved_faces += (double)parts[i].solved_faces;
    }
    for (uint32_t i = 0; i < count; i++)
        if (parts[i].atlas_side > 0)
            cmd_note("primitive %u: the side of its atlas is %g long in the scene", i, parts[i].atlas_side);
    faces = fmax(faces, 1); /* 0 where all parts are kept without patches */
    cmd_note("%u %s, overlap %.2f; %u end at face edges instead of at their outline, %u enlarged to contain a face",
             patches, cmd_plural(patches, "patch", "patches"), patch_faces / faces, cut, enlarged);
    cmd_note("texture coordinates were computed %.1f times per face", solved_faces / faces);
}

/* Makes the mask no larger than pictures of the largest patch, and its soft border, need. */
static void fit_mask(struct cmd_args *args, const char *name, const struct hatch_needs *needs,
                     const struct lapped_param_part *parts, const struct hatch_scene *scene,
                     struct lapped_param_options *settings)
{
    struct hatch_err err;
    double *px, most = 0;
    uint32_t whole = settings->mask_px;
    cmd_check(HATCH_ALLOC(&args->keep, &px, scene->mesh_count, &err), name, &err);
    cmd_mesh_px(args, name, needs, scene, px);
    for (uint32_t i = 0; i < scene->mesh_count; i++)
        most = fmax(most, px[i] * parts[i].outline_side);
    double least = fmax(fmax(HATCH_OUTLINE_PX_MIN, most / PX_PER_TEXEL), FEATHER_PX / settings->feather);
    while (settings->mask_px / 2 >= least)
        settings->mask_px /= 2;
    cmd_note("the mask is %u of %u pixels wide: the largest patch covers %.0f in the pictures", settings->mask_px,
             whole, most);
}

int main(int argc, char **argv)
{
    struct cmd_args args;
    struct lapped_param_options settings;
    struct hatch_scene scene;
    struct hatch_needs needs;
    struct hatch_outline outline;
    struct hatch_err err;
    cmd_begin(&program, argc, argv, &args);
    read_options(&args, &settings);
    const char *input = args.operand_count ? args.operands[0] : NULL, *name = cmd_input_name(input);
    struct cmd_output *output = cmd_open_output(args.output, "glb", true);

    cmd_read_scene_to_write(&args, input, false, &scene);
    cmd_warn_up(name, &scene);
    cmd_warn_strokes(name, &scene);
    cmd_refuse_lapped(name, &scene);
    lapped_param_clear(&args, name, atlas, &scene);
    if (needs_path) {
        cmd_read_needs_and_regions(&args, needs_path, &needs);
        cmd_fit_meshes(&args, input, needs_path, &needs, &scene);
    }
    hatch_outline_make(args.seed, settings.roughness, settings.feather, &outline);
    struct lapped_param_part *parts = cover(&args, input, &settings, &outline, &scene);
    print_notes(parts, scene.mesh_count);
    if (needs_path && !atlas && !mask_given)
        fit_mask(&args, name, &needs, parts, &scene, &settings);
    lapped_param_replace(&args, &scene, parts);
    if (!settings.atlas)
        lapped_param_mask(&args, &outline, settings.mask_px, &scene);

    char comment[256];
    snprintf(comment, sizeof comment,
             "lapped-param --size %.9g --curved %.9g --stretch %.9g --turn %.9g --tile %.9g "
             "--roughness %.9g --feather %.9g%s --seed %llu",
             size, curved, stretch, turn_deg, tile, roughness, feather, atlas ? " --atlas" : "",
             (unsigned long long)args.seed);
    struct hatch_buffer file = {.arena = &args.keep};
    cmd_check(hatch_glb_write_scene(&scene, comment, &args.scratch, &file, &err), name, &err);
    cmd_write(output, file.data, file.size);
    return cmd_end(&args, HATCH_OK);
}
