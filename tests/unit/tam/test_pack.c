#include "run.h"

#include "base/random.h"
#include "fail_alloc.h"
#include "tam/pack.h"

#define SIZE 4u
#define TONES 5u
#define LEVELS 3u

static struct hatch_arena keep;
static struct hatch_err err;
static struct hatch_mipmap columns[TONES];

static void make_map(bool color, struct hatch_tam *tam)
{
    *tam = (struct hatch_tam){.size_px = SIZE, .tones = TONES, .levels = 1, .color = color, .columns = columns};
    for (uint32_t tone = 0; tone < TONES; tone++) {
        columns[tone] = (struct hatch_mipmap){.level_count = LEVELS};
        columns[tone].levels = HATCH_NEW(&keep, struct hatch_image, LEVELS, &err);
        for (uint32_t l = 0; l < LEVELS; l++) {
            struct hatch_image *level = &columns[tone].levels[l];
            HATCH_TEST_OK(hatch_image_make(&keep, SIZE >> l, SIZE >> l, color ? "RGBi" : "Yi", level, &err), &err);
            for (size_t i = 0; i < (size_t)level->width * level->height * level->channel_count; i++)
                level->pixels[i] = hatch_random_unit(tone, l, i) * 1.2f - 0.1f;
        }
    }
}

static void begin(void)
{
    hatch_arena_init(&keep, (size_t)1 << 24);
}

static void end(void)
{
    hatch_arena_free(&keep);
}

static double clamped(const struct hatch_tam *tam, uint32_t tone, uint32_t level, size_t texel, uint32_t channel)
{
    const struct hatch_image *image = &tam->columns[tone].levels[level];
    double value = (double)image->pixels[texel * image->channel_count + channel];
    return value < 0 ? 0 : value > 1 ? 1 : value;
}

static void check_code(uint8_t code, double value, bool ink_is_one)
{
    double want = 255 * (ink_is_one ? 1 - value : value);
    ck_assert_msg((double)code >= want - 0.5001 && (double)code <= want + 0.5001, "%u for %g", code, want);
}

START_TEST(three_tones_are_packed_into_each_texture)
{
    struct hatch_tam tam;
    bool ink_is_one = _i;
    make_map(false, &tam);
    ck_assert_uint_eq(hatch_tam_rgb_count(&tam), 2);
    for (uint32_t index = 0; index < 2; index++) {
        struct hatch_texels texture;
        HATCH_TEST_OK(hatch_tam_pack_rgb(&tam, index, ink_is_one, &keep, &texture, &err), &err);
        ck_assert_uint_eq(texture.level_count, LEVELS);
        ck_assert(texture.width == SIZE && texture.channels == 4 && !texture.layers);
        for (uint32_t l = 0; l < LEVELS; l++)
            for (size_t i = 0; i < (SIZE >> l) * (SIZE >> l); i++) {
                for (uint32_t c = 0; c < 3; c++) {
                    uint32_t tone = 3 * index + c;
                    double value = tone < TONES ? clamped(&tam, tone, l, i, 0) : 1;
                    check_code(texture.texels[l][4 * i + c], value, ink_is_one);
                }
                ck_assert_uint_eq(texture.texels[l][4 * i + 3], 255);
            }
    }
}
END_TEST

START_TEST(an_array_has_a_layer_for_each_tone)
{
    struct hatch_tam tam;
    struct hatch_texels texture;
    bool color = _i;
    make_map(color, &tam);
    HATCH_TEST_OK(hatch_tam_pack_array(&tam, true, &keep, &texture, &err), &err);
    uint32_t channels = color ? 4 : 1;
    ck_assert(texture.layers == TONES && texture.channels == channels);
    for (uint32_t l = 0; l < LEVELS; l++)
        for (uint32_t tone = 0; tone < TONES; tone++) {
            size_t count = (SIZE >> l) * (SIZE >> l);
            const uint8_t *layer = texture.texels[l] + tone * count * channels;
            for (size_t i = 0; i < count; i++) {
                for (uint32_t c = 0; c < (color ? 3 : 1); c++)
                    check_code(layer[i * channels + c], clamped(&tam, tone, l, i, c), true);
                if (color)
                    ck_assert_uint_eq(layer[i * channels + 3], 255);
            }
        }
}
END_TEST

START_TEST(a_map_in_colour_is_rejected)
{
    struct hatch_tam tam;
    struct hatch_texels texture;
    make_map(true, &tam);
    ck_assert_int_eq(hatch_tam_pack_rgb(&tam, 0, false, &keep, &texture, &err), HATCH_BAD_INPUT);
}
END_TEST

static enum hatch_status pack_both(void *context, struct hatch_arena *arena, struct hatch_arena *scratch,
                                   struct hatch_err *error)
{
    struct hatch_texels first, all;
    (void)scratch;
    HATCH_TRY(hatch_tam_pack_rgb(context, 0, false, arena, &first, error));
    return hatch_tam_pack_array(context, false, arena, &all, error);
}

START_TEST(every_failed_allocation_is_a_status)
{
    struct hatch_tam tam;
    make_map(false, &tam);
    ck_assert_uint_ge(hatch_test_fail_alloc(pack_both, &tam, NULL, 0), 2 * LEVELS);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("tam pack");
    TCase *tests = tcase_create("pack");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, three_tones_are_packed_into_each_texture, 0, 2);
    tcase_add_loop_test(tests, an_array_has_a_layer_for_each_tone, 0, 2);
    tcase_add_test(tests, a_map_in_colour_is_rejected);
    tcase_add_test(tests, every_failed_allocation_is_a_status);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
