/* Reads strokes back from pictures of a receding plane: the strokes of a more distant view are in every nearer one. */
#include "render_frame.h"
#include "rptam_model.h"

enum { SIZE = 256, SEEDS_MOST = 64, TILES = 2, FRAMES = 49 };

static struct test_frame frame;
static struct hatch_rptam rptam;

static void begin_plane(void)
{
    struct hatch_mesh mesh = frame_shape(&frame, HATCH_SHAPE_PLANE, 2);
    float *position = hatch_mesh_find(&mesh, "POSITION", 3), *texcoord = hatch_mesh_find(&mesh, "TEXCOORD_0", 2);
    for (size_t v = 0; v < mesh.vertex_count; v++) {
        for (size_t k = 0; k < 2; k++)
            position[3 * v + k] *= 20;
        texcoord[2 * v] = position[3 * v];
        texcoord[2 * v + 1] = -position[3 * v + 1];
    }
    frame_open(&mesh, &frame_unit, NULL, &frame);
    frame.model = &rptam;
}

struct stroke {
    double uv[2], ink; /* position in texture coordinates, ink in the last picture */
    bool alone;        /* no other stroke overlaps it in the picture */
};

static uint32_t list_strokes(struct stroke *strokes)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < rptam.layers[0].count * TILES * TILES; i++) {
        const struct hatch_seed_point *place = &rptam.layers[0].points[i / (TILES * TILES)];
        strokes[count++] = (struct stroke){.uv = {i % TILES + (double)place->u * 0x1p-64 - TILES / 2.0,
                                                  i / TILES % TILES + (double)place->v * 0x1p-64 - TILES / 2.0},
                                           .ink = 2};
    }
    return count;
}

static void find_alone(struct stroke *strokes, uint32_t count, double pixels, double size_px)
{
    for (uint32_t i = 0; i < count; i++) {
        const double *at = strokes[i].uv;
        double nearest = INFINITY;
        for (uint32_t k = 0; k < count; k++)
            if (k != i)
                nearest = fmin(nearest, hypot(at[0] - strokes[k].uv[0], at[1] - strokes[k].uv[1]));
        strokes[i].alone = nearest * pixels > 1.5 * size_px;
    }
}

/* Draws 2 span x 2 span of the plane and checks that no stroke has more ink than in the last picture.
 * Returns the number of strokes with more than half of the ink. */
static uint32_t read_strokes(double span, double size_px, struct stroke *strokes, uint32_t count)
{
    struct hatch_arena_mark mark = hatch_arena_mark(&frame.args.keep);
    struct hatch_image picture;
    struct hatch_view view = {.eye = {0, 0, 5},
                              .right = {1, 0, 0},
                              .up = {0, 1, 0},
                              .back = {0, 0, 1},
                              .orthographic = true,
                              .half_height = span,
                              .aspect = 1,
                              .near = 0.1,
                              .far = 10,
                              .pivot = 5};
    uint32_t there = 0;
    double pixels = SIZE / (2 * span);
    frame_draw(&frame, "rptam", &view, SIZE, SIZE, 1, &picture);
    find_alone(strokes, count, pixels, size_px);
    for (uint32_t i = 0; i < count; i++) {
        struct stroke *stroke = &strokes[i];
        double x = floor(SIZE / 2 + pixels * stroke->uv[0]), y = floor(SIZE / 2 + pixels * stroke->uv[1]);
        if (!stroke->alone || !(x >= 0 && y >= 0 && x < SIZE && y < SIZE))
            continue;
        double ink = 1 - (double)picture.pixels[3 * ((size_t)y * SIZE + (size_t)x)];
        ck_assert_msg(ink <= stroke->ink + 2 / 255.0, "stroke %u, span %g: %.3f after %.3f", i, span, ink, stroke->ink);
        stroke->ink = ink;
        there += ink > 0.5;
    }
    hatch_arena_rewind(&frame.args.keep, mark);
    return there;
}

START_TEST(no_stroke_appears_while_the_plane_recedes)
{
    static struct stroke strokes[SEEDS_MOST * TILES * TILES];
    const struct model_how models[] = {
        {.seeds = 16, .overlap = 0},
        {.seeds = 37, .overlap = 0.3},
        {.seeds = 16, .overlap = 1, .fade_size = false},
        {.seeds = 64, .overlap = 0.5, .law = HATCH_FADE_PAPER},
    };
    struct model_how how = models[_i];
    how.tile_px = SIZE / 2;
    how.length_px = how.width_px = 3;
    how.solid = true;
    how.candidates = 50;
    frame_arenas(&frame);
    model_make(&how, &frame.args.keep, &frame.args.scratch, &rptam);
    begin_plane();
    frame.shown.style.curve.low = frame.shown.style.curve.high = 1;
    uint32_t count = list_strokes(strokes), first = 0, last = 0;
    for (int i = 0; i < FRAMES; i++) {
        last = read_strokes(exp2(i / 32.0), how.length_px, strokes, count);
        first = i ? first : last;
    }
    ck_assert_uint_gt(first, count / 2);
    ck_assert_uint_lt(last, first / 2);
    ck_assert_uint_gt(last, 0);
    frame_finish(&frame);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("render nesting");
    TCase *tests = tcase_create("nesting");
    tcase_add_loop_test(tests, no_stroke_appears_while_the_plane_recedes, 0, 4);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
