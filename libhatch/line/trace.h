/* Finds the lines of a posed mesh as they are seen from a place: silhouettes anew for each view,
 * creases and boundaries where they have moved to. */
#ifndef HATCH_LINE_TRACE_H
#define HATCH_LINE_TRACE_H

#include "line/mesh.h"
#include "view/view.h"

/* A mesh as it stands in a frame. */
struct hatch_line_shape {
    const struct hatch_line_mesh *lines;
    const float *positions, *normals; /* 3 per vertex of lines->mesh */
    double to_unit[16];               /* positions to the unit scene; column-major */
    bool mirrored;                    /* to_unit turns faces round */
    bool double_sided;                /* faces are drawn from behind, too */
};

/* Where one looks from, and how large a pixel is. */
struct hatch_line_eye {
    const struct hatch_view *view;
    double focal_px; /* pixels that a unit has at distance 1; of an orthographic view, everywhere */
};

/* Segments in the unit scene. slack: how much nearer than the segment, in units along the view, a
 * surface may seem to be and not hide it; below 0: it is not to be drawn. */
struct hatch_line_trace {
    uint32_t node_count, segment_count;
    double *nodes;   /* 3 per node */
    uint32_t *ends;  /* 2 per segment */
    float *slack;    /* per segment */
    uint8_t *smooth; /* per node of a silhouette: not 0: the surface is smooth there */
};

/* The silhouette: where the interpolated normal is at a right angle to the view (Hertzmann & Zorin
 * 2000, section 4.1), a line across each face on which that changes sign; and along edges where
 * normals jump, where one side is seen and the other is not. Together these are closed curves but for
 * the mesh's boundaries. Points between vertices lie on the cubic through both normals (Vlachos et al.
 * 2001), so that coarse meshes have smooth silhouettes. A shape that to_unit flattens has none. */
enum hatch_status hatch_line_trace_silhouettes(const struct hatch_line_shape *shape, const struct hatch_line_eye *eye,
                                               struct hatch_arena *arena, struct hatch_arena *scratch,
                                               struct hatch_line_trace *trace, struct hatch_err *err) HATCH_MUST_USE;

/* Puts curves through the smooth nodes of a silhouette's chains in place of corners: each segment beside
 * a visible turn becomes four. Both are replaced by new ones in the arena, without ends and smooth. */
enum hatch_status hatch_line_refine(struct hatch_line_trace *trace, struct hatch_line_chains *chains,
                                    struct hatch_arena *arena, struct hatch_err *err) HATCH_MUST_USE;

/* The mesh's features: nodes and segments have their numbers in shape->lines->chains. */
enum hatch_status hatch_line_trace_features(const struct hatch_line_shape *shape, const struct hatch_line_eye *eye,
                                            struct hatch_arena *arena, struct hatch_line_trace *trace,
                                            struct hatch_err *err) HATCH_MUST_USE;

/* Distance along the view. */
double hatch_line_depth(const struct hatch_view *view, const double point[3]);

/* How large a pixel is at a point. */
double hatch_line_pixel(const struct hatch_line_eye *eye, const double point[3]);

#endif
