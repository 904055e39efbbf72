/* Inputs on which a plain implementation of recursive procedural tonal art maps fails and this one does not. */
#include "render_frame.h"
#include "rptam_ink.h"
#include "rptam_model.h"
#include "rptam_raster.h"

enum { SIZE = 128 };

static struct test_frame frame;
static struct hatch_rptam rptam;

static const struct model_how how = {.tile_px = 64, .length_px = 20, .width_px = 2, .angle_rad = {0.9}, .overlap = 0.3};

/* The pattern changes its level where the depth M is a whole number; ink must be the same on both sides. */
START_TEST(ink_is_continuous_between_levels)
{
    static const struct {
        enum hatch_fade_law law;
        bool size;
        double overlap;
    } fades[] = {{HATCH_FADE_EVEN, false, 0.3}, {HATCH_FADE_EVEN, true, 0.3},      {HATCH_FADE_EVEN, false, 1},
                 {HATCH_FADE_PAPER, true, 1},   {HATCH_FADE_WEIGHTED, false, 0.3}, {HATCH_FADE_WEIGHTED, true, 1}};
    static const double amounts[] = {1, 0.6, 0.1};
    static const uint32_t counts[] = {2, 16, 37, 64};
    struct model_how model = how;
    model.law = fades[_i].law;
    model.fade_size = fades[_i].size;
    model.overlap = fades[_i].overlap;
    frame_arenas(&frame);
    for (size_t c = 0; c < sizeof counts / sizeof *counts; c++)
        for (size_t a = 0; a < sizeof amounts / sizeof *amounts; a++) {
            double sum = 0;
            model.seeds = counts[c];
            model_make(&model, &frame.args.keep, &frame.args.scratch, &rptam);
            for (int i = 0; i < 20000; i++) {
                const double uv[2] = {i * 0.6180339887 - 5000, i * 0.7548776662 - 9000};
                double inside = rptam_layer_ink(&rptam, 0, uv, 2 - 1e-9, amounts[a], false);
                double outside = rptam_layer_ink(&rptam, 0, uv, 2, amounts[a], false);
                ck_assert_double_eq_tol(inside, outside, 1e-5);
                sum += inside;
            }
            ck_assert_double_gt(sum, 0);
        }
    hatch_arena_free(&frame.args.keep);
    hatch_arena_free(&frame.args.scratch);
}
END_TEST

/* Makes two squares in one plane; texture coordinates change 2.4 times as fast on the right one.
 *   own_corners  they share no vertex */
static void make_bent(bool own_corners, struct hatch_mesh *mesh)
{
    static float position[24], normal[24], uv[16];
    static uint32_t indices[12] = {0, 1, 3, 0, 3, 2, 4, 5, 7, 4, 7, 6};
    for (uint32_t v = 0; v < 8; v++) {
        float x = (float)(v / 4) - 1 + (float)(v % 2), y = (float)(v / 2 % 2) - 0.5f;
        memcpy(position + 3 * v, (float[]){x, y, 0}, 3 * sizeof(float));
        memcpy(normal + 3 * v, (float[]){0, 0, 1}, 3 * sizeof(float));
        memcpy(uv + 2 * v, (float[]){x > 0 ? 2.4f * x : x, -y}, 2 * sizeof(float));
    }
    for (uint32_t i = 6; i < 12 && !own_corners; i++)
        indices[i] = indices[i] == 4 ? 1 : indices[i] == 6 ? 3 : indices[i];
    *mesh = (struct hatch_mesh){.vertex_count = 8, .face_count = 4, .indices = indices, .attribute_count = 3};
    mesh->attributes[0] = (struct hatch_mesh_attribute){.name = "POSITION", .components = 3, .data = position};
    mesh->attributes[1] = (struct hatch_mesh_attribute){.name = "NORMAL", .components = 3, .data = normal};
    mesh->attributes[2] = (struct hatch_mesh_attribute){.name = "TEXCOORD_0", .components = 2, .data = uv};
}

static const struct hatch_view front = {.eye = {0, 0, 2},
                                        .right = {1, 0, 0},
                                        .up = {0, 1, 0},
                                        .back = {0, 0, 1},
                                        .half_height = 0.25,
                                        .aspect = 1,
                                        .near = 0.01,
                                        .far = 100,
                                        .pivot = 2};

/* Mean difference of ink between the two sides of the edge. */
static double cut(struct raster *raster)
{
    double sum = 0;
    raster_draw(raster, &frame.args.keep);
    for (uint32_t y = 0; y < SIZE; y++) {
        struct raster_pixel side[2];
        for (uint32_t k = 0; k < 2; k++) {
            side[k] = raster->pixels[(size_t)y * SIZE + SIZE / 2 - 1 + k];
            side[k].point.uv[0] = 0; /* on the edge itself */
        }
        sum += fabs(raster_ink(raster, &side[0], &rptam, 0.4, 0.4) - raster_ink(raster, &side[1], &rptam, 0.4, 0.4));
    }
    return sum / SIZE;
}

/* Derivatives T per face cut strokes at an edge between faces of different distortion; T averaged at vertices does not.
 * The renderer averages whether or not the faces share vertices. */
START_TEST(strokes_continue_across_edges)
{
    struct hatch_mesh shared, apart;
    struct hatch_image pictures[2];
    double plain, smooth;
    frame_arenas(&frame);
    struct model_how model = how;
    model.angle_rad[0] = 1.5708; /* strokes across the direction of the stretch */
    model_make(&model, &frame.args.keep, &frame.args.scratch, &rptam);
    for (int own = 1; own >= 0; own--) {
        make_bent(own, own ? &apart : &shared);
        struct raster raster = {.mesh = own ? &apart : &shared, .view = &front, .size = SIZE};
        *(own ? &plain : &smooth) = cut(&raster);
        if (!own)
            for (uint32_t i = 0; i < SIZE * SIZE; i++)
                ck_assert(isfinite(raster.pixels[i].w));
        frame_open(own ? &apart : &shared, &frame_unit, NULL, &frame);
        frame.model = &rptam;
        frame.shown.style.curve.low = frame.shown.style.curve.high = 0.4;
        frame_draw(&frame, "rptam", &front, SIZE, SIZE, 1, &pictures[own]);
        frame_close(&frame);
    }
    ck_assert_double_gt(plain, 0.05);
    ck_assert_double_lt(smooth, plain / 4);
    ck_assert_double_eq(frame_difference(&pictures[0], &pictures[1]), 0);
    ck_assert_double_gt(frame_ink(&pictures[0]), 0.1);
    hatch_arena_free(&frame.args.keep);
    hatch_arena_free(&frame.args.scratch);
}
END_TEST

/* Coverage lists hold strokes longer than the tile, and ink stays within 0..1. */
START_TEST(strokes_may_be_larger_than_the_tile)
{
    struct model_how model = how;
    model.tile_px = 24;
    model.length_px = 60;
    model.width_px = 5;
    model.ink = 0.3;
    model.seeds = 5;
    frame_arenas(&frame);
    model_make(&model, &frame.args.keep, &frame.args.scratch, &rptam);
    for (int i = 0; i < 20000; i++) {
        const double uv[2] = {i * 0.6180339887, i * 0.7548776662}, depth = 0.001 * i;
        double ink = rptam_layer_ink(&rptam, 0, uv, depth, 1, false);
        ck_assert(ink >= 0 && ink <= 1);
        ck_assert_double_eq_tol(ink, rptam_layer_ink(&rptam, 0, uv, depth, 1, true), 1e-12);
    }
    hatch_arena_free(&frame.args.keep);
    hatch_arena_free(&frame.args.scratch);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("rptam limits");
    TCase *tests = tcase_create("limits");
    tcase_add_loop_test(tests, ink_is_continuous_between_levels, 0, 6);
    tcase_add_test(tests, strokes_continue_across_edges);
    tcase_add_test(tests, strokes_may_be_larger_than_the_tile);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
