#include "render-gl/context.h"

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

enum hatch_status context_open_window(struct context *context, uint32_t width, uint32_t height, struct hatch_err *err)
{
    if (!glfwInit())
        return hatch_fail(err, HATCH_IO,
                          "there is no display for a window; without --window the "
                          "picture goes to -o");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    context->window = glfwCreateWindow((int)width, (int)height, "render-gl", NULL, NULL);
    if (!context->window) {
        glfwTerminate();
        return hatch_fail(err, HATCH_IO, "the display has no OpenGL 4.5");
    }
    glfwMakeContextCurrent(context->window);
    glfwSwapInterval(1);
    return context_read_limits(context, err);
}

void context_close_window(struct context *context)
{
    glfwDestroyWindow(context->window);
    context->window = NULL;
    glfwTerminate();
}
