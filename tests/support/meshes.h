/* Meshes for tests, made in keep; with POSITION alone unless stated otherwise. */
#ifndef HATCH_TEST_MESHES_H
#define HATCH_TEST_MESHES_H

#include <math.h>
#include <string.h>

#include "arenas.h"
#include "shapes/shapes.h"

#define PI 3.14159265358979323846

static inline struct hatch_mesh mesh_of(const float *positions, uint32_t vertices, const uint32_t *indices,
                                        uint32_t faces)
{
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, vertices, faces, &mesh, &err), &err);
    memcpy(mesh.attributes[0].data, positions, vertices * 12);
    memcpy(mesh.indices, indices, faces * 12);
    return mesh;
}

/* Makes a built-in shape with all its attributes. */
static inline struct hatch_mesh shape_with(enum hatch_shape kind, struct hatch_shape_options options)
{
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_shape_make(kind, &options, &keep, &scratch, &mesh, &err), &err);
    return mesh;
}

static inline struct hatch_mesh shape_of(enum hatch_shape kind, uint32_t faces)
{
    return shape_with(kind, (struct hatch_shape_options){.faces = faces});
}

static inline struct hatch_mesh bare_shape(enum hatch_shape kind, uint32_t faces)
{
    struct hatch_mesh mesh = shape_of(kind, faces);
    mesh.attribute_count = 1;
    return mesh;
}

/* Makes a flat fan of count faces around its last point. */
static inline struct hatch_mesh fan(uint32_t count)
{
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, count + 1, count, &mesh, &err), &err);
    for (uint32_t i = 0; i < count; i++) {
        mesh.attributes[0].data[3 * i] = (float)cos(2 * PI * i / count);
        mesh.attributes[0].data[3 * i + 1] = (float)sin(2 * PI * i / count);
        const uint32_t face[3] = {i, (i + 1) % count, count};
        memcpy(&mesh.indices[3 * (size_t)i], face, sizeof face);
    }
    return mesh;
}

/* Makes a band of n by width squares, closed into a ring.
 *   twisted  true: a Möbius strip */
static inline struct hatch_mesh band(uint32_t n, uint32_t width, bool twisted)
{
    struct hatch_mesh mesh;
    uint32_t rows = width + 1;
    HATCH_TEST_OK(hatch_mesh_make(&keep, rows * n, 2 * n * width, &mesh, &err), &err);
    for (uint32_t i = 0; i < n * rows; i++) {
        double a = 2 * PI * (i / rows) / n, tilt = twisted ? a / 2 : 0;
        double across = 0.6 * (i % rows) / width - 0.3, radius = 1 + across * sin(tilt);
        float *p = &mesh.attributes[0].data[3 * i];
        p[0] = (float)(radius * cos(a));
        p[1] = (float)(across * cos(tilt));
        p[2] = (float)(radius * sin(a));
    }
    for (uint32_t q = 0; q < n * width; q++) {
        uint32_t i = q / width, j = q % width, a = i * rows + j, b = a + 1, next = (i + 1) % n * rows;
        bool swap = twisted && i + 1 == n;
        uint32_t c = next + (swap ? width - j : j), d = swap ? c - 1 : c + 1;
        const uint32_t faces[6] = {a, b, c, b, d, c};
        memcpy(&mesh.indices[6 * q], faces, sizeof faces);
    }
    return mesh;
}

/* Makes the figure-8 immersion of a Klein bottle, of m by n squares, n even. It intersects itself, but no two vertices
 * coincide there. */
static inline struct hatch_mesh klein(uint32_t m, uint32_t n)
{
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, m * n, 2 * m * n, &mesh, &err), &err);
    for (uint32_t i = 0; i < m; i++)
        for (uint32_t j = 0; j < n; j++) {
            double u = 2 * PI * i / m, v = 2 * PI * (j + 0.5) / n;
            double r = 3 + cos(u / 2) * sin(v) - sin(u / 2) * sin(2 * v);
            float *p = &mesh.attributes[0].data[(i * n + j) * 3];
            p[0] = (float)(r * cos(u));
            p[1] = (float)(r * sin(u));
            p[2] = (float)(sin(u / 2) * sin(v) + cos(u / 2) * sin(2 * v));
            uint32_t k = (j + 1) % n, last = i + 1 == m, row = (i + 1) % m * n;
            uint32_t a = i * n + j, b = i * n + k;
            uint32_t c = row + (last ? n - 1 - j : j), d = row + (last ? n - 1 - k : k);
            const uint32_t faces[6] = {a, c, b, b, c, d};
            memcpy(&mesh.indices[(i * n + j) * 6], faces, sizeof faces);
        }
    return mesh;
}

/* Returns a copy in which every face corner has a vertex of its own and the faces are in reverse order. */
static inline struct hatch_mesh soup(const struct hatch_mesh *from)
{
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, from->face_count * 3, from->face_count, &mesh, &err), &err);
    for (uint32_t i = 0; i < from->face_count * 3; i++) {
        uint32_t source = from->face_count * 3 - 1 - i;
        source = source - source % 3 + (2 - source % 3); /* keep the order of corners in a face */
        mesh.indices[i] = i;
        memcpy(&mesh.attributes[0].data[i * 3], &from->attributes[0].data[from->indices[source] * 3], 12);
    }
    return mesh;
}

/* Makes a cube with eight vertices. */
static inline struct hatch_mesh cube(float low, float high)
{
    static const uint32_t quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    float positions[24];
    uint32_t faces[36];
    for (int i = 0; i < 24; i++)
        positions[i] = i / 3 >> i % 3 & 1 ? high : low;
    for (int q = 0; q < 6; q++) {
        static const int corners[6] = {0, 1, 2, 0, 2, 3};
        for (int i = 0; i < 6; i++)
            faces[q * 6 + i] = quads[q][corners[i]];
    }
    return mesh_of(positions, 8, faces, 12);
}

/* Makes a cube from -1 to 1 whose eight corners are cut off as triangles, which lean 55 degrees from its six octagons.
 *   cut  0 .. 1: length that the edges lose at each end */
static inline struct hatch_mesh clipped_cube(float cut)
{
    float positions[72];
    uint32_t faces[3 * 44], *at = faces;
    for (uint32_t i = 0; i < 72; i++) /* vertex 3 * c + a lies on the edge along axis a that ends at corner c */
        positions[i] = (i / 9 >> i % 3 & 1 ? 1.0f : -1.0f) * (i / 3 % 3 == i % 3 ? 1 - cut : 1);
    for (uint32_t c = 0; c < 8; c++, at += 3) {
        const uint32_t odd = (c ^ c >> 1 ^ c >> 2) & 1, corner[3] = {3 * c, 3 * c + 2 - odd, 3 * c + 1 + odd};
        memcpy(at, corner, sizeof corner);
    }
    for (uint32_t side = 0; side < 6; side++) {
        uint32_t axis = side / 2, u = (axis + 1) % 3, v = (axis + 2) % 3, round[8];
        for (uint32_t k = 0; k < 4; k++) {
            uint32_t c = (side % 2) << axis | (uint32_t)(k == 1 || k == 2) << u | (uint32_t)(k > 1) << v;
            round[2 * k] = 3 * c + (k % 2 ? u : v);
            round[2 * k + 1] = 3 * c + (k % 2 ? v : u);
        }
        for (uint32_t k = 1; k < 7; k++, at += 3) {
            const uint32_t face[3] = {round[0], round[side % 2 ? k : k + 1], round[side % 2 ? k + 1 : k]};
            memcpy(at, face, sizeof face);
        }
    }
    return mesh_of(positions, 24, faces, 44);
}

static inline void turn(struct hatch_mesh *mesh, uint32_t face)
{
    uint32_t *index = &mesh->indices[face * 3], swap = index[1];
    index[1] = index[2];
    index[2] = swap;
}

/* Joins two meshes; a's vertices and faces come first. */
static inline struct hatch_mesh both(const struct hatch_mesh *a, const struct hatch_mesh *b)
{
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, a->vertex_count + b->vertex_count, a->face_count + b->face_count, &mesh, &err),
                  &err);
    memcpy(mesh.attributes[0].data, a->attributes[0].data, a->vertex_count * 12);
    memcpy(mesh.attributes[0].data + 3 * a->vertex_count, b->attributes[0].data, b->vertex_count * 12);
    memcpy(mesh.indices, a->indices, a->face_count * 12);
    for (uint32_t i = 0; i < 3 * b->face_count; i++)
        mesh.indices[3 * a->face_count + i] = a->vertex_count + b->indices[i];
    return mesh;
}

static inline void move(struct hatch_mesh *mesh, float scale, float x)
{
    float *p = mesh->attributes[0].data;
    for (uint32_t i = 0; i < 3 * mesh->vertex_count; i++)
        p[i] = p[i] * scale + (i % 3 ? 0 : x);
}

/* Gives every vertex one of two joints. */
static inline void add_joints(struct hatch_mesh *mesh)
{
    float *joint, *weight;
    HATCH_TEST_OK(hatch_mesh_add(&keep, mesh, "JOINTS_0", 4, &joint, &err), &err);
    HATCH_TEST_OK(hatch_mesh_add(&keep, mesh, "WEIGHTS_0", 4, &weight, &err), &err);
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        joint[4 * v] = (float)(v % 2);
        weight[4 * v] = 1;
    }
}

/* Adds two morph targets, of positions and normals. */
static inline void add_targets(struct hatch_mesh *mesh)
{
    float *displacements, *normals;
    HATCH_TEST_OK(hatch_mesh_add(&keep, mesh, HATCH_MORPH_POSITION, 6, &displacements, &err), &err);
    HATCH_TEST_OK(hatch_mesh_add(&keep, mesh, HATCH_MORPH_NORMAL, 6, &normals, &err), &err);
    for (uint32_t i = 0; i < 6 * mesh->vertex_count; i++) {
        displacements[i] = 0.5f * (float)(i % 7);
        normals[i] = -0.1f * (float)(i % 5);
    }
}

#endif
