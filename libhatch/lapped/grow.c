#include <math.h>
#include <string.h>

#include "lapped/work.h"
#include "mesh/edges.h"

/* Cosine of the angle by which the field may turn across an edge inside a patch. */
#define COHERENT 0.5
/* How many faces deep a patch grows into covered ground. */
#define STEPS_MAX 1

enum hatch_status hatch_growth_make(const struct hatch_ground *ground, const struct hatch_outline *outline,
                                    const uint8_t *covered, struct hatch_arena *arena,
                                    struct hatch_growth *growth, struct hatch_err *err)
{
    const struct hatch_surface *surface = ground->surface;
    struct hatch_growth made = {.covered = covered, .ground = ground, .outline = outline, .arena = arena,
                                .heap = {.arena = arena},
                                .obstacles = {.arena = arena}};
    made.face_round = HATCH_NEW(arena, uint32_t, surface->face_count, err);
    made.face_local = made.face_round ? HATCH_NEW(arena, uint32_t, surface->face_count, err) : NULL;
    made.barred = made.face_local ? HATCH_NEW(arena, uint32_t, surface->face_count, err) : NULL;
    made.point_round = made.barred ? HATCH_NEW(arena, uint32_t, surface->point_count, err) : NULL;
    made.point_local = made.point_round ? HATCH_NEW(arena, uint32_t, surface->point_count, err) : NULL;
    made.place_number = made.point_local ? HATCH_NEW(arena, uint32_t, surface->point_count, err) : NULL;
    made.known = made.place_number ? HATCH_NEW(arena, double, (size_t)surface->point_count * 2, err) : NULL;
    made.budget = made.known ? HATCH_NEW(arena, uint32_t, surface->face_count, err) : NULL;
    if (!made.budget)
        return HATCH_LIMIT;
    for (uint32_t f = 0; f < surface->face_count; f++)
        made.budget[f] = ground->faces_max;
    *growth = made;
    return HATCH_OK;
}

static uint32_t side_of(uint32_t face, uint32_t corner)
{
    return face * 3 + corner;
}

/* The side across, when going there keeps the faces' sides alike; else HATCH_NO_SIDE. */
static uint32_t across(const struct hatch_surface *surface, uint32_t side)
{
    uint32_t other = surface->opposite[side];
    if (other == HATCH_NO_SIDE || surface->corners[side] == surface->corners[other])
        return HATCH_NO_SIDE;
    return other;
}

static bool holds_face(const struct hatch_growth *growth, uint32_t face)
{
    return growth->face_round[face] == growth->round;
}

static bool holds_point(const struct hatch_growth *growth, uint32_t point)
{
    return growth->point_round[point] == growth->round;
}

/* A side in its face's frame. */
static void side_vector(const struct hatch_ground *ground, uint32_t side, double vector[2])
{
    double from[2], to[2];
    hatch_ground_corner(ground, side / 3, side % 3, from);
    hatch_ground_corner(ground, side / 3, hatch_side_end(side) % 3, to);
    vector[0] = to[0] - from[0];
    vector[1] = to[1] - from[1];
}

/* Cosine between the lines of the two faces along an edge, unfolded. */
static double cosine_across(const struct hatch_ground *ground, uint32_t side, uint32_t other)
{
    double a[2], b[2];
    side_vector(ground, side, a);
    side_vector(ground, other, b);
    return -(a[0] * b[0] + a[1] * b[1]) / (a[0] * a[0] + a[1] * a[1]);
}

enum hatch_side hatch_growth_side(const struct hatch_growth *growth, uint32_t side)
{
    uint32_t other = growth->ground->surface->opposite[side];
    if (other == HATCH_NO_SIDE)
        return HATCH_SIDE_BORDER;
    return across(growth->ground->surface, side) != HATCH_NO_SIDE && holds_face(growth, other / 3)
               ? HATCH_SIDE_INSIDE
               : HATCH_SIDE_OPEN;
}

/* How many of a face's sides the patch holds the other face of. */
static int sides_inside(const struct hatch_growth *growth, uint32_t face)
{
    int count = 0;
    for (uint32_t c = 0; c < 3; c++)
        count += hatch_growth_side(growth, side_of(face, c)) == HATCH_SIDE_INSIDE;
    return count;
}

/* The sign of a face's line that agrees with the patch around it; 0 where none does, or where it is
 * only reached through a face with an index. */
static int8_t agree(const struct hatch_growth *growth, uint32_t face)
{
    const struct hatch_ground *ground = growth->ground;
    int8_t sign = 0, through = 0;
    for (uint32_t c = 0; c < 3; c++) {
        uint32_t side = side_of(face, c);
        if (hatch_growth_side(growth, side) != HATCH_SIDE_INSIDE)
            continue;
        uint32_t other = ground->surface->opposite[side], neighbour = other / 3;
        double cosine = cosine_across(ground, other, side);
        int8_t own = (int8_t)((cosine < 0 ? -1 : 1) * growth->patch.sign[growth->face_local[neighbour]]);
        if (ground->singular[face] || (ground->singular[neighbour] && growth->patch.face_count == 1)) {
            through = own;
        } else if (!ground->singular[neighbour]) {
            if (fabs(cosine) < COHERENT || (sign && sign != own))
                return 0;
            sign = own;
        }
    }
    return sign ? sign : through;
}

/* Whether the patch may have this face, and stays a disk that encloses no index. */
static bool stays_disk(const struct hatch_growth *growth, uint32_t face)
{
    const struct hatch_surface *surface = growth->ground->surface;
    int shared = 0;
    uint32_t last = 0;
    if (growth->barred[face] == growth->number)
        return false;
    for (uint32_t c = 0; c < 3; c++) {
        uint32_t side = side_of(face, c);
        if (hatch_growth_side(growth, side) != HATCH_SIDE_INSIDE)
            continue;
        uint32_t neighbour = surface->opposite[side] / 3;
        if (growth->ground->singular[neighbour] && sides_inside(growth, neighbour) > 1)
            return false;
        shared++;
        last = c;
    }
    if (shared == 1)
        return !holds_point(growth, surface->corners[side_of(face, (last + 2) % 3)]);
    return shared == 2;
}

/* Where a corner of a face comes to lie, seen from another corner that has its place. */
static void unfold(const struct hatch_ground *ground, uint32_t face, int8_t sign, uint32_t corner,
                   uint32_t from, const double place[2], double sum[2])
{
    double a[2], b[2];
    hatch_ground_corner(ground, face, from, a);
    hatch_ground_corner(ground, face, corner, b);
    for (int i = 0; i < 2; i++)
        sum[i] += place[i] + sign * (b[i] - a[i]);
}

static enum hatch_status add_vertex(struct hatch_growth *growth, uint32_t point, const double place[2],
                                    struct hatch_err *err)
{
    struct hatch_patch *patch = &growth->patch;
    uint32_t local = patch->vertex_count;
    void *points = patch->points, *places = patch->place;
    HATCH_TRY(hatch_heap_reserve(growth->arena, &points, &patch->point_room, local + 1, sizeof *patch->points,
                                 err));
    patch->points = points;
    HATCH_TRY(hatch_heap_reserve(growth->arena, &places, &patch->place_room, 2 * local + 2,
                                 sizeof *patch->place, err));
    patch->place = places;
    patch->vertex_count++;
    patch->points[local] = point;
    growth->point_round[point] = growth->round;
    growth->point_local[point] = local;
    bool solved = growth->place_number[point] == growth->number;
    growth->unfolded += !solved;
    memcpy(&patch->place[(size_t)local * 2], solved ? &growth->known[(size_t)point * 2] : place,
           2 * sizeof *place);
    return HATCH_OK;
}

static double distance_to_side(const double center[2], const double a[2], const double b[2])
{
    double x = b[0] - a[0], y = b[1] - a[1], length = x * x + y * y;
    double t = length > 0 ? ((center[0] - a[0]) * x + (center[1] - a[1]) * y) / length : 0;
    t = fmin(1, fmax(0, t));
    double dx = a[0] + t * x - center[0], dy = a[1] + t * y - center[1];
    return sqrt(dx * dx + dy * dy);
}

static void side_places(const struct hatch_growth *growth, uint32_t side, const double *ends[2])
{
    const uint32_t *corners = growth->ground->surface->corners;
    ends[0] = &growth->patch.place[2 * growth->point_local[corners[side]]];
    ends[1] = &growth->patch.place[2 * growth->point_local[corners[hatch_side_end(side)]]];
}

static enum hatch_status push_sides(struct hatch_growth *growth, uint32_t face, struct hatch_err *err)
{
    const struct hatch_patch *patch = &growth->patch;
    double inner = 2 * patch->radius * growth->outline->core_min;
    double outer = 2 * patch->radius * growth->outline->reach_max;
    for (uint32_t c = 0; c < 3; c++) {
        uint32_t side = side_of(face, c);
        if (hatch_growth_side(growth, side) != HATCH_SIDE_OPEN ||
            across(growth->ground->surface, side) == HATCH_NO_SIDE)
            continue;
        const double *ends[2];
        side_places(growth, side, ends);
        double away = distance_to_side(patch->center, ends[0], ends[1]);
        if (away < inner || (away < outer && hatch_patch_touches(patch, growth->outline, ends[0], ends[1])))
            HATCH_TRY(hatch_heap_push(&growth->heap, away, side, err));
    }
    return HATCH_OK;
}

/* Takes a face whose vertices but `fresh` (3: none) the patch has. */
static enum hatch_status add_face(struct hatch_growth *growth, uint32_t face, int8_t sign, uint8_t steps,
                                  uint32_t fresh, struct hatch_err *err)
{
    struct hatch_patch *patch = &growth->patch;
    const uint32_t *corner = &growth->ground->surface->corners[(size_t)face * 3];
    uint32_t local = patch->face_count;
    void *array, *faces = patch->faces, *signs = patch->sign, *corners = patch->corners;
    HATCH_TRY(hatch_heap_reserve(growth->arena, &faces, &patch->face_room, local + 1, sizeof *patch->faces, err));
    patch->faces = faces;
    HATCH_TRY(hatch_heap_reserve(growth->arena, &signs, &patch->sign_room, local + 1, sizeof *patch->sign, err));
    patch->sign = signs;
    HATCH_TRY(hatch_heap_reserve(growth->arena, &corners, &patch->corner_room, 3 * local + 3,
                                 sizeof *patch->corners, err));
    patch->corners = corners;
    array = patch->steps;
    HATCH_TRY(hatch_heap_reserve(growth->arena, &array, &patch->steps_room, local + 1, sizeof *patch->steps, err));
    patch->steps = array;
    patch->steps[local] = steps;
    if (fresh < 3) {
        double place[2] = {0, 0};
        for (uint32_t c = 1; c < 3; c++) {
            uint32_t from = (fresh + c) % 3;
            const double *at = &patch->place[2 * growth->point_local[corner[from]]];
            unfold(growth->ground, face, sign, fresh, from, at, place);
        }
        place[0] /= 2;
        place[1] /= 2;
        HATCH_TRY(add_vertex(growth, corner[fresh], place, err));
    }
    patch->face_count++;
    patch->faces[local] = face;
    patch->sign[local] = sign;
    for (uint32_t c = 0; c < 3; c++)
        patch->corners[3 * local + c] = growth->point_local[corner[c]];
    growth->face_round[face] = growth->round;
    growth->face_local[face] = local;
    return push_sides(growth, face, err);
}

bool hatch_growth_may(const struct hatch_growth *growth, uint32_t side)
{
    uint32_t other = across(growth->ground->surface, side);
    return other != HATCH_NO_SIDE && !holds_face(growth, other / 3) &&
           growth->patch.face_count < growth->patch.faces_max && stays_disk(growth, other / 3) &&
           agree(growth, other / 3) != 0;
}

void hatch_growth_keep(struct hatch_growth *growth)
{
    const struct hatch_patch *patch = &growth->patch;
    for (uint32_t v = 0; v < patch->vertex_count; v++) {
        growth->place_number[patch->points[v]] = growth->number;
        memcpy(&growth->known[(size_t)patch->points[v] * 2], &patch->place[(size_t)v * 2],
               2 * sizeof *patch->place);
    }
    growth->unfolded = 0;
}

void hatch_growth_begin(struct hatch_growth *growth, uint32_t seed)
{
    struct hatch_patch *patch = &growth->patch;
    growth->number++;
    patch->seed = seed;
    patch->face_count = 0;
    patch->offset[0] = patch->offset[1] = 0;
    patch->faces_max = growth->budget[seed];
}

static enum hatch_status plant(struct hatch_growth *growth, struct hatch_err *err)
{
    struct hatch_patch *patch = &growth->patch;
    const uint32_t *corner = &growth->ground->surface->corners[(size_t)patch->seed * 3];
    patch->face_count = patch->vertex_count = growth->heap.count = growth->unfolded = 0;
    growth->round++;
    for (uint32_t c = 0; c < 3; c++) {
        double place[2];
        hatch_ground_corner(growth->ground, patch->seed, c, place);
        HATCH_TRY(add_vertex(growth, corner[c], place, err));
    }
    return add_face(growth, patch->seed, 1, 0, 3, err);
}

enum hatch_status hatch_growth_grow(struct hatch_growth *growth, struct hatch_err *err)
{
    struct hatch_patch *patch = &growth->patch;
    const struct hatch_surface *surface = growth->ground->surface;
    HATCH_TRY(plant(growth, err));
    struct hatch_heap_item item;
    while (patch->face_count < patch->faces_max && hatch_heap_pop(&growth->heap, &item)) {
        uint32_t side = surface->opposite[item.id], face = side / 3;
        uint8_t steps = growth->covered[face]
                            ? (uint8_t)(patch->steps[growth->face_local[item.id / 3]] + 1) : 0;
        if (holds_face(growth, face) || steps > STEPS_MAX || !stays_disk(growth, face))
            continue;
        int8_t sign = agree(growth, face);
        if (!sign)
            continue;
        uint32_t fresh = 3;
        for (uint32_t c = 0; c < 3; c++)
            if (!holds_point(growth, surface->corners[side_of(face, c)]))
                fresh = c;
        HATCH_TRY(add_face(growth, face, sign, steps, fresh, err));
    }
    return HATCH_OK;
}
