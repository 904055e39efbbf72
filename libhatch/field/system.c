#include <assert.h>
#include <math.h>

#include "math/vector.h"
#include "field/system.h"

void hatch_field_encode(const struct hatch_frames *frames, uint32_t point, const double direction[3], double z[2])
{
    const double *axis = &frames->axis[(size_t)point * 3];
    double side[3];
    hatch_vec_cross(&frames->normal[(size_t)point * 3], axis, side);
    double x = hatch_vec_dot(direction, axis), y = hatch_vec_dot(direction, side);
    double most = fmax(fabs(x), fabs(y));
    double along = fabs(hatch_vec_dot(direction, &frames->normal[(size_t)point * 3]));
    z[0] = z[1] = 0;
    if (!(most > HATCH_FRAMES_ROUNDING * along) || !isfinite(x) || !isfinite(y))
        return;
    x /= most;
    y /= most;
    double length = x * x + y * y;
    z[0] = (x * x - y * y) / length;
    z[1] = 2 * x * y / length;
}

#define DATA_WEIGHT_MAX 1e6  /* per unit of confidence, in sums of edge weights: in effect a hard constraint */
#define CONFIDENCE_MIN 0.001 /* root mean square over a component with data: noise on a sphere or a plane has less */
#define LENGTH_SHARE 0.0115  /* of the square root of the component's area, at smooth 0.5 */

static double edge_weight_sum(const struct hatch_surface *surface, const struct hatch_frames *frames, uint32_t point)
{
    double sum = 0;
    for (uint32_t i = surface->ring_first[point]; i < surface->ring_first[point + 1]; i++)
        sum += frames->weight[i];
    return sum;
}

struct hatch_field_smoothing hatch_field_smoothing_of(const struct hatch_field_problem *problem, double smooth,
                                                      uint32_t index)
{
    const struct hatch_component *component = &problem->surface->components[index];
    const struct hatch_frames *frames = problem->frames;
    double area = 0, squares = 0;
    bool has_constraint = false;
    for (uint32_t p = component->first_point; p < component->first_point + component->point_count; p++) {
        area += frames->area[p];
        squares += frames->area[p] * problem->confidence[p] * problem->confidence[p];
        has_constraint = has_constraint || (problem->constraint_weight && problem->constraint_weight[p] > 0);
    }
    double odds = smooth / fmax(1 - smooth, 1e-3);
    return (struct hatch_field_smoothing){.constrained =
                                              has_constraint || squares >= CONFIDENCE_MIN * CONFIDENCE_MIN * area,
                                          .length = LENGTH_SHARE * sqrt(area) * odds * odds};
}

double hatch_field_data_weight(const struct hatch_field_problem *problem, const struct hatch_field_smoothing *smoothing,
                               uint32_t point)
{
    double edges = edge_weight_sum(problem->surface, problem->frames, point), confidence = problem->confidence[point];
    double z[2];
    if (!smoothing->constrained)
        return 0;
    hatch_field_encode(problem->frames, point, &problem->direction[(size_t)point * 3], z);
    if (z[0] == 0 && z[1] == 0)
        return 0;
    if (problem->constraint_weight && problem->constraint_weight[point] > 0)
        return problem->constraint_weight[point] * edges;
    if (!(confidence > 0))
        return 0;
    double weight_max = DATA_WEIGHT_MAX * confidence * edges, odds = confidence / (1 - confidence);
    return fmin(problem->frames->area[point] * odds / (smoothing->length * smoothing->length), weight_max);
}

void hatch_field_system_energy(const struct hatch_surface *surface, const struct hatch_field_system *system,
                               const double *z, double energy[2])
{
    energy[0] = energy[1] = 0;
    for (uint32_t k = 0; k < surface->point_count; k++) {
        uint32_t n = system->node[system->order[k]];
        if (n == HATCH_NO_SIDE)
            continue;
        const double *own = &z[2 * (size_t)n], *rhs = &system->rhs[2 * (size_t)n];
        double square = own[0] * own[0] + own[1] * own[1], data_weight = system->data_weight[n];
        for (uint32_t i = system->first[n]; i < system->first[n + 1]; i++) {
            const double *link = &system->link[2 * (size_t)i], *other = &z[2 * (size_t)system->to[i]];
            double weight = sqrt(link[0] * link[0] + link[1] * link[1]);
            double x = link[0] * other[0] - link[1] * other[1], y = link[0] * other[1] + link[1] * other[0];
            double there = other[0] * other[0] + other[1] * other[1];
            energy[0] += 0.5 * (weight * (square + there) - 2 * (own[0] * x + own[1] * y));
        }
        if (data_weight > 0)
            energy[1] += data_weight * (square + 1) - 2 * (own[0] * rhs[0] + own[1] * rhs[1]);
    }
}

void hatch_field_apply(const struct hatch_field_system *system, const double *z, double *out)
{
    for (uint32_t n = 0; n < system->count; n++) {
        double x = 0, y = 0;
        for (uint32_t i = system->first[n]; i < system->first[n + 1]; i++) {
            const double *link = &system->link[2 * (size_t)i], *other = &z[2 * (size_t)system->to[i]];
            x += link[0] * other[0] - link[1] * other[1];
            y += link[0] * other[1] + link[1] * other[0];
        }
        out[2 * (size_t)n] = system->diagonal[n] * z[2 * (size_t)n] - x;
        out[2 * (size_t)n + 1] = system->diagonal[n] * z[2 * (size_t)n + 1] - y;
    }
}

double hatch_field_dot(const double *a, const double *b, uint32_t count)
{
    double sum = 0;
    for (size_t i = 0; i < 2 * (size_t)count; i++)
        sum += a[i] * b[i];
    return sum;
}

/* Numbers the nodes by component; the two of a point on a one-sided component are consecutive. */
static enum hatch_status number_nodes(const struct hatch_surface *surface, const bool *include,
                                      struct hatch_arena *arena, struct hatch_field_system *system, uint32_t *links,
                                      struct hatch_err *err)
{
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &system->order, surface->point_count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &system->node, surface->point_count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &system->component_first, (size_t)surface->component_count + 1, err));
    HATCH_TRY(hatch_surface_order_points(surface, arena, system->order, system->node, err));
    uint64_t count = 0, entries = 0;
    system->component_count = 0;
    for (uint32_t i = 0; i < surface->point_count; i++) {
        uint32_t p = system->order[i];
        uint32_t component = surface->point_component[p], sides = surface->components[component].orientable ? 1 : 2;
        system->node[p] = include[component] ? (uint32_t)count : HATCH_NO_SIDE;
        if (include[component]) {
            if (i == 0 || surface->point_component[system->order[i - 1]] != component)
                system->component_first[system->component_count++] = (uint32_t)count;
            count += sides;
            entries += (uint64_t)sides * (surface->ring_first[p + 1] - surface->ring_first[p]);
        }
    }
    if (entries >= UINT32_MAX)
        return hatch_fail(err, HATCH_LIMIT, "%llu edges are too many for a direction field: simplify the mesh",
                          (unsigned long long)entries / 2);
    system->count = (uint32_t)count;
    system->component_first[system->component_count] = (uint32_t)count;
    *links = (uint32_t)entries;
    return HATCH_OK;
}

/* Sets link `at` of node n, which belongs to ring entry i; side as in fill_row. Where the row of the other node exists,
 * the link is exactly the conjugate of the one back. */
static void make_link(const struct hatch_field_problem *problem, uint32_t i, uint32_t n, uint32_t side, uint32_t at,
                      struct hatch_field_system *system)
{
    const struct hatch_surface *surface = problem->surface;
    const struct hatch_frames *frames = problem->frames;
    double *link = &system->link[2 * (size_t)at];
    uint32_t to = system->to[at];
    if (to < n) {
        uint32_t twin = frames->twin[i] - surface->ring_first[surface->ring_point[i]];
        const double *back = &system->link[2 * ((size_t)system->first[to] + twin)];
        link[0] = back[0];
        link[1] = -back[1];
        return;
    }
    double angle = 2 * frames->transport_rad[i], weight = frames->weight[i];
    link[0] = weight * cos(angle);
    link[1] = weight * (side ? -sin(angle) : sin(angle));
}

/* Fills the row of a point seen from the outside of its ring (side 0) or from the other side (1), from link `at` on.
 * Returns the link after its last. */
static uint32_t fill_row(const struct hatch_field_problem *problem, uint32_t point, uint32_t side, uint32_t at,
                         struct hatch_field_system *system)
{
    const struct hatch_surface *surface = problem->surface;
    uint32_t n = system->node[point] + side;
    double sum = 0;
    system->first[n] = at;
    for (uint32_t i = surface->ring_first[point]; i < surface->ring_first[point + 1]; i++, at++) {
        system->to[at] = system->node[surface->ring_point[i]] + (side ^ surface->ring_turned[i]);
        make_link(problem, i, n, side, at, system);
        sum += problem->frames->weight[i];
    }
    system->diagonal[n] = sum + system->data_weight[n];
    system->first[n + 1] = at;
    return at;
}

enum hatch_status hatch_field_assemble(const struct hatch_field_problem *problem,
                                       const struct hatch_field_smoothing *smoothing, const bool *include,
                                       struct hatch_arena *arena, struct hatch_field_system *system,
                                       struct hatch_err *err)
{
    const struct hatch_surface *surface = problem->surface;
    uint32_t links = 0, at = 0;
    HATCH_TRY(number_nodes(surface, include, arena, system, &links, err));
    size_t count = system->count;
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &system->first, count + 1, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &system->to, links, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &system->link, (size_t)links * 2, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &system->diagonal, count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &system->data_weight, count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &system->rhs, count * 2, err));
    for (uint32_t k = 0; k < surface->point_count; k++) {
        uint32_t p = system->order[k], n = system->node[p], component = surface->point_component[p];
        double d[2];
        if (n == HATCH_NO_SIDE)
            continue;
        hatch_field_encode(problem->frames, p, &problem->direction[(size_t)p * 3], d);
        double weight = hatch_field_data_weight(problem, &smoothing[component], p);
        for (uint32_t side = 0; side < (surface->components[component].orientable ? 1 : 2); side++) {
            system->data_weight[n + side] = weight;
            system->rhs[2 * (size_t)(n + side)] = weight * d[0];
            system->rhs[2 * (size_t)(n + side) + 1] = side ? -weight * d[1] : weight * d[1];
            at = fill_row(problem, p, side, at, system);
        }
    }
    return HATCH_OK;
}
