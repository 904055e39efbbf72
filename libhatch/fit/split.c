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
        double x = (double)(f->x - place[0]), y = (double)(f->y - place[1]);
        if (x * x + y * y > reach_px * reach_px)
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

/* A picture of the box around the fragments, with a border that they do not reach: each pixel has a list of those of
 * its fragments that have no component. */
struct box {
    int low[2], width, height;
    uint32_t *pixels; /* 1 + the index of the first; 0: none */
    uint32_t *next;   /* per fragment: 1 + the index of the next one on its pixel; 0: none */
    uint32_t *at;     /* per fragment: the index of its pixel */
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
    *box = (struct box){.low = {(int)floorf(low[0]) - TOUCH_PX, (int)floorf(low[1]) - TOUCH_PX}};
    box->width = (int)floorf(high[0]) - box->low[0] + 1 + TOUCH_PX;
    box->height = (int)floorf(high[1]) - box->low[1] + 1 + TOUCH_PX;
    return (double)box->width * box->height <= BOX_MOST;
}

/* A component in search of its fragments. */
struct flood {
    const struct hatch_fragment *fragments;
    struct box *box;
    uint32_t *component;      /* in, out: per fragment */
    uint32_t *stack, waiting; /* fragments whose neighbours are to be visited */
};

/* Takes the fragments of a pixel into the component of a fragment that they touch. */
static void take_pixel(struct flood *flood, uint32_t from, uint32_t *link)
{
    const struct hatch_fragment *fragments = flood->fragments;
    while (*link) {
        uint32_t i = *link - 1;
        if (fabsf(fragments[i].t - fragments[from].t) > TOUCH_T) {
            link = &flood->box->next[i];
            continue;
        }
        *link = flood->box->next[i];
        flood->component[i] = flood->component[from];
        flood->stack[flood->waiting++] = i;
    }
}

/* Takes all fragments that a fragment touches, directly or through others, into its component. */
static void take_all(struct flood *flood, uint32_t from)
{
    const struct box *box = flood->box;
    take_pixel(flood, from, &box->pixels[box->at[from]]);
    while (flood->waiting) {
        uint32_t i = flood->stack[--flood->waiting];
        uint32_t *row = box->pixels + box->at[i] - TOUCH_PX * box->width - TOUCH_PX;
        for (int y = -TOUCH_PX; y <= TOUCH_PX; y++, row += box->width)
            for (int x = 0; x <= 2 * TOUCH_PX; x++)
                take_pixel(flood, i, &row[x]);
    }
}

/* Makes an empty picture for so many fragments. */
static enum hatch_status make_box(uint32_t count, struct hatch_arena *scratch, struct box *box, struct hatch_err *err)
{
    HATCH_TRY(HATCH_ALLOC(scratch, &box->pixels, (size_t)box->width * (size_t)box->height, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &box->next, count, err));
    return HATCH_ALLOC_UNSET(scratch, &box->at, count, err);
}

/* Finds the components of touching fragments, numbered in the order of their first fragments. */
static enum hatch_status find_components(const struct hatch_fragment *fragments, uint32_t count,
                                         struct hatch_arena *scratch, uint32_t *component, uint32_t *components,
                                         struct hatch_err *err)
{
    struct box box;
    struct flood flood = {.fragments = fragments, .box = &box, .component = component};
    *components = 1;
    memset(component, 0, sizeof *component * count);
    if (!find_box(fragments, count, &box))
        return HATCH_OK;
    HATCH_TRY(make_box(count, scratch, &box, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &flood.stack, count, err));
    for (uint32_t i = 0; i < count; i++) {
        int column = (int)floorf(fragments[i].x) - box.low[0], row = (int)floorf(fragments[i].y) - box.low[1];
        box.at[i] = (uint32_t)row * (uint32_t)box.width + (uint32_t)column;
        box.next[i] = box.pixels[box.at[i]];
        box.pixels[box.at[i]] = i + 1;
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
