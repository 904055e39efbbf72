/* The true normals and curvatures of shapes, against closed forms and against their meshes. */
#include <math.h>

#include "math/vector.h"
#include "meshes.h"

static struct hatch_mesh make(enum hatch_shape shape, uint32_t faces, float jitter, float noise, uint64_t seed)
{
    return shape_with(shape,
                      (struct hatch_shape_options){.faces = faces, .jitter = jitter, .noise = noise, .seed = seed});
}

static void corner(const struct hatch_mesh *mesh, uint32_t vertex, double p[3], double n[3])
{
    hatch_vec_of(&hatch_mesh_find(mesh, "POSITION", 3)[(size_t)vertex * 3], p);
    hatch_vec_of(&hatch_mesh_find(mesh, "NORMAL", 3)[(size_t)vertex * 3], n);
}

START_TEST(normals_match_closed_forms)
{
    for (int shape = HATCH_SHAPE_SPHERE; shape < HATCH_SHAPE_COUNT; shape++) {
        struct hatch_mesh mesh = make((enum hatch_shape)shape, 3000, 0.7f, 0, 5);
        for (uint32_t v = 0; v < mesh.vertex_count; v++) {
            double p[3], n[3], want[3], direction[3], k[2];
            corner(&mesh, v, p, n);
            ck_assert_double_eq_tol(hatch_vec_length(n), 1, 1e-6);
            if (shape == HATCH_SHAPE_CONE && p[1] > 0.999)
                continue; /* the apex has no normal */
            hatch_shape_curvature((enum hatch_shape)shape, p, want, direction, k);
            ck_assert_msg(hatch_vec_distance(n, want) < 1e-5, "%s: vertex %u: normal off by %g",
                          hatch_shape_names[(enum hatch_shape)shape], v, hatch_vec_distance(n, want));
        }
    }
}
END_TEST

/* Returns the normal curvature at p towards q, k1 cos² + k2 sin² (Euler). */
static double curvature_towards(enum hatch_shape shape, const double p[3], const double q[3])
{
    double step[3], normal[3], direction[3], k[2];
    hatch_vec_sub(q, p, step);
    hatch_vec_normalize(step);
    hatch_shape_curvature(shape, p, normal, direction, k);
    double along = hatch_vec_dot(step, direction);
    return k[1] + (k[0] - k[1]) * along * along;
}

/* Normals turn along each edge by the mean of the normal curvatures at its ends. */
START_TEST(curvatures_are_the_turn_of_the_normals)
{
    for (int i = HATCH_SHAPE_SPHERE; i < HATCH_SHAPE_COUNT; i++) {
        enum hatch_shape shape = (enum hatch_shape)i;
        struct hatch_mesh mesh = make(shape, 100000, 0, 0, 1);
        double worst = 0;
        for (uint32_t c = 0; c < mesh.face_count * 3; c += 97) {
            double p[3], q[3], np[3], nq[3], step[3], turn[3];
            corner(&mesh, mesh.indices[c], p, np);
            corner(&mesh, mesh.indices[c % 3 == 2 ? c - 2 : c + 1], q, nq);
            if (shape == HATCH_SHAPE_CONE && (p[1] > 0.9 || q[1] > 0.9))
                continue;
            hatch_vec_sub(q, p, step);
            hatch_vec_sub(nq, np, turn);
            double have = hatch_vec_dot(turn, step) / hatch_vec_dot(step, step);
            double want = (curvature_towards(shape, p, q) + curvature_towards(shape, q, p)) / 2;
            worst = fmax(worst, fabs(have - want));
        }
        ck_assert_msg(worst < 0.02, "%s: curvature off by %g", hatch_shape_names[shape], worst);
    }
}
END_TEST

START_TEST(curvatures_match_closed_forms)
{
    const struct {
        enum hatch_shape shape;
        double position[3], direction[3], curvature[2];
        bool defined;
    } known[] = {
        {HATCH_SHAPE_SPHERE, {0, 0.6, 0.8}, {0, 0, 0}, {1, 1}, false},
        {HATCH_SHAPE_PLANE, {0.3, -0.2, 0}, {0, 0, 0}, {0, 0}, false},
        {HATCH_SHAPE_CYLINDER, {0.6, 0.1, 0.8}, {0.8, 0, -0.6}, {1, 0}, true},
        {HATCH_SHAPE_CONE, {0.5, 0, 0}, {0, 0, 1}, {4 / 2.23606797749979, 0}, true},
        {HATCH_SHAPE_TORUS, {1.4, 0, 0}, {0, 1, 0}, {2.5, 1 / 1.4}, true},
        {HATCH_SHAPE_TORUS, {0, 0, -0.6}, {0, 1, 0}, {2.5, -1 / 0.6}, true},
        {HATCH_SHAPE_WAVE, {-PI / 8, 0.4, -0.125}, {1, 0, 0}, {-2, 0}, true},
        {HATCH_SHAPE_WAVE, {PI / 8, 0.4, 0.125}, {1, 0, 0}, {2, 0}, true},
        {HATCH_SHAPE_ELLIPSOID, {1, 0, 0}, {0, 0, 1}, {4, 1 / 0.49}, true},
        {HATCH_SHAPE_ELLIPSOID, {0, -0.7, 0}, {0, 0, 1}, {0.7 / 0.25, 0.7}, true},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        double n[3], d[3], k[2];
        ck_assert(hatch_shape_curvature(known[i].shape, known[i].position, n, d, k) == known[i].defined);
        ck_assert_double_eq_tol(k[0], known[i].curvature[0], 1e-12);
        ck_assert_double_eq_tol(k[1], known[i].curvature[1], 1e-12);
        ck_assert_double_eq_tol(fabs(hatch_vec_dot(d, known[i].direction)), known[i].defined, 1e-12);
    }
    double n[3], d[3], k[2];
    const double middle[3] = {0, 0, 0}, apex[3] = {0, 1, 0};
    hatch_shape_curvature(HATCH_SHAPE_SADDLE, middle, n, d, k);
    ck_assert_double_eq_tol(fabs(k[0]), 1, 1e-12);
    ck_assert_double_eq_tol(k[0] + k[1], 0, 1e-12);
    ck_assert(!hatch_shape_curvature(HATCH_SHAPE_TEAPOT, middle, n, d, k));
    ck_assert(!hatch_shape_curvature(HATCH_SHAPE_CONE, apex, n, d, k));
}
END_TEST

START_TEST(field_does_not_depend_on_noise)
{
    for (int shape = 0; shape < HATCH_SHAPE_COUNT; shape++) {
        struct hatch_mesh mesh[2];
        for (int i = 0; i < 2; i++) {
            const struct hatch_shape_options options = {
                .faces = 1000, .jitter = 1, .noise = 0.3f * (float)i, .seed = 3, .field = true};
            HATCH_TEST_OK(hatch_shape_make((enum hatch_shape)shape, &options, &keep, &scratch, &mesh[i], &err), &err);
        }
        const float *field = hatch_mesh_find(&mesh[0], "_HATCH_DIR", 4);
        ck_assert_mem_eq(field, hatch_mesh_find(&mesh[1], "_HATCH_DIR", 4), (size_t)mesh[0].vertex_count * 16);
        for (uint32_t v = 0; v < mesh[0].vertex_count; v++) {
            double p[3], n[3], d[3], k[2] = {0, 0};
            corner(&mesh[0], v, p, n);
            hatch_shape_curvature((enum hatch_shape)shape, p, n, d, k);
            double difference = fabs(k[0] - k[1]), sum = fabs(k[0]) + fabs(k[1]);
            corner(&mesh[0], v, p, n);
            hatch_vec_of(&field[v * 4], d);
            ck_assert_double_eq_tol(hatch_vec_length(d), 1, 1e-6);
            ck_assert_double_eq_tol(hatch_vec_dot(d, n), 0, 1e-5);
            ck_assert(difference > 0.009 * sum || field[v * 4 + 3] == 0);
            ck_assert(!(difference > 0.011 * sum) || field[v * 4 + 3] == 1 || p[1] > 0.999);
        }
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("shape curvature");
    TCase *tests = tcase_create("shape curvature");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, normals_match_closed_forms);
    tcase_add_test(tests, curvatures_are_the_turn_of_the_normals);
    tcase_add_test(tests, curvatures_match_closed_forms);
    tcase_add_test(tests, field_does_not_depend_on_noise);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
