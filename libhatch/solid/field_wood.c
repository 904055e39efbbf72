/* Wood: growth rings, as nearly flat layers that noise bends, and fibres along the trunk. */
#include "solid/field.h"

enum { STREAM_BEND = 0x776f6f64, STREAM_YEARS, STREAM_FIBERS, STREAM_PORES };

struct state {
    const struct hatch_solid_style *style;
    struct hatch_noise noise;
    uint32_t axes[3]; /* those across the trunk, the first of which crosses the rings, and that of the trunk */
    struct hatch_noise_octaves bend, years, fibers, pores;
};

static float wood(const void *context, const float at[3])
{
    const struct state *state = context;
    const struct hatch_solid_style *style = state->style;
    float bend = hatch_noise_sum(&state->bend, at, false), years = hatch_noise_sum(&state->years, at, false);
    float fiber = hatch_noise_sum(&state->fibers, at, false), pore = hatch_noise_sum(&state->pores, at, false);
    float phase =
        style->rings * at[state->axes[0]] + 2 * style->warp * bend + 1.2f * years + 0.1f * style->grain * fiber;
    float year = hatch_noise_fraction(phase);
    /* Early wood is light and darkens until the winter, after which the next ring begins. */
    float late = year * year * (1 - hatch_noise_step((year - 0.9f) / 0.1f));
    float pores = hatch_noise_step((pore - 0.25f) * 5) * (1 - 0.5f * year);
    return 0.85f - 0.6f * late + style->grain * (0.35f * fiber - 0.35f * pores) + 0.3f * years;
}

enum hatch_status solid_wood_field(const struct solid_job *job, struct solid_field *field, struct hatch_err *err)
{
    const struct hatch_solid_style *style = job->style;
    struct state *state;
    HATCH_TRY(HATCH_ALLOC(job->arena, &state, 1, err));
    state->style = style;
    hatch_noise_make(job->seed, &state->noise);
    for (uint32_t i = 0; i < 3; i++)
        state->axes[i] = (style->axis + 2 - i) % 3;
    uint32_t scale = (uint32_t)style->scale, fibers = (uint32_t)style->fibers, along = state->axes[2],
             max = job->size / 2;
    uint32_t bend[3] = {scale, scale, scale}, years[3] = {1, 1, 1}, fine[3] = {fibers, fibers, fibers};
    bend[along] = (scale + 1) / 2;
    years[state->axes[0]] = ((uint32_t)style->rings + 2) / 3;
    fine[along] = (fibers + 15) / 16;
    state->bend = hatch_noise_octaves_make(&state->noise, job->seed, STREAM_BEND, bend, max, 2, 0.35f);
    state->years = hatch_noise_octaves_make(&state->noise, job->seed, STREAM_YEARS, years, max, 2, 0.5f);
    state->fibers = hatch_noise_octaves_make(&state->noise, job->seed, STREAM_FIBERS, fine, max, 2, 0.6f);
    state->pores = hatch_noise_octaves_make(&state->noise, job->seed, STREAM_PORES, fine, max, 1, 1);
    *field = (struct solid_field){wood, state, 0};
    return HATCH_OK;
}
