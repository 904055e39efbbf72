#include "curve/density.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "math/vector.h"
#include "mesh/fans.h"

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

/* Finds the length of stroke that belongs to each point of a curve: half of the lines at both sides.
 *   length  out: of all points */
static void measure_curve(const struct hatch_curves *curves, const struct hatch_curve *curve,
                          const struct hatch_mesh *mesh, double *length)
{
    double before[3] = {0, 0, 0};
    for (uint32_t i = curve->first; i < curve->first + curve->count; i++) {
        float position[3];
        double at[3];
        hatch_curve_position(mesh, &curves->points[i], position);
        hatch_vec_of(position, at);
        length[i] = i > curve->first ? hatch_vec_distance(at, before) / 2 : 0;
        if (i > curve->first)
            length[i - 1] += length[i];
        hatch_vec_copy(at, before);
    }
}

/* Returns a number by which points are sorted: by their thresholds, which are not negative, then by their numbers. */
static uint64_t key_of(float threshold, uint32_t point)
{
    uint32_t bits;
    memcpy(&bits, &threshold, sizeof bits);
    return (uint64_t)bits << 32 | point;
}

static int compare(const void *a, const void *b)
{
    const uint64_t *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

/* Returns the key that is greater than `rank` others (Hoare 1961, Algorithm 65). Reorders the keys. */
static uint64_t select_key(uint64_t *keys, uint32_t count, uint32_t rank)
{
    int64_t low = 0, high = (int64_t)count - 1;
    while (low < high) {
        uint64_t pivot = keys[(low + high) / 2];
        int64_t i = low, j = high;
        while (i <= j) {
            while (keys[i] < pivot)
                i++;
            while (keys[j] > pivot)
                j--;
            if (i > j)
                break;
            uint64_t swapped = keys[i];
            keys[i++] = keys[j];
            keys[j--] = swapped;
        }
        /* Keys up to j are at most the pivot, those from i on at least the pivot; a key between them is the pivot. */
        low = j < rank ? i : low;
        high = rank < i ? j : high;
    }
    return keys[rank];
}

/* Lists points group by group, by their keys.
 *   begin, end  numbers of the first one and of the one after the last
 *   keys        out: end - begin of them
 *   first       out: per group, and the end of the last one: where its points begin in the list */
static void list_points(const struct hatch_curves *curves, uint32_t begin, uint32_t end,
                        const struct hatch_curve_groups *groups, const float *thresholds, uint64_t *keys,
                        uint32_t *first)
{
    memset(first, 0, ((size_t)groups->count + 1) * sizeof *first);
    for (uint32_t i = begin; i < end; i++)
        first[hatch_curves_group_of(groups, &curves->points[i])]++;
    for (uint32_t g = 0; g < groups->count; g++)
        first[g + 1] += first[g]; /* the end of each */
    for (uint32_t i = end; i-- > begin;)
        keys[--first[hatch_curves_group_of(groups, &curves->points[i])]] = key_of(thresholds[i], i);
}

/* Makes the thresholds of a family even.
 *   length  of the points, as measure_curve finds it
 *   keys, first  scratch */
static void even_family(const struct hatch_curves *curves, uint32_t begin, uint32_t end,
                        const struct hatch_curve_groups *groups, const double *length, uint64_t *keys, uint32_t *first,
                        float *thresholds)
{
    list_points(curves, begin, end, groups, thresholds, keys, first);
    for (uint32_t g = 0; g < groups->count; g++) {
        double sum = 0;
        if (first[g] < first[g + 1])
            qsort(&keys[first[g]], first[g + 1] - first[g], sizeof *keys, compare);
        for (uint32_t i = first[g]; i < first[g + 1]; i++) {
            uint32_t point = (uint32_t)keys[i];
            double own = (double)thresholds[point], even = (sum + length[point] / 2) / groups->area[g];
            sum += length[point];
            thresholds[point] = (float)fmin(fmax(even, own / HATCH_DENSITY_MOST), own * HATCH_DENSITY_MOST);
        }
    }
}

enum hatch_status hatch_curves_even_thresholds(const struct hatch_curves *curves, const struct hatch_mesh *mesh,
                                               const struct hatch_curve_groups *groups, struct hatch_arena *scratch,
                                               float *thresholds, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    double *length;
    uint64_t *keys;
    uint32_t *first, begin = 0;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &length, curves->point_count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &keys, curves->point_count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &first, (size_t)groups->count + 1, err));
    for (uint32_t c = 0; c < curves->count; c++)
        measure_curve(curves, &curves->curves[c], mesh, length);
    for (uint32_t s = 0, end = 0; s < curves->set_count; s++) {
        for (uint32_t c = 0; c < curves->sets[s].count; c++)
            end += curves->curves[curves->sets[s].first + c].count;
        if (s + 1 < curves->set_count && curves->sets[s + 1].family == curves->sets[s].family)
            continue;
        even_family(curves, begin, end, groups, length, keys, first, thresholds);
        begin = end;
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

enum hatch_status hatch_curves_densest(const struct hatch_curves *curves, const struct hatch_curve_groups *groups,
                                       const float *thresholds, struct hatch_arena *scratch, float *densest,
                                       struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    uint64_t *keys;
    uint32_t *first;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &keys, curves->point_count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &first, (size_t)groups->count + 1, err));
    list_points(curves, 0, curves->point_count, groups, thresholds, keys, first);
    for (uint32_t g = 0; g < groups->count; g++) {
        uint32_t count = first[g + 1] - first[g];
        uint32_t beyond = count / HATCH_DENSITY_BEYOND;
        densest[g] = count > 0 ? thresholds[(uint32_t)select_key(&keys[first[g]], count, count - 1 - beyond)] : 0;
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
