/* The search for the tolerance that keeps a promise. */
#include <math.h>

#include "coarse/scene.h"
#include "meshfit.h"

#define TRIES 12      /* runs for one error */
#define LOCAL_TRIES 5 /* those of them after which the tolerance is lowered only near places with a larger error */
#define LOWER 0.7     /* factor of the tolerance everywhere after each later run */
#define FACE_TRIES 18 /* tolerances for one number of faces */
#define ESTIMATES 7   /* those of them that are estimated while none has been large enough */
#define LEAP 8        /* factor of later ones until one is */
#define CLOSE 0.97    /* share of the number of faces that is near enough */
#define CAUTION 0.85  /* factor of the tolerance that should lead to the error */
#define NO_ERROR 1e-3 /* displacement in pixels of which nobody wants less */
#define ERROR_MAX 1e5 /* largest tolerance in pixels: that of a mesh of very few faces */

static uint64_t count_faces(const struct meshfit *fit, const struct hatch_mesh *meshes)
{
    uint64_t faces = 0;
    for (uint32_t m = 0; m < fit->scene->mesh_count; m++)
        faces += meshes[m].face_count;
    return faces;
}

void meshfit_begin(struct meshfit *fit, const struct cmd_view_options *views)
{
    struct cmd_args *args = fit->args;
    struct hatch_err err;
    for (uint32_t m = 0; m < fit->scene->mesh_count; m++)
        fit->faces += fit->scene->meshes[m].mesh.face_count;
    cmd_make_views(args, fit->name, fit->scene, views, &fit->pose, &fit->bounds, &fit->views);
    if (!fit->bounds.empty)
        cmd_check(
            hatch_scene_flatten(fit->scene, fit->bounds.center, true, &args->keep, &args->scratch, &fit->full, &err),
            fit->name, &err);
    cmd_check(HATCH_ALLOC(&args->keep, &fit->share, fit->full.vertex_count, &err), fit->name, &err);
    cmd_check(HATCH_ALLOC(&args->keep, &fit->worst, fit->full.face_count, &err), fit->name, &err);
}

/* Takes the meshes of the scene as they are. */
static void take_scene(struct meshfit *fit, struct meshfit_level *level)
{
    struct hatch_err err;
    cmd_check(HATCH_ALLOC(&fit->args->keep, &level->meshes, fit->scene->mesh_count, &err), fit->name, &err);
    for (uint32_t m = 0; m < fit->scene->mesh_count; m++)
        level->meshes[m] = fit->scene->meshes[m].mesh;
    level->faces = fit->faces;
    level->figures = (struct hatch_coarse_figures){0};
}

/* Makes meshes with a tolerance; where no face can be left out of any, they are the scene's. */
static void make(struct meshfit *fit, double tolerance_px, const float *share, struct meshfit_level *level)
{
    struct cmd_args *args = fit->args;
    struct hatch_err err;
    cmd_check(HATCH_ALLOC(&args->keep, &level->meshes, fit->scene->mesh_count, &err), fit->name, &err);
    cmd_check(hatch_coarse_scene(&fit->pose, &fit->views, tolerance_px, share, &args->keep, &args->scratch,
                                 level->meshes, &err),
              fit->name, &err);
    level->faces = count_faces(fit, level->meshes);
    if (level->faces == fit->faces)
        take_scene(fit, level);
}

/* Measures the meshes of a level beside those of the scene: if they are the same, nothing is displaced.
 *   all  true: outlines and normals, too; false: fills fit->worst */
static void measure(struct meshfit *fit, bool all, struct meshfit_level *level)
{
    struct cmd_args *args = fit->args;
    struct hatch_scene scene = *fit->scene;
    struct hatch_mesh coarse;
    struct hatch_err err;
    struct hatch_arena_mark mark = hatch_arena_mark(&args->keep);
    level->figures = (struct hatch_coarse_figures){0};
    if (level->faces == fit->faces)
        return;
    for (uint32_t f = 0; f < fit->full.face_count; f++)
        atomic_init(&fit->worst[f], 0);
    cmd_check(HATCH_ALLOC(&args->keep, &scene.meshes, scene.mesh_count, &err), fit->name, &err);
    for (uint32_t m = 0; m < scene.mesh_count; m++) {
        scene.meshes[m] = fit->scene->meshes[m];
        scene.meshes[m].mesh = level->meshes[m];
    }
    cmd_check(hatch_scene_flatten(&scene, fit->bounds.center, true, &args->keep, &args->scratch, &coarse, &err),
              fit->name, &err);
    cmd_check(hatch_measure_coarse(&fit->full, &coarse, &fit->views, all ? NULL : fit->worst, cmd_pool(args),
                                   &args->scratch, &level->figures, &err),
              fit->name, &err);
    hatch_arena_rewind(&args->keep, mark);
}

/* Lowers the tolerance at the vertices of faces that are displaced by more than the error.
 *   everywhere  at all others, too */
static void tighten(struct meshfit *fit, double error_px, bool everywhere)
{
    struct hatch_arena *scratch = &fit->args->scratch;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_err err;
    double *worst; /* per vertex */
    cmd_check(HATCH_ALLOC(scratch, &worst, fit->full.vertex_count, &err), fit->name, &err);
    for (size_t i = 0; i < 3 * (size_t)fit->full.face_count; i++) {
        uint32_t vertex = fit->full.indices[i];
        worst[vertex] = fmax(worst[vertex], atomic_load(&fit->worst[i / 3]) / HATCH_WORST_STEPS);
    }
    for (uint32_t v = 0; v < fit->full.vertex_count; v++)
        if (worst[v] > error_px)
            fit->share[v] *= (float)(CAUTION * error_px / worst[v]);
        else if (everywhere)
            fit->share[v] *= (float)LOWER;
    hatch_arena_rewind(scratch, mark);
}

void meshfit_by_error(struct meshfit *fit, double error_px, struct meshfit_level *level)
{
    struct hatch_arena_mark mark = hatch_arena_mark(&fit->args->keep);
    for (uint32_t v = 0; v < fit->full.vertex_count; v++)
        fit->share[v] = 1;
    for (int i = 0; i < TRIES; i++) {
        hatch_arena_rewind(&fit->args->keep, mark);
        make(fit, error_px, fit->share, level);
        if (fit->full.face_count == 0)
            return;
        measure(fit, false, level);
        if (level->figures.displacement_px <= error_px)
            return;
        tighten(fit, error_px, i >= LOCAL_TRIES);
    }
    hatch_arena_rewind(&fit->args->keep, mark);
    take_scene(fit, level);
}

/* Returns whether the meshes of a level lie where those of the scene do. Where two tolerances leave as many faces, a
 * smaller one then changes nothing but its own roundings. */
static bool is_exact(struct meshfit *fit, struct meshfit_level *level)
{
    if (fit->full.face_count > 0)
        measure(fit, false, level);
    return level->figures.displacement_px <= NO_ERROR;
}

static bool has_texcoords(const struct hatch_scene *scene)
{
    for (uint32_t m = 0; m < scene->mesh_count; m++)
        if (hatch_mesh_find(&scene->meshes[m].mesh, "TEXCOORD_0", 2))
            return true;
    return false;
}

void meshfit_by_faces(struct meshfit *fit, uint64_t faces, struct meshfit_level *level)
{
    struct hatch_arena_mark mark = hatch_arena_mark(&fit->args->keep);
    struct hatch_err err;
    double low = 0, high = INFINITY, tolerance = 1;
    uint64_t fewest = 0; /* faces with the tolerance `high` */
    take_scene(fit, level);
    if (level->faces <= faces)
        return;
    for (int i = 0; i < FACE_TRIES; i++) {
        hatch_arena_rewind(&fit->args->keep, mark);
        make(fit, tolerance, NULL, level);
        bool same = level->faces == fewest;
        if (level->faces > faces)
            low = tolerance;
        else {
            high = tolerance;
            fewest = level->faces;
        }
        if ((level->faces <= faces && (double)level->faces >= CLOSE * (double)faces) || low >= ERROR_MAX)
            break;
        if (same && is_exact(fit, level))
            break;
        /* The number of faces falls about as the tolerance grows, or more slowly. */
        double next = tolerance * (double)level->faces / (double)faces;
        if (isinf(high) && i >= ESTIMATES)
            next = LEAP * low;
        if (!(next > low && next < high))
            next = low == 0 ? high / 4 : isinf(high) ? 4 * low : sqrt(low * high);
        tolerance = fmin(next, ERROR_MAX);
    }
    if (level->faces > faces && isfinite(high)) {
        hatch_arena_rewind(&fit->args->keep, mark);
        make(fit, high, NULL, level);
    }
    if (level->faces > faces)
        cmd_check(hatch_fail(&err, HATCH_BAD_INPUT, "--faces %llu: the surface%s cannot have fewer than %llu",
                             (unsigned long long)faces,
                             has_texcoords(fit->scene) ? ", with the borders of its texture coordinates," : "",
                             (unsigned long long)level->faces),
                  fit->name, &err);
    if (fit->full.face_count > 0)
        measure(fit, false, level);
}

void meshfit_measure_all(struct meshfit *fit, struct meshfit_level *level)
{
    if (fit->full.face_count > 0)
        measure(fit, true, level);
}
