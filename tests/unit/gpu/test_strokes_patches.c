/* Strokes of patches on the GPU: shaders/strokes/patches.glsl lets them go on beyond their patch as far as the surface
 * does, wherever they and the patches point. Surfaces are images of what owner.frag writes. */
#include <math.h>
#include <string.h>

#include "arenas.h"
#include "gpu/stage.h"
#include "math/angle.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/gpu/context.h"
#include "render-gl/gpu/texture.h"

enum { SIZE = 128 };

/* A straight stroke through the middle of the image, of which `half` pixels to each side are on its patch. */
struct stroke {
    float way[2];   /* of unit length */
    float half;     /* pixels */
    float range[2]; /* of t on the patch */
    float own[2];   /* u of its own ends */
    float thick[2]; /* widths there, in mean widths */
};

/* A stroke as the shader leaves it. */
struct found {
    float ends[2];
    float elsewhere; /* 1: its middle is beyond the patch */
    float unused;
};

static float owners[SIZE][SIZE][4];
static struct gpu_context context;
static GLuint program;

static void open_program(void)
{
    static const char include[] = "#include \"strokes/doubled.glsl\"\n",
                      begin[] = "#version 450 core\n#define UNIT_SOURCE 0\n#define FRAGMENT_LAPPED 1u\n"
                                "layout(std430, binding = 0) readonly buffer Sorted { uvec2 sorted[]; };\n",
                      end[] = "layout(local_size_x = 1) in;\n"
                              "layout(std430, binding = 1) writeonly buffer Found { vec4 found; };\n"
                              "layout(location = 0) uniform vec4 line;\n"
                              "layout(location = 1) uniform vec4 own;\n"
                              "layout(location = 2) uniform vec2 thick;\n"
                              "void main()\n"
                              "{\n"
                              "    Cubic cubic = Cubic(own.xy, line.xy, vec4(0.0), vec4(0.0), 1.0);\n"
                              "    cubic.x.y = line.z;\n"
                              "    cubic.y.y = line.w;\n"
                              "    found = vec4(follow_both(cubic, own.zw, thick),\n"
                              "                 has_middle_elsewhere(cubic, own.zw, thick) ? 1.0 : 0.0, 0.0);\n"
                              "}\n";
    const char *text = shader_text("strokes/patches.glsl"), *patches = strstr(text, include);
    HATCH_TEST_OK(gpu_context_open_headless(&context, 2, &err), &err);
    ck_assert_ptr_nonnull(patches);
    const char *const texts[] = {begin, shader_text("strokes/curve.glsl"), shader_text("strokes/doubled.glsl"),
                                 patches + sizeof include - 1, end};
    program = compute_program(5, texts);
}

static void close_program(void)
{
    glDeleteProgram(program);
    gpu_context_close(&context);
}

/* Makes an image of one patch. */
static void lay_patch(float depth, double angle_rad)
{
    for (size_t i = 0; i < (size_t)SIZE * SIZE; i++) {
        float *owner = owners[i / SIZE][i % SIZE];
        owner[0] = 2;
        owner[1] = depth;
        owner[2] = (float)cos(2 * angle_rad);
        owner[3] = (float)sin(2 * angle_rad);
    }
}

/* Changes the pixels that lie at least so many pixels from the middle along a way: their depth and direction. */
static void change_beyond(const float way[2], float from_px, float depth, double angle_rad)
{
    for (uint32_t y = 0; y < SIZE; y++)
        for (uint32_t x = 0; x < SIZE; x++) {
            float along = way[0] * ((float)x - SIZE / 2) + way[1] * ((float)y - SIZE / 2);
            if (along < from_px)
                continue;
            owners[y][x][0] = depth > 0 ? 3 : 0;
            owners[y][x][1] = depth;
            owners[y][x][2] = (float)cos(2 * angle_rad);
            owners[y][x][3] = (float)sin(2 * angle_rad);
        }
}

static struct found find(const struct stroke *stroke)
{
    struct found found;
    GLuint texture = gpu_texture_make(GL_TEXTURE_2D, 1, GL_RGBA32F, SIZE, SIZE, 1);
    GLuint buffer = gpu_buffer_make(NULL, sizeof found);
    glTextureSubImage2D(texture, 0, 0, 0, SIZE, SIZE, GL_RGBA, GL_FLOAT, owners);
    gpu_texture_bind(0, texture, 0);
    gpu_storage_bind(1, buffer);
    glUseProgram(program);
    glUniform4f(0, SIZE / 2 + 0.5f, SIZE / 2 + 0.5f, stroke->half * stroke->way[0], stroke->half * stroke->way[1]);
    glUniform4f(1, stroke->range[0], stroke->range[1], stroke->own[0], stroke->own[1]);
    glUniform2f(2, stroke->thick[0], stroke->thick[1]);
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    gpu_buffer_read(buffer, &found, sizeof found);
    glDeleteBuffers(1, &buffer);
    glDeleteTextures(1, &texture);
    return found;
}

/* A stroke that is cut off after 10 pixels, and whose own end lies 30 pixels from the middle. */
static const struct stroke plain = {
    .way = {1, 0}, .half = 10, .range = {0.1f, 0.7f}, .own = {-0.5f, 3}, .thick = {1, 1}};

static bool goes_on(const struct stroke *stroke)
{
    struct found found = find(stroke);
    ck_assert_float_eq(found.ends[0], -1);
    ck_assert(found.ends[1] == 1 || found.ends[1] == stroke->own[1]);
    ck_assert_float_eq(found.elsewhere, 0);
    return found.ends[1] > 1;
}

/* Its end lies 30.5 pixels from the left border of the middle pixel. */
START_TEST(strokes_go_on_as_far_as_the_surface)
{
    open_program();
    lay_patch(0.5f, 0);
    ck_assert(goes_on(&plain));
    for (int px = 29; px <= 32; px++) {
        lay_patch(0.5f, 0);
        change_beyond(plain.way, (float)px, 0, 0);
        ck_assert_msg(goes_on(&plain) == (px > 30), "a surface that ends after %d pixels", px);
    }
    for (int px = 5; px <= 7; px++) { /* in tens: 64 pixels from the middle, the image ends */
        struct stroke stroke = plain;
        lay_patch(0.9999f, 0);
        stroke.own[1] = (float)px;
        ck_assert_msg(goes_on(&stroke) == (px < 7), "%d0 pixels", px);
    }
    close_program();
}
END_TEST

/* Adds to the depth of the pixels that lie at least so many pixels to the right of the middle, `slant` per pixel, too.
 */
static void lower_beyond(uint32_t from_px, float depth, float slant)
{
    for (size_t i = 0; i < (size_t)SIZE * SIZE; i++)
        if (i % SIZE >= SIZE / 2 + from_px)
            owners[i / SIZE][i % SIZE][1] += depth + slant * (float)(i % SIZE - SIZE / 2 - from_px + 1);
}

/* At the depth of 0.5, which may jump by 0.00025. */
START_TEST(strokes_end_where_depth_jumps)
{
    static const float jumps[] = {0.0001f, 0.0002f, 0.0003f, 0.01f};
    open_program();
    for (uint32_t from_px = 11; from_px <= 30; from_px++)
        for (int down = 0; down < 2; down++)
            for (size_t i = 0; i < sizeof jumps / sizeof *jumps; i++) {
                lay_patch(0.5f, 0);
                lower_beyond(from_px, down ? -jumps[i] : jumps[i], 0);
                ck_assert_msg(goes_on(&plain) == (i < 2), "a jump of %g after %u pixels", (double)jumps[i], from_px);
            }
    lay_patch(0.5f, 0);
    lower_beyond(15, 0.0002f, 0);
    lower_beyond(25, 0.0004f, 0);
    ck_assert(!goes_on(&plain)); /* the first jump is no slant */
    close_program();
}
END_TEST

/* A slant is no jump, but for one that begins steeply. It is followed in steps of up to 3 pixels. */
START_TEST(strokes_go_on_over_slants)
{
    open_program();
    lay_patch(0.5f, 0);
    lower_beyond(0, -0.03f, 0.001f);
    ck_assert(goes_on(&plain));
    lower_beyond(20, 0, 0.003f);
    ck_assert(!goes_on(&plain));
    lay_patch(0.5f, 0);
    lower_beyond(21, 0, 0.00007f);
    ck_assert(goes_on(&plain));
    lay_patch(0.5f, 0);
    lower_beyond(14, 0, 0.00006f);
    lower_beyond(22, 0, 0.00006f);
    ck_assert(goes_on(&plain));
    close_program();
}
END_TEST

/* The cosine of twice the angle between two patches is to be at least 0.3: up to 36.27 degrees. Only that angle counts,
 * not where the stroke and the patches point. */
START_TEST(strokes_end_at_patches_of_another_direction)
{
    open_program();
    for (int way = 0; way < 12; way++)
        for (int patch = 0; patch < 12; patch++)
            for (int off = -3; off <= 3; off++) {
                static const double apart[] = {0, 20, 36, 37};
                struct stroke stroke = plain;
                double angle = 15 * patch * HATCH_RADIANS, other = copysign(apart[abs(off)], off) * HATCH_RADIANS;
                stroke.way[0] = (float)cos(30 * way * HATCH_RADIANS);
                stroke.way[1] = (float)sin(30 * way * HATCH_RADIANS);
                lay_patch(0.5f, angle);
                change_beyond(stroke.way, 20, 0.5f, angle + other);
                ck_assert_msg(goes_on(&stroke) == (abs(off) < 3), "a stroke at %d degrees, patches at %d and %g",
                              30 * way, 15 * patch, 15 * patch + other / HATCH_RADIANS);
            }
    close_program();
}
END_TEST

/* Thin ends, ends on the patch, and strokes of which the patch has less than two fifths. */
START_TEST(some_strokes_keep_to_their_patch)
{
    static const struct {
        float own[2], thick[2], ends[2];
    } cases[] = {
        {{-2, 2}, {1, 1}, {-2, 2}},         {{-2, 2}, {0.29f, 0.31f}, {-1, 2}},     {{-2, 2}, {0.31f, 0.29f}, {-2, 1}},
        {{-0.9f, 0.9f}, {1, 1}, {-1, 1}},   {{-2.4f, 2.5f}, {1, 1}, {-2.4f, 2.5f}}, {{-2.4f, 2.7f}, {1, 1}, {-1, 1}},
        {{-0.9f, 4.5f}, {1, 1}, {-1, 4.5f}}};
    open_program();
    lay_patch(0.5f, 0);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct stroke stroke = plain;
        memcpy(stroke.own, cases[i].own, sizeof stroke.own);
        memcpy(stroke.thick, cases[i].thick, sizeof stroke.thick);
        struct found found = find(&stroke);
        ck_assert_msg(found.ends[0] == cases[i].ends[0] && found.ends[1] == cases[i].ends[1], "case %zu: from %g to %g",
                      i, (double)found.ends[0], (double)found.ends[1]);
    }
    close_program();
}
END_TEST

/* The middle is at t 0.5, where u is 1.5 or -1.5. Such a stroke is another patch's, if the surface goes on so far. */
START_TEST(a_middle_beyond_the_patch_is_elsewhere)
{
    static const float left[2] = {-1, 0};
    open_program();
    for (int side = 0; side < 2; side++) {
        struct stroke stroke = plain;
        stroke.range[0] = side ? 0.6f : 0;
        stroke.range[1] = side ? 1 : 0.4f;
        stroke.own[0] = side ? -4 : -1;
        stroke.own[1] = side ? 1 : 4;
        for (int px = 14; px <= 16; px++) {
            lay_patch(0.5f, 0);
            change_beyond(side ? left : plain.way, (float)px, 0, 0);
            struct found found = find(&stroke);
            ck_assert_msg((found.elsewhere > 0) == (px > 15), "side %d, a surface that ends after %d pixels", side, px);
            ck_assert(found.ends[0] == -1 && found.ends[1] == 1);
        }
        lay_patch(0.5f, 0);
        struct found found = find(&stroke);
        ck_assert(found.ends[0] == -1 && found.ends[1] == 1);
        stroke.thick[1 - side] = 0.29f;
        ck_assert_float_eq(find(&stroke).elsewhere, 0);
        stroke.thick[1 - side] = 0.31f;
        stroke.thick[side] = 0.29f;
        ck_assert_float_eq(find(&stroke).elsewhere, 1);
    }
    close_program();
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("render strokes patches");
    TCase *tests = tcase_create("patches");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, strokes_go_on_as_far_as_the_surface);
    tcase_add_test(tests, strokes_end_where_depth_jumps);
    tcase_add_test(tests, strokes_go_on_over_slants);
    tcase_add_test(tests, strokes_end_at_patches_of_another_direction);
    tcase_add_test(tests, some_strokes_keep_to_their_patch);
    tcase_add_test(tests, a_middle_beyond_the_patch_is_elsewhere);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
