/* Keys and mouse: what they do to camera, light, technique and strokes. */
#include <math.h>

#include "render-gl/window/window.h"

#define STEP_RAD 0.1
#define HATCH_STEP_RAD (3.14159265358979324 / 36)
#define HATCH_STEP 1.1

static void say_keys(void)
{
    cmd_say("drag: turn; shift+drag or right button: pan; ctrl+drag: move the light");
    cmd_say("arrows: turn; wheel, + and -: nearer and further; f: the view of the start");
    cmd_say("1 to 9, t: technique, the next; space: pause or play the animation");
    cmd_say("p and P: choose a parameter, which the title shows; . and ,: more and less of it; d: as it was");
    cmd_say("[ and ]: turn the strokes; < and >: make their pattern smaller and larger");
    cmd_say("s: save a picture; l: lines; r: read --shader-dir again; ?: these lines; q, escape: close");
    for (uint32_t i = 0; i < TECHNIQUE_CHOICES; i++)
        cmd_say("%u %s: %s", i + 1, techniques[i]->name, techniques[i]->summary);
}

static void set_technique(struct window *window, uint32_t technique)
{
    struct job *job = window->job;
    struct hatch_err err;
    if (!renderer_can(&job->renderer, technique)) {
        cmd_say("%s needs %s: --tam FILE", techniques[technique]->name, columns_name(techniques[technique]->columns));
        return;
    }
    bool strokes = technique_draws_strokes(techniques[technique]);
    if (techniques[technique]->seeds && !job->renderer.rptam)
        job_read_seeds(job);
    if ((strokes && load_check_texcoords(&job->scene, &err) != HATCH_OK) ||
        renderer_prepare(&job->renderer, technique, &job->args.scratch, &err) != HATCH_OK) {
        cmd_say("%s", err.text);
        return;
    }
    window->technique = technique;
    window->title_s = 0;
}

static void reload(struct window *window)
{
    struct hatch_err err;
    if (renderer_reload(&window->job->renderer, &err) != HATCH_OK)
        cmd_say("%s", err.text);
}

/* Strokes lie otherwise on their surfaces at once: nothing is computed anew. */
static void move_hatch(struct window *window, unsigned character)
{
    struct style *style = &window->job->renderer.style;
    style->hatch_turn_rad += HATCH_STEP_RAD * ((character == ']') - (character == '['));
    style->hatch_scale *= pow(HATCH_STEP, (character == '>') - (character == '<'));
    style->hatch_scale = fmin(fmax(style->hatch_scale, 0.01), 100);
}

/* Lines that were never wanted are found now. */
static void toggle_lines(struct window *window)
{
    struct job *job = window->job;
    struct renderer *renderer = &job->renderer;
    struct hatch_err err;
    bool strokes = technique_draws_strokes(techniques[window->technique]);
    if (renderer->lines && (strokes || renderer->lines->style.asked)) {
        renderer->lines = NULL;
        return;
    }
    if (job->lines.scene)
        renderer->lines = &job->lines;
    else if (job_make_lines(job, HATCH_LINES_ALL, &err) != HATCH_OK)
        cmd_say("%s", err.text);
    job->lines.style.asked = true;
}

/* Nearer and further. A surface that the middle of the picture shows close by is what counts from then on:
 * however often one zooms, it stays before the eye. */
static void zoom(struct window *window, double factor)
{
    struct hatch_orbit *orbit = &window->orbit;
    double depth = (double)target_middle_depth(&window->target);
    double distance = depth > 0 ? window->job->renderer.near.plane / depth : INFINITY;
    if (!orbit->view.orthographic && distance < 0.5 * orbit->distance)
        hatch_orbit_look_at(orbit, distance);
    hatch_orbit_zoom(orbit, factor);
    window->moved = window->stale = true;
}

static void on_character(GLFWwindow *handle, unsigned character)
{
    struct window *window = glfwGetWindowUserPointer(handle);
    window->stale = true;
    if (window_param_key(window, character))
        return;
    if (character >= '1' && character <= '9' && character < '1' + TECHNIQUE_CHOICES)
        set_technique(window, character - '1');
    switch (character) {
    case '?':
        say_keys();
        break;
    case '+':
        zoom(window, 0.9);
        break;
    case '-':
        zoom(window, 1 / 0.9);
        break;
    case 't':
        set_technique(window, window->technique + 1 < TECHNIQUE_CHOICES ? window->technique + 1 : 0);
        break;
    case ' ':
        window->paused = !window->paused;
        break;
    case '[':
    case ']':
    case '<':
    case '>':
        move_hatch(window, character);
        break;
    case 'f':
        window->moved = false;
        break;
    case 's':
        window->save = true;
        break;
    case 'l':
        toggle_lines(window);
        break;
    case 'r':
        reload(window);
        break;
    case 'q':
        glfwSetWindowShouldClose(handle, GLFW_TRUE);
        break;
    }
}

static void on_key(GLFWwindow *handle, int key, int scancode, int action, int modifiers)
{
    struct window *window = glfwGetWindowUserPointer(handle);
    double step = modifiers & GLFW_MOD_SHIFT ? 0.2 * STEP_RAD : STEP_RAD;
    (void)scancode;
    if (action == GLFW_RELEASE)
        return;
    if (key == GLFW_KEY_ESCAPE)
        glfwSetWindowShouldClose(handle, GLFW_TRUE);
    double azimuth = (key == GLFW_KEY_RIGHT) - (key == GLFW_KEY_LEFT);
    double elevation = (key == GLFW_KEY_UP) - (key == GLFW_KEY_DOWN);
    if (azimuth != 0 || elevation != 0) {
        hatch_orbit_turn(&window->orbit, step * azimuth, step * elevation);
        window->moved = window->stale = true;
    }
}

static void on_button(GLFWwindow *handle, int button, int action, int modifiers)
{
    struct window *window = glfwGetWindowUserPointer(handle);
    window->drag = DRAG_NONE;
    if (action != GLFW_PRESS)
        return;
    window->drag = DRAG_TURN;
    if (button != GLFW_MOUSE_BUTTON_LEFT || modifiers & GLFW_MOD_SHIFT)
        window->drag = DRAG_PAN;
    else if (modifiers & GLFW_MOD_CONTROL)
        window->drag = DRAG_LIGHT;
}

static void on_pointer(GLFWwindow *handle, double x, double y)
{
    struct window *window = glfwGetWindowUserPointer(handle);
    int width, height;
    glfwGetWindowSize(handle, &width, &height);
    double right = (x - window->x) / fmax(height, 1), down = (y - window->y) / fmax(height, 1);
    window->x = x;
    window->y = y;
    if (window->drag == DRAG_NONE)
        return;
    window->stale = true;
    window->moved = window->moved || window->drag != DRAG_LIGHT;
    if (window->drag == DRAG_TURN)
        hatch_orbit_turn(&window->orbit, -4 * right, 4 * down);
    if (window->drag == DRAG_PAN)
        hatch_orbit_pan(&window->orbit, -right, down);
    if (window->drag == DRAG_LIGHT) {
        struct own_light *light = &window->job->renderer.style.light;
        light->wanted = true;
        light->azimuth_rad += 4 * right;
        light->elevation_rad -= 4 * down;
    }
}

static void on_wheel(GLFWwindow *handle, double x, double y)
{
    struct window *window = glfwGetWindowUserPointer(handle);
    (void)x;
    zoom(window, pow(0.9, y));
}

static void on_damage(GLFWwindow *handle)
{
    struct window *window = glfwGetWindowUserPointer(handle);
    window->stale = true;
}

void window_listen(struct window *window)
{
    GLFWwindow *handle = window->handle;
    glfwSetWindowUserPointer(handle, window);
    glfwSetCharCallback(handle, on_character);
    glfwSetKeyCallback(handle, on_key);
    glfwSetMouseButtonCallback(handle, on_button);
    glfwSetCursorPosCallback(handle, on_pointer);
    glfwSetScrollCallback(handle, on_wheel);
    glfwSetWindowRefreshCallback(handle, on_damage);
}
