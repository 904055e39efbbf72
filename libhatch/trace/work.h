/* Parts of the tracer: the pieces of strokes on the faces, and the rounds of a level. */
#ifndef HATCH_TRACE_WORK_H
#define HATCH_TRACE_WORK_H

#include <math.h>

#include "trace/region.h"
#include "curve/reserve.h"
#include "trace/trace.h"

#define HATCH_TRACE_NONE UINT32_MAX
#define HATCH_TRACE_STEP 0.5       /* of the gap: a round of growth, and the way between two measured gaps */
#define HATCH_TRACE_REACH 1.5      /* of the gap: how far gaps are measured to each side */
#define HATCH_TRACE_LEGS_MAX 4096u /* of a short walk: longer ones get nowhere */
#define HATCH_TRACE_WINDING 1e-3   /* of the gap: shorter ways around are not told from rounding */

/* A straight part of a stroke on a face. The pieces of each half of a stroke are a list, from the seed to the end. */
struct hatch_trace_piece {
    float from[2], to[2]; /* from the face's origin (hatch_trace_origin_of); the end `to` is farther from the seed */
    uint32_t face;
    uint32_t half;         /* 2 * stroke, plus 1 for the half behind the seed */
    float arc;             /* length along the stroke from the seed to `to`, at least 0 */
    uint32_t round;        /* in which it was drawn */
    uint32_t next;         /* of this half, or HATCH_TRACE_NONE */
    uint32_t next_in_cell; /* the one that was drawn before it in its cell, or HATCH_TRACE_NONE */
};

struct hatch_trace_stroke {
    uint64_t id;
    struct hatch_trace_place seed;
    uint32_t level;
    bool given;                      /* traced before: it has no half behind its seed, and no stop there */
    int64_t first_number;            /* number of the place that lengths are measured from; 0 unless given */
    double first_arc;                /* length at which it begins; 0 unless given */
    bool growing[2], bound[2];       /* bound: that half ends where the ground or its direction does */
    double length[2], length_max[2]; /* of its halves, in surface units */
    struct hatch_trace_place end[2]; /* the heading leads on */
    uint32_t first[2], last[2];      /* pieces of its halves, or HATCH_TRACE_NONE */
    uint32_t first_threshold;        /* of its thresholds, at the stops of its own level */
    uint32_t threshold_count[2];     /* of its halves; the seed's counts for the front */
};

/* A point of a stroke. Each stroke has one at its seed, and others every HATCH_TRACE_STEP gaps of the level. */
struct hatch_trace_stop {
    uint32_t face, stroke;
    float x, y, heading[2]; /* from the face's origin; away from the seed; at the seed, forward */
    float arc;              /* from the seed, negative behind it */
    int32_t number;         /* from the seed, negative behind it */
};

/* The cells in which pieces are found: each face, or its window, is cut into cells of a few gaps. A piece is in the
 * cell of its middle. */
struct hatch_trace_cells {
    uint32_t *first;  /* per face of the component or window of the region, and the end of the last: its first cell */
    uint16_t *across; /* per face or window: cells along x */
    uint32_t *heads;  /* per cell: its last piece, or HATCH_TRACE_NONE */
    uint32_t count;   /* cells */
};

/* The memory of an array that grows: it moves from one arena to the other, so that its old memory can be given back. */
struct hatch_trace_room {
    struct hatch_arena arenas[2];
    uint32_t used; /* the arena that holds the array */
    void *spare;   /* an array in the other one */
    uint32_t spare_capacity;
};

/* The strokes of one family on a component while levels are added. */
struct hatch_tracer {
    const struct hatch_trace_options *options;
    uint32_t family;
    uint64_t seed; /* of the family */
    struct hatch_trace_ground ground;
    const struct hatch_component *component;
    const struct hatch_trace_region *region; /* of the component, where strokes are traced; NULL: everywhere */
    double quantum; /* of coordinates in a region, and of its windows' corners: a power of two, so that the strokes do
                       not depend on the windows; 0 without a region */
    struct hatch_arena *keep, *scratch; /* for its arrays; for temporary ones, rewound after each step of a level */
    struct hatch_pool *pool;
    uint32_t level, round;
    double gap, leg_max; /* wanted gap of the level, and the greatest length of a piece, in surface units */
    struct hatch_trace_cells cells;
    struct hatch_trace_room *piece_room, *stop_room;
    struct hatch_trace_piece *pieces;
    uint32_t piece_count, piece_capacity;
    struct hatch_trace_stroke *strokes;
    uint32_t stroke_count, stroke_capacity;
    struct hatch_trace_stop *stops; /* of the level, by stroke, each from its back to its front */
    uint32_t stop_count, stop_capacity;
    float *thresholds; /* in strokes per surface unit */
    uint32_t threshold_count, threshold_capacity;
};

/* A place where a stroke may begin. */
struct hatch_trace_seed {
    struct hatch_trace_place place;
    double at[3];
    float heading[3], normal[3];
    uint64_t id;
    bool valid;
};

/* Returns the place in the plane of a face from which pieces and stops are measured: the corner of its window. */
static inline const double *hatch_trace_origin_of(const struct hatch_tracer *tracer, uint32_t face)
{
    static const double corner[2] = {0, 0};
    return tracer->region ? tracer->region->windows[tracer->region->of_face[face]].low : corner;
}

/* Returns a coordinate in the plane of a face as pieces have it.
 *   origin  of the face */
static inline float hatch_trace_local(const struct hatch_tracer *tracer, double coordinate, double origin)
{
    double quantum = tracer->quantum;
    return (float)((quantum > 0 ? rint(coordinate / quantum) * quantum : coordinate) - origin);
}

/* pieces.c */

/* Sorts the pieces into cells for the gap of the level. */
enum hatch_status hatch_trace_sort(struct hatch_tracer *tracer, struct hatch_err *err) HATCH_MUST_USE;

/* Moves the pieces of a cell, and the cells of neighbouring faces, next to one another in memory. */
enum hatch_status hatch_trace_gather(struct hatch_tracer *tracer, struct hatch_err *err) HATCH_MUST_USE;

/* Adds a stroke without pieces.
 *   seed  its heading is along the stroke */
enum hatch_status hatch_trace_add_stroke(struct hatch_tracer *tracer, const struct hatch_trace_seed *seed,
                                         struct hatch_err *err) HATCH_MUST_USE;

/* Adds a piece to the end of half a stroke. */
enum hatch_status hatch_trace_add_piece(struct hatch_tracer *tracer, uint32_t half, const struct hatch_trace_leg *leg,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* The point of a stroke from which a way is looked along. */
struct hatch_trace_origin {
    uint32_t stroke; /* HATCH_TRACE_NONE: of no stroke */
    double arc;      /* from the seed, negative behind it: pieces nearby on the same stroke do not count,
                        unless they are other windings, which run beside it */
    bool growing;    /* strokes that run beside it, drew in the round before and have a lower id do not count: of two
                        strokes that converge evenly, only one is to end */
    bool passes;     /* strokes that run against it and end nearby do not count: ends that meet overlap a little */
    double turn;   /* sine of the angle from the stroke's heading to the way: 0: along it, 1: to its left, -1: right */
    bool backward; /* that heading leads to the back of the stroke */
    double walked; /* from the point to where the way begins */
};

/* Looks along a way within a face. Returns the length to the first stroke that crosses it, or HUGE_VAL.
 *   leg  of the way */
double hatch_trace_look(const struct hatch_tracer *tracer, const struct hatch_trace_leg *leg,
                        const struct hatch_trace_origin *origin);

/* Walks straight on until a stroke or the reach is met.
 *   place   in: the heading leads the way; out: at the reach
 *   border  out: where the ground ended, the sine of the angle between its border and the way; else 0
 * Returns the length to the stroke or to the end of the ground; reach if there is neither. */
double hatch_trace_cast(const struct hatch_tracer *tracer, struct hatch_trace_place *place, double reach,
                        const struct hatch_trace_origin *origin, double *border);

/* The gaps to both sides of a place, at most HATCH_TRACE_REACH gaps. A border beside strokes counts as if there were a
 * stroke as far behind it; one that strokes run into, as if there were one a gap away. */
struct hatch_trace_gaps {
    double left, right;
};

/* Measures the gaps beside a place, whose heading is along the strokes. */
struct hatch_trace_gaps hatch_trace_gaps_at(const struct hatch_tracer *tracer, const struct hatch_trace_place *place,
                                            const struct hatch_trace_origin *origin);

/* room.c */

/* Makes a room that is empty, whose memory is taken from a budget. */
void hatch_trace_room_init(struct hatch_trace_room *room, struct hatch_budget *budget);

/* Gives all memory back; the room is empty and usable again. */
void hatch_trace_room_free(struct hatch_trace_room *room);

/* Does the same as hatch_curve_reserve for an array that is alone in a room. */
enum hatch_status hatch_trace_room_reserve(struct hatch_trace_room *room, void *array, size_t size, uint32_t count,
                                           uint32_t *capacity, struct hatch_err *err) HATCH_MUST_USE;

/* Makes a second array in a room, of the same capacity, which becomes that of the room; the first keeps its contents
 * until the next call.
 *   now    the first
 *   array  out: the second, unset */
enum hatch_status hatch_trace_room_swap(struct hatch_trace_room *room, void *now, size_t size, uint32_t capacity,
                                        void **array, struct hatch_err *err) HATCH_MUST_USE;

/* stops.c: adds the stops of strokes from `first` on. */
enum hatch_status hatch_trace_add_stops(struct hatch_tracer *tracer, uint32_t first,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* Returns the place of a stop, whose heading is forward. */
struct hatch_trace_place hatch_trace_stop_place(const struct hatch_tracer *tracer, const struct hatch_trace_stop *stop);

/* make.c: adds the strokes of a level. */
enum hatch_status hatch_trace_add_level(struct hatch_tracer *tracer, uint32_t level,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* seeds.c: finds places for new strokes and adds those strokes.
 *   phase  0 .. HATCH_TRACE_PHASES - 1 */
#define HATCH_TRACE_PHASES 5u
enum hatch_status hatch_trace_add_seeds(struct hatch_tracer *tracer, uint32_t phase,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* thin.c: of seeds that are too near to one another, keeps those of the highest ids. */
enum hatch_status hatch_trace_thin(const struct hatch_tracer *tracer, struct hatch_trace_seed *seeds, uint32_t count,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* grow.c: lets all strokes grow that can. */
enum hatch_status hatch_trace_grow(struct hatch_tracer *tracer, struct hatch_err *err) HATCH_MUST_USE;

/* thresholds.c: computes those of the strokes of the level. */
enum hatch_status hatch_trace_find_thresholds(struct hatch_tracer *tracer, struct hatch_err *err) HATCH_MUST_USE;

/* Returns the logarithm of the threshold at a length from a stroke's seed, negative behind it, by interpolation. */
double hatch_trace_threshold_at(const struct hatch_tracer *tracer, const struct hatch_trace_stroke *stroke, double arc);

/* collect: a place on a stroke where two pieces meet, or where it begins or ends. */
struct hatch_trace_joint {
    uint32_t face;
    double x, y, at[3]; /* on the face, and in space */
    float normal[3];    /* of the face */
    double arc;         /* along the stroke */
    double log_threshold;
};

/* Drops joints that a straight line passes closely enough; keeps the others in front of the list.
 *   tolerance  greatest distance of a joint from the line beside it, in the unit of `at`; above or under it, where it
 *              is hardly seen, the distance may be twice as large
 *
 * Returns their number. */
uint32_t hatch_trace_simplify(struct hatch_trace_joint *joints, uint32_t count, double tolerance);

/* Converts a joint to a point of the mesh, whose faces may list their corners in another order.
 *   threshold  of the point */
void hatch_trace_fill_point(const struct hatch_trace_ground *ground, const struct hatch_mesh *mesh,
                            const struct hatch_trace_joint *joint, double threshold, struct hatch_curve_point *point);

/* Finds out whether a point lies on a narrow face: between two ends of the ground, each a border or a hard edge, that
 * are near to one another for some length. Sets its members `width` and `across`.
 *   options  with the angles of all families; NAN: there is none of that number
 *   family   of the ground
 *   gap      of the point's level, in surface units
 *   scale    mesh units in a surface unit */
void hatch_trace_find_narrow(const struct hatch_trace_ground *ground, const struct hatch_trace_options *options,
                             uint32_t family, const struct hatch_trace_joint *joint, double gap, double scale,
                             struct hatch_curve_point *point);

/* collect/strokes.c: the strokes that are traced so far, as curves of a mesh. */
struct hatch_trace_sink {
    const struct hatch_mesh *mesh;
    struct hatch_arena *arena;
    struct hatch_curves curves; /* unsorted; without sets */
    uint32_t capacity, point_capacity, level_capacity;
    uint8_t *levels; /* per curve */
};
enum hatch_status hatch_trace_collect(const struct hatch_tracer *tracer, struct hatch_trace_sink *sink,
                                      struct hatch_err *err) HATCH_MUST_USE;

#endif
