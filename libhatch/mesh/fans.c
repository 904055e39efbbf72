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

/* Joins the corners of all faces along one edge, end by end. */
static void join_edge(const uint32_t *point, const uint32_t *sides, uint32_t count,
                      uint32_t *parent)
{
    uint32_t start = sides[0], end = hatch_side_end(sides[0]);
    for (uint32_t i = 1; i < count; i++) {
        uint32_t a = sides[i], b = hatch_side_end(sides[i]);
        bool same_way = point[a] == point[start];
        hatch_sets_join(parent, start, same_way ? a : b);
        hatch_sets_join(parent, end, same_way ? b : a);
    }
}

uint32_t hatch_mesh_corner_fans(const uint32_t *point, uint32_t face_count,
                                const struct hatch_edges *edges, const uint8_t *sharp, uint32_t *fan)
{
    uint32_t corner_count = face_count * 3, fan_count = 0;
    hatch_sets_init(fan, corner_count);
    for (uint32_t e = 0; e < edges->count; e++)
        if (edges->first[e + 1] - edges->first[e] == 2 && !(sharp && sharp[e]))
            join_edge(point, &edges->sides[edges->first[e]], 2, fan);
    /* A root is the lowest corner of its fan, so its number is known before its members ask. */
    for (uint32_t i = 0; i < corner_count; i++)
        fan[i] = hatch_sets_find(fan, i);
    for (uint32_t i = 0; i < corner_count; i++)
        fan[i] = fan[i] == i ? fan_count++ : fan[fan[i]];
    return fan_count;
}

enum hatch_status hatch_mesh_count_pinched(const uint32_t *point, uint32_t face_count,
                                           uint32_t point_count, const struct hatch_edges *edges,
                                           const uint8_t *dropped, struct hatch_arena *scratch,
                                           uint32_t *count, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    uint32_t *parent = HATCH_NEW(scratch, uint32_t, (size_t)face_count * 3, err);
    uint8_t *fans = parent ? HATCH_NEW(scratch, uint8_t, point_count, err) : NULL;
    if (!fans) {
        hatch_arena_rewind(scratch, mark);
        return HATCH_LIMIT;
    }
    hatch_sets_init(parent, face_count * 3);
    for (uint32_t e = 0; e < edges->count; e++)
        join_edge(point, &edges->sides[edges->first[e]], edges->first[e + 1] - edges->first[e],
                  parent);
    uint32_t pinched = 0;
    for (uint32_t i = 0; i < face_count * 3; i++)
        if (parent[i] == i && !(dropped && dropped[i / 3]) && fans[point[i]] < 2)
            pinched += ++fans[point[i]] == 2;
    *count = pinched;
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
