#include <math.h>
#include <string.h>

#include "lapped/work.h"
#include "mesh/edges.h"

/* How many faces deep a patch grows into covered ground. */
#define STEPS_MAX 1

enum hatch_status hatch_growth_make(const struct hatch_ground *ground, const struct hatch_outline *outline,
                                    const uint8_t *covered, struct hatch_arena *arena, struct hatch_growth *growth,
                                    struct hatch_err *err)
{
    const struct hatch_surface *surface = ground->surface;
    struct hatch_growth made = {.covered = covered,
                                .ground = ground,
                                .outline = outline,
                                .arena = arena,
                                .heap = {.arena = arena},
                                .obstacles = {.arena = arena}};
    made.face = HATCH_NEW(arena, struct hatch_stamp, surface->face_count, err);
    made.barred = made.face ? HATCH_NEW(arena, uint32_t, surface->face_count, err) : NULL;
    made.point = made.barred ? HATCH_NEW(arena, struct hatch_stamp, surface->point_count, err) : NULL;
    made.known = made.point ? HATCH_NEW(arena, struct hatch_known, surface->point_count, err) : NULL;
    made.budget = made.known ? HATCH_NEW_UNSET(arena, uint32_t, surface->face_count, err) : NULL;
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

static bool holds_face(const struct hatch_growth *growth, uint32_t face)
{
    return growth->face[face].round == growth->round;
}

static bool holds_point(const struct hatch_growth *growth, uint32_t point)
{
    return growth->point[point].round == growth->round;
}

enum hatch_side hatch_growth_side(const struct hatch_growth *growth, uint32_t side)
{
    uint32_t other = growth->ground->surface->opposite[side];
    if (other == HATCH_NO_SIDE)
        return HATCH_SIDE_BORDER;
    return growth->ground->bend[side] != 0 && holds_face(growth, other / 3) ? HATCH_SIDE_INSIDE : HATCH_SIDE_OPEN;
}

/* How many of a face's sides the patch holds the other face of. */
static int sides_inside(const struct hatch_growth *growth, uint32_t face)
{
    int count = 0;
    for (uint32_t c = 0; c < 3; c++)
        count += hatch_growth_side(growth, side_of(face, c)) == HATCH_SIDE_INSIDE;
    return count;
}

/* The sign with which the patch may have this face: its line then agrees with those around, it is not only
 * reached through a face with an index, and the patch stays a disk that encloses no index; else 0. */
static int8_t admit(const struct hatch_growth *growth, uint32_t face)
{
    const struct hatch_ground *ground = growth->ground;
    const uint32_t *opposite = &ground->surface->opposite[(size_t)face * 3];
    int8_t sign = 0, through = 0;
    uint32_t shared = 0, last = 0;
    if (growth->barred[face] == growth->number)
        return 0;
    for (uint32_t c = 0; c < 3; c++) {
        int8_t bend = ground->bend[side_of(face, c)];
        uint32_t neighbour = opposite[c] / 3;
        if (bend == 0 || !holds_face(growth, neighbour))
            continue;
        bool index = ground->singular[neighbour];
        if (index && sides_inside(growth, neighbour) > 1)
            return 0;
        shared++;
        last = c;
        int8_t own = (int8_t)((bend < 0 ? -1 : 1) * growth->patch.sign[growth->face[neighbour].local]);
        if (ground->singular[face] || (index && growth->patch.face_count == 1)) {
            through = own;
        } else if (!index) {
            if (bend == 1 || bend == -1 || sign == -own)
                return 0;
            sign = own;
        }
    }
    if (shared == 0 || shared == 3 ||
        (shared == 1 && holds_point(growth, ground->surface->corners[side_of(face, (last + 2) % 3)])))
        return 0;
    return sign ? sign : through;
}

/* Where a corner of a face comes to lie, seen from another corner that has its place. */
static void unfold(const struct hatch_ground *ground, uint32_t face, int8_t sign, uint32_t corner, uint32_t from,
                   const double place[2], double sum[2])
{
    double a[2], b[2];
    hatch_ground_corner(ground, face, from, a);
    hatch_ground_corner(ground, face, corner, b);
    for (int i = 0; i < 2; i++)
        sum[i] += place[i] + sign * (b[i] - a[i]);
}

/* Room for one more in arrays that have the same room; sizes: of what each has for one. */
static enum hatch_status widen(struct hatch_arena *arena, void *const *arrays, const size_t *sizes, size_t count,
                               uint32_t *room, uint32_t want, struct hatch_err *err)
{
    uint32_t wider = *room;
    for (size_t i = 0; i < count && want > *room; i++) {
        void *array;
        wider = *room;
        memcpy(&array, arrays[i], sizeof array);
        HATCH_TRY(hatch_heap_reserve(arena, &array, &wider, want, sizes[i], err));
        memcpy(arrays[i], &array, sizeof array);
    }
    *room = wider;
    return HATCH_OK;
}

/* Room for one face and one vertex more. */
static enum hatch_status make_room(struct hatch_growth *growth, struct hatch_err *err)
{
    struct hatch_patch *patch = &growth->patch;
    void *const of_faces[] = {&patch->faces, &patch->sign, &patch->past, &patch->steps, &patch->corners};
    static const size_t face_sizes[] = {sizeof *patch->faces, sizeof *patch->sign, sizeof *patch->past,
                                        sizeof *patch->steps, 3 * sizeof *patch->corners};
    void *const of_points[] = {&patch->points, &patch->place};
    static const size_t point_sizes[] = {sizeof *patch->points, 2 * sizeof *patch->place};
    HATCH_TRY(widen(growth->arena, of_faces, face_sizes, 5, &patch->face_room, patch->face_count + 1, err));
    return widen(growth->arena, of_points, point_sizes, 2, &patch->point_room, patch->vertex_count + 1, err);
}

static void add_vertex(struct hatch_growth *growth, uint32_t point, const double place[2])
{
    struct hatch_patch *patch = &growth->patch;
    const struct hatch_known *known = &growth->known[point];
    uint32_t local = patch->vertex_count++;
    bool solved = known->number == growth->number;
    patch->points[local] = point;
    growth->point[point] = (struct hatch_stamp){growth->round, local};
    growth->unfolded += !solved;
    memcpy(&patch->place[(size_t)local * 2], solved ? known->place : place, 2 * sizeof *place);
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
    ends[0] = &growth->patch.place[2 * growth->point[corners[side]].local];
    ends[1] = &growth->patch.place[2 * growth->point[corners[hatch_side_end(side)]].local];
}

/* Queues a side if the outline touches it. */
static enum hatch_status push_side(struct hatch_growth *growth, uint32_t side, struct hatch_err *err)
{
    const struct hatch_patch *patch = &growth->patch;
    double inner = 2 * patch->radius * growth->outline->core_min;
    double outer = 2 * patch->radius * growth->outline->reach_max;
    const double *ends[2];
    side_places(growth, side, ends);
    double away = distance_to_side(patch->center, ends[0], ends[1]);
    if (away < inner || (away < outer && hatch_patch_touches(patch, growth->outline, ends[0], ends[1])))
        return hatch_heap_push(&growth->heap, away, side, err);
    return HATCH_OK;
}

/* Takes a face whose vertices but `fresh` (3: none) the patch has. */
static enum hatch_status add_face(struct hatch_growth *growth, uint32_t face, int8_t sign, uint8_t steps,
                                  uint32_t fresh, struct hatch_err *err)
{
    struct hatch_patch *patch = &growth->patch;
    const uint32_t *corner = &growth->ground->surface->corners[(size_t)face * 3];
    const uint32_t *opposite = &growth->ground->surface->opposite[(size_t)face * 3];
    uint32_t local = patch->face_count++;
    if (fresh < 3) {
        double place[2] = {0, 0};
        for (uint32_t c = 1; c < 3; c++) {
            uint32_t from = (fresh + c) % 3;
            const double *at = &patch->place[2 * growth->point[corner[from]].local];
            unfold(growth->ground, face, sign, fresh, from, at, place);
        }
        place[0] /= 2;
        place[1] /= 2;
        add_vertex(growth, corner[fresh], place);
    }
    patch->faces[local] = face;
    patch->sign[local] = sign;
    patch->steps[local] = steps;
    growth->face[face] = (struct hatch_stamp){growth->round, local};
    for (uint32_t c = 0; c < 3; c++) {
        patch->corners[3 * local + c] = growth->point[corner[c]].local;
        if (growth->ground->bend[side_of(face, c)] != 0 && !holds_face(growth, opposite[c] / 3))
            HATCH_TRY(push_side(growth, side_of(face, c), err));
    }
    return HATCH_OK;
}

void hatch_growth_keep(struct hatch_growth *growth)
{
    const struct hatch_patch *patch = &growth->patch;
    for (uint32_t v = 0; v < patch->vertex_count; v++) {
        struct hatch_known *known = &growth->known[patch->points[v]];
        known->number = growth->number;
        memcpy(known->place, &patch->place[(size_t)v * 2], sizeof known->place);
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
    patch->measured = patch->past_count = patch->wide_count = 0;
    growth->round++;
    for (uint32_t c = 0; c < 3; c++) {
        double place[2];
        hatch_ground_corner(growth->ground, patch->seed, c, place);
        HATCH_TRY(make_room(growth, err));
        add_vertex(growth, corner[c], place);
    }
    return add_face(growth, patch->seed, 1, 0, 3, err);
}

/* Of a face behind a side of the patch, how far in it lies. */
static uint8_t steps_behind(const struct hatch_growth *growth, uint32_t side, uint32_t face)
{
    return growth->covered[face] ? (uint8_t)(growth->patch.steps[growth->face[side / 3].local] + 1) : 0;
}

static enum hatch_status find_rim(struct hatch_growth *growth, struct hatch_err *err)
{
    struct hatch_patch *patch = &growth->patch;
    const uint32_t *opposite = growth->ground->surface->opposite;
    void *rim = patch->rim;
    HATCH_TRY(
        hatch_heap_reserve(growth->arena, &rim, &patch->rim_room, patch->face_count + 2, sizeof *patch->rim, err));
    patch->rim = rim;
    patch->rim_count = 0;
    for (uint32_t f = 0; f < patch->face_count; f++) {
        for (uint32_t c = 0; c < 3; c++) {
            uint32_t side = side_of(patch->faces[f], c), behind = opposite[side];
            if (behind == HATCH_NO_SIDE || (growth->ground->bend[side] != 0 && holds_face(growth, behind / 3)))
                continue;
            patch->rim[patch->rim_count++] = (struct hatch_rim){
                .side = side,
                .ends = {patch->corners[3 * f + c], patch->corners[3 * f + (c + 1) % 3]},
                .covered = growth->covered[behind / 3],
                .may = growth->ground->bend[side] != 0 && steps_behind(growth, side, behind / 3) <= STEPS_MAX &&
                       admit(growth, behind / 3) != 0,
            };
        }
    }
    return HATCH_OK;
}

/* Takes what is queued, nearest first. */
static enum hatch_status spread(struct hatch_growth *growth, struct hatch_err *err)
{
    struct hatch_patch *patch = &growth->patch;
    const struct hatch_surface *surface = growth->ground->surface;
    struct hatch_heap_item item;
    while (patch->face_count < patch->faces_max && hatch_heap_pop(&growth->heap, &item)) {
        uint32_t face = surface->opposite[item.id] / 3;
        if (holds_face(growth, face))
            continue;
        uint8_t steps = steps_behind(growth, item.id, face);
        int8_t sign = steps > STEPS_MAX ? 0 : admit(growth, face);
        if (!sign)
            continue;
        uint32_t fresh = 3;
        for (uint32_t c = 0; c < 3; c++)
            if (!holds_point(growth, surface->corners[side_of(face, c)]))
                fresh = c;
        HATCH_TRY(make_room(growth, err));
        HATCH_TRY(add_face(growth, face, sign, steps, fresh, err));
    }
    return find_rim(growth, err);
}

enum hatch_status hatch_growth_grow(struct hatch_growth *growth, struct hatch_err *err)
{
    HATCH_TRY(plant(growth, err));
    return spread(growth, err);
}

enum hatch_status hatch_growth_extend(struct hatch_growth *growth, struct hatch_err *err)
{
    const struct hatch_patch *patch = &growth->patch;
    growth->heap.count = 0;
    for (uint32_t i = 0; i < patch->rim_count; i++)
        if (patch->rim[i].may)
            HATCH_TRY(push_side(growth, patch->rim[i].side, err));
    return growth->heap.count > 0 && patch->face_count < patch->faces_max ? spread(growth, err) : HATCH_OK;
}
