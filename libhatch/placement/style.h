/* Drawing styles: small text files with one "key value ..." per line; '#' begins a comment. hatch-style(5) describes
 * the keys, whose values struct hatch_style holds. */
#ifndef HATCH_PLACEMENT_STYLE_H
#define HATCH_PLACEMENT_STYLE_H

#include <stdbool.h>

#include "base/bytes.h"
#include "curve/line_brush.h"
#include "curve/width.h"
#include "image/ramp.h"
#include "stroke/brush.h"
#include "tam/tam.h"

#define HATCH_STYLE_DIRECTIONS_MAX 8u

/* One direction of cross-hatching (Praun et al. 2001, §4), for the columns whose target tone is in from .. to. The
 * strokes of a column alternate between all of its directions. */
struct hatch_style_direction {
    float angle_rad;
    float from, to; /* tones, 0 .. 1 */
};

/* How crossing strokes combine; no pixel ever gets lighter. A stroke of colour c and alpha a changes the reflectance p
 * of each channel to: */
enum hatch_overlap {
    HATCH_OVERLAP_DARKENS, /* p (1 - a (1 - c)): layers of thin colour */
    HATCH_OVERLAP_FLAT,    /* min(p, 1 - a (1 - c)): the darker stroke wins */
    HATCH_OVERLAP_COVERS   /* min(p, p (1 - a) + a c): the later stroke covers, like paint */
};

struct hatch_style {
    char name[HATCH_NAME_MAX];
    enum hatch_brush_kind brush;
    char brush_file[256];             /* brush image: a path relative to the style's file */
    float width_px;                   /* 0.5 .. 64, the same on every level */
    float length_min, length_max;     /* fractions of the tile, 0 .. 4; 0 0 makes dots */
    float jitter_rad;                 /* standard deviation of the direction */
    float ink;                        /* darkness of a stroke, 0.01 .. 1 */
    float bend_min_rad, bend_max_rad; /* range of the turn of a stroke from start to end, 0 .. HATCH_STROKE_BEND_MAX, to
                                         a random side */
    enum hatch_overlap overlap;
    float tone_max; /* target tone of the last column, 0.01 .. 1 */
    bool tone_max_given;
    float tone_gamma; /* exponent of the target tones, 0.1 .. 10; 1: even steps of darkness, the first of which is
                         already darker than paper */
    uint32_t direction_count;
    struct hatch_style_direction directions[HATCH_STYLE_DIRECTIONS_MAX];
    uint32_t color_count;                                /* 0: strokes are black */
    struct hatch_ramp_stop colors[HATCH_RAMP_STOPS_MAX]; /* colours of strokes by tone */
    struct hatch_stroke_pen pen;        /* traced strokes; its width_px is unset: it is that of the style */
    struct hatch_line_brush line_brush; /* feature lines over traced strokes; pressure, ink and grain are unset */
    uint32_t candidates_light, candidates_dark; /* candidates per stroke in the lightest and the darkest column; 1000
                                                   and 100 in Praun et al. 2001, §4 */
};

/* Sets the style "ink", whose values other styles have for the keys that they leave out. */
void hatch_style_default(struct hatch_style *style);

/* Parses a style file.
 *   style  in: values for absent keys; out: the style; unchanged on failure
 * HATCH_BAD_INPUT for a text without a key, and, naming the line, for an unknown key, a wrong number of values or a
 * value out of range. */
enum hatch_status hatch_style_parse(struct hatch_bytes text, struct hatch_style *style,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Computes the target tone of each column: target[i] = tone_max * ((i + 1) / tones)^tone_gamma.
 *   target  out: tones entries */
void hatch_style_targets(const struct hatch_style *style, uint32_t tones, float *target);

#endif
