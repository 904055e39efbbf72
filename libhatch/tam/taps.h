/* Texture filtering: the four texels around a position with their bilinear weights, and the two levels around a
 * level of detail. Private to tam. */
#ifndef HATCH_TAM_TAPS_H
#define HATCH_TAM_TAPS_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>

struct hatch_taps {
    size_t texel[4];
    float weight[4]; /* sum to 1 */
};

/* Finds the two texels around a coordinate along one axis of a repeating texture.
 *   share  out: weight of index[1] */
static inline void hatch_tap_axis(float coordinate, uint32_t size, uint32_t index[2], float *share)
{
    float position = (coordinate - floorf(coordinate)) * (float)size - 0.5f, below = floorf(position);
    *share = position - below;
    index[0] = (uint32_t)((int64_t)below + size) % size;
    index[1] = (index[0] + 1) % size;
}

/* Returns the taps at (u, v) of a repeating image of width x height texels. */
static inline struct hatch_taps hatch_taps_at(float u, float v, uint32_t width, uint32_t height)
{
    uint32_t x[2], y[2];
    float right, down;
    struct hatch_taps taps;
    hatch_tap_axis(u, width, x, &right);
    hatch_tap_axis(v, height, y, &down);
    for (uint32_t i = 0; i < 4; i++) {
        taps.texel[i] = (size_t)y[i / 2] * width + x[i % 2];
        taps.weight[i] = (i % 2 ? right : 1 - right) * (i / 2 ? down : 1 - down);
    }
    return taps;
}

/* Returns the finer of the two levels around lod.
 *   share  out: weight of the coarser one, 0 .. 1 */
static inline uint32_t hatch_tap_levels(float lod, uint32_t level_count, float *share)
{
    float last = (float)(level_count - 1), clamped = lod > 0 ? (lod < last ? lod : last) : 0;
    uint32_t level = (uint32_t)clamped;
    *share = clamped - (float)level;
    return level;
}

#endif
