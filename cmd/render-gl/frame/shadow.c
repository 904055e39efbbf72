#include "render-gl/frame/shadow.h"

#include <math.h>
#include <string.h>

#include "math/vector.h"
#include "render-gl/frame/parts.h"
#include "render-gl/frame/pass.h"
#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/gpu/texture.h"

#define MARGIN 1.05       /* factor by which maps show more than the scene, so that soft edges at its rim fit in */
#define CUBE_TANGENT 1.15 /* half width of a cube's map at distance 1; over 1, for soft edges across borders */
#define SPOT_COSINE 0.4   /* least cosine of half a spot's angle for one map; wider spots need a cube of six */
#define NEAREST 1e-3      /* smallest distance from a lamp at which surfaces cast shadows */
#define FAR_LAMP 2.0      /* least distance of a lamp from the middle of the scene for a map of the whole scene */
#define NEAR_BACKDROP                                                                                                  \
    (1 / 64.0) /* least distance at which backdrops cast shadows, of that from the lamp to the middle of the scene */
#define SIZE_MIN_PX 512u
#define SIZE_MAX_PX 2048u
#define EDGE_PX 13.0 /* least width of soft edges in texels of a map; maps are enlarged for it up to SIZE_MAX_PX */

static const GLuint units[2] = {UNIT_SHADOWS, UNIT_SHADOW_TEXELS};

/* Projection of a map. A lamp is a point light or spot; other lights are directional. */
struct lens {
    double axes[3][3]; /* unit vectors of the map's x and y, and the direction away from the light */
    double from[3];    /* origin: position of the lamp; directional: middle of the scene's box */
    double extent[2];  /* half the map's width and height; of a lamp's map at distance 1 */
    double near, far;  /* range of distances along the last axis */
    bool lamp;
};

static void set_axes(const double along[3], double axes[3][3])
{
    static const double forward[3] = {0, 0, 1};
    hatch_vec_copy(along, axes[2]);
    if (!(hatch_vec_normalize(axes[2]) > 0))
        hatch_vec_copy(forward, axes[2]);
    hatch_vec_any_orthogonal(axes[2], axes[0]);
    hatch_vec_cross(axes[2], axes[0], axes[1]);
}

/* Sets the matrix from the unit scene to a map; depth is 0 at the near plane and 1 at the far one. */
static void set_matrix(const struct lens *lens, float matrix[16])
{
    double rows[4][4] = {{0}};
    for (int r = 0; r < 3; r++) {
        for (int k = 0; k < 3; k++)
            rows[r][k] = lens->axes[r][k];
        rows[r][3] = -hatch_vec_dot(lens->axes[r], lens->from);
    }
    double depth = lens->far - lens->near;
    memcpy(rows[3], rows[2], sizeof rows[3]);
    for (int c = 0; c < 4; c++) {
        double w = lens->lamp ? rows[3][c] : (c == 3 ? 1.0 : 0.0), z = rows[2][c] - (c == 3 ? lens->near : 0.0);
        for (int r = 0; r < 2; r++)
            rows[r][c] = 0.5 * rows[r][c] / lens->extent[r] + 0.5 * w;
        rows[2][c] = z * (lens->lamp ? lens->far : 1.0) / depth;
        rows[3][c] = w;
    }
    for (int r = 0; r < 4; r++)
        for (int c = 0; c < 4; c++)
            matrix[4 * c + r] = (float)rows[r][c];
}

/* Fits the map of a directional light to the extent of the items along the map's axes. Backdrops, which may be much
 * larger than the scene, do not widen it: there is light around it, and their shadows on the scene fall within. They
 * only lengthen its range of depths. */
static void fit(const struct hatch_unit_scene *scene, struct lens *lens)
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (uint32_t i = 0; i < scene->item_count; i++)
        for (int corner = 0; corner < 8; corner++) {
            const struct hatch_item *item = &scene->items[i];
            int first = scene->scene->nodes[item->node].backdrop ? 2 : 0;
            double point[3];
            for (int k = 0; k < 3; k++)
                point[k] = corner >> k & 1 ? item->high[k] : item->low[k];
            for (int k = first; k < 3; k++) {
                low[k] = fmin(low[k], hatch_vec_dot(lens->axes[k], point));
                high[k] = fmax(high[k], hatch_vec_dot(lens->axes[k], point));
            }
        }
    for (int k = 0; k < 3; k++) {
        double middle = high[k] > low[k] ? 0.5 * low[k] + 0.5 * high[k] : 0.0;
        double half = fmax(0.5 * high[k] - 0.5 * low[k], 1e-3) * MARGIN;
        hatch_vec_add_scaled(lens->from, middle, lens->axes[k], lens->from);
        if (k < 2)
            lens->extent[k] = half;
        lens->near = -half;
        lens->far = half;
    }
}

static void set_map(struct shadow *shadow, uint32_t light, const struct lens *lens)
{
    set_matrix(lens, shadow->block.map_from_unit[shadow->layers++]);
    for (int k = 0; k < 2; k++)
        shadow->block.maps[light][2 + k] = (float)(0.5 / lens->extent[k]);
}

/* Sets the six maps of a lamp, in the order +x -x +y -y +z -z. A point is in the map of that axis along which it is
 * farthest from the lamp (cube_face in shaders/shadow/shadow.glsl). */
static void set_cube(struct shadow *shadow, uint32_t light, struct lens lens)
{
    lens.extent[0] = lens.extent[1] = CUBE_TANGENT;
    for (int face = 0; face < 6; face++) {
        double along[3] = {0, 0, 0};
        along[face / 2] = face % 2 ? -1 : 1;
        set_axes(along, lens.axes);
        set_map(shadow, light, &lens);
    }
}

static bool has_backdrop(const struct hatch_unit_scene *scene)
{
    for (uint32_t i = 0; i < scene->item_count; i++)
        if (scene->scene->nodes[scene->items[i].node].backdrop)
            return true;
    return false;
}

/* Aims the map of a lamp along the axis of a spot, or from far away at the scene, whichever needs the narrower one;
 * shadows of the scene on backdrops are in either. Returns the number of maps: six where neither does. */
static uint32_t aim_lamp(const struct hatch_unit_light *light, const struct hatch_unit_scene *scene, struct lens *lens)
{
    const double scale = (double)light->cone[0], outer = scale > 0 ? -(double)light->cone[1] / scale : -1;
    const double away = hatch_vec_length(lens->from);
    const double of_cone = outer >= SPOT_COSINE ? MARGIN * sqrt(1 - outer * outer) / outer : INFINITY;
    const double of_scene = away > FAR_LAMP ? MARGIN / sqrt(away * away - MARGIN * MARGIN) : INFINITY;
    const bool far = of_scene < of_cone;
    double along[3], share = far ? 1 : of_cone < INFINITY ? 0.9 * outer : 0.5; /* of a distance, along the axis */
    for (int k = 0; k < 3; k++)
        along[k] = far ? -lens->from[k] : (double)light->direction[k];
    set_axes(along, lens->axes);
    lens->extent[0] = lens->extent[1] = fmin(of_cone, of_scene);
    lens->near = share * (away - MARGIN);
    lens->near = fmax(has_backdrop(scene) ? fmin(lens->near, NEAR_BACKDROP * away) : lens->near, NEAREST);
    lens->far = away + MARGIN;
    return lens->extent[0] < INFINITY ? 1 : 6;
}

static void add_light(const struct hatch_unit_light *light, uint32_t index, const struct hatch_unit_scene *scene,
                      struct shadow *shadow)
{
    struct lens lens = {.lamp = light->position[3] > 0};
    double along[3];
    uint32_t count = 1;
    for (int k = 0; k < 3; k++) {
        along[k] = -(double)light->direction[k];
        lens.from[k] = lens.lamp ? (double)light->position[k] : 0;
    }
    if (lens.lamp) {
        count = aim_lamp(light, scene, &lens);
    } else {
        set_axes(along, lens.axes);
        fit(scene, &lens);
    }
    if (!(light->direction[3] > 0) || shadow->layers + count > SHADOW_LAYERS_MAX)
        return;
    shadow->block.maps[index][0] = (float)shadow->layers;
    shadow->block.maps[index][1] = (float)count;
    if (count > 1)
        set_cube(shadow, index, lens);
    else
        set_map(shadow, index, &lens);
}

/* Sets up a sampler that compares depths. Points outside a map are lit. */
static void set_reads(GLuint sampler, GLint filter)
{
    static const GLfloat lit[4] = {1, 1, 1, 1};
    glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, filter);
    glSamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, filter);
    glSamplerParameteri(sampler, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glSamplerParameteri(sampler, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    glSamplerParameterfv(sampler, GL_TEXTURE_BORDER_COLOR, lit);
    glSamplerParameteri(sampler, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glSamplerParameteri(sampler, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

static enum hatch_status make_maps(struct shadow *shadow, uint32_t size_px, struct hatch_err *err)
{
    GLint layers = 0;
    if (shadow->maps)
        glGetTextureLevelParameteriv(shadow->maps, 0, GL_TEXTURE_DEPTH, &layers);
    if (size_px == shadow->size_px && layers >= (GLint)shadow->layers)
        return HATCH_OK;
    glDeleteTextures(1, &shadow->maps);
    shadow->maps = gpu_texture_make(GL_TEXTURE_2D_ARRAY, 1, GL_DEPTH_COMPONENT32F, size_px, size_px,
                                    shadow->layers ? shadow->layers : 1);
    shadow->size_px = size_px;
    shadow->drawn = false;
    return gpu_check_memory(err, "%u shadow maps of %u by %u pixels", shadow->layers, size_px, size_px);
}

static void make_state(struct shadow *shadow)
{
    glCreateSamplers(2, shadow->samplers);
    set_reads(shadow->samplers[0], GL_LINEAR);
    set_reads(shadow->samplers[1], GL_NEAREST);
    glCreateFramebuffers(1, &shadow->framebuffer);
    glNamedFramebufferDrawBuffer(shadow->framebuffer, GL_NONE);
}

/* Assigns layers to a frame's lights and updates the uniform block. Clears `drawn` if lights or pose differ from those
 * of the last call. */
static enum hatch_status begin(struct shadow *shadow, const struct frame_block *frame, const struct scene *scene,
                               double width, struct hatch_err *err)
{
    uint32_t size_px = SIZE_MIN_PX, layers = shadow->layers, pose_number = scene->unit.pose_number;
    struct shadow_block before = shadow->block;
    while (size_px < SIZE_MAX_PX && size_px * width < 2 * EDGE_PX)
        size_px *= 2;
    shadow->layers = 0;
    for (int32_t i = 0; i < frame->counts[0]; i++) {
        shadow->block.maps[i][0] = -1;
        add_light(&frame->lights[i], (uint32_t)i, &scene->unit, shadow);
    }
    shadow->drawn =
        shadow->drawn && layers == shadow->layers && shadow->pose_number == pose_number &&
        memcmp(before.map_from_unit, shadow->block.map_from_unit, layers * sizeof before.map_from_unit[0]) == 0;
    shadow->pose_number = pose_number;
    HATCH_TRY(make_maps(shadow, size_px, err));
    if (!shadow->framebuffer)
        make_state(shadow);
    shadow->block.edge[0] = (float)(0.5 * width);
    shadow->block.edge[1] = 1.0f / (float)size_px;
    gpu_block_update(&shadow->buffer, BLOCK_SHADOWS, &shadow->block, sizeof shadow->block);
    for (int i = 0; i < 2; i++)
        glBindTextureUnit(units[i], 0);
    return HATCH_OK;
}

/* Draws the surfaces of all items into a layer. */
static void draw_layer(const struct shadow *shadow, const struct scene *scene,
                       const struct gpu_program *const programs[2], uint32_t layer)
{
    static const float far = 1.0f;
    const struct gpu_target target = {.form = {.width = shadow->size_px, .height = shadow->size_px},
                                      .framebuffer = shadow->framebuffer};
    glNamedFramebufferTextureLayer(shadow->framebuffer, GL_DEPTH_ATTACHMENT, shadow->maps, 0, (GLint)layer);
    frame_pass_begin(&(struct frame_pass){.target = &target, .depth = FRAME_DEPTH_LOWER, .clear_depth = &far});
    for (uint32_t i = 0; i < scene->unit.item_count; i++) {
        const struct hatch_item *unit = &scene->unit.items[i];
        const struct scene_item *item = &scene->items[i];
        bool holes = !scene->unit.meshes[unit->mesh].patches && item->base_texture && unit->alpha_cutoff > 0;
        frame_use_item(scene, i, item->base_lightness, programs[holes]);
        glUniform1i(UNIFORM_LAYER, (GLint)layer);
        frame_part_draw(frame_part_of_surface(scene, i, NULL));
    }
}

enum hatch_status shadow_draw(struct shadow *shadow, const struct frame_block *frame, const struct scene *scene,
                              double width, struct gpu_programs *programs, struct hatch_err *err)
{
    static const struct gpu_stages stages = {.vertex = "shadow/shadow.vert", .fragment = "shadow/shadow.frag"};
    static const char *const defines[2] = {"", "#define BASE_TEXTURE 1\n#define BASE_HOLES 1\n"};
    const struct gpu_program *draw[2]; /* for items without and with holes */
    for (int holes = 0; holes < 2; holes++)
        HATCH_TRY(gpu_program_get(programs, &stages, defines[holes], &draw[holes], err));
    HATCH_TRY(begin(shadow, frame, scene, width, err));
    for (uint32_t layer = 0; layer < shadow->layers && !shadow->drawn; layer++)
        draw_layer(shadow, scene, draw, layer);
    shadow->drawn = true;
    for (int i = 0; i < 2; i++)
        gpu_texture_bind(units[i], shadow->maps, shadow->samplers[i]);
    return HATCH_OK;
}

void shadow_free(struct shadow *shadow)
{
    glDeleteFramebuffers(1, &shadow->framebuffer);
    glDeleteBuffers(1, &shadow->buffer);
    glDeleteTextures(1, &shadow->maps);
    glDeleteSamplers(2, shadow->samplers);
    *shadow = (struct shadow){.size_px = 0};
}
