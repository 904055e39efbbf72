/* Kinds made of noise: perlin, turbulence, marble and paper. */
#include "solid/field.h"

enum { STREAM_OCTAVES = 0x6f637461, STREAM_FIBERS = 0x66696272 };

#define STRETCH 6u /* length of a fibre of paper over its width */

struct state {
    const struct hatch_solid_style *style;
    struct hatch_noise noise;
    struct hatch_noise_octaves octaves;
    struct hatch_noise_octaves fibers[3]; /* of paper, along x, y and z */
};

static float perlin(const void *context, const float at[3])
{
    const struct state *state = context;
    return 0.5f + 0.8f * hatch_noise_sum(&state->octaves, at, false);
}

static float turbulence(const void *context, const float at[3])
{
    const struct state *state = context;
    return 2 * hatch_noise_sum(&state->octaves, at, true);
}

static float marble(const void *context, const float at[3])
{
    const struct state *state = context;
    const struct hatch_solid_style *style = state->style;
    float turns = 2 * style->warp * hatch_noise_sum(&state->octaves, at, true);
    for (int i = 0; i < 3; i++)
        turns += style->veins[i] * at[i];
    /* A vein is where the cosine is 1; a high power of its height above -1 is narrow. */
    float height = 0.5f + 0.5f * hatch_noise_cosine(turns), vein = height;
    for (int i = 1; i < (int)style->sharpness; i++)
        vein *= height;
    return 1 - vein - (vein * height - vein) * (style->sharpness - floorf(style->sharpness));
}

static float paper(const void *context, const float at[3])
{
    const struct state *state = context;
    float bumps = hatch_noise_sum(&state->octaves, at, false), fiber = -1;
    for (int i = 0; i < 3; i++)
        fiber = fmaxf(fiber, 0.2f - fabsf(hatch_noise_sum(&state->fibers[i], at, false)));
    return 0.5f + (1 - state->style->grain) * bumps + state->style->grain * 2 * fiber;
}

enum hatch_status solid_noise_field(const struct solid_job *job, struct solid_field *field, struct hatch_err *err)
{
    const struct hatch_solid_style *style = job->style;
    struct state *state;
    HATCH_TRY(HATCH_ALLOC(job->arena, &state, 1, err));
    uint32_t scale = (uint32_t)style->scale, cells[3] = {scale, scale, scale}, cells_max = job->size / 2;
    state->style = style;
    hatch_noise_make(job->seed, &state->noise);
    state->octaves = hatch_noise_octaves_make(&state->noise, job->seed, STREAM_OCTAVES, cells, cells_max,
                                              (uint32_t)style->octaves, style->gain);
    for (uint32_t i = 0; i < 3; i++) {
        uint32_t fibers[3] = {scale, scale, scale};
        fibers[i] = (scale + STRETCH - 1) / STRETCH;
        state->fibers[i] =
            hatch_noise_octaves_make(&state->noise, job->seed, STREAM_FIBERS + i, fibers, cells_max, 1, 1);
    }
    field->state = state;
    field->value = style->kind == HATCH_SOLID_PERLIN       ? perlin
                   : style->kind == HATCH_SOLID_TURBULENCE ? turbulence
                   : style->kind == HATCH_SOLID_MARBLE     ? marble
                                                           : paper;
    return HATCH_OK;
}
