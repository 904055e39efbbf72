#include <assert.h>
#include <math.h>
#include <string.h>

#include "math/vector.h"
#include "field/system.h"

void hatch_field_square(const struct hatch_frames *frames, uint32_t point, const double direction[3], double z[2])
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

/* Data so strong that nothing moves it, in sums of edge weights; and the confidence under whose root mean square a
 * component has none: what noise leaves on a sphere or a plane. */
#define MASS_MAX 1e6
#define CONFIDENCE_MIN 0.001
#define LENGTH_SHARE 0.0115 /* of the root of the component's area, at smooth 0.5 */

static double edge_sum(const struct hatch_surface *surface, const struct hatch_frames *frames, uint32_t point)
{
    double sum = 0;
    for (uint32_t i = surface->ring_first[point]; i < surface->ring_first[point + 1]; i++)
        sum += frames->weight[i];
    return sum;
}

struct hatch_field_scale hatch_field_scale_of(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                              const struct hatch_field_data *data, double smooth, uint32_t component)
{
    const struct hatch_component *of = &surface->components[component];
    double area = 0, known = 0;
    bool hard = false;
    for (uint32_t p = of->first_point; p < of->first_point + of->point_count; p++) {
        area += frames->area[p];
        known += frames->area[p] * data->confidence[p] * data->confidence[p];
        hard = hard || (data->hard && data->hard[p] > 0);
    }
    double knob = smooth / fmax(1 - smooth, 1e-3);
    return (struct hatch_field_scale){.directed = hard || known >= CONFIDENCE_MIN * CONFIDENCE_MIN * area,
                                      .length = LENGTH_SHARE * sqrt(area) * knob * knob};
}

double hatch_field_mass(const struct hatch_surface *surface, const struct hatch_frames *frames,
                        const struct hatch_field_data *data, const struct hatch_field_scale *scale, uint32_t point)
{
    double edges = edge_sum(surface, frames, point), confidence = data->confidence[point], z[2];
    if (!scale->directed)
        return 0;
    hatch_field_square(frames, point, &data->direction[(size_t)point * 3], z);
    if (z[0] == 0 && z[1] == 0)
        return 0;
    if (data->hard && data->hard[point] > 0)
        return data->hard[point] * edges;
    if (!(confidence > 0))
        return 0;
    double most = MASS_MAX * confidence * edges, odds = confidence / (1 - confidence);
    return fmin(frames->area[point] * odds / (scale->length * scale->length), most);
}

void hatch_field_system_energy(const struct hatch_surface *surface, const struct hatch_field_system *system,
                               const double *z, double energy[2])
{
    energy[0] = energy[1] = 0;
    for (uint32_t k = 0; k < surface->point_count; k++) {
        uint32_t n = system->node[system->order[k]];
        if (n == HATCH_NO_SIDE)
            continue;
        const double *own = &z[2 * (size_t)n], *right = &system->right[2 * (size_t)n];
        double square = own[0] * own[0] + own[1] * own[1], mass = system->mass[n];
        for (uint32_t i = system->first[n]; i < system->first[n + 1]; i++) {
            const double *link = &system->link[2 * (size_t)i], *far = &z[2 * (size_t)system->to[i]];
            double weight = sqrt(link[0] * link[0] + link[1] * link[1]);
            double x = link[0] * far[0] - link[1] * far[1], y = link[0] * far[1] + link[1] * far[0];
            double there = far[0] * far[0] + far[1] * far[1];
            energy[0] += 0.5 * (weight * (square + there) - 2 * (own[0] * x + own[1] * y));
        }
        if (mass > 0)
            energy[1] += mass * (square + 1) - 2 * (own[0] * right[0] + own[1] * right[1]);
    }
}

void hatch_field_apply(const struct hatch_field_system *system, const double *z, double *out)
{
    for (uint32_t n = 0; n < system->count; n++) {
        double x = 0, y = 0;
        for (uint32_t i = system->first[n]; i < system->first[n + 1]; i++) {
            const double *link = &system->link[2 * (size_t)i], *far = &z[2 * (size_t)system->to[i]];
            x += link[0] * far[0] - link[1] * far[1];
            y += link[0] * far[1] + link[1] * far[0];
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

/* Numbers the nodes; a component with one side has two a point, one after the other. */
static enum hatch_status number_nodes(const struct hatch_surface *surface, const bool *include,
                                      struct hatch_arena *arena, struct hatch_field_system *system, uint32_t *links,
                                      struct hatch_err *err)
{
    system->order = HATCH_NEW_UNSET(arena, uint32_t, surface->point_count, err);
    system->node = system->order ? HATCH_NEW_UNSET(arena, uint32_t, surface->point_count, err) : NULL;
    if (!system->node)
        return HATCH_LIMIT;
    HATCH_TRY(hatch_surface_order(surface, arena, system->order, system->node, err));
    uint64_t count = 0, entries = 0;
    for (uint32_t i = 0; i < surface->point_count; i++) {
        uint32_t p = system->order[i];
        uint32_t of = surface->point_component[p], sides = surface->components[of].orientable ? 1 : 2;
        system->node[p] = include[of] ? (uint32_t)count : HATCH_NO_SIDE;
        if (include[of]) {
            count += sides;
            entries += (uint64_t)sides * (surface->ring_first[p + 1] - surface->ring_first[p]);
        }
    }
    if (entries >= UINT32_MAX)
        return hatch_fail(err, HATCH_LIMIT, "a surface with %llu edges is too large for a direction field",
                          (unsigned long long)entries / 2);
    system->count = (uint32_t)count;
    *links = (uint32_t)entries;
    return HATCH_OK;
}

/* The link of entry i of a node's point, of which the row at the other end may be there already: what leads back is
 * its conjugate, unless both ends see the edge from different sides. */
static void make_link(const struct hatch_surface *surface, const struct hatch_frames *frames, uint32_t i, uint32_t n,
                      uint32_t side, const struct hatch_field_system *system, uint32_t to, double link[2])
{
    if (to < n) {
        uint32_t mate = frames->mate[i] - surface->ring_first[surface->ring_point[i]];
        const double *back = &system->link[2 * ((size_t)system->first[to] + mate)];
        link[0] = back[0];
        link[1] = -back[1];
        return;
    }
    double turn = 2 * frames->turn_rad[i], weight = frames->weight[i];
    link[0] = weight * cos(turn);
    link[1] = weight * (side ? -sin(turn) : sin(turn));
}

/* The row of a point seen from its ring's outside (side 0) or its other side. */
static uint32_t fill_row(const struct hatch_surface *surface, const struct hatch_frames *frames, uint32_t point,
                         uint32_t side, uint32_t at, struct hatch_field_system *system)
{
    uint32_t n = system->node[point] + side;
    double sum = 0;
    system->first[n] = at;
    for (uint32_t i = surface->ring_first[point]; i < surface->ring_first[point + 1]; i++, at++) {
        system->to[at] = system->node[surface->ring_point[i]] + (side ^ surface->ring_turned[i]);
        make_link(surface, frames, i, n, side, system, system->to[at], &system->link[2 * (size_t)at]);
        sum += frames->weight[i];
    }
    system->diagonal[n] = sum + system->mass[n];
    system->first[n + 1] = at;
    return at;
}

enum hatch_status hatch_field_assemble(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                       const struct hatch_field_data *data, const struct hatch_field_scale *scales,
                                       const bool *include, struct hatch_arena *arena,
                                       struct hatch_field_system *system, struct hatch_err *err)
{
    uint32_t links = 0, at = 0;
    HATCH_TRY(number_nodes(surface, include, arena, system, &links, err));
    size_t count = system->count;
    system->first = HATCH_NEW_UNSET(arena, uint32_t, count + 1, err);
    system->to = system->first ? HATCH_NEW_UNSET(arena, uint32_t, links, err) : NULL;
    system->link = system->to ? HATCH_NEW_UNSET(arena, double, (size_t)links * 2, err) : NULL;
    system->diagonal = system->link ? HATCH_NEW_UNSET(arena, double, count, err) : NULL;
    system->mass = system->diagonal ? HATCH_NEW_UNSET(arena, double, count, err) : NULL;
    system->right = system->mass ? HATCH_NEW_UNSET(arena, double, count * 2, err) : NULL;
    if (!system->right)
        return HATCH_LIMIT;
    for (uint32_t k = 0; k < surface->point_count; k++) {
        uint32_t p = system->order[k], n = system->node[p], of = surface->point_component[p];
        double d[2];
        if (n == HATCH_NO_SIDE)
            continue;
        hatch_field_square(frames, p, &data->direction[(size_t)p * 3], d);
        double m = hatch_field_mass(surface, frames, data, &scales[of], p);
        for (uint32_t side = 0; side < (surface->components[of].orientable ? 1 : 2); side++) {
            system->mass[n + side] = m;
            system->right[2 * (size_t)(n + side)] = m * d[0];
            system->right[2 * (size_t)(n + side) + 1] = side ? -m * d[1] : m * d[1];
            at = fill_row(surface, frames, p, side, at, system);
        }
    }
    return HATCH_OK;
}
