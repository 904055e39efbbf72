#include <assert.h>
#include <math.h>
#include <string.h>

#include "lapped/work.h"
#include "math/vector.h"
#include "mesh/edges.h"

/* Faces that one task measures. */
#define SLICE 4096u
/* Rounds in which roughness is shared with neighbours: it should speak of a patch, not of a face. */
#define BLUR_ROUNDS 4
/* Chosen size: diameter over the diagonal, and the faces that a patch should at least have. */
#define SIZE_CHOSEN 0.10
#define FACES_WANTED 250.0
/* More, where a face's longest side squared is over so many times that of equal sides: what a patch's border cuts
 * through is in two patches at least, and long faces reach far in. */
#define LONG 2.5
/* What they should at most have, so that time stays in proportion to faces; and how much larger than
 * chosen the wish for faces may make a patch. */
#define FACES_MOST 1000.0
#define SIZE_MOST 8.0
/* Where growth ends for the size that is chosen and for one that is given: a patch that comes from
 * large faces into small ones would take them all, and time and memory of its matrix with them. */
#define FACES_CHOSEN_MAX 2000u
#define FACES_GIVEN_MAX 20000u
/* The disk that a patch shows, over its square's radius. */
#define SHOWN 0.75
/* How strongly `curved` counts, and the smallest share of its size that it leaves a patch. */
#define CURVED_GAIN 1.0
#define CURVED_MIN 0.25

/* Cosine of the angle by which the field may turn across an edge inside a patch. */
#define COHERENT 0.5

/* Of an equilateral triangle: the square of its side over its area. */
#define EDGE_SQUARED 2.3094010767585034

struct measure {
    struct hatch_ground *ground;
    const struct hatch_frames *frames;
    const double *direction;
    double *area;      /* per face */
    double *angle_rad; /* per point: of the field in its frame */
};

static double square(double x)
{
    return x * x;
}

/* How fast the normals turn along a face's sides: mean square, per length. */
static double normals_turn(const struct measure *of, uint32_t face)
{
    const struct hatch_surface *surface = of->ground->surface;
    const uint32_t *corner = &surface->corners[(size_t)face * 3];
    double sum = 0;
    for (int c = 0; c < 3; c++) {
        const double *a = &of->frames->normal[(size_t)corner[c] * 3];
        const double *b = &of->frames->normal[(size_t)corner[(c + 1) % 3] * 3];
        double length = hatch_vec_distance(&surface->points[(size_t)corner[c] * 3],
                                           &surface->points[(size_t)corner[(c + 1) % 3] * 3]);
        /* The rings of the two points may look to different sides. */
        double dot = fmin(1, fabs(hatch_vec_dot(a, b)));
        sum += (2 - 2 * dot) / square(length);
    }
    return sum / 3;
}

/* The line that the corners' directions make in a face's plane as they stand in space: so programs that
 * know nothing of how a surface turns between its points read the field. Along a crease it follows the
 * crease on both sides. nearest: as hatch_field_mean_direction's. */
static void find_line(const struct measure *of, const uint32_t *corner, const double normal[3], double line[3],
                      double *nearest)
{
    const struct hatch_surface *surface = of->ground->surface;
    double u[3], v[3], z[3][2];
    hatch_vec_sub(&surface->points[(size_t)corner[1] * 3], &surface->points[(size_t)corner[0] * 3], u);
    hatch_vec_normalize(u);
    hatch_vec_cross(normal, u, v);
    for (int c = 0; c < 3; c++) {
        const double *own = &of->direction[(size_t)corner[c] * 3];
        double x = hatch_vec_dot(own, u), y = hatch_vec_dot(own, v), square = x * x + y * y;
        z[c][0] = square > 0 ? (x * x - y * y) / square : 0;
        z[c][1] = square > 0 ? 2 * x * y / square : 0;
    }
    hatch_field_mean_direction((const double(*)[2])z, u, v, line, nearest);
}

static void measure_face(const struct measure *of, uint32_t face)
{
    struct hatch_ground *ground = of->ground;
    const struct hatch_surface *surface = ground->surface;
    const uint32_t *corner = &surface->corners[(size_t)face * 3];
    const double *at[3];
    for (int c = 0; c < 3; c++)
        at[c] = &surface->points[(size_t)corner[c] * 3];
    double line[3], across[3], normal[3], nearest;
    hatch_vec_triangle(at[0], at[1], at[2], normal);
    of->area[face] = hatch_vec_normalize(normal) / 2;
    find_line(of, corner, normal, line, &nearest);
    hatch_vec_cross(normal, line, across);
    for (int c = 1; c < 3; c++) {
        double side[3];
        hatch_vec_sub(at[c], at[0], side);
        ground->flat[(size_t)face * 4 + (size_t)(2 * c - 2)] = hatch_vec_dot(side, line);
        ground->flat[(size_t)face * 4 + (size_t)(2 * c - 1)] = hatch_vec_dot(side, across);
    }
    ground->singular[face] = hatch_field_face_index(surface, of->frames, of->angle_rad, face) != 0;
    /* By the sine of the largest angle between the line and a corner's own. */
    ground->rough[face] = normals_turn(of, face) + (1 - nearest) / (2 * of->area[face]);
}

static void angle_slice(void *context, uint32_t slice)
{
    const struct measure *of = context;
    uint32_t count = of->ground->surface->point_count, first = slice * SLICE;
    for (uint32_t p = first; p < count && p < first + SLICE; p++)
        of->angle_rad[p] = hatch_frames_angle(of->frames, p, &of->direction[(size_t)p * 3]);
}

static void measure_slice(void *context, uint32_t slice)
{
    const struct measure *of = context;
    uint32_t count = of->ground->surface->face_count, first = slice * SLICE;
    for (uint32_t f = first; f < count && f < first + SLICE; f++)
        measure_face(of, f);
}

/* A side in its face's frame. */
static void side_vector(const struct hatch_ground *ground, uint32_t side, double vector[2])
{
    double from[2], to[2];
    hatch_ground_corner(ground, side / 3, side % 3, from);
    hatch_ground_corner(ground, side / 3, hatch_side_end(side) % 3, to);
    vector[0] = to[0] - from[0];
    vector[1] = to[1] - from[1];
}

/* See struct hatch_ground: from the lines of the two faces along their edge, unfolded. */
static int8_t bend_at(const struct hatch_ground *ground, uint32_t side)
{
    const struct hatch_surface *surface = ground->surface;
    uint32_t other = surface->opposite[side];
    if (other == HATCH_NO_SIDE || surface->corners[side] == surface->corners[other])
        return 0;
    double a[2], b[2];
    side_vector(ground, other, a);
    side_vector(ground, side, b);
    double cosine = -(a[0] * b[0] + a[1] * b[1]) / (a[0] * a[0] + a[1] * a[1]);
    int8_t size = fabs(cosine) < COHERENT ? 1 : 2;
    return cosine < 0 ? (int8_t)-size : size;
}

static void join_slice(void *context, uint32_t slice)
{
    const struct measure *of = context;
    uint32_t count = 3 * of->ground->surface->face_count, first = 3 * slice * SLICE;
    for (uint32_t i = first; i < count && i < first + 3 * SLICE; i++)
        of->ground->bend[i] = bend_at(of->ground, i);
}

/* Shares values among the faces around each point, weighed by area. sum: two a point. */
static void blur(const struct hatch_surface *surface, const double *area, double *value, double *sum)
{
    memset(sum, 0, (size_t)surface->point_count * 2 * sizeof *sum);
    size_t count = (size_t)surface->face_count * 3;
    for (size_t i = 0; i < count; i++) {
        sum[2 * surface->corners[i]] += area[i / 3] * value[i / 3];
        sum[2 * surface->corners[i] + 1] += area[i / 3];
    }
    for (uint32_t f = 0; f < surface->face_count; f++) {
        double mean = 0;
        for (size_t c = 0; c < 3; c++) {
            uint32_t point = surface->corners[(size_t)f * 3 + c];
            mean += sum[2 * point] / sum[2 * point + 1];
        }
        value[f] = mean / 3;
    }
}

/* Diagonal of the box around the whole mesh, in its units. */
static double diagonal_of(const struct hatch_surface *surface)
{
    double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, at[3];
    for (uint32_t p = 0; p < surface->point_count; p++) {
        hatch_surface_position(surface, p, at);
        for (int i = 0; i < 3; i++) {
            low[i] = fmin(low[i], at[i]);
            high[i] = fmax(high[i], at[i]);
        }
    }
    return hatch_vec_distance(low, high);
}

/* Half the side of the square around an outline that shows about so many faces. */
static double radius_of_faces(double faces, double area)
{
    return sqrt(faces * area / 3.14159265358979) / SHOWN;
}

static double longest_squared(const struct hatch_ground *ground, uint32_t face)
{
    double longest = 0;
    for (uint32_t c = 0; c < 3; c++) {
        double vector[2];
        side_vector(ground, 3 * face + c, vector);
        longest = fmax(longest, vector[0] * vector[0] + vector[1] * vector[1]);
    }
    return longest;
}

/* Where normals turn far over a patch of so many faces, it would not come about. */
static double more_wanted(const struct hatch_ground *ground, uint32_t face, double area)
{
    double more = fmax(0, longest_squared(ground, face) / (LONG * EDGE_SQUARED * area) - 1);
    double bend = ground->rough[face] * radius_of_faces(FACES_WANTED * (1 + more), area);
    return 1 + more / (1 + square(bend * bend));
}

/* The radius whose core holds a face and neighbours like it. Were it to hold the one alone, long faces side by
 * side would each be in three patches. */
static double radius_to_hold(const struct hatch_ground *ground, const struct hatch_outline *outline, uint32_t face)
{
    double at[3][2], middle[2];
    for (uint32_t c = 0; c < 3; c++)
        hatch_ground_corner(ground, face, c, at[c]);
    return HATCH_LAPPED_HOLD * hatch_patch_circle((const double(*)[2])at, middle) / (2 * outline->core_min);
}

static void choose_radii(struct hatch_ground *ground, const struct hatch_outline *outline,
                         const struct hatch_lapped_options *options, const double *area)
{
    const struct hatch_surface *surface = ground->surface;
    double diagonal = diagonal_of(surface);
    double share = options->size > 0 ? options->size : SIZE_CHOSEN;
    for (uint32_t c = 0; c < surface->component_count; c++) {
        const struct hatch_component *component = &surface->components[c];
        double whole = share * diagonal / component->scale / 2;
        for (uint32_t i = 0; i < component->face_count; i++) {
            uint32_t f = component->first_face + i;
            double bend = options->curved * CURVED_GAIN * ground->rough[f] * whole;
            double radius = whole * fmax(CURVED_MIN, 1 / sqrt(1 + bend * bend));
            double wanted = FACES_WANTED * more_wanted(ground, f, area[f]);
            if (options->size > 0)
                radius = fmax(radius, fmin(whole, radius_of_faces(FACES_WANTED, area[f])));
            else
                radius = fmin(fmax(radius, radius_of_faces(wanted, area[f])),
                              fmin(radius_of_faces(FACES_MOST, area[f]), SIZE_MOST * whole));
            ground->wish[f] = fmax(radius, radius_to_hold(ground, outline, f));
        }
    }
}

enum hatch_status hatch_ground_make(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                    const double *direction, const struct hatch_outline *outline,
                                    const struct hatch_lapped_options *options, struct hatch_pool *pool,
                                    struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_ground *ground,
                                    struct hatch_err *err)
{
    uint32_t count = surface->face_count;
    struct hatch_ground made = {.surface = surface};
    made.faces_max = options->size > 0 ? FACES_GIVEN_MAX : FACES_CHOSEN_MAX;
    made.flat = HATCH_NEW_UNSET(arena, double, (size_t)count * 4, err);
    made.rough = made.flat ? HATCH_NEW_UNSET(arena, double, count, err) : NULL;
    made.wish = made.rough ? HATCH_NEW_UNSET(arena, double, count, err) : NULL;
    made.grain = made.wish ? HATCH_NEW_UNSET(arena, double, count, err) : NULL;
    made.singular = made.grain ? HATCH_NEW_UNSET(arena, uint8_t, count, err) : NULL;
    made.bend = made.singular ? HATCH_NEW_UNSET(arena, int8_t, (size_t)count * 3, err) : NULL;
    if (!made.bend)
        return HATCH_LIMIT;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    double *area = HATCH_NEW_UNSET(scratch, double, count, err);
    double *sum = area ? HATCH_NEW_UNSET(scratch, double, (size_t)surface->point_count * 2, err) : NULL;
    if (sum) {
        /* The sums of the blur come after the angles. */
        struct measure of = {&made, frames, direction, area, sum};
        hatch_parallel_for(pool, (surface->point_count + SLICE - 1) / SLICE, angle_slice, &of);
        hatch_parallel_for(pool, (count + SLICE - 1) / SLICE, measure_slice, &of);
        hatch_parallel_for(pool, (count + SLICE - 1) / SLICE, join_slice, &of);
        double *wide = made.wish;
        memcpy(wide, area, count * sizeof *area);
        for (int i = 0; i < BLUR_ROUNDS; i++) {
            blur(surface, area, made.rough, sum);
            blur(surface, area, wide, sum);
        }
        memcpy(area, wide, count * sizeof *area);
        for (uint32_t f = 0; f < count; f++) {
            made.rough[f] = sqrt(made.rough[f]);
            made.grain[f] = sqrt(area[f] * EDGE_SQUARED);
        }
        choose_radii(&made, outline, options, area);
        *ground = made;
    }
    hatch_arena_rewind(scratch, mark);
    return sum ? HATCH_OK : HATCH_LIMIT;
}
