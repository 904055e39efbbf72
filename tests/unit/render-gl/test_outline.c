/* The silhouettes of coarse meshes in pictures: they are the outline of the faces that are drawn. */
#include "arenas.h"
#include "meshes.h"
#include "outline/drawn.h"

enum { WIDTH = 320, HEIGHT = 240 };

static struct drawn drawn;

static void begin_drawn(void)
{
    begin();
    memset(&drawn, 0, sizeof drawn);
    frame_arenas(&drawn.frame);
}

static void end_drawn(void)
{
    drawn_close(&drawn);
    hatch_arena_free(&scratch);
    hatch_arena_free(&keep);
}

static struct hatch_mesh octahedron(void)
{
    static const float corners[18] = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
    static const uint32_t faces[24] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    return mesh_of(corners, 6, faces, 8);
}

/* Every pixel of the outline has a line within 2 pixels, and no line is farther than that from an outline or a step in
 * depth. Short steps near an outline may lack one. */
START_TEST(lines_follow_the_faces)
{
    static const struct {
        enum hatch_shape shape;
        uint32_t faces;
    } shapes[] = {{HATCH_SHAPE_SPHERE, 80},        {HATCH_SHAPE_SPHERE, 300}, {HATCH_SHAPE_TORUS, 400},
                  {HATCH_SHAPE_SUPERQUADRIC, 150}, {HATCH_SHAPE_BUMP, 300},   {HATCH_SHAPE_TEAPOT, 1000},
                  {HATCH_SHAPE_FRUSTUM, 100},      {HATCH_SHAPE_TORUS, 6000}};
    struct hatch_mesh mesh = _i < 8 ? shape_of(shapes[_i].shape, shapes[_i].faces) : octahedron();
    struct outline_score score = {0};
    drawn_normalize(&mesh);
    drawn_open(&mesh, &drawn);
    for (int i = 0; i < DRAWN_VIEWS; i += 5) {
        struct hatch_view view = drawn_view(i, (double)WIDTH / HEIGHT);
        struct hatch_image shown;
        drawn_compare(&drawn, &view, WIDTH, HEIGHT, &shown, &score);
    }
    ck_assert_uint_gt(score.outline, 2000);
    ck_assert_uint_gt(score.lines, 900);
    ck_assert_uint_eq(score.outline_missed, 0);
    ck_assert_uint_le(score.lines_off, score.lines / 500);
    ck_assert_uint_le(score.steps_missed, score.steps / 10);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("render outline");
    TCase *tests = tcase_create("outline");
    tcase_add_checked_fixture(tests, begin_drawn, end_drawn);
    tcase_add_loop_test(tests, lines_follow_the_faces, 0, 9);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
