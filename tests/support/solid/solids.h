/* Solid textures for tests and measurements, and render-gl's technique that draws them. */
#ifndef HATCH_TEST_SOLIDS_H
#define HATCH_TEST_SOLIDS_H

#include <math.h>

#include "base/random.h"
#include "render-gl/look/look.h"
#include "render_frame.h"
#include "solid/zoom.h"

#define SOLID_TURN 6.283185307179586

/* Makes a texture without texels that the next functions fill. */
static inline struct hatch_solid solid_blank(struct hatch_arena *arena, uint32_t size)
{
    struct hatch_solid solid;
    struct hatch_err err;
    HATCH_TEST_OK(hatch_solid_make(arena, size, 1, &solid, &err), &err);
    return solid;
}

/* Draws a random wave with about `periods` along a side of the texture. It has about as many in planes of x and y:
 * these have the frequencies and the mean of the texture. */
static inline void solid_wave(uint32_t number, double periods, int wave[3])
{
    double across = 0, length = 0;
    for (uint32_t try = 0; fabs(length - periods) > 0.1 * periods || across < 0.9 * periods; try++) {
        for (uint32_t k = 0; k < 3; k++)
            wave[k] = (int)lround(2.4 * periods * ((double)hatch_random_unit(9, number, 3 * try + k) - 0.5));
        across = hypot(wave[0], wave[1]);
        length = hypot(across, wave[2]);
    }
}

/* Makes a sum of 60 waves of random directions with about `periods` along a side; two standard deviations reach from
 * ink to paper. */
static inline struct hatch_solid solid_of_waves(struct hatch_arena *arena, uint32_t size, double periods)
{
    enum { WAVES = 60 };
    struct hatch_solid solid = solid_blank(arena, size);
    size_t texels = (size_t)size * size * size;
    double *sums = HATCH_NEW(arena, double, texels, NULL);
    ck_assert_ptr_nonnull(sums);
    for (uint32_t i = 0; i < WAVES; i++) {
        int wave[3];
        double shift = (double)hatch_random_unit(10, i, 0), *to = sums;
        solid_wave(i, periods, wave);
        for (int z = 0; z < (int)size; z++)
            for (int y = 0; y < (int)size; y++)
                for (int x = 0; x < (int)size; x++)
                    *to++ += cos(SOLID_TURN * (shift + (double)(wave[0] * x + wave[1] * y + wave[2] * z) / size));
    }
    for (size_t t = 0; t < texels; t++)
        solid.texels[t] = hatch_unorm8((float)(0.5 + 0.25 * sums[t] / sqrt(WAVES / 2.0)));
    return solid;
}

/* Makes cubes of `cell` texels that are paper and ink in turn. */
static inline struct hatch_solid solid_checkers(struct hatch_arena *arena, uint32_t size, uint32_t cell)
{
    struct hatch_solid solid = solid_blank(arena, size);
    for (uint32_t z = 0; z < size; z++)
        for (uint32_t y = 0; y < size; y++)
            for (uint32_t x = 0; x < size; x++)
                solid.texels[((size_t)z * size + y) * size + x] = (x / cell + y / cell + z / cell) % 2 ? 255 : 0;
    return solid;
}

static inline struct hatch_solid solid_of_value(struct hatch_arena *arena, uint32_t size, uint8_t value)
{
    struct hatch_solid solid = solid_blank(arena, size);
    memset(solid.texels, value, (size_t)size * size * size);
    return solid;
}

/* Draws with a texture from here on, fully lit: pictures by the look "plain" are the texture's values. */
static inline void solid_use(struct test_frame *frame, const struct hatch_solid *solid, enum hatch_zoom_blend blend,
                             double period_px)
{
    for (int i = 0; i < FRAME_TECHNIQUES_MAX; i++)
        technique_close(&frame->instances[i]);
    HATCH_TEST_OK(technique_open(&frame->instances[0], &technique_solid, &frame->technique_args, &frame->err),
                  &frame->err);
    struct look *look = frame->instances[0].state;
    look_choose(look, LOOK_PLAIN);
    frame->instances[0].places = HATCH_NEAR_REST;
    look->files.count = 1;
    look->files.solids[0] = *solid;
    look_options.blend = (int)blend;
    look_options.period_px = period_px;
    frame->shown.style.curve.low = frame->shown.style.curve.high = 0;
}

/* Draws in a look from here on, in all tones. */
static inline void solid_use_look(struct test_frame *frame, const struct hatch_solid *solid, double period_px,
                                  enum look_kind kind)
{
    solid_use(frame, solid, HATCH_ZOOM_LINEAR, period_px);
    look_choose(frame->instances[0].state, kind);
    frame->shown.style.curve.high = 1;
}

#endif
