/* Strokes are the same for any number of threads, place and size of the mesh, and number of finer levels. */
#include "fail_alloc.h"
#include "trace_make.h"

static struct field_case make_ring(uint32_t faces)
{
    struct field_case ring = case_of_shape(HATCH_SHAPE_TORUS, faces, 0.5f);
    follow_truth(&ring, HATCH_SHAPE_TORUS, 0, 1);
    return ring;
}

/* Two families, the second at an angle to the field. */
static struct hatch_trace_options two_families(double gap, uint32_t levels)
{
    static const float angles[2] = {0, 1};
    struct hatch_trace_options options = with_gap(gap, levels);
    options.family_count = 2;
    options.angle_rad = angles;
    return options;
}

/* Compares strokes whose lengths differ by a factor. */
static void check_same(const struct hatch_curves *a, const struct hatch_curves *b, float scale)
{
    ck_assert_uint_eq(b->set_count, a->set_count);
    ck_assert_uint_eq(b->count, a->count);
    ck_assert_uint_eq(b->point_count, a->point_count);
    ck_assert_mem_eq(b->curves, a->curves, a->count * sizeof *a->curves);
    for (uint32_t s = 0; s < a->set_count; s++) {
        struct hatch_curve_set scaled = a->sets[s];
        scaled.gap *= scale;
        ck_assert_mem_eq(&b->sets[s], &scaled, sizeof scaled);
    }
    for (uint32_t i = 0; i < a->point_count; i++) {
        struct hatch_curve_point scaled = a->points[i];
        scaled.threshold /= scale;
        ck_assert_msg(memcmp(&b->points[i], &scaled, sizeof scaled) == 0, "point %u", i);
    }
}

START_TEST(the_number_of_threads_does_not_matter)
{
    struct field_case ring = make_ring(2000);
    struct hatch_trace_options options = two_families(0.2, 3);
    struct hatch_curves one = trace_with(&ring, &options, NULL);
    ck_assert_uint_gt(one.count, 500);
    for (uint32_t threads = 1; threads <= 7; threads += threads == 1 ? 1 : 5) {
        struct hatch_pool *pool;
        HATCH_TEST_OK(hatch_pool_make(threads, &keep, &pool, &err), &err);
        struct hatch_curves many = trace_with(&ring, &options, pool);
        hatch_pool_free(pool);
        check_same(&one, &many, 1);
    }
}
END_TEST

/* Traces a plane of 20 by 20 squares with corners at multiples of 1/16, moved and then scaled, both without rounding.
 */
static struct hatch_curves trace_squares(float scale, float moved)
{
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 21 * 21, 800, &mesh, &err), &err);
    for (uint32_t v = 0; v < 21 * 21; v++) {
        float *at = &mesh.attributes[0].data[3 * v];
        at[0] = scale * ((float)(v % 21) / 16 + moved);
        at[1] = scale * ((float)(v / 21) / 16 - 2 * moved);
        at[2] = scale * moved;
    }
    for (uint32_t q = 0; q < 400; q++) {
        uint32_t a = q / 20 * 21 + q % 20;
        const uint32_t faces[6] = {a, a + 1, a + 22, a, a + 22, a + 21};
        memcpy(&mesh.indices[6 * q], faces, sizeof faces);
    }
    struct field_case field = case_of(mesh);
    const float angle = 0.4f;
    struct hatch_trace_options options = with_gap(0.125 * (double)scale, 3);
    options.angle_rad = &angle;
    set_direction(&field, 1, 0.25, 0);
    return trace_with(&field, &options, NULL);
}

START_TEST(size_and_place_do_not_matter)
{
    struct hatch_curves plain = trace_squares(1, 0), moved = trace_squares(1, 64);
    struct hatch_curves large = trace_squares(0x1p20f, 0), small = trace_squares(0x1p-30f, 8);
    ck_assert_uint_gt(plain.count, 100);
    check_same(&plain, &moved, 1);
    check_same(&plain, &large, 0x1p20f);
    check_same(&plain, &small, 0x1p-30f);
}
END_TEST

static const struct hatch_curve *find(const struct hatch_curves *curves, const struct hatch_curve_set *set, uint32_t id)
{
    for (uint32_t c = set->first; c < set->first + set->count; c++)
        if (curves->curves[c].id == id)
            return &curves->curves[c];
    return NULL;
}

static double ends_apart(const struct hatch_mesh *mesh, const struct hatch_curve_point *a,
                         const struct hatch_curve_point *b)
{
    float places[2][3];
    double at[2][3];
    hatch_curve_position(mesh, a, places[0]);
    hatch_curve_position(mesh, b, places[1]);
    for (int k = 0; k < 2; k++)
        hatch_vec_of(places[k], at[k]);
    return hatch_vec_distance(at[0], at[1]);
}

/* The strokes of a level are nearly the same whatever the number of levels: the length of steps follows the finest, and
 * rarely decides where a stroke along the field ends. */
START_TEST(finer_levels_leave_coarser_ones_alone)
{
    struct field_case ring = make_ring(2000);
    struct hatch_trace_options options = with_gap(0.2, 3);
    struct hatch_curves few = trace_with(&ring, &options, NULL);
    options.levels = 5;
    struct hatch_curves many = trace_with(&ring, &options, NULL);
    uint32_t same = 0, all = 0;
    for (uint32_t s = 0; s < few.set_count; s++)
        for (uint32_t c = few.sets[s].first; c < few.sets[s].first + few.sets[s].count; c++, all++) {
            const struct hatch_curve *a = &few.curves[c];
            const struct hatch_curve *b = find(&many, &many.sets[s], a->id);
            double near = 0.25 * (double)few.sets[s].gap;
            same += b && ends_apart(&ring.mesh, &few.points[a->first], &many.points[b->first]) < near &&
                    ends_apart(&ring.mesh, &few.points[a->first + a->count - 1],
                               &many.points[b->first + b->count - 1]) < near &&
                    fabs(log2((double)curve_threshold(&few, a) / (double)curve_threshold(&many, b))) < 0.25;
        }
    ck_assert_uint_gt(all, 400);
    ck_assert_msg(same > 0.9 * all, "%u of %u strokes are the same", same, all);
}
END_TEST

START_TEST(another_seed_gives_other_strokes)
{
    struct field_case ring = make_ring(500);
    struct hatch_trace_options options = with_gap(0.3, 2);
    struct hatch_curves first = trace_with(&ring, &options, NULL);
    options.seed = 2;
    struct hatch_curves second = trace_with(&ring, &options, NULL);
    uint32_t shared = 0;
    for (uint32_t s = 0; s < 2; s++)
        for (uint32_t c = first.sets[s].first; c < first.sets[s].first + first.sets[s].count; c++)
            shared += find(&second, &second.sets[s], first.curves[c].id) != NULL;
    ck_assert_uint_gt(first.count, 30);
    ck_assert_uint_eq(shared, 0);
}
END_TEST

static struct field_case small;
static struct hatch_curves traced;

static enum hatch_status trace_small(void *context, struct hatch_arena *kept, struct hatch_arena *temporary,
                                     struct hatch_err *error)
{
    return hatch_trace_make(&small.surface, &small.mesh, &small.frames, small.direction, context, NULL, kept, temporary,
                            &traced, error);
}

START_TEST(every_failed_allocation_is_a_limit)
{
    struct hatch_trace_options options = two_families(0.5, 2);
    small = make_ring(60);
    hatch_test_fail_alloc(trace_small, &options, &traced, sizeof traced);
}
END_TEST

/* Traces with a limit of temporary memory; returns the status. */
static enum hatch_status trace_within(size_t limit_bytes, struct hatch_trace_options *options, struct hatch_pool *pool)
{
    struct hatch_arena temporary;
    hatch_arena_init(&temporary, limit_bytes);
    enum hatch_status status = hatch_trace_make(&small.surface, &small.mesh, &small.frames, small.direction, options,
                                                pool, &keep, &temporary, &traced, &err);
    hatch_arena_free(&temporary);
    return status;
}

/* The limit is that of all families together: where it suffices for a little more than one, eight are traced one after
 * the other, although there are eight threads. */
START_TEST(families_share_the_memory)
{
    static const float angles[8] = {0, 0, 0, 0, 0, 0, 0, 0};
    struct hatch_trace_options options = with_gap(0.2, 4);
    struct hatch_pool *pool;
    size_t enough = (size_t)1 << 26;
    small = make_ring(2000);
    options.angle_rad = angles;
    while (trace_within(enough / 2, &options, NULL) == HATCH_OK)
        enough /= 2;
    ck_assert_uint_lt(enough, (size_t)1 << 26);
    options.family_count = 8;
    HATCH_TEST_OK(hatch_pool_make(8, &keep, &pool, &err), &err);
    HATCH_TEST_OK(trace_within(2 * enough, &options, pool), &err);
    struct hatch_curves many = traced;
    ck_assert_int_eq(trace_within(enough / 4, &options, pool), HATCH_LIMIT);
    hatch_pool_free(pool);
    HATCH_TEST_OK(trace_within((size_t)1 << 28, &options, NULL), &err);
    check_same(&traced, &many, 1);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("trace same");
    TCase *tests = tcase_create("same");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, the_number_of_threads_does_not_matter);
    tcase_add_test(tests, size_and_place_do_not_matter);
    tcase_add_test(tests, finer_levels_leave_coarser_ones_alone);
    tcase_add_test(tests, another_seed_gives_other_strokes);
    tcase_add_test(tests, every_failed_allocation_is_a_limit);
    tcase_add_test(tests, families_share_the_memory);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
