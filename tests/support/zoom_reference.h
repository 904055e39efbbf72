/* Checks close-ups against a ray tracer in double-double arithmetic. Compared are the positions of pixels in the
 * pattern of seed points, which the technique "places" draws with floats alone or with pieces of near faces. */
#ifndef HATCH_TEST_ZOOM_REFERENCE_H
#define HATCH_TEST_ZOOM_REFERENCE_H

#include <math.h>

#include "math/pair.h"
#include "math/vector.h"
#include "render-gl/gpu/buffer.h"
#include "render_frame.h"

struct zoom_error {
    double largest_px, mean_px; /* errors of positions in the pattern of seed points, as displacements in the picture */
    uint32_t pixels;            /* number of compared pixels */
    uint32_t wrong;             /* pixels drawn where there is no surface, or not drawn where there is one */
};

/* A vertex in camera coordinates. */
struct zoom_corner {
    struct hatch_pair at[3], uv[2];
    double span[6]; /* derivatives of the position with respect to u and v, in the unit scene */
};

/* A ray in camera coordinates. begin: its origin, in the plane z = 0 through the eye. */
struct zoom_ray {
    double begin[2], along[3];
};

/* Returns a view of a point of the surface from a distance.
 *   back  unit vector from the point to the eye */
static inline struct hatch_view zoomed_view(struct test_frame *frame, const double point[3], const double back[3],
                                            double distance, double aspect)
{
    struct hatch_view_choice choice = {.kind = HATCH_VIEW_EYE, .fov_rad = 0.5, .has_target = true};
    struct hatch_view view;
    for (int k = 0; k < 3; k++) {
        choice.target[k] = point[k];
        choice.eye[k] = point[k] + distance * back[k];
    }
    const struct hatch_framing framing = {.bounds = &frame->on_gpu.unit.bounds, .aspect = aspect};
    HATCH_TEST_OK(
        hatch_view_make(&choice, &frame->on_gpu.unit.pose, &framing, &frame->args.scratch, &view, &frame->err),
        &frame->err);
    if (distance < 0x1p-50) /* the eye may round to the point, and then they give no direction */
        hatch_view_set_back(&view, back);
    return view;
}

/* Computes a point of a face and the normal of the face.
 *   share  barycentric coordinates */
static inline void zoom_face_point(const struct hatch_mesh *mesh, uint32_t face, const double share[3], double point[3],
                                   double normal[3])
{
    double corner[3][3];
    ck_assert(hatch_mesh_corners(mesh, face, corner));
    for (int k = 0; k < 3; k++)
        point[k] = share[0] * corner[0][k] + share[1] * corner[1][k] + share[2] * corner[2][k];
    hatch_vec_triangle(corner[0], corner[1], corner[2], normal);
    hatch_vec_normalize(normal);
}

/* Computes the direction to the eye: the normal rotated by an angle. */
static inline void zoom_lean(const double normal[3], double tilt, double back[3])
{
    double side[3];
    hatch_vec_any_orthogonal(normal, side);
    for (int k = 0; k < 3; k++)
        back[k] = cos(tilt) * normal[k] + sin(tilt) * side[k];
}

/* Computes the positions of vertices in camera coordinates. */
static inline void zoom_positions(struct test_frame *frame, const struct hatch_view *view, struct zoom_corner *corners)
{
    const struct hatch_item *item = &frame->on_gpu.unit.items[0];
    const double *axes[3] = {view->right, view->up, view->back};
    size_t count = frame->scene.meshes[0].mesh.vertex_count;
    struct hatch_arena_mark mark = hatch_arena_mark(&frame->args.scratch);
    double *world = HATCH_NEW(&frame->args.scratch, double, 3 * count, &frame->err);
    hatch_pose_vertices(&frame->on_gpu.unit.pose, item->node, 0, world, NULL);
    for (size_t v = 0; v < count; v++) {
        struct hatch_pair from[3];
        for (int k = 0; k < 3; k++) {
            const struct hatch_pair eye = {view->eye[k], view->eye_low[k]};
            from[k] = hatch_pair_sub(hatch_view_to_unit(&frame->on_gpu.unit.bounds, k, world[3 * v + (size_t)k]), eye);
        }
        for (int k = 0; k < 3; k++)
            corners[v].at[k] = hatch_pair_dot(from, axes[k]);
    }
    hatch_arena_rewind(&frame->args.scratch, mark);
}

static inline void zoom_corners(struct test_frame *frame, const struct hatch_view *view, struct zoom_corner *corners)
{
    const struct hatch_mesh *mesh = &frame->scene.meshes[0].mesh;
    const struct hatch_item *item = &frame->on_gpu.unit.items[0];
    const float *texcoord = hatch_mesh_find(mesh, "TEXCOORD_0", 2);
    size_t count = mesh->vertex_count;
    zoom_positions(frame, view, corners);
    struct hatch_arena_mark mark = hatch_arena_mark(&frame->args.scratch);
    float *spans = HATCH_NEW(&frame->args.scratch, float, 6 * count, &frame->err);
    gpu_buffer_read(frame->on_gpu.items[0].uv_tangents, spans, 6 * sizeof *spans * count);
    for (size_t v = 0; v < count; v++) {
        for (size_t k = 0; k < 2; k++)
            corners[v].uv[k] = hatch_pair_product((double)texcoord[2 * v + k], (double)item->repeat[k]);
        for (size_t k = 0; k < 6;
             k++) /* the buffer holds derivatives in the mesh's units, per unit of unrepeated coordinates */
            corners[v].span[k] =
                (double)spans[6 * v + k] / frame->on_gpu.unit.bounds.radius / (double)item->repeat[k / 3];
    }
    hatch_arena_rewind(&frame->args.scratch, mark);
}

/* Computes the position of a corner relative to the origin of a ray. Rays of orthographic views do not start at the
 * eye. */
static inline void zoom_relative(const struct zoom_corner *corner, const double begin[2], struct hatch_pair at[3])
{
    for (int k = 0; k < 2; k++)
        at[k] = hatch_pair_sub(corner->at[k], hatch_pair_of(begin[k]));
    at[2] = corner->at[2];
}

/* Computes the barycentric coordinates of the intersection of a ray with a face, not yet divided by their sum. Returns
 * false when the ray misses the face. */
static inline bool zoom_shares(const struct zoom_corner *const c[3], const struct zoom_ray *ray,
                               struct hatch_pair share[3], struct hatch_pair *sum)
{
    *sum = hatch_pair_of(0);
    for (int i = 0; i < 3; i++) {
        struct hatch_pair a[3], b[3], cross[3];
        zoom_relative(c[(i + 1) % 3], ray->begin, a);
        zoom_relative(c[(i + 2) % 3], ray->begin, b);
        for (int k = 0; k < 3; k++)
            cross[k] = hatch_pair_sub(hatch_pair_mul(a[(k + 1) % 3], b[(k + 2) % 3]),
                                      hatch_pair_mul(a[(k + 2) % 3], b[(k + 1) % 3]));
        share[i] = hatch_pair_dot(cross, ray->along);
        *sum = hatch_pair_add(*sum, share[i]);
    }
    for (int i = 0; i < 3; i++)
        if (!(share[i].high / sum->high > 0))
            return false;
    return true;
}

/* Returns whether a ray clearly misses a face; a quick test in doubles. */
static inline bool zoom_misses(const struct zoom_corner *const c[3], const struct zoom_ray *ray)
{
    double at[3][3], cross[3], share[3], sum = 0;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            at[i][k] = c[i]->at[k].high - (k < 2 ? ray->begin[k] : 0);
    for (int i = 0; i < 3; i++) {
        hatch_vec_cross(at[(i + 1) % 3], at[(i + 2) % 3], cross);
        share[i] = hatch_vec_dot(cross, ray->along);
        sum += share[i];
    }
    return fmin(fmin(share[0] / sum, share[1] / sum), share[2] / sum) < -0.1;
}

/* Finds the first face that a ray meets, and the texture coordinates and derivatives there. Returns the distance along
 * the view direction, negative when there is none.
 *   face  out: corners of the face */
static inline double zoom_hit(const struct hatch_mesh *mesh, const struct zoom_corner *corners,
                              const struct zoom_ray *ray, struct hatch_pair uv[2], double span[6],
                              const struct zoom_corner *face[3])
{
    double nearest = -1;
    for (size_t f = 0; f < mesh->face_count; f++) {
        const struct zoom_corner *c[3];
        struct hatch_pair share[3], sum, depth = {0, 0};
        for (size_t k = 0; k < 3; k++)
            c[k] = &corners[mesh->indices[3 * f + k]];
        if (zoom_misses(c, ray) || !zoom_shares(c, ray, share, &sum))
            continue;
        for (int i = 0; i < 3; i++) {
            share[i] = hatch_pair_div(share[i], sum);
            depth = hatch_pair_add(depth, hatch_pair_mul(share[i], c[i]->at[2]));
        }
        if (!(-depth.high > 0) || (nearest >= 0 && -depth.high > nearest))
            continue;
        nearest = -depth.high;
        for (int i = 0; i < 3; i++)
            face[i] = c[i];
        for (int k = 0; k < 2; k++) {
            uv[k] = hatch_pair_of(0);
            for (int i = 0; i < 3; i++)
                uv[k] = hatch_pair_add(uv[k], hatch_pair_mul(share[i], c[i]->uv[k]));
        }
        for (int k = 0; k < 6; k++)
            span[k] = share[0].high * c[0]->span[k] + share[1].high * c[1]->span[k] + share[2].high * c[2]->span[k];
    }
    return nearest;
}

/* Returns the ray through a position in the picture, 0 .. 1 from its lower left corner. */
static inline struct zoom_ray zoom_ray_of(const struct hatch_view *view, double x, double y)
{
    struct zoom_ray ray = {{0, 0}, {0, 0, -1}};
    double *place = view->orthographic ? ray.begin : ray.along;
    place[0] = (2 * x - 1) * view->half_height * view->aspect;
    place[1] = (2 * y - 1) * view->half_height;
    return ray;
}

/* Computes the derivatives of the position in the picture, in pixels, with respect to u and v. */
static inline void zoom_pixels(const struct hatch_view *view, const struct zoom_ray *ray, double depth, uint32_t height,
                               const double span[6], double pixels[2][2])
{
    double scale = height / (2 * view->half_height) / (view->orthographic ? 1 : depth);
    for (int k = 0; k < 2; k++) {
        double back = hatch_vec_dot(span + 3 * k, view->back);
        const double *axes[2] = {view->right, view->up};
        for (int axis = 0; axis < 2; axis++)
            pixels[k][axis] = scale * (hatch_vec_dot(span + 3 * k, axes[axis]) + ray->along[axis] * back);
    }
}

/* Returns the fractional part of a texture coordinate divided by 4 * 2^depth, as the technique "places" writes it. */
static inline double zoom_place(struct hatch_pair uv, int depth)
{
    struct hatch_pair at = {ldexp(uv.high, -depth - 2), ldexp(uv.low, -depth - 2)};
    return hatch_pair_round(hatch_pair_sub(at, hatch_pair_floor(at)));
}

/* Compares a drawn pixel with the reference and adds its error to *error.
 *   hit   distance of the surface along the view
 *   rgba  the drawn pixel */
static inline void zoom_compare(const struct hatch_rptam *rptam, const struct hatch_view *view, uint32_t height,
                                const struct zoom_ray *ray, double hit, const struct hatch_pair uv[2],
                                const double span[6], const float rgba[4], struct zoom_error *error)
{
    double pixels[2][2], along[2], away[2] = {0, 0};
    const struct hatch_rptam_layer *layer = &rptam->layers[0];
    zoom_pixels(view, ray, hit, height, span, pixels);
    for (int k = 0; k < 2; k++)
        along[k] = layer->cosine * pixels[0][k] + layer->sine * pixels[1][k];
    double area = fabs(pixels[0][0] * pixels[1][1] - pixels[0][1] * pixels[1][0]);
    double depth = log2(layer->style.tile_px * hypot(along[0], along[1]) / area);
    if (fabs(depth - round(depth)) < 1e-3) /* rounding decides which nesting depth is drawn */
        return;
    for (int k = 0; k < 2; k++) {
        double drawn = (double)rgba[2 * k] + ((double)rgba[2 * k + 1] + 0.5 / 1024) / 1024;
        double turn = drawn - zoom_place(uv[k], (int)floor(depth));
        double part = 4 * (turn - round(turn)) * exp2(floor(depth));
        away[0] += part * pixels[k][0];
        away[1] += part * pixels[k][1];
    }
    double off = hypot(away[0], away[1]);
    error->largest_px = fmax(error->largest_px, off);
    error->mean_px += off;
    error->pixels++;
}

/* Draws with the technique "places" and compares every step-th pixel of every step-th row. */
static inline struct zoom_error zoom_measure(struct test_frame *frame, const struct hatch_view *view, uint32_t width,
                                             uint32_t height, uint32_t step)
{
    const struct hatch_mesh *mesh = &frame->scene.meshes[0].mesh;
    struct zoom_error error = {0, 0, 0, 0};
    struct hatch_err *err = &frame->err;
    struct hatch_arena_mark mark = hatch_arena_mark(&frame->args.keep);
    float *rgba = HATCH_NEW(&frame->args.keep, float, 4 * (size_t)width * height, err);
    struct zoom_corner *corners = HATCH_NEW(&frame->args.keep, struct zoom_corner, mesh->vertex_count, err);
    ck_assert_ptr_nonnull(corners);
    frame_draw_numbers(frame, "places", view, width, height, rgba);
    zoom_corners(frame, view, corners);
    for (uint32_t y = step / 2; y < height; y += step)
        for (uint32_t x = step / 2; x < width; x += step) {
            const struct zoom_ray ray = zoom_ray_of(view, (x + 0.5) / width, (y + 0.5) / height);
            const float *drawn = rgba + 4 * ((size_t)y * width + x);
            const struct zoom_corner *face[3];
            struct hatch_pair uv[2];
            double span[6], hit = zoom_hit(mesh, corners, &ray, uv, span, face);
            if ((hit > 0) != (drawn[0] >= 0))
                error.wrong++;
            else if (hit > 0)
                zoom_compare(frame->model, view, height, &ray, hit, uv, span, drawn, &error);
        }
    error.mean_px /= error.pixels ? error.pixels : 1;
    hatch_arena_rewind(&frame->args.keep, mark);
    return error;
}

#endif
