#include "render-gl/gpu/context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/load.h"

#ifdef __SANITIZE_ADDRESS__
/* Drivers hold memory until the process ends, but are unloaded before the leak check, so that suppressions cannot match
 * them by name. Programs that draw therefore turn leak detection off. */
int __lsan_is_turned_off(void);
int __lsan_is_turned_off(void)
{
    return 1;
}
#endif

#define DEVICES_MAX 16

/* Opens a library. libepoxy, which opens it again, aborts when it is missing or when memory does not suffice, so that
 * it is opened first, and stays open. */
static enum hatch_status open_library(const char *name, struct hatch_err *err)
{
    void *object;
    struct hatch_err why;
    enum hatch_status status = hatch_load(name, &object, &why);
    if (status == HATCH_IO)
        return hatch_fail(err, status, "%.200s: install EGL (libegl1) and OpenGL (libgl1-mesa-dri)", why.text);
    return status == HATCH_OK ? status : hatch_fail(err, status, "%s", why.text);
}

static void close_headless(struct gpu_context *context)
{
    eglMakeCurrent(context->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(context->display, context->handle);
    eglTerminate(context->display);
}

static bool make_current(struct gpu_context *context, EGLDisplay display)
{
    static const EGLint attributes[] = {
        EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, NULL, NULL))
        return false;
    EGLContext made = EGL_NO_CONTEXT;
    if (eglBindAPI(EGL_OPENGL_API))
        made = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (made == EGL_NO_CONTEXT || !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, made)) {
        if (made != EGL_NO_CONTEXT)
            eglDestroyContext(display, made);
        eglTerminate(display);
        return false;
    }
    context->display = display;
    context->handle = made;
    context->close = close_headless;
    return true;
}

/* EGL_EXT_device_base is the older form of EGL_EXT_device_enumeration and EGL_EXT_device_query; drivers name either. */
static bool lists_devices(const char *extensions)
{
    return epoxy_extension_in_string(extensions, "EGL_EXT_device_base") ||
           epoxy_extension_in_string(extensions, "EGL_EXT_device_enumeration");
}

/* Opens the first hardware device. Mesa's list of devices also contains its software renderer, which is skipped. */
static bool open_hardware(struct gpu_context *context, const char *extensions)
{
    EGLDeviceEXT devices[DEVICES_MAX];
    EGLint count = 0;
    if (!epoxy_extension_in_string(extensions, "EGL_EXT_platform_device") || !lists_devices(extensions) ||
        !eglQueryDevicesEXT(DEVICES_MAX, devices, &count))
        return false;
    for (EGLint i = 0; i < count; i++) {
        const char *kind = eglQueryDeviceStringEXT(devices[i], EGL_EXTENSIONS);
        if (!kind || epoxy_extension_in_string(kind, "EGL_MESA_device_software"))
            continue;
        if (make_current(context, eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], NULL)))
            return true;
    }
    return false;
}

static bool open_surfaceless(struct gpu_context *context, const char *extensions)
{
    return epoxy_extension_in_string(extensions, "EGL_MESA_platform_surfaceless") &&
           make_current(context, eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL));
}

enum hatch_status gpu_context_read_limits(struct gpu_context *context, struct hatch_err *err)
{
    if (epoxy_gl_version() < 45)
        return hatch_fail(err, HATCH_IO, "the driver has OpenGL %d.%d, OpenGL 4.5 is needed", epoxy_gl_version() / 10,
                          epoxy_gl_version() % 10);
    GLint texture = 0, viewport[2] = {0, 0};
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
    GLint least = viewport[0] < viewport[1] ? viewport[0] : viewport[1];
    context->size_max_px = (uint32_t)(texture < least ? texture : least);
    context->anisotropy_max = 1.0f;
    if (epoxy_has_gl_extension("GL_ARB_texture_filter_anisotropic") ||
        epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic"))
        glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY, &context->anisotropy_max);
    context->device = (const char *)glGetString(GL_RENDERER);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    return HATCH_OK;
}

enum hatch_status gpu_context_open_headless(struct gpu_context *context, uint32_t threads, struct hatch_err *err)
{
    char number[16];
    HATCH_TRY(open_library("libEGL.so.1", err));
    HATCH_TRY(open_library("libGL.so.1", err));
    /* Keeps Mesa from printing messages about devices that it has no permission to open. */
    setenv("EGL_LOG_LEVEL", "fatal", 0);
    /* Mesa's software renderer reads its number of threads from this variable only. */
    snprintf(number, sizeof number, "%u", threads);
    setenv("LP_NUM_THREADS", number, 1);
    const char *extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!extensions || (!open_hardware(context, extensions) && !open_surfaceless(context, extensions)))
        return hatch_fail(err, HATCH_IO,
                          "EGL finds no OpenGL 4.5 driver that works without a "
                          "display: install libgl1-mesa-dri");
    return gpu_context_read_limits(context, err);
}

void gpu_context_close(struct gpu_context *context)
{
    if (context->close)
        context->close(context);
    *context = (struct gpu_context){0};
}
