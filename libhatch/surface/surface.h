/* Cleaned meshes. Algorithms on surfaces (curvature, direction fields, patches) take this structure and no other.
 *
 * A point is a position: vertices at the same position are one point, unless skins or morph targets move them apart.
 *
 * Where the mesh is not manifold, it is cut. The faces at an edge with more than two faces are separated and then
 * joined again in pairs, so that several edges may lie there, some of them on a border. A point whose faces are not
 * connected through edges becomes several points. Two points may therefore be joined by several edges and occur
 * repeatedly in each other's rings.
 *
 * The result is a set of connected components: manifold, with or without borders, orientable or not. Each is centred
 * and scaled to a mean edge length of 1 in doubles, so that an offset of 10⁶ or a scale of 10^±20 does not matter.
 * The faces and points of a component have consecutive numbers. */
#ifndef HATCH_SURFACE_SURFACE_H
#define HATCH_SURFACE_SURFACE_H

#include "mesh/mesh.h"

#define HATCH_NO_SIDE UINT32_MAX /* no side; also no face, point, node or ring entry */

struct hatch_component {
    uint32_t first_point, point_count;
    uint32_t first_face, face_count;
    uint32_t border_loops;
    uint32_t body; /* number of the component before creases around planes were cut; rises with the component */
    int32_t euler; /* Euler characteristic: points - edges + faces */
    bool orientable;
    double center[3]; /* of the bounding box, in mesh units */
    double scale;     /* mesh units per surface unit: the mean edge length, greater than 0 */
};

/* Side 3 * f + c (a half-edge) runs from corner c of face f to corner (c + 1) % 3, as in mesh/edges.h.
 * A contrary edge is one whose two faces cannot be oriented consistently; a Möbius strip has at least one. */
struct hatch_surface {
    uint32_t point_count, face_count, component_count;
    struct hatch_component *components;
    double *points;     /* 3 per point: (position - center) / scale */
    uint32_t *corners;  /* 3 per face: points, counter-clockwise seen from outside */
    uint32_t *opposite; /* per side: the other side of its edge, or HATCH_NO_SIDE on a border; it runs in the opposite
                           direction, except across a contrary edge, where it runs in the same one */
    uint32_t *point_component;
    uint32_t *corner_vertex; /* 3 per face: vertex of the mesh */
    uint32_t *face_source;   /* per face: face of the mesh */
    uint32_t plane_count;    /* 0 unless made by hatch_surface_make_cut */
    uint32_t *face_plane;    /* per face: its plane, or HATCH_NO_SIDE */
    double *plane_direction; /* 3 per plane: unit tangent */

    /* The ring of point p: its neighbours, counter-clockwise seen from the outside of the ring, which is the outside
     * of p's first face. Entries are ring_first[p] .. ring_first[p + 1] - 1. The ring of a border point is open: its
     * first and last neighbours lie on the border. */
    uint32_t *ring_first;  /* point_count + 1 */
    uint32_t *ring_point;  /* per entry: neighbour */
    uint32_t *ring_face;   /* per entry: face between this neighbour and the next (cyclic); HATCH_NO_SIDE in the last
                              entry of an open ring */
    uint8_t *ring_flipped; /* per entry: 1 where ring_face is clockwise seen from the outside of the ring */
    uint8_t *ring_turned;  /* per entry: 1 where the rings of p and of the neighbour have opposite outsides; this and
                              ring_flipped are 0 on orientable components */
};

/* Changes made by hatch_surface_make, for a warning; 0 where none. */
struct hatch_surface_notes {
    uint32_t welded;       /* vertices merged with another at their position */
    uint32_t degenerate;   /* faces without area, left out */
    uint32_t duplicate;    /* repeated faces, left out */
    uint32_t reversed;     /* those of them that face the other way than the one that is kept */
    uint32_t unreferenced; /* vertices without faces, left out */
    uint32_t flipped;      /* faces reversed to agree with their neighbours */
    uint32_t edges_cut;    /* edges with more than two faces */
    uint32_t points_split; /* points at which faces met that were not connected through edges */
    uint32_t contrary;     /* contrary edges */
    uint32_t components;   /* of the surface; not a change */
};

/* Makes the surface of a mesh, which hatch_mesh_check must accept. Vertices are welded by hatch_mesh_weld_moving. A
 * face is degenerate when a corner repeats or its area is 0 in doubles; (a, b, c) and (a, c, b) are duplicates. Time
 * and memory are linear, except for one sort.
 *   surface  out: arrays in arena, no pointer into the mesh
 *   notes    out
 * HATCH_BAD_INPUT when the check fails or no face remains. */
enum hatch_status hatch_surface_make(const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                     struct hatch_arena *scratch, struct hatch_surface *surface,
                                     struct hatch_surface_notes *notes, struct hatch_err *err) HATCH_MUST_USE;

/* The same, with planes: the flat faces of a body. They consist of connected triangles in one plane and either are
 * bounded by edges of over 75 degrees, where one or two triangles count if they are large or 30 % of the component is
 * flat; or have at least 30 triangles with a point inside, and half of their border open
 * or creased, or a width of several triangles. Edges of over 20 degrees around them are cut, so that both sides have
 * points, and directions, of their own. The direction of a plane is the one in which most of its border runs; or where
 * no tenth of it is straight, as around a disc, the coordinate axis that lies nearest to the plane. */
enum hatch_status hatch_surface_make_cut(const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                         struct hatch_arena *scratch, struct hatch_surface *surface,
                                         struct hatch_surface_notes *notes, struct hatch_err *err) HATCH_MUST_USE;

/* Converts a surface back to a mesh with the same faces and corners and all attributes of the source. A vertex used by
 * several points is duplicated. At vertices whose faces were all reversed, NORMAL and with it w of TANGENT are negated.
 *   source        mesh that the surface was made from
 *   vertex_point  out: per vertex, its point; in arena */
enum hatch_status hatch_surface_to_mesh(const struct hatch_surface *surface, const struct hatch_mesh *source,
                                        struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_mesh *mesh,
                                        uint32_t **vertex_point, struct hatch_err *err) HATCH_MUST_USE;

/* Numbers the points so that neighbours are close in memory; in the order of a file, cache misses would dominate the
 * time of traversals. Components stay consecutive and in their order, each starting at its first point.
 *   arena   for temporary memory
 *   order   out: per new number, the point; point_count entries
 *   number  out: per point, its new number; point_count entries */
enum hatch_status hatch_surface_order_points(const struct hatch_surface *surface, struct hatch_arena *arena,
                                             uint32_t *order, uint32_t *number, struct hatch_err *err) HATCH_MUST_USE;

/* Computes the normal of a face, on the side from which its corners are counter-clockwise; its length is twice the
 * area. */
void hatch_surface_face_normal(const struct hatch_surface *surface, uint32_t face, double normal[3]);

/* Computes a point's position in mesh units. */
void hatch_surface_position(const struct hatch_surface *surface, uint32_t point, double position[3]);

#endif
