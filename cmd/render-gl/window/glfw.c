/* The OpenGL context behind a window. */
#include "render-gl/window/window.h"

static void close_window(struct gpu_context *context)
{
    glfwDestroyWindow(context->handle);
    glfwTerminate();
}

enum hatch_status window_open(struct gpu_context *context, uint32_t width, uint32_t height, struct hatch_err *err)
{
#ifdef GLFW_PLATFORM
    /* X11, which Wayland desktops have as Xwayland: libwayland prints a message where there is no display. */
    glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
    if (!glfwInit())
        return hatch_fail(err, HATCH_IO,
                          "there is no display for a window: without --window the picture is written to -o");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    context->handle = glfwCreateWindow((int)width, (int)height, "render-gl", NULL, NULL);
    if (!context->handle) {
        glfwTerminate();
        return hatch_fail(err, HATCH_IO, "the display has no OpenGL 4.5");
    }
    context->close = close_window;
    glfwMakeContextCurrent(context->handle);
    glfwSwapInterval(1);
    return gpu_context_read_limits(context, err);
}
