#include "shared/field.h"

#include <math.h>

/* Rounding steps: coarser than the differences between the libm of different processors, and too fine to be visible
 * (2^-20 is 0.00005 degrees). */
#define DIRECTION_STEP 0x1p-20
#define CONFIDENCE_STEP 0x1p-12

static void round_direction(const double direction[3], double confidence, float out[4])
{
    double rounded[3], sign = 0;
    for (int k = 0; k < 3; k++) {
        rounded[k] = round(direction[k] / DIRECTION_STEP) * DIRECTION_STEP;
        sign = sign != 0 ? sign : rounded[k] > 0 ? 1 : rounded[k] < 0 ? -1 : 0;
    }
    for (int k = 0; k < 3; k++)
        out[k] = rounded[k] == 0 ? 0.0f : (float)(sign * rounded[k]);
    out[3] = (float)(round(confidence / CONFIDENCE_STEP) * CONFIDENCE_STEP);
}

void cmd_attach_field(struct cmd_args *args, const char *name, const struct hatch_surface *surface,
                      const double *direction, const double *confidence, struct hatch_scene_mesh *mesh)
{
    struct hatch_err err;
    struct hatch_mesh made;
    uint32_t *vertex_point;
    cmd_check(hatch_surface_to_mesh(surface, &mesh->mesh, &args->keep, &args->scratch, &made, &vertex_point, &err),
              name, &err);
    float *directions = hatch_mesh_find(&made, "_HATCH_DIR", 4);
    if (!directions)
        cmd_check(hatch_mesh_add(&args->keep, &made, "_HATCH_DIR", 4, &directions, &err), name, &err);
    for (size_t v = 0; v < made.vertex_count; v++) {
        size_t p = vertex_point[v];
        round_direction(&direction[3 * p], confidence[p], &directions[4 * v]);
    }
    cmd_check(hatch_mesh_add_normals(&args->keep, &args->scratch, &made, CMD_CREASE_RAD, &err), name, &err);
    mesh->mesh = made;
    mesh->curves = (struct hatch_curves){0}; /* they lie on the old faces */
    mesh->file_vertices = made.vertex_count;
    mesh->numbers = NULL;
    mesh->had_normals = true;
}

enum hatch_status cmd_finish_curvature(struct cmd_args *args, const struct hatch_surface *surface,
                                       struct hatch_frames *frames, struct hatch_curvature *curvature,
                                       struct hatch_err *err)
{
    hatch_curvature_clear_crease_confidence(surface, CMD_FIELD_HARD_RAD, curvature);
    HATCH_TRY(hatch_curvature_follow_rims(surface, frames, CMD_FIELD_HARD_RAD, &args->scratch, curvature, err));
    hatch_curvature_set_planes(surface, curvature);
    HATCH_TRY(hatch_frames_set_normals(surface, curvature->normal, &args->scratch, frames, err));
    return hatch_curvature_continue_axes(surface, frames, &args->scratch, curvature, err);
}

static enum hatch_status solve(struct cmd_args *args, const struct hatch_surface *surface, struct hatch_arena *work,
                               struct hatch_field *field, struct hatch_err *err)
{
    const struct hatch_curvature_options adaptive = {.pool = cmd_pool(args)};
    static const struct hatch_field_options options = {.method = HATCH_FIELD_LINEAR,
                                                       .solver = HATCH_FIELD_MULTIGRID,
                                                       .smooth = CMD_FIELD_SMOOTH,
                                                       .tolerance = CMD_FIELD_TOLERANCE,
                                                       .iterations_max = CMD_FIELD_ITERATIONS};
    struct hatch_frames frames;
    struct hatch_curvature curvature;
    bool *filled;
    HATCH_TRY(HATCH_ALLOC(work, &filled, surface->component_count, err));
    HATCH_TRY(hatch_frames_begin(surface, work, &args->scratch, &frames, err));
    HATCH_TRY(hatch_curvature_estimate(surface, &frames, &adaptive, work, &args->scratch, &curvature, err));
    HATCH_TRY(cmd_finish_curvature(args, surface, &frames, &curvature, err));
    hatch_field_fill_from_dihedrals(surface, &frames, CMD_FIELD_HARD_RAD, NULL, curvature.direction,
                                    curvature.confidence);
    hatch_field_fill_unconstrained(surface, &frames, NULL, curvature.direction, curvature.confidence, filled);
    const struct hatch_field_problem problem = {.surface = surface,
                                                .frames = &frames,
                                                .direction = curvature.direction,
                                                .confidence = curvature.confidence,
                                                .principal = true};
    HATCH_TRY(hatch_field_solve(&problem, &options, work, &args->scratch, field, err));
    hatch_field_clear_filled_confidence(surface, filled, field);
    hatch_field_clear_plane_confidence(surface, curvature.confidence, field);
    return HATCH_OK;
}

void cmd_add_field(struct cmd_args *args, const char *name, const struct hatch_surface *surface,
                   struct hatch_scene_mesh *mesh)
{
    struct hatch_arena work;
    struct hatch_field field;
    struct hatch_err err;
    hatch_arena_init(&work, args->max_memory);
    cmd_check(solve(args, surface, &work, &field, &err), name, &err);
    cmd_attach_field(args, name, surface, field.direction, field.confidence, mesh);
    hatch_arena_free(&work);
}
