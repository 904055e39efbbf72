/* A drawing style: a small text file that a user copies and changes. One "key value ..." per line,
 * '#' begins a comment. hatch-style(5) lists the keys; every key of this struct has one. */
#ifndef HATCH_TAM_STYLE_H
#define HATCH_TAM_STYLE_H

#include <stdbool.h>

#include "base/bytes.h"
#include "stroke/brush.h"
#include "tam/tam.h"

#define HATCH_STYLE_DIRECTIONS_MAX 8u
#define HATCH_STYLE_COLORS_MAX 32u

/* One direction of the cross-hatching schedule (§4): strokes of angle_rad are drawn in the columns
 * whose target darkness lies in [from, to]. Several at once fill the gaps of each other. */
struct hatch_style_direction {
    float angle_rad;
    float from, to; /* 0 .. 1 */
};

/* What crossing strokes do to each other; nothing ever gets lighter. With a stroke's colour c and alpha a,
 * channel by channel, a reflectance p becomes: */
enum hatch_overlap {
    HATCH_OVERLAP_DARKENS, /* p (1 - a (1 - c)): layers of thin colour */
    HATCH_OVERLAP_FLAT,    /* min(p, 1 - a (1 - c)): the darker one stands */
    HATCH_OVERLAP_COVERS   /* min(p, p (1 - a) + a c): the later one covers, as paint does */
};

/* The colour of the strokes that are drawn in the column of that darkness. */
struct hatch_style_color {
    float tone;   /* 0 .. 1, rising */
    float rgb[3]; /* linear */
};

struct hatch_style {
    char name[HATCH_NAME_MAX];
    enum hatch_brush_kind brush;
    char brush_file[256];             /* brush image: a path, relative to the style's file */
    float width_px;                   /* 0.5 .. 64, equal on every level */
    float length_min, length_max;     /* fractions of the tile, 0 .. 4; 0 0 makes dots */
    float jitter_rad;                 /* standard deviation of the orientation */
    float ink;                        /* 0 .. 1: how dark one stroke is */
    float bend_min_rad, bend_max_rad; /* how far a stroke turns, to either side, 0 .. HATCH_STROKE_BEND_MAX */
    enum hatch_overlap overlap;
    float tone_max; /* target darkness of the last column, 0 .. 1 */
    bool tone_max_given;
    float tone_gamma; /* 0.1 .. 10: 1 is even steps of darkness from white, which is implicit */
    uint32_t direction_count;
    struct hatch_style_direction directions[HATCH_STYLE_DIRECTIONS_MAX];
    uint32_t color_count; /* 0: black */
    struct hatch_style_color colors[HATCH_STYLE_COLORS_MAX];
    uint32_t candidates_light, candidates_dark; /* 1000 falling to 100 (§4) */
};

/* The style "ink": what an empty file means. */
void hatch_style_default(struct hatch_style *style);

/* HATCH_BAD_INPUT with the line for an unknown key, a wrong number of values, or a value out of
 * range. style holds the defaults on entry and is unchanged on failure. */
enum hatch_status hatch_style_parse(struct hatch_bytes text, struct hatch_style *style,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* The colour of strokes that are drawn at that darkness: linear between the style's colours, the nearest
 * beyond them, black where there is none. */
void hatch_style_color_at(const struct hatch_style *style, float tone, float rgb[3]);

/* The target darkness of each column: target[i] = tone_max * ((i + 1) / tones)^tone_gamma. */
void hatch_style_targets(const struct hatch_style *style, uint32_t tones, float *target);

#endif
