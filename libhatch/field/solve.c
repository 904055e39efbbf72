#include <assert.h>
#include <math.h>
#include <string.h>

#include "base/random.h"
#include "field/system.h"
#include "math/percentile.h"

/* The smoothest field of unconstrained components: the smallest eigenvector of A with areas as the mass matrix, by
 * inverse iteration (Knöppel et al. 2013, §4, algorithm 1). */
#define POWER_STEPS_MAX 30
#define POWER_CHANGE 1e-3 /* relative change of the eigenvalues at which to stop */
#define POWER_TOLERANCE 1e-3
#define POWER_SHIFT 0.1 /* divided by the component's area; keeps A regular where a parallel field exists */

/* Confidence 1 is that of data that agree, at the point where they count more than on so large a share of the area. */
static const double agreed_share = 0.9;
#define AGREED_TOLERANCE 1e-3

struct work {
    const struct hatch_field_problem *problem;
    const struct hatch_field_options *options;
    struct hatch_arena *scratch;
    struct hatch_field_smoothing *smoothing; /* per component */
    bool *include;                           /* per component */
    struct hatch_field_convergence convergence;
};

static double length_of(const double z[2])
{
    return sqrt(z[0] * z[0] + z[1] * z[1]);
}

static void make_unit(double *z, uint32_t count)
{
    for (size_t n = 0; n < count; n++) {
        double length = length_of(&z[2 * n]);
        if (length > 0) {
            z[2 * n] /= length;
            z[2 * n + 1] /= length;
        } else {
            z[2 * n] = 1;
        }
    }
}

/* Solves Az = rhs.
 *   levels  of the system; NULL for Cholesky */
static enum hatch_status solve_rhs(const struct work *w, const struct hatch_field_system *system,
                                   const struct hatch_field_levels *levels, double tolerance, double *z,
                                   struct hatch_field_convergence *convergence, struct hatch_err *err)
{
    if (!levels)
        return hatch_field_solve_cholesky(system, w->scratch->limit_bytes, w->scratch, z, err);
    return hatch_field_solve_multigrid(levels, tolerance, w->options->iterations_max, w->scratch, z, convergence, err);
}

/* Solves for z, and with the same weights for data that agree with it everywhere.
 *   agreed  out: 2 per node */
static enum hatch_status solve_linear(struct work *w, const struct hatch_field_system *system, double *z,
                                      double *agreed, struct hatch_err *err)
{
    struct hatch_field_levels *levels = NULL;
    struct hatch_field_convergence ignored = {0};
    size_t bytes = (size_t)system->count * 2 * sizeof *z;
    double *rhs;
    if (w->options->solver == HATCH_FIELD_MULTIGRID)
        HATCH_TRY(hatch_field_coarsen(system, w->scratch, &levels, err));
    HATCH_TRY(solve_rhs(w, system, levels, w->options->tolerance, z, &w->convergence, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(w->scratch, &rhs, (size_t)system->count * 2, err));
    memcpy(rhs, system->rhs, bytes);
    memcpy(agreed, z, bytes);
    make_unit(agreed, system->count);
    for (size_t i = 0; i < 2 * (size_t)system->count; i++)
        system->rhs[i] = system->data_weight[i / 2] * agreed[i];
    memcpy(agreed, z, bytes);
    HATCH_TRY(solve_rhs(w, system, levels, fmax(w->options->tolerance, AGREED_TOLERANCE), agreed, &ignored, err));
    memcpy(system->rhs, rhs, bytes);
    return HATCH_OK;
}

/* Uses all directions of the problem, also those without weight. */
static void start_from_data(const struct work *w, const struct hatch_field_system *system, double *z)
{
    for (uint32_t p = 0; p < w->problem->surface->point_count; p++) {
        uint32_t n = system->node[p];
        if (n == HATCH_NO_SIDE)
            continue;
        double *own = &z[2 * (size_t)n];
        const double *rhs = &system->rhs[2 * (size_t)n];
        hatch_field_encode(w->problem->frames, p, &w->problem->direction[(size_t)p * 3], own);
        if (own[0] * rhs[0] + own[1] * rhs[1] < 0)
            memcpy(own, rhs, 2 * sizeof *own);
        if (!w->problem->surface->components[w->problem->surface->point_component[p]].orientable) {
            own[2] = own[0];
            own[3] = -own[1];
        }
    }
    make_unit(z, system->count);
}

/* Finds the nodes of a component, which are consecutive. Returns their number. */
static uint32_t component_nodes(const struct work *w, const struct hatch_field_system *system, uint32_t index,
                                uint32_t *first)
{
    const struct hatch_component *component = &w->problem->surface->components[index];
    *first = system->node[component->first_point];
    return *first == HATCH_NO_SIDE ? 0 : component->point_count * (component->orientable ? 1 : 2);
}

/* Sets rhs = data_weight z / |z| per component, with |z| in the norm of data_weight, here the mass. Returns the sum of
 * |z|, which converges to that of 1 / eigenvalue. z itself stays: it is the best start for the next solve. */
static double set_rhs(const struct work *w, const struct hatch_field_system *system, const double *z)
{
    double sum = 0;
    for (uint32_t c = 0; c < w->problem->surface->component_count; c++) {
        uint32_t first, count = component_nodes(w, system, c, &first);
        double square = 0;
        for (size_t n = first; n < (size_t)first + count; n++)
            square += system->data_weight[n] * (z[2 * n] * z[2 * n] + z[2 * n + 1] * z[2 * n + 1]);
        double length = sqrt(square);
        sum += count > 0 ? length : 0;
        for (size_t n = first; n < (size_t)first + count; n++)
            for (size_t i = 2 * n; i < 2 * n + 2; i++)
                system->rhs[i] = system->data_weight[n] * z[i] / length;
    }
    return sum;
}

/* Sets data_weight to the mass of each node, its share of the component's area times POWER_SHIFT, which also shifts A;
 * and z to random numbers, which are orthogonal to no eigenvector. */
static void start_power(const struct work *w, const struct hatch_field_system *system, double *z)
{
    for (uint32_t c = 0; c < w->problem->surface->component_count; c++) {
        const struct hatch_component *component = &w->problem->surface->components[c];
        double area = 0;
        for (uint32_t p = component->first_point; p < component->first_point + component->point_count; p++)
            area += w->problem->frames->area[p];
        for (uint32_t p = component->first_point; p < component->first_point + component->point_count; p++) {
            uint32_t n = system->node[p];
            for (uint32_t side = 0; n != HATCH_NO_SIDE && side < (component->orientable ? 1 : 2); side++, n++) {
                system->data_weight[n] = w->problem->frames->area[p] / area * POWER_SHIFT;
                system->diagonal[n] += system->data_weight[n];
                z[2 * (size_t)n] = (double)hatch_random_unit(0, 1, p - component->first_point) - 0.5;
                z[2 * (size_t)n + 1] = (double)hatch_random_unit(0, 2, p - component->first_point) - 0.5;
                z[2 * (size_t)n + 1] *= side ? -1 : 1;
            }
        }
    }
}

static enum hatch_status solve_smoothest(struct work *w, struct hatch_field_system *system, double *z,
                                         struct hatch_err *err)
{
    struct hatch_field_levels *levels;
    start_power(w, system, z);
    set_rhs(w, system, z);
    HATCH_TRY(hatch_field_coarsen(system, w->scratch, &levels, err));
    double before = 0;
    for (int i = 0; i < POWER_STEPS_MAX; i++) {
        HATCH_TRY(hatch_field_solve_multigrid(levels, POWER_TOLERANCE, w->options->iterations_max, w->scratch, z,
                                              &w->convergence, err));
        double now = set_rhs(w, system, z);
        if (fabs(now - before) <= POWER_CHANGE * now)
            break;
        before = now;
    }
    /* Removes the shift: these components have no data. */
    for (uint32_t n = 0; n < system->count; n++) {
        system->diagonal[n] -= system->data_weight[n];
        system->data_weight[n] = 0;
    }
    memset(system->rhs, 0, (size_t)system->count * 2 * sizeof *system->rhs);
    return HATCH_OK;
}

/* Returns the confidence at a node: |z|, which scale_confidence divides, or for unit z the length of the weighted mean
 * of data and neighbours. */
static double agreement(const struct work *w, const struct hatch_field_system *system, const double *z,
                        const double *applied, uint32_t n)
{
    if (w->options->method == HATCH_FIELD_LINEAR)
        return fmin(length_of(&z[2 * (size_t)n]), 1);
    double pull[2];
    for (size_t i = 0; i < 2; i++)
        pull[i] =
            system->diagonal[n] * z[2 * (size_t)n + i] - applied[2 * (size_t)n + i] + system->rhs[2 * (size_t)n + i];
    return fmin(length_of(pull) / system->diagonal[n], 1);
}

static void write_field(const struct work *w, const struct hatch_field_system *system, const double *z,
                        const double *applied, bool constrained, struct hatch_field *field)
{
    for (uint32_t p = 0; p < w->problem->surface->point_count; p++) {
        uint32_t n = system->node[p];
        if (n == HATCH_NO_SIDE)
            continue;
        field->confidence[p] = constrained ? agreement(w, system, z, applied, n) : 0;
        hatch_frames_direction(w->problem->frames, p, atan2(z[2 * (size_t)n + 1], z[2 * (size_t)n]) / 2,
                               &field->direction[(size_t)p * 3]);
    }
}

/* Divides |z| by that of data that agree, where these count most: smoothing over a whole surface leaves little of
 * either, because no direction goes on over all of it.
 *   agreed  from solve_linear */
static enum hatch_status scale_confidence(const struct work *w, const struct hatch_field_system *system,
                                          const double *agreed, struct hatch_field *field, struct hatch_err *err)
{
    struct hatch_weighted *lengths;
    HATCH_TRY(HATCH_ALLOC_UNSET(w->scratch, &lengths, w->problem->surface->point_count, err));
    for (uint32_t c = 0; c < w->problem->surface->component_count; c++) {
        const struct hatch_component *component = &w->problem->surface->components[c];
        uint32_t first = component->first_point, end = first + component->point_count;
        double largest;
        if (system->node[first] == HATCH_NO_SIDE)
            continue;
        for (uint32_t p = first; p < end; p++)
            lengths[p] =
                (struct hatch_weighted){length_of(&agreed[2 * (size_t)system->node[p]]), w->problem->frames->area[p]};
        hatch_percentiles(&lengths[first], component->point_count, &agreed_share, 1, &largest);
        for (uint32_t p = first; p < end && largest > 0; p++)
            field->confidence[p] = fmin(field->confidence[p] / largest, 1);
    }
    return HATCH_OK;
}

/* Solves for the components with data, or for those without. */
static enum hatch_status solve_components(struct work *w, bool constrained, struct hatch_field *field,
                                          struct hatch_err *err)
{
    struct hatch_field_system system;
    double energy[2];
    for (uint32_t c = 0; c < w->problem->surface->component_count; c++)
        w->include[c] = w->smoothing[c].constrained == constrained;
    HATCH_TRY(hatch_field_assemble(w->problem, w->smoothing, w->include, w->scratch, &system, err));
    double *z, *applied;
    HATCH_TRY(HATCH_ALLOC(w->scratch, &z, (size_t)system.count * 2, err));
    HATCH_TRY(HATCH_ALLOC(w->scratch, &applied, (size_t)system.count * 2, err));
    if (constrained && w->problem->principal)
        HATCH_TRY(hatch_field_weaken_jumps(w->problem, w->options->iterations_max, w->scratch, &system, z,
                                           &w->convergence, err));
    if (!constrained)
        HATCH_TRY(solve_smoothest(w, &system, z, err));
    else if (w->options->method == HATCH_FIELD_LINEAR)
        HATCH_TRY(solve_linear(w, &system, z, applied, err));
    if (w->options->method == HATCH_FIELD_HZ) {
        if (constrained)
            start_from_data(w, &system, z);
        make_unit(z, system.count);
        HATCH_TRY(hatch_field_descend(&system, w->options->tolerance, w->options->iterations_max, w->scratch, z,
                                      &w->convergence, err));
        hatch_field_apply(&system, z, applied);
    }
    write_field(w, &system, z, applied, constrained, field);
    if (constrained && w->options->method == HATCH_FIELD_LINEAR)
        HATCH_TRY(scale_confidence(w, &system, applied, field, err));
    hatch_field_system_energy(w->problem->surface, &system, z, energy);
    field->solution_energy += constrained ? energy[0] + energy[1] : 0;
    make_unit(z, system.count);
    hatch_field_system_energy(w->problem->surface, &system, z, energy);
    field->solution_energy += constrained ? 0 : energy[0];
    for (int i = 0; i < 2; i++)
        field->energy[i] += energy[i];
    return HATCH_OK;
}

static enum hatch_status solve(struct work *w, struct hatch_field *field, struct hatch_err *err)
{
    uint32_t components = w->problem->surface->component_count;
    HATCH_TRY(HATCH_ALLOC(w->scratch, &w->smoothing, components, err));
    HATCH_TRY(HATCH_ALLOC(w->scratch, &w->include, components, err));
    for (uint32_t c = 0; c < components; c++) {
        w->smoothing[c] = hatch_field_smoothing_of(w->problem, w->options->smooth, c);
        field->unconstrained += !w->smoothing[c].constrained;
    }
    for (int constrained = 0; constrained < 2; constrained++) {
        struct hatch_arena_mark mark = hatch_arena_mark(w->scratch);
        enum hatch_status status = HATCH_OK;
        if (constrained ? field->unconstrained < components : field->unconstrained > 0)
            status = solve_components(w, constrained, field, err);
        hatch_arena_rewind(w->scratch, mark);
        HATCH_TRY(status);
    }
    field->iterations = w->convergence.iterations;
    field->residual = w->convergence.residual;
    return HATCH_OK;
}

enum hatch_status hatch_field_solve(const struct hatch_field_problem *problem,
                                    const struct hatch_field_options *options, struct hatch_arena *arena,
                                    struct hatch_arena *scratch, struct hatch_field *field, struct hatch_err *err)
{
    assert(options->smooth >= 0 && options->smooth <= 1);
    assert(options->tolerance >= 1e-12 && options->tolerance <= 1e-1);
    struct hatch_field made = {0};
    uint32_t points = problem->surface->point_count;
    HATCH_TRY(HATCH_ALLOC(arena, &made.direction, (size_t)points * 3, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.confidence, points, err));
    struct work work = {.problem = problem, .options = options, .scratch = scratch};
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = solve(&work, &made, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *field = made;
    return status;
}
