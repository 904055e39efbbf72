/* Rims: lines at which the surface turns, and that long faces on one side end at, as the side of a cylinder does at its
 * chamfer. The points that a fit sees there lie on rims, so that it shows how the surface turns at them, not how the
 * long faces bend. */
#include <math.h>

#include "curvature/bending.h"
#include "curvature/curvature.h"
#include "math/vector.h"

#define TURN_RAD 0.09        /* smallest dihedral angle of a rim */
#define REACH_RATIO 2.75     /* smallest ratio of the reaches of both sides */
#define REACH_FACES_MAX 16u  /* that are gone through to find a reach */
#define RIM_POINTS_MIN 8     /* connected: the edge of a cap of eight sides */
#define STRAIGHT_COSINE -0.3 /* largest, of the angle between the two edges of a rim at a point */

struct rims {
    const struct hatch_surface *surface;
    double *normals; /* 3 per face: unit */
    int8_t *edge;    /* per ring entry: 1 where its edge is one of a rim and the faces before it, -1 where those after
                        it are the long ones; else 0 */
    bool *point;     /* per point: whether it is on a rim */
    bool *left_out;  /* per ring entry: whether its edge does not tell how the long faces bend */
};

/* Returns the greatest distance from a line that a face and the faces in its plane around it reach, as far as they are
 * gone through: the diagonals and rows into which a plane part is divided do not matter.
 *   from, along  a point of the line, and its unit direction */
static double reach_of(const struct rims *r, uint32_t face, const double from[3], const double along[3])
{
    const struct hatch_surface *surface = r->surface;
    const double *normal = &r->normals[3 * (size_t)face], flat_cosine = cos(HATCH_BENDING_HALF_RAD);
    uint32_t queue[REACH_FACES_MAX] = {face}, count = 1;
    double square = 0;
    for (uint32_t next = 0; next < count; next++)
        for (uint32_t side = 3 * queue[next]; side < 3 * queue[next] + 3; side++) {
            double offset[3], across[3];
            hatch_vec_sub(&surface->points[3 * (size_t)surface->corners[side]], from, offset);
            hatch_vec_add_scaled(offset, -hatch_vec_dot(offset, along), along, across);
            square = fmax(square, hatch_vec_dot(across, across));
            uint32_t other = surface->opposite[side] == HATCH_NO_SIDE ? face : surface->opposite[side] / 3, known = 0;
            while (known < count && queue[known] != other)
                known++;
            if (known == count && count < REACH_FACES_MAX &&
                fabs(hatch_vec_dot(normal, &r->normals[3 * (size_t)other])) > flat_cosine)
                queue[count++] = other;
        }
    return sqrt(square);
}

/* Returns r->edge of ring entry i of a point, whose edge lies between the faces of entries `before` and i. */
static int8_t side_of_rim(const struct rims *r, uint32_t point, uint32_t before, uint32_t i)
{
    const struct hatch_surface *surface = r->surface;
    uint32_t faces[2] = {surface->ring_face[before], surface->ring_face[i]};
    if (faces[0] == HATCH_NO_SIDE || faces[1] == HATCH_NO_SIDE)
        return 0;
    double cosine = hatch_vec_dot(&r->normals[3 * (size_t)faces[0]], &r->normals[3 * (size_t)faces[1]]);
    cosine = surface->ring_flipped[before] == surface->ring_flipped[i] ? cosine : -cosine;
    if (!(cosine < cos(TURN_RAD)))
        return 0;
    const double *from = &surface->points[3 * (size_t)point];
    double along[3];
    hatch_vec_sub(&surface->points[3 * (size_t)surface->ring_point[i]], from, along);
    hatch_vec_normalize(along);
    double a = reach_of(r, faces[0], from, along), b = reach_of(r, faces[1], from, along);
    return a > REACH_RATIO * b ? 1 : b > REACH_RATIO * a ? -1 : 0;
}

/* Whether a rim goes on straight through a point, along two edges, with several faces on its short side: two edges of
 * an obtuse sliver are no rim. At a border it has one edge. */
static bool is_on_rim(const struct rims *r, uint32_t point)
{
    const struct hatch_surface *surface = r->surface;
    uint32_t first = surface->ring_first[point], end = surface->ring_first[point + 1], edges[2], count = 0;
    double line[2][3];
    for (uint32_t i = first; i < end; i++) {
        if (r->edge[i] == 0)
            continue;
        if (count == 2)
            return false;
        hatch_vec_sub(&surface->points[3 * (size_t)surface->ring_point[i]], &surface->points[3 * (size_t)point],
                      line[count]);
        hatch_vec_normalize(line[count]);
        edges[count++] = i;
    }
    if (count < 2)
        return count == 1 && surface->ring_face[end - 1] == HATCH_NO_SIDE;
    uint32_t between = edges[1] - edges[0], faces = r->edge[edges[0]] > 0 ? between : end - first - between;
    return r->edge[edges[0]] + r->edge[edges[1]] == 0 && faces > 1 && hatch_vec_dot(line[0], line[1]) < STRAIGHT_COSINE;
}

/* Drops rims of few points, which are those of slivers.
 *   queue  for a number per point
 *   seen   per point: false */
static void drop_short_rims(const struct rims *r, uint32_t *queue, bool *seen)
{
    const struct hatch_surface *surface = r->surface;
    for (uint32_t p = 0; p < surface->point_count; p++) {
        uint32_t count = 0;
        if (r->point[p] && !seen[p])
            queue[count++] = p;
        for (uint32_t next = 0; next < count; next++) {
            seen[queue[next]] = true;
            for (uint32_t i = surface->ring_first[queue[next]]; i < surface->ring_first[queue[next] + 1]; i++) {
                uint32_t q = surface->ring_point[i];
                if (r->edge[i] == 0 || !r->point[q] || seen[q])
                    continue;
                seen[q] = true;
                queue[count++] = q;
            }
        }
        for (uint32_t i = 0; count < RIM_POINTS_MIN && i < count; i++)
            r->point[queue[i]] = false;
    }
}

/* Returns whether there are points that may be on a rim.
 *   twin  of the frames */
static bool find_rims(const struct rims *r, const uint32_t *twin)
{
    bool any = false;
    const struct hatch_surface *surface = r->surface;
    for (uint32_t f = 0; f < surface->face_count; f++) {
        hatch_surface_face_normal(surface, f, &r->normals[3 * (size_t)f]);
        hatch_vec_normalize(&r->normals[3 * (size_t)f]);
    }
    for (uint32_t p = 0; p < surface->point_count; p++) {
        uint32_t first = surface->ring_first[p], end = surface->ring_first[p + 1];
        for (uint32_t i = first; i < end; i++) {
            if (surface->ring_point[i] < p)
                continue;
            r->edge[i] = side_of_rim(r, p, i > first ? i - 1 : end - 1, i);
            r->edge[twin[i]] = surface->ring_turned[i] ? r->edge[i] : (int8_t)-r->edge[i];
        }
    }
    for (uint32_t p = 0; p < surface->point_count; p++) {
        r->point[p] = is_on_rim(r, p);
        any = any || r->point[p];
    }
    return any;
}

/* Whether all faces at a point have a corner on a rim. */
static bool is_within_rims(const struct rims *r, uint32_t point)
{
    const struct hatch_surface *surface = r->surface;
    for (uint32_t i = surface->ring_first[point]; i < surface->ring_first[point + 1]; i++) {
        uint32_t first = surface->ring_face[i] == HATCH_NO_SIDE ? HATCH_NO_SIDE : 3 * surface->ring_face[i];
        bool on_rim = first == HATCH_NO_SIDE;
        for (uint32_t c = first; !on_rim && c < first + 3; c++)
            on_rim = r->point[surface->corners[c]];
        if (!on_rim)
            return false;
    }
    return true;
}

/* Leaves out the edges of rims at a point and, if wanted, those on the short side of its rim. Returns whether the short
 * side reaches from rim to rim, as a chamfer does. */
static bool leave_out(const struct rims *r, uint32_t point, bool short_side)
{
    uint32_t first = r->surface->ring_first[point], end = r->surface->ring_first[point + 1];
    int8_t last = 0; /* of the edges of rims, from which the present one is counter-clockwise */
    bool strip = true;
    for (uint32_t i = first; i < end && last == 0; i++)
        last = (int8_t)-r->edge[i];
    for (uint32_t i = first; i < end; i++) {
        bool inside = r->point[point] && r->edge[i] == 0 && last > 0;
        strip = strip && !(inside && !r->point[r->surface->ring_point[i]]);
        r->left_out[i] = r->edge[i] != 0 || (inside && short_side);
        last = r->edge[i] != 0 ? r->edge[i] : last;
    }
    return strip;
}

/* Replaces the result at a point whose faces all have a corner on a rim: by the bend of the long faces or, where these
 * are flat, by that of a strip from rim to rim. A strip with more rows beyond bends in a way that its edges at the
 * point do not show: nothing is known there. */
static void replace(const struct rims *r, const struct hatch_frames *frames, double crease_rad, uint32_t point,
                    struct hatch_curvature *curvature)
{
    bool strip = leave_out(r, point, true);
    struct hatch_bending bending = hatch_bending_at(r->surface, frames, point, crease_rad, r->left_out);
    if (bending.largest_rad < HATCH_BENDING_HALF_RAD && strip) {
        leave_out(r, point, false);
        bending = hatch_bending_at(r->surface, frames, point, crease_rad, r->left_out);
    }
    if (bending.largest_rad < HATCH_BENDING_HALF_RAD) {
        curvature->confidence[point] = strip ? curvature->confidence[point] : 0;
        return;
    }
    hatch_frames_direction(frames, point, bending.angle_rad, &curvature->direction[3 * (size_t)point]);
    hatch_vec_copy(&frames->normal[3 * (size_t)point], &curvature->normal[3 * (size_t)point]);
    curvature->value[2 * (size_t)point] = 1;
    curvature->value[2 * (size_t)point + 1] = 0;
    curvature->confidence[point] = hatch_bending_confidence(&bending);
}

static enum hatch_status follow(struct rims *r, const struct hatch_frames *frames, double crease_rad,
                                struct hatch_arena *scratch, struct hatch_curvature *curvature, struct hatch_err *err)
{
    uint32_t points = r->surface->point_count, *queue;
    bool *seen;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &r->normals, 3 * (size_t)r->surface->face_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &r->edge, r->surface->ring_first[points], err));
    HATCH_TRY(HATCH_ALLOC(scratch, &r->left_out, r->surface->ring_first[points], err));
    HATCH_TRY(HATCH_ALLOC(scratch, &r->point, points, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &queue, points, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &seen, points, err));
    if (!find_rims(r, frames->twin))
        return HATCH_OK;
    drop_short_rims(r, queue, seen);
    for (uint32_t p = 0; p < points; p++)
        if (is_within_rims(r, p))
            replace(r, frames, crease_rad, p, curvature);
    return HATCH_OK;
}

enum hatch_status hatch_curvature_follow_rims(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                              double crease_rad, struct hatch_arena *scratch,
                                              struct hatch_curvature *curvature, struct hatch_err *err)
{
    struct rims rims = {.surface = surface};
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = follow(&rims, frames, crease_rad, scratch, curvature, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}
