/* Normal maps with one constant normal, under which the light on a plane is known. */
#include "render-gl/scene/normals.h"
#include "render_frame.h"
#include "render_map.h"

enum { SIZE = 16 };

static struct test_frame frame;
static bool is_skinned; /* the plane is skinned */
static float units = 1; /* of a skinned mesh's coordinates in a unit of its pose */
static const double to_light[3] = {0.48, 0.6, 0.64};

/* Opens a plane that faces the camera.
 *   turn      rotation of its texture coordinates in quarter turns, counter-clockwise
 *   mirrored  u is negated
 *   own       the mesh has TANGENT, and its texture coordinates are constant */
static void begin(int turn, bool mirrored, bool own)
{
    static const float quarter[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    frame_arenas(&frame);
    struct hatch_mesh mesh = frame_shape(&frame, HATCH_SHAPE_PLANE, 2);
    const float *position = hatch_mesh_find(&mesh, "POSITION", 3);
    float *texcoord = hatch_mesh_find(&mesh, "TEXCOORD_0", 2), *tangent = hatch_mesh_find(&mesh, "TANGENT", 4);
    const float *along = quarter[turn];
    for (size_t v = 0; v < mesh.vertex_count; v++) {
        float x = position[3 * v], y = position[3 * v + 1];
        float u = along[0] * x + along[1] * y, up = along[0] * y - along[1] * x;
        texcoord[2 * v] = own ? 0 : mirrored ? -u : u;
        texcoord[2 * v + 1] = own ? 0 : -up;
        memcpy(tangent + 4 * v,
               (float[4]){mirrored ? -along[0] : along[0], mirrored ? -along[1] : along[1], 0, mirrored ? -1.0f : 1.0f},
               16);
    }
    for (uint32_t i = 0; !own && i < mesh.attribute_count; i++)
        if (strcmp(mesh.attributes[i].name, "TANGENT") == 0)
            mesh.attributes[i] = mesh.attributes[--mesh.attribute_count];
    if (is_skinned) {
        for (size_t k = 0; k < 3 * (size_t)mesh.vertex_count; k++)
            mesh.attributes[0].data[k] *= units;
        frame_skin(&mesh, &frame);
        for (int k = 0; k < 32; k++)
            frame.scene.skins[0].inverse_bind[k] /= k % 16 < 12 ? units : 1;
        frame_open_scene(NULL, &frame_unit, NULL, &frame);
    } else {
        frame_open(&mesh, &frame_unit, NULL, &frame);
    }
    frame.shown.style.pixel_light = true;
    frame.shown.style.light = (struct hatch_key_light){
        .replaces = true, .azimuth_rad = atan2(to_light[0], to_light[2]), .elevation_rad = asin(to_light[1])};
}

static void set_normal(double x, double y, double z, double strength)
{
    const float texel[4] = {(float)(0.5 + 0.5 * x), (float)(0.5 + 0.5 * y), (float)(0.5 + 0.5 * z), 1};
    const struct hatch_normal_map map = {.used = true, .strength = (float)strength};
    GLuint texture;
    glCreateTextures(GL_TEXTURE_2D, 1, &texture);
    glTextureStorage2D(texture, 1, GL_RGBA32F, 1, 1);
    glTextureSubImage2D(texture, 0, 0, 0, 1, 1, GL_RGBA, GL_FLOAT, texel);
    HATCH_TEST_OK(normals_set(&frame.on_gpu, 0, &map, texture, &frame.args.keep, &frame.args.scratch, &frame.err),
                  &frame.err);
}

static double light(void)
{
    struct hatch_image image;
    frame_draw(&frame, "gouraud", &view_facing, SIZE, SIZE, 1, &image);
    return (double)image.pixels[3 * (SIZE / 2 * SIZE + SIZE / 2)];
}

/* glTF 2.0: x of the map points along increasing u, y along decreasing v. */
START_TEST(normal_maps_tilt_the_normal_as_gltf_defines)
{
    static const double tilts[][3] = {{0.6, 0, 0.8}, {0, 0.6, 0.8}, {-0.36, 0.48, 0.8}, {0.8, -0.36, 0.48}};
    static const double along[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (int turn = 0; turn < 4; turn++)
        for (int kind = 0; kind < 4; kind++)
            for (size_t i = 0; i < sizeof tilts / sizeof *tilts; i++) {
                double strength = i == 2 ? 0.5 : 1, x = strength * tilts[i][0], y = strength * tilts[i][1];
                double u = kind % 2 ? -x : x; /* along u before it is mirrored */
                double normal[3] = {along[turn][0] * u - along[turn][1] * y, along[turn][1] * u + along[turn][0] * y,
                                    tilts[i][2]};
                double size = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]), want = 0;
                for (int k = 0; k < 3; k++)
                    want += normal[k] / size * to_light[k];
                begin(turn, kind % 2, kind / 2);
                set_normal(tilts[i][0], tilts[i][1], tilts[i][2], strength);
                double got = light();
                ck_assert_msg(fabs(got - fmax(want, 0)) <= 1.0 / 255, "turn %d, kind %d, tilt %zu: %g, not %g", turn,
                              kind, i, got, want);
                frame_finish(&frame);
            }
}
END_TEST

/* Eight bits have no exact zero, so 128 is not quite flat. */
START_TEST(a_flat_normal_map_changes_nothing)
{
    begin(0, false, false);
    double bare = light();
    set_normal(128 / 127.5 - 1, 128 / 127.5 - 1, 1, 1);
    ck_assert_double_eq_tol(light(), bare, 1.0 / 255);
    frame_finish(&frame);
}
END_TEST

/* A quarter turn of the joints maps x to y and y to -x, in any units of the mesh. */
START_TEST(joints_rotate_mapped_normals)
{
    static const float sizes[] = {1, 0x1p-40f, 0x1p40f};
    is_skinned = true;
    units = sizes[_i];
    begin(0, false, false);
    set_normal(0.6, 0, 0.8, 1);
    for (int i = 1; i <= 2; i++)
        frame.scene.nodes[i].rotation[2] = frame.scene.nodes[i].rotation[3] = (float)sqrt(0.5);
    HATCH_TEST_OK(scene_set_pose(&frame.on_gpu, HATCH_NONE, 0, &frame.args.scratch, &frame.err), &frame.err);
    ck_assert_double_eq_tol(light(), 0.6 * to_light[1] + 0.8 * to_light[2], 1.0 / 255);
    frame_finish(&frame);
}
END_TEST

/* Joints that mirror x turn faces over, and u, but not v. */
START_TEST(joints_mirror_mapped_normals)
{
    static const double tilts[2][3] = {{0, 0.6, 0.8}, {0.6, 0, 0.8}};
    for (int i = 0; i < 2; i++) {
        is_skinned = true;
        begin(0, false, false);
        set_normal(tilts[i][0], tilts[i][1], tilts[i][2], 1);
        ck_assert(!frame.on_gpu.unit.items[0].mirrored);
        for (int joint = 1; joint <= 2; joint++)
            frame.scene.nodes[joint].scale[0] = -1;
        HATCH_TEST_OK(scene_set_pose(&frame.on_gpu, HATCH_NONE, 0, &frame.args.scratch, &frame.err), &frame.err);
        ck_assert(frame.on_gpu.unit.items[0].mirrored);
        double want = -tilts[i][0] * to_light[0] + tilts[i][1] * to_light[1] + tilts[i][2] * to_light[2];
        ck_assert_double_eq_tol(light(), want, 1.0 / 255);
        frame_finish(&frame);
    }
}
END_TEST

/* Seen from behind, the mapped normal is reversed. */
START_TEST(back_faces_reverse_mapped_normals)
{
    struct hatch_view behind = view_facing;
    behind.eye[2] = -2;
    behind.right[0] = -1;
    behind.back[2] = -1;
    begin(0, false, false);
    set_normal(0.6, 0, 0.8, 1);
    struct hatch_image image;
    frame_draw(&frame, "gouraud", &behind, SIZE, SIZE, 1, &image);
    double want = 0.6 * to_light[0] + 0.8 * to_light[2]; /* -n, seen in a camera whose right is -x */
    ck_assert_double_eq_tol((double)image.pixels[3 * (SIZE / 2 * SIZE + SIZE / 2)], want, 1.0 / 255);
    frame_finish(&frame);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("render normals");
    TCase *tests = tcase_create("normals");
    tcase_add_test(tests, normal_maps_tilt_the_normal_as_gltf_defines);
    tcase_add_test(tests, a_flat_normal_map_changes_nothing);
    tcase_add_loop_test(tests, joints_rotate_mapped_normals, 0, 3);
    tcase_add_test(tests, joints_mirror_mapped_normals);
    tcase_add_test(tests, back_faces_reverse_mapped_normals);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
