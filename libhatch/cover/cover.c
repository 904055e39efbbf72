#include "cover/cover.h"

#include <math.h>
#include <string.h>

#include "cover/strokes.h"

#define SHARE_LEAST 0.04f /* a stroke that covers less of a texel is not listed below others */
#define T_BINS 16
#define AWAY_BINS 64
#define AWAY_STEP 0.25f /* texels */
#define BELOW 0.995     /* share of a map's texels within the reach of their strokes' curves */
#define DARK 0.95       /* share of inked texels that are no darker than a stroke */
#define INK_BINS 256
#define STROKES_PER_TEXEL 16 /* at most so many strokes per texel of the finest level */
#define STEP_TEXELS 2.0f     /* length of the pieces of a curve of which the nearest is found */

/* A stroke below a texel, or at it. */
struct near {
    uint32_t at; /* texel */
    int x, y;    /* the texel's place in the stroke's own plane, where the middle is in the tile */
    float t, away;
};

/* A mark and the texel that it belongs to. */
struct placed {
    uint32_t at;
    struct hatch_cover_mark mark;
};

struct maker {
    const struct hatch_tam *tam;
    const struct hatch_stroke_list *list;
    struct hatch_cover_stroke *strokes;
    uint32_t id_max;
    struct hatch_cover_owner *owners; /* of the level */
    struct hatch_cover_texels texels; /* of the level */
    uint32_t size;                    /* of the level */
    float scale;                      /* its size as a share of the finest level's */
    uint32_t *slot_of;                /* per texel: index of its entry in `near`, plus 1; 0: none */
    struct near *near;                /* texels near the stroke in hand */
    uint32_t near_count;
    float reach;                        /* distance of texels from their stroke's curve */
    float share[T_BINS][AWAY_BINS + 1]; /* mean ink of a stroke's texels, by t and distance */
    float ink;
    uint32_t *columns; /* per stroke: the first column of the level or of a coarser one that names it */
    struct placed *placed;
    size_t placed_count, placed_room;
};

/* Computes where a stroke is at t, in texels of the level. */
static void place_at(const struct maker *maker, const struct hatch_cover_stroke *stroke, float t, float place[2])
{
    hatch_cover_stroke_at(stroke, t, place);
    place[0] *= maker->scale;
    place[1] *= maker->scale;
}

/* Notes that a texel lies near a stroke, or that it lies nearer than was known. */
static void note(struct maker *maker, int x, int y, float t, float away)
{
    int size = (int)maker->size, column = (x % size + size) % size, row = (y % size + size) % size;
    uint32_t at = (uint32_t)(row * size + column), slot = maker->slot_of[at];
    if (!slot) {
        maker->near[maker->near_count] = (struct near){at, x, y, t, away};
        maker->slot_of[at] = ++maker->near_count;
    } else if (away < maker->near[slot - 1].away)
        maker->near[slot - 1] = (struct near){at, x, y, t, away};
}

/* Notes the texels around a piece of a curve, from t[0] to t[1]. */
static void note_piece(struct maker *maker, const float from[2], const float to[2], const float t[2])
{
    float way[2] = {to[0] - from[0], to[1] - from[1]}, square = way[0] * way[0] + way[1] * way[1];
    int low[2], high[2];
    for (int axis = 0; axis < 2; axis++) {
        low[axis] = (int)floorf(fminf(from[axis], to[axis]) - maker->reach);
        high[axis] = (int)floorf(fmaxf(from[axis], to[axis]) + maker->reach);
    }
    for (int y = low[1]; y <= high[1]; y++)
        for (int x = low[0]; x <= high[0]; x++) {
            float at[2] = {(float)x + 0.5f - from[0], (float)y + 0.5f - from[1]};
            float share = square > 0 ? (at[0] * way[0] + at[1] * way[1]) / square : 0;
            share = fminf(fmaxf(share, 0), 1);
            float away = hypotf(at[0] - share * way[0], at[1] - share * way[1]);
            if (away <= maker->reach)
                note(maker, x, y, t[0] + share * (t[1] - t[0]), away);
        }
}

/* Finds the texels near a stroke. */
static void find_near(struct maker *maker, const struct hatch_cover_stroke *stroke)
{
    float length = stroke->length * maker->scale, from[2], to[2];
    int pieces = (int)ceilf(fminf(length / STEP_TEXELS, (float)maker->size)) + 1;
    maker->near_count = 0;
    place_at(maker, stroke, 0, from);
    for (int k = 0; k < pieces; k++) {
        const float t[2] = {(float)k / (float)pieces, (float)(k + 1) / (float)pieces};
        place_at(maker, stroke, t[1], to);
        note_piece(maker, from, to, t);
        memcpy(from, to, sizeof from);
    }
    for (uint32_t i = 0; i < maker->near_count; i++)
        maker->slot_of[maker->near[i].at] = 0;
}

/* Returns the distance of a texel from the place of its stroke at its t, and its place in the stroke's plane. */
static float distance_of(const struct maker *maker, uint32_t at, int *x, int *y)
{
    const struct hatch_cover_owner *owner = &maker->owners[at];
    float place[2], size = (float)maker->size;
    place_at(maker, &maker->strokes[owner->id], owner->t, place);
    float column = (float)(at % maker->size) + 0.5f, row = (float)(at / maker->size) + 0.5f;
    column += size * rintf((place[0] - column) / size);
    row += size * rintf((place[1] - row) / size);
    *x = (int)floorf(column);
    *y = (int)floorf(row);
    return hypotf(column - place[0], row - place[1]);
}

/* Returns the value below which a share of the counted ones lie, as an upper limit in bins. */
static uint32_t quantile(const uint32_t *counts, uint32_t bins, double share)
{
    uint64_t whole = 0, sum = 0;
    uint32_t i = 0;
    for (uint32_t k = 0; k < bins; k++)
        whole += counts[k];
    while (i < bins && (double)(sum += counts[i]) < share * (double)whole)
        i++;
    return i + 1;
}

/* Measures how far texels of the finest level lie from their strokes' curves, and how dark they are. */
static void measure_texels(struct maker *maker)
{
    uint32_t away[AWAY_BINS] = {0}, ink[INK_BINS] = {0}, count = maker->size * maker->size;
    for (uint32_t i = 0; i < count; i++) {
        int x, y;
        if (!maker->owners[i].id)
            continue;
        float bin = distance_of(maker, i, &x, &y) / AWAY_STEP;
        away[bin < AWAY_BINS ? (int)bin : AWAY_BINS - 1]++;
        ink[(int)(maker->owners[i].ink * (INK_BINS - 1) + 0.5f)]++;
    }
    maker->reach = AWAY_STEP * (float)quantile(away, AWAY_BINS, BELOW);
    maker->ink = fmaxf((float)(quantile(ink, INK_BINS, DARK) - 1) / (INK_BINS - 1), 1.0f / (INK_BINS - 1));
}

static int bin_of_t(float t)
{
    return t < 1 ? (int)(t * T_BINS) : T_BINS - 1;
}

/* Computes the mean ink of strokes' texels from those of the finest level that are not below other strokes. */
static void measure_share(struct maker *maker)
{
    uint32_t counts[T_BINS][AWAY_BINS] = {{0}};
    for (uint32_t id = 1; id <= maker->id_max; id++) {
        const struct hatch_cover_stroke *stroke = &maker->strokes[id];
        if (!stroke->texel_count)
            continue;
        find_near(maker, stroke);
        for (uint32_t i = 0; i < maker->near_count; i++) {
            const struct near *near = &maker->near[i];
            const struct hatch_cover_owner *owner = &maker->owners[near->at];
            int bin = (int)fminf(near->away / AWAY_STEP, AWAY_BINS - 1), along = bin_of_t(near->t);
            bool own = owner->id == id, bare = !owner->id || owner->column > stroke->column;
            counts[along][bin] += own || bare;
            maker->share[along][bin] += own ? owner->ink : 0;
        }
    }
    for (int along = 0; along < T_BINS; along++)
        for (int bin = 0; bin < AWAY_BINS; bin++)
            maker->share[along][bin] /= counts[along][bin] ? (float)counts[along][bin] : 1;
}

/* Returns the mean width of strokes in texels where they are widest: the ink across them. */
static float widest(const struct maker *maker)
{
    float most = 0;
    for (int along = 0; along < T_BINS; along++) {
        float sum = 0;
        for (int bin = 0; bin < AWAY_BINS; bin++)
            sum += maker->share[along][bin];
        most = fmaxf(most, sum);
    }
    return fmaxf(2 * AWAY_STEP * most / maker->ink, 0.5f);
}

/* Adds a mark. The list of them grows in the scratch arena.
 *   x, y  the texel's place in the stroke's plane */
static enum hatch_status add(struct maker *maker, const struct near *near, uint32_t id, float ink, uint32_t column,
                             struct hatch_arena *scratch, struct hatch_err *err)
{
    int size = (int)maker->size;
    /* The stroke's tile, as seen from that of the texel, is opposite to the texel's as seen from the stroke. */
    int u = HATCH_COVER_TILES - (int)floorf((float)near->x / (float)size);
    int v = HATCH_COVER_TILES - (int)floorf((float)near->y / (float)size);
    uint32_t layer = maker->strokes[id].column < 63 ? maker->strokes[id].column : 63;
    if (u < 0 || u > 2 * HATCH_COVER_TILES || v < 0 || v > 2 * HATCH_COVER_TILES)
        return HATCH_OK;
    if (maker->placed_count == maker->placed_room) {
        struct placed *more;
        size_t room = maker->placed_room ? 2 * maker->placed_room : 65536;
        HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &more, room, err));
        if (maker->placed_count)
            memcpy(more, maker->placed, sizeof *more * maker->placed_count);
        maker->placed = more;
        maker->placed_room = room;
    }
    const uint32_t t = (uint32_t)lrintf(near->t * (float)((1u << HATCH_COVER_MARK_T_BITS) - 1));
    const uint32_t share = (uint32_t)lrintf(255 * fminf(ink / maker->ink, 1));
    const uint32_t tile = (uint32_t)u | (uint32_t)v << 3;
    maker->placed[maker->placed_count++] =
        (struct placed){near->at,
                        {id | layer << HATCH_COVER_MARK_LAYER_SHIFT | tile >> 4 << HATCH_COVER_MARK_HIGH_SHIFT,
                         t | share << HATCH_COVER_MARK_COVER_SHIFT | column << HATCH_COVER_MARK_COLUMN_SHIFT |
                             tile << HATCH_COVER_MARK_TILE_SHIFT}};
    return HATCH_OK;
}

/* Marks the texels of a stroke: those that name it, and those where it is below others. */
static enum hatch_status mark_stroke(struct maker *maker, uint32_t id, struct hatch_arena *scratch,
                                     struct hatch_err *err)
{
    const uint32_t *at = maker->texels.at, begin = maker->texels.first[id], end = maker->texels.first[id + 1];
    for (uint32_t i = begin; i < end; i++) {
        const struct hatch_cover_owner *owner = &maker->owners[at[i]];
        struct near near = {.at = at[i], .t = owner->t};
        distance_of(maker, at[i], &near.x, &near.y);
        if (owner->column < maker->columns[id])
            maker->columns[id] = owner->column;
        HATCH_TRY(add(maker, &near, id, owner->ink, owner->column, scratch, err));
    }
    if (maker->columns[id] == UINT32_MAX)
        return HATCH_OK;
    find_near(maker, &maker->strokes[id]);
    for (uint32_t i = 0; i < maker->near_count; i++) {
        const struct near *near = &maker->near[i];
        const struct hatch_cover_owner *owner = &maker->owners[near->at];
        float ink = maker->share[bin_of_t(near->t)][(int)fminf(near->away / AWAY_STEP, AWAY_BINS - 1)];
        bool below = owner->id && owner->id != id && owner->column <= maker->columns[id];
        if (below && ink >= SHARE_LEAST * maker->ink)
            HATCH_TRY(add(maker, near, id, ink, maker->columns[id], scratch, err));
    }
    return HATCH_OK;
}

/* Sets the first column in which a level has a listed stroke. */
static void take_column(struct maker *maker, uint32_t level, uint32_t id)
{
    const struct hatch_stroke *original = maker->strokes[id].original;
    if (original && level <= original->level && level < HATCH_STROKE_LEVELS_MAX &&
        original->column + original->delay[level] < maker->tam->tones)
        maker->columns[id] = original->column + original->delay[level];
}

/* Finds the owners of a level and the texels of each stroke. */
static enum hatch_status begin_level(struct maker *maker, uint32_t level, struct hatch_arena *scratch,
                                     struct hatch_err *err)
{
    uint32_t count;
    maker->size = hatch_mip_size(maker->tam->size_px, level);
    maker->scale = (float)maker->size / (float)maker->tam->size_px;
    count = maker->size * maker->size;
    hatch_cover_find_owners(maker->tam, level, maker->owners);
    for (uint32_t i = 0; i < count; i++) /* ids that the finest level does not name have no curve */
        if (maker->owners[i].id > maker->id_max || !maker->strokes[maker->owners[i].id].is_there)
            maker->owners[i].id = 0;
    return hatch_cover_group(maker->owners, count, maker->id_max, scratch, &maker->texels, err);
}

/* Marks the strokes of a level. Its texels come after those of coarser levels. */
static enum hatch_status mark_level(struct maker *maker, uint32_t level, struct hatch_arena *scratch,
                                    struct hatch_cover *cover, struct hatch_err *err)
{
    size_t before = maker->placed_count;
    HATCH_TRY(begin_level(maker, level, scratch, err));
    for (uint32_t id = 1; id <= maker->id_max; id++)
        if (maker->strokes[id].is_there) {
            take_column(maker, level, id);
            HATCH_TRY(mark_stroke(maker, id, scratch, err));
        }
    cover->first[level] = cover->texel_count;
    cover->texel_count += maker->size * maker->size;
    for (size_t i = before; i < maker->placed_count; i++)
        maker->placed[i].at += cover->first[level];
    return HATCH_OK;
}

/* Sorts the marks by texel. */
static enum hatch_status sort(const struct maker *maker, struct hatch_arena *arena, struct hatch_cover *cover,
                              struct hatch_err *err)
{
    uint32_t *ends;
    HATCH_TRY(HATCH_ALLOC(arena, &ends, (size_t)cover->texel_count + 2, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &cover->marks, maker->placed_count, err));
    /* Counts move up by two entries, so that filling leaves the first mark of each texel in its own. */
    for (size_t i = 0; i < maker->placed_count; i++)
        ends[maker->placed[i].at + 2]++;
    for (uint32_t i = 0; i < cover->texel_count; i++)
        ends[i + 2] += ends[i + 1];
    for (size_t i = 0; i < maker->placed_count; i++)
        cover->marks[ends[maker->placed[i].at + 1]++] = maker->placed[i].mark;
    cover->ends = ends;
    cover->mark_count = (uint32_t)maker->placed_count;
    return HATCH_OK;
}

/* Finds the strokes of the finest level and what they look like. */
static enum hatch_status find_strokes(struct maker *maker, struct hatch_arena *scratch, struct hatch_err *err)
{
    uint32_t count = maker->tam->size_px * maker->tam->size_px;
    maker->size = maker->tam->size_px;
    maker->scale = 1;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &maker->owners, count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &maker->slot_of, count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &maker->near, count, err));
    maker->id_max = hatch_cover_find_owners(maker->tam, 0, maker->owners);
    for (uint32_t i = 0; i < maker->list->count; i++)
        if (maker->list->items[i].id > maker->id_max && maker->list->items[i].id <= HATCH_COVER_ID_MAX)
            maker->id_max = maker->list->items[i].id;
    if (maker->id_max / STROKES_PER_TEXEL > count)
        return hatch_fail(err, HATCH_BAD_INPUT, "id %u, but the finest level has only %u texels", maker->id_max, count);
    HATCH_TRY(hatch_cover_group(maker->owners, count, maker->id_max, scratch, &maker->texels, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &maker->strokes, (size_t)maker->id_max + 1, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &maker->columns, (size_t)maker->id_max + 1, err));
    for (uint32_t id = 0; id <= maker->id_max; id++)
        maker->columns[id] = UINT32_MAX;
    HATCH_TRY(hatch_cover_fit_strokes(maker->tam, maker->owners, &maker->texels, maker->id_max, scratch, maker->strokes,
                                      err));
    hatch_cover_add_listed(maker->list, maker->size, maker->id_max, maker->strokes);
    measure_texels(maker);
    measure_share(maker);
    return HATCH_OK;
}

/* Makes the lists; leaves its own arrays in the scratch arena. */
static enum hatch_status make(const struct hatch_tam *tam, const struct hatch_stroke_list *strokes,
                              struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_cover *cover,
                              struct hatch_err *err)
{
    struct maker *maker;
    HATCH_TRY(HATCH_ALLOC(scratch, &maker, 1, err));
    maker->tam = tam;
    maker->list = strokes;
    HATCH_TRY(find_strokes(maker, scratch, err));
    cover->width_px = widest(maker);
    cover->ink = maker->ink;
    for (uint32_t level = tam->levels; level-- > 0;) /* what a coarser level names is on finer ones, too */
        HATCH_TRY(mark_level(maker, level, scratch, cover, err));
    return sort(maker, arena, cover, err);
}

enum hatch_status hatch_cover_make(const struct hatch_tam *tam, const struct hatch_stroke_list *strokes,
                                   struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_cover *cover,
                                   struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_cover made = {.levels = tam->levels};
    enum hatch_status status = make(tam, strokes, arena, scratch, &made, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *cover = made;
    return status;
}
