/* Kinds made of noise: perlin, turbulence, marble and paper. */
#include "solid/field.h"

enum { STREAM_OCTAVES = 0x6f637461, STREAM_FIBERS = 0x66696272, STREAM_CURL = 0x6375726c };

#define STRETCH 6u  /* length of a fibre of paper over its width */
#define FAMILIES 6u /* of fibres, along the diagonals of the sides of the cube */
#define CURL 0.5f   /* how far noise displaces fibres, in their widths */

struct state {
    const struct hatch_solid_style *style;
    struct hatch_noise noise;
    struct hatch_noise_octaves octaves;
    struct hatch_noise_octaves fibers[FAMILIES], curl; /* of paper */
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
    const struct hatch_solid_style *style = state->style;
    float bumps = hatch_noise_sum(&state->octaves, at, false), fiber = -1;
    float curl = CURL / style->scale * hatch_noise_sum(&state->curl, at, false);
    for (uint32_t i = 0; i < FAMILIES; i++) {
        uint32_t x = i % 3, y = (x + 1) % 3;
        float sign = i < 3 ? 1 : -1;
        /* Sums and differences of two coordinates repeat with the cube, too. */
        const float place[3] = {at[x] + sign * at[y], at[x] - sign * at[y] + curl, at[(x + 2) % 3] - curl};
        fiber = fmaxf(fiber, 0.15f - fabsf(hatch_noise_sum(&state->fibers[i], place, false)));
    }
    return 0.5f + (1 - style->grain) * bumps + style->grain * 2 * fiber;
}

/* Makes the fibres of paper. */
static void make_fibers(const struct solid_job *job, struct state *state)
{
    uint32_t scale = (uint32_t)job->style->scale, across = (scale * 2 + 2) / 3, cells_max = job->size / 2;
    const uint32_t fibers[3] = {(across + STRETCH - 1) / STRETCH, across, scale}, wide = (scale + 3) / 4;
    const uint32_t curl[3] = {wide, wide, wide};
    for (uint32_t i = 0; i < FAMILIES; i++)
        state->fibers[i] =
            hatch_noise_octaves_make(&state->noise, job->seed, STREAM_FIBERS + i, fibers, cells_max, 1, 1);
    state->curl = hatch_noise_octaves_make(&state->noise, job->seed, STREAM_CURL, curl, cells_max, 1, 1);
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
    make_fibers(job, state);
    field->state = state;
    field->value = style->kind == HATCH_SOLID_PERLIN       ? perlin
                   : style->kind == HATCH_SOLID_TURBULENCE ? turbulence
                   : style->kind == HATCH_SOLID_MARBLE     ? marble
                                                           : paper;
    return HATCH_OK;
}
