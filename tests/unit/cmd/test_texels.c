/* Textures as parts of an OpenEXR file. */
#include "base/random.h"
#include "io/exr/exr.h"
#include "run.h"
#include "shared/texels.h"

enum { SIDE = 8 };

/* Level l of the part for slice k is slice k >> l of that level, also where there are fewer levels than the depth has
 * halves. */
START_TEST(parts_have_the_levels_of_their_slices)
{
    static const struct cmd_option options[] = {{0}};
    static const struct cmd_program program = {.name = "tested", .summary = "is tested", .options = options};
    static const char *const keys[] = {NULL};
    char *words[] = {(char[]){"tested"}, NULL};
    struct hatch_texels texels = {.width = SIDE, .height = SIDE, .depth = 2 * SIDE, .channels = 1, .level_count = 5};
    const struct cmd_texture texture = {.texels = &texels, .key_values = keys};
    struct hatch_buffer file = {0};
    struct hatch_mipmap *parts;
    struct cmd_args args;
    struct hatch_err err;
    uint32_t count;
    cmd_begin(&program, 1, words, &args);
    file.arena = &args.keep;
    HATCH_TEST_OK(hatch_texels_make(&args.keep, &texels, &err), &err);
    for (uint32_t l = 0; l < texels.level_count; l++)
        for (size_t i = 0; i < hatch_texels_level_size(&texels, l); i++)
            texels.texels[l][i] = (uint8_t)(255 * hatch_random_unit(1, l, i));
    cmd_encode_texture(&args, &texture, "made.exr", &file);
    HATCH_TEST_OK(hatch_exr_read((struct hatch_bytes){file.data, file.size}, NULL, &args.keep, &args.scratch, &parts,
                                 &count, &err),
                  &err);
    ck_assert_uint_eq(count, 2 * SIDE);
    for (uint32_t k = 0; k < count; k++) {
        ck_assert_uint_eq(parts[k].level_count, 4);
        for (uint32_t l = 0; l < 4; l++) {
            const uint32_t side = SIDE >> l;
            for (uint32_t i = 0; i < side * side; i++)
                ck_assert_float_eq_tol(parts[k].levels[l].pixels[i],
                                       (float)texels.texels[l][side * side * (k >> l) + i] / 255, 1e-3f);
        }
    }
    hatch_arena_free(&args.scratch);
    hatch_arena_free(&args.keep);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("cmd texels");
    TCase *tests = tcase_create("texels");
    tcase_add_test(tests, parts_have_the_levels_of_their_slices);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
