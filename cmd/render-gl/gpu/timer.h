/* Times of a frame and of its passes, by GL timer queries and by the wall clock. */
#ifndef RENDER_GPU_TIMER_H
#define RENDER_GPU_TIMER_H

#include <epoxy/gl.h>
#include <stdbool.h>
#include <stdint.h>

#define GPU_TIMER_PASSES_MAX 24u

struct gpu_timer {
    GLuint queries[GPU_TIMER_PASSES_MAX + 1]; /* time stamps: start of the frame, end of each pass */
    bool every_pass;     /* set by the caller: each pass is timed, and the GPU finishes after each; false: the frame */
    uint32_t count;      /* passes timed so far; after gpu_timer_end: valid entries of the arrays below */
    double wall_begin_s; /* start of the current pass, gpu_timer_now_s */
    double gpu_ms[GPU_TIMER_PASSES_MAX], wall_ms[GPU_TIMER_PASSES_MAX]; /* milliseconds */
    const char *names[GPU_TIMER_PASSES_MAX];                            /* string literals */
    double cpu_begin_s;                         /* processor time of the process at the start of the frame */
    double sum_gpu_ms, sum_wall_ms, sum_cpu_ms; /* of all frames that have ended since the caller set them to 0 */
};

/* Makes the queries; gpu_timer_free releases them. */
void gpu_timer_make(struct gpu_timer *timer);

/* Starts timing a frame. If timer is NULL, this function and the next two do nothing. */
void gpu_timer_begin(struct gpu_timer *timer);
/* Ends a pass, which began where the previous one ended. Does nothing without every_pass.
 *   name  string literal, kept by reference */
void gpu_timer_end_pass(struct gpu_timer *timer, const char *name);
/* Ends a frame: waits for the GPU and sets gpu_ms. Without every_pass there is one entry, "frame". */
void gpu_timer_end(struct gpu_timer *timer);

void gpu_timer_free(struct gpu_timer *timer);

/* Returns the seconds of a monotonic clock. */
double gpu_timer_now_s(void);

#endif
