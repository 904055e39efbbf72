#include "curvature/bending.h"

#include <assert.h>
#include <math.h>

#include "curvature/curvature.h"
#include "math/vector.h"

#define ERROR_RAD 0.05 /* smallest standard error of a direction from dihedral angles */

/* Sums over edges. */
struct sums {
    double length;
    double z[2]; /* cosine and sine of twice the angle of the direction across the edge, times length, dihedral angle */
};

double hatch_bending_face_normal(const struct hatch_surface *surface, uint32_t face, bool back, double normal[3])
{
    hatch_surface_face_normal(surface, face, normal);
    double length = hatch_vec_normalize(normal);
    for (int k = 0; k < 3 && back; k++)
        normal[k] = -normal[k];
    return length;
}

/* Adds an edge between faces of these normals: the surface bends in the direction across it. */
static void add_edge(const struct hatch_frames *frames, uint32_t point, const double edge[3], double normals[2][3],
                     double dihedral_rad, struct sums *sums)
{
    double mean[3], across[3], length = hatch_vec_length(edge);
    hatch_vec_add_scaled(normals[0], 1, normals[1], mean);
    hatch_vec_cross(edge, mean, across);
    double twice_rad = 2 * hatch_frames_angle(frames, point, across);
    sums->length += length;
    sums->z[0] += length * dihedral_rad * cos(twice_rad);
    sums->z[1] += length * dihedral_rad * sin(twice_rad);
}

struct hatch_bending hatch_bending_at(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                      uint32_t point, double crease_rad, const bool *left_out)
{
    struct hatch_bending bending = {0};
    struct sums sums = {0};
    uint32_t first = surface->ring_first[point], end = surface->ring_first[point + 1];
    assert(crease_rad > 0 && crease_rad < 1.5707963267948966);
    for (uint32_t i = first; i < end; i++) {
        uint32_t before = i > first ? i - 1 : end - 1;
        double normals[2][3], edge[3];
        if (surface->ring_face[before] == HATCH_NO_SIDE || surface->ring_face[i] == HATCH_NO_SIDE)
            continue;
        hatch_bending_face_normal(surface, surface->ring_face[before], surface->ring_flipped[before], normals[0]);
        hatch_bending_face_normal(surface, surface->ring_face[i], surface->ring_flipped[i], normals[1]);
        double dihedral_rad = hatch_vec_angle(normals[0], normals[1]);
        bending.on_crease = bending.on_crease || dihedral_rad > crease_rad;
        if (dihedral_rad > crease_rad || (left_out && left_out[i]))
            continue;
        bending.largest_rad = fmax(bending.largest_rad, dihedral_rad);
        hatch_vec_sub(&surface->points[(size_t)surface->ring_point[i] * 3], &surface->points[(size_t)point * 3], edge);
        add_edge(frames, point, edge, normals, dihedral_rad, &sums);
    }
    bending.mean_rad = sums.length > 0 ? hypot(sums.z[0], sums.z[1]) / sums.length : 0;
    bending.angle_rad = atan2(sums.z[1], sums.z[0]) / 2;
    return bending;
}

double hatch_bending_confidence(const struct hatch_bending *bending)
{
    double error_ratio = HATCH_CURVATURE_HALF_CONFIDENCE_RAD / ERROR_RAD;
    double flat_ratio = HATCH_BENDING_HALF_RAD / bending->mean_rad;
    double odds = error_ratio * error_ratio / (1 + flat_ratio * flat_ratio);
    return odds / (1 + odds);
}
