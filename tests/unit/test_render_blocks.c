/* What an OpenGL driver makes of the blocks of tamvol --compress: it takes them where tamvol(5) says, and
 * reads the numbers that hatch_texels_unpack reads. */
#include "run.h"

#include <epoxy/gl.h>

#include <math.h>
#include <stdlib.h>

#include "base/random.h"
#include "image/blocks.h"
#include "render-gl/context.h"

#define SIDE 32u
#define DEEP 8u

static struct hatch_arena keep;
static struct hatch_err err;
static struct context context;

static void begin(void)
{
    hatch_arena_init(&keep, (size_t)64 << 20);
    HATCH_TEST_OK(context_open_headless(&context, 1, &err), &err);
}

static void end(void)
{
    context_close(&context);
    hatch_arena_free(&keep);
}

/* Soft strokes of ink on paper. */
static struct hatch_texels make(uint32_t channels, bool deep)
{
    static const float ink[] = {20, 60, 120};
    struct hatch_texels made = {.width = SIDE, .height = SIDE, .depth = deep ? DEEP : 0,
                                .layers = deep ? 0 : DEEP, .channels = channels, .level_count = 3};
    HATCH_TEST_OK(hatch_texels_make(&keep, &made, &err), &err);
    for (uint32_t level = 0; level < 3; level++)
        for (size_t i = 0; i < hatch_texels_level_size(&made, level); i++) {
            float share = 0.5f + 0.5f * sinf(0.7f * (float)(i / channels));
            made.texels[level][i] = (uint8_t)(255 + share * (ink[i % channels] - 255));
        }
    return made;
}

static void upload(const struct hatch_texels *packed, GLenum target, GLenum format)
{
    GLuint name;
    glGenTextures(1, &name);
    glBindTexture(target, name);
    while (glGetError() != GL_NO_ERROR)
        ;
    for (uint32_t level = 0; level < packed->level_count; level++)
        glCompressedTexImage3D(target, (GLint)level, format, (GLsizei)(SIDE >> level), (GLsizei)(SIDE >> level),
                               (GLsizei)(packed->depth ? DEEP >> level : DEEP), 0,
                               (GLsizei)hatch_texels_level_size(packed, level), packed->texels[level]);
}

static void compare(const struct hatch_texels *packed, GLenum target, GLenum format, GLenum read)
{
    struct hatch_texels plain;
    upload(packed, target, format);
    ck_assert_uint_eq(glGetError(), GL_NO_ERROR);
    HATCH_TEST_OK(hatch_texels_unpack(packed, &keep, &plain, &err), &err);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    for (uint32_t level = 0; level < plain.level_count; level++) {
        size_t size = hatch_texels_level_size(&plain, level);
        uint8_t *got = HATCH_NEW(&keep, uint8_t, size, &err);
        glGetTexImage(target, (GLint)level, read, GL_UNSIGNED_BYTE, got);
        ck_assert_uint_eq(glGetError(), GL_NO_ERROR);
        for (size_t i = 0; i < size; i++)
            ck_assert_int_le(abs(got[i] - plain.texels[level][i]), 1);
    }
}

START_TEST(grey_blocks_are_read_in_arrays)
{
    struct hatch_texels plain = make(1, false), packed;
    HATCH_TEST_OK(hatch_texels_pack(&plain, HATCH_TEXELS_BC4, NULL, &keep, &packed, NULL, &err), &err);
    compare(&packed, GL_TEXTURE_2D_ARRAY, GL_COMPRESSED_RED_RGTC1, GL_RED);
}
END_TEST

/* Which is why tamvol makes an array of them. */
START_TEST(grey_blocks_are_refused_in_volumes)
{
    struct hatch_texels plain = make(1, true), packed;
    HATCH_TEST_OK(hatch_texels_pack(&plain, HATCH_TEXELS_BC4, NULL, &keep, &packed, NULL, &err), &err);
    upload(&packed, GL_TEXTURE_3D, GL_COMPRESSED_RED_RGTC1);
    ck_assert_uint_ne(glGetError(), GL_NO_ERROR);
}
END_TEST

START_TEST(coloured_blocks_are_read_in_both)
{
    struct hatch_texels plain = make(3, _i), packed;
    HATCH_TEST_OK(hatch_texels_pack(&plain, HATCH_TEXELS_BC7, NULL, &keep, &packed, NULL, &err), &err);
    compare(&packed, _i ? GL_TEXTURE_3D : GL_TEXTURE_2D_ARRAY, GL_COMPRESSED_RGBA_BPTC_UNORM, GL_RGBA);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("render blocks");
    TCase *tests = tcase_create("blocks");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, grey_blocks_are_read_in_arrays);
    tcase_add_test(tests, grey_blocks_are_refused_in_volumes);
    tcase_add_loop_test(tests, coloured_blocks_are_read_in_both, 0, 2);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
