#include "topo/curvature_support.h"

#include <string.h>

#include "math/vector.h"

#define LEAN_COSINE 0.2

/* A disk of radius r holds about 3.6 r² points when edges are alike. Where a mesh has far more, the nearest
 * rings say enough, and of a ring of thousands a few hundred do: else time is the square of the points. */
#define POINTS_LEAST 200
#define POINTS_PER_SQUARE 16
#define RING_MAX 256u

enum hatch_status hatch_support_make(const struct hatch_surface *surface, const double *normals,
                                     struct hatch_arena *arena, struct hatch_support *support,
                                     struct hatch_err *err)
{
    size_t points = surface->point_count;
    struct hatch_support made = {.surface = surface, .normals = normals, .lean_cosine = LEAN_COSINE};
    made.seen = HATCH_NEW(arena, uint32_t, points, err);
    made.points = made.seen ? HATCH_NEW(arena, uint32_t, points, err) : NULL;
    made.sides = made.points ? HATCH_NEW(arena, int8_t, points, err) : NULL;
    made.offsets = made.sides ? HATCH_NEW(arena, double, points * 3, err) : NULL;
    if (!made.offsets)
        return HATCH_LIMIT;
    *support = made;
    return HATCH_OK;
}

/* The walk's state stands in locals: through the struct every write would make the compiler read all its
 * pointers again. */
bool hatch_support_gather(struct hatch_support *support, uint32_t middle, const double normal[3],
                          double radius)
{
    const struct hatch_surface *surface = support->surface;
    const uint32_t *ring_first = surface->ring_first, *ring_point = surface->ring_point;
    const double *positions = surface->points, *normals = support->normals;
    const double origin[3] = {positions[(size_t)middle * 3], positions[(size_t)middle * 3 + 1],
                              positions[(size_t)middle * 3 + 2]};
    const double up[3] = {normal[0], normal[1], normal[2]}, lean_cosine = support->lean_cosine;
    const double square = radius * radius, most = POINTS_LEAST + POINTS_PER_SQUARE * square;
    uint32_t *restrict seen = support->seen, *restrict points = support->points;
    int8_t *restrict sides = support->sides;
    double *restrict offsets = support->offsets;
    uint32_t walk = ++support->walk, count = 1;
    seen[middle] = walk;
    points[0] = middle;
    sides[0] = 1;
    memset(offsets, 0, 3 * sizeof *offsets);
    for (uint32_t next = 0; next < count && count < most; next++) {
        uint32_t p = points[next], end = ring_first[p + 1];
        uint32_t stride = 1 + (end - ring_first[p]) / RING_MAX;
        for (uint32_t i = ring_first[p]; i < end; i += stride) {
            uint32_t q = ring_point[i];
            if (seen[q] == walk)
                continue;
            seen[q] = walk;
            double *offset = &offsets[(size_t)count * 3];
            hatch_vec_sub(&positions[(size_t)q * 3], origin, offset);
            if (hatch_vec_dot(offset, offset) > square)
                continue;
            int side = surface->ring_turned[i] ? -sides[next] : sides[next];
            if (hatch_vec_dot(&normals[(size_t)q * 3], up) * side < lean_cosine)
                continue;
            points[count] = q;
            sides[count++] = (int8_t)side;
        }
    }
    support->count = count;
    return count >= most;
}

#define BLOCK 32u

void hatch_support_sums(const struct hatch_support *support, const double normal[3], double radius,
                        struct hatch_jet_frame *frame, struct hatch_jet_sums *sums)
{
    const double *origin = &support->surface->points[(size_t)support->points[0] * 3];
    hatch_vec_copy(origin, frame->origin);
    hatch_vec_copy(normal, frame->axes[2]);
    hatch_vec_any_orthogonal(normal, frame->axes[0]);
    hatch_vec_cross(normal, frame->axes[0], frame->axes[1]);
    frame->radius = radius;
    *sums = (struct hatch_jet_sums){.count = 0};
    double scaled[3][3], local[3][BLOCK];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            scaled[i][k] = frame->axes[i][k] / radius;
    for (uint32_t n = 0; n < support->count; n += BLOCK) {
        uint32_t some = support->count - n < BLOCK ? support->count - n : BLOCK;
        for (uint32_t k = 0; k < some; k++)
            for (int i = 0; i < 3; i++)
                local[i][k] = hatch_vec_dot(&support->offsets[(size_t)(n + k) * 3], scaled[i]);
        hatch_jet_add(sums, some, local[0], local[1], local[2]);
    }
}
