/* Seeds of strokes before any stroke is there: random places on faces of any size. */
#include "trace/work.h"
#include "base/budget.h"
#include "trace_make.h"

enum { ACROSS = 4 };

/* Counts the seeds of the first phase on a plane of 2 by 2, in squares that divide it. */
static void count_seeds(uint32_t faces, double gap, uint64_t seed, uint32_t counts[ACROSS * ACROSS])
{
    struct field_case plane = trace_plane(faces, 0);
    const struct hatch_trace_options options = with_gap(gap, 1);
    const struct hatch_component *component = &plane.surface.components[0];
    struct hatch_arena_mark mark = hatch_arena_mark(&scratch);
    struct hatch_trace_room pieces, stops;
    struct hatch_budget budget;
    struct hatch_tracer tracer = {.options = &options,
                                  .seed = seed,
                                  .component = component,
                                  .keep = &keep,
                                  .scratch = &scratch,
                                  .gap = gap / component->scale,
                                  .leg_max = 2 * gap / component->scale,
                                  .piece_room = &pieces,
                                  .stop_room = &stops};
    hatch_budget_init(&budget, (size_t)1 << 30);
    hatch_trace_room_init(&pieces, &budget);
    hatch_trace_room_init(&stops, &budget);
    HATCH_TEST_OK(hatch_trace_lay_out(&plane.surface, &plane.frames, plane.direction, 0, options.hard_rad, &keep,
                                      &tracer.ground, &err),
                  &err);
    HATCH_TEST_OK(hatch_trace_sort(&tracer, &err), &err);
    HATCH_TEST_OK(hatch_trace_add_seeds(&tracer, 0, &err), &err);
    for (uint32_t s = 0; s < tracer.stroke_count; s++) {
        const struct hatch_trace_place *place = &tracer.strokes[s].seed;
        double at[3];
        hatch_trace_position(&tracer.ground.poses[place->face], place->x, place->y, at);
        for (int k = 0; k < 2; k++)
            at[k] = (at[k] * component->scale + component->center[k] + 1) / 2 * ACROSS;
        ck_assert(at[0] >= 0 && at[0] < ACROSS && at[1] >= 0 && at[1] < ACROSS);
        counts[ACROSS * (uint32_t)at[1] + (uint32_t)at[0]]++;
    }
    hatch_trace_room_free(&stops);
    hatch_trace_room_free(&pieces);
    hatch_arena_rewind(&scratch, mark);
}

/* There is a seed for 50 squares of a gap, less those that others are too near to. */
START_TEST(seeds_are_as_many_everywhere)
{
    static const uint32_t faces[] = {2, 50, 20000};
    uint32_t counts[ACROSS * ACROSS] = {0}, all = 0;
    for (uint64_t seed = 1; seed <= 4; seed++)
        count_seeds(faces[_i], 0.01, seed, counts);
    for (int i = 0; i < ACROSS * ACROSS; i++)
        all += counts[i];
    double want = 4 * (2 / 0.01) * (2 / 0.01) / 50, mean = (double)all / (ACROSS * ACROSS);
    ck_assert_msg(all > 0.75 * want && all < 0.9 * want, "%u of %g seeds", all, want);
    for (int i = 0; i < ACROSS * ACROSS; i++)
        ck_assert_msg(fabs(counts[i] - mean) < 4 * sqrt(mean), "square %d: %u seeds, %g in mean", i, counts[i], mean);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("trace seeds");
    TCase *tests = tcase_create("seeds");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, seeds_are_as_many_everywhere, 0, 3);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
