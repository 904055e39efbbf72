#include "render-gl/frame.h"

#include <math.h>
#include <string.h>

#include "image/color.h"
#include "math/vector.h"

void frame_set_style(struct frame_block *block, const struct inks *inks, const struct tone_curve *curve,
                     const struct gpu_columns *columns)
{
    memcpy(block->paper, inks->paper, sizeof inks->paper);
    memcpy(block->ink, inks->ink, sizeof inks->ink);
    memcpy(block->light_ink, inks->light_ink, sizeof inks->light_ink);
    block->curve[0] = (float)curve->low;
    block->curve[1] = (float)curve->high;
    block->curve[2] = (float)curve->gamma;
    block->shade[1] = (float)curve->ambient;
    block->shade[2] = (float)curve->specular;
    block->shade[3] = (float)curve->shininess;
    block->counts[1] = columns ? (int32_t)columns->count : 0;
    block->counts[3] = columns && columns->whole;
    block->counts[2] =
        hatch_color_luminance(inks->ink) > hatch_color_luminance(inks->paper) ? INK_LIGHTENS : INK_DARKENS;
    if (inks->two)
        block->counts[2] = INK_BOTH;
    for (uint32_t i = 0; columns && i < columns->count; i++) {
        float begin = i ? columns->targets[i - 1] : 0.0f;
        block->targets[i / 4][i % 4] = columns->targets[i];
        if (i >= 6)
            continue;
        block->ramp_low[i / 3][i % 3] = begin;
        block->ramp_scale[i / 3][i % 3] = 1.0f / fmaxf(columns->targets[i] - begin, 1e-6f);
    }
}

void frame_set_hatch(struct frame_block *block, double turn_rad, double scale)
{
    block->hatch[0] = (float)(cos(turn_rad) / scale);
    block->hatch[1] = (float)(sin(turn_rad) / scale);
}

void frame_set_view(struct frame_block *block, const struct hatch_view *view, const struct hatch_tile *tile,
                    uint32_t side)
{
    block->curve[3] = (float)(side * side);
    hatch_view_matrix(view, tile, block->clip_from_unit);
    block->viewport[0] = (float)(tile->width / 2);
    block->viewport[1] = (float)(tile->height / 2);
    for (int k = 0; k < 3; k++)
        block->eye[k] = (float)(view->orthographic ? view->back[k] : view->eye[k]);
    block->eye[3] = view->orthographic ? 0.0f : 1.0f;
}

static void set_directional(struct frame_light *light, const double to_light[3])
{
    double length = hatch_vec_length(to_light);
    *light = (struct frame_light){.direction = {0, 1, 0, 0}, .cone = {0, 1, 0, 0}};
    for (int k = 0; k < 3 && length > 0 && isfinite(length); k++)
        light->direction[k] = (float)(to_light[k] / length);
}

/* Beyond FAR_AWAY radii a lamp is a sun: floats would lose its falloff, and nobody would see it.
 * Closer than 1/FAR_AWAY its strength stops growing. */
#define FAR_AWAY 1e3

/* Fills one light, all but its strength; returns that. */
static double set_scene_light(struct frame_light *light, const struct hatch_light *from, const double world[16],
                              const struct hatch_bounds *bounds)
{
    double power = (double)from->intensity * (double)hatch_color_luminance(from->color);
    double away[3] = {world[8], world[9], world[10]}, at[3];
    if (from->type == HATCH_LIGHT_DIRECTIONAL) {
        set_directional(light, away);
        return power;
    }
    for (int k = 0; k < 3; k++)
        at[k] = (world[12 + k] - bounds->center[k]) / bounds->radius;
    power = power / bounds->radius / bounds->radius;
    double distance = hatch_vec_length(at), range = (double)from->range / bounds->radius;
    if (!(distance < FAR_AWAY)) {
        set_directional(light, at);
        power = range > 0 && range <= distance ? 0.0 : power / distance / distance;
        return power;
    }
    double length = hatch_vec_length(away);
    *light = (struct frame_light){.position = {(float)at[0], (float)at[1], (float)at[2], 1.0f},
                                  .cone = {0.0f, 1.0f, 0.0f, (float)(1 / (FAR_AWAY * FAR_AWAY))}};
    for (int k = 0; k < 3; k++)
        light->direction[k] = length > 0 ? (float)(-away[k] / length) : 0.0f;
    if (from->type == HATCH_LIGHT_SPOT) {
        double outer = cos((double)from->outer_cone_rad), inner = cos((double)from->inner_cone_rad);
        light->cone[0] = (float)(1.0 / fmax(inner - outer, 1e-3));
        light->cone[1] = (float)(-outer / fmax(inner - outer, 1e-3));
    }
    light->cone[2] = range > 0 ? (float)(1.0 / (range * range)) : 0.0f;
    return power;
}

static void set_own_light(struct frame_block *block, const struct hatch_view *view, const struct own_light *own)
{
    double level = cos(own->elevation_rad), to_light[3];
    double x = level * sin(own->azimuth_rad), y = sin(own->elevation_rad);
    double z = level * cos(own->azimuth_rad);
    for (int k = 0; k < 3; k++)
        to_light[k] = x * view->right[k] + y * view->up[k] + z * view->back[k];
    set_directional(&block->lights[0], to_light);
    block->counts[0] = 1;
}

double frame_strongest_light(const struct hatch_pose *pose, const struct hatch_bounds *bounds)
{
    const struct hatch_scene *scene = pose->scene;
    double strongest = 0;
    for (uint32_t node = 0; node < scene->node_count; node++) {
        struct frame_light light;
        double world[16];
        if (scene->nodes[node].light == HATCH_NONE)
            continue;
        hatch_pose_matrix(pose, node, world);
        strongest = fmax(strongest, set_scene_light(&light, &scene->lights[scene->nodes[node].light], world, bounds));
    }
    return strongest;
}

static uint32_t count_lights(const struct hatch_scene *scene)
{
    uint32_t lights = 0;
    for (uint32_t node = 0; node < scene->node_count; node++)
        lights += scene->nodes[node].light != HATCH_NONE;
    return lights;
}

bool frame_has_lone_sun(const struct hatch_scene *scene, const struct own_light *own)
{
    return own->wanted || count_lights(scene) == 0;
}

uint32_t frame_lights_left_out(const struct hatch_scene *scene)
{
    uint32_t lights = count_lights(scene);
    return lights > LIGHTS_MAX ? lights - LIGHTS_MAX : 0;
}

void frame_set_lights(struct frame_block *block, const struct hatch_pose *pose, const struct hatch_bounds *bounds,
                      const struct hatch_view *view, const struct own_light *own, double exposure)
{
    const struct hatch_scene *scene = pose->scene;
    uint32_t count = 0;
    double power[LIGHTS_MAX];
    for (uint32_t node = 0; node < scene->node_count && !own->wanted && count < LIGHTS_MAX; node++) {
        uint32_t index = scene->nodes[node].light;
        if (index == HATCH_NONE)
            continue;
        double world[16];
        hatch_pose_matrix(pose, node, world);
        power[count] = set_scene_light(&block->lights[count], &scene->lights[index], world, bounds);
        count++;
    }
    block->counts[0] = (int32_t)count;
    if (count == 0) {
        set_own_light(block, view, own);
        block->lights[0].direction[3] = 1.0f;
    }
    /* Strengths of lamps and exposures may each be far outside the range of floats. */
    for (uint32_t i = 0; i < count; i++)
        block->lights[i].direction[3] = (float)fmin(power[i] * exposure, 1e30);
}
