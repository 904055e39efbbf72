/* Reads layers(5): the layers of strokes of a recursive procedural tonal art map as text, one layer per line. */
#ifndef HATCH_SEED_LAYERS_H
#define HATCH_SEED_LAYERS_H

#include "base/bytes.h"
#include "seed/rptam.h"

/* The values that one line gives; values for absent keys are left to the caller. */
struct hatch_layer_line {
    bool tone_given, turn_given;
    double low, high;                         /* as in struct hatch_rptam_layer_style; set if tone_given */
    double turn_rad;                          /* direction of strokes, measured from u towards v; set if turn_given */
    double length_px, width_px, ink, tile_px; /* greater than 0; 0 if not given */
    const char *stroke;                       /* name of a file or a brush, NUL-terminated; NULL: not given */
};

struct hatch_layers {
    uint32_t count; /* 1 .. HATCH_RPTAM_LAYERS_MAX */
    struct hatch_layer_line *lines;
};

/* Reads a file. Empty lines, and text after a #, are ignored.
 *   layers  out, in arena; unchanged on failure
 * HATCH_BAD_INPUT, which names the line, for an unknown or repeated key, a missing value or a value out of range;
 * HATCH_BAD_INPUT also for a file without layers; HATCH_LIMIT for more than HATCH_RPTAM_LAYERS_MAX layers. */
enum hatch_status hatch_layers_read(struct hatch_bytes file, struct hatch_arena *arena, struct hatch_layers *layers,
                                    struct hatch_err *err) HATCH_MUST_USE;

#endif
