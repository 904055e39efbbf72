/* meshgen: writes a built-in shape as GLB. */
#include <stdio.h>
#include <string.h>

#include "shared/cmd.h"
#include "io/glb/glb.h"
#include "shapes/shapes.h"

static int64_t faces = 10000;
static double jitter, noise, stretch = 1;
static int uv;
static bool field;

static const char *const uv_choices[] = {"natural", "even", "whole", NULL};

static const struct cmd_option options[] = {
    {'n', "faces", CMD_INT, 2, HATCH_SHAPE_FACES_MAX, "N", "approximate number of triangles (default 10000)", &faces,
     NULL, NULL},
    {'J', "jitter", CMD_REAL, 0, 1, "SHARE",
     "irregularity of the triangles; 1: vertices move by up to a quarter of a grid step (default 0)", &jitter, NULL,
     NULL},
    {'S', "stretch", CMD_REAL, 1, 16, "RATIO", "ratio of the sides of the triangles, along u and v (default 1)",
     &stretch, NULL, NULL},
    {'N', "noise", CMD_REAL, 0, 1, "SHARE",
     "noise along the normals: standard deviation in mean edge lengths (default 0)", &noise, NULL, NULL},
    {'u', "uv", CMD_CHOICE, 0, 0, "HOW",
     "natural (by surface parameter; default), even (v by arc length), whole (0 to 1)", &uv, uv_choices, NULL},
    {'f', "field", CMD_FLAG, 0, 0, NULL, "add the true first principal directions as _HATCH_DIR", &field, NULL, NULL},
    {0},
};

static const char *const examples[] = {
    "meshgen teapot -o teapot.glb",
    "meshgen torus --faces 50000 --jitter 0.8 --seed 3 | hatchstat mesh",
    NULL,
};

static const struct cmd_program program = {
    .name = "meshgen",
    .operands = "SHAPE",
    .summary = "make a shape, such as teapot, sphere or torus; the manual lists them",
    .examples = examples,
    .options = options,
    .names = hatch_shape_names,
    .operands_min = 1,
    .operands_max = 1,
    .seeded = true,
    .binary = true,
};

int main(int argc, char **argv)
{
    struct cmd_args args;
    cmd_begin(&program, argc, argv, &args);
    enum hatch_shape shape = (enum hatch_shape)args.name;
    const struct hatch_shape_options shape_options = {
        .faces = (uint32_t)faces,
        .jitter = (float)jitter,
        .stretch = (float)stretch,
        .noise = (float)noise,
        .seed = args.seed,
        .uv = (enum hatch_shape_uv)uv,
        .field = field,
    };
    if (field && shape == HATCH_SHAPE_TEAPOT)
        cmd_usage("--field: the curvature of the teapot has no closed form");
    struct cmd_output *output = cmd_open_output(args.output, "glb", true);

    struct hatch_err err;
    struct hatch_mesh mesh;
    cmd_check(hatch_shape_make(shape, &shape_options, &args.keep, &args.scratch, &mesh, &err), NULL, &err);
    char comment[180], stretched[32] = "";
    if (stretch != 1)
        snprintf(stretched, sizeof stretched, " --stretch %.9g", stretch);
    snprintf(comment, sizeof comment, "meshgen %s --faces %u --jitter %.9g%s --noise %.9g --uv %s%s --seed %llu",
             hatch_shape_names[shape], shape_options.faces, jitter, stretched, noise, uv_choices[uv],
             field ? " --field" : "", (unsigned long long)args.seed);
    struct hatch_buffer file = {.arena = &args.keep};
    cmd_check(hatch_glb_write(&mesh, hatch_shape_names[shape], comment, &args.scratch, &file, &err), NULL, &err);
    cmd_note("%u faces, %u vertices", mesh.face_count, mesh.vertex_count);
    cmd_write(output, file.data, file.size);
    return cmd_end(&args, HATCH_OK);
}
