/* The window of --window: its state, shared by the files of this folder. */
#ifndef RENDER_WINDOW_WINDOW_H
#define RENDER_WINDOW_WINDOW_H

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "render-gl/mode/job.h"
#include "view/orbit_control.h"

#define WINDOW_PARAMS_MAX 32u

enum window_drag { WINDOW_DRAG_NONE, WINDOW_DRAG_TURN, WINDOW_DRAG_PAN, WINDOW_DRAG_LIGHT };

struct window {
    struct job *job;
    GLFWwindow *handle;
    struct canvas canvas;
    struct gpu_timer timer;
    struct hatch_orbit orbit;
    struct technique_instance *instance; /* draws the frames */
    uint32_t saved;                      /* number of pictures saved */
    bool has_param;                      /* a parameter is chosen for keys to change */
    uint32_t param, component;           /* index of that parameter (params_at), and which of its values, 0 or 1 */
    double start[WINDOW_PARAMS_MAX][2];  /* per parameter: its values before the first change */
    bool start_given[WINDOW_PARAMS_MAX]; /* per parameter: its option was given then */
    bool has_start[WINDOW_PARAMS_MAX];   /* per parameter: start is set */
    bool own_changed;      /* options of a technique have changed, which others may share that were opened before */
    bool lines_off;        /* a key has switched feature lines off */
    bool lines_on;         /* a key has switched them on, for all techniques */
    enum window_drag drag; /* effect of moving the pointer now */
    double x, y;           /* position of the pointer, in GLFW's screen coordinates */
    double time_s;         /* time of the animation */
    double last_s;         /* clock at the last frame, gpu_timer_now_s */
    double moving_s;       /* total time for which the parameters of --animate have moved */
    double title_s;        /* clock at the last update of the title */
    bool paused;
    bool stale; /* the picture must be drawn again */
    bool save;  /* the next frame is also saved as a picture */
    bool moved; /* keys or mouse have moved the camera */
};

/* Opens a visible window with an OpenGL context.
 *   width, height  in GLFW's screen coordinates, at least 1
 * HATCH_IO without a display or without OpenGL 4.5. */
enum hatch_status window_open(struct gpu_context *context, uint32_t width, uint32_t height,
                              struct hatch_err *err) HATCH_MUST_USE;

/* Draws frames until the window is closed. */
void window_run(struct job *job);

/* Installs the callbacks for keys, the mouse and requests to redraw.
 *   window  kept by reference */
void window_listen(struct window *window);

/* Returns whether feature lines are drawn now. */
bool window_draws_lines(const struct window *window);

/* Handles a character if its key chooses or changes parameters; else returns false. */
bool window_param_key(struct window *window, unsigned character);

/* Writes the chosen parameter with brackets around the value that keys change, as in ", stroke [40]x2". Writes an empty
 * text if no parameter is chosen or the technique does not use it.
 *   size  size of text, in bytes */
void window_param_text(const struct window *window, char *text, size_t size);

#endif
