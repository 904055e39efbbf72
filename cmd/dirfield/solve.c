#include <math.h>

#include "dirfield.h"
#include "io/openmesh/openmesh.h"
#include "math/vector.h"

#define TANGENT_MIN 1e-3  /* length of the tangent component of a constraint, as a share of its length */
#define TANGENT_SHARE 0.9 /* of the longest tangent component: sides of a crease with shorter ones do not count */

static void end_phase(struct dirfield_job *job, enum dirfield_phase phase, double begun_ms)
{
    job->ms[phase] = cmd_elapsed_ms() - begun_ms;
    cmd_progress("directions", ((double)phase + 1) / (double)PHASE_COUNT);
}

static void check(const struct dirfield_job *job, enum hatch_status status, struct hatch_err *err)
{
    if (status != HATCH_OK && job->number > 0)
        hatch_fail_at(err, "primitive %u: ", job->number);
    cmd_check(status, job->name, err);
}

/* Rotates the directions that are not given by hand. Multiples of 90 degrees are exact, and independent of the
 * orientation. */
static void rotate_directions(const struct hatch_frames *frames, const struct hatch_surface *surface, double degrees,
                              const double *constraint_weight, double *direction)
{
    double right_angles = degrees / 90, radians = degrees * (3.14159265358979323846 / 180);
    bool exact = right_angles == floor(right_angles), across = exact && fmod(right_angles, 2) != 0;
    double cosine = exact ? !across : cos(radians), sine = exact ? across : sin(radians);
    for (size_t p = 0; p < surface->point_count; p++) {
        double *d = &direction[3 * p], left[3];
        if (constraint_weight && constraint_weight[p] > 0)
            continue;
        hatch_vec_cross(&frames->normal[3 * p], d, left);
        for (int k = 0; k < 3; k++)
            d[k] = cosine * d[k] + sine * left[k];
    }
}

static enum hatch_status check_orientable(const struct hatch_surface *surface, double degrees, struct hatch_err *err)
{
    for (uint32_t c = 0; c < surface->component_count && fmod(degrees, 90) != 0; c++)
        if (!surface->components[c].orientable)
            return hatch_fail(err, HATCH_BAD_INPUT,
                              "component %u is a one-sided surface: use --direction max or min, not %g degrees", c,
                              degrees);
    return HATCH_OK;
}

static enum hatch_status estimate(struct cmd_args *args, const struct dirfield_options *options,
                                  struct dirfield_job *job, struct hatch_curvature *curvature, struct hatch_err *err)
{
    struct hatch_curvature_options fits = options->curvature;
    fits.pool = cmd_pool(args);
    if (!(options->coarse_faces > 0))
        return hatch_curvature_estimate(job->surface, &job->frames, &fits, &job->work, &args->scratch, curvature, err);
    struct hatch_mesh repaired, coarse;
    uint32_t *vertex_point, faces = (uint32_t)fmax(1, round(options->coarse_faces * job->share));
    HATCH_TRY(hatch_surface_to_mesh(job->surface, &job->mesh->mesh, &job->work, &args->scratch, &repaired,
                                    &vertex_point, err));
    HATCH_TRY(hatch_mesh_decimate(&repaired, faces, &job->work, &args->scratch, &coarse, NULL, err));
    return hatch_curvature_coarse(job->surface, &job->frames, &coarse, &job->work, &args->scratch, curvature, err);
}

/* Returns the plane that a point lies on, or HATCH_NO_SIDE. */
static uint32_t plane_of(const struct hatch_surface *surface, uint32_t point)
{
    uint32_t plane = HATCH_NO_SIDE;
    for (uint32_t i = surface->ring_first[point]; i < surface->ring_first[point + 1]; i++)
        if (surface->ring_face[i] != HATCH_NO_SIDE && surface->face_plane[surface->ring_face[i]] != HATCH_NO_SIDE)
            plane = surface->face_plane[surface->ring_face[i]];
    return plane;
}

/* Frees planes with directions given by hand from the direction that planes have.
 *   weight  per point, over 0 where a direction is given */
static void free_planes(struct dirfield_job *job, const double *weight, double *confidence)
{
    struct hatch_err err;
    const struct hatch_surface *surface = job->surface;
    bool *given;
    cmd_check(HATCH_ALLOC(&job->work, &given, surface->plane_count, &err), NULL, &err);
    for (uint32_t p = 0; p < surface->point_count; p++) {
        uint32_t plane = weight[p] > 0 ? plane_of(surface, p) : HATCH_NO_SIDE;
        if (plane != HATCH_NO_SIDE)
            given[plane] = true;
    }
    for (size_t i = 0; i < 3 * (size_t)surface->face_count; i++)
        if (surface->face_plane[i / 3] != HATCH_NO_SIDE && given[surface->face_plane[i / 3]])
            confidence[surface->corners[i]] = 0;
}

/* Computes the unit tangent component of a direction given by hand, at a point. Returns its length before, as a share
 * of the direction's. */
static double find_tangent(const struct dirfield_job *job, const struct dirfield_constraint *given, uint32_t point,
                           double tangent[3])
{
    const double *normal = &job->frames.normal[3 * (size_t)point];
    double unit[3];
    if (given->pose)
        return dirfield_to_tangent(given->pose, given->direction, normal, tangent);
    hatch_vec_copy(given->direction, unit);
    hatch_vec_normalize(unit);
    hatch_vec_add_scaled(unit, -hatch_vec_dot(unit, normal), normal, tangent);
    return hatch_vec_normalize(tangent);
}

/* Replaces directions by those given by hand. Where the surface is cut, one counts on the sides that it runs along.
 *   weight  out: per point, as constraint_weight of hatch_field_problem; NULL without constraints */
static void constrain(const char *file, struct dirfield_job *job, double *direction, double *confidence,
                      double **weight)
{
    struct hatch_err err;
    *weight = NULL;
    if (job->constraint_count == 0)
        return;
    cmd_check(HATCH_ALLOC(&job->work, weight, job->surface->point_count, &err), NULL, &err);
    for (uint32_t i = 0; i < job->constraint_count; i++) {
        const struct dirfield_constraint *given = &job->constraints[i];
        double tangent[3], most = 0;
        for (uint32_t k = 0; k < given->point_count; k++)
            most = fmax(most, find_tangent(job, given, given->points[k], tangent));
        if (!(most > TANGENT_MIN)) {
            hatch_fail(&err, HATCH_BAD_INPUT, "line %u: the direction is perpendicular to the surface", given->line);
            cmd_die(file, &err);
        }
        for (uint32_t k = 0; k < given->point_count; k++) {
            uint32_t point = given->points[k];
            if (find_tangent(job, given, point, tangent) < TANGENT_SHARE * most)
                continue;
            hatch_vec_copy(tangent, &direction[3 * (size_t)point]);
            (*weight)[point] = given->weight;
        }
    }
    free_planes(job, *weight, confidence);
}

void dirfield_solve(struct cmd_args *args, const struct dirfield_options *options, struct dirfield_job *job)
{
    struct hatch_err err;
    struct hatch_curvature curvature;
    double begun_ms = cmd_elapsed_ms(), *constraint_weight;
    bool *filled = HATCH_NEW(&job->work, bool, job->surface->component_count, &err);
    check(job, filled ? HATCH_OK : HATCH_LIMIT, &err);
    check(job, check_orientable(job->surface, options->turn_deg, &err), &err);
    check(job, hatch_frames_begin(job->surface, &job->work, &args->scratch, &job->frames, &err), &err);
    end_phase(job, PHASE_FRAMES, begun_ms);

    begun_ms = cmd_elapsed_ms();
    check(job, estimate(args, options, job, &curvature, &err), &err);
    check(job, cmd_finish_curvature(args, job->surface, &job->frames, &curvature, &err), &err);
    constrain(cmd_input_name(options->constraints), job, curvature.direction, curvature.confidence, &constraint_weight);
    hatch_field_fill_from_dihedrals(job->surface, &job->frames, CMD_FIELD_HARD_RAD, constraint_weight,
                                    curvature.direction, curvature.confidence);
    hatch_field_fill_unconstrained(job->surface, &job->frames, constraint_weight, curvature.direction,
                                   curvature.confidence, filled);
    rotate_directions(&job->frames, job->surface, options->turn_deg, constraint_weight, curvature.direction);
    end_phase(job, PHASE_CURVATURE, begun_ms);

    begun_ms = cmd_elapsed_ms();
    const struct hatch_field_problem problem = {.surface = job->surface,
                                                .frames = &job->frames,
                                                .direction = curvature.direction,
                                                .confidence = curvature.confidence,
                                                .constraint_weight = constraint_weight,
                                                .principal = true};
    check(job, hatch_field_solve(&problem, &options->field, &job->work, &args->scratch, &job->field, &err), &err);
    hatch_field_clear_filled_confidence(job->surface, filled, &job->field);
    hatch_field_clear_plane_confidence(job->surface, curvature.confidence, &job->field);
    end_phase(job, PHASE_FIELD, begun_ms);
    check(job,
          hatch_field_singularities(job->surface, &job->frames, job->field.direction, &job->work, &args->scratch,
                                    &job->singular, &err),
          &err);
}
