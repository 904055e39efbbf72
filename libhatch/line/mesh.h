/* The view-independent data of a mesh for feature lines: normals that are discontinuous at creases, and the edges that
 * are drawn in every view. */
#ifndef HATCH_LINE_MESH_H
#define HATCH_LINE_MESH_H

#include "scene/scene.h"
#include "line/chain.h"

/* Kinds of feature lines, as bits. */
enum hatch_line_kind {
    HATCH_LINES_NONE = 0,
    HATCH_LINES_SILHOUETTES = 1, /* lines between parts of the surface that face the eye and parts that face away */
    HATCH_LINES_CREASES = 2,     /* edges sharper than an angle, and edges at which more than two sheets meet */
    HATCH_LINES_BOUNDARIES = 4,  /* edges where the surface ends */
    HATCH_LINES_ALL = 7
};

/* An edge across which normals are discontinuous: the silhouette may run along it. */
struct hatch_line_hard_edge {
    uint32_t low[2], high[2]; /* vertices at its two ends: [0] of its first face, [1] of its second */
    uint32_t points[2];       /* welded points at its low and high end */
};

/* An edge that is drawn wherever it is visible. */
struct hatch_line_feature {
    uint32_t ends[2];  /* vertices of hatch_line_mesh.mesh */
    uint32_t faces[2]; /* two of the faces at the edge; the second is HATCH_NONE at a boundary */
    bool more_faces;   /* more than two faces meet there */
};

/* The lines to find. */
struct hatch_line_choice {
    uint32_t kinds;        /* bits of enum hatch_line_kind */
    double crease_rad;     /* least angle between the faces at a crease, 0 .. π */
    bool normals_authored; /* as for hatch_line_edges_find */
};

/* The neighbours of each vertex. Vertices that are not completely surrounded by faces have none. */
struct hatch_line_ring {
    uint32_t *first;      /* per vertex: the first of its range in neighbours; then the end of the last range */
    uint32_t *neighbours; /* vertices */
};

struct hatch_line_mesh {
    struct hatch_mesh mesh; /* one vertex per position and normal; relative to the origin */
    uint8_t *hard_sides;    /* per face: bit c is set where normals are discontinuous across side c */
    struct hatch_line_ring ring;
    uint32_t hard_edge_count, feature_count;
    struct hatch_line_hard_edge *hard_edges;
    struct hatch_line_feature *features;
    uint32_t node_count;
    uint32_t *node_vertices;         /* per node of the chains: its vertex */
    struct hatch_line_chains chains; /* chains of features */
};

/* Welds a mesh, finds and classifies its edges, and joins features into chains. If the mesh's normals are continuous
 * across a crease, all normals are computed again from the faces; otherwise the silhouette of a box, for example, would
 * run across its sides.
 *   origin  subtracted from positions; 0 0 0 for a deformed mesh
 *   arena   for the result; not the scratch arena */
enum hatch_status hatch_line_mesh_make(const struct hatch_mesh *from, const double origin[3],
                                       const struct hatch_line_choice *choice, struct hatch_arena *arena,
                                       struct hatch_arena *scratch, struct hatch_line_mesh *lines,
                                       struct hatch_err *err) HATCH_MUST_USE;

/* Finds the neighbours of each vertex.
 *   arena  for the result; not the scratch arena */
enum hatch_status hatch_line_ring_make(const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                       struct hatch_arena *scratch, struct hatch_line_ring *ring,
                                       struct hatch_err *err) HATCH_MUST_USE;

#endif
