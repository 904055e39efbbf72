/* How dark layers are at each amount of them, from samples of a tile at an integer depth. Stroke by stroke
 * over the samples that it covers, so that a style may change from frame to frame. */
#include <math.h>

#include "seed/rptam_parts.h"

#define SIDE 128u /* samples along the tile's side */
#define SAMPLES ((size_t)SIDE * SIDE)
#define STEPS HATCH_RPTAM_STEPS

struct tone {
    const struct hatch_rptam *rptam;
    const struct hatch_rptam_layer *layer;
    double (*paper)[STEPS]; /* SAMPLES: what is left of it at each amount */
};

struct shown {
    double at[2];
    double of_tile[4]; /* of its ink is there, if it stands in that one of four tiles */
    double of_step[STEPS];
};

static void find_shares(const struct tone *tone, uint32_t seed, struct shown *stroke)
{
    const struct hatch_rptam_layer *layer = tone->layer;
    stroke->at[0] = (double)layer->places[seed].u * 0x1p-64;
    stroke->at[1] = (double)layer->places[seed].v * 0x1p-64;
    for (uint8_t tile = 0; tile < 4; tile++)
        stroke->of_tile[tile] = hatch_rptam_depth_weight(tone->rptam, layer, seed, tile, 0);
    for (uint32_t step = 0; step < STEPS; step++)
        stroke->of_step[step] = hatch_rptam_tone_weight(tone->rptam, layer, seed, step / (STEPS - 1.0));
}

static void put_sample(const struct tone *tone, const struct shown *stroke, uint8_t tile, const double d[2],
                       double paper[STEPS])
{
    double whole = stroke->of_tile[tile], tile_px = tone->rptam->style.tile_px;
    double ink = hatch_rptam_stroke_ink(tone->rptam, tone->layer, d, tile_px, whole);
    if (!(ink > 0))
        return; /* nor would a smaller or paler one reach here */
    if (!tone->rptam->style.fade_size) {
        for (uint32_t step = 0; step < STEPS; step++)
            paper[step] *= 1 - ink * stroke->of_step[step];
        return;
    }
    for (uint32_t step = 0; step < STEPS; step++) {
        double share = stroke->of_step[step];
        paper[step] *= 1 - (share < 1 ? hatch_rptam_stroke_ink(tone->rptam, tone->layer, d, tile_px, whole * share)
                                      : ink);
    }
}

/* The samples of one row, which stands d_v from the stroke's middle. */
static void put_row(const struct tone *tone, const struct shown *stroke, const double span[2], int64_t row,
                    double d_v)
{
    int64_t first = (int64_t)ceil((stroke->at[0] + span[0]) * SIDE - 0.5);
    int64_t last = (int64_t)floor((stroke->at[0] + span[1]) * SIDE - 0.5);
    for (int64_t column = first; column <= last && column < first + SIDE; column++) {
        const double d[2] = {((double)column + 0.5) / SIDE - stroke->at[0], d_v};
        int64_t x = (column + SIDE) % SIDE, y = (row + SIDE) % SIDE;
        /* In a tile beside that of the samples: an odd one, on whichever side. */
        uint8_t tile = (uint8_t)(2 * (row != y) + (column != x));
        put_sample(tone, stroke, tile, d, tone->paper[y * SIDE + x]);
    }
}

static void put_stroke(const struct tone *tone, uint32_t seed)
{
    const struct hatch_rptam_style *style = &tone->rptam->style;
    const struct hatch_coverage_stroke outline = {style->length_px / style->tile_px, style->width_px / style->tile_px,
                                                  tone->layer->cosine, tone->layer->sine};
    double reach = 1 / style->tile_px, limit = 0.5, span[2];
    struct shown stroke;
    find_shares(tone, seed, &stroke);
    int64_t first = (int64_t)ceil((stroke.at[1] - limit) * SIDE - 0.5);
    for (int64_t row = first; row < first + SIDE; row++) {
        double d_v = ((double)row + 0.5) / SIDE - stroke.at[1];
        if (hatch_coverage_span(&outline, d_v, reach, limit, span))
            put_row(tone, &stroke, span, row, d_v);
    }
}

static void read_darkness(const struct tone *tone, double darkness[STEPS])
{
    double sum[STEPS] = {0};
    for (size_t i = 0; i < SAMPLES; i++)
        for (uint32_t step = 0; step < STEPS; step++)
            sum[step] += 1 - tone->paper[i][step];
    for (uint32_t step = 0; step < STEPS; step++)
        darkness[step] = sum[step] / SAMPLES;
}

enum hatch_status hatch_rptam_measure(struct hatch_rptam *rptam, struct hatch_arena *scratch, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    double *paper = HATCH_NEW(scratch, double, SAMPLES * STEPS, err);
    if (!paper)
        return HATCH_LIMIT;
    struct tone tone = {rptam, NULL, (double (*)[STEPS])paper};
    for (size_t i = 0; i < SAMPLES; i++)
        paper[i * STEPS + STEPS - 1] = 1;
    for (uint32_t k = 0; k < rptam->layer_count; k++) {
        tone.layer = &rptam->layers[k];
        for (size_t i = 0; i < SAMPLES; i++) /* below it lies all of the one before */
            for (uint32_t step = 0; step + 1 < STEPS; step++)
                tone.paper[i][step] = tone.paper[i][STEPS - 1];
        for (uint32_t seed = 0; seed < tone.layer->count; seed++)
            put_stroke(&tone, seed);
        read_darkness(&tone, rptam->layers[k].darkness);
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
