/* --arrows. Rhombi are made of triangles, since many viewers do not draw the edges of a PLY. */
#include <math.h>

#include "dirfield.h"
#include "math/vector.h"

/* In mean edge lengths at the point. */
#define HALF_LENGTH 0.4
#define HALF_WIDTH 0.07
#define LIFT 0.04 /* off the surface, which would otherwise hide half of each rhombus */

#define CORNERS 4u
#define VERTEX_BYTES 15u /* three floats, three bytes */

static void check(enum hatch_status status, const struct hatch_err *err)
{
    cmd_check(status, NULL, err);
}

void dirfield_arrows_begin(struct dirfield_arrows *arrows, struct cmd_args *args)
{
    *arrows = (struct dirfield_arrows){.vertices = {.arena = &args->keep}};
}

/* Violet for confidence 0, green for 1/2, yellow for 1; lightness rises evenly. */
static void color_of(double confidence, uint8_t rgb[3])
{
    static const double stops[3][3] = {{68, 1, 84}, {33, 145, 140}, {253, 231, 37}};
    double at = 2 * fmin(1, fmax(0, confidence));
    int from = at < 1 ? 0 : 1;
    for (int k = 0; k < 3; k++)
        rgb[k] = (uint8_t)lround(stops[from][k] + (at - from) * (stops[from + 1][k] - stops[from][k]));
}

static double edge_length(const struct hatch_surface *surface, uint32_t point)
{
    const double *at = &surface->points[3 * (size_t)point];
    double sum = 0;
    uint32_t first = surface->ring_first[point], end = surface->ring_first[point + 1];
    for (uint32_t i = first; i < end; i++)
        sum += hatch_vec_distance(at, &surface->points[3 * (size_t)surface->ring_point[i]]);
    return sum / (end - first) * surface->components[surface->point_component[point]].scale;
}

static void put_corner(struct dirfield_arrows *arrows, const struct dirfield_pose *pose, const double at[3],
                       const uint8_t rgb[3])
{
    struct hatch_err err;
    double in_scene[3];
    dirfield_to_scene(pose, at, in_scene);
    for (int k = 0; k < 3; k++) {
        union {
            float number;
            uint32_t bits;
        } word = {.number = (float)in_scene[k]};
        check(hatch_buffer_add_u32le(&arrows->vertices, word.bits, &err), &err);
    }
    check(hatch_buffer_add(&arrows->vertices, rgb, 3, &err), &err);
}

static void put_rhombus(struct dirfield_arrows *arrows, const struct dirfield_job *job,
                        const struct dirfield_pose *pose, uint32_t point)
{
    const double *along = &job->field.direction[3 * (size_t)point];
    const double *normal = &job->frames.normal[3 * (size_t)point];
    double middle[3], across[3], corner[3], length = edge_length(job->surface, point);
    uint8_t rgb[3];
    color_of(job->field.confidence[point], rgb);
    hatch_surface_position(job->surface, point, middle);
    hatch_vec_add_scaled(middle, LIFT * length, normal, middle);
    hatch_vec_cross(normal, along, across);
    for (uint32_t c = 0; c < CORNERS; c++) {
        double sign = c < CORNERS / 2 ? length : -length;
        hatch_vec_add_scaled(middle, sign * (c % 2 ? HALF_WIDTH : HALF_LENGTH), c % 2 ? across : along, corner);
        put_corner(arrows, pose, corner, rgb);
    }
    arrows->count++;
}

void dirfield_arrows_add(struct dirfield_arrows *arrows, const struct dirfield_job *job)
{
    struct hatch_err err;
    for (uint32_t i = 0; i < job->pose_count; i++) {
        check(hatch_buffer_reserve(&arrows->vertices, (size_t)job->surface->point_count * CORNERS * VERTEX_BYTES, &err),
              &err);
        for (uint32_t p = 0; p < job->surface->point_count; p++)
            put_rhombus(arrows, job, &job->poses[i], p);
    }
}

struct hatch_bytes dirfield_arrows_end(struct dirfield_arrows *arrows)
{
    struct hatch_err err;
    struct hatch_buffer file = {.arena = arrows->vertices.arena};
    check(hatch_buffer_print(&file, &err,
                             "ply\nformat binary_little_endian 1.0\n"
                             "comment a direction field: color is confidence, violet for 0 to yellow for 1\n"
                             "element vertex %u\nproperty float x\nproperty float y\nproperty float z\n"
                             "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                             "element face %u\nproperty list uchar int vertex_indices\nend_header\n",
                             CORNERS * arrows->count, 2 * arrows->count),
          &err);
    check(hatch_buffer_reserve(&file, arrows->vertices.size + (size_t)arrows->count * 26, &err), &err);
    check(hatch_buffer_add(&file, arrows->vertices.data, arrows->vertices.size, &err), &err);
    for (uint32_t i = 0; i < 2 * arrows->count; i++) {
        static const uint8_t three = 3;
        static const uint32_t halves[2][3] = {{0, 1, 2}, {0, 2, 3}};
        check(hatch_buffer_add(&file, &three, 1, &err), &err);
        for (int c = 0; c < 3; c++)
            check(hatch_buffer_add_u32le(&file, CORNERS * (i / 2) + halves[i % 2][c], &err), &err);
    }
    return (struct hatch_bytes){file.data, file.size};
}
