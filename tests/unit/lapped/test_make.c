#include "fail_alloc.h"
#include "lapped_make.h"
#include "lapped/work.h"
#include "mesh/edges.h"

/* A field along the first principal direction of a shape. */
static struct field_case along_curvature(enum hatch_shape shape, uint32_t faces, float jitter)
{
    struct field_case field = case_of_shape(shape, faces, jitter);
    for (uint32_t p = 0; p < field.surface.point_count; p++) {
        double position[3], normal[3], curvature[2], *d = &field.direction[3 * p];
        hatch_surface_position(&field.surface, p, position);
        hatch_shape_curvature(shape, position, normal, d, curvature);
        if (hatch_vec_length(d) < 0.5)
            hatch_vec_copy(&field.frames.axis[3 * p], d);
        field.confidence[p] = 1;
    }
    return field;
}

/* Checks that hatch coordinates are a flattening, up to translation and half a turn. */
static void check_isometric(const struct lapped_case *made, void (*flatten)(const double *, double *))
{
    const struct hatch_lapped *lapped = &made->lapped;
    uint32_t met = 0;
    for (uint32_t p = 0; p < lapped->patch_count; p++) {
        const struct hatch_lapped_patch *patch = &lapped->patches[p];
        double sign = 0;
        for (uint32_t i = 0; i < 3 * patch->face_count; i++) {
            size_t corner = 3 * (size_t)patch->first_face + i, next = i % 3 == 2 ? corner - 2 : corner + 1;
            const struct hatch_lapped_vertex *a = &lapped->vertices[patch->first_vertex + lapped->corners[corner]];
            const struct hatch_lapped_vertex *b = &lapped->vertices[patch->first_vertex + lapped->corners[next]];
            double from[3], to[3], u[2], v[2];
            hatch_surface_position(&made->field.surface, a->point, from);
            hatch_surface_position(&made->field.surface, b->point, to);
            flatten(from, u);
            flatten(to, v);
            double dx = b->hatch[0] - a->hatch[0], dy = b->hatch[1] - a->hatch[1];
            double wx = v[0] - u[0], wy = v[1] - u[1];
            if (fabs(wx) > 3)
                continue; /* across the seam of the flattening */
            if (sign == 0)
                sign = dx * wx + dy * wy > 0 ? 1 : -1;
            ck_assert_double_eq_tol(dx, sign * wx, 2e-4);
            ck_assert_double_eq_tol(dy, sign * wy, 2e-4);
            met++;
        }
    }
    ck_assert_uint_ge(met, 3 * made->field.surface.face_count); /* more: patches overlap, and few sides lie on a seam */
}

static void flat_plane(const double *p, double *u)
{
    u[0] = p[0];
    u[1] = -p[1];
}

START_TEST(a_plane_keeps_its_lengths)
{
    struct field_case field = case_of_shape(HATCH_SHAPE_PLANE, 3000, 1);
    set_direction(&field, 1, 0, 0);
    struct hatch_lapped_options options = LAPPED_DEFAULTS;
    options.size = 0.2;
    struct lapped_case plane = make_lapped(field, &options);
    ck_assert_uint_gt(plane.lapped.patch_count, 10);
    ck_assert_uint_eq(plane.lapped.cut_count, 0);
    check_patches(&plane, 3000);
    check_isometric(&plane, flat_plane);
}
END_TEST

/* Makes a flat star: a fan of count faces, and a face of the same height beyond each side of its rim. */
static struct hatch_mesh star(uint32_t count)
{
    struct hatch_mesh hub = fan(count), mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 2 * count + 1, 2 * count, &mesh, &err), &err);
    memcpy(mesh.attributes[0].data, hub.attributes[0].data, 12 * ((size_t)count + 1));
    memcpy(mesh.indices, hub.indices, 12 * (size_t)count);
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t next = (i + 1) % count, tip = count + 1 + i, face[3] = {next, i, tip};
        for (uint32_t k = 0; k < 2; k++)
            mesh.attributes[0].data[3 * tip + k] =
                mesh.attributes[0].data[3 * i + k] + mesh.attributes[0].data[3 * next + k];
        memcpy(&mesh.indices[3 * (size_t)(count + i)], face, sizeof face);
    }
    return mesh;
}

/* Its faces lie across each other wherever a line sweeps over them, so that the factors of one patch are sparse. */
START_TEST(a_star_keeps_its_lengths)
{
    struct field_case field = case_of(star(5000));
    set_direction(&field, 1, 0, 0);
    struct hatch_lapped_options options = LAPPED_DEFAULTS;
    options.size = 1;
    struct lapped_case made = make_lapped(field, &options);
    check_patches(&made, 10000);
    check_isometric(&made, flat_plane);
}
END_TEST

/* Flattens a prism of SIDES sides: u runs around, v downwards. */
#define SIDES 64
static void flat_prism(const double *p, double *u)
{
    double step = 2 * PI / SIDES, angle = atan2(p[0], p[2]);
    double side = floor(angle / step), in = angle - (side + 0.5) * step;
    /* Along the chord. */
    u[0] = 2 * sin(step / 2) * side + cos(step / 2) * tan(in);
    u[1] = -p[1];
}

START_TEST(a_prism_is_unrolled)
{
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, SIDES * 11, SIDES * 20, &mesh, &err), &err);
    for (uint32_t i = 0; i < SIDES; i++)
        for (uint32_t j = 0; j < 11; j++) {
            float *at = &mesh.attributes[0].data[3 * (i * 11 + j)];
            at[0] = (float)sin(2 * PI * i / SIDES);
            at[1] = (float)j * 0.1f;
            at[2] = (float)cos(2 * PI * i / SIDES);
            uint32_t a = i * 11 + j, b = (i + 1) % SIDES * 11 + j;
            const uint32_t two[6] = {a, b, b + 1, a, b + 1, a + 1};
            if (j < 10)
                memcpy(&mesh.indices[6 * (i * 10 + j)], two, sizeof two);
        }
    struct field_case field = case_of(mesh);
    set_direction(&field, 0, 1, 0);
    struct lapped_case tube = make_lapped(field, &LAPPED_DEFAULTS);
    ck_assert_uint_gt(tube.lapped.patch_count, 3);
    check_patches(&tube, 2000);
    /* u runs upwards, as the field does: exchange the axes. */
    for (uint32_t v = 0; v < tube.lapped.vertex_count; v++) {
        double *hatch = tube.lapped.vertices[v].hatch, u = hatch[0];
        hatch[0] = -hatch[1];
        hatch[1] = u;
    }
    check_isometric(&tube, flat_prism);
}
END_TEST

START_TEST(a_torus_has_little_overlap)
{
    struct lapped_case torus = make_lapped(along_curvature(HATCH_SHAPE_TORUS, 12000, 1), &LAPPED_DEFAULTS);
    check_patches(&torus, 20000);
    double overlap = (double)torus.lapped.face_count / torus.field.surface.face_count;
    ck_assert_msg(overlap <= 1.5, "overlap %g", overlap);
}
END_TEST

/* Checks that no patch ends visibly: on a side behind which it has no face the surface ends, its opacity is 0, or later
 * patches hide it. */
static void check_ends(const struct lapped_case *made)
{
    const struct hatch_lapped *lapped = &made->lapped;
    uint32_t *held = HATCH_NEW(&keep, uint32_t, made->field.surface.face_count, &err);
    uint32_t samples = 0;
    ck_assert_uint_eq(lapped->cut_count, 0);
    for (uint32_t p = 0; p < lapped->patch_count; p++) {
        const struct hatch_lapped_patch *patch = &lapped->patches[p];
        for (uint32_t e = patch->first_face; e < patch->first_face + patch->face_count; e++)
            held[lapped->faces[e]] = p + 1;
        for (uint32_t i = 0; i < 3 * patch->face_count; i++) {
            uint32_t e = patch->first_face + i / 3, c = i % 3;
            uint32_t other = made->field.surface.opposite[3 * lapped->faces[e] + c];
            if (other == HATCH_NO_SIDE || held[other / 3] == p + 1)
                continue;
            for (int k = 1; k < 8; k++, samples++) {
                double bary[3] = {0, 0, 0}, mask[2];
                bary[c] = k / 8.0;
                bary[(c + 1) % 3] = 1 - k / 8.0;
                mask_at(lapped, p, e, bary, mask);
                double shown = hatch_outline_opacity(&made->outline, mask);
                ck_assert_msg(shown < 1e-3 || largest_opacity(made, lapped->faces[e], bary, p + 1) > 0.999,
                              "patch %u ends with opacity %g", p, shown);
            }
        }
    }
    ck_assert_uint_gt(samples, 1000);
}

START_TEST(patches_end_where_faded_or_hidden)
{
    struct lapped_case torus = make_lapped(along_curvature(HATCH_SHAPE_TORUS, 5000, 1), &LAPPED_DEFAULTS);
    check_ends(&torus);
    /* A tube on which patches are wide enough to meet themselves. */
    struct hatch_mesh tube = case_of_shape(HATCH_SHAPE_CYLINDER, 3000, 0).mesh;
    for (uint32_t v = 0; v < tube.vertex_count; v++)
        tube.attributes[0].data[3 * v + 1] *= 4;
    struct field_case along = case_of(tube);
    set_direction(&along, 0, 1, 0);
    struct hatch_lapped_options options = LAPPED_DEFAULTS;
    options.size = 1;
    options.curved = 0;
    struct lapped_case wrapped = make_lapped(along, &options);
    check_ends(&wrapped);
}
END_TEST

/* Patches as hatch_patch_make makes them, before any face is left out. */
START_TEST(every_patch_is_a_disk)
{
    struct field_case field = along_curvature(HATCH_SHAPE_TORUS, 3000, 1);
    struct hatch_outline outline;
    struct hatch_patch_domain domain;
    struct hatch_growth growth;
    struct hatch_core_coverage coverage;
    struct hatch_solver solver = {.arena = &keep};
    struct hatch_patch_notes done;
    struct hatch_lapped_options options = LAPPED_DEFAULTS;
    options.size = 0.6; /* wider than the tube is around */
    hatch_outline_make(3, 1, 0.05, &outline);
    uint8_t *covered = HATCH_NEW(&keep, uint8_t, field.surface.face_count, &err);
    const struct hatch_lapped_input input = lapped_input(&field, &outline);
    HATCH_TEST_OK(hatch_patch_domain_make(&input, &options, NULL, &keep, &scratch, &domain, &err), &err);
    HATCH_TEST_OK(hatch_growth_make(&domain, &outline, covered, &keep, &growth, &err), &err);
    HATCH_TEST_OK(hatch_core_coverage_make(&outline, field.surface.face_count, &keep, &coverage, &err), &err);
    for (uint32_t seed = 0; seed < field.surface.face_count; seed += 97) {
        HATCH_TEST_OK(hatch_patch_make(&growth, &solver, &options, seed, 0, &done, &err), &err);
        const struct hatch_patch *patch = &growth.patch;
        uint32_t inner = 0, outer = 0;
        for (uint32_t f = 0; f < patch->face_count; f++)
            for (uint32_t c = 0; c < 3; c++) {
                if (hatch_growth_side_inside(&growth, 3 * patch->faces[f] + c))
                    inner++;
                else
                    outer++;
            }
        ck_assert_int_eq((int)(patch->vertex_count + patch->face_count) - (int)(inner / 2 + outer), 1);
        ck_assert_uint_eq(patch->faces[0], seed);
        double mask[3][2];
        for (uint32_t c = 0; c < 3; c++)
            hatch_patch_mask(patch, &patch->xy[2 * patch->corners[c]], mask[c]);
        enum hatch_visibility visible;
        HATCH_TEST_OK(hatch_core_coverage_add(&coverage, seed, (const double(*)[2])mask, &visible, &err), &err);
        ck_assert(visible == HATCH_LAPPED_VISIBLE && coverage.covered[seed]);
    }
}
END_TEST

START_TEST(results_do_not_depend_on_threads_or_powers_of_two)
{
    struct field_case field = along_curvature(HATCH_SHAPE_ELLIPSOID, 6000, 1);
    struct lapped_case one = make_lapped(field, &LAPPED_DEFAULTS);
    struct hatch_pool *pool;
    struct hatch_lapped other;
    HATCH_TEST_OK(hatch_pool_make(3, &keep, &pool, &err), &err);
    const struct hatch_lapped_input input = lapped_input(&field, &one.outline);
    HATCH_TEST_OK(hatch_lapped_make(&input, &LAPPED_DEFAULTS, pool, &keep, &scratch, &other, &err), &err);
    hatch_pool_free(pool);
    ck_assert_uint_eq(one.lapped.vertex_count, other.vertex_count);
    ck_assert_mem_eq(one.lapped.vertices, other.vertices, other.vertex_count * sizeof *other.vertices);
    ck_assert_mem_eq(one.lapped.faces, other.faces, other.face_count * sizeof *other.faces);

    struct hatch_mesh large = field.mesh;
    for (uint32_t i = 0; i < 3 * large.vertex_count; i++)
        large.attributes[0].data[i] *= 1024;
    struct field_case grown = case_of(large);
    grown.direction = field.direction;
    grown.confidence = field.confidence;
    other = cover(&grown, &one.outline, &LAPPED_DEFAULTS);
    ck_assert_uint_eq(one.lapped.vertex_count, other.vertex_count);
    for (uint32_t v = 0; v < other.vertex_count; v++)
        ck_assert_double_eq(one.lapped.vertices[v].hatch[0] * 1024, other.vertices[v].hatch[0]);
}
END_TEST

START_TEST(a_rotated_and_moved_torus_is_covered_alike)
{
    struct field_case field = along_curvature(HATCH_SHAPE_TORUS, 4000, 1);
    struct lapped_case one = make_lapped(field, &LAPPED_DEFAULTS);
    struct hatch_mesh moved = field.mesh;
    for (uint32_t v = 0; v < moved.vertex_count; v++) {
        float *p = &moved.attributes[0].data[3 * v], x = p[0];
        p[0] = 0.6f * x - 0.8f * p[1] + 100;
        p[1] = 0.8f * x + 0.6f * p[1];
    }
    struct field_case turned = case_of(moved);
    for (uint32_t p = 0; p < turned.surface.point_count; p++) {
        const double *d = &field.direction[3 * p];
        const double rotated[3] = {0.6 * d[0] - 0.8 * d[1], 0.8 * d[0] + 0.6 * d[1], d[2]};
        hatch_vec_copy(rotated, &turned.direction[3 * p]);
    }
    struct lapped_case two = make_lapped(turned, &LAPPED_DEFAULTS);
    check_patches(&two, 5000);
    ck_assert_double_eq_tol((double)two.lapped.face_count / one.lapped.face_count, 1, 0.1);
}
END_TEST

START_TEST(a_patch_mesh_has_positions_of_the_source)
{
    struct field_case field = along_curvature(HATCH_SHAPE_TORUS, 2000, 0);
    struct lapped_case torus = make_lapped(field, &LAPPED_DEFAULTS);
    struct hatch_lapped_input input = lapped_input(&field, &torus.outline);
    input.tile = 0.25;
    for (uint32_t p = 0; p < torus.lapped.patch_count; p++) {
        const struct hatch_lapped_patch *patch = &torus.lapped.patches[p];
        struct hatch_mesh mesh;
        HATCH_TEST_OK(hatch_lapped_mesh(&input, &torus.lapped, p, &keep, &scratch, &mesh, &err), &err);
        HATCH_TEST_OK(hatch_mesh_check(&mesh, &err), &err);
        ck_assert_uint_eq(mesh.face_count, patch->face_count);
        const float *hatch = hatch_mesh_find(&mesh, "TEXCOORD_0", 2), *mask = hatch_mesh_find(&mesh, "TEXCOORD_1", 2);
        const float *written = hatch_mesh_find(&mesh, "_HATCH_DIR", 4), *at = hatch_mesh_find(&mesh, "POSITION", 3);
        for (uint32_t i = 0; i < 3 * mesh.face_count; i++) {
            uint32_t face = torus.lapped.faces[patch->first_face + i / 3], v = mesh.indices[i];
            uint32_t local = torus.lapped.corners[3 * (size_t)patch->first_face + i];
            const struct hatch_lapped_vertex *vertex = &torus.lapped.vertices[patch->first_vertex + local];
            uint32_t source = field.mesh.indices[3 * field.surface.face_source[face] + i % 3];
            ck_assert_mem_eq(&at[3 * v], &field.mesh.attributes[0].data[3 * source], 12);
            ck_assert_float_eq(hatch[2 * v], (float)(vertex->hatch[0] * 4 + patch->shift[0]));
            ck_assert_float_eq(mask[2 * v + 1], vertex->mask[1]);
            ck_assert_float_eq(written[4 * v], (float)field.direction[3 * vertex->point]);
            ck_assert_float_eq(written[4 * v + 3], 1);
        }
    }
}
END_TEST

static enum hatch_status make_all(void *context, struct hatch_arena *result, struct hatch_arena *work,
                                  struct hatch_err *error)
{
    struct lapped_case *made = context;
    const struct hatch_lapped_input input = lapped_input(&made->field, &made->outline);
    return hatch_lapped_make(&input, &LAPPED_DEFAULTS, NULL, result, work, &made->lapped, error);
}

static enum hatch_status make_mesh(void *context, struct hatch_arena *result, struct hatch_arena *work,
                                   struct hatch_err *error)
{
    struct lapped_case *made = context;
    struct hatch_mesh mesh;
    const struct hatch_lapped_input input = lapped_input(&made->field, &made->outline);
    return hatch_lapped_mesh(&input, &made->lapped, 0, result, work, &mesh, error);
}

START_TEST(failed_allocations_are_reported)
{
    struct lapped_case torus = make_lapped(along_curvature(HATCH_SHAPE_TORUS, 300, 0), &LAPPED_DEFAULTS);
    hatch_test_fail_alloc(make_all, &torus, &torus.lapped, sizeof torus.lapped);
    torus.lapped = cover(&torus.field, &torus.outline, &LAPPED_DEFAULTS);
    hatch_test_fail_alloc(make_mesh, &torus, NULL, 0);
}
END_TEST

/* Returns the variance of the logarithms of some numbers. */
static double spread_of(const double *values, uint32_t count)
{
    double sum = 0, squares = 0;
    for (uint32_t i = 0; i < count; i++) {
        sum += log(values[i]);
        squares += log(values[i]) * log(values[i]);
    }
    return squares / count - sum / count * (sum / count);
}

/* On an irregular plane the typical edges around faces differ less than the faces do. */
START_TEST(typical_edges_are_smoothed)
{
    struct lapped_case plane = {.field = case_of_shape(HATCH_SHAPE_PLANE, 2000, 1)};
    struct hatch_patch_domain domain;
    hatch_outline_make(3, 0.3, 0.05, &plane.outline);
    const struct hatch_lapped_input input = lapped_input(&plane.field, &plane.outline);
    uint32_t count = plane.field.surface.face_count;
    double *own = HATCH_NEW(&keep, double, count, &err);
    HATCH_TEST_OK(hatch_patch_domain_make(&input, &LAPPED_DEFAULTS, NULL, &keep, &scratch, &domain, &err), &err);
    for (uint32_t f = 0; f < count; f++) {
        const double *flat = &domain.flattened[4 * f];
        own[f] = sqrt((flat[0] * flat[3] - flat[1] * flat[2]) * 2 / sqrt(3));
    }
    ck_assert_double_gt(spread_of(own, count), 0.01);
    ck_assert_double_lt(spread_of(domain.edge_length, count), spread_of(own, count) / 4);
}
END_TEST

static void note_share(void *context, double share)
{
    double *last = context;
    ck_assert_double_ge(share, *last);
    ck_assert_double_le(share, 1);
    *last = share;
}

START_TEST(progress_rises_to_the_end)
{
    double last = 0;
    const struct hatch_progress progress = {note_share, &last};
    struct hatch_lapped_options options = LAPPED_DEFAULTS;
    options.progress = &progress;
    struct field_case field = case_of_shape(HATCH_SHAPE_TORUS, 2000, 1);
    set_direction(&field, 0, 0, 1);
    make_lapped(field, &options);
    ck_assert_double_eq(last, 1);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("lapped make");
    TCase *tests = tcase_create("patches");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_plane_keeps_its_lengths);
    tcase_add_test(tests, a_star_keeps_its_lengths);
    tcase_add_test(tests, a_prism_is_unrolled);
    tcase_add_test(tests, a_torus_has_little_overlap);
    tcase_add_test(tests, patches_end_where_faded_or_hidden);
    tcase_add_test(tests, every_patch_is_a_disk);
    tcase_add_test(tests, results_do_not_depend_on_threads_or_powers_of_two);
    tcase_add_test(tests, a_rotated_and_moved_torus_is_covered_alike);
    tcase_add_test(tests, a_patch_mesh_has_positions_of_the_source);
    tcase_add_test(tests, failed_allocations_are_reported);
    tcase_add_test(tests, typical_edges_are_smoothed);
    tcase_add_test(tests, progress_rises_to_the_end);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
