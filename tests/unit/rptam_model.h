/* Models of strokes at seeds for tests: seeds, styles and a stroke that is darker along its middle and at one
 * end. Include after run.h. */
#ifndef HATCH_TEST_RPTAM_MODEL_H
#define HATCH_TEST_RPTAM_MODEL_H

#include <math.h>

#include "run.h"
#include "seed/rptam.h"
#include "seed/spread.h"

/* What a model is made of; numbers of 0 are what they say. */
struct model_how {
    uint32_t seeds;         /* 0: 64 */
    uint32_t layers;        /* 0: 1 */
    double tile_px, length_px, width_px;
    double angle_rad[HATCH_RPTAM_LAYERS_MAX];
    double ink;             /* 0: 1 */
    enum hatch_fade_law law;
    bool fade_size;
    double overlap;
    bool solid;             /* strokes are rectangles of one darkness */
    uint32_t candidates;    /* 0: 5 */
};

static inline void model_stroke(bool solid, struct hatch_arena *arena, struct hatch_image *stroke)
{
    struct hatch_err failed;
    HATCH_TEST_OK(hatch_image_make(arena, 64, 16, "A", stroke, &failed), &failed);
    for (uint32_t i = 0; i < 64 * 16; i++)
        stroke->pixels[i] = solid ? 1.0f
                                  : (float)sin(3.1416 * (i / 64 + 0.5) / 16) * fminf(1.0f, (float)(i % 64) / 20);
}

static inline void model_make(const struct model_how *how, struct hatch_arena *arena, struct hatch_arena *temporary,
                              struct hatch_rptam *rptam)
{
    const struct hatch_seeds_options options = {.cycle = {.count = how->seeds ? how->seeds : 64, .seed = 2},
                                                .layers = how->layers ? how->layers : 1,
                                                .candidates = how->candidates ? how->candidates : 5};
    struct hatch_rptam_style style = {.tile_px = how->tile_px,
                                      .length_px = how->length_px,
                                      .width_px = how->width_px,
                                      .ink = how->ink > 0 ? how->ink : 1,
                                      .law = how->law,
                                      .fade_size = how->fade_size,
                                      .overlap = how->overlap,
                                      .tone_overlap = how->overlap};
    struct hatch_seeds seeds;
    struct hatch_image stroke;
    uint64_t steps;
    struct hatch_err failed;
    memcpy(style.angle_rad, how->angle_rad, sizeof style.angle_rad);
    HATCH_TEST_OK(hatch_seeds_make(&options, arena, temporary, &seeds, &steps, &failed), &failed);
    model_stroke(how->solid, arena, &stroke);
    HATCH_TEST_OK(hatch_rptam_make(&seeds, &style, &stroke, arena, temporary, rptam, &failed), &failed);
}

#endif
