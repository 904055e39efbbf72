#include "mesh/orient.h"

#include "math/vector.h"

struct flood {
    const struct hatch_mesh *mesh;
    const uint32_t *point;
    const struct hatch_edges *edges;
    uint8_t *flipped;
    uint8_t *seen;  /* per face */
    uint32_t *queue; /* faces of the component, in the order found */
    uint32_t count;
    bool closed;
};

/* The other side of an edge of exactly two faces, or HATCH_NO_EDGE. */
static uint32_t partner(const struct hatch_edges *edges, uint32_t side)
{
    uint32_t edge = edges->edge_of[side];
    if (edge == HATCH_NO_EDGE || edges->first[edge + 1] - edges->first[edge] != 2)
        return HATCH_NO_EDGE;
    const uint32_t *sides = &edges->sides[edges->first[edge]];
    return sides[sides[0] == side ? 1 : 0];
}

/* Two sides of one edge agree when they run in opposite directions. */
static bool agree(const struct flood *f, uint32_t side, uint32_t other)
{
    bool same_way = f->point[side] == f->point[other];
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
            uint32_t side = f->queue[i] * 3 + c, other = partner(f->edges, side);
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

/* Six times the volume, as turned. Measured from the component's first corner, so that a far offset
 * does not drown it. */
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

static uint32_t settle(struct flood *f)
{
    uint32_t turned = 0;
    for (uint32_t i = 0; i < f->count; i++)
        turned += f->flipped[f->queue[i]];
    if (turned == 0)
        return 0;
    double size = f->closed ? volume(f) : 0;
    bool other_side = size < 0 || (!(size > 0) && turned > f->count - turned);
    if (!other_side)
        return turned;
    for (uint32_t i = 0; i < f->count; i++)
        f->flipped[f->queue[i]] = !f->flipped[f->queue[i]];
    return f->count - turned;
}

enum hatch_status hatch_mesh_orient(const struct hatch_mesh *mesh, const uint32_t *point,
                                    const struct hatch_edges *edges, const uint8_t *dropped,
                                    struct hatch_arena *scratch, uint8_t *flipped,
                                    uint32_t *component, struct hatch_orientation *result,
                                    struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct flood f = {.mesh = mesh, .point = point, .edges = edges, .flipped = flipped};
    f.seen = HATCH_NEW(scratch, uint8_t, mesh->face_count, err);
    f.queue = f.seen ? HATCH_NEW(scratch, uint32_t, mesh->face_count, err) : NULL;
    if (!f.queue) {
        hatch_arena_rewind(scratch, mark);
        return HATCH_LIMIT;
    }
    struct hatch_orientation found = {0};
    for (uint32_t face = 0; face < mesh->face_count; face++) {
        if (f.seen[face] || (dropped && dropped[face]))
            continue;
        flood_from(&f, face);
        for (uint32_t i = 0; component && i < f.count; i++)
            component[f.queue[i]] = found.components;
        found.components++;
        found.faces_flipped += settle(&f);
    }
    for (uint32_t e = 0; e < edges->count; e++) {
        const uint32_t *sides = &edges->sides[edges->first[e]];
        if (edges->first[e + 1] - edges->first[e] == 2 && !agree(&f, sides[0], sides[1]))
            found.contrary_edges++;
    }
    *result = found;
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
