/* What the tests of feature lines share: meshes, a view, lengths of chains. */
#ifndef HATCH_TEST_LINES_H
#define HATCH_TEST_LINES_H

#include <math.h>
#include <string.h>

#include "math/vector.h"
#include "mesh/shapes.h"
#include "render-gl/lines_trace.h"
#include "run.h"

static struct hatch_arena keep, scratch;

static inline void begin(void)
{
    hatch_arena_init(&keep, (size_t)1 << 30);
    hatch_arena_init(&scratch, (size_t)1 << 30);
}

static inline void end(void)
{
    ck_assert_ptr_null(hatch_arena_mark(&scratch).block);
    hatch_arena_free(&scratch);
    hatch_arena_free(&keep);
}

static inline struct hatch_mesh mesh_of(const float *positions, uint32_t vertices,
                                        const uint32_t *indices, uint32_t faces)
{
    struct hatch_mesh mesh;
    struct hatch_err err;
    HATCH_TEST_OK(hatch_mesh_make(&keep, vertices, faces, &mesh, &err), &err);
    memcpy(mesh.attributes[0].data, positions, vertices * 12);
    memcpy(mesh.indices, indices, faces * 12);
    return mesh;
}

static inline struct hatch_mesh shape_of(enum hatch_shape shape, uint32_t faces)
{
    struct hatch_mesh mesh;
    struct hatch_err err;
    const struct hatch_shape_options options = {.faces = faces};
    HATCH_TEST_OK(hatch_shape_make(shape, &options, &keep, &scratch, &mesh, &err), &err);
    return mesh;
}

/* Two by two by two, every corner once, without normals. */
static inline struct hatch_mesh cube(void)
{
    static const uint32_t quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    float positions[24];
    uint32_t indices[36];
    for (uint32_t v = 0; v < 8; v++)
        for (uint32_t k = 0; k < 3; k++)
            positions[3 * v + k] = v >> k & 1 ? 1.0f : -1.0f;
    for (uint32_t q = 0; q < 6; q++)
        for (uint32_t i = 0; i < 6; i++)
            indices[6 * q + i] = quads[q][(const uint32_t[]){0, 1, 2, 0, 2, 3}[i]];
    return mesh_of(positions, 8, indices, 12);
}

/* The same faces, each with corners of its own. */
static inline struct hatch_mesh unwelded(const struct hatch_mesh *mesh)
{
    struct hatch_mesh apart;
    struct hatch_err err;
    float *data;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 3 * mesh->face_count, mesh->face_count, &apart, &err), &err);
    for (uint32_t i = 0; i < mesh->attribute_count; i++) {
        const struct hatch_mesh_attribute *from = &mesh->attributes[i];
        data = apart.attributes[0].data;
        if (i > 0)
            HATCH_TEST_OK(
                hatch_mesh_add(&keep, &apart, from->name, from->components, &data, &err), &err);
        for (uint32_t c = 0; c < 3 * mesh->face_count; c++)
            memcpy(data + from->components * c, from->data + from->components * mesh->indices[c],
                   from->components * sizeof *data);
    }
    for (uint32_t c = 0; c < 3 * mesh->face_count; c++)
        apart.indices[c] = c;
    return apart;
}

static inline struct line_mesh lines_of(const struct hatch_mesh *mesh, uint32_t kinds,
                                        double crease_rad)
{
    static const double origin[3] = {0, 0, 0};
    const struct line_choice choice = {kinds, crease_rad, false};
    struct line_mesh lines = {.skinned = true};
    struct hatch_err err;
    HATCH_TEST_OK(line_mesh_make(mesh, origin, &choice, &keep, &scratch, &lines, &err), &err);
    return lines;
}

/* 400 pixels high; looks at the middle. */
static inline struct view view_from(double x, double y, double z, bool orthographic)
{
    struct view view = {.eye = {x, y, z}, .orthographic = orthographic, .aspect = 1};
    view.half_height = orthographic ? 2 : 0.5;
    view.near = 1e-3;
    view.far = 100;
    view_set_back(&view, view.eye);
    return view;
}

static inline struct line_shape shape_in_place(const struct line_mesh *lines)
{
    struct line_shape shape = {.lines = lines,
                               .positions = lines->mesh.attributes[0].data,
                               .normals = hatch_mesh_find(&lines->mesh, "NORMAL", 3),
                               .double_sided = true};
    for (int i = 0; i < 16; i += 5)
        shape.to_unit[i] = 1;
    return shape;
}

static inline struct line_trace silhouettes_of(const struct line_shape *shape,
                                               const struct view *view)
{
    const struct line_eye eye = {view, 200 / view->half_height};
    struct line_trace trace = {.node_count = 0};
    struct hatch_err err;
    HATCH_TEST_OK(line_trace_silhouettes(shape, &eye, &keep, &scratch, &trace, &err), &err);
    return trace;
}

static inline struct line_chains chains_of(const struct line_trace *trace)
{
    const struct line_graph graph = {trace->node_count, trace->segment_count, trace->nodes,
                                     trace->ends};
    struct line_chains chains = {.count = 0};
    struct hatch_err err;
    HATCH_TEST_OK(line_chains_make(&graph, &keep, &scratch, &chains, &err), &err);
    return chains;
}

static inline double length_of(const struct line_trace *trace)
{
    double length = 0;
    for (uint32_t s = 0; s < trace->segment_count; s++)
        length += hatch_vec_distance(&trace->nodes[3 * trace->ends[2 * s]],
                                     &trace->nodes[3 * trace->ends[2 * s + 1]]);
    return length;
}

#endif
