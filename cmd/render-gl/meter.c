#include "render-gl/meter.h"

#include <math.h>

#define BRIGHTEST_SHARE 0.05

/* Vertices by the logarithm of their light, in sixteenths of an octave. */
#define STEPS 16
#define OCTAVES 200
#define BINS (OCTAVES * STEPS)

struct meter {
    const struct frame_block *lights;
    uint64_t bins[BINS];
    uint64_t lit;
};

/* The diffuse part of light_at in shaders/light.glsl. */
static double light_of(const struct frame_light *light, const double point[3], const float normal[3])
{
    double to_light[3], square = 1, strength = (double)light->direction[3], facing = 0, along = 0;
    for (int k = 0; k < 3; k++)
        to_light[k] = (double)light->direction[k];
    if (light->position[3] > 0) {
        square = 0;
        for (int k = 0; k < 3; k++) {
            to_light[k] = (double)light->position[k] - point[k];
            square += to_light[k] * to_light[k];
        }
        square = fmax(square, (double)light->cone[3]);
        for (int k = 0; k < 3; k++) {
            to_light[k] /= sqrt(square);
            along -= (double)light->direction[k] * to_light[k];
        }
        double spot = fmin(fmax(along * (double)light->cone[0] + (double)light->cone[1], 0), 1);
        double far = square * (double)light->cone[2];
        strength *= spot * spot * fmin(fmax(1 - far * far, 0), 1) / square;
    }
    for (int k = 0; k < 3; k++)
        facing += to_light[k] * (double)normal[k];
    return strength * fmax(facing, 0);
}

static void add_vertex(struct meter *meter, const double point[3], const float normal[3])
{
    double sum = 0;
    for (int32_t i = 0; i < meter->lights->counts[0]; i++)
        sum += light_of(&meter->lights->lights[i], point, normal);
    double bin = floor((log2(sum) + OCTAVES / 2) * STEPS);
    if (!(bin >= 0 && bin < BINS))
        return;
    meter->bins[(int)bin]++;
    meter->lit++;
}

static enum hatch_status add_item(struct meter *meter, const struct gpu_scene *scene, const struct gpu_item *item,
                                  struct hatch_arena *scratch, struct hatch_err *err)
{
    const struct hatch_mesh *surface = scene->meshes[item->mesh].surface;
    size_t count = surface->vertex_count;
    double *positions = HATCH_NEW(scratch, double, 3 * count, err);
    float *normals = HATCH_NEW(scratch, float, 3 * count, err);
    if (!positions || !normals)
        return HATCH_LIMIT;
    struct hatch_pose pose = scene->pose;
    hatch_pose_mesh(&pose, item->node, surface, positions, normals);
    for (size_t v = 0; v < count; v++) {
        double point[3];
        for (size_t k = 0; k < 3; k++)
            point[k] = (positions[3 * v + k] - scene->bounds.center[k]) / scene->bounds.radius;
        add_vertex(meter, point, normals + 3 * v);
    }
    return HATCH_OK;
}

/* The light that all but the brightest share of the lit vertices stay under. */
static double white_point(const struct meter *meter)
{
    double left = BRIGHTEST_SHARE * (double)meter->lit;
    int bin = BINS - 1;
    while (bin > 0 && (left -= (double)meter->bins[bin]) > 0)
        bin--;
    return exp2((bin + 0.5) / STEPS - OCTAVES / 2);
}

enum hatch_status meter_exposure(const struct gpu_scene *scene, const struct hatch_view *view,
                                 struct hatch_arena *scratch, double *exposure, struct hatch_err *err)
{
    static const struct own_light none;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct frame_block *block = HATCH_NEW(scratch, struct frame_block, 1, err);
    struct meter *meter = HATCH_NEW(scratch, struct meter, 1, err);
    enum hatch_status status = block && meter ? HATCH_OK : HATCH_LIMIT;
    /* Lamps that floats cannot tell from darkness may be all the light there is. */
    double strongest = frame_strongest_light(&scene->pose, &scene->bounds);
    double first = strongest > 0 ? 1 / strongest : 1;
    if (status == HATCH_OK) {
        frame_set_lights(block, &scene->pose, &scene->bounds, view, &none, first);
        meter->lights = block;
    }
    for (uint32_t i = 0; status == HATCH_OK && i < scene->item_count; i++) {
        struct hatch_arena_mark before = hatch_arena_mark(scratch);
        status = add_item(meter, scene, &scene->items[i], scratch, err);
        hatch_arena_rewind(scratch, before);
    }
    if (status == HATCH_OK)
        *exposure = meter->lit ? first / white_point(meter) : 1;
    hatch_arena_rewind(scratch, mark);
    return status;
}
