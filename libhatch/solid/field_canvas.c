/* Canvas: threads that pass over and under each other on every slice across an axis. */
#include "solid/field.h"

#define OVER 0.6f /* weight of what lies on top, against the threads themselves */

enum { STREAM_THREADS = 0x636c6f74 };

struct state {
    const struct hatch_solid_style *style;
    struct hatch_noise noise;
    struct hatch_noise_octaves unevenness;
};

static float canvas(const void *context, const float at[3])
{
    const struct state *state = context;
    float whole[3], half[3], height = 0;
    for (int i = 0; i < 3; i++) {
        float turns = state->style->threads * at[i];
        whole[i] = hatch_noise_cosine(turns); /* 1 in the middle of a thread, -1 between two */
        half[i] = hatch_noise_cosine(turns / 2);
    }
    /* Products of two have the same mean on all slices. Where threads cross, the product of the halves is 1 or -1 by
     * turns, and one of the threads lies on top: it is as high beside the crossing. */
    for (int i = 0; i < 3; i++) {
        int next = (i + 1) % 3;
        height += whole[i] * whole[next] + OVER * half[i] * half[next] * (whole[next] - whole[i]);
    }
    float uneven = state->style->vary * hatch_noise_sum(&state->unevenness, at, false);
    return 0.5f + height / 6 + uneven;
}

enum hatch_status solid_canvas_field(const struct solid_job *job, struct solid_field *field, struct hatch_err *err)
{
    struct state *state;
    HATCH_TRY(HATCH_ALLOC(job->arena, &state, 1, err));
    uint32_t threads = (uint32_t)job->style->threads, cells[3] = {threads, threads, threads};
    state->style = job->style;
    hatch_noise_make(job->seed, &state->noise);
    state->unevenness =
        hatch_noise_octaves_make(&state->noise, job->seed, STREAM_THREADS, cells, job->size / 2, 2, 0.6f);
    *field = (struct solid_field){canvas, state, 0};
    return HATCH_OK;
}
