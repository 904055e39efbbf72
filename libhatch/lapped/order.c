#include <math.h>
#include <string.h>

#include "lapped/work.h"
#include "math/vector.h"
#include "mesh/edges.h"

/* Distance of a patch's middle from covered ground, in radii of its core: disks that cover a plane
 * with the least overlap stand √3 radii apart. */
#define WAVE_BEST 0.73
#define WAVE_MIN 0.55
#define WAVE_MAX 1.0

enum hatch_status hatch_order_make(const struct hatch_ground *ground, const struct hatch_outline *outline,
                                   const uint8_t *covered, struct hatch_arena *arena, struct hatch_order *order,
                                   struct hatch_err *err)
{
    const struct hatch_surface *surface = ground->surface;
    struct hatch_order made = {.ground = ground, .covered = covered};
    made.core = 2 * (outline->core_min + outline->reach_max - outline->feather) / 2;
    made.wave.arena = made.front.arena = made.gaps.arena = arena;
    made.distance = HATCH_NEW(arena, double, surface->face_count, err);
    made.middle = made.distance ? HATCH_NEW(arena, double, (size_t)surface->face_count * 3, err) : NULL;
    made.late = made.middle ? HATCH_NEW(arena, uint8_t, surface->face_count, err) : NULL;
    made.smooth = made.late ? HATCH_NEW(arena, uint32_t, surface->face_count, err) : NULL;
    made.items = made.smooth ? HATCH_NEW_UNSET(arena, struct hatch_order_item, surface->face_count, err) : NULL;
    made.spare = made.items ? HATCH_NEW_UNSET(arena, struct hatch_order_item, surface->face_count, err) : NULL;
    if (!made.spare)
        return HATCH_LIMIT;
    for (uint32_t f = 0; f < surface->face_count; f++) {
        made.distance[f] = HUGE_VAL;
        made.late[f] = ground->singular[f];
        for (uint32_t c = 0; c < 3; c++) {
            const double *at = &surface->points[3 * (size_t)surface->corners[3 * (size_t)f + c]];
            hatch_vec_add_scaled(&made.middle[3 * (size_t)f], 1.0 / 3, at, &made.middle[3 * (size_t)f]);
        }
    }
    *order = made;
    return HATCH_OK;
}

/* Sorts by key, byte by byte, equal keys as they stand; spare: as many. After four passes all are back in items. */
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

void hatch_order_component(struct hatch_order *order, uint32_t number)
{
    const struct hatch_component *component = &order->ground->surface->components[number];
    order->first_face = component->first_face;
    order->face_count = component->face_count;
    order->smooth_count = order->smooth_next = 0;
    order->wave.count = order->front.count = order->gaps.count = 0;
    order->filling = false;
    struct hatch_order_item *items = &order->items[component->first_face];
    for (uint32_t i = 0; i < component->face_count; i++) {
        float rough = (float)order->ground->rough[component->first_face + i];
        /* The bits of a float that is not negative rise with it. */
        memcpy(&items[i].key, &rough, sizeof rough);
        items[i].face = component->first_face + i;
    }
    sort_items(items, component->face_count, &order->spare[component->first_face]);
    for (uint32_t i = 0; i < component->face_count; i++)
        if (!order->late[items[i].face])
            order->smooth[order->smooth_count++] = items[i].face;
}

/* Distance to covered ground in radii of the core of a patch that begins here. Faces are covered as a whole, and
 * their middles are where distances begin: an edge of it lies under cores already. */
static double ratio(const struct hatch_order *order, uint32_t face)
{
    return (order->distance[face] - order->ground->grain[face]) / (order->core * order->ground->wish[face]);
}

static enum hatch_status begin_filling(struct hatch_order *order, struct hatch_err *err)
{
    order->filling = true;
    for (uint32_t f = order->first_face; f < order->first_face + order->face_count; f++)
        if (!order->covered[f])
            HATCH_TRY(hatch_heap_push(&order->gaps, -ratio(order, f), f, err));
    return HATCH_OK;
}

enum hatch_status hatch_order_next(struct hatch_order *order, uint32_t *face, struct hatch_err *err)
{
    struct hatch_heap_item item;
    while (!order->filling && hatch_heap_pop(&order->front, &item)) {
        double now = ratio(order, item.id);
        if (!order->covered[item.id] && !order->late[item.id] && now >= WAVE_MIN) {
            *face = item.id;
            return HATCH_OK;
        }
    }
    for (; order->smooth_next < order->smooth_count; order->smooth_next++) {
        uint32_t f = order->smooth[order->smooth_next];
        if (!order->covered[f] && !order->late[f] && ratio(order, f) > WAVE_MIN) {
            *face = f;
            return HATCH_OK;
        }
    }
    if (!order->filling)
        HATCH_TRY(begin_filling(order, err));
    while (hatch_heap_pop(&order->gaps, &item)) {
        if (order->covered[item.id])
            continue;
        double now = -ratio(order, item.id);
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

static enum hatch_status approach(struct hatch_order *order, uint32_t face, double distance, struct hatch_err *err)
{
    order->distance[face] = distance;
    if (order->filling)
        return HATCH_OK;
    double now = ratio(order, face);
    if (now >= WAVE_MIN && now <= WAVE_MAX && !order->late[face])
        HATCH_TRY(hatch_heap_push(&order->front, fabs(now - WAVE_BEST), face, err));
    return HATCH_OK;
}

enum hatch_status hatch_order_covered(struct hatch_order *order, const uint32_t *faces, uint32_t count,
                                      struct hatch_err *err)
{
    const struct hatch_surface *surface = order->ground->surface;
    order->wave.count = 0;
    for (uint32_t i = 0; i < count; i++) {
        order->distance[faces[i]] = 0;
        HATCH_TRY(hatch_heap_push(&order->wave, 0, faces[i], err));
    }
    struct hatch_heap_item item;
    while (hatch_heap_pop(&order->wave, &item)) {
        if (item.key > order->distance[item.id])
            continue;
        for (uint32_t c = 0; c < 3; c++) {
            uint32_t other = surface->opposite[item.id * 3 + c];
            if (other == HATCH_NO_SIDE || order->covered[other / 3])
                continue;
            uint32_t next = other / 3;
            double distance =
                item.key + hatch_vec_distance(&order->middle[3 * (size_t)item.id], &order->middle[3 * (size_t)next]);
            if (distance >= order->distance[next] || distance > 1.5 * order->core * order->ground->wish[next])
                continue;
            HATCH_TRY(approach(order, next, distance, err));
            HATCH_TRY(hatch_heap_push(&order->wave, distance, next, err));
        }
    }
    return HATCH_OK;
}
