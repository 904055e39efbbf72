/* Tonal art maps as runs: each texel's whole row along tone, run-length encoded ("The current
 * implementation of volume TAMs utilizes a large amount of texture memory ... it may be possible to
 * greatly reduce", Webb, Praun, Finkelstein & Hoppe 2002, §6). tamthresh(5) is the file.
 *
 * One buffer of 32-bit words, little-endian, to be uploaded as a storage buffer, a buffer texture or an
 * R32UI texture of HATCH_EXACT_WIDTH texels a row (word i at (i % width, i / width)):
 *
 *     0                HATCH_EXACT_VERSION
 *     1                size of the finest level, in texels each way
 *     2                levels in all
 *     3                levels that hold strokes
 *     4                columns
 *     5                word at which the runs begin
 *     6                runs
 *     7                0
 *     8 ..             for each level the word at which its index begins
 *     then             for each column its tone, a float
 *     then the indices: of each level, texel by texel from the top row on, the number of its first run;
 *                      the next word is that of the run behind its last
 *     then the runs:   16 bits each, two to a word, the low half first: column + 256 × darkness.
 *                      From that column on the texel has that darkness, 0 .. 255; before the first run
 *                      it is paper. Runs of a texel rise in column and, the map being nested, in darkness.
 *
 * A texel's darkness at tone t: with c the last column of tone at most t, and c + 1, blend the darkness
 * in force at both by where t lies between their tones (below the first column: paper at tone 0 and the
 * first). A shader does this for four texels (of two levels), then blends: no step is ever interpolated.
 */
#ifndef HATCH_TAM_EXACT_H
#define HATCH_TAM_EXACT_H

#include "base/parallel.h"
#include "image/texels.h"
#include "tam/tam.h"

#define HATCH_EXACT_VERSION 1u
#define HATCH_EXACT_WIDTH 1024u
#define HATCH_EXACT_HEAD 8u

struct hatch_exact {
    struct hatch_texels texels; /* HATCH_TEXELS_R32UI, HATCH_EXACT_WIDTH wide, one level */
    uint32_t size_px, level_count, levels, columns;
    uint32_t run_count;
};

/* Each value within half a step of 8 bits of the map's. HATCH_BAD_INPUT for a coloured map, and where
 * a texel gets lighter (hatch_tam_check_nesting); HATCH_LIMIT at 2^32 runs. */
enum hatch_status hatch_exact_make(const struct hatch_tam *tam, struct hatch_pool *pool, struct hatch_arena *arena,
                                   struct hatch_arena *scratch, struct hatch_exact *exact,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Takes a file's texture over (nothing is copied) and checks every offset in it, so that sampling cannot
 * leave it. HATCH_BAD_INPUT where it is none. */
enum hatch_status hatch_exact_from_texels(const struct hatch_texels *texels, struct hatch_exact *exact,
                                          struct hatch_err *err) HATCH_MUST_USE;

/* The tone of a column, 0 .. columns - 1. */
float hatch_exact_tone(const struct hatch_exact *exact, uint32_t column);

/* The reflectance, 0 .. 1, at (u, v), repeating, tone and level of detail lod (0 is the finest):
 * evaluated at each texel, then bilinear within a level, linear between two. */
float hatch_exact_sample(const struct hatch_exact *exact, float u, float v, float tone, float lod);

#endif
