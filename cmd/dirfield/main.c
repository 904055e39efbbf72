/* dirfield: computes the direction in which strokes should run over a surface. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "dirfield.h"

#define DESCENT_TOLERANCE 1e-5 /* radians */

static int method, solver;
static double smooth = CMD_FIELD_SMOOTH, radius;
static int64_t degree, coarse;
static const char *direction = "max", *constraints, *report_path, *arrows_path, *needs_path;

static const char *const method_choices[] = {"linear", "hz", NULL};
static const char *const solver_choices[] = {"multigrid", "cholesky", NULL};

static const struct cmd_option options[] = {
    {'m', "method", CMD_CHOICE, 0, 0, "METHOD", "linear (default) or hz (Hertzmann and Zorin)", &method, method_choices,
     NULL},
    {0, "solver", CMD_CHOICE, 0, 0, "SOLVER", "solver of --method linear: multigrid (default) or cholesky", &solver,
     solver_choices, NULL},
    {'S', "smooth", CMD_REAL, 0, 1, "X", "amount of smoothing; 0: none (default 0.35)", &smooth, NULL, NULL},
    {'d', "direction", CMD_TEXT, 0, 0, "WHICH",
     "max (of largest absolute curvature; default), min (across it), or degrees from max", &direction, NULL, NULL},
    {'c', "constraints", CMD_TEXT, 0, 0, "FILE", "read a table of directions given at positions or vertex numbers",
     &constraints, NULL, NULL},
    {0, "coarse", CMD_INT, 1, 20000000, "FACES", "fit curvature to a mesh simplified to FACES faces", &coarse, NULL,
     NULL},
    {0, "radius", CMD_REAL, 0.5, 100, "EDGES", "radius of the fits, in mean edge lengths (default: chosen per point)",
     &radius, NULL, NULL},
    {0, "degree", CMD_INT, 2, 4, "N", "degree of the fitted polynomials (default: chosen per point)", &degree, NULL,
     NULL},
    {'N', "needs", CMD_TEXT, 0, 0, "FILE", "make meshes no finer than views need (render-gl --needs)", &needs_path,
     NULL, NULL},
    {'r', "report", CMD_TEXT, 0, 0, "FILE", "write a table of singularities and confidence", &report_path, NULL, NULL},
    {'a', "arrows", CMD_TEXT, 0, 0, "FILE.ply", "write the field as a mesh of coloured slivers", &arrows_path, NULL,
     NULL},
    {0},
};

static const struct cmd_rule rules[] = {
    {"solver", "method=linear", NULL},
    {"radius degree", "!coarse", "it fits to the neighbours of each face"},
    {"json", "report", "it is the form of that table"},
    {NULL, NULL, NULL},
};

static const char *const examples[] = {
    "meshgen torus | dirfield - --report torus.tsv -o torus.glb",
    "dirfield model.glb --direction min --arrows field.ply -o field.glb",
    NULL,
};

static const struct cmd_program program = {
    .name = "dirfield",
    .operands = "[FILE]",
    .summary = "find the direction in which strokes should run over a surface",
    .examples = examples,
    .options = options,
    .rules = rules,
    .operands_min = 0,
    .operands_max = 1,
    .reports = true,
    .binary = true,
};

static double turn_of(const char *text)
{
    double degrees;
    if (strcmp(text, "max") == 0)
        return 0;
    if (strcmp(text, "min") == 0)
        return 90;
    if (!hatch_text_number((struct hatch_text){text, strlen(text)}, &degrees) || !(fabs(degrees) <= 360))
        cmd_usage("--direction: '%s' is not max, min or a number from -360 to 360", text);
    return degrees;
}

static void read_options(struct dirfield_options *parsed)
{
    *parsed = (struct dirfield_options){
        .turn_deg = turn_of(direction),
        .constraints = constraints,
        .needs = needs_path,
        .coarse_faces = (double)coarse,
        .curvature = {.radius = radius, .degree = (uint32_t)degree},
        .field = {.method = (enum hatch_field_method)method,
                  .solver = (enum hatch_field_solver)solver,
                  .smooth = smooth,
                  .tolerance = method == HATCH_FIELD_HZ ? DESCENT_TOLERANCE : CMD_FIELD_TOLERANCE,
                  .iterations_max = CMD_FIELD_ITERATIONS},
    };
    snprintf(parsed->comment, sizeof parsed->comment, "dirfield --method %s --smooth %.9g --direction %s",
             method_choices[method], smooth, direction);
}

int main(int argc, char **argv)
{
    struct cmd_args args;
    struct dirfield_options parsed;
    struct cmd_file files[DIRFIELD_FILES] = {{.output = NULL}};
    cmd_begin(&program, argc, argv, &args);
    read_options(&parsed);
    const char *input = args.operand_count ? args.operands[0] : NULL;
    if (constraints && strcmp(constraints, "-") == 0 && (!input || strcmp(input, "-") == 0))
        cmd_usage("the mesh and the constraints cannot both come from standard input");
    files[DIRFIELD_MESH].output = cmd_open_output(args.output, "glb", true);
    if (report_path)
        files[DIRFIELD_REPORT].output = cmd_open_report(&args, report_path);
    if (arrows_path)
        files[DIRFIELD_ARROWS].output = cmd_open_output(arrows_path, "ply", true);
    dirfield_run(&args, &parsed, input, files);

    size_t count = 0;
    for (size_t i = 0; i < DIRFIELD_FILES; i++)
        if (files[i].output)
            files[count++] = files[i];
    cmd_write_all(files, count);
    return cmd_end(&args, HATCH_OK);
}
