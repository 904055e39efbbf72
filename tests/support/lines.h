/* Support for tests of feature lines: unwelded meshes, views, traces and chains. */
#ifndef HATCH_TEST_LINES_H
#define HATCH_TEST_LINES_H

#include <math.h>
#include <string.h>

#include "math/vector.h"
#include "meshes.h"
#include "line/trace.h"

/* Returns a copy in which every face corner has a vertex of its own. */
static inline struct hatch_mesh unwelded(const struct hatch_mesh *mesh)
{
    struct hatch_mesh apart;
    float *data;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 3 * mesh->face_count, mesh->face_count, &apart, &err), &err);
    for (uint32_t i = 0; i < mesh->attribute_count; i++) {
        const struct hatch_mesh_attribute *from = &mesh->attributes[i];
        data = apart.attributes[0].data;
        if (i > 0)
            HATCH_TEST_OK(hatch_mesh_add(&keep, &apart, from->name, from->components, &data, &err), &err);
        for (uint32_t c = 0; c < 3 * mesh->face_count; c++)
            memcpy(data + from->components * c, from->data + from->components * mesh->indices[c],
                   from->components * sizeof *data);
    }
    for (uint32_t c = 0; c < 3 * mesh->face_count; c++)
        apart.indices[c] = c;
    return apart;
}

static inline struct hatch_line_mesh lines_of(const struct hatch_mesh *mesh, uint32_t kinds, double crease_rad)
{
    static const double origin[3] = {0, 0, 0};
    const struct hatch_line_choice choice = {.kinds = kinds, .crease_rad = crease_rad};
    struct hatch_line_mesh lines;
    HATCH_TEST_OK(hatch_line_mesh_make(mesh, NULL, origin, &choice, &keep, &scratch, &lines, &err), &err);
    return lines;
}

/* Returns a view of the origin from (x, y, z). */
static inline struct hatch_view view_from(double x, double y, double z, bool orthographic)
{
    struct hatch_view view = {.eye = {x, y, z}, .orthographic = orthographic, .aspect = 1};
    view.half_height = orthographic ? 2 : 0.5;
    view.near = 1e-3;
    view.far = 100;
    hatch_view_set_back(&view, view.eye);
    return view;
}

/* Makes all faces of a shape visible from behind, or none. */
static inline void set_sides(struct hatch_line_shape *shape, bool double_sided)
{
    uint8_t *sides = HATCH_NEW(&keep, uint8_t, shape->lines->mesh.face_count, &err);
    memset(sides, double_sided, shape->lines->mesh.face_count);
    shape->double_sided = sides;
}

static inline struct hatch_line_shape shape_in_place(const struct hatch_line_mesh *lines)
{
    struct hatch_line_shape shape = {.lines = lines, .positions = lines->mesh.attributes[0].data};
    set_sides(&shape, true);
    for (int i = 0; i < 16; i += 5)
        shape.to_unit[i] = 1;
    return shape;
}

static inline struct hatch_line_trace silhouettes_of(const struct hatch_line_shape *shape,
                                                     const struct hatch_view *view)
{
    const struct hatch_line_eye eye = {view, 200 / view->half_height};
    struct hatch_line_trace trace = {.node_count = 0};
    HATCH_TEST_OK(hatch_line_trace_silhouettes(shape, &eye, &keep, &scratch, &trace, &err), &err);
    return trace;
}

static inline struct hatch_line_chains chains_of(const struct hatch_line_trace *trace)
{
    const struct hatch_line_graph graph = {trace->node_count, trace->segment_count, trace->nodes, trace->ends};
    struct hatch_line_chains chains = {.count = 0};
    HATCH_TEST_OK(hatch_line_chains_make(&graph, &keep, &scratch, &chains, &err), &err);
    return chains;
}

static inline double length_of(const struct hatch_line_trace *trace)
{
    double length = 0;
    for (uint32_t s = 0; s < trace->segment_count; s++)
        length += hatch_vec_distance(&trace->nodes[3 * trace->ends[2 * s]], &trace->nodes[3 * trace->ends[2 * s + 1]]);
    return length;
}

#endif
