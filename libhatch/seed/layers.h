/* layers(5): the layers of strokes of a recursive procedural tonal art map as text, a layer a line. */
#ifndef HATCH_SEED_LAYERS_H
#define HATCH_SEED_LAYERS_H

#include "base/bytes.h"
#include "seed/rptam.h"

/* What a line says; what it leaves out is somebody else's choice. */
struct hatch_layer_line {
    bool tone_given, turn_given;
    double low, high;                         /* of the way from paper to the darkest, 0 <= low < high <= 1 */
    double turn_rad;                          /* of strokes to u */
    double length_px, width_px, ink, tile_px; /* over 0, or 0: not given */
    const char *stroke;                       /* a file's name or a brush's, zero-terminated; NULL: not given */
};

struct hatch_layers {
    uint32_t count; /* 1 .. HATCH_RPTAM_LAYERS_MAX */
    struct hatch_layer_line *lines;
};

/* Empty lines, and what stands behind a #, do not count. HATCH_BAD_INPUT with the line's number for an unknown or
 * repeated key and a value that is missing, none, or out of its range; and where there is no layer.
 * HATCH_LIMIT for more than HATCH_RPTAM_LAYERS_MAX. */
enum hatch_status hatch_layers_read(struct hatch_bytes file, struct hatch_arena *arena, struct hatch_layers *layers,
                                    struct hatch_err *err) HATCH_MUST_USE;

#endif
