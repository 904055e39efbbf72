#include "solid/noise.h"

#include "base/random.h"

enum { STREAM_GRADIENTS = 0x6e6f6973 };

/* Finds a point in the unit ball by trying points of the cube around it. */
static void random_direction(uint64_t key, uint64_t number, float out[3])
{
    for (uint64_t attempt = 0;; attempt++) {
        uint64_t bits = hatch_random_at(key, number << 32 | attempt);
        float length = 0;
        for (int i = 0; i < 3; i++, bits >>= 21) {
            out[i] = (float)(int32_t)((bits & 0x1fffff) - 0x100000) * 0x1p-20f;
            length += out[i] * out[i];
        }
        if (length > 0.01f && length <= 1) {
            length = sqrtf(length);
            for (int i = 0; i < 3; i++)
                out[i] /= length;
            return;
        }
    }
}

void hatch_noise_make(uint64_t seed, struct hatch_noise *noise)
{
    uint64_t key = hatch_random_key(seed, STREAM_GRADIENTS);
    for (uint32_t i = 0; i < HATCH_NOISE_GRADIENTS; i += 2) {
        random_direction(key, i, noise->gradients[i]);
        for (int c = 0; c < 3; c++)
            noise->gradients[i + 1][c] = -noise->gradients[i][c];
    }
}

struct hatch_noise_octaves hatch_noise_octaves_make(const struct hatch_noise *noise, uint64_t seed, uint64_t stream,
                                                    const uint32_t cells[3], uint32_t cells_max, uint32_t count,
                                                    float gain)
{
    struct hatch_noise_octaves made = {.noise = noise};
    float amplitude = 1, sum = 0;
    for (uint32_t octave = 0; octave < count; octave++, amplitude *= gain) {
        struct hatch_noise_lattice *lattice = &made.lattices[octave];
        bool fits = true;
        for (int i = 0; i < 3; i++) {
            lattice->cells[i] = cells[i] << octave;
            lattice->shift[i] = octave ? hatch_random_unit(seed, stream, 4 * octave + (uint32_t)i) : 0;
            fits = fits && lattice->cells[i] <= cells_max;
        }
        if (!fits && octave > 0)
            break;
        lattice->key = (uint32_t)hatch_random_u64(seed, stream, 4 * octave + 3);
        made.amplitudes[made.count++] = amplitude;
        sum += amplitude;
    }
    for (uint32_t octave = 0; octave < made.count; octave++)
        made.amplitudes[octave] /= sum;
    return made;
}

static uint32_t hash(uint32_t x, uint32_t y, uint32_t z, uint32_t key)
{
    uint32_t h = key ^ x * 0x9e3779b1u ^ y * 0x85ebca77u ^ z * 0xc2b2ae3du;
    h = (h ^ h >> 16) * 0x7feb352du;
    h = (h ^ h >> 15) * 0x846ca68bu;
    return h ^ h >> 16;
}

float hatch_noise_at(const struct hatch_noise *noise, const struct hatch_noise_lattice *lattice, const float at[3])
{
    uint32_t cell[3][2];
    float from[3], fade[3];
    for (int i = 0; i < 3; i++) {
        float floored = floorf(at[i]), t = at[i] - floored;
        int32_t cells = (int32_t)lattice->cells[i], low = (int32_t)floored % cells;
        low += low < 0 ? cells : 0;
        cell[i][0] = (uint32_t)low;
        cell[i][1] = (uint32_t)(low + 1 == cells ? 0 : low + 1);
        from[i] = t;
        fade[i] = t * t * t * (t * (t * 6 - 15) + 10);
    }
    float corners[8];
    for (int corner = 0; corner < 8; corner++) {
        int x = corner & 1, y = corner >> 1 & 1, z = corner >> 2;
        uint32_t h = hash(cell[0][x], cell[1][y], cell[2][z], lattice->key);
        const float *gradient = noise->gradients[h % HATCH_NOISE_GRADIENTS];
        corners[corner] = gradient[0] * (from[0] - (float)x) + gradient[1] * (from[1] - (float)y) +
                          gradient[2] * (from[2] - (float)z);
    }
    for (int i = 0, count = 4; i < 3; i++, count /= 2)
        for (int corner = 0; corner < count; corner++)
            corners[corner] = corners[2 * corner] + fade[i] * (corners[2 * corner + 1] - corners[2 * corner]);
    return corners[0];
}

float hatch_noise_sum(const struct hatch_noise_octaves *octaves, const float at[3], bool absolute)
{
    float sum = 0;
    for (uint32_t octave = 0; octave < octaves->count; octave++) {
        const struct hatch_noise_lattice *lattice = &octaves->lattices[octave];
        float place[3];
        for (int i = 0; i < 3; i++)
            place[i] = at[i] * (float)lattice->cells[i] + lattice->shift[i];
        float value = hatch_noise_at(octaves->noise, lattice, place);
        sum += octaves->amplitudes[octave] * (absolute ? fabsf(value) : value);
    }
    return sum;
}

float hatch_noise_cosine(float turns)
{
    /* With b = |t| - 1/4 for t in -1/2 .. 1/2, the cosine of t turns is the sine of -b turns: a Taylor series. */
    float t = turns - floorf(turns + 0.5f), b = fabsf(t) - 0.25f, b2 = b * b;
    float series =
        6.2831853f + b2 * (-41.341702f + b2 * (81.605249f + b2 * (-76.705860f + b2 * (42.058694f + b2 * -15.094643f))));
    return -b * series;
}
