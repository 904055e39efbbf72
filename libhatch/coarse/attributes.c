/* The attributes that keep a surface finer than its shape needs: texture coordinates, colours, joints and morph
 * targets. */
#include <math.h>
#include <string.h>

#include "coarse/work.h"
#include "math/vector.h"

#define TEXCOORD_SHARE 1.0 /* distance in tolerances by which a texture may move on the surface */
#define COLOR_MAX 0.03     /* difference of a component of a colour */
#define WEIGHT_MAX 0.05    /* difference of a joint's weight */

/* Computes, per vertex, the mean length on the surface of a unit of texture coordinates: the square root of the areas'
 * ratio, over the faces around. */
static enum hatch_status find_scale(const struct hatch_mesh *mesh, const float *texcoord, struct hatch_arena *arena,
                                    float **scale, struct hatch_err *err)
{
    double *areas, area[2];
    HATCH_TRY(HATCH_ALLOC(arena, scale, mesh->vertex_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &areas, 2 * (size_t)mesh->vertex_count, err));
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        const uint32_t *index = &mesh->indices[3 * (size_t)f];
        double corners[3][3], normal[3], uv[3][2];
        hatch_mesh_corners(mesh, f, corners);
        hatch_vec_triangle(corners[0], corners[1], corners[2], normal);
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < 2; k++)
                uv[c][k] = (double)texcoord[2 * (size_t)index[c] + (size_t)k];
        area[0] = hatch_vec_length(normal);
        area[1] = fabs((uv[1][0] - uv[0][0]) * (uv[2][1] - uv[0][1]) - (uv[2][0] - uv[0][0]) * (uv[1][1] - uv[0][1]));
        for (size_t c = 0; c < 3; c++)
            for (size_t k = 0; k < 2; k++)
                areas[2 * (size_t)index[c] + k] += area[k];
    }
    for (size_t v = 0; v < mesh->vertex_count; v++)
        (*scale)[v] = areas[2 * v + 1] > 0 ? (float)sqrt(areas[2 * v] / areas[2 * v + 1]) : 0.0f;
    return HATCH_OK;
}

static enum hatch_status add_check(struct hatch_coarse_checks *checks, const struct hatch_mesh *mesh,
                                   const struct hatch_mesh_attribute *from, struct hatch_arena *arena,
                                   struct hatch_err *err)
{
    static const struct {
        const char *prefix;
        enum hatch_coarse_check check;
    } kinds[] = {{"TEXCOORD_", HATCH_COARSE_TEXCOORD},
                 {"COLOR_", HATCH_COARSE_COLOR},
                 {"WEIGHTS_0", HATCH_COARSE_WEIGHTS},
                 {HATCH_MORPH_POSITION, HATCH_COARSE_MORPH}};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        if (strncmp(from->name, kinds[i].prefix, strlen(kinds[i].prefix)) != 0)
            continue;
        struct hatch_coarse_attribute *made = &checks->attributes[checks->count];
        *made = (struct hatch_coarse_attribute){kinds[i].check, from->components, from->data, NULL, NULL};
        if (made->check == HATCH_COARSE_TEXCOORD)
            HATCH_TRY(find_scale(mesh, from->data, arena, &made->scale, err));
        if (made->check == HATCH_COARSE_WEIGHTS)
            made->joints = hatch_mesh_find(mesh, "JOINTS_0", 4);
        checks->count += made->check != HATCH_COARSE_WEIGHTS || made->joints;
    }
    return HATCH_OK;
}

enum hatch_status hatch_coarse_checks_make(struct hatch_coarse_work *work, struct hatch_arena *arena,
                                           struct hatch_err *err)
{
    HATCH_TRY(HATCH_ALLOC(arena, &work->checks, work->part_count, err));
    for (uint32_t part = 0; part < work->part_count; part++) {
        const struct hatch_mesh *mesh = work->parts[part].mesh;
        work->checks[part].normals = hatch_mesh_find(mesh, "NORMAL", 3);
        for (uint32_t a = 0; a < mesh->attribute_count; a++)
            HATCH_TRY(add_check(&work->checks[part], mesh, &mesh->attributes[a], arena, err));
    }
    return HATCH_OK;
}

/* Returns the difference of a component: the sample's value less that of the face. */
static double difference(const struct hatch_coarse_attribute *attribute, uint32_t component, uint32_t sample,
                         const uint32_t vertices[3], const double share[3])
{
    size_t n = attribute->components;
    double sum = (double)attribute->data[n * sample + component];
    for (int c = 0; c < 3; c++)
        sum -= share[c] * (double)attribute->data[n * vertices[c] + component];
    return sum;
}

/* Returns the weight of a joint at a vertex. */
static double weight_of(const struct hatch_coarse_attribute *weights, uint32_t vertex, float joint)
{
    double sum = 0;
    for (size_t k = 0; k < 4; k++)
        if (weights->joints[4 * (size_t)vertex + k] == joint)
            sum += (double)weights->data[4 * (size_t)vertex + k];
    return sum;
}

/* Returns the largest difference of the weights of any joint. */
static double weights_difference(const struct hatch_coarse_attribute *weights, uint32_t sample,
                                 const uint32_t vertices[3], const double share[3])
{
    const uint32_t all[4] = {sample, vertices[0], vertices[1], vertices[2]};
    double largest = 0;
    for (int i = 0; i < 4; i++)
        for (size_t k = 0; k < 4; k++) {
            float joint = weights->joints[4 * (size_t)all[i] + k];
            double sum = weight_of(weights, sample, joint);
            for (int c = 0; c < 3; c++)
                sum -= share[c] * weight_of(weights, vertices[c], joint);
            largest = fmax(largest, fabs(sum));
        }
    return largest;
}

/* Returns the square of an attribute's error.
 *   tolerance  of the sample */
static double error_of(const struct hatch_coarse_attribute *attribute, uint32_t sample, const uint32_t vertices[3],
                       const double share[3], double tolerance)
{
    double sum = 0, largest = 0;
    if (attribute->check == HATCH_COARSE_WEIGHTS) {
        largest = weights_difference(attribute, sample, vertices, share) / WEIGHT_MAX;
        return largest * largest;
    }
    double unit = attribute->check == HATCH_COARSE_TEXCOORD
                      ? TEXCOORD_SHARE * tolerance / (double)attribute->scale[sample]
                  : attribute->check == HATCH_COARSE_COLOR ? COLOR_MAX
                                                           : tolerance;
    for (uint32_t c = 0; c < attribute->components; c++) {
        if (attribute->check == HATCH_COARSE_MORPH && c % 3 == 0)
            sum = 0;
        double by = difference(attribute, c, sample, vertices, share) / unit;
        sum = attribute->check == HATCH_COARSE_COLOR ? by * by : sum + by * by;
        largest = fmax(largest, sum);
    }
    return largest;
}

double hatch_coarse_attribute_error(const struct hatch_coarse_work *work, uint32_t part, uint32_t sample,
                                    const uint32_t wedges[3], const double share[3])
{
    const struct hatch_coarse_checks *checks = &work->checks[part];
    uint32_t first = work->first_wedge[part], vertices[3] = {wedges[0] - first, wedges[1] - first, wedges[2] - first};
    double largest = 0;
    for (uint32_t i = 0; i < checks->count; i++)
        largest = fmax(largest, error_of(&checks->attributes[i], sample - first, vertices, share,
                                         work->tolerance[work->point_of[sample]]));
    return largest;
}
