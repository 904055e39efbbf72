#include <assert.h>
#include <math.h>

#include "math/vector.h"
#include "surface/frames.h"

#define FULL_TURN (2 * 3.14159265358979323846)

/* Cotangents are clamped to those of about 87° and 3°; a sliver would otherwise give an edge a huge weight, or one of
 * 0 or less. */
#define COT_MIN 0.05
#define COT_MAX 20.0

struct corners {
    double *angle, *cot; /* per corner 3 * f + c: angle in radians, clamped cotangent */
    double *normal;      /* 3 per face: unit */
};

static void measure_face(const struct hatch_surface *surface, uint32_t face, struct corners *measured, double *area)
{
    const uint32_t *corner = &surface->corners[(size_t)face * 3];
    const double *at[3];
    for (int c = 0; c < 3; c++)
        at[c] = &surface->points[(size_t)corner[c] * 3];
    double *normal = &measured->normal[(size_t)face * 3];
    hatch_vec_triangle(at[0], at[1], at[2], normal);
    double doubled = hatch_vec_normalize(normal);
    double angles = FULL_TURN / 2;
    for (int c = 0; c < 3; c++) {
        double a[3], b[3];
        hatch_vec_sub(at[(c + 1) % 3], at[c], a);
        hatch_vec_sub(at[(c + 2) % 3], at[c], b);
        double dot = hatch_vec_dot(a, b);
        double angle = c < 2 ? atan2(doubled, dot) : fmax(angles, 0);
        angles -= angle;
        measured->angle[(size_t)face * 3 + (size_t)c] = angle;
        double *cot = &measured->cot[(size_t)face * 3 + (size_t)c];
        if (doubled > 0)
            *cot = fmin(fmax(dot, COT_MIN * doubled), COT_MAX * doubled) / doubled;
        else /* a needle that has lost its area to rounding */
            *cot = dot > 0 ? COT_MAX : COT_MIN;
        area[corner[c]] += doubled / 6;
    }
}

static uint32_t corner_of(const struct hatch_surface *surface, uint32_t face, uint32_t point)
{
    const uint32_t *corner = &surface->corners[(size_t)face * 3];
    return face * 3 + (corner[0] == point ? 0 : corner[1] == point ? 1 : 2);
}

static enum hatch_status measure_corners(const struct hatch_surface *surface, struct hatch_arena *scratch,
                                         struct corners *measured, struct hatch_frames *frames, struct hatch_err *err)
{
    size_t count = (size_t)surface->face_count * 3;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &measured->angle, count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &measured->cot, count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &measured->normal, count, err));
    for (uint32_t f = 0; f < surface->face_count; f++)
        measure_face(surface, f, measured, frames->area);
    for (uint32_t p = 0; p < surface->point_count; p++)
        for (uint32_t i = surface->ring_first[p]; i < surface->ring_first[p + 1]; i++)
            if (surface->ring_face[i] != HATCH_NO_SIDE)
                frames->corner_entry[corner_of(surface, surface->ring_face[i], p)] = i;
    return HATCH_OK;
}

/* Sets the scaled angles of a point's ring, and its normal. */
static void measure_ring(const struct hatch_surface *surface, const struct corners *measured, uint32_t point,
                         struct hatch_frames *frames)
{
    uint32_t first = surface->ring_first[point], end = surface->ring_first[point + 1];
    double sum = 0, *normal = &frames->normal[(size_t)point * 3];
    for (uint32_t i = first; i < end; i++) {
        frames->angle_rad[i] = sum;
        uint32_t face = surface->ring_face[i];
        if (face == HATCH_NO_SIDE)
            continue;
        double angle = measured->angle[corner_of(surface, face, point)];
        hatch_vec_add_scaled(normal, surface->ring_flipped[i] ? -angle : angle, &measured->normal[(size_t)face * 3],
                             normal);
        sum += angle;
    }
    bool open = surface->ring_face[end - 1] == HATCH_NO_SIDE;
    double scale = open ? fmin(1, FULL_TURN / sum) : FULL_TURN / sum;
    for (uint32_t i = first; i < end; i++)
        frames->angle_rad[i] *= scale;
    /* The normals of faces folded onto one another cancel; the first face's normal is used then. */
    if (!(hatch_vec_normalize(normal) > 1e-12))
        for (int i = 0; i < 3; i++)
            normal[i] = (surface->ring_flipped[first] ? -1 : 1) *
                        measured->normal[(size_t)surface->ring_face[first] * 3 + (size_t)i];
}

void hatch_frames_fit_axis(const struct hatch_surface *surface, uint32_t point, struct hatch_frames *frames)
{
    const double *at = &surface->points[(size_t)point * 3], *normal = &frames->normal[(size_t)point * 3];
    double u[3], v[3], x = 0, y = 0;
    hatch_vec_any_orthogonal(normal, u);
    hatch_vec_cross(normal, u, v);
    for (uint32_t i = surface->ring_first[point]; i < surface->ring_first[point + 1]; i++) {
        double edge[3];
        hatch_vec_sub(&surface->points[(size_t)surface->ring_point[i] * 3], at, edge);
        double length = hatch_vec_length(edge);
        if (!(length > 0))
            continue;
        double a = hatch_vec_dot(edge, u) / length, b = hatch_vec_dot(edge, v) / length;
        double c = cos(frames->angle_rad[i]), s = sin(frames->angle_rad[i]);
        x += a * c + b * s;
        y += b * c - a * s;
    }
    double length = hypot(x, y), *axis = &frames->axis[(size_t)point * 3];
    x = length > 1e-12 ? x / length : 1;
    y = length > 1e-12 ? y / length : 0;
    for (int i = 0; i < 3; i++)
        axis[i] = x * u[i] + y * v[i];
}

/* Finds the entry of the same edge in the neighbour's ring, through a face that both rings contain. */
static uint32_t find_twin(const struct hatch_surface *surface, const struct hatch_frames *frames, uint32_t point,
                          uint32_t i)
{
    uint32_t q = surface->ring_point[i], face = surface->ring_face[i];
    if (face == HATCH_NO_SIDE)
        face = surface->ring_face[i - 1];
    uint32_t twin = frames->corner_entry[corner_of(surface, face, q)];
    if (surface->ring_point[twin] == point)
        return twin;
    return twin + 1 < surface->ring_first[q + 1] ? twin + 1 : surface->ring_first[q];
}

/* Returns the cotangent of a face's corner opposite an edge. */
static double cot_opposite(const struct hatch_surface *surface, const struct corners *measured, uint32_t face,
                           uint32_t p, uint32_t q)
{
    const uint32_t *corner = &surface->corners[(size_t)face * 3];
    for (uint32_t c = 0; c < 3; c++)
        if (corner[c] != p && corner[c] != q)
            return measured->cot[face * 3 + c];
    return 0;
}

static double edge_weight(const struct hatch_surface *surface, const struct corners *measured, uint32_t p, uint32_t i)
{
    uint32_t first = surface->ring_first[p], end = surface->ring_first[p + 1];
    uint32_t after = surface->ring_face[i], before = surface->ring_face[i > first ? i - 1 : end - 1];
    double sum = 0;
    if (after != HATCH_NO_SIDE)
        sum += cot_opposite(surface, measured, after, p, surface->ring_point[i]);
    if (before != HATCH_NO_SIDE)
        sum += cot_opposite(surface, measured, before, p, surface->ring_point[i]);
    return sum / 2;
}

static void find_weights(const struct hatch_surface *surface, const struct corners *measured,
                         struct hatch_frames *frames)
{
    for (uint32_t p = 0; p < surface->point_count; p++)
        for (uint32_t i = surface->ring_first[p]; i < surface->ring_first[p + 1]; i++) {
            uint32_t twin = find_twin(surface, frames, p, i);
            frames->twin[i] = twin;
            frames->weight[i] = i < twin ? edge_weight(surface, measured, p, i) : frames->weight[twin];
        }
}

double hatch_frames_wrap_angle(double angle_rad)
{
    while (angle_rad > FULL_TURN / 2)
        angle_rad -= FULL_TURN;
    while (angle_rad < -FULL_TURN / 2)
        angle_rad += FULL_TURN;
    return angle_rad;
}

void hatch_frames_find_transport(const struct hatch_surface *surface, struct hatch_frames *frames)
{
    for (uint32_t i = 0; i < surface->ring_first[surface->point_count]; i++) {
        double here = frames->angle_rad[i], there = frames->angle_rad[frames->twin[i]];
        frames->transport_rad[i] =
            hatch_frames_wrap_angle(here + (surface->ring_turned[i] ? there : -there) + FULL_TURN / 2);
    }
}

static enum hatch_status allocate(const struct hatch_surface *surface, struct hatch_arena *arena,
                                  struct hatch_frames *frames, struct hatch_err *err)
{
    size_t points = surface->point_count, entries = surface->ring_first[surface->point_count];
    HATCH_TRY(HATCH_ALLOC(arena, &frames->normal, points * 3, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &frames->axis, points * 3, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &frames->angle_rad, entries, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &frames->transport_rad, entries, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &frames->weight, entries, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &frames->twin, entries, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &frames->corner_entry, (size_t)surface->face_count * 3, err));
    HATCH_TRY(HATCH_ALLOC(arena, &frames->area, points, err));
    return HATCH_ALLOC(arena, &frames->folded, points, err);
}

enum hatch_status hatch_frames_begin(const struct hatch_surface *surface, struct hatch_arena *arena,
                                     struct hatch_arena *scratch, struct hatch_frames *frames, struct hatch_err *err)
{
    struct hatch_frames made = {0};
    struct corners measured = {0};
    HATCH_TRY(allocate(surface, arena, &made, err));
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = measure_corners(surface, scratch, &measured, &made, err);
    if (status == HATCH_OK) {
        for (uint32_t p = 0; p < surface->point_count; p++) {
            measure_ring(surface, &measured, p, &made);
            hatch_vec_any_orthogonal(&made.normal[(size_t)p * 3], &made.axis[(size_t)p * 3]);
        }
        find_weights(surface, &measured, &made);
        *frames = made;
    }
    hatch_arena_rewind(scratch, mark);
    return status;
}

enum hatch_status hatch_frames_make(const struct hatch_surface *surface, struct hatch_arena *arena,
                                    struct hatch_arena *scratch, struct hatch_frames *frames, struct hatch_err *err)
{
    HATCH_TRY(hatch_frames_begin(surface, arena, scratch, frames, err));
    for (uint32_t p = 0; p < surface->point_count; p++)
        hatch_frames_fit_axis(surface, p, frames);
    hatch_frames_find_transport(surface, frames);
    return HATCH_OK;
}

double hatch_frames_angle(const struct hatch_frames *frames, uint32_t point, const double direction[3])
{
    const double *axis = &frames->axis[(size_t)point * 3];
    double side[3];
    hatch_vec_cross(&frames->normal[(size_t)point * 3], axis, side);
    double x = hatch_vec_dot(direction, axis), y = hatch_vec_dot(direction, side);
    double along = fabs(hatch_vec_dot(direction, &frames->normal[(size_t)point * 3]));
    return fmax(fabs(x), fabs(y)) > HATCH_FRAMES_ROUNDING * along ? atan2(y, x) : 0;
}

void hatch_frames_direction(const struct hatch_frames *frames, uint32_t point, double angle_rad, double direction[3])
{
    const double *axis = &frames->axis[(size_t)point * 3];
    double side[3], c = cos(angle_rad), s = sin(angle_rad);
    hatch_vec_cross(&frames->normal[(size_t)point * 3], axis, side);
    for (int i = 0; i < 3; i++)
        direction[i] = c * axis[i] + s * side[i];
}

double hatch_frames_corner_angle(const struct hatch_surface *surface, const struct hatch_frames *frames, uint32_t point,
                                 uint32_t i)
{
    uint32_t next = i + 1 < surface->ring_first[point + 1] ? i + 1 : surface->ring_first[point];
    return frames->angle_rad[next] - frames->angle_rad[i] + (next > i ? 0 : FULL_TURN);
}
