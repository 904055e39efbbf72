#include <math.h>
#include <string.h>

#include "math/vector.h"
#include "surface/frames.h"

#define TURN (2 * 3.14159265358979323846)

/* The edge of ring entry i, laid into the plane that halves the angle between the tangent planes at its ends: from
 * there it falls onto both alike, so that the angles that it takes in them differ by the least turn that makes one
 * plane the other. */
static void lay_edge(const struct hatch_surface *surface, const double *normal, uint32_t p, uint32_t i, double edge[3])
{
    uint32_t q = surface->ring_point[i];
    double middle[3];
    hatch_vec_sub(&surface->points[(size_t)q * 3], &surface->points[(size_t)p * 3], edge);
    hatch_vec_add_scaled(&normal[(size_t)p * 3], surface->ring_turned[i] ? -1 : 1, &normal[(size_t)q * 3], middle);
    hatch_vec_normalize(middle);
    hatch_vec_add_scaled(edge, -hatch_vec_dot(edge, middle), middle, edge);
}

/* The angle of entry i's edge in a plane, against an axis in it. */
static double edge_angle(const struct hatch_surface *surface, const double *normal, uint32_t p, uint32_t i,
                         const double axis[3])
{
    double edge[3], side[3];
    lay_edge(surface, normal, p, i, edge);
    hatch_vec_cross(&normal[(size_t)p * 3], axis, side);
    return atan2(hatch_vec_dot(edge, side), hatch_vec_dot(edge, axis));
}

/* Goes around a ring in the plane of its new normal. false when that is not one time around, or goes back on the way:
 * faces are folded over one another there. angle_rad: of the ring's entries. */
static bool lean_ring(const struct hatch_surface *surface, const double *normal, uint32_t p, double axis[3],
                      double *angle_rad)
{
    uint32_t first = surface->ring_first[p], end = surface->ring_first[p + 1];
    const double *n = &normal[(size_t)p * 3];
    bool open = surface->ring_face[end - 1] == HATCH_NO_SIDE;
    double sum = 0, before = 0;
    lay_edge(surface, normal, p, first, axis);
    hatch_vec_add_scaled(axis, -hatch_vec_dot(axis, n), n, axis);
    if (!(hatch_vec_normalize(axis) > 0))
        return false;
    for (uint32_t i = first; i < end; i++) {
        double angle = i == first ? 0 : edge_angle(surface, normal, p, i, axis);
        double step = hatch_frames_shortest(angle - before);
        sum += step;
        before = angle;
        angle_rad[i - first] = sum;
        if (step < 0 || sum >= TURN)
            return false;
    }
    double last = hatch_frames_shortest(-before);
    return open || (last >= 0 && sum + last > TURN / 2);
}

/* Keeps the scaled angles; on a border, so that they end where its last edge lies. */
static void fold(const struct hatch_surface *surface, const double *normal, uint32_t p, struct hatch_frames *frames)
{
    uint32_t first = surface->ring_first[p], end = surface->ring_first[p + 1];
    frames->folded[p] = true;
    hatch_vec_copy(&normal[(size_t)p * 3], &frames->normal[(size_t)p * 3]);
    if (surface->ring_face[end - 1] == HATCH_NO_SIDE) {
        double axis[3];
        hatch_vec_any_orthogonal(&normal[(size_t)p * 3], axis);
        double wide = edge_angle(surface, normal, p, end - 1, axis) - edge_angle(surface, normal, p, first, axis);
        double scale = (wide > 0 ? wide : wide + TURN) / frames->angle_rad[end - 1];
        for (uint32_t i = first; i < end; i++)
            frames->angle_rad[i] *= scale;
    }
    hatch_frames_fit_axis(surface, p, frames);
}

/* Turns are found last: until then their place holds angles that may come to nothing. */
enum hatch_status hatch_frames_lean(const struct hatch_surface *surface, const double *normal,
                                    struct hatch_arena *scratch, struct hatch_frames *frames, struct hatch_err *err)
{
    for (uint32_t p = 0; p < surface->point_count; p++) {
        uint32_t first = surface->ring_first[p], count = surface->ring_first[p + 1] - first;
        double axis[3];
        if (!lean_ring(surface, normal, p, axis, &frames->turn_rad[first])) {
            fold(surface, normal, p, frames);
            continue;
        }
        memcpy(&frames->angle_rad[first], &frames->turn_rad[first], count * sizeof *frames->angle_rad);
        hatch_vec_copy(&normal[(size_t)p * 3], &frames->normal[(size_t)p * 3]);
        hatch_vec_copy(axis, &frames->axis[(size_t)p * 3]);
    }
    hatch_frames_find_turns(surface, frames);
    return hatch_frames_turn_folds(surface, scratch, frames, err);
}
