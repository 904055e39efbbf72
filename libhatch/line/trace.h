/* Traces the feature lines of a posed mesh in a view: silhouettes, and the posed creases and boundaries. */
#ifndef HATCH_LINE_TRACE_H
#define HATCH_LINE_TRACE_H

#include "line/mesh.h"
#include "view/view.h"

/* A posed mesh. */
struct hatch_line_shape {
    const struct hatch_line_mesh *lines;
    const float *positions, *normals; /* 3 per vertex of lines->mesh */
    double to_unit[16];               /* from positions to the unit scene; column-major */
    bool mirrored;                    /* to_unit reverses the winding of faces */
    bool double_sided;                /* faces are visible from behind, too */
};

/* The view, and the size of a pixel. */
struct hatch_line_eye {
    const struct hatch_view *view;
    double focal_px; /* pixels per unit of the unit scene: at distance 1 (perspective) or everywhere (orthographic) */
};

/* Line segments in the unit scene. */
struct hatch_line_trace {
    uint32_t node_count, segment_count;
    double *nodes;  /* positions: 3 per node */
    uint32_t *ends; /* 2 per segment: its nodes */
    float *slack; /* per segment: distance along the view axis by which a surface may be nearer without hiding it; below
                     0: the segment is not drawn */
    uint8_t *smooth; /* silhouettes only, per node: not 0: the surface is smooth there */
};

/* Traces the silhouette: across faces, where the interpolated normal is orthogonal to the view direction (Hertzmann &
 * Zorin 2000, §4.1); along edges with discontinuous normals, where one side faces the eye and the other does not. The
 * result consists of closed curves, except at boundaries of the mesh. Points on edges lie on the cubic that is
 * orthogonal to the normals at both ends (Vlachos et al. 2001), so that coarse meshes have smooth silhouettes. If
 * to_unit is singular there is no silhouette.
 *   trace  out: in arena */
enum hatch_status hatch_line_trace_silhouettes(const struct hatch_line_shape *shape, const struct hatch_line_eye *eye,
                                               struct hatch_arena *arena, struct hatch_arena *scratch,
                                               struct hatch_line_trace *trace, struct hatch_err *err) HATCH_MUST_USE;

/* Replaces the segments of a silhouette by curves through its smooth nodes: each segment at a visible turn becomes
 * four.
 *   trace   of hatch_line_trace_silhouettes; replaced by one in arena, with ends and smooth NULL
 *   chains  of trace; replaced by those of the new trace, in arena */
enum hatch_status hatch_line_refine(struct hatch_line_trace *trace, struct hatch_line_chains *chains,
                                    struct hatch_arena *arena, struct hatch_err *err) HATCH_MUST_USE;

/* Computes the mesh's features at the pose.
 *   trace  out: in arena; nodes and segments are numbered as in shape->lines->chains, ends and smooth are NULL */
enum hatch_status hatch_line_trace_features(const struct hatch_line_shape *shape, const struct hatch_line_eye *eye,
                                            struct hatch_arena *arena, struct hatch_line_trace *trace,
                                            struct hatch_err *err) HATCH_MUST_USE;

/* Returns the distance of a point from the eye, along the view axis. */
double hatch_line_depth(const struct hatch_view *view, const double point[3]);

/* Returns the size of a pixel at a point, in units of the unit scene. */
double hatch_line_pixel(const struct hatch_line_eye *eye, const double point[3]);

#endif
