#include <math.h>

#include "math/vector.h"
#include "field/system.h"

#define CONFIDENCE 0.5 /* of lines that are made up, where the surface lies along the axis */
#define TIE 1e-6

/* The coordinate axis along which a component is longest; of equals y, then x. */
static void longest_axis(const struct hatch_surface *surface, const struct hatch_component *of, double axis[3])
{
    static const int order[3] = {1, 0, 2};
    double longest = -1;
    int found = 1;
    for (int i = 0; i < 3; i++) {
        double low = INFINITY, high = -INFINITY;
        for (size_t p = of->first_point; p < of->first_point + of->point_count; p++) {
            low = fmin(low, surface->points[3 * p + (size_t)order[i]]);
            high = fmax(high, surface->points[3 * p + (size_t)order[i]]);
        }
        if (high - low <= longest * (1 + TIE))
            continue;
        longest = high - low;
        found = order[i];
    }
    for (int k = 0; k < 3; k++)
        axis[k] = k == found;
}

void hatch_field_make_up(const struct hatch_surface *surface, const struct hatch_frames *frames, const double *hard,
                         double *direction, double *confidence, bool *made_up)
{
    const struct hatch_field_data data = {direction, confidence, hard, false};
    for (uint32_t c = 0; c < surface->component_count; c++) {
        const struct hatch_component *of = &surface->components[c];
        double axis[3];
        made_up[c] = !hatch_field_scale_of(surface, frames, &data, 0, c).directed;
        if (!made_up[c])
            continue;
        longest_axis(surface, of, axis);
        for (size_t p = of->first_point; p < of->first_point + of->point_count; p++) {
            hatch_vec_cross(&frames->normal[3 * p], axis, &direction[3 * p]);
            confidence[p] = CONFIDENCE * hatch_vec_dot(&direction[3 * p], &direction[3 * p]);
        }
    }
}

void hatch_field_own_up(const struct hatch_surface *surface, const bool *made_up, struct hatch_field *field)
{
    for (uint32_t c = 0; c < surface->component_count; c++) {
        const struct hatch_component *of = &surface->components[c];
        if (!made_up[c])
            continue;
        field->undirected++;
        for (uint32_t p = of->first_point; p < of->first_point + of->point_count; p++)
            field->confidence[p] = 0;
    }
}
