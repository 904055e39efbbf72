/* Draws lapped scenes with a map of random texels and with an outline that the test fills. Call begin first. */
#ifndef HATCH_TEST_RENDER_LAPPED_H
#define HATCH_TEST_RENDER_LAPPED_H

#include <math.h>

#include "lapped_scene.h"
#include "render-gl/scene/material.h"
#include "render_frame.h"
#include "render_map.h"

enum { SIZE = LAPPED_SIZE, TONES = 6 };

static struct test_frame frame;
static struct hatch_tam map;
static struct hatch_image mask;
static struct hatch_patch_mesh *patches;

static inline void make_scene(const struct hatch_mesh *surface, const struct cut *cut)
{
    lapped_scene(surface, cut, &frame.args.keep, &frame.scene);
}

static inline void set_outline(void)
{
    GLuint texture = 0;
    HATCH_TEST_OK(material_outline(&mask, &frame.args.scratch, &texture, &frame.err), &frame.err);
    for (uint32_t i = 0; i < frame.on_gpu.unit.item_count; i++)
        frame.on_gpu.items[i].base_texture = texture;
}

static inline void begin_lapped(const struct hatch_mesh *surface, const struct cut *cut)
{
    make_scene(surface, cut);
    HATCH_TEST_OK(hatch_patches_join(&frame.scene, &frame.args.keep, &frame.args.scratch, &patches, NULL, &frame.err),
                  &frame.err);
    frame_open_scene(patches, &frame_unit, &map, &frame);
    set_outline();
}

static inline void begin(void)
{
    frame_arenas(&frame);
    random_map(SIZE, TONES, &frame.args.keep, &map);
    HATCH_TEST_OK(hatch_image_make(&frame.args.keep, SIZE, SIZE, "YA", &mask, &frame.err), &frame.err);
}

static inline void fill_mask(void)
{
    for (uint32_t i = 0; i < SIZE * SIZE; i++)
        mask.pixels[2 * i + 1] = 1;
}

/* Sets the outline to a disk with a soft border. */
static inline void round_mask(void)
{
    for (uint32_t i = 0; i < SIZE * SIZE; i++) {
        double x = (i % SIZE + 0.5) / SIZE - 0.5, y = (i / SIZE + 0.5) / SIZE - 0.5;
        mask.pixels[2 * i + 1] = (float)fmin(fmax((0.48 - hypot(x, y)) / 0.08, 0), 1);
    }
}

/* Makes the map black. Call this before the first technique draws. */
static inline void black_map(void)
{
    for (uint32_t t = 0; t < TONES; t++)
        for (uint32_t level = 0; level < map.columns[t].level_count; level++)
            for (uint32_t i = 0; i < map.columns[t].levels[level].width * map.columns[t].levels[level].height; i++)
                map.columns[t].levels[level].pixels[i] = 0;
}

static inline void draw_in_tiles(const char *technique, uint32_t tile_px, uint32_t side, struct hatch_image *image)
{
    const struct hatch_view view = {.eye = {0, 0, 4},
                                    .right = {1, 0, 0},
                                    .up = {0, 1, 0},
                                    .back = {0, 0, 1},
                                    .half_height = 0.3,
                                    .aspect = 1,
                                    .near = 0.1,
                                    .pivot = 4};
    const struct picture picture = frame_picture(&frame, technique);
    struct hatch_err *err = &frame.err;
    struct canvas canvas;
    HATCH_TEST_OK(canvas_make(tile_px, tile_px, side, &frame.shown.programs, &canvas, err), err);
    HATCH_TEST_OK(hatch_image_make(&frame.args.keep, 160, 160, "RGB", image, err), err);
    HATCH_TEST_OK(picture_draw(&picture, &view, &canvas, image, err), err);
    canvas_free(&canvas);
}

#endif
