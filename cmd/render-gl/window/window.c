/* The window's loop over frames, and saving of pictures. */
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "render-gl/mode/modes.h"
#include "render-gl/mode/parse_args.h"
#include "render-gl/scene/pose.h"
#include "render-gl/window/window.h"

#define TITLE_EVERY_S 0.5 /* time between updates of the title */
#define MOVING_S 4        /* time in which --animate goes from A to B if --frames is not given */

static void resize(struct window *window)
{
    struct job *job = window->job;
    int width, height;
    glfwGetFramebufferSize(window->handle, &width, &height);
    uint32_t wide = width > 0 ? (uint32_t)width : 1, high = height > 0 ? (uint32_t)height : 1;
    if (window->canvas.width == wide && window->canvas.height == high)
        return;
    uint32_t side = job->options->side;
    enum hatch_status status;
    struct hatch_err err;
    canvas_free(&window->canvas);
    while ((status = canvas_make(wide, high, side, &job->frame.programs, &window->canvas, &err)) == HATCH_LIMIT &&
           side > 1)
        side--;
    cmd_check(status, NULL, &err);
    if (side < job->options->side)
        cmd_say("the window is drawn with %u %s: the GPU cannot draw so many pixels with %u", side * side,
                cmd_plural(side * side, "sample", "samples"), job->options->side * job->options->side);
    window->stale = true;
}

static struct picture picture_of(struct window *window)
{
    struct picture picture = job_picture(window->job, window->instance);
    picture.draws_lines = window_draws_lines(window);
    return picture;
}

/* Returns whether the folder of a file can be written to. This is checked first, because a failed write ends the
 * command, and the user's view is lost. */
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
    cmd_say("%s cannot be saved: its folder does not exist or is read-only", name);
    return false;
}

/* Writes the name of a saved picture: that of -o, or one in the current folder, with a number in its field, or before
 * its ending if it has no field. */
static void name_picture(const char *output, uint32_t number, char *name, size_t size_bytes)
{
    const char *pattern = output ? output : "render-gl-%03d.png";
    if (parse_has_frame(pattern)) {
        parse_frame_name(pattern, number, name, size_bytes);
        return;
    }
    const char *slash = strrchr(pattern, '/'), *dot = strrchr(slash ? slash : pattern, '.');
    size_t stem = dot ? (size_t)(dot - pattern) : strlen(pattern);
    snprintf(name, size_bytes, "%.*s-%03u%s", (int)stem, pattern, number, pattern + stem);
}

/* Saves the picture under the first number, after that of the last one, whose name is free. */
static void save(struct window *window, const struct hatch_view *view)
{
    struct job *job = window->job;
    struct hatch_arena *keep = &job->args.keep;
    struct hatch_arena_mark mark = hatch_arena_mark(keep);
    struct hatch_buffer file = {.arena = keep};
    struct hatch_image image;
    struct hatch_err err;
    char name[4096];
    uint32_t number = window->saved;
    do
        name_picture(job->args.output, ++number, name, sizeof name);
    while (access(name, F_OK) == 0);
    if (!can_save(name))
        return;
    window->saved = number;
    cmd_check(hatch_image_make(keep, window->canvas.width, window->canvas.height, "RGB", &image, &err), NULL, &err);
    struct cmd_output *output = cmd_open_output(name, "png exr", true);
    const struct picture picture = picture_of(window);
    cmd_check(picture_draw(&picture, view, &window->canvas, &image, &err), NULL, &err);
    pictures_encode(name, &image, &job->args.scratch, &file);
    cmd_write(output, file.data, file.size);
    hatch_arena_rewind(keep, mark);
    cmd_say("saved %s", name);
}

/* Moves the parameters of --animate back and forth between their ends. */
static void move_params(struct window *window)
{
    struct job *job = window->job;
    const struct options *options = job->options;
    double whole_s = options->frames > 1 ? (options->frames - 1) / options->rate : MOVING_S;
    struct hatch_err err;
    uint32_t subjects = params_move(options, params_swing(window->moving_s, whole_s));
    if (job_refresh(job, window->instance, subjects, &err) != HATCH_OK)
        cmd_say("%s", err.text);
}

static void pose(struct window *window, struct hatch_view *view)
{
    struct job *job = window->job;
    double aspect = (double)window->canvas.width / window->canvas.height;
    struct hatch_err err;
    cmd_check(scene_set_pose(&job->scene, job->span.animation, window->time_s, &job->args.scratch, &err), NULL, &err);
    if (!window->moved) {
        job_view(job, window->time_s, view);
        hatch_orbit_start(&window->orbit, view);
    }
    window->orbit.view.aspect = aspect;
    *view = window->orbit.view;
}

static void set_title(struct window *window, double now_s)
{
    char title[160], param[96];
    window_param_text(window, param, sizeof param);
    snprintf(title, sizeof title, "render-gl: %s, %.1f ms%s", window->instance->technique->name,
             window->timer.gpu_ms[0], param);
    glfwSetWindowTitle(window->handle, title);
    window->title_s = now_s;
}

static void draw(struct window *window)
{
    struct job *job = window->job;
    struct hatch_view view;
    struct hatch_err err;
    move_params(window);
    pose(window, &view);
    const struct hatch_tile tile = {
        0, 0, window->canvas.width, window->canvas.height, window->canvas.width, window->canvas.height};
    const struct picture picture = picture_of(window);
    double now_s = gpu_timer_now_s();
    bool timed = now_s - window->title_s > TITLE_EVERY_S;
    job->frame.timer = timed ? &window->timer : NULL;
    cmd_check(picture_draw_tile(&picture, &view, &tile, &window->canvas, &err), NULL, &err);
    job->frame.timer = NULL;
    if (timed)
        set_title(window, now_s);
    canvas_present(&window->canvas);
    glfwSwapBuffers(window->handle);
    if (window->save)
        save(window, &view);
    window->stale = window->save = false;
}

void window_run(struct job *job)
{
    static struct window window;
    struct hatch_err err;
    window = (struct window){.job = job,
                             .handle = job->gpu.handle,
                             .instance = job_open(job, job->options->technique, &err),
                             .time_s = job->options->time_s,
                             .last_s = gpu_timer_now_s(),
                             .stale = true};
    gpu_timer_make(&window.timer);
    cmd_show_warnings();
    window_listen(&window);
    while (!glfwWindowShouldClose(window.handle)) {
        bool moves = job->span.animation != HATCH_NONE || job->options->change_count;
        bool plays = moves && !window.paused;
        double now_s = gpu_timer_now_s();
        window.time_s += plays ? now_s - window.last_s : 0;
        window.moving_s += plays ? now_s - window.last_s : 0;
        window.last_s = now_s;
        resize(&window);
        if (plays || window.stale)
            draw(&window);
        if (plays)
            glfwPollEvents();
        else
            glfwWaitEventsTimeout(0.25);
    }
    gpu_timer_free(&window.timer);
    canvas_free(&window.canvas);
}
