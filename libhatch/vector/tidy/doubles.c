#include <math.h>
#include <stdlib.h>

#include "math/range.h"
#include "vector/runs.h"
#include "vector/tidy/segments.h"
#include "vector/tidy/tidy.h"

#define SINE_MOST 0.35 /* of the angle between lines that count as doubles: 20 degrees */

/* Lengths, in reaches. */
#define SPECK_REACHES 4.0       /* what remains between two parts that are cut out, or beside one, is so long */
#define GAP_REACHES 3.0         /* parts that are cut out between two that remain are so long */
#define APART_REACHES 8.0       /* parts of one path are doubles if they are so far apart along it: bends stay */
#define AGAIN_REACHES 2.0       /* what is cut out of a path that doubles itself has something that remains so near */
#define AGAIN_SPECK_REACHES 1.0 /* or is shorter */

#define NONE UINT32_MAX

/* A path, its layer, and how long it is. */
struct rank {
    double length;
    uint32_t path, layer;
};

/* A segment that others must not run along. */
struct segment {
    double ends[2][2];
    double begin;  /* length of its path up to its first end */
    uint32_t path; /* that it is a part of; NONE: one drawn before */
    bool dropped;  /* it does not remain, after all */
};

/* How a piece of a segment lies beside segments that remain. */
enum beside {
    BESIDE_DOUBLE, /* along another path, or along a part of its own that is far along the path */
    BESIDE_BEND,   /* along a part of its own path that is near along it: the path turns back */
    BESIDE_NONE
};

/* A piece of a path. */
struct piece {
    double begin, end; /* in 0 .. 1 of the segment */
    uint32_t segment;
    enum beside beside;
    bool cut_out;
};

/* A part of the segment searched for. */
struct part {
    double begin, end;
    enum beside beside; /* not BESIDE_NONE */
};

struct work {
    const struct hatch_vector_paths *paths;
    double reach;
    struct hatch_segments near;   /* segments of the paths that remain, and of those drawn before */
    struct hatch_buffer segments; /* these, in the order of their numbers */
    uint32_t near_count;
    struct hatch_vector_runs runs;
    struct hatch_buffer parts; /* of the segment searched for, beside others */
    uint32_t part_count;
    struct hatch_buffer pieces; /* of a path */
    uint32_t piece_count;
    struct segment sought;  /* the segment that is searched for */
    uint32_t sought_number; /* of it in its path */
    double round;           /* length of its path if that is closed, or INFINITY */
    bool own;               /* whether parts of its own path are doubles however near they are along it */
    bool doubles_itself;    /* the path has parts that run along others of it */
    double aside;           /* largest distance of doubles */
    struct hatch_vector_builder built;
};

static int compare_ranks(const void *a, const void *b)
{
    const struct rank *x = a, *y = b;
    if (x->layer != y->layer)
        return x->layer > y->layer ? 1 : -1;
    if (x->length > y->length || x->length < y->length)
        return x->length > y->length ? -1 : 1;
    return (x->path > y->path) - (x->path < y->path);
}

/* Returns how far apart a part of the segment searched for is, at most, along its path from what it runs along, an
 * earlier segment of the path.
 *   along  length of that one up to the places beside both ends of the segment searched for */
static double way_between(const struct work *w, const struct segment *by, double length, const double along[2],
                          const double part[2])
{
    double ways[2];
    for (int i = 0; i < 2; i++)
        ways[i] = w->sought.begin + part[i] * length - (by->begin + along[0] + part[i] * (along[1] - along[0]));
    const double low = fmin(ways[0], ways[1]), high = fmax(ways[0], ways[1]);
    const double farthest = fmin(fmax(0.5 * w->round, low), high); /* half of a closed path is as far as it can be */
    return fmin(farthest, w->round - farthest);
}

/* Finds the part of the segment searched for that runs along another, and how. */
static enum beside runs_along(const struct work *w, const struct segment *by, double part[2])
{
    const double *a = w->sought.ends[0], *b = w->sought.ends[1], *c = by->ends[0], *d = by->ends[1];
    double length = hatch_vector_distance(a, b), other = hatch_vector_distance(c, d), across[2], along[2];
    const double *ends[2] = {a, b};
    if (!(length > 0 && other > 0))
        return BESIDE_NONE;
    const double way[2] = {(d[0] - c[0]) / other, (d[1] - c[1]) / other};
    for (int i = 0; i < 2; i++) {
        double x = ends[i][0] - c[0], y = ends[i][1] - c[1];
        along[i] = x * way[0] + y * way[1];
        across[i] = y * way[0] - x * way[1];
    }
    part[0] = 0;
    part[1] = 1;
    if (!(fabs(across[1] - across[0]) <= SINE_MOST * length &&
          hatch_range_keep(w->aside - across[0], w->aside - across[1], &part[0], &part[1]) &&
          hatch_range_keep(w->aside + across[0], w->aside + across[1], &part[0], &part[1]) &&
          hatch_range_keep(along[0], along[1], &part[0], &part[1]) &&
          hatch_range_keep(other - along[0], other - along[1], &part[0], &part[1])))
        return BESIDE_NONE;
    if (w->own || by->path != w->sought.path || way_between(w, by, length, along, part) >= APART_REACHES * w->reach)
        return BESIDE_DOUBLE;
    return along[1] < along[0] ? BESIDE_BEND : BESIDE_NONE;
}

/* Sorts doubles before bends, and either by their beginnings. */
static int compare_parts(const void *a, const void *b)
{
    const struct part *x = a, *y = b;
    if (x->beside != y->beside)
        return x->beside > y->beside ? 1 : -1;
    return x->begin > y->begin ? 1 : x->begin < y->begin ? -1 : (x->end > y->end) - (x->end < y->end);
}

static struct segment *segment_at(const struct work *w, uint32_t i)
{
    return (struct segment *)(void *)w->segments.data + i;
}

static struct piece *piece_at(const struct work *w, uint32_t i)
{
    return (struct piece *)(void *)w->pieces.data + i;
}

/* Notes the part of the segment searched for that runs along one that remains. */
static enum hatch_status note(void *context, uint32_t segment, struct hatch_err *err)
{
    struct work *w = context;
    const struct segment *by = segment_at(w, segment);
    double ends[2];
    enum beside beside = by->dropped ? BESIDE_NONE : runs_along(w, by, ends);
    if (beside == BESIDE_NONE)
        return HATCH_OK;
    w->doubles_itself = w->doubles_itself || (beside == BESIDE_DOUBLE && by->path == w->sought.path);
    w->part_count++;
    return hatch_buffer_add(&w->parts, &(struct part){ends[0], ends[1], beside}, sizeof(struct part), err);
}

/* Finds the parts of the segment searched for that run along segments that remain. */
static enum hatch_status find_parts(struct work *w, struct hatch_err *err)
{
    w->parts.size = 0;
    w->part_count = 0;
    HATCH_TRY(hatch_segments_find(&w->near, w->sought.ends[0], w->sought.ends[1], w->aside, note, w, err));
    if (w->part_count)
        qsort(w->parts.data, w->part_count, sizeof(struct part), compare_parts);
    return HATCH_OK;
}

/* Adds a segment to those that others must not run along. */
static enum hatch_status insert(struct work *w, const struct segment *segment, struct hatch_err *err)
{
    HATCH_TRY(hatch_buffer_add(&w->segments, segment, sizeof *segment, err));
    return hatch_segments_insert(&w->near, w->near_count++, segment->ends[0], segment->ends[1], err);
}

/* Adds a piece of the segment searched for to those of the path. One beside no other is inserted. */
static enum hatch_status add_piece(struct work *w, double begin, double end, enum beside beside, struct hatch_err *err)
{
    const double *a = w->sought.ends[0], *b = w->sought.ends[1];
    const struct piece piece = {begin, end, w->sought_number, beside, beside == BESIDE_DOUBLE};
    struct segment kept = w->sought;
    if (!(begin < end))
        return HATCH_OK;
    w->piece_count++;
    HATCH_TRY(hatch_buffer_add(&w->pieces, &piece, sizeof piece, err));
    if (beside != BESIDE_NONE)
        return HATCH_OK;
    kept.begin += begin * hatch_vector_distance(a, b);
    for (int k = 0; k < 2; k++) {
        kept.ends[0][k] = begin > 0 ? a[k] + begin * (b[k] - a[k]) : a[k];
        kept.ends[1][k] = end < 1 ? a[k] + end * (b[k] - a[k]) : b[k];
    }
    return insert(w, &kept, err);
}

/* Divides a piece of the segment searched for into those that are beside others, and those that are not.
 *   beside  the first way in which they may be */
static enum hatch_status divide_piece(struct work *w, double begin, double end, enum beside beside,
                                      struct hatch_err *err)
{
    if (beside == BESIDE_NONE)
        return add_piece(w, begin, end, BESIDE_NONE, err);
    for (uint32_t i = 0; i < w->part_count; i++) {
        const struct part part = ((const struct part *)(const void *)w->parts.data)[i];
        if (part.beside != beside)
            continue;
        HATCH_TRY(divide_piece(w, begin, fmin(part.begin, end), beside + 1, err));
        begin = fmax(begin, part.begin);
        HATCH_TRY(add_piece(w, begin, fmin(part.end, end), beside, err));
        begin = fmax(begin, part.end);
    }
    return divide_piece(w, begin, end, beside + 1, err);
}

/* Adds the segments of a path to those that others must not run along.
 *   number  as in struct segment */
static enum hatch_status insert_path(struct work *w, const struct hatch_vector_paths *paths,
                                     const struct hatch_vector_path *path, uint32_t number, struct hatch_err *err)
{
    for (uint32_t i = 0; i < hatch_vector_segments(path); i++) {
        const double *a = hatch_vector_point(paths, path, i), *b = hatch_vector_point(paths, path, i + 1);
        HATCH_TRY(insert(w, &(struct segment){.ends = {{a[0], a[1]}, {b[0], b[1]}}, .path = number}, err));
    }
    return HATCH_OK;
}

/* Divides a path into pieces. */
static enum hatch_status divide(struct work *w, uint32_t number, struct hatch_err *err)
{
    const struct hatch_vector_path *path = &w->paths->paths[number];
    double begin = 0;
    w->round = path->closed ? hatch_vector_length(w->paths, path) : INFINITY;
    w->pieces.size = 0;
    w->piece_count = 0;
    for (uint32_t i = 0; i < hatch_vector_segments(path); i++) {
        const double *a = hatch_vector_point(w->paths, path, i), *b = hatch_vector_point(w->paths, path, i + 1);
        w->sought = (struct segment){.ends = {{a[0], a[1]}, {b[0], b[1]}}, .begin = begin, .path = number};
        w->sought_number = i;
        HATCH_TRY(find_parts(w, err));
        HATCH_TRY(divide_piece(w, 0, 1, BESIDE_DOUBLE, err));
        begin += hatch_vector_distance(a, b);
    }
    return HATCH_OK;
}

/* Cuts bends out that have a double near them, before or after them along the path: there the path runs back along
 * itself, and they are what is nearest to the place where it turns. Bends that remain are corners. */
static void unite_bends(struct work *w, const struct hatch_vector_path *path, bool backwards)
{
    double way = INFINITY; /* since the last double */
    for (uint32_t i = 0; i < w->piece_count; i++) {
        struct piece *piece = piece_at(w, backwards ? w->piece_count - 1 - i : i);
        const double *a = hatch_vector_point(w->paths, path, piece->segment);
        const double *b = hatch_vector_point(w->paths, path, piece->segment + 1);
        if (piece->beside == BESIDE_BEND && way < 0.5 * APART_REACHES * w->reach)
            piece->cut_out = true;
        way = piece->beside == BESIDE_DOUBLE ? 0 : way + (piece->end - piece->begin) * hatch_vector_distance(a, b);
    }
}

/* Builds what remains of a path when its pieces have been found.
 *   speck   shorter parts between two that are cut out, or beside one, are cut out, too
 *   closed  as for hatch_vector_runs_drop */
static enum hatch_status deliver(struct work *w, const struct hatch_vector_path *path, double speck, bool closed,
                                 struct hatch_err *err)
{
    hatch_vector_runs_clear(&w->runs);
    for (uint32_t i = 0; i < w->piece_count; i++) {
        const struct piece *piece = piece_at(w, i);
        HATCH_TRY(hatch_vector_runs_add(&w->runs, hatch_vector_point(w->paths, path, piece->segment),
                                        hatch_vector_point(w->paths, path, piece->segment + 1), piece->begin,
                                        piece->end, !piece->cut_out, err));
    }
    HATCH_TRY(hatch_vector_runs_make(&w->runs, err));
    hatch_vector_runs_drop(&w->runs, speck, closed);
    hatch_vector_runs_fill(&w->runs, GAP_REACHES * w->reach);
    return hatch_vector_runs_deliver(&w->runs, path, path->closed, true, &w->built, err);
}

/* Adds what remains of a path.
 *   again  what remains of it has been added: what else does where nothing is beside it is added */
static enum hatch_status add_rest(struct work *w, uint32_t number, bool again, struct hatch_err *err)
{
    const struct hatch_vector_path *path = &w->paths->paths[number];
    const uint32_t before = hatch_vector_built(&w->built).count, first = w->near_count;
    w->own = again;
    w->aside = again ? AGAIN_REACHES * w->reach : w->reach;
    w->doubles_itself = false;
    HATCH_TRY(divide(w, number, err));
    unite_bends(w, path, false);
    unite_bends(w, path, true);
    HATCH_TRY(deliver(w, path, (again ? AGAIN_SPECK_REACHES : SPECK_REACHES) * w->reach, path->closed && !again, err));
    for (uint32_t i = first; i < w->near_count; i++)
        segment_at(w, i)->dropped = true;
    const struct hatch_vector_paths made = hatch_vector_built(&w->built);
    for (uint32_t i = before; i < made.count; i++)
        HATCH_TRY(insert_path(w, &made, &made.paths[i], number, err));
    return HATCH_OK;
}

/* Adds what remains of a path. If it doubles itself, parts may have been cut out that are beside others which are cut
 * out later, as specks: they are looked for again. */
static enum hatch_status add_path(struct work *w, uint32_t number, struct hatch_err *err)
{
    HATCH_TRY(add_rest(w, number, false, err));
    return w->doubles_itself ? add_rest(w, number, true, err) : HATCH_OK;
}

/* Begins a layer, of which only what was drawn before remains so far. */
static enum hatch_status begin_layer(struct work *w, const struct hatch_vector_paths *drawn,
                                     struct hatch_arena *scratch, struct hatch_err *err)
{
    w->segments.size = 0;
    w->near_count = 0;
    HATCH_TRY(hatch_segments_make(w->paths, w->reach, scratch, &w->near, err));
    for (uint32_t i = 0; drawn && i < drawn->count; i++)
        HATCH_TRY(insert_path(w, drawn, &drawn->paths[i], NONE, err));
    return HATCH_OK;
}

static enum hatch_status drop(struct work *w, const struct hatch_vector_paths *drawn, struct hatch_arena *scratch,
                              struct hatch_err *err)
{
    const struct hatch_vector_paths *paths = w->paths;
    struct rank *ranks;
    HATCH_TRY(HATCH_ALLOC(scratch, &ranks, paths->count, err));
    for (uint32_t i = 0; i < paths->count; i++) {
        const struct hatch_vector_path *path = &paths->paths[i];
        ranks[i] = (struct rank){hatch_vector_length(paths, path), i, path->layer};
    }
    qsort(ranks, paths->count, sizeof *ranks, compare_ranks);
    for (uint32_t i = 0; i < paths->count; i++) {
        if (i == 0 || ranks[i].layer != ranks[i - 1].layer)
            HATCH_TRY(begin_layer(w, drawn, scratch, err));
        HATCH_TRY(add_path(w, ranks[i].path, err));
    }
    return HATCH_OK;
}

enum hatch_status hatch_vector_drop_doubles(const struct hatch_vector_paths *paths,
                                            const struct hatch_vector_paths *drawn, double reach,
                                            struct hatch_arena *arena, struct hatch_arena *scratch,
                                            struct hatch_vector_paths *single, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct work work = {.paths = paths,
                        .reach = reach,
                        .segments = {.arena = scratch},
                        .parts = {.arena = scratch},
                        .pieces = {.arena = scratch},
                        .runs = hatch_vector_runs_of(scratch),
                        .built = hatch_vector_builder_of(arena)};
    enum hatch_status status = drop(&work, drawn, scratch, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *single = hatch_vector_built(&work.built);
    return status;
}
