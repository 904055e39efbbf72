/* A part of the ground: a window on each of some faces. Finer strokes are traced on regions, however large the faces
 * that they lie on are. */
#ifndef HATCH_TRACE_REGION_H
#define HATCH_TRACE_REGION_H

#include "trace/ground.h"

/* A rectangle in the plane of a face. */
struct hatch_trace_window {
    uint32_t face;
    double low[2], high[2];
};

struct hatch_trace_region {
    struct hatch_trace_window *windows; /* by face, one for each */
    uint32_t count;
    uint32_t *of_face; /* per face of the ground: its window, or HATCH_NO_SIDE */
};

/* Returns the rectangle around a face. */
struct hatch_trace_window hatch_trace_window_of(const struct hatch_trace_ground *ground, uint32_t face);

/* Cuts a window to another one of the same face. Returns whether anything is left. */
bool hatch_trace_window_cut(struct hatch_trace_window *window, const struct hatch_trace_window *by);

/* Returns whether a place is in a region. */
bool hatch_trace_region_has(const struct hatch_trace_region *region, const struct hatch_trace_place *place);

#define HATCH_TRACE_DETOUR 1.4

/* Makes the region of all places within a distance of some windows, and of some more.
 *   windows   in any order, also several of a face
 *   distance  in surface units, at least 0, along ways from side to side of the faces, which are up to
 *             HATCH_TRACE_DETOUR times as long as straight ones
 *   region    out: in arena */
enum hatch_status hatch_trace_region_around(const struct hatch_trace_ground *ground,
                                            const struct hatch_trace_window *windows, uint32_t count, double distance,
                                            struct hatch_arena *arena, struct hatch_arena *scratch,
                                            struct hatch_trace_region *region, struct hatch_err *err) HATCH_MUST_USE;

/* Part of a line from one place of a face to another that lies in its window: shares of the line.
 * Returns false if there is none. */
bool hatch_trace_window_clip(const struct hatch_trace_window *window, const double from[2], const double to[2],
                             double share[2]);

#endif
