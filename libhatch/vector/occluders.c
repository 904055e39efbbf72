#include "vector/occluders.h"

#include <string.h>

#include "math/vector.h"

double hatch_occluders_nearness(const struct hatch_occluders *occluders, double depth)
{
    return occluders->view.orthographic ? -depth : 1 / fmax(depth, HATCH_OCCLUDERS_DEPTH_LEAST);
}

void hatch_occluders_project(const struct hatch_occluders *occluders, const double point[3], double out[3])
{
    const struct hatch_view *view = &occluders->view;
    double from[3], depth, w;
    hatch_vec_sub(point, view->eye, from);
    hatch_vec_add_scaled(from, -1, view->eye_low, from);
    depth = -hatch_vec_dot(from, view->back);
    w = view->orthographic ? 1 : depth;
    out[0] = occluders->focal_px[0] * hatch_vec_dot(from, view->right) + 0.5 * occluders->width_px * w;
    out[1] = occluders->focal_px[1] * hatch_vec_dot(from, view->up) + 0.5 * occluders->height_px * w;
    out[2] = depth;
}

bool hatch_occluders_touch(const struct hatch_occluders *occluders, uint32_t a, uint32_t b)
{
    for (size_t i = 0; i < 3; i++)
        for (size_t j = 0; j < 3; j++)
            if (memcmp(&occluders->points[3 * (size_t)occluders->corners[3 * (size_t)a + i]],
                       &occluders->points[3 * (size_t)occluders->corners[3 * (size_t)b + j]], 3 * sizeof(double)) == 0)
                return true;
    return false;
}
