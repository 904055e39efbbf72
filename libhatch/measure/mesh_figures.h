/* The figures of a mesh: its topology, sizes and texture coordinates. hatchstat(1) writes their formulas.
 * Points are positions: vertices at one place are one. */
#ifndef HATCH_MEASURE_MESH_FIGURES_H
#define HATCH_MEASURE_MESH_FIGURES_H

#include "mesh/mesh.h"

struct hatch_uv_figures {
    double degenerate_share; /* share of the area whose triangles have no area in texture space */
    double mirrored_share;   /* share of the rest that is mirrored */
    double angle[3];         /* 5th, 50th and 95th percentile, by area, of the larger over the smaller
                                stretch of a triangle: 1 keeps angles */
    double area[3];          /* the same of texture area over area, in units of the whole's: 1 is even */
};

struct hatch_mesh_figures {
    uint32_t vertices, faces;
    uint32_t points;              /* that vertices are at */
    uint32_t unused_vertices;     /* that no face uses */
    uint32_t components;          /* of faces that share points */
    uint32_t boundary_loops;      /* connected sets of edges of one face */
    int64_t euler;                /* points - edges + faces, of what has an area */
    int64_t genus;                /* -1 where it has none: not manifold, or not orientable as it is */
    uint32_t non_manifold_edges;  /* of more than two faces */
    uint32_t non_manifold_points; /* where faces meet that share no edge there */
    uint32_t degenerate_faces;    /* a corner given twice, or no area; left out of the topology */
    uint32_t duplicate_faces;     /* on the points of an earlier face */
    uint32_t contrary_edges;      /* of two faces that do not agree which side is out */
    double area;
    float low[3], high[3]; /* box around the used vertices */
    double edge_min, edge_mean, edge_max;
    bool has_uv;
    struct hatch_uv_figures uv; /* where has_uv */
};

/* Measures a mesh that passes hatch_mesh_check. Time is about linear, whatever the valences. */
enum hatch_status hatch_measure_mesh(const struct hatch_mesh *mesh, struct hatch_arena *scratch,
                                     struct hatch_mesh_figures *figures, struct hatch_err *err) HATCH_MUST_USE;

#endif
