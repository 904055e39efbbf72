#include <string.h>

#include "base/random.h"
#include "math/vector.h"
#include "meshes.h"
#include "surface_check.h"
#include "surface/nearest.h"

/* Two triangles of different sizes, far apart, of which the face of the last vertices comes first, and an unused vertex
 * between them. */
static struct hatch_mesh two_triangles(void)
{
    static const float at[7][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {50, 0, 0}, {100, 0, 0}, {130, 0, 0}, {100, 40, 0}};
    static const uint32_t corners[6] = {4, 5, 6, 0, 1, 2};
    return mesh_of(at[0], 7, corners, 2);
}

static struct hatch_surface_points points_of(const struct hatch_surface *surface)
{
    struct hatch_surface_points points;
    HATCH_TEST_OK(hatch_surface_points_make(surface, &keep, &points, &err), &err);
    return points;
}

/* Tests every point. */
static uint32_t nearest_of_all(const struct hatch_surface *surface, const double position[3])
{
    uint32_t nearest = 0;
    double least = INFINITY;
    for (uint32_t p = 0; p < surface->point_count; p++) {
        const struct hatch_component *component = &surface->components[surface->point_component[p]];
        double local[3], length;
        for (int k = 0; k < 3; k++)
            local[k] = (position[k] - component->center[k]) / component->scale;
        length = hatch_vec_distance(local, &surface->points[3 * (size_t)p]) * component->scale;
        if (length < least) {
            least = length;
            nearest = p;
        }
    }
    return nearest;
}

/* Components of different units, one far from the origin, whose points a float just tells apart; positions in and
 * around them, half of them on a coarse grid, where many points are equally near. */
START_TEST(the_search_finds_the_nearest_of_all)
{
    struct hatch_mesh parts[3] = {bare_shape(HATCH_SHAPE_PLANE, 800), bare_shape(HATCH_SHAPE_TORUS, 700),
                                  bare_shape(HATCH_SHAPE_SPHERE, 300)};
    move(&parts[1], 5, 3);
    move(&parts[2], 0.5f, 9000);
    struct hatch_mesh mesh = both(&parts[0], &parts[1]);
    mesh = both(&mesh, &parts[2]);
    struct hatch_surface surface = surface_of(&mesh);
    struct hatch_surface_points points = points_of(&surface);
    for (uint32_t i = 0; i < 3000; i++) {
        double position[3];
        for (uint32_t k = 0; k < 3; k++) {
            position[k] = 16 * (double)hatch_random_unit(1, k, i) - 8;
            position[k] = i % 2 ? position[k] : round(4 * position[k]) / 4;
        }
        position[0] += i % 3 ? 0 : 9000;
        ck_assert_uint_eq(hatch_surface_nearest(&points, position), nearest_of_all(&surface, position));
    }
    const double nowhere[3] = {0, NAN, 0}, beyond[3] = {INFINITY, 0, 0};
    ck_assert_uint_eq(hatch_surface_nearest(&points, nowhere), 0);
    ck_assert_uint_eq(hatch_surface_nearest(&points, beyond), 0);
}
END_TEST

START_TEST(every_point_is_nearest_to_itself)
{
    struct hatch_mesh mesh =
        shape_with(HATCH_SHAPE_TORUS, (struct hatch_shape_options){.faces = 500, .jitter = 0.5f, .seed = 1});
    struct hatch_surface surface = surface_of(&mesh);
    struct hatch_surface_points points = points_of(&surface);
    for (uint32_t p = 0; p < surface.point_count; p++) {
        double position[3];
        hatch_surface_position(&surface, p, position);
        ck_assert_uint_eq(hatch_surface_nearest(&points, position), p);
    }
}
END_TEST

START_TEST(distances_are_measured_in_mesh_units)
{
    /* 24 from the small triangle, 74 from the large one, the surface unit of which is 40 times as long. */
    static const double between[3] = {25, 0, 0}, beyond[3] = {64, 3, 0};
    struct hatch_mesh mesh = two_triangles();
    struct hatch_surface surface = surface_of(&mesh);
    struct hatch_surface_points points = points_of(&surface);
    double position[3];
    hatch_surface_position(&surface, hatch_surface_nearest(&points, between), position);
    ck_assert_double_eq_tol(position[0], 1, 1e-9);
    hatch_surface_position(&surface, hatch_surface_nearest(&points, beyond), position);
    ck_assert_double_eq_tol(position[0], 100, 1e-9);
    ck_assert_double_eq_tol(position[1], 0, 1e-9);
}
END_TEST

START_TEST(every_used_vertex_has_a_point)
{
    struct hatch_mesh mesh = two_triangles();
    struct hatch_surface surface = surface_of(&mesh);
    uint32_t points[7] = {0};
    hatch_surface_vertex_points(&surface, 7, points);
    for (uint32_t v = 0; v < 7; v++) {
        if (v == 3) {
            ck_assert_uint_eq(points[v], HATCH_NO_SIDE);
            continue;
        }
        double position[3], want[3];
        hatch_surface_position(&surface, points[v], position);
        hatch_vec_of(&mesh.attributes[0].data[3 * v], want);
        ck_assert_double_lt(hatch_vec_distance(position, want), 1e-9);
    }
}
END_TEST

/* Vertices in two groups, by their parity: each group has the points of the corners with its vertices, and no others.
 */
START_TEST(groups_have_the_points_of_their_vertices)
{
    struct hatch_mesh mesh = two_triangles();
    struct hatch_surface surface = surface_of(&mesh);
    struct hatch_surface_groups groups;
    const uint32_t parity[7] = {0, 1, 0, 1, 0, 1, 0};
    for (int own = 0; own < 2; own++) {
        uint32_t count = own ? 7 : 2;
        HATCH_TEST_OK(hatch_surface_group_points(&surface, own ? NULL : parity, count, &keep, &groups, &err), &err);
        ck_assert_uint_eq(groups.first[0], 0);
        ck_assert_uint_eq(groups.first[count], 3 * surface.face_count);
        for (uint32_t i = 0; i < 3 * surface.face_count; i++) {
            uint32_t group = own ? surface.corner_vertex[i] : parity[surface.corner_vertex[i]];
            uint32_t at = groups.first[group];
            while (at < groups.first[group + 1] && groups.points[at] != surface.corners[i])
                at++;
            ck_assert_uint_lt(at, groups.first[group + 1]);
        }
        for (uint32_t p = 0; p < surface.point_count; p++)
            ck_assert_uint_lt(groups.group[p], count);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("nearest");
    TCase *tests = tcase_create("nearest");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, the_search_finds_the_nearest_of_all);
    tcase_add_test(tests, every_point_is_nearest_to_itself);
    tcase_add_test(tests, distances_are_measured_in_mesh_units);
    tcase_add_test(tests, every_used_vertex_has_a_point);
    tcase_add_test(tests, groups_have_the_points_of_their_vertices);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
