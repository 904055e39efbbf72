#include "curve/marks.h"

#include <math.h>

#include "curve/hash.h"

#define BITS 3           /* of a place within its cell; the last one counts by the share of the way to the next level */
#define ANCESTORS 4      /* levels over which a place keeps its number */
#define SOFT 0.2         /* share of the marks that are growing at any time, between two levels */
#define SHARE_SOFT 0.08  /* the same, where the share of dots changes */
#define LEAST_PX 0.05    /* half the length of a dot's line */
#define PASSING 0.6      /* gaps by which strokes that meet pass one another */
#define PLACES_MAX 65536 /* along a stroke */
#define MARGIN 0.5       /* no mark begins or ends so close to an end of the stroke, in periods */

/* A place of a mark, or the joint between two marks. */
struct place {
    double at;       /* arc length, in mesh units */
    double weight;   /* 0: absent .. 1: fully there */
    uint32_t number; /* random */
};

static uint32_t hash_cell(uint32_t stroke, int level, uint32_t cell)
{
    return hatch_mix_bits(stroke + (uint32_t)level * 0x9e3779b9u + cell * 0x85ebca6bu);
}

/* Returns one of the three random numbers, 0 .. 1, of a place. */
static double draw(uint32_t number, uint32_t which)
{
    return (number >> 10 * which & 1023) / 1023.0;
}

/* Returns the weight of the mark of a random number if a share of all marks is drawn: on the mean of all numbers, it is
 * that share. */
static double grown(double share, double number, double soft)
{
    double limit = share + 0.5 * soft;
    if (share < 0.5 * soft)
        limit = sqrt(2 * soft * fmax(share, 0));
    else if (share > 1 - 0.5 * soft)
        limit = 1 + soft - sqrt(2 * soft * fmax(1 - share, 0));
    return fmin(fmax((limit - number) / soft, 0), 1);
}

/* Finds the place in a cell.
 *   level  of the cell
 *   part   share of the way from the level before to this one */
static struct place place_of(uint32_t stroke, int level, uint32_t cell, double part)
{
    uint32_t parent = hash_cell(stroke, level - 1, cell >> 1), below = cell;
    struct place place = {.weight = 1};
    double within = 0, size = 0.5;
    for (int n = 0; n < BITS; n++, size *= 0.5) {
        uint32_t bit = hash_cell(stroke, level + n, below) >> 31;
        below = 2 * below + bit;
        within += bit * size * (n + 1 < BITS ? 1 : part);
    }
    place.at = ldexp(cell + within, -level);
    if ((cell & 1) != parent >> 31)
        place.weight = grown(exp2(part) - 1, (parent & 0xffffff) / 16777216.0, SOFT);
    for (int n = 0; n < ANCESTORS && (cell & 1) == hash_cell(stroke, level - 1, cell >> 1) >> 31; n++, level--)
        cell >>= 1;
    place.number = hash_cell(stroke ^ 0x5bd1e995u, level, cell);
    return place;
}

bool hatch_pen_has_dots(const struct hatch_stroke_pen *pen)
{
    return pen->mark_px > 0 && pen->mark_px <= HATCH_DOT_WIDTHS * pen->width_px;
}

double hatch_mark_period_px(const struct hatch_stroke_pen *pen, double tone)
{
    double period = (double)pen->mark_px + (double)pen->gap_px;
    return hatch_pen_has_dots(pen) ? period * sqrt(0.5 / fmax(HATCH_DOT_LAYERS * tone, 1e-4)) : period;
}

double hatch_mark_stroke_tone(const struct hatch_stroke_pen *pen, double tone)
{
    if (!hatch_pen_has_dots(pen))
        return tone;
    return HATCH_DOT_LAYERS * tone * hatch_mark_period_px(pen, tone) / (double)pen->mark_px;
}

/* Marks under construction. */
struct listing {
    const struct hatch_stroke_pen *pen;
    const struct hatch_mark_point *points;
    uint32_t count, segment; /* the line from point `segment` to the next is the current one */
    struct hatch_buffer *marks;
    struct hatch_mark open; /* of longer marks: the current one */
};

/* Returns what the points have at an arc length, which never falls from call to call. */
static struct hatch_mark_point point_at(struct listing *listing, double at)
{
    while (listing->segment + 2 < listing->count && (double)listing->points[listing->segment + 1].at <= at)
        listing->segment++;
    const struct hatch_mark_point *a = &listing->points[listing->segment], *b = a + 1;
    float share = (float)fmin(fmax((at - (double)a->at) / fmax((double)(b->at - a->at), 1e-30), 0), 1);
    return (struct hatch_mark_point){.at = (float)at,
                                     .scale = a->scale + share * (b->scale - a->scale),
                                     .level = a->level + share * (b->level - a->level),
                                     .share = a->share + share * (b->share - a->share),
                                     .scatter = a->scatter + share * (b->scatter - a->scatter)};
}

static enum hatch_status add_dot(struct listing *listing, const struct place *place, struct hatch_err *err)
{
    const struct hatch_mark_point here = point_at(listing, place->at);
    double total = (double)listing->points[listing->count - 1].at, scale = fmax((double)here.scale, 1e-20);
    double half = 0.5 * (double)listing->pen->mark_px / scale;
    double passing_px =
        (double)listing->pen->scatter > 0 ? PASSING * (double)(here.scatter / listing->pen->scatter) : 0;
    double taper_px = fmax(fmax((double)listing->pen->taper_px, 1e-3), passing_px);
    double taper = fmin(fmin(place->at, total - place->at) * scale / taper_px, 1);
    double weight = place->weight * grown((double)here.share * taper, draw(place->number, 0), SHARE_SOFT);
    double core = fmax(half - 0.5 * (double)listing->pen->width_px / scale, LEAST_PX / scale);
    float beside = here.scatter * (float)(2 * draw(place->number, 1) - 1);
    if (weight < 0.5 || place->at < half || place->at > total - half)
        return HATCH_OK;
    const struct hatch_mark mark = {(float)(place->at - core), (float)(place->at + core), {beside, beside}};
    return hatch_buffer_add(listing->marks, &mark, sizeof mark, err);
}

static enum hatch_status add_joint(struct listing *listing, const struct place *place, struct hatch_err *err)
{
    const struct hatch_mark_point here = point_at(listing, place->at);
    double scale = fmax((double)here.scale, 1e-20), gap = (double)listing->pen->gap_px;
    double to_end = fmin(place->at, (double)listing->points[listing->count - 1].at - place->at) * scale;
    double weight = place->weight;
    weight *= fmin(fmax(4 * (to_end / hatch_mark_period_px(listing->pen, 0.5) - MARGIN), 0), 1);
    if (!(weight > 0))
        return HATCH_OK;
    float half = (float)(0.5 * weight * gap * (0.6 + 0.8 * draw(place->number, 0)) / scale);
    struct hatch_mark *open = &listing->open;
    open->to = (float)place->at - half;
    open->beside[1] = here.scatter * (float)(weight * (2 * draw(place->number, 1) - 1));
    if (open->to > open->from)
        HATCH_TRY(hatch_buffer_add(listing->marks, open, sizeof *open, err));
    *open = (struct hatch_mark){.from = (float)place->at + half,
                                .beside = {here.scatter * (float)(weight * (2 * draw(place->number, 2) - 1)), 0}};
    return HATCH_OK;
}

enum hatch_status hatch_marks_list(const struct hatch_stroke_pen *pen, uint32_t stroke,
                                   const struct hatch_mark_point *points, uint32_t count, struct hatch_buffer *marks,
                                   struct hatch_err *err)
{
    struct listing listing = {.pen = pen, .points = points, .count = count, .marks = marks};
    const double total = (double)points[count - 1].at;
    const bool dots = hatch_pen_has_dots(pen);
    for (double at = 0; at < total;) {
        double level = fmin((double)point_at(&listing, at).level, log2(PLACES_MAX / total)), low = floor(level);
        int cells = (int)low + 1;
        double cell = floor(ldexp(at, cells));
        const struct place place = place_of(stroke, cells, (uint32_t)cell, level - low);
        if (place.weight > 0 && place.at < total)
            HATCH_TRY((dots ? add_dot : add_joint)(&listing, &place, err));
        at = ldexp(cell + 1, -cells);
    }
    listing.open.to = (float)total;
    return dots ? HATCH_OK : hatch_buffer_add(marks, &listing.open, sizeof listing.open, err);
}
