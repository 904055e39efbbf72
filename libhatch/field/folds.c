#include <assert.h>
#include <math.h>

#include "math/vector.h"
#include "curvature/curvature.h"
#include "field/system.h"

#define ERROR_RAD 0.05 /* folds tell a direction so well at best */
#define HALF_RAD 0.02  /* and half as well, in odds, where they turn by so little */
#define ROUND_RAD 0.8  /* a tube of eight sides is round, the teeth of a gear are not */

/* The edges around a point. */
struct folds {
    bool hard;     /* one is */
    double length; /* of the others */
    double z[2];   /* their lines across, at twice their angles in the point's plane, times length and fold */
};

/* Unit; turned: of the face's back. Returns twice the area. */
static double face_normal(const struct hatch_surface *surface, uint32_t face, bool turned, double normal[3])
{
    hatch_surface_normal(surface, face, normal);
    double length = hatch_vec_normalize(normal);
    for (int k = 0; k < 3 && turned; k++)
        normal[k] = -normal[k];
    return length;
}

static double angle_between(const double a[3], const double b[3])
{
    double turn[3];
    hatch_vec_cross(a, b, turn);
    return atan2(hatch_vec_length(turn), hatch_vec_dot(a, b));
}

/* Whether most of a component's area is of faces that are parts of something round: they fold a little somewhere. */
static bool is_round(const struct hatch_surface *surface, const struct hatch_component *of)
{
    double whole = 0, round = 0;
    for (uint32_t f = of->first_face; f < of->first_face + of->face_count; f++) {
        double normals[2][3], area = face_normal(surface, f, false, normals[0]);
        bool folds = false;
        for (uint32_t side = 3 * f; side < 3 * f + 3 && !folds; side++) {
            uint32_t other = surface->opposite[side];
            if (other == HATCH_NO_SIDE)
                continue;
            /* Across a contrary edge, which runs one way on both, one face shows its back. */
            face_normal(surface, other / 3, surface->corners[other] == surface->corners[side], normals[1]);
            double fold_rad = angle_between(normals[0], normals[1]);
            folds = fold_rad > HALF_RAD && fold_rad < ROUND_RAD;
        }
        whole += area;
        round += folds ? area : 0;
    }
    return round > whole / 2;
}

/* The surface bends across the edge, which runs between faces of these normals. */
static void add_fold(const struct hatch_frames *frames, uint32_t point, const double edge[3], double normals[2][3],
                     double crease_rad, struct folds *folds)
{
    double mean[3], across[3], length = hatch_vec_length(edge);
    double fold_rad = angle_between(normals[0], normals[1]);
    if (fold_rad > crease_rad) {
        folds->hard = true;
        return;
    }
    hatch_vec_add_scaled(normals[0], 1, normals[1], mean);
    hatch_vec_cross(edge, mean, across);
    double z[2];
    hatch_field_square(frames, point, across, z);
    folds->length += length;
    for (int k = 0; k < 2; k++)
        folds->z[k] += length * fold_rad * z[k];
}

static struct folds folds_at(const struct hatch_surface *surface, const struct hatch_frames *frames, uint32_t point,
                             double crease_rad)
{
    struct folds folds = {0};
    uint32_t first = surface->ring_first[point], end = surface->ring_first[point + 1];
    for (uint32_t i = first; i < end; i++) {
        uint32_t before = i > first ? i - 1 : end - 1;
        double normals[2][3], edge[3];
        if (surface->ring_face[before] == HATCH_NO_SIDE || surface->ring_face[i] == HATCH_NO_SIDE)
            continue;
        face_normal(surface, surface->ring_face[before], surface->ring_flipped[before], normals[0]);
        face_normal(surface, surface->ring_face[i], surface->ring_flipped[i], normals[1]);
        hatch_vec_sub(&surface->points[(size_t)surface->ring_point[i] * 3], &surface->points[(size_t)point * 3], edge);
        add_fold(frames, point, edge, normals, crease_rad, &folds);
    }
    return folds;
}

void hatch_field_follow_folds(const struct hatch_surface *surface, const struct hatch_frames *frames, double crease_rad,
                              const double *hard, double *direction, double *confidence)
{
    assert(crease_rad > 0 && crease_rad < 1.5707963267948966);
    const struct hatch_field_data data = {direction, confidence, hard, false};
    double least = HATCH_CURVATURE_EVEN_RAD / ERROR_RAD;
    for (uint32_t c = 0; c < surface->component_count; c++) {
        const struct hatch_component *of = &surface->components[c];
        if (hatch_field_scale_of(surface, frames, &data, 0, c).directed || !is_round(surface, of))
            continue;
        for (uint32_t p = of->first_point; p < of->first_point + of->point_count; p++) {
            struct folds folds = folds_at(surface, frames, p, crease_rad);
            double fold_rad = hypot(folds.z[0], folds.z[1]) / folds.length;
            if (!folds.hard || !(fold_rad > 0))
                continue;
            double odds = least * least / (1 + HALF_RAD * HALF_RAD / (fold_rad * fold_rad));
            confidence[p] = odds / (1 + odds);
            hatch_frames_direction(frames, p, atan2(folds.z[1], folds.z[0]) / 2, &direction[(size_t)p * 3]);
        }
    }
}
