/* The OpenGL 4.5 core context: headless by EGL without a window system, or behind a window (window/glfw.h). All that is
 * done with it is the same for both. */
#ifndef RENDER_GPU_CONTEXT_H
#define RENDER_GPU_CONTEXT_H

#include <stdint.h>

#include "base/status.h"

/* Zeroed: no context. */
struct gpu_context {
    void *display, *handle;                     /* of the window system's interface */
    void (*close)(struct gpu_context *context); /* set by what opened it */
    const char *device;                         /* the driver's name for it; the driver's string */
    uint32_t size_max_px;                       /* largest side of a texture and of a viewport */
    float anisotropy_max;                       /* 1 where the driver has none */
};

/* Makes a context without a window system and makes it current: on a graphics device where EGL lists one, else on
 * Mesa's surfaceless platform. threads  of a software renderer, at least 1 HATCH_IO without EGL, a driver, or
 * OpenGL 4.5. */
enum hatch_status gpu_context_open_headless(struct gpu_context *context, uint32_t threads,
                                            struct hatch_err *err) HATCH_MUST_USE;

/* Reads the limits of the current context; for what opens one. HATCH_IO below OpenGL 4.5. */
enum hatch_status gpu_context_read_limits(struct gpu_context *context, struct hatch_err *err) HATCH_MUST_USE;

/* Releases the context. */
void gpu_context_close(struct gpu_context *context);

#endif
