/* Shader programs are compiled once for each combination of stages and definitions. */
#include "gpu/stage.h"
#include "render-gl/gpu/buffer.h"
#include "render_frame.h"

#define INDICES (65535u * 64 + 1000) /* more than work groups of one row */

static struct test_frame frame;

static const struct gpu_program *get(const struct gpu_stages *stages, const char *defines)
{
    const struct gpu_program *program;
    HATCH_TEST_OK(gpu_program_get(&frame.shown.programs, stages, defines, &program, &frame.err), &frame.err);
    ck_assert(glIsProgram(program->name));
    return program;
}

START_TEST(a_program_is_compiled_once_and_again_when_asked)
{
    frame_arenas(&frame);
    struct hatch_mesh plane = frame_shape(&frame, HATCH_SHAPE_PLANE, 2);
    frame_open(&plane, &frame_unit, NULL, &frame);
    const struct gpu_stages line = {"overlay/mark.vert", NULL, "overlay/mark.frag", NULL};
    const struct gpu_program *first = get(&line, ""), *other = get(&line, "#define UNUSED 1\n");
    ck_assert_ptr_ne(first, other);
    ck_assert_uint_ne(first->name, other->name);
    ck_assert_ptr_eq(get(&line, ""), first);
    ck_assert_ptr_eq(get(&line, "#define UNUSED 1\n"), other);
    GLuint before = first->name;
    HATCH_TEST_OK(gpu_programs_reload(&frame.shown.programs, &frame.err), &frame.err);
    ck_assert_uint_ne(first->name, before);
    ck_assert(glIsProgram(first->name) && !glIsProgram(before));
    GLuint after = first->name;
    gpu_programs_free(&frame.shown.programs);
    ck_assert(!glIsProgram(after));
    hatch_arena_init(&frame.shown.programs.keep, (size_t)1 << 30);
    frame_finish(&frame);
}
END_TEST

/* Each index is that of one invocation, also where a row of work groups does not suffice. */
START_TEST(a_pass_over_many_indices_reaches_each_once)
{
    static const char count[] = "#version 450 core\n",
                      own[] = "layout(local_size_x = 64) in;\n"
                              "layout(std430, binding = 0) buffer Visits { uint visits[]; };\n"
                              "layout(location = UNIFORM_COUNT) uniform uint count;\n",
                      body[] = "void main() { if (index_of() < count) visits[index_of()]++; }\n";
    static uint32_t visits[INDICES + 64];
    frame_arenas(&frame);
    struct hatch_mesh plane = frame_shape(&frame, HATCH_SHAPE_PLANE, 2);
    frame_open(&plane, &frame_unit, NULL, &frame);
    const char *const texts[] = {count, shader_bindings, own, shader_text("frame/index.glsl"), body};
    const struct gpu_program program = {.name = compute_program(5, texts)};
    for (uint32_t wanted = 0; wanted < 2 * INDICES; wanted += INDICES) {
        GLuint buffer = gpu_buffer_make(visits, sizeof visits);
        gpu_storage_bind(0, buffer);
        frame_dispatch_over(
            &(struct frame_dispatch){.name = "visit", .program = &program, .barrier = GL_BUFFER_UPDATE_BARRIER_BIT},
            wanted, NULL);
        gpu_buffer_read(buffer, visits, sizeof visits);
        for (uint32_t i = 0; i < INDICES + 64; i++)
            ck_assert_uint_eq(visits[i], i < wanted);
        glDeleteBuffers(1, &buffer);
    }
    glDeleteProgram(program.name);
    frame_finish(&frame);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("render-gl programs");
    TCase *tests = tcase_create("programs");
    tcase_add_test(tests, a_program_is_compiled_once_and_again_when_asked);
    tcase_add_test(tests, a_pass_over_many_indices_reaches_each_once);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
