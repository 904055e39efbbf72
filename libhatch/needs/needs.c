#include "needs/needs.h"

#include <math.h>
#include <string.h>

#include "base/text.h"

#define HEADER "thing\tindex\tvalue\tunit"

/* Things that generators read. */
enum thing { TOLERANCE, RELATIVE, DARKEST, UNIT_PX, THINGS };

static const struct {
    const char *name;
    double low, high;
} things[THINGS] = {
    [TOLERANCE] = {"tolerance", 1e-6, 1},
    [RELATIVE] = {"relative", 0, 1},
    [DARKEST] = {"darkest", 0, 1},
    [UNIT_PX] = {"unit-px", 0, 1e30},
};

/* Values that were read; below 0: not found. */
struct reading {
    double values[THINGS]; /* of several rows of one thing, the greatest */
    double unit_px[HATCH_NEEDS_TONES];
};

static enum hatch_status parse_row(struct hatch_text line, struct reading *reading, struct hatch_err *err)
{
    struct hatch_text thing, index, number;
    double value, part;
    if (!hatch_text_field(&line, &thing) || !hatch_text_field(&line, &index) || !hatch_text_field(&line, &number))
        return hatch_fail(err, HATCH_BAD_INPUT, "fewer than 3 fields");
    for (int i = 0; i < THINGS; i++) {
        if (!hatch_text_is(thing, things[i].name))
            continue;
        if (!hatch_text_number(number, &value) || !(value >= things[i].low && value <= things[i].high))
            return hatch_fail(err, HATCH_BAD_INPUT, "%s: want a number from %g to %g", things[i].name, things[i].low,
                              things[i].high);
        reading->values[i] = fmax(reading->values[i], value);
        if (i != UNIT_PX)
            continue;
        if (!hatch_text_number(index, &part) || !(part >= 0 && part < HATCH_NEEDS_TONES && part == floor(part)))
            return hatch_fail(err, HATCH_BAD_INPUT, "unit-px: want an index from 0 to %u", HATCH_NEEDS_TONES - 1);
        reading->unit_px[(int)part] = value;
    }
    return HATCH_OK;
}

enum hatch_status hatch_needs_parse(struct hatch_bytes file, struct hatch_needs *needs, struct hatch_err *err)
{
    struct hatch_text rest = hatch_text_of(file), line;
    struct reading reading = {.values = {-1, -1, -1, 0}};
    if (!hatch_text_line(&rest, &line) || !hatch_text_is(line, HEADER))
        return hatch_fail(err, HATCH_BAD_INPUT, "no table of needs; render-gl SCENE --needs -o FILE makes one");
    for (uint32_t row = 2; hatch_text_line(&rest, &line); row++)
        if (line.length && parse_row(line, &reading, err) != HATCH_OK)
            return hatch_fail_at(err, "row %u: ", row);
    for (int i = 0; i < THINGS; i++)
        if (reading.values[i] < 0)
            return hatch_fail(err, HATCH_BAD_INPUT, "no row '%s'; render-gl SCENE --needs makes the file anew",
                              things[i].name);
    *needs = (struct hatch_needs){.tolerance = reading.values[TOLERANCE],
                                  .darkest = reading.values[DARKEST],
                                  .relative = reading.values[RELATIVE] > 0};
    memcpy(needs->unit_px, reading.unit_px, sizeof needs->unit_px);
    return HATCH_OK;
}

uint32_t hatch_needs_columns(const struct hatch_needs *needs, const float *targets, uint32_t tones)
{
    double tone = needs->darkest * (needs->relative ? (double)targets[tones - 1] : 1);
    uint32_t count = 1;
    while (count < tones && (double)targets[count - 1] < tone)
        count++;
    return count;
}

double hatch_needs_strokes(const struct hatch_needs *needs, const struct hatch_stroke_pen *pen, uint32_t families)
{
    double most = 0, darkest = hatch_stroke_darkest(pen, families);
    for (uint32_t f = 0; f < families; f++) {
        float tones[HATCH_STROKE_TONES];
        hatch_stroke_tones(pen, families, f, tones);
        for (uint32_t i = 0; i < HATCH_NEEDS_TONES; i++) {
            double ink = fmin((i + 1.0) / HATCH_NEEDS_TONES, needs->darkest) * (needs->relative ? darkest : 1);
            double tone = (double)tones[(uint32_t)ceil(ink * (HATCH_STROKE_TONES - 1))];
            most = fmax(most, needs->unit_px[i] * tone / (HATCH_STROKE_GAIN * hatch_stroke_whole_px(pen, tone)));
        }
    }
    return most;
}
