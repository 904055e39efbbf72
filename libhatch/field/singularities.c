#include <math.h>

#include "math/vector.h"
#include "field/system.h"

#define PI 3.14159265358979323846

struct field {
    const struct hatch_surface *surface;
    const struct hatch_frames *frames;
    const double *direction; /* 3 per point; NULL for functions that use angle_rad */
    const double *angle_rad; /* per point: of the direction; NULL for functions that use direction */
};

/* Returns the angle, -π/2 .. π/2, by which the field turns along ring entry i of p, seen from the outside of the
 * ring. The value from the other end is exactly the opposite. */
static double turn_along(const struct field *field, uint32_t p, uint32_t i)
{
    uint32_t q = field->surface->ring_point[i], twin = field->frames->twin[i];
    bool turned = field->surface->ring_turned[i], reversed = twin < i;
    double here = field->angle_rad[reversed ? q : p], there = field->angle_rad[reversed ? p : q];
    double turn = (turned ? -there : there) + field->frames->transport_rad[reversed ? twin : i] - here;
    while (turn > PI / 2)
        turn -= PI;
    while (turn < -PI / 2)
        turn += PI;
    return reversed && !turned ? -turn : turn;
}

/* Returns the angle by which the field turns along side c of a face, counter-clockwise for the face. */
static double side_turn(const struct field *field, uint32_t face, uint32_t c)
{
    uint32_t p = field->surface->corners[(size_t)face * 3 + c], i = field->frames->corner_entry[(size_t)face * 3 + c];
    uint32_t next = i + 1 < field->surface->ring_first[p + 1] ? i + 1 : field->surface->ring_first[p];
    return field->surface->ring_flipped[i] ? -turn_along(field, p, next) : turn_along(field, p, i);
}

/* The holonomy of a face and the turning of the field around it sum to a multiple of π. */
static int face_index(const struct field *field, uint32_t face)
{
    double sum = hatch_frames_face_holonomy(field->surface, field->frames, face);
    for (uint32_t c = 0; c < 3; c++)
        sum += side_turn(field, face, c);
    return (int)lround(sum / PI);
}

int hatch_field_face_index(const struct hatch_surface *surface, const struct hatch_frames *frames,
                           const double *angle_rad, uint32_t face)
{
    const struct field field = {surface, frames, NULL, angle_rad};
    return face_index(&field, face);
}

/* Returns the turning of the border tangents of a component against the field, in half turns. */
static int32_t border_turns(const struct field *field, const struct hatch_component *component)
{
    double sum = 0;
    for (uint32_t f = component->first_face; f < component->first_face + component->face_count; f++)
        for (uint32_t c = 0; c < 3; c++)
            if (field->surface->opposite[(size_t)f * 3 + c] == HATCH_NO_SIDE)
                sum -= side_turn(field, f, c);
    for (uint32_t p = component->first_point; p < component->first_point + component->point_count; p++) {
        uint32_t last = field->surface->ring_first[p + 1] - 1;
        if (field->surface->ring_face[last] == HATCH_NO_SIDE)
            sum += PI - field->frames->angle_rad[last];
    }
    return (int32_t)lround(sum / PI);
}

enum hatch_status hatch_field_singularities(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                            const double *direction, struct hatch_arena *arena,
                                            struct hatch_arena *scratch, struct hatch_singularities *found,
                                            struct hatch_err *err)
{
    struct field field = {surface, frames, direction, NULL};
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
    field.angle_rad = angle_rad;
    for (uint32_t c = 0; c < surface->component_count; c++) {
        const struct hatch_component *component = &surface->components[c];
        made.component_half_turns[c] = border_turns(&field, component);
        for (uint32_t f = component->first_face; f < component->first_face + component->face_count; f++) {
            index[f] = (int8_t)face_index(&field, f);
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

/* Computes z of the field at a corner against axes x and y of the face's plane. The tangent plane of the point is
 * rotated into it so that the bisector of the corner's scaled angle falls on the bisector of the corner. */
static void corner_z(const struct field *field, uint32_t face, uint32_t c, const double x_axis[3],
                     const double y_axis[3], double z[2])
{
    const uint32_t *corner = &field->surface->corners[(size_t)face * 3];
    uint32_t p = corner[c], i = field->frames->corner_entry[(size_t)face * 3 + c];
    const double *at = &field->surface->points[(size_t)p * 3];
    double middle[3] = {0, 0, 0}, at_point[2];
    for (uint32_t k = 1; k < 3; k++) {
        double edge[3];
        hatch_vec_sub(&field->surface->points[(size_t)corner[(c + k) % 3] * 3], at, edge);
        hatch_vec_normalize(edge);
        hatch_vec_add_scaled(middle, 1, edge, middle);
    }
    double x = hatch_vec_dot(middle, x_axis), y = hatch_vec_dot(middle, y_axis), square = x * x + y * y;
    double bisector = field->frames->angle_rad[i] + hatch_frames_corner_angle(field->surface, field->frames, p, i) / 2;
    double cosine = cos(2 * bisector), sine = sin(2 * bisector);
    hatch_field_encode(field->frames, p, &field->direction[(size_t)p * 3], at_point);
    double relative[2] = {at_point[0] * cosine + at_point[1] * sine, at_point[1] * cosine - at_point[0] * sine};
    if (field->surface->ring_flipped[i])
        relative[1] = -relative[1];
    double rotation[2] = {(x * x - y * y) / square, 2 * x * y / square};
    z[0] = relative[0] * rotation[0] - relative[1] * rotation[1];
    z[1] = relative[0] * rotation[1] + relative[1] * rotation[0];
}

void hatch_field_mean_direction(const double z[3][2], const double u[3], const double v[3], double mean[3],
                                double *cosine_min)
{
    double sum[2] = {0, 0};
    for (int c = 0; c < 3; c++) {
        sum[0] += z[c][0];
        sum[1] += z[c][1];
    }
    double length = sqrt(sum[0] * sum[0] + sum[1] * sum[1]);
    double x = length > 0 ? sum[0] / length : 1, y = length > 0 ? sum[1] / length : 0;
    *cosine_min = 1;
    for (int c = 0; c < 3; c++)
        *cosine_min = fmax(-1, fmin(*cosine_min, z[c][0] * x + z[c][1] * y));
    /* Cosine and sine of half the angle. */
    double larger = sqrt((1 + fabs(x)) / 2), smaller = fabs(y) / (2 * larger);
    double cosine = x < 0 ? smaller : larger, sine = copysign(x < 0 ? larger : smaller, y);
    for (int k = 0; k < 3; k++)
        mean[k] = cosine * u[k] + sine * v[k];
}

/* Computes axes of a face's plane: u along side 0, v towards the third corner. */
static void face_axes(const struct hatch_surface *surface, uint32_t face, double u[3], double v[3])
{
    const uint32_t *corner = &surface->corners[(size_t)face * 3];
    const double *a = &surface->points[(size_t)corner[0] * 3], *b = &surface->points[(size_t)corner[1] * 3];
    double normal[3];
    hatch_vec_triangle(a, b, &surface->points[(size_t)corner[2] * 3], normal);
    hatch_vec_normalize(normal);
    hatch_vec_sub(b, a, u);
    hatch_vec_normalize(u);
    hatch_vec_cross(normal, u, v);
}

void hatch_field_corner_directions(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                   const double *direction, uint32_t face, double z[3][2])
{
    const struct field field = {surface, frames, direction, NULL};
    double u[3], v[3];
    face_axes(surface, face, u, v);
    for (uint32_t c = 0; c < 3; c++)
        corner_z(&field, face, c, u, v, z[c]);
}

void hatch_field_face_direction(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                const double *direction, uint32_t face, double face_direction[3], double *spread_rad)
{
    double u[3], v[3], z[3][2], cosine_min;
    hatch_field_corner_directions(surface, frames, direction, face, z);
    face_axes(surface, face, u, v);
    hatch_field_mean_direction((const double(*)[2])z, u, v, face_direction, &cosine_min);
    *spread_rad = acos(cosine_min) / 2;
}
