#include <assert.h>
#include <math.h>

#include "math/vector.h"
#include "curvature/curvature.h"
#include "field/system.h"

#define ERROR_RAD 0.05 /* smallest standard error of a direction from dihedral angles */
#define HALF_RAD 0.02  /* dihedral angle that halves the odds of its confidence */
#define ROUND_RAD 0.8  /* largest dihedral angle of a round part: a tube of eight sides, but not the teeth of a gear */

/* The edges around a point. */
struct bending {
    bool on_crease;
    double length; /* of the edges that are not creases */
    double z[2];   /* sum over these: direction across the edge (hatch_field_encode) * length * dihedral angle */
};

/* Computes the unit normal of a face, or of its back. Returns twice the area. */
static double face_normal(const struct hatch_surface *surface, uint32_t face, bool back, double normal[3])
{
    hatch_surface_face_normal(surface, face, normal);
    double length = hatch_vec_normalize(normal);
    for (int k = 0; k < 3 && back; k++)
        normal[k] = -normal[k];
    return length;
}

/* Whether most of a component's area consists of faces with an edge of small but significant dihedral angle. */
static bool is_round(const struct hatch_surface *surface, const struct hatch_component *component)
{
    double whole = 0, round = 0;
    for (uint32_t f = component->first_face; f < component->first_face + component->face_count; f++) {
        double normals[2][3], area = face_normal(surface, f, false, normals[0]);
        bool bends = false;
        for (uint32_t side = 3 * f; side < 3 * f + 3 && !bends; side++) {
            uint32_t other = surface->opposite[side];
            if (other == HATCH_NO_SIDE)
                continue;
            /* The back across a contrary edge. */
            face_normal(surface, other / 3, surface->corners[other] == surface->corners[side], normals[1]);
            double dihedral_rad = hatch_vec_angle(normals[0], normals[1]);
            bends = dihedral_rad > HALF_RAD && dihedral_rad < ROUND_RAD;
        }
        whole += area;
        round += bends ? area : 0;
    }
    return round > whole / 2;
}

/* Adds an edge between faces of these normals: the surface bends in the direction across it. */
static void add_edge(const struct hatch_frames *frames, uint32_t point, const double edge[3], double normals[2][3],
                     double crease_rad, struct bending *bending)
{
    double mean[3], across[3], length = hatch_vec_length(edge);
    double dihedral_rad = hatch_vec_angle(normals[0], normals[1]);
    if (dihedral_rad > crease_rad) {
        bending->on_crease = true;
        return;
    }
    hatch_vec_add_scaled(normals[0], 1, normals[1], mean);
    hatch_vec_cross(edge, mean, across);
    double z[2];
    hatch_field_encode(frames, point, across, z);
    bending->length += length;
    for (int k = 0; k < 2; k++)
        bending->z[k] += length * dihedral_rad * z[k];
}

static struct bending bending_at(const struct hatch_surface *surface, const struct hatch_frames *frames, uint32_t point,
                                 double crease_rad)
{
    struct bending bending = {0};
    uint32_t first = surface->ring_first[point], end = surface->ring_first[point + 1];
    for (uint32_t i = first; i < end; i++) {
        uint32_t before = i > first ? i - 1 : end - 1;
        double normals[2][3], edge[3];
        if (surface->ring_face[before] == HATCH_NO_SIDE || surface->ring_face[i] == HATCH_NO_SIDE)
            continue;
        face_normal(surface, surface->ring_face[before], surface->ring_flipped[before], normals[0]);
        face_normal(surface, surface->ring_face[i], surface->ring_flipped[i], normals[1]);
        hatch_vec_sub(&surface->points[(size_t)surface->ring_point[i] * 3], &surface->points[(size_t)point * 3], edge);
        add_edge(frames, point, edge, normals, crease_rad, &bending);
    }
    return bending;
}

void hatch_field_fill_from_dihedrals(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                     double crease_rad, const double *constraint_weight, double *direction,
                                     double *confidence)
{
    assert(crease_rad > 0 && crease_rad < 1.5707963267948966);
    const struct hatch_field_problem problem = {surface, frames, direction, confidence, constraint_weight, false};
    double error_ratio = HATCH_CURVATURE_HALF_CONFIDENCE_RAD / ERROR_RAD;
    for (uint32_t c = 0; c < surface->component_count; c++) {
        const struct hatch_component *component = &surface->components[c];
        if (hatch_field_smoothing_of(&problem, 0, c).constrained || !is_round(surface, component))
            continue;
        for (uint32_t p = component->first_point; p < component->first_point + component->point_count; p++) {
            struct bending bending = bending_at(surface, frames, p, crease_rad);
            double dihedral_rad = hypot(bending.z[0], bending.z[1]) / bending.length;
            if (!bending.on_crease || !(dihedral_rad > 0))
                continue;
            double odds = error_ratio * error_ratio / (1 + HALF_RAD * HALF_RAD / (dihedral_rad * dihedral_rad));
            confidence[p] = odds / (1 + odds);
            hatch_frames_direction(frames, p, atan2(bending.z[1], bending.z[0]) / 2, &direction[(size_t)p * 3]);
        }
    }
}
