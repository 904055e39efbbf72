/* A tonal art map from a drawing: its strokes are drawn again in their order, and the images of a tone are
 * what stands there when the drawing has become that dark (Webb, Praun, Finkelstein and Hoppe, "Fine Tone
 * Control in Hardware Hatching", NPAR 2002, §4). */
#ifndef HATCH_TAM_REPLAY_H
#define HATCH_TAM_REPLAY_H

#include "placement/fill.h"

struct hatch_replay_options {
    uint32_t size_px, tones, levels; /* as for filling; levels: 1 .. HATCH_STROKE_LEVELS_MAX */
    uint64_t seed;                   /* of the strokes that are thrown out */
    bool ids, color;                 /* color: columns hold R, G and B */
    /* How an image of a coarser level chooses from the strokes of the next finer one. Below 1: the share of
     * the drawing that is kept, at random, from level to level, before the first ones are taken until the
     * tone is met; 1: the first ones. */
    float keep;
    bool fit; /* take of each tone's new strokes the share that meets it, found stroke by stroke */
};

/* A tone error that nobody sees. Chroma and hue are those of image/color.h. */
#define HATCH_REPLAY_TONE 0.003f

struct hatch_replay_result {
    float darkest;          /* of the finest level with every stroke */
    uint32_t short_columns; /* whose target is over HATCH_REPLAY_TONE darker than that */
    float tone_error;       /* largest, over all images, between the mean and the target */
    float tone_bound;       /* what it cannot pass where no image is exhausted: half of what the darkest stroke
                               adds to an image */
    uint32_t exhausted;     /* images over HATCH_REPLAY_TONE lighter than their target with all the strokes that
                               the finer image has */
    float chroma_error;     /* largest distance of an image's (chroma, hue) from that of its tone's finest
                               image: as both are means, no blend of images is further off */
    float hue_error_deg;    /* largest, where the finest image has HATCH_COLOR_CHROMA_MIN or more */
};

/* Draws the strokes in their order. Where they stand is noted in their column, level and delay; those that
 * stand nowhere, because the darkest column is reached before them, are left out.
 * Every stroke of an image is also in all darker images of its size and in all finer images of its tone.
 * targets: of each column, rising; NULL for even steps to what the whole drawing reaches, and then
 * style's tone_gamma counts. brush: of all strokes. Columns go to sink, lightest first. */
enum hatch_status hatch_tam_replay(const struct hatch_style *style, const struct hatch_brush *brush,
                                   const struct hatch_replay_options *options, const float *targets,
                                   struct hatch_stroke_list *strokes, struct hatch_arena *arena,
                                   struct hatch_arena *scratch, hatch_tam_sink sink, void *context,
                                   struct hatch_replay_result *result, struct hatch_err *err) HATCH_MUST_USE;

#endif
