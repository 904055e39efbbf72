/* The window: a hand on camera and light, techniques by number, saved pictures. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "render-gl/picture.h"
#include "render-gl/window/window.h"
#include "render-gl/words.h"

#define TITLE_EVERY_S 0.5
#define WAY_S 4 /* that --animate takes where the number of frames is not said */

static void resize(struct window *window)
{
    struct job *job = window->job;
    int width, height;
    glfwGetFramebufferSize(window->handle, &width, &height);
    uint32_t wide = width > 0 ? (uint32_t)width : 1, high = height > 0 ? (uint32_t)height : 1;
    if (window->target.width == wide && window->target.height == high)
        return;
    struct hatch_err err;
    target_free(&window->target);
    cmd_check(target_make(wide, high, job->options.side, &job->renderer.shaders, &window->target, &err), NULL, &err);
    job->options.width = wide;
    job->options.height = high;
    window->stale = true;
}

/* A window with somebody's view in it should not end because a folder is read-only. */
static bool can_save(const char *name)
{
    char folder[4096] = ".";
    const char *slash = strrchr(name, '/');
    if (slash && (size_t)(slash - name) + 1 < sizeof folder) {
        memcpy(folder, name, (size_t)(slash - name) + 1);
        folder[slash - name + 1] = '\0';
    }
    if (access(folder, W_OK) == 0)
        return true;
    cmd_say("%s cannot be saved: its folder is not there, or cannot be written to", name);
    return false;
}

/* Pictures are saved where -o says, else beside the user; the number grows with each. */
static void save(struct window *window, const struct hatch_view *view)
{
    struct job *job = window->job;
    const char *pattern = job->args.output ? job->args.output : "render-gl-%03d.png";
    struct hatch_arena *keep = &job->args.keep;
    struct hatch_arena_mark mark = hatch_arena_mark(keep);
    struct hatch_buffer file = {.arena = keep};
    struct hatch_image image;
    struct hatch_err err;
    char name[4096];
    words_frame_name(pattern, window->saved + 1, name, sizeof name);
    if (!can_save(name))
        return;
    window->saved++;
    cmd_check(hatch_image_make(keep, window->target.width, window->target.height, "RGB", &image, &err), NULL, &err);
    struct cmd_output *output = cmd_open_output(name, true);
    cmd_check(picture_draw(&job->renderer, window->technique, view, &window->target, &image, &err), NULL, &err);
    pictures_encode(name, &image, &job->args.scratch, &file);
    cmd_write(output, file.data, file.size);
    hatch_arena_rewind(keep, mark);
    cmd_say("saved %s", name);
}

/* Parameters on their way go forth and back. */
static void move_params(struct window *window)
{
    const struct options *options = &window->job->options;
    double whole_s = options->frames > 1 ? (options->frames - 1) / options->rate : WAY_S;
    double phase = fmod(window->way_s / whole_s, 2);
    struct hatch_err err;
    params_move(window->job, phase < 1 ? phase : 2 - phase);
    if (job_refresh(window->job, &err) != HATCH_OK)
        cmd_say("%s", err.text);
}

static void pose(struct window *window, struct hatch_view *view)
{
    struct job *job = window->job;
    double aspect = (double)window->target.width / window->target.height;
    struct hatch_err err;
    cmd_check(scene_set_pose(&job->gpu, job->span.animation, window->time_s, &job->args.scratch, &err), NULL, &err);
    if (!window->moved) {
        job_view(job, window->time_s, view);
        hatch_orbit_start(&window->orbit, view);
    }
    window->orbit.view.aspect = aspect;
    *view = window->orbit.view;
}

static void draw(struct window *window)
{
    struct job *job = window->job;
    struct hatch_view view;
    move_params(window);
    pose(window, &view);
    struct hatch_tile tile = {
        0, 0, window->target.width, window->target.height, window->target.width, window->target.height};
    double now_s = clock_now_s();
    bool timed = now_s - window->title_s > TITLE_EVERY_S;
    job->renderer.clock = timed ? &window->clock : NULL;
    struct hatch_err err;
    cmd_check(renderer_draw(&job->renderer, window->technique, &view, &tile, &window->target, &err), NULL, &err);
    job->renderer.clock = NULL;
    if (timed) {
        char title[160], param[96];
        window_param_text(window, param, sizeof param);
        snprintf(title, sizeof title, "render-gl: %s, %.1f ms%s", techniques[window->technique]->name,
                 window->clock.gpu_ms[0], param);
        glfwSetWindowTitle(window->handle, title);
        window->title_s = now_s;
    }
    target_present(&window->target);
    glfwSwapBuffers(window->handle);
    if (window->save)
        save(window, &view);
    window->stale = window->save = false;
}

void window_run(struct job *job)
{
    static struct window window;
    window = (struct window){.job = job,
                             .handle = job->context.window,
                             .technique = (uint32_t)job->options.technique,
                             .param = PARAM_NONE,
                             .time_s = job->options.time_s,
                             .last_s = clock_now_s(),
                             .stale = true};
    clock_make(&window.clock);
    window_listen(&window);
    while (!glfwWindowShouldClose(window.handle)) {
        bool moves = job->span.animation != HATCH_NONE || job->options.change_count;
        bool plays = moves && !window.paused;
        double now_s = clock_now_s();
        window.time_s += plays ? now_s - window.last_s : 0;
        window.way_s += plays ? now_s - window.last_s : 0;
        window.last_s = now_s;
        resize(&window);
        if (plays || window.stale)
            draw(&window);
        if (plays)
            glfwPollEvents();
        else
            glfwWaitEventsTimeout(0.25);
    }
    clock_free(&window.clock);
    target_free(&window.target);
}
