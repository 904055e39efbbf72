/* Apart from the solvers: what measures a field needs none of them, nor CHOLMOD. */
#include <math.h>

#include "field/system.h"

void hatch_field_energy(const struct hatch_surface *surface, const struct hatch_frames *frames,
                        const struct hatch_field_data *data, double smooth, const double *direction, double energy[2])
{
    energy[0] = energy[1] = 0;
    for (uint32_t c = 0; c < surface->component_count; c++) {
        const struct hatch_component *of = &surface->components[c];
        struct hatch_field_scale scale = hatch_field_scale_of(surface, frames, data, smooth, c);
        for (uint32_t p = of->first_point; p < of->first_point + of->point_count; p++) {
            double z[2], far[2], mass = hatch_field_mass(surface, frames, data, &scale, p);
            hatch_field_square(frames, p, &direction[(size_t)p * 3], z);
            for (uint32_t i = surface->ring_first[p]; i < surface->ring_first[p + 1]; i++) {
                uint32_t q = surface->ring_point[i];
                double x = cos(2 * frames->turn_rad[i]), y = sin(2 * frames->turn_rad[i]);
                hatch_field_square(frames, q, &direction[(size_t)q * 3], far);
                far[1] *= surface->ring_turned[i] ? -1 : 1;
                double dx = z[0] - (x * far[0] - y * far[1]), dy = z[1] - (x * far[1] + y * far[0]);
                energy[0] += 0.5 * frames->weight[i] * (dx * dx + dy * dy);
            }
            if (!(mass > 0))
                continue;
            hatch_field_square(frames, p, &data->direction[(size_t)p * 3], far);
            double dx = z[0] - far[0], dy = z[1] - far[1];
            energy[1] += mass * (dx * dx + dy * dy);
        }
    }
}
