/* The steps of hatch_surface_make. Private to surface. */
#ifndef HATCH_SURFACE_WORK_H
#define HATCH_SURFACE_WORK_H

#include "mesh/edges.h"
#include "surface/surface.h"

/* Arrays are indexed by the faces, corners and sides of the mesh. */
struct hatch_surface_work {
    const struct hatch_mesh *mesh;
    struct hatch_arena *arena, *scratch;
    bool planes;     /* whether planes are found */
    uint32_t *point; /* per corner: number of its position */
    uint32_t position_count;
    uint8_t *dropped, *flipped; /* per face: 1 if it is left out; 1 if it is reversed */
    uint32_t *component;        /* per face: its component */
    uint32_t *fan;              /* per corner: its fan (mesh/fans.h); each fan of faces that are kept becomes a point */
    uint32_t fan_count, component_count;
    struct hatch_edges edges;
    uint32_t *partner; /* per side: the side it is joined with, or HATCH_NO_EDGE */
    uint32_t *body;    /* per component: of hatch_component; NULL: its own number */
    uint32_t plane_count;
    uint32_t *plane;         /* per face: its plane, or HATCH_NO_SIDE */
    double *plane_direction; /* 3 per plane */
};

/* At each edge with more than two faces, joins faces two by two. Only faces with consistent orientations form a pair;
 * pairs within one component come before pairs across components, and among these the flattest pair comes first. Edges
 * with more than 8 faces stay cut. Returns the number of pairs. */
uint32_t hatch_surface_stitch_edges(const struct hatch_surface_work *work);

/* Finds planes and their directions, cuts the creases around them and numbers the components anew. */
enum hatch_status hatch_surface_find_planes(struct hatch_surface_work *work, struct hatch_err *err) HATCH_MUST_USE;

/* Builds the faces, corners, points, opposite sides and planes, component by component, with positions in mesh units.
 * Leaves border loops, orientability and rings unset. */
enum hatch_status hatch_surface_build_components(const struct hatch_surface_work *work, struct hatch_surface *surface,
                                                 struct hatch_err *err) HATCH_MUST_USE;

/* Centres and scales the points of each component. */
void hatch_surface_normalize(struct hatch_surface *surface);

/* Sets the Euler characteristic, border loops and orientability of each component. */
enum hatch_status hatch_surface_find_topology(struct hatch_surface *surface, struct hatch_arena *scratch,
                                              struct hatch_err *err) HATCH_MUST_USE;

/* Makes the rings of all points of an otherwise complete surface. */
enum hatch_status hatch_surface_make_rings(struct hatch_surface *surface, struct hatch_arena *arena,
                                           struct hatch_arena *scratch, struct hatch_err *err) HATCH_MUST_USE;

/* Returns whether the edge of two opposite sides is contrary. */
static inline bool hatch_surface_is_contrary(const struct hatch_surface *surface, uint32_t side, uint32_t other)
{
    return surface->corners[side] == surface->corners[other];
}

#endif
