/* Regions grow from face to face, each time by what is left of the distance. */
#include "trace/region.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "curve/reserve.h"

#define WORTH 0.05 /* of the distance: a face is looked at again if so much more of it is left */

/* A part of a face, and how far the region goes around it. */
struct visit {
    uint32_t face;
    double from[2], to[2]; /* a line; the lowest and the highest corner of a window */
    bool is_window;
    double reach;
};

/* The region under construction. */
struct growth {
    const struct hatch_trace_ground *ground;
    double distance;
    struct hatch_arena *scratch;
    struct visit *queue;
    uint32_t queued, capacity;
    uint32_t *of_face;
    struct hatch_trace_window *windows; /* as they are met */
    double *reach;                      /* per window: the largest of its visits */
    uint32_t count, window_capacity, reach_capacity;
};

struct hatch_trace_window hatch_trace_window_of(const struct hatch_trace_ground *ground, uint32_t face)
{
    const struct hatch_trace_face *f = &ground->faces[face];
    return (struct hatch_trace_window){
        face, {fmin(0, (double)f->x2), 0}, {fmax((double)f->x1, (double)f->x2), (double)f->y2}};
}

bool hatch_trace_window_cut(struct hatch_trace_window *window, const struct hatch_trace_window *by)
{
    bool any = true;
    for (int k = 0; k < 2; k++) {
        window->low[k] = fmax(window->low[k], by->low[k]);
        window->high[k] = fmin(window->high[k], by->high[k]);
        any = any && window->low[k] <= window->high[k];
    }
    return any;
}

bool hatch_trace_region_has(const struct hatch_trace_region *region, const struct hatch_trace_place *place)
{
    uint32_t number = region->of_face[place->face];
    if (number == HATCH_NO_SIDE)
        return false;
    const struct hatch_trace_window *window = &region->windows[number];
    return place->x >= window->low[0] && place->x <= window->high[0] && place->y >= window->low[1] &&
           place->y <= window->high[1];
}

bool hatch_trace_window_clip(const struct hatch_trace_window *window, const double from[2], const double to[2],
                             double share[2])
{
    share[0] = 0;
    share[1] = 1;
    for (int k = 0; k < 2; k++) {
        double way = to[k] - from[k], first = window->low[k] - from[k], last = window->high[k] - from[k];
        if (way < 0) {
            double swapped = first;
            first = last;
            last = swapped;
        }
        if (way > 0 || way < 0) {
            share[0] = fmax(share[0], first / way);
            share[1] = fmin(share[1], last / way);
        } else if (first > 0 || last < 0) {
            return false;
        }
    }
    return share[0] <= share[1];
}

static enum hatch_status add_visit(struct growth *growth, const struct visit *visit, struct hatch_err *err)
{
    HATCH_TRY(hatch_curve_reserve(growth->scratch, &growth->queue, sizeof *growth->queue, growth->queued,
                                  &growth->capacity, err));
    growth->queue[growth->queued++] = *visit;
    return HATCH_OK;
}

/* Adds what a visit reaches to the face's window.
 *   news  out: whether neighbours are to be visited from here */
static enum hatch_status widen(struct growth *growth, const struct visit *visit, bool *news, struct hatch_err *err)
{
    uint32_t number = growth->of_face[visit->face];
    const struct hatch_trace_window whole = hatch_trace_window_of(growth->ground, visit->face);
    struct hatch_trace_window reached = {.face = visit->face};
    for (int k = 0; k < 2; k++) {
        reached.low[k] = fmin(visit->from[k], visit->to[k]) - visit->reach;
        reached.high[k] = fmax(visit->from[k], visit->to[k]) + visit->reach;
    }
    *news = hatch_trace_window_cut(&reached, &whole);
    if (!*news)
        return HATCH_OK;
    if (number == HATCH_NO_SIDE) {
        HATCH_TRY(hatch_curve_reserve(growth->scratch, &growth->windows, sizeof *growth->windows, growth->count,
                                      &growth->window_capacity, err));
        HATCH_TRY(hatch_curve_reserve(growth->scratch, &growth->reach, sizeof *growth->reach, growth->count,
                                      &growth->reach_capacity, err));
        growth->of_face[visit->face] = growth->count;
        growth->reach[growth->count] = visit->reach;
        growth->windows[growth->count++] = reached;
        return HATCH_OK;
    }
    struct hatch_trace_window *window = &growth->windows[number];
    double slack = WORTH * growth->distance;
    *news = visit->is_window || visit->reach > growth->reach[number] + slack;
    for (int k = 0; k < 2; k++) {
        *news = *news || reached.low[k] < window->low[k] - slack || reached.high[k] > window->high[k] + slack;
        window->low[k] = fmin(window->low[k], reached.low[k]);
        window->high[k] = fmax(window->high[k], reached.high[k]);
    }
    growth->reach[number] = fmax(growth->reach[number], visit->reach);
    return HATCH_OK;
}

/* Returns the share of a line at which it is nearest to a point. */
static double nearest_share(const double from[2], const double to[2], const double at[2])
{
    double way[2] = {to[0] - from[0], to[1] - from[1]}, square = way[0] * way[0] + way[1] * way[1];
    double share = square > 0 ? ((at[0] - from[0]) * way[0] + (at[1] - from[1]) * way[1]) / square : 0;
    return fmin(fmax(share, 0), 1);
}

/* Returns the distance from the part of the face that a visit starts from to a point. */
static double distance_to(const struct visit *visit, const double at[2])
{
    double off[2];
    if (visit->is_window) {
        for (int k = 0; k < 2; k++)
            off[k] = fmax(fmax(visit->from[k] - at[k], at[k] - visit->to[k]), 0);
    } else {
        double share = nearest_share(visit->from, visit->to, at);
        for (int k = 0; k < 2; k++)
            off[k] = visit->from[k] + share * (visit->to[k] - visit->from[k]) - at[k];
    }
    return hypot(off[0], off[1]);
}

static void between(const double from[2], const double to[2], double share, double at[2])
{
    for (int k = 0; k < 2; k++)
        at[k] = from[k] + share * (to[k] - from[k]);
}

/* A side of a face from which its neighbour is visited. */
struct crossing {
    const double *a, *b; /* the side */
    const double *p, *q; /* the same edge on the neighbour; p is where b is, unless it is contrary */
    bool contrary;
    uint32_t to;
};

/* Visits the neighbour from a part of the side.
 *   share  of the side: ends of the part */
static enum hatch_status enter(struct growth *growth, const struct crossing *crossing, const double share[2],
                               double reach, struct hatch_err *err)
{
    struct visit onward = {.face = crossing->to, .reach = reach};
    const double *p = crossing->contrary ? crossing->p : crossing->q;
    const double *q = crossing->contrary ? crossing->q : crossing->p;
    between(p, q, share[0], onward.from);
    between(p, q, share[1], onward.to);
    return reach > 0 ? add_visit(growth, &onward, err) : HATCH_OK;
}

/* Visits the neighbour beyond a side: from the place of the side that is nearest, and from the part of it that lies
 * beside the visit's. */
static enum hatch_status cross_side(struct growth *growth, const struct visit *visit, const struct crossing *crossing,
                                    struct hatch_err *err)
{
    double beside[2] = {1, 0}, nearest = HUGE_VAL, place = 0;
    int corners = visit->is_window ? 4 : 2;
    for (int i = 0; i < corners + 2; i++) { /* corners, then the ends of the side */
        double at[2], on_side[2], share = i - corners;
        if (i < corners) {
            at[0] = i & 1 ? visit->to[0] : visit->from[0];
            at[1] = (corners == 4 ? i >> 1 : i) ? visit->to[1] : visit->from[1];
            share = nearest_share(crossing->a, crossing->b, at);
            beside[0] = fmin(beside[0], share);
            beside[1] = fmax(beside[1], share);
        }
        between(crossing->a, crossing->b, share, on_side);
        double distance = distance_to(visit, on_side);
        if (distance < nearest) {
            nearest = distance;
            place = share;
        }
    }
    if (visit->is_window) { /* the part of the side that is in the window */
        struct hatch_trace_window window = {
            visit->face, {visit->from[0], visit->from[1]}, {visit->to[0], visit->to[1]}};
        double share[2];
        if (hatch_trace_window_clip(&window, crossing->a, crossing->b, share))
            return enter(growth, crossing, share, visit->reach, err);
    }
    double farthest = 0;
    for (int e = 0; e < 2; e++) {
        double at[2];
        between(crossing->a, crossing->b, beside[e], at);
        farthest = fmax(farthest, distance_to(visit, at));
    }
    HATCH_TRY(enter(growth, crossing, (const double[2]){place, place}, visit->reach - nearest, err));
    return beside[1] > beside[0] ? enter(growth, crossing, beside, visit->reach - farthest, err) : HATCH_OK;
}

static enum hatch_status cross_sides(struct growth *growth, const struct visit *visit, struct hatch_err *err)
{
    const struct hatch_trace_face *faces = growth->ground->faces, *face = &faces[visit->face];
    double corner[3][2], next[3][2];
    hatch_trace_corners(face, corner);
    for (uint32_t side = 0; side < 3; side++) {
        uint32_t other = face->beyond[side];
        if (other == HATCH_NO_SIDE)
            continue;
        hatch_trace_corners(&faces[other / 3], next);
        const struct crossing crossing = {.a = corner[side],
                                          .b = corner[(side + 1) % 3],
                                          .p = next[other % 3],
                                          .q = next[(other + 1) % 3],
                                          .contrary = face->contrary >> side & 1,
                                          .to = other / 3};
        HATCH_TRY(cross_side(growth, visit, &crossing, err));
    }
    return HATCH_OK;
}

static int by_face(const void *a, const void *b)
{
    const struct hatch_trace_window *x = a, *y = b;
    return (x->face > y->face) - (x->face < y->face);
}

enum hatch_status hatch_trace_region_around(const struct hatch_trace_ground *ground,
                                            const struct hatch_trace_window *windows, uint32_t count, double distance,
                                            struct hatch_arena *arena, struct hatch_arena *scratch,
                                            struct hatch_trace_region *region, struct hatch_err *err)
{
    struct growth growth = {.ground = ground, .distance = distance, .scratch = scratch};
    uint32_t face_count = ground->surface->face_count;
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &growth.of_face, face_count, err));
    memset(growth.of_face, 0xff, sizeof *growth.of_face * face_count);
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    for (uint32_t i = 0; i < count; i++)
        HATCH_TRY(add_visit(&growth,
                            &(struct visit){.face = windows[i].face,
                                            .from = {windows[i].low[0], windows[i].low[1]},
                                            .to = {windows[i].high[0], windows[i].high[1]},
                                            .is_window = true,
                                            .reach = distance},
                            err));
    for (uint32_t i = 0; i < growth.queued; i++) {
        const struct visit visit = growth.queue[i];
        bool news;
        HATCH_TRY(widen(&growth, &visit, &news, err));
        if (news)
            HATCH_TRY(cross_sides(&growth, &visit, err));
    }
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &region->windows, growth.count, err));
    if (growth.count > 0) {
        memcpy(region->windows, growth.windows, sizeof *growth.windows * growth.count);
        qsort(region->windows, growth.count, sizeof *region->windows, by_face);
    }
    for (uint32_t i = 0; i < growth.count; i++)
        growth.of_face[region->windows[i].face] = i;
    region->of_face = growth.of_face;
    region->count = growth.count;
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
