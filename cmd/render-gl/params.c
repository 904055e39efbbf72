#include "render-gl/params.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "render-gl/job.h"

#define RADIANS (3.14159265358979324 / 180)
#define AT(member) offsetof(struct job, member)
#define SEEDS(member) AT(options.seeds.member)
#define STYLE(member) AT(renderer.style.member)
#define TEXT_MAX 128

const struct param params[] = {
    {"stroke", PARAM_SEEDS, true, 1.1, 1, {SEEDS(style.length_px), SEEDS(style.width_px)}},
    {"stroke-ink", PARAM_SEEDS, false, 0.05, 1, {SEEDS(style.ink)}},
    {"stroke-turn", PARAM_SEEDS, false, 5, RADIANS, {SEEDS(stroke_turn_rad)}},
    {"seed-tile", PARAM_SEEDS, true, 1.1, 1, {SEEDS(style.tile_px)}},
    {"seed-layers", PARAM_SEEDS, false, 1, 1, {SEEDS(layers)}},
    {"overlap", PARAM_SEEDS, false, 0.1, 1, {SEEDS(style.overlap)}},
    {"hatch-turn", PARAM_STROKES, false, 5, RADIANS, {STYLE(hatch_turn_rad)}},
    {"hatch-scale", PARAM_STROKES, true, 1.1, 1, {STYLE(hatch_scale)}},
    {"tone-range", PARAM_TONE, false, 0.05, 1, {STYLE(curve.low), STYLE(curve.high)}},
    {"tone-gamma", PARAM_TONE, true, 1.1, 1, {STYLE(curve.gamma)}},
    {"light", PARAM_TONE, false, 5, RADIANS, {STYLE(light.azimuth_rad), STYLE(light.elevation_rad)}},
    {"shadows", PARAM_TONE, true, 1.1, 1, {STYLE(shadow_edge)}},
    {"exposure", PARAM_TONE, true, 1.1, 1, {STYLE(curve.exposure)}},
    {"haloes", PARAM_TONE, true, 1.1, 1, {STYLE(halo_px)}},
    {"line-width", PARAM_LINES, true, 1.1, 1, {AT(options.lines.width_px)}},
    {"from", PARAM_CAMERA, false, 5, RADIANS, {AT(options.view.azimuth_rad), AT(options.view.elevation_rad)}},
    {"fov", PARAM_CAMERA, false, 5, RADIANS, {AT(options.view.fov_rad)}},
    {"zoom", PARAM_CAMERA, true, 1.1, 1, {AT(options.zoom)}},
};
_Static_assert(sizeof params / sizeof *params <= PARAMS_MAX, "PARAMS_MAX is too small");

uint32_t params_count(void)
{
    return sizeof params / sizeof *params;
}

static uint32_t count_of(const struct param *param)
{
    return param->at[1] ? 2 : 1;
}

static uint32_t find(const char *text, size_t length)
{
    for (uint32_t i = 0; i < params_count(); i++)
        if (strlen(params[i].name) == length && strncmp(params[i].name, text, length) == 0)
            return i;
    return PARAM_NONE;
}

static noreturn void refuse_name(const char *text, size_t length)
{
    char all[512] = "";
    for (uint32_t i = 0; i < params_count(); i++) {
        size_t used = strlen(all);
        snprintf(all + used, sizeof all - used, "%s%s", i ? ", " : "", params[i].name);
    }
    cmd_usage("--animate %.*s: want one of %s", (int)length, text, all);
}

bool params_are_used(uint32_t param, const struct technique *technique, bool lines)
{
    switch (params[param].use) {
    case PARAM_LINES:
        return lines;
    case PARAM_STROKES:
        return technique_draws_strokes(technique);
    case PARAM_SEEDS:
        return technique->seeds;
    default:
        return true;
    }
}

/* What the option says when it is given a text. */
static void take(const struct cmd_option *option, const char *text, size_t length, double values[2])
{
    char word[TEXT_MAX];
    if (length >= sizeof word)
        cmd_usage("--%s: a number of %zu characters is too long", option->name, length);
    memcpy(word, text, length);
    word[length] = '\0';
    cmd_set_option(option, word);
    if (option->type == CMD_INT)
        values[0] = (double)*(const int64_t *)option->value;
    else
        memcpy(values, option->value, (option->type == CMD_PAIR ? 2 : 1) * sizeof *values);
}

const struct cmd_option *params_option(uint32_t param)
{
    const struct cmd_option *option = options_table();
    while (strcmp(option->name, params[param].name) != 0)
        option++;
    return option;
}

static void read_one(const char *text, struct param_change *change)
{
    size_t length = strcspn(text, "=");
    const char *from = text + length + 1, *gap = text[length] ? strstr(from, "..") : NULL;
    if (!gap)
        cmd_usage("--animate %s: want PARAM=FROM..TO, like stroke=20x1.5..80x3", text);
    uint32_t param = find(text, length);
    if (param == PARAM_NONE)
        refuse_name(text, length);
    const struct cmd_option *option = params_option(param);
    *change = (struct param_change){.param = param};
    take(option, gap + 2, strlen(gap + 2), change->to);
    take(option, from, (size_t)(gap - from), change->from);
    for (uint32_t k = 0; params[param].scale && k < count_of(&params[param]); k++)
        if (!(change->from[k] > 0 && change->to[k] > 0))
            cmd_usage("--animate %s: it changes by factors, from and to numbers over 0", text);
}

uint32_t params_read(const struct cmd_texts *texts, const struct technique *technique, bool lines,
                     struct param_change *changes)
{
    bool seen[PARAMS_MAX] = {false};
    uint32_t count = 0;
    for (int i = 0; i < texts->count; i++) {
        struct param_change change;
        read_one(texts->at[i], &change);
        const char *name = params[change.param].name;
        if (seen[change.param])
            cmd_usage("--animate %s: it changes in one way only", name);
        if (!params_are_used(change.param, technique, lines))
            cmd_usage("--animate %s: technique %s does not use it%s", name, technique->name,
                      params[change.param].use == PARAM_LINES ? " without --lines" : "");
        seen[change.param] = true;
        changes[count++] = change;
    }
    return count;
}

void params_get(const struct job *job, uint32_t index, double values[2])
{
    const struct param *param = &params[index];
    for (uint32_t k = 0; k < count_of(param); k++)
        values[k] = *(const double *)((const char *)job + param->at[k]) / param->unit;
}

void params_set(struct job *job, uint32_t index, const double values[2])
{
    const struct param *param = &params[index];
    bool same = true;
    for (uint32_t k = 0; k < count_of(param); k++) {
        double *at = (double *)((char *)job + param->at[k]), value = values[k] * param->unit;
        same = same && *at == value;
        *at = value;
    }
    if (same)
        return;
    job->strokes_changed = job->strokes_changed || param->use == PARAM_SEEDS;
    job->view_changed = job->view_changed || param->use == PARAM_CAMERA;
    if (param->at[0] == SEEDS(style.tile_px))
        job->options.seeds.tile_given = true;
    if (param->at[0] == STYLE(curve.low))
        job->options.high_given = true;
    if (param->at[0] == STYLE(light.azimuth_rad))
        job->renderer.style.light.wanted = true;
    if (param->use == PARAM_LINES)
        job->lines.style.width_px = job->options.lines.width_px;
}

void params_move(struct job *job, double share)
{
    for (uint32_t i = 0; i < job->options.change_count; i++) {
        const struct param_change *change = &job->options.changes[i];
        double values[2] = {0};
        for (uint32_t k = 0; k < count_of(&params[change->param]); k++) {
            double from = change->from[k], to = change->to[k];
            values[k] = params[change->param].scale ? from * pow(to / from, share) : from + share * (to - from);
        }
        params_set(job, change->param, share < 1 ? values : change->to);
    }
}
