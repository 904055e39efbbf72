/* The faces of a posed scene as they hide lines: projected into the picture without rounding to pixels, and listed by
 * the cells of a grid. */
#ifndef HATCH_VECTOR_OCCLUDERS_H
#define HATCH_VECTOR_OCCLUDERS_H

#include "scene/unit_scene.h"
#include "view/view.h"
#include "vector/cells.h"

/* Depth of the near plane where it is automatic, and of points behind the eye */
#define HATCH_OCCLUDERS_DEPTH_LEAST 1e-9

/* Positions are in pixels from the picture's lower left corner. Nearness is linear over a projected face: 1 / depth, or
 * -depth in an orthographic view, where depth is the distance along the view axis. */

/* A face that hides what is behind it. */
struct hatch_occluder {
    double sides[3][3]; /* a x + b y + c: distance to the line through a side, in pixels; inside, all are positive */
    double nearness[3]; /* a x + b y + c: nearness of the face's plane */
    double nearest;     /* largest nearness of the face */
    uint32_t face;      /* as in hatch_occluders_face */
};

struct hatch_occluders {
    struct hatch_view view;
    double width_px, height_px;
    double nearest;       /* nearness of the near plane */
    double focal_px[2];   /* pixels per unit at distance 1, along x and y */
    uint32_t *first_face; /* per item: number of its first face; then the number of all faces */
    uint32_t *corners;    /* 3 per face: vertices */
    int8_t *facing; /* per face: 1: its front is visible, -1: its back, 0: it is seen edge-on, or it is no occluder */
    double *points; /* 3 per vertex: x * w, y * w, and depth; w is depth, or 1 in an orthographic view */
    uint32_t count;
    struct hatch_occluder *at;       /* the nearest first */
    struct hatch_vector_cells cells; /* over the picture */
    uint32_t *first;                 /* per cell, row by row: its range in `listed`; then the end of the last range */
    uint32_t *listed;                /* occluders, the nearest of a cell first */
    uint32_t most;                   /* largest number of occluders in a cell */
};

/* Returns the number of a face among the faces of all items.
 *   item  index in the unit scene
 *   face  of the item's surface */
static inline uint32_t hatch_occluders_face(const struct hatch_occluders *occluders, uint32_t item, uint32_t face)
{
    return occluders->first_face[item] + face;
}

/* Returns the value of a linear function of an occluder at a place of the picture. */
static inline double hatch_occluder_value(const double f[3], const double at_px[2])
{
    return f[0] * at_px[0] + f[1] * at_px[1] + f[2];
}

/* Projects a point of the unit scene: x * w, y * w and depth, as in `points`. */
void hatch_occluders_project(const struct hatch_occluders *occluders, const double point[3], double out[3]);

/* Returns the nearness of a point at a depth; that of the eye, or a point behind it, is very large. */
double hatch_occluders_nearness(const struct hatch_occluders *occluders, double depth);

/* Returns whether two faces have a corner at the same place. */
bool hatch_occluders_touch(const struct hatch_occluders *occluders, uint32_t a, uint32_t b);

#endif
