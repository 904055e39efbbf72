/* The OpenGL 4.5 core context: made by EGL without a window system, or by the window (window_open). Code that draws
 * need not know which. */
#ifndef RENDER_GPU_CONTEXT_H
#define RENDER_GPU_CONTEXT_H

#include <stdint.h>

#include "base/status.h"

/* Zeroed: no context. */
struct gpu_context {
    void *display, *handle;                     /* EGL display and context; with a window: NULL and the GLFWwindow */
    void (*close)(struct gpu_context *context); /* releases both; NULL: there is no context */
    const char *device;                         /* name of the device; owned by the driver */
    uint32_t size_max_px;                       /* largest side of a texture and of a viewport */
    float anisotropy_max;                       /* of texture filters; 1: the driver has isotropic filters only */
};

/* Makes a context without a window system and makes it current: on the first graphics device that EGL lists, else on
 * Mesa's surfaceless platform.
 *   threads  of Mesa's software renderer, at least 1
 * HATCH_IO without EGL, without a driver, or below OpenGL 4.5. */
enum hatch_status gpu_context_open_headless(struct gpu_context *context, uint32_t threads,
                                            struct hatch_err *err) HATCH_MUST_USE;

/* Fills in device and limits of the current context, and lets it read rows of texels without padding. For functions
 * that open contexts. HATCH_IO below OpenGL 4.5. */
enum hatch_status gpu_context_read_limits(struct gpu_context *context, struct hatch_err *err) HATCH_MUST_USE;

/* Releases the context; leaves *context zeroed. */
void gpu_context_close(struct gpu_context *context);

#endif
