/* dirfield: finds the direction in which strokes should run over a surface. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "cmd_surface.h"
#include "dirfield.h"
#include "io/gltf.h"

static int method, solver;
static bool solver_given, fit_given;
static double smooth = CMD_FIELD_SMOOTH, radius;
static int64_t degree, coarse;
static const char *direction = "max", *constraints, *report_path, *arrows_path;

static const char *const method_choices[] = {"linear", "hz", NULL};
static const char *const solver_choices[] = {"multigrid", "cholesky", NULL};

static const struct cmd_option options[] = {
    {'m', "method", CMD_CHOICE, 0, 0, "METHOD", "linear (default) or hz: see the manual", &method,
     method_choices, NULL},
    {0, "solver", CMD_CHOICE, 0, 0, "SOLVER", "of linear: multigrid (default) or cholesky", &solver,
     solver_choices, &solver_given},
    {'S', "smooth", CMD_REAL, 0, 1, "X", "0: the curvature as it is, to 1: as smooth as can be (default 0.5)",
     &smooth, NULL, NULL},
    {'d', "direction", CMD_TEXT, 0, 0, "WHICH", "max (default), min, or degrees from max", &direction, NULL,
     NULL},
    {'c', "constraints", CMD_TEXT, 0, 0, "FILE", "directions given by hand: see the manual", &constraints,
     NULL, NULL},
    {0, "coarse", CMD_INT, 1, 20000000, "FACES", "curvature of the mesh simplified to so many faces", &coarse,
     NULL, NULL},
    {0, "radius", CMD_REAL, 0.5, 100, "EDGES", "fit over this far, in mean edges (default: as noise asks)",
     &radius, NULL, &fit_given},
    {0, "degree", CMD_INT, 2, 4, "N", "of the fitted polynomial (default: as noise asks)", &degree, NULL,
     &fit_given},
    {'r', "report", CMD_TEXT, 0, 0, "FILE", "singularities, confidence, times: a table", &report_path, NULL,
     NULL},
    {'a', "arrows", CMD_TEXT, 0, 0, "FILE.ply", "the field as coloured slivers, to look at", &arrows_path,
     NULL, NULL},
    {0},
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

static void read_options(struct dirfield_options *how)
{
    if (solver_given && method == HATCH_FIELD_HZ)
        cmd_usage("--solver goes with --method linear");
    if (fit_given && coarse)
        cmd_usage("--radius and --degree do not go with --coarse, which fits to each face's neighbours");
    *how = (struct dirfield_options){
        .turn_deg = turn_of(direction),
        .curvature = {.radius = radius, .degree = (uint32_t)degree},
        .field = {.method = (enum hatch_field_method)method,
                  .solver = (enum hatch_field_solver)solver,
                  .smooth = smooth,
                  .tolerance = CMD_FIELD_TOLERANCE,
                  .iterations_max = CMD_FIELD_ITERATIONS},
    };
}

/* What goes beside the GLB, where it was asked for. */
struct extras {
    struct dirfield_report report;
    struct dirfield_arrows arrows;
    struct cmd_file *report_file, *arrows_file;
};

static struct dirfield_part *make_parts(struct cmd_args *args, const char *input, struct hatch_scene *scene)
{
    struct hatch_err err;
    const struct hatch_surface *surfaces = cmd_make_surfaces(args, input, scene);
    struct dirfield_part *parts = HATCH_NEW(&args->keep, struct dirfield_part, scene->mesh_count, &err);
    cmd_check(parts ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    for (uint32_t i = 0; i < scene->mesh_count; i++)
        parts[i] = (struct dirfield_part){cmd_input_name(input), i, &scene->meshes[i], &surfaces[i], .ms = {0}};
    return parts;
}

/* Of several meshes each gets as many of the coarse faces as it has of the others. */
static double coarse_share(const struct dirfield_part *parts, uint32_t count)
{
    double faces = 0;
    for (uint32_t i = 0; i < count; i++)
        faces += parts[i].surface->face_count;
    return fmin(1, (double)coarse / faces);
}

static void begin_extras(struct cmd_args *args, const struct hatch_scene *scene,
                         const struct dirfield_part *parts, struct extras *extras)
{
    uint32_t points = 0;
    for (uint32_t i = 0; i < scene->mesh_count; i++)
        points += parts[i].surface->point_count;
    dirfield_report_begin(&extras->report, args, points);
    if (extras->arrows_file)
        dirfield_arrows_begin(&extras->arrows, args, scene);
}

static void work(struct cmd_args *args, const struct dirfield_options *how, const struct hatch_scene *scene,
                 struct dirfield_part *part, struct extras *extras)
{
    hatch_arena_init(&part->work, args->max_memory);
    dirfield_solve(args, how, cmd_input_name(constraints), part);
    cmd_attach_field(args, part->name, part->surface, part->field.direction, part->field.confidence,
                     part->mesh);
    if (extras->report_file)
        dirfield_report_add(&extras->report, part);
    if (extras->arrows_file)
        dirfield_arrows_add(&extras->arrows, scene, part);
    hatch_arena_free(&part->work);
}

static void say(const struct cmd_args *args, const char *input, const struct dirfield_part *parts, uint32_t count)
{
    uint32_t components = 0, undirected = 0, singularities = 0;
    for (uint32_t i = 0; i < count; i++) {
        components += parts[i].surface->component_count;
        undirected += parts[i].field.undirected;
        singularities += parts[i].singular.count;
    }
    if (undirected > 0 && components == 1)
        cmd_warn(cmd_input_name(input), "the surface has no direction of its own, as a plane or a sphere: its "
                                        "lines are smooth, but follow from nothing");
    else if (undirected > 0)
        cmd_warn(cmd_input_name(input), "%u of %u parts have no direction of their own, as a plane or a sphere: "
                                        "their lines are smooth, but follow from nothing",
                 undirected, components);
    cmd_note("%u singularities; peak memory %zu KiB", singularities,
             (args->keep.peak_bytes + args->scratch.peak_bytes) / 1024);
}

static void set_content(struct cmd_file *file, struct hatch_bytes bytes)
{
    file->data = bytes.data;
    file->size = bytes.size;
}

static void encode(struct cmd_args *args, const struct hatch_scene *scene, const char *input,
                   struct cmd_file *file)
{
    struct hatch_err err;
    struct hatch_buffer glb = {.arena = &args->keep};
    char comment[160];
    snprintf(comment, sizeof comment, "dirfield --method %s --smooth %g --direction %s", method_choices[method],
             smooth, direction);
    cmd_check(hatch_glb_write_scene(scene, comment, &args->scratch, &glb, &err), cmd_input_name(input), &err);
    set_content(file, (struct hatch_bytes){glb.data, glb.size});
}

int main(int argc, char **argv)
{
    struct cmd_args args;
    struct dirfield_options how;
    struct hatch_scene scene;
    struct extras extras = {.report_file = NULL};
    struct cmd_file files[3] = {{.output = NULL}};
    size_t file_count = 1;
    cmd_begin(&program, argc, argv, &args);
    read_options(&how);
    const char *input = args.operand_count ? args.operands[0] : NULL;
    cmd_check_ending(args.output, "glb");
    cmd_check_ending(arrows_path, "ply");
    files[0].output = cmd_open_output(args.output, true);
    if (report_path) {
        extras.report_file = &files[file_count++];
        extras.report_file->output = cmd_open_output(report_path, false);
    }
    if (arrows_path) {
        extras.arrows_file = &files[file_count++];
        extras.arrows_file->output = cmd_open_output(arrows_path, true);
    }

    cmd_read_scene(&args, input, CMD_SCENE_AS_IS, &scene);
    double begun_ms = cmd_elapsed_ms();
    struct dirfield_part *parts = make_parts(&args, input, &scene);
    double surfaces_ms = cmd_elapsed_ms() - begun_ms;
    if (constraints)
        dirfield_read_constraints(&args, constraints, parts, scene.mesh_count);
    begin_extras(&args, &scene, parts, &extras);
    how.coarse = coarse_share(parts, scene.mesh_count);
    for (uint32_t i = 0; i < scene.mesh_count; i++)
        work(&args, &how, &scene, &parts[i], &extras);
    encode(&args, &scene, input, &files[0]);
    if (extras.report_file)
        set_content(extras.report_file, dirfield_report_end(&extras.report, surfaces_ms));
    if (extras.arrows_file)
        set_content(extras.arrows_file, dirfield_arrows_end(&extras.arrows));
    say(&args, input, parts, scene.mesh_count);
    cmd_write_all(files, file_count);
    return cmd_end(&args, HATCH_OK);
}
