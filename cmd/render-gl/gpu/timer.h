/* Times of passes: GL timer queries, and the wall clock around commands that are finished. */
#ifndef RENDER_GPU_TIMER_H
#define RENDER_GPU_TIMER_H

#include <epoxy/gl.h>
#include <stdbool.h>
#include <stdint.h>

#define GPU_TIMER_PASSES_MAX 12u

struct gpu_timer {
    GLuint queries[GPU_TIMER_PASSES_MAX + 1]; /* moments: the beginning, and the end of each pass */
    bool every_pass;                          /* the GPU finishes after each pass, so that their times are apart */
    uint32_t count;                           /* passes of the frame so far */
    double wall_begin_s;
    double gpu_ms[GPU_TIMER_PASSES_MAX], wall_ms[GPU_TIMER_PASSES_MAX];
    const char *names[GPU_TIMER_PASSES_MAX];
};

void gpu_timer_make(struct gpu_timer *timer);

/* timer may be NULL in these three: nothing is timed. */
void gpu_timer_begin(struct gpu_timer *timer);
/* Ends a pass that began where the one before it ended. */
void gpu_timer_end_pass(struct gpu_timer *timer, const char *name);
/* Waits for the GPU and fills the times; count is 1, the whole frame, unless every_pass. */
void gpu_timer_end(struct gpu_timer *timer);

void gpu_timer_free(struct gpu_timer *timer);

/* Seconds of a clock that only runs forward. */
double gpu_timer_now_s(void);

#endif
