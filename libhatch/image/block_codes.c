#include "image/block_codes.h"

#include <string.h>

#define TEXELS HATCH_BLOCK_TEXELS
#define BC1_ROUNDS 4
#define BC4_INDEX_BITS 3u
#define BC7_MODE6 0x40u
#define BC7_STEPS 15

/* Writes bits, least significant first. */
struct bits {
    uint8_t *bytes;
    uint32_t at;
};

static void put(struct bits *bits, uint32_t count, uint32_t value)
{
    for (uint32_t i = 0; i < count; i++, bits->at++)
        bits->bytes[bits->at / 8] |= (uint8_t)((value >> i & 1) << bits->at % 8);
}

static uint32_t take(const uint8_t *bytes, uint32_t *at, uint32_t count)
{
    uint32_t value = 0;
    for (uint32_t i = 0; i < count; i++, (*at)++)
        value |= (uint32_t)(bytes[*at / 8] >> *at % 8 & 1) << i;
    return value;
}

/* Computes the eight values that a BC4 block encodes, rounded to nearest; the last two are 0 and 255 unless a > b. */
static void bc4_numbers(uint32_t a, uint32_t b, uint8_t numbers[8])
{
    uint32_t steps = a > b ? 7 : 5;
    numbers[0] = (uint8_t)a;
    numbers[1] = (uint8_t)b;
    for (uint32_t i = 1; i < steps; i++)
        numbers[i + 1] = (uint8_t)(((steps - i) * a + i * b + steps / 2) / steps);
    if (steps == 5) {
        numbers[6] = 0;
        numbers[7] = 255;
    }
}

/* Chooses the nearest value for each texel, of equally near ones the first; returns the sum of squared errors. Loops
 * are over texels, of 16 bits, at once on vector units. */
static uint32_t bc4_choose(const int16_t values[TEXELS], const uint8_t numbers[8], uint8_t index[TEXELS])
{
    int16_t least[TEXELS]; /* 8 times the distance, plus the index */
    uint32_t sum = 0;
    for (uint32_t t = 0; t < TEXELS; t++)
        least[t] = INT16_MAX;
    for (int16_t i = 0; i < 8; i++)
        for (uint32_t t = 0; t < TEXELS; t++) {
            int16_t over = (int16_t)(values[t] - numbers[i]), under = (int16_t)(numbers[i] - values[t]);
            int16_t found = (int16_t)((over > under ? over : under) * 8 + i);
            least[t] = found < least[t] ? found : least[t];
        }
    for (uint32_t t = 0; t < TEXELS; t++) {
        index[t] = (uint8_t)(least[t] % 8);
        sum += (uint32_t)((least[t] / 8) * (least[t] / 8));
    }
    return sum;
}

static void bc4_write(uint32_t a, uint32_t b, const uint8_t index[TEXELS], uint8_t block[8])
{
    struct bits bits = {block, 16};
    memset(block, 0, 8);
    block[0] = (uint8_t)a;
    block[1] = (uint8_t)b;
    for (uint32_t t = 0; t < TEXELS; t++)
        put(&bits, BC4_INDEX_BITS, index[t]);
}

void hatch_bc4_encode(uint8_t texels[TEXELS][4], uint8_t block[8])
{
    int16_t values[TEXELS], low = 255, high = 0, inner_low = 255, inner_high = 0; /* inner: of others than 0 and 255 */
    uint8_t numbers[8], index[2][TEXELS] = {{0}};
    for (uint32_t t = 0; t < TEXELS; t++)
        values[t] = texels[t][0];
    for (uint32_t t = 0; t < TEXELS; t++) {
        const int16_t above = values[t] > 0 ? values[t] : 255, below = values[t] < 255 ? values[t] : 0;
        low = values[t] < low ? values[t] : low;
        high = values[t] > high ? values[t] : high;
        inner_low = above < inner_low ? above : inner_low;
        inner_high = below > inner_high ? below : inner_high;
    }
    if (low == high) {
        bc4_write((uint32_t)low, (uint32_t)low, index[0], block);
        return;
    }
    if (inner_low > inner_high) /* only 0 and 255 */
        inner_low = inner_high = 0;
    bc4_numbers((uint32_t)inner_low, (uint32_t)inner_high, numbers);
    uint32_t with_ends = bc4_choose(values, numbers, index[0]);
    bc4_numbers((uint32_t)high, (uint32_t)low, numbers);
    uint32_t without = with_ends ? bc4_choose(values, numbers, index[1]) : UINT32_MAX;
    if (with_ends <= without)
        bc4_write((uint32_t)inner_low, (uint32_t)inner_high, index[0], block);
    else
        bc4_write((uint32_t)high, (uint32_t)low, index[1], block);
}

void hatch_bc4_decode(const uint8_t block[8], uint8_t texels[TEXELS][4])
{
    uint8_t numbers[8];
    uint64_t indices = 0;
    bc4_numbers(block[0], block[1], numbers);
    for (uint32_t i = 0; i < 6; i++)
        indices |= (uint64_t)block[2 + i] << 8 * i;
    for (uint32_t t = 0; t < TEXELS; t++)
        texels[t][0] = numbers[indices >> BC4_INDEX_BITS * t & 7];
}

/* Computes the principal axis of the colours, by a few steps of power iteration. */
static void principal_axis(uint8_t texels[TEXELS][4], const float mean[3], float axis[3])
{
    float products[3][3] = {{0}};
    for (uint32_t t = 0; t < TEXELS; t++)
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                products[i][j] += ((float)texels[t][i] - mean[i]) * ((float)texels[t][j] - mean[j]);
    int widest = products[1][1] > products[0][0] ? 1 : 0;
    widest = products[2][2] > products[widest][widest] ? 2 : widest;
    memcpy(axis, products[widest], 3 * sizeof *axis);
    for (int step = 0; step < 4; step++) {
        float next[3], largest = 1e-20f;
        for (int i = 0; i < 3; i++) {
            next[i] = products[i][0] * axis[0] + products[i][1] * axis[1] + products[i][2] * axis[2];
            float size = next[i] < 0 ? -next[i] : next[i];
            largest = size > largest ? size : largest;
        }
        for (int i = 0; i < 3; i++)
            axis[i] = next[i] / largest;
    }
}

/* Projects the colours onto their principal axis and returns the two outermost points there. */
static void axis_ends(uint8_t texels[TEXELS][4], float ends[2][3])
{
    float mean[3] = {0}, axis[3], least = 0, most = 0, length = 1e-20f;
    for (uint32_t t = 0; t < TEXELS; t++)
        for (int c = 0; c < 3; c++)
            mean[c] += (float)texels[t][c] / TEXELS;
    principal_axis(texels, mean, axis);
    for (int c = 0; c < 3; c++)
        length += axis[c] * axis[c];
    for (uint32_t t = 0; t < TEXELS; t++) {
        float along = 0;
        for (int c = 0; c < 3; c++)
            along += ((float)texels[t][c] - mean[c]) * axis[c] / length;
        least = along < least ? along : least;
        most = along > most ? along : most;
    }
    for (int c = 0; c < 3; c++) {
        ends[0][c] = mean[c] + least * axis[c];
        ends[1][c] = mean[c] + most * axis[c];
    }
}

/* Quantises a colour to 5, 6 and 5 bits. */
static uint32_t bc1_end(const float color[3])
{
    static const float most[] = {31, 63, 31};
    uint32_t bits[3];
    for (int c = 0; c < 3; c++) {
        float value = color[c] * most[c] / 255 + 0.5f;
        bits[c] = (uint32_t)(value > 0 ? (value < most[c] ? value : most[c]) : 0);
    }
    return bits[0] << 11 | bits[1] << 5 | bits[2];
}

/* Computes the four colours that a BC1 block encodes, rounded to nearest; the last one is black unless a > b. */
static void bc1_colors(uint32_t a, uint32_t b, uint8_t colors[4][3])
{
    const uint32_t ends[2] = {a, b};
    for (int end = 0; end < 2; end++) {
        uint32_t red = ends[end] >> 11, green = ends[end] >> 5 & 63, blue = ends[end] & 31;
        colors[end][0] = (uint8_t)(red << 3 | red >> 2);
        colors[end][1] = (uint8_t)(green << 2 | green >> 4);
        colors[end][2] = (uint8_t)(blue << 3 | blue >> 2);
    }
    for (int c = 0; c < 3; c++) {
        uint32_t first = colors[0][c], second = colors[1][c];
        colors[2][c] = (uint8_t)(a > b ? (2 * first + second + 1) / 3 : (first + second + 1) / 2);
        colors[3][c] = (uint8_t)(a > b ? (first + 2 * second + 1) / 3 : 0);
    }
}

/* Chooses the nearest colour for each texel; returns the sum of squared errors. */
static uint32_t bc1_choose(uint8_t texels[TEXELS][4], uint32_t a, uint32_t b, uint8_t index[TEXELS])
{
    uint8_t colors[4][3];
    uint32_t sum = 0;
    bc1_colors(a, b, colors);
    for (uint32_t t = 0; t < TEXELS; t++) {
        uint32_t best = UINT32_MAX;
        for (uint32_t i = 0; i < 4; i++) {
            uint32_t squares = 0;
            for (int c = 0; c < 3; c++) {
                int apart = texels[t][c] - colors[i][c];
                squares += (uint32_t)(apart * apart);
            }
            if (squares < best) {
                best = squares;
                index[t] = (uint8_t)i;
            }
        }
        sum += best;
    }
    return sum;
}

/* Fits the end points to the chosen indices by least squares; leaves them where all texels have the same index. */
static void bc1_fit(uint8_t texels[TEXELS][4], const uint8_t index[TEXELS], float ends[2][3])
{
    static const float shares[] = {0, 1, 1.0f / 3, 2.0f / 3}; /* weight of the second end point, per index */
    float aa = 0, ab = 0, bb = 0, a[3] = {0}, b[3] = {0};
    for (uint32_t t = 0; t < TEXELS; t++) {
        float share = shares[index[t]], rest = 1 - share;
        aa += rest * rest;
        ab += rest * share;
        bb += share * share;
        for (int c = 0; c < 3; c++) {
            a[c] += rest * (float)texels[t][c];
            b[c] += share * (float)texels[t][c];
        }
    }
    float determinant = aa * bb - ab * ab;
    for (int c = 0; c < 3 && determinant >= 1e-3f; c++) {
        ends[0][c] = (bb * a[c] - ab * b[c]) / determinant;
        ends[1][c] = (aa * b[c] - ab * a[c]) / determinant;
    }
}

void hatch_bc1_encode(uint8_t texels[TEXELS][4], uint8_t block[8])
{
    float ends[2][3];
    uint32_t best = UINT32_MAX, chosen[2] = {0, 0};
    uint8_t index[TEXELS], tried[TEXELS];
    axis_ends(texels, ends);
    for (int round = 0; round < BC1_ROUNDS && best > 0; round++) {
        uint32_t a = bc1_end(ends[0]), b = bc1_end(ends[1]);
        if (a < b) { /* a block of four colours has the larger end point first */
            uint32_t larger = b;
            b = a;
            a = larger;
        }
        uint32_t error = bc1_choose(texels, a, b, tried);
        if (error >= best)
            break;
        best = error;
        chosen[0] = a;
        chosen[1] = b;
        memcpy(index, tried, sizeof index);
        if (a == b)
            break;
        bc1_fit(texels, index, ends);
    }
    struct bits bits = {block, 0};
    memset(block, 0, 8);
    put(&bits, 16, chosen[0]);
    put(&bits, 16, chosen[1]);
    for (uint32_t t = 0; t < TEXELS; t++)
        put(&bits, 2, index[t]);
}

void hatch_bc1_decode(const uint8_t block[8], uint8_t texels[TEXELS][4])
{
    uint8_t colors[4][3];
    uint32_t at = 32;
    bc1_colors(block[0] | (uint32_t)block[1] << 8, block[2] | (uint32_t)block[3] << 8, colors);
    for (uint32_t t = 0; t < TEXELS; t++) {
        memcpy(texels[t], colors[take(block, &at, 2)], 3);
        texels[t][3] = 255;
    }
}

/* Quantises a colour to seven bits per channel, followed by a lowest bit that all channels share. Returns that bit. */
static uint32_t bc7_end(const float color[3], uint8_t end[4])
{
    float best = 1e20f;
    uint32_t chosen = 0;
    for (uint32_t low = 0; low < 2; low++) {
        uint8_t tried[3];
        float sum = 0;
        for (int c = 0; c < 3; c++) {
            float seven = (color[c] - (float)low) / 2 + 0.5f;
            seven = seven > 0 ? (seven < 127 ? seven : 127) : 0;
            tried[c] = (uint8_t)((uint32_t)seven << 1 | low);
            sum += ((float)tried[c] - color[c]) * ((float)tried[c] - color[c]);
        }
        if (sum >= best)
            continue;
        best = sum;
        chosen = low;
        memcpy(end, tried, sizeof tried);
    }
    end[3] = (uint8_t)(254 | chosen);
    return chosen;
}

static void bc7_ends(uint8_t texels[TEXELS][4], uint8_t ends[2][4], uint32_t low_bits[2])
{
    float colors[2][3];
    axis_ends(texels, colors);
    for (int end = 0; end < 2; end++)
        low_bits[end] = bc7_end(colors[end], ends[end]);
}

static void bc7_choose(uint8_t texels[TEXELS][4], uint8_t ends[2][4], uint32_t index[TEXELS])
{
    int axis[3], length = 0;
    for (int c = 0; c < 3; c++) {
        axis[c] = ends[1][c] - ends[0][c];
        length += axis[c] * axis[c];
    }
    for (uint32_t t = 0; t < TEXELS; t++) {
        int along = 0;
        for (int c = 0; c < 3; c++)
            along += (texels[t][c] - ends[0][c]) * axis[c];
        int step = length && along > 0 ? (2 * BC7_STEPS * along + length) / (2 * length) : 0;
        index[t] = (uint32_t)(step < BC7_STEPS ? step : BC7_STEPS);
    }
}

void hatch_bc7_encode(uint8_t texels[TEXELS][4], uint8_t block[16])
{
    uint8_t ends[2][4];
    uint32_t low_bits[2], index[TEXELS];
    bc7_ends(texels, ends, low_bits);
    bc7_choose(texels, ends, index);
    /* The first index is stored with one bit less, so it must be in the lower half; if it is not, the end points are
     * swapped. */
    uint32_t swap = index[0] > BC7_STEPS / 2 ? 1 : 0;
    struct bits bits = {block, 7};
    memset(block, 0, 16);
    block[0] = BC7_MODE6;
    for (int c = 0; c < 4; c++)
        for (uint32_t end = 0; end < 2; end++)
            put(&bits, 7, ends[end ^ swap][c] >> 1);
    for (uint32_t end = 0; end < 2; end++)
        put(&bits, 1, low_bits[end ^ swap]);
    for (uint32_t t = 0; t < TEXELS; t++)
        put(&bits, t ? 4 : 3, swap ? BC7_STEPS - index[t] : index[t]);
}

bool hatch_bc7_decode(const uint8_t block[16], uint8_t texels[TEXELS][4])
{
    static const uint8_t weights[] = {0, 4, 9, 13, 17, 21, 26, 30, 34, 38, 43, 47, 51, 55, 60, 64};
    uint32_t ends[2][4], at = 7;
    if ((block[0] & 0x7f) != BC7_MODE6) {
        memset(texels, 0, 4 * TEXELS);
        return false;
    }
    for (int c = 0; c < 4; c++)
        for (int end = 0; end < 2; end++)
            ends[end][c] = take(block, &at, 7) << 1;
    for (int end = 0; end < 2; end++) {
        uint32_t low = take(block, &at, 1);
        for (int c = 0; c < 4; c++)
            ends[end][c] |= low;
    }
    for (uint32_t t = 0; t < TEXELS; t++) {
        uint32_t weight = weights[take(block, &at, t ? 4 : 3)];
        for (int c = 0; c < 4; c++)
            texels[t][c] = (uint8_t)(((64 - weight) * ends[0][c] + weight * ends[1][c] + 32) >> 6);
    }
    return true;
}
