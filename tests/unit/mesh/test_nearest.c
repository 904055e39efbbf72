/* Nearest places on meshes, compared with a search through all faces. */
#include "mesh/nearest/nearest.h"

#include "base/random.h"
#include "fail_alloc.h"
#include "math/triangle.h"
#include "math/vector.h"
#include "meshes.h"

#define QUERIES 300u

static double uniform(uint32_t stream, uint32_t index)
{
    return (double)hatch_random_unit(1, stream, index);
}

/* Makes a cone of needles around the last point, which lies `height` above the others, turned out of the axes and
 * moved. */
static struct hatch_mesh needles(uint32_t count, double height)
{
    struct hatch_mesh mesh = fan(count);
    for (uint32_t v = 0; v <= count; v++) {
        float *at = &mesh.attributes[0].data[3 * (size_t)v];
        double x = (double)at[0], y = (double)at[1], z = v == count ? height : 0;
        at[0] = (float)(x - 0.3 * y + 0.2 * z + 5);
        at[1] = (float)(0.4 * x + y - 0.1 * z);
        at[2] = (float)(0.5 * x - 0.2 * y + z - 2);
    }
    return mesh;
}

/* Makes triangles of random directions and of lengths from 1 to 10^-4, each with corners of its own. */
static struct hatch_mesh splinters(uint32_t count)
{
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 3 * count, count, &mesh, &err), &err);
    for (uint32_t i = 0; i < 9 * count; i++) {
        double center = uniform(7, i / 9 * 3 + i % 3), length = pow(1e-4, uniform(8, i / 9));
        mesh.attributes[0].data[i] = (float)(3 * center + length * (uniform(9, i) - 0.5));
    }
    for (uint32_t i = 0; i < 3 * count; i++)
        mesh.indices[i] = i;
    return mesh;
}

static struct hatch_nearest tree_of(const struct hatch_mesh *mesh)
{
    struct hatch_nearest nearest;
    HATCH_TEST_OK(hatch_nearest_make(mesh, &keep, &scratch, &nearest, &err), &err);
    return nearest;
}

static double distance_to(const struct hatch_mesh *mesh, uint32_t face, const double point[3])
{
    double corners[3][3], share[3];
    hatch_mesh_corners(mesh, face, corners);
    return sqrt(hatch_triangle_distance_squared(corners[0], corners[1], corners[2], point, share));
}

static double least_distance(const struct hatch_mesh *mesh, const double point[3])
{
    double least = INFINITY;
    for (uint32_t f = 0; f < mesh->face_count; f++)
        least = fmin(least, distance_to(mesh, f, point));
    return least;
}

/* Finds a random point: on a face, or up to `away` from it along each axis. */
static void random_point(const struct hatch_mesh *mesh, uint32_t index, double away, double point[3])
{
    double corners[3][3], share[3] = {uniform(1, index), uniform(2, index), uniform(3, index)};
    double sum = share[0] + share[1] + share[2];
    hatch_mesh_corners(mesh, (uint32_t)(uniform(4, index) * mesh->face_count), corners);
    for (uint32_t k = 0; k < 3; k++) {
        point[k] = away * (2 * uniform(5, 3 * index + k) - 1);
        for (int c = 0; c < 3; c++)
            point[k] += share[c] / sum * corners[c][k];
    }
}

/* The place found is on the face found, and no other face is nearer. */
static void check_place(const struct hatch_mesh *mesh, const double point[3], const struct hatch_nearest_place *place)
{
    double corners[3][3], at[3] = {0, 0, 0};
    hatch_mesh_corners(mesh, place->face, corners);
    for (int c = 0; c < 3; c++) {
        ck_assert_double_ge(place->share[c], -1e-12);
        hatch_vec_add_scaled(at, place->share[c], corners[c], at);
    }
    ck_assert_double_eq_tol(place->share[0] + place->share[1] + place->share[2], 1, 1e-12);
    ck_assert_double_eq_tol(hatch_vec_distance(at, point), place->distance, 1e-9);
    ck_assert_double_eq(place->distance, least_distance(mesh, point));
}

static void check_mesh(const struct hatch_mesh *mesh)
{
    struct hatch_nearest nearest = tree_of(mesh);
    for (uint32_t i = 0; i < QUERIES; i++) {
        double point[3], away = i % 3 == 0 ? 0 : i % 3 == 1 ? 1e-3 : 1;
        uint32_t hint = (uint32_t)(uniform(6, i) * mesh->face_count);
        struct hatch_nearest_place place;
        random_point(mesh, i, away, point);
        hatch_nearest_find(&nearest, point, hint, &place);
        check_place(mesh, point, &place);
        double least = place.distance;
        uint32_t found = hint;
        ck_assert(hatch_nearest_within(&nearest, point, least * (1 + 1e-12), &found));
        ck_assert_double_le(distance_to(mesh, found, point), least * (1 + 1e-12));
        ck_assert(hatch_nearest_is_near(&nearest, place.face, point, least * (1 + 1e-12)));
        ck_assert(least == 0 || !hatch_nearest_is_near(&nearest, place.face, point, least * (1 - 1e-12)));
        found = hint;
        ck_assert(least == 0 || !hatch_nearest_within(&nearest, point, least * (1 - 1e-12), &found));
    }
}

START_TEST(places_are_the_nearest)
{
    struct hatch_mesh meshes[] = {bare_shape(HATCH_SHAPE_TEAPOT, 2000),
                                  needles(1000, 0),
                                  needles(777, 0.3),
                                  needles(3, 1),
                                  splinters(500),
                                  cube(-1, 1)};
    for (size_t i = 0; i < sizeof meshes / sizeof *meshes; i++)
        check_mesh(&meshes[i]);
}
END_TEST

/* A face that is as near as any other is the hint, if that is one: here two faces that share an edge. */
START_TEST(of_equally_near_faces_the_hint_is_found)
{
    static const float at[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
    static const uint32_t corners[6] = {0, 1, 2, 0, 1, 3};
    struct hatch_mesh mesh = mesh_of(at[0], 4, corners, 2);
    struct hatch_nearest nearest = tree_of(&mesh);
    for (uint32_t hint = 0; hint < 2; hint++) {
        struct hatch_nearest_place place;
        uint32_t found = hint;
        hatch_nearest_find(&nearest, (const double[3]){0.5, 0, 1}, hint, &place);
        ck_assert_uint_eq(place.face, hint);
        ck_assert_double_eq(place.distance, 1);
        ck_assert(hatch_nearest_within(&nearest, (const double[3]){0.5, 0, 1}, 1, &found));
        ck_assert_uint_eq(found, hint);
        ck_assert(!hatch_nearest_within(&nearest, (const double[3]){0.5, 0, 1}, 0.999, &found));
    }
}
END_TEST

/* A list holds the faces that are at most the nearest distance and twice the radius from the centre, in their order,
 * unless they are too many; and the nearest face to each point of the ball is among them. */
static void check_list(const struct hatch_mesh *mesh, const struct hatch_nearest *nearest, uint32_t index,
                       uint32_t counts[2])
{
    double center[3], radius = pow(1e-4, uniform(10, index)), limit;
    struct hatch_nearest_list list;
    uint32_t near = 0;
    random_point(mesh, index, 0.01, center);
    limit = least_distance(mesh, center) + 2 * radius;
    for (uint32_t f = 0; f < mesh->face_count; f++)
        near += distance_to(mesh, f, center) <= limit;
    bool listed = hatch_nearest_gather(nearest, center, radius, 0, &list);
    ck_assert_int_eq(listed, near <= HATCH_NEAREST_LIST_MAX);
    counts[listed]++;
    ck_assert(!listed || list.count == near);
    for (uint32_t i = 0; i < near && listed; i++) {
        double distance = distance_to(mesh, nearest->faces[list.items[i].place], center);
        ck_assert_double_eq_tol(list.items[i].distance, distance, 1e-12);
        ck_assert(i == 0 || list.items[i].distance >= list.items[i - 1].distance);
    }
    for (uint32_t i = 0; i < 10 && listed; i++) {
        double direction[3], point[3];
        struct hatch_nearest_place place;
        for (uint32_t k = 0; k < 3; k++)
            direction[k] = uniform(11, 100 * index + 3 * i + k) - 0.5;
        hatch_vec_normalize(direction);
        hatch_vec_add_scaled(center, i % 2 ? radius : radius * uniform(12, 100 * index + i), direction, point);
        hatch_nearest_find_listed(nearest, &list, point, &place);
        check_place(mesh, point, &place);
    }
}

START_TEST(lists_hold_the_nearest_faces_of_a_ball)
{
    struct hatch_mesh meshes[] = {bare_shape(HATCH_SHAPE_TEAPOT, 2000), needles(200, 0.3), splinters(300)};
    for (size_t m = 0; m < sizeof meshes / sizeof *meshes; m++) {
        struct hatch_nearest nearest = tree_of(&meshes[m]);
        uint32_t counts[2] = {0, 0};
        for (uint32_t i = 0; i < QUERIES; i++)
            check_list(&meshes[m], &nearest, i, counts);
        ck_assert_uint_gt(counts[0], QUERIES / 20);
        ck_assert_uint_gt(counts[1], QUERIES / 20);
    }
}
END_TEST

/* Capsules are kept where faces are long and thin, and only there. */
START_TEST(needles_have_capsules)
{
    struct hatch_mesh cone = needles(1000, 0.3), torus = bare_shape(HATCH_SHAPE_TORUS, 2000);
    ck_assert_ptr_nonnull(tree_of(&cone).spans);
    ck_assert_ptr_null(tree_of(&torus).spans);
}
END_TEST

struct again {
    const struct hatch_mesh *mesh;
    struct hatch_nearest nearest;
};

static enum hatch_status make_again(void *context, struct hatch_arena *arena, struct hatch_arena *temporary,
                                    struct hatch_err *error)
{
    struct again *again = context;
    return hatch_nearest_make(again->mesh, arena, temporary, &again->nearest, error);
}

START_TEST(allocations_may_fail)
{
    struct hatch_mesh cone = needles(50, 0.3);
    struct again again = {.mesh = &cone};
    hatch_test_fail_alloc(make_again, &again, &again, sizeof again);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("mesh nearest");
    TCase *tests = tcase_create("nearest");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, places_are_the_nearest);
    tcase_add_test(tests, of_equally_near_faces_the_hint_is_found);
    tcase_add_test(tests, lists_hold_the_nearest_faces_of_a_ball);
    tcase_add_test(tests, needles_have_capsules);
    tcase_add_test(tests, allocations_may_fail);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
