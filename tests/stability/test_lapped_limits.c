/* Surfaces and fields on which patches stay small: the computation must end, cover every face and turn none over. */
#include "meshes.h"

#include "lapped_make.h"

static void check_covers(struct field_case field, double size, uint32_t samples)
{
    struct hatch_lapped_options options = LAPPED_DEFAULTS;
    options.size = size;
    struct lapped_case made = make_lapped(field, &options);
    check_patches(&made, samples);
}

/* Covers a mesh with small patches, patches of the default size, and patches as large as the surface. */
static void check_all_sizes(struct hatch_mesh mesh)
{
    static const double sizes[] = {0.05, 0, 1};
    for (int i = 0; i < 3; i++) {
        struct field_case field = case_of(mesh);
        set_direction(&field, 0.3, 1, 0.2);
        check_covers(field, sizes[i], 1000);
    }
}

static struct hatch_mesh triangle(float x, float y)
{
    const float positions[] = {0, 0, 0, x, 0, 0, 0, y, 0};
    const uint32_t face[] = {0, 1, 2};
    return mesh_of(positions, 3, face, 1);
}

START_TEST(one_triangle_is_covered)
{
    check_all_sizes(triangle(1, 1));
    check_all_sizes(triangle(1, 1e-4f));
    check_all_sizes(triangle(1e-12f, 1e-12f));
}
END_TEST

START_TEST(a_strip_one_face_wide_is_covered)
{
    check_all_sizes(band(100, 1, false));
    struct hatch_mesh open = band(100, 1, false);
    open.face_count -= 2;
    check_all_sizes(open);
}
END_TEST

START_TEST(one_sided_surfaces_are_covered)
{
    check_all_sizes(band(60, 1, true));
    check_all_sizes(klein(40, 20));
}
END_TEST

START_TEST(a_cube_is_covered)
{
    check_all_sizes(cube(0, 1));
}
END_TEST

/* A fan from a distant point to a fine row: its faces are longer than any patch. */
START_TEST(huge_faces_beside_tiny_ones_are_covered)
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
    check_all_sizes(mesh);
}
END_TEST

/* Patches could reach around a thin tube, or through a handle, and meet themselves. */
START_TEST(tubes_and_handles_smaller_than_a_patch_are_covered)
{
    struct field_case torus = case_of_shape(HATCH_SHAPE_TORUS, 2000, 1);
    set_direction(&torus, 0, 0, 1);
    check_covers(torus, 1, 2000);
    struct hatch_mesh leg = bare_shape(HATCH_SHAPE_CYLINDER, 2000);
    for (uint32_t v = 0; v < leg.vertex_count; v++)
        leg.attributes[0].data[3 * v + 1] *= 20;
    for (int i = 0; i < 2; i++) {
        struct field_case field = case_of(leg);
        set_direction(&field, 0, 1, 0);
        check_covers(field, 1, 2000);
    }
}
END_TEST

/* A sphere whose poles are tiny rings of vertices, as rounding makes them: faces there are needles. */
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

/* Counts faces that are turned over in the texture coordinates as written. */
static uint32_t count_turned(const struct field_case *field, const struct hatch_lapped *lapped, double tile)
{
    uint32_t count = 0;
    struct hatch_lapped_input input = lapped_input(field, NULL);
    input.tile = tile;
    for (uint32_t p = 0; p < lapped->patch_count; p++) {
        struct hatch_mesh mesh;
        HATCH_TEST_OK(hatch_lapped_mesh(&input, lapped, p, &keep, &scratch, &mesh, &err), &err);
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

/* A sheet of squares in which every other column is as narrow as the distance between floats: rounding would turn its
 * faces over. */
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

START_TEST(rounding_flips_no_needle)
{
    static const double widths[] = {1e-3, 1e-6, 1e-7, 1e-8, 1e-9};
    for (size_t i = 0; i < sizeof widths / sizeof *widths; i++) {
        struct field_case fields[] = {case_of(needle_columns(widths[i])), case_of(needle_sphere(widths[i]))};
        for (int k = 0; k < 2; k++) {
            set_direction(&fields[k], 0.3, 1, 0.2);
            const struct hatch_lapped lapped = make_lapped(fields[k], &LAPPED_DEFAULTS).lapped;
            ck_assert_uint_eq(count_turned(&fields[k], &lapped, 0.7), 0);
        }
    }
}
END_TEST

START_TEST(needles_have_finite_coordinates)
{
    static const double widths[] = {1e-3, 1e-6, 1e-8, 1e-9, 1e-10, 1e-16};
    for (size_t i = 0; i < sizeof widths / sizeof *widths; i++) {
        struct field_case field = case_of(needle_sphere(widths[i]));
        set_direction(&field, 0.3, 1, 0.2);
        const struct hatch_lapped lapped = make_lapped(field, &LAPPED_DEFAULTS).lapped;
        ck_assert_uint_ge(lapped.face_count, field.surface.face_count);
        for (uint32_t v = 0; v < lapped.vertex_count; v++)
            for (int k = 0; k < 2; k++)
                ck_assert(isfinite(lapped.vertices[v].hatch[k]) && isfinite(lapped.vertices[v].mask[k]));
    }
}
END_TEST

START_TEST(components_of_any_size_are_covered)
{
    struct hatch_mesh small = bare_shape(HATCH_SHAPE_SPHERE, 200), large = bare_shape(HATCH_SHAPE_TORUS, 800);
    move(&small, 1e-3f, 5);
    struct hatch_mesh mesh = both(&large, &small);
    check_all_sizes(mesh);
    struct hatch_mesh far = bare_shape(HATCH_SHAPE_SPHERE, 300);
    move(&far, 1e10f, 0);
    check_all_sizes(far);
}
END_TEST

/* Random directions: every other face has an index. */
START_TEST(a_random_field_is_covered)
{
    struct field_case field = case_of_shape(HATCH_SHAPE_SPHERE, 1500, 1);
    for (uint32_t p = 0; p < field.surface.point_count; p++)
        hatch_frames_direction(&field.frames, p, 6.28 * (double)hatch_random_unit(4, 0, p), &field.direction[3 * p]);
    struct hatch_lapped_options options = LAPPED_DEFAULTS;
    struct lapped_case made = make_lapped(field, &options);
    check_patches(&made, 2000);
    ck_assert_uint_gt(made.lapped.cut_count, 0);
}
END_TEST

/* Patches end near a singularity, and cover it. */
START_TEST(singularities_are_covered)
{
    struct field_case field = case_of_shape(HATCH_SHAPE_PLANE, 2000, 0.7f);
    for (int kind = 0; kind < 2; kind++) {
        for (uint32_t p = 0; p < field.surface.point_count; p++) {
            double at[3];
            hatch_surface_position(&field.surface, p, at);
            double angle = atan2(at[1] - 0.013, at[0] - 0.017) / (kind ? 2 : 1);
            field.direction[3 * p] = cos(angle);
            field.direction[3 * p + 1] = sin(angle);
            field.direction[3 * p + 2] = 0;
        }
        check_covers(field, 0.3, 5000);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("lapped limits");
    TCase *tests = tcase_create("limits");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, one_triangle_is_covered);
    tcase_add_test(tests, a_strip_one_face_wide_is_covered);
    tcase_add_test(tests, one_sided_surfaces_are_covered);
    tcase_add_test(tests, a_cube_is_covered);
    tcase_add_test(tests, huge_faces_beside_tiny_ones_are_covered);
    tcase_add_test(tests, tubes_and_handles_smaller_than_a_patch_are_covered);
    tcase_add_test(tests, rounding_flips_no_needle);
    tcase_add_test(tests, needles_have_finite_coordinates);
    tcase_add_test(tests, components_of_any_size_are_covered);
    tcase_add_test(tests, a_random_field_is_covered);
    tcase_add_test(tests, singularities_are_covered);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
