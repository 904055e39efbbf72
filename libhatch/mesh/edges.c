#include "mesh/edges.h"

#include <assert.h>
#include <string.h>

#include "math/vector.h"

#define FLAT 1e-5 /* faces with a smaller ratio of height to width may be due to rounding of floats */

void hatch_mesh_corner_points(const struct hatch_mesh *mesh, const uint32_t *vertex_to_point, uint32_t *point)
{
    for (size_t i = 0; i < (size_t)mesh->face_count * 3; i++)
        point[i] = vertex_to_point[mesh->indices[i]];
}

static uint32_t low_point(const uint32_t *point, uint32_t side)
{
    uint32_t a = point[side], b = point[hatch_side_end(side)];
    return a < b ? a : b;
}

static uint32_t high_point(const uint32_t *point, uint32_t side)
{
    uint32_t a = point[side], b = point[hatch_side_end(side)];
    return a < b ? b : a;
}

/* Does one pass of a stable counting sort of sides.
 *   starts  scratch: room for point_count + 1 */
static void sort_by(uint32_t (*key)(const uint32_t *, uint32_t), const uint32_t *point, uint32_t point_count,
                    const uint32_t *from, uint32_t *to, uint32_t count, uint32_t *starts)
{
    memset(starts, 0, ((size_t)point_count + 1) * sizeof *starts);
    for (uint32_t i = 0; i < count; i++)
        starts[key(point, from[i]) + 1]++;
    for (uint32_t p = 0; p < point_count; p++)
        starts[p + 1] += starts[p];
    for (uint32_t i = 0; i < count; i++)
        to[starts[key(point, from[i])]++] = from[i];
}

static uint32_t list_sides(const struct hatch_connectivity *faces, uint32_t *sides)
{
    uint32_t count = 0;
    for (uint32_t side = 0; side < faces->face_count * 3; side++)
        if (!(faces->dropped && faces->dropped[side / 3]) && faces->point[side] != faces->point[hatch_side_end(side)])
            sides[count++] = side;
    return count;
}

static void group_by_edge(const uint32_t *point, uint32_t side_count, struct hatch_edges *edges)
{
    edges->count = 0;
    for (uint32_t i = 0; i < side_count; i++) {
        uint32_t side = edges->sides[i], before = i ? edges->sides[i - 1] : side;
        if (i == 0 || low_point(point, side) != low_point(point, before) ||
            high_point(point, side) != high_point(point, before))
            edges->first[edges->count++] = i;
    }
    edges->first[edges->count] = side_count;
}

enum hatch_status hatch_edges_find(const struct hatch_connectivity *faces, struct hatch_arena *arena,
                                   struct hatch_arena *scratch, struct hatch_edges *edges, struct hatch_err *err)
{
    assert(faces->face_count <= UINT32_MAX / 3 - 1);
    size_t all = (size_t)faces->face_count * 3;
    struct hatch_edges found;
    HATCH_TRY(HATCH_ALLOC(arena, &found.first, all + 1, err));
    HATCH_TRY(HATCH_ALLOC(arena, &found.sides, all, err));
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    uint32_t *listed = HATCH_NEW(scratch, uint32_t, all, err);
    uint32_t *starts = listed ? HATCH_NEW(scratch, uint32_t, (size_t)faces->point_count + 1, err) : NULL;
    if (starts) {
        uint32_t count = list_sides(faces, found.sides);
        sort_by(high_point, faces->point, faces->point_count, found.sides, listed, count, starts);
        sort_by(low_point, faces->point, faces->point_count, listed, found.sides, count, starts);
        group_by_edge(faces->point, count, &found);
        *edges = found;
    }
    hatch_arena_rewind(scratch, mark);
    return starts ? HATCH_OK : HATCH_LIMIT;
}

void hatch_edges_partners(const struct hatch_edges *edges, const uint8_t *sharp, uint32_t face_count, uint32_t *partner)
{
    memset(partner, 0xff, (size_t)face_count * 3 * sizeof *partner);
    for (uint32_t e = 0; e < edges->count; e++) {
        const uint32_t *sides = &edges->sides[edges->first[e]];
        if (edges->first[e + 1] - edges->first[e] != 2 || (sharp && sharp[e]))
            continue;
        partner[sides[0]] = sides[1];
        partner[sides[1]] = sides[0];
    }
}

bool hatch_side_direction(const struct hatch_mesh *mesh, uint32_t side, double direction[3])
{
    const float *positions = mesh->attributes[0].data;
    uint32_t end = hatch_side_end(side), rest = hatch_side_end(end);
    double a[3], b[3], c[3], along[3];
    hatch_vec_of(&positions[(size_t)mesh->indices[side] * 3], a);
    hatch_vec_of(&positions[(size_t)mesh->indices[end] * 3], b);
    hatch_vec_of(&positions[(size_t)mesh->indices[rest] * 3], c);
    hatch_vec_sub(b, a, along);
    hatch_vec_sub(c, a, direction);
    hatch_vec_normalize(along);
    double width = hatch_vec_length(direction);
    hatch_vec_add_scaled(direction, -hatch_vec_dot(direction, along), along, direction);
    return hatch_vec_normalize(direction) > FLAT * width;
}
