#include "fit/split.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#define TOUCH_PX 2          /* fragments whose columns and rows differ by no more touch each other, */
#define TOUCH_T 0.2f        /* if their parameters differ by no more */
#define MISSED_MOST 0.05    /* share of a part's weight that may be out of reach */
#define END 0.1             /* parameter at which slivers begin: they have no ends of a stroke */
#define HALVINGS 3u         /* greatest number of times that a part is halved */
#define HALVED_LEAST 8u     /* fragments of the smallest part that is halved */
#define BOX_MOST (1u << 22) /* pixels of the largest box around a stroke whose fragments are told apart */

/* A stroke that is being divided. */
struct division {
    struct hatch_fragment *fragments;
    double reach_px;
    struct hatch_stroke_part *parts;
    uint32_t count;
    struct hatch_fragment *room; /* for as many */
};

double hatch_cubic_missed(const struct hatch_cubic *cubic, const struct hatch_fragment *fragments, size_t count,
                          double reach_px)
{
    double missed = 0, all = 0;
    for (size_t i = 0; i < count; i++) {
        const struct hatch_fragment *f = &fragments[i];
        float place[2];
        hatch_cubic_at(cubic, hatch_cubic_u(cubic, f->t), place);
        if (hypot((double)(f->x - place[0]), (double)(f->y - place[1])) > reach_px)
            missed += (double)f->weight;
        all += (double)f->weight;
    }
    return all > 0 ? missed / all : 0;
}

/* Orders fragments by parameter, then by place. */
static int compare(const void *a, const void *b)
{
    const struct hatch_fragment *f = a, *g = b;
    if (f->t < g->t || f->t > g->t)
        return f->t < g->t ? -1 : 1;
    if (f->y < g->y || f->y > g->y)
        return f->y < g->y ? -1 : 1;
    return (f->x > g->x) - (f->x < g->x);
}

/* A picture of the box around the fragments: each pixel has a list of its fragments. */
struct box {
    const struct hatch_fragment *fragments;
    int low[2], width, height;
    uint32_t *pixels; /* 1 + the index of the first; 0: none */
    uint32_t *next;   /* per fragment: 1 + the index of the next one on its pixel; 0: none */
};

/* Finds the box; returns whether it is small enough for a picture. */
static bool find_box(const struct hatch_fragment *fragments, uint32_t count, struct box *box)
{
    float low[2] = {fragments->x, fragments->y}, high[2] = {fragments->x, fragments->y};
    for (uint32_t i = 1; i < count; i++) {
        low[0] = fminf(low[0], fragments[i].x);
        low[1] = fminf(low[1], fragments[i].y);
        high[0] = fmaxf(high[0], fragments[i].x);
        high[1] = fmaxf(high[1], fragments[i].y);
    }
    *box = (struct box){.fragments = fragments,
                        .low = {(int)floorf(low[0]), (int)floorf(low[1])},
                        .width = (int)floorf(high[0]) - (int)floorf(low[0]) + 1,
                        .height = (int)floorf(high[1]) - (int)floorf(low[1]) + 1};
    return (double)box->width * box->height <= BOX_MOST;
}

/* Returns the pixel at a distance from that of a fragment; NULL: it is outside of the box. */
static uint32_t *pixel_beside(const struct box *box, uint32_t fragment, int right, int up)
{
    int column = (int)floorf(box->fragments[fragment].x) - box->low[0] + right;
    int row = (int)floorf(box->fragments[fragment].y) - box->low[1] + up;
    bool inside = column >= 0 && row >= 0 && column < box->width && row < box->height;
    return inside ? &box->pixels[(size_t)row * (size_t)box->width + (size_t)column] : NULL;
}

/* A component in search of its fragments. */
struct flood {
    const struct box *box;
    uint32_t *component;      /* in, out: per fragment; UINT32_MAX: none yet */
    uint32_t *stack, waiting; /* fragments whose neighbours are to be visited */
};

/* Takes the fragments of a pixel into the component of a fragment that they touch. */
static void take_pixel(struct flood *flood, uint32_t from, const uint32_t *pixel)
{
    const struct hatch_fragment *fragments = flood->box->fragments;
    for (uint32_t i = pixel ? *pixel : 0; i > 0; i = flood->box->next[i - 1])
        if (flood->component[i - 1] == UINT32_MAX && fabsf(fragments[i - 1].t - fragments[from].t) <= TOUCH_T) {
            flood->component[i - 1] = flood->component[from];
            flood->stack[flood->waiting++] = i - 1;
        }
}

/* Takes all fragments that a fragment touches, directly or through others, into its component. */
static void take_all(struct flood *flood, uint32_t from)
{
    flood->stack[flood->waiting++] = from;
    while (flood->waiting) {
        uint32_t i = flood->stack[--flood->waiting];
        for (int y = -TOUCH_PX; y <= TOUCH_PX; y++)
            for (int x = -TOUCH_PX; x <= TOUCH_PX; x++)
                take_pixel(flood, i, pixel_beside(flood->box, i, x, y));
    }
}

/* Finds the components of touching fragments, numbered in the order of their first fragments. */
static enum hatch_status find_components(const struct hatch_fragment *fragments, uint32_t count,
                                         struct hatch_arena *scratch, uint32_t *component, uint32_t *components,
                                         struct hatch_err *err)
{
    struct box box;
    struct flood flood = {.box = &box, .component = component};
    *components = 1;
    memset(component, 0, sizeof *component * count);
    if (!find_box(fragments, count, &box))
        return HATCH_OK;
    HATCH_TRY(HATCH_ALLOC(scratch, &box.pixels, (size_t)box.width * (size_t)box.height, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &box.next, count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &flood.stack, count, err));
    for (uint32_t i = 0; i < count; i++) {
        uint32_t *pixel = pixel_beside(&box, i, 0, 0);
        box.next[i] = *pixel;
        *pixel = i + 1;
        component[i] = UINT32_MAX;
    }
    *components = 0;
    for (uint32_t i = 0; i < count; i++)
        if (component[i] == UINT32_MAX) {
            component[i] = (*components)++;
            take_all(&flood, i);
        }
    return HATCH_OK;
}

/* Computes the middle of fragments and the unit direction in which they spread most. */
static void find_axis(const struct hatch_fragment *fragments, uint32_t count, double middle[2], double axis[2])
{
    double xx = 0, xy = 0, yy = 0;
    middle[0] = middle[1] = 0;
    for (uint32_t i = 0; i < count; i++) {
        middle[0] += (double)fragments[i].x / count;
        middle[1] += (double)fragments[i].y / count;
    }
    for (uint32_t i = 0; i < count; i++) {
        double x = (double)fragments[i].x - middle[0], y = (double)fragments[i].y - middle[1];
        xx += x * x;
        xy += x * y;
        yy += y * y;
    }
    double angle = 0.5 * atan2(2 * xy, xx - yy);
    axis[0] = cos(angle);
    axis[1] = sin(angle);
}

/* Gives fragments parameters along the direction in which they spread most, from END to 1 - END, if a curve then
 * follows them: at rims a stroke is smeared to a sliver along the rim, across its own direction. */
static bool turn(struct hatch_fragment *fragments, uint32_t count, double reach_px, struct hatch_fragment *turned)
{
    double middle[2], axis[2], low = HUGE_VAL, high = -HUGE_VAL;
    struct hatch_cubic cubic;
    find_axis(fragments, count, middle, axis);
    for (int write = 0; write < 2; write++)
        for (uint32_t i = 0; i < count; i++) {
            double at = axis[0] * ((double)fragments[i].x - middle[0]) + axis[1] * ((double)fragments[i].y - middle[1]);
            low = fmin(low, at);
            high = fmax(high, at);
            turned[i] = fragments[i];
            turned[i].t = (float)(END + (1 - 2 * END) * (at - low) / fmax(high - low, 1e-9));
        }
    hatch_cubic_fit(turned, count, &cubic);
    if (hatch_cubic_missed(&cubic, turned, count, reach_px) > MISSED_MOST)
        return false;
    memcpy(fragments, turned, sizeof *turned * count);
    return true;
}

/* Halves a range of fragments, sorted by parameter, until its curve follows it. Parts beyond the last allowed one
 * remain in it. */
static void halve(struct division *division, uint32_t first, uint32_t end, uint32_t halvings)
{
    struct hatch_fragment *from = division->fragments + first;
    struct hatch_cubic cubic;
    uint32_t middle = first;
    hatch_cubic_fit(from, end - first, &cubic);
    while (middle < end && hatch_cubic_u(&cubic, division->fragments[middle].t) < 0)
        middle++;
    bool follows = halvings == 0 || end - first < HALVED_LEAST || middle == first || middle == end ||
                   hatch_cubic_missed(&cubic, from, end - first, division->reach_px) <= MISSED_MOST ||
                   turn(from, end - first, division->reach_px, division->room);
    if (!follows) {
        halve(division, first, middle, halvings - 1);
        division->parts[division->count - 1].goes_on = true;
        halve(division, middle, end, halvings - 1);
        return;
    }
    division->count += division->count < HATCH_FIT_PARTS_MAX;
    division->parts[division->count - 1] = (struct hatch_stroke_part){.end = end};
}

/* Does the work of hatch_fragments_split, but leaves memory in the scratch arena. */
static enum hatch_status split(struct division *division, uint32_t count, struct hatch_arena *scratch,
                               struct hatch_err *err)
{
    struct hatch_fragment *fragments = division->fragments, *sorted;
    uint32_t *component, components, at = 0;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &component, count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &sorted, count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &division->room, count, err));
    qsort(fragments, count, sizeof *fragments, compare);
    HATCH_TRY(find_components(fragments, count, scratch, component, &components, err));
    memcpy(sorted, fragments, sizeof *sorted * count);
    for (uint32_t c = 0; c < components; c++) {
        uint32_t first = at;
        for (uint32_t i = 0; i < count; i++)
            if (component[i] == c)
                fragments[at++] = sorted[i];
        halve(division, first, at, HALVINGS);
    }
    return HATCH_OK;
}

enum hatch_status hatch_fragments_split(struct hatch_fragment *fragments, uint32_t count, double reach_px,
                                        struct hatch_arena *scratch,
                                        struct hatch_stroke_part parts[HATCH_FIT_PARTS_MAX], uint32_t *part_count,
                                        struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct division division = {.fragments = fragments, .reach_px = reach_px, .parts = parts};
    enum hatch_status status = split(&division, count, scratch, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *part_count = division.count;
    return status;
}
