#include <math.h>
#include <string.h>

#include "math/vector.h"
#include "field/system.h"

#define PI 3.14159265358979323846

/* Turns are seen by a face: counter-clockwise as its corners run. */
struct hatch_view {
    const struct hatch_surface *surface;
    const struct hatch_frames *frames;
    const double *direction;
    const double *angle_rad; /* the direction's, per point; NULL where no turns are asked for */
};

/* How the line turns along ring entry i of p, seen from p's ring: the shorter way, and exactly the opposite from
 * the other end. */
static double turn_along(const struct hatch_view *v, uint32_t p, uint32_t i)
{
    uint32_t q = v->surface->ring_point[i], mate = v->frames->mate[i];
    bool turned = v->surface->ring_turned[i], away = mate < i;
    double here = v->angle_rad[away ? q : p], there = v->angle_rad[away ? p : q];
    double turn = (turned ? -there : there) + v->frames->turn_rad[away ? mate : i] - here;
    while (turn > PI / 2)
        turn -= PI;
    while (turn < -PI / 2)
        turn += PI;
    return away && !turned ? -turn : turn;
}

/* The turn of the line along a face's side that begins at corner c. */
static double side_turn(const struct hatch_view *v, uint32_t face, uint32_t c)
{
    uint32_t p = v->surface->corners[(size_t)face * 3 + c], i = v->frames->entry[(size_t)face * 3 + c];
    uint32_t next = i + 1 < v->surface->ring_first[p + 1] ? i + 1 : v->surface->ring_first[p];
    return v->surface->ring_flipped[i] ? -turn_along(v, p, next) : turn_along(v, p, i);
}

/* What a line that is carried around a face comes back turned by and what the field turns make a whole number of half
 * turns. */
static int face_index(const struct hatch_view *v, uint32_t face)
{
    double sum = hatch_frames_excess(v->surface, v->frames, face);
    for (uint32_t c = 0; c < 3; c++)
        sum += side_turn(v, face, c);
    return (int)lround(sum / PI);
}

int hatch_field_face_index(const struct hatch_surface *surface, const struct hatch_frames *frames,
                           const double *angle_rad, uint32_t face)
{
    const struct hatch_view view = {surface, frames, NULL, angle_rad};
    return face_index(&view, face);
}

/* How the border's direction turns against the line, in half turns, all loops of a component together. */
static int32_t border_turns(const struct hatch_view *v, const struct hatch_component *of)
{
    double sum = 0;
    for (uint32_t f = of->first_face; f < of->first_face + of->face_count; f++)
        for (uint32_t c = 0; c < 3; c++)
            if (v->surface->opposite[(size_t)f * 3 + c] == HATCH_NO_SIDE)
                sum -= side_turn(v, f, c);
    for (uint32_t p = of->first_point; p < of->first_point + of->point_count; p++) {
        uint32_t last = v->surface->ring_first[p + 1] - 1;
        if (v->surface->ring_face[last] == HATCH_NO_SIDE)
            sum += PI - v->frames->angle_rad[last];
    }
    return (int32_t)lround(sum / PI);
}

enum hatch_status hatch_field_singularities(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                            const double *direction, struct hatch_arena *arena,
                                            struct hatch_arena *scratch, struct hatch_singularities *found,
                                            struct hatch_err *err)
{
    struct hatch_view view = {surface, frames, direction, NULL};
    struct hatch_singularities made = {0};
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    made.component_half_turns = HATCH_NEW(arena, int32_t, surface->component_count, err);
    int8_t *index = made.component_half_turns ? HATCH_NEW(scratch, int8_t, surface->face_count, err) : NULL;
    double *angle_rad = index ? HATCH_NEW(scratch, double, surface->point_count, err) : NULL;
    if (!angle_rad) {
        hatch_arena_rewind(scratch, mark);
        return HATCH_LIMIT;
    }
    for (uint32_t p = 0; p < surface->point_count; p++)
        angle_rad[p] = hatch_frames_angle(frames, p, &direction[(size_t)p * 3]);
    view.angle_rad = angle_rad;
    for (uint32_t c = 0; c < surface->component_count; c++) {
        const struct hatch_component *of = &surface->components[c];
        made.component_half_turns[c] = border_turns(&view, of);
        for (uint32_t f = of->first_face; f < of->first_face + of->face_count; f++) {
            index[f] = (int8_t)face_index(&view, f);
            made.component_half_turns[c] += index[f];
            made.count += index[f] != 0;
        }
    }
    made.faces = HATCH_NEW(arena, uint32_t, made.count, err);
    made.half_turns = made.faces ? HATCH_NEW(arena, int8_t, made.count, err) : NULL;
    for (uint32_t f = 0, at = 0; made.half_turns && f < surface->face_count; f++)
        if (index[f] != 0) {
            made.faces[at] = f;
            made.half_turns[at++] = index[f];
        }
    hatch_arena_rewind(scratch, mark);
    if (!made.half_turns)
        return HATCH_LIMIT;
    *found = made;
    return HATCH_OK;
}

/* The line at a corner as z in the face's plane, against its axes u and v: the plane of the point is laid down so
 * that the middle of the face's corner falls on the middle of its scaled angle. */
static void corner_line(const struct hatch_view *v, uint32_t face, uint32_t c, const double u[3], const double side[3],
                        double z[2])
{
    const uint32_t *corner = &v->surface->corners[(size_t)face * 3];
    uint32_t p = corner[c], i = v->frames->entry[(size_t)face * 3 + c];
    const double *at = &v->surface->points[(size_t)p * 3];
    double middle[3] = {0, 0, 0}, own[2];
    for (uint32_t k = 1; k < 3; k++) {
        double edge[3];
        hatch_vec_sub(&v->surface->points[(size_t)corner[(c + k) % 3] * 3], at, edge);
        hatch_vec_normalize(edge);
        hatch_vec_add_scaled(middle, 1, edge, middle);
    }
    double x = hatch_vec_dot(middle, u), y = hatch_vec_dot(middle, side), square = x * x + y * y;
    double bisector = v->frames->angle_rad[i] + hatch_frames_corner(v->surface, v->frames, p, i) / 2;
    double cosine = cos(2 * bisector), sine = sin(2 * bisector);
    hatch_field_square(v->frames, p, &v->direction[(size_t)p * 3], own);
    double against[2] = {own[0] * cosine + own[1] * sine, own[1] * cosine - own[0] * sine};
    if (v->surface->ring_flipped[i])
        against[1] = -against[1];
    double turn[2] = {(x * x - y * y) / square, 2 * x * y / square};
    z[0] = against[0] * turn[0] - against[1] * turn[1];
    z[1] = against[0] * turn[1] + against[1] * turn[0];
}

void hatch_field_mean(const double z[3][2], const double u[3], const double side[3], double line[3], double *nearest)
{
    double sum[2] = {0, 0};
    for (int c = 0; c < 3; c++) {
        sum[0] += z[c][0];
        sum[1] += z[c][1];
    }
    double length = sqrt(sum[0] * sum[0] + sum[1] * sum[1]);
    double x = length > 0 ? sum[0] / length : 1, y = length > 0 ? sum[1] / length : 0;
    *nearest = 1;
    for (int c = 0; c < 3; c++)
        *nearest = fmax(-1, fmin(*nearest, z[c][0] * x + z[c][1] * y));
    /* Of half the angle. */
    double larger = sqrt((1 + fabs(x)) / 2), smaller = fabs(y) / (2 * larger);
    double cosine = x < 0 ? smaller : larger, sine = copysign(x < 0 ? larger : smaller, y);
    for (int k = 0; k < 3; k++)
        line[k] = cosine * u[k] + sine * side[k];
}

void hatch_field_face(const struct hatch_surface *surface, const struct hatch_frames *frames, const double *direction,
                      uint32_t face, double line[3], double *spread_rad)
{
    const struct hatch_view view = {surface, frames, direction, NULL};
    const uint32_t *corner = &surface->corners[(size_t)face * 3];
    const double *a = &surface->points[(size_t)corner[0] * 3], *b = &surface->points[(size_t)corner[1] * 3];
    double normal[3], u[3], side[3], z[3][2], nearest;
    hatch_vec_triangle(a, b, &surface->points[(size_t)corner[2] * 3], normal);
    hatch_vec_normalize(normal);
    hatch_vec_sub(b, a, u);
    hatch_vec_normalize(u);
    hatch_vec_cross(normal, u, side);
    for (uint32_t c = 0; c < 3; c++)
        corner_line(&view, face, c, u, side, z[c]);
    hatch_field_mean((const double(*)[2])z, u, side, line, &nearest);
    *spread_rad = acos(nearest) / 2;
}
