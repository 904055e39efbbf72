#include "curvature/support.h"

#include "math/vector.h"

#define NORMAL_COSINE_MIN 0.2 /* 78 degrees */

/* A disk of radius r holds about 3.6 r² points when edges have similar lengths. Supports are limited to several times
 * that, and rings of thousands are sampled: time would otherwise be quadratic in the number of points. */
#define COUNT_BASE 200
#define COUNT_PER_SQUARE 16
#define RING_SAMPLES 256u

size_t hatch_support_bytes(uint32_t point_count)
{
    const struct hatch_support *s;
    size_t entry = sizeof *s->visited + sizeof *s->points + sizeof *s->sides + 3 * sizeof *s->offsets[0];
    return ((size_t)point_count + 1) * entry;
}

enum hatch_status hatch_support_make(const struct hatch_surface *surface, const double *normals,
                                     struct hatch_arena *arena, struct hatch_support *support, struct hatch_err *err)
{
    size_t points = surface->point_count;
    struct hatch_support made = {.surface = surface, .normals = normals, .normal_cosine_min = NORMAL_COSINE_MIN};
    double *offsets;
    HATCH_TRY(HATCH_ALLOC(arena, &made.visited, points, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.points, points + 1, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.sides, points + 1, err));
    HATCH_TRY(HATCH_ALLOC(arena, &offsets, points * 3, err));
    for (size_t k = 0; k < 3; k++)
        made.offsets[k] = &offsets[k * points];
    *support = made;
    return HATCH_OK;
}

void hatch_support_set_surface(struct hatch_support *support, const struct hatch_surface *surface,
                               const double *normals, const double *weights)
{
    support->surface = surface;
    support->normals = normals;
    support->weights = weights;
}

/* points[] holds both the support (first `count`) and the queue (`next` .. `reached`): count <= next. Neighbours are
 * queued without a branch on `visited`, which would be mispredicted too often. */
bool hatch_support_gather(struct hatch_support *support, uint32_t center, const double normal[3], double radius)
{
    const struct hatch_surface *surface = support->surface;
    const uint32_t *ring_first = surface->ring_first, *ring_point = surface->ring_point;
    const uint8_t *ring_turned = surface->ring_turned;
    const double *positions = surface->points, *normals = support->normals;
    const double origin[3] = {positions[(size_t)center * 3], positions[(size_t)center * 3 + 1],
                              positions[(size_t)center * 3 + 2]};
    const double axis[3] = {normal[0], normal[1], normal[2]}, normal_cosine_min = support->normal_cosine_min;
    const double square = radius * radius, count_max = COUNT_BASE + COUNT_PER_SQUARE * square;
    uint32_t *restrict visited = support->visited, *restrict points = support->points;
    int8_t *restrict sides = support->sides;
    double *restrict x = support->offsets[0], *restrict y = support->offsets[1], *restrict z = support->offsets[2];
    uint32_t walk = ++support->walk, count = 0, reached = 1;
    bool cut = false;
    visited[center] = walk;
    points[0] = center;
    sides[0] = 1;
    for (uint32_t next = 0; next < reached && count < count_max; next++) {
        uint32_t p = points[next];
        int8_t side = sides[next];
        double offset[3];
        hatch_vec_sub(&positions[(size_t)p * 3], origin, offset);
        bool near = hatch_vec_dot(offset, offset) <= square;
        bool aligned = hatch_vec_dot(&normals[(size_t)p * 3], axis) * side >= normal_cosine_min;
        if (next > 0 && !(near & aligned)) {
            cut |= aligned;
            continue;
        }
        points[count] = p;
        sides[count] = side;
        x[count] = offset[0];
        y[count] = offset[1];
        z[count++] = offset[2];
        uint32_t end = ring_first[p + 1], stride = 1 + (end - ring_first[p]) / RING_SAMPLES;
        for (uint32_t i = ring_first[p]; i < end; i += stride) {
            uint32_t q = ring_point[i];
            points[reached] = q;
            sides[reached] = ring_turned[i] ? (int8_t)-side : side;
            reached += visited[q] != walk;
            visited[q] = walk;
        }
    }
    support->count = count;
    support->cut = cut;
    return count >= count_max;
}

#define BLOCK 32u

void hatch_support_sums(const struct hatch_support *support, const double normal[3], double radius,
                        struct hatch_jet_frame *frame, struct hatch_jet_sums *sums)
{
    const double *origin = &support->surface->points[(size_t)support->points[0] * 3];
    const double *x = support->offsets[0], *y = support->offsets[1], *z = support->offsets[2];
    hatch_vec_copy(origin, frame->origin);
    hatch_vec_copy(normal, frame->axes[2]);
    hatch_vec_any_orthogonal(normal, frame->axes[0]);
    hatch_vec_cross(normal, frame->axes[0], frame->axes[1]);
    frame->radius = radius;
    *sums = (struct hatch_jet_sums){.count = 0};
    double local[3][BLOCK], weights[BLOCK];
    for (uint32_t n = 0; n < support->count; n += BLOCK) {
        uint32_t size = support->count - n < BLOCK ? support->count - n : BLOCK;
        for (int i = 0; i < 3; i++) {
            double a = frame->axes[i][0] / radius, b = frame->axes[i][1] / radius, c = frame->axes[i][2] / radius;
            for (uint32_t k = 0; k < size; k++)
                local[i][k] = a * x[n + k] + b * y[n + k] + c * z[n + k];
        }
        for (uint32_t k = 0; support->weights && k < size; k++)
            weights[k] = support->weights[support->points[n + k]];
        hatch_jet_add(sums, size, local[0], local[1], local[2], support->weights ? weights : NULL);
    }
}
