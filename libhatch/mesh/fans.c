#include "mesh/fans.h"

void hatch_sets_init(uint32_t *parent, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++)
        parent[i] = i;
}

uint32_t hatch_sets_find(uint32_t *parent, uint32_t member)
{
    while (parent[member] != member) {
        parent[member] = parent[parent[member]];
        member = parent[member];
    }
    return member;
}

void hatch_sets_join(uint32_t *parent, uint32_t a, uint32_t b)
{
    a = hatch_sets_find(parent, a);
    b = hatch_sets_find(parent, b);
    if (a < b)
        parent[b] = a;
    else
        parent[a] = b;
}

/* Joins the corners of two faces at the ends of their common edge, except at those that are cut. */
static void join_sides(const uint32_t *point, uint32_t side, uint32_t other, unsigned cut, uint32_t *parent)
{
    uint32_t end = hatch_side_end(side), other_end = hatch_side_end(other);
    bool same_way = point[side] == point[other];
    if (!(cut & 1))
        hatch_sets_join(parent, side, same_way ? other : other_end);
    if (!(cut & 2))
        hatch_sets_join(parent, end, same_way ? other_end : other);
}

uint32_t hatch_mesh_corner_fans(const uint32_t *point, const uint32_t *partner, const uint8_t *cut, uint32_t face_count,
                                uint32_t *fan)
{
    uint32_t corner_count = face_count * 3, fan_count = 0;
    hatch_sets_init(fan, corner_count);
    for (uint32_t side = 0; side < corner_count; side++)
        if (partner[side] != HATCH_NO_EDGE && side < partner[side])
            join_sides(point, side, partner[side], cut ? cut[side] : 0, fan);
    /* The root of a fan is its lowest corner, so it is numbered before the other corners. */
    for (uint32_t i = 0; i < corner_count; i++)
        fan[i] = hatch_sets_find(fan, i);
    for (uint32_t i = 0; i < corner_count; i++)
        fan[i] = fan[i] == i ? fan_count++ : fan[fan[i]];
    return fan_count;
}

enum hatch_status hatch_mesh_count_pinched(const struct hatch_connectivity *faces, const struct hatch_edges *edges,
                                           struct hatch_arena *scratch, uint32_t *count, struct hatch_err *err)
{
    uint32_t corner_count = faces->face_count * 3, pinched = 0;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    uint32_t *parent = HATCH_NEW(scratch, uint32_t, (size_t)faces->face_count * 3, err);
    /* Number of fans per point, counted up to 2. */
    uint8_t *fans = parent ? HATCH_NEW(scratch, uint8_t, faces->point_count, err) : NULL;
    if (!fans) {
        hatch_arena_rewind(scratch, mark);
        return HATCH_LIMIT;
    }
    hatch_sets_init(parent, corner_count);
    for (uint32_t e = 0; e < edges->count; e++)
        for (uint32_t i = edges->first[e] + 1; i < edges->first[e + 1]; i++)
            join_sides(faces->point, edges->sides[edges->first[e]], edges->sides[i], 0, parent);
    for (uint32_t i = 0; i < corner_count; i++)
        if (parent[i] == i && !(faces->dropped && faces->dropped[i / 3]) && fans[faces->point[i]] < 2)
            pinched += ++fans[faces->point[i]] == 2;
    *count = pinched;
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
