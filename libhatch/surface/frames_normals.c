#include <math.h>
#include <string.h>

#include "math/vector.h"
#include "surface/frames.h"

#define FULL_TURN (2 * 3.14159265358979323846)

/* Projects the edge of ring entry i into the bisecting plane of the tangent planes at its ends. Its angles in the two
 * planes then differ by exactly the smallest rotation that takes one plane to the other. */
static void project_edge(const struct hatch_surface *surface, const double *normal, uint32_t p, uint32_t i,
                         double edge[3])
{
    uint32_t q = surface->ring_point[i];
    double bisector[3];
    hatch_vec_sub(&surface->points[(size_t)q * 3], &surface->points[(size_t)p * 3], edge);
    hatch_vec_add_scaled(&normal[(size_t)p * 3], surface->ring_turned[i] ? -1 : 1, &normal[(size_t)q * 3], bisector);
    hatch_vec_normalize(bisector);
    hatch_vec_add_scaled(edge, -hatch_vec_dot(edge, bisector), bisector, edge);
}

/* Returns the angle of entry i's edge in p's plane, measured from an axis. */
static double edge_angle(const struct hatch_surface *surface, const double *normal, uint32_t p, uint32_t i,
                         const double axis[3])
{
    double edge[3], side[3];
    project_edge(surface, normal, p, i, edge);
    hatch_vec_cross(&normal[(size_t)p * 3], axis, side);
    return atan2(hatch_vec_dot(edge, side), hatch_vec_dot(edge, axis));
}

/* Measures a ring in the plane of its new normal. Returns false if faces overlap there, that is, unless the edges go
 * once around the point, each ahead of the one before.
 *   axis       out: direction of the first edge
 *   angle_rad  out: per ring entry */
static bool measure_ring(const struct hatch_surface *surface, const double *normal, uint32_t p, double axis[3],
                         double *angle_rad)
{
    uint32_t first = surface->ring_first[p], end = surface->ring_first[p + 1];
    const double *n = &normal[(size_t)p * 3];
    bool open = surface->ring_face[end - 1] == HATCH_NO_SIDE;
    double sum = 0, before = 0;
    project_edge(surface, normal, p, first, axis);
    hatch_vec_add_scaled(axis, -hatch_vec_dot(axis, n), n, axis);
    if (!(hatch_vec_normalize(axis) > 0))
        return false;
    for (uint32_t i = first; i < end; i++) {
        double angle = i == first ? 0 : edge_angle(surface, normal, p, i, axis);
        double step = hatch_frames_wrap_angle(angle - before);
        sum += step;
        before = angle;
        angle_rad[i - first] = sum;
        if (step < 0 || sum >= FULL_TURN)
            return false;
    }
    double last = hatch_frames_wrap_angle(-before);
    return open || (last >= 0 && sum + last > FULL_TURN / 2);
}

/* Marks a point as folded. It keeps its scaled angles; at a border point they are rescaled so that they span the angle
 * between its first and its last edge in the new plane. */
static void keep_scaled_angles(const struct hatch_surface *surface, const double *normal, uint32_t p,
                               struct hatch_frames *frames)
{
    uint32_t first = surface->ring_first[p], end = surface->ring_first[p + 1];
    frames->folded[p] = true;
    hatch_vec_copy(&normal[(size_t)p * 3], &frames->normal[(size_t)p * 3]);
    if (surface->ring_face[end - 1] == HATCH_NO_SIDE) {
        double axis[3];
        hatch_vec_any_orthogonal(&normal[(size_t)p * 3], axis);
        double span = edge_angle(surface, normal, p, end - 1, axis) - edge_angle(surface, normal, p, first, axis);
        double scale = (span > 0 ? span : span + FULL_TURN) / frames->angle_rad[end - 1];
        for (uint32_t i = first; i < end; i++)
            frames->angle_rad[i] *= scale;
    }
    hatch_frames_fit_axis(surface, p, frames);
}

/* Each ring's new angles are kept in transport_rad until they prove valid. */
enum hatch_status hatch_frames_set_normals(const struct hatch_surface *surface, const double *normal,
                                           struct hatch_arena *scratch, struct hatch_frames *frames,
                                           struct hatch_err *err)
{
    for (uint32_t p = 0; p < surface->point_count; p++) {
        uint32_t first = surface->ring_first[p], count = surface->ring_first[p + 1] - first;
        double axis[3];
        if (!measure_ring(surface, normal, p, axis, &frames->transport_rad[first])) {
            keep_scaled_angles(surface, normal, p, frames);
            continue;
        }
        memcpy(&frames->angle_rad[first], &frames->transport_rad[first], count * sizeof *frames->angle_rad);
        hatch_vec_copy(&normal[(size_t)p * 3], &frames->normal[(size_t)p * 3]);
        hatch_vec_copy(axis, &frames->axis[(size_t)p * 3]);
    }
    hatch_frames_find_transport(surface, frames);
    return hatch_frames_transport_folded(surface, scratch, frames, err);
}
