/* The outline and the depth steps of a triangle mesh in a picture, found by drawing its faces on the processor, without
 * libhatch/line or OpenGL; and the agreement of a picture of lines with them. */
#ifndef HATCH_TEST_OUTLINE_TRUTH_H
#define HATCH_TEST_OUTLINE_TRUTH_H

#include <math.h>
#include <string.h>

#include "image/image.h"
#include "math/vector.h"
#include "mesh/mesh.h"
#include "run.h"
#include "view/view.h"

#define TRUTH_SIDE 3       /* samples along a pixel's side */
#define TRUTH_STEP_PX 4.0  /* deeper steps must have a line */
#define TRUTH_TRACE_PX 0.5 /* shallower steps must not have one; depths count in pixels at their distance */
#define TRUTH_INK 0.4f     /* least ink of a pixel that a line one pixel wide crosses */

enum { TRUTH_OUTLINE = 1, TRUTH_STEP = 2, TRUTH_TRACE = 4 };

struct outline_truth {
    uint32_t width, height; /* samples */
    double pixel;           /* size of a pixel at distance 1, in units of the scene; orthographic: anywhere */
    bool orthographic;
    const struct hatch_mesh *mesh;
    int8_t *turned;  /* per face: sign of its area in the picture */
    uint32_t *face;  /* per sample: its face + 1; 0: none */
    double *near;    /* per sample: nearness, which is linear in the picture: 1 / depth, or -depth if orthographic */
    double *planes;  /* per face: nearness is planes[0] x + planes[1] y + planes[2] */
    uint8_t *border; /* per sample: what lies between it and its right or upper neighbour, as bits */
};

/* Agreement of lines with the truth, in samples and in pixels. */
struct outline_score {
    size_t outline, outline_missed; /* samples at the border of the background; those without a line within 2 px */
    size_t steps, steps_missed;     /* the same at steps of TRUTH_STEP_PX and more */
    size_t lines, lines_off;        /* pixels with ink; those farther than 2 px from any outline or step */
};

static inline void truth_plane(double p[3][3], double plane[3])
{
    double ax = p[1][0] - p[0][0], ay = p[1][1] - p[0][1], bx = p[2][0] - p[0][0], by = p[2][1] - p[0][1];
    double az = p[1][2] - p[0][2], bz = p[2][2] - p[0][2], area = ax * by - ay * bx;
    plane[0] = (az * by - ay * bz) / area;
    plane[1] = (ax * bz - az * bx) / area;
    plane[2] = p[0][2] - plane[0] * p[0][0] - plane[1] * p[0][1];
}

static inline double truth_at(const struct outline_truth *truth, uint32_t face, double x, double y)
{
    const double *plane = &truth->planes[3 * (size_t)(face - 1)];
    return plane[0] * x + plane[1] * y + plane[2];
}

/* Draws a face whose corners are given in samples, with their nearness. */
static inline void truth_draw(struct outline_truth *truth, uint32_t face, double p[3][3])
{
    double low[2], high[2];
    truth_plane(p, &truth->planes[3 * (size_t)face]);
    double area = (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
    truth->turned[face] = (int8_t)((area > 0) - (area < 0));
    for (int k = 0; k < 2; k++) {
        low[k] = fmin(p[0][k], fmin(p[1][k], p[2][k]));
        high[k] = fmax(p[0][k], fmax(p[1][k], p[2][k]));
    }
    for (double y = fmax(ceil(low[1] - 0.5), 0); y + 0.5 <= high[1] && y < truth->height; y++)
        for (double x = fmax(ceil(low[0] - 0.5), 0); x + 0.5 <= high[0] && x < truth->width; x++) {
            bool inside = area != 0;
            for (int i = 0; i < 3 && inside; i++) {
                const double *a = p[i], *b = p[(i + 1) % 3];
                inside = ((b[0] - a[0]) * (y + 0.5 - a[1]) - (b[1] - a[1]) * (x + 0.5 - a[0])) * area >= 0;
            }
            size_t at = (size_t)y * truth->width + (size_t)x;
            double near = truth_at(truth, face + 1, x + 0.5, y + 0.5);
            if (!inside || (truth->face[at] && near <= truth->near[at]))
                continue;
            truth->face[at] = face + 1;
            truth->near[at] = near;
        }
}

/* Returns the depth of the step between two neighbouring samples, in pixels: 0 if the planes of their faces meet
 * between them.
 *   explained  out: step that a narrow face between the two might explain, with the slopes of both */
static inline double truth_step(const struct outline_truth *truth, const uint32_t faces[2], const double at[2][2],
                                double *explained)
{
    double gap[2], depth[2][2], least = INFINITY, slopes = 0;
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 2; k++) {
            double near = truth_at(truth, faces[k], at[i][0], at[i][1]);
            depth[i][k] = truth->orthographic ? -near : 1 / near;
        }
        gap[i] = depth[i][0] - depth[i][1];
        least = fmin(least, fabs(gap[i]) / (truth->orthographic ? 1 : fmin(depth[i][0], depth[i][1])));
    }
    for (int k = 0; k < 2; k++)
        slopes += fabs(depth[1][k] - depth[0][k]) / (truth->orthographic ? 1 : fmin(depth[0][k], depth[1][k]));
    *explained = slopes / truth->pixel;
    return gap[0] * gap[1] <= 0 ? 0 : least / truth->pixel;
}

/* Returns how many corners two faces share. */
static inline int truth_shared(const struct hatch_mesh *mesh, uint32_t a, uint32_t b)
{
    int shared = 0;
    for (uint32_t i = 3 * a; i < 3 * a + 3; i++)
        for (uint32_t k = 3 * b; k < 3 * b + 3; k++)
            shared += memcmp(&mesh->attributes[0].data[3 * (size_t)mesh->indices[i]],
                             &mesh->attributes[0].data[3 * (size_t)mesh->indices[k]], 12) == 0;
    return shared;
}

/* Returns whether a face too narrow to be seen joins two faces: the surface is then steep there, but has no step. */
static inline bool truth_joined(const struct outline_truth *truth, uint32_t a, uint32_t b)
{
    const struct hatch_mesh *mesh = truth->mesh;
    if (!truth_shared(mesh, a, b))
        return false;
    for (uint32_t f = 0; f < mesh->face_count; f++)
        if (truth->turned[f] == truth->turned[a] && truth->turned[f] == truth->turned[b] && f != a && f != b &&
            truth_shared(mesh, f, a) == 2 && truth_shared(mesh, f, b) == 2)
            return true;
    return false;
}

static inline uint8_t truth_between(const struct outline_truth *truth, size_t a, size_t b)
{
    const uint32_t faces[2] = {truth->face[a], truth->face[b]};
    const double at[2][2] = {{(double)(a % truth->width) + 0.5, (double)(a / truth->width) + 0.5},
                             {(double)(b % truth->width) + 0.5, (double)(b / truth->width) + 0.5}};
    if (faces[0] == faces[1])
        return 0;
    if (!faces[0] || !faces[1])
        return TRUTH_OUTLINE;
    double explained, step = truth_step(truth, faces, at, &explained);
    bool deep = step >= TRUTH_STEP_PX + explained && !truth_joined(truth, faces[0] - 1, faces[1] - 1);
    return deep ? TRUTH_STEP : step >= TRUTH_TRACE_PX ? TRUTH_TRACE : 0;
}

/* Finds the outline and the steps of a mesh of the unit scene that lies in front of the eye.
 *   width, height  of the picture, pixels */
static inline void truth_make(const struct hatch_mesh *mesh, const struct hatch_view *view, uint32_t width,
                              uint32_t height, struct hatch_arena *arena, struct outline_truth *truth)
{
    struct hatch_err error;
    size_t samples = (size_t)TRUTH_SIDE * TRUTH_SIDE * width * height;
    *truth = (struct outline_truth){.width = TRUTH_SIDE * width, .height = TRUTH_SIDE * height, .mesh = mesh};
    truth->orthographic = view->orthographic;
    truth->pixel = 2 * view->half_height / height;
    HATCH_TEST_OK(HATCH_ALLOC(arena, &truth->face, samples, &error), &error);
    HATCH_TEST_OK(HATCH_ALLOC(arena, &truth->near, samples, &error), &error);
    HATCH_TEST_OK(HATCH_ALLOC(arena, &truth->border, samples, &error), &error);
    HATCH_TEST_OK(HATCH_ALLOC(arena, &truth->turned, mesh->face_count, &error), &error);
    HATCH_TEST_OK(HATCH_ALLOC(arena, &truth->planes, 3 * (size_t)mesh->face_count, &error), &error);
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        double p[3][3];
        for (int c = 0; c < 3; c++) {
            double at[3], from[3];
            hatch_vec_of(&mesh->attributes[0].data[3 * (size_t)mesh->indices[3 * (size_t)f + (size_t)c]], at);
            hatch_vec_sub(at, view->eye, from);
            double depth = -hatch_vec_dot(from, view->back), scale = view->orthographic ? 1 : depth;
            double x = hatch_vec_dot(from, view->right) / (scale * view->half_height * view->aspect);
            double y = hatch_vec_dot(from, view->up) / (scale * view->half_height);
            p[c][0] = 0.5 * (1 + x) * truth->width;
            p[c][1] = 0.5 * (1 + y) * truth->height;
            p[c][2] = view->orthographic ? -depth : 1 / depth;
        }
        truth_draw(truth, f, p);
    }
    for (size_t i = 0; i < samples; i++) {
        if ((i + 1) % truth->width)
            truth->border[i] |= truth_between(truth, i, i + 1);
        if (i + truth->width < samples)
            truth->border[i] |= truth_between(truth, i, i + truth->width);
    }
}

/* Returns whether a line is within 2 pixels of a place, in pixels from the lower left corner. */
static inline bool truth_has_line(const struct hatch_image *ink, double x, double y)
{
    for (long v = lround(y) - 3; v <= lround(y) + 2; v++)
        for (long u = lround(x) - 3; u <= lround(x) + 2; u++)
            if (u >= 0 && v >= 0 && u < (long)ink->width && v < (long)ink->height &&
                hypot((double)u + 0.5 - x, (double)v + 0.5 - y) <= 2 &&
                ink->pixels[3 * ((ink->height - 1 - (size_t)v) * ink->width + (size_t)u)] >= TRUTH_INK)
                return true;
    return false;
}

/* Returns whether an outline or a step is within 2 pixels of a place. */
static inline bool truth_is_near(const struct outline_truth *truth, double x, double y)
{
    const double reach = 2.0 * TRUTH_SIDE;
    long u0 = lround(x * TRUTH_SIDE), v0 = lround(y * TRUTH_SIDE);
    for (long v = v0 - 7; v <= v0 + 7; v++)
        for (long u = u0 - 7; u <= u0 + 7; u++)
            if (u >= 0 && v >= 0 && u < (long)truth->width && v < (long)truth->height &&
                hypot((double)u + 0.75 - x * TRUTH_SIDE, (double)v + 0.75 - y * TRUTH_SIDE) <= reach &&
                truth->border[(size_t)v * truth->width + (size_t)u])
                return true;
    return false;
}

/* Colours the pixel at a place. */
static inline void truth_color(struct hatch_image *shown, double x, double y, float red, float green, float blue)
{
    size_t column = (size_t)x, row = shown->height - 1 - (size_t)y;
    float *pixel = &shown->pixels[3 * (row * shown->width + column)];
    pixel[0] = red;
    pixel[1] = green;
    pixel[2] = blue;
}

/* Looks for a line at each outline and step, and adds to the score.
 *   ink    picture of lines, one pixel wide: channels R G B, 1: ink
 *   shown  NULL, or coloured where a line is missing: red at the outline, orange at steps */
static inline void truth_find_lines(const struct outline_truth *truth, const struct hatch_image *ink,
                                    struct hatch_image *shown, struct outline_score *score)
{
    for (size_t i = 0; i < (size_t)truth->width * truth->height; i++) {
        if (!(truth->border[i] & (TRUTH_OUTLINE | TRUTH_STEP)))
            continue;
        double x = ((double)(i % truth->width) + 0.75) / TRUTH_SIDE;
        double y = ((double)(i / truth->width) + 0.75) / TRUTH_SIDE;
        bool outline = truth->border[i] & TRUTH_OUTLINE, has = truth_has_line(ink, x, y);
        score->outline += outline;
        score->outline_missed += outline && !has;
        score->steps += !outline;
        score->steps_missed += !outline && !has;
        if (shown && !has)
            truth_color(shown, x, y, 1, outline ? 0 : 0.3f, 0);
    }
}

/* Looks for an outline or a step at each pixel of a line, and adds to the score.
 *   ink, shown  as above; blue where there is none */
static inline void truth_check_lines(const struct outline_truth *truth, const struct hatch_image *ink,
                                     struct hatch_image *shown, struct outline_score *score)
{
    for (size_t i = 0; i < (size_t)ink->width * ink->height; i++) {
        double x = (double)(i % ink->width) + 0.5, y = (double)ink->height - 0.5 - (double)(i / ink->width);
        if (ink->pixels[3 * i] < TRUTH_INK)
            continue;
        bool off = !truth_is_near(truth, x, y);
        score->lines++;
        score->lines_off += off;
        if (shown && off)
            truth_color(shown, x, y, 0, 0.2f, 1);
    }
}

#endif
