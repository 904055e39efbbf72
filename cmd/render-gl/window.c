/* The window: a hand on camera and light, techniques by number, saved pictures. */
#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "render-gl/job.h"
#include "render-gl/orbit.h"
#include "render-gl/picture.h"
#include "render-gl/words.h"

#define TITLE_EVERY_S 0.5
#define STEP_RAD 0.1
#define HATCH_STEP_RAD (3.14159265358979324 / 36)
#define HATCH_STEP 1.1

enum drag { DRAG_NONE, DRAG_TURN, DRAG_PAN, DRAG_LIGHT };

struct window {
    struct job *job;
    GLFWwindow *handle;
    struct target target;
    struct clock clock;
    struct orbit orbit;
    uint32_t technique, saved;
    enum drag drag;
    double x, y;           /* of the pointer */
    double time_s, last_s; /* of the animation; of the clock at the last frame */
    double title_s;
    bool paused, stale, save, moved; /* moved: a hand has taken the camera */
};

static void say_keys(void)
{
    cmd_say("drag: turn; shift+drag or right button: pan; ctrl+drag: move the light");
    cmd_say("arrows: turn; wheel, + and -: nearer and further; f: the view of the start");
    cmd_say("1 to %u, t: technique; space: pause or play the animation", TECHNIQUE_CHOICES);
    cmd_say("[ and ]: turn the strokes; < and >: make their pattern smaller and larger");
    cmd_say("s: save a picture; l: lines; r: read --shader-dir again; ?: these lines; q, escape: close");
    for (uint32_t i = 0; i < TECHNIQUE_CHOICES; i++)
        cmd_say("%u %s: %s", i + 1, techniques[i]->name, techniques[i]->summary);
}

static void set_technique(struct window *window, uint32_t technique)
{
    struct job *job = window->job;
    struct hatch_err err;
    if (techniques[technique]->columns != COLUMNS_NONE && !job->renderer.map) {
        cmd_say("%s needs a tonal art map: --tam FILE", techniques[technique]->name);
        return;
    }
    bool strokes = technique_draws_strokes(techniques[technique]);
    if (techniques[technique]->seeds && !job->renderer.rptam)
        job_read_seeds(job);
    if ((strokes && load_check_texcoords(&job->scene, &err) != HATCH_OK) ||
        renderer_prepare(&job->renderer, technique, &job->args.scratch, &err) != HATCH_OK) {
        cmd_say("%s", err.text);
        return;
    }
    window->technique = technique;
    window->title_s = 0;
}

static void reload(struct window *window)
{
    struct hatch_err err;
    if (renderer_reload(&window->job->renderer, &err) != HATCH_OK)
        cmd_say("%s", err.text);
}

/* Strokes lie otherwise on their surfaces at once: nothing is computed anew. */
static void move_hatch(struct window *window, unsigned character)
{
    struct style *style = &window->job->renderer.style;
    style->hatch_turn_rad += HATCH_STEP_RAD * ((character == ']') - (character == '['));
    style->hatch_scale *= pow(HATCH_STEP, (character == '>') - (character == '<'));
    style->hatch_scale = fmin(fmax(style->hatch_scale, 0.01), 100);
}

/* Lines that were never wanted are found now. */
static void toggle_lines(struct window *window)
{
    struct job *job = window->job;
    struct renderer *renderer = &job->renderer;
    struct hatch_err err;
    bool strokes = techniques[window->technique]->columns != COLUMNS_NONE;
    if (renderer->lines && (strokes || renderer->lines->style.asked)) {
        renderer->lines = NULL;
        return;
    }
    if (job->lines.scene)
        renderer->lines = &job->lines;
    else if (job_make_lines(job, LINES_ALL, &err) != HATCH_OK)
        cmd_say("%s", err.text);
    job->lines.style.asked = true;
}

static void on_character(GLFWwindow *handle, unsigned character)
{
    struct window *window = glfwGetWindowUserPointer(handle);
    window->stale = true;
    if (character >= '1' && character < '1' + TECHNIQUE_CHOICES)
        set_technique(window, character - '1');
    switch (character) {
    case '?':
        say_keys();
        break;
    case '+':
        orbit_zoom(&window->orbit, 0.9);
        window->moved = true;
        break;
    case '-':
        orbit_zoom(&window->orbit, 1 / 0.9);
        window->moved = true;
        break;
    case 't':
        set_technique(window, window->technique + 1 < TECHNIQUE_CHOICES ? window->technique + 1 : 0);
        break;
    case ' ':
        window->paused = !window->paused;
        break;
    case '[':
    case ']':
    case '<':
    case '>':
        move_hatch(window, character);
        break;
    case 'f':
        window->moved = false;
        break;
    case 's':
        window->save = true;
        break;
    case 'l':
        toggle_lines(window);
        break;
    case 'r':
        reload(window);
        break;
    case 'q':
        glfwSetWindowShouldClose(handle, GLFW_TRUE);
        break;
    }
}

static void on_key(GLFWwindow *handle, int key, int scancode, int action, int modifiers)
{
    struct window *window = glfwGetWindowUserPointer(handle);
    double step = modifiers & GLFW_MOD_SHIFT ? 0.2 * STEP_RAD : STEP_RAD;
    (void)scancode;
    if (action == GLFW_RELEASE)
        return;
    if (key == GLFW_KEY_ESCAPE)
        glfwSetWindowShouldClose(handle, GLFW_TRUE);
    double azimuth = (key == GLFW_KEY_RIGHT) - (key == GLFW_KEY_LEFT);
    double elevation = (key == GLFW_KEY_UP) - (key == GLFW_KEY_DOWN);
    if (azimuth != 0 || elevation != 0) {
        orbit_turn(&window->orbit, step * azimuth, step * elevation);
        window->moved = window->stale = true;
    }
}

static void on_button(GLFWwindow *handle, int button, int action, int modifiers)
{
    struct window *window = glfwGetWindowUserPointer(handle);
    window->drag = DRAG_NONE;
    if (action != GLFW_PRESS)
        return;
    window->drag = DRAG_TURN;
    if (button != GLFW_MOUSE_BUTTON_LEFT || modifiers & GLFW_MOD_SHIFT)
        window->drag = DRAG_PAN;
    else if (modifiers & GLFW_MOD_CONTROL)
        window->drag = DRAG_LIGHT;
}

static void on_pointer(GLFWwindow *handle, double x, double y)
{
    struct window *window = glfwGetWindowUserPointer(handle);
    int width, height;
    glfwGetWindowSize(handle, &width, &height);
    double right = (x - window->x) / fmax(height, 1), down = (y - window->y) / fmax(height, 1);
    window->x = x;
    window->y = y;
    if (window->drag == DRAG_NONE)
        return;
    window->stale = true;
    window->moved = window->moved || window->drag != DRAG_LIGHT;
    if (window->drag == DRAG_TURN)
        orbit_turn(&window->orbit, -4 * right, 4 * down);
    if (window->drag == DRAG_PAN)
        orbit_pan(&window->orbit, -right, down);
    if (window->drag == DRAG_LIGHT) {
        struct own_light *light = &window->job->renderer.style.light;
        light->wanted = true;
        light->azimuth_rad += 4 * right;
        light->elevation_rad -= 4 * down;
    }
}

static void on_wheel(GLFWwindow *handle, double x, double y)
{
    struct window *window = glfwGetWindowUserPointer(handle);
    (void)x;
    orbit_zoom(&window->orbit, pow(0.9, y));
    window->moved = window->stale = true;
}

static void on_damage(GLFWwindow *handle)
{
    struct window *window = glfwGetWindowUserPointer(handle);
    window->stale = true;
}

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
    cmd_check(target_make(wide, high, job->options.side, &job->renderer.shaders, &window->target,
                          &err),
              NULL, &err);
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
static void save(struct window *window, const struct view *view)
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
    cmd_check(hatch_image_make(keep, window->target.width, window->target.height, "RGB", &image,
                               &err),
              NULL, &err);
    struct cmd_output *output = cmd_open_output(name, true);
    cmd_check(picture_draw(&job->renderer, window->technique, view, &window->target, &image, &err),
              NULL, &err);
    pictures_encode(name, &image, &job->args.scratch, &file);
    cmd_write(output, file.data, file.size);
    hatch_arena_rewind(keep, mark);
    cmd_say("saved %s", name);
}

static void pose(struct window *window, struct view *view)
{
    struct job *job = window->job;
    double aspect = (double)window->target.width / window->target.height;
    struct hatch_err err;
    cmd_check(scene_set_pose(&job->gpu, job->span.animation, window->time_s, &job->args.scratch,
                             &err),
              NULL, &err);
    if (!window->moved) {
        job_view(job, window->time_s, view);
        orbit_start(&window->orbit, view);
    }
    window->orbit.view.aspect = aspect;
    *view = window->orbit.view;
}

static void draw(struct window *window)
{
    struct job *job = window->job;
    struct view view;
    pose(window, &view);
    struct tile tile = {0, 0, window->target.width, window->target.height, window->target.width,
                        window->target.height};
    double now_s = clock_now_s();
    bool timed = now_s - window->title_s > TITLE_EVERY_S;
    job->renderer.clock = timed ? &window->clock : NULL;
    struct hatch_err err;
    cmd_check(renderer_draw(&job->renderer, window->technique, &view, &tile, &window->target, &err),
              NULL, &err);
    job->renderer.clock = NULL;
    if (timed) {
        char title[128];
        snprintf(title, sizeof title, "render-gl: %s, %.1f ms", techniques[window->technique]->name,
                 window->clock.gpu_ms[0]);
        glfwSetWindowTitle(window->handle, title);
        window->title_s = now_s;
    }
    target_present(&window->target);
    glfwSwapBuffers(window->handle);
    if (window->save)
        save(window, &view);
    window->stale = window->save = false;
}

static void listen(struct window *window)
{
    GLFWwindow *handle = window->handle;
    glfwSetWindowUserPointer(handle, window);
    glfwSetCharCallback(handle, on_character);
    glfwSetKeyCallback(handle, on_key);
    glfwSetMouseButtonCallback(handle, on_button);
    glfwSetCursorPosCallback(handle, on_pointer);
    glfwSetScrollCallback(handle, on_wheel);
    glfwSetWindowRefreshCallback(handle, on_damage);
}

void window_run(struct job *job)
{
    static struct window window;
    window = (struct window){.job = job,
                             .handle = job->context.window,
                             .technique = (uint32_t)job->options.technique,
                             .time_s = job->options.time_s,
                             .last_s = clock_now_s(),
                             .stale = true};
    clock_make(&window.clock);
    listen(&window);
    while (!glfwWindowShouldClose(window.handle)) {
        bool plays = job->span.animation != HATCH_NONE && !window.paused;
        double now_s = clock_now_s();
        if (plays)
            window.time_s += now_s - window.last_s;
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
