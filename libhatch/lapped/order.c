#include <math.h>
#include <string.h>

#include "lapped/work.h"
#include "math/vector.h"

/* Distance of a seed face from covered faces, in radii of the core. Disks that cover a plane with the least overlap
 * have centers √3 radii apart, so a new center is best √3 - 1 radii from another disk. */
#define DISTANCE_BEST 0.73
#define DISTANCE_MIN 0.55
#define DISTANCE_MAX 1.0

enum hatch_status hatch_order_make(const struct hatch_patch_domain *domain, const struct hatch_outline *outline,
                                   const uint8_t *covered, struct hatch_arena *arena, struct hatch_order *order,
                                   struct hatch_err *err)
{
    const struct hatch_surface *surface = domain->surface;
    struct hatch_order made = {.domain = domain, .covered = covered};
    made.core_ratio = 2 * (outline->core_min + outline->reach_max - outline->feather) / 2;
    made.queue.arena = made.candidates.arena = made.gaps.arena = arena;
    HATCH_TRY(HATCH_ALLOC(arena, &made.distance, surface->face_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.middle, (size_t)surface->face_count * 3, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.postponed, surface->face_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.smooth, surface->face_count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &made.items, surface->face_count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &made.spare, surface->face_count, err));
    for (uint32_t f = 0; f < surface->face_count; f++) {
        made.distance[f] = HUGE_VAL;
        made.postponed[f] = domain->singular[f];
        for (uint32_t c = 0; c < 3; c++) {
            const double *at = &surface->points[3 * (size_t)surface->corners[3 * (size_t)f + c]];
            hatch_vec_add_scaled(&made.middle[3 * (size_t)f], 1.0 / 3, at, &made.middle[3 * (size_t)f]);
        }
    }
    *order = made;
    return HATCH_OK;
}

/* Stable radix sort by key, one byte per pass; after four passes the result is in items.
 *   spare  room for count items */
static void sort_items(struct hatch_order_item *items, uint32_t count, struct hatch_order_item *spare)
{
    for (uint32_t shift = 0; shift < 32; shift += 8) {
        uint32_t first[256] = {0}, next = 0;
        for (uint32_t i = 0; i < count; i++)
            first[items[i].key >> shift & 255]++;
        for (uint32_t d = 0; d < 256; d++) {
            uint32_t here = first[d];
            first[d] = next;
            next += here;
        }
        for (uint32_t i = 0; i < count; i++)
            spare[first[items[i].key >> shift & 255]++] = items[i];
        struct hatch_order_item *sorted = spare;
        spare = items;
        items = sorted;
    }
}

void hatch_order_start_component(struct hatch_order *order, uint32_t number)
{
    const struct hatch_component *component = &order->domain->surface->components[number];
    order->first_face = component->first_face;
    order->face_count = component->face_count;
    order->smooth_count = order->smooth_next = 0;
    order->queue.count = order->candidates.count = order->gaps.count = 0;
    order->filling_gaps = false;
    struct hatch_order_item *items = &order->items[component->first_face];
    for (uint32_t i = 0; i < component->face_count; i++) {
        float rate = (float)order->domain->turning_rate[component->first_face + i];
        /* Floats that are not negative have the same order as their bits. */
        memcpy(&items[i].key, &rate, sizeof rate);
        items[i].face = component->first_face + i;
    }
    sort_items(items, component->face_count, &order->spare[component->first_face]);
    for (uint32_t i = 0; i < component->face_count; i++)
        if (!order->postponed[items[i].face])
            order->smooth[order->smooth_count++] = items[i].face;
}

/* Returns the distance from a face to covered faces, in radii of the core of a patch that begins at the face. Distances
 * are measured between the middles of faces; the last edge length of them is already covered. */
static double relative_distance(const struct hatch_order *order, uint32_t face)
{
    return (order->distance[face] - order->domain->edge_length[face]) /
           (order->core_ratio * order->domain->target_radius[face]);
}

static enum hatch_status begin_filling_gaps(struct hatch_order *order, struct hatch_err *err)
{
    order->filling_gaps = true;
    for (uint32_t f = order->first_face; f < order->first_face + order->face_count; f++)
        if (!order->covered[f])
            HATCH_TRY(hatch_heap_push(&order->gaps, -relative_distance(order, f), f, err));
    return HATCH_OK;
}

enum hatch_status hatch_order_next(struct hatch_order *order, uint32_t *face, struct hatch_err *err)
{
    struct hatch_heap_item item;
    while (!order->filling_gaps && hatch_heap_pop(&order->candidates, &item)) {
        double now = relative_distance(order, item.id);
        if (!order->covered[item.id] && !order->postponed[item.id] && now >= DISTANCE_MIN) {
            *face = item.id;
            return HATCH_OK;
        }
    }
    for (; order->smooth_next < order->smooth_count; order->smooth_next++) {
        uint32_t f = order->smooth[order->smooth_next];
        if (!order->covered[f] && !order->postponed[f] && relative_distance(order, f) > DISTANCE_MIN) {
            *face = f;
            return HATCH_OK;
        }
    }
    if (!order->filling_gaps)
        HATCH_TRY(begin_filling_gaps(order, err));
    while (hatch_heap_pop(&order->gaps, &item)) {
        if (order->covered[item.id])
            continue;
        double now = -relative_distance(order, item.id);
        if (now > item.key) {
            HATCH_TRY(hatch_heap_push(&order->gaps, now, item.id, err));
            continue;
        }
        *face = item.id;
        return HATCH_OK;
    }
    *face = HATCH_NO_SIDE;
    return HATCH_OK;
}

static enum hatch_status lower_distance(struct hatch_order *order, uint32_t face, double distance,
                                        struct hatch_err *err)
{
    order->distance[face] = distance;
    if (order->filling_gaps)
        return HATCH_OK;
    double now = relative_distance(order, face);
    if (now >= DISTANCE_MIN && now <= DISTANCE_MAX && !order->postponed[face])
        HATCH_TRY(hatch_heap_push(&order->candidates, fabs(now - DISTANCE_BEST), face, err));
    return HATCH_OK;
}

enum hatch_status hatch_order_add_covered(struct hatch_order *order, const uint32_t *faces, uint32_t count,
                                          struct hatch_err *err)
{
    const struct hatch_surface *surface = order->domain->surface;
    order->queue.count = 0;
    for (uint32_t i = 0; i < count; i++) {
        order->distance[faces[i]] = 0;
        HATCH_TRY(hatch_heap_push(&order->queue, 0, faces[i], err));
    }
    struct hatch_heap_item item;
    while (hatch_heap_pop(&order->queue, &item)) {
        if (item.key > order->distance[item.id])
            continue;
        for (uint32_t c = 0; c < 3; c++) {
            uint32_t other = surface->opposite[item.id * 3 + c];
            if (other == HATCH_NO_SIDE || order->covered[other / 3])
                continue;
            uint32_t next = other / 3;
            double distance =
                item.key + hatch_vec_distance(&order->middle[3 * (size_t)item.id], &order->middle[3 * (size_t)next]);
            if (distance >= order->distance[next] ||
                distance > 1.5 * order->core_ratio * order->domain->target_radius[next])
                continue;
            HATCH_TRY(lower_distance(order, next, distance, err));
            HATCH_TRY(hatch_heap_push(&order->queue, distance, next, err));
        }
    }
    return HATCH_OK;
}
