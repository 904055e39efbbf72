/* Colours in coordinates along their principal components. */
#include <math.h>

#include "math/pca.h"
#include "solid/zoom/axes.h"

/* Computes the axes, of length 1, from the sums over all texels. */
static void find_axes(const struct hatch_solid *solid, double axes[9])
{
    size_t count = hatch_solid_count(solid);
    uint64_t sum[3] = {0}, products[3][3] = {{0}};
    double covariance[9], next[9];
    for (size_t i = 0; i < count; i++)
        for (size_t a = 0; a < 3; a++) {
            const uint8_t *texel = solid->texels + 3 * i;
            sum[a] += texel[a];
            for (size_t b = 0; b < 3; b++)
                products[a][b] += (uint64_t)texel[a] * texel[b];
        }
    for (size_t a = 0; a < 3; a++)
        for (size_t b = 0; b < 3; b++)
            covariance[3 * a + b] = (double)products[a][b] / (double)count -
                                    (double)sum[a] / (double)count * ((double)sum[b] / (double)count);
    hatch_pca_directions(covariance, 3, 3, axes, next);
}

static double along(const double axis[3], const uint8_t texel[3])
{
    return (axis[0] * texel[0] + axis[1] * texel[1] + axis[2] * texel[2]) / 255;
}

enum hatch_status hatch_zoom_turn(const struct hatch_solid *solid, struct hatch_arena *arena, struct hatch_zoom *zoom,
                                  struct hatch_err *err)
{
    size_t count = hatch_solid_count(solid);
    double axes[9];
    HATCH_TRY(hatch_solid_make_like(arena, solid, solid->size, 3, &zoom->base, err));
    find_axes(solid, axes);
    for (size_t k = 0; k < 3; k++)
        zoom->offset[k] = 0;
    for (size_t c = 0; c < 3; c++) {
        double low = INFINITY, high = -INFINITY;
        for (size_t i = 0; i < count; i++) {
            double value = along(axes + 3 * c, solid->texels + 3 * i);
            low = fmin(low, value);
            high = fmax(high, value);
        }
        double span = fmax(high - low, 1e-6);
        for (size_t i = 0; i < count; i++)
            zoom->base.texels[3 * i + c] =
                hatch_unorm8((float)((along(axes + 3 * c, solid->texels + 3 * i) - low) / span));
        for (size_t k = 0; k < 3; k++) {
            zoom->offset[k] += (float)(low * axes[3 * c + k]);
            zoom->axes[c][k] = (float)(span * axes[3 * c + k]);
        }
    }
    return HATCH_OK;
}
