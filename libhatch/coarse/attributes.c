/* The attributes that keep a surface finer than its shape needs: texture coordinates, colours, joints and morph
 * targets. */
#include <math.h>
#include <string.h>

#include "coarse/work.h"
#include "math/vector.h"

#define TEXCOORD_SHARE 1.0 /* distance in tolerances by which a texture may move on the surface */
#define FLAT 1e-6          /* of the mean square of a gradient of the mesh: the least that counts */
#define ALIKE_MAX 0.9999   /* square of the cosine between the gradients of u and v: more counts as this */
#define COLOR_MAX 0.03     /* difference of a component of a colour */
#define WEIGHT_MAX 0.05    /* difference of a joint's weight */

/* Computes the products of the gradients of texture coordinates on a face, u u, u v and v v, per square of a mesh unit.
 * Returns the weight of the face in a mean: its area, less for a needle, whose gradients are uncertain; 0: it has none.
 */
static double gradients_of(const struct hatch_mesh *mesh, const float *texcoord, const uint32_t index[3],
                           double products[3])
{
    double at[3][3], side[2][3], normal[3], change[2][2], along[2][3] = {{0, 0, 0}, {0, 0, 0}};
    for (size_t c = 0; c < 3; c++)
        hatch_vec_of(&mesh->attributes[0].data[3 * (size_t)index[c]], at[c]);
    hatch_vec_triangle(at[0], at[1], at[2], normal);
    for (size_t i = 0; i < 2; i++) {
        hatch_vec_sub(at[i + 1], at[0], side[i]);
        for (size_t k = 0; k < 2; k++)
            change[k][i] = (double)texcoord[2 * (size_t)index[i + 1] + k] - (double)texcoord[2 * (size_t)index[0] + k];
    }
    double square = hatch_vec_dot(normal, normal);
    double longest = fmax(fmax(hatch_vec_dot(side[0], side[0]), hatch_vec_dot(side[1], side[1])),
                          pow(hatch_vec_distance(at[1], at[2]), 2));
    if (!(square > 0))
        return 0;
    for (size_t k = 0; k < 2; k++) { /* turned by a right angle, and longer by the length of the normal */
        hatch_vec_add_scaled(along[k], change[k][0], side[1], along[k]);
        hatch_vec_add_scaled(along[k], -change[k][1], side[0], along[k]);
    }
    products[0] = hatch_vec_dot(along[0], along[0]) / square;
    products[1] = hatch_vec_dot(along[0], along[1]) / square;
    products[2] = hatch_vec_dot(along[1], along[1]) / square;
    return square / longest;
}

/* Inverts the products of gradients: the square of a distance on the surface from a difference of u and v. A component
 * that does not change has no length.
 *   mean  of the mesh */
static void invert(const double products[3], const double mean[3], float inverse[3])
{
    double u = fmax(products[0], FLAT * mean[0]), v = fmax(products[2], FLAT * mean[2]);
    double both = u > 0 && v > 0 ? fmin(products[1] * products[1] / (u * v), ALIKE_MAX) : 0, apart = 1 - both;
    inverse[0] = u > 0 ? (float)(1 / (u * apart)) : 0.0f;
    inverse[2] = v > 0 ? (float)(1 / (v * apart)) : 0.0f;
    inverse[1] = both > 0 ? (float)(-copysign(sqrt(both / (u * v)), products[1]) / apart) : 0.0f;
}

/* Computes, per vertex, the squares of lengths on the surface of texture coordinates, in the mean over the faces
 * around. */
static enum hatch_status find_scale(const struct hatch_mesh *mesh, const float *texcoord, struct hatch_arena *arena,
                                    float **scale, struct hatch_err *err)
{
    double *sums, mean[4] = {0, 0, 0, 0};
    HATCH_TRY(HATCH_ALLOC(arena, scale, 3 * (size_t)mesh->vertex_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &sums, 4 * (size_t)mesh->vertex_count, err));
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        const uint32_t *index = &mesh->indices[3 * (size_t)f];
        double products[3] = {0, 0, 0}, weight = gradients_of(mesh, texcoord, index, products);
        for (size_t k = 0; k < 4; k++) {
            double share = k < 3 ? weight * products[k] : weight;
            mean[k] += share;
            for (size_t c = 0; c < 3; c++)
                sums[4 * (size_t)index[c] + k] += share;
        }
    }
    for (size_t k = 0; k < 3; k++)
        mean[k] /= mean[3] > 0 ? mean[3] : 1;
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        double weight = sums[4 * v + 3], *own = &sums[4 * v];
        for (size_t k = 0; k < 3 && weight > 0; k++)
            own[k] /= weight;
        invert(own, mean, *scale + 3 * v);
    }
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

/* Returns the square of the distance by which a texture moves on the surface. */
static double texcoord_error(const struct hatch_coarse_attribute *texcoord, uint32_t sample, const uint32_t vertices[3],
                             const double share[3])
{
    double u = difference(texcoord, 0, sample, vertices, share), v = difference(texcoord, 1, sample, vertices, share);
    const float *scale = &texcoord->scale[3 * (size_t)sample];
    return (double)scale[0] * u * u + 2 * (double)scale[1] * u * v + (double)scale[2] * v * v;
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
    if (attribute->check == HATCH_COARSE_TEXCOORD)
        return texcoord_error(attribute, sample, vertices, share) / (TEXCOORD_SHARE * TEXCOORD_SHARE) /
               (tolerance * tolerance);
    double unit = attribute->check == HATCH_COARSE_COLOR ? COLOR_MAX : tolerance;
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
