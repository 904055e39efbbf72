#include "curve/density.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "math/vector.h"
#include "mesh/fans.h"

/* A point, and the length of stroke that belongs to it: half of the lines at both sides. */
struct part {
    double length;
    float threshold;
    uint32_t point, group;
};

static int compare(const void *a, const void *b)
{
    const struct part *x = a, *y = b;
    if (x->group != y->group)
        return x->group < y->group ? -1 : 1;
    if (x->threshold < y->threshold || x->threshold > y->threshold)
        return x->threshold < y->threshold ? -1 : 1;
    return (x->point > y->point) - (x->point < y->point);
}

/* Names the connected components.
 *   component  out: per face: a point of it, below point_count */
static enum hatch_status find_components(const struct hatch_mesh *mesh, struct hatch_arena *scratch,
                                         uint32_t *component, uint32_t *point_count, struct hatch_err *err)
{
    uint32_t *point, *set;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &point, mesh->vertex_count, err));
    HATCH_TRY(hatch_mesh_weld(mesh, scratch, point, point_count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &set, *point_count, err));
    hatch_sets_init(set, *point_count);
    for (size_t f = 0; f < mesh->face_count; f++)
        for (size_t c = 1; c < 3; c++)
            hatch_sets_join(set, point[mesh->indices[3 * f]], point[mesh->indices[3 * f + c]]);
    for (size_t f = 0; f < mesh->face_count; f++)
        component[f] = hatch_sets_find(set, point[mesh->indices[3 * f]]);
    return HATCH_OK;
}

enum hatch_status hatch_curves_group(const struct hatch_curves *curves, const struct hatch_mesh *mesh,
                                     struct hatch_arena *arena, struct hatch_arena *scratch,
                                     struct hatch_curve_groups *groups, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    uint32_t *component, *strokes, *group, point_count;
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &groups->of_face, mesh->face_count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &component, mesh->face_count, err));
    HATCH_TRY(find_components(mesh, scratch, component, &point_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &strokes, point_count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &group, point_count, err));
    for (uint32_t c = 0; c < curves->count; c++)
        strokes[component[curves->points[curves->curves[c].first].face]]++;
    groups->count = 1;
    for (uint32_t c = 0; c < point_count; c++)
        group[c] = strokes[c] < HATCH_DENSITY_FEW ? 0 : groups->count++;
    HATCH_TRY(HATCH_ALLOC(arena, &groups->area, groups->count, err));
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        groups->of_face[f] = group[component[f]];
        groups->area[groups->of_face[f]] += hatch_mesh_face_area(mesh, f);
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

uint32_t hatch_curves_group_of(const struct hatch_curve_groups *groups, const struct hatch_curve_point *point)
{
    return groups->of_face ? groups->of_face[point->face] : 0;
}

/* Appends the points of a curve to a list; returns its new end. */
static struct part *add_curve(const struct hatch_curves *curves, const struct hatch_curve *curve,
                              const struct hatch_mesh *mesh, const struct hatch_curve_groups *groups,
                              const float *thresholds, struct part *parts)
{
    uint32_t group = hatch_curves_group_of(groups, &curves->points[curve->first]);
    double before[3] = {0, 0, 0};
    for (uint32_t i = curve->first; i < curve->first + curve->count; i++, parts++) {
        float position[3];
        double at[3];
        hatch_curve_position(mesh, &curves->points[i], position);
        hatch_vec_of(position, at);
        double half = i > curve->first ? hatch_vec_distance(at, before) / 2 : 0;
        *parts = (struct part){half, thresholds[i], i, group};
        if (i > curve->first)
            parts[-1].length += half;
        hatch_vec_copy(at, before);
    }
    return parts;
}

enum hatch_status hatch_curves_even_thresholds(const struct hatch_curves *curves, const struct hatch_mesh *mesh,
                                               const struct hatch_curve_groups *groups, struct hatch_arena *scratch,
                                               float *thresholds, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct part *parts;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &parts, curves->point_count, err));
    for (uint32_t s = 0, next; s < curves->set_count; s = next) {
        struct part *end = parts;
        for (next = s; next < curves->set_count && curves->sets[next].family == curves->sets[s].family; next++)
            for (uint32_t i = 0; i < curves->sets[next].count; i++)
                end = add_curve(curves, &curves->curves[curves->sets[next].first + i], mesh, groups, thresholds, end);
        size_t count = (size_t)(end - parts);
        qsort(parts, count, sizeof *parts, compare);
        double sum = 0;
        for (size_t i = 0; i < count; i++) {
            if (i > 0 && parts[i].group != parts[i - 1].group)
                sum = 0;
            double own = (double)parts[i].threshold;
            double even = (sum + parts[i].length / 2) / groups->area[parts[i].group];
            sum += parts[i].length;
            thresholds[parts[i].point] = (float)fmin(fmax(even, own / HATCH_DENSITY_MOST), own * HATCH_DENSITY_MOST);
        }
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

enum hatch_status hatch_curves_densest(const struct hatch_curves *curves, const struct hatch_curve_groups *groups,
                                       const float *thresholds, struct hatch_arena *scratch, float *densest,
                                       struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct part *sorted;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &sorted, curves->point_count, err));
    memset(densest, 0, groups->count * sizeof *densest);
    for (uint32_t i = 0; i < curves->point_count; i++)
        sorted[i] = (struct part){0, thresholds[i], i, hatch_curves_group_of(groups, &curves->points[i])};
    qsort(sorted, curves->point_count, sizeof *sorted, compare);
    for (uint32_t first = 0, next; first < curves->point_count; first = next) {
        for (next = first + 1; next < curves->point_count && sorted[next].group == sorted[first].group;)
            next++;
        densest[sorted[first].group] = sorted[next - 1 - (next - first) / HATCH_DENSITY_BEYOND].threshold;
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
