#include "needs/needs.h"

#include <math.h>
#include <string.h>

#include "base/text.h"

#define HEADER "thing\tindex\tvalue\tunit"

/* Things that generators read. */
enum thing {
    TOLERANCE,
    RELATIVE,
    DARKEST,
    UNIT_PX,
    TEXELS,
    SOLID_PX,
    ITEM_PX,
    REGION_LOW,
    REGION_SIDE,
    REGION_CELLS,
    REGION_PX,
    THINGS
};

static const struct {
    const char *name;
    uint32_t count; /* of indices */
    double low, high;
    bool must; /* there must be a row */
} things[THINGS] = {
    [TOLERANCE] = {"tolerance", 1, 1e-6, 1, true},
    [RELATIVE] = {"relative", 1, 0, 1, true},
    [DARKEST] = {"darkest", 2, 0, 1, true},
    [UNIT_PX] = {"unit-px", HATCH_NEEDS_TONES, 0, 1e30, false},
    [TEXELS] = {"texels", HATCH_NEEDS_OCTAVES, 0, 1, false},
    [SOLID_PX] = {"solid-px", 1, 1, 1e6, false},
    [ITEM_PX] = {"item-px", UINT32_MAX, 0, 1e30, false},
    [REGION_LOW] = {"region-low", 3, -1e30, 1e30, true},
    [REGION_SIDE] = {"region-side", 3, 0, 1e30, true},
    [REGION_CELLS] = {"region-cells", 1, 0, HATCH_NEEDS_CELLS, true},
    [REGION_PX] = {"region-unit-px", HATCH_NEEDS_CELLS, 0, 1e30, false},
};

/* Values that were read. */
struct reading {
    bool found[THINGS];
    double values[REGION_PX][HATCH_NEEDS_TONES]; /* per thing and index */
    float *cells;                                /* of the regions; NULL: not read */
    uint32_t cell_rows;                          /* rows of cells, read or not */
};

static enum hatch_status parse_row(struct hatch_text line, struct reading *reading, struct hatch_err *err)
{
    struct hatch_text thing, index, number, unit;
    double value, at;
    int i = 0;
    if (!hatch_text_field(&line, &thing) || !hatch_text_field(&line, &index) || !hatch_text_field(&line, &number) ||
        !hatch_text_field(&line, &unit))
        return hatch_fail(err, HATCH_BAD_INPUT, "fewer than 4 fields");
    while (i < THINGS && !hatch_text_is(thing, things[i].name))
        i++;
    reading->cell_rows += i == REGION_PX;
    if (i == THINGS || (i == REGION_PX && !reading->cells))
        return HATCH_OK;
    if (!hatch_text_number(index, &at) || !(at >= 0 && at < things[i].count && at == floor(at)))
        return hatch_fail(err, HATCH_BAD_INPUT, "%s: want an index from 0 to %u", things[i].name, things[i].count - 1);
    if (!hatch_text_number(number, &value) || !(value >= things[i].low && value <= things[i].high))
        return hatch_fail(err, HATCH_BAD_INPUT, "%s: want a number from %g to %g", things[i].name, things[i].low,
                          things[i].high);
    reading->found[i] = true;
    if (i == ITEM_PX)
        reading->values[i][0] = fmax(reading->values[i][0], value);
    else if (i != REGION_PX)
        reading->values[i][(int)at] = value;
    else
        reading->cells[(uint32_t)at] = (float)value;
    return HATCH_OK;
}

enum hatch_status hatch_needs_parse(struct hatch_bytes file, float *cells, struct hatch_needs *needs,
                                    struct hatch_err *err)
{
    struct hatch_text rest = hatch_text_of(file), line;
    struct reading reading = {.cells = cells};
    if (cells)
        memset(cells, 0, HATCH_NEEDS_CELLS * sizeof *cells);
    if (!hatch_text_line(&rest, &line) || !hatch_text_is(line, HEADER))
        return hatch_fail(err, HATCH_BAD_INPUT, "no table of needs; render-gl SCENE --needs -o FILE makes one");
    for (uint32_t row = 2; hatch_text_line(&rest, &line); row++)
        if (line.length && parse_row(line, &reading, err) != HATCH_OK)
            return hatch_fail_at(err, "row %u: ", row);
    for (int i = 0; i < THINGS; i++)
        if (things[i].must && !reading.found[i])
            return hatch_fail(err, HATCH_BAD_INPUT, "no row '%s'; render-gl SCENE --needs makes the file anew",
                              things[i].name);
    if (reading.cell_rows != (uint32_t)reading.values[REGION_CELLS][0])
        return hatch_fail(err, HATCH_BAD_INPUT,
                          "%u rows '%s', not %g: the file was cut; render-gl SCENE --needs makes it anew",
                          reading.cell_rows, things[REGION_PX].name, reading.values[REGION_CELLS][0]);
    *needs = (struct hatch_needs){.tolerance = reading.values[TOLERANCE][0],
                                  .darkest = fmax(reading.values[DARKEST][0], reading.values[DARKEST][1]),
                                  .relative = reading.values[RELATIVE][0] > 0};
    memcpy(needs->unit_px, reading.values[UNIT_PX], sizeof needs->unit_px);
    memcpy(needs->texels, reading.values[TEXELS], sizeof needs->texels);
    memcpy(needs->regions.low, reading.values[REGION_LOW], sizeof needs->regions.low);
    memcpy(needs->regions.side, reading.values[REGION_SIDE], sizeof needs->regions.side);
    needs->regions.px = cells;
    needs->solid_px = reading.values[SOLID_PX][0];
    needs->item_px = reading.values[ITEM_PX][0];
    return HATCH_OK;
}

uint32_t hatch_needs_columns(const struct hatch_needs *needs, const float *targets, uint32_t tones, float darkest)
{
    double tone = needs->darkest * (needs->relative ? (double)darkest : 1);
    uint32_t count = 1;
    while (count < tones && (double)targets[count - 1] < tone)
        count++;
    return count;
}

/* Returns the greatest difference between the tones of each n-th column, of which the one before the first is paper. */
static double greatest_step(const float *targets, uint32_t tones, uint32_t n)
{
    double step = 0, before = 0;
    for (uint32_t i = n; i <= tones; i += n) {
        step = fmax(step, (double)targets[i - 1] - before);
        before = (double)targets[i - 1];
    }
    return step;
}

uint32_t hatch_needs_every(const struct hatch_needs *needs, const float *targets, uint32_t tones)
{
    double most = HATCH_NEEDS_COLUMN * needs->tolerance * (needs->relative ? (double)targets[tones - 1] : 1);
    uint32_t every = 1;
    while (tones % (2 * every) == 0 && tones / (2 * every) >= HATCH_NEEDS_COLUMNS &&
           greatest_step(targets, tones, 2 * every) <= most)
        every *= 2;
    return every;
}

uint32_t hatch_needs_size(const struct hatch_needs *needs, uint32_t size_px, uint32_t size_min_px)
{
    double finer = 0; /* share of the pixels that would read a finer level */
    uint32_t octave = HATCH_NEEDS_OCTAVES;
    while (octave > 0 && 1u << (octave - 1) >= size_px)
        finer += needs->texels[--octave];
    while (size_px / 2 >= size_min_px && octave > 0) {
        finer += needs->texels[--octave];
        if (finer > needs->tolerance)
            break;
        size_px /= 2;
    }
    return size_px;
}

uint32_t hatch_needs_tile(const struct hatch_needs *needs, uint32_t size_px, uint32_t size_min_px)
{
    for (uint32_t octave = 0; octave < HATCH_NEEDS_OCTAVES - 1; octave++)
        if (needs->texels[octave] > 0)
            return size_px;
    while (needs->item_px > 0 && size_px / 2 >= size_min_px && size_px / 2 >= needs->item_px / HATCH_NEEDS_PATCHES)
        size_px /= 2;
    return size_px;
}

uint32_t hatch_needs_slices(const struct hatch_needs *needs, uint32_t levels, uint32_t slices)
{
    const uint32_t halved = levels - 1;
    while (slices >> halved > 4 && HATCH_NEEDS_SLICE * needs->tolerance * (slices >> halved) >= 2)
        slices /= 2;
    return slices;
}

uint32_t hatch_needs_solid(const struct hatch_needs *needs, uint32_t size, uint32_t size_min)
{
    while (needs->solid_px > 0 && size / 2 >= size_min && HATCH_NEEDS_SOLID * size / 2 >= needs->solid_px)
        size /= 2;
    return size;
}

double hatch_needs_strokes(const struct hatch_needs *needs, double mesh_px, const struct hatch_stroke_pen *pen,
                           uint32_t families)
{
    double most = 0, darkest = hatch_stroke_darkest(pen, families);
    for (uint32_t f = 0; f < families; f++) {
        float tones[HATCH_STROKE_TONES];
        hatch_stroke_tones(pen, families, f, tones);
        for (uint32_t i = 0; i < HATCH_NEEDS_TONES; i++) {
            double ink = fmin((i + 1.0) / HATCH_NEEDS_TONES, needs->darkest) * (needs->relative ? darkest : 1);
            double tone = (double)tones[(uint32_t)ceil(ink * (HATCH_STROKE_TONES - 1))];
            double covered = fmin(needs->unit_px[i], mesh_px) * tone / HATCH_STROKE_GAIN;
            most = fmax(most, covered / hatch_stroke_whole_px(pen, tone));
        }
    }
    return most;
}
