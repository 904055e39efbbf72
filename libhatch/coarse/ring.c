/* The neighbourhood of a point, and which collapses leave it a surface. */
#include <assert.h>

#include "coarse/work.h"
#include "math/vector.h"

#define TURN_COS 0.2 /* cosine of the largest angle by which a collapse may turn a face */

static struct hatch_coarse_spoke *find_spoke(struct hatch_coarse_ring *ring, uint32_t point, uint32_t here,
                                             uint32_t there)
{
    for (uint32_t i = 0; i < ring->spoke_count; i++)
        if (ring->spokes[i].point == point) {
            ring->spokes[i].border |= ring->spokes[i].here != here || ring->spokes[i].there != there;
            return &ring->spokes[i];
        }
    struct hatch_coarse_spoke *spoke = &ring->spokes[ring->spoke_count++];
    *spoke = (struct hatch_coarse_spoke){.point = point, .here = here, .there = there};
    return spoke;
}

bool hatch_coarse_ring_find(struct hatch_coarse_work *work, uint32_t point, struct hatch_coarse_ring *ring)
{
    ring->point = point;
    ring->face_count = ring->spoke_count = ring->border_count = 0;
    for (uint32_t *link = &work->first[point]; *link != HATCH_COARSE_NONE;) {
        uint32_t corner = *link, face = corner / 3, side = corner % 3;
        const uint32_t *wedges = &work->corner[3 * face];
        if (wedges[0] == HATCH_COARSE_NONE) {
            *link = work->next[corner];
            continue;
        }
        link = &work->next[corner];
        if (ring->face_count == HATCH_COARSE_RING_MAX)
            return false;
        ring->faces[ring->face_count] = face;
        ring->sides[ring->face_count++] = side;
        uint32_t after = wedges[(side + 1) % 3], before = wedges[(side + 2) % 3];
        find_spoke(ring, work->point_of[after], wedges[side], after)->leaving++;
        find_spoke(ring, work->point_of[before], wedges[side], before)->coming++;
    }
    for (uint32_t i = 0; i < ring->spoke_count; i++) {
        struct hatch_coarse_spoke *spoke = &ring->spokes[i];
        spoke->border |= spoke->leaving != 1 || spoke->coming != 1;
        ring->border_count += spoke->border;
    }
    return ring->face_count > 0;
}

/* Adds to the collapse that wedge `from` is replaced by `to`. Returns false where it is already replaced by another. */
static bool add_pair(struct hatch_coarse_collapse *collapse, uint32_t from, uint32_t to)
{
    for (uint32_t i = 0; i < collapse->pair_count; i++)
        if (collapse->from[i] == from)
            return collapse->to[i] == to;
    collapse->from[collapse->pair_count] = from;
    collapse->to[collapse->pair_count++] = to;
    return true;
}

static uint32_t replacement(const struct hatch_coarse_collapse *collapse, uint32_t from)
{
    for (uint32_t i = 0; i < collapse->pair_count; i++)
        if (collapse->from[i] == from)
            return collapse->to[i];
    return HATCH_COARSE_NONE;
}

/* Divides the ring's faces: those at the edge vanish, and tell which wedge replaces which; the others are kept.
 *   opposite  out: the third points of faces that vanish */
static bool divide(const struct hatch_coarse_work *work, struct hatch_coarse_collapse *collapse,
                   uint32_t opposite[HATCH_COARSE_RING_MAX])
{
    const struct hatch_coarse_ring *ring = collapse->ring;
    uint32_t onto = collapse->spoke->point, gone = 0;
    for (uint32_t i = 0; i < ring->face_count; i++) {
        const uint32_t *wedges = &work->corner[3 * ring->faces[i]];
        uint32_t here = wedges[ring->sides[i]], after = wedges[(ring->sides[i] + 1) % 3],
                 before = wedges[(ring->sides[i] + 2) % 3];
        bool is_after = work->point_of[after] == onto, is_before = work->point_of[before] == onto;
        if (!is_after && !is_before)
            collapse->kept[collapse->kept_count++] = i;
        else if (!add_pair(collapse, here, is_after ? after : before))
            return false;
        else
            opposite[gone++] = work->point_of[is_after ? before : after];
    }
    return collapse->kept_count > 0;
}

static bool is_spoke(const struct hatch_coarse_ring *ring, uint32_t point)
{
    for (uint32_t i = 0; i < ring->spoke_count; i++)
        if (ring->spokes[i].point == point)
            return true;
    return false;
}

static bool is_among(const uint32_t *list, uint32_t count, uint32_t point)
{
    for (uint32_t i = 0; i < count; i++)
        if (list[i] == point)
            return true;
    return false;
}

/* Tests that the faces at both ends of the edge meet nowhere else: the common neighbours are the third points of the
 * faces that vanish, and no face becomes the double of another (the link condition of Dey et al. 1999). */
static bool stays_surface(struct hatch_coarse_work *work, const struct hatch_coarse_ring *ring, uint32_t onto,
                          const uint32_t *opposite, uint32_t gone)
{
    uint32_t faces = 0;
    for (uint32_t corner = work->first[onto]; corner != HATCH_COARSE_NONE; corner = work->next[corner]) {
        const uint32_t *wedges = &work->corner[corner / 3 * 3];
        if (wedges[0] == HATCH_COARSE_NONE)
            continue;
        if (++faces + ring->face_count > HATCH_COARSE_RING_MAX)
            return false;
        uint32_t ends[2] = {work->point_of[wedges[(corner + 1) % 3]], work->point_of[wedges[(corner + 2) % 3]]};
        if (ends[0] == ring->point || ends[1] == ring->point)
            continue;
        bool shared = true;
        for (int k = 0; k < 2; k++) {
            bool listed = is_among(opposite, gone, ends[k]);
            if (!listed && is_spoke(ring, ends[k]))
                return false;
            shared &= listed;
        }
        for (uint32_t i = 0; i < ring->face_count && shared; i++) {
            const uint32_t *own = &work->corner[3 * ring->faces[i]];
            uint32_t after = work->point_of[own[(ring->sides[i] + 1) % 3]],
                     before = work->point_of[own[(ring->sides[i] + 2) % 3]];
            if ((after == ends[0] && before == ends[1]) || (after == ends[1] && before == ends[0]))
                return false;
        }
    }
    return true;
}

/* Sets the corners of a face that is kept; returns false if the face has a wedge without replacement, or turns. */
static bool place_kept(const struct hatch_coarse_work *work, struct hatch_coarse_collapse *collapse, uint32_t index)
{
    uint32_t i = collapse->kept[index], side = collapse->ring->sides[i], *wedges = collapse->wedges[index];
    const uint32_t *old = &work->corner[3 * collapse->ring->faces[i]];
    double before[3], after[3];
    for (uint32_t c = 0; c < 3; c++) {
        wedges[c] = old[c];
        hatch_vec_copy(&work->at[3 * (size_t)work->point_of[old[c]]], collapse->corners[index][c]);
    }
    hatch_vec_triangle(collapse->corners[index][0], collapse->corners[index][1], collapse->corners[index][2], before);
    wedges[side] = replacement(collapse, old[side]);
    if (wedges[side] == HATCH_COARSE_NONE)
        return false;
    hatch_vec_copy(&work->at[3 * (size_t)collapse->spoke->point], collapse->corners[index][side]);
    hatch_vec_triangle(collapse->corners[index][0], collapse->corners[index][1], collapse->corners[index][2], after);
    double dot = hatch_vec_dot(before, after), lengths = hatch_vec_length(before) * hatch_vec_length(after);
    return dot > TURN_COS * lengths || (hatch_vec_length(before) == 0 && hatch_vec_length(after) > 0);
}

/* Sets the other end of the border that the point is on. */
static void find_other(struct hatch_coarse_collapse *collapse)
{
    const struct hatch_coarse_ring *ring = collapse->ring;
    assert(ring->border_count == 0 || (ring->border_count == 2 && collapse->spoke->border));
    collapse->other = HATCH_COARSE_NONE;
    for (uint32_t i = 0; i < ring->spoke_count; i++)
        if (ring->spokes[i].border && &ring->spokes[i] != collapse->spoke)
            collapse->other = ring->spokes[i].point;
}

bool hatch_coarse_collapse_find(struct hatch_coarse_work *work, const struct hatch_coarse_ring *ring,
                                const struct hatch_coarse_spoke *spoke, struct hatch_coarse_collapse *collapse)
{
    uint32_t opposite[HATCH_COARSE_RING_MAX];
    collapse->ring = ring;
    collapse->spoke = spoke;
    collapse->pair_count = collapse->kept_count = 0;
    find_other(collapse);
    if (!divide(work, collapse, opposite) ||
        !stays_surface(work, ring, spoke->point, opposite, ring->face_count - collapse->kept_count))
        return false;
    for (uint32_t i = 0; i < collapse->kept_count; i++)
        if (!place_kept(work, collapse, i))
            return false;
    return true;
}
