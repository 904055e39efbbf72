/* This file is apart from the solvers, so that programs that only measure a field do not link CHOLMOD. */
#include <math.h>

#include "field/system.h"

void hatch_field_energy(const struct hatch_field_problem *problem, double smooth, const double *direction,
                        double energy[2])
{
    const struct hatch_surface *surface = problem->surface;
    const struct hatch_frames *frames = problem->frames;
    energy[0] = energy[1] = 0;
    for (uint32_t c = 0; c < surface->component_count; c++) {
        const struct hatch_component *component = &surface->components[c];
        struct hatch_field_smoothing smoothing = hatch_field_smoothing_of(problem, smooth, c);
        for (uint32_t p = component->first_point; p < component->first_point + component->point_count; p++) {
            double z[2], other[2], data_weight = hatch_field_data_weight(problem, &smoothing, p);
            hatch_field_encode(frames, p, &direction[(size_t)p * 3], z);
            for (uint32_t i = surface->ring_first[p]; i < surface->ring_first[p + 1]; i++) {
                uint32_t q = surface->ring_point[i];
                double x = cos(2 * frames->transport_rad[i]), y = sin(2 * frames->transport_rad[i]);
                hatch_field_encode(frames, q, &direction[(size_t)q * 3], other);
                other[1] *= surface->ring_turned[i] ? -1 : 1;
                double dx = z[0] - (x * other[0] - y * other[1]), dy = z[1] - (x * other[1] + y * other[0]);
                energy[0] += 0.5 * frames->weight[i] * (dx * dx + dy * dy);
            }
            if (!(data_weight > 0))
                continue;
            hatch_field_encode(frames, p, &problem->direction[(size_t)p * 3], other);
            double dx = z[0] - other[0], dy = z[1] - other[1];
            energy[1] += data_weight * (dx * dx + dy * dy);
        }
    }
}
