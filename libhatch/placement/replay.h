/* Makes a tonal art map from a drawing by replaying its strokes in order. The finest image of a tone holds the strokes
 * up to the point at which the drawing is that dark; each coarser image holds a selection of those (Webb, Praun,
 * Finkelstein & Hoppe, "Fine Tone Control in Hardware Hatching", NPAR 2002, §4). */
#ifndef HATCH_PLACEMENT_REPLAY_H
#define HATCH_PLACEMENT_REPLAY_H

#include "placement/fill.h"

struct hatch_replay_options {
    const struct hatch_style *style;
    const struct hatch_brush *brush; /* the brush of all strokes */
    uint32_t size_px, tones;         /* as in struct hatch_fill_options */
    uint32_t levels;                 /* number of drawn levels, 1 .. HATCH_STROKE_LEVELS_MAX */
    uint64_t seed;                   /* random seed that selects the strokes to leave out */
    bool ids, color;                 /* as in struct hatch_fill_options, but strokes have their own colours */
    const float *targets; /* target tone of each column, ascending; NULL: even steps to the darkness of the whole
                             drawing, shaped by the tone_gamma of the style */
    float keep; /* how a coarser level chooses strokes of the next finer one. Below 1: it takes the first strokes of a
                   random selection until the tone is met; each level's selection is this share of that of the next
                   finer level. 1: it takes the first strokes */
    bool fit;   /* true: instead, a coarser level takes of the new strokes of each tone the share that meets the tone;
                   keep is ignored */
};

/* A tone error that is too small to be seen. */
#define HATCH_REPLAY_TONE 0.003f

/* Chroma and hue are those of image/color.h. */
struct hatch_replay_result {
    float darkest;          /* mean darkness of the finest level with every stroke */
    uint32_t short_columns; /* number of columns whose target is darker than `darkest` by more than HATCH_REPLAY_TONE */
    float tone_error;       /* largest difference between the mean of an image and its target */
    float tone_bound;   /* bound of tone_error unless images are exhausted: half of the largest darkness that a single
                           stroke adds to an image */
    uint32_t exhausted; /* number of images that are more than HATCH_REPLAY_TONE lighter than their target although they
                           hold all strokes of the next finer image */
    float shortfall;    /* how much lighter such an image is at most */
    float chroma_error; /* largest distance of an image's mean (chroma, hue) from that of its tone's finest image;
                           as both are means, no blend of images has a larger one */
    float hue_error_deg; /* largest difference in hue between an image's mean and that of its tone's finest image, over
                            tones whose finest image has a chroma of at least HATCH_COLOR_CHROMA_MIN */
};

/* Replays a drawing and passes each column to sink. Every stroke of an image is also in all darker images of its
 * level and in all finer images of its tone.
 *   strokes  in drawing order; their column, level and delay are set, and strokes that no image holds, because the
 *            darkest column is reached before them, are removed
 *   result   out; unchanged on failure
 * HATCH_BAD_INPUT for a drawing without strokes; the status of sink. */
enum hatch_status hatch_tam_replay(const struct hatch_replay_options *options, struct hatch_stroke_list *strokes,
                                   struct hatch_arena *arena, struct hatch_arena *scratch,
                                   const struct hatch_tam_sink *sink, struct hatch_replay_result *result,
                                   struct hatch_err *err) HATCH_MUST_USE;

#endif
