#include "cover/strokes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "stroke/path.h"

#define LENGTH_STEPS 16
#define LENGTH_MOST 16.0f /* of a listed stroke, in tiles */
#define GAP_MOST 0.3f     /* share of a stroke; where no texel within a longer part names it, it is taken as straight */

/* Reads a number that may be no valid id. */
static uint32_t id_of(float number)
{
    return number >= 1 && number <= (float)HATCH_COVER_ID_MAX ? (uint32_t)number : 0;
}

static float ink_of(const float *texel, bool color)
{
    float light = color ? (texel[0] + texel[1] + texel[2]) / 3 : texel[0];
    return fminf(fmaxf(1 - light, 0), 1);
}

uint32_t hatch_cover_find_owners(const struct hatch_tam *tam, uint32_t level, struct hatch_cover_owner *owners)
{
    const struct hatch_image *any = &tam->columns[0].levels[level];
    size_t count = (size_t)any->width * any->height, channels = any->channel_count;
    int id_channel = hatch_image_channel(any, "id"), t_channel = hatch_image_channel(any, "t");
    uint32_t id_max = 0;
    for (size_t i = 0; i < count; i++)
        owners[i] = (struct hatch_cover_owner){0};
    for (uint32_t column = 0; column < tam->tones; column++) {
        const float *texel = tam->columns[column].levels[level].pixels;
        for (size_t i = 0; i < count; i++, texel += channels) {
            uint32_t id = owners[i].id ? 0 : id_of(texel[id_channel]);
            if (!id)
                continue;
            owners[i] =
                (struct hatch_cover_owner){id, column, fminf(fmaxf(texel[t_channel], 0), 1), ink_of(texel, tam->color)};
            id_max = id > id_max ? id : id_max;
        }
    }
    return id_max;
}

enum hatch_status hatch_cover_group(const struct hatch_cover_owner *owners, uint32_t texel_count, uint32_t id_max,
                                    struct hatch_arena *arena, struct hatch_cover_texels *texels, struct hatch_err *err)
{
    uint32_t *first;
    HATCH_TRY(HATCH_ALLOC(arena, &first, (size_t)id_max + 3, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &texels->at, texel_count, err));
    /* Counts move up by two entries, so that filling leaves each first texel in its own. */
    for (uint32_t i = 0; i < texel_count; i++)
        first[owners[i].id + 2]++;
    for (uint32_t id = 1; id < id_max + 3; id++)
        first[id] += first[id - 1];
    for (uint32_t i = 0; i < texel_count; i++)
        texels->at[first[owners[i].id + 1]++] = i;
    texels->first = first;
    return HATCH_OK;
}

/* Orders fragments along the stroke; those at one place by row and column. */
static int compare(const void *a, const void *b)
{
    const struct hatch_fragment *first = a, *second = b;
    if (first->t < second->t || first->t > second->t)
        return first->t > second->t ? 1 : -1;
    if (first->y < second->y || first->y > second->y)
        return first->y > second->y ? 1 : -1;
    return first->x > second->x ? 1 : first->x < second->x ? -1 : 0;
}

/* Moves each fragment by whole tiles next to the one before it, and all of them to where no coordinate is negative. */
static void unwrap(struct hatch_fragment *fragments, uint32_t count, float size)
{
    float least[2] = {fragments->x, fragments->y};
    for (uint32_t i = 1; i < count; i++) {
        fragments[i].x += size * rintf((fragments[i - 1].x - fragments[i].x) / size);
        fragments[i].y += size * rintf((fragments[i - 1].y - fragments[i].y) / size);
        least[0] = fminf(least[0], fragments[i].x);
        least[1] = fminf(least[1], fragments[i].y);
    }
    for (uint32_t i = 0; i < count; i++) {
        fragments[i].x -= size * floorf(least[0] / size);
        fragments[i].y -= size * floorf(least[1] / size);
    }
}

void hatch_cover_stroke_at(const struct hatch_cover_stroke *stroke, float t, float place[2])
{
    hatch_cubic_at(&stroke->curve, hatch_cubic_u(&stroke->curve, t), place);
    place[0] += stroke->shift[0];
    place[1] += stroke->shift[1];
}

/* Returns the longest part of a stroke, in t, without a fragment. */
static float longest_gap(const struct hatch_fragment *fragments, uint32_t count)
{
    float gap = fmaxf(fragments[0].t, 1 - fragments[count - 1].t);
    for (uint32_t i = 1; i < count; i++)
        gap = fmaxf(gap, fragments[i].t - fragments[i - 1].t);
    return gap;
}

/* Replaces a cubic by the straight line through its fragments. */
static void straighten(const struct hatch_fragment *fragments, uint32_t count, struct hatch_cubic *cubic)
{
    double n = count, u_sum = 0, square = 0, places[2] = {0, 0}, products[2] = {0, 0};
    for (uint32_t i = 0; i < count; i++) {
        double u = (double)hatch_cubic_u(cubic, fragments[i].t);
        const double place[2] = {(double)(fragments[i].x - cubic->origin[0]),
                                 (double)(fragments[i].y - cubic->origin[1])};
        u_sum += u;
        square += u * u;
        for (int axis = 0; axis < 2; axis++) {
            places[axis] += place[axis];
            products[axis] += u * place[axis];
        }
    }
    double spread = n * square - u_sum * u_sum;
    for (int axis = 0; axis < 2; axis++) {
        double slope = spread > 1e-9 ? (n * products[axis] - u_sum * places[axis]) / spread : 0;
        const float factor[HATCH_CUBIC_TERMS] = {(float)((places[axis] - slope * u_sum) / n), (float)slope};
        memcpy(cubic->factor[axis], factor, sizeof factor);
    }
}

static float measure(const struct hatch_cover_stroke *stroke)
{
    float length = 0, before[2], here[2];
    hatch_cover_stroke_at(stroke, 0, before);
    for (int k = 1; k <= LENGTH_STEPS; k++) {
        hatch_cover_stroke_at(stroke, (float)k / LENGTH_STEPS, here);
        length += hypotf(here[0] - before[0], here[1] - before[1]);
        before[0] = here[0];
        before[1] = here[1];
    }
    return length;
}

/* Moves the middle of a stroke into the tile, and measures it. */
static void finish(uint32_t size, struct hatch_cover_stroke *stroke)
{
    float middle[2];
    hatch_cover_stroke_at(stroke, 0.5f, middle);
    for (int axis = 0; axis < 2; axis++)
        stroke->shift[axis] = -(float)size * floorf(middle[axis] / (float)size);
    stroke->length = measure(stroke);
}

static void fit_stroke(const struct hatch_cover_owner *owners, const uint32_t *at, uint32_t count, uint32_t size,
                       struct hatch_fragment *fragments, struct hatch_cover_stroke *stroke)
{
    *stroke = (struct hatch_cover_stroke){.is_there = true, .texel_count = count, .column = owners[*at].column};
    for (uint32_t i = 0; i < count; i++) {
        const struct hatch_cover_owner *owner = &owners[at[i]];
        fragments[i] = (struct hatch_fragment){owner->t, (float)(at[i] % size) + 0.5f, (float)(at[i] / size) + 0.5f, 1};
        if (owner->column < stroke->column)
            stroke->column = owner->column;
    }
    qsort(fragments, count, sizeof *fragments, compare);
    unwrap(fragments, count, (float)size);
    hatch_cubic_fit(fragments, count, &stroke->curve);
    if (longest_gap(fragments, count) > GAP_MOST)
        straighten(fragments, count, &stroke->curve);
    finish(size, stroke);
}

/* Takes the curve of a listed stroke. */
static void take_listed(const struct hatch_stroke *listed, uint32_t size, struct hatch_cover_stroke *stroke)
{
    struct hatch_fragment fragments[LENGTH_STEPS + 1];
    float least[2] = {HUGE_VALF, HUGE_VALF};
    for (int k = 0; k <= LENGTH_STEPS; k++) {
        float place[2], t = (float)k / LENGTH_STEPS;
        hatch_stroke_place(listed, t, place);
        fragments[k] = (struct hatch_fragment){t, place[0] * (float)size, place[1] * (float)size, 1};
        least[0] = fminf(least[0], fragments[k].x);
        least[1] = fminf(least[1], fragments[k].y);
    }
    for (int k = 0; k <= LENGTH_STEPS; k++) { /* no coordinate is negative */
        fragments[k].x -= (float)size * floorf(least[0] / (float)size);
        fragments[k].y -= (float)size * floorf(least[1] / (float)size);
    }
    stroke->is_there = true;
    stroke->column = listed->column;
    hatch_cubic_fit(fragments, LENGTH_STEPS + 1, &stroke->curve);
    finish(size, stroke);
}

void hatch_cover_add_listed(const struct hatch_stroke_list *list, uint32_t size_px, uint32_t id_max,
                            struct hatch_cover_stroke *strokes)
{
    for (uint32_t i = 0; i < list->count; i++) {
        const struct hatch_stroke *listed = &list->items[i];
        if (listed->id < 1 || listed->id > id_max || listed->length > LENGTH_MOST)
            continue;
        strokes[listed->id].original = listed;
        if (!strokes[listed->id].is_there)
            take_listed(listed, size_px, &strokes[listed->id]);
    }
}

enum hatch_status hatch_cover_fit_strokes(const struct hatch_tam *tam, const struct hatch_cover_owner *owners,
                                          const struct hatch_cover_texels *texels, uint32_t id_max,
                                          struct hatch_arena *scratch, struct hatch_cover_stroke *strokes,
                                          struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_fragment *fragments;
    uint32_t most = 0;
    for (uint32_t id = 1; id <= id_max; id++) {
        uint32_t count = texels->first[id + 1] - texels->first[id];
        most = count > most ? count : most;
    }
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &fragments, most, err));
    strokes[0] = (struct hatch_cover_stroke){0};
    for (uint32_t id = 1; id <= id_max; id++) {
        uint32_t first = texels->first[id], count = texels->first[id + 1] - first;
        strokes[id] = (struct hatch_cover_stroke){0};
        if (count)
            fit_stroke(owners, texels->at + first, count, tam->size_px, fragments, &strokes[id]);
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
