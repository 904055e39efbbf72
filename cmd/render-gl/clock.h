/* How long passes take: GL timer queries, and the wall clock around commands that are finished. */
#ifndef RENDER_CLOCK_H
#define RENDER_CLOCK_H

#include <epoxy/gl.h>
#include <stdbool.h>
#include <stdint.h>

#define CLOCK_PASSES_MAX 12u

struct clock {
    GLuint queries[CLOCK_PASSES_MAX + 1]; /* moments: the begin, and the end of each pass */
    bool every_pass;                      /* the GPU finishes after each pass, so that their times are apart */
    uint32_t count;                       /* passes of the frame so far */
    double wall_begin_s;
    double gpu_ms[CLOCK_PASSES_MAX], wall_ms[CLOCK_PASSES_MAX];
    const char *names[CLOCK_PASSES_MAX];
};

void clock_make(struct clock *clock);
void clock_begin_frame(struct clock *clock);
/* Ends a pass that began where the one before ended. clock may be NULL. */
void clock_end_pass(struct clock *clock, const char *name);
/* Waits for the GPU and fills the times; count is 1, the whole frame, unless every_pass. */
void clock_end_frame(struct clock *clock);
void clock_free(struct clock *clock);

/* Seconds of a clock that only runs forward. */
double clock_now_s(void);

#endif
