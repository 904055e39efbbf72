/* The pieces of strokes on the faces, and the ways between strokes. */
#include <math.h>
#include <string.h>

#include "base/random.h"
#include "trace/work.h"

#define CELL_GAPS 3.0           /* side of a cell: smaller ones are all looked into anyway */
#define CELL_GAPS_OF_REGION 1.5 /* where faces are often larger than cells */
#define CELLS_MAX 1024.0        /* of a face, along each axis */
#define OWN_GAPS 2.5            /* pieces of the same stroke that are nearer along it do not count, but for windings */
#define GAP_LEAST 0.2           /* of the gap: nothing is nearer, but for rounding and strokes that cross */
#define OBLIQUE 0.7   /* sine of the angle between a border and the way across: below, strokes run into the border, */
#define PARALLEL 0.95 /* and above, beside it */
#define OVERLAP_GAPS 0.6 /* length by which strokes that meet may pass one another */
#define SLACK 1e-4f      /* of a piece's length: pieces that meet at a face's border leave no hole */

/* Returns the number of a face in the table of cells; HATCH_NO_SIDE outside of the region. */
static uint32_t row_of(const struct hatch_tracer *tracer, uint32_t face)
{
    return tracer->region ? tracer->region->of_face[face] : face - tracer->component->first_face;
}

/* The rectangle that the cells of a face cover, from its origin: its width begins at x_low, its height at 0. */
static void extent_of(const struct hatch_tracer *tracer, uint32_t row, double *x_low, double *width, double *height)
{
    struct hatch_trace_window window =
        tracer->region ? tracer->region->windows[row]
                       : hatch_trace_window_of(&tracer->ground, tracer->component->first_face + row);
    *x_low = tracer->region ? 0 : window.low[0];
    *width = window.high[0] - window.low[0];
    *height = window.high[1] - window.low[1];
}

static uint32_t cells_along(double size, double cell)
{
    return (uint32_t)fmin(fmax(ceil(size / cell), 1), CELLS_MAX);
}

/* Returns which of `count` cells along an axis a coordinate is in. */
static uint32_t cell_at(double coordinate, double size, uint32_t count)
{
    double cell = coordinate / size * count;
    return cell > 0 ? (uint32_t)fmin(cell, count - 1) : 0;
}

static void put_in_cell(struct hatch_tracer *tracer, uint32_t number)
{
    struct hatch_trace_piece *piece = &tracer->pieces[number];
    const struct hatch_trace_cells *cells = &tracer->cells;
    uint32_t f = row_of(tracer, piece->face);
    uint32_t cell = cells->first[f], across = cells->across[f], count = cells->first[f + 1] - cell;
    if (count > 1) {
        double x_low, width, height;
        extent_of(tracer, f, &x_low, &width, &height);
        double x = 0.5 * (double)(piece->from[0] + piece->to[0]) - x_low;
        cell += cell_at(x, width, across) +
                across * cell_at(0.5 * (double)(piece->from[1] + piece->to[1]), height, count / across);
    }
    piece->next_in_cell = cells->heads[cell];
    cells->heads[cell] = number;
}

enum hatch_status hatch_trace_sort(struct hatch_tracer *tracer, struct hatch_err *err)
{
    uint32_t count = tracer->region ? tracer->region->count : tracer->component->face_count;
    struct hatch_trace_cells *cells = &tracer->cells;
    double gaps = tracer->region ? CELL_GAPS_OF_REGION : CELL_GAPS;
    double size = gaps * fmax(tracer->gap, tracer->leg_max), sum = 0;
    HATCH_TRY(HATCH_ALLOC_UNSET(tracer->keep, &cells->first, (size_t)count + 1, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(tracer->keep, &cells->across, count, err));
    for (uint32_t f = 0; f < count; f++) {
        double x_low, width, height;
        extent_of(tracer, f, &x_low, &width, &height);
        cells->first[f] = (uint32_t)sum;
        cells->across[f] = (uint16_t)cells_along(width, size);
        sum += (double)cells->across[f] * cells_along(height, size);
        if (sum >= UINT32_MAX)
            return hatch_fail(err, HATCH_LIMIT, "too many strokes: use a wider gap or fewer levels");
    }
    cells->first[count] = (uint32_t)sum;
    cells->count = (uint32_t)sum;
    HATCH_TRY(HATCH_ALLOC_UNSET(tracer->keep, &cells->heads, (size_t)sum, err));
    for (uint32_t i = 0; i < (uint32_t)sum; i++)
        cells->heads[i] = HATCH_TRACE_NONE;
    for (uint32_t i = 0; i < tracer->piece_count; i++)
        put_in_cell(tracer, i);
    return HATCH_OK;
}

/* Returns the new number of a piece. */
static uint32_t renumbered(const uint32_t *number, uint32_t piece)
{
    return piece == HATCH_TRACE_NONE ? HATCH_TRACE_NONE : number[piece];
}

enum hatch_status hatch_trace_gather(struct hatch_tracer *tracer, struct hatch_err *err)
{
    struct hatch_trace_piece *gathered;
    struct hatch_arena_mark mark = hatch_arena_mark(tracer->scratch);
    uint32_t *number, next = 0, cells = tracer->cells.count;
    void *array;
    HATCH_TRY(HATCH_ALLOC_UNSET(tracer->scratch, &number, tracer->piece_count, err));
    HATCH_TRY(hatch_trace_room_swap(tracer->piece_room, tracer->pieces, sizeof *gathered, tracer->piece_capacity,
                                    &array, err));
    gathered = array;
    for (uint32_t cell = 0; cell < cells; cell++)
        for (uint32_t n = tracer->cells.heads[cell]; n != HATCH_TRACE_NONE; n = tracer->pieces[n].next_in_cell)
            number[n] = next++;
    for (uint32_t n = 0; n < tracer->piece_count; n++) {
        struct hatch_trace_piece *piece = &gathered[number[n]];
        *piece = tracer->pieces[n];
        piece->next = renumbered(number, piece->next);
        piece->next_in_cell = renumbered(number, piece->next_in_cell);
    }
    for (uint32_t cell = 0; cell < cells; cell++)
        tracer->cells.heads[cell] = renumbered(number, tracer->cells.heads[cell]);
    for (uint32_t s = 0; s < tracer->stroke_count; s++)
        for (int way = 0; way < 2; way++) {
            tracer->strokes[s].first[way] = renumbered(number, tracer->strokes[s].first[way]);
            tracer->strokes[s].last[way] = renumbered(number, tracer->strokes[s].last[way]);
        }
    tracer->pieces = gathered;
    hatch_arena_rewind(tracer->scratch, mark);
    return HATCH_OK;
}

enum hatch_status hatch_trace_add_stroke(struct hatch_tracer *tracer, const struct hatch_trace_seed *seed,
                                         struct hatch_err *err)
{
    HATCH_TRY(hatch_curve_reserve(tracer->keep, &tracer->strokes, sizeof *tracer->strokes, tracer->stroke_count,
                                  &tracer->stroke_capacity, err));
    struct hatch_trace_stroke *stroke = &tracer->strokes[tracer->stroke_count++];
    *stroke = (struct hatch_trace_stroke){.id = seed->id,
                                          .seed = seed->place,
                                          .level = tracer->level,
                                          .growing = {true, true},
                                          .first = {HATCH_TRACE_NONE, HATCH_TRACE_NONE},
                                          .last = {HATCH_TRACE_NONE, HATCH_TRACE_NONE},
                                          .end = {seed->place, seed->place}};
    for (int k = 0; k < 2; k++)
        stroke->end[1].heading[k] = -stroke->end[1].heading[k];
    for (uint32_t way = 0; way < 2; way++) {
        double share = 0.5 + 0.5 * (double)hatch_random_unit(tracer->seed, seed->id, way);
        stroke->length_max[way] = share * tracer->options->length / 2 * tracer->gap;
    }
    return HATCH_OK;
}

enum hatch_status hatch_trace_add_piece(struct hatch_tracer *tracer, uint32_t half, const struct hatch_trace_leg *leg,
                                        struct hatch_err *err)
{
    struct hatch_trace_stroke *stroke = &tracer->strokes[half / 2];
    const double *origin = hatch_trace_origin_of(tracer, leg->face);
    uint32_t way = half % 2, number = tracer->piece_count;
    HATCH_TRY(hatch_trace_room_reserve(tracer->piece_room, &tracer->pieces, sizeof *tracer->pieces, tracer->piece_count,
                                       &tracer->piece_capacity, err));
    stroke->length[way] += leg->length;
    tracer->pieces[tracer->piece_count++] = (struct hatch_trace_piece){.face = leg->face,
                                                                       .half = half,
                                                                       .arc = (float)stroke->length[way],
                                                                       .round = tracer->round,
                                                                       .next = HATCH_TRACE_NONE};
    for (int k = 0; k < 2; k++) {
        tracer->pieces[number].from[k] = hatch_trace_local(tracer, leg->from[k], origin[k]);
        tracer->pieces[number].to[k] = hatch_trace_local(tracer, leg->to[k], origin[k]);
    }
    if (stroke->last[way] == HATCH_TRACE_NONE)
        stroke->first[way] = number;
    else
        tracer->pieces[stroke->last[way]].next = number;
    stroke->last[way] = number;
    put_in_cell(tracer, number);
    return HATCH_OK;
}

/* Returns whether a piece runs against the heading of a stroke, to which `way` is at a right angle. */
static bool is_opposed(const struct hatch_trace_piece *piece, const float way[2], double turn)
{
    float along[2] = {piece->to[0] - piece->from[0], piece->to[1] - piece->from[1]};
    return (way[1] * along[0] - way[0] * along[1]) * (float)turn < 0;
}

/* Returns whether a piece of the origin's own stroke is part of another winding, around a tube or in a spiral: it runs
 * the same way, and is farther off along the stroke than aside.
 *   along  the stroke to the piece */
static bool is_winding(const struct hatch_tracer *tracer, const struct hatch_trace_piece *piece, const float at[2],
                       const float from[2], const float way[2], const struct hatch_trace_origin *origin, double along)
{
    bool backward = piece->half % 2;
    return origin->turn != 0 && along > HATCH_TRACE_WINDING * tracer->gap &&
           is_opposed(piece, way, origin->turn) == (backward != origin->backward) &&
           along > origin->walked + (double)hypotf(at[0] - from[0], at[1] - from[1]);
}

/* Returns whether a piece does not hinder the way from an origin, which it crosses at a place of the face. */
static bool is_ignored(const struct hatch_tracer *tracer, const struct hatch_trace_piece *piece, const float at[2],
                       const float from[2], const float way[2], const struct hatch_trace_origin *origin)
{
    uint32_t stroke = piece->half / 2;
    double arc = (double)(piece->arc - hypotf(piece->to[0] - at[0], piece->to[1] - at[1]));
    if (stroke == origin->stroke) {
        double along = fabs((piece->half % 2 ? -arc : arc) - origin->arc);
        return along < OWN_GAPS * tracer->gap && !is_winding(tracer, piece, at, from, way, origin, along);
    }
    bool opposed = is_opposed(piece, way, origin->turn);
    if (opposed && origin->passes)
        return tracer->strokes[stroke].length[piece->half % 2] - arc < OVERLAP_GAPS * tracer->gap;
    return !opposed && origin->growing && piece->round + 1 == tracer->round &&
           tracer->strokes[stroke].growing[piece->half % 2] &&
           tracer->strokes[stroke].id < tracer->strokes[origin->stroke].id;
}

/* Returns the share of a way at which the first piece of a cell crosses it, or HUGE_VALF. */
static float first_in_cell(const struct hatch_tracer *tracer, uint32_t cell, const float from[2], const float way[2],
                           const struct hatch_trace_origin *origin)
{
    float nearest = HUGE_VALF;
    for (uint32_t n = tracer->cells.heads[cell]; n != HATCH_TRACE_NONE; n = tracer->pieces[n].next_in_cell) {
        const struct hatch_trace_piece *piece = &tracer->pieces[n];
        float along[2] = {piece->to[0] - piece->from[0], piece->to[1] - piece->from[1]};
        float off[2] = {piece->from[0] - from[0], piece->from[1] - from[1]};
        float area = 1 / (way[0] * along[1] - way[1] * along[0]); /* not finite where they are parallel */
        float on_way = (off[0] * along[1] - off[1] * along[0]) * area;
        float on_piece = (off[0] * way[1] - off[1] * way[0]) * area;
        /* A single branch, which is rarely taken: most pieces of a face are beside the way. */
        if (!((on_way >= 0) & (on_way <= 1) & (on_way < nearest) & (on_piece >= -SLACK) & (on_piece <= 1 + SLACK)))
            continue;
        const float at[2] = {from[0] + on_way * way[0], from[1] + on_way * way[1]};
        if (!is_ignored(tracer, piece, at, from, way, origin))
            nearest = on_way;
    }
    return nearest;
}

double hatch_trace_look(const struct hatch_tracer *tracer, const struct hatch_trace_leg *leg,
                        const struct hatch_trace_origin *origin)
{
    const struct hatch_trace_cells *cells = &tracer->cells;
    uint32_t f = row_of(tracer, leg->face);
    if (f == HATCH_NO_SIDE)
        return HUGE_VAL;
    const double *corner = hatch_trace_origin_of(tracer, leg->face);
    uint32_t first = cells->first[f], across = cells->across[f], count = cells->first[f + 1] - first;
    float nearest = HUGE_VALF;
    float from[2], way[2];
    for (int k = 0; k < 2; k++) {
        from[k] = hatch_trace_local(tracer, leg->from[k], corner[k]);
        way[k] = tracer->region ? hatch_trace_local(tracer, leg->to[k], corner[k]) - from[k]
                                : (float)(leg->to[k] - leg->from[k]);
    }
    if (count == 1) {
        nearest = first_in_cell(tracer, first, from, way, origin);
    } else {
        double x_low, width, height, margin = 0.5 * tracer->leg_max;
        extent_of(tracer, f, &x_low, &width, &height);
        double left = (double)from[0] - x_low, low = (double)from[1], right = left + (double)way[0];
        double high = low + (double)way[1];
        uint32_t x0 = cell_at(fmin(left, right) - margin, width, across);
        uint32_t x1 = cell_at(fmax(left, right) + margin, width, across);
        uint32_t y0 = cell_at(fmin(low, high) - margin, height, count / across);
        uint32_t y1 = cell_at(fmax(low, high) + margin, height, count / across);
        for (uint32_t y = y0; y <= y1; y++)
            for (uint32_t x = x0; x <= x1; x++) {
                float share = first_in_cell(tracer, first + x + across * y, from, way, origin);
                nearest = share < nearest ? share : nearest;
            }
    }
    return nearest < HUGE_VALF ? (double)nearest * leg->length : HUGE_VAL;
}

double hatch_trace_cast(const struct hatch_tracer *tracer, struct hatch_trace_place *place, double reach,
                        const struct hatch_trace_origin *origin, double *border)
{
    struct hatch_trace_origin from = *origin;
    *border = 0;
    for (uint32_t n = 0; n < HATCH_TRACE_LEGS_MAX && reach - from.walked > 1e-6 * tracer->gap; n++) {
        struct hatch_trace_leg leg;
        bool goes_on = hatch_trace_walk(&tracer->ground, place, reach - from.walked, HATCH_TRACE_STRAIGHT, &leg);
        double met = hatch_trace_look(tracer, &leg, &from);
        if (met < HUGE_VAL)
            return from.walked + met;
        from.walked += leg.length;
        if (!goes_on) {
            *border = leg.side < 3 ? hatch_trace_steepness(&tracer->ground, &leg, place->heading) : 1;
            return from.walked;
        }
    }
    return reach;
}

struct hatch_trace_gaps hatch_trace_gaps_at(const struct hatch_tracer *tracer, const struct hatch_trace_place *place,
                                            const struct hatch_trace_origin *origin)
{
    double gap[2], reach = HATCH_TRACE_REACH * tracer->gap;
    for (int side = 0; side < 2; side++) {
        struct hatch_trace_place aside = *place;
        struct hatch_trace_origin from = *origin;
        double border, share;
        from.turn = side == 0 ? 1 : -1;
        hatch_trace_turn(&aside, from.turn);
        gap[side] = hatch_trace_cast(tracer, &aside, reach, &from, &border);
        if (border > 0) {
            share = fmin(fmax((border - OBLIQUE) / (PARALLEL - OBLIQUE), 0), 1);
            gap[side] = fmin(fmax(2 * gap[side], (1 - share) * tracer->gap), reach);
        }
        gap[side] = fmax(gap[side], GAP_LEAST * tracer->gap);
    }
    return (struct hatch_trace_gaps){gap[0], gap[1]};
}
