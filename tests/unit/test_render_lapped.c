/* Patches over a surface: their composite against its definition, computed here for each pixel of a plane
 * on which a pixel is a texel of map and outline; against ordinary texture coordinates; and what must see
 * the surface once. */
#include <math.h>

#include "fail_alloc.h"
#include "render-gl/material.h"
#include "render_frame.h"
#include "render_map.h"

enum { SIZE = 64, TONES = 6, PATCHES_MAX = 64 };

static struct test_frame frame;
static struct hatch_tam map;
static struct hatch_image mask;
static struct patch_mesh *patches;

/* How a surface is cut into patches. */
struct cut {
    uint32_t count;
    uint32_t materials; /* in turns */
    bool (*holds)(uint32_t patch, const double point[3]); /* a face with this middle? NULL: all */
    void (*place)(uint32_t patch, const float *position, float hatch[2], float outline[2]);
};

static void middle_of(const struct hatch_mesh *mesh, size_t face, double middle[3])
{
    for (size_t k = 0; k < 3; k++) {
        middle[k] = 0;
        for (size_t c = 0; c < 3; c++)
            middle[k] += (double)mesh->attributes[0].data[3 * (size_t)mesh->indices[3 * face + c] + k] / 3;
    }
}

/* All of the surface's attributes, its faces begun at another corner in each patch. */
static struct hatch_mesh patch_of(const struct hatch_mesh *surface, const struct cut *cut, uint32_t patch)
{
    struct hatch_err *err = &frame.err;
    struct hatch_mesh made;
    uint32_t *now = HATCH_NEW(&frame.arena, uint32_t, surface->vertex_count, err); /* number + 1 */
    uint32_t *old = HATCH_NEW(&frame.arena, uint32_t, surface->vertex_count, err);
    HATCH_TEST_OK(hatch_mesh_make(&frame.arena, surface->vertex_count, surface->face_count, &made, err),
                  err);
    made.vertex_count = made.face_count = 0;
    for (size_t f = 0; f < surface->face_count; f++) {
        double middle[3];
        middle_of(surface, f, middle);
        if (cut->holds && !cut->holds(patch, middle))
            continue;
        for (size_t c = 0; c < 3; c++) {
            uint32_t vertex = surface->indices[3 * f + (c + patch) % 3];
            if (!now[vertex]) {
                old[made.vertex_count] = vertex;
                now[vertex] = ++made.vertex_count;
            }
            made.indices[3 * (size_t)made.face_count + c] = now[vertex] - 1;
        }
        made.face_count++;
    }
    float *hatch, *outline;
    for (uint32_t a = 0; a < surface->attribute_count; a++) {
        const struct hatch_mesh_attribute *from = &surface->attributes[a];
        float *data = made.attributes[0].data;
        if (strncmp(from->name, "TEXCOORD", 8) == 0)
            continue;
        if (a > 0)
            HATCH_TEST_OK(hatch_mesh_add(&frame.arena, &made, from->name, from->components, &data, err), err);
        for (size_t v = 0; v < made.vertex_count; v++)
            memcpy(data + from->components * v, from->data + from->components * old[v],
                   from->components * sizeof *data);
    }
    HATCH_TEST_OK(hatch_mesh_add(&frame.arena, &made, "TEXCOORD_0", 2, &hatch, err), err);
    HATCH_TEST_OK(hatch_mesh_add(&frame.arena, &made, "TEXCOORD_1", 2, &outline, err), err);
    for (size_t v = 0; v < made.vertex_count; v++)
        cut->place(patch, made.attributes[0].data + 3 * v, hatch + 2 * v, outline + 2 * v);
    return made;
}

/* frame.scene: one node with the patches, not joined yet. */
static void make_scene(const struct hatch_mesh *surface, const struct cut *cut)
{
    struct hatch_scene *scene = &frame.scene;
    struct hatch_err *err = &frame.err;
    HATCH_TEST_OK(hatch_scene_of_mesh(surface, &frame.arena, scene, err), err);
    scene->meshes = HATCH_NEW(&frame.arena, struct hatch_scene_mesh, cut->count, err);
    scene->materials = HATCH_NEW(&frame.arena, struct hatch_material, 2, err);
    scene->textures = HATCH_NEW(&frame.arena, struct hatch_texture, 1, err);
    scene->material_count = 2;
    scene->texture_count = 1;
    for (int i = 0; i < 2; i++)
        scene->materials[i] = (struct hatch_material){
            .base_color = {1, 1, 1, 1}, .base_texcoord = 1, .double_sided = true, .outline = true};
    scene->mesh_count = scene->nodes[0].mesh_count = cut->count;
    for (uint32_t i = 0; i < cut->count; i++)
        scene->meshes[i] = (struct hatch_scene_mesh){
            .mesh = patch_of(surface, cut, i), .material = i % cut->materials, .had_normals = true};
}

static void lend_outline(void)
{
    GLuint texture = 0;
    HATCH_TEST_OK(material_outline(&mask, &frame.scratch, &texture, &frame.err), &frame.err);
    for (uint32_t i = 0; i < frame.gpu.item_count; i++)
        frame.gpu.items[i].base_texture = texture;
}

static void begin_lapped(const struct hatch_mesh *surface, const struct cut *cut)
{
    make_scene(surface, cut);
    HATCH_TEST_OK(patches_join(&frame.scene, &frame.arena, &frame.scratch, &patches, &frame.err),
                  &frame.err);
    frame_begin_scene(patches, &frame_unit, &map, &frame);
    lend_outline();
}

static void begin(void)
{
    frame_arenas(&frame);
    random_map(SIZE, TONES, &frame.arena, &map);
    HATCH_TEST_OK(hatch_image_make(&frame.arena, SIZE, SIZE, "YA", &mask, &frame.err), &frame.err);
}

static struct hatch_mesh shape_of(enum hatch_shape shape, uint32_t faces)
{
    struct hatch_shape_options how = {.faces = faces, .seed = 1};
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_shape_make(shape, &how, &frame.arena, &frame.scratch, &mesh, &frame.err),
                  &frame.err);
    return mesh;
}

static double worst_difference(const struct hatch_image *a, const struct hatch_image *b)
{
    double worst = 0;
    for (size_t i = 0; i < 3 * (size_t)a->width * a->height; i++)
        worst = fmax(worst, fabs((double)a->pixels[i] - (double)b->pixels[i]));
    return worst;
}

static double ink_of(const struct hatch_image *image)
{
    double sum = 0;
    for (size_t i = 0; i < 3 * (size_t)image->width * image->height; i++)
        sum += 1 - (double)image->pixels[i];
    return sum / (3.0 * image->width * image->height);
}

/* Shifts of the map and of the outline, in texels, from patch to patch. */
static const int shifts[4][4] = {{0, 0, 0, 0}, {5, 40, 11, -7}, {23, 9, -20, 3}, {50, 31, 2, 17}};

static void place_shifted(uint32_t patch, const float *position, float hatch[2], float outline[2])
{
    double uv[2] = {0.5 + 0.5 * (double)position[0], 0.5 - 0.5 * (double)position[1]};
    for (int k = 0; k < 2; k++) {
        hatch[k] = (float)(uv[k] + shifts[patch][k] / (double)SIZE);
        outline[k] = (float)(uv[k] + shifts[patch][2 + k] / (double)SIZE);
    }
}

/* The reflectance that the patches leave at a pixel, where the tone is that of one column. */
static double composite(uint32_t count, uint32_t tone, int column, int row)
{
    double paper = 1;
    for (uint32_t p = 0; p < count; p++) {
        int x = (column + shifts[p][0]) % SIZE, y = (row + shifts[p][1]) % SIZE;
        int mx = column + shifts[p][2], my = row + shifts[p][3];
        double texel = round(255 * (double)map.columns[tone].levels[0].pixels[y * SIZE + x]) / 255;
        double share = mx < 0 || my < 0 || mx >= SIZE || my >= SIZE
                           ? 0
                           : (double)mask.pixels[2 * (my * SIZE + mx) + 1];
        paper += share * (texel - paper);
    }
    return paper;
}

static double worst_against_composite(const char *technique, uint32_t materials)
{
    static const uint32_t tone = 3;
    struct cut cut = {.count = 4, .materials = materials, .place = place_shifted};
    struct hatch_image image;
    begin();
    for (uint32_t i = 0; i < SIZE * SIZE; i++)
        mask.pixels[2 * i + 1] = (float)(hatch_random_u64(3, 0, i) % 256) / 255.0f;
    struct hatch_mesh plane = shape_of(HATCH_SHAPE_PLANE, 50);
    begin_lapped(&plane, &cut);
    ck_assert_uint_eq(frame.gpu.item_count, materials == 1 ? 1 : 4);
    frame.renderer.style.curve.low = frame.renderer.style.curve.high = (double)map.target[tone];
    frame_draw(&frame, technique, &map_facing, SIZE, SIZE, 1, &image);
    double worst = 0;
    for (int row = 0; row < SIZE; row++)
        for (int column = 0; column < SIZE; column++)
            worst = fmax(worst, fabs((double)image.pixels[3 * (row * SIZE + column)] -
                                     composite(4, tone, column, row)));
    frame_end(&frame);
    return worst;
}

START_TEST(patches_lie_over_one_another)
{
    static const char *const names[] = {"tam", "tam-flat", "tam-face", "tam-gouraud", "tam-triple"};
    ck_assert_double_le(worst_against_composite(names[_i], 1), 1.0 / 255);
}
END_TEST

START_TEST(patches_of_two_materials_too)
{
    ck_assert_double_le(worst_against_composite("tam", 2), 1.0 / 255);
    ck_assert_double_le(worst_against_composite("tam-triple", 2), 1.0 / 255);
}
END_TEST

/* A lamp from the upper left, so that every vertex has a tone of its own. */
static void light(void)
{
    frame.renderer.style.light = (struct own_light){true, -0.7, 0.6};
}

static void place_plain(uint32_t patch, const float *position, float hatch[2], float outline[2])
{
    place_shifted(patch, position, hatch, outline);
    for (int k = 0; k < 2; k++)
        outline[k] = 0.5f;
}

static void fill_mask(void)
{
    for (uint32_t i = 0; i < SIZE * SIZE; i++)
        mask.pixels[2 * i + 1] = 1;
}

/* A disk with a ramp. */
static void round_mask(void)
{
    for (uint32_t i = 0; i < SIZE * SIZE; i++) {
        double x = (i % SIZE + 0.5) / SIZE - 0.5, y = (i / SIZE + 0.5) / SIZE - 0.5;
        mask.pixels[2 * i + 1] = (float)fmin(fmax((0.48 - hypot(x, y)) / 0.08, 0), 1);
    }
}

START_TEST(one_patch_is_ordinary_texture_coordinates)
{
    static const char *const names[] = {"tam",         "tam-flat",   "tam-face",     "tam-gouraud",
                                        "tam-triple", "tam-threshold", "gouraud"};
    const struct cut cut = {.count = 1, .materials = 1, .place = place_plain};
    const struct view slant = {.eye = {0, 1.2, 2.4},
                               .right = {1, 0, 0},
                               .up = {0, 0.894427191, -0.447213595},
                               .back = {0, 0.447213595, 0.894427191},
                               .half_height = 0.5,
                               .aspect = 1,
                               .near = 0.1,
                               .pivot = 2.7};
    struct hatch_image lapped, plain;
    begin();
    fill_mask();
    struct hatch_mesh mesh = shape_of(HATCH_SHAPE_PLANE, 50);
    float *texcoord = hatch_mesh_find(&mesh, "TEXCOORD_0", 2), unused[2];
    float *normal = hatch_mesh_find(&mesh, "NORMAL", 3);
    for (size_t v = 0; v < mesh.vertex_count; v++) {
        place_shifted(0, mesh.attributes[0].data + 3 * v, texcoord + 2 * v, unused);
        normal[3 * v] = 0.4f * hatch_random_unit(5, 0, v); /* so that tones differ */
    }
    begin_lapped(&mesh, &cut);
    light();
    frame_draw(&frame, names[_i], &slant, 120, 90, 2, &lapped);
    renderer_free(&frame.renderer);
    scene_free(&frame.gpu);
    context_close(&frame.context);
    frame_begin(&mesh, &frame_unit, &map, &frame);
    light();
    frame_draw(&frame, names[_i], &slant, 120, 90, 2, &plain);
    ck_assert_double_gt(ink_of(&plain), 0.1);
    ck_assert_double_le(worst_difference(&lapped, &plain), 1.0 / 255);
    frame_end(&frame);
}
END_TEST

/* Caps of a sphere around points of a spiral, each in the plane that touches it there. */
enum { CAPS = 40 };
static const double CAP_COS = 0.86;

static void cap_axes(uint32_t patch, double axes[3][3])
{
    double y = 1 - (2.0 * patch + 1) / CAPS, angle = 2.399963 * patch, r = sqrt(1 - y * y);
    double up[3] = {r * cos(angle), y, r * sin(angle)}, east[3] = {-sin(angle), 0, cos(angle)};
    for (int k = 0; k < 3; k++) {
        axes[0][k] = east[k];
        axes[2][k] = up[k];
    }
    for (int k = 0; k < 3; k++)
        axes[1][k] = up[(k + 1) % 3] * east[(k + 2) % 3] - up[(k + 2) % 3] * east[(k + 1) % 3];
}

static double along(const double axis[3], const double point[3])
{
    return axis[0] * point[0] + axis[1] * point[1] + axis[2] * point[2];
}

static bool cap_holds(uint32_t patch, const double point[3])
{
    double axes[3][3];
    cap_axes(patch, axes);
    return along(axes[2], point) > CAP_COS * sqrt(along(point, point));
}

static void cap_place(uint32_t patch, const float *position, float hatch[2], float outline[2])
{
    double axes[3][3], point[3] = {(double)position[0], (double)position[1], (double)position[2]};
    double size = 2 * sqrt(1 - CAP_COS * CAP_COS);
    cap_axes(patch, axes);
    for (int k = 0; k < 2; k++) {
        double at = along(axes[k], point) / sqrt(along(point, point));
        hatch[k] = (float)at;
        outline[k] = (float)(0.5 + at / (1.02 * size));
    }
}

static const struct cut caps = {.count = CAPS, .materials = 1, .holds = cap_holds, .place = cap_place};

static void draw_in_tiles(const char *technique, uint32_t tile_px, uint32_t side, struct hatch_image *image)
{
    const struct view view = {.eye = {0, 0, 4},
                              .right = {1, 0, 0},
                              .up = {0, 1, 0},
                              .back = {0, 0, 1},
                              .half_height = 0.3,
                              .aspect = 1,
                              .near = 0.1,
                              .pivot = 4};
    uint32_t index = frame_technique(technique);
    struct hatch_err *err = &frame.err;
    struct target target;
    HATCH_TEST_OK(renderer_prepare(&frame.renderer, index, &frame.scratch, err), err);
    HATCH_TEST_OK(target_make(tile_px, tile_px, side, &frame.renderer.shaders, &target, err), err);
    HATCH_TEST_OK(hatch_image_make(&frame.arena, 160, 160, "RGB", image, err), err);
    HATCH_TEST_OK(picture_draw(&frame.renderer, index, &view, &target, image, err), err);
    target_free(&target);
}

START_TEST(both_ways_to_blend_agree)
{
    struct hatch_image once, passes, tiled;
    begin();
    round_mask();
    struct hatch_mesh sphere = shape_of(HATCH_SHAPE_SPHERE, 2000);
    begin_lapped(&sphere, &caps);
    light();
    draw_in_tiles("tam", 160, (uint32_t)_i, &once);
    draw_in_tiles("tam-triple", 160, (uint32_t)_i, &passes);
    ck_assert_double_gt(ink_of(&once), 0.05);
    ck_assert_double_le(worst_difference(&once, &passes), 1.0 / 255);
    draw_in_tiles("tam", 64, (uint32_t)_i, &tiled);
    ck_assert_double_le(worst_difference(&once, &tiled), 1.0 / 255);
    draw_in_tiles("tam-triple", 64, (uint32_t)_i, &tiled);
    ck_assert_double_le(worst_difference(&passes, &tiled), 1.0 / 255);
    frame_end(&frame);
}
END_TEST

START_TEST(nothing_shows_through_patches)
{
    struct hatch_image image;
    begin();
    fill_mask();
    struct hatch_mesh sphere = shape_of(HATCH_SHAPE_SPHERE, 500);
    begin_lapped(&sphere, &caps);
    for (uint32_t t = 0; t < TONES; t++)
        for (uint32_t level = 0; level < map.columns[t].level_count; level++)
            for (uint32_t i = 0; i < map.columns[t].levels[level].width *
                                         map.columns[t].levels[level].height; i++)
                map.columns[t].levels[level].pixels[i] = 0;
    frame.renderer.style.curve.low = frame.renderer.style.curve.high = 1;
    draw_in_tiles("tam", 160, 1, &image);
    for (int y = -40; y <= 40; y++)
        for (int x = -40; x <= 40; x++)
            ck_assert_double_le((double)image.pixels[3 * ((80 + y) * 160 + 80 + x)], 1.0 / 255);
    frame_end(&frame);
}
END_TEST

static uint32_t layer_of(const struct patch_mesh *from, const struct hatch_mesh *mesh, uint32_t patch)
{
    uint32_t layer = 0;
    for (uint32_t i = 0; i < 3 * mesh->face_count; i++) {
        while (i >= from->layer_end[layer])
            layer++;
        if (mesh->indices[i] >= from->first_vertex[patch] && mesh->indices[i] < from->first_vertex[patch + 1])
            return layer;
    }
    ck_abort_msg("patch %u has no face", patch);
    return 0;
}

/* By their middles: do two patches share a face? */
static bool overlap(uint32_t a, uint32_t b, const struct hatch_mesh *sphere)
{
    for (size_t f = 0; f < sphere->face_count; f++) {
        double middle[3];
        middle_of(sphere, f, middle);
        if (cap_holds(a, middle) && cap_holds(b, middle))
            return true;
    }
    return false;
}

START_TEST(joined_patches_are_the_surface)
{
    begin();
    struct hatch_mesh sphere = shape_of(HATCH_SHAPE_SPHERE, 500);
    make_scene(&sphere, &caps);
    HATCH_TEST_OK(patches_join(&frame.scene, &frame.arena, &frame.scratch, &patches, &frame.err),
                  &frame.err);
    ck_assert_uint_eq(frame.scene.mesh_count, 1);
    ck_assert_uint_eq(frame.scene.nodes[0].mesh_count, 1);
    ck_assert_uint_eq(patches[0].patch_count, CAPS);
    const struct hatch_mesh *joined = &frame.scene.meshes[0].mesh, *surface = &patches[0].surface;
    ck_assert_uint_eq(surface->face_count, sphere.face_count);
    ck_assert_uint_gt(joined->face_count, surface->face_count);
    for (uint32_t v = 0; v < surface->vertex_count; v++)
        ck_assert_mem_eq(surface->attributes[0].data + 3 * v,
                         joined->attributes[0].data + 3 * patches[0].vertex_of[v], 3 * sizeof(float));
    ck_assert_uint_eq(patches[0].layer_end[patches[0].layer_count - 1], 3 * joined->face_count);
    for (uint32_t a = 0; a < CAPS; a++)
        for (uint32_t b = a + 1; b < CAPS; b++)
            if (overlap(a, b, &sphere))
                ck_assert_uint_lt(layer_of(&patches[0], joined, a), layer_of(&patches[0], joined, b));
    hatch_arena_free(&frame.arena);
    hatch_arena_free(&frame.scratch);
}
END_TEST

static enum hatch_status join(void *context, struct hatch_arena *keep, struct hatch_arena *scratch,
                              struct hatch_err *err)
{
    struct hatch_scene *scene = context, before = *scene;
    struct hatch_node node = scene->nodes[0];
    enum hatch_status status = patches_join(scene, keep, scratch, &patches, err);
    if (status == HATCH_OK) {
        *scene = before;
        scene->nodes[0] = node;
    }
    return status;
}

START_TEST(joining_survives_every_failed_allocation)
{
    begin();
    struct hatch_mesh sphere = shape_of(HATCH_SHAPE_SPHERE, 100);
    make_scene(&sphere, &caps);
    ck_assert_uint_gt(hatch_test_fail_alloc(join, &frame.scene, &frame.scene, sizeof frame.scene), 20);
    hatch_arena_free(&frame.arena);
    hatch_arena_free(&frame.scratch);
}
END_TEST

/* Draws tone and lines of what frame holds. */
static void draw_lines(struct hatch_image *image)
{
    const struct line_style style = {
        .kinds = LINES_ALL, .asked = true, .width_px = 2, .crease_rad = 0.7};
    struct lines lines;
    HATCH_TEST_OK(lines_make(&frame.gpu, &style, &frame.renderer.shaders, (uint64_t)1 << 30,
                             &frame.arena, &frame.scratch, &lines, &frame.err),
                  &frame.err);
    frame.renderer.lines = &lines;
    draw_in_tiles("gouraud", 160, 2, image);
    frame.renderer.lines = NULL;
    lines_free(&lines);
}

START_TEST(lines_see_the_surface_once)
{
    struct hatch_image lapped, plain, none;
    begin();
    fill_mask();
    struct hatch_mesh mesh = shape_of(_i ? HATCH_SHAPE_PLANE : HATCH_SHAPE_SPHERE, 500);
    const struct cut planes = {.count = 3, .materials = 1, .place = place_shifted};
    begin_lapped(&mesh, _i ? &planes : &caps);
    frame.renderer.style.curve.high = 0.2;
    draw_lines(&lapped);
    renderer_free(&frame.renderer);
    scene_free(&frame.gpu);
    context_close(&frame.context);
    frame_begin(&mesh, &frame_unit, NULL, &frame);
    frame.renderer.style.curve.high = 0.2;
    frame.scene.meshes[0].had_normals = true;
    draw_lines(&plain);
    draw_in_tiles("gouraud", 160, 2, &none);
    ck_assert_double_gt(worst_difference(&plain, &none), 0.5);
    ck_assert_double_le(worst_difference(&lapped, &plain), 1.0 / 255);
    frame_end(&frame);
}
END_TEST

START_TEST(turning_strokes_is_turning_texture_coordinates)
{
    struct hatch_image turned, other;
    begin();
    struct hatch_mesh mesh = shape_of(HATCH_SHAPE_PLANE, 50);
    float *texcoord = hatch_mesh_find(&mesh, "TEXCOORD_0", 2), unused[2];
    for (size_t v = 0; v < mesh.vertex_count; v++)
        place_shifted(0, mesh.attributes[0].data + 3 * v, texcoord + 2 * v, unused);
    frame_begin(&mesh, &frame_unit, &map, &frame);
    frame.renderer.style.curve.low = frame.renderer.style.curve.high = 0.5;
    frame.renderer.style.hatch_turn_rad = 1.57079632679489662;
    frame.renderer.style.hatch_scale = 0.5;
    frame_draw(&frame, "tam", &map_facing, SIZE, SIZE, 1, &turned);
    renderer_free(&frame.renderer);
    scene_free(&frame.gpu);
    context_close(&frame.context);
    /* Against the clock as one sees it: what ran to the right along u runs upwards, where v falls. */
    for (size_t v = 0; v < mesh.vertex_count; v++) {
        float *t = texcoord + 2 * v, u = t[0];
        t[0] = -2 * t[1];
        t[1] = 2 * u;
    }
    frame_begin(&mesh, &frame_unit, &map, &frame);
    frame.renderer.style.curve.low = frame.renderer.style.curve.high = 0.5;
    frame_draw(&frame, "tam", &map_facing, SIZE, SIZE, 1, &other);
    ck_assert_double_gt(ink_of(&other), 0.2);
    ck_assert_double_le(worst_difference(&turned, &other), 1.0 / 255);
    frame_end(&frame);
}
END_TEST

/* Two spheres, one in a node that makes it three times as large. */
START_TEST(strokes_have_one_size_on_all_patches)
{
    begin();
    struct hatch_mesh sphere = shape_of(HATCH_SHAPE_SPHERE, 500);
    make_scene(&sphere, &caps);
    struct hatch_node *nodes = HATCH_NEW(&frame.arena, struct hatch_node, 2, &frame.err);
    nodes[0] = nodes[1] = frame.scene.nodes[0];
    for (int k = 0; k < 3; k++)
        nodes[1].scale[k] = 3;
    frame.scene.nodes = nodes;
    frame.scene.node_count = 2;
    HATCH_TEST_OK(patches_join(&frame.scene, &frame.arena, &frame.scratch, &patches, &frame.err),
                  &frame.err);
    frame_begin_scene(patches, &frame_unit, &map, &frame);
    ck_assert_uint_eq(frame.gpu.item_count, 2);
    HATCH_TEST_OK(repeat_set(&frame.gpu, 0, &map_facing, 300, SIZE, 3, &frame.scratch, &frame.err),
                  &frame.err);
    ck_assert_double_eq_tol((double)frame.gpu.items[1].repeat[0] / (double)frame.gpu.items[0].repeat[0], 3, 1e-3);
    /* 150 pixels to a unit; a unit of the hatch coordinates is one of the small sphere. */
    ck_assert_double_eq_tol((double)frame.gpu.items[0].repeat[0], 150.0 / SIZE, 0.05 * 150.0 / SIZE);
    frame_end(&frame);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("render lapped");
    TCase *tests = tcase_create("lapped");
    tcase_add_loop_test(tests, patches_lie_over_one_another, 0, 5);
    tcase_add_test(tests, patches_of_two_materials_too);
    tcase_add_loop_test(tests, one_patch_is_ordinary_texture_coordinates, 0, 7);
    tcase_add_loop_test(tests, both_ways_to_blend_agree, 1, 3);
    tcase_add_test(tests, nothing_shows_through_patches);
    tcase_add_test(tests, joined_patches_are_the_surface);
    tcase_add_test(tests, joining_survives_every_failed_allocation);
    tcase_add_loop_test(tests, lines_see_the_surface_once, 0, 2);
    tcase_add_test(tests, turning_strokes_is_turning_texture_coordinates);
    tcase_add_test(tests, strokes_have_one_size_on_all_patches);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
