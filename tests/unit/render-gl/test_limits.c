/* Assets that are larger than the GPU's textures may be are refused, and those that just fit are uploaded. */
#include <math.h>

#include "render-gl/frame/near.h"
#include "render-gl/technique/traced/traced.h"
#include "render_frame.h"
#include "render_map.h"
#include "rptam_model.h"
#include "tam_map.h"
#include "tam/thresholds.h"
#include "tam/volume.h"

enum { SIZE = 32, TONES = 8 };

static struct test_frame frame;
static struct asset asset;

/* The driver's limits, where they are not 0. */
static struct {
    GLint volume, array, layers, buffer;
} limits;
static PFNGLGETINTEGERVPROC get_integers;

static void get_limits(GLenum name, GLint *values)
{
    epoxy_glGetIntegerv = get_integers;
    glGetIntegerv(name, values);
    get_integers = epoxy_glGetIntegerv;
    epoxy_glGetIntegerv = get_limits;
    GLint limit = name == GL_MAX_3D_TEXTURE_SIZE        ? limits.volume
                  : name == GL_MAX_TEXTURE_SIZE         ? limits.array
                  : name == GL_MAX_ARRAY_TEXTURE_LAYERS ? limits.layers
                  : name == GL_MAX_TEXTURE_BUFFER_SIZE  ? limits.buffer
                                                        : 0;
    values[0] = limit ? limit : values[0];
}

static void begin(void)
{
    frame_arenas(&frame);
    HATCH_TEST_OK(gpu_context_open_headless(&frame.context, 1, &frame.err), &frame.err);
    memset(&asset, 0, sizeof asset);
    memset(&limits, 0, sizeof limits);
    random_map(SIZE, TONES, &frame.args.keep, &asset.map);
    get_integers = epoxy_glGetIntegerv;
    epoxy_glGetIntegerv = get_limits;
}

static void end(void)
{
    gpu_context_close(&frame.context);
    hatch_arena_free(&frame.args.keep);
    hatch_arena_free(&frame.args.scratch);
}

static enum hatch_status upload(const struct asset_kind *kind, uint32_t size_max_px)
{
    struct assets assets = {.asset = &asset, .limits = {.size_max_px = size_max_px, .anisotropy = 1}};
    const struct asset_tones *tones;
    enum hatch_status status = assets_upload(&assets, kind, &frame.args.scratch, &tones, &frame.err);
    assets_free(&assets);
    return status;
}

START_TEST(maps_keep_to_the_largest_texture)
{
    const struct asset_kind *const kinds[2] = {&asset_six_columns, &asset_columns};
    for (int i = 0; i < 2; i++) {
        HATCH_TEST_OK(upload(kinds[i], SIZE), &frame.err);
        ck_assert_int_eq(upload(kinds[i], SIZE - 1), HATCH_LIMIT);
        ck_assert_str_eq(frame.err.text, "the map is 32 texels wide, the GPU's limit is 31");
    }
}
END_TEST

static void make_volume(enum hatch_volume_layout layout)
{
    const struct hatch_volume_options how = {.tones = TONES, .layout = layout};
    struct hatch_volume_figures figures;
    struct hatch_volume volume;
    HATCH_TEST_OK(hatch_volume_make(&asset.map, &how, NULL, &frame.args.keep, &volume, &figures, &frame.err),
                  &frame.err);
    asset.texture = (struct tone_texture){.holds = TONE_TEXTURE_VOLUME,
                                          .texels = volume.texels,
                                          .levels = volume.levels,
                                          .darkest = volume.darkest,
                                          .top = volume.top};
}

START_TEST(volumes_keep_to_the_largest_texture)
{
    make_volume(HATCH_VOLUME_3D);
    limits.volume = SIZE;
    HATCH_TEST_OK(upload(&asset_volume, SIZE), &frame.err);
    limits.volume = SIZE - 1;
    ck_assert_int_eq(upload(&asset_volume, SIZE), HATCH_LIMIT);
    make_volume(HATCH_VOLUME_ARRAY);
    GLint layers = (GLint)asset.texture.texels.layers;
    limits.array = SIZE;
    limits.layers = layers;
    HATCH_TEST_OK(upload(&asset_volume, SIZE), &frame.err);
    limits.layers = layers - 1;
    ck_assert_int_eq(upload(&asset_volume, SIZE), HATCH_LIMIT);
    limits.layers = layers;
    limits.array = SIZE - 1;
    ck_assert_int_eq(upload(&asset_volume, SIZE), HATCH_LIMIT);
}
END_TEST

START_TEST(exact_runs_keep_to_the_largest_texture)
{
    struct hatch_exact exact;
    for (uint32_t t = 0; t < TONES; t++) /* columns darken with the tone */
        for (uint32_t level = 0; t > 0 && level < asset.map.columns[t].level_count; level++) {
            struct hatch_image *image = &asset.map.columns[t].levels[level];
            for (uint32_t i = 0; i < image->width * image->height; i++)
                image->pixels[i] = fminf(image->pixels[i], asset.map.columns[t - 1].levels[level].pixels[i]);
        }
    HATCH_TEST_OK(hatch_exact_make(&asset.map, NULL, &frame.args.keep, &frame.args.scratch, &exact, &frame.err),
                  &frame.err);
    asset.texture = (struct tone_texture){
        .holds = TONE_TEXTURE_RUNS, .texels = exact.texels, .exact = exact, .levels = exact.levels, .darkest = 1};
    limits.array = (GLint)exact.texels.height;
    HATCH_TEST_OK(upload(&asset_thresholds, SIZE), &frame.err);
    limits.array--;
    ck_assert_int_eq(upload(&asset_thresholds, SIZE), HATCH_LIMIT);
}
END_TEST

/* Of the vertices of a plane that passes the eye, and of a ribbon of 100 points, 3 texels each. */
START_TEST(buffers_keep_to_the_texels_that_shaders_read)
{
    const struct hatch_tile tile = {0, 0, 64, 64, 64, 64};
    const struct hatch_near_options options = {
        .places = HATCH_NEAR_TEXCOORDS, .turn = {1, 0}, .tile = &tile, .max_memory = 1 << 28};
    const uint32_t ends[] = {100};
    const struct traced_strokes strokes = {.count = 1, .end = ends};
    struct near near = {.array = 0};
    struct traced_ribbon ribbon;
    epoxy_glGetIntegerv = get_integers;
    end();
    frame_arenas(&frame);
    struct hatch_mesh plane = frame_plane(&frame, 8);
    frame_open(&plane, &frame_unit, NULL, &frame);
    get_integers = epoxy_glGetIntegerv;
    epoxy_glGetIntegerv = get_limits;
    for (int i = 0; i < 2; i++) {
        struct hatch_view view = view_facing;
        view.orthographic = false;
        view.near_is_automatic = true;
        view.eye[2] = 1e-5;
        limits.buffer = (GLint)(10 * plane.vertex_count) - i;
        ck_assert_int_eq(near_begin(&near, &frame.on_gpu, &options, &view, &frame.err), i ? HATCH_LIMIT : HATCH_OK);
        ck_assert_ptr_nonnull(hatch_near_item_at(&near.found, 0));
        limits.buffer = 300 - i;
        ck_assert_int_eq(traced_make_ribbon(&strokes, &ribbon, &frame.err), i ? HATCH_LIMIT : HATCH_OK);
    }
    ck_assert_str_eq(frame.err.text, "too many points of strokes: 300 texels, the GPU's limit is 299");
    traced_free_ribbon(&ribbon);
    near_free(&near);
    epoxy_glGetIntegerv = get_integers;
    frame_finish(&frame);
    begin();
}
END_TEST

/* The refusal tells how many rows there are. */
START_TEST(lists_of_strokes_keep_to_the_largest_texture)
{
    struct test_map map;
    uint32_t rows = 0;
    map_begin();
    map_style("ink", NULL, &map);
    map.options.ids = true;
    map_fill(&map);
    asset.map = map.tam;
    ck_assert_int_eq(upload(&asset_strokes, 0), HATCH_LIMIT);
    ck_assert_int_eq(sscanf(frame.err.text, "the lists of the map's strokes have %u rows", &rows), 1);
    HATCH_TEST_OK(upload(&asset_strokes, rows), &frame.err);
    ck_assert_int_eq(upload(&asset_strokes, rows - 1), HATCH_LIMIT);
    map_end();
}
END_TEST

static enum hatch_status upload_seeds(const struct hatch_rptam *rptam, GLint limit)
{
    struct seeds seeds = {0};
    limits.buffer = limit;
    enum hatch_status status = seeds_upload(rptam, false, &frame.args.scratch, &seeds, &frame.err);
    if (status == HATCH_OK)
        seeds_free(&seeds);
    return status;
}

/* The refusal tells how many entries there are. */
START_TEST(seeds_keep_to_the_largest_buffer)
{
    struct hatch_rptam rptam;
    int entries = 0;
    model_make(&(struct model_how){.tile_px = 100, .length_px = 30, .width_px = 6}, &frame.args.keep,
               &frame.args.scratch, &rptam);
    ck_assert_int_eq(upload_seeds(&rptam, 1), HATCH_LIMIT);
    ck_assert_int_eq(sscanf(frame.err.text, "too many overlapping strokes: %d texels", &entries), 1);
    HATCH_TEST_OK(upload_seeds(&rptam, entries), &frame.err);
    ck_assert_int_eq(upload_seeds(&rptam, entries - 1), HATCH_LIMIT);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("render limits");
    TCase *tests = tcase_create("limits");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, maps_keep_to_the_largest_texture);
    tcase_add_test(tests, volumes_keep_to_the_largest_texture);
    tcase_add_test(tests, exact_runs_keep_to_the_largest_texture);
    tcase_add_test(tests, buffers_keep_to_the_texels_that_shaders_read);
    tcase_add_test(tests, lists_of_strokes_keep_to_the_largest_texture);
    tcase_add_test(tests, seeds_keep_to_the_largest_buffer);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
