#include "run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/random.h"
#include "fail_alloc.h"
#include "image/block_codes.h"
#include "image/block_compress.h"

static struct hatch_arena keep;
static struct hatch_err err;

static void begin(void)
{
    hatch_arena_init(&keep, (size_t)64 << 20);
}

static void end(void)
{
    hatch_arena_free(&keep);
}

static struct hatch_texels texture(uint32_t width, uint32_t height, uint32_t layers, uint32_t depth, uint32_t channels)
{
    struct hatch_texels made = {
        .width = width, .height = height, .layers = layers, .depth = depth, .channels = channels};
    made.level_count = hatch_texels_chain_length(&made);
    HATCH_TEST_OK(hatch_texels_make(&keep, &made, &err), &err);
    return made;
}

static struct hatch_texels round_trip_as(enum hatch_texels_code code, const struct hatch_texels *plain,
                                         struct hatch_block_figures *figures, size_t *bytes)
{
    struct hatch_texels packed, back;
    HATCH_TEST_OK(hatch_texels_compress(plain, code, NULL, &keep, &packed, figures, &err), &err);
    HATCH_TEST_OK(hatch_texels_decompress(&packed, &keep, &back, &err), &err);
    ck_assert(packed.code == code && back.code == HATCH_TEXELS_PLAIN);
    *bytes = hatch_texels_level_size(&packed, 0);
    return back;
}

static struct hatch_texels round_trip(const struct hatch_texels *plain, struct hatch_block_figures *figures,
                                      size_t *bytes)
{
    return round_trip_as(plain->channels == 1 ? HATCH_TEXELS_BC4 : HATCH_TEXELS_BC7, plain, figures, bytes);
}

/* Checks the figures against the textures; back may have alpha where plain has none. */
static void check_figures(const struct hatch_texels *plain, const struct hatch_texels *back,
                          const struct hatch_block_figures *figures)
{
    double worst = 0;
    for (uint32_t level = 0; level < plain->level_count; level++) {
        size_t texels = hatch_texels_level_size(plain, level) / plain->channels;
        for (size_t i = 0; i < texels * plain->channels; i++) {
            if (i % plain->channels >= back->channels) /* BC1 has no alpha */
                continue;
            size_t other = i / plain->channels * back->channels + i % plain->channels;
            worst = fmax(worst, fabs((double)plain->texels[level][i] - back->texels[level][other]) / 255);
        }
    }
    ck_assert_double_eq_tol(figures->error_max, worst, 1e-12);
    ck_assert_double_le(figures->error_rms, worst);
}

/* Examples of both modes of the specification, computed by hand. */
START_TEST(bc4_blocks_are_decoded_as_specified)
{
    uint8_t blocks[2][8] = {{211, 0, 0x88, 0xc6, 0xfa, 0, 0, 0}, {0, 252, 0x88, 0xc6, 0xfa, 0, 0, 0}};
    static const uint8_t want[2][8] = {{211, 0, 181, 151, 121, 90, 60, 30}, {0, 252, 50, 101, 151, 202, 0, 255}};
    struct hatch_texels packed = {.width = 4,
                                  .height = 4,
                                  .channels = 1,
                                  .level_count = 1,
                                  .code = HATCH_TEXELS_BC4,
                                  .texels = {blocks[_i]}},
                        back;
    HATCH_TEST_OK(hatch_texels_decompress(&packed, &keep, &back, &err), &err);
    for (uint32_t i = 0; i < 8; i++) /* indices 0 to 7 */
        ck_assert_uint_eq(back.texels[0][i], want[_i][i]);
}
END_TEST

START_TEST(paper_and_ink_are_kept_exactly)
{
    struct hatch_block_figures figures;
    struct hatch_texels plain = texture(37, 11, 3, 0, 1);
    size_t bytes;
    for (uint32_t level = 0; level < plain.level_count; level++)
        for (size_t i = 0; i < hatch_texels_level_size(&plain, level); i++)
            plain.texels[level][i] = hatch_random_u64(1, level, i) % 3 ? 255 : 0;
    struct hatch_texels back = round_trip(&plain, &figures, &bytes);
    check_figures(&plain, &back, &figures);
    ck_assert_double_eq(figures.error_max, 0);
    ck_assert_uint_eq(bytes, 10 * 3 * 3 * 8);
}
END_TEST

/* Each block has two greys of its own beside paper and ink, some blocks only one: they are the values that it stores.
 */
START_TEST(paper_ink_and_two_greys_are_kept_exactly)
{
    struct hatch_block_figures figures;
    struct hatch_texels plain = texture(64, 64, 0, 0, 1);
    size_t bytes;
    for (uint32_t i = 0; i < 64 * 64; i++) {
        uint64_t block = i / 256 * 16 + i % 64 / 4, pick = hatch_random_u64(1, 0, i) % 4;
        uint64_t grey = hatch_random_u64(1, 1, block) % 256, other = hatch_random_u64(1, 2, block) % 256;
        other = block % 2 ? other : grey;
        plain.texels[0][i] = (uint8_t)(pick == 0 ? 0 : pick == 1 ? 255 : pick == 2 ? grey : other);
    }
    struct hatch_texels back = round_trip(&plain, &figures, &bytes);
    ck_assert_mem_eq(back.texels[0], plain.texels[0], 64 * 64);
}
END_TEST

/* Returns the sum of the squared errors of a block with two end points, from the numbers of the specification. */
static unsigned bc4_squares(uint8_t texels[16][4], int first, int second)
{
    int numbers[8] = {first, second, [6] = 0, [7] = 255}, steps = first > second ? 7 : 5;
    unsigned sum = 0;
    for (int i = 1; i < steps; i++)
        numbers[i + 1] = (int)lround(first + (double)(second - first) * i / steps);
    for (int t = 0; t < 16; t++) {
        int least = 255;
        for (int i = 0; i < 8; i++)
            least = abs(texels[t][0] - numbers[i]) < least ? abs(texels[t][0] - numbers[i]) : least;
        sum += (unsigned)(least * least);
    }
    return sum;
}

/* Of both modes a block has the one with the smaller error, and each texel its nearest number. Bits that lay in the
 * block before do not matter. Each second block has texels of 0 or 255. */
START_TEST(bc4_blocks_have_the_better_mode)
{
    uint32_t with_ends = 0;
    for (uint64_t n = 0; n < 3000; n++) {
        uint8_t texels[16][4] = {{0}}, back[16][4], block[8];
        uint64_t base = hatch_random_u64(n, 0, 0) % 200, range = 1 + hatch_random_u64(n, 0, 1) % 56;
        int low = 255, high = 0, inner_low = 255, inner_high = 0;
        for (int t = 0; t < 16; t++) {
            uint64_t pick = hatch_random_u64(n, 1, (uint64_t)t), grey = base + (pick >> 8) % range;
            int value = (int)(n % 2 && pick % 8 == 0 ? 0 : n % 2 && pick % 8 == 1 ? 255 : grey);
            texels[t][0] = (uint8_t)value;
            low = value < low ? value : low;
            high = value > high ? value : high;
            inner_low = value > 0 && value < inner_low ? value : inner_low;
            inner_high = value < 255 && value > inner_high ? value : inner_high;
        }
        unsigned without = bc4_squares(texels, high, low), with = bc4_squares(texels, inner_low, inner_high), sum = 0;
        memset(block, 0xff, sizeof block);
        hatch_bc4_encode(texels, block);
        hatch_bc4_decode(block, back);
        for (int t = 0; t < 16; t++)
            sum += (unsigned)((texels[t][0] - back[t][0]) * (texels[t][0] - back[t][0]));
        ck_assert_uint_eq(sum, with < without ? with : without);
        with_ends += with < without;
    }
    ck_assert(with_ends > 1000 && with_ends < 2000);
}
END_TEST

START_TEST(greys_are_approximated)
{
    struct hatch_block_figures figures;
    struct hatch_texels plain = texture(64, 64, 4, 0, 1);
    size_t bytes;
    for (uint32_t level = 0; level < plain.level_count; level++)
        for (size_t i = 0; i < hatch_texels_level_size(&plain, level); i++)
            plain.texels[level][i] = (uint8_t)(_i ? hatch_random_u64(1, level, i) : 100 + i % 64);
    struct hatch_texels back = round_trip(&plain, &figures, &bytes);
    check_figures(&plain, &back, &figures);
    /* Half of a seventh of the range; half of a fifth in the mode with 0 and 255. */
    ck_assert_double_le(figures.error_max, _i ? 26.0 / 255 : 3.0 / 255);
}
END_TEST

START_TEST(colours_are_approximated)
{
    struct hatch_block_figures figures;
    struct hatch_texels plain = texture(20, 18, 0, 7, _i ? 4 : 3);
    size_t bytes;
    for (uint32_t level = 0; level < plain.level_count; level++)
        for (size_t i = 0; i < hatch_texels_level_size(&plain, level); i++) {
            /* ink of one colour on paper: a line through the colours */
            float share = hatch_random_unit(1, level, i / plain.channels);
            static const float ink[] = {40, 80, 200, 255};
            plain.texels[level][i] = (uint8_t)(255 + (ink[i % plain.channels] - 255) * share);
        }
    struct hatch_texels back = round_trip(&plain, &figures, &bytes);
    check_figures(&plain, &back, &figures);
    ck_assert_double_le(figures.error_max, 11.0 / 255);
    ck_assert_double_le(figures.error_rms, 5.0 / 255);
    ck_assert_uint_eq(bytes, 5 * 5 * 7 * 16);
}
END_TEST

/* Both modes, computed by hand: red and blue with thirds between them; then with the mean and black. */
START_TEST(bc1_blocks_are_decoded_as_specified)
{
    uint8_t blocks[2][8] = {{0, 0xf8, 0x1f, 0, 0xe4, 0, 0, 0}, {0x1f, 0, 0, 0xf8, 0xe4, 0, 0, 0}};
    static const uint8_t want[2][4][3] = {{{255, 0, 0}, {0, 0, 255}, {170, 0, 85}, {85, 0, 170}},
                                          {{0, 0, 255}, {255, 0, 0}, {128, 0, 128}, {0, 0, 0}}};
    struct hatch_texels packed = {.width = 4,
                                  .height = 4,
                                  .channels = 3,
                                  .level_count = 1,
                                  .code = HATCH_TEXELS_BC1,
                                  .texels = {blocks[_i]}},
                        back;
    HATCH_TEST_OK(hatch_texels_decompress(&packed, &keep, &back, &err), &err);
    ck_assert_uint_eq(back.channels, 3);
    for (uint32_t i = 0; i < 4; i++) /* indices 0 to 3 */
        for (int c = 0; c < 3; c++)
            ck_assert_uint_eq(back.texels[0][3 * i + (uint32_t)c], want[_i][i][c]);
}
END_TEST

/* Ink of one colour on paper: of four colours on a line the error is half of a third, and half a step of the end
 * points' bits. Paper and full ink have only the error of the end points. */
START_TEST(bc1_colours_are_approximated)
{
    struct hatch_block_figures figures;
    struct hatch_texels plain = texture(20, 18, 7, 0, _i & 1 ? 4 : 3);
    static const float ink[] = {40, 80, 200, 255};
    size_t bytes;
    for (uint32_t level = 0; level < plain.level_count; level++)
        for (size_t i = 0; i < hatch_texels_level_size(&plain, level); i++) {
            float share = hatch_random_unit(1, level, i / plain.channels);
            share = _i < 2 ? share : (float)(share > 0.5f);
            plain.texels[level][i] = (uint8_t)(255 + (ink[i % plain.channels] - 255) * share);
        }
    struct hatch_texels back = round_trip_as(HATCH_TEXELS_BC1, &plain, &figures, &bytes);
    check_figures(&plain, &back, &figures);
    ck_assert_double_le(figures.error_max, (_i < 2 ? 215 / 6.0 + 5 + 8 : 5) / 255);
    /* without fitting the end points to the indices it is 12.0 and 10.4 */
    ck_assert_double_le(figures.error_rms, (_i > 1 ? 1.5 : _i ? 9.0 : 10.5) / 255);
    ck_assert_uint_eq(bytes, 5 * 5 * 7 * 8);
}
END_TEST

/* The end points are fitted a second time although only one channel of one texel is off by one: the texel that differs
 * is a third of the way to an end point that no texel has. */
START_TEST(bc1_colours_between_the_end_points_are_exact)
{
    static const uint8_t most[3] = {8, 190, 66}, other[3] = {11, 193, 69};
    struct hatch_block_figures figures;
    struct hatch_texels plain = texture(4, 4, 0, 0, 3);
    size_t bytes;
    for (uint32_t level = 0; level < plain.level_count; level++)
        for (size_t i = 0; i < hatch_texels_level_size(&plain, level); i++)
            plain.texels[level][i] = most[i % 3];
    memcpy(&plain.texels[0][12 * 3], other, sizeof other);
    struct hatch_texels back = round_trip_as(HATCH_TEXELS_BC1, &plain, &figures, &bytes);
    ck_assert_mem_eq(back.texels[0], plain.texels[0], 48);
    ck_assert_double_eq(figures.error_max, 0);
}
END_TEST

START_TEST(a_single_colour_is_exact)
{
    struct hatch_block_figures figures;
    struct hatch_texels plain = texture(4, 4, 0, 0, 3);
    size_t bytes;
    for (uint32_t value = 0; value < 256; value++) {
        for (uint32_t level = 0; level < plain.level_count; level++)
            memset(plain.texels[level], (int)value, hatch_texels_level_size(&plain, level));
        round_trip(&plain, &figures, &bytes);
        ck_assert_double_eq(figures.error_max, 0);
    }
}
END_TEST

/* Layers that repeat that before them have its blocks, and its error; one that differs has its own. */
START_TEST(repeated_layers_have_repeated_blocks)
{
    struct hatch_texels plain = {.width = 10, .height = 9, .layers = 4, .channels = 1, .level_count = 1}, packed, one;
    struct hatch_block_figures all, first, last;
    const size_t layer = 90;
    HATCH_TEST_OK(hatch_texels_make(&keep, &plain, &err), &err);
    for (size_t i = 0; i < layer; i++)
        for (size_t k = 0; k < 4; k++)
            plain.texels[0][k * layer + i] = (uint8_t)(i * i * 31 + (k == 3 && i == 5 ? 40 : 0));
    HATCH_TEST_OK(hatch_texels_compress(&plain, HATCH_TEXELS_BC4, NULL, &keep, &packed, &all, &err), &err);
    plain.layers = 1;
    HATCH_TEST_OK(hatch_texels_compress(&plain, HATCH_TEXELS_BC4, NULL, &keep, &one, &first, &err), &err);
    size_t bytes = hatch_texels_level_size(&one, 0);
    for (size_t k = 0; k < 3; k++)
        ck_assert_mem_eq(packed.texels[0] + k * bytes, one.texels[0], bytes);
    plain.texels[0] += 3 * layer;
    HATCH_TEST_OK(hatch_texels_compress(&plain, HATCH_TEXELS_BC4, NULL, &keep, &one, &last, &err), &err);
    ck_assert_mem_eq(packed.texels[0] + 3 * bytes, one.texels[0], bytes);
    ck_assert_mem_ne(packed.texels[0], one.texels[0], bytes);
    ck_assert_double_eq_tol(all.error_rms * all.error_rms * 4,
                            first.error_rms * first.error_rms * 3 + last.error_rms * last.error_rms, 1e-12);
    ck_assert_double_eq_tol(all.error_max, fmax(first.error_max, last.error_max), 1e-12);
}
END_TEST

START_TEST(a_block_of_another_mode_is_rejected)
{
    uint8_t block[16] = {1};
    struct hatch_texels back,
        packed = {
            .width = 4, .height = 4, .channels = 4, .level_count = 1, .code = HATCH_TEXELS_BC7, .texels = {block}};
    ck_assert_int_eq(hatch_texels_decompress(&packed, &keep, &back, &err), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "level 0: BC7 is supported in mode 6 only");
}
END_TEST

START_TEST(unorm8_rounds_and_clamps)
{
    for (int i = -1000; i <= 2000; i++) {
        float value = (float)i / 1000;
        float clamped = value > 0 ? (value < 1 ? value : 1) : 0;
        ck_assert_uint_eq(hatch_unorm8(value), (uint8_t)(clamped * 255 + 0.5f));
    }
    ck_assert_uint_eq(hatch_unorm8(-0.0f), 0);
    ck_assert_uint_eq(hatch_unorm8(1e30f), 255);
    ck_assert_uint_eq(hatch_unorm8(-1e30f), 0);
    ck_assert_uint_eq(hatch_unorm8(INFINITY), 255);
}
END_TEST

static struct hatch_texels packed_by_test;

static enum hatch_status compress(void *context, struct hatch_arena *arena, struct hatch_arena *scratch,
                                  struct hatch_err *error)
{
    (void)scratch;
    return hatch_texels_compress(context, HATCH_TEXELS_BC4, NULL, arena, &packed_by_test, NULL, error);
}

static enum hatch_status decompress(void *context, struct hatch_arena *arena, struct hatch_arena *scratch,
                                    struct hatch_err *error)
{
    static struct hatch_texels plain;
    (void)scratch;
    return hatch_texels_decompress(context, arena, &plain, error);
}

START_TEST(every_failed_allocation_is_a_status)
{
    struct hatch_texels plain = texture(16, 16, 2, 0, 1), packed;
    hatch_test_fail_alloc(compress, &plain, &packed_by_test, sizeof packed_by_test);
    HATCH_TEST_OK(hatch_texels_compress(&plain, HATCH_TEXELS_BC4, NULL, &keep, &packed, NULL, &err), &err);
    hatch_test_fail_alloc(decompress, &packed, NULL, 0);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("image blocks");
    TCase *tests = tcase_create("blocks");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, bc4_blocks_are_decoded_as_specified, 0, 2);
    tcase_add_test(tests, paper_and_ink_are_kept_exactly);
    tcase_add_test(tests, paper_ink_and_two_greys_are_kept_exactly);
    tcase_add_test(tests, bc4_blocks_have_the_better_mode);
    tcase_add_loop_test(tests, greys_are_approximated, 0, 2);
    tcase_add_loop_test(tests, colours_are_approximated, 0, 2);
    tcase_add_loop_test(tests, bc1_blocks_are_decoded_as_specified, 0, 2);
    tcase_add_loop_test(tests, bc1_colours_are_approximated, 0, 4);
    tcase_add_test(tests, bc1_colours_between_the_end_points_are_exact);
    tcase_add_test(tests, a_single_colour_is_exact);
    tcase_add_test(tests, repeated_layers_have_repeated_blocks);
    tcase_add_test(tests, a_block_of_another_mode_is_rejected);
    tcase_add_test(tests, unorm8_rounds_and_clamps);
    tcase_add_test(tests, every_failed_allocation_is_a_status);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
