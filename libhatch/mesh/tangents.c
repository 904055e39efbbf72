#include <assert.h>

#include "math/vector.h"
#include "mesh/mesh.h"

/* Adds a face's unit directions of increasing u and decreasing v, weighted by its area, to the sums of its vertices.
 *   sums  6 per vertex */
static void add_face(const struct hatch_mesh *mesh, uint32_t face, const float *texcoords, double *sums)
{
    const uint32_t *index = &mesh->indices[(size_t)face * 3];
    double p[3][3], a[3], b[3], normal[3], along_u[3], along_v[3];
    if (!hatch_mesh_corners(mesh, face, p))
        return;
    hatch_vec_sub(p[1], p[0], a);
    hatch_vec_sub(p[2], p[0], b);
    hatch_vec_cross(a, b, normal);
    double u[3], v[3];
    for (int c = 0; c < 3; c++) {
        u[c] = (double)texcoords[(size_t)index[c] * 2];
        v[c] = (double)texcoords[(size_t)index[c] * 2 + 1];
    }
    double au = u[1] - u[0], av = v[1] - v[0], bu = u[2] - u[0], bv = v[2] - v[0];
    double sign = au * bv - bu * av;
    if (!(sign < 0 || sign > 0))
        return;
    sign = sign > 0 ? 1 : -1;
    for (int k = 0; k < 3; k++) {
        along_u[k] = sign * (a[k] * bv - b[k] * av);
        along_v[k] = sign * (a[k] * bu - b[k] * au);
    }
    double area = hatch_vec_length(normal);
    if (!(hatch_vec_normalize(along_u) > 0) || !(hatch_vec_normalize(along_v) > 0))
        return;
    for (int c = 0; c < 3; c++) {
        double *sum = &sums[(size_t)index[c] * 6];
        hatch_vec_add_scaled(sum, area, along_u, sum);
        hatch_vec_add_scaled(sum + 3, area, along_v, sum + 3);
    }
}

static void store(const float *normal_in, const double *sum, float *tangent)
{
    double normal[3], t[3], other[3];
    hatch_vec_of(normal_in, normal);
    hatch_vec_normalize(normal);
    hatch_vec_add_scaled(sum, -hatch_vec_dot(sum, normal), normal, t);
    double length = hatch_vec_length(sum), rest = hatch_vec_normalize(t);
    /* If the sum is along the normal, only rounding errors remain here. */
    if (!(rest > 1e-6 * length))
        hatch_vec_any_orthogonal(normal, t);
    hatch_vec_cross(normal, t, other);
    hatch_vec_round(t, tangent);
    tangent[3] = hatch_vec_dot(other, sum + 3) < 0 ? -1.0f : 1.0f;
}

enum hatch_status hatch_mesh_add_tangents(struct hatch_arena *arena, struct hatch_arena *scratch,
                                          struct hatch_mesh *mesh, struct hatch_err *err)
{
    if (hatch_mesh_find(mesh, "TANGENT", 4))
        return HATCH_OK;
    const float *normals = hatch_mesh_find(mesh, "NORMAL", 3);
    const float *texcoords = hatch_mesh_find(mesh, "TEXCOORD_0", 2);
    assert(normals && texcoords);
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    double *sums = HATCH_NEW(scratch, double, (size_t)mesh->vertex_count * 6, err);
    float *tangents;
    enum hatch_status status = sums ? hatch_mesh_add(arena, mesh, "TANGENT", 4, &tangents, err) : HATCH_LIMIT;
    if (status == HATCH_OK) {
        for (uint32_t f = 0; f < mesh->face_count; f++)
            add_face(mesh, f, texcoords, sums);
        for (size_t v = 0; v < mesh->vertex_count; v++)
            store(&normals[v * 3], &sums[v * 6], &tangents[v * 4]);
    }
    hatch_arena_rewind(scratch, mark);
    return status;
}
