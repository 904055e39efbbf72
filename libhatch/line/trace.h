/* Traces the feature lines of a posed mesh in a view: silhouettes, and the posed creases and boundaries. */
#ifndef HATCH_LINE_TRACE_H
#define HATCH_LINE_TRACE_H

#include "line/mesh.h"
#include "view/view.h"

/* A posed mesh. */
struct hatch_line_shape {
    const struct hatch_line_mesh *lines;
    const float *positions;      /* 3 per vertex of lines->mesh */
    double to_unit[16];          /* from positions to the unit scene; column-major */
    bool mirrored;               /* to_unit reverses the winding of faces */
    const uint8_t *double_sided; /* per face: not 0: visible from behind, too */
};

/* The view, and the size of a pixel. */
struct hatch_line_eye {
    const struct hatch_view *view;
    double focal_px; /* pixels per unit of the unit scene: at distance 1 (perspective) or everywhere (orthographic) */
};

/* Line segments in the unit scene. */
struct hatch_line_trace {
    uint32_t node_count, segment_count;
    double *nodes;   /* positions: 3 per node */
    uint32_t *ends;  /* 2 per segment: its nodes */
    float *slack_px; /* per segment: distance along the view axis by which a surface may be nearer without hiding it, in
                        the size that a pixel has at each of its places; below 0: the segment is not drawn */
    int8_t *surface; /* silhouettes only, per segment: the side of it on which the picture shows its surface, from its
                        first end to its second: 1: left, -1: right */
    uint8_t *fixed;  /* silhouettes only, per node: not 0: a crease of the silhouette ends there */
};

/* Traces the silhouette of the faces as they are drawn: the edges all of whose faces lie on one side in the picture. On
 * a closed surface it consists of closed curves, of which parts hide behind the surface close by. The winding of faces
 * matters only where they are not double-sided: an edge needs a face that is visible. If to_unit is singular there is
 * no silhouette.
 *   trace  out: in arena */
enum hatch_status hatch_line_trace_silhouettes(const struct hatch_line_shape *shape, const struct hatch_line_eye *eye,
                                               struct hatch_arena *arena, struct hatch_arena *scratch,
                                               struct hatch_line_trace *trace, struct hatch_err *err) HATCH_MUST_USE;

/* Makes silhouettes smooth where their edges are short, except at creases, without leaving the outline of the faces by
 * more than a pixel: removes bends from node to node, then replaces segments at slight turns by curves, four segments
 * each.
 *   trace   of hatch_line_trace_silhouettes; replaced by one in arena, with ends and fixed NULL, and with the surface
 *           of each segment in the direction of its chain
 *   chains  of trace; replaced by those of the new trace, in arena */
enum hatch_status hatch_line_refine(const struct hatch_line_eye *eye, struct hatch_line_trace *trace,
                                    struct hatch_line_chains *chains, struct hatch_arena *arena,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Computes the mesh's features at the pose.
 *   trace  out: in arena; nodes and segments are numbered as in shape->lines->chains, ends, surface and fixed are NULL
 */
enum hatch_status hatch_line_trace_features(const struct hatch_line_shape *shape, const struct hatch_line_eye *eye,
                                            struct hatch_arena *arena, struct hatch_line_trace *trace,
                                            struct hatch_err *err) HATCH_MUST_USE;

/* Computes the position of a vertex of lines->mesh in the unit scene. */
void hatch_line_place(const struct hatch_line_shape *shape, uint32_t vertex, double out[3]);

/* Returns the distance of a point from the eye, along the view axis. */
double hatch_line_depth(const struct hatch_view *view, const double point[3]);

/* Returns the size of a pixel at a point, in units of the unit scene. */
double hatch_line_pixel(const struct hatch_line_eye *eye, const double point[3]);

#endif
