/* Shader programs are compiled once for each combination of stages and definitions. */
#include "render_frame.h"

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

static Suite *suite(void)
{
    Suite *suite = suite_create("render-gl programs");
    TCase *tests = tcase_create("programs");
    tcase_add_test(tests, a_program_is_compiled_once_and_again_when_asked);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
