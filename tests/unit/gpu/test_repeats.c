/* How often the texture in use repeats over the items. */
#include "render-gl/scene/attributes.h"
#include "render-gl/technique/list.h"
#include "render_frame.h"
#include "render_map.h"

static struct test_frame frame;

/* The map's repeats are back after a technique that has a texture with others, and these when it is used again. */
START_TEST(repeats_of_another_texture_are_taken_back)
{
    frame_arenas(&frame);
    struct hatch_mesh plane = frame_shape(&frame, HATCH_SHAPE_PLANE, 2);
    const struct hatch_uv_repeat coarse = {.repeat = 3, .size_px = 64, .levels = 1};
    const struct hatch_uv_repeat fine = {.repeat = 11, .size_px = 64, .levels = 1};
    frame_open(&plane, &frame_unit, NULL, &frame);
    struct hatch_arena *keep = &frame.args.keep, *scratch = &frame.args.scratch;
    const struct hatch_item *item = &frame.on_gpu.unit.items[0];
    HATCH_TEST_OK(scene_set_repeats(&frame.on_gpu, &coarse, keep, scratch, &frame.err), &frame.err);
    for (int visit = 0; visit < 2; visit++) {
        ck_assert_float_eq(item->repeat[0], 3);
        HATCH_TEST_OK(scene_replace_repeats(&frame.on_gpu, &fine, keep, scratch, &frame.err), &frame.err);
        HATCH_TEST_OK(scene_replace_repeats(&frame.on_gpu, &fine, keep, scratch, &frame.err), &frame.err);
        ck_assert_float_eq(item->repeat[0], 11);
        struct technique_instance instance;
        HATCH_TEST_OK(technique_open(&instance, &technique_gouraud, &frame.args, &frame.err), &frame.err);
        HATCH_TEST_OK(technique_prepare(&frame.technique_context, &instance, &frame.err), &frame.err);
        ck_assert_float_eq(item->repeat[0], 3);
        technique_close(&instance);
    }
    frame_finish(&frame);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("repeats");
    TCase *tests = tcase_create("repeats");
    tcase_add_test(tests, repeats_of_another_texture_are_taken_back);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
