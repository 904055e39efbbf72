/* What feature lines need of a mesh, found once: normals with creases, and the edges that are drawn
 * wherever one looks from. */
#ifndef HATCH_LINE_MESH_H
#define HATCH_LINE_MESH_H

#include "scene/scene.h"
#include "line/chain.h"

/* Which lines; bits. */
enum hatch_line_kind {
    HATCH_LINES_NONE = 0,
    HATCH_LINES_SILHOUETTES = 1, /* where the surface turns away */
    HATCH_LINES_CREASES = 2,     /* edges sharper than an angle, and edges of more than two faces */
    HATCH_LINES_BOUNDARIES = 4,  /* edges where the surface ends */
    HATCH_LINES_ALL = 7
};

/* An edge along which normals jump: the silhouette may run along it. */
struct hatch_line_hard_edge {
    uint32_t low[2], high[2]; /* the vertices at both ends: of its first face, of its second */
    uint32_t points[2];       /* numbers of the ends, whatever the normal */
};

/* An edge that is always drawn where it can be seen. */
struct hatch_line_feature {
    uint32_t ends[2];  /* vertices */
    uint32_t faces[2]; /* the second HATCH_NONE at a boundary */
    bool more_faces;   /* than these two meet there */
};

/* Which of a mesh's lines are wanted. */
struct hatch_line_choice {
    uint32_t kinds;     /* enum hatch_line_kind, joined */
    double crease_rad;  /* 0 .. π: edges that turn by more are creases */
    bool normals_meant; /* the mesh's normals are its maker's, not made from its faces */
};

/* The neighbours of vertex v are neighbours[first[v]] up to first[v + 1]: none where they do not go all around it. */
struct hatch_line_ring {
    uint32_t *first, *neighbours;
};

struct hatch_line_mesh {
    struct hatch_mesh mesh; /* a vertex for each position and normal; positions minus the origin */
    uint8_t *hard_sides;    /* per face: bit c is set where the surface is not smooth across side c */
    struct hatch_line_ring ring;
    uint32_t hard_count, feature_count;
    struct hatch_line_hard_edge *hards;
    struct hatch_line_feature *features;
    uint32_t node_count;
    uint32_t *node_vertices;         /* the vertex at each node of the chains */
    struct hatch_line_chains chains; /* of features */
};

/* Welds, finds edges and their kinds, and chains those that are wanted. Where the mesh's normals smooth
 * over a crease, all its normals are made anew: a silhouette would cross the faces of a box otherwise.
 * origin: subtracted from positions; of a skinned
 * mesh 0 0 0. arena and scratch must not be the same. */
enum hatch_status hatch_line_mesh_make(const struct hatch_mesh *from, const double origin[3],
                                       const struct hatch_line_choice *choice, struct hatch_arena *arena,
                                       struct hatch_arena *scratch, struct hatch_line_mesh *lines,
                                       struct hatch_err *err) HATCH_MUST_USE;

/* arena and scratch must not be the same. */
enum hatch_status hatch_line_ring_make(const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                       struct hatch_arena *scratch, struct hatch_line_ring *ring,
                                       struct hatch_err *err) HATCH_MUST_USE;

#endif
