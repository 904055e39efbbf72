#include <math.h>
#include <string.h>

#include "fail_alloc.h"
#include "math/vector.h"
#include "measure/mesh_figures.h"
#include "meshes.h"
#include "shapes/grid.h"

static struct hatch_mesh make(enum hatch_shape shape, uint32_t faces, float jitter, float noise, uint64_t seed)
{
    return shape_with(shape,
                      (struct hatch_shape_options){.faces = faces, .jitter = jitter, .noise = noise, .seed = seed});
}

static struct hatch_mesh_figures measure(const struct hatch_mesh *mesh)
{
    struct hatch_mesh_figures figures;
    HATCH_TEST_OK(hatch_measure_mesh(mesh, &scratch, &figures, &err), &err);
    return figures;
}

/* The vertices of a pole are one point for programs that compare bytes, too: no coordinate is -0. */
START_TEST(poles_have_one_position)
{
    static const enum hatch_shape shapes[] = {HATCH_SHAPE_SPHERE, HATCH_SHAPE_ELLIPSOID, HATCH_SHAPE_CONE};
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++) {
        struct hatch_mesh mesh = make(shapes[i], 200, 0, 0, 0);
        const float *at = hatch_mesh_find(&mesh, "POSITION", 3);
        uint32_t poles = 0;
        for (uint32_t v = 0; v < mesh.vertex_count; v++) {
            poles += at[3 * v] == 0 && at[3 * v + 2] == 0;
            for (uint32_t k = 0; k < 3; k++)
                ck_assert(at[3 * v + k] != 0 || !signbit(at[3 * v + k]));
        }
        ck_assert_uint_ge(poles, 8);
    }
}
END_TEST

/* ∫∫ √(1 + x² + y²) over [-1, 1]², by the midpoint rule */
static double saddle_area(void)
{
    const int n = 1000;
    double sum = 0;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            double x = (2 * i + 1.0) / n - 1, y = (2 * j + 1.0) / n - 1;
            sum += sqrt(1 + x * x + y * y);
        }
    return sum * 4 / n / n;
}

/* 2 ∫ √(1 + cos²(4x)/4) over [-1, 1], by the midpoint rule */
static double wave_area(void)
{
    const int n = 1000;
    double sum = 0;
    for (int i = 0; i < n; i++) {
        double slope = cos(4 * ((2 * i + 1.0) / n - 1)) / 2;
        sum += sqrt(1 + slope * slope);
    }
    return sum * 4 / n;
}

START_TEST(areas_match_closed_forms)
{
    const struct {
        enum hatch_shape shape;
        double area;
    } known[] = {
        {HATCH_SHAPE_SPHERE, 4 * PI},
        {HATCH_SHAPE_CYLINDER, 4 * PI},
        {HATCH_SHAPE_CONE, PI * sqrt(5.0)},
        {HATCH_SHAPE_WAVE, wave_area()},
        {HATCH_SHAPE_TORUS, 4 * PI * PI * 0.4},
        {HATCH_SHAPE_PLANE, 4},
        {HATCH_SHAPE_SADDLE, saddle_area()},
        {HATCH_SHAPE_FRUSTUM, PI * 1.5 * sqrt(4.25)},
        {HATCH_SHAPE_CATENOID, PI * 0.5 * (1.5 + 0.5 * sinh(3))},
        {HATCH_SHAPE_HELICOID, 2 * PI * (sqrt(1 + 0.1225) + 0.1225 * asinh(1 / 0.35))},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        struct hatch_mesh mesh = make(known[i].shape, 40000, 0, 0, 1);
        double area = measure(&mesh).area;
        ck_assert_msg(fabs(area / known[i].area - 1) < 1e-3, "%s: area %g, want %g", hatch_shape_names[known[i].shape],
                      area, known[i].area);
    }
}
END_TEST

/* It is 0.25 high and falls off with the fourth power of what is left of the way, in the cosine, to 60 degrees. */
START_TEST(a_bump_ends_at_60_degrees)
{
    double slope[2];
    ck_assert_double_eq_tol(hatch_bump_radius(1, slope), 1.25, 1e-12);
    ck_assert_double_eq_tol(hatch_bump_radius(0.75, slope), 1 + 0.25 / 16, 1e-12);
    for (double cosine = 0.5; cosine >= -1; cosine -= 0.25) {
        ck_assert_double_eq(hatch_bump_radius(cosine, slope), 1);
        ck_assert_double_eq(slope[0], 0);
        ck_assert_double_eq(slope[1], 0);
    }
}
END_TEST

START_TEST(topology_is_correct)
{
    const struct {
        enum hatch_shape shape;
        uint32_t components, loops;
        int64_t euler, genus;
    } known[] = {
        {HATCH_SHAPE_SPHERE, 1, 0, 2, 0},   {HATCH_SHAPE_CYLINDER, 1, 2, 0, 0},     {HATCH_SHAPE_CONE, 1, 1, 1, 0},
        {HATCH_SHAPE_TORUS, 1, 0, 0, 1},    {HATCH_SHAPE_PLANE, 1, 1, 1, 0},        {HATCH_SHAPE_ELLIPSOID, 1, 0, 2, 0},
        {HATCH_SHAPE_SADDLE, 1, 1, 1, 0},   {HATCH_SHAPE_WAVE, 1, 1, 1, 0},         {HATCH_SHAPE_FRUSTUM, 1, 2, 0, 0},
        {HATCH_SHAPE_CATENOID, 1, 2, 0, 0}, {HATCH_SHAPE_SUPERQUADRIC, 1, 0, 2, 0}, {HATCH_SHAPE_BUMP, 1, 0, 2, 0},
        {HATCH_SHAPE_HELICOID, 1, 1, 1, 0}, {HATCH_SHAPE_MONGE, 1, 1, 1, 0},        {HATCH_SHAPE_EGGBOX, 1, 1, 1, 0},
    };
    const float jitters[] = {0, 1}, noises[] = {0, 0.3f};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        for (int k = 0; k < 4; k++) {
            struct hatch_mesh mesh = make(known[i].shape, 700, jitters[k % 2], noises[k / 2], (uint64_t)k);
            struct hatch_mesh_figures f = measure(&mesh);
            const char *name = hatch_shape_names[known[i].shape];
            ck_assert_msg(f.components == known[i].components, "%s: components", name);
            ck_assert_msg(f.boundary_loops == known[i].loops, "%s: loops", name);
            ck_assert_msg(f.euler == known[i].euler, "%s: Euler %d", name, (int)f.euler);
            ck_assert_msg(f.genus == known[i].genus, "%s: genus %d", name, (int)f.genus);
            ck_assert_uint_eq(f.degenerate_faces + f.duplicate_faces + f.unused_vertices, 0);
        }
}
END_TEST

START_TEST(smallest_shapes_are_manifold)
{
    for (int shape = 0; shape < HATCH_SHAPE_COUNT; shape++)
        for (uint32_t faces = 2; faces < 40; faces++) {
            struct hatch_mesh mesh = make((enum hatch_shape)shape, faces, 1, 0, faces);
            struct hatch_mesh_figures f = measure(&mesh);
            ck_assert_uint_eq(f.degenerate_faces + f.duplicate_faces + f.non_manifold_edges + f.contrary_edges +
                                  f.unused_vertices,
                              0);
        }
}
END_TEST

static void corner(const struct hatch_mesh *mesh, uint32_t vertex, double p[3], double n[3])
{
    hatch_vec_of(&hatch_mesh_find(mesh, "POSITION", 3)[(size_t)vertex * 3], p);
    hatch_vec_of(&hatch_mesh_find(mesh, "NORMAL", 3)[(size_t)vertex * 3], n);
}

START_TEST(faces_are_oriented_outwards_with_jitter)
{
    for (int shape = 0; shape < HATCH_SHAPE_COUNT; shape++) {
        /* The teapot's lip and foot are sharply curved and need small faces. */
        uint32_t faces = shape == HATCH_SHAPE_TEAPOT ? 200000 : 5000;
        struct hatch_mesh mesh = make((enum hatch_shape)shape, faces, 1, 0, 11);
        uint32_t back = 0;
        for (uint32_t f = 0; f < mesh.face_count; f++) {
            double c[3][3], normal[3], p[3], n[3];
            ck_assert(hatch_mesh_corners(&mesh, f, c));
            hatch_vec_triangle(c[0], c[1], c[2], normal);
            for (uint32_t k = 0; k < 3; k++) {
                corner(&mesh, mesh.indices[f * 3 + k], p, n);
                back += hatch_vec_dot(normal, n) <= 0;
            }
        }
        ck_assert_msg(back == 0, "%s: %u corners look inwards", hatch_shape_names[(enum hatch_shape)shape], back);
    }
}
END_TEST

START_TEST(tangents_point_along_u)
{
    for (int shape = 0; shape < HATCH_SHAPE_COUNT; shape++) {
        struct hatch_mesh mesh = make((enum hatch_shape)shape, 20000, 0, 0, 1), copy = mesh;
        const float *tangent = hatch_mesh_find(&mesh, "TANGENT", 4);
        /* tangents from positions and texture coordinates alone */
        for (uint32_t i = 0; i < copy.attribute_count; i++)
            if (strcmp(copy.attributes[i].name, "TANGENT") == 0)
                copy.attributes[i] = copy.attributes[--copy.attribute_count];
        HATCH_TEST_OK(hatch_mesh_add_tangents(&keep, &scratch, &copy, &err), &err);
        const float *derived = hatch_mesh_find(&copy, "TANGENT", 4);
        double worst = 0, p[3], n[3];
        for (uint32_t v = 0; v < mesh.vertex_count; v++) {
            double a[3], b[3];
            hatch_vec_of(&tangent[v * 4], a);
            hatch_vec_of(&derived[v * 4], b);
            corner(&mesh, v, p, n);
            ck_assert_double_eq_tol(hatch_vec_length(a), 1, 1e-6);
            ck_assert_double_eq_tol(hatch_vec_dot(a, n), 0, 1e-5);
            ck_assert_float_eq(tangent[v * 4 + 3], 1.0f);
            ck_assert_float_eq(derived[v * 4 + 3], 1.0f);
            worst += 1 - hatch_vec_dot(a, b);
        }
        ck_assert_msg(worst / mesh.vertex_count < 0.003, "%s: mean deviation %g",
                      hatch_shape_names[(enum hatch_shape)shape], worst / mesh.vertex_count);
    }
}
END_TEST

START_TEST(textures_repeat_whole_times_with_little_stretch)
{
    for (int shape = 0; shape < HATCH_SHAPE_COUNT; shape++) {
        struct hatch_mesh mesh = make((enum hatch_shape)shape, 5000, 0, 0, 1);
        const char *name = hatch_shape_names[(enum hatch_shape)shape];
        struct hatch_mesh_figures f = measure(&mesh);
        ck_assert_msg(f.has_uv && f.uv.degenerate_share == 0, "%s: degenerate", name);
        ck_assert_msg(f.uv.mirrored_share == 0, "%s: mirrored", name);
        ck_assert_msg(f.uv.angle[1] < 1.7, "%s: median stretch %g", name, f.uv.angle[1]);
        if (shape == HATCH_SHAPE_TEAPOT)
            continue;
        const float *uv = hatch_mesh_find(&mesh, "TEXCOORD_0", 2);
        float high[2] = {0, 0};
        for (uint32_t i = 0; i < mesh.vertex_count * 2; i++) {
            ck_assert_float_ge(uv[i], 0);
            if (uv[i] > high[i % 2])
                high[i % 2] = uv[i];
        }
        ck_assert_msg(high[0] == floorf(high[0]), "%s: u ends at %g", name, (double)high[0]);
        ck_assert_msg(high[1] == floorf(high[1]), "%s: v ends at %g", name, (double)high[1]);
    }
}
END_TEST

/* On shapes of one surface the texture covers 0 .. 1 once. */
START_TEST(whole_texture_covers_the_unit_square)
{
    static const enum hatch_shape shapes[] = {HATCH_SHAPE_SPHERE, HATCH_SHAPE_TORUS, HATCH_SHAPE_CYLINDER,
                                              HATCH_SHAPE_PLANE};
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++) {
        struct hatch_mesh mesh =
            shape_with(shapes[i], (struct hatch_shape_options){.faces = 500, .uv = HATCH_SHAPE_UV_WHOLE});
        const float *texcoord = hatch_mesh_find(&mesh, "TEXCOORD_0", 2);
        float low[2] = {9, 9}, high[2] = {-9, -9};
        for (size_t v = 0; v < mesh.vertex_count; v++)
            for (size_t k = 0; k < 2; k++) {
                low[k] = fminf(low[k], texcoord[2 * v + k]);
                high[k] = fmaxf(high[k], texcoord[2 * v + k]);
            }
        for (int k = 0; k < 2; k++) {
            ck_assert_float_eq_tol(low[k], 0, 0.03f); /* vertices at poles are half a step from the end */
            ck_assert_float_eq_tol(high[k], 1, 0.03f);
        }
    }
}
END_TEST

START_TEST(seams_differ_by_whole_tiles)
{
    struct hatch_mesh mesh = make(HATCH_SHAPE_TORUS, 3000, 1, 0.2f, 4);
    uint32_t points, *point = HATCH_NEW(&keep, uint32_t, mesh.vertex_count, &err);
    uint32_t *first = HATCH_NEW(&keep, uint32_t, mesh.vertex_count, &err);
    HATCH_TEST_OK(hatch_mesh_weld(&mesh, &scratch, point, &points, &err), &err);
    const float *uv = hatch_mesh_find(&mesh, "TEXCOORD_0", 2);
    uint32_t doubled = 0;
    for (uint32_t v = 0; v < mesh.vertex_count; v++) {
        if (!first[point[v]]) {
            first[point[v]] = v + 1;
            continue;
        }
        const float *other = &uv[(first[point[v]] - 1) * 2];
        for (int k = 0; k < 2; k++) {
            float apart = uv[v * 2 + (uint32_t)k] - other[k];
            ck_assert_float_eq_tol(apart, roundf(apart), 1e-5f);
        }
        doubled++;
    }
    ck_assert_uint_gt(doubled, 20);
}
END_TEST

START_TEST(teapot_has_the_published_size_and_topology)
{
    struct hatch_mesh mesh = make(HATCH_SHAPE_TEAPOT, 100000, 0, 0, 1);
    struct hatch_mesh_figures f = measure(&mesh);
    /* Wall and lid have one boundary, handle and spout two; the handle touches the wall at a point. */
    ck_assert_uint_eq(f.boundary_loops, 6);
    ck_assert_uint_eq(f.components, 3);
    ck_assert_uint_eq(f.non_manifold_points, 1);
    ck_assert_uint_eq(f.non_manifold_edges + f.contrary_edges + f.degenerate_faces, 0);
    /* 3 by 1.47 by 1.87; the lip of the spout extends a little beyond 3. */
    const double size[3] = {3.0022, 1.47, 1.8667};
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol((double)f.high[k] - (double)f.low[k], size[k], 1e-3);
    /* The published patches' area, 52.85 in their own units, times the square of 7/15. */
    ck_assert_double_eq_tol(f.area, 11.509, 0.003);
    ck_assert_float_lt(f.high[2] + f.low[2], 1e-6f);
}
END_TEST

/* Six times the volume under the faces beyond a plane of constant x, relative to their centre. */
static double volume_beyond(const struct hatch_mesh *mesh, double x, double side)
{
    double middle[3] = {0, 0, 0}, sum = 0, count = 0;
    for (int pass = 0; pass < 2; pass++)
        for (uint32_t f = 0; f < mesh->face_count; f++) {
            double c[3][3], normal[3];
            hatch_mesh_corners(mesh, f, c);
            if (side * c[0][0] < x || side * c[1][0] < x || side * c[2][0] < x)
                continue;
            hatch_vec_triangle(c[0], c[1], c[2], normal);
            if (pass == 0) {
                hatch_vec_add_scaled(middle, 1, c[0], middle);
                count += 1;
                continue;
            }
            hatch_vec_add_scaled(c[0], -1 / count, middle, c[0]);
            sum += hatch_vec_dot(c[0], normal);
        }
    return sum;
}

START_TEST(handle_and_spout_are_not_inside_out)
{
    struct hatch_mesh mesh = make(HATCH_SHAPE_TEAPOT, 30000, 0, 0, 1);
    ck_assert_double_gt(volume_beyond(&mesh, 1.1, -1), 0.05);
    ck_assert_double_gt(volume_beyond(&mesh, 0.95, 1), 0.05);
}
END_TEST

START_TEST(even_texture_has_less_stretch_than_natural)
{
    struct hatch_mesh mesh = make(HATCH_SHAPE_TEAPOT, 20000, 0, 0, 1), even;
    const struct hatch_shape_options options = {.faces = 20000, .uv = HATCH_SHAPE_UV_EVEN};
    HATCH_TEST_OK(hatch_shape_make(HATCH_SHAPE_TEAPOT, &options, &keep, &scratch, &even, &err), &err);
    ck_assert_double_lt(measure(&even).uv.angle[2], measure(&mesh).uv.angle[2]);
    ck_assert_mem_eq(hatch_mesh_find(&even, "POSITION", 3), hatch_mesh_find(&mesh, "POSITION", 3),
                     mesh.vertex_count * 12);
}
END_TEST

/* Along a meridian of a catenoid of waist c, the length from its middle is c sinh(y / c). */
START_TEST(even_texture_follows_the_length)
{
    const double c = 0.5; /* HATCH_CATENOID_WAIST */
    const struct hatch_shape_options options = {.faces = 2000, .uv = HATCH_SHAPE_UV_EVEN};
    struct hatch_mesh mesh = shape_with(HATCH_SHAPE_CATENOID, options), plain = shape_of(HATCH_SHAPE_CATENOID, 2000);
    const float *even = hatch_mesh_find(&mesh, "TEXCOORD_0", 2), *natural = hatch_mesh_find(&plain, "TEXCOORD_0", 2);
    const float *position = mesh.attributes[0].data;
    uint32_t first = 0, last = 0;
    for (uint32_t v = 0; v < mesh.vertex_count; v++) {
        first = even[2 * v + 1] < even[2 * first + 1] ? v : first;
        last = even[2 * v + 1] > even[2 * last + 1] ? v : last;
    }
    ck_assert_float_eq(even[2 * first + 1], natural[2 * first + 1]);
    ck_assert_float_eq(even[2 * last + 1], natural[2 * last + 1]);
    double from = sinh((double)position[3 * first + 1] / c), to = sinh((double)position[3 * last + 1] / c);
    double low = (double)even[2 * first + 1], high = (double)even[2 * last + 1];
    ck_assert_double_gt(high, low + 0.5);
    for (uint32_t v = 0; v < mesh.vertex_count; v++) {
        double share = (sinh((double)position[3 * v + 1] / c) - from) / (to - from);
        ck_assert_double_eq_tol((double)even[2 * v + 1], low + share * (high - low), 1e-3 * (high - low));
    }
}
END_TEST

START_TEST(face_counts_are_near_the_requested)
{
    const uint32_t counts[] = {100, 1000, 12345, 300000};
    for (int shape = 0; shape < HATCH_SHAPE_COUNT; shape++)
        for (int i = 0; i < 4; i++) {
            struct hatch_mesh mesh = make((enum hatch_shape)shape, counts[i], 0, 0, 1);
            double share = mesh.face_count / (double)counts[i];
            double slack = 2 / sqrt(counts[i]) + 0.005;
            ck_assert_msg(fabs(share - 1) < slack, "%s: %u faces, want %u", hatch_shape_names[(enum hatch_shape)shape],
                          mesh.face_count, counts[i]);
        }
}
END_TEST

/* On a plane of 2 by 2 the sides of the triangles along x and along y are those of the grid. */
START_TEST(cells_are_stretched)
{
    struct hatch_mesh mesh =
        shape_with(HATCH_SHAPE_PLANE, (struct hatch_shape_options){.faces = 4800, .stretch = 6, .seed = 1});
    double corners[3][3], low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    hatch_mesh_corners(&mesh, 0, corners);
    for (int k = 0; k < 3; k++)
        for (int c = 0; c < 3; c++) {
            low[k] = fmin(low[k], corners[c][k]);
            high[k] = fmax(high[k], corners[c][k]);
        }
    ck_assert_double_eq_tol((high[0] - low[0]) / (high[1] - low[1]), 6, 0.01);
    ck_assert_uint_eq(mesh.face_count, 4800);
}
END_TEST

START_TEST(the_same_seed_gives_the_same_shape)
{
    struct hatch_mesh a = make(HATCH_SHAPE_TEAPOT, 2000, 0.5f, 0.1f, 7);
    struct hatch_mesh b = make(HATCH_SHAPE_TEAPOT, 2000, 0.5f, 0.1f, 7);
    struct hatch_mesh c = make(HATCH_SHAPE_TEAPOT, 2000, 0.5f, 0.1f, 8);
    size_t size = (size_t)a.vertex_count * 12;
    ck_assert_mem_eq(a.attributes[0].data, b.attributes[0].data, size);
    ck_assert_mem_eq(a.indices, b.indices, (size_t)a.face_count * 12);
    ck_assert_int_ne(memcmp(a.attributes[0].data, c.attributes[0].data, size), 0);
    struct hatch_mesh still = make(HATCH_SHAPE_TEAPOT, 2000, 0, 0, 7);
    struct hatch_mesh other = make(HATCH_SHAPE_TEAPOT, 2000, 0, 0, 8);
    ck_assert_mem_eq(still.attributes[0].data, other.attributes[0].data, size);
}
END_TEST

START_TEST(noise_has_the_requested_deviation)
{
    struct hatch_mesh smooth = make(HATCH_SHAPE_PLANE, 20000, 0, 0, 3);
    struct hatch_mesh rough = make(HATCH_SHAPE_PLANE, 20000, 0, 0.25f, 3);
    const float *p = rough.attributes[0].data;
    double sum = 0, squares = 0, n = rough.vertex_count;
    for (uint32_t v = 0; v < rough.vertex_count; v++) {
        sum += (double)p[v * 3 + 2];
        squares += (double)p[v * 3 + 2] * (double)p[v * 3 + 2];
        ck_assert_float_eq(p[v * 3], smooth.attributes[0].data[v * 3]);
    }
    double want = 0.25 * 2.0 / 100 * (2 + sqrt(2.0)) / 3; /* mean edge of a right grid */
    ck_assert_double_eq_tol(sqrt(squares / n) / want, 1, 0.03);
    ck_assert_double_eq_tol(sum / n / want, 0, 0.05);
}
END_TEST

static enum hatch_status make_one(void *context, struct hatch_arena *kept, struct hatch_arena *temporary,
                                  struct hatch_err *error)
{
    const struct hatch_shape_options options = {.faces = 50, .jitter = 0.5f, .noise = 0.1f};
    return hatch_shape_make(HATCH_SHAPE_TEAPOT, &options, kept, temporary, context, error);
}

START_TEST(failed_allocations_are_reported)
{
    struct hatch_mesh mesh = {0};
    hatch_test_fail_alloc(make_one, &mesh, &mesh, sizeof mesh);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("shapes");
    TCase *tests = tcase_create("shapes");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, poles_have_one_position);
    tcase_add_test(tests, areas_match_closed_forms);
    tcase_add_test(tests, a_bump_ends_at_60_degrees);
    tcase_add_test(tests, topology_is_correct);
    tcase_add_test(tests, smallest_shapes_are_manifold);
    tcase_add_test(tests, faces_are_oriented_outwards_with_jitter);
    tcase_add_test(tests, tangents_point_along_u);
    tcase_add_test(tests, textures_repeat_whole_times_with_little_stretch);
    tcase_add_test(tests, whole_texture_covers_the_unit_square);
    tcase_add_test(tests, seams_differ_by_whole_tiles);
    tcase_add_test(tests, teapot_has_the_published_size_and_topology);
    tcase_add_test(tests, handle_and_spout_are_not_inside_out);
    tcase_add_test(tests, even_texture_has_less_stretch_than_natural);
    tcase_add_test(tests, even_texture_follows_the_length);
    tcase_add_test(tests, face_counts_are_near_the_requested);
    tcase_add_test(tests, cells_are_stretched);
    tcase_add_test(tests, the_same_seed_gives_the_same_shape);
    tcase_add_test(tests, noise_has_the_requested_deviation);
    tcase_add_test(tests, failed_allocations_are_reported);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
