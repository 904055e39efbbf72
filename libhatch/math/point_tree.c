#include "math/point_tree.h"

#include "base/random.h"
#include "math/box.h"
#include "math/vector.h"

/* By which the distance of a point may be less than that of a plane beyond which it lies: shares of the distance, and
 * of the coordinates, which the caller may have rounded. */
#define ROUNDING_DISTANCE 1e-12
#define ROUNDING_COORDINATE 1e-14

static bool is_before(const struct hatch_point_tree_item *a, const struct hatch_point_tree_item *b)
{
    return a->key < b->key || (a->key <= b->key && a->point < b->point);
}

static void swap(struct hatch_point_tree_item *a, struct hatch_point_tree_item *b)
{
    struct hatch_point_tree_item item = *a;
    *a = *b;
    *b = item;
}

/* Moves the items begin .. end - 1 so that those before `middle` are lower than that, and those after it higher (Hoare,
 * "Algorithm 65: find", 1961). Pivots are drawn, so that no order of the points is slow. */
static void divide(struct hatch_point_tree_item *items, uint32_t begin, uint32_t end, uint32_t middle)
{
    while (end - begin > 1) {
        uint32_t drawn = begin + (uint32_t)(hatch_random_mix(((uint64_t)begin << 32) + end) % (end - begin));
        uint32_t at = begin;
        swap(&items[drawn], &items[end - 1]);
        for (uint32_t i = begin; i + 1 < end; i++)
            if (is_before(&items[i], &items[end - 1]))
                swap(&items[i], &items[at++]);
        swap(&items[at], &items[end - 1]);
        if (at == middle)
            return;
        if (at > middle)
            end = at;
        else
            begin = at + 1;
    }
}

/* Orders the items begin .. end - 1. */
static void make_range(struct hatch_point_tree *tree, uint32_t begin, uint32_t end)
{
    if (begin == end)
        return;
    struct hatch_box box = {.any = false};
    double extent[3];
    for (uint32_t i = begin; i < end; i++)
        hatch_box_add(&box, &tree->points[3 * (size_t)tree->items[i].point]);
    hatch_vec_sub(box.high, box.low, extent);
    uint8_t axis = extent[1] > extent[0];
    axis = extent[2] > extent[axis] ? 2 : axis;
    for (uint32_t i = begin; i < end; i++)
        tree->items[i].key = tree->points[3 * (size_t)tree->items[i].point + axis];
    uint32_t middle = begin + (end - begin) / 2;
    divide(tree->items, begin, end, middle);
    tree->axis[middle] = axis;
    make_range(tree, begin, middle);
    make_range(tree, middle + 1, end);
}

enum hatch_status hatch_point_tree_make(const double *points, uint32_t count, struct hatch_arena *arena,
                                        struct hatch_point_tree *tree, struct hatch_err *err)
{
    struct hatch_point_tree made = {.points = points, .count = count};
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &made.items, count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &made.axis, count, err));
    for (uint32_t i = 0; i < count; i++)
        made.items[i].point = i;
    make_range(&made, 0, count);
    *tree = made;
    return HATCH_OK;
}

struct search {
    const struct hatch_point_tree *tree;
    const double *position;
    hatch_point_distance distance;
    const void *context;
    uint32_t best;
    double best_distance;
};

static void visit(struct search *search, uint32_t point)
{
    double distance = search->distance(search->context, point);
    if (distance < search->best_distance || (distance <= search->best_distance && point < search->best)) {
        search->best_distance = distance;
        search->best = point;
    }
}

/* Searches a range, first the part in which the position lies. */
static void search_range(struct search *search, uint32_t begin, uint32_t end)
{
    if (begin == end)
        return;
    uint32_t middle = begin + (end - begin) / 2, point = search->tree->items[middle].point;
    uint8_t axis = search->tree->axis[middle];
    double plane = search->tree->points[3 * (size_t)point + axis], beyond = search->position[axis] - plane;
    visit(search, point);
    if (beyond < 0)
        search_range(search, begin, middle);
    else
        search_range(search, middle + 1, end);
    double rounding = ROUNDING_COORDINATE * (fabs(plane) + fabs(search->position[axis]));
    if (fabs(beyond) > search->best_distance * (1 + ROUNDING_DISTANCE) + rounding)
        return;
    if (beyond < 0)
        search_range(search, middle + 1, end);
    else
        search_range(search, begin, middle);
}

uint32_t hatch_point_tree_nearest(const struct hatch_point_tree *tree, const double position[3],
                                  hatch_point_distance distance, const void *context)
{
    struct search search = {.tree = tree,
                            .position = position,
                            .distance = distance,
                            .context = context,
                            .best = HATCH_POINT_NONE,
                            .best_distance = INFINITY};
    search_range(&search, 0, tree->count);
    return search.best;
}
