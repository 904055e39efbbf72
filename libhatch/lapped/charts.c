#include <math.h>
#include <string.h>

#include "lapped/atlas.h"
#include "lapped/heap.h"
#include "mesh/edges.h"

/* Sample points along a side of a face, ten on the whole face, at which the visible patch is determined. */
#define SAMPLES_SIDE 4
/* Faces of a chart may overlap by this share of their width, because their coordinates are rounded. */
#define OVERLAP_TOLERANCE 0.01

struct work {
    const struct hatch_surface *surface;
    const struct hatch_lapped *lapped;
    struct hatch_arena *arena;
    struct hatch_charts charts;
    uint32_t *patch, *entry; /* per face of the surface: the patch that shows most of it, and its index in
                               lapped's faces */
    /* A grid over one patch, with a list of faces per cell. */
    double low[2], cell;
    uint32_t cells[2];
    uint32_t *head, head_capacity;
    struct node {
        uint32_t next, face;
    } * nodes;
    uint32_t node_count, node_capacity;
    uint32_t *queue, queue_capacity;
};

/* Counts the samples of a patch's face at which the patch is visible.
 *   entry   index in lapped's faces
 *   unseen  in and out: a bit per sample, set while no patch above is visible there */
static uint32_t count_shown(const struct hatch_lapped *lapped, const struct hatch_outline *outline,
                            const struct hatch_lapped_patch *patch, uint32_t entry, uint16_t *unseen)
{
    const struct hatch_lapped_vertex *at[3];
    for (uint32_t c = 0; c < 3; c++)
        at[c] = &lapped->vertices[patch->first_vertex + lapped->corners[3 * (size_t)entry + c]];
    uint32_t shown = 0, bit = 0;
    for (int i = 0; i < SAMPLES_SIDE; i++) {
        for (int j = 0; i + j < SAMPLES_SIDE; j++, bit++) {
            double a = (i + 1.0 / 3) / SAMPLES_SIDE, b = (j + 1.0 / 3) / SAMPLES_SIDE, uv[2];
            for (int k = 0; k < 2; k++)
                uv[k] = a * (double)at[0]->mask[k] + b * (double)at[1]->mask[k] + (1 - a - b) * (double)at[2]->mask[k];
            if (*unseen >> bit & 1 && hatch_outline_opacity(outline, uv) >= 0.5) {
                *unseen = (uint16_t)(*unseen & ~(1u << bit));
                shown++;
            }
        }
    }
    return shown;
}

/* Finds for every face the patch that shows most of it, from the uppermost patch down. */
static enum hatch_status choose_patches(struct work *w, const struct hatch_outline *outline, struct hatch_err *err)
{
    const struct hatch_lapped *lapped = w->lapped;
    uint32_t count = w->surface->face_count;
    uint16_t *unseen;
    uint8_t *most;
    HATCH_TRY(HATCH_ALLOC(w->arena, &w->patch, count, err));
    HATCH_TRY(HATCH_ALLOC(w->arena, &w->entry, count, err));
    HATCH_TRY(HATCH_ALLOC(w->arena, &unseen, count, err));
    HATCH_TRY(HATCH_ALLOC(w->arena, &most, count, err));
    memset(unseen, 0xff, count * sizeof *unseen);
    memset(w->patch, 0xff, count * sizeof *w->patch);
    for (uint32_t p = lapped->patch_count; p-- > 0;) {
        const struct hatch_lapped_patch *patch = &lapped->patches[p];
        for (uint32_t e = patch->first_face; e < patch->first_face + patch->face_count; e++) {
            uint32_t face = lapped->faces[e];
            uint32_t shown = count_shown(lapped, outline, patch, e, &unseen[face]);
            if (w->patch[face] == UINT32_MAX || shown > most[face]) {
                most[face] = (uint8_t)shown;
                w->patch[face] = p;
                w->entry[face] = e;
            }
        }
    }
    return HATCH_OK;
}

static void copy_positions(const struct work *w, uint32_t face)
{
    const struct hatch_lapped *lapped = w->lapped;
    const struct hatch_lapped_patch *patch = &lapped->patches[w->patch[face]];
    for (uint32_t c = 0; c < 3; c++) {
        uint32_t vertex = patch->first_vertex + lapped->corners[3 * (size_t)w->entry[face] + c];
        for (uint32_t i = 0; i < 2; i++)
            w->charts.positions[6 * (size_t)face + 2 * c + i] = lapped->vertices[vertex].hatch[i];
    }
}

/* Returns whether the normal of a side of triangle a is a separating axis of the two triangles. */
static bool side_separates(const double *a, const double *b, int side)
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
    return common <= OVERLAP_TOLERANCE * fmin(range[0][1] - range[0][0], range[1][1] - range[1][0]);
}

static bool overlap(const double *a, const double *b)
{
    for (int side = 0; side < 3; side++)
        if (side_separates(a, b, side) || side_separates(b, a, side))
            return false;
    return true;
}

static void cell_range(const struct work *w, const double *positions, uint32_t range[4])
{
    for (uint32_t i = 0; i < 2; i++) {
        double low = fmin(positions[i], fmin(positions[2 + i], positions[4 + i])) - w->low[i];
        double high = fmax(positions[i], fmax(positions[2 + i], positions[4 + i])) - w->low[i];
        range[i] = (uint32_t)fmin(fmax(low / w->cell, 0), w->cells[i] - 1);
        range[2 + i] = (uint32_t)fmin(fmax(high / w->cell, 0), w->cells[i] - 1);
    }
}

/* Returns whether a face overlaps another face of the chart. */
static bool collides(const struct work *w, uint32_t face, uint32_t chart)
{
    const double *positions = &w->charts.positions[6 * (size_t)face];
    uint32_t range[4];
    cell_range(w, positions, range);
    for (uint32_t y = range[1]; y <= range[3]; y++)
        for (uint32_t x = range[0]; x <= range[2]; x++)
            for (uint32_t n = w->head[y * w->cells[0] + x]; n != UINT32_MAX; n = w->nodes[n].next)
                if (w->charts.chart_of[w->nodes[n].face] == chart &&
                    overlap(positions, &w->charts.positions[6 * (size_t)w->nodes[n].face]))
                    return true;
    return false;
}

static enum hatch_status add_face(struct work *w, uint32_t face, uint32_t chart, struct hatch_err *err)
{
    const double *positions = &w->charts.positions[6 * (size_t)face];
    double *box = w->charts.boxes[chart];
    uint32_t range[4];
    cell_range(w, positions, range);
    w->charts.chart_of[face] = chart;
    for (size_t i = 0; i < 6; i++) {
        box[i % 2] = fmin(box[i % 2], positions[i]);
        box[2 + i % 2] = fmax(box[2 + i % 2], positions[i]);
    }
    for (uint32_t y = range[1]; y <= range[3]; y++) {
        for (uint32_t x = range[0]; x <= range[2]; x++) {
            void *nodes = w->nodes;
            HATCH_TRY(
                hatch_lapped_reserve(w->arena, &nodes, &w->node_capacity, w->node_count + 1, sizeof *w->nodes, err));
            w->nodes = nodes;
            uint32_t *head = &w->head[y * w->cells[0] + x];
            w->nodes[w->node_count] = (struct node){*head, face};
            *head = w->node_count++;
        }
    }
    return HATCH_OK;
}

/* Returns whether the faces of two opposite sides belong to one patch and are connected across these sides. */
static bool joined(const struct work *w, uint32_t side, uint32_t other)
{
    const uint32_t *corners = w->lapped->corners;
    size_t a = 3 * (size_t)w->entry[side / 3], b = 3 * (size_t)w->entry[other / 3];
    return w->patch[side / 3] == w->patch[other / 3] &&
           corners[a + side % 3] == corners[b + hatch_side_end(other) % 3] &&
           corners[a + hatch_side_end(side) % 3] == corners[b + other % 3];
}

static enum hatch_status grow_chart(struct work *w, uint32_t first, uint32_t *queue, struct hatch_err *err)
{
    uint32_t chart = w->charts.count++, count = 1;
    double *box = w->charts.boxes[chart];
    box[0] = box[1] = HUGE_VAL;
    box[2] = box[3] = -HUGE_VAL;
    queue[0] = first;
    HATCH_TRY(add_face(w, first, chart, err));
    for (uint32_t i = 0; i < count; i++) {
        for (uint32_t c = 0; c < 3; c++) {
            uint32_t side = 3 * queue[i] + c, other = w->surface->opposite[side];
            if (other == HATCH_NO_SIDE || w->charts.chart_of[other / 3] != UINT32_MAX || !joined(w, side, other) ||
                collides(w, other / 3, chart))
                continue;
            HATCH_TRY(add_face(w, other / 3, chart, err));
            queue[count++] = other / 3;
        }
    }
    return HATCH_OK;
}

/* Makes an empty grid with about as many cells as the patch has faces. */
static enum hatch_status make_grid(struct work *w, const struct hatch_lapped_patch *patch, struct hatch_err *err)
{
    double high[2] = {-HUGE_VAL, -HUGE_VAL};
    w->low[0] = w->low[1] = HUGE_VAL;
    for (uint32_t v = 0; v < patch->vertex_count; v++) {
        for (int i = 0; i < 2; i++) {
            double at = w->lapped->vertices[patch->first_vertex + v].hatch[i];
            w->low[i] = fmin(w->low[i], at);
            high[i] = fmax(high[i], at);
        }
    }
    double wide = fmax(high[0] - w->low[0], high[1] - w->low[1]);
    w->cell = wide > 0 ? wide / (1 + floor(sqrt((double)patch->face_count))) : 1;
    for (int i = 0; i < 2; i++)
        w->cells[i] = 1 + (uint32_t)((high[i] - w->low[i]) / w->cell);
    void *head = w->head;
    uint32_t count = w->cells[0] * w->cells[1];
    HATCH_TRY(hatch_lapped_reserve(w->arena, &head, &w->head_capacity, count, sizeof *w->head, err));
    w->head = head;
    memset(w->head, 0xff, count * sizeof *w->head);
    w->node_count = 0;
    return HATCH_OK;
}

static enum hatch_status chart_patch(struct work *w, uint32_t p, struct hatch_err *err)
{
    const struct hatch_lapped_patch *patch = &w->lapped->patches[p];
    void *queue = w->queue;
    HATCH_TRY(hatch_lapped_reserve(w->arena, &queue, &w->queue_capacity, patch->face_count, sizeof *w->queue, err));
    w->queue = queue;
    HATCH_TRY(make_grid(w, patch, err));
    for (uint32_t e = patch->first_face; e < patch->first_face + patch->face_count; e++) {
        uint32_t face = w->lapped->faces[e];
        if (w->patch[face] == p && w->charts.chart_of[face] == UINT32_MAX)
            HATCH_TRY(grow_chart(w, face, w->queue, err));
    }
    return HATCH_OK;
}

enum hatch_status hatch_charts_make(const struct hatch_surface *surface, const struct hatch_lapped *lapped,
                                    const struct hatch_outline *outline, struct hatch_arena *arena,
                                    struct hatch_charts *charts, struct hatch_err *err)
{
    uint32_t count = surface->face_count;
    struct work w = {.surface = surface, .lapped = lapped, .arena = arena};
    HATCH_TRY(choose_patches(&w, outline, err));
    HATCH_TRY(HATCH_ALLOC(arena, &w.charts.chart_of, count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &w.charts.positions, 6 * (size_t)count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &w.charts.boxes, count, err));
    memset(w.charts.chart_of, 0xff, count * sizeof *w.charts.chart_of);
    for (uint32_t f = 0; f < count; f++)
        copy_positions(&w, f);
    for (uint32_t p = 0; p < lapped->patch_count; p++)
        HATCH_TRY(chart_patch(&w, p, err));
    *charts = w.charts;
    return HATCH_OK;
}
