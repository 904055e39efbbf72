#include "mesh/edge_kinds.h"

#include <assert.h>
#include <string.h>

#include "math/vector.h"

/* If two faces at an edge lie on top of each other, their directions differ by rounding only: the cosine between them
 * is above this. */
#define COS_SAME 0.9999

/* Rounding of the cosine between directions that are opposite: without it, flat edges would be creases at 0. */
#define COS_ROUNDING 1e-12

#define COS_SAME_PLANE 0.99999 /* least cosine of the angle between neighbours that lie in one plane */

static enum hatch_edge_kind classify(const struct hatch_mesh *mesh, const uint32_t *sides, uint32_t count,
                                     double cos_crease)
{
    double first[3], other[3];
    uint32_t at = 0, directions = 1;
    bool same = true, opposite = false, bent = false;
    while (at < count && !hatch_side_direction(mesh, sides[at], first))
        at++;
    for (uint32_t i = at + 1; i < count; i++) {
        if (!hatch_side_direction(mesh, sides[i], other))
            continue;
        double cosine = hatch_vec_dot(first, other);
        directions++;
        same = same && cosine > COS_SAME;
        opposite = opposite || -cosine >= cos_crease;
        bent = bent || (-cosine < cos_crease && cosine < COS_SAME);
    }
    if (count == 1 || (directions > 1 && same))
        return HATCH_EDGE_BOUNDARY;
    return directions > 1 && (bent || !opposite) ? HATCH_EDGE_CREASE : HATCH_EDGE_SMOOTH;
}

void hatch_edges_classify(const struct hatch_mesh *mesh, const struct hatch_edges *edges, double crease_rad,
                          uint8_t *kinds)
{
    assert(crease_rad >= 0 && crease_rad < 3.1416);
    double cos_crease = cos(crease_rad) - COS_ROUNDING;
    for (uint32_t e = 0; e < edges->count; e++)
        kinds[e] =
            (uint8_t)classify(mesh, &edges->sides[edges->first[e]], edges->first[e + 1] - edges->first[e], cos_crease);
}

void hatch_edges_find_planes(const struct hatch_mesh *mesh, const struct hatch_edges *edges, uint8_t *in_plane)
{
    double first[3], other[3];
    memset(in_plane, 0, mesh->face_count);
    for (uint32_t e = 0; e < edges->count; e++) {
        const uint32_t *sides = &edges->sides[edges->first[e]];
        if (edges->first[e + 1] - edges->first[e] == 2 && hatch_side_direction(mesh, sides[0], first) &&
            hatch_side_direction(mesh, sides[1], other) && -hatch_vec_dot(first, other) >= COS_SAME_PLANE)
            in_plane[sides[0] / 3] = in_plane[sides[1] / 3] = 1;
    }
}
