/* render-gl's drawing for tests: a mesh and a map become a picture, without files. Include after
 * run.h; frame_begin makes a context, frame_draw draws. */
#ifndef HATCH_TEST_RENDER_FRAME_H
#define HATCH_TEST_RENDER_FRAME_H

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "shapes/shapes.h"
#include "render-gl/context.h"
#include "render-gl/picture.h"
#include "scene/uv_repeat.h"
#include "run.h"

struct test_frame {
    struct hatch_arena arena, scratch;
    struct hatch_err err;
    struct context context;
    struct hatch_scene scene;
    struct gpu_scene gpu;
    struct renderer renderer;
};

/* The scene in units where it is drawn: no bounds are taken off. */
static const struct hatch_bounds frame_unit = {.radius = 1.0};

static inline uint32_t frame_technique(const char *name)
{
    for (uint32_t i = 0; i < TECHNIQUE_COUNT; i++)
        if (strcmp(techniques[i]->name, name) == 0)
            return i;
    ck_abort_msg("no technique %s", name);
    return 0;
}

/* The scene is frame->scene, patches of its meshes (or NULL). A black line on white paper, no ambient
 * light, tones up to the map's darkest. map may be NULL. */
static inline void frame_begin_scene(const struct hatch_patch_mesh *patches, const struct hatch_bounds *bounds,
                                     const struct hatch_tam *map, struct test_frame *frame)
{
    struct hatch_err *err = &frame->err;
    HATCH_TEST_OK(context_open_headless(&frame->context, 2, err), err);
    HATCH_TEST_OK(scene_upload(&frame->scene, patches, bounds, &frame->arena, &frame->scratch, &frame->gpu, err), err);
    HATCH_TEST_OK(scene_set_pose(&frame->gpu, HATCH_NONE, 0, &frame->scratch, err), err);
    frame->renderer = (struct renderer){
        .shaders = {NULL, &frame->scratch},
        .style = {.inks = {.paper = {1, 1, 1}},
                  .curve = {.high = map ? (double)map->target[map->tones - 1] : 1.0, .gamma = 1},
                  .anisotropy = 1,
                  .hatch_scale = 1},
        .map = map,
        .scene = &frame->gpu,
        .size_max_px = frame->context.size_max_px,
    };
}

/* The same for a scene of one mesh. */
static inline void frame_begin(const struct hatch_mesh *mesh, const struct hatch_bounds *bounds,
                               const struct hatch_tam *map, struct test_frame *frame)
{
    HATCH_TEST_OK(hatch_scene_of_mesh(mesh, &frame->arena, &frame->scene, &frame->err), &frame->err);
    frame_begin_scene(NULL, bounds, map, frame);
}

static inline void frame_arenas(struct test_frame *frame)
{
    memset(frame, 0, sizeof *frame);
    hatch_arena_init(&frame->arena, (size_t)2 << 30);
    hatch_arena_init(&frame->scratch, (size_t)1 << 30);
}

/* With all the attributes that shapes have, in the frame's arena. */
static inline struct hatch_mesh frame_shape(struct test_frame *frame, enum hatch_shape shape, uint32_t faces)
{
    struct hatch_shape_options how = {.faces = faces, .seed = 1};
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_shape_make(shape, &how, &frame->arena, &frame->scratch, &mesh, &frame->err), &frame->err);
    return mesh;
}

/* A square of 2 by 2 whose texture coordinates run from 0 to 1, to the right and down. */
static inline struct hatch_mesh frame_plane(struct test_frame *frame, uint32_t faces)
{
    struct hatch_mesh mesh = frame_shape(frame, HATCH_SHAPE_PLANE, faces);
    const float *position = hatch_mesh_find(&mesh, "POSITION", 3);
    float *texcoord = hatch_mesh_find(&mesh, "TEXCOORD_0", 2);
    for (size_t v = 0; v < mesh.vertex_count; v++) {
        texcoord[2 * v] = 0.5f + 0.5f * position[3 * v];
        texcoord[2 * v + 1] = 0.5f - 0.5f * position[3 * v + 1];
    }
    return mesh;
}

/* A scene of a mesh that hangs on two joints, nodes 1 and 2, which are to move as one; some vertices by the first, some
 * by the second or both. */
static inline void frame_hang(struct hatch_mesh *mesh, struct test_frame *frame)
{
    static const float unmoved[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    static struct hatch_node nodes[3];
    static uint32_t joints[2] = {1, 2};
    static float inverse[32];
    static struct hatch_skin skin = {2, joints, inverse};
    struct hatch_scene *scene = &frame->scene;
    float *ids, *weights;
    HATCH_TEST_OK(hatch_mesh_add(&frame->arena, mesh, "JOINTS_0", 4, &ids, &frame->err), &frame->err);
    HATCH_TEST_OK(hatch_mesh_add(&frame->arena, mesh, "WEIGHTS_0", 4, &weights, &frame->err), &frame->err);
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        ids[4 * v + 1] = 1;
        weights[4 * v] = (float)(v % 3) / 2;
        weights[4 * v + 1] = 1 - weights[4 * v];
    }
    HATCH_TEST_OK(hatch_scene_of_mesh(mesh, &frame->arena, scene, &frame->err), &frame->err);
    for (int i = 0; i < 3; i++) {
        nodes[i] = scene->nodes[0];
        nodes[i].mesh_count = i == 0;
    }
    for (int i = 0; i < 2; i++)
        memcpy(inverse + 16 * i, unmoved, sizeof unmoved);
    nodes[0].skin = 0;
    scene->nodes = nodes;
    scene->node_count = 3;
    scene->skins = &skin;
    scene->skin_count = 1;
    scene->meshes[0].joints_used = 2;
}

/* From a little above and beside, at the distance that frames the scene. */
static inline struct hatch_view frame_view(struct test_frame *frame, double aspect)
{
    static const struct hatch_view_choice choice = {
        .kind = HATCH_VIEW_FRAMED, .azimuth_rad = 0.5, .elevation_rad = 0.4, .fov_rad = 0.5};
    static const struct hatch_pose_span span = {.animation = HATCH_NONE, .moments = 1};
    struct hatch_view view;
    HATCH_TEST_OK(hatch_view_make(&choice, &frame->gpu.pose, &span, &frame->gpu.bounds, aspect, &frame->scratch, &view,
                                  &frame->err),
                  &frame->err);
    return view;
}

/* Draws with a technique into an image of R G B, linear. */
static inline void frame_draw(struct test_frame *frame, const char *technique, const struct hatch_view *view,
                              uint32_t width, uint32_t height, uint32_t side, struct hatch_image *image)
{
    struct hatch_err *err = &frame->err;
    uint32_t index = frame_technique(technique);
    struct target target;
    HATCH_TEST_OK(renderer_prepare(&frame->renderer, index, &frame->scratch, err), err);
    HATCH_TEST_OK(picture_target(width, height, side, &frame->renderer, &target, err), err);
    HATCH_TEST_OK(hatch_image_make(&frame->arena, width, height, "RGB", image, err), err);
    HATCH_TEST_OK(picture_draw(&frame->renderer, index, view, &target, image, err), err);
    target_free(&target);
}

/* The largest of all channels, of two pictures of one size. */
static inline double frame_difference(const struct hatch_image *a, const struct hatch_image *b)
{
    double worst = 0;
    for (size_t i = 0; i < 3 * (size_t)a->width * a->height; i++)
        worst = fmax(worst, fabs((double)a->pixels[i] - (double)b->pixels[i]));
    return worst;
}

/* The mean darkness of all channels. */
static inline double frame_ink(const struct hatch_image *image)
{
    double sum = 0;
    for (size_t i = 0; i < 3 * (size_t)image->width * image->height; i++)
        sum += 1 - (double)image->pixels[i];
    return sum / (3.0 * image->width * image->height);
}

/* What frame_begin made; the arenas keep what they hold, for the next frame_begin. */
static inline void frame_close(struct test_frame *frame)
{
    renderer_free(&frame->renderer);
    scene_free(&frame->gpu);
    context_close(&frame->context);
}

static inline void frame_end(struct test_frame *frame)
{
    frame_close(frame);
    hatch_arena_free(&frame->arena);
    hatch_arena_free(&frame->scratch);
}

#endif
