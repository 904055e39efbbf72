/* Where faces lie over one another in a point's plane, its angles say nothing of how a direction turns along its edges:
 * the least turn between the planes does, as elsewhere, and around a face the solid angle between its normals. */
#include <math.h>

#include "math/vector.h"
#include "surface/frames.h"

#define PI 3.14159265358979323846

static double excess_of_corners(const struct hatch_surface *surface, const struct hatch_frames *frames, uint32_t face)
{
    double sum = -PI;
    for (size_t c = (size_t)face * 3; c < (size_t)face * 3 + 3; c++)
        sum += hatch_frames_corner(surface, frames, surface->corners[c], frames->entry[c]);
    return sum;
}

static double solid_angle(const struct hatch_surface *surface, const struct hatch_frames *frames, uint32_t face)
{
    double n[3][3], across[3];
    for (size_t c = 0; c < 3; c++) {
        size_t corner = (size_t)face * 3 + c;
        for (size_t k = 0; k < 3; k++)
            n[c][k] = frames->normal[(size_t)surface->corners[corner] * 3 + k] *
                      (surface->ring_flipped[frames->entry[corner]] ? -1 : 1);
    }
    hatch_vec_cross(n[1], n[2], across);
    return 2 * atan2(hatch_vec_dot(n[0], across),
                     1 + hatch_vec_dot(n[0], n[1]) + hatch_vec_dot(n[1], n[2]) + hatch_vec_dot(n[2], n[0]));
}

double hatch_frames_excess(const struct hatch_surface *surface, const struct hatch_frames *frames, uint32_t face)
{
    const uint32_t *corner = &surface->corners[(size_t)face * 3];
    bool folded = frames->folded[corner[0]] || frames->folded[corner[1]] || frames->folded[corner[2]];
    return folded ? solid_angle(surface, frames, face) : excess_of_corners(surface, frames, face);
}

/* The least turn that makes the plane at the far end of entry i of p the one at p, as the frames' axes see it. */
static double least_turn(const struct hatch_surface *surface, const struct hatch_frames *frames, uint32_t p, uint32_t i)
{
    size_t q = surface->ring_point[i];
    const double *normal = &frames->normal[(size_t)p * 3], *axis = &frames->axis[(size_t)p * 3];
    double sum[3], brought[3], side[3];
    hatch_vec_add_scaled(normal, surface->ring_turned[i] ? -1 : 1, &frames->normal[q * 3], sum);
    double square = hatch_vec_dot(sum, sum), along = hatch_vec_dot(&frames->axis[q * 3], normal);
    hatch_vec_add_scaled(&frames->axis[q * 3], square > 0 ? -2 * along / square : 0, sum, brought);
    hatch_vec_cross(normal, axis, side);
    return atan2(hatch_vec_dot(brought, side), hatch_vec_dot(brought, axis));
}

/* The first folded corner of a face. */
static uint32_t first_folded(const struct hatch_surface *surface, const struct hatch_frames *frames, uint32_t face)
{
    const uint32_t *corner = &surface->corners[(size_t)face * 3];
    return frames->folded[corner[0]] ? corner[0] : frames->folded[corner[1]] ? corner[1] : corner[2];
}

/* Folded points that hang together: found from one of them by going over edges. */
struct cluster {
    uint32_t *points, count;
    bool *met;
};

static void find_cluster(const struct hatch_surface *surface, const struct hatch_frames *frames, uint32_t point,
                         struct cluster *cluster)
{
    cluster->count = 1;
    cluster->points[0] = point;
    cluster->met[point] = true;
    for (uint32_t next = 0; next < cluster->count; next++)
        for (uint32_t p = cluster->points[next], i = surface->ring_first[p]; i < surface->ring_first[p + 1]; i++) {
            uint32_t q = surface->ring_point[i];
            if (!frames->folded[q] || cluster->met[q])
                continue;
            cluster->met[q] = true;
            cluster->points[cluster->count++] = q;
        }
}

/* Both measures of how the faces of a cluster turn what is carried around them differ by whole turns. Where that is not
 * none, the normals are wild, and the sum of indices would no longer be the Euler characteristic. */
static bool is_sound(const struct hatch_surface *surface, const struct hatch_frames *frames,
                     const struct cluster *cluster)
{
    double apart = 0;
    for (uint32_t k = 0; k < cluster->count; k++)
        for (uint32_t p = cluster->points[k], i = surface->ring_first[p]; i < surface->ring_first[p + 1]; i++) {
            uint32_t face = surface->ring_face[i];
            if (face != HATCH_NO_SIDE && first_folded(surface, frames, face) == p)
                apart += solid_angle(surface, frames, face) - excess_of_corners(surface, frames, face);
        }
    return fabs(apart) < 1;
}

static void turn_edges(const struct hatch_surface *surface, const struct cluster *cluster, struct hatch_frames *frames)
{
    for (uint32_t k = 0; k < cluster->count; k++)
        for (uint32_t p = cluster->points[k], i = surface->ring_first[p]; i < surface->ring_first[p + 1]; i++) {
            double turn = least_turn(surface, frames, p, i);
            frames->turn_rad[i] = turn;
            frames->turn_rad[frames->mate[i]] = surface->ring_turned[i] ? turn : -turn;
        }
}

enum hatch_status hatch_frames_turn_folds(const struct hatch_surface *surface, struct hatch_arena *scratch,
                                          struct hatch_frames *frames, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct cluster cluster = {.points = HATCH_NEW_UNSET(scratch, uint32_t, surface->point_count, err)};
    cluster.met = cluster.points ? HATCH_NEW(scratch, bool, surface->point_count, err) : NULL;
    for (uint32_t p = 0; cluster.met && p < surface->point_count; p++) {
        if (!frames->folded[p] || cluster.met[p])
            continue;
        find_cluster(surface, frames, p, &cluster);
        bool sound = is_sound(surface, frames, &cluster);
        for (uint32_t k = 0; !sound && k < cluster.count; k++)
            frames->folded[cluster.points[k]] = false;
        if (sound)
            turn_edges(surface, &cluster, frames);
    }
    hatch_arena_rewind(scratch, mark);
    return cluster.met ? HATCH_OK : HATCH_LIMIT;
}
