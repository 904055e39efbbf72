#include "render-gl/gpu/timer.h"

#include <time.h>

static double seconds_of(clockid_t clock)
{
    struct timespec now;
    clock_gettime(clock, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

double gpu_timer_now_s(void)
{
    return seconds_of(CLOCK_MONOTONIC);
}

void gpu_timer_make(struct gpu_timer *timer)
{
    *timer = (struct gpu_timer){.count = 0};
    glCreateQueries(GL_TIMESTAMP, GPU_TIMER_PASSES_MAX + 1, timer->queries);
}

static void mark(struct gpu_timer *timer)
{
    glFinish();
    glQueryCounter(timer->queries[timer->count], GL_TIMESTAMP);
    glFinish();
}

void gpu_timer_begin(struct gpu_timer *timer)
{
    if (!timer)
        return;
    timer->count = 0;
    mark(timer);
    timer->cpu_begin_s = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
    timer->wall_begin_s = gpu_timer_now_s();
}

static void end_span(struct gpu_timer *timer, const char *name)
{
    glFinish();
    double now_s = gpu_timer_now_s();
    timer->names[timer->count] = name;
    timer->wall_ms[timer->count++] = 1e3 * (now_s - timer->wall_begin_s);
    mark(timer);
    timer->wall_begin_s = gpu_timer_now_s();
}

void gpu_timer_end_pass(struct gpu_timer *timer, const char *name)
{
    if (timer && timer->every_pass && timer->count < GPU_TIMER_PASSES_MAX)
        end_span(timer, name);
}

void gpu_timer_end(struct gpu_timer *timer)
{
    if (!timer)
        return;
    if (!timer->every_pass)
        end_span(timer, "frame");
    timer->sum_cpu_ms += 1e3 * (seconds_of(CLOCK_PROCESS_CPUTIME_ID) - timer->cpu_begin_s);
    GLuint64 before = 0;
    for (uint32_t i = 0; i <= timer->count; i++) {
        GLuint64 at = 0;
        glGetQueryObjectui64v(timer->queries[i], GL_QUERY_RESULT, &at);
        if (i > 0)
            timer->gpu_ms[i - 1] = 1e-6 * (double)(at - before);
        before = at;
    }
    for (uint32_t i = 0; i < timer->count; i++) {
        timer->sum_gpu_ms += timer->gpu_ms[i];
        timer->sum_wall_ms += timer->wall_ms[i];
    }
}

void gpu_timer_free(struct gpu_timer *timer)
{
    glDeleteQueries(GPU_TIMER_PASSES_MAX + 1, timer->queries);
}
