/* Where faces overlap in a point's tangent plane, its angles are meaningless. There, transport along an edge is the
 * smallest rotation between the planes, and the holonomy of a face is the solid angle spanned by the normals at its
 * corners. */
#include <math.h>

#include "math/vector.h"
#include "surface/frames.h"

#define PI 3.14159265358979323846

/* Returns the sum of the face's scaled angles minus π. */
static double angle_excess(const struct hatch_surface *surface, const struct hatch_frames *frames, uint32_t face)
{
    double sum = -PI;
    for (size_t c = (size_t)face * 3; c < (size_t)face * 3 + 3; c++)
        sum += hatch_frames_corner_angle(surface, frames, surface->corners[c], frames->corner_entry[c]);
    return sum;
}

static double solid_angle(const struct hatch_surface *surface, const struct hatch_frames *frames, uint32_t face)
{
    double n[3][3], cross[3];
    for (size_t c = 0; c < 3; c++) {
        size_t corner = (size_t)face * 3 + c;
        for (size_t k = 0; k < 3; k++)
            n[c][k] = frames->normal[(size_t)surface->corners[corner] * 3 + k] *
                      (surface->ring_flipped[frames->corner_entry[corner]] ? -1 : 1);
    }
    hatch_vec_cross(n[1], n[2], cross);
    return 2 * atan2(hatch_vec_dot(n[0], cross),
                     1 + hatch_vec_dot(n[0], n[1]) + hatch_vec_dot(n[1], n[2]) + hatch_vec_dot(n[2], n[0]));
}

double hatch_frames_face_holonomy(const struct hatch_surface *surface, const struct hatch_frames *frames, uint32_t face)
{
    const uint32_t *corner = &surface->corners[(size_t)face * 3];
    bool folded = frames->folded[corner[0]] || frames->folded[corner[1]] || frames->folded[corner[2]];
    return folded ? solid_angle(surface, frames, face) : angle_excess(surface, frames, face);
}

/* Returns the transport along entry i of p by the smallest rotation between the planes at its ends. */
static double smallest_rotation(const struct hatch_surface *surface, const struct hatch_frames *frames, uint32_t p,
                                uint32_t i)
{
    size_t q = surface->ring_point[i];
    const double *normal = &frames->normal[(size_t)p * 3], *axis = &frames->axis[(size_t)p * 3];
    double sum[3], transported[3], side[3];
    hatch_vec_add_scaled(normal, surface->ring_turned[i] ? -1 : 1, &frames->normal[q * 3], sum);
    double square = hatch_vec_dot(sum, sum), along = hatch_vec_dot(&frames->axis[q * 3], normal);
    hatch_vec_add_scaled(&frames->axis[q * 3], square > 0 ? -2 * along / square : 0, sum, transported);
    hatch_vec_cross(normal, axis, side);
    return atan2(hatch_vec_dot(transported, side), hatch_vec_dot(transported, axis));
}

static uint32_t first_folded(const struct hatch_surface *surface, const struct hatch_frames *frames, uint32_t face)
{
    const uint32_t *corner = &surface->corners[(size_t)face * 3];
    return frames->folded[corner[0]] ? corner[0] : frames->folded[corner[1]] ? corner[1] : corner[2];
}

/* A cluster of folded points that are connected by edges. */
struct cluster {
    uint32_t *points, count;
    bool *visited; /* per point of the surface */
};

static void find_cluster(const struct hatch_surface *surface, const struct hatch_frames *frames, uint32_t point,
                         struct cluster *cluster)
{
    cluster->count = 1;
    cluster->points[0] = point;
    cluster->visited[point] = true;
    for (uint32_t next = 0; next < cluster->count; next++)
        for (uint32_t p = cluster->points[next], i = surface->ring_first[p]; i < surface->ring_first[p + 1]; i++) {
            uint32_t q = surface->ring_point[i];
            if (!frames->folded[q] || cluster->visited[q])
                continue;
            cluster->visited[q] = true;
            cluster->points[cluster->count++] = q;
        }
}

/* Returns whether the solid angles of the faces of a cluster sum to the same holonomy as their angle excesses. The two
 * sums differ by a multiple of 2π. If that is not 0, the normals are wrong, and indices would no longer sum to the
 * Euler characteristic. */
static bool keeps_holonomy(const struct hatch_surface *surface, const struct hatch_frames *frames,
                           const struct cluster *cluster)
{
    double difference = 0;
    for (uint32_t k = 0; k < cluster->count; k++)
        for (uint32_t p = cluster->points[k], i = surface->ring_first[p]; i < surface->ring_first[p + 1]; i++) {
            uint32_t face = surface->ring_face[i];
            if (face != HATCH_NO_SIDE && first_folded(surface, frames, face) == p)
                difference += solid_angle(surface, frames, face) - angle_excess(surface, frames, face);
        }
    return fabs(difference) < 1;
}

static void transport_cluster(const struct hatch_surface *surface, const struct cluster *cluster,
                              struct hatch_frames *frames)
{
    for (uint32_t k = 0; k < cluster->count; k++)
        for (uint32_t p = cluster->points[k], i = surface->ring_first[p]; i < surface->ring_first[p + 1]; i++) {
            double rotation = smallest_rotation(surface, frames, p, i);
            frames->transport_rad[i] = rotation;
            frames->transport_rad[frames->twin[i]] = surface->ring_turned[i] ? rotation : -rotation;
        }
}

enum hatch_status hatch_frames_transport_folded(const struct hatch_surface *surface, struct hatch_arena *scratch,
                                                struct hatch_frames *frames, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct cluster cluster = {.points = HATCH_NEW_UNSET(scratch, uint32_t, surface->point_count, err)};
    cluster.visited = cluster.points ? HATCH_NEW(scratch, bool, surface->point_count, err) : NULL;
    for (uint32_t p = 0; cluster.visited && p < surface->point_count; p++) {
        if (!frames->folded[p] || cluster.visited[p])
            continue;
        find_cluster(surface, frames, p, &cluster);
        bool valid = keeps_holonomy(surface, frames, &cluster);
        for (uint32_t k = 0; !valid && k < cluster.count; k++)
            frames->folded[cluster.points[k]] = false;
        if (valid)
            transport_cluster(surface, &cluster, frames);
    }
    hatch_arena_rewind(scratch, mark);
    return cluster.visited ? HATCH_OK : HATCH_LIMIT;
}
