#include <math.h>
#include <string.h>

#include "lapped/atlas.h"
#include "lapped/heap.h"
#include "mesh/edges.h"

/* Sample points along a side of a face, ten on the whole face, at which the visible patch is determined. */
#define SAMPLES_SIDE 4
/* Faces of a chart may overlap by this share of their width, because their coordinates are rounded. */
#define OVERLAP_TOLERANCE 0.01
/* Share of a cell's width by which sides and faces also count to the cells beside them. */
#define CELL_MARGIN 0.02

struct work {
    const struct hatch_surface *surface;
    const struct hatch_lapped *lapped;
    struct hatch_arena *arena;
    struct hatch_charts charts;
    uint32_t *patch, *entry; /* per face of the surface: the patch that shows most of it, and its index in
                               lapped's faces */
    /* A grid over one patch, turned and stretched so that few sides pass through a cell. Each cell has a list of the
       sides that pass through it and that were on the boundary of a chart when they were added. Nodes that are not in
       use are a list, too. */
    double axis[2];         /* cosine and sine of the grid's turn */
    double low[2], cell[2]; /* of the grid, in turned coordinates; width and height of a cell */
    uint32_t cells[2];
    uint32_t *head, head_capacity;
    struct node {
        uint32_t next, side;
    } * nodes;
    uint32_t node_count, node_capacity, unused;
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
    const double *from = &a[2 * side], *to = &a[2 * ((side + 1) % 3)], *apex = &a[2 * ((side + 2) % 3)];
    double x = to[1] - from[1], y = from[0] - to[0];
    double height = x * (apex[0] - from[0]) + y * (apex[1] - from[1]);
    double own_low = height < 0 ? height : 0, own_high = height > 0 ? height : 0, low = 0, high = 0;
    for (int c = 0; c < 3; c++) {
        double along = x * (b[2 * c] - from[0]) + y * (b[2 * c + 1] - from[1]);
        low = c == 0 || along < low ? along : low;
        high = c == 0 || along > high ? along : high;
    }
    double common = (own_high < high ? own_high : high) - (own_low > low ? own_low : low);
    double narrower = own_high - own_low < high - low ? own_high - own_low : high - low;
    return common <= OVERLAP_TOLERANCE * narrower;
}

static bool overlap(const double *a, const double *b)
{
    for (int side = 0; side < 3; side++)
        if (side_separates(a, b, side) || side_separates(b, a, side))
            return false;
    return true;
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

/* Returns whether a side of a face of the chart is on the chart's boundary. */
static bool is_boundary(const struct work *w, uint32_t side, uint32_t chart)
{
    uint32_t other = w->surface->opposite[side];
    return other == HATCH_NO_SIDE || w->charts.chart_of[other / 3] != chart || !joined(w, side, other);
}

/* Converts a position to the grid's coordinates. */
static void turn(const struct work *w, const double *from, double to[2])
{
    to[0] = w->axis[0] * from[0] + w->axis[1] * from[1];
    to[1] = w->axis[0] * from[1] - w->axis[1] * from[0];
}

/* Returns the number of the row or column of cells that contains a position, which may be outside the grid. */
static uint32_t cell_at(const struct work *w, uint32_t axis, double position)
{
    return (uint32_t)fmin(fmax((position - w->low[axis]) / w->cell[axis], 0), w->cells[axis] - 1);
}

/* Finds the rows of cells that a polygon touches.
 *   positions  2 per corner */
static void touched_rows(const struct work *w, const double *positions, uint32_t corners, uint32_t rows[2])
{
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (uint32_t c = 0; c < corners; c++) {
        low = fmin(low, positions[2 * c + 1]);
        high = fmax(high, positions[2 * c + 1]);
    }
    rows[0] = cell_at(w, 1, low - CELL_MARGIN * w->cell[1]);
    rows[1] = cell_at(w, 1, high + CELL_MARGIN * w->cell[1]);
}

/* Finds the first and last cell of a row that a polygon touches there. */
static void touched_columns(const struct work *w, const double *positions, uint32_t corners, uint32_t row,
                            uint32_t columns[2])
{
    double margin = CELL_MARGIN * w->cell[0], start = w->low[1] + row * w->cell[1];
    double ends[2] = {start - CELL_MARGIN * w->cell[1], start + (1 + CELL_MARGIN) * w->cell[1]};
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (uint32_t c = 0; c < corners; c++) {
        const double *a = &positions[2 * c], *b = &positions[2 * ((c + 1) % corners)];
        double from = fmin(a[1], b[1]), to = fmax(a[1], b[1]), length = b[1] - a[1];
        if (from > ends[1] || to < ends[0])
            continue;
        for (int e = 0; e < 2; e++) {
            double t = to > from ? fmin(fmax((ends[e] - a[1]) / length, 0), 1) : e, x = a[0] + t * (b[0] - a[0]);
            low = fmin(low, x);
            high = fmax(high, x);
        }
    }
    columns[0] = cell_at(w, 0, low - margin);
    columns[1] = low <= high ? cell_at(w, 0, high + margin) : columns[0];
}

/* Returns whether a face overlaps a face on the chart's boundary that passes through a cell. Removes the sides from the
 * cell's list that are no longer on the boundary. */
static bool collides_in(struct work *w, uint32_t cell, const double *positions, uint32_t chart)
{
    uint32_t *link = &w->head[cell];
    while (*link != UINT32_MAX) {
        struct node *node = &w->nodes[*link];
        uint32_t other = node->side / 3;
        if (w->charts.chart_of[other] != chart || !is_boundary(w, node->side, chart)) {
            uint32_t removed = *link;
            *link = node->next;
            node->next = w->unused;
            w->unused = removed;
            continue;
        }
        if (overlap(positions, &w->charts.positions[6 * (size_t)other]))
            return true;
        link = &node->next;
    }
    return false;
}

/* Returns whether a face that shares a side with a chart overlaps another face of it. Since it lies outside the chart
 * there, it can then only overlap the chart by crossing its boundary. */
static bool collides(struct work *w, uint32_t face, uint32_t chart)
{
    const double *positions = &w->charts.positions[6 * (size_t)face];
    double turned[6];
    uint32_t rows[2], columns[2];
    for (size_t c = 0; c < 3; c++)
        turn(w, &positions[2 * c], &turned[2 * c]);
    touched_rows(w, turned, 3, rows);
    for (uint32_t y = rows[0]; y <= rows[1]; y++) {
        touched_columns(w, turned, 3, y, columns);
        for (uint32_t x = columns[0]; x <= columns[1]; x++)
            if (collides_in(w, y * w->cells[0] + x, positions, chart))
                return true;
    }
    return false;
}

/* Adds a side to the list of a cell. */
static enum hatch_status add_to_cell(struct work *w, uint32_t cell, uint32_t side, struct hatch_err *err)
{
    uint32_t number = w->unused;
    if (number == UINT32_MAX) {
        void *nodes = w->nodes;
        HATCH_TRY(hatch_lapped_reserve(w->arena, &nodes, &w->node_capacity, w->node_count + 1, sizeof *w->nodes, err));
        w->nodes = nodes;
        number = w->node_count++;
    } else {
        w->unused = w->nodes[number].next;
    }
    w->nodes[number] = (struct node){w->head[cell], side};
    w->head[cell] = number;
    return HATCH_OK;
}

/* Adds a side to the cells through which it passes. */
static enum hatch_status add_side(struct work *w, uint32_t side, struct hatch_err *err)
{
    double ends[4];
    turn(w, &w->charts.positions[2 * (size_t)side], &ends[0]);
    turn(w, &w->charts.positions[2 * (size_t)hatch_side_end(side)], &ends[2]);
    uint32_t rows[2], columns[2];
    touched_rows(w, ends, 2, rows);
    for (uint32_t y = rows[0]; y <= rows[1]; y++) {
        touched_columns(w, ends, 2, y, columns);
        for (uint32_t x = columns[0]; x <= columns[1]; x++)
            HATCH_TRY(add_to_cell(w, y * w->cells[0] + x, side, err));
    }
    return HATCH_OK;
}

static enum hatch_status add_face(struct work *w, uint32_t face, uint32_t chart, struct hatch_err *err)
{
    const double *positions = &w->charts.positions[6 * (size_t)face];
    double *box = w->charts.boxes[chart];
    w->charts.chart_of[face] = chart;
    for (size_t i = 0; i < 6; i++) {
        box[i % 2] = fmin(box[i % 2], positions[i]);
        box[2 + i % 2] = fmax(box[2 + i % 2], positions[i]);
    }
    for (uint32_t c = 0; c < 3; c++)
        if (is_boundary(w, 3 * face + c, chart))
            HATCH_TRY(add_side(w, 3 * face + c, err));
    return HATCH_OK;
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

/* Computes the vector along a side of a patch's face in hatch coordinates.
 *   corner  where the side begins, an index in lapped's corners */
static void along_side(const struct work *w, const struct hatch_lapped_patch *patch, size_t corner, double along[2])
{
    const struct hatch_lapped_vertex *vertices = &w->lapped->vertices[patch->first_vertex];
    const double *from = vertices[w->lapped->corners[corner]].hatch;
    const double *to = vertices[w->lapped->corners[corner % 3 == 2 ? corner - 2 : corner + 1]].hatch;
    for (int i = 0; i < 2; i++)
        along[i] = to[i] - from[i];
}

/* Turns the grid so that its first axis runs along the long sides of a patch's faces. */
static void choose_axis(struct work *w, const struct hatch_lapped_patch *patch)
{
    size_t first = 3 * (size_t)patch->first_face, end = first + 3 * (size_t)patch->face_count;
    double x = 0, y = 0, side[2]; /* sum of the sides' squares as complex numbers */
    for (size_t c = first; c < end; c++) {
        along_side(w, patch, c, side);
        x += side[0] * side[0] - side[1] * side[1];
        y += 2 * side[0] * side[1];
    }
    double length = sqrt(x * x + y * y), cosine = length > 0 ? fmax(fmin(x / length, 1), -1) : 1;
    w->axis[0] = sqrt((1 + cosine) / 2);
    w->axis[1] = copysign(sqrt((1 - cosine) / 2), y);
}

/* Computes the number of cells along each axis: in all about as many as the patch has faces, and so shaped that all
 * sides together pass through the fewest.
 *   extent  of the grid along each axis */
static void choose_cells(struct work *w, const struct hatch_lapped_patch *patch, const double extent[2])
{
    size_t first = 3 * (size_t)patch->first_face, end = first + 3 * (size_t)patch->face_count;
    double count = patch->face_count, sums[2] = {0, 0}, side[2], turned[2];
    for (size_t c = first; c < end; c++) {
        along_side(w, patch, c, side);
        turn(w, side, turned);
        for (int i = 0; i < 2; i++)
            sums[i] += extent[i] > 0 ? fabs(turned[i]) / extent[i] : 0;
    }
    for (int i = 0; i < 2; i++) {
        double cells = sums[i] > 0 ? sqrt(count * sums[1 - i] / sums[i]) : count;
        w->cells[i] = (uint32_t)ceil(fmax(fmin(cells, count), 1));
        w->cell[i] = extent[i] > 0 ? extent[i] / w->cells[i] : 1;
    }
}

/* Makes an empty grid over a patch. */
static enum hatch_status make_grid(struct work *w, const struct hatch_lapped_patch *patch, struct hatch_err *err)
{
    double high[2] = {-HUGE_VAL, -HUGE_VAL}, at[2];
    w->low[0] = w->low[1] = HUGE_VAL;
    choose_axis(w, patch);
    for (uint32_t v = 0; v < patch->vertex_count; v++) {
        turn(w, w->lapped->vertices[patch->first_vertex + v].hatch, at);
        for (int i = 0; i < 2; i++) {
            w->low[i] = fmin(w->low[i], at[i]);
            high[i] = fmax(high[i], at[i]);
        }
    }
    const double extent[2] = {high[0] - w->low[0], high[1] - w->low[1]};
    choose_cells(w, patch, extent);
    void *head = w->head;
    uint32_t count = w->cells[0] * w->cells[1];
    HATCH_TRY(hatch_lapped_reserve(w->arena, &head, &w->head_capacity, count, sizeof *w->head, err));
    w->head = head;
    memset(w->head, 0xff, count * sizeof *w->head);
    w->node_count = 0;
    w->unused = UINT32_MAX;
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
