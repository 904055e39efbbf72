#include "view/exposure.h"

#include "math/vector.h"

#define BRIGHTEST_SHARE 0.05

#define SAMPLE_SIDE (1.0 / 16) /* root of the area that a sample stands for, in the unit scene */
#define PARTS_MAX 64           /* parts of a face's side */

/* Histogram of the surface by the logarithm of the light at its vertices: STEPS bins per octave. */
#define STEPS 16
#define OCTAVES 200
#define BINS (OCTAVES * STEPS)

struct exposure {
    struct hatch_unit_light lights[HATCH_LIGHTS_MAX];
    uint32_t light_count;
    double bins[BINS];
    double lit;  /* area in all bins */
    bool inside; /* the light inside of large faces counts, not their vertices' alone */
    bool behind; /* the sides of double-sided items are measured from which they have no normals */
};

/* Returns the diffuse light that one light gives to a point, computed like light_at in the shader light.glsl. */
static double diffuse_light(const struct hatch_unit_light *light, const double point[3], const double normal[3])
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
        facing += to_light[k] * normal[k];
    return strength * fmax(facing, 0);
}

static void add_sample(struct exposure *exposure, const double point[3], const double normal[3], double area)
{
    const double side = exposure->behind ? -1 : 1, facing[3] = {side * normal[0], side * normal[1], side * normal[2]};
    double sum = 0;
    for (uint32_t i = 0; i < exposure->light_count; i++)
        sum += diffuse_light(&exposure->lights[i], point, facing);
    double bin = floor((log2(sum) + OCTAVES / 2) * STEPS);
    if (!(bin >= 0 && bin < BINS))
        return;
    exposure->bins[(int)bin] += area;
    exposure->lit += area;
}

/* The vertices of an item in the present pose. */
struct vertices {
    double *positions; /* 3 per vertex */
    float *normals;    /* 3 per vertex */
    double *areas;     /* that each vertex stands for */
};

/* Adds the middle of each of the equal parts that a face has, parts along a side. */
static void add_parts(struct exposure *exposure, const struct vertices *vertices, const uint32_t at[3], double area,
                      int parts)
{
    for (int row = 0; row < parts; row++)
        for (int part = 0; part < 2 * row + 1; part++) {
            /* Parts with odd numbers stand on a corner. */
            double b = (part / 2 + (part % 2 ? 2 : 1) / 3.0) / parts, a = 1 - (row + (part % 2 ? 1 : 2) / 3.0) / parts;
            const double share[3] = {a, b, 1 - a - b};
            double point[3] = {0, 0, 0}, normal[3] = {0, 0, 0};
            for (size_t c = 0; c < 3; c++)
                for (size_t k = 0; k < 3; k++) {
                    point[k] += share[c] * vertices->positions[3 * (size_t)at[c] + k];
                    normal[k] += share[c] * (double)vertices->normals[3 * (size_t)at[c] + k];
                }
            hatch_vec_normalize(normal);
            add_sample(exposure, point, normal, area / (parts * parts));
        }
}

/* Adds large faces part by part if the light inside counts, and a third of the area of all others to that of each
 * vertex. */
static void add_faces(struct exposure *exposure, const struct hatch_mesh *mesh, const struct vertices *vertices)
{
    for (size_t f = 0; f < mesh->face_count; f++) {
        const uint32_t *at = mesh->indices + 3 * f;
        double normal[3];
        hatch_vec_triangle(vertices->positions + 3 * (size_t)at[0], vertices->positions + 3 * (size_t)at[1],
                           vertices->positions + 3 * (size_t)at[2], normal);
        double area = hatch_vec_length(normal) / 2;
        int parts = exposure->inside ? (int)fmin(sqrt(area) / SAMPLE_SIDE, PARTS_MAX) : 0;
        if (parts > 1) {
            add_parts(exposure, vertices, at, area, parts);
            continue;
        }
        for (int c = 0; c < 3; c++)
            vertices->areas[at[c]] += area / 3;
    }
}

static enum hatch_status add_item(struct exposure *exposure, const struct hatch_unit_scene *scene,
                                  const struct hatch_item *item, struct hatch_arena *scratch, struct hatch_err *err)
{
    const struct hatch_mesh *mesh = scene->meshes[item->mesh].surface;
    size_t count = mesh->vertex_count;
    struct vertices vertices;
    HATCH_TRY(HATCH_ALLOC(scratch, &vertices.positions, 3 * count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &vertices.normals, 3 * count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &vertices.areas, count, err));
    hatch_item_surface(scene, item, vertices.positions, vertices.normals);
    add_faces(exposure, mesh, &vertices);
    for (size_t v = 0; v < count; v++) {
        const float *normal = vertices.normals + 3 * v;
        const double facing[3] = {(double)normal[0], (double)normal[1], (double)normal[2]};
        add_sample(exposure, vertices.positions + 3 * v, facing, vertices.areas[v]);
    }
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
static enum hatch_status measure(const struct hatch_unit_scene *scene, const struct hatch_view *view, bool per_pixel,
                                 struct hatch_arena *scratch, double *factor, struct hatch_err *err)
{
    static const struct hatch_key_light none;
    struct exposure *exposure;
    HATCH_TRY(HATCH_ALLOC(scratch, &exposure, 1, err));
    /* Lights are scaled so that the strongest one is 1, because their strengths may all be too small for floats. */
    double strongest = hatch_lights_strongest(&scene->pose, &scene->bounds);
    double prescale = strongest > 0 ? 1 / strongest : 1;
    exposure->light_count = hatch_lights_fill(&scene->pose, &scene->bounds, view, &none, prescale, exposure->lights);
    for (uint32_t i = 0; per_pixel && i < exposure->light_count; i++)
        exposure->inside |= exposure->lights[i].position[3] > 0;
    HATCH_TRY(add_items(exposure, scene, scratch, err));
    exposure->behind = true;
    if (!(exposure->lit > 0))
        HATCH_TRY(add_items(exposure, scene, scratch, err));
    *factor = exposure->lit > 0 ? prescale / white_point(exposure) : 0;
    return HATCH_OK;
}

enum hatch_status hatch_auto_exposure(struct hatch_unit_scene *scene, const struct hatch_pose_span *span,
                                      const struct hatch_view *view, bool per_pixel, struct hatch_arena *scratch,
                                      double *exposure, struct hatch_err *err)
{
    const bool moves = span && scene->scene->light_count > 0;
    const uint32_t moments = moves ? span->moments : 1;
    double least = 0, factor;
    for (uint32_t i = 0; i < moments; i++) {
        struct hatch_arena_mark mark = hatch_arena_mark(scratch);
        if (moves)
            hatch_unit_scene_pose(scene, span->animation, span->times_s ? span->times_s[i] : 0);
        enum hatch_status status = measure(scene, view, per_pixel, scratch, &factor, err);
        hatch_arena_rewind(scratch, mark);
        if (status != HATCH_OK)
            return status;
        least = factor > 0 && !(least > 0 && least < factor) ? factor : least;
    }
    *exposure = least > 0 ? least : 1;
    return HATCH_OK;
}
