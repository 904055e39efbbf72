/* The figures of direction fields: `_HATCH_DIR` of meshes. hatchstat(1) writes their formulas. The
 * meshes of a scene are added one after another, and measured as one. */
#ifndef HATCH_MEASURE_FIELD_FIGURES_H
#define HATCH_MEASURE_FIELD_FIGURES_H

#include "mesh/mesh.h"

struct hatch_field_figures {
    uint64_t points, faces, components;
    int64_t euler;
    double index_sum;       /* with what borders turn: the Euler characteristic, when all is well */
    uint64_t singularities; /* faces with an index */
    double smoothness;      /* the energy of the edges */
    double confidence[3];   /* quartiles over the points */
    double uv_degrees[3];   /* 50th, 75th and 95th percentile by area: angle to rising u; NaN without one */
    uint64_t compared;      /* points that were compared with the reference */
    double degrees[4];      /* 50th, 75th, 95th percentile and largest angle to it; NaN without one */
};

struct hatch_field_samples;

/* The meshes so far. Start from zeros but for the arenas; the rest is private. */
struct hatch_field_sum {
    struct hatch_arena *arena, *scratch; /* arena: what is kept until the end */
    struct hatch_field_figures figures;
    struct hatch_field_samples *samples; /* of each mesh, newest first */
};

/* Adds a mesh. reference: NULL, or a mesh whose field the mesh's is compared with. Points meet by their
 * exact positions; where most positions are not in both, but both have as many vertices, by the
 * vertices' numbers. Points where the reference's confidence is 0 are left out. HATCH_BAD_INPUT as
 * hatch_surface_make, when a mesh has no `_HATCH_DIR`, and when no point meets one. */
enum hatch_status hatch_measure_field_add(struct hatch_field_sum *sum, const struct hatch_mesh *mesh,
                                          const struct hatch_mesh *reference, struct hatch_err *err) HATCH_MUST_USE;

/* The figures of all meshes. share: over 0, at most 1: how many of the compared points count, those
 * where the reference is most confident. */
enum hatch_status hatch_measure_field_end(const struct hatch_field_sum *sum, double share,
                                          struct hatch_field_figures *figures, struct hatch_err *err) HATCH_MUST_USE;

#endif
