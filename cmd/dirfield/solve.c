#include <math.h>

#include "dirfield.h"
#include "io/openmesh/openmesh.h"
#include "math/vector.h"

#define STANDING 1e-3 /* a direction whose tangent part is shorter than this share stands on the surface */

static void end_phase(struct dirfield_part *part, enum dirfield_phase phase, double begun_ms)
{
    part->ms[phase] = cmd_elapsed_ms() - begun_ms;
    cmd_progress("directions", (double)(phase + 1) / PHASE_COUNT);
}

static void check(const struct dirfield_part *part, enum hatch_status status, struct hatch_err *err)
{
    if (status != HATCH_OK && part->number > 0)
        hatch_fail_at(err, "mesh %u: ", part->number);
    cmd_check(status, part->name, err);
}

/* What was found, not what was given by hand. Right angles are exact, and need no side to be seen from. */
static void turn(const struct hatch_frames *frames, const struct hatch_surface *surface, double degrees,
                 const double *hard, double *direction)
{
    double right_angles = degrees / 90, radians = degrees * (3.14159265358979323846 / 180);
    bool exact = right_angles == floor(right_angles), across = exact && fmod(right_angles, 2) != 0;
    double along = exact ? !across : cos(radians), aside = exact ? across : sin(radians);
    for (size_t p = 0; p < surface->point_count; p++) {
        double *d = &direction[3 * p], left[3];
        if (hard && hard[p] > 0)
            continue;
        hatch_vec_cross(&frames->normal[3 * p], d, left);
        for (int k = 0; k < 3; k++)
            d[k] = along * d[k] + aside * left[k];
    }
}

static enum hatch_status check_sides(const struct hatch_surface *surface, double degrees, struct hatch_err *err)
{
    for (uint32_t c = 0; c < surface->component_count && fmod(degrees, 90) != 0; c++)
        if (!surface->components[c].orientable)
            return hatch_fail(err, HATCH_BAD_INPUT,
                              "component %u has but one side, from which no turn by %g degrees can be seen: "
                              "--direction max and min are possible",
                              c, degrees);
    return HATCH_OK;
}

static enum hatch_status estimate(struct cmd_args *args, const struct dirfield_options *options,
                                  struct dirfield_part *part, struct hatch_curvature *curvature, struct hatch_err *err)
{
    struct hatch_curvature_options fits = options->curvature;
    fits.pool = cmd_pool(args);
    if (!(options->coarse_faces > 0))
        return hatch_curvature_estimate(part->surface, &part->frames, &fits, &part->work, &args->scratch, curvature,
                                        err);
    struct hatch_mesh coarse;
    uint32_t faces = (uint32_t)fmax(1, round(options->coarse_faces * part->share));
    HATCH_TRY(hatch_mesh_decimate(&part->mesh->mesh, faces, &part->work, &args->scratch, &coarse, NULL, err));
    return hatch_curvature_coarse(part->surface, &part->frames, &coarse, &part->work, &args->scratch, curvature, err);
}

/* What was given by hand replaces what was found. */
static void constrain(const char *file, struct dirfield_part *part, double *direction, double **hard)
{
    struct hatch_err err;
    *hard = NULL;
    if (part->constraint_count == 0)
        return;
    *hard = HATCH_NEW(&part->work, double, part->surface->point_count, &err);
    cmd_check(*hard ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    for (uint32_t i = 0; i < part->constraint_count; i++) {
        const struct dirfield_constraint *given = &part->constraints[i];
        const double *normal = &part->frames.normal[3 * (size_t)given->point];
        double *d = &direction[3 * (size_t)given->point], unit[3];
        hatch_vec_copy(given->direction, unit);
        hatch_vec_normalize(unit);
        hatch_vec_add_scaled(unit, -hatch_vec_dot(unit, normal), normal, d);
        if (!(hatch_vec_normalize(d) > STANDING)) {
            hatch_fail(&err, HATCH_BAD_INPUT, "line %u: the direction stands on the surface, as its normal does",
                       given->line);
            cmd_die(file, &err);
        }
        (*hard)[given->point] = given->weight;
    }
}

void dirfield_solve(struct cmd_args *args, const struct dirfield_options *options, struct dirfield_part *part)
{
    struct hatch_err err;
    struct hatch_curvature curvature;
    double begun_ms = cmd_elapsed_ms(), *hard;
    bool *filled = HATCH_NEW(&part->work, bool, part->surface->component_count, &err);
    check(part, filled ? HATCH_OK : HATCH_LIMIT, &err);
    check(part, check_sides(part->surface, options->turn_deg, &err), &err);
    check(part, hatch_frames_begin(part->surface, &part->work, &args->scratch, &part->frames, &err), &err);
    end_phase(part, PHASE_FRAMES, begun_ms);

    begun_ms = cmd_elapsed_ms();
    check(part, estimate(args, options, part, &curvature, &err), &err);
    hatch_curvature_clear_crease_confidence(part->surface, CMD_FIELD_HARD_RAD, &curvature);
    check(part, hatch_frames_set_normals(part->surface, curvature.normal, &args->scratch, &part->frames, &err), &err);
    constrain(cmd_input_name(options->constraints), part, curvature.direction, &hard);
    hatch_field_fill_from_dihedrals(part->surface, &part->frames, CMD_FIELD_HARD_RAD, hard, curvature.direction,
                                    curvature.confidence);
    hatch_field_fill_unconstrained(part->surface, &part->frames, hard, curvature.direction, curvature.confidence,
                                   filled);
    turn(&part->frames, part->surface, options->turn_deg, hard, curvature.direction);
    end_phase(part, PHASE_CURVATURE, begun_ms);

    begun_ms = cmd_elapsed_ms();
    const struct hatch_field_problem problem = {.surface = part->surface,
                                                .frames = &part->frames,
                                                .direction = curvature.direction,
                                                .confidence = curvature.confidence,
                                                .constraint_weight = hard,
                                                .principal = true};
    check(part, hatch_field_solve(&problem, &options->field, &part->work, &args->scratch, &part->field, &err), &err);
    hatch_field_clear_filled_confidence(part->surface, filled, &part->field);
    end_phase(part, PHASE_FIELD, begun_ms);
    check(part,
          hatch_field_singularities(part->surface, &part->frames, part->field.direction, &part->work, &args->scratch,
                                    &part->singular, &err),
          &err);
}
