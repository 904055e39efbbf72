#include "math/triangle.h"

#include "math/vector.h"

double hatch_segment_distance_squared(const double a[3], const double b[3], const double point[3], double *share)
{
    double along[3], to[3];
    hatch_vec_sub(b, a, along);
    hatch_vec_sub(point, a, to);
    double length_squared = hatch_vec_dot(along, along), dot = hatch_vec_dot(along, to);
    *share = !(dot > 0) ? 0 : dot >= length_squared ? 1 : dot / length_squared;
    hatch_vec_add_scaled(to, -*share, along, to);
    return hatch_vec_dot(to, to);
}

double hatch_triangle_distance_squared(const double a[3], const double b[3], const double c[3], const double point[3],
                                       double share[3])
{
    const double *corners[3] = {a, b, c};
    double ab[3], ac[3], to[3];
    hatch_vec_sub(b, a, ab);
    hatch_vec_sub(c, a, ac);
    hatch_vec_sub(point, a, to);
    double bb = hatch_vec_dot(ab, ab), bc = hatch_vec_dot(ab, ac), cc = hatch_vec_dot(ac, ac);
    double along_b = hatch_vec_dot(ab, to), along_c = hatch_vec_dot(ac, to), area = bb * cc - bc * bc;
    double u = cc * along_b - bc * along_c, v = bb * along_c - bc * along_b;
    if (area > 0 && u >= 0 && v >= 0 && u + v <= area) {
        share[1] = u / area;
        share[2] = v / area;
        share[0] = 1 - share[1] - share[2];
        hatch_vec_add_scaled(to, -share[1], ab, to);
        hatch_vec_add_scaled(to, -share[2], ac, to);
        return hatch_vec_dot(to, to);
    }
    double best = 0;
    for (int side = 0; side < 3; side++) {
        double at, distance = hatch_segment_distance_squared(corners[side], corners[(side + 1) % 3], point, &at);
        if (side > 0 && !(distance < best))
            continue;
        best = distance;
        share[side] = 1 - at;
        share[(side + 1) % 3] = at;
        share[(side + 2) % 3] = 0;
    }
    return best;
}
