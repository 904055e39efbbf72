/* render-gl's drawing for tests: a mesh and a map become a picture, without files. Include after
 * run.h; frame_begin makes a context, frame_draw draws. */
#ifndef HATCH_TEST_RENDER_FRAME_H
#define HATCH_TEST_RENDER_FRAME_H

#include <stdio.h>
#include <string.h>

#include "mesh/shapes.h"
#include "render-gl/context.h"
#include "render-gl/picture.h"
#include "render-gl/repeat.h"
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
static const struct bounds frame_unit = {.radius = 1.0};

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
static inline void frame_begin_scene(const struct patch_mesh *patches, const struct bounds *bounds,
                                     const struct hatch_tam *map, struct test_frame *frame)
{
    struct hatch_err *err = &frame->err;
    HATCH_TEST_OK(context_open_headless(&frame->context, 2, err), err);
    HATCH_TEST_OK(scene_upload(&frame->scene, patches, bounds, &frame->arena, &frame->scratch,
                               &frame->gpu, err),
                  err);
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
static inline void frame_begin(const struct hatch_mesh *mesh, const struct bounds *bounds,
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

/* Draws with a technique into an image of R G B, linear. */
static inline void frame_draw(struct test_frame *frame, const char *technique,
                              const struct view *view, uint32_t width, uint32_t height,
                              uint32_t side, struct hatch_image *image)
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

static inline void frame_end(struct test_frame *frame)
{
    renderer_free(&frame->renderer);
    scene_free(&frame->gpu);
    context_close(&frame->context);
    hatch_arena_free(&frame->arena);
    hatch_arena_free(&frame->scratch);
}

#endif
