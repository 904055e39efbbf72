#include <math.h>

#include "curvature/curvature.h"
#include "field/system.h"

#define CERTAIN_RAD 0.1     /* largest standard error of axes that can show a jump */
#define JUMP_WEIGHT 0.1     /* of a link across a jump, as a share of its weight */
#define ROUGH_TOLERANCE 0.1 /* enough to choose between two axes */

/* Returns a number with the sign of the cosine of twice the angle between the data at the ends of link i of node n:
 * negative over 45°. */
static double agreement(const struct hatch_field_system *system, uint32_t n, uint32_t i)
{
    const double *here = &system->rhs[2 * (size_t)n], *there = &system->rhs[2 * (size_t)system->to[i]];
    const double *link = &system->link[2 * (size_t)i];
    return here[0] * (link[0] * there[0] - link[1] * there[1]) + here[1] * (link[0] * there[1] + link[1] * there[0]);
}

static bool is_jump(const struct hatch_field_system *system, const bool *certain, uint32_t n, uint32_t i)
{
    return certain[n] && certain[system->to[i]] && agreement(system, n, i) < 0;
}

static bool any_jump(const struct hatch_field_system *system, const bool *certain)
{
    for (uint32_t n = 0; n < system->count; n++)
        for (uint32_t i = system->first[n]; certain[n] && i < system->first[n + 1]; i++)
            if (is_jump(system, certain, n, i))
                return true;
    return false;
}

static uint32_t nodes_of(const struct hatch_surface *surface, uint32_t point)
{
    return surface->components[surface->point_component[point]].orientable ? 1 : 2;
}

/* Whether the data at a point is a principal direction, not one given by hand. */
static bool is_axis(const struct hatch_field_problem *problem, uint32_t point)
{
    return !(problem->constraint_weight && problem->constraint_weight[point] > 0);
}

static void find_certain(const struct hatch_field_problem *problem, const struct hatch_field_system *system,
                         bool *certain)
{
    double error = CERTAIN_RAD / HATCH_CURVATURE_HALF_CONFIDENCE_RAD, confidence_min = 1 / (1 + error * error);
    for (uint32_t p = 0; p < problem->surface->point_count; p++)
        for (uint32_t k = 0; system->node[p] != HATCH_NO_SIDE && k < nodes_of(problem->surface, p); k++)
            certain[system->node[p] + k] = is_axis(problem, p) && problem->confidence[p] >= confidence_min;
}

/* Replaces data by the other axis where the field z is nearer to that. */
static void choose_axes(const struct hatch_field_problem *problem, const double *z, struct hatch_field_system *system)
{
    for (uint32_t p = 0; p < problem->surface->point_count; p++)
        for (uint32_t k = 0; system->node[p] != HATCH_NO_SIDE && k < nodes_of(problem->surface, p); k++) {
            size_t at = 2 * ((size_t)system->node[p] + k);
            double *rhs = &system->rhs[at];
            double sign = is_axis(problem, p) && z[at] * rhs[0] + z[at + 1] * rhs[1] < 0 ? -1 : 1;
            rhs[0] *= sign;
            rhs[1] *= sign;
        }
}

static void weaken(struct hatch_field_system *system, const bool *certain)
{
    for (uint32_t n = 0; n < system->count; n++)
        for (uint32_t i = system->first[n]; certain[n] && i < system->first[n + 1]; i++) {
            double *link = &system->link[2 * (size_t)i];
            if (!is_jump(system, certain, n, i))
                continue;
            system->diagonal[n] -= (1 - JUMP_WEIGHT) * sqrt(link[0] * link[0] + link[1] * link[1]);
            link[0] *= JUMP_WEIGHT;
            link[1] *= JUMP_WEIGHT;
        }
}

enum hatch_status hatch_field_weaken_jumps(const struct hatch_field_problem *problem, uint32_t iterations_max,
                                           struct hatch_arena *scratch, struct hatch_field_system *system, double *z,
                                           struct hatch_field_convergence *convergence, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_field_levels *levels;
    bool *certain = HATCH_NEW(scratch, bool, system->count, err);
    enum hatch_status status = certain ? HATCH_OK : HATCH_LIMIT;
    if (status == HATCH_OK)
        find_certain(problem, system, certain);
    if (status == HATCH_OK && any_jump(system, certain)) {
        status = hatch_field_coarsen(system, scratch, &levels, err);
        if (status == HATCH_OK)
            status = hatch_field_solve_multigrid(levels, ROUGH_TOLERANCE, iterations_max, scratch, z, convergence, err);
        if (status == HATCH_OK) {
            choose_axes(problem, z, system);
            weaken(system, certain);
        }
    }
    hatch_arena_rewind(scratch, mark);
    return status;
}
