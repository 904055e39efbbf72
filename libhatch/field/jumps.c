#include <math.h>

#include "curvature/curvature.h"
#include "field/system.h"

#define KNOWN_RAD 0.1        /* a point whose axes are known no better tells no jump from noise */
#define SHARE 0.1            /* of a link's weight that is left over a jump */
#define SETTLE_TOLERANCE 0.1 /* a side is asked for, not an angle */

/* Of what the data says at the ends of a link, seen from the first: under 0 where the lines are nearer to a right
 * angle than to none. */
static double agreement(const struct hatch_field_system *system, uint32_t n, uint32_t i)
{
    const double *here = &system->right[2 * (size_t)n], *there = &system->right[2 * (size_t)system->to[i]];
    const double *link = &system->link[2 * (size_t)i];
    return here[0] * (link[0] * there[0] - link[1] * there[1]) + here[1] * (link[0] * there[1] + link[1] * there[0]);
}

static bool is_jump(const struct hatch_field_system *system, const bool *known, uint32_t n, uint32_t i)
{
    return known[n] && known[system->to[i]] && agreement(system, n, i) < 0;
}

static bool any_jump(const struct hatch_field_system *system, const bool *known)
{
    for (uint32_t n = 0; n < system->count; n++)
        for (uint32_t i = system->first[n]; known[n] && i < system->first[n + 1]; i++)
            if (is_jump(system, known, n, i))
                return true;
    return false;
}

static uint32_t nodes_of(const struct hatch_surface *surface, uint32_t point)
{
    return surface->components[surface->point_component[point]].orientable ? 1 : 2;
}

/* Lines given by hand are not one of two axes. */
static bool is_axis(const struct hatch_field_data *data, uint32_t point)
{
    return !(data->hard && data->hard[point] > 0);
}

static void find_known(const struct hatch_surface *surface, const struct hatch_field_data *data,
                       const struct hatch_field_system *system, bool *known)
{
    double error = KNOWN_RAD / HATCH_CURVATURE_EVEN_RAD, least = 1 / (1 + error * error);
    for (uint32_t p = 0; p < surface->point_count; p++)
        for (uint32_t k = 0; system->node[p] != HATCH_NO_SIDE && k < nodes_of(surface, p); k++)
            known[system->node[p] + k] = is_axis(data, p) && data->confidence[p] >= least;
}

/* Where the smooth field z lies nearer to the other axis, that is the one meant. */
static void settle(const struct hatch_surface *surface, const struct hatch_field_data *data, const double *z,
                   struct hatch_field_system *system)
{
    for (uint32_t p = 0; p < surface->point_count; p++)
        for (uint32_t k = 0; system->node[p] != HATCH_NO_SIDE && k < nodes_of(surface, p); k++) {
            size_t at = 2 * ((size_t)system->node[p] + k);
            double *right = &system->right[at];
            double sign = is_axis(data, p) && z[at] * right[0] + z[at + 1] * right[1] < 0 ? -1 : 1;
            right[0] *= sign;
            right[1] *= sign;
        }
}

static void loosen(struct hatch_field_system *system, const bool *known)
{
    for (uint32_t n = 0; n < system->count; n++)
        for (uint32_t i = system->first[n]; known[n] && i < system->first[n + 1]; i++) {
            double *link = &system->link[2 * (size_t)i];
            if (!is_jump(system, known, n, i))
                continue;
            system->diagonal[n] -= (1 - SHARE) * sqrt(link[0] * link[0] + link[1] * link[1]);
            link[0] *= SHARE;
            link[1] *= SHARE;
        }
}

enum hatch_status hatch_field_loosen_jumps(const struct hatch_surface *surface, const struct hatch_field_data *data,
                                           uint32_t iterations_max, struct hatch_arena *scratch,
                                           struct hatch_field_system *system, double *z,
                                           struct hatch_field_progress *progress, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_field_levels *levels;
    bool *known = HATCH_NEW(scratch, bool, system->count, err);
    enum hatch_status status = known ? HATCH_OK : HATCH_LIMIT;
    if (status == HATCH_OK)
        find_known(surface, data, system, known);
    if (status == HATCH_OK && any_jump(system, known)) {
        status = hatch_field_coarsen(system, scratch, &levels, err);
        if (status == HATCH_OK)
            status = hatch_field_iterate(system, levels, system->right, SETTLE_TOLERANCE, iterations_max, scratch, z,
                                         progress, err);
        if (status == HATCH_OK) {
            settle(surface, data, z, system);
            loosen(system, known);
        }
    }
    hatch_arena_rewind(scratch, mark);
    return status;
}
