/* Parameters in the window: keys choose a value and change it. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "render-gl/window/window.h"

/* Returns whether keys can change a parameter. A parameter that is 0 and changes by factors is switched off; factors
 * cannot switch it on. */
static bool is_available(const struct window *window, const struct param *param)
{
    double values[2];
    params_get(param, values);
    return param->subject != PARAM_CAMERA && (values[0] > 0 || !param->by_factor) &&
           params_are_used(param, window->instance->technique, window->job->has_lines && !window->lines_off);
}

static uint32_t count_all(void)
{
    struct param param;
    uint32_t count = 0;
    while (params_at(count, &param))
        count++;
    return count;
}

/* Chooses the next or previous value among all values of the available parameters. */
static void choose(struct window *window, bool back)
{
    uint32_t count = 2 * count_all();
    uint32_t at = !window->has_param ? (back ? 0 : count - 1) : 2 * window->param + window->component;
    for (uint32_t i = 0; i < count; i++) {
        struct param param;
        at = (at + (back ? count - 1 : 1)) % count;
        params_at(at / 2, &param);
        if (is_available(window, &param) && at % 2 < params_count(&param)) {
            window->has_param = true;
            window->param = at / 2;
            window->component = at % 2;
            return;
        }
    }
}

/* Returns the value after a key press. It stays within the range of the option; a value that the mouse has moved out of
 * that range can only be moved back. */
static double stepped(double value, bool more, const struct param *param)
{
    double change = more ? 1 : -1;
    double next = param->by_factor ? value * pow(param->step, change) : value + param->step * change;
    if (fabs(next) < 1e-9) /* rounding error of decimal steps */
        next = 0;
    return more ? fmin(next, fmax(param->option->maximum, value)) : fmax(next, fmin(param->option->minimum, value));
}

static void change(struct window *window, const struct param *param, unsigned character)
{
    double values[2] = {0}, *start = window->start[window->param];
    bool *given = param->option->given, *start_given = &window->start_given[window->param];
    struct hatch_err err;
    params_get(param, values);
    if (!window->has_start[window->param]) {
        memcpy(start, values, sizeof values);
        *start_given = given && *given;
    }
    window->has_start[window->param] = true;
    if (character == 'd')
        memcpy(values, start, sizeof values);
    else
        values[window->component] = stepped(values[window->component], character == '.', param);
    bool is_new = params_set(param, values);
    /* An option that was not given at the start has no effect again: --light replaces the lights of the scene. */
    if (character == 'd' && given && *given != *start_given) {
        *given = *start_given;
        is_new = true;
    }
    window->own_changed |= is_new && param->subject == PARAM_TECHNIQUE;
    if (is_new && job_refresh(window->job, window->instance, 1u << param->subject, &err) != HATCH_OK)
        cmd_say("%s", err.text);
}

bool window_param_key(struct window *window, unsigned character)
{
    bool chooses = character == 'p' || character == 'P';
    struct param param;
    if (!chooses && character != '.' && character != ',' && character != 'd')
        return false;
    if (chooses)
        choose(window, character == 'P');
    else if (window->has_param && params_at(window->param, &param) && is_available(window, &param))
        change(window, &param, character);
    window->title_s = 0;
    return true;
}

void window_param_text(const struct window *window, char *text, size_t size)
{
    struct param param;
    double values[2];
    *text = '\0';
    if (!window->has_param || !params_at(window->param, &param) || !is_available(window, &param))
        return;
    params_get(&param, values);
    const char *name = param.option->name;
    char between = strchr(param.option->metavariable, 'x') ? 'x' : ':';
    if (params_count(&param) == 1)
        snprintf(text, size, ", %s [%.4g]", name, values[0]);
    else if (window->component == 0)
        snprintf(text, size, ", %s [%.4g]%c%.4g", name, values[0], between, values[1]);
    else
        snprintf(text, size, ", %s %.4g%c[%.4g]", name, values[0], between, values[1]);
}
