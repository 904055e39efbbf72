#include <math.h>
#include <string.h>

#include "lapped/atlas.h"
#include "lapped/heap.h"
#include "mesh/edges.h"

/* Places of a face at which it is asked which patch shows. */
#define SAMPLES_SIDE 4
#define SAMPLES (SAMPLES_SIDE * (SAMPLES_SIDE + 1) / 2)
/* Faces of a chart may run into each other by this share of their width: their coordinates are
 * rounded. */
#define TOUCH 0.01

struct charting {
    const struct hatch_surface *surface;
    const struct hatch_lapped *lapped;
    struct hatch_arena *arena;
    struct hatch_charts charts;
    uint32_t *patch, *entry; /* per face of the surface: which shows most of it, and the face there */
    /* Faces by the cells of a grid over one patch. */
    double low[2], cell;
    uint32_t cells[2];
    uint32_t *head, head_room;
    struct node {
        uint32_t next, face;
    } * nodes;
    uint32_t node_count, node_room;
    uint32_t *queue, queue_room;
};

/* How many places of the entry's face show this patch and none above it; left: those not yet shown. */
static uint32_t count_shown(const struct hatch_lapped *lapped, const struct hatch_outline *outline,
                            const struct hatch_lapped_patch *patch, uint32_t entry, uint16_t *left)
{
    const struct hatch_lapped_vertex *at[3];
    for (uint32_t c = 0; c < 3; c++)
        at[c] = &lapped->vertices[patch->first_vertex + lapped->corners[3 * (size_t)entry + c]];
    uint32_t shown = 0, bit = 0;
    for (int i = 0; i < SAMPLES_SIDE; i++) {
        for (int j = 0; i + j < SAMPLES_SIDE; j++, bit++) {
            double a = (i + 1.0 / 3) / SAMPLES_SIDE, b = (j + 1.0 / 3) / SAMPLES_SIDE, place[2];
            for (int k = 0; k < 2; k++)
                place[k] =
                    a * (double)at[0]->mask[k] + b * (double)at[1]->mask[k] + (1 - a - b) * (double)at[2]->mask[k];
            if (*left >> bit & 1 && hatch_outline_opacity(outline, place) >= 0.5) {
                *left = (uint16_t)(*left & ~(1u << bit));
                shown++;
            }
        }
    }
    return shown;
}

/* Finds for every face the patch that shows most of it, from the uppermost down. */
static enum hatch_status choose_patches(struct charting *of, const struct hatch_outline *outline, struct hatch_err *err)
{
    const struct hatch_lapped *lapped = of->lapped;
    uint32_t count = of->surface->face_count;
    of->patch = HATCH_NEW(of->arena, uint32_t, count, err);
    of->entry = of->patch ? HATCH_NEW(of->arena, uint32_t, count, err) : NULL;
    uint16_t *left = of->entry ? HATCH_NEW(of->arena, uint16_t, count, err) : NULL;
    uint8_t *most = left ? HATCH_NEW(of->arena, uint8_t, count, err) : NULL;
    if (!most)
        return HATCH_LIMIT;
    memset(left, 0xff, count * sizeof *left);
    memset(of->patch, 0xff, count * sizeof *of->patch);
    for (uint32_t p = lapped->patch_count; p-- > 0;) {
        const struct hatch_lapped_patch *patch = &lapped->patches[p];
        for (uint32_t e = patch->first_face; e < patch->first_face + patch->face_count; e++) {
            uint32_t face = lapped->faces[e];
            uint32_t shown = count_shown(lapped, outline, patch, e, &left[face]);
            if (of->patch[face] == UINT32_MAX || shown > most[face]) {
                most[face] = (uint8_t)shown;
                of->patch[face] = p;
                of->entry[face] = e;
            }
        }
    }
    return HATCH_OK;
}

static void find_places(const struct charting *of, uint32_t face)
{
    const struct hatch_lapped *lapped = of->lapped;
    const struct hatch_lapped_patch *patch = &lapped->patches[of->patch[face]];
    for (uint32_t c = 0; c < 3; c++) {
        uint32_t vertex = patch->first_vertex + lapped->corners[3 * (size_t)of->entry[face] + c];
        for (uint32_t i = 0; i < 2; i++)
            of->charts.places[6 * (size_t)face + 2 * c + i] = lapped->vertices[vertex].hatch[i];
    }
}

/* Whether the line along a side of a keeps the two triangles apart. */
static bool side_parts(const double *a, const double *b, int side)
{
    const double *from = &a[2 * side], *to = &a[2 * ((side + 1) % 3)];
    double x = to[1] - from[1], y = from[0] - to[0], range[2][2];
    for (int t = 0; t < 2; t++) {
        const double *at = t ? b : a;
        range[t][0] = HUGE_VAL;
        range[t][1] = -HUGE_VAL;
        for (int c = 0; c < 3; c++) {
            double along = x * (at[2 * c] - from[0]) + y * (at[2 * c + 1] - from[1]);
            range[t][0] = fmin(range[t][0], along);
            range[t][1] = fmax(range[t][1], along);
        }
    }
    double common = fmin(range[0][1], range[1][1]) - fmax(range[0][0], range[1][0]);
    return common <= TOUCH * fmin(range[0][1] - range[0][0], range[1][1] - range[1][0]);
}

static bool overlap(const double *a, const double *b)
{
    for (int side = 0; side < 3; side++)
        if (side_parts(a, b, side) || side_parts(b, a, side))
            return false;
    return true;
}

static void cell_range(const struct charting *of, const double *places, uint32_t range[4])
{
    for (uint32_t i = 0; i < 2; i++) {
        double low = fmin(places[i], fmin(places[2 + i], places[4 + i])) - of->low[i];
        double high = fmax(places[i], fmax(places[2 + i], places[4 + i])) - of->low[i];
        range[i] = (uint32_t)fmin(fmax(low / of->cell, 0), of->cells[i] - 1);
        range[2 + i] = (uint32_t)fmin(fmax(high / of->cell, 0), of->cells[i] - 1);
    }
}

/* Whether a face lies over one that the chart has. */
static bool collides(const struct charting *of, uint32_t face, uint32_t chart)
{
    const double *places = &of->charts.places[6 * (size_t)face];
    uint32_t range[4];
    cell_range(of, places, range);
    for (uint32_t y = range[1]; y <= range[3]; y++)
        for (uint32_t x = range[0]; x <= range[2]; x++)
            for (uint32_t n = of->head[y * of->cells[0] + x]; n != UINT32_MAX; n = of->nodes[n].next)
                if (of->charts.of[of->nodes[n].face] == chart &&
                    overlap(places, &of->charts.places[6 * (size_t)of->nodes[n].face]))
                    return true;
    return false;
}

static enum hatch_status enter(struct charting *of, uint32_t face, uint32_t chart, struct hatch_err *err)
{
    const double *places = &of->charts.places[6 * (size_t)face];
    double *box = of->charts.boxes[chart];
    uint32_t range[4];
    cell_range(of, places, range);
    of->charts.of[face] = chart;
    for (size_t i = 0; i < 6; i++) {
        box[i % 2] = fmin(box[i % 2], places[i]);
        box[2 + i % 2] = fmax(box[2 + i % 2], places[i]);
    }
    for (uint32_t y = range[1]; y <= range[3]; y++) {
        for (uint32_t x = range[0]; x <= range[2]; x++) {
            void *nodes = of->nodes;
            HATCH_TRY(
                hatch_heap_reserve(of->arena, &nodes, &of->node_room, of->node_count + 1, sizeof *of->nodes, err));
            of->nodes = nodes;
            uint32_t *head = &of->head[y * of->cells[0] + x];
            of->nodes[of->node_count] = (struct node){*head, face};
            *head = of->node_count++;
        }
    }
    return HATCH_OK;
}

/* Whether two faces of one patch are joined there along a side. */
static bool joined(const struct charting *of, uint32_t side, uint32_t other)
{
    const uint32_t *corners = of->lapped->corners;
    size_t a = 3 * (size_t)of->entry[side / 3], b = 3 * (size_t)of->entry[other / 3];
    return of->patch[side / 3] == of->patch[other / 3] &&
           corners[a + side % 3] == corners[b + hatch_side_end(other) % 3] &&
           corners[a + hatch_side_end(side) % 3] == corners[b + other % 3];
}

static enum hatch_status grow_chart(struct charting *of, uint32_t first, uint32_t *queue, struct hatch_err *err)
{
    uint32_t chart = of->charts.count++, count = 1;
    double *box = of->charts.boxes[chart];
    box[0] = box[1] = HUGE_VAL;
    box[2] = box[3] = -HUGE_VAL;
    queue[0] = first;
    HATCH_TRY(enter(of, first, chart, err));
    for (uint32_t i = 0; i < count; i++) {
        for (uint32_t c = 0; c < 3; c++) {
            uint32_t side = 3 * queue[i] + c, other = of->surface->opposite[side];
            if (other == HATCH_NO_SIDE || of->charts.of[other / 3] != UINT32_MAX || !joined(of, side, other) ||
                collides(of, other / 3, chart))
                continue;
            HATCH_TRY(enter(of, other / 3, chart, err));
            queue[count++] = other / 3;
        }
    }
    return HATCH_OK;
}

/* A grid of about as many cells as the patch has faces. */
static enum hatch_status make_grid(struct charting *of, const struct hatch_lapped_patch *patch, struct hatch_err *err)
{
    double high[2] = {-HUGE_VAL, -HUGE_VAL};
    of->low[0] = of->low[1] = HUGE_VAL;
    for (uint32_t v = 0; v < patch->vertex_count; v++) {
        for (int i = 0; i < 2; i++) {
            double at = of->lapped->vertices[patch->first_vertex + v].hatch[i];
            of->low[i] = fmin(of->low[i], at);
            high[i] = fmax(high[i], at);
        }
    }
    double wide = fmax(high[0] - of->low[0], high[1] - of->low[1]);
    of->cell = wide > 0 ? wide / (1 + floor(sqrt((double)patch->face_count))) : 1;
    for (int i = 0; i < 2; i++)
        of->cells[i] = 1 + (uint32_t)((high[i] - of->low[i]) / of->cell);
    void *head = of->head;
    uint32_t count = of->cells[0] * of->cells[1];
    HATCH_TRY(hatch_heap_reserve(of->arena, &head, &of->head_room, count, sizeof *of->head, err));
    of->head = head;
    memset(of->head, 0xff, count * sizeof *of->head);
    of->node_count = 0;
    return HATCH_OK;
}

static enum hatch_status chart_patch(struct charting *of, uint32_t p, struct hatch_err *err)
{
    const struct hatch_lapped_patch *patch = &of->lapped->patches[p];
    void *queue = of->queue;
    HATCH_TRY(hatch_heap_reserve(of->arena, &queue, &of->queue_room, patch->face_count, sizeof *of->queue, err));
    of->queue = queue;
    HATCH_TRY(make_grid(of, patch, err));
    for (uint32_t e = patch->first_face; e < patch->first_face + patch->face_count; e++) {
        uint32_t face = of->lapped->faces[e];
        if (of->patch[face] == p && of->charts.of[face] == UINT32_MAX)
            HATCH_TRY(grow_chart(of, face, of->queue, err));
    }
    return HATCH_OK;
}

enum hatch_status hatch_charts_make(const struct hatch_surface *surface, const struct hatch_lapped *lapped,
                                    const struct hatch_outline *outline, struct hatch_arena *arena,
                                    struct hatch_charts *charts, struct hatch_err *err)
{
    uint32_t count = surface->face_count;
    struct charting of = {.surface = surface, .lapped = lapped, .arena = arena};
    HATCH_TRY(choose_patches(&of, outline, err));
    of.charts.of = HATCH_NEW(arena, uint32_t, count, err);
    of.charts.places = of.charts.of ? HATCH_NEW(arena, double, 6 * (size_t)count, err) : NULL;
    void *boxes = of.charts.places ? hatch_arena_array(arena, count, sizeof *of.charts.boxes, err) : NULL;
    if (!boxes)
        return HATCH_LIMIT;
    of.charts.boxes = boxes;
    memset(of.charts.of, 0xff, count * sizeof *of.charts.of);
    for (uint32_t f = 0; f < count; f++)
        find_places(&of, f);
    for (uint32_t p = 0; p < lapped->patch_count; p++)
        HATCH_TRY(chart_patch(&of, p, err));
    *charts = of.charts;
    return HATCH_OK;
}
