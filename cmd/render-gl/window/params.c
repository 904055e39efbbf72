/* Parameters in the window: one number is chosen, keys change it. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "render-gl/window/window.h"

/* What changes by factors and is 0 is not there at all. */
static bool is_there(const struct window *window, uint32_t param)
{
    double values[2];
    params_get(window->job, param, values);
    return params[param].use != PARAM_CAMERA && (values[0] > 0 || !params[param].scale) &&
           params_are_used(param, techniques[window->technique], window->job->renderer.lines != NULL);
}

/* The next number that the technique uses, or the one before; all parameters' numbers in a row. */
static void choose(struct window *window, bool back)
{
    uint32_t count = 2 * params_count();
    uint32_t at = window->param == PARAM_NONE ? (back ? 0 : count - 1) : 2 * window->param + window->component;
    for (uint32_t i = 0; i < count; i++) {
        at = (at + (back ? count - 1 : 1)) % count;
        if (is_there(window, at / 2) && (at % 2 == 0 || params[at / 2].at[1])) {
            window->param = at / 2;
            window->component = at % 2;
            return;
        }
    }
}

/* A key goes to the end of the range, not beyond; what a mouse has put there may come back. */
static double stepped(double value, bool more, uint32_t index)
{
    const struct param *param = &params[index];
    const struct cmd_option *option = params_option(index);
    double change = more ? 1 : -1;
    double next = param->scale ? value * pow(param->step, change) : value + param->step * change;
    if (fabs(next) < 1e-9) /* what steps of a tenth leave of nothing */
        next = 0;
    return more ? fmin(next, fmax(option->maximum, value)) : fmax(next, fmin(option->minimum, value));
}

static void change(struct window *window, unsigned character)
{
    uint32_t param = window->param;
    double values[2] = {0};
    params_get(window->job, param, values);
    if (!window->has_start[param])
        memcpy(window->start[param], values, sizeof values);
    window->has_start[param] = true;
    if (character == 'd')
        memcpy(values, window->start[param], sizeof values);
    else
        values[window->component] = stepped(values[window->component], character == '.', param);
    params_set(window->job, param, values);
}

bool window_param_key(struct window *window, unsigned character)
{
    bool chooses = character == 'p' || character == 'P';
    if (!chooses && character != '.' && character != ',' && character != 'd')
        return false;
    if (chooses)
        choose(window, character == 'P');
    else if (window->param != PARAM_NONE && is_there(window, window->param))
        change(window, character);
    window->title_s = 0;
    return true;
}

void window_param_text(const struct window *window, char *text, size_t size)
{
    double values[2];
    *text = '\0';
    if (window->param == PARAM_NONE || !is_there(window, window->param))
        return;
    const struct param *param = &params[window->param];
    params_get(window->job, window->param, values);
    char between = strchr(params_option(window->param)->metavariable, 'x') ? 'x' : ':';
    if (!param->at[1])
        snprintf(text, size, ", %s [%.4g]", param->name, values[0]);
    else if (window->component == 0)
        snprintf(text, size, ", %s [%.4g]%c%.4g", param->name, values[0], between, values[1]);
    else
        snprintf(text, size, ", %s %.4g%c[%.4g]", param->name, values[0], between, values[1]);
}
