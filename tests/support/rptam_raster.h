/* Reference for pictures of rptam: a small rasteriser that evaluates Algorithm 2 (Szécsi & Szirányi 2014) in doubles
 * over a mesh in perspective. It shares no code with the renderer's shaders, but follows the same rules: light is
 * computed at vertices; derivatives of the surface with respect to texture coordinates are, per vertex, the
 * area-weighted means over the faces around it; interpolation is perspective-correct. Include after run.h. */
#ifndef HATCH_TEST_RPTAM_RASTER_H
#define HATCH_TEST_RPTAM_RASTER_H

#include <math.h>
#include <string.h>

#include "math/vector.h"
#include "mesh/mesh.h"
#include "view/view.h"
#include "rptam_ink.h"
#include "seed/rptam.h"

/* Values interpolated over a face. */
struct raster_point {
    double along[2][3]; /* derivatives of the position with respect to u and v */
    double uv[2], light;
};

struct raster_vertex {
    struct raster_point point[2]; /* [0]: with the light on the front, [1]: on the back */
    double x, y, w;               /* x, y: pixels; w: distance along the view */
};

struct raster_pixel {
    struct raster_point point;
    double x, y, w; /* w: INFINITY on the background */
};

struct raster {
    const struct hatch_mesh *mesh;
    const struct hatch_view *view;
    uint32_t size; /* pixels along the picture's sides */
    double to_light[3];
    struct raster_vertex *vertices;
    struct raster_pixel *pixels;
};

static inline void raster_span(const struct hatch_mesh *mesh, double (*sums)[7])
{
    const float *position = hatch_mesh_find(mesh, "POSITION", 3), *uv = hatch_mesh_find(mesh, "TEXCOORD_0", 2);
    for (size_t f = 0; f < mesh->face_count; f++) {
        const uint32_t *c = mesh->indices + 3 * f;
        double e[2][3], t[2][2], normal[3];
        for (size_t k = 0; k < 2; k++) {
            for (size_t i = 0; i < 3; i++)
                e[k][i] = (double)position[3 * (size_t)c[k + 1] + i] - (double)position[3 * (size_t)c[0] + i];
            for (size_t i = 0; i < 2; i++)
                t[k][i] = (double)uv[2 * (size_t)c[k + 1] + i] - (double)uv[2 * (size_t)c[0] + i];
        }
        double turn = t[0][0] * t[1][1] - t[0][1] * t[1][0];
        hatch_vec_cross(e[0], e[1], normal);
        double area = hatch_vec_length(normal);
        if (!(fabs(turn) > 1e-7 * hypot(t[0][0], t[0][1]) * hypot(t[1][0], t[1][1])) || !(area > 0))
            continue;
        for (int corner = 0; corner < 3; corner++) {
            double *sum = sums[c[corner]];
            for (int i = 0; i < 3; i++) {
                sum[i] += area * (t[1][1] * e[0][i] - t[0][1] * e[1][i]) / turn;
                sum[3 + i] += area * (t[0][0] * e[1][i] - t[1][0] * e[0][i]) / turn;
            }
            sum[6] += area;
        }
    }
}

static inline void raster_vertices(struct raster *raster, struct hatch_arena *arena)
{
    const struct hatch_mesh *mesh = raster->mesh;
    const struct hatch_view *view = raster->view;
    const float *position = hatch_mesh_find(mesh, "POSITION", 3), *normal = hatch_mesh_find(mesh, "NORMAL", 3);
    const float *uv = hatch_mesh_find(mesh, "TEXCOORD_0", 2);
    struct hatch_err err;
    double *sums = HATCH_NEW(arena, double, 7 * (size_t)mesh->vertex_count, &err);
    raster->vertices = HATCH_NEW(arena, struct raster_vertex, mesh->vertex_count, &err);
    ck_assert_ptr_nonnull(raster->vertices);
    raster_span(mesh, (double(*)[7])sums);
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        struct raster_vertex *to = &raster->vertices[v];
        double at[3], n[3];
        hatch_vec_of(position + 3 * v, at);
        hatch_vec_of(normal + 3 * v, n);
        for (int k = 0; k < 3; k++)
            at[k] -= view->eye[k];
        to->w = -hatch_vec_dot(at, view->back);
        double half = 0.5 * raster->size / (view->half_height * to->w);
        to->x = 0.5 * raster->size + half * hatch_vec_dot(at, view->right);
        to->y = 0.5 * raster->size + half * hatch_vec_dot(at, view->up);
        for (int side = 0; side < 2; side++) {
            struct raster_point *point = &to->point[side];
            memcpy(point->uv, (double[]){(double)uv[2 * v], (double)uv[2 * v + 1]}, sizeof point->uv);
            for (int k = 0; k < 6; k++)
                point->along[k / 3][k % 3] = sums[7 * v + (size_t)k] / sums[7 * v + 6];
            double facing = hatch_vec_dot(n, raster->to_light) / hatch_vec_length(n);
            point->light = fmax(side ? -facing : facing, 0);
        }
    }
}

/* Draws a face at a pixel, unless the pixel is outside it or already shows something nearer. */
static inline void raster_pixel(const struct raster_vertex *const corner[3], struct raster_pixel *pixel)
{
    double weight[3], area = 0, sum = 0;
    for (int k = 0; k < 3; k++) {
        const struct raster_vertex *a = corner[(k + 1) % 3], *b = corner[(k + 2) % 3];
        weight[k] = (a->x - pixel->x) * (b->y - pixel->y) - (a->y - pixel->y) * (b->x - pixel->x);
        area += weight[k];
    }
    for (int k = 0; k < 3; k++) {
        if (weight[k] * area < 0 || area == 0)
            return;
        sum += weight[k] / area / corner[k]->w;
    }
    if (!(1 / sum < pixel->w))
        return;
    const double *from[3];
    double *to = (double *)&pixel->point;
    for (int k = 0; k < 3; k++) {
        from[k] = (const double *)&corner[k]->point[area < 0];
        weight[k] /= area * corner[k]->w * sum;
    }
    for (size_t i = 0; i < sizeof pixel->point / sizeof *to; i++)
        to[i] = weight[0] * from[0][i] + weight[1] * from[1][i] + weight[2] * from[2][i];
    pixel->w = 1 / sum;
}

/* Draws all faces, which must lie in front of the eye. Pixels are stored row by row from the top. */
static inline void raster_draw(struct raster *raster, struct hatch_arena *arena)
{
    struct hatch_err err;
    uint32_t size = raster->size;
    raster_vertices(raster, arena);
    raster->pixels = HATCH_NEW(arena, struct raster_pixel, (size_t)size * size, &err);
    ck_assert_ptr_nonnull(raster->pixels);
    for (uint32_t i = 0; i < size * size; i++)
        raster->pixels[i] = (struct raster_pixel){.x = i % size + 0.5, .y = size - i / size - 0.5, .w = INFINITY};
    for (size_t f = 0; f < raster->mesh->face_count; f++) {
        const struct raster_vertex *corner[3];
        for (size_t k = 0; k < 3; k++)
            corner[k] = &raster->vertices[raster->mesh->indices[3 * f + k]];
        double low = fmin(corner[0]->y, fmin(corner[1]->y, corner[2]->y));
        double high = fmax(corner[0]->y, fmax(corner[1]->y, corner[2]->y));
        double left = fmin(corner[0]->x, fmin(corner[1]->x, corner[2]->x));
        double right = fmax(corner[0]->x, fmax(corner[1]->x, corner[2]->x));
        for (double y = fmax(floor(low), 0); y < fmin(high, size); y++)
            for (double x = fmax(floor(left), 0); x < fmin(right, size); x++)
                raster_pixel(corner, &raster->pixels[(size_t)(size - 1 - y) * size + (size_t)x]);
    }
}

/* Computes the displacement in the picture, in pixels, that belongs to a displacement on the surface. */
static inline void raster_move(const struct raster *raster, const struct raster_pixel *pixel, const double vector[3],
                               double move[2])
{
    const struct hatch_view *view = raster->view;
    double half = 0.5 * raster->size / view->half_height, w = -hatch_vec_dot(vector, view->back);
    double x = (pixel->x - 0.5 * raster->size) / half, y = (pixel->y - 0.5 * raster->size) / half;
    move[0] = half * (hatch_vec_dot(vector, view->right) - x * w) / pixel->w;
    move[1] = half * (hatch_vec_dot(vector, view->up) - y * w) / pixel->w;
}

/* Returns the ink at a pixel by Algorithm 2.
 *   low, high  tones in full light and without light */
static inline double raster_ink(const struct raster *raster, const struct raster_pixel *pixel,
                                const struct hatch_rptam *rptam, double low, double high)
{
    double amounts[HATCH_RPTAM_LAYERS_MAX], paper = 1, move[2][2];
    double dark = 1 - fmin(pixel->point.light, 1);
    rptam_amounts(rptam, low + (high - low) * dark, amounts);
    for (int k = 0; k < 2; k++)
        raster_move(raster, pixel, pixel->point.along[k], move[k]);
    for (uint32_t i = 0; i < rptam->layer_count; i++) {
        const struct hatch_rptam_layer *layer = &rptam->layers[i];
        double along = hypot(layer->cosine * move[0][0] + layer->sine * move[1][0],
                             layer->cosine * move[0][1] + layer->sine * move[1][1]);
        double across = fabs(move[0][0] * move[1][1] - move[0][1] * move[1][0]) / along;
        double depth = log2(layer->style.tile_px / across);
        if (fabs(depth) < 60)
            paper *= 1 - rptam_layer_ink(rptam, i, pixel->point.uv, depth, amounts[i], true);
    }
    return 1 - paper;
}

/* Returns whether the pixels around a pixel show one smooth surface. At the borders of surfaces rounding decides which
 * face is drawn, so pictures cannot be compared there. */
static inline bool raster_is_inside(const struct raster *raster, uint32_t x, uint32_t y)
{
    const struct raster_pixel *pixel = &raster->pixels[(size_t)y * raster->size + x];
    for (uint32_t i = 0; i < 9; i++) {
        uint32_t column = x + i % 3 - 1, row = y + i / 3 - 1;
        if (column >= raster->size || row >= raster->size)
            return false;
        const struct raster_pixel *near = &raster->pixels[(size_t)row * raster->size + column];
        for (int k = 0; k < 2; k++)
            if (!(fabs(near->point.uv[k] - pixel->point.uv[k]) < 0.5))
                return false;
        if (!(fabs(near->w - pixel->w) < 0.1 * pixel->w))
            return false;
    }
    return true;
}

#endif
