#include "mesh/orient.h"

#include <string.h>

#include "math/vector.h"

/* A component found by breadth-first search. */
struct flood {
    const struct hatch_mesh *mesh;
    const struct hatch_connectivity *faces;
    const uint32_t *partner;
    uint8_t *flipped; /* per face */
    uint8_t *seen;    /* per face */
    uint32_t *queue;  /* faces of the component */
    uint32_t count;
    bool closed; /* every side of the faces has a partner */
};

/* Returns whether the faces on both sides of an edge agree after flipping: their sides then run in opposite
 * directions. */
static bool agree(const struct flood *f, uint32_t side, uint32_t other)
{
    bool same_way = f->faces->point[side] == f->faces->point[other];
    return same_way == (f->flipped[side / 3] != f->flipped[other / 3]);
}

static void flood_from(struct flood *f, uint32_t start)
{
    f->count = 0;
    f->closed = true;
    f->queue[f->count++] = start;
    f->seen[start] = 1;
    for (uint32_t i = 0; i < f->count; i++)
        for (uint32_t c = 0; c < 3; c++) {
            uint32_t side = f->queue[i] * 3 + c, other = f->partner[side];
            if (other == HATCH_NO_EDGE) {
                f->closed = false;
            } else if (!f->seen[other / 3]) {
                f->seen[other / 3] = 1;
                f->flipped[other / 3] = 0;
                f->flipped[other / 3] = !agree(f, side, other);
                f->queue[f->count++] = other / 3;
            }
        }
}

/* Returns six times the signed volume of the component after flipping. Positions are relative to its first corner,
 * because a large offset from the origin would cancel all digits. */
static double volume(const struct flood *f)
{
    double sum = 0, origin[3], corners[3][3], normal[3];
    hatch_mesh_corners(f->mesh, f->queue[0], corners);
    hatch_vec_copy(corners[0], origin);
    for (uint32_t i = 0; i < f->count; i++) {
        hatch_mesh_corners(f->mesh, f->queue[i], corners);
        for (int c = 0; c < 3; c++)
            hatch_vec_sub(corners[c], origin, corners[c]);
        hatch_vec_cross(corners[1], corners[2], normal);
        double six = hatch_vec_dot(corners[0], normal);
        sum += f->flipped[f->queue[i]] ? -six : six;
    }
    return sum;
}

/* Counts the component's contrary edges.
 *   turned  out: after flipping
 *   before  out: without flipping */
static void count_contrary(const struct flood *f, uint32_t *turned, uint32_t *before)
{
    *turned = *before = 0;
    for (uint32_t i = 0; i < f->count * 3; i++) {
        uint32_t side = f->queue[i / 3] * 3 + i % 3, other = f->partner[side];
        if (other == HATCH_NO_EDGE || other < side)
            continue;
        *turned += !agree(f, side, other);
        *before += f->faces->point[side] == f->faces->point[other];
    }
}

/* Decides which side of the component is the outside, and so which of its faces are flipped. */
static void choose_side(struct flood *f, struct hatch_orientation *result)
{
    uint32_t turned = 0, contrary, before;
    for (uint32_t i = 0; i < f->count; i++)
        turned += f->flipped[f->queue[i]];
    count_contrary(f, &contrary, &before);
    result->contrary_edges += contrary < before ? contrary : before;
    if (turned == 0)
        return;
    if (before <= contrary) { /* non-orientable, and flipping gains nothing */
        for (uint32_t i = 0; i < f->count; i++)
            f->flipped[f->queue[i]] = 0;
        return;
    }
    double size = f->closed ? volume(f) : 0;
    bool other_side = size < 0 || (!(size > 0) && turned > f->count - turned);
    for (uint32_t i = 0; other_side && i < f->count; i++)
        f->flipped[f->queue[i]] = !f->flipped[f->queue[i]];
    result->faces_flipped += other_side ? f->count - turned : turned;
}

enum hatch_status hatch_mesh_orient(const struct hatch_mesh *mesh, const struct hatch_connectivity *faces,
                                    const uint32_t *partner, struct hatch_arena *scratch,
                                    struct hatch_orientation *orientation, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct flood f = {.mesh = mesh, .faces = faces, .partner = partner, .flipped = orientation->flipped};
    f.seen = HATCH_NEW(scratch, uint8_t, mesh->face_count, err);
    f.queue = f.seen ? HATCH_NEW(scratch, uint32_t, mesh->face_count, err) : NULL;
    if (!f.queue) {
        hatch_arena_rewind(scratch, mark);
        return HATCH_LIMIT;
    }
    struct hatch_orientation found = {.flipped = orientation->flipped, .component = orientation->component};
    memset(found.flipped, 0, mesh->face_count);
    for (uint32_t face = 0; face < mesh->face_count; face++) {
        if (f.seen[face] || (faces->dropped && faces->dropped[face]))
            continue;
        flood_from(&f, face);
        choose_side(&f, &found);
        for (uint32_t i = 0; found.component && i < f.count; i++)
            found.component[f.queue[i]] = found.components;
        found.components++;
    }
    *orientation = found;
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
