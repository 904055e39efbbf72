#include "measure/stretch.h"

#include <math.h>

#include "math/vector.h"

/* For the singular values s1, s2 of the derivative, (s1 ± s2)² = E ± 2 |det|, where E is the sum of the squared
 * entries. */
bool hatch_measure_stretch(const struct hatch_mesh *mesh, const float *uv, uint32_t face, struct hatch_stretch *stretch)
{
    double p[3][3], normal[3], x[3], y[3], ab[3], ac[3], t[3][2];
    const uint32_t *index = &mesh->indices[(size_t)face * 3];
    if (!hatch_mesh_corners(mesh, face, p))
        return false;
    hatch_vec_triangle(p[0], p[1], p[2], normal);
    hatch_vec_sub(p[1], p[0], ab);
    hatch_vec_sub(p[2], p[0], ac);
    for (int c = 0; c < 3; c++)
        for (size_t k = 0; k < 2; k++)
            t[c][k] = (double)uv[(size_t)index[c] * 2 + k] - (double)uv[(size_t)index[0] * 2 + k];
    double area2 = hatch_vec_length(normal), length = hatch_vec_length(ab);
    hatch_vec_copy(ab, x);
    hatch_vec_normalize(x);
    hatch_vec_normalize(normal);
    hatch_vec_cross(normal, x, y);
    /* The corners in the plane are (0, 0), (length, 0), (cx, cy). d[k]: derivative of u (v) along both axes. */
    double cx = hatch_vec_dot(ac, x), cy = area2 / length, e = 0, d[2][2];
    for (int k = 0; k < 2; k++) {
        d[k][0] = t[1][k] / length;
        d[k][1] = (t[2][k] - d[k][0] * cx) / cy;
        e += d[k][0] * d[k][0] + d[k][1] * d[k][1];
    }
    double det = d[0][0] * d[1][1] - d[0][1] * d[1][0], sign = det > 0 ? 1 : det < 0 ? -1 : 0;
    double plus = sqrt(e + 2 * fabs(det)), minus = sqrt(fmax(0, e - 2 * fabs(det)));
    stretch->area = area2 / 2;
    stretch->uv_area = det * stretch->area;
    stretch->ratio = sign != 0 ? (plus + minus) / (plus - minus) : HUGE_VAL;
    for (int k = 0; k < 3; k++)
        stretch->u[k] = sign * (d[1][1] * x[k] - d[1][0] * y[k]);
    hatch_vec_normalize(stretch->u);
    return true;
}
