/* Faces laid out in the plane, and walks over them. */
#include <math.h>
#include <stdlib.h>

#include "math/box.h"
#include "math/vector.h"
#include "field/field.h"
#include "trace/ground.h"

#define ROUNDING_RAD 1e-6 /* angle between faces that counts as none */
#define CALM_MIN 0.15     /* length of the mean of the corners' directions below which there is none on a small face */

static void corner_position(const struct hatch_surface *surface, uint32_t face, uint32_t c, double at[3])
{
    hatch_vec_copy(&surface->points[3 * (size_t)surface->corners[3 * (size_t)face + c]], at);
}

static void lay_out_face(const struct hatch_surface *surface, uint32_t f, struct hatch_trace_face *face,
                         struct hatch_trace_pose *pose)
{
    double p[3][3], e1[3], e2[3], n[3], v[3];
    for (uint32_t c = 0; c < 3; c++)
        corner_position(surface, f, c, p[c]);
    hatch_vec_triangle(p[0], p[1], p[2], n);
    hatch_vec_normalize(n);
    hatch_vec_sub(p[1], p[0], e1);
    hatch_vec_sub(p[2], p[0], e2);
    face->x1 = (float)hatch_vec_normalize(e1);
    hatch_vec_cross(n, e1, v);
    face->x2 = (float)hatch_vec_dot(e2, e1);
    face->y2 = (float)hatch_vec_dot(e2, v);
    hatch_vec_round(e1, pose->u);
    hatch_vec_round(v, pose->v);
    hatch_vec_round(p[0], pose->at);
}

/* Returns the angle between the faces at a side and at the same edge of another face.
 *   contrary  the side runs in the same direction there: the faces have opposite outsides */
static double bend_of(const struct hatch_surface *surface, uint32_t side, uint32_t other, bool contrary)
{
    double a[3], b[3];
    hatch_surface_face_normal(surface, side / 3, a);
    hatch_surface_face_normal(surface, other / 3, b);
    return contrary ? hatch_vec_angle(a, (const double[3]){-b[0], -b[1], -b[2]}) : hatch_vec_angle(a, b);
}

void hatch_trace_corners(const struct hatch_trace_face *face, double corner[3][2])
{
    corner[0][0] = corner[0][1] = corner[1][1] = 0;
    corner[1][0] = (double)face->x1;
    corner[2][0] = (double)face->x2;
    corner[2][1] = (double)face->y2;
}

/* Sets how headings turn that cross a side, so that they keep their angle to the edge. */
static void set_turn(struct hatch_trace_ground *ground, uint32_t side)
{
    struct hatch_trace_face *face = &ground->faces[side / 3];
    uint32_t c = side % 3, other = face->beyond[c];
    double from[3][2], to[3][2];
    hatch_trace_corners(face, from);
    hatch_trace_corners(&ground->faces[other / 3], to);
    const double *a = from[c], *b = from[(c + 1) % 3], *p = to[other % 3], *q = to[(other + 1) % 3];
    double edge[2] = {b[0] - a[0], b[1] - a[1]}, next[2] = {q[0] - p[0], q[1] - p[1]};
    double square = edge[0] * edge[0] + edge[1] * edge[1], next_square = next[0] * next[0] + next[1] * next[1];
    double mirror = face->contrary >> c & 1 ? -1 : 1, size = -mirror * sqrt(square * next_square);
    edge[1] *= mirror;
    face->turn[c][0] = (float)((edge[0] * next[0] + edge[1] * next[1]) / size);
    face->turn[c][1] = (float)((edge[0] * next[1] - edge[1] * next[0]) / size);
}

/* Joins the faces at the edges that strokes cross. Across a contrary edge, the angle to the field is counted the other
 * way round, so that strokes go on only where it is a multiple of a right angle.
 *   number  per face of the surface: its number on the ground */
static void join_sides(const struct hatch_surface *surface, const uint32_t *number, double angle_rad, double hard_rad,
                       struct hatch_trace_ground *ground)
{
    const bool slanted = fabs(sin(2 * angle_rad)) > ROUNDING_RAD;
    for (uint32_t side = 0; side < 3 * surface->face_count; side++) {
        uint32_t from = 3 * ground->source[side / 3] + side % 3, to = surface->opposite[from], other = to;
        struct hatch_trace_face *face = &ground->faces[side / 3];
        if (to != HATCH_NO_SIDE)
            other = 3 * number[to / 3] + to % 3;
        bool contrary = to != HATCH_NO_SIDE && surface->corners[from] == surface->corners[to];
        bool open = to != HATCH_NO_SIDE && !(contrary && slanted) &&
                    bend_of(surface, from, to, contrary) <= hard_rad + ROUNDING_RAD;
        face->beyond[side % 3] = open ? other : HATCH_NO_SIDE;
        face->contrary |= (uint8_t)((uint32_t)contrary << side % 3);
        if (open)
            set_turn(ground, side);
    }
}

/* Spreads the low ten bits of a number: two zeros come before each. */
static uint32_t spread(uint32_t bits)
{
    uint32_t result = 0;
    for (uint32_t i = 0; i < 10; i++)
        result |= (bits >> i & 1) << 3 * i;
    return result;
}

struct coded {
    uint32_t code, face;
};

static int by_code(const void *a, const void *b)
{
    const struct coded *x = a, *y = b;
    if (x->code != y->code)
        return x->code < y->code ? -1 : 1;
    return x->face < y->face ? -1 : x->face > y->face;
}

/* Numbers the faces of each component along a Z-order curve through their first corners.
 *   source, number  out: per number its face, per face its number */
static enum hatch_status order_faces(const struct hatch_surface *surface, struct hatch_arena *arena, uint32_t *source,
                                     uint32_t *number, struct hatch_err *err)
{
    struct coded *coded;
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &coded, surface->face_count, err));
    for (uint32_t c = 0; c < surface->component_count; c++) {
        const struct hatch_component *component = &surface->components[c];
        struct hatch_box box = {.any = false};
        for (uint32_t p = 0; p < component->point_count; p++)
            hatch_box_add(&box, &surface->points[3 * (size_t)(component->first_point + p)]);
        for (uint32_t f = component->first_face; f < component->first_face + component->face_count; f++) {
            double at[3];
            corner_position(surface, f, 0, at);
            coded[f] = (struct coded){0, f};
            for (int k = 0; k < 3; k++) {
                double size = box.high[k] - box.low[k], share = size > 0 ? (at[k] - box.low[k]) / size : 0;
                coded[f].code |= spread((uint32_t)(share * 1023)) << k;
            }
        }
        qsort(&coded[component->first_face], component->face_count, sizeof *coded, by_code);
    }
    for (uint32_t f = 0; f < surface->face_count; f++) {
        source[f] = coded[f].face;
        number[coded[f].face] = f;
    }
    return HATCH_OK;
}

/* Sets the directions of a face from those at its corners. */
static void set_changes(const struct hatch_trace_face *face, double z[3][2], struct hatch_trace_pose *pose)
{
    for (int k = 0; k < 2; k++) {
        double along_x = (z[1][k] - z[0][k]) / (double)face->x1;
        pose->z[0][k] = (float)z[0][k];
        pose->z[1][k] = (float)along_x;
        pose->z[2][k] = (float)((z[2][k] - z[0][k] - along_x * (double)face->x2) / (double)face->y2);
    }
}

enum hatch_status hatch_trace_lay_out(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                      const double *direction, double angle_rad, double hard_rad,
                                      struct hatch_arena *arena, struct hatch_trace_ground *ground,
                                      struct hatch_err *err)
{
    struct hatch_trace_ground made = {.surface = surface};
    double cosine = cos(2 * angle_rad), sine = sin(2 * angle_rad);
    uint32_t *number;
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &made.source, surface->face_count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &number, surface->face_count, err));
    HATCH_TRY(order_faces(surface, arena, made.source, number, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.faces, surface->face_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.poses, surface->face_count, err));
    for (uint32_t f = 0; f < surface->face_count; f++) {
        double z[3][2];
        lay_out_face(surface, made.source[f], &made.faces[f], &made.poses[f]);
        hatch_field_corner_directions(surface, frames, direction, made.source[f], z);
        for (int c = 0; c < 3; c++) {
            double x = z[c][0];
            z[c][0] = x * cosine - z[c][1] * sine;
            z[c][1] = x * sine + z[c][1] * cosine;
        }
        set_changes(&made.faces[f], z, &made.poses[f]);
    }
    join_sides(surface, number, angle_rad, hard_rad, &made);
    HATCH_TRY(hatch_trace_find_ends(&made, arena, &made.ends, err));
    *ground = made;
    return HATCH_OK;
}

void hatch_trace_shares(const struct hatch_trace_face *face, double x, double y, double share[3])
{
    share[2] = y / (double)face->y2;
    share[1] = (x - share[2] * (double)face->x2) / (double)face->x1;
    share[0] = 1 - share[1] - share[2];
}

/* Returns how fast the mean of the corners' directions changes, per surface unit, as a root of a sum of squares. */
static double rate_of_change(const struct hatch_trace_pose *pose)
{
    double sum = 0;
    for (int i = 1; i < 3; i++)
        for (int k = 0; k < 2; k++)
            sum += (double)pose->z[i][k] * (double)pose->z[i][k];
    return sqrt(sum);
}

bool hatch_trace_direction(const struct hatch_trace_ground *ground, const struct hatch_trace_place *place,
                           double direction[2])
{
    const struct hatch_trace_pose *pose = &ground->poses[place->face];
    double z[2];
    for (int k = 0; k < 2; k++)
        z[k] = (double)pose->z[0][k] + place->x * (double)pose->z[1][k] + place->y * (double)pose->z[2][k];
    double length = sqrt(z[0] * z[0] + z[1] * z[1]);
    if (!(length >= CALM_MIN || length > ground->calm * rate_of_change(pose)))
        return false;
    double x = z[0] / length, y = z[1] / length;
    double larger = sqrt((1 + fabs(x)) / 2), smaller = fabs(y) / (2 * larger);
    direction[0] = x < 0 ? smaller : larger;
    direction[1] = copysign(x < 0 ? larger : smaller, y);
    if (direction[0] * place->heading[0] + direction[1] * place->heading[1] < 0) {
        direction[0] = -direction[0];
        direction[1] = -direction[1];
    }
    return true;
}

/* Moves straight on in the face, by `length` at most. Returns the side that was reached, 3 if none.
 *   moved  out: the way */
static uint32_t move(const struct hatch_trace_face *face, struct hatch_trace_place *place, double length, double *moved)
{
    const double x1 = (double)face->x1, x2 = (double)face->x2, y2 = (double)face->y2, back = x2 - x1;
    const double x = place->x, y = place->y, dx = place->heading[0], dy = place->heading[1];
    uint32_t reached = 3;
    /* For each side, how fast its line comes nearer, and how far it is, both times the side's length. */
    const double rates[3] = {-x1 * dy, y2 * dx - back * dy, x2 * dy - y2 * dx};
    for (uint32_t c = 0; c < 3; c++) {
        if (!(rates[c] > 0))
            continue;
        double inside = c == 0 ? x1 * y : c == 1 ? back * y - y2 * (x - x1) : y2 * (x - x2) - x2 * (y - y2);
        if (inside < length * rates[c]) {
            length = inside > 0 ? inside / rates[c] : 0;
            reached = c;
        }
    }
    place->x += length * dx;
    place->y += length * dy;
    *moved = length;
    return reached;
}

/* Crosses a side to the next face. The heading keeps its angle to the edge; across a contrary edge it is mirrored. */
static void cross_side(const struct hatch_trace_ground *ground, struct hatch_trace_place *place, uint32_t c)
{
    const struct hatch_trace_face *face = &ground->faces[place->face];
    uint32_t other = face->beyond[c];
    double from[3][2], to[3][2];
    hatch_trace_corners(face, from);
    hatch_trace_corners(&ground->faces[other / 3], to);
    const double *a = from[c], *b = from[(c + 1) % 3], *p = to[other % 3], *q = to[(other + 1) % 3];
    double edge[2] = {b[0] - a[0], b[1] - a[1]};
    double along = (place->x - a[0]) * edge[0] + (place->y - a[1]) * edge[1];
    double share = along / (edge[0] * edge[0] + edge[1] * edge[1]);
    share = share > 0 ? share < 1 ? share : 1 : 0;
    double x = place->heading[0], y = place->heading[1];
    if (face->contrary >> c & 1)
        y = -y;
    else
        share = 1 - share;
    place->face = other / 3;
    place->x = p[0] + share * (q[0] - p[0]);
    place->y = p[1] + share * (q[1] - p[1]);
    place->heading[0] = x * (double)face->turn[c][0] - y * (double)face->turn[c][1];
    place->heading[1] = x * (double)face->turn[c][1] + y * (double)face->turn[c][0];
}

/* Turns the heading to the direction of the field half a step ahead, within the face. */
static bool follow(const struct hatch_trace_ground *ground, struct hatch_trace_place *place, double length)
{
    struct hatch_trace_place ahead = *place;
    double moved;
    if (!hatch_trace_direction(ground, place, ahead.heading))
        return false;
    move(&ground->faces[place->face], &ahead, length / 2, &moved);
    return hatch_trace_direction(ground, &ahead, place->heading);
}

bool hatch_trace_walk(const struct hatch_trace_ground *ground, struct hatch_trace_place *place, double length,
                      enum hatch_trace_way way, struct hatch_trace_leg *leg)
{
    const struct hatch_trace_face *face = &ground->faces[place->face];
    *leg = (struct hatch_trace_leg){place->face, {place->x, place->y}, {place->x, place->y}, 0, 3};
    if (way == HATCH_TRACE_ALONG && !follow(ground, place, length))
        return false;
    leg->side = move(face, place, length, &leg->length);
    leg->to[0] = place->x;
    leg->to[1] = place->y;
    if (leg->side == 3)
        return true;
    if (face->beyond[leg->side] == HATCH_NO_SIDE)
        return false;
    cross_side(ground, place, leg->side);
    return true;
}

double hatch_trace_steepness(const struct hatch_trace_ground *ground, const struct hatch_trace_leg *leg,
                             const double heading[2])
{
    double corner[3][2];
    hatch_trace_corners(&ground->faces[leg->face], corner);
    const double *a = corner[leg->side], *b = corner[(leg->side + 1) % 3];
    double edge[2] = {b[0] - a[0], b[1] - a[1]}, length = sqrt(edge[0] * edge[0] + edge[1] * edge[1]);
    return fabs(edge[0] * heading[1] - edge[1] * heading[0]) / length;
}

void hatch_trace_turn(struct hatch_trace_place *place, double sign)
{
    double x = place->heading[0];
    place->heading[0] = -sign * place->heading[1];
    place->heading[1] = sign * x;
}

void hatch_trace_position(const struct hatch_trace_pose *pose, double x, double y, double position[3])
{
    for (int k = 0; k < 3; k++)
        position[k] = (double)pose->at[k] + x * (double)pose->u[k] + y * (double)pose->v[k];
}

void hatch_trace_vector(const struct hatch_trace_pose *pose, const double plane[2], float vector[3])
{
    for (int k = 0; k < 3; k++)
        vector[k] = (float)(plane[0] * (double)pose->u[k] + plane[1] * (double)pose->v[k]);
}

void hatch_trace_normal(const struct hatch_trace_pose *pose, float normal[3])
{
    for (int k = 0; k < 3; k++)
        normal[k] = pose->u[(k + 1) % 3] * pose->v[(k + 2) % 3] - pose->u[(k + 2) % 3] * pose->v[(k + 1) % 3];
}
