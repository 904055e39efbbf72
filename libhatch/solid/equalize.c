#include "solid/equalize.h"

#include <string.h>

#define CUTS 255u /* between 256 bytes */
#define DIGIT_BITS 10u
#define DIGITS (1u << DIGIT_BITS)
#define KEY_BITS 60u /* 32 of the value, 28 of the hash */
#define PIECES_MAX 8u

/* The 255 keys at which bytes change, called cuts, are found digit by digit, from the highest: keys that agree with a
 * cut in all digits so far are counted by their next digit. */
struct equalizing {
    const float *values;
    uint8_t *bytes;
    uint32_t count, pieces;
    uint32_t shift;          /* of the present digit within a key */
    uint64_t cuts[CUTS];     /* the first key of bytes 1 .. 255: the digits found so far */
    uint32_t below[CUTS];    /* number of keys with smaller digits so far */
    uint64_t prefixes[CUTS]; /* the different digits of cuts so far, rising */
    uint32_t prefix_count;
    uint32_t *counts[PIECES_MAX]; /* per piece of the values: [prefix * DIGITS + digit] */
};

/* Returns a key in the order of the values; no two are equal. */
static uint64_t key_of(const struct equalizing *e, uint32_t index)
{
    uint32_t bits, mask = (1u << 28) - 1, hash = index;
    float value = e->values[index] + 0.0f; /* -0 becomes 0 */
    memcpy(&bits, &value, sizeof bits);
    bits ^= bits >> 31 ? UINT32_MAX : 0x80000000u;
    for (int round = 0; round < 2; round++) { /* each step permutes 0 .. 2^28 - 1 */
        hash = hash * 0x2c1b3c6du & mask;
        hash ^= hash >> 14;
    }
    return (uint64_t)bits << 28 | (hash * 0x297a2d39u & mask);
}

/* Returns the number of entries of a rising list that are at most key. */
static uint32_t count_upto(const uint64_t *list, uint32_t count, uint64_t key)
{
    uint32_t low = 0;
    while (count > 0) {
        uint32_t half = count / 2;
        if (list[low + half] <= key) {
            low += half + 1;
            count -= half + 1;
        } else
            count = half;
    }
    return low;
}

static void count_digits(void *context, uint32_t piece)
{
    const struct equalizing *e = context;
    uint32_t *counts = e->counts[piece], size = e->count / e->pieces, end = (piece + 1) * size;
    memset(counts, 0, (size_t)e->prefix_count * DIGITS * sizeof *counts);
    for (uint32_t i = piece * size; i < end; i++) {
        uint64_t key = key_of(e, i) >> e->shift, prefix = key / DIGITS;
        uint32_t upto = count_upto(e->prefixes, e->prefix_count, prefix);
        if (upto && e->prefixes[upto - 1] == prefix)
            counts[(size_t)(upto - 1) * DIGITS + key % DIGITS]++;
    }
}

/* Finds the next digit of each cut. */
static void find_digits(struct equalizing *e)
{
    for (uint32_t piece = 1; piece < e->pieces; piece++)
        for (uint32_t i = 0; i < e->prefix_count * DIGITS; i++)
            e->counts[0][i] += e->counts[piece][i];
    for (uint32_t cut = 0; cut < CUTS; cut++) {
        uint32_t group = count_upto(e->prefixes, e->prefix_count, e->cuts[cut]) - 1, digit = 0;
        const uint32_t *counts = e->counts[0] + (size_t)group * DIGITS;
        uint32_t left = (uint32_t)((uint64_t)e->count * (cut + 1) / (CUTS + 1)) - e->below[cut];
        for (; counts[digit] <= left; digit++) {
            left -= counts[digit];
            e->below[cut] += counts[digit];
        }
        e->cuts[cut] = e->cuts[cut] * DIGITS + digit;
    }
    e->prefix_count = 0;
    for (uint32_t cut = 0; cut < CUTS; cut++)
        if (!e->prefix_count || e->prefixes[e->prefix_count - 1] != e->cuts[cut])
            e->prefixes[e->prefix_count++] = e->cuts[cut];
}

static void fill_bytes(void *context, uint32_t piece)
{
    const struct equalizing *e = context;
    uint32_t size = e->count / e->pieces, end = (piece + 1) * size;
    for (uint32_t i = piece * size; i < end; i++)
        e->bytes[i] = (uint8_t)count_upto(e->cuts, CUTS, key_of(e, i));
}

static enum hatch_status equalize(struct equalizing *e, struct hatch_pool *pool, struct hatch_arena *scratch,
                                  struct hatch_err *err)
{
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &e->counts[0], (size_t)CUTS * DIGITS, err));
    for (uint32_t piece = 1; piece < e->pieces; piece++)
        if (HATCH_ALLOC_UNSET(scratch, &e->counts[piece], (size_t)CUTS * DIGITS, err) != HATCH_OK)
            e->pieces = piece; /* the memory is short: fewer and larger pieces, of the same result */
    while (e->pieces & (e->pieces - 1))
        e->pieces--;
    e->prefix_count = 1;
    for (e->shift = KEY_BITS; e->shift > 0;) {
        e->shift -= DIGIT_BITS;
        hatch_parallel_for(pool, e->pieces, count_digits, e);
        find_digits(e);
    }
    hatch_parallel_for(pool, e->pieces, fill_bytes, e);
    return HATCH_OK;
}

enum hatch_status hatch_equalize(const float *values, uint32_t count, struct hatch_pool *pool,
                                 struct hatch_arena *scratch, uint8_t *bytes, struct hatch_err *err)
{
    struct equalizing e = {.values = values, .bytes = bytes, .count = count, .pieces = 1};
    while (e.pieces < PIECES_MAX && e.pieces < hatch_pool_threads(pool))
        e.pieces *= 2;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = equalize(&e, pool, scratch, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}
