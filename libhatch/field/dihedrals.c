#include <math.h>

#include "math/vector.h"
#include "curvature/bending.h"
#include "field/system.h"

#define ROUND_RAD 0.8 /* largest dihedral angle of a round part: a tube of eight sides, but not the teeth of a gear */

/* Whether most of a component's area consists of faces with an edge of small but significant dihedral angle. */
static bool is_round(const struct hatch_surface *surface, const struct hatch_component *component)
{
    double whole = 0, round = 0;
    for (uint32_t f = component->first_face; f < component->first_face + component->face_count; f++) {
        double normals[2][3], area = hatch_bending_face_normal(surface, f, false, normals[0]);
        bool bends = false;
        for (uint32_t side = 3 * f; side < 3 * f + 3 && !bends; side++) {
            uint32_t other = surface->opposite[side];
            if (other == HATCH_NO_SIDE)
                continue;
            /* The back across a contrary edge. */
            hatch_bending_face_normal(surface, other / 3, surface->corners[other] == surface->corners[side],
                                      normals[1]);
            double dihedral_rad = hatch_vec_angle(normals[0], normals[1]);
            bends = dihedral_rad > HATCH_BENDING_HALF_RAD && dihedral_rad < ROUND_RAD;
        }
        whole += area;
        round += bends ? area : 0;
    }
    return round > whole / 2;
}

void hatch_field_fill_from_dihedrals(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                     double crease_rad, const double *constraint_weight, double *direction,
                                     double *confidence)
{
    const struct hatch_field_problem problem = {surface, frames, direction, confidence, constraint_weight, false};
    for (uint32_t c = 0; c < surface->component_count; c++) {
        const struct hatch_component *component = &surface->components[c];
        if (hatch_field_smoothing_of(&problem, 0, c).constrained || !is_round(surface, component))
            continue;
        for (uint32_t p = component->first_point; p < component->first_point + component->point_count; p++) {
            struct hatch_bending bending = hatch_bending_at(surface, frames, p, crease_rad, NULL);
            if (!bending.on_crease || !(bending.mean_rad > 0))
                continue;
            confidence[p] = hatch_bending_confidence(&bending);
            hatch_frames_direction(frames, p, bending.angle_rad, &direction[(size_t)p * 3]);
        }
    }
}
