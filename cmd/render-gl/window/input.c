/* Keys and mouse, which change camera, light, technique and strokes. */
#include <math.h>

#include "math/angle.h"
#include "render-gl/window/window.h"

#define STEP_RAD 0.1     /* rotation of the camera per press of an arrow key */
#define HATCH_STEP_DEG 5 /* rotation of the strokes per key press */
#define HATCH_STEP 1.1   /* factor for the size of the strokes' pattern per key press */

static void say_keys(void)
{
    cmd_say("drag: turn; shift+drag or right button: pan; ctrl+drag: move the light");
    cmd_say("arrows: turn; wheel, + and -: move nearer and further; f: return to the first view");
    cmd_say("1 to 9: choose a technique; t: the next technique; space: pause or play the animation");
    cmd_say("p and P: choose the next or previous parameter, shown in the title; . and ,: increase and decrease it; "
            "d: reset it");
    cmd_say("[ and ]: turn the strokes; < and >: make their pattern smaller and larger");
    cmd_say("s: save a picture; l: show or hide lines; r: read --shader-dir again; ?: this list; q, escape: close");
    for (uint32_t i = 0; i < TECHNIQUE_COUNT; i++)
        cmd_say("%u %s: %s", i + 1, techniques[i]->name, techniques[i]->summary);
}

static uint32_t index_of(const struct technique *technique)
{
    uint32_t i = 0;
    while (techniques[i] && techniques[i] != technique)
        i++;
    return i;
}

/* Draws with a technique from now on. Returns false if something is missing for it, and says what. */
static bool set_technique(struct window *window, uint32_t index)
{
    struct job *job = window->job;
    const struct technique *technique = techniques[index];
    struct technique_instance *instance;
    const char *file;
    struct hatch_err err;
    if (!assets_have(&job->assets, technique->asset)) {
        cmd_say("%s needs %s: --tam FILE", technique->name, technique->asset->name);
        return false;
    }
    if (job_check(job, technique, &file, &err) != HATCH_OK || !(instance = job_open(job, technique, &err)) ||
        technique_prepare(&job->context, instance, &err) != HATCH_OK ||
        (window->own_changed && job_refresh(job, instance, 1u << PARAM_TECHNIQUE, &err) != HATCH_OK)) {
        cmd_say("%s", err.text);
        return false;
    }
    job_set_darkest(job, instance);
    options_style(job->options, &job->frame.style);
    window->instance = instance;
    window->title_s = 0;
    return true;
}

/* Goes on to the next technique that can be used. */
static void next_technique(struct window *window)
{
    uint32_t index = index_of(window->instance->technique);
    for (uint32_t i = 1; i < TECHNIQUE_COUNT; i++)
        if (set_technique(window, (index + i) % TECHNIQUE_COUNT))
            return;
}

static void reload(struct window *window)
{
    struct hatch_err err;
    if (gpu_programs_reload(&window->job->frame.programs, &err) != HATCH_OK)
        cmd_say("%s", err.text);
}

/* Changes --hatch-turn or --hatch-scale; both are uniforms, so nothing is recomputed. */
static void move_hatch(struct window *window, unsigned character)
{
    struct options *options = window->job->options;
    options->hatch_turn_deg += HATCH_STEP_DEG * ((character == ']') - (character == '['));
    options->hatch_scale *= pow(HATCH_STEP, (character == '>') - (character == '<'));
    options->hatch_scale = fmin(fmax(options->hatch_scale, 0.01), 100);
}

bool window_draws_lines(const struct window *window)
{
    bool asked = window->lines_on || window->job->options->lines_given;
    bool strokes = window->instance->technique->features & (TECHNIQUE_STROKES | TECHNIQUE_LINES);
    return window->job->has_lines && !window->lines_off && (strokes || asked);
}

/* Switches feature lines on or off; finds them on first use. */
static void toggle_lines(struct window *window)
{
    struct hatch_err err;
    window->lines_off = window_draws_lines(window);
    if (window->lines_off)
        return;
    if (!window->job->has_lines && job_make_lines(window->job, HATCH_LINES_ALL, &err) != HATCH_OK)
        cmd_say("%s", err.text);
    window->lines_on = true;
}

/* Moves the camera nearer or further. If the surface in the middle of the picture is much nearer than the point around
 * which the camera turns, that point is moved to the surface first, so that repeated zooming never passes through it.
 */
static void zoom(struct window *window, double factor)
{
    struct hatch_orbit *orbit = &window->orbit;
    const struct gpu_target *samples = &window->canvas.samples;
    const struct hatch_view *drawn = &window->job->frame.view;
    double shift = hatch_view_depth_shift(drawn);
    double depth = (double)gpu_target_read_depth(samples, samples->form.width / 2, samples->form.height / 2);
    double distance = depth > 0 ? (1 + shift) * drawn->near / (depth + shift) : INFINITY;
    if (!orbit->view.orthographic && distance < 0.5 * orbit->distance)
        hatch_orbit_set_distance(orbit, distance);
    hatch_orbit_zoom(orbit, factor);
    window->moved = window->stale = true;
}

static void on_character(GLFWwindow *handle, unsigned character)
{
    struct window *window = glfwGetWindowUserPointer(handle);
    window->stale = true;
    if (window_param_key(window, character))
        return;
    if (character >= '1' && character <= '9' && character < '1' + TECHNIQUE_COUNT)
        set_technique(window, character - '1');
    if (character == '?')
        say_keys();
    else if (character == '+' || character == '-')
        zoom(window, character == '+' ? 0.9 : 1 / 0.9);
    else if (character == 't')
        next_technique(window);
    else if (character == ' ')
        window->paused = !window->paused;
    else if (character == '[' || character == ']' || character == '<' || character == '>')
        move_hatch(window, character);
    else if (character == 'f')
        window->moved = false;
    else if (character == 's')
        window->save = true;
    else if (character == 'l')
        toggle_lines(window);
    else if (character == 'r')
        reload(window);
    else if (character == 'q')
        glfwSetWindowShouldClose(handle, GLFW_TRUE);
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
    window->drag = WINDOW_DRAG_NONE;
    if (action != GLFW_PRESS)
        return;
    window->drag = WINDOW_DRAG_TURN;
    if (button != GLFW_MOUSE_BUTTON_LEFT || modifiers & GLFW_MOD_SHIFT)
        window->drag = WINDOW_DRAG_PAN;
    else if (modifiers & GLFW_MOD_CONTROL)
        window->drag = WINDOW_DRAG_LIGHT;
}

static void on_pointer(GLFWwindow *handle, double x, double y)
{
    struct window *window = glfwGetWindowUserPointer(handle);
    int width, height;
    glfwGetWindowSize(handle, &width, &height);
    double right = (x - window->x) / fmax(height, 1), down = (y - window->y) / fmax(height, 1);
    window->x = x;
    window->y = y;
    if (window->drag == WINDOW_DRAG_NONE)
        return;
    window->stale = true;
    window->moved = window->moved || window->drag != WINDOW_DRAG_LIGHT;
    if (window->drag == WINDOW_DRAG_TURN)
        hatch_orbit_turn(&window->orbit, -4 * right, 4 * down);
    if (window->drag == WINDOW_DRAG_PAN)
        hatch_orbit_pan(&window->orbit, -right, down);
    if (window->drag == WINDOW_DRAG_LIGHT) {
        struct options *options = window->job->options;
        options->light_given = true;
        options->light_deg[0] += 4 * right / HATCH_RADIANS;
        options->light_deg[1] -= 4 * down / HATCH_RADIANS;
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
