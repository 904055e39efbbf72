#include <assert.h>
#include <math.h>
#include <string.h>

#include "lapped/work.h"
#include "math/vector.h"
#include "mesh/edges.h"

/* Number of faces, or of points, per task. */
#define SLICE 4096u
/* Number of rounds in which the turning rate is smoothed, so that it describes a patch rather than a face. */
#define BLUR_ROUNDS 4
/* Default diameter of a patch over the diagonal of the mesh, and the fewest faces that a patch should have. */
#define DEFAULT_SIZE 0.10
#define FACES_MIN 250.0
/* A patch of long faces should have more faces: a face that the border cuts is in at least two patches, and long faces
 * reach far into a patch. A face is long if the square of its longest side is more than LONG times that of an
 * equilateral triangle of the same area. */
#define LONG 2.5
/* The most faces that a patch of default size should have, so that time stays proportional to the number of faces; and
 * the largest factor by which FACES_MIN may enlarge a patch. */
#define FACES_MAX 1000.0
#define SIZE_FACTOR_MAX 8.0
/* Growth stops at this number of faces, by default and with options->size: a patch that grows from large faces into
 * small ones would otherwise add them all and need a huge matrix. */
#define DEFAULT_FACES_MAX 2000u
#define SIZED_FACES_MAX 20000u
/* Radius of the visible disk of a patch over half the side of its square. */
#define SHOWN 0.75
/* Factor on options->curved, and the smallest share of its size to which a patch shrinks. */
#define CURVED_GAIN 1.0
#define CURVED_MIN 0.25

/* Cosine of the largest angle by which the field may turn across an edge inside a patch. */
#define COHERENT 0.5

/* Squared side of an equilateral triangle over its area. */
#define EDGE_SQUARED 2.3094010767585034

struct work {
    const struct hatch_lapped_input *input;
    struct hatch_patch_domain *domain;
    double *area;      /* per face */
    double *angle_rad; /* per point: angle of the field in the point's frame */
};

static double square(double x)
{
    return x * x;
}

/* Returns the mean squared turning of the normals along a face's sides, per squared length. */
static double normals_turn(const struct work *w, uint32_t face)
{
    const struct hatch_surface *surface = w->domain->surface;
    const uint32_t *corner = &surface->corners[(size_t)face * 3];
    double sum = 0;
    for (int c = 0; c < 3; c++) {
        const double *a = &w->input->frames->normal[(size_t)corner[c] * 3];
        const double *b = &w->input->frames->normal[(size_t)corner[(c + 1) % 3] * 3];
        double length = hatch_vec_distance(&surface->points[(size_t)corner[c] * 3],
                                           &surface->points[(size_t)corner[(c + 1) % 3] * 3]);
        /* The normals may point to different sides of a non-orientable surface. */
        double dot = fmin(1, fabs(hatch_vec_dot(a, b)));
        sum += (2 - 2 * dot) / square(length);
    }
    return sum / 3;
}

/* Computes the mean of the corners' directions, projected into the face's plane without parallel transport, so that
 * readers of the file, which know nothing of transport, find the same direction. Along a crease it follows the crease
 * on both sides.
 *   nearest  as in hatch_field_mean_direction */
static void find_direction(const struct work *w, const uint32_t *corner, const double normal[3], double direction[3],
                           double *nearest)
{
    const struct hatch_surface *surface = w->domain->surface;
    double u[3], v[3], z[3][2];
    hatch_vec_sub(&surface->points[(size_t)corner[1] * 3], &surface->points[(size_t)corner[0] * 3], u);
    hatch_vec_normalize(u);
    hatch_vec_cross(normal, u, v);
    for (int c = 0; c < 3; c++) {
        const double *own = &w->input->direction[(size_t)corner[c] * 3];
        double x = hatch_vec_dot(own, u), y = hatch_vec_dot(own, v), square = x * x + y * y;
        z[c][0] = square > 0 ? (x * x - y * y) / square : 0;
        z[c][1] = square > 0 ? 2 * x * y / square : 0;
    }
    hatch_field_mean_direction((const double(*)[2])z, u, v, direction, nearest);
}

static void measure_face(const struct work *w, uint32_t face)
{
    struct hatch_patch_domain *domain = w->domain;
    const struct hatch_surface *surface = domain->surface;
    const uint32_t *corner = &surface->corners[(size_t)face * 3];
    const double *at[3];
    for (int c = 0; c < 3; c++)
        at[c] = &surface->points[(size_t)corner[c] * 3];
    double direction[3], across[3], normal[3], nearest;
    hatch_vec_triangle(at[0], at[1], at[2], normal);
    w->area[face] = hatch_vec_normalize(normal) / 2;
    find_direction(w, corner, normal, direction, &nearest);
    hatch_vec_cross(normal, direction, across);
    for (int c = 1; c < 3; c++) {
        double side[3];
        hatch_vec_sub(at[c], at[0], side);
        domain->flattened[(size_t)face * 4 + (size_t)(2 * c - 2)] = hatch_vec_dot(side, direction);
        domain->flattened[(size_t)face * 4 + (size_t)(2 * c - 1)] = hatch_vec_dot(side, across);
    }
    domain->singular[face] = hatch_field_face_index(surface, w->input->frames, w->angle_rad, face) != 0;
    /* The second term is the squared sine of the largest angle between the face's direction and that of a corner, per
     * area. */
    domain->turning_rate[face] = normals_turn(w, face) + (1 - nearest) / (2 * w->area[face]);
}

static void angle_slice(void *context, uint32_t slice)
{
    const struct work *w = context;
    uint32_t count = w->domain->surface->point_count, first = slice * SLICE;
    for (uint32_t p = first; p < count && p < first + SLICE; p++)
        w->angle_rad[p] = hatch_frames_angle(w->input->frames, p, &w->input->direction[(size_t)p * 3]);
}

static void measure_slice(void *context, uint32_t slice)
{
    const struct work *w = context;
    uint32_t count = w->domain->surface->face_count, first = slice * SLICE;
    for (uint32_t f = first; f < count && f < first + SLICE; f++)
        measure_face(w, f);
}

/* Computes a side as a vector in its face's plane. */
static void side_vector(const struct hatch_patch_domain *domain, uint32_t side, double vector[2])
{
    double from[2], to[2];
    hatch_patch_domain_corner(domain, side / 3, side % 3, from);
    hatch_patch_domain_corner(domain, side / 3, hatch_side_end(side) % 3, to);
    vector[0] = to[0] - from[0];
    vector[1] = to[1] - from[1];
}

/* Returns the matching of a side: compares the directions of its two faces as if they were unfolded around it. */
static int8_t matching_at(const struct hatch_patch_domain *domain, uint32_t side)
{
    const struct hatch_surface *surface = domain->surface;
    uint32_t other = surface->opposite[side];
    if (other == HATCH_NO_SIDE || surface->corners[side] == surface->corners[other])
        return 0;
    double a[2], b[2];
    side_vector(domain, other, a);
    side_vector(domain, side, b);
    double cosine = -(a[0] * b[0] + a[1] * b[1]) / (a[0] * a[0] + a[1] * a[1]);
    int8_t size = fabs(cosine) < COHERENT ? 1 : 2;
    return cosine < 0 ? (int8_t)-size : size;
}

static void match_slice(void *context, uint32_t slice)
{
    const struct work *w = context;
    uint32_t count = 3 * w->domain->surface->face_count, first = 3 * slice * SLICE;
    for (uint32_t i = first; i < count && i < first + 3 * SLICE; i++)
        w->domain->matching[i] = matching_at(w->domain, i);
}

/* Replaces each face's value by the mean, over the face's points, of the area-weighted mean around the point.
 *   value  per face
 *   sum    scratch: 2 values per point */
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

/* Returns the diagonal of the bounding box of consecutive components, in the mesh's units.
 *   end  the component after the last one */
static double diagonal_of(const struct hatch_surface *surface, uint32_t first, uint32_t end)
{
    double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, at[3];
    const struct hatch_component *last = &surface->components[end - 1];
    for (uint32_t p = surface->components[first].first_point; p < last->first_point + last->point_count; p++) {
        hatch_surface_position(surface, p, at);
        for (int i = 0; i < 3; i++) {
            low[i] = fmin(low[i], at[i]);
            high[i] = fmax(high[i], at[i]);
        }
    }
    return hatch_vec_distance(low, high);
}

/* Returns the radius of a patch that shows about this many faces of an area. */
static double radius_of_faces(double faces, double area)
{
    return sqrt(faces * area / 3.14159265358979) / SHOWN;
}

static double longest_squared(const struct hatch_patch_domain *domain, uint32_t face)
{
    double longest = 0;
    for (uint32_t c = 0; c < 3; c++) {
        double vector[2];
        side_vector(domain, 3 * face + c, vector);
        longest = fmax(longest, vector[0] * vector[0] + vector[1] * vector[1]);
    }
    return longest;
}

/* Returns the factor, at least 1, by which FACES_MIN is raised for a face that is long for its area (see LONG). It
 * falls back towards 1 where normals or field turn so fast that a patch of that size could not be made. */
static double long_face_factor(const struct hatch_patch_domain *domain, uint32_t face, double area)
{
    double more = fmax(0, longest_squared(domain, face) / (LONG * EDGE_SQUARED * area) - 1);
    double turning = domain->turning_rate[face] * radius_of_faces(FACES_MIN * (1 + more), area);
    return 1 + more / (1 + square(turning * turning));
}

/* Returns the radius of a patch whose core contains a face and neighbours of the same size. If it contained the face
 * alone, each of a row of long faces would be in three patches. */
static double radius_to_contain(const struct hatch_patch_domain *domain, const struct hatch_outline *outline,
                                uint32_t face)
{
    double at[3][2], middle[2];
    for (uint32_t c = 0; c < 3; c++)
        hatch_patch_domain_corner(domain, face, c, at[c]);
    return HATCH_LAPPED_CORE_FACTOR * hatch_patch_enclosing_circle((const double(*)[2])at, middle) /
           (2 * outline->core_min);
}

/* Chooses the target radii of a component.
 *   whole  radius of a patch on a flat part as a share of the mesh's diagonal, in the component's units
 *   own    the same as a share of the diagonal of the component's body */
static void choose_radii(struct hatch_patch_domain *domain, const struct hatch_outline *outline,
                         const struct hatch_lapped_options *options, const double *area,
                         const struct hatch_component *component, double whole, double own)
{
    for (uint32_t i = 0; i < component->face_count; i++) {
        uint32_t f = component->first_face + i;
        double most = radius_of_faces(FACES_MAX, area[f]);
        /* On a small body beside a large one, even CURVED_MIN of the whole may exceed FACES_MAX: without options->size,
         * the radius that shrinks is therefore at most that of FACES_MAX, or the body's own if that is larger. */
        double flat = options->size > 0 ? whole : fmin(whole, fmax(own, most));
        double turning = options->curved * CURVED_GAIN * domain->turning_rate[f] * flat;
        double radius = flat * fmax(CURVED_MIN, 1 / sqrt(1 + turning * turning));
        double faces_min = FACES_MIN * long_face_factor(domain, f, area[f]);
        if (options->size > 0)
            radius = fmax(radius, fmin(whole, radius_of_faces(FACES_MIN, area[f])));
        else
            radius = fmin(fmax(radius, radius_of_faces(faces_min, area[f])), fmin(most, SIZE_FACTOR_MAX * whole));
        domain->target_radius[f] = fmax(radius, radius_to_contain(domain, outline, f));
    }
}

/* Returns the component after the last one that belongs to the same body as a component. */
static uint32_t end_of_body(const struct hatch_surface *surface, uint32_t component)
{
    uint32_t end = component;
    while (end < surface->component_count && surface->components[end].body == surface->components[component].body)
        end++;
    return end;
}

/* Chooses the target radii of all faces. */
static void choose_all_radii(struct hatch_patch_domain *domain, const struct hatch_outline *outline,
                             const struct hatch_lapped_options *options, const double *area)
{
    const struct hatch_surface *surface = domain->surface;
    double share = options->size > 0 ? options->size : DEFAULT_SIZE;
    double whole = share * diagonal_of(surface, 0, surface->component_count) / 2;
    for (uint32_t c = 0, end; c < surface->component_count; c = end) {
        end = end_of_body(surface, c);
        double own = share * diagonal_of(surface, c, end) / 2;
        for (uint32_t i = c; i < end; i++) {
            const struct hatch_component *component = &surface->components[i];
            choose_radii(domain, outline, options, area, component, whole / component->scale, own / component->scale);
        }
    }
}

enum hatch_status hatch_patch_domain_make(const struct hatch_lapped_input *input,
                                          const struct hatch_lapped_options *options, struct hatch_pool *pool,
                                          struct hatch_arena *arena, struct hatch_arena *scratch,
                                          struct hatch_patch_domain *domain, struct hatch_err *err)
{
    const struct hatch_surface *surface = input->surface;
    uint32_t count = surface->face_count;
    struct hatch_patch_domain made = {.surface = surface};
    made.faces_max = options->size > 0 ? SIZED_FACES_MAX : DEFAULT_FACES_MAX;
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &made.flattened, (size_t)count * 4, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &made.turning_rate, count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &made.target_radius, count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &made.edge_length, count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &made.singular, count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &made.matching, (size_t)count * 3, err));
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    double *area = HATCH_NEW_UNSET(scratch, double, count, err);
    double *sum = area ? HATCH_NEW_UNSET(scratch, double, (size_t)surface->point_count * 2, err) : NULL;
    if (sum) {
        /* The angles are kept in sum, because they are no longer needed when the blur uses it. */
        struct work w = {input, &made, area, sum};
        hatch_parallel_for(pool, (surface->point_count + SLICE - 1) / SLICE, angle_slice, &w);
        hatch_parallel_for(pool, (count + SLICE - 1) / SLICE, measure_slice, &w);
        hatch_parallel_for(pool, (count + SLICE - 1) / SLICE, match_slice, &w);
        double *smoothed_area = made.target_radius;
        memcpy(smoothed_area, area, count * sizeof *area);
        for (int i = 0; i < BLUR_ROUNDS; i++) {
            blur(surface, area, made.turning_rate, sum);
            blur(surface, area, smoothed_area, sum);
        }
        memcpy(area, smoothed_area, count * sizeof *area);
        for (uint32_t f = 0; f < count; f++) {
            made.turning_rate[f] = sqrt(made.turning_rate[f]);
            made.edge_length[f] = sqrt(area[f] * EDGE_SQUARED);
        }
        choose_all_radii(&made, input->outline, options, area);
        *domain = made;
    }
    hatch_arena_rewind(scratch, mark);
    return sum ? HATCH_OK : HATCH_LIMIT;
}
