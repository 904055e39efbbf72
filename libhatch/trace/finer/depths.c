#include "trace/finer/depths.h"

#include <math.h>

#define SLACK 2e-3 /* of the nearness: surfaces that are as near as that hide nothing of one another */

enum hatch_status hatch_depths_make(int width, int height, struct hatch_arena *arena, struct hatch_depths *depths,
                                    struct hatch_err *err)
{
    *depths = (struct hatch_depths){width, height, NULL};
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &depths->near, (size_t)width * (size_t)height, err));
    for (size_t i = 0; i < (size_t)width * (size_t)height; i++)
        depths->near[i] = -HUGE_VALF;
    return HATCH_OK;
}

/* A row of pixels whose centres are in a polygon. */
struct row {
    int y, first, last;
    double near, step; /* nearness at the first pixel, and its change from pixel to pixel */
};

/* Finds the change of nearness in x and y. Returns false for a polygon that is seen edge on. */
static bool find_slope(const struct hatch_depths_corner *corners, int count, double slope[2])
{
    const struct hatch_depths_corner *a = corners;
    double largest = 0;
    for (int i = 1; i + 1 < count; i++) { /* from the largest triangle of the fan */
        const struct hatch_depths_corner *b = &corners[i], *c = &corners[i + 1];
        double x1 = b->x - a->x, y1 = b->y - a->y, x2 = c->x - a->x, y2 = c->y - a->y, area = x1 * y2 - x2 * y1;
        if (fabs(area) <= largest)
            continue;
        largest = fabs(area);
        slope[0] = ((b->near - a->near) * y2 - (c->near - a->near) * y1) / area;
        slope[1] = ((c->near - a->near) * x1 - (b->near - a->near) * x2) / area;
    }
    return largest > 1e-12;
}

/* Finds the row of a polygon at a height. Returns false if there is none. */
static bool find_row(const struct hatch_depths *depths, const struct hatch_depths_corner *corners, int count,
                     const double slope[2], int y, struct row *row)
{
    double middle = y + 0.5, left = HUGE_VAL, right = -HUGE_VAL;
    for (int i = 0; i < count; i++) {
        const struct hatch_depths_corner *a = &corners[i], *b = &corners[(i + 1) % count];
        if ((a->y > middle) == (b->y > middle))
            continue;
        double x = a->x + (b->x - a->x) * (middle - a->y) / (b->y - a->y);
        left = fmin(left, x);
        right = fmax(right, x);
    }
    row->y = y;
    row->first = (int)fmax(ceil(left - 0.5), 0);
    row->last = (int)fmin(ceil(right - 0.5), depths->width) - 1;
    row->step = slope[0];
    row->near = corners[0].near + slope[0] * (row->first + 0.5 - corners[0].x) + slope[1] * (middle - corners[0].y);
    return left <= right && row->first <= row->last;
}

static void find_rows(const struct hatch_depths *depths, const struct hatch_depths_corner *corners, int count,
                      int *first, int *last)
{
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (int i = 0; i < count; i++) {
        low = fmin(low, corners[i].y);
        high = fmax(high, corners[i].y);
    }
    *first = (int)fmax(ceil(low - 0.5), 0);
    *last = (int)fmin(ceil(high - 0.5), depths->height) - 1;
}

void hatch_depths_draw(struct hatch_depths *depths, const struct hatch_depths_corner *corners, int count)
{
    double slope[2];
    int first, last;
    struct row row;
    if (!find_slope(corners, count, slope))
        return;
    find_rows(depths, corners, count, &first, &last);
    for (int y = first; y <= last; y++) {
        if (!find_row(depths, corners, count, slope, y, &row))
            continue;
        float *near = &depths->near[(size_t)y * (size_t)depths->width];
        for (int x = row.first; x <= row.last; x++)
            near[x] = fmaxf(near[x], (float)(row.near + (x - row.first) * row.step));
    }
}

static bool is_hidden(double near, double by)
{
    return near < by - SLACK * fabs(by);
}

/* Returns whether a point is behind all surfaces of the pixels around it. */
static bool is_behind(const struct hatch_depths *depths, double x, double y, double near)
{
    int column = (int)floor(x), line = (int)floor(y);
    for (int v = line - 1; v <= line + 1; v++)
        for (int u = column - 1; u <= column + 1; u++)
            if (u >= 0 && u < depths->width && v >= 0 && v < depths->height &&
                !is_hidden(near, (double)depths->near[(size_t)v * (size_t)depths->width + (size_t)u]))
                return false;
    return true;
}

bool hatch_depths_show(const struct hatch_depths *depths, const struct hatch_depths_corner *corners, int count)
{
    double slope[2], x = 0, y = 0, near = 0;
    int first, last;
    struct row row;
    for (int i = 0; i < count; i++) {
        if (!is_behind(depths, corners[i].x, corners[i].y, corners[i].near))
            return true;
        x += corners[i].x / count;
        y += corners[i].y / count;
        near += corners[i].near / count;
    }
    if (!is_behind(depths, x, y, near))
        return true;
    if (!find_slope(corners, count, slope))
        return false;
    find_rows(depths, corners, count, &first, &last);
    for (int v = first; v <= last; v++) {
        if (!find_row(depths, corners, count, slope, v, &row))
            continue;
        const float *by = &depths->near[(size_t)v * (size_t)depths->width];
        for (int u = row.first; u <= row.last; u++)
            if (!is_hidden(row.near + (u - row.first) * row.step, (double)by[u]))
                return true;
    }
    return false;
}
