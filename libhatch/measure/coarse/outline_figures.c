/* Distances of the outlines of two meshes, from masks of both: bits of pictures with HATCH_OUTLINE_PARTS² parts per
 * pixel. */
#include <string.h>

#include "math/vector.h"
#include "measure/coarse/coarse_figures.h"

#define NEAREST 1e-4 /* distance from the camera, in radii of the scene, from which on faces are seen */
#define REACH_PX 16  /* largest distance that is measured; larger ones count as this */
#define BINS (REACH_PX * HATCH_OUTLINE_PARTS * 16 + 1)

struct mask {
    uint32_t width, height, stride; /* stride: words of a row */
    uint64_t *words;
};

/* The work of one view. */
struct view_work {
    struct mask masks[2], outlines[2];
    uint64_t *bins; /* BINS: outline parts by distance, in sixteenths of a part */
};

struct outlines {
    const struct hatch_mesh *meshes[2];
    const struct hatch_view_set *views;
    struct view_work *works; /* per view */
    uint32_t first;          /* the view of the first task */
};

/* Finds where a point is seen: to the right of the middle, above it, and its distance from the camera's plane, 1 in an
 * orthographic view. */
static void look(const struct outlines *all, uint32_t view_index, const float position[3], double seen[3])
{
    const struct hatch_view *view = &all->views->views[view_index];
    double to[3];
    for (int k = 0; k < 3; k++)
        to[k] = (double)position[k] / all->views->bounds->radius - view->eye[k];
    seen[0] = hatch_vec_dot(to, view->right);
    seen[1] = hatch_vec_dot(to, view->up);
    seen[2] = view->orthographic ? 1 : -hatch_vec_dot(to, view->back);
}

/* Cuts off the part of a face that is not in front of the camera. Returns the number of corners that are left, 0, 3 or
 * 4. Both faces at an edge cut it at the same point. */
static uint32_t clip(double corners[3][3], double left[4][3])
{
    uint32_t count = 0;
    for (int c = 0; c < 3; c++) {
        const double *a = corners[c], *b = corners[(c + 1) % 3];
        const double *front = a[2] >= NEAREST ? a : b, *behind = front == a ? b : a;
        if (front == a)
            memcpy(left[count++], a, sizeof *left);
        if (front[2] < NEAREST || behind[2] >= NEAREST)
            continue;
        double share = (front[2] - NEAREST) / (front[2] - behind[2]), way[3];
        hatch_vec_sub(behind, front, way);
        hatch_vec_add_scaled(front, share, way, left[count]);
        left[count++][2] = NEAREST;
    }
    return count;
}

/* Projects a point to the parts of a picture: x to the right, y upwards. */
static void project(const struct outlines *all, uint32_t view_index, const double seen[3], double out[2])
{
    double half = HATCH_OUTLINE_PARTS * all->views->height_px / 2,
           scale = half / (all->views->views[view_index].half_height * seen[2]);
    out[0] = HATCH_OUTLINE_PARTS * all->views->width_px / 2 + scale * seen[0];
    out[1] = half + scale * seen[1];
}

/* Sets the bits from begin to end of a row; end is not included. */
static void fill_row(struct mask *mask, uint32_t y, double begin, double end)
{
    double low = fmin(fmax(ceil(begin), 0), mask->width), high = fmin(fmax(ceil(end), 0), mask->width);
    uint64_t *row = &mask->words[(size_t)y * mask->stride];
    for (uint32_t x = (uint32_t)low; x < (uint32_t)high;) {
        uint32_t bits = 64 - x % 64, left = (uint32_t)high - x, n = left < bits ? left : bits;
        row[x / 64] |= (n == 64 ? ~(uint64_t)0 : (((uint64_t)1 << n) - 1) << x % 64);
        x += n;
    }
}

/* Returns where an edge crosses a row. It is computed from the lower end, so that both faces at an edge agree. */
static double crossing(const double *a, const double *b, double y)
{
    const double *low = a[1] < b[1] || (a[1] == b[1] && a[0] < b[0]) ? a : b, *high = low == a ? b : a;
    return low[0] + (high[0] - low[0]) * ((y - low[1]) / (high[1] - low[1]));
}

static void fill_triangle(struct mask *mask, double corners[3][2])
{
    double low = fmin(fmin(corners[0][1], corners[1][1]), corners[2][1]),
           high = fmax(fmax(corners[0][1], corners[1][1]), corners[2][1]);
    double first = fmin(fmax(ceil(low), 0), mask->height), last = fmin(fmax(ceil(high), 0), mask->height);
    for (uint32_t y = (uint32_t)first; y < (uint32_t)last; y++) {
        double begin = INFINITY, end = -INFINITY;
        for (int c = 0; c < 3; c++) {
            const double *a = corners[c], *b = corners[(c + 1) % 3];
            if ((a[1] <= y) == (b[1] <= y))
                continue;
            double x = crossing(a, b, y);
            begin = fmin(begin, x);
            end = fmax(end, x);
        }
        fill_row(mask, y, begin, end);
    }
}

static void fill_mask(const struct outlines *all, uint32_t view, const struct hatch_mesh *mesh, struct mask *mask)
{
    memset(mask->words, 0, (size_t)mask->stride * mask->height * sizeof *mask->words);
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        double seen[3][3], left[4][3];
        for (size_t c = 0; c < 3; c++)
            look(all, view, &mesh->attributes[0].data[3 * (size_t)mesh->indices[3 * (size_t)f + c]], seen[c]);
        uint32_t count = clip(seen, left);
        for (uint32_t c = 2; c < count; c++) {
            double corners[3][2];
            for (uint32_t k = 0; k < 3; k++)
                project(all, view, left[k == 0 ? 0 : c - 2 + k], corners[k]);
            fill_triangle(mask, corners);
        }
    }
}

/* Returns 64 parts of a row, from bit 64 * word + shift on; shift is -1, 0 or 1. */
static uint64_t bits_at(const struct mask *mask, int64_t y, uint32_t word, int shift)
{
    if (y < 0 || y >= mask->height)
        return 0;
    const uint64_t *row = &mask->words[(size_t)y * mask->stride];
    if (shift < 0)
        return row[word] << 1 | (word > 0 ? row[word - 1] >> 63 : 0);
    if (shift > 0)
        return row[word] >> 1 | (word + 1 < mask->stride ? row[word + 1] << 63 : 0);
    return row[word];
}

/* Finds the outline of a mask: parts in the mask that have a part beside them that is not. */
static void find_outline(const struct mask *mask, struct mask *outline)
{
    for (uint32_t y = 0; y < mask->height; y++)
        for (uint32_t word = 0; word < mask->stride; word++) {
            uint64_t inside = bits_at(mask, y, word, 0);
            if (inside)
                inside &= ~(bits_at(mask, y, word, -1) & bits_at(mask, y, word, 1) &
                            bits_at(mask, (int64_t)y - 1, word, 0) & bits_at(mask, (int64_t)y + 1, word, 0));
            outline->words[(size_t)y * mask->stride + word] = inside;
        }
}

/* Returns the squared distance in parts from a part to the nearest on an outline that lies in a row, or `most` if that
 * is less. */
static int64_t find_in_row(const struct mask *outline, int64_t row, int64_t x, int64_t y, int64_t most)
{
    int64_t squared_rows = (row - y) * (row - y), reach = (int64_t)sqrt((double)(most - squared_rows));
    if (row < 0 || row >= outline->height)
        return most;
    int64_t first = x > reach ? (x - reach) / 64 : 0;
    int64_t last = x + reach < outline->width ? (x + reach) / 64 : outline->stride - 1;
    for (int64_t word = first; word <= last; word++) {
        uint64_t bits = outline->words[row * outline->stride + word];
        for (int64_t at = 64 * word; bits; bits >>= 1, at++) {
            int64_t squared = (at - x) * (at - x) + squared_rows;
            if ((bits & 1) && squared < most)
                most = squared;
        }
    }
    return most;
}

/* Returns the distance in parts from a part to the nearest on an outline. */
static double find_distance(const struct mask *outline, int64_t x, int64_t y)
{
    const int64_t reach = REACH_PX * HATCH_OUTLINE_PARTS;
    int64_t best = reach * reach;
    for (int64_t rows = 0; rows * rows < best; rows++) {
        best = find_in_row(outline, y - rows, x, y, best);
        if (rows * rows < best)
            best = find_in_row(outline, y + rows, x, y, best);
    }
    return sqrt((double)best);
}

/* Adds the distances of one outline from another to the bins. */
static void add_distances(const struct mask *from, const struct mask *to, uint64_t *bins)
{
    for (uint32_t y = 0; y < from->height; y++)
        for (uint32_t word = 0; word < from->stride; word++) {
            uint64_t bits = from->words[(size_t)y * from->stride + word];
            for (uint32_t x = 64 * word; bits; bits >>= 1, x++)
                if (bits & 1)
                    bins[(size_t)(find_distance(to, x, y) * 16)]++;
        }
}

static void measure_view(void *context, uint32_t index)
{
    const struct outlines *all = context;
    struct view_work *work = &all->works[index];
    for (int side = 0; side < 2; side++) {
        fill_mask(all, all->first + index, all->meshes[side], &work->masks[side]);
        find_outline(&work->masks[side], &work->outlines[side]);
    }
    for (int side = 0; side < 2; side++)
        add_distances(&work->outlines[side], &work->outlines[1 - side], work->bins);
}

static struct mask mask_of(const struct hatch_view_set *views)
{
    struct mask mask = {.width = (uint32_t)(HATCH_OUTLINE_PARTS * views->width_px),
                        .height = (uint32_t)(HATCH_OUTLINE_PARTS * views->height_px)};
    mask.stride = (mask.width + 63) / 64;
    return mask;
}

/* Returns the memory of a view_work, in bytes. */
static size_t work_bytes(const struct hatch_view_set *views)
{
    const struct mask mask = mask_of(views);
    const struct view_work *work;
    return 4 * (size_t)mask.stride * mask.height * sizeof *mask.words + BINS * sizeof *work->bins;
}

static enum hatch_status allocate(const struct hatch_view_set *views, struct hatch_arena *scratch,
                                  struct view_work *work, struct hatch_err *err)
{
    for (int side = 0; side < 2; side++) {
        struct mask *mask = &work->masks[side];
        *mask = mask_of(views);
        HATCH_TRY(HATCH_ALLOC(scratch, &mask->words, (size_t)mask->stride * mask->height, err));
        work->outlines[side] = *mask;
        HATCH_TRY(HATCH_ALLOC(scratch, &work->outlines[side].words, (size_t)mask->stride * mask->height, err));
    }
    return HATCH_ALLOC(scratch, &work->bins, BINS, err);
}

/* Finds the figures from the bins of all tasks. */
static void summarize(const struct outlines *all, uint32_t tasks, struct hatch_coarse_figures *figures)
{
    uint64_t total = 0, below = 0;
    for (uint32_t t = 0; t < tasks; t++)
        for (uint32_t bin = 0; bin < BINS; bin++)
            total += all->works[t].bins[bin];
    figures->outline_px = figures->outline_p999_px = 0;
    for (uint32_t bin = 0; bin < BINS; bin++) {
        uint64_t here = 0;
        for (uint32_t t = 0; t < tasks; t++)
            here += all->works[t].bins[bin];
        double distance_px = bin / (16.0 * HATCH_OUTLINE_PARTS);
        if (here > 0 && (double)below < 0.999 * (double)total)
            figures->outline_p999_px = distance_px;
        if (here > 0)
            figures->outline_px = distance_px;
        below += here;
    }
}

enum hatch_status hatch_measure_outlines(const struct hatch_mesh *full, const struct hatch_mesh *coarse,
                                         const struct hatch_view_set *views, struct hatch_pool *pool,
                                         struct hatch_arena *scratch, struct hatch_coarse_figures *figures,
                                         struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    uint32_t workers = hatch_pool_workers(pool, work_bytes(views), scratch);
    uint32_t tasks = workers < views->count ? workers : views->count;
    struct outlines all = {.meshes = {full, coarse}, .views = views};
    enum hatch_status status = HATCH_ALLOC(scratch, &all.works, tasks, err);
    for (uint32_t t = 0; t < tasks && status == HATCH_OK; t++)
        status = allocate(views, scratch, &all.works[t], err);
    for (; all.first < views->count && status == HATCH_OK; all.first += tasks) {
        uint32_t left = views->count - all.first;
        hatch_parallel_for(pool, left < tasks ? left : tasks, measure_view, &all);
    }
    if (status == HATCH_OK)
        summarize(&all, tasks, figures);
    hatch_arena_rewind(scratch, mark);
    return status;
}
