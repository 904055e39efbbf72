#include "render-gl/clock.h"

#include <time.h>

double clock_now_s(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

void clock_make(struct clock *clock)
{
    *clock = (struct clock){.count = 0};
    glCreateQueries(GL_TIMESTAMP, CLOCK_PASSES_MAX + 1, clock->queries);
}

static void mark(struct clock *clock)
{
    glFinish();
    glQueryCounter(clock->queries[clock->count], GL_TIMESTAMP);
    glFinish();
}

void clock_begin_frame(struct clock *clock)
{
    clock->count = 0;
    mark(clock);
    clock->wall_begin_s = clock_now_s();
}

static void end_span(struct clock *clock, const char *name)
{
    glFinish();
    double now_s = clock_now_s();
    clock->names[clock->count] = name;
    clock->wall_ms[clock->count++] = 1e3 * (now_s - clock->wall_begin_s);
    mark(clock);
    clock->wall_begin_s = clock_now_s();
}

void clock_end_pass(struct clock *clock, const char *name)
{
    if (clock && clock->every_pass && clock->count < CLOCK_PASSES_MAX)
        end_span(clock, name);
}

void clock_end_frame(struct clock *clock)
{
    if (!clock->every_pass)
        end_span(clock, "frame");
    GLuint64 before = 0;
    for (uint32_t i = 0; i <= clock->count; i++) {
        GLuint64 at = 0;
        glGetQueryObjectui64v(clock->queries[i], GL_QUERY_RESULT, &at);
        if (i > 0)
            clock->gpu_ms[i - 1] = 1e-6 * (double)(at - before);
        before = at;
    }
}

void clock_free(struct clock *clock)
{
    glDeleteQueries(CLOCK_PASSES_MAX + 1, clock->queries);
}
