#include "view/exposure.h"

#include "math/vector.h"

#define BRIGHTEST_SHARE 0.05

/* Histogram of the surface by the logarithm of the light at its vertices: STEPS bins per octave. */
#define STEPS 16
#define OCTAVES 200
#define BINS (OCTAVES * STEPS)

struct exposure {
    struct hatch_unit_light lights[HATCH_LIGHTS_MAX];
    uint32_t light_count;
    double bins[BINS];
    double lit;  /* area in all bins */
    bool behind; /* the sides of double-sided items are measured from which they have no normals */
};

/* Returns the diffuse light that one light gives to a point, computed like light_at in the shader light.glsl. */
static double diffuse_light(const struct hatch_unit_light *light, const double point[3], const float normal[3])
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

static void add_vertex(struct exposure *exposure, const double point[3], const float normal[3], double area)
{
    const float side = exposure->behind ? -1 : 1, facing[3] = {side * normal[0], side * normal[1], side * normal[2]};
    double sum = 0;
    for (uint32_t i = 0; i < exposure->light_count; i++)
        sum += diffuse_light(&exposure->lights[i], point, facing);
    double bin = floor((log2(sum) + OCTAVES / 2) * STEPS);
    if (!(bin >= 0 && bin < BINS))
        return;
    exposure->bins[(int)bin] += area;
    exposure->lit += area;
}

/* Adds a third of the area of each face to those of its vertices. */
static void add_areas(const struct hatch_mesh *mesh, const double *positions, double *areas)
{
    for (size_t f = 0; f < mesh->face_count; f++) {
        const uint32_t *at = mesh->indices + 3 * f;
        double normal[3];
        hatch_vec_triangle(positions + 3 * (size_t)at[0], positions + 3 * (size_t)at[1], positions + 3 * (size_t)at[2],
                           normal);
        for (int k = 0; k < 3; k++)
            areas[at[k]] += hatch_vec_length(normal) / 6;
    }
}

static enum hatch_status add_item(struct exposure *exposure, const struct hatch_unit_scene *scene,
                                  const struct hatch_item *item, struct hatch_arena *scratch, struct hatch_err *err)
{
    const struct hatch_mesh *mesh = scene->meshes[item->mesh].surface;
    size_t count = mesh->vertex_count;
    double *positions, *areas;
    float *normals;
    HATCH_TRY(HATCH_ALLOC(scratch, &positions, 3 * count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &normals, 3 * count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &areas, count, err));
    hatch_item_surface(scene, item, positions, normals);
    add_areas(mesh, positions, areas);
    for (size_t v = 0; v < count; v++)
        add_vertex(exposure, positions + 3 * v, normals + 3 * v, areas[v]);
    return HATCH_OK;
}

/* Returns the light that BRIGHTEST_SHARE of the lit surface exceeds. */
static double white_point(const struct exposure *exposure)
{
    double remaining = BRIGHTEST_SHARE * exposure->lit;
    int bin = BINS - 1;
    while (bin > 0 && (remaining -= exposure->bins[bin]) > 0)
        bin--;
    return exp2((bin + 0.5) / STEPS - OCTAVES / 2);
}

static enum hatch_status add_items(struct exposure *exposure, const struct hatch_unit_scene *scene,
                                   struct hatch_arena *scratch, struct hatch_err *err)
{
    for (uint32_t i = 0; i < scene->item_count; i++) {
        const struct hatch_item *item = &scene->items[i];
        if (scene->scene->nodes[item->node].backdrop || (exposure->behind && !item->double_sided))
            continue;
        struct hatch_arena_mark mark = hatch_arena_mark(scratch);
        HATCH_TRY(add_item(exposure, scene, item, scratch, err));
        hatch_arena_rewind(scratch, mark);
    }
    return HATCH_OK;
}

/* Measures the present pose: the sides that normals point to, or if none of them is lit, the others.
 *   factor  out: 0 if nothing is lit */
static enum hatch_status measure(const struct hatch_unit_scene *scene, const struct hatch_view *view,
                                 struct hatch_arena *scratch, double *factor, struct hatch_err *err)
{
    static const struct hatch_key_light none;
    struct exposure *exposure;
    HATCH_TRY(HATCH_ALLOC(scratch, &exposure, 1, err));
    /* Lights are scaled so that the strongest one is 1, because their strengths may all be too small for floats. */
    double strongest = hatch_lights_strongest(&scene->pose, &scene->bounds);
    double prescale = strongest > 0 ? 1 / strongest : 1;
    exposure->light_count = hatch_lights_fill(&scene->pose, &scene->bounds, view, &none, prescale, exposure->lights);
    HATCH_TRY(add_items(exposure, scene, scratch, err));
    exposure->behind = true;
    if (!(exposure->lit > 0))
        HATCH_TRY(add_items(exposure, scene, scratch, err));
    *factor = exposure->lit > 0 ? prescale / white_point(exposure) : 0;
    return HATCH_OK;
}

enum hatch_status hatch_auto_exposure(struct hatch_unit_scene *scene, const struct hatch_pose_span *span,
                                      const struct hatch_view *view, struct hatch_arena *scratch, double *exposure,
                                      struct hatch_err *err)
{
    const bool moves = span && scene->scene->light_count > 0;
    const uint32_t moments = moves ? span->moments : 1;
    double least = 0, factor;
    for (uint32_t i = 0; i < moments; i++) {
        struct hatch_arena_mark mark = hatch_arena_mark(scratch);
        if (moves)
            hatch_unit_scene_pose(scene, span->animation, span->times_s ? span->times_s[i] : 0);
        enum hatch_status status = measure(scene, view, scratch, &factor, err);
        hatch_arena_rewind(scratch, mark);
        if (status != HATCH_OK)
            return status;
        least = factor > 0 && !(least > 0 && least < factor) ? factor : least;
    }
    *exposure = least > 0 ? least : 1;
    return HATCH_OK;
}
