#include "lapped/atlas.h"

#include <assert.h>

static enum hatch_status build(const struct hatch_lapped_input *input, const struct hatch_lapped *lapped, double margin,
                               struct hatch_arena *scratch, float *texcoords, double *scale, struct hatch_err *err)
{
    struct hatch_charts charts;
    HATCH_TRY(hatch_charts_make(input->surface, lapped, input->outline, scratch, &charts, err));
    double *sizes, *corners;
    HATCH_TRY(HATCH_ALLOC(scratch, &sizes, 2 * (size_t)charts.count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &corners, 2 * (size_t)charts.count, err));
    for (uint32_t c = 0; c < charts.count; c++)
        for (uint32_t i = 0; i < 2; i++)
            sizes[2 * c + i] = charts.boxes[c][2 + i] - charts.boxes[c][i];
    double side;
    HATCH_TRY(hatch_charts_pack(sizes, charts.count, margin, scratch, corners, &side, err));
    for (size_t i = 0; i < 6 * (size_t)input->surface->face_count; i++) {
        uint32_t chart = charts.chart_of[i / 6];
        double in_chart = charts.positions[i] - charts.boxes[chart][i % 2];
        texcoords[i] = (float)((corners[2 * (size_t)chart + i % 2] + in_chart) / side);
    }
    *scale = 1 / side;
    return HATCH_OK;
}

enum hatch_status hatch_lapped_atlas(const struct hatch_lapped_input *input, const struct hatch_lapped *lapped,
                                     double margin, struct hatch_arena *scratch, float *texcoords, double *scale,
                                     struct hatch_err *err)
{
    assert(margin >= 0);
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = build(input, lapped, margin, scratch, texcoords, scale, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}
