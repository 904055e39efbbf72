/* Checks for all surfaces: surface_check fails unless a surface has the properties that every surface must have. */
#ifndef HATCH_TEST_SURFACE_CHECK_H
#define HATCH_TEST_SURFACE_CHECK_H

#include <math.h>
#include <string.h>

#include "math/vector.h"
#include "run.h"
#include "surface/surface.h"

static inline uint32_t surface_side_end(uint32_t side)
{
    return side % 3 == 2 ? side - 2 : side + 1;
}

/* Checks that opposite sides refer to each other, join the same points, and have opposite directions on orientable
 * components. */
static inline void surface_check_opposites(const struct hatch_surface *s)
{
    for (uint32_t side = 0; side < 3 * s->face_count; side++) {
        uint32_t other = s->opposite[side];
        if (other == HATCH_NO_SIDE)
            continue;
        uint32_t a = s->corners[side], b = s->corners[surface_side_end(side)];
        uint32_t c = s->corners[other], d = s->corners[surface_side_end(other)];
        ck_assert_uint_lt(other, 3 * s->face_count);
        ck_assert_uint_ne(other / 3, side / 3);
        ck_assert_uint_eq(s->opposite[other], side);
        ck_assert((a == d && b == c) || (a == c && b == d));
        ck_assert(a == d || !s->components[s->point_component[a]].orientable);
    }
}

static inline uint32_t surface_corner_of(const struct hatch_surface *s, uint32_t face, uint32_t point)
{
    for (uint32_t c = 0; c < 3; c++)
        if (s->corners[3 * face + c] == point)
            return c;
    ck_abort_msg("point %u is no corner of face %u", point, face);
    return 0;
}

/* Checks that the ring of a point contains each of its corners once; that each face lies between its two neighbours,
 * counter-clockwise from the first to the second unless flipped; and that an open ring begins and ends on the
 * border. */
static inline void surface_check_ring(const struct hatch_surface *s, uint32_t p, uint32_t corner_count)
{
    uint32_t first = s->ring_first[p], count = s->ring_first[p + 1] - first, faces = 0;
    ck_assert_uint_ge(count, 2);
    for (uint32_t i = 0; i < count; i++) {
        uint32_t face = s->ring_face[first + i];
        uint32_t q = s->ring_point[first + i], next = s->ring_point[first + (i + 1) % count];
        if (face == HATCH_NO_SIDE) {
            ck_assert_uint_eq(i, count - 1);
            continue;
        }
        faces++;
        uint32_t c = surface_corner_of(s, face, p);
        uint32_t after = s->corners[3 * face + (c + 1) % 3], before = s->corners[3 * face + (c + 2) % 3];
        bool flipped = s->ring_flipped[first + i];
        ck_assert_uint_eq(q, flipped ? before : after);
        ck_assert_uint_eq(next, flipped ? after : before);
        ck_assert(!flipped || !s->components[s->point_component[p]].orientable);
    }
    ck_assert_uint_eq(faces, corner_count);
    ck_assert(count == faces || s->ring_face[first + count - 1] == HATCH_NO_SIDE);
}

/* Checks that ring_turned is the same at both ends of an edge. */
static inline void surface_check_turned(const struct hatch_surface *s, uint32_t p)
{
    for (uint32_t i = s->ring_first[p]; i < s->ring_first[p + 1]; i++) {
        uint32_t q = s->ring_point[i], back = 0, same = 0;
        for (uint32_t k = s->ring_first[q]; k < s->ring_first[q + 1]; k++) {
            back += s->ring_point[k] == p;
            same += s->ring_point[k] == p && s->ring_turned[k] == s->ring_turned[i];
        }
        ck_assert_uint_ge(back, 1);
        ck_assert_uint_ge(same, 1);
        ck_assert(!s->ring_turned[i] || !s->components[s->point_component[p]].orientable);
    }
}

/* Checks that the points and faces of components are consecutive, and that their scale and topology are those of their
 * faces. */
static inline void surface_check_components(const struct hatch_surface *s)
{
    uint32_t point = 0, face = 0;
    for (uint32_t c = 0; c < s->component_count; c++) {
        const struct hatch_component *part = &s->components[c];
        double sum = 0;
        uint32_t sides = 0, borders = 0;
        ck_assert_uint_eq(part->first_point, point);
        ck_assert_uint_eq(part->first_face, face);
        ck_assert(part->scale > 0 && isfinite(part->scale));
        for (; face < part->first_face + part->face_count; face++)
            for (uint32_t k = 0; k < 3; k++) {
                uint32_t a = s->corners[3 * face + k], b = s->corners[3 * face + (k + 1) % 3];
                bool border = s->opposite[3 * face + k] == HATCH_NO_SIDE;
                ck_assert_uint_ne(a, b);
                ck_assert_uint_eq(s->point_component[a], c);
                sum += hatch_vec_distance(&s->points[3 * a], &s->points[3 * b]) * (border ? 2 : 1);
                sides++;
                borders += border;
            }
        double middle[3][2] = {{0}};
        for (point = part->first_point; point < part->first_point + part->point_count; point++)
            for (int k = 0; k < 3; k++) {
                ck_assert(isfinite(s->points[3 * point + (uint32_t)k]));
                middle[k][0] = fmin(middle[k][0], s->points[3 * point + (uint32_t)k]);
                middle[k][1] = fmax(middle[k][1], s->points[3 * point + (uint32_t)k]);
            }
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq_tol(middle[k][0], -middle[k][1], 1e-9);
        uint32_t edges = (sides + borders) / 2;
        ck_assert_double_eq_tol(sum / (sides + borders), 1, 1e-9);
        ck_assert_int_eq(part->euler, (int)(part->point_count - edges + part->face_count));
        ck_assert_uint_le(part->border_loops, borders / 2);
        ck_assert((part->border_loops == 0) == (borders == 0));
    }
    ck_assert_uint_eq(point, s->point_count);
    ck_assert_uint_eq(face, s->face_count);
}

/* Checks that corners are those of the mesh, flipped or not, and that points have the positions of the mesh's
 * vertices. */
static inline void surface_check_source(const struct hatch_mesh *mesh, const struct hatch_surface *s)
{
    double place[3], want[3];
    for (uint32_t f = 0; f < s->face_count; f++) {
        const uint32_t *from = &mesh->indices[3 * s->face_source[f]], *to = &s->corner_vertex[3 * f];
        ck_assert_uint_eq(to[0], from[0]);
        ck_assert((to[1] == from[1] && to[2] == from[2]) || (to[1] == from[2] && to[2] == from[1]));
        for (uint32_t c = 0; c < 3; c++) {
            uint32_t p = s->corners[3 * f + c];
            hatch_vec_of(&mesh->attributes[0].data[3 * to[c]], want);
            hatch_surface_position(s, p, place);
            double size = hatch_vec_length(want) + s->components[s->point_component[p]].scale;
            ck_assert_double_le(hatch_vec_distance(place, want), 1e-12 * size);
        }
    }
}

static inline void surface_check(const struct hatch_mesh *mesh, const struct hatch_surface *s)
{
    uint32_t *corners = calloc(s->point_count, sizeof *corners);
    ck_assert_ptr_nonnull(corners);
    for (uint32_t i = 0; i < 3 * s->face_count; i++) {
        ck_assert_uint_lt(s->corners[i], s->point_count);
        corners[s->corners[i]]++;
    }
    surface_check_source(mesh, s);
    surface_check_opposites(s);
    surface_check_components(s);
    for (uint32_t p = 0; p < s->point_count; p++) {
        surface_check_ring(s, p, corners[p]);
        surface_check_turned(s, p);
    }
    free(corners);
}

static struct hatch_surface_notes notes;

/* Makes and checks the surface of a mesh; sets notes. */
static inline struct hatch_surface surface_of(const struct hatch_mesh *mesh)
{
    struct hatch_surface surface;
    HATCH_TEST_OK(hatch_surface_make(mesh, &keep, &scratch, &surface, &notes, &err), &err);
    surface_check(mesh, &surface);
    return surface;
}

#endif
