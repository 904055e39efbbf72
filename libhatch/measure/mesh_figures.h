/* Measurements of a mesh: topology, sizes and texture coordinates; hatchstat(1) has the formulas. A point is a
 * position: vertices at the same position are one point. */
#ifndef HATCH_MEASURE_MESH_FIGURES_H
#define HATCH_MEASURE_MESH_FIGURES_H

#include "mesh/mesh.h"

struct hatch_uv_figures {
    double degenerate_share; /* share of the surface area in faces without texture area; NaN without surface area */
    /* Of the remaining area; NaN if there is none. */
    double mirrored_share; /* share of it in faces with a mirrored texture */
    double angle[3]; /* larger / smaller singular value of the map to texture space: 5th, 50th, 95th percentile by area;
                        1 preserves angles */
    double area[3];  /* texture area per surface area, relative to the mean: the same percentiles; 1 is uniform */
};

struct hatch_mesh_figures {
    uint32_t vertices, faces;
    uint32_t points;
    uint32_t unused_vertices;     /* vertices that no face uses */
    uint32_t components;          /* sets of faces that are connected through shared points */
    uint32_t boundary_loops;      /* connected sets of boundary edges */
    int64_t euler;                /* points - edges + faces, without degenerate faces */
    int64_t genus;                /* -1 when not manifold or not consistently oriented */
    uint32_t non_manifold_edges;  /* edges of more than two faces */
    uint32_t non_manifold_points; /* points whose faces are not connected through edges */
    uint32_t degenerate_faces;    /* faces with a repeated corner or no area; excluded from the topology */
    uint32_t duplicate_faces;     /* faces with the same points as an earlier face */
    uint32_t contrary_edges;      /* edges of two faces with opposite orientations */
    double area;
    float low[3], high[3];                /* bounding box of the used vertices */
    double edge_min, edge_mean, edge_max; /* NaN if all faces are degenerate */
    bool has_uv;                          /* has TEXCOORD_0 */
    struct hatch_uv_figures uv;           /* zero without TEXCOORD_0 */
};

/* Measures a mesh. Time is nearly linear, whatever the valences.
 *   mesh  must pass hatch_mesh_check */
enum hatch_status hatch_measure_mesh(const struct hatch_mesh *mesh, struct hatch_arena *scratch,
                                     struct hatch_mesh_figures *figures, struct hatch_err *err) HATCH_MUST_USE;

#endif
