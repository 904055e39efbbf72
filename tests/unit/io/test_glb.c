/* Scenes written as GLB and read again. */
#include <stdio.h>
#include <string.h>

#include "fail_alloc.h"
#include "io/glb/glb.h"
#include "io/gltf/gltf.h"
#include "meshes.h"

static struct hatch_scene full, back;

static const uint8_t png[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 1, 2, 3};
static const uint8_t jpeg[] = {0xff, 0xd8, 0xff, 0xe0, 0, 16, 'J', 'F', 'I', 'F', 0, 4};
static const uint8_t gif[] = {'G', 'I', 'F', '8', '9', 'a', 1, 0, 1, 0, 0, 0, 0};

static struct hatch_scene_mesh scene_meshes[5];
static struct hatch_node nodes[7];
static struct hatch_material materials[4];
static struct hatch_texture textures[4];
static struct hatch_camera cameras[3];
static struct hatch_light lights[3];
static struct hatch_skin skins[1];
static struct hatch_animation_channel channels[4];
static struct hatch_animation animations[1];
static uint32_t joints[2] = {3, 5};
static float inverse_bind[32], times[3] = {0, 0.1f, 2.5f}, values[36], weights[2] = {0.25f, 0};

static void make_meshes(void)
{
    const struct hatch_shape_options options = {.faces = 12, .jitter = 0.3f};
    for (uint32_t i = 0; i < 5; i++) {
        struct hatch_mesh *mesh = &scene_meshes[i].mesh;
        HATCH_TEST_OK(
            hatch_shape_make(i % 2 ? HATCH_SHAPE_TORUS : HATCH_SHAPE_PLANE, &options, &keep, &scratch, mesh, &err),
            &err);
        scene_meshes[i].material = i == 4 ? HATCH_NONE : i;
        scene_meshes[i].file_vertices = mesh->vertex_count;
        scene_meshes[i].had_texcoords = scene_meshes[i].had_normals = true;
    }
    add_joints(&scene_meshes[3].mesh);
    add_targets(&scene_meshes[4].mesh);
    scene_meshes[3].joints_used = 2;
}

/* Nodes 1 and 2 use meshes 0 and 1; node 6 mesh 2; mesh 3 has a skin; mesh 4 a node with a matrix. */
static void make_nodes(void)
{
    static const struct hatch_node plain = {.parent = HATCH_NONE,
                                            .rotation = {0, 0, 0, 1},
                                            .scale = {1, 1, 1},
                                            .skin = HATCH_NONE,
                                            .camera = HATCH_NONE,
                                            .light = HATCH_NONE};
    static const uint32_t parents[] = {HATCH_NONE, HATCH_NONE, 0, 0, 1, 3, 4};
    for (uint32_t i = 0; i < 7; i++) {
        nodes[i] = plain;
        nodes[i].parent = parents[i];
        nodes[i].translation[i % 3] = 0.1f * (float)i;
    }
    nodes[1].rotation[0] = nodes[1].rotation[3] = 0.70710678f;
    nodes[2].scale[1] = -1.0f / 3;
    nodes[1].mesh_count = nodes[2].mesh_count = 2;
    nodes[3].first_mesh = 3;
    nodes[3].mesh_count = 1;
    nodes[3].skin = 0;
    nodes[4].has_matrix = true;
    memset(nodes[4].translation, 0, sizeof nodes[4].translation);
    for (uint32_t i = 0; i < 16; i++)
        nodes[4].matrix[i] = i % 5 == 0 ? 1 : i == 12 ? 1e-7f : 0;
    nodes[4].first_mesh = 4;
    nodes[4].mesh_count = 1;
    nodes[5].camera = 1;
    nodes[6].light = 2;
    nodes[6].first_mesh = 2;
    nodes[6].mesh_count = 1;
    nodes[0].light = 0;
}

static void make_materials(void)
{
    textures[0] = (struct hatch_texture){.data = png, .size = sizeof png};
    textures[1] = (struct hatch_texture){.data = jpeg, .size = sizeof jpeg};
    static const struct hatch_material made[] = {
        {.base_color = {1, 1, 1, 1},
         .base.wrap = {HATCH_WRAP_REPEAT, HATCH_WRAP_REPEAT},
         .normals = {true,
                     {.texture = 1,
                      .texcoord = 2,
                      .wrap = {HATCH_WRAP_CLAMP, HATCH_WRAP_MIRROR},
                      .has_transform = true,
                      .scale = {-1, 3},
                      .turn_rad = 0.1f,
                      .offset = {0.2f, 0.3f}},
                     0.7f}},
        {.base_color = {0.1f, 1.0f / 3, 1, 0.5f},
         .base.texture = 1,
         .base.texcoord = 1,
         .base.wrap = {HATCH_WRAP_MIRROR, HATCH_WRAP_REPEAT},
         .double_sided = true,
         .alpha_cutoff = 0.25f,
         .base.has_transform = true,
         .base.scale = {2, -0.1f},
         .base.turn_rad = 0.3f,
         .base.offset = {0.7f, 0}},
        {.base_color = {1, 1, 1, 1},
         .base.texcoord = 1,
         .base.wrap = {HATCH_WRAP_CLAMP, HATCH_WRAP_CLAMP},
         .outline = true},
        {.base_color = {0.2f, 0.3f, 0.4f, 1},
         .base.texture = HATCH_NONE,
         .base.wrap = {HATCH_WRAP_REPEAT, HATCH_WRAP_REPEAT},
         .alpha_cutoff = 0.5f,
         .blend = true,
         .normals = {true, {.wrap = {HATCH_WRAP_REPEAT, HATCH_WRAP_REPEAT}}, 1}},
    };
    memcpy(materials, made, sizeof made);
    cameras[0] = (struct hatch_camera){.yfov_rad = 0.7f, .aspect = 1.7777778f, .znear = 0.01f};
    cameras[1] = (struct hatch_camera){.orthographic = true, .ymag = 0.3f, .aspect = 1.1f, .zfar = 9};
    cameras[2] = (struct hatch_camera){.yfov_rad = 1.2f, .znear = 0.1f, .zfar = 100};
    for (int i = 0; i < 3; i++)
        lights[i] = (struct hatch_light){.type = (enum hatch_light_type)i,
                                         .color = {1, 0.9f, 0.1f},
                                         .intensity = 3.3f,
                                         .outer_cone_rad = 0.78539816f};
    lights[1].range = 12.5f;
    lights[2].inner_cone_rad = 0.1f;
    lights[2].outer_cone_rad = 0.2f;
}

static void make_motion(void)
{
    for (uint32_t i = 0; i < 32; i++)
        inverse_bind[i] = i % 16 % 5 == 0 ? 1 : i % 4 == 3 ? 0 : 0.01f * (float)i;
    for (uint32_t i = 0; i < 36; i++)
        values[i] = i % 4 == 3 ? 0.6f : 0.8f - 0.8f * (float)(i % 4 > 0);
    skins[0] = (struct hatch_skin){.joint_count = 2, .joints = joints, .inverse_bind = inverse_bind};
    static const enum hatch_interpolation interpolations[] = {HATCH_STEP, HATCH_CUBIC, HATCH_LINEAR};
    for (uint32_t i = 0; i < 3; i++)
        channels[i] =
            (struct hatch_animation_channel){i, (enum hatch_channel_path)i, interpolations[i], 3, times, values, 0};
    channels[3] = (struct hatch_animation_channel){4, HATCH_PATH_WEIGHTS, HATCH_CUBIC, 3, times, values, 2};
    animations[0] = (struct hatch_animation){.channel_count = 4, .channels = channels, .duration_s = 2.5f};
}

static void begin_scene(void)
{
    begin();
    make_meshes();
    make_nodes();
    make_materials();
    make_motion();
    full = (struct hatch_scene){.mesh_count = 5,
                                .node_count = 7,
                                .material_count = 4,
                                .texture_count = 2,
                                .camera_count = 3,
                                .light_count = 3,
                                .skin_count = 1,
                                .animation_count = 1,
                                .meshes = scene_meshes,
                                .nodes = nodes,
                                .materials = materials,
                                .textures = textures,
                                .cameras = cameras,
                                .lights = lights,
                                .skins = skins,
                                .animations = animations};
}

static struct hatch_buffer written(const struct hatch_scene *scene)
{
    struct hatch_buffer file = {.arena = &keep};
    HATCH_TEST_OK(hatch_glb_write_scene(scene, "a \"comment\"", &scratch, &file, &err), &err);
    return file;
}

static struct hatch_buffer write_and_read(const struct hatch_scene *scene)
{
    struct hatch_mesh_notes notes = {0};
    struct hatch_buffer file = written(scene);
    HATCH_TEST_OK(
        hatch_gltf_read((struct hatch_bytes){file.data, file.size}, NULL, &keep, &scratch, &back, &notes, &err), &err);
    return file;
}

/* The weights of the only node with a mesh are its weights at rest. */
START_TEST(weights_at_rest_are_applied)
{
    nodes[4].weights = weights;
    write_and_read(&full);
    const struct hatch_mesh *was = &full.meshes[4].mesh, *is = &back.meshes[4].mesh;
    const float *displacements = hatch_mesh_find(was, HATCH_MORPH_POSITION, 6);
    ck_assert_ptr_null(back.nodes[4].weights);
    for (size_t i = 0; i < 3 * (size_t)was->vertex_count; i++)
        ck_assert_float_eq(is->attributes[0].data[i],
                           was->attributes[0].data[i] + 0.25f * displacements[i / 3 * 6 + i % 3]);
    ck_assert_float_eq(back.animations[0].channels[3].values[2], values[2] - 0.25f);
    ck_assert_float_eq(back.animations[0].channels[3].values[3], values[3]);
    ck_assert_float_eq(back.animations[0].channels[3].values[4], values[4]); /* a tangent */
}
END_TEST

static void same_floats(const float *a, const float *b, size_t count)
{
    ck_assert_mem_eq(a, b, count * sizeof *a);
}

START_TEST(meshes_survive_a_round_trip)
{
    write_and_read(&full);
    ck_assert_uint_eq(back.mesh_count, 5);
    for (uint32_t m = 0; m < 5; m++) {
        const struct hatch_mesh *a = &full.meshes[m].mesh, *b = &back.meshes[m].mesh;
        ck_assert_uint_eq(b->vertex_count, a->vertex_count);
        ck_assert_uint_eq(b->attribute_count, a->attribute_count);
        ck_assert_mem_eq(b->indices, a->indices, (size_t)a->face_count * 12);
        for (uint32_t i = 0; i < a->attribute_count; i++) {
            const struct hatch_mesh_attribute *at = &a->attributes[i];
            const float *data = hatch_mesh_find(b, at->name, at->components);
            ck_assert_msg(data != NULL, "%s is lost", at->name);
            same_floats(data, at->data, (size_t)a->vertex_count * at->components);
        }
        ck_assert_uint_eq(back.meshes[m].material, full.meshes[m].material);
        ck_assert_uint_eq(back.meshes[m].joints_used, full.meshes[m].joints_used);
    }
}
END_TEST

START_TEST(nodes_survive_a_round_trip)
{
    write_and_read(&full);
    ck_assert_uint_eq(back.node_count, 7);
    for (uint32_t n = 0; n < 7; n++)
        ck_assert_msg(memcmp(&back.nodes[n], &full.nodes[n], sizeof *nodes) == 0, "node %u", n);
}
END_TEST

static void same_use(const struct hatch_texture_use *a, const struct hatch_texture_use *b)
{
    ck_assert_uint_eq(a->texture, b->texture);
    ck_assert_uint_eq(a->texcoord, b->texcoord);
    ck_assert(a->wrap[0] == b->wrap[0] && a->wrap[1] == b->wrap[1]);
    ck_assert(a->has_transform == b->has_transform && a->turn_rad == b->turn_rad);
    same_floats(a->scale, b->scale, 2);
    same_floats(a->offset, b->offset, 2);
}

START_TEST(materials_cameras_and_lights_survive_a_round_trip)
{
    write_and_read(&full);
    ck_assert_uint_eq(back.texture_count, 2);
    for (uint32_t t = 0; t < 2; t++) {
        ck_assert_uint_eq(back.textures[t].size, textures[t].size);
        ck_assert_mem_eq(back.textures[t].data, textures[t].data, textures[t].size);
    }
    ck_assert_uint_eq(back.material_count, 4);
    for (uint32_t m = 0; m < 4; m++) {
        const struct hatch_material *a = &materials[m], *b = &back.materials[m];
        same_floats(a->base_color, b->base_color, 4);
        same_use(&a->base, &b->base);
        ck_assert(a->normals.used == b->normals.used);
        if (a->normals.used) {
            same_use(&a->normals.at, &b->normals.at);
            ck_assert_float_eq(a->normals.strength, b->normals.strength);
        }
        ck_assert(a->double_sided == b->double_sided && a->blend == b->blend);
        ck_assert(a->alpha_cutoff == b->alpha_cutoff && a->outline == b->outline);
    }
    ck_assert_uint_eq(back.camera_count, 3);
    ck_assert_mem_eq(back.lights, lights, sizeof lights);
    for (uint32_t c = 0; c < 3; c++) {
        const struct hatch_camera *a = &cameras[c], *b = &back.cameras[c];
        ck_assert(a->orthographic == b->orthographic && a->yfov_rad == b->yfov_rad && a->ymag == b->ymag &&
                  a->aspect == b->aspect && a->znear == b->znear && a->zfar == b->zfar);
    }
}
END_TEST

START_TEST(skins_and_animations_survive_a_round_trip)
{
    write_and_read(&full);
    ck_assert_uint_eq(back.skin_count, 1);
    ck_assert_mem_eq(back.skins[0].joints, joints, sizeof joints);
    same_floats(back.skins[0].inverse_bind, inverse_bind, 32);
    ck_assert_uint_eq(back.animation_count, 1);
    ck_assert_uint_eq(back.animations[0].channel_count, 4);
    ck_assert_float_eq(back.animations[0].duration_s, 2.5f);
    for (uint32_t c = 0; c < 4; c++) {
        const struct hatch_animation_channel *a = &channels[c], *b = &back.animations[0].channels[c];
        ck_assert(a->node == b->node && a->path == b->path && a->interpolation == b->interpolation);
        same_floats(b->times_s, times, 3);
        ck_assert_uint_eq(b->targets, a->targets);
        same_floats(b->values, values, (a->interpolation == HATCH_CUBIC ? 9u : 3u) * hatch_channel_width(a));
    }
}
END_TEST

/* Regardless of the attributes' order, and with a minus zero, which JSON readers read as 0. */
START_TEST(a_copy_has_the_same_bytes)
{
    nodes[4].matrix[1] = -0.0f;
    struct hatch_buffer first = write_and_read(&full);
    struct hatch_buffer second = written(&back);
    ck_assert_uint_eq(second.size, first.size);
    ck_assert_mem_eq(second.data, first.data, first.size);
}
END_TEST

/* Without the second node, the file lacks just that node's reference. */
START_TEST(a_mesh_of_two_nodes_is_written_once)
{
    struct hatch_buffer both = written(&full);
    nodes[2].mesh_count = 0;
    struct hatch_buffer once = written(&full);
    ck_assert_uint_le(both.size - once.size, sizeof ",\"mesh\":0" + 3);
    ck_assert_uint_gt(both.size, once.size);
}
END_TEST

/* Any UTF-8, and numbered sets after the first. */
START_TEST(meshes_without_nodes_survive_a_round_trip)
{
    full.node_count = full.skin_count = full.animation_count = 0;
    write_and_read(&full);
    ck_assert_uint_eq(back.mesh_count, 5);
    ck_assert_uint_eq(back.node_count, 0);
    nodes[6].mesh_count = 0;
    full.node_count = 7;
    full.skin_count = 1;
    struct hatch_buffer one_unused = written(&full);
    nodes[6].mesh_count = 1;
    struct hatch_buffer all_used = written(&full);
    ck_assert_uint_le(all_used.size - one_unused.size, sizeof ",\"mesh\":0" + 3);
}
END_TEST

START_TEST(attribute_names_are_kept)
{
    static const char *const names[] = {"_A \"name\"\\\n", "_\xc3\xa9t\xc3\xa9", "COLOR_1", "JOINTS_1", "TEXCOORD_7"};
    struct hatch_mesh *mesh = &scene_meshes[4].mesh;
    float *data[5];
    for (uint32_t i = 0; i < 5; i++) {
        HATCH_TEST_OK(hatch_mesh_add(&keep, mesh, names[i], i == 4 ? 2 : 4, &data[i], &err), &err);
        data[i][1] = 3;
    }
    write_and_read(&full);
    for (uint32_t i = 0; i < 5; i++) {
        const float *read = hatch_mesh_find(&back.meshes[4].mesh, names[i], i == 4 ? 2 : 4);
        ck_assert_msg(read != NULL, "%s is lost", names[i]);
        ck_assert_float_eq(read[1], 3);
    }
    ck_assert_uint_eq(back.meshes[4].joints_used, 4);
}
END_TEST

START_TEST(surplus_attributes_are_counted)
{
    struct hatch_mesh *mesh = &scene_meshes[4].mesh;
    struct hatch_mesh_notes notes = {0};
    float *data;
    while (mesh->attribute_count < HATCH_MESH_ATTRIBUTES_READ + 2 + 2) { /* 2: morph targets, which do not count */
        char name[] = "_A";
        name[1] = (char)('A' + mesh->attribute_count);
        HATCH_TEST_OK(hatch_mesh_add(&keep, mesh, name, 1, &data, &err), &err);
    }
    struct hatch_buffer file = written(&full);
    HATCH_TEST_OK(
        hatch_gltf_read((struct hatch_bytes){file.data, file.size}, NULL, &keep, &scratch, &back, &notes, &err), &err);
    ck_assert_uint_eq(back.meshes[4].mesh.attribute_count, HATCH_MESH_ATTRIBUTES_READ + 2);
    ck_assert_uint_eq(notes.attributes_dropped, 2);
}
END_TEST

static bool contains(struct hatch_buffer file, const char *text)
{
    size_t length = strlen(text);
    for (size_t at = 0; at + length <= file.size; at++)
        if (memcmp(file.data + at, text, length) == 0)
            return true;
    return false;
}

/* min and max are those of the written values. */
START_TEST(bounds_are_exact)
{
    struct hatch_mesh *mesh = &scene_meshes[4].mesh;
    float *p = mesh->attributes[0].data;
    p[0] = 1.1754944e-38f;
    p[1] = 3.4028235e38f;
    p[2] = -16777217.0f / 3;
    struct hatch_buffer file = written(&full);
    char want[120];
    float low[3], high[3];
    ck_assert(hatch_mesh_bounds(mesh, low, high));
    snprintf(want, sizeof want, "\"min\":[%.9g,%.9g,%.9g],\"max\":[%.9g,%.9g,%.9g]", (double)low[0], (double)low[1],
             (double)low[2], (double)high[0], (double)high[1], (double)high[2]);
    ck_assert_msg(contains(file, want), "no %s", want);
}
END_TEST

/* References to them are removed, and later ones renumbered. */
START_TEST(unsupported_images_and_empty_skins_are_left_out)
{
    textures[2] = (struct hatch_texture){.data = gif, .size = sizeof gif};
    textures[3] = textures[1];
    textures[1] = (struct hatch_texture){.data = NULL, .size = 0};
    full.texture_count = 4;
    materials[1].base.texture = 2;
    materials[3].base.texture = 3;
    nodes[3].skin = HATCH_NONE;
    skins[0].joint_count = 0;
    animations[0].channel_count = 0;
    write_and_read(&full);
    ck_assert_uint_eq(back.texture_count, 2);
    ck_assert_mem_eq(back.textures[1].data, jpeg, sizeof jpeg);
    ck_assert_uint_eq(back.materials[1].base.texture, HATCH_NONE);
    ck_assert_uint_eq(back.materials[2].base.texture, 0);
    ck_assert_uint_eq(back.materials[3].base.texture, 1);
    ck_assert(back.materials[3].normals.used && !back.materials[0].normals.used);
    ck_assert_uint_eq(back.skin_count + back.animation_count, 0);
}
END_TEST

START_TEST(an_empty_scene_is_written)
{
    full = (struct hatch_scene){0};
    struct hatch_buffer file = write_and_read(&full);
    ck_assert_uint_lt(file.size, 200);
    ck_assert_uint_eq(back.node_count + back.mesh_count, 0);
}
END_TEST

START_TEST(meshes_without_faces_are_left_out)
{
    scene_meshes[0].mesh.face_count = scene_meshes[4].mesh.face_count = 0;
    write_and_read(&full);
    ck_assert_uint_eq(back.mesh_count, 3);
    ck_assert_uint_eq(back.nodes[1].mesh_count, 1);
    ck_assert_uint_eq(back.nodes[3].first_mesh, 2);
    ck_assert_uint_eq(back.nodes[4].mesh_count, 0);
}
END_TEST

/* The size is checked before the mesh's data, which do not exist, are read. */
START_TEST(over_four_gigabytes_are_refused)
{
    struct hatch_mesh *mesh = &scene_meshes[4].mesh;
    static float three[3];
    mesh->attribute_count = 1;
    mesh->attributes[0].data = three;
    mesh->vertex_count = 1;
    mesh->face_count = 1u << 30;
    struct hatch_buffer file = {.arena = &keep};
    ck_assert_int_eq(hatch_glb_write_scene(&full, NULL, &scratch, &file, &err), HATCH_LIMIT);
    ck_assert_msg(strstr(err.text, "a GLB file holds at most 4294967295") != NULL, "%s", err.text);
    ck_assert_uint_eq(file.size, 0);
}
END_TEST

static enum hatch_status write_one(void *context, struct hatch_arena *kept, struct hatch_arena *temporary,
                                   struct hatch_err *error)
{
    struct hatch_buffer file = {.arena = kept};
    return hatch_glb_write_scene(context, "x", temporary, &file, error);
}

START_TEST(every_failed_allocation_is_a_limit)
{
    hatch_test_fail_alloc(write_one, &full, &full, sizeof full);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("io glb");
    TCase *tests = tcase_create("glb");
    tcase_add_checked_fixture(tests, begin_scene, end);
    tcase_add_test(tests, meshes_survive_a_round_trip);
    tcase_add_test(tests, nodes_survive_a_round_trip);
    tcase_add_test(tests, materials_cameras_and_lights_survive_a_round_trip);
    tcase_add_test(tests, skins_and_animations_survive_a_round_trip);
    tcase_add_test(tests, weights_at_rest_are_applied);
    tcase_add_test(tests, a_copy_has_the_same_bytes);
    tcase_add_test(tests, a_mesh_of_two_nodes_is_written_once);
    tcase_add_test(tests, meshes_without_nodes_survive_a_round_trip);
    tcase_add_test(tests, attribute_names_are_kept);
    tcase_add_test(tests, surplus_attributes_are_counted);
    tcase_add_test(tests, bounds_are_exact);
    tcase_add_test(tests, unsupported_images_and_empty_skins_are_left_out);
    tcase_add_test(tests, an_empty_scene_is_written);
    tcase_add_test(tests, meshes_without_faces_are_left_out);
    tcase_add_test(tests, over_four_gigabytes_are_refused);
    tcase_add_test(tests, every_failed_allocation_is_a_limit);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
