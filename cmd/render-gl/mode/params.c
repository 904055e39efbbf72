#include "render-gl/mode/params.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define TEXT_MAX 128
#define NAMES_MAX 64 /* parameters that a message lists */

/* Parameters that belong to no technique, in the order in which the window's key p goes through them. */
static const struct {
    struct technique_param param;
    enum param_subject subject;
} common[] = {
    {{"hatch-turn", false, 5}, PARAM_STROKES},
    {{"hatch-scale", true, 1.1}, PARAM_STROKES},
    {{"tone-range", false, 0.05}, PARAM_STYLE},
    {{"tone-gamma", true, 1.1}, PARAM_STYLE},
    {{"light", false, 5}, PARAM_STYLE},
    {{"shadows", true, 1.1}, PARAM_STYLE},
    {{"exposure", true, 1.1}, PARAM_STYLE},
    {{"haloes", true, 1.1}, PARAM_STYLE},
    {{"solid-size", true, 1.1}, PARAM_LOOK},
    {{"grain", false, 0.05}, PARAM_LOOK},
    {{"bands", false, 1}, PARAM_LOOK},
    {{"wobble", false, 0.5}, PARAM_LOOK},
    {{"dry", false, 0.05}, PARAM_LOOK},
    {{"wet", false, 0.05}, PARAM_LOOK},
    {{"edge-darkening", false, 0.05}, PARAM_LOOK},
    {{"paper-grain", false, 0.05}, PARAM_LOOK},
    {{"border", false, 0.5}, PARAM_LOOK},
    {{"line-width", true, 1.1}, PARAM_LINES},
    {{"from", false, 5}, PARAM_CAMERA},
    {{"fov", false, 5}, PARAM_CAMERA},
    {{"zoom", true, 1.1}, PARAM_CAMERA},
};

bool params_at(uint32_t index, struct param *param)
{
    for (size_t i = 0; techniques[i]; i++)
        for (const struct technique_param *own = techniques[i]->params; own && own->option; own++)
            if (index-- == 0) {
                *param = (struct param){options_find(own->option), PARAM_TECHNIQUE, techniques[i], own->by_factor,
                                        own->step};
                return true;
            }
    if (index >= sizeof common / sizeof *common)
        return false;
    const struct technique_param *from = &common[index].param;
    *param = (struct param){options_find(from->option), common[index].subject, NULL, from->by_factor, from->step};
    return true;
}

uint32_t params_count(const struct param *param)
{
    return param->option->type == CMD_PAIR ? 2 : 1;
}

bool params_are_used(const struct param *param, const struct technique *technique, bool lines)
{
    switch (param->subject) {
    case PARAM_LINES:
        return lines;
    case PARAM_LOOK:
        return technique->features & TECHNIQUE_LOOKS ||
               (look_options.kind == LOOK_WATERCOLOR && technique_is_painted(technique));
    case PARAM_STROKES:
        return technique->features & TECHNIQUE_STROKES;
    case PARAM_TECHNIQUE:
        return technique_has_option(technique, param->option->name);
    default:
        return true;
    }
}

void params_get(const struct param *param, double values[2])
{
    const struct cmd_option *option = param->option;
    if (option->type == CMD_INT)
        values[0] = (double)*(const int64_t *)option->value;
    else
        memcpy(values, option->value, params_count(param) * sizeof *values);
}

bool params_set(const struct param *param, const double values[2])
{
    const struct cmd_option *option = param->option;
    double old[2] = {0}, rounded[2] = {values[0], values[1]};
    params_get(param, old);
    if (option->type == CMD_INT)
        rounded[0] = round(rounded[0]);
    bool is_new = false;
    for (uint32_t k = 0; k < params_count(param); k++)
        is_new = is_new || rounded[k] < old[k] || rounded[k] > old[k];
    if (!is_new)
        return false;
    if (option->type == CMD_INT)
        *(int64_t *)option->value = (int64_t)rounded[0];
    else
        memcpy(option->value, rounded, params_count(param) * sizeof *rounded);
    if (option->given)
        *option->given = true;
    return true;
}

static bool find_param(const char *text, size_t length, struct param *param)
{
    for (uint32_t i = 0; params_at(i, param); i++)
        if (strlen(param->option->name) == length && strncmp(param->option->name, text, length) == 0)
            return true;
    return false;
}

static noreturn void refuse_name(const char *text, size_t length)
{
    struct param param;
    const char *names[NAMES_MAX + 1] = {NULL};
    char word[TEXT_MAX];
    for (uint32_t i = 0; i < NAMES_MAX && params_at(i, &param); i++)
        names[i] = param.option->name;
    snprintf(word, sizeof word, "%.*s", (int)length, text);
    cmd_refuse_name("--animate", word, names, NULL);
}

/* Parses a value by setting the option to it; checks its range. */
static void parse_value(const struct param *param, const char *text, size_t length, double values[2])
{
    char word[TEXT_MAX];
    if (length >= sizeof word)
        cmd_usage("--%s: a number of %zu characters is too long", param->option->name, length);
    memcpy(word, text, length);
    word[length] = '\0';
    cmd_set_option(param->option, word);
    params_get(param, values);
}

static void read_one(const char *text, struct option_change *change)
{
    struct param *param = &change->param;
    size_t length = strcspn(text, "=");
    const char *from = text + length + 1, *gap = text[length] ? strstr(from, "..") : NULL;
    if (!gap)
        cmd_usage("--animate %s: want PARAM=FROM..TO, like stroke=20x1.5..80x3", text);
    if (!find_param(text, length, param))
        refuse_name(text, length);
    parse_value(param, gap + 2, strlen(gap + 2), change->to);
    parse_value(param, from, (size_t)(gap - from), change->from);
    for (uint32_t k = 0; param->by_factor && k < params_count(param); k++)
        if (!(change->from[k] > 0 && change->to[k] > 0))
            cmd_usage("--animate %s: want numbers over 0, since it changes by the same factor each frame", text);
}

void params_read(struct options *options)
{
    const struct technique *technique = options->technique;
    for (int i = 0; i < options->animate.count; i++) {
        struct option_change *change = &options->changes[options->change_count];
        const struct param *param = &change->param;
        if (options->change_count == OPTIONS_CHANGES_MAX)
            cmd_usage("--animate %s: more than %u parameters", options->animate.at[i], OPTIONS_CHANGES_MAX);
        read_one(options->animate.at[i], change);
        for (uint32_t k = 0; k < options->change_count; k++)
            if (options->changes[k].param.option == param->option)
                cmd_usage("--animate %s: given twice", param->option->name);
        if (!params_are_used(param, technique, options_draw_lines(options, technique)))
            cmd_usage("--animate %s: technique %s does not use it%s", param->option->name, technique->name,
                      param->subject == PARAM_LINES ? " without --lines" : "");
        if (options->vectors && !technique->curves && param->subject != PARAM_CAMERA && param->subject != PARAM_LINES)
            cmd_usage("--animate %s: a drawing, which has lines alone, does not use it", param->option->name);
        if (options->vectors && technique_has_pen_for(technique, param->option->name))
            cmd_usage("--animate %s: a drawing, which has the width of its --pen, does not use it",
                      param->option->name);
        cmd_imply_option(param->option);
        options->change_count++;
    }
    options_read_view(options);
}

bool params_differ(const struct options *options)
{
    bool differ = false;
    for (uint32_t i = 0; i < options->change_count; i++) {
        const struct option_change *change = &options->changes[i];
        for (uint32_t k = 0; k < params_count(&change->param); k++)
            differ = differ || change->from[k] < change->to[k] || change->from[k] > change->to[k];
    }
    return differ;
}

uint32_t params_move(const struct options *options, double share)
{
    uint32_t subjects = 0;
    for (uint32_t i = 0; i < options->change_count; i++) {
        const struct option_change *change = &options->changes[i];
        const struct param *param = &change->param;
        double values[2] = {0};
        for (uint32_t k = 0; k < params_count(param); k++) {
            double from = change->from[k], to = change->to[k];
            values[k] = param->by_factor ? from * pow(to / from, share) : from + share * (to - from);
        }
        if (params_set(param, share < 1 ? values : change->to))
            subjects |= 1u << param->subject;
    }
    return subjects;
}

double params_swing(double time_s, double whole_s)
{
    double phase = fmod(time_s / whole_s, 2);
    return phase < 1 ? phase : 2 - phase;
}
