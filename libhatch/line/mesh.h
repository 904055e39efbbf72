/* The view-independent data of a mesh at a pose for feature lines: its edges, and which of them are drawn in every
 * view. */
#ifndef HATCH_LINE_MESH_H
#define HATCH_LINE_MESH_H

#include "scene/scene.h"
#include "line/chain.h"

/* Kinds of feature lines, as bits. */
enum hatch_line_kind {
    HATCH_LINES_NONE = 0,
    HATCH_LINES_SILHOUETTES = 1, /* edges all of whose faces lie on one side of them in the picture */
    HATCH_LINES_CREASES = 2,     /* edges sharper than an angle, and edges at which more than two sheets meet */
    HATCH_LINES_BOUNDARIES = 4,  /* edges where the surface ends */
    HATCH_LINES_ALL = 7
};

/* An edge that is drawn wherever it is visible. */
struct hatch_line_feature {
    uint32_t ends[2];  /* vertices of hatch_line_mesh.mesh */
    uint32_t faces[2]; /* two of the faces at the edge; the second is HATCH_NONE at a boundary */
    bool more_faces;   /* more than two faces meet there */
};

struct hatch_line_edges; /* line/edges.h */

/* The lines to find. */
struct hatch_line_choice {
    uint32_t kinds;        /* bits of enum hatch_line_kind */
    double crease_rad;     /* least angle between the faces at a crease, 0 .. π */
    bool normals_authored; /* as for hatch_line_edges_judge */
};

/* Edges where a silhouette may run. Side 3 * f + c is that of face f from its corner c to the next. */
struct hatch_line_turns {
    uint32_t count;
    uint32_t *first; /* count + 1 entries: edge e has sides[first[e]] .. sides[first[e + 1] - 1] */
    uint32_t *sides;
    uint8_t *creases; /* per edge: not 0: a crease */
};

struct hatch_line_mesh {
    struct hatch_mesh mesh;        /* a vertex per welded point: POSITION relative to the origin */
    struct hatch_line_turns turns; /* all edges but boundaries */
    uint32_t feature_count;
    struct hatch_line_feature *features;
    uint32_t node_count;
    uint32_t *node_vertices;         /* per node of the chains: its vertex */
    struct hatch_line_chains chains; /* chains of features */
};

/* Welds a mesh, finds and classifies its edges, and joins features into chains.
 *   edges   of the mesh at another pose, whatever their kinds; NULL: they are found
 *   origin  subtracted from positions
 *   arena   for the result; not the scratch arena */
enum hatch_status hatch_line_mesh_make(const struct hatch_mesh *from, const struct hatch_line_edges *edges,
                                       const double origin[3], const struct hatch_line_choice *choice,
                                       struct hatch_arena *arena, struct hatch_arena *scratch,
                                       struct hatch_line_mesh *lines, struct hatch_err *err) HATCH_MUST_USE;

#endif
