/* Poses a scene at a moment of an animation. */
#include "scene/scene.h"

#include <assert.h>
#include <math.h>
#include <string.h>

/* Offsets in a node's 16 numbers of `world` while a pose is computed. These numbers first hold the node's local
 * translation, rotation and scale; a pass over the nodes, parents first, then replaces them by the world matrix. This
 * saves scratch memory. */
enum { LOCAL_TRANSLATION = 0, LOCAL_ROTATION = 3, LOCAL_SCALE = 7 };

static void multiply(const double *a, const double *b, double *out)
{
    for (int column = 0; column < 4; column++)
        for (int row = 0; row < 4; row++) {
            double sum = 0;
            for (int k = 0; k < 4; k++)
                sum += a[k * 4 + row] * b[column * 4 + k];
            out[column * 4 + row] = sum;
        }
}

static void matrix_of(const double *local, double *matrix)
{
    const double *t = local + LOCAL_TRANSLATION, *q = local + LOCAL_ROTATION, *s = local + LOCAL_SCALE;
    double x = q[0], y = q[1], z = q[2], w = q[3];
    const double turn[3][3] = {
        {1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
        {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
        {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)},
    };
    for (int column = 0; column < 3; column++) {
        for (int row = 0; row < 3; row++)
            matrix[column * 4 + row] = turn[column][row] * s[column];
        matrix[column * 4 + 3] = 0;
    }
    memcpy(matrix + 12, t, 3 * sizeof *t);
    matrix[15] = 1;
}

static void normalize4(double q[4])
{
    double length = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (int i = 0; i < 4 && length > 0; i++)
        q[i] /= length;
}

/* Interpolates rotations along the shorter arc, at constant angular speed. Nearly equal rotations are interpolated
 * linearly, because the sine of their angle is too small to divide by. */
static void slerp(const float *a, const float *b, double t, double out[4])
{
    double dot = 0;
    for (int i = 0; i < 4; i++)
        dot += (double)a[i] * (double)b[i];
    double sign = dot < 0 ? -1 : 1;
    double from = 1 - t, to = t;
    if (fabs(dot) < 0.9995) {
        double angle = acos(fabs(dot));
        from = sin((1 - t) * angle) / sin(angle);
        to = sin(t * angle) / sin(angle);
    }
    for (int i = 0; i < 4; i++)
        out[i] = from * (double)a[i] + sign * to * (double)b[i];
}

/* Returns the index of the last key at or before time_s, within 0 .. key_count - 2. */
static uint32_t find_key(const struct hatch_animation_channel *channel, double time_s)
{
    uint32_t low = 0, high = channel->key_count - 1;
    while (high - low > 1) {
        uint32_t middle = low + (high - low) / 2;
        if ((double)channel->times_s[middle] <= time_s)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Interpolates with cubic Hermite splines (glTF 2.0, appendix C). A key consists of in-tangent, value and
 * out-tangent. */
static void cubic(const float *key, const float *next, uint32_t n, double span_s, double t, double *out)
{
    double t2 = t * t, t3 = t2 * t;
    for (uint32_t i = 0; i < n; i++) {
        double from = (double)key[n + i], leave = span_s * (double)key[2 * n + i];
        double to = (double)next[n + i], arrive = span_s * (double)next[i];
        out[i] = (2 * t3 - 3 * t2 + 1) * from + (t3 - 2 * t2 + t) * leave + (3 * t2 - 2 * t3) * to + (t3 - t2) * arrive;
    }
}

static void interpolate(const struct hatch_animation_channel *channel, uint32_t n, double time_s, double *out)
{
    uint32_t k = find_key(channel, time_s);
    double start = (double)channel->times_s[k], end = (double)channel->times_s[k + 1];
    double t = end > start ? (time_s - start) / (end - start) : 1;
    t = t > 1 ? 1 : t > 0 ? t : 0;
    size_t stride = (size_t)n * (channel->interpolation == HATCH_CUBIC ? 3 : 1);
    const float *key = &channel->values[k * stride], *next = key + stride;
    if (channel->interpolation == HATCH_CUBIC) {
        cubic(key, next, n, end - start, t, out);
    } else if (channel->interpolation == HATCH_STEP) {
        for (uint32_t i = 0; i < n; i++)
            out[i] = (double)(t < 1 ? key : next)[i];
    } else if (channel->path == HATCH_PATH_ROTATION) {
        slerp(key, next, t, out);
    } else {
        for (uint32_t i = 0; i < n; i++)
            out[i] = (1 - t) * (double)key[i] + t * (double)next[i];
    }
}

/* Evaluates a channel with at least one key.
 *   value  out: hatch_channel_width entries */
static void value_at(const struct hatch_animation_channel *channel, double time_s, double *value)
{
    uint32_t n = hatch_channel_width(channel);
    if (channel->key_count > 1) {
        interpolate(channel, n, time_s, value);
        return;
    }
    const float *only = channel->values + (channel->interpolation == HATCH_CUBIC ? n : 0);
    for (uint32_t i = 0; i < n; i++)
        value[i] = (double)only[i];
}

/* Replaces the part of a node's local transform that a channel animates. */
static void sample(const struct hatch_animation_channel *channel, double time_s, double *local)
{
    static const int offset[] = {[HATCH_PATH_TRANSLATION] = LOCAL_TRANSLATION,
                                 [HATCH_PATH_ROTATION] = LOCAL_ROTATION,
                                 [HATCH_PATH_SCALE] = LOCAL_SCALE};
    double value[4];
    if (channel->key_count == 0 || channel->path == HATCH_PATH_WEIGHTS)
        return;
    value_at(channel, time_s, value);
    if (channel->path == HATCH_PATH_ROTATION)
        normalize4(value);
    for (uint32_t i = 0; i < hatch_channel_width(channel); i++)
        local[offset[channel->path] + (int)i] = value[i];
}

double hatch_animation_wrap(const struct hatch_animation *animation, double time_s)
{
    double duration_s = (double)animation->duration_s;
    if (!(duration_s > 0))
        return 0;
    if (time_s >= 0 && time_s <= duration_s)
        return time_s;
    double wrapped = fmod(time_s, duration_s);
    return wrapped < 0 ? wrapped + duration_s : wrapped;
}

void hatch_scene_pose(const struct hatch_scene *scene, uint32_t animation, double time_s, double *world)
{
    for (uint32_t i = 0; i < scene->node_count; i++) {
        double *local = &world[(size_t)i * 16];
        memcpy(local + LOCAL_TRANSLATION, scene->nodes[i].translation, 3 * sizeof *local);
        memcpy(local + LOCAL_ROTATION, scene->nodes[i].rotation, 4 * sizeof *local);
        memcpy(local + LOCAL_SCALE, scene->nodes[i].scale, 3 * sizeof *local);
    }
    if (animation != HATCH_NONE) {
        assert(animation < scene->animation_count);
        const struct hatch_animation *a = &scene->animations[animation];
        double at = hatch_animation_wrap(a, time_s);
        for (uint32_t c = 0; c < a->channel_count; c++)
            sample(&a->channels[c], at, &world[(size_t)a->channels[c].node * 16]);
    }
    for (uint32_t i = 0; i < scene->node_count; i++) {
        const struct hatch_node *node = &scene->nodes[i];
        double local[16];
        if (node->has_matrix)
            memcpy(local, node->matrix, sizeof local);
        else
            matrix_of(&world[(size_t)i * 16], local);
        if (node->parent == HATCH_NONE)
            memcpy(&world[(size_t)i * 16], local, sizeof local);
        else
            multiply(&world[(size_t)node->parent * 16], local, &world[(size_t)i * 16]);
    }
}

void hatch_scene_weights(const struct hatch_scene *scene, uint32_t node, uint32_t animation, double time_s,
                         uint32_t count, double *weights)
{
    const float *rest = scene->nodes[node].weights;
    for (uint32_t i = 0; i < count; i++)
        weights[i] = rest ? (double)rest[i] : 0;
    if (animation == HATCH_NONE)
        return;
    const struct hatch_animation *a = &scene->animations[animation];
    for (uint32_t c = 0; c < a->channel_count; c++) {
        const struct hatch_animation_channel *channel = &a->channels[c];
        if (channel->path != HATCH_PATH_WEIGHTS || channel->node != node || channel->key_count == 0)
            continue;
        assert(channel->targets == count);
        value_at(channel, hatch_animation_wrap(a, time_s), weights);
    }
}

void hatch_scene_skin(const struct hatch_scene *scene, uint32_t skin, const double *world, double *joints)
{
    const struct hatch_skin *s = &scene->skins[skin];
    for (size_t j = 0; j < s->joint_count; j++) {
        double inverse[16];
        for (size_t i = 0; i < 16; i++)
            inverse[i] = (double)s->inverse_bind[16 * j + i];
        multiply(&world[(size_t)s->joints[j] * 16], inverse, &joints[16 * j]);
    }
}
