#include "mesh/uv_tangents.h"

#include <math.h>

#include "math/vector.h"
#include "mesh/remap.h"

/* Adds dP/du and dP/dv of one face, each times twice the face's area, and that weight.
 *   number  per vertex: its entry in sums
 *   sums    7 per entry: dP/du, dP/dv, weight */
static void add_face(const uint32_t corner[3], const float *position, const float *texcoord, const uint32_t *number,
                     double *sums)
{
    double p[3][3], edge[2][3], normal[3], uv[2][2];
    for (int k = 0; k < 3; k++)
        hatch_vec_of(position + 3 * (size_t)corner[k], p[k]);
    for (int k = 0; k < 2; k++) {
        hatch_vec_sub(p[k + 1], p[0], edge[k]);
        for (int c = 0; c < 2; c++)
            uv[k][c] = (double)texcoord[2 * (size_t)corner[k + 1] + (size_t)c] -
                       (double)texcoord[2 * (size_t)corner[0] + (size_t)c];
    }
    double turn = uv[0][0] * uv[1][1] - uv[1][0] * uv[0][1];
    hatch_vec_cross(edge[0], edge[1], normal);
    double area = hatch_vec_length(normal), size = hypot(uv[0][0], uv[0][1]) * hypot(uv[1][0], uv[1][1]);
    if (!(fabs(turn) > 1e-7 * size) || !(area > 0))
        return;
    for (int k = 0; k < 3; k++) {
        double du = (uv[1][1] * edge[0][k] - uv[0][1] * edge[1][k]) / turn;
        double dv = (uv[0][0] * edge[1][k] - uv[1][0] * edge[0][k]) / turn;
        for (int c = 0; c < 3; c++) {
            double *sum = sums + 7 * (size_t)number[corner[c]];
            sum[k] += area * du;
            sum[3 + k] += area * dv;
            sum[6] += k == 0 ? area : 0;
        }
    }
}

double hatch_uv_reach(const struct hatch_mesh *mesh)
{
    const float *position = mesh->attributes[0].data, *texcoord = hatch_mesh_find(mesh, "TEXCOORD_0", 2);
    double area = 0, uv_area = 0, most = 0;
    for (size_t f = 0; f < mesh->face_count; f++) {
        const uint32_t *corner = mesh->indices + 3 * f;
        double p[3][3], normal[3], uv[3][2];
        for (int k = 0; k < 3; k++) {
            hatch_vec_of(position + 3 * (size_t)corner[k], p[k]);
            for (size_t c = 0; c < 2; c++) {
                uv[k][c] = (double)texcoord[2 * (size_t)corner[k] + c];
                most = fmax(most, fabs(uv[k][c]));
            }
        }
        hatch_vec_triangle(p[0], p[1], p[2], normal);
        area += hatch_vec_length(normal);
        uv_area += fabs((uv[1][0] - uv[0][0]) * (uv[2][1] - uv[0][1]) - (uv[2][0] - uv[0][0]) * (uv[1][1] - uv[0][1]));
    }
    return uv_area > 0 ? most * sqrt(area / uv_area) : 0;
}

/* Vertices that are equal in position and texture coordinates share their tangents, because flat-shaded meshes have
 * separate vertices for each face. */
enum hatch_status hatch_uv_tangents(const struct hatch_mesh *mesh, struct hatch_arena *scratch, float **tangents,
                                    struct hatch_err *err)
{
    const float *position = mesh->attributes[0].data, *texcoord = hatch_mesh_find(mesh, "TEXCOORD_0", 2);
    struct hatch_remap remap;
    HATCH_TRY(hatch_remap_by_texcoord(mesh, scratch, &remap, err));
    double *sums;
    float *made;
    HATCH_TRY(HATCH_ALLOC(scratch, &sums, 7 * (size_t)remap.count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &made, 6 * (size_t)mesh->vertex_count, err));
    for (size_t f = 0; f < mesh->face_count; f++)
        add_face(mesh->indices + 3 * f, position, texcoord, remap.number, sums);
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        const double *sum = sums + 7 * (size_t)remap.number[v];
        for (size_t k = 0; k < 6; k++)
            made[6 * v + k] = sum[6] > 0 ? (float)(sum[k] / sum[6]) : 0.0f;
    }
    *tangents = made;
    return HATCH_OK;
}
