#include <math.h>

#include "math/vector.h"
#include "field/system.h"

#define CONFIDENCE 0.5 /* of the directions filled in, where the axis is tangent to the surface */
#define TIE 1e-6       /* relative difference between lengths that count as equal */

/* Finds the coordinate axis along which a component is longest; of equal ones y, then x. */
static void longest_axis(const struct hatch_surface *surface, const struct hatch_component *component, double axis[3])
{
    static const int order[3] = {1, 0, 2};
    double longest = -1;
    int found = 1;
    for (int i = 0; i < 3; i++) {
        double low = INFINITY, high = -INFINITY;
        for (size_t p = component->first_point; p < component->first_point + component->point_count; p++) {
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

void hatch_field_fill_unconstrained(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                    const double *constraint_weight, double *direction, double *confidence,
                                    bool *filled)
{
    const struct hatch_field_problem problem = {surface, frames, direction, confidence, constraint_weight, false};
    for (uint32_t c = 0; c < surface->component_count; c++) {
        const struct hatch_component *component = &surface->components[c];
        double axis[3];
        filled[c] = !hatch_field_smoothing_of(&problem, 0, c).constrained;
        if (!filled[c])
            continue;
        longest_axis(surface, component, axis);
        for (size_t p = component->first_point; p < component->first_point + component->point_count; p++) {
            hatch_vec_cross(&frames->normal[3 * p], axis, &direction[3 * p]);
            confidence[p] = CONFIDENCE * hatch_vec_dot(&direction[3 * p], &direction[3 * p]);
        }
    }
}

void hatch_field_clear_plane_confidence(const struct hatch_surface *surface, const double *confidence,
                                        struct hatch_field *field)
{
    for (uint32_t i = 0; surface->plane_count > 0 && i < 3 * surface->face_count; i++) {
        uint32_t p = surface->corners[i];
        if (surface->face_plane[i / 3] != HATCH_NO_SIDE && confidence[p] > 0)
            field->confidence[p] = 0;
    }
}

void hatch_field_clear_filled_confidence(const struct hatch_surface *surface, const bool *filled,
                                         struct hatch_field *field)
{
    for (uint32_t c = 0; c < surface->component_count; c++) {
        const struct hatch_component *component = &surface->components[c];
        if (!filled[c])
            continue;
        field->unconstrained++;
        for (uint32_t p = component->first_point; p < component->first_point + component->point_count; p++)
            field->confidence[p] = 0;
    }
}
