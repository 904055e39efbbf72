/* Opacity in strokes that a brush draws (shaders/strokes/brush.glsl): its image times its grain. */
#include <stdlib.h>

#include "arenas.h"
#include "gpu/stage.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/gpu/context.h"
#include "render-gl/gpu/texture.h"

enum { GRAIN = 64, STROKES = 4096, IMAGE = 8 };

static struct gpu_context context;
static GLuint program, textures[2];

/* The grain tells its own texels, from 1 on; the image has a multiple in each row. */
static void open_program(void)
{
    static const char begin[] = "#version 450 core\n#define UNIT_TECHNIQUE 4\n#define UNIFORM_BRUSH 15\n",
                      end[] = "layout(local_size_x = 64) in;\n"
                              "layout(std430, binding = 1) writeonly buffer Found { float found[]; };\n"
                              "layout(location = 0) uniform vec3 place;\n"
                              "void main()\n"
                              "{\n"
                              "    uint stroke = gl_GlobalInvocationID.x;\n"
                              "    found[stroke] = brush_alpha(stroke, place.x, place.y, place.z);\n"
                              "}\n";
    const char *const texts[] = {begin, shader_text("traced/noise.glsl"), shader_text("strokes/brush.glsl"), end};
    static float grain[GRAIN * GRAIN], image[IMAGE];
    HATCH_TEST_OK(gpu_context_open_headless(&context, 2, &err), &err);
    program = compute_program(4, texts);
    for (uint32_t i = 0; i < GRAIN * GRAIN; i++)
        grain[i] = (float)(i + 1);
    for (uint32_t i = 0; i < IMAGE; i++)
        image[i] = (float)(i + 1);
    for (uint32_t i = 0; i < 2; i++) {
        const GLsizei width = i ? GRAIN : 1, height = i ? GRAIN : IMAGE;
        textures[i] = gpu_texture_make(GL_TEXTURE_2D, 1, GL_R32F, (uint32_t)width, (uint32_t)height, 1);
        glTextureSubImage2D(textures[i], 0, 0, 0, width, height, GL_RED, GL_FLOAT, i ? grain : image);
        glTextureParameteri(textures[i], GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTextureParameteri(textures[i], GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        gpu_texture_bind(5 + i, textures[i], 0);
    }
    glProgramUniform1f(program, 15, 1000);
}

static void close_program(void)
{
    glDeleteTextures(2, textures);
    glDeleteProgram(program);
    gpu_context_close(&context);
}

/* Finds the texels of the grain that strokes read at a place. */
static void find(double along_px, double across_px, uint32_t texels[STROKES])
{
    static float found[STROKES];
    GLuint buffer = gpu_buffer_make(NULL, sizeof found);
    gpu_storage_bind(1, buffer);
    glUseProgram(program);
    glUniform3f(0, (GLfloat)(along_px / 1000), (GLfloat)across_px, 40);
    glDispatchCompute(STROKES / 64, 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    gpu_buffer_read(buffer, found, sizeof found);
    glDeleteBuffers(1, &buffer);
    uint32_t row = (uint32_t)(IMAGE * (0.5 + 0.5 * across_px / 40));
    for (uint32_t i = 0; i < STROKES; i++) {
        texels[i] = (uint32_t)(found[i] / (float)(row + 1)) - 1;
        ck_assert_uint_lt(texels[i], GRAIN * GRAIN);
    }
}

/* Of 4096 strokes, each column and each row of the grain begins 64, with a deviation of 8. */
START_TEST(strokes_begin_anywhere_in_the_grain)
{
    static uint32_t texels[STROKES], counts[2][GRAIN];
    open_program();
    find(0.5, 0.5, texels);
    for (uint32_t i = 0; i < STROKES; i++) {
        counts[0][texels[i] % GRAIN]++;
        counts[1][texels[i] / GRAIN]++;
    }
    for (uint32_t i = 0; i < 2 * GRAIN; i++)
        ck_assert_uint_le((uint32_t)abs((int)counts[i / GRAIN][i % GRAIN] - 64), 40);
    close_program();
}
END_TEST

/* A pixel of the stroke is a texel of the grain, which repeats. */
START_TEST(the_grain_has_a_texel_per_pixel)
{
    static const int moves[][2] = {{1, 0}, {0, 1}, {0, -17}, {63, 5}, {900, -39}};
    static uint32_t first[STROKES], moved[STROKES];
    open_program();
    find(0.5, 0.5, first);
    for (size_t k = 0; k < sizeof moves / sizeof *moves; k++) {
        find(moves[k][0] + 0.5, moves[k][1] + 0.5, moved);
        for (uint32_t i = 0; i < STROKES; i++) {
            ck_assert_uint_eq(moved[i] % GRAIN, (first[i] + (uint32_t)moves[k][0]) % GRAIN);
            ck_assert_uint_eq(moved[i] / GRAIN, (first[i] / GRAIN + GRAIN + (uint32_t)moves[k][1]) % GRAIN);
        }
    }
    close_program();
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("render brush");
    TCase *tests = tcase_create("brush");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, strokes_begin_anywhere_in_the_grain);
    tcase_add_test(tests, the_grain_has_a_texel_per_pixel);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
