#include <math.h>
#include <string.h>

#include "curvature/curvature.h"

#include "math/vector.h"

#define JUMP_LENGTH 0.15  /* cost of a jump for each unit of its length, in square roots of the component's area */
#define CERTAIN_RAD 0.1   /* standard error of the axes that halves the certainty */
#define CERTAINTY_MIN 0.1 /* of both ends together: no jump shows where less is known */
#define ROUNDS_MAX 64     /* noise needs six; bounds the time where each round merges few regions */

/* Regions of points whose directions continue each other, bounded by jumps. */
struct regions {
    const struct hatch_surface *surface;
    struct hatch_curvature *curvature;
    double *unit_cost;  /* per component: of a jump, for each unit of its length */
    double *continuity; /* per ring entry: cosine of twice the turn between the first directions at its ends, times the
                           cost of a jump there; 0 where too little is known */
    bool *swapped;      /* per point: its direction is that of the second curvature */
    uint32_t *region;   /* per point: a point that stands for its region */
    bool *alone;        /* per point: no other is in its region */
    double *score;      /* per region: what is gained when all its directions are swapped */
    double *best;       /* per region: over 0 where a neighbour has a larger score */
};

/* Returns how well the axes at a point are known, 0 .. 1. */
static double certainty(const struct hatch_curvature *curvature, uint32_t point)
{
    double confidence = curvature->confidence[point], ratio = HATCH_CURVATURE_HALF_CONFIDENCE_RAD / CERTAIN_RAD;
    return confidence / (confidence + (1 - confidence) * ratio * ratio);
}

/* Returns by how much the first curvature exceeds the second, in shares of their sum, absolute values of both. */
static double excess(const struct hatch_curvature *curvature, uint32_t point)
{
    double first = fabs(curvature->value[2 * (size_t)point]), second = fabs(curvature->value[2 * (size_t)point + 1]);
    return first > second ? (first - second) / (first + second) : 0;
}

/* Fills continuity. Returns whether there is a jump: a cosine below 0. */
static bool find_jumps(struct regions *r, const struct hatch_frames *frames, double *angle_rad)
{
    const struct hatch_surface *surface = r->surface;
    bool any = false;
    for (uint32_t p = 0; p < surface->point_count; p++)
        angle_rad[p] = hatch_frames_angle(frames, p, &r->curvature->direction[3 * (size_t)p]);
    for (uint32_t p = 0; p < surface->point_count; p++) {
        double here = certainty(r->curvature, p);
        for (uint32_t i = surface->ring_first[p]; i < surface->ring_first[p + 1]; i++) {
            uint32_t q = surface->ring_point[i];
            double there = surface->ring_turned[i] ? -angle_rad[q] : angle_rad[q];
            double cosine = cos(2 * (angle_rad[p] - frames->transport_rad[i] - there));
            double known = here * certainty(r->curvature, q), length = frames->weight[i];
            if (known < CERTAINTY_MIN)
                continue;
            length *= hatch_vec_distance(&surface->points[3 * (size_t)p], &surface->points[3 * (size_t)q]);
            r->continuity[i] = cosine * known * length * r->unit_cost[surface->point_component[p]];
            any = any || cosine < 0;
        }
    }
    return any;
}

/* Returns the cost of the jump at ring entry i of point p, 0 where there is none. */
static double jump_cost(const struct regions *r, uint32_t p, uint32_t i)
{
    bool same = r->swapped[p] == r->swapped[r->surface->ring_point[i]];
    return fmax(0, same ? -r->continuity[i] : r->continuity[i]);
}

static uint32_t region_of(struct regions *r, uint32_t p)
{
    while (r->region[p] != p)
        p = r->region[p] = r->region[r->region[p]];
    return p;
}

/* Joins the regions of two points. */
static void join(struct regions *r, uint32_t p, uint32_t q)
{
    uint32_t a = region_of(r, p), b = region_of(r, q);
    r->region[a < b ? b : a] = a < b ? a : b;
    r->alone[p] = r->alone[q] = false;
}

/* Joins the points whose directions continue each other, then those at which too little is known with a region beside
 * them: with one, because they would join what lies on both sides of a jump. */
static void find_regions(struct regions *r)
{
    const struct hatch_surface *surface = r->surface;
    for (uint32_t p = 0; p < surface->point_count; p++) {
        r->region[p] = p;
        r->alone[p] = true;
    }
    for (int unknown = 0; unknown < 2; unknown++)
        for (uint32_t p = 0; p < surface->point_count; p++)
            for (uint32_t i = surface->ring_first[p]; i < surface->ring_first[p + 1]; i++) {
                uint32_t q = surface->ring_point[i];
                if (q < p || jump_cost(r, p, i) > 0 || (r->continuity[i] == 0) != unknown)
                    continue;
                if (!unknown || r->alone[p] || r->alone[q])
                    join(r, p, q);
            }
}

/* Computes the scores: jumps that would vanish from the region's border, less the excess of the curvature given up. */
static void find_scores(struct regions *r, const double *area)
{
    const struct hatch_surface *surface = r->surface;
    memset(r->score, 0, surface->point_count * sizeof *r->score);
    for (uint32_t p = 0; p < surface->point_count; p++) {
        uint32_t own = region_of(r, p);
        double loss = area[p] * certainty(r->curvature, p) * excess(r->curvature, p);
        r->score[own] += r->swapped[p] ? loss : -loss;
        r->best[p] = 0;
        for (uint32_t i = surface->ring_first[p]; i < surface->ring_first[p + 1]; i++)
            if (region_of(r, surface->ring_point[i]) != own)
                r->score[own] += jump_cost(r, p, i);
    }
    for (uint32_t p = 0; p < surface->point_count; p++)
        for (uint32_t i = surface->ring_first[p]; i < surface->ring_first[p + 1]; i++) {
            uint32_t own = region_of(r, p), other = region_of(r, surface->ring_point[i]);
            bool first = r->score[other] > r->score[own] || (r->score[other] == r->score[own] && other < own);
            if (own != other && first)
                r->best[own] = INFINITY;
        }
}

/* Swaps each region that gains by it and gains no less than its neighbours. Returns whether there was one. */
static bool swap_regions(struct regions *r)
{
    bool any = false;
    for (uint32_t p = 0; p < r->surface->point_count; p++) {
        uint32_t own = region_of(r, p);
        if (!(r->score[own] > 0) || r->best[own] > 0)
            continue;
        r->swapped[p] = !r->swapped[p];
        any = true;
    }
    return any;
}

static void swap_axes(const struct regions *r)
{
    for (size_t p = 0; p < r->surface->point_count; p++) {
        double *direction = &r->curvature->direction[3 * p], *value = &r->curvature->value[2 * p], across[3];
        double first = value[0];
        if (!r->swapped[p])
            continue;
        hatch_vec_cross(&r->curvature->normal[3 * p], direction, across);
        hatch_vec_copy(across, direction);
        value[0] = value[1];
        value[1] = first;
    }
}

static enum hatch_status allocate(struct regions *r, struct hatch_arena *scratch, struct hatch_err *err)
{
    size_t points = r->surface->point_count;
    HATCH_TRY(HATCH_ALLOC(scratch, &r->unit_cost, r->surface->component_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &r->continuity, r->surface->ring_first[points], err));
    HATCH_TRY(HATCH_ALLOC(scratch, &r->swapped, points, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &r->region, points, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &r->alone, points, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &r->best, points, err));
    return HATCH_ALLOC(scratch, &r->score, points, err);
}

static enum hatch_status continue_axes(struct regions *r, const struct hatch_frames *frames,
                                       struct hatch_arena *scratch, struct hatch_err *err)
{
    const struct hatch_surface *surface = r->surface;
    double *angle_rad;
    HATCH_TRY(allocate(r, scratch, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &angle_rad, surface->point_count, err));
    for (uint32_t p = 0; p < surface->point_count; p++)
        r->unit_cost[surface->point_component[p]] += frames->area[p];
    for (uint32_t c = 0; c < surface->component_count; c++)
        r->unit_cost[c] = JUMP_LENGTH * sqrt(r->unit_cost[c]);
    if (!find_jumps(r, frames, angle_rad))
        return HATCH_OK;
    bool more = true;
    for (int round = 0; more && round < ROUNDS_MAX; round++) {
        find_regions(r);
        find_scores(r, frames->area);
        more = swap_regions(r);
    }
    swap_axes(r);
    return HATCH_OK;
}

enum hatch_status hatch_curvature_continue_axes(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                                struct hatch_arena *scratch, struct hatch_curvature *curvature,
                                                struct hatch_err *err)
{
    struct regions regions = {.surface = surface, .curvature = curvature};
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = continue_axes(&regions, frames, scratch, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}
