/* Lights in the unit scene, and the exposure that makes them white. */
#include "math/angle.h"
#include "math/vector.h"
#include "meshes.h"
#include "view/exposure.h"
#include "views.h"

static struct hatch_scene scene;
static struct hatch_unit_scene unit;
static const struct hatch_bounds bounds = {.center = {10, 20, 30}, .radius = 5};

/* A square plane that faces +z, with a light of one type at a node of its own. */
static void light_plane(struct hatch_light light, const float translation[3])
{
    struct hatch_mesh plane = shape_of(HATCH_SHAPE_PLANE, 50);
    HATCH_TEST_OK(hatch_scene_of_mesh(&plane, &keep, &scene, &err), &err);
    struct hatch_node *nodes = HATCH_NEW(&keep, struct hatch_node, 2, &err);
    nodes[0] = nodes[1] = scene.nodes[0];
    nodes[0].light = HATCH_NONE;
    nodes[1].mesh_count = 0;
    nodes[1].light = 0;
    hatch_vec_of(translation, nodes[1].translation);
    scene.nodes = nodes;
    scene.node_count = 2;
    scene.lights = HATCH_NEW(&keep, struct hatch_light, 1, &err);
    scene.lights[0] = light;
    scene.light_count = 1;
    HATCH_TEST_OK(hatch_unit_scene_make(&scene, NULL, &bounds, &keep, &unit, &err), &err);
    hatch_unit_scene_pose(&unit, HATCH_NONE, 0);
}

static const float nowhere[3] = {0, 0, 0};
static const struct hatch_light sun = {.type = HATCH_LIGHT_DIRECTIONAL, .color = {1, 1, 1}, .intensity = 8};

START_TEST(the_key_light_turns_with_the_camera)
{
    static const struct {
        double azimuth_deg, elevation_deg, to_light[3];
    } cases[] = {{0, 0, {0, 0, 1}}, {90, 0, {1, 0, 0}}, {0, 90, {0, 1, 0}}, {180, 0, {0, 0, -1}}};
    struct hatch_unit_light lights[HATCH_LIGHTS_MAX];
    light_plane(sun, nowhere);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const struct hatch_key_light key = {true, cases[i].azimuth_deg * HATCH_RADIANS,
                                            cases[i].elevation_deg * HATCH_RADIANS};
        ck_assert(hatch_lights_are_key_alone(&scene, &key));
        ck_assert_uint_eq(hatch_lights_fill(&unit.pose, &bounds, &view_facing, &key, 3, lights), 1);
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq_tol((double)lights[0].direction[k], cases[i].to_light[k], 1e-6);
        ck_assert_float_eq(lights[0].direction[3], 1);
        ck_assert_float_eq(lights[0].position[3], 0);
    }
}
END_TEST

START_TEST(a_point_light_is_scaled_with_the_scene)
{
    static const struct hatch_key_light key = {.replaces = false};
    const struct hatch_light lamp = {.type = HATCH_LIGHT_POINT, .color = {1, 1, 1}, .intensity = 50, .range = 10};
    const float at[3] = {15, 20, 40};
    struct hatch_unit_light lights[HATCH_LIGHTS_MAX];
    light_plane(lamp, at);
    ck_assert(!hatch_lights_are_key_alone(&scene, &key));
    ck_assert_uint_eq(hatch_lights_fill(&unit.pose, &bounds, &view_facing, &key, 3, lights), 1);
    ck_assert_float_eq_tol(lights[0].position[0], 1, 1e-6f);
    ck_assert_float_eq_tol(lights[0].position[1], 0, 1e-6f);
    ck_assert_float_eq_tol(lights[0].position[2], 2, 1e-6f);
    ck_assert_float_eq(lights[0].position[3], 1);
    /* The light at a distance stays: lengths shrink by the radius, 5, strengths by its square. */
    ck_assert_float_eq_tol(lights[0].direction[3], 3 * 50 / 25.0f, 1e-5f);
    ck_assert_float_eq_tol(lights[0].cone[2], 1 / (2 * 2.0f), 1e-6f);
    ck_assert_float_eq_tol(lights[0].cone[3], 0.001f * 0.001f, 1e-12f); /* nearer than that it gets no stronger */
    ck_assert_double_eq_tol(hatch_lights_strongest(&unit.pose, &bounds), 50 / 25.0, 1e-6);
    scene.lights[0].intensity = 5;
    ck_assert_double_eq_tol(hatch_lights_strongest(&unit.pose, &bounds), 5 / 25.0, 1e-6);
}
END_TEST

/* The cone makes 0 of the cosine of the outer angle, and 1 of that of the inner one; a point light has 1 everywhere. */
START_TEST(a_spot_has_a_cone)
{
    static const struct hatch_key_light key = {.replaces = false};
    const float at[3] = {15, 20, 40};
    struct hatch_unit_light lights[HATCH_LIGHTS_MAX];
    for (int type = 0; type < 3; type++) {
        struct hatch_light lamp = {.type = type ? HATCH_LIGHT_SPOT : HATCH_LIGHT_POINT,
                                   .color = {1, 1, 1},
                                   .intensity = 50,
                                   .inner_cone_rad = type == 1 ? 0.3f : 0.6f,
                                   .outer_cone_rad = 0.6f};
        light_plane(lamp, at);
        ck_assert_uint_eq(hatch_lights_fill(&unit.pose, &bounds, &view_facing, &key, 3, lights), 1);
        const float *cone = lights[0].cone, inner = cosf(0.3f), outer = cosf(0.6f);
        ck_assert_float_eq_tol(outer * cone[0] + cone[1], type ? 0 : 1, 1e-4f);
        ck_assert_float_eq_tol(cone[0], type == 0 ? 0 : type == 1 ? 1 / (inner - outer) : 1000, 1e-3f);
        ck_assert_float_eq(cone[2], 0);
        ck_assert_float_eq_tol(lights[0].direction[2], -1, 1e-6f); /* a light shines along -z */
    }
}
END_TEST

/* Just within and just beyond 1000 radii, where a spot becomes directional, the light that reaches the scene's centre
 * is the same: the squared share of the cone, in cosines of the angle between the spot's axis and the centre, and what
 * the range of 1500 radii leaves. */
START_TEST(a_far_spot_keeps_its_cone_and_range)
{
    static const struct hatch_key_light key = {.replaces = false};
    static const double angles[] = {0, 0.2, 0.4, 0.5, 0.7, 3};
    const struct hatch_light lamp = {.type = HATCH_LIGHT_SPOT,
                                     .color = {1, 1, 1},
                                     .intensity = 5e7f,
                                     .range = 7500,
                                     .inner_cone_rad = 0.3f,
                                     .outer_cone_rad = 0.6f};
    struct hatch_unit_light lights[HATCH_LIGHTS_MAX];
    for (size_t i = 0; i < sizeof angles / sizeof *angles; i++) {
        double share = fmin(fmax((cos(angles[i]) - cos(0.6)) / (cos(0.3) - cos(0.6)), 0), 1);
        for (int far = 0; far < 2; far++) {
            const float distance = far ? 1001 : 999, at[3] = {10, 20, 30 + 5 * distance};
            light_plane(lamp, at);
            scene.nodes[1].rotation[0] = (float)sin(angles[i] / 2);
            scene.nodes[1].rotation[3] = (float)cos(angles[i] / 2);
            hatch_unit_scene_pose(&unit, HATCH_NONE, 0);
            ck_assert_uint_eq(hatch_lights_fill(&unit.pose, &bounds, &view_facing, &key, 1, lights), 1);
            ck_assert_float_eq(lights[0].position[3], far ? 0 : 1);
            double square = (double)distance * (double)distance, got = (double)lights[0].direction[3];
            if (!far) {
                double cosine = -(double)lights[0].direction[2], ratio = square * (double)lights[0].cone[2];
                double spot = fmin(fmax(cosine * (double)lights[0].cone[0] + (double)lights[0].cone[1], 0), 1);
                got *= spot * spot * (1 - ratio * ratio) / square;
            }
            double want = 5e7 / 25 / square * share * share * (1 - pow((double)distance / 1500, 4));
            ck_assert_msg(fabs(got - want) <= 1e-4, "%g from the axis, far %d: %g, not %g", angles[i], far, got, want);
        }
    }
}
END_TEST

START_TEST(lights_beyond_the_limit_are_counted)
{
    static const struct hatch_key_light key = {.replaces = false};
    struct hatch_unit_light lights[HATCH_LIGHTS_MAX];
    light_plane(sun, nowhere);
    struct hatch_node *nodes = HATCH_NEW(&keep, struct hatch_node, HATCH_LIGHTS_MAX + 3, &err);
    for (uint32_t i = 0; i < HATCH_LIGHTS_MAX + 3; i++)
        nodes[i] = scene.nodes[1];
    scene.nodes = nodes;
    scene.node_count = HATCH_LIGHTS_MAX + 3;
    ck_assert_uint_eq(hatch_lights_left_out(&scene), 3);
    HATCH_TEST_OK(hatch_unit_scene_make(&scene, NULL, &bounds, &keep, &unit, &err), &err);
    hatch_unit_scene_pose(&unit, HATCH_NONE, 0);
    ck_assert_uint_eq(hatch_lights_fill(&unit.pose, &bounds, &view_facing, &key, 1, lights), HATCH_LIGHTS_MAX);
}
END_TEST

/* Every vertex of the plane has the light's strength, or half of it where the light leans by 60 degrees. Bins of the
 * histogram are a sixteenth of an octave wide. */
START_TEST(the_exposure_makes_a_lit_plane_white)
{
    const double bin = exp2(1.0 / 16);
    for (int leans = 0; leans <= 1; leans++) {
        double exposure;
        light_plane(sun, nowhere);
        if (leans) {
            scene.nodes[1].rotation[0] = 0.5f;
            scene.nodes[1].rotation[3] = sqrtf(0.75f);
            hatch_unit_scene_pose(&unit, HATCH_NONE, 0);
        }
        HATCH_TEST_OK(hatch_auto_exposure(&unit, NULL, &view_facing, false, &scratch, &exposure, &err), &err);
        double want = leans ? 1 / 4.0 : 1 / 8.0;
        ck_assert_msg(exposure > want / bin && exposure < want * bin, "%g instead of %g", exposure, want);
    }
}
END_TEST

/* The scene's plane leans by 60 degrees and has half the light; a backdrop with the same vertices, as --ground is,
 * faces the light. */
START_TEST(the_exposure_leaves_out_backdrops)
{
    const double bin = exp2(1.0 / 16), want = 1 / 4.0;
    double exposure;
    light_plane(sun, nowhere);
    struct hatch_node *nodes = HATCH_NEW(&keep, struct hatch_node, 3, &err);
    memcpy(nodes, scene.nodes, 2 * sizeof *nodes);
    nodes[2] = nodes[0];
    nodes[2].backdrop = true;
    nodes[0].rotation[0] = 0.5f;
    nodes[0].rotation[3] = sqrtf(0.75f);
    scene.nodes = nodes;
    scene.node_count = 3;
    HATCH_TEST_OK(hatch_unit_scene_make(&scene, NULL, &bounds, &keep, &unit, &err), &err);
    hatch_unit_scene_pose(&unit, HATCH_NONE, 0);
    HATCH_TEST_OK(hatch_auto_exposure(&unit, NULL, &view_facing, false, &scratch, &exposure, &err), &err);
    ck_assert_msg(exposure > want / bin && exposure < want * bin, "%g instead of %g", exposure, want);
}
END_TEST

/* The scene's plane leans by 60 degrees and has half the light. A plane that faces the light has a hundredth of its
 * area, but many more vertices. */
START_TEST(the_exposure_counts_areas)
{
    const double bin = exp2(1.0 / 16), want = 1 / 4.0;
    double exposure;
    light_plane(sun, nowhere);
    struct hatch_mesh dense = shape_of(HATCH_SHAPE_PLANE, 5000);
    struct hatch_node *nodes = HATCH_NEW(&keep, struct hatch_node, 3, &err);
    struct hatch_scene_mesh *meshes = HATCH_NEW(&keep, struct hatch_scene_mesh, 2, &err);
    memcpy(nodes, scene.nodes, 2 * sizeof *nodes);
    meshes[0] = meshes[1] = scene.meshes[0];
    meshes[1].mesh = dense;
    nodes[2] = nodes[0];
    nodes[2].first_mesh = 1;
    for (int k = 0; k < 3; k++)
        nodes[2].scale[k] = 0.1f;
    nodes[0].rotation[0] = 0.5f;
    nodes[0].rotation[3] = sqrtf(0.75f);
    scene.nodes = nodes;
    scene.meshes = meshes;
    scene.node_count = 3;
    scene.mesh_count = 2;
    HATCH_TEST_OK(hatch_unit_scene_make(&scene, NULL, &bounds, &keep, &unit, &err), &err);
    hatch_unit_scene_pose(&unit, HATCH_NONE, 0);
    HATCH_TEST_OK(hatch_auto_exposure(&unit, NULL, &view_facing, false, &scratch, &exposure, &err), &err);
    ck_assert_msg(exposure > want / bin && exposure < want * bin, "%g instead of %g", exposure, want);
}
END_TEST

/* The light of a vertex that is 2^-99.97 of the strongest light, of a normal almost across it, is in the histogram's
 * first bin; what is darker does not count as lit. */
START_TEST(the_exposure_of_grazing_light_is_known_down_to_the_first_bin)
{
    static const double octaves[] = {-99.97, -100.1};
    for (int dark = 0; dark <= 1; dark++) {
        light_plane(sun, nowhere);
        struct hatch_mesh *plane = &scene.meshes[0].mesh;
        float *normals = hatch_mesh_find(plane, "NORMAL", 3);
        double exposure, want = dark ? 1 : exp2(-octaves[dark]) / 8, bin = exp2(1.0 / 16);
        for (uint32_t v = 0; v < plane->vertex_count; v++) {
            normals[3 * v] = 1;
            normals[3 * v + 2] = (float)exp2(octaves[dark]);
        }
        HATCH_TEST_OK(hatch_auto_exposure(&unit, NULL, &view_facing, false, &scratch, &exposure, &err), &err);
        ck_assert_msg(exposure > want / bin && exposure < want * bin, "%g instead of %g", exposure, want);
    }
}
END_TEST

/* A lamp at height h over the middle of a square of two faces, whose corners are darker: light falls with
 * h / (r^2 + h^2)^(3/2) at a distance r from the middle, and a twentieth of the area lies in a circle. Per vertex, the
 * corners alone count. */
START_TEST(the_exposure_counts_the_light_inside_of_large_faces)
{
    const double height = 0.25, bin = exp2(1.0 / 16);
    const struct hatch_light lamp = {.type = HATCH_LIGHT_POINT, .color = {1, 1, 1}, .intensity = 8};
    const struct hatch_bounds tight = {.radius = 1};
    light_plane(lamp, (float[3]){0, 0, (float)height});
    struct hatch_mesh *plane = &scene.meshes[0].mesh;
    *plane = shape_of(HATCH_SHAPE_PLANE, 2);
    double side = 2 * fabs((double)hatch_mesh_find(plane, "POSITION", 3)[0]);
    for (int per_pixel = 0; per_pixel <= 1; per_pixel++) {
        double exposure, square = per_pixel ? 0.05 * side * side / PI : side * side / 2;
        double want = pow(square + height * height, 1.5) / (8 * height);
        HATCH_TEST_OK(hatch_unit_scene_make(&scene, NULL, &tight, &keep, &unit, &err), &err);
        hatch_unit_scene_pose(&unit, HATCH_NONE, 0);
        HATCH_TEST_OK(hatch_auto_exposure(&unit, NULL, &view_facing, per_pixel, &scratch, &exposure, &err), &err);
        ck_assert_msg(exposure > want / bin && exposure < want * bin, "%g instead of %g", exposure, want);
    }
}
END_TEST

/* Nothing of a plane that is lit from behind is lit, unless it is visible from there. */
START_TEST(the_exposure_of_a_plane_lit_from_behind_is_one)
{
    const double bin = exp2(1.0 / 16);
    for (int sides = 1; sides <= 2; sides++) {
        double exposure, want = sides == 1 ? 1 : 1 / 8.0;
        light_plane(sun, nowhere);
        scene.nodes[1].rotation[0] = 1;
        scene.nodes[1].rotation[3] = 0;
        unit.items[0].double_sided = sides == 2;
        hatch_unit_scene_pose(&unit, HATCH_NONE, 0);
        HATCH_TEST_OK(hatch_auto_exposure(&unit, NULL, &view_facing, false, &scratch, &exposure, &err), &err);
        ck_assert_msg(exposure > want / bin && exposure < want * bin, "%g instead of %g", exposure, want);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("light");
    TCase *tests = tcase_create("light");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, the_key_light_turns_with_the_camera);
    tcase_add_test(tests, a_point_light_is_scaled_with_the_scene);
    tcase_add_test(tests, a_spot_has_a_cone);
    tcase_add_test(tests, a_far_spot_keeps_its_cone_and_range);
    tcase_add_test(tests, lights_beyond_the_limit_are_counted);
    tcase_add_test(tests, the_exposure_makes_a_lit_plane_white);
    tcase_add_test(tests, the_exposure_leaves_out_backdrops);
    tcase_add_test(tests, the_exposure_counts_areas);
    tcase_add_test(tests, the_exposure_of_grazing_light_is_known_down_to_the_first_bin);
    tcase_add_test(tests, the_exposure_counts_the_light_inside_of_large_faces);
    tcase_add_test(tests, the_exposure_of_a_plane_lit_from_behind_is_one);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
