/* meshfit: makes the meshes of a scene as coarse as its views allow. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "io/glb/glb.h"
#include "shared/scene.h"
#include "meshfit.h"

#define COMMENT_MAX 256

static struct cmd_view_options chosen = CMD_VIEW_OPTIONS;
static double error_px = 0.5;
static int64_t faces, level_count = 1;

static const struct cmd_option options[] = {
    {'e', "error", CMD_REAL, 1e-3, 1000, "PX", "how far the surface may move in the pictures, in pixels (default 0.5)",
     &error_px, NULL, NULL},
    {'n', "faces", CMD_INT, 4, 4294967295, "N", "keep N faces at most, with an error as small as possible", &faces,
     NULL, NULL},
    {'l', "levels", CMD_INT, 1, MESHFIT_LEVELS_MAX, "N",
     "levels of detail, each with twice the error of the one before (default 1)", &level_count, NULL, NULL},
    {0, "size", CMD_WHOLES, 1, 65536, "WxH", "width and height of the pictures in pixels (default 1280x720)",
     chosen.size_px, NULL, NULL},
    {0, "from", CMD_PAIR, -360, 360, "AZ:EL", "see the scene from this azimuth and elevation only (default: all sides)",
     chosen.from_deg, NULL, &chosen.alone},
    {0, "fov", CMD_REAL, 1, 170, "DEGREES", "vertical field of view (default 30)", &chosen.fov_deg, NULL, NULL},
    {0, "zoom", CMD_REAL, 1e-3, 0x1p40, "X", "move X times nearer to the middle of the picture (default 1)",
     &chosen.zoom, NULL, NULL},
    {0},
};

static const struct cmd_rule rules[] = {
    {"error levels", "!faces", "which determines the error"},
    {NULL, NULL, NULL},
};

static const char *const examples[] = {
    "meshgen teapot --faces 100000 | meshfit -o teapot.glb",
    "meshfit --size 960x720 model.glb -o model-coarse.glb",
    NULL,
};

static const struct cmd_program program = {
    .name = "meshfit",
    .operands = "[FILE]",
    .summary = "make the meshes of a scene as coarse as its pictures allow",
    .examples = examples,
    .options = options,
    .rules = rules,
    .operands_min = 0,
    .operands_max = 1,
    .binary = true,
};

/* Reports a level, and warns where nothing could be left out. */
static void report(struct meshfit *fit, struct meshfit_level *level)
{
    const struct hatch_coarse_figures *f = &level->figures;
    if (fit->args->verbose)
        meshfit_measure_all(fit, level);
    cmd_note("%llu of %llu faces; displacement %.3g px at most, 99.9 %% within %.3g px; outlines %.3g px at most; "
             "normals %.3g degrees in the mean",
             (unsigned long long)level->faces, (unsigned long long)fit->faces, f->displacement_px,
             f->displacement_p999_px, f->outline_px, f->normal_deg);
    if (level->faces == fit->faces && level_count == 1)
        cmd_warn(fit->name, "no face can be left out: the meshes are as they were");
}

/* Leaves out the meshes of a scene without nodes, and warns of them. */
static void drop_undrawn(struct cmd_args *args, const char *name, struct hatch_scene *scene)
{
    struct hatch_arena_mark mark = hatch_arena_mark(&args->scratch);
    struct hatch_err err;
    uint32_t all = scene->mesh_count, *first;
    bool *drawn;
    cmd_check(HATCH_ALLOC(&args->scratch, &first, (size_t)all + 1, &err), name, &err);
    cmd_check(HATCH_ALLOC(&args->scratch, &drawn, all, &err), name, &err);
    for (uint32_t n = 0; n < scene->node_count; n++)
        for (uint32_t m = 0; m < scene->nodes[n].mesh_count; m++)
            drawn[scene->nodes[n].first_mesh + m] = true;
    hatch_scene_keep(scene, drawn, first);
    hatch_arena_rewind(&args->scratch, mark);
    uint32_t dropped = all - scene->mesh_count;
    if (dropped > 0)
        cmd_warn(name, "%u %s", dropped,
                 cmd_plural(dropped, "mesh that no node draws is left out", "meshes that no node draws are left out"));
}

/* Removes the normals of flat faces, which a glTF without normals gets: their borders are everywhere. */
static void drop_flat_normals(struct hatch_scene *scene)
{
    for (uint32_t m = 0; m < scene->mesh_count; m++) {
        struct hatch_mesh *mesh = &scene->meshes[m].mesh;
        uint32_t kept = 0;
        for (uint32_t a = 0; a < mesh->attribute_count; a++)
            if (scene->meshes[m].had_normals || (strcmp(mesh->attributes[a].name, "NORMAL") != 0 &&
                                                 strcmp(mesh->attributes[a].name, HATCH_MORPH_NORMAL) != 0))
                mesh->attributes[kept++] = mesh->attributes[a];
        mesh->attribute_count = kept;
    }
}

/* Writes the command, as the file tells it. */
static void describe(char text[COMMENT_MAX])
{
    char goal[64], from[64] = "";
    if (faces > 0)
        snprintf(goal, sizeof goal, "--faces %lld", (long long)faces);
    else
        snprintf(goal, sizeof goal, "--error %.9g --levels %d", error_px, (int)level_count);
    if (chosen.alone)
        snprintf(from, sizeof from, " --from %.9g:%.9g", chosen.from_deg[0], chosen.from_deg[1]);
    snprintf(text, COMMENT_MAX, "meshfit %s --size %.9gx%.9g%s --fov %.9g --zoom %.9g", goal, chosen.size_px[0],
             chosen.size_px[1], from, chosen.fov_deg, chosen.zoom);
}

int main(int argc, char **argv)
{
    struct cmd_args args;
    struct hatch_scene scene, out;
    struct meshfit fit = {.args = &args, .scene = &scene};
    struct meshfit_level levels[MESHFIT_LEVELS_MAX];
    struct hatch_err err;
    cmd_begin(&program, argc, argv, &args);
    const char *input = args.operand_count ? args.operands[0] : NULL;
    struct cmd_output *output = cmd_open_output(args.output, "glb", true);
    fit.name = cmd_input_name(input);

    cmd_read_scene_to_write(&args, input, true, &scene);
    drop_undrawn(&args, fit.name, &scene);
    cmd_add_normals(&args, fit.name, &scene);
    drop_flat_normals(&scene);
    meshfit_begin(&fit, &chosen);
    for (int64_t i = 0; i < level_count; i++) {
        if (faces > 0)
            meshfit_by_faces(&fit, (uint64_t)faces, &levels[i]);
        else
            meshfit_by_error(&fit, ldexp(error_px, (int)i), &levels[i]);
        report(&fit, &levels[i]);
    }
    meshfit_join_levels(&fit, levels, (uint32_t)level_count, &out);

    char comment[COMMENT_MAX];
    describe(comment);
    struct hatch_buffer file = {.arena = &args.keep};
    cmd_check(hatch_glb_write_scene(&out, comment, &args.scratch, &file, &err), fit.name, &err);
    cmd_write(output, file.data, file.size);
    return cmd_end(&args, HATCH_OK);
}
