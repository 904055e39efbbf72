/* Parts of the finer strokes: what has been traced, by tiles of the ground. */
#ifndef HATCH_TRACE_STORE_H
#define HATCH_TRACE_STORE_H

#include "base/budget.h"
#include "trace/finer.h"
#include "trace/finer/depths.h"
#include "trace/work.h"

#define HATCH_STORE_DRIFTS 16u /* parts of an octave of thresholds */
#define HATCH_STORE_LEAST 0.5  /* least threshold of a level's strokes, as they are drawn, times its gap */

/* A straight part of a stroke on a face. */
struct hatch_store_piece {
    uint32_t face;       /* of the ground */
    float log_threshold; /* at `to`, in strokes per mesh unit */
    double from[2], to[2];
    double arc; /* length from the start of the stroke to `to`, in surface units */
};

struct hatch_store_line {
    uint32_t first, count; /* pieces */
    uint32_t level;
    uint32_t free_ends;  /* as in struct hatch_curve */
    float log_threshold; /* at its start */
    uint64_t id;
    double length; /* in surface units */
    float middle[3];
};

/* A square of the plane of a face. A face that is smaller than a tile is one. */
struct hatch_store_tile {
    uint32_t face;
    int64_t x, y;
};

/* The strokes of a level whose seeds are in some tiles. */
struct hatch_store_batch {
    struct hatch_store_batch *next;
    struct hatch_arena arena; /* holds the batch, too */
    uint32_t level;
    const struct hatch_component *component; /* whose strokes they are; NULL: given ones, of all components */
    uint64_t used;                           /* number of the last view that needed it */
    double area;                             /* of the windows in which it was traced, in square surface units */
    struct hatch_store_tile *tiles;          /* in order */
    struct hatch_store_line *lines;
    struct hatch_store_piece *pieces;
    uint32_t tile_count, line_count, line_capacity, piece_count, piece_capacity;
};

/* The strokes of a family. */
struct hatch_store {
    struct hatch_budget budget; /* of all its arenas */
    struct hatch_arena keep, scratch;
    struct hatch_trace_ground ground;
    struct hatch_trace_options options; /* its gap is that of level 0, in mesh units */
    struct hatch_pool *pool;            /* for the inside of a level */
    size_t keep_bytes;                  /* of batches that no view needs at present */
    uint32_t family, level_count;       /* level_count: levels that the mesh came with */
    float angle_rad;
    struct hatch_store_batch given;    /* the strokes of these levels; in keep */
    bool taken;                        /* given is complete */
    struct hatch_store_batch *batches; /* newest first */
    uint64_t view;                     /* number of the present view */
    uint32_t traced;                   /* strokes in this view */
    bool enough;                       /* the view's greatest number of levels suffices for it */
    double wanted;                     /* most strokes per mesh unit that the view wants anywhere */
    double ink, lack; /* ink that the view wants, and the part of it that cannot be drawn without finer strokes where
                         all strokes are alike; in pixels times strokes per pixel */
    double drawn;     /* strokes per mesh unit, above which the view draws none */
    double raised;    /* factor of the thresholds of traced strokes in the view */
    struct hatch_depths depths;       /* of the view */
    double drift[HATCH_STORE_DRIFTS]; /* what drawn thresholds differ from measured ones, as logarithms, by the part of
                                         an octave: those of each octave repeat */
};

/* Windows of what a view shows, in an array that grows. */
struct hatch_store_windows {
    struct hatch_trace_window *items;
    uint32_t count, capacity;
};

/* Returns the gap of a level, in surface units. */
double hatch_store_gap(const struct hatch_store *store, uint32_t level, const struct hatch_component *component);

/* Returns how many octaves a threshold is above the beginning of the last octave that the mesh came with completely. */
double hatch_store_octaves(const struct hatch_store *store, double log_threshold);

/* Appends a piece to the last line of a batch. */
enum hatch_status hatch_store_add_piece(struct hatch_store_batch *batch, struct hatch_arena *arena,
                                        const struct hatch_store_piece *piece, struct hatch_err *err) HATCH_MUST_USE;
enum hatch_status hatch_store_add_line(struct hatch_store_batch *batch, struct hatch_arena *arena,
                                       const struct hatch_store_line *line, struct hatch_err *err) HATCH_MUST_USE;

/* given.c: lays the curves of the family on the ground, and computes the drift. */
enum hatch_status hatch_store_take_curves(struct hatch_store *store, const struct hatch_finer_source *source,
                                          struct hatch_err *err) HATCH_MUST_USE;

/* tiles.c: traces the strokes that may come into the windows of a view.
 *   shown  [i]: windows on the component that need strokes of level level_count + i */
enum hatch_status hatch_store_trace(struct hatch_store *store, const struct hatch_component *component,
                                    const struct hatch_store_windows shown[HATCH_FINER_LEVELS_MAX],
                                    struct hatch_err *err) HATCH_MUST_USE;

/* refine.c: traces the strokes of a level in a region, and keeps those whose seeds are in the tiles of a batch.
 *   batch  with tiles */
enum hatch_status hatch_store_trace_region(struct hatch_store *store, const struct hatch_component *component,
                                           const struct hatch_trace_region *region, struct hatch_store_batch *batch,
                                           struct hatch_err *err) HATCH_MUST_USE;

/* Returns the tile that a place of a face is in.
 *   side  of tiles, in surface units */
struct hatch_store_tile hatch_store_tile_at(const struct hatch_trace_ground *ground, uint32_t face, const double at[2],
                                            double side);
void hatch_store_free_batch(struct hatch_store_batch *batch);
bool hatch_store_has_tile(const struct hatch_store_batch *batch, const struct hatch_store_tile *tile);
double hatch_store_tile_side(double gap);

/* sight.c: draws the depths of a view, and finds how many strokes it wants.
 *   arena  holds store->depths */
enum hatch_status hatch_store_look(struct hatch_store *store, const struct hatch_mesh *mesh,
                                   const struct hatch_finer_view *view, struct hatch_arena *arena,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Finds what the view shows, in the order of faces, after hatch_store_look. store->drawn and raised must be set.
 *   windows  out: [0]: of all faces; [i]: of places that need strokes of level level_count - 1 + i; in arena */
enum hatch_status hatch_store_find_windows(struct hatch_store *store, const struct hatch_mesh *mesh,
                                           const struct hatch_finer_view *view, struct hatch_arena *arena,
                                           struct hatch_store_windows windows[HATCH_FINER_LEVELS_MAX + 1],
                                           struct hatch_err *err) HATCH_MUST_USE;

/* The curves of a view under construction. */
struct hatch_store_sink {
    struct hatch_arena *arena, *scratch;
    double finest; /* gap of the finest level that the view needs */
    const struct hatch_mesh *mesh;
    struct hatch_finer_found *found;
    uint32_t set_capacity, curve_capacity, part_capacity, point_capacity;
};

/* parts.c: adds a set with the parts of a level's strokes that lie in a region. */
enum hatch_status hatch_store_add_parts(const struct hatch_store *store, uint32_t level,
                                        const struct hatch_trace_region *region, struct hatch_store_sink *sink,
                                        struct hatch_err *err) HATCH_MUST_USE;

#endif
