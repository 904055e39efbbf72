/* The OpenGL 4.5 core context: headless by EGL without a window system, or behind a GLFW window.
 * Everything after it is the same for both. */
#ifndef RENDER_CONTEXT_H
#define RENDER_CONTEXT_H

#include <stdint.h>

#include "base/status.h"

struct GLFWwindow;

struct context {
    void *egl_display, *egl_context; /* headless; else NULL */
    struct GLFWwindow *window;       /* behind a window; else NULL */
    const char *device;              /* what the driver calls itself */
    uint32_t size_max_px;            /* largest side of a texture and of a viewport */
    float anisotropy_max;            /* 1 where the driver has none */
};

/* Makes a context without a window system and makes it current: on a graphics device where EGL lists
 * one, else on Mesa's surfaceless platform. HATCH_IO with one sentence when there is no EGL, no driver
 * or no OpenGL 4.5. threads: of a software renderer, at least 1. */
enum hatch_status context_open_headless(struct context *context, uint32_t threads,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* The same behind a visible window. HATCH_IO when there is no display. width, height: in screen
 * units, at least 1. */
enum hatch_status context_open_window(struct context *context, uint32_t width, uint32_t height,
                                      struct hatch_err *err) HATCH_MUST_USE;

/* Reads the limits of the current context; both openers call it. HATCH_IO below OpenGL 4.5. */
enum hatch_status context_read_limits(struct context *context, struct hatch_err *err) HATCH_MUST_USE;

/* Releases the context, and its window. A zeroed struct is allowed. */
void context_close(struct context *context);

/* Closes what context_open_window made. */
void context_close_window(struct context *context);

#endif
