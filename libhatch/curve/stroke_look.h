/* The look of strokes along their line: a zigzag, profiles of width and pressure, and colours of which each stroke has
 * one. shaders/traced of render-gl computes the same. */
#ifndef HATCH_CURVE_STROKE_LOOK_H
#define HATCH_CURVE_STROKE_LOOK_H

#include <stdbool.h>
#include <stdint.h>

#define HATCH_PROFILE_MAX 8u
#define HATCH_STROKE_COLORS_MAX 16u
#define HATCH_STROKE_NUMBER_BITS 0xfffffu /* of a stroke's id, which choose its colour */

/* Values at even distances along a stroke, linear between them. */
struct hatch_profile {
    uint32_t count; /* 0: 1 everywhere; else at least 2 */
    float values[HATCH_PROFILE_MAX];
};

/* Zeroed: a plain line in the colour of the ink. */
struct hatch_stroke_look {
    float zigzag;                         /* greatest distance of a zigzag from the stroke's line, in widths; 0: none */
    float zigzag_length;                  /* of a wave, in widths; over 0 with a zigzag */
    struct hatch_profile width, pressure; /* shares of the width and of the ink */
    uint32_t color_count;                 /* 0: all strokes have the colour of the ink */
    bool mixes;                           /* a stroke has any colour between two neighbours, else one of them */
    float colors[HATCH_STROKE_COLORS_MAX][3]; /* linear light */
};

/* Returns the value at a place along the stroke, 0 .. 1. */
double hatch_profile_at(const struct hatch_profile *profile, double at);

double hatch_profile_mean(const struct hatch_profile *profile);

/* Returns how far a zigzag lies beside the stroke's line, -1 .. 1; above 0: to its left. Near whole levels
 * it is a triangle wave from 0 upwards; between them the waves of the next level, which are half as long, grow.
 *   at     place along the stroke, in waves of level 0
 *   level  binary logarithm of waves per unit of `at` */
double hatch_zigzag_beside(double at, double level);

/* Returns the first place after `at` where a zigzag may turn. */
double hatch_zigzag_turn(double at, double level);

/* Returns the length of strokes with their zigzag, in that of their lines. */
double hatch_zigzag_stretch(const struct hatch_stroke_look *look);

/* Finds the colour of a stroke, which is always the same; there must be some. */
void hatch_stroke_color(const struct hatch_stroke_look *look, uint32_t id, float rgb[3]);

#endif
