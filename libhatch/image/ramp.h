/* Colour ramps: colours at rising places between 0 and 1, and linear between them. */
#ifndef HATCH_IMAGE_RAMP_H
#define HATCH_IMAGE_RAMP_H

#include "base/text.h"

#define HATCH_RAMP_STOPS_MAX 32u

struct hatch_ramp_stop {
    float at;     /* 0 .. 1, rising from stop to stop */
    float rgb[3]; /* linear */
};

/* Computes the colour at a place: that of the first or the last stop beyond them; black without stops.
 *   rgb  out: linear */
void hatch_ramp_color(const struct hatch_ramp_stop *stops, uint32_t count, float at, float rgb[3]);

/* Parses the values of a "color" line, a place and three or six hexadecimal digits, and adds them as a stop.
 *   rest   the line after its key
 *   what   names the place in messages, such as "tone"
 *   stops  HATCH_RAMP_STOPS_MAX entries
 *   count  in and out: number of stops
 * HATCH_BAD_INPUT for wrong values, a place that does not exceed the last one, and too many stops. */
enum hatch_status hatch_ramp_read(struct hatch_text *rest, const char *what, struct hatch_ramp_stop *stops,
                                  uint32_t *count, struct hatch_err *err) HATCH_MUST_USE;

#endif
