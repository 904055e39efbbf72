/* The OpenGL 4.5 core context. It is made by EGL without a window system, or by the window (window_open); code that
 * draws need not know which. */
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
    float anisotropy_max; /* greatest anisotropy of filters; 1: the driver has isotropic ones only */
};

/* Makes a context without a window system and makes it current: on the first graphics device that EGL lists, else on
 * Mesa's surfaceless platform.
 *   threads  number of threads for Mesa's software renderer, at least 1
 * HATCH_IO without EGL, without a driver, or below OpenGL 4.5. */
enum hatch_status gpu_context_open_headless(struct gpu_context *context, uint32_t threads,
                                            struct hatch_err *err) HATCH_MUST_USE;

/* Reads device and limits of the current context into *context, and lets GL read rows of texels without padding. Called
 * by functions that open contexts. HATCH_IO below OpenGL 4.5. */
enum hatch_status gpu_context_read_limits(struct gpu_context *context, struct hatch_err *err) HATCH_MUST_USE;

/* Releases the context; leaves *context zeroed. */
void gpu_context_close(struct gpu_context *context);

#endif
