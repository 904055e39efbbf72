/* Parameters whose values change from frame to frame. */
#include <math.h>
#include <string.h>

#include "run.h"

#include "render-gl/mode/params.h"

START_TEST(a_motion_goes_back_and_forth)
{
    for (int i = 0; i < 10; i++) {
        double whole_s = 0.5 + i % 5, start_s = 2 * whole_s * i;
        ck_assert_double_eq_tol(params_swing(start_s, whole_s), 0, 1e-12);
        ck_assert_double_eq_tol(params_swing(start_s + 0.25 * whole_s, whole_s), 0.25, 1e-12);
        ck_assert_double_eq_tol(params_swing(start_s + whole_s, whole_s), 1, 1e-12);
        ck_assert_double_eq_tol(params_swing(start_s + 1.25 * whole_s, whole_s), 0.75, 1e-12);
    }
}
END_TEST

START_TEST(whole_numbers_are_rounded_to_the_nearest)
{
    int64_t value = 1;
    const struct cmd_option option = {.name = "count", .type = CMD_INT, .minimum = 0, .maximum = 9, .value = &value};
    const struct param param = {.option = &option};
    ck_assert(params_set(&param, (const double[2]){2.6, 0}));
    ck_assert_int_eq(value, 3);
    ck_assert(!params_set(&param, (const double[2]){3.4, 0}));
}
END_TEST

/* The steps of the window's keys, as render-gl(1) tells them. */
START_TEST(steps_are_those_of_the_manual)
{
    static const struct {
        const char *option;
        double step;
    } steps[] = {{"hatch-turn", 5},  {"light", 5},        {"from", 5},          {"fov", 5},
                 {"stroke-turn", 5}, {"tone-range", .05}, {"grain", .05},       {"dry", .05},
                 {"wet", .05},       {"stroke-ink", .05}, {"paper-grain", .05}, {"edge-darkening", .05},
                 {"overlap", .1},    {"wobble", .5},      {"border", .5},       {"bands", 1},
                 {"seed-layers", 1}, {"overdraw", 1}};
    static char *words[] = {"render-gl", "scene.glb", "-t", "gouraud", "-o", "picture.png", NULL};
    static struct cmd_args args;
    struct param param;
    size_t found = 0;
    options_read(6, words, &args);
    for (uint32_t i = 0; params_at(i, &param); i++) {
        double want = 1.1;
        bool by_factor = true;
        for (size_t k = 0; k < sizeof steps / sizeof *steps; k++)
            if (strcmp(param.option->name, steps[k].option) == 0) {
                want = steps[k].step;
                by_factor = false;
                found++;
            }
        ck_assert_msg(param.by_factor == by_factor && fabs(param.step - want) < 1e-12, "%s: %g", param.option->name,
                      param.step);
    }
    ck_assert_uint_eq(found, sizeof steps / sizeof *steps);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("params");
    TCase *tests = tcase_create("params");
    tcase_add_test(tests, a_motion_goes_back_and_forth);
    tcase_add_test(tests, steps_are_those_of_the_manual);
    tcase_add_test(tests, whole_numbers_are_rounded_to_the_nearest);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
