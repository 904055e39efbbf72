#include "surface/work.h"

/* The state of a walk around a point. */
struct walk {
    uint32_t corner; /* the point's corner in the current face */
    bool flipped;    /* whether the face is clockwise seen from the outside of the ring */
};

/* Returns the side over which a counter-clockwise walk enters the face or, if leave is true, leaves it. */
static uint32_t side_of(struct walk at, bool leave)
{
    return leave != at.flipped ? hatch_side_end(hatch_side_end(at.corner)) : at.corner;
}

/* Returns the end of a side that is not the point. */
static uint32_t far_end(const struct hatch_surface *s, uint32_t side, uint32_t point)
{
    return s->corners[side] == point ? s->corners[hatch_side_end(side)] : s->corners[side];
}

/* Moves to the next face, counter-clockwise or clockwise. Returns false at a border. */
static bool step(const struct hatch_surface *s, bool counter_clockwise, struct walk *at)
{
    uint32_t side = side_of(*at, counter_clockwise), other = s->opposite[side];
    uint32_t point = s->corners[at->corner];
    if (other == HATCH_NO_SIDE)
        return false;
    at->flipped = at->flipped != hatch_surface_is_contrary(s, side, other);
    at->corner = s->corners[other] == point ? other : hatch_side_end(other);
    return true;
}

/* Writes the ring of a point from entry `entry` on; an open ring starts at its clockwise end. Returns the entry after
 * the ring's last.
 *   first_corner    the point's corner in its first face
 *   corner_flipped  out: per corner of the ring, whether its face is clockwise seen from the outside of the ring */
static uint32_t fill_ring(struct hatch_surface *s, uint32_t first_corner, uint32_t entry, uint8_t *corner_flipped)
{
    uint32_t point = s->corners[first_corner];
    struct walk at = {.corner = first_corner};
    bool inside;
    do
        inside = step(s, false, &at);
    while (inside && at.corner != first_corner);
    uint32_t start = at.corner;
    do {
        corner_flipped[at.corner] = at.flipped;
        s->ring_point[entry] = far_end(s, side_of(at, false), point);
        s->ring_face[entry] = at.corner / 3;
        s->ring_flipped[entry++] = at.flipped;
        inside = step(s, true, &at);
    } while (inside && at.corner != start);
    if (!inside) {
        s->ring_point[entry] = far_end(s, side_of(at, true), point);
        s->ring_face[entry++] = HATCH_NO_SIDE;
    }
    return entry;
}

static void find_turned(struct hatch_surface *s, const uint8_t *corner_flipped)
{
    for (uint32_t p = 0; p < s->point_count; p++) {
        if (s->components[s->point_component[p]].orientable)
            continue;
        for (uint32_t i = s->ring_first[p]; i < s->ring_first[p + 1]; i++) {
            uint32_t shared = s->ring_face[i] == HATCH_NO_SIDE ? i - 1 : i;
            uint32_t corner = 3 * s->ring_face[shared];
            while (s->corners[corner] != s->ring_point[i])
                corner++;
            s->ring_turned[i] = corner_flipped[corner] != s->ring_flipped[shared];
        }
    }
}

static uint32_t count_entries(const struct hatch_surface *s)
{
    uint32_t count = 3 * s->face_count;
    for (uint32_t side = 0; side < 3 * s->face_count; side++)
        count += s->opposite[side] == HATCH_NO_SIDE; /* there are as many border points as border sides */
    return count;
}

enum hatch_status hatch_surface_make_rings(struct hatch_surface *s, struct hatch_arena *arena,
                                           struct hatch_arena *scratch, struct hatch_err *err)
{
    size_t entries = count_entries(s);
    uint32_t *first_corner;
    uint8_t *corner_flipped;
    HATCH_TRY(HATCH_ALLOC(arena, &s->ring_first, (size_t)s->point_count + 1, err));
    HATCH_TRY(HATCH_ALLOC(arena, &s->ring_point, entries, err));
    HATCH_TRY(HATCH_ALLOC(arena, &s->ring_face, entries, err));
    HATCH_TRY(HATCH_ALLOC(arena, &s->ring_flipped, entries, err));
    HATCH_TRY(HATCH_ALLOC(arena, &s->ring_turned, entries, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &first_corner, s->point_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &corner_flipped, (size_t)s->face_count * 3, err));
    for (uint32_t corner = 3 * s->face_count; corner-- > 0;)
        first_corner[s->corners[corner]] = corner;
    for (uint32_t p = 0; p < s->point_count; p++)
        s->ring_first[p + 1] = fill_ring(s, first_corner[p], s->ring_first[p], corner_flipped);
    find_turned(s, corner_flipped);
    return HATCH_OK;
}
