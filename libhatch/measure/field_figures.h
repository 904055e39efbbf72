/* Figures of the direction fields of meshes (`_HATCH_DIR`); hatchstat(1) has the formulas. The meshes of a
 * scene are added one after another and measured together. */
#ifndef HATCH_MEASURE_FIELD_FIGURES_H
#define HATCH_MEASURE_FIELD_FIGURES_H

#include "mesh/mesh.h"

struct hatch_field_figures {
    uint64_t points, faces, components; /* of the surfaces */
    int64_t euler;                      /* Euler characteristic */
    double index_sum;                   /* of all faces and borders; equals euler for every field */
    uint64_t singularities;             /* faces with an index other than 0 */
    double smoothness;                  /* energy of the edges */
    double confidence[3];               /* quartiles over the points */
    double uv_degrees[3];               /* angle to rising u, 0 .. 90: 50th, 75th, 95th percentile by area; NaN
                                           without texture coordinates */
    uint64_t compared;                  /* points compared with the reference */
    double degrees[4];                  /* angle to the reference, 0 .. 90: 50th, 75th, 95th percentile, maximum;
                                           NaN without a reference */
    double axis_degrees[2];             /* angle to the nearer of the reference's line and the tangent line
                                           perpendicular to it, 0 .. 45: 50th and 95th percentile; NaN without */
};

struct hatch_field_samples;

/* Figures of the meshes added so far. Start from {.arena = a, .scratch = s}. */
struct hatch_field_sum {
    struct hatch_arena *arena, *scratch; /* arena: keeps the samples until hatch_measure_field_end */
    struct hatch_field_figures figures;
    struct hatch_field_samples *samples; /* list of one entry per mesh */
    bool reference_failed;               /* the error of hatch_measure_field_add concerns the reference */
};

/* Adds a mesh and its field, and compares it with a reference. Points are matched by exact position; where
 * most positions are not in both meshes but both have as many vertices, by vertex number. Points with
 * reference confidence 0 are not compared.
 *   reference  mesh with the true field; may be NULL
 * HATCH_BAD_INPUT without `_HATCH_DIR`, when no point matches, and as hatch_surface_make. */
enum hatch_status hatch_measure_field_add(struct hatch_field_sum *sum, const struct hatch_mesh *mesh,
                                          const struct hatch_mesh *reference, struct hatch_err *err) HATCH_MUST_USE;

/* Computes the figures of all meshes added.
 *   share  fraction of the compared points that counts, above 0 to 1: those of largest reference confidence,
 *          and all others that are equal to the last of these */
enum hatch_status hatch_measure_field_end(const struct hatch_field_sum *sum, double share,
                                          struct hatch_field_figures *figures, struct hatch_err *err) HATCH_MUST_USE;

#endif
