/* Makes models of recursive procedural tonal art maps for tests: seed points, a style, and a stroke that is darker
 * along its middle and at one end. */
#ifndef HATCH_TEST_RPTAM_MODEL_H
#define HATCH_TEST_RPTAM_MODEL_H

#include <math.h>

#include "base/random.h"
#include "run.h"
#include "seed/rptam.h"
#include "seed/seeds_make.h"

/* Parameters of a model. Where a comment has "0: default", 0 stands for that default. */
struct model_how {
    uint32_t seeds;  /* 0: 64 */
    uint32_t layers; /* 0: 1 */
    double tile_px, length_px, width_px;
    double angle_rad[HATCH_RPTAM_LAYERS_MAX];
    double ink; /* 0: 1 */
    enum hatch_fade_law law;
    bool fade_size;
    double overlap;
    bool solid;          /* strokes are rectangles of one darkness */
    bool varied;         /* strokes differ and have grain */
    uint32_t candidates; /* 0: 5 */
};

static inline void model_stroke(bool solid, struct hatch_arena *arena, struct hatch_image *stroke)
{
    struct hatch_err failed;
    HATCH_TEST_OK(hatch_image_make(arena, 64, 16, "A", stroke, &failed), &failed);
    for (uint32_t i = 0; i < 64 * 16; i++)
        stroke->pixels[i] = solid ? 1.0f : (float)sin(3.1416 * (i / 64 + 0.5) / 16) * fminf(1.0f, (float)(i % 64) / 20);
}

/* Makes a grain texture of 11 x 7 random pixels. */
static inline const struct hatch_image *model_grain(struct hatch_arena *arena)
{
    struct hatch_err failed;
    struct hatch_image *grain = HATCH_NEW(arena, struct hatch_image, 1, &failed);
    ck_assert_ptr_nonnull(grain);
    HATCH_TEST_OK(hatch_image_make(arena, 11, 7, "A", grain, &failed), &failed);
    for (uint32_t i = 0; i < 11 * 7; i++)
        grain->pixels[i] = hatch_random_unit(3, 0, i);
    return grain;
}

/* Makes a style whose layers divide the tones 0..1 evenly.
 *   stroke  out: the image of the strokes */
static inline void model_style(const struct model_how *how, struct hatch_arena *arena, struct hatch_image *stroke,
                               struct hatch_rptam_style *style)
{
    uint32_t layers = how->layers ? how->layers : 1;
    model_stroke(how->solid, arena, stroke);
    *style = (struct hatch_rptam_style){
        .law = how->law, .fade_size = how->fade_size, .overlap = how->overlap, .layer_count = layers};
    for (uint32_t i = 0; i < layers; i++)
        style->layers[i] = (struct hatch_rptam_layer_style){.low = (double)i / layers,
                                                            .high = (i + 1.0) / layers,
                                                            .angle_rad = how->angle_rad[i],
                                                            .length_px = how->length_px,
                                                            .width_px = how->width_px,
                                                            .tile_px = how->tile_px,
                                                            .ink = how->ink > 0 ? how->ink : 1,
                                                            .stroke = stroke,
                                                            .grain = how->varied ? model_grain(arena) : NULL,
                                                            .varied = how->varied};
}

/* Makes the model of a style, with seed sets of its own. */
static inline void model_of_style(const struct model_how *how, const struct hatch_rptam_style *style,
                                  struct hatch_arena *arena, struct hatch_arena *temporary, struct hatch_rptam *rptam)
{
    const struct hatch_seeds_options options = {.cycle = {.count = how->seeds ? how->seeds : 64, .seed = 2},
                                                .layers = style->layer_count,
                                                .candidates = how->candidates ? how->candidates : 5};
    struct hatch_seeds seeds;
    uint64_t steps;
    struct hatch_err failed;
    HATCH_TEST_OK(hatch_seeds_make(&options, arena, temporary, &seeds, &steps, &failed), &failed);
    HATCH_TEST_OK(hatch_rptam_make(&seeds, style, arena, temporary, rptam, &failed), &failed);
}

static inline void model_make(const struct model_how *how, struct hatch_arena *arena, struct hatch_arena *temporary,
                              struct hatch_rptam *rptam)
{
    struct hatch_rptam_style style;
    struct hatch_image stroke;
    model_style(how, arena, &stroke, &style);
    model_of_style(how, &style, arena, temporary, rptam);
}

#endif
