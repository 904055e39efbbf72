/* Cameras: their axes, framing, and where points lie in the picture. */
#include "math/angle.h"
#include "math/vector.h"
#include "meshes.h"
#include "scene/unit_scene.h"
#include "view/view.h"

static const struct hatch_bounds bounds = {.center = {10, 20, 30}, .radius = 5};
static const struct hatch_tile whole = {0, 0, 300, 200, 300, 200};

/* Projects a point of the unit scene: x and y from -1 to 1, depth from 1 to 0. */
static void project(const struct hatch_view *view, const struct hatch_tile *tile, const double point[3], double at[3])
{
    float matrix[16];
    double clip[4];
    hatch_view_matrix(view, tile, matrix);
    for (int r = 0; r < 4; r++)
        clip[r] = (double)matrix[r] * point[0] + (double)matrix[4 + r] * point[1] + (double)matrix[8 + r] * point[2] +
                  (double)matrix[12 + r];
    for (int r = 0; r < 3; r++)
        at[r] = clip[r] / clip[3];
}

static struct hatch_view view_at(double x, double y, double z, bool orthographic)
{
    struct hatch_view view = {
        .eye = {x, y, z}, .orthographic = orthographic, .half_height = 0.5, .aspect = 1.5, .near = 0.1, .far = 20};
    hatch_view_set_back(&view, view.eye);
    return view;
}

START_TEST(views_are_upright)
{
    static const double backs[5][3] = {{3, 1, 2}, {-1, -4, 0.5}, {0, 7, 0}, {0, -7, 0}, {0, 0, 0}};
    for (int i = 0; i < 5; i++) {
        struct hatch_view view = {.pivot = 1};
        double length = hatch_vec_length(backs[i]), across[3];
        hatch_view_set_back(&view, backs[i]);
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq_tol(view.back[k], length > 0 ? backs[i][k] / length : k == 2, 1e-12);
        hatch_vec_cross(view.up, view.back, across);
        ck_assert_double_eq_tol(hatch_vec_distance(across, view.right), 0, 1e-12);
        ck_assert_double_eq_tol(hatch_vec_length(view.right), 1, 1e-12);
        ck_assert_double_eq_tol(view.right[1], 0, 1e-12);
        ck_assert_double_ge(view.up[1], -1e-12);
        ck_assert(i < 2 || view.right[0] > 0.999);
    }
}
END_TEST

/* A torus fills 92 % of the picture's width or height, in the middle. */
START_TEST(a_framed_scene_fills_the_picture)
{
    for (int i = 0; i < 12; i++) {
        struct hatch_mesh torus = shape_of(HATCH_SHAPE_TORUS, 300);
        struct hatch_scene scene;
        struct hatch_unit_scene unit;
        struct hatch_view view;
        move(&torus, 2, 13);
        HATCH_TEST_OK(hatch_scene_of_mesh(&torus, &keep, &scene, &err), &err);
        HATCH_TEST_OK(hatch_unit_scene_make(&scene, NULL, &bounds, &keep, &unit, &err), &err);
        hatch_unit_scene_pose(&unit, HATCH_NONE, 0);
        const struct hatch_view_choice choice = {
            .kind = HATCH_VIEW_FRAMED, .azimuth_rad = 0.5 * i, .elevation_rad = 0.2 * i - 1, .fov_rad = 0.6};
        const struct hatch_pose_span moment = {.animation = HATCH_NONE, .moments = 1};
        const double aspect = i % 3 == 2 ? 0.5 : 1.5;
        const struct hatch_framing framing = {&moment, &bounds, aspect};
        const struct hatch_tile tile = {0, 0, 200 * aspect, 200, 200 * aspect, 200};
        HATCH_TEST_OK(hatch_view_make(&choice, &unit.pose, &framing, &scratch, &view, &err), &err);
        double low[2] = {1, 1}, high[2] = {-1, -1};
        for (uint32_t v = 0; v < torus.vertex_count; v++) {
            double world[3], point[3], at[3];
            hatch_vec_of(&torus.attributes[0].data[3 * (size_t)v], world);
            hatch_bounds_to_unit(&bounds, world, point);
            project(&view, &tile, point, at);
            ck_assert(at[2] > 0 && at[2] < 1);
            for (int k = 0; k < 2; k++) {
                low[k] = fmin(low[k], at[k]);
                high[k] = fmax(high[k], at[k]);
            }
        }
        ck_assert_double_eq_tol(fmax(high[0] - low[0], high[1] - low[1]), 2 * 0.92, 1e-4);
        for (int k = 0; k < 2; k++)
            ck_assert(low[k] > -0.9201 && high[k] < 0.9201);
        ck_assert_double_eq_tol(hatch_vec_dot(view.back, (const double[3]){0, 1, 0}), sin(0.2 * i - 1), 1e-12);
    }
}
END_TEST

START_TEST(points_near_the_picture_are_seen)
{
    for (int orthographic = 0; orthographic < 2; orthographic++) {
        struct hatch_view view = view_at(1, 2, 5, orthographic != 0);
        for (int i = 0; i < 200; i++) {
            double x = 0.15 * (i % 20 - 9.6), y = 0.3 * (i / 20 - 4.7), depth = i % 7 - 1.5, point[3], at[3];
            double size = view.half_height * (orthographic ? 1 : fabs(depth));
            hatch_vec_add_scaled(view.eye, -depth, view.back, point);
            hatch_vec_add_scaled(point, x * size * view.aspect, view.right, point);
            hatch_vec_add_scaled(point, y * size, view.up, point);
            ck_assert_int_eq(hatch_view_sees(&view, point), depth > 0.1 && fabs(x) < 1.1 && fabs(y) < 1.1);
            project(&view, &whole, point, at);
            if (depth > 0) {
                ck_assert_double_eq_tol(at[0], x, 1e-5);
                ck_assert_double_eq_tol(at[1], y, 1e-5);
                ck_assert_double_eq_tol(at[2], orthographic ? (20 - depth) / 19.9 : 0.1 / depth, 1e-5);
            }
        }
    }
}
END_TEST

/* A view that ends at 20: depth is 1 at the near plane, 0 at the far one, and linear in the inverse of the distance. */
START_TEST(a_finite_view_ends_at_its_far_plane)
{
    static const double distances[] = {0.1, 0.2, 1, 10, 20, 40};
    struct hatch_view view = view_at(0, 0, 5, false);
    view.finite = true;
    for (int i = 0; i < 6; i++) {
        const double d = distances[i], point[3] = {0, 0, 5 - d};
        double at[3];
        project(&view, &whole, point, at);
        ck_assert_double_eq_tol(at[2], (1 / d - 1 / 20.0) / (1 / 0.1 - 1 / 20.0), 1e-6);
        ck_assert_double_eq_tol(at[2] + hatch_view_depth_shift(&view), (1 + hatch_view_depth_shift(&view)) * 0.1 / d,
                                1e-6);
        ck_assert_int_eq(hatch_view_sees(&view, point), d > 0.1 && d < 20);
    }
    view.finite = false;
    ck_assert(hatch_view_sees(&view, (const double[]){0, 0, -35}));
    ck_assert_double_eq(hatch_view_depth_shift(&view), 0);
}
END_TEST

/* At a depth of 4 the picture is 4 high; up to the near plane the distance counts, here 5. */
START_TEST(pixels_follow_the_depth)
{
    struct hatch_view view = view_at(0, 0, 6, false), flat = view_at(0, 0, 6, true);
    const double before[3] = {1, -0.5, 2}, behind[3] = {0, 4, 9}, close[3] = {3, 4, 5.5};
    ck_assert_double_eq_tol(hatch_view_pixels_per_unit(&view, before, 200), 200 / 4.0, 1e-9);
    ck_assert_double_eq_tol(hatch_view_pixels_per_unit(&view, behind, 200), 200 / 5.0, 1e-9);
    ck_assert_double_eq_tol(hatch_view_pixels_per_unit(&view, view.eye, 200), 200 / 0.1, 1e-6);
    view.near = 0.5;
    ck_assert_double_eq_tol(hatch_view_pixels_per_unit(&view, close, 200), 200 / sqrt(25.25), 1e-9);
    ck_assert_double_eq_tol(hatch_view_pixels_per_unit(&flat, before, 200), 200, 1e-9);
    ck_assert_double_eq_tol(hatch_view_pixels_per_unit(&flat, behind, 200), 200, 1e-9);
}
END_TEST

/* Pixels of a tile are those of the whole picture. */
START_TEST(tiles_are_parts_of_the_picture)
{
    const struct hatch_tile tile = {120, 30, 60, 40, 300, 200};
    for (int orthographic = 0; orthographic < 2; orthographic++) {
        struct hatch_view view = view_at(1, 2, 5, orthographic != 0);
        for (int i = 0; i < 20; i++) {
            const double point[3] = {0.1 * i - 1, 0.07 * i, 0.3 - 0.1 * i};
            double of_all[3], of_tile[3];
            project(&view, &whole, point, of_all);
            project(&view, &tile, point, of_tile);
            ck_assert_double_eq_tol(150 * (of_all[0] + 1), 120 + 30 * (of_tile[0] + 1), 1e-3);
            ck_assert_double_eq_tol(100 * (of_all[1] + 1), 30 + 20 * (of_tile[1] + 1), 1e-3);
            ck_assert_double_eq_tol(of_all[2], of_tile[2], 1e-6);
        }
    }
}
END_TEST

/* A camera's near plane moves closer for views that move, and may then be moved where a face is near; that of an
 * orthographic view stays. */
START_TEST(near_planes_of_perspective_views_become_automatic)
{
    struct hatch_view view = {.near = 0.5}, close = {.near = 1e-6}, orthographic = {.near = 0.5, .orthographic = true};
    hatch_view_set_near_automatic(&view);
    ck_assert_double_eq(view.near, HATCH_VIEW_NEAR);
    ck_assert(view.near_is_automatic);
    hatch_view_set_near_automatic(&close);
    ck_assert_double_eq(close.near, 1e-6);
    hatch_view_set_near_automatic(&orthographic);
    ck_assert_double_eq(orthographic.near, 0.5);
    ck_assert(!orthographic.near_is_automatic);
}
END_TEST

/* The scene turns with the view: a point and the view that are turned alike give the same picture. */
START_TEST(a_view_turns_about_the_vertical)
{
    struct hatch_view view = view_at(1, 2, 5, false), turned = view;
    const double angle = 0.7, point[3] = {0.3, -0.2, 0.5};
    const double there[3] = {cos(angle) * point[0] + sin(angle) * point[2], point[1],
                             cos(angle) * point[2] - sin(angle) * point[0]};
    double before[3], after[3];
    hatch_view_turn(&turned, angle);
    project(&view, &whole, point, before);
    project(&turned, &whole, there, after);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(before[k], after[k], 1e-5);
}
END_TEST

/* Of a film, the first eye is 5 from a surface; a later one is nearer to it, or farther, or looks elsewhere. */
START_TEST(a_zoom_is_as_steady_as_its_views)
{
    static const struct hatch_pose_span moment = {.animation = HATCH_NONE, .moments = 1};
    static const struct hatch_bounds unit = {.radius = 1};
    static const double eyes[][3] = {{0, 0, 5}, {0, 0, 3}, {0, 0, 9}, {0, 3, 4}, {0, 0, 0}};
    static const double steps[] = {4, 2.4, 4, 4, 0}; /* with which the distance is divided by 5 */
    struct hatch_mesh face;
    struct hatch_scene scene;
    struct hatch_pose pose;
    struct hatch_view_middle middle;
    struct hatch_view view = view_at(0, 0, 5, false);
    HATCH_TEST_OK(hatch_mesh_make(&keep, 3, 1, &face, &err), &err);
    memcpy(face.attributes[0].data, (const float[]){-1, -1, 0, 1, -1, 0, 0, 1, 0}, 9 * sizeof(float));
    for (uint32_t v = 0; v < 3; v++)
        face.indices[v] = v;
    HATCH_TEST_OK(hatch_scene_of_mesh(&face, &keep, &scene, &err), &err);
    HATCH_TEST_OK(hatch_pose_make(&scene, &keep, &pose, &err), &err);
    HATCH_TEST_OK(hatch_view_find_middle(&pose, &moment, &unit, &view, &scratch, &middle, &err), &err);
    ck_assert_double_eq(middle.distance, 5);
    for (int i = 0; i < 5; i++)
        for (int side = 0; side < 2; side++) {
            view = view_at(eyes[i][0], eyes[i][1], eyes[i][2], false);
            hatch_view_set_back(&view, (const double[]){side, 0, 1 - side});
            view.pivot = 1;
            hatch_view_zoom(&middle, 5, &view);
            ck_assert_double_eq_tol(view.eye[0], -steps[i] * side, 1e-12);
            ck_assert_double_eq_tol(view.eye[1], eyes[i][1], 1e-12);
            ck_assert_double_eq_tol(view.eye[2], eyes[i][2] - steps[i] * (1 - side), 1e-12);
            ck_assert_double_gt(view.pivot, 0);
        }
    view = view_at(0, 0, 5, false);
    hatch_view_zoom(&middle, 5, &view);
    ck_assert_double_eq_tol(view.far, 16, 1e-12);
    view.finite = true; /* the face lies beyond its far plane */
    view.far = 0.9;
    HATCH_TEST_OK(hatch_view_find_middle(&pose, &moment, &unit, &view, &scratch, &middle, &err), &err);
    ck_assert_double_eq(middle.distance, view.pivot);
    middle.distance = 5;
    view = view_at(0, 0, 3, true);
    hatch_view_zoom(&middle, 5, &view);
    ck_assert_double_eq_tol(view.half_height, 0.1, 1e-15);
    ck_assert_double_eq(view.eye[2], 3);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("view");
    TCase *tests = tcase_create("view");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, views_are_upright);
    tcase_add_test(tests, a_framed_scene_fills_the_picture);
    tcase_add_test(tests, points_near_the_picture_are_seen);
    tcase_add_test(tests, a_finite_view_ends_at_its_far_plane);
    tcase_add_test(tests, pixels_follow_the_depth);
    tcase_add_test(tests, tiles_are_parts_of_the_picture);
    tcase_add_test(tests, near_planes_of_perspective_views_become_automatic);
    tcase_add_test(tests, a_view_turns_about_the_vertical);
    tcase_add_test(tests, a_zoom_is_as_steady_as_its_views);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
