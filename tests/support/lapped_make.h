/* Patches on a surface with a given field, and checks that hold for all of them. */
#ifndef HATCH_TEST_LAPPED_MAKE_H
#define HATCH_TEST_LAPPED_MAKE_H

#include "field_make.h"
#include "lapped/lapped.h"

static const struct hatch_lapped_options LAPPED_DEFAULTS = {
    .curved = 0.5, .stretch_max = 1.5, .turn_max_rad = 0.3, .seed = 1};

struct lapped_case {
    struct field_case field;
    struct hatch_outline outline;
    struct hatch_lapped lapped;
};

static inline struct hatch_lapped_input lapped_input(const struct field_case *field,
                                                     const struct hatch_outline *outline)
{
    return (struct hatch_lapped_input){.surface = &field->surface,
                                       .frames = &field->frames,
                                       .direction = field->direction,
                                       .confidence = field->confidence,
                                       .mesh = &field->mesh,
                                       .outline = outline,
                                       .tile = 1};
}

static inline struct hatch_lapped cover(const struct field_case *field, const struct hatch_outline *outline,
                                        const struct hatch_lapped_options *options)
{
    struct hatch_lapped lapped;
    const struct hatch_lapped_input input = lapped_input(field, outline);
    HATCH_TEST_OK(hatch_lapped_make(&input, options, NULL, &keep, &scratch, &lapped, &err), &err);
    return lapped;
}

static inline struct lapped_case make_lapped(struct field_case field, const struct hatch_lapped_options *options)
{
    struct lapped_case made = {.field = field};
    hatch_outline_make(3, 0.3, 0.05, &made.outline);
    made.lapped = cover(&made.field, &made.outline, options);
    return made;
}

/* Computes the mask coordinates at a point of a patch's face.
 *   entry  index of the face in lapped->faces
 *   bary   barycentric coordinates of the point */
static inline void mask_at(const struct hatch_lapped *lapped, uint32_t patch, uint32_t entry, const double bary[3],
                           double mask[2])
{
    mask[0] = mask[1] = 0;
    for (uint32_t c = 0; c < 3; c++) {
        uint32_t vertex = lapped->patches[patch].first_vertex + lapped->corners[3 * (size_t)entry + c];
        for (int i = 0; i < 2; i++)
            mask[i] += bary[c] * (double)lapped->vertices[vertex].mask[i];
    }
}

/* Returns the largest opacity that the patches from index first on have at a point of a face. */
static inline double largest_opacity(const struct lapped_case *made, uint32_t face, const double bary[3],
                                     uint32_t first)
{
    double most = 0;
    for (uint32_t p = first; p < made->lapped.patch_count; p++) {
        const struct hatch_lapped_patch *patch = &made->lapped.patches[p];
        for (uint32_t e = patch->first_face; e < patch->first_face + patch->face_count; e++) {
            double mask[2];
            if (made->lapped.faces[e] != face)
                continue;
            mask_at(&made->lapped, p, e, bary, mask);
            most = fmax(most, hatch_outline_opacity(&made->outline, mask));
        }
    }
    return most;
}

/* Checks that at random points some patch has opacity 1, up to the rounding of floats. */
static inline void check_covered(const struct lapped_case *made, uint32_t samples)
{
    for (uint32_t i = 0; i < samples; i++) {
        uint32_t face = (uint32_t)(hatch_random_u64(9, 0, i) % made->field.surface.face_count);
        double a = (double)hatch_random_unit(9, 1, i), b = (double)hatch_random_unit(9, 2, i);
        if (a + b > 1) {
            a = 1 - a;
            b = 1 - b;
        }
        const double bary[3] = {a, b, 1 - a - b};
        double opacity = largest_opacity(made, face, bary, 0);
        ck_assert_msg(opacity > 0.9999, "face %u at %g %g has opacity %g", face, a, b, opacity);
    }
}

/* Returns the signed area of a face in hatch coordinates (v rises downwards) divided by its area on the surface. */
static inline double area_ratio(const struct lapped_case *made, uint32_t patch, uint32_t entry)
{
    const struct hatch_lapped *lapped = &made->lapped;
    const struct hatch_lapped_vertex *at[3];
    double p[3][3], normal[3];
    for (uint32_t c = 0; c < 3; c++) {
        at[c] = &lapped->vertices[lapped->patches[patch].first_vertex + lapped->corners[3 * (size_t)entry + c]];
        ck_assert_uint_eq(at[c]->point, made->field.surface.corners[3 * (size_t)lapped->faces[entry] + c]);
        hatch_surface_position(&made->field.surface, at[c]->point, p[c]);
    }
    hatch_vec_triangle(p[0], p[1], p[2], normal);
    double x[2][2];
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++)
            x[i][j] = at[i + 1]->hatch[j] - at[0]->hatch[j];
    return -(x[0][0] * x[1][1] - x[0][1] * x[1][0]) / hatch_vec_length(normal);
}

/* Checks what holds for every surface: counts agree, no face is turned over, all are covered. */
static inline void check_patches(const struct lapped_case *made, uint32_t samples)
{
    const struct hatch_lapped *lapped = &made->lapped;
    uint32_t vertices = 0, faces = 0;
    for (uint32_t p = 0; p < lapped->patch_count; p++) {
        const struct hatch_lapped_patch *patch = &lapped->patches[p];
        ck_assert_uint_eq(patch->first_vertex, vertices);
        ck_assert_uint_eq(patch->first_face, faces);
        ck_assert(patch->radius > 0 && patch->face_count > 0);
        vertices += patch->vertex_count;
        faces += patch->face_count;
        for (uint32_t e = patch->first_face; e < faces; e++) {
            double ratio = area_ratio(made, p, e);
            ck_assert_msg(ratio > 0.01 && ratio < 30, "patch %u: a face has %g times its area", p, ratio);
        }
    }
    ck_assert_uint_eq(vertices, lapped->vertex_count);
    ck_assert_uint_eq(faces, lapped->face_count);
    ck_assert_uint_le(lapped->patch_count, made->field.surface.face_count);
    check_covered(made, samples);
}

#endif
