#include "view/light.h"

#include "image/color.h"
#include "math/vector.h"

/* Distance, in radii of the scene, beyond which a point or spot light is replaced by a directional one: there its
 * falloff is not visible, and would be lost in floats. At distances below the reciprocal its strength does not increase
 * any more. */
#define FAR_AWAY 1e3

static void set_directional(struct hatch_unit_light *light, const double to_light[3])
{
    double length = hatch_vec_length(to_light);
    *light = (struct hatch_unit_light){.direction = {0, 1, 0, 0}, .cone = {0, 1, 0, 0}};
    for (int k = 0; k < 3 && length > 0 && isfinite(length); k++)
        light->direction[k] = (float)(to_light[k] / length);
}

/* Computes scale and offset of the cosine that make the falloff of a light's cone: 1 everywhere except for a spot. */
static void find_cone(const struct hatch_light *from, double cone[2])
{
    double outer = cos((double)from->outer_cone_rad), inner = cos((double)from->inner_cone_rad);
    bool spot = from->type == HATCH_LIGHT_SPOT;
    cone[0] = spot ? 1.0 / fmax(inner - outer, 1e-3) : 0.0;
    cone[1] = spot ? -outer / fmax(inner - outer, 1e-3) : 1.0;
}

/* Returns the share of a lamp's light that cone and range leave at the scene's centre, as light_at in the shader
 * light.glsl computes it.
 *   along  cosine of the angle between the lamp's axis and the direction to the centre
 *   reach  distance of the lamp in ranges; 0: the range is unlimited */
static double share_at_center(const double cone[2], double along, double reach)
{
    double spot = fmin(fmax(along * cone[0] + cone[1], 0), 1), square = reach * reach;
    return spot * spot * fmin(fmax(1 - square * square, 0), 1);
}

/* Fills a light except for its strength, and returns the strength. */
static double set_scene_light(struct hatch_unit_light *light, const struct hatch_light *from, const double world[16],
                              const struct hatch_bounds *bounds)
{
    double power = (double)from->intensity * (double)hatch_color_luminance(from->color);
    double away[3] = {world[8], world[9], world[10]}, at[3], cone[2];
    if (from->type == HATCH_LIGHT_DIRECTIONAL) {
        set_directional(light, away);
        return power;
    }
    hatch_bounds_to_unit(bounds, world + 12, at);
    power = power / bounds->radius / bounds->radius;
    double distance = hatch_vec_length(at), range = (double)from->range / bounds->radius;
    double length = hatch_vec_length(away);
    find_cone(from, cone);
    if (!(distance < FAR_AWAY)) {
        set_directional(light, at);
        double along = length > 0 ? hatch_vec_dot(away, at) / length / distance : 0;
        return power / distance / distance * share_at_center(cone, along, range > 0 ? distance / range : 0);
    }
    *light = (struct hatch_unit_light){.position = {(float)at[0], (float)at[1], (float)at[2], 1.0f},
                                       .cone = {(float)cone[0], (float)cone[1],
                                                range > 0 ? (float)(1.0 / (range * range)) : 0.0f,
                                                (float)(1 / (FAR_AWAY * FAR_AWAY))}};
    for (int k = 0; k < 3; k++)
        light->direction[k] = length > 0 ? (float)(-away[k] / length) : 0.0f;
    return power;
}

static void set_key_light(struct hatch_unit_light *light, const struct hatch_view *view,
                          const struct hatch_key_light *key)
{
    double level = cos(key->elevation_rad), to_light[3];
    double x = level * sin(key->azimuth_rad), y = sin(key->elevation_rad), z = level * cos(key->azimuth_rad);
    for (int k = 0; k < 3; k++)
        to_light[k] = x * view->right[k] + y * view->up[k] + z * view->back[k];
    set_directional(light, to_light);
    light->direction[3] = 1.0f;
}

/* Fills the light of a node, and returns its strength in *power. Returns false if the node has no light. */
static bool light_at_node(const struct hatch_pose *pose, const struct hatch_bounds *bounds, uint32_t node,
                          struct hatch_unit_light *light, double *power)
{
    const struct hatch_scene *scene = pose->scene;
    double world[16];
    if (scene->nodes[node].light == HATCH_NONE)
        return false;
    hatch_pose_matrix(pose, node, world);
    *power = set_scene_light(light, &scene->lights[scene->nodes[node].light], world, bounds);
    return true;
}

double hatch_lights_strongest(const struct hatch_pose *pose, const struct hatch_bounds *bounds)
{
    double strongest = 0, power;
    struct hatch_unit_light light;
    for (uint32_t node = 0; node < pose->scene->node_count; node++)
        if (light_at_node(pose, bounds, node, &light, &power))
            strongest = fmax(strongest, power);
    return strongest;
}

static uint32_t count_lights(const struct hatch_scene *scene)
{
    uint32_t lights = 0;
    for (uint32_t node = 0; node < scene->node_count; node++)
        lights += scene->nodes[node].light != HATCH_NONE;
    return lights;
}

bool hatch_lights_are_key_alone(const struct hatch_scene *scene, const struct hatch_key_light *key)
{
    return key->replaces || count_lights(scene) == 0;
}

uint32_t hatch_lights_left_out(const struct hatch_scene *scene)
{
    uint32_t lights = count_lights(scene);
    return lights > HATCH_LIGHTS_MAX ? lights - HATCH_LIGHTS_MAX : 0;
}

uint32_t hatch_lights_fill(const struct hatch_pose *pose, const struct hatch_bounds *bounds,
                           const struct hatch_view *view, const struct hatch_key_light *key, double exposure,
                           struct hatch_unit_light *lights)
{
    uint32_t count = 0;
    double power;
    for (uint32_t node = 0; node < pose->scene->node_count && !key->replaces && count < HATCH_LIGHTS_MAX; node++)
        if (light_at_node(pose, bounds, node, &lights[count], &power))
            /* Computed in doubles, as strength and exposure may each be outside the range of floats. */
            lights[count++].direction[3] = (float)fmin(power * exposure, 1e30);
    if (count)
        return count;
    set_key_light(&lights[0], view, key);
    return 1;
}
