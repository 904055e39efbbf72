/* How a brush draws the feature lines of a picture (line/lines.h). */
#ifndef HATCH_CURVE_LINE_BRUSH_H
#define HATCH_CURVE_LINE_BRUSH_H

#include <stdbool.h>

/* Zeroed: lines have one width. */
struct hatch_line_brush {
    float taper_px;  /* length of the pointed ends of lines; of a short one, they are three tenths of its length */
    float vary;      /* greatest change of width along a line, as a share of it, 0 .. 1 */
    float wobble_px; /* greatest distance from the line's place */
    float depth;     /* how much wider lines are before deep steps and narrower elsewhere, 0 .. 1 */
    float tone;      /* how much wider lines are in the dark and narrower in the light, 0 .. 1 */
    float pressure;  /* greatest lightening of the ink along a line, 0 .. 1 */
    float ink;       /* darkness of lines, 0 .. 1 */
    float grain;     /* share of the ink that the grain of the paper leaves out, 0 .. 1 */
};

/* Returns whether a brush draws lines of more than one width. */
static inline bool hatch_line_brush_is_used(const struct hatch_line_brush *brush)
{
    return brush->taper_px > 0 || brush->vary > 0 || brush->wobble_px > 0 || brush->depth > 0 || brush->tone > 0;
}

#endif
