/* Styles of solid textures: small text files with one "key value ..." per line; '#' begins a comment. solid(5)
 * describes the kinds and the keys of each. */
#ifndef HATCH_SOLID_STYLE_H
#define HATCH_SOLID_STYLE_H

#include <stdbool.h>

#include "base/bytes.h"
#include "image/image.h"
#include "image/ramp.h"

#define HATCH_SOLID_DIRECTIONS_MAX 8u

enum hatch_solid_kind {
    HATCH_SOLID_NO_KIND,
    HATCH_SOLID_PERLIN,     /* gradient noise */
    HATCH_SOLID_TURBULENCE, /* absolute values of gradient noise, in octaves */
    HATCH_SOLID_WOOD,       /* growth rings and fibres */
    HATCH_SOLID_MARBLE,     /* a sine of a distorted position */
    HATCH_SOLID_WORLEY,     /* distances from scattered points */
    HATCH_SOLID_STIPPLE,    /* dots */
    HATCH_SOLID_STROKES,    /* short straight strokes */
    HATCH_SOLID_PAPER,      /* fibres and grain of paper */
    HATCH_SOLID_CANVAS,     /* woven threads */
    HATCH_SOLID_KINDS
};

/* Value of a worley texture: the distance from the nearest point, from the second nearest, or their difference. */
enum hatch_solid_distance { HATCH_SOLID_F1, HATCH_SOLID_F2, HATCH_SOLID_F2_F1 };

/* Whether values are equalized: always, never, or unless the style has colours. */
enum hatch_solid_equalize { HATCH_SOLID_EQUALIZE_GREY, HATCH_SOLID_EQUALIZE, HATCH_SOLID_EQUALIZE_NOT };

/* A direction of strokes that are added while the tone grows from `from` to `to`. */
struct hatch_solid_direction {
    float vector[3]; /* of any length but 0 */
    float from, to;  /* tones, 0 .. 1 */
};

/* The values of the keys. Numbers of cells, rings and so on are whole, so that the texture repeats. Values of keys that
 * the kind does not use are 0. */
struct hatch_solid_style {
    char name[HATCH_NAME_MAX];
    enum hatch_solid_kind kind;
    enum hatch_solid_equalize equalize;
    float contrast; /* factor of the distance from middle grey, where values are not equalized */
    uint32_t color_count;
    struct hatch_ramp_stop colors[HATCH_RAMP_STOPS_MAX]; /* colours by value; none: the texture is grey */
    float scale;                                         /* cells of the noise along a side of the cube */
    float octaves, gain;      /* number of octaves, and the amplitude of each relative to the one before */
    float rings;              /* growth rings across the cube */
    float veins[3];           /* periods of the sine along x, y and z */
    float warp;               /* distortion, in rings or veins */
    float grain;              /* strength of fibres, 0 .. 1 */
    float fibers;             /* fibres across the cube */
    float sharpness;          /* of veins: 1 is a sine */
    float jitter;             /* of points: a share of their cell; of strokes: degrees */
    float dots;               /* dots along a side: the cube holds the cube of this number */
    float vary;               /* differences between dots or threads, 0 .. 1 */
    float length, width;      /* of strokes, as shares of a side */
    float density;            /* strokes over each point at the darkest tone, on average */
    float grow;               /* share of the tones over which a stroke grows to its width */
    float threads;            /* threads across the cube, an even number */
    uint32_t axis;            /* of the trunk: 0 x, 1 y, 2 z */
    uint32_t distance;        /* enum hatch_solid_distance */
    uint32_t direction_count; /* 0: strokes in all directions */
    struct hatch_solid_direction directions[HATCH_SOLID_DIRECTIONS_MAX];
};

/* Returns the name of a kind, such as "wood". */
const char *hatch_solid_kind_name(enum hatch_solid_kind kind);

/* Returns whether the values of a style are equalized. */
bool hatch_solid_equalizes(const struct hatch_solid_style *style);

/* Returns whether the textures of a style have no direction: its kind has none, or its strokes point anywhere. */
bool hatch_solid_is_isotropic(const struct hatch_solid_style *style);

/* Lowers the numbers of cells, rings, dots, fibres, threads and veins to those that texels can show: of cells, rings
 * and dots one for two texels, of fibres one for each, of threads and, in either direction, of veins one for four. With
 * more, noise, threads and veins would be the same in all texels. Returns the first key that it has lowered, or NULL.
 *   style  of a kind
 *   size   texels along a side, a power of two, at least 8 */
const char *hatch_solid_style_fit(struct hatch_solid_style *style, uint32_t size);

/* Parses the text of a style.
 *   style  in: zeroed for a file, whose first key is its kind; for lines that follow a file: its style; out: the style,
 *          unchanged on failure
 * HATCH_BAD_INPUT for a text without a key and, naming the line, for an unknown key, a key that the kind does not use,
 * and missing, additional and wrong values. */
enum hatch_status hatch_solid_style_parse(struct hatch_bytes text, struct hatch_solid_style *style,
                                          struct hatch_err *err) HATCH_MUST_USE;

#endif
