/* Flat faces of a mesh, as a draughtsman sees them: the triangles of one plane, connected, and either bounded by hard
 * edges or too large to be facets of a curved surface. The surface is cut along the creases around them, so that each
 * side of a crease has points, and directions, of its own. */
#include <math.h>
#include <string.h>

#include "math/vector.h"
#include "surface/work.h"

#define PLANE_RAD 1e-3        /* largest angle between neighbouring triangles of a plane */
#define FLATNESS 5e-4         /* largest distance from the plane, in radii */
#define ROUNDING 0x1p-22      /* relative error of positions */
#define ROUNDING_MAX_RAD 0.05 /* of normals; thinner faces are not compared */
#define HARD_COSINE 0.2588    /* 75 degrees: edges of a five-sided prism still count as round */
#define CREASE_COSINE 0.9397  /* 20 degrees: around a plane, sharper edges are cut */
#define FACES_MIN 30u         /* of a plane not bounded by hard edges all round; it has a point inside, */
#define AREA_MIN 8.0          /* and an area of so many mean faces: slivers around a pole look flat */
#define CREASE_MIN 0.5        /* share of its border that is open or a crease; */
#define WIDTH_MIN 8.0         /* or else its area over its radius, in square roots of the mean area of faces */
#define SURE_FACES 3u         /* between hard edges all round are a plane, */
#define SURE_AREA 8.0         /* and so are fewer with an area of so many mean faces; others are facets */
#define FLAT_MIN 0.3          /* share of the area of a component that is flat, or it has no facets */
#define BINS 180u             /* of directions of its border */
#define STRAIGHT_MIN 0.1      /* share of the border that runs along the direction of a plane with straight edges */

struct finder {
    struct hatch_surface_work *w;
    double *normal;                            /* 3 per face: unit, on the outside; 0 where the face is left out */
    double *area;                              /* per face */
    uint32_t *list;                            /* faces by region */
    uint32_t *sorted, sorted_count;            /* faces that are kept, by body */
    uint32_t first, end;                       /* of the current region in list */
    uint32_t *inside;                          /* per position: the region that it was last seen in, plus 1 */
    uint32_t *border;                          /* per position: the region on whose border it was last seen, plus 1 */
    double extent;                             /* largest coordinate */
    double mean_area;                          /* of the faces */
    bool *is_facet;                            /* per plane */
    uint32_t capacity;                         /* of the arrays per plane */
    double center[3], plane_normal[3], radius; /* of the current region */
};

static void corner(const struct finder *f, uint32_t i, double position[3])
{
    hatch_vec_of(&f->w->mesh->attributes[0].data[3 * (size_t)f->w->mesh->indices[i]], position);
}

static void find_normals(struct finder *f)
{
    for (uint32_t face = 0; face < f->w->mesh->face_count; face++) {
        double p[3][3], *normal = &f->normal[3 * (size_t)face];
        if (f->w->dropped[face])
            continue;
        for (uint32_t k = 0; k < 3; k++) {
            corner(f, 3 * face + k, p[k]);
            for (int i = 0; i < 3; i++)
                f->extent = fmax(f->extent, fabs(p[k][i]));
        }
        bool flipped = f->w->flipped[face] != 0;
        hatch_vec_triangle(p[0], p[flipped ? 2 : 1], p[flipped ? 1 : 2], normal);
        f->area[face] = hatch_vec_normalize(normal) / 2;
        f->mean_area += f->area[face] / f->w->mesh->face_count;
    }
}

/* Returns the rounding error of a face's normal in radians: that of positions over the smallest height. */
static double rounding_rad(const struct finder *f, uint32_t face)
{
    double longest = 0, p[3][3];
    for (uint32_t k = 0; k < 3; k++)
        corner(f, 3 * face + k, p[k]);
    for (int k = 0; k < 3; k++)
        longest = fmax(longest, hatch_vec_distance(p[k], p[(k + 1) % 3]));
    return ROUNDING * f->extent * longest / (2 * f->area[face]);
}

/* Returns whether a normal agrees with that of a face, to within PLANE_RAD and rounding. */
static bool agrees(const struct finder *f, const double normal[3], uint32_t face)
{
    const double *own = &f->normal[3 * (size_t)face];
    double turn[3];
    hatch_vec_cross(normal, own, turn);
    double sine = hatch_vec_length(turn);
    if (!(sine <= ROUNDING_MAX_RAD) || !(hatch_vec_dot(normal, own) > 0))
        return false;
    return sine <= PLANE_RAD || sine <= PLANE_RAD + rounding_rad(f, face);
}

static bool is_coplanar(const struct finder *f, uint32_t a, uint32_t b)
{
    return agrees(f, &f->normal[3 * (size_t)a], b) || agrees(f, &f->normal[3 * (size_t)b], a);
}

/* Lists the faces that are connected to a face through coplanar neighbours. */
static void grow(struct finder *f, uint32_t seed, uint32_t region)
{
    uint32_t *of = f->w->plane;
    f->first = f->end;
    of[seed] = region;
    f->list[f->end++] = seed;
    for (uint32_t next = f->first; next < f->end; next++)
        for (uint32_t side = 3 * f->list[next]; side < 3 * f->list[next] + 3; side++) {
            uint32_t partner = f->w->partner[side];
            if (partner == HATCH_NO_EDGE || of[partner / 3] != HATCH_NO_SIDE || !is_coplanar(f, side / 3, partner / 3))
                continue;
            of[partner / 3] = region;
            f->list[f->end++] = partner / 3;
        }
}

/* Computes the plane of the region. Returns whether all its points lie in it. */
static bool is_flat(struct finder *f)
{
    double whole = 0, farthest = 0;
    memset(f->center, 0, sizeof f->center);
    memset(f->plane_normal, 0, sizeof f->plane_normal);
    f->radius = 0;
    for (uint32_t n = f->first; n < f->end; n++)
        for (uint32_t k = 0; k < 3; k++) {
            uint32_t face = f->list[n];
            double p[3];
            corner(f, 3 * face + k, p);
            hatch_vec_add_scaled(f->center, f->area[face], p, f->center);
            hatch_vec_add_scaled(f->plane_normal, f->area[face], &f->normal[3 * (size_t)face], f->plane_normal);
            whole += f->area[face];
        }
    for (int k = 0; k < 3; k++)
        f->center[k] /= whole;
    hatch_vec_normalize(f->plane_normal);
    for (uint32_t n = 3 * f->first; n < 3 * f->end; n++) {
        double p[3];
        if (!agrees(f, f->plane_normal, f->list[n / 3]))
            return false;
        corner(f, 3 * f->list[n / 3] + n % 3, p);
        hatch_vec_sub(p, f->center, p);
        farthest = fmax(farthest, fabs(hatch_vec_dot(p, f->plane_normal)));
        f->radius = fmax(f->radius, hatch_vec_length(p));
    }
    return farthest <= FLATNESS * f->radius + ROUNDING * f->extent;
}

/* Returns the cosine of the angle between the faces at a side, -1 at a border. */
static double cosine_at(const struct finder *f, uint32_t side)
{
    uint32_t partner = f->w->partner[side];
    return partner == HATCH_NO_EDGE
               ? -1
               : hatch_vec_dot(&f->normal[3 * (size_t)(side / 3)], &f->normal[3 * (size_t)(partner / 3)]);
}

static bool is_border(const struct finder *f, uint32_t side)
{
    uint32_t partner = f->w->partner[side];
    return partner == HATCH_NO_EDGE || f->w->plane[partner / 3] != f->w->plane[side / 3];
}

enum kind { NO_PLANE, FACET, PLANE };

/* Returns whether hard edges bound the region all round. */
static bool is_hard(const struct finder *f)
{
    for (uint32_t n = 3 * f->first; n < 3 * f->end; n++) {
        uint32_t side = 3 * f->list[n / 3] + n % 3;
        if (is_border(f, side) && !(cosine_at(f, side) < HARD_COSINE))
            return false;
    }
    return true;
}

static double length_of(const struct finder *f, uint32_t side)
{
    double p[2][3];
    corner(f, side, p[0]);
    corner(f, hatch_side_end(side), p[1]);
    return hatch_vec_distance(p[0], p[1]);
}

/* Returns what the region is: a plane where it is large, has a point inside, and is bounded by creases or is wide:
 * where a curved surface changes the sense of its curvature, strips look flat. Where hard edges bound it all round it
 * is a plane, too, or a facet if it is no larger than what noise makes. */
static enum kind kind_of(struct finder *f, uint32_t region)
{
    uint32_t borders = 0, points = 0;
    double area = 0, border = 0, crease = 0;
    for (uint32_t n = 3 * f->first; n < 3 * f->end; n++) {
        uint32_t side = 3 * f->list[n / 3] + n % 3;
        const uint32_t ends[2] = {f->w->point[side], f->w->point[hatch_side_end(side)]};
        area += f->area[side / 3] / 3;
        points += f->inside[ends[0]] != region + 1;
        f->inside[ends[0]] = region + 1;
        if (!is_border(f, side))
            continue;
        double length = length_of(f, side);
        border += length;
        crease += cosine_at(f, side) <= CREASE_COSINE ? length : 0;
        for (int k = 0; k < 2; k++) {
            borders += f->border[ends[k]] != region + 1;
            f->border[ends[k]] = region + 1;
        }
    }
    bool bounded = crease >= CREASE_MIN * border || area >= WIDTH_MIN * sqrt(f->mean_area) * f->radius;
    if (f->end - f->first >= FACES_MIN && points > borders && area >= AREA_MIN * f->mean_area && bounded)
        return PLANE;
    if (!is_hard(f))
        return NO_PLANE;
    return f->end - f->first >= SURE_FACES || area >= SURE_AREA * f->mean_area ? PLANE : FACET;
}

/* Drops the facets of components that do not mostly consist of planes and facets: noise makes hard edges, too. */
static enum hatch_status drop_facets(struct finder *f, struct hatch_err *err)
{
    struct hatch_surface_work *w = f->w;
    double *whole, *flat;
    uint32_t *number; /* per plane: its number afterwards */
    HATCH_TRY(HATCH_ALLOC(w->scratch, &whole, w->component_count, err));
    HATCH_TRY(HATCH_ALLOC(w->scratch, &flat, w->component_count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(w->scratch, &number, (size_t)w->plane_count + 1, err));
    for (uint32_t face = 0; face < w->mesh->face_count; face++)
        if (!w->dropped[face]) {
            whole[w->component[face]] += f->area[face];
            flat[w->component[face]] += w->plane[face] != HATCH_NO_SIDE ? f->area[face] : 0;
        }
    memset(number, 0xff, w->plane_count * sizeof *number);
    uint32_t kept = 0;
    for (uint32_t face = 0; face < w->mesh->face_count; face++) {
        uint32_t plane = w->plane[face], c = w->component[face];
        if (plane == HATCH_NO_SIDE)
            continue;
        if (number[plane] == HATCH_NO_SIDE && (!f->is_facet[plane] || flat[c] >= FLAT_MIN * whole[c])) {
            hatch_vec_copy(&w->plane_direction[3 * (size_t)plane], &w->plane_direction[3 * (size_t)kept]);
            number[plane] = kept++;
        }
        w->plane[face] = number[plane];
    }
    w->plane_count = kept;
    return HATCH_OK;
}

/* Finds the direction in which most of the border runs; where none has a tenth of it, as around a disc, the coordinate
 * axis nearest to the plane. Of equal ones, that nearest to this axis. */
static void find_direction(const struct finder *f, double direction[3])
{
    double length[BINS] = {0}, sums[BINS][2] = {{0}}, whole = 0, across[3], best = 0;
    int axis = 0;
    for (int k = 1; k < 3; k++)
        if (fabs(f->plane_normal[k]) < 0.999 * fabs(f->plane_normal[axis]))
            axis = k;
    const double along[3] = {axis == 0, axis == 1, axis == 2};
    hatch_vec_add_scaled(along, -hatch_vec_dot(along, f->plane_normal), f->plane_normal, direction);
    hatch_vec_normalize(direction);
    hatch_vec_cross(f->plane_normal, direction, across);
    for (uint32_t n = 3 * f->first; n < 3 * f->end; n++) {
        uint32_t side = 3 * f->list[n / 3] + n % 3;
        double p[2][3], edge[3];
        if (!is_border(f, side))
            continue;
        corner(f, side, p[0]);
        corner(f, hatch_side_end(side), p[1]);
        hatch_vec_sub(p[1], p[0], edge);
        double x = hatch_vec_dot(edge, direction), y = hatch_vec_dot(edge, across), size = sqrt(x * x + y * y);
        double turn = atan2(y, x) / 3.14159265358979323846;
        uint32_t bin = (uint32_t)floor((turn - floor(turn)) * BINS + 0.5) % BINS;
        whole += size;
        length[bin] += size;
        sums[bin][0] += size > 0 ? (x * x - y * y) / size : 0;
        sums[bin][1] += size > 0 ? 2 * x * y / size : 0;
    }
    double angle_rad = 0;
    for (uint32_t b = 0; b < BINS; b++) {
        uint32_t next = (b + 1) % BINS, last = (b + BINS - 1) % BINS;
        double here = length[last] + length[b] + length[next];
        if (!(length[b] > 0) || here < STRAIGHT_MIN * whole || !(here > 1.001 * best))
            continue;
        best = here;
        angle_rad = atan2(sums[last][1] + sums[b][1] + sums[next][1], sums[last][0] + sums[b][0] + sums[next][0]) / 2;
    }
    for (int k = 0; k < 3; k++)
        direction[k] = cos(angle_rad) * direction[k] + sin(angle_rad) * across[k];
}

/* Cuts the creases around planes. Returns whether there were any. */
static bool cut_creases(const struct finder *f)
{
    bool any = false;
    for (uint32_t side = 0; side < 3 * f->w->mesh->face_count; side++) {
        uint32_t partner = f->w->partner[side], here = f->w->plane[side / 3];
        if (partner == HATCH_NO_EDGE || (here == HATCH_NO_SIDE && f->w->plane[partner / 3] == HATCH_NO_SIDE) ||
            cosine_at(f, side) > CREASE_COSINE)
            continue;
        f->w->partner[side] = f->w->partner[partner] = HATCH_NO_EDGE;
        any = true;
    }
    return any;
}

/* Lists the faces that are kept, body by body. */
static enum hatch_status sort_by_body(struct finder *f, const uint32_t *body_of, uint32_t bodies, struct hatch_err *err)
{
    const struct hatch_surface_work *w = f->w;
    uint32_t *first;
    HATCH_TRY(HATCH_ALLOC_UNSET(w->scratch, &f->sorted, w->mesh->face_count, err));
    HATCH_TRY(HATCH_ALLOC(w->scratch, &first, (size_t)bodies + 1, err));
    f->sorted_count = 0;
    for (uint32_t face = 0; face < w->mesh->face_count; face++)
        if (!w->dropped[face])
            first[body_of[face] + 1]++;
    for (uint32_t b = 0; b < bodies; b++)
        first[b + 1] += first[b];
    for (uint32_t face = 0; face < w->mesh->face_count; face++)
        if (!w->dropped[face])
            f->sorted[first[body_of[face]]++] = face;
    f->sorted_count = bodies > 0 ? first[bodies - 1] : 0;
    return HATCH_OK;
}

/* Numbers the components anew: body by body, in the order of their first faces. */
static enum hatch_status number_components(struct finder *f, struct hatch_err *err)
{
    struct hatch_surface_work *w = f->w;
    uint32_t faces = w->mesh->face_count, bodies = w->component_count, *body_of = w->component;
    HATCH_TRY(HATCH_ALLOC_UNSET(w->scratch, &w->component, faces, err));
    HATCH_TRY(HATCH_ALLOC(w->scratch, &w->body, faces, err));
    memset(w->component, 0xff, faces * sizeof *w->component);
    w->component_count = 0;
    HATCH_TRY(sort_by_body(f, body_of, bodies, err));
    for (uint32_t i = 0; i < f->sorted_count; i++) {
        uint32_t seed = f->sorted[i], end = 1;
        if (w->component[seed] != UINT32_MAX)
            continue;
        f->list[0] = seed;
        w->component[seed] = w->component_count;
        for (uint32_t next = 0; next < end; next++)
            for (uint32_t side = 3 * f->list[next]; side < 3 * f->list[next] + 3; side++) {
                uint32_t other = w->partner[side] == HATCH_NO_EDGE ? seed : w->partner[side] / 3;
                if (w->component[other] != UINT32_MAX)
                    continue;
                w->component[other] = w->component_count;
                f->list[end++] = other;
            }
        w->body[w->component_count++] = body_of[seed];
    }
    return HATCH_OK;
}

static enum hatch_status allocate(struct finder *f, struct hatch_err *err)
{
    struct hatch_surface_work *w = f->w;
    uint32_t faces = w->mesh->face_count;
    HATCH_TRY(HATCH_ALLOC(w->scratch, &f->normal, 3 * (size_t)faces, err));
    HATCH_TRY(HATCH_ALLOC(w->scratch, &f->area, faces, err));
    HATCH_TRY(HATCH_ALLOC(w->scratch, &f->list, faces, err));
    HATCH_TRY(HATCH_ALLOC(w->scratch, &f->inside, w->position_count, err));
    HATCH_TRY(HATCH_ALLOC(w->scratch, &f->border, w->position_count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(w->scratch, &w->plane, faces, err));
    memset(w->plane, 0xff, faces * sizeof *w->plane);
    return HATCH_OK;
}

/* Makes the region a plane. */
static enum hatch_status add_plane(struct finder *f, enum kind kind, struct hatch_err *err)
{
    struct hatch_surface_work *w = f->w;
    uint32_t before = f->capacity;
    if (w->plane_count == before) {
        double *direction = w->plane_direction;
        bool *is_facet = f->is_facet;
        f->capacity = before > 0 ? 2 * before : 64;
        HATCH_TRY(HATCH_ALLOC_UNSET(w->scratch, &w->plane_direction, 3 * (size_t)f->capacity, err));
        HATCH_TRY(HATCH_ALLOC_UNSET(w->scratch, &f->is_facet, f->capacity, err));
        if (before > 0) {
            memcpy(w->plane_direction, direction, 3 * before * sizeof *direction);
            memcpy(f->is_facet, is_facet, before * sizeof *is_facet);
        }
    }
    find_direction(f, &w->plane_direction[3 * (size_t)w->plane_count]);
    f->is_facet[w->plane_count] = kind == FACET;
    for (uint32_t n = f->first; n < f->end; n++)
        w->plane[f->list[n]] = w->plane_count;
    w->plane_count++;
    return HATCH_OK;
}

enum hatch_status hatch_surface_find_planes(struct hatch_surface_work *w, struct hatch_err *err)
{
    struct finder f = {.w = w};
    HATCH_TRY(allocate(&f, err));
    find_normals(&f);
    /* Regions have numbers from face_count on until they turn out to be planes; the others lose them at the end, so as
     * not to be grown again. */
    uint32_t tried = 0;
    for (uint32_t face = 0; face < w->mesh->face_count; face++) {
        if (w->dropped[face] || w->plane[face] != HATCH_NO_SIDE)
            continue;
        uint32_t region = w->mesh->face_count + tried++;
        grow(&f, face, region);
        bool candidate = f.end - f.first >= FACES_MIN || is_hard(&f);
        enum kind kind = candidate && is_flat(&f) ? kind_of(&f, region) : NO_PLANE;
        if (kind != NO_PLANE)
            HATCH_TRY(add_plane(&f, kind, err));
    }
    for (uint32_t face = 0; face < w->mesh->face_count; face++)
        if (w->plane[face] >= w->mesh->face_count)
            w->plane[face] = HATCH_NO_SIDE;
    HATCH_TRY(drop_facets(&f, err));
    return w->plane_count > 0 && cut_creases(&f) ? number_components(&f, err) : HATCH_OK;
}
