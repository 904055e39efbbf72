#include "mesh/mesh.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "math/vector.h"

enum hatch_status hatch_mesh_make(struct hatch_arena *arena, uint32_t vertex_count, uint32_t face_count,
                                  struct hatch_mesh *mesh, struct hatch_err *err)
{
    struct hatch_mesh made = {.vertex_count = vertex_count, .face_count = face_count};
    HATCH_TRY(HATCH_ALLOC(arena, &made.indices, (size_t)face_count * 3, err));
    float *positions;
    HATCH_TRY(hatch_mesh_add(arena, &made, "POSITION", 3, &positions, err));
    *mesh = made;
    return HATCH_OK;
}

enum hatch_status hatch_mesh_add(struct hatch_arena *arena, struct hatch_mesh *mesh, const char *name,
                                 uint32_t components, float **data, struct hatch_err *err)
{
    assert(components >= 1);
    assert(strlen(name) < HATCH_MESH_NAME_MAX);
    if (mesh->attribute_count >= HATCH_MESH_ATTRIBUTES_MAX)
        return hatch_fail(err, HATCH_LIMIT, "attribute %s: a mesh has at most %u attributes", name,
                          HATCH_MESH_ATTRIBUTES_MAX);
    float *floats;
    HATCH_TRY(HATCH_ALLOC(arena, &floats, (size_t)mesh->vertex_count * components, err));
    struct hatch_mesh_attribute *attribute = &mesh->attributes[mesh->attribute_count++];
    memcpy(attribute->name, name, strlen(name) + 1);
    attribute->components = components;
    attribute->data = floats;
    *data = floats;
    return HATCH_OK;
}

enum hatch_status hatch_mesh_gather(const struct hatch_mesh *from, const uint32_t *origin, uint32_t vertex_count,
                                    uint32_t face_count, struct hatch_arena *arena, struct hatch_mesh *mesh,
                                    struct hatch_err *err)
{
    struct hatch_mesh made = {.vertex_count = vertex_count, .face_count = face_count};
    HATCH_TRY(HATCH_ALLOC(arena, &made.indices, (size_t)face_count * 3, err));
    for (uint32_t i = 0; i < from->attribute_count; i++) {
        const struct hatch_mesh_attribute *attribute = &from->attributes[i];
        size_t n = attribute->components;
        float *data;
        HATCH_TRY(hatch_mesh_add(arena, &made, attribute->name, attribute->components, &data, err));
        for (uint32_t v = 0; v < vertex_count; v++)
            memcpy(&data[v * n], &attribute->data[origin[v] * n], n * sizeof *data);
    }
    *mesh = made;
    return HATCH_OK;
}

const struct hatch_mesh_attribute *hatch_mesh_attribute(const struct hatch_mesh *mesh, const char *name)
{
    for (uint32_t i = 0; i < mesh->attribute_count; i++)
        if (strcmp(mesh->attributes[i].name, name) == 0)
            return &mesh->attributes[i];
    return NULL;
}

uint32_t hatch_mesh_target_count(const struct hatch_mesh *mesh)
{
    const struct hatch_mesh_attribute *morph = hatch_mesh_attribute(mesh, HATCH_MORPH_POSITION);
    return morph ? morph->components / 3 : 0;
}

float *hatch_mesh_find(const struct hatch_mesh *mesh, const char *name, uint32_t components)
{
    const struct hatch_mesh_attribute *found = hatch_mesh_attribute(mesh, name);
    return found && found->components == components ? found->data : NULL;
}

bool hatch_mesh_corners(const struct hatch_mesh *mesh, uint32_t face, double corners[3][3])
{
    const uint32_t *index = &mesh->indices[(size_t)face * 3];
    for (int c = 0; c < 3; c++)
        hatch_vec_of(&mesh->attributes[0].data[(size_t)index[c] * 3], corners[c]);
    double normal[3];
    hatch_vec_triangle(corners[0], corners[1], corners[2], normal);
    return hatch_vec_dot(normal, normal) > 0;
}

double hatch_mesh_face_area(const struct hatch_mesh *mesh, uint32_t face)
{
    double corners[3][3], normal[3];
    hatch_mesh_corners(mesh, face, corners);
    hatch_vec_triangle(corners[0], corners[1], corners[2], normal);
    return hatch_vec_length(normal) / 2;
}

static enum hatch_status check_positions(const struct hatch_mesh *mesh, struct hatch_err *err)
{
    const float *positions = mesh->attributes[0].data;
    for (size_t i = 0; i < (size_t)mesh->vertex_count * 3; i++)
        if (!isfinite(positions[i]))
            return hatch_fail(err, HATCH_BAD_INPUT, "vertex %zu: position is not finite", i / 3);
    return HATCH_OK;
}

enum hatch_status hatch_mesh_check(const struct hatch_mesh *mesh, struct hatch_err *err)
{
    assert(mesh->attribute_count > 0 && strcmp(mesh->attributes[0].name, "POSITION") == 0);
    if (mesh->face_count == 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "no faces");
    for (size_t i = 0; i < (size_t)mesh->face_count * 3; i++)
        if (mesh->indices[i] >= mesh->vertex_count)
            return hatch_fail(err, HATCH_BAD_INPUT, "face %zu: vertex index %u, want one below %u", i / 3,
                              mesh->indices[i], mesh->vertex_count);
    HATCH_TRY(check_positions(mesh, err));
    double corners[3][3];
    for (uint32_t f = 0; f < mesh->face_count; f++)
        if (hatch_mesh_corners(mesh, f, corners))
            return HATCH_OK;
    return hatch_fail(err, HATCH_BAD_INPUT, "no face has an area");
}

/* Returns whether a face has one position alone, as those have that some scanners write for missing ones. */
static bool is_one_point(const struct hatch_mesh *mesh, size_t face)
{
    const float *positions = mesh->attributes[0].data;
    const uint32_t *corner = &mesh->indices[3 * face];
    for (size_t k = 0; k < 3; k++)
        for (size_t c = 1; c < 3; c++)
            if (positions[3 * (size_t)corner[c] + k] < positions[3 * (size_t)corner[0] + k] ||
                positions[3 * (size_t)corner[c] + k] > positions[3 * (size_t)corner[0] + k])
                return false;
    return true;
}

bool hatch_mesh_bounds(const struct hatch_mesh *mesh, float low[3], float high[3])
{
    const float *positions = mesh->attributes[0].data;
    bool any = false;
    for (size_t i = 0; i < (size_t)mesh->face_count * 3; i++) {
        const float *p = &positions[(size_t)mesh->indices[i] * 3];
        if (i % 3 == 0 && is_one_point(mesh, i / 3)) {
            i += 2;
            continue;
        }
        for (int k = 0; k < 3; k++) {
            if (!any || p[k] < low[k])
                low[k] = p[k];
            if (!any || p[k] > high[k])
                high[k] = p[k];
        }
        any = true;
    }
    return any;
}

double hatch_mesh_diagonal(const struct hatch_mesh *mesh)
{
    float low[3], high[3];
    double a[3], b[3];
    if (!hatch_mesh_bounds(mesh, low, high))
        return 0;
    hatch_vec_of(low, a);
    hatch_vec_of(high, b);
    return hatch_vec_distance(a, b);
}
