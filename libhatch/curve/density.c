#include "curve/density.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "math/vector.h"

/* A point, and the length of stroke that belongs to it: half of the lines at both sides. */
struct part {
    double length;
    float threshold;
    uint32_t point;
};

static int compare(const void *a, const void *b)
{
    const struct part *x = a, *y = b;
    if (x->threshold < y->threshold || x->threshold > y->threshold)
        return x->threshold < y->threshold ? -1 : 1;
    return (x->point > y->point) - (x->point < y->point);
}

static double area_of(const struct hatch_mesh *mesh)
{
    const float *data = mesh->attributes[0].data;
    double sum = 0;
    for (size_t f = 0; f < mesh->face_count; f++) {
        double corner[3][3], normal[3];
        for (int c = 0; c < 3; c++)
            hatch_vec_of(&data[3 * (size_t)mesh->indices[3 * f + (size_t)c]], corner[c]);
        hatch_vec_triangle(corner[0], corner[1], corner[2], normal);
        sum += hatch_vec_length(normal) / 2;
    }
    return sum;
}

/* Appends the points of a curve to a list; returns its new end. */
static struct part *add_curve(const struct hatch_curves *curves, const struct hatch_curve *curve,
                              const struct hatch_mesh *mesh, const float *thresholds, struct part *parts)
{
    double before[3] = {0, 0, 0};
    for (uint32_t i = curve->first; i < curve->first + curve->count; i++, parts++) {
        float position[3];
        double at[3];
        hatch_curve_position(mesh, &curves->points[i], position);
        hatch_vec_of(position, at);
        double half = i > curve->first ? hatch_vec_distance(at, before) / 2 : 0;
        *parts = (struct part){half, thresholds[i], i};
        if (i > curve->first)
            parts[-1].length += half;
        hatch_vec_copy(at, before);
    }
    return parts;
}

enum hatch_status hatch_curves_even_thresholds(const struct hatch_curves *curves, const struct hatch_mesh *mesh,
                                               struct hatch_arena *scratch, float *thresholds, struct hatch_err *err)
{
    double area = area_of(mesh);
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct part *parts;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &parts, curves->point_count, err));
    for (uint32_t s = 0, next; s < curves->set_count; s = next) {
        struct part *end = parts;
        for (next = s; next < curves->set_count && curves->sets[next].family == curves->sets[s].family; next++)
            for (uint32_t i = 0; i < curves->sets[next].count; i++)
                end = add_curve(curves, &curves->curves[curves->sets[next].first + i], mesh, thresholds, end);
        size_t count = (size_t)(end - parts);
        qsort(parts, count, sizeof *parts, compare);
        double sum = 0;
        for (size_t i = 0; i < count; i++) {
            double own = (double)parts[i].threshold, even = (sum + parts[i].length / 2) / area;
            sum += parts[i].length;
            thresholds[parts[i].point] = (float)fmin(fmax(even, own / HATCH_DENSITY_MOST), own * HATCH_DENSITY_MOST);
        }
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

static int compare_thresholds(const void *a, const void *b)
{
    const float *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

enum hatch_status hatch_curves_densest(const float *thresholds, uint32_t count, struct hatch_arena *scratch,
                                       float *densest, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    float *sorted;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &sorted, count, err));
    memcpy(sorted, thresholds, count * sizeof *sorted);
    qsort(sorted, count, sizeof *sorted, compare_thresholds);
    *densest = sorted[count - 1 - count / HATCH_DENSITY_BEYOND];
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
