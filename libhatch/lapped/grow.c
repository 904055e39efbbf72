#include <math.h>
#include <string.h>

#include "lapped/work.h"
#include "mesh/edges.h"

/* Largest number of covered faces that a patch may add one behind another. */
#define COVERED_DEPTH_MAX 1

enum hatch_status hatch_growth_make(const struct hatch_patch_domain *domain, const struct hatch_outline *outline,
                                    const uint8_t *covered, struct hatch_arena *arena, struct hatch_growth *growth,
                                    struct hatch_err *err)
{
    const struct hatch_surface *surface = domain->surface;
    struct hatch_growth made = {.covered = covered,
                                .domain = domain,
                                .outline = outline,
                                .arena = arena,
                                .heap = {.arena = arena},
                                .obstacles = {.arena = arena}};
    HATCH_TRY(HATCH_ALLOC(arena, &made.face, surface->face_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.excluded_from, surface->face_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.point, surface->point_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.last_position, surface->point_count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &made.start_faces_max, surface->face_count, err));
    for (uint32_t f = 0; f < surface->face_count; f++)
        made.start_faces_max[f] = domain->faces_max;
    *growth = made;
    return HATCH_OK;
}

static uint32_t side_of(uint32_t face, uint32_t corner)
{
    return face * 3 + corner;
}

static bool contains_face(const struct hatch_growth *growth, uint32_t face)
{
    return growth->face[face].round == growth->round;
}

static bool contains_point(const struct hatch_growth *growth, uint32_t point)
{
    return growth->point[point].round == growth->round;
}

bool hatch_growth_side_inside(const struct hatch_growth *growth, uint32_t side)
{
    return growth->domain->matching[side] != 0 && contains_face(growth, growth->domain->surface->opposite[side] / 3);
}

static int count_sides_inside(const struct hatch_growth *growth, uint32_t face)
{
    int count = 0;
    for (uint32_t c = 0; c < 3; c++)
        count += hatch_growth_side_inside(growth, side_of(face, c));
    return count;
}

/* Returns the sign that a face would have in the patch, or 0 if the patch may not add it. Its direction must agree with
 * those of its neighbours, it must not be reached only through a face with an index, and the patch must remain a disk
 * that has faces with an index on its boundary only. */
static int8_t admissible_sign(const struct hatch_growth *growth, uint32_t face)
{
    const struct hatch_patch_domain *domain = growth->domain;
    const uint32_t *opposite = &domain->surface->opposite[(size_t)face * 3];
    int8_t sign = 0, through = 0;
    uint32_t shared = 0, last = 0;
    if (growth->excluded_from[face] == growth->patch_number)
        return 0;
    for (uint32_t c = 0; c < 3; c++) {
        int8_t matching = domain->matching[side_of(face, c)];
        uint32_t neighbour = opposite[c] / 3;
        if (matching == 0 || !contains_face(growth, neighbour))
            continue;
        bool has_index = domain->singular[neighbour];
        if (has_index && count_sides_inside(growth, neighbour) > 1)
            return 0;
        shared++;
        last = c;
        int8_t own_sign = (int8_t)((matching < 0 ? -1 : 1) * growth->patch.sign[growth->face[neighbour].local]);
        if (domain->singular[face] || (has_index && growth->patch.face_count == 1)) {
            through = own_sign;
        } else if (!has_index) {
            if (matching == 1 || matching == -1 || sign == -own_sign)
                return 0;
            sign = own_sign;
        }
    }
    if (shared == 0 || shared == 3 ||
        (shared == 1 && contains_point(growth, domain->surface->corners[side_of(face, (last + 2) % 3)])))
        return 0;
    return sign ? sign : through;
}

/* Adds to sum the position that a corner of a face has when the face is laid into the plane with its corner `from` at
 * xy. */
static void unfold(const struct hatch_patch_domain *domain, uint32_t face, int8_t sign, uint32_t corner, uint32_t from,
                   const double xy[2], double sum[2])
{
    double a[2], b[2];
    hatch_patch_domain_corner(domain, face, from, a);
    hatch_patch_domain_corner(domain, face, corner, b);
    for (int i = 0; i < 2; i++)
        sum[i] += xy[i] + sign * (b[i] - a[i]);
}

/* Grows arrays that share one capacity.
 *   sizes  bytes per item of each array */
static enum hatch_status reserve_all(struct hatch_arena *arena, void *const *arrays, const size_t *sizes, size_t count,
                                     uint32_t *capacity, uint32_t needed, struct hatch_err *err)
{
    uint32_t wider = *capacity;
    for (size_t i = 0; i < count && needed > *capacity; i++) {
        void *array;
        wider = *capacity;
        memcpy(&array, arrays[i], sizeof array);
        HATCH_TRY(hatch_lapped_reserve(arena, &array, &wider, needed, sizes[i], err));
        memcpy(arrays[i], &array, sizeof array);
    }
    *capacity = wider;
    return HATCH_OK;
}

/* Makes room for another face and another vertex. */
static enum hatch_status reserve_one_more(struct hatch_growth *growth, struct hatch_err *err)
{
    struct hatch_patch *patch = &growth->patch;
    void *const face_arrays[] = {&patch->faces, &patch->sign, &patch->limit_state, &patch->covered_depth,
                                 &patch->corners};
    static const size_t face_sizes[] = {sizeof *patch->faces, sizeof *patch->sign, sizeof *patch->limit_state,
                                        sizeof *patch->covered_depth, 3 * sizeof *patch->corners};
    void *const vertex_arrays[] = {&patch->points, &patch->xy};
    static const size_t vertex_sizes[] = {sizeof *patch->points, 2 * sizeof *patch->xy};
    HATCH_TRY(
        reserve_all(growth->arena, face_arrays, face_sizes, 5, &patch->face_capacity, patch->face_count + 1, err));
    return reserve_all(growth->arena, vertex_arrays, vertex_sizes, 2, &patch->vertex_capacity, patch->vertex_count + 1,
                       err);
}

static void add_vertex(struct hatch_growth *growth, uint32_t point, const double xy[2])
{
    struct hatch_patch *patch = &growth->patch;
    const struct hatch_last_position *last = &growth->last_position[point];
    uint32_t local = patch->vertex_count++;
    bool solved = last->patch_number == growth->patch_number;
    patch->points[local] = point;
    growth->point[point] = (struct hatch_local_index){growth->round, local};
    growth->unsolved_count += !solved;
    memcpy(&patch->xy[(size_t)local * 2], solved ? last->xy : xy, 2 * sizeof *xy);
}

static double distance_to_side(const double center[2], const double a[2], const double b[2])
{
    double x = b[0] - a[0], y = b[1] - a[1], length = x * x + y * y;
    double t = length > 0 ? ((center[0] - a[0]) * x + (center[1] - a[1]) * y) / length : 0;
    t = t > 0 ? t < 1 ? t : 1 : 0;
    double dx = a[0] + t * x - center[0], dy = a[1] + t * y - center[1];
    return sqrt(dx * dx + dy * dy);
}

static void side_ends(const struct hatch_growth *growth, uint32_t side, const double *ends[2])
{
    const uint32_t *corners = growth->domain->surface->corners;
    ends[0] = &growth->patch.xy[2 * growth->point[corners[side]].local];
    ends[1] = &growth->patch.xy[2 * growth->point[corners[hatch_side_end(side)]].local];
}

/* Queues a side when the outline touches it. */
static enum hatch_status push_side(struct hatch_growth *growth, uint32_t side, struct hatch_err *err)
{
    const struct hatch_patch *patch = &growth->patch;
    double inner = 2 * patch->radius * growth->outline->core_min;
    double outer = 2 * patch->radius * growth->outline->reach_max;
    const double *ends[2];
    side_ends(growth, side, ends);
    double away = distance_to_side(patch->center, ends[0], ends[1]);
    if (away < inner || (away < outer && hatch_patch_touches(patch, growth->outline, ends[0], ends[1])))
        return hatch_heap_push(&growth->heap, away, side, err);
    return HATCH_OK;
}

/* Adds a face.
 *   new_corner  the corner whose vertex the patch lacks; 3: none */
static enum hatch_status add_face(struct hatch_growth *growth, uint32_t face, int8_t sign, uint8_t depth,
                                  uint32_t new_corner, struct hatch_err *err)
{
    struct hatch_patch *patch = &growth->patch;
    const uint32_t *corner = &growth->domain->surface->corners[(size_t)face * 3];
    const uint32_t *opposite = &growth->domain->surface->opposite[(size_t)face * 3];
    uint32_t local = patch->face_count++;
    if (new_corner < 3) {
        double xy[2] = {0, 0};
        for (uint32_t c = 1; c < 3; c++) {
            uint32_t from = (new_corner + c) % 3;
            const double *at = &patch->xy[2 * growth->point[corner[from]].local];
            unfold(growth->domain, face, sign, new_corner, from, at, xy);
        }
        xy[0] /= 2;
        xy[1] /= 2;
        add_vertex(growth, corner[new_corner], xy);
    }
    patch->faces[local] = face;
    patch->sign[local] = sign;
    patch->covered_depth[local] = depth;
    growth->face[face] = (struct hatch_local_index){growth->round, local};
    for (uint32_t c = 0; c < 3; c++) {
        patch->corners[3 * local + c] = growth->point[corner[c]].local;
        if (growth->domain->matching[side_of(face, c)] != 0 && !contains_face(growth, opposite[c] / 3))
            HATCH_TRY(push_side(growth, side_of(face, c), err));
    }
    return HATCH_OK;
}

void hatch_growth_store_positions(struct hatch_growth *growth)
{
    const struct hatch_patch *patch = &growth->patch;
    for (uint32_t v = 0; v < patch->vertex_count; v++) {
        struct hatch_last_position *last = &growth->last_position[patch->points[v]];
        last->patch_number = growth->patch_number;
        memcpy(last->xy, &patch->xy[(size_t)v * 2], sizeof last->xy);
    }
    growth->unsolved_count = 0;
}

void hatch_growth_begin(struct hatch_growth *growth, uint32_t seed_face)
{
    struct hatch_patch *patch = &growth->patch;
    growth->patch_number++;
    patch->seed_face = seed_face;
    patch->face_count = 0;
    patch->offset[0] = patch->offset[1] = 0;
    patch->faces_max = growth->start_faces_max[seed_face];
}

static enum hatch_status start_at_seed(struct hatch_growth *growth, struct hatch_err *err)
{
    struct hatch_patch *patch = &growth->patch;
    const uint32_t *corner = &growth->domain->surface->corners[(size_t)patch->seed_face * 3];
    patch->face_count = patch->vertex_count = growth->heap.count = growth->unsolved_count = 0;
    patch->measured_count = patch->exceeded_count = patch->near_count = 0;
    growth->round++;
    for (uint32_t c = 0; c < 3; c++) {
        double xy[2];
        hatch_patch_domain_corner(growth->domain, patch->seed_face, c, xy);
        HATCH_TRY(reserve_one_more(growth, err));
        add_vertex(growth, corner[c], xy);
    }
    return add_face(growth, patch->seed_face, 1, 0, 3, err);
}

/* Returns the covered_depth that the face behind a side of the patch would have. */
static uint8_t covered_depth_behind(const struct hatch_growth *growth, uint32_t side, uint32_t face)
{
    return growth->covered[face] ? (uint8_t)(growth->patch.covered_depth[growth->face[side / 3].local] + 1) : 0;
}

static enum hatch_status find_boundary(struct hatch_growth *growth, struct hatch_err *err)
{
    struct hatch_patch *patch = &growth->patch;
    const uint32_t *opposite = growth->domain->surface->opposite;
    void *boundary = patch->boundary;
    HATCH_TRY(hatch_lapped_reserve(growth->arena, &boundary, &patch->boundary_capacity, patch->face_count + 2,
                                   sizeof *patch->boundary, err));
    patch->boundary = boundary;
    patch->boundary_count = 0;
    for (uint32_t f = 0; f < patch->face_count; f++) {
        for (uint32_t c = 0; c < 3; c++) {
            uint32_t side = side_of(patch->faces[f], c), behind = opposite[side];
            if (behind == HATCH_NO_SIDE || hatch_growth_side_inside(growth, side))
                continue;
            patch->boundary[patch->boundary_count++] = (struct hatch_boundary_side){
                .side = side,
                .ends = {patch->corners[3 * f + c], patch->corners[3 * f + (c + 1) % 3]},
                .covered = growth->covered[behind / 3],
                .growable = growth->domain->matching[side] != 0 &&
                            covered_depth_behind(growth, side, behind / 3) <= COVERED_DEPTH_MAX &&
                            admissible_sign(growth, behind / 3) != 0,
            };
        }
    }
    return HATCH_OK;
}

/* Adds the faces behind queued sides, nearest first, and then those behind the sides of the added faces. */
static enum hatch_status add_queued_faces(struct hatch_growth *growth, struct hatch_err *err)
{
    struct hatch_patch *patch = &growth->patch;
    const struct hatch_surface *surface = growth->domain->surface;
    struct hatch_heap_item item;
    while (patch->face_count < patch->faces_max && hatch_heap_pop(&growth->heap, &item)) {
        uint32_t face = surface->opposite[item.id] / 3;
        if (contains_face(growth, face))
            continue;
        uint8_t depth = covered_depth_behind(growth, item.id, face);
        int8_t sign = depth > COVERED_DEPTH_MAX ? 0 : admissible_sign(growth, face);
        if (!sign)
            continue;
        uint32_t new_corner = 3;
        for (uint32_t c = 0; c < 3; c++)
            if (!contains_point(growth, surface->corners[side_of(face, c)]))
                new_corner = c;
        HATCH_TRY(reserve_one_more(growth, err));
        HATCH_TRY(add_face(growth, face, sign, depth, new_corner, err));
    }
    return find_boundary(growth, err);
}

enum hatch_status hatch_growth_grow(struct hatch_growth *growth, struct hatch_err *err)
{
    HATCH_TRY(start_at_seed(growth, err));
    return add_queued_faces(growth, err);
}

enum hatch_status hatch_growth_extend(struct hatch_growth *growth, struct hatch_err *err)
{
    const struct hatch_patch *patch = &growth->patch;
    growth->heap.count = 0;
    for (uint32_t i = 0; i < patch->boundary_count; i++)
        if (patch->boundary[i].growable)
            HATCH_TRY(push_side(growth, patch->boundary[i].side, err));
    return growth->heap.count > 0 && patch->face_count < patch->faces_max ? add_queued_faces(growth, err) : HATCH_OK;
}
