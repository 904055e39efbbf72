/* The front door for meshes of any origin: what a mesh is once its dirt is gone. Everything that
 * works on surfaces (curvature, direction fields, patches) works on this, and on nothing else.
 *
 * Points are positions: vertices at one place are one point. Where a mesh is not manifold it is
 * cut: the faces of an edge of more than two are taken apart, and those that continue one another
 * joined two and two (the edge is then several, some of them borders); a point whose faces do not
 * hang together becomes several. So two points may be joined by several edges, and stand more than
 * once in each other's rings. What is left are components, each a surface with or without borders,
 * closed or not, orientable or not, each moved to its middle and scaled to mean edge 1, in
 * doubles: an offset of 10⁶ or a scale of 10^±20 changes nothing. Faces and points of a component
 * follow one another. */
#ifndef HATCH_TOPO_SURFACE_H
#define HATCH_TOPO_SURFACE_H

#include "mesh/mesh.h"

#define HATCH_NO_SIDE UINT32_MAX

struct hatch_component {
    uint32_t first_point, point_count;
    uint32_t first_face, face_count;
    uint32_t border_loops;
    int32_t euler; /* points - edges + faces */
    bool orientable;
    double center[3]; /* of the box around it, in the mesh's units */
    double scale;     /* the mesh's units for one unit here: the mean edge; over 0 */
};

/* Side 3 * f + c of face f runs from its corner c to corner (c + 1) % 3, as in mesh/edges.h. */
struct hatch_surface {
    uint32_t point_count, face_count, component_count;
    struct hatch_component *components;
    double *points;     /* 3 a point: (position - center) / scale */
    uint32_t *corners;  /* 3 a face: points, counter-clockwise as far as neighbours can agree */
    uint32_t *opposite; /* per side: the side of the other face, or HATCH_NO_SIDE on a border. The two run
                           against each other, but the same way across a contrary edge (a Möbius strip has
                           some): then their faces look to different sides. */
    uint32_t *point_component;
    uint32_t *corner_vertex; /* 3 a face: the mesh's vertex there */
    uint32_t *face_source;   /* per face: the mesh's face */

    /* The ring of a point p, counter-clockwise seen from the side that its ring takes for outside:
     * neighbours ring_point[ring_first[p]] .. ring_point[ring_first[p + 1] - 1]. ring_face[i] lies between
     * neighbours i and i + 1 (cyclic); HATCH_NO_SIDE in the last place of an open ring, whose first and last
     * neighbours lie on the border. ring_flipped[i]: ring_face[i] is clockwise for this ring (a contrary edge
     * is near). A neighbour may stand in two rings of different outsides: ring_turned[i] is 1 when p's ring
     * and that of neighbour i look to different sides. All zero on orientable components. */
    uint32_t *ring_first; /* point_count + 1 */
    uint32_t *ring_point, *ring_face;
    uint8_t *ring_flipped, *ring_turned;
};

/* What was done, for one line of warning; 0 where nothing was. */
struct hatch_surface_notes {
    uint32_t welded;                              /* vertices that stood where another did */
    uint32_t degenerate, duplicate, unreferenced; /* faces, faces, vertices left out */
    uint32_t flipped;                             /* faces turned to agree with their neighbours */
    uint32_t edges_cut;                           /* of more than two faces */
    uint32_t points_split;                        /* where faces met that shared no edge */
    uint32_t contrary;                            /* edges whose faces cannot agree: components with but one side */
    uint32_t components;
};

/* Makes the surface of a mesh that passes hatch_mesh_check, which is called first. Points are
 * welded where positions are equal (-0 is 0). A face is degenerate when a corner repeats or it has
 * no area in doubles; (a,b,c) and (a,c,b) are duplicates. Time and memory are linear but for one
 * sort. The surface keeps no pointer into the mesh. HATCH_BAD_INPUT when no face is left. */
enum hatch_status hatch_surface_make(const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                     struct hatch_arena *scratch, struct hatch_surface *surface,
                                     struct hatch_surface_notes *notes, struct hatch_err *err) HATCH_MUST_USE;

/* The mesh again, as the surface sees it: its face f, corner c is the surface's, with every
 * attribute of the mesh. A vertex that serves several points is given once for each.
 * *vertex_point: the point of each new vertex. Flipped faces keep the normals that the file gave
 * their vertices, turned where all of a vertex's faces were. */
enum hatch_status hatch_surface_mesh(const struct hatch_surface *surface, const struct hatch_mesh *source,
                                     struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_mesh *mesh,
                                     uint32_t **vertex_point, struct hatch_err *err) HATCH_MUST_USE;

/* Numbers the points so that neighbours lie near one another in memory: files order them as they like, and walks then
 * wait for memory most of the time. Components stay whole, in their order, each from its first point on. order: the
 * points by their new numbers; number: the new number of each point. A little memory: arena. */
enum hatch_status hatch_surface_order(const struct hatch_surface *surface, struct hatch_arena *arena, uint32_t *order,
                                      uint32_t *number, struct hatch_err *err) HATCH_MUST_USE;

/* The normal of a face, counter-clockwise, as long as twice its area. */
void hatch_surface_normal(const struct hatch_surface *surface, uint32_t face, double normal[3]);

/* A point's position in the mesh's units. */
void hatch_surface_position(const struct hatch_surface *surface, uint32_t point, double position[3]);

#endif
