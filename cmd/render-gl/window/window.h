/* What the window's files share: its state, and the hand of whoever sits before it. */
#ifndef RENDER_WINDOW_H
#define RENDER_WINDOW_H

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "render-gl/job.h"
#include "scene/orbit.h"

enum drag { DRAG_NONE, DRAG_TURN, DRAG_PAN, DRAG_LIGHT };

struct window {
    struct job *job;
    GLFWwindow *handle;
    struct target target;
    struct clock clock;
    struct hatch_orbit orbit;
    uint32_t technique, saved;
    uint32_t param, component;   /* that keys change; PARAM_NONE: none yet */
    double start[PARAMS_MAX][2]; /* what parameters were when they were first changed */
    bool has_start[PARAMS_MAX];
    enum drag drag;
    double x, y;           /* of the pointer */
    double time_s, last_s; /* of the animation; of the clock at the last frame */
    double way_s;          /* how long parameters have been on their way */
    double title_s;
    bool paused, stale, save, moved; /* moved: a hand has taken the camera */
};

/* Asks GLFW for keys, mouse and damage. */
void window_listen(struct window *window);

/* Keys that choose and change parameters; false for another character. */
bool window_param_key(struct window *window, unsigned character);

/* ", stroke [40]x2": the chosen parameter with brackets around the number that keys change; empty when the
 * technique does not use it. */
void window_param_text(const struct window *window, char *text, size_t size);

#endif
