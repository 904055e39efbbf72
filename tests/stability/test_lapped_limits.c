/* Surfaces on which patches have little room, and fields that leave them little: each must end, cover
 * every face and turn none over. */
#include "meshes.h"

#include "lapped_make.h"

static void covers(struct field_case of, double size, uint32_t samples)
{
    struct hatch_lapped_options options = LAPPED_PLAIN;
    options.size = size;
    struct lapped_case made = cover_all(of, &options);
    check_patches(&made, samples);
}

/* Small patches, the size that is chosen, and patches as large as the whole. */
static void covers_at_all_sizes(struct hatch_mesh mesh)
{
    static const double sizes[] = {0.05, 0, 1};
    for (int i = 0; i < 3; i++) {
        struct field_case of = case_of(mesh);
        lay_field(&of, 0.3, 1, 0.2);
        covers(of, sizes[i], 1000);
    }
}

static struct hatch_mesh triangle(float x, float y)
{
    const float positions[] = {0, 0, 0, x, 0, 0, 0, y, 0};
    const uint32_t face[] = {0, 1, 2};
    return mesh_of(positions, 3, face, 1);
}

START_TEST(one_triangle)
{
    covers_at_all_sizes(triangle(1, 1));
    covers_at_all_sizes(triangle(1, 1e-4f));
    covers_at_all_sizes(triangle(1e-12f, 1e-12f));
}
END_TEST

START_TEST(a_strip_one_face_wide)
{
    covers_at_all_sizes(band(100, 1, false));
    struct hatch_mesh open = band(100, 1, false);
    open.face_count -= 2;
    covers_at_all_sizes(open);
}
END_TEST

START_TEST(surfaces_of_one_side)
{
    covers_at_all_sizes(band(60, 1, true));
    covers_at_all_sizes(klein(40, 20));
}
END_TEST

START_TEST(a_cube)
{
    covers_at_all_sizes(cube(0, 1));
}
END_TEST

/* A fan from one far point to a fine row: every face is longer than any patch. */
START_TEST(huge_faces_beside_tiny_ones)
{
    struct hatch_mesh mesh;
    const uint32_t n = 200;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 2 * n + 3, 3 * n, &mesh, &err), &err);
    float *at = mesh.attributes[0].data;
    for (uint32_t i = 0; i <= n; i++) {
        at[6 * i] = at[6 * i + 3] = (float)i / (float)n;
        at[6 * i + 4] = 1.0f / (float)n;
    }
    at[3 * (2 * n + 2)] = 0.5f;
    at[3 * (2 * n + 2) + 1] = -100;
    for (uint32_t i = 0; i < n; i++) {
        const uint32_t a = 2 * i, faces[9] = {a, a + 2, a + 3, a, a + 3, a + 1, a, 2 * n + 2, a + 2};
        memcpy(&mesh.indices[9 * i], faces, sizeof faces);
    }
    covers_at_all_sizes(mesh);
}
END_TEST

/* A patch would reach around a thin leg, or through a handle, and meet itself. */
START_TEST(legs_and_handles_smaller_than_a_patch)
{
    struct field_case torus = case_of_shape(HATCH_SHAPE_TORUS, 2000, 1);
    lay_field(&torus, 0, 0, 1);
    covers(torus, 1, 2000);
    struct hatch_mesh leg = bare_shape(HATCH_SHAPE_CYLINDER, 2000);
    for (uint32_t v = 0; v < leg.vertex_count; v++)
        leg.attributes[0].data[3 * v + 1] *= 20;
    for (int i = 0; i < 2; i++) {
        struct field_case of = case_of(leg);
        lay_field(&of, 0, 1, 0);
        covers(of, 1, 2000);
    }
}
END_TEST

/* A sphere whose poles are rings of vertices next to each other, as rounding leaves them: faces there are needles. */
static struct hatch_mesh needle_sphere(double width)
{
    enum { AROUND = 24, DOWN = 12 };
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, AROUND * (DOWN + 1), 2 * AROUND * DOWN, &mesh, &err), &err);
    for (uint32_t v = 0; v < mesh.vertex_count; v++) {
        double a = 2 * 3.14159265358979 * (v % AROUND) / AROUND, b = 3.14159265358979 * (v / AROUND) / DOWN;
        double radius = v / AROUND % DOWN ? sin(b) : width;
        float *p = &mesh.attributes[0].data[3 * v];
        p[0] = (float)(radius * cos(a));
        p[1] = (float)cos(b);
        p[2] = (float)(-radius * sin(a));
    }
    for (uint32_t i = 0; i < AROUND * DOWN; i++) {
        uint32_t a = i, next = i / AROUND * AROUND + (i + 1) % AROUND, b = a + AROUND;
        const uint32_t faces[6] = {a, b, next, next, b, next + AROUND};
        memcpy(mesh.indices + 6 * i, faces, sizeof faces);
    }
    return mesh;
}

/* Faces whose texture coordinates, as they are written, are turned over. */
static uint32_t count_turned(const struct field_case *of, const struct hatch_lapped *lapped, double tile)
{
    uint32_t count = 0;
    for (uint32_t p = 0; p < lapped->patch_count; p++) {
        struct hatch_mesh mesh;
        HATCH_TEST_OK(hatch_lapped_mesh(&of->surface, &of->mesh, lapped, p, of->direction, of->confidence, tile, &keep,
                                        &scratch, &mesh, &err),
                      &err);
        const float *uv = hatch_mesh_find(&mesh, "TEXCOORD_0", 2);
        for (uint32_t f = 0; f < mesh.face_count; f++) {
            double x[2][2];
            for (uint32_t i = 0; i < 2; i++)
                for (uint32_t k = 0; k < 2; k++)
                    x[i][k] = (double)uv[2 * mesh.indices[3 * f + i + 1] + k] - (double)uv[2 * mesh.indices[3 * f] + k];
            count += !(x[0][0] * x[1][1] - x[0][1] * x[1][0] < 0);
        }
    }
    return count;
}

/* A sheet of squares whose every other column is as wide as floats are apart: what rounding would turn
 * over. */
static struct hatch_mesh needle_columns(double width)
{
    enum { ACROSS = 20, DOWN = 10 };
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, ACROSS * (DOWN + 1), 2 * (ACROSS - 1) * DOWN, &mesh, &err), &err);
    for (uint32_t v = 0; v < mesh.vertex_count; v++) {
        float *p = &mesh.attributes[0].data[3 * v];
        p[0] = (float)(v % ACROSS / 2 + v % 2 * width - 5);
        p[1] = 0.1f * p[0] * p[0];
        p[2] = -(float)(v / ACROSS);
    }
    for (uint32_t i = 0; i < (ACROSS - 1) * DOWN; i++) {
        uint32_t a = i / (ACROSS - 1) * ACROSS + i % (ACROSS - 1), b = a + ACROSS;
        const uint32_t faces[6] = {a, a + 1, b + 1, a, b + 1, b};
        memcpy(mesh.indices + 6 * i, faces, sizeof faces);
    }
    return mesh;
}

START_TEST(floats_turn_no_needle_over)
{
    static const double widths[] = {1e-3, 1e-6, 1e-7, 1e-8, 1e-9};
    for (size_t i = 0; i < sizeof widths / sizeof *widths; i++) {
        struct field_case of[] = {case_of(needle_columns(widths[i])), case_of(needle_sphere(widths[i]))};
        for (int k = 0; k < 2; k++) {
            lay_field(&of[k], 0.3, 1, 0.2);
            const struct hatch_lapped lapped = cover_all(of[k], &LAPPED_PLAIN).lapped;
            ck_assert_uint_eq(count_turned(&of[k], &lapped, 0.7), 0);
        }
    }
}
END_TEST

START_TEST(needles_give_numbers)
{
    static const double widths[] = {1e-3, 1e-6, 1e-8, 1e-9, 1e-10, 1e-16};
    for (size_t i = 0; i < sizeof widths / sizeof *widths; i++) {
        struct field_case of = case_of(needle_sphere(widths[i]));
        lay_field(&of, 0.3, 1, 0.2);
        const struct hatch_lapped lapped = cover_all(of, &LAPPED_PLAIN).lapped;
        ck_assert_uint_ge(lapped.face_count, of.surface.face_count);
        for (uint32_t v = 0; v < lapped.vertex_count; v++)
            for (int k = 0; k < 2; k++)
                ck_assert(isfinite(lapped.vertices[v].hatch[k]) && isfinite(lapped.vertices[v].mask[k]));
    }
}
END_TEST

START_TEST(components_of_any_size)
{
    struct hatch_mesh small = bare_shape(HATCH_SHAPE_SPHERE, 200), large = bare_shape(HATCH_SHAPE_TORUS, 800);
    move(&small, 1e-3f, 5);
    struct hatch_mesh mesh = both(&large, &small);
    covers_at_all_sizes(mesh);
    struct hatch_mesh far = bare_shape(HATCH_SHAPE_SPHERE, 300);
    move(&far, 1e10f, 0);
    covers_at_all_sizes(far);
}
END_TEST

/* A direction of its own for every point: every other face has an index. */
START_TEST(a_field_of_noise)
{
    struct field_case of = case_of_shape(HATCH_SHAPE_SPHERE, 1500, 1);
    for (uint32_t p = 0; p < of.surface.point_count; p++)
        hatch_frames_direction(&of.frames, p, 6.28 * (double)hatch_random_unit(4, 0, p), &of.direction[3 * p]);
    struct hatch_lapped_options options = LAPPED_PLAIN;
    struct lapped_case made = cover_all(of, &options);
    check_patches(&made, 2000);
    ck_assert_uint_gt(made.lapped.cut, 0);
}
END_TEST

/* Patches end before a point where lines meet, and leave nothing bare there. */
START_TEST(lines_that_meet_in_a_point)
{
    struct field_case of = case_of_shape(HATCH_SHAPE_PLANE, 2000, 0.7f);
    for (int kind = 0; kind < 2; kind++) {
        for (uint32_t p = 0; p < of.surface.point_count; p++) {
            double at[3];
            hatch_surface_position(&of.surface, p, at);
            double angle = atan2(at[1] - 0.013, at[0] - 0.017) / (kind ? 2 : 1);
            of.direction[3 * p] = cos(angle);
            of.direction[3 * p + 1] = sin(angle);
            of.direction[3 * p + 2] = 0;
        }
        covers(of, 0.3, 5000);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("lapped limits");
    TCase *tests = tcase_create("limits");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, one_triangle);
    tcase_add_test(tests, a_strip_one_face_wide);
    tcase_add_test(tests, surfaces_of_one_side);
    tcase_add_test(tests, a_cube);
    tcase_add_test(tests, huge_faces_beside_tiny_ones);
    tcase_add_test(tests, legs_and_handles_smaller_than_a_patch);
    tcase_add_test(tests, floats_turn_no_needle_over);
    tcase_add_test(tests, needles_give_numbers);
    tcase_add_test(tests, components_of_any_size);
    tcase_add_test(tests, a_field_of_noise);
    tcase_add_test(tests, lines_that_meet_in_a_point);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
