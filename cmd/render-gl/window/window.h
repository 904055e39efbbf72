/* The window: its state, which its files share. */
#ifndef RENDER_WINDOW_WINDOW_H
#define RENDER_WINDOW_WINDOW_H

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "render-gl/mode/job.h"
#include "view/orbit.h"

#define WINDOW_PARAMS_MAX 32u

enum window_drag { WINDOW_DRAG_NONE, WINDOW_DRAG_TURN, WINDOW_DRAG_PAN, WINDOW_DRAG_LIGHT };

struct window {
    struct job *job;
    GLFWwindow *handle;
    struct canvas canvas;
    struct gpu_timer timer;
    struct hatch_orbit orbit;
    struct technique_instance *instance; /* what is drawn with */
    uint32_t saved;                      /* pictures */
    bool has_param;                      /* a parameter has been chosen, for keys to change: */
    uint32_t param, component;           /* its number, and which of its numbers */
    double start[WINDOW_PARAMS_MAX][2];  /* of each parameter, before its first change */
    bool has_start[WINDOW_PARAMS_MAX];
    bool lines_off, lines_on; /* a key has switched feature lines off; on, for every technique */
    enum window_drag drag;
    double x, y;           /* of the pointer */
    double time_s, last_s; /* of the animation; of the clock at the last frame */
    double moving_s;       /* how long parameters of --animate have been moving */
    double title_s;
    bool paused, stale, save;
    bool moved; /* keys or mouse have moved the camera */
};

/* Opens a context behind a visible window. width, height: in screen units, at least 1. HATCH_IO when there is no
 * display. */
enum hatch_status window_open(struct gpu_context *context, uint32_t width, uint32_t height,
                              struct hatch_err *err) HATCH_MUST_USE;

/* Shows the job until the window is closed. */
void window_run(struct job *job);

/* Subscribes to keys, mouse and damage. */
void window_listen(struct window *window);

/* Whether feature lines are drawn over its technique. */
bool window_draws_lines(const struct window *window);

/* Keys that choose and change parameters; false for another character. */
bool window_param_key(struct window *window, unsigned character);

/* Writes ", stroke [40]x2": the chosen parameter, with brackets around the number that keys change; empty where the
 * technique does not use it. */
void window_param_text(const struct window *window, char *text, size_t size);

#endif
