/* Choosing a layer among candidates takes about as many steps behind many layers as behind few. */
#include "arenas.h"
#include "base/reports.h"
#include "run.h"
#include "seed/seeds_make.h"
#include "seed/spread.h"
#include "steps.h"

static struct hatch_seeds make(uint32_t layers, struct reports *reports)
{
    const struct hatch_progress progress = {note_share, reports};
    const struct hatch_seeds_options options = {
        .cycle = {.count = 100, .seed = 3}, .layers = layers, .candidates = 30, .progress = &progress};
    struct hatch_seeds seeds;
    uint64_t tried;
    HATCH_TEST_OK(hatch_seeds_make(&options, &keep, &scratch, &seeds, &tried, &err), &err);
    return seeds;
}

/* Measured: 180,000 and 240,000 steps per layer. Rating each candidate with the points of all layers makes it 750,000
 * and 2,400,000. Fewer than 1000 would mean that steps are not counted. */
START_TEST(a_layer_takes_as_many_steps_behind_many_layers)
{
    struct reports reports = {0};
    steps = 0;
    make(8, &reports);
    double few = (double)steps / 8;
    steps = 0;
    reports = (struct reports){0};
    make(32, &reports);
    double many = (double)steps / 32;
    ck_assert_double_gt(few, 1000);
    ck_assert_msg(many < 1.5 * few, "%g steps a layer of 8, %g of 32", few, many);
}
END_TEST

START_TEST(every_candidate_is_reported)
{
    struct reports reports = {0};
    make(4, &reports);
    ck_assert_uint_eq(reports.count, 4 * 30);
    ck_assert_double_eq(reports.last, 1);
}
END_TEST

/* Rates a set as the last of count layers, whose points lie one after another, by all pairs of points. */
static double goodness_of(const struct hatch_seed_point *points, uint32_t count, uint32_t each)
{
    double own, together;
    HATCH_TEST_OK(hatch_spread_distance(points + (size_t)(count - 1) * each, each, &scratch, &own, &err), &err);
    HATCH_TEST_OK(hatch_spread_distance(points, count * each, &scratch, &together, &err), &err);
    own /= hatch_spread_bound(each);
    return count == 1 ? own : own * own * together / hatch_spread_bound(count * each);
}

/* Each layer is the first of the best among all candidates, made here one by one. */
START_TEST(the_best_candidate_is_chosen)
{
    enum { EACH = 100, LAYERS = 6, CANDIDATES = 30 };
    struct reports reports = {0};
    struct hatch_seeds seeds = make(LAYERS, &reports);
    struct hatch_seed_point points[LAYERS * EACH];
    for (uint32_t layer = 0; layer < LAYERS; layer++) {
        uint8_t crumbs[EACH], best_crumbs[EACH] = {0};
        const struct hatch_seed_set candidate = {EACH, crumbs};
        double best = -1;
        for (uint32_t i = 0; i < CANDIDATES; i++) {
            const struct hatch_cycle_options cycle = {.count = EACH, .seed = 3, .stream = (uint64_t)layer << 32 | i};
            HATCH_TEST_OK(hatch_cycle_make(&cycle, &scratch, crumbs, NULL, &err), &err);
            hatch_seed_points(&candidate, points + (size_t)layer * EACH);
            double goodness = goodness_of(points, layer + 1, EACH);
            if (goodness > best) {
                best = goodness;
                memcpy(best_crumbs, crumbs, EACH);
            }
        }
        ck_assert_mem_eq(seeds.layers[layer].crumbs, best_crumbs, EACH);
        hatch_seed_points(&seeds.layers[layer], points + (size_t)layer * EACH);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("seed steps");
    TCase *tests = tcase_create("steps");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_layer_takes_as_many_steps_behind_many_layers);
    tcase_add_test(tests, every_candidate_is_reported);
    tcase_add_test(tests, the_best_candidate_is_chosen);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
