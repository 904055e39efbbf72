/* Strokes at a larger depth are a subset of those at a smaller one, and none appears while zooming out: in doubles, for
 * seed sets of all cycles. */
#include "arenas.h"
#include "rptam_ink.h"
#include "rptam_model.h"

enum { TILES = 4, STEPS = 24 };

/* Dots that do not overlap, even after zooming out by two octaves. */
static const struct model_how how = {.tile_px = 4096, .length_px = 8, .width_px = 8, .solid = true};

static struct hatch_rptam rptam;

static double ink_at(uint32_t seed, uint32_t tile_u, uint32_t tile_v, double depth, double amount, bool all)
{
    const struct hatch_seed_point *place = &rptam.layers[0].points[seed];
    const double uv[2] = {tile_u + (double)place->u * 0x1p-64, tile_v + (double)place->v * 0x1p-64};
    return rptam_layer_ink(&rptam, 0, uv, depth, amount, all);
}

static const struct {
    enum hatch_fade_law law;
    double overlap;
} fades[] = {{HATCH_FADE_EVEN, 0},
             {HATCH_FADE_EVEN, 0.3},
             {HATCH_FADE_EVEN, 1},
             {HATCH_FADE_PAPER, 0.5},
             {HATCH_FADE_WEIGHTED, 0.3}};
enum { FADES = sizeof fades / sizeof *fades };

/* Follows every stroke of 4 x 4 tiles while zooming out by two octaves. */
START_TEST(strokes_only_fade_while_zooming_out)
{
    static const uint32_t counts[] = {2, 5, 16, 37, 64};
    static const double amounts[] = {1, 0.5, 0.25};
    struct model_how model = how;
    model.seeds = counts[_i / FADES];
    model.law = fades[_i % FADES].law;
    model.overlap = fades[_i % FADES].overlap;
    model_make(&model, &keep, &scratch, &rptam);
    for (size_t k = 0; k < sizeof amounts / sizeof *amounts; k++) {
        double begun = 0, left = 0; /* ink */
        for (uint32_t i = 0; i < model.seeds * TILES * TILES; i++) {
            uint32_t seed = i / (TILES * TILES), u = i % TILES, v = i / TILES % TILES;
            double before = ink_at(seed, u, v, 0, amounts[k], false);
            begun += before;
            for (uint32_t step = 1; step <= 2 * STEPS; step++) {
                double now = ink_at(seed, u, v, (double)step / STEPS, amounts[k], false);
                ck_assert_msg(now <= before + 1e-9, "seed %u, tile %u %u, depth %g, amount %g: %g after %g", seed, u, v,
                              (double)step / STEPS, amounts[k], now, before);
                before = now;
            }
            left += before;
        }
        ck_assert_double_gt(begun, model.seeds * TILES * TILES * amounts[k] * 0.7);
        ck_assert_double_le(left, begun / 8 + 1);
    }
}
END_TEST

/* At whole depths the strokes of depth M + 1 are a subset of those of depth M, exactly a quarter of them. */
START_TEST(a_quarter_of_the_strokes_stays_at_each_level)
{
    static const uint32_t counts[] = {2, 3, 16, 37, 64, 250};
    struct model_how model = how;
    model.seeds = counts[_i];
    model_make(&model, &keep, &scratch, &rptam);
    for (int depth = 0; depth < 2; depth++) {
        uint32_t there = 0, further = 0;
        for (uint32_t i = 0; i < model.seeds * TILES * TILES; i++) {
            uint32_t seed = i / (TILES * TILES), u = i % TILES, v = i / TILES % TILES;
            bool now = ink_at(seed, u, v, depth, 1, true) > 0.5, next = ink_at(seed, u, v, depth + 1, 1, true) > 0.5;
            ck_assert(now || !next);
            there += now;
            further += next;
        }
        ck_assert_uint_eq(there, 4 * further);
    }
}
END_TEST

/* s -> 2 s modulo 1 maps seed point i to seed point i + 1 and the last to the first, for every size up to 2048 and all
 * three methods. Points hold 64 bits of an infinite fraction, so the last bit after doubling is unknown. */
START_TEST(doubling_maps_every_seed_set_onto_itself)
{
    static uint8_t crumbs[2048];
    static struct hatch_seed_point places[2048];
    for (uint32_t count = 2; count <= 2048; count++)
        for (int method = HATCH_CYCLE_ANY; method <= HATCH_CYCLE_BACKTRACK; method++) {
            bool power = hatch_cycle_order(count) > 0;
            if (method != HATCH_CYCLE_ANY && (!power || (method == HATCH_CYCLE_BACKTRACK && count > 64)))
                continue;
            const struct hatch_cycle_options options = {
                .method = (enum hatch_cycle_method)method, .count = count, .seed = count, .steps_max = 1000000};
            const struct hatch_seed_set set = {count, crumbs};
            HATCH_TEST_OK(hatch_cycle_make(&options, &scratch, crumbs, NULL, &err), &err);
            hatch_seed_points(&set, places);
            for (uint32_t i = 0; i < count; i++) {
                const struct hatch_seed_point *next = &places[(i + 1) % count];
                ck_assert_uint_eq(2 * places[i].u, next->u & ~(uint64_t)1);
                ck_assert_uint_eq(2 * places[i].v, next->v & ~(uint64_t)1);
            }
        }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("rptam nesting");
    TCase *tests = tcase_create("nesting");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, strokes_only_fade_while_zooming_out, 0, 5 * FADES);
    tcase_add_loop_test(tests, a_quarter_of_the_strokes_stays_at_each_level, 0, 6);
    tcase_add_test(tests, doubling_maps_every_seed_set_onto_itself);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
