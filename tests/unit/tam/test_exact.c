/* Exact runs that are read from a file. Their results are compared in test_thresholds.c. */
#include "tam/exact.h"
#include "tam_made.h"

static struct hatch_exact exact;

/* A wide stroke from tone .5 on, and another from .8 on. */
static float two_strokes(float u, float v, uint32_t level, float tone, uint32_t channel)
{
    (void)level, (void)channel;
    bool first = tone > 0.4999f && u > 0.25f && u<0.5f, second = tone> 0.7999f && v > 0.6f && v < 0.7f;
    return first || second ? 0 : 1;
}

static void make_exact(const struct hatch_tam *tam)
{
    HATCH_TEST_OK(hatch_exact_make(tam, NULL, &map_arena, &map_scratch, &exact, &map_err), &map_err);
}

static enum hatch_status read_back(struct hatch_exact *got)
{
    return hatch_exact_from_texels(&exact.texels, got, &map_err);
}

/* The smallest map, and one with the most columns. */
START_TEST(maps_at_the_limits_are_read_back)
{
    struct hatch_tam tam = made_map(_i ? 4 : 1, _i ? HATCH_TAM_TONES_MAX : 1, 1, "Y", made_ramp);
    struct hatch_exact got;
    make_exact(&tam);
    HATCH_TEST_OK(read_back(&got), &map_err);
    ck_assert_uint_eq(got.size_px, _i ? 4 : 1);
    ck_assert_uint_eq(got.columns, _i ? 256 : 1);
    ck_assert_uint_eq(got.level_count, _i ? 3 : 1);
    ck_assert_float_eq_tol(hatch_exact_sample(&got, 0.5f, 0.5f, 0.5f, 0), 0.5f, 0.01f);
}
END_TEST

/* The bytes are those of exact runs, but the texture has another kind. */
START_TEST(other_textures_are_refused)
{
    struct hatch_tam tam = made_map(64, 40, 1, "Y", two_strokes);
    struct hatch_exact got;
    make_exact(&tam);
    const struct hatch_texels kept = exact.texels;
    HATCH_TEST_OK(read_back(&got), &map_err);
    for (int kind = 0; kind < 4; kind++) {
        exact.texels = kept;
        if (kind == 0)
            exact.texels.code = HATCH_TEXELS_PLAIN;
        else
            *(kind == 1 ? &exact.texels.width : kind == 2 ? &exact.texels.depth : &exact.texels.layers) += 1;
        ck_assert_int_eq(read_back(&got), HATCH_BAD_INPUT);
        ck_assert_str_eq(map_err.text, "not exact runs as described in tamthresh(5)");
    }
}
END_TEST

/* A texel whose runs begin where those of the texel before do has none; they do not begin before these. */
START_TEST(an_index_that_falls_is_damage)
{
    struct hatch_tam tam = made_map(64, 40, 1, "Y", two_strokes);
    struct hatch_exact got;
    make_exact(&tam);
    uint8_t *index = exact.texels.texels[0] + 4 * (8 + 7 + 40); /* of the finest level */
    for (size_t texel = 1; texel < 64 * 64; texel += 61) {
        uint8_t *at = index + 4 * texel;
        uint32_t before = at[-4] | (uint32_t)at[-3] << 8, kept = at[0] | (uint32_t)at[1] << 8;
        for (uint32_t less = 0; less < 2 && less <= before; less++) {
            at[0] = (uint8_t)(before - less);
            at[1] = (uint8_t)((before - less) >> 8);
            ck_assert_int_eq(read_back(&got), less ? HATCH_BAD_INPUT : HATCH_OK);
        }
        at[0] = (uint8_t)kept;
        at[1] = (uint8_t)(kept >> 8);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("tam exact");
    TCase *tests = tcase_create("exact");
    tcase_add_checked_fixture(tests, map_begin, map_end);
    tcase_add_loop_test(tests, maps_at_the_limits_are_read_back, 0, 2);
    tcase_add_test(tests, other_textures_are_refused);
    tcase_add_test(tests, an_index_that_falls_is_damage);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
