/* Private to the surface: what its makers hand to one another. */
#ifndef HATCH_TOPO_SURFACE_WORK_H
#define HATCH_TOPO_SURFACE_WORK_H

#include "mesh/edges.h"
#include "surface/surface.h"

struct hatch_surface_work {
    const struct hatch_mesh *mesh;
    struct hatch_arena *arena, *scratch;
    /* Of the mesh's faces and corners. */
    uint32_t *point; /* per corner: the position */
    uint32_t position_count;
    uint8_t *dropped, *flipped; /* per face */
    uint32_t *component;        /* per face */
    uint32_t *fan;              /* per corner: what becomes a point */
    uint32_t fan_count, component_count;
    struct hatch_edges edges;
    uint32_t *partner; /* per side: what it is joined with, or HATCH_NO_EDGE */
};

/* Joins pages of the edges of more than two faces: two and two of them that run against each other as the
 * faces are turned, those of one component first, then the flattest. Returns how many pairs it made. */
uint32_t hatch_surface_join_pages(const struct hatch_surface_work *work);

/* Faces, corners, points and neighbours, component after component: all of the surface but border loops,
 * orientability and rings. */
enum hatch_status hatch_surface_arrange(const struct hatch_surface_work *work, struct hatch_surface *surface,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* Moves each component's points to its middle and scales them. On entry they are in the mesh's units. */
void hatch_surface_place(struct hatch_surface *surface);

/* Euler characteristic, border loops and orientability of each component. */
enum hatch_status hatch_surface_count(struct hatch_surface *surface, struct hatch_arena *scratch,
                                      struct hatch_err *err) HATCH_MUST_USE;

/* The rings of all points, of a surface that has all else. */
enum hatch_status hatch_surface_rings(struct hatch_surface *surface, struct hatch_arena *arena,
                                      struct hatch_arena *scratch, struct hatch_err *err) HATCH_MUST_USE;

/* Whether the faces of two sides of one edge look to different sides. */
static inline bool hatch_sides_contrary(const struct hatch_surface *surface, uint32_t side, uint32_t other)
{
    return surface->corners[side] == surface->corners[other];
}

#endif
