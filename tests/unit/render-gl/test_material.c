/* Items that use a texture in the same way share it on the GPU; others have one of their own. */
#include <unistd.h>

#include "io/png/png.h"
#include "render-gl/scene/material.h"
#include "render-gl/scene/normals.h"
#include "render_frame.h"

/* How an item uses a texture. */
struct use {
    uint32_t texture; /* HATCH_NONE: the item has no material */
    enum hatch_wrap wrap[2];
    bool patches;
    uint32_t same; /* index of the first item that uses it in the same way */
};

enum { USES = 12, SIDE = 16, KEPT = 6 };

static const struct use uses[USES] = {
    {0, {HATCH_WRAP_REPEAT, HATCH_WRAP_REPEAT}, false, 0}, {0, {HATCH_WRAP_REPEAT, HATCH_WRAP_REPEAT}, true, 1},
    {0, {HATCH_WRAP_CLAMP, HATCH_WRAP_REPEAT}, false, 2},  {0, {HATCH_WRAP_REPEAT, HATCH_WRAP_CLAMP}, false, 3},
    {1, {HATCH_WRAP_REPEAT, HATCH_WRAP_REPEAT}, false, 4}, {HATCH_NONE, {HATCH_WRAP_REPEAT}, false, 5},
    {0, {HATCH_WRAP_REPEAT, HATCH_WRAP_REPEAT}, false, 0}, {0, {HATCH_WRAP_REPEAT, HATCH_WRAP_REPEAT}, true, 1},
    {0, {HATCH_WRAP_REPEAT, HATCH_WRAP_CLAMP}, false, 3},  {1, {HATCH_WRAP_REPEAT, HATCH_WRAP_REPEAT}, false, 4},
    {1, {HATCH_WRAP_MIRROR, HATCH_WRAP_CLAMP}, false, 10}, {1, {HATCH_WRAP_MIRROR, HATCH_WRAP_CLAMP}, false, 10},
};

static struct test_frame frame;

/* Makes a texture whose least alpha is a half. */
static struct hatch_texture make_texture(uint32_t width)
{
    struct hatch_arena *keep = &frame.args.keep;
    struct hatch_image image;
    struct hatch_buffer file = {.arena = keep};
    HATCH_TEST_OK(hatch_image_make(keep, width, SIDE, "RGBA", &image, &frame.err), &frame.err);
    for (uint32_t i = 0; i < 4 * width * SIDE; i++)
        image.pixels[i] = i == 3 ? 128.0f / 255 : 1;
    HATCH_TEST_OK(hatch_png_write(&image, HATCH_PNG_SRGB, 8, NULL, &frame.args.scratch, &file, &frame.err), &frame.err);
    return (struct hatch_texture){.data = file.data, .size = file.size};
}

/* Opens a scene of an item for each of the uses, with their textures. */
static void begin_uses(void)
{
    static const struct hatch_patch_mesh patches = {0};
    frame_arenas(&frame);
    struct hatch_arena *keep = &frame.args.keep;
    struct hatch_scene *scene = &frame.scene;
    struct hatch_mesh mesh = frame_plane(&frame, 2);
    HATCH_TEST_OK(hatch_scene_of_mesh(&mesh, keep, scene, &frame.err), &frame.err);
    const struct hatch_scene_mesh first = scene->meshes[0];
    const struct hatch_node node = scene->nodes[0];
    scene->mesh_count = scene->node_count = scene->material_count = USES;
    scene->texture_count = 2;
    scene->meshes = HATCH_NEW(keep, struct hatch_scene_mesh, USES, &frame.err);
    scene->nodes = HATCH_NEW(keep, struct hatch_node, USES, &frame.err);
    scene->materials = HATCH_NEW(keep, struct hatch_material, USES, &frame.err);
    scene->textures = HATCH_NEW(keep, struct hatch_texture, 2, &frame.err);
    ck_assert(scene->meshes && scene->nodes && scene->materials && scene->textures);
    for (uint32_t i = 0; i < USES; i++) {
        scene->meshes[i] = first;
        scene->meshes[i].material = uses[i].texture == HATCH_NONE ? HATCH_NONE : i;
        scene->nodes[i] = node;
        scene->nodes[i].first_mesh = i;
        scene->materials[i] =
            (struct hatch_material){.base_color = {1, 1, 1, 1},
                                    .alpha_cutoff = 0.75f,
                                    .base = {.texture = uses[i].texture, .wrap = {uses[i].wrap[0], uses[i].wrap[1]}}};
    }
    scene->textures[0] = make_texture(SIDE);
    scene->textures[1] = make_texture(2 * SIDE);
    frame_open_scene(NULL, &frame_unit, NULL, &frame);
    for (uint32_t i = 0; i < USES; i++)
        frame.on_gpu.unit.meshes[i].patches = uses[i].patches ? &patches : NULL;
}

static void check_unchanged(struct hatch_arena_mark before)
{
    struct hatch_arena_mark after = hatch_arena_mark(&frame.args.keep);
    ck_assert(after.block == before.block && after.block_used == before.block_used);
}

START_TEST(items_share_textures_that_they_use_alike)
{
    begin_uses();
    struct scene *scene = &frame.on_gpu;
    struct hatch_arena_mark before = hatch_arena_mark(&frame.args.keep);
    material_upload(&frame.args, "test", true, frame.context.size_max_px, scene);
    check_unchanged(before);
    for (uint32_t i = 0; i < USES; i++) {
        const struct scene_item *item = &scene->items[i];
        ck_assert_int_eq(item->base_texture != 0, uses[i].texture != HATCH_NONE);
        for (uint32_t k = 0; k < i && item->base_texture; k++)
            ck_assert_msg((scene->items[k].base_texture == item->base_texture) == (uses[k].same == uses[i].same),
                          "items %u and %u", k, i);
        if (item->base_texture) {
            ck_assert_float_eq(item->base_side_px, uses[i].texture ? 2 * SIDE : SIDE);
            ck_assert_float_eq_tol(item->base_alpha, 128.0f / 255, 1e-6f);
            ck_assert_float_eq_tol(item->base_lod, log2f(item->base_side_px / 2), 1e-6f); /* of four vertices */
            ck_assert(scene->unit.items[i].cut_out);
        }
    }
    frame_finish(&frame);
}
END_TEST

/* With a lower cutoff, items of the first texture have no holes, and get the picture. One of two that share a name
 * keeps its holes, and therefore the name. */
START_TEST(one_picture_replaces_the_textures_of_items_without_holes)
{
    char path[] = "/tmp/test_material_XXXXXX";
    begin_uses();
    const struct hatch_texture file = make_texture(4 * SIDE);
    int descriptor = mkstemp(path);
    ck_assert(descriptor >= 0 && write(descriptor, file.data, file.size) == (ssize_t)file.size);
    close(descriptor);
    struct scene *scene = &frame.on_gpu;
    for (uint32_t i = 0; i < USES; i++)
        if (uses[i].texture == 0 && i != KEPT)
            scene->unit.items[i].alpha_cutoff = 0.25f;
    material_upload(&frame.args, "test", true, frame.context.size_max_px, scene);
    GLuint shared = scene->items[KEPT].base_texture, alone = scene->items[2].base_texture;
    ck_assert_uint_eq(scene->items[0].base_texture, shared);
    struct hatch_arena_mark before = hatch_arena_mark(&frame.args.keep);
    material_modulate(&frame.args, path, frame.context.size_max_px, scene);
    remove(path);
    check_unchanged(before);
    for (uint32_t i = 0; i < USES; i++) {
        const struct scene_item *item = &scene->items[i];
        bool kept = uses[i].patches || i == KEPT || uses[i].texture == 1;
        ck_assert_msg((item->base_texture == scene->items[0].base_texture) == !kept, "item %u", i);
        ck_assert(glIsTexture(item->base_texture));
        ck_assert_float_eq(item->base_side_px, !kept ? 4 * SIDE : uses[i].texture ? 2 * SIDE : SIDE);
    }
    ck_assert_uint_eq(scene->items[KEPT].base_texture, shared);
    ck_assert(!glIsTexture(alone));
    frame_finish(&frame);
}
END_TEST

/* Returns the number of allocations in args.keep while holes are found. */
static uint64_t find_holes(void)
{
    const uint64_t many = 1000000;
    struct hatch_arena_mark before = hatch_arena_mark(&frame.args.keep);
    hatch_arena_fail_after(&frame.args.keep, many);
    material_find_holes(&frame.args, "test", &frame.on_gpu.unit);
    uint64_t made = many - frame.args.keep.fail_countdown;
    hatch_arena_fail_after(&frame.args.keep, 0);
    check_unchanged(before);
    return made;
}

/* Without a context, too, each texture is decoded once, and nothing of it is kept. */
START_TEST(holes_are_found_by_the_least_alpha)
{
    begin_uses();
    struct hatch_unit_scene *unit = &frame.on_gpu.unit;
    unit->items[0].alpha_cutoff = 0.5f;
    unit->items[4].alpha_cutoff = 0;
    uint64_t all = find_holes();
    for (uint32_t i = 0; i < USES; i++)
        ck_assert_int_eq(unit->items[i].cut_out, i != 0 && i != 4 && uses[i].texture != HATCH_NONE);
    for (uint32_t i = 0; i < USES; i++)
        if (i != 2 && i != 9)
            unit->items[i].alpha_cutoff = 0;
    ck_assert_uint_eq(find_holes(), all); /* one item of each texture */
    frame_finish(&frame);
}
END_TEST

/* Items whose normal maps are the same texture with the same wrapping share it. The texels are not kept. */
START_TEST(items_share_normal_maps)
{
    begin_uses();
    struct scene *scene = &frame.on_gpu;
    for (uint32_t i = 0; i < USES; i++) {
        frame.scene.materials[i].normals.at = frame.scene.materials[i].base;
        frame.scene.materials[i].normals.used = true;
        frame.scene.materials[i].normals.strength = 1;
    }
    struct hatch_arena_mark before = hatch_arena_mark(&frame.args.keep);
    const struct hatch_normal_map *map = &frame.scene.materials[0].normals;
    GLuint alone = material_normals(&frame.args, "test", &frame.scene, map, frame.context.size_max_px);
    glDeleteTextures(1, &alone);
    check_unchanged(before);
    normals_upload(&frame.args, "test", frame.context.size_max_px, scene);
    for (uint32_t i = 0; i < USES; i++)
        for (uint32_t k = 0; k < i; k++) {
            const struct use *a = &uses[i], *b = &uses[k];
            bool same = a->texture == b->texture && a->wrap[0] == b->wrap[0] && a->wrap[1] == b->wrap[1];
            ck_assert_msg((scene->items[i].normals == scene->items[k].normals) == same, "items %u and %u", k, i);
        }
    frame_finish(&frame);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("render material");
    TCase *tests = tcase_create("material");
    tcase_add_test(tests, items_share_textures_that_they_use_alike);
    tcase_add_test(tests, one_picture_replaces_the_textures_of_items_without_holes);
    tcase_add_test(tests, holes_are_found_by_the_least_alpha);
    tcase_add_test(tests, items_share_normal_maps);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
