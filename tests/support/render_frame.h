/* Draws meshes and maps with render-gl's techniques, without files. Call frame_arenas, then frame_open and frame_draw,
 * and frame_finish last. */
#ifndef HATCH_TEST_RENDER_FRAME_H
#define HATCH_TEST_RENDER_FRAME_H

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "render-gl/gpu/context.h"
#include "render-gl/mode/picture.h"
#include "render-gl/mode/show.h"
#include "render-gl/scene/pose.h"
#include "render-gl/technique/list.h"
#include "render-gl/technique/rptam.h"
#include "gpu/alive.h"
#include "run.h"
#include "shapes/shapes.h"
#include "views.h"

#define FRAME_TECHNIQUES_MAX 8

struct test_frame {
    struct cmd_args args;           /* arenas of the test, which may rewind them */
    struct cmd_args technique_args; /* arenas of the techniques */
    struct hatch_err err;
    struct gpu_context context;
    struct hatch_scene scene;
    struct scene on_gpu;
    struct asset asset;              /* map or tone texture that the techniques draw with */
    const struct hatch_rptam *model; /* model that the technique rptam draws */
    struct assets assets;
    struct frame shown;
    struct technique_context technique_context;
    struct technique_instance instances[FRAME_TECHNIQUES_MAX];
    struct line_overlay *lines; /* drawn over every technique; NULL: none */
};

/* Bounds for which the unit scene equals the scene. */
static const struct hatch_bounds frame_unit = {.radius = 1.0};

static inline const struct technique *frame_technique(const char *name)
{
    if (strcmp(name, technique_rptam_places.name) == 0)
        return &technique_rptam_places;
    for (uint32_t i = 0; techniques[i]; i++)
        if (strcmp(techniques[i]->name, name) == 0)
            return techniques[i];
    for (uint32_t i = 0; show_techniques[i]; i++)
        if (strcmp(show_techniques[i]->name, name) == 0)
            return show_techniques[i];
    ck_abort_msg("no technique %s", name);
    return NULL;
}

/* Opens and prepares a technique if that is not yet done; returns the picture to pass to picture_draw. */
static inline struct picture frame_picture(struct test_frame *frame, const char *name)
{
    const struct technique *technique = frame_technique(name);
    struct technique_instance *instance = frame->instances;
    while (instance->technique && instance->technique != technique)
        instance++;
    ck_assert_int_lt(instance - frame->instances, FRAME_TECHNIQUES_MAX);
    if (!instance->technique)
        HATCH_TEST_OK(technique_open(instance, technique, &frame->technique_args, &frame->err), &frame->err);
    if (technique->read == rptam_read || technique == &technique_rptam_places)
        ((struct rptam_state *)instance->state)->model = frame->model;
    HATCH_TEST_OK(technique_prepare(&frame->technique_context, instance, &frame->err), &frame->err);
    return (struct picture){.context = &frame->technique_context,
                            .instance = instance,
                            .lines = frame->lines,
                            .draws_lines = frame->lines != NULL};
}

/* Opens a context and uploads frame->scene. The style is black ink on white paper, without ambient light, with tones up
 * to the map's darkest.
 *   patches  the joined patches of the scene's meshes; NULL: none
 *   map      NULL: none */
static inline void frame_open_scene(const struct hatch_patch_mesh *patches, const struct hatch_bounds *bounds,
                                    const struct hatch_tam *map, struct test_frame *frame)
{
    struct hatch_err *error = &frame->err;
    struct hatch_arena *lasting = &frame->args.keep, *temporary = &frame->args.scratch;
    HATCH_TEST_OK(gpu_context_open_headless(&frame->context, 2, error), error);
    HATCH_TEST_OK(scene_upload(&frame->scene, patches, bounds, lasting, temporary, &frame->on_gpu, error), error);
    HATCH_TEST_OK(scene_set_pose(&frame->on_gpu, HATCH_NONE, 0, temporary, error), error);
    memset(&frame->asset, 0, sizeof frame->asset);
    if (map)
        frame->asset.map = *map;
    frame->assets =
        (struct assets){.asset = &frame->asset, .limits = {.size_max_px = frame->context.size_max_px, .anisotropy = 1}};
    frame->shown = (struct frame){
        .programs = {.scratch = temporary},
        .style = {.inks = {.paper = {1, 1, 1}},
                  .curve = {.high = map ? (double)map->target[map->tones - 1] : 1.0, .gamma = 1},
                  .anisotropy = 1,
                  .hatch_scale = 1},
        .scene = &frame->on_gpu,
        .size_max_px = frame->context.size_max_px,
    };
    hatch_arena_init(&frame->shown.programs.keep, (size_t)1 << 30);
    frame->technique_context = (struct technique_context){
        .frame = &frame->shown, .assets = &frame->assets, .args = &frame->technique_args, .side = 1};
    memset(frame->instances, 0, sizeof frame->instances);
}

/* Like frame_open_scene, for a scene of one mesh. */
static inline void frame_open(const struct hatch_mesh *mesh, const struct hatch_bounds *bounds,
                              const struct hatch_tam *map, struct test_frame *frame)
{
    HATCH_TEST_OK(hatch_scene_of_mesh(mesh, &frame->args.keep, &frame->scene, &frame->err), &frame->err);
    frame_open_scene(NULL, bounds, map, frame);
}

static inline void frame_arenas(struct test_frame *frame)
{
    memset(frame, 0, sizeof *frame);
    frame->args.max_memory = (uint64_t)1 << 30;
    hatch_arena_init(&frame->args.keep, (size_t)2 << 30);
    hatch_arena_init(&frame->args.scratch, (size_t)1 << 30);
    hatch_arena_init(&frame->technique_args.keep, (size_t)1 << 30);
    hatch_arena_init(&frame->technique_args.scratch, (size_t)1 << 30);
    hatch_arena_init(&frame->technique_args.pool_arena, (size_t)1 << 30);
    frame->technique_args.threads = 1;
}

/* Makes a built-in shape with all its attributes, in args.keep. */
static inline struct hatch_mesh frame_shape(struct test_frame *frame, enum hatch_shape shape, uint32_t faces)
{
    struct hatch_shape_options how = {.faces = faces, .seed = 1};
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_shape_make(shape, &how, &frame->args.keep, &frame->args.scratch, &mesh, &frame->err),
                  &frame->err);
    return mesh;
}

/* Makes a square with sides of 2 whose texture coordinates run from 0 to 1, u to the right and v downwards. */
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

/* Makes a scene of a mesh with a skin of two joints, nodes 1 and 2, whose weights differ between vertices. The test
 * must give both joints the same transform. */
static inline void frame_skin(struct hatch_mesh *mesh, struct test_frame *frame)
{
    static const float unmoved[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    static struct hatch_node nodes[3];
    static uint32_t joints[2] = {1, 2};
    static float inverse[32];
    static struct hatch_skin skin = {.joint_count = 2, .joints = joints, .inverse_bind = inverse};
    struct hatch_scene *scene = &frame->scene;
    float *ids, *weights;
    HATCH_TEST_OK(hatch_mesh_add(&frame->args.keep, mesh, "JOINTS_0", 4, &ids, &frame->err), &frame->err);
    HATCH_TEST_OK(hatch_mesh_add(&frame->args.keep, mesh, "WEIGHTS_0", 4, &weights, &frame->err), &frame->err);
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        ids[4 * v + 1] = 1;
        weights[4 * v] = (float)(v % 3) / 2;
        weights[4 * v + 1] = 1 - weights[4 * v];
    }
    HATCH_TEST_OK(hatch_scene_of_mesh(mesh, &frame->args.keep, scene, &frame->err), &frame->err);
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

/* Returns a view that frames the scene, from a little above and to the side. */
static inline struct hatch_view frame_view(struct test_frame *frame, double aspect)
{
    static const struct hatch_view_choice choice = {
        .kind = HATCH_VIEW_FRAMED, .azimuth_rad = 0.5, .elevation_rad = 0.4, .fov_rad = 0.5};
    static const struct hatch_pose_span span = {.animation = HATCH_NONE, .moments = 1};
    struct hatch_unit_scene *unit = &frame->on_gpu.unit;
    const struct hatch_framing framing = {&span, &unit->bounds, aspect};
    struct hatch_view view;
    HATCH_TEST_OK(hatch_view_make(&choice, &unit->pose, &framing, &frame->args.scratch, &view, &frame->err),
                  &frame->err);
    return view;
}

/* Draws with a technique into a linear RGB image.
 *   side  samples per pixel along each axis */
static inline void frame_draw(struct test_frame *frame, const char *technique, const struct hatch_view *view,
                              uint32_t width, uint32_t height, uint32_t side, struct hatch_image *image)
{
    struct hatch_err *error = &frame->err;
    frame->technique_context.side = side;
    const struct picture picture = frame_picture(frame, technique);
    struct canvas canvas;
    HATCH_TEST_OK(picture_canvas(&frame->shown, width, height, side, &canvas, error), error);
    HATCH_TEST_OK(hatch_image_make(&frame->args.keep, width, height, "RGB", image, error), error);
    HATCH_TEST_OK(picture_draw(&picture, view, &canvas, image, error), error);
    canvas_free(&canvas);
}

/* Draws the samples of a picture; the background is -1.
 *   side  samples along a pixel's side
 *   rgba  out: 4 floats per sample, rows from the bottom up */
static inline void frame_draw_samples(struct test_frame *frame, const char *technique, const struct hatch_view *view,
                                      uint32_t width, uint32_t height, uint32_t side, float *rgba)
{
    static const float nothing[3] = {-1, -1, -1};
    frame->technique_context.side = side;
    const struct picture picture = frame_picture(frame, technique);
    const struct hatch_tile tile = {0, 0, width, height, width, height};
    struct canvas canvas;
    const struct frame_request request = {.view = view, .tile = &tile, .canvas = &canvas, .background = nothing};
    HATCH_TEST_OK(picture_canvas(&frame->shown, width, height, side, &canvas, &frame->err), &frame->err);
    HATCH_TEST_OK(technique_draw(&frame->technique_context, picture.instance, &request, &frame->err), &frame->err);
    canvas_read_samples(&canvas, rgba);
    canvas_free(&canvas);
}

/* Draws with a technique that writes numbers instead of colours, one sample per pixel, as frame_draw_samples() does. */
static inline void frame_draw_numbers(struct test_frame *frame, const char *technique, const struct hatch_view *view,
                                      uint32_t width, uint32_t height, float *rgba)
{
    frame_draw_samples(frame, technique, view, width, height, 1, rgba);
}

/* Returns the largest difference between two pictures of the same size in any channel of a pixel. */
static inline double frame_difference(const struct hatch_image *a, const struct hatch_image *b)
{
    double worst = 0;
    for (size_t i = 0; i < 3 * (size_t)a->width * a->height; i++)
        worst = fmax(worst, fabs((double)a->pixels[i] - (double)b->pixels[i]));
    return worst;
}

/* Returns the mean darkness over all pixels and channels. */
static inline double frame_ink(const struct hatch_image *image)
{
    double sum = 0;
    for (size_t i = 0; i < 3 * (size_t)image->width * image->height; i++)
        sum += 1 - (double)image->pixels[i];
    return sum / (3.0 * image->width * image->height);
}

/* Closes all techniques and frees their programs. Needed after changing options that are compiled into shaders. */
static inline void frame_reset(struct test_frame *frame)
{
    for (int i = 0; i < FRAME_TECHNIQUES_MAX; i++)
        technique_close(&frame->instances[i]);
    assets_free(&frame->assets);
    frame_free(&frame->shown);
    hatch_arena_init(&frame->shown.programs.keep, (size_t)1 << 30);
}

/* Releases the context and the scene on the GPU, of which nothing is to be left; the arenas stay for the next
 * frame_open. */
static inline void frame_close(struct test_frame *frame)
{
    frame_reset(frame);
    scene_free(&frame->on_gpu);
    check_none_alive();
    gpu_context_close(&frame->context);
}

static inline void frame_finish(struct test_frame *frame)
{
    frame_close(frame);
    hatch_arena_free(&frame->args.keep);
    hatch_arena_free(&frame->args.scratch);
    hatch_pool_free(frame->technique_args.pool);
    hatch_arena_free(&frame->technique_args.pool_arena);
    hatch_arena_free(&frame->technique_args.keep);
    hatch_arena_free(&frame->technique_args.scratch);
}

#endif
