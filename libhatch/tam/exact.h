/* Exact runs: tonal art maps with the darkness of each texel over tone run-length encoded. This is the compression
 * that Webb, Praun, Finkelstein & Hoppe 2002, §6, propose for volumes ("it may be possible to greatly reduce" their
 * memory). tamthresh(5) describes the file.
 *
 * One buffer of 32-bit words, little-endian, uploaded as a storage buffer, a buffer texture or an R32UI texture
 * of HATCH_EXACT_WIDTH texels per row (word i at (i % width, i / width)):
 *
 *     0                HATCH_EXACT_VERSION
 *     1                width and height of the finest level, in texels
 *     2                number of levels
 *     3                number of drawn levels
 *     4                number of columns
 *     5                word at which the runs begin
 *     6                number of runs
 *     7                0
 *     8 ..             per level, the word at which its index begins
 *     then             per column, its tone, a float
 *     then the indices: per level, for each texel from the top row on, the number of its first run; a last entry
 *                      holds the end of the last texel's runs
 *     then the runs:   16 bits each, two per word, the low half first: column + 256 * darkness. The texel has
 *                      darkness 0 .. 255 from that column on; before its first run it is paper. Columns and,
 *                      because the map is nested, darknesses rise over the runs of a texel.
 *
 * The darkness of a texel at tone t: let c be the last column of tone t or less. Interpolate the darknesses at
 * columns c and c + 1 by the position of t between their tones; below the first column, between paper at tone 0
 * and the first column. A shader evaluates four texels (of one or two levels) and filters the results, so no step
 * is ever interpolated.
 */
#ifndef HATCH_TAM_EXACT_H
#define HATCH_TAM_EXACT_H

#include "base/parallel.h"
#include "image/texels.h"
#include "tam/tam.h"

#define HATCH_EXACT_VERSION 1u
#define HATCH_EXACT_WIDTH 1024u
#define HATCH_EXACT_HEAD 8u /* number of words before the list of index positions */

struct hatch_exact {
    struct hatch_texels texels; /* HATCH_TEXELS_R32UI, HATCH_EXACT_WIDTH wide, one level */
    uint32_t size_px;           /* of the finest level */
    uint32_t level_count;
    uint32_t levels; /* number of drawn levels */
    uint32_t columns;
    uint32_t run_count;
};

/* Encodes a map; darkness is rounded to 8 bits.
 *   pool   NULL: one thread
 *   exact  out; its texels are in arena
 * HATCH_BAD_INPUT for a map in colour and where a texel gets lighter (hatch_tam_check_nesting); HATCH_LIMIT for
 * 2^32 runs or more, or when memory does not suffice. */
enum hatch_status hatch_exact_make(const struct hatch_tam *tam, struct hatch_pool *pool, struct hatch_arena *arena,
                                   struct hatch_arena *scratch, struct hatch_exact *exact,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Interprets a file's texture as exact runs. Checks every offset in it, so that sampling never reads outside it.
 *   texels  its levels are kept by reference
 *   exact   out; unchanged on failure
 * HATCH_BAD_INPUT for anything else. */
enum hatch_status hatch_exact_from_texels(const struct hatch_texels *texels, struct hatch_exact *exact,
                                          struct hatch_err *err) HATCH_MUST_USE;

/* Returns the target tone of a column.
 *   column  0 .. columns - 1 */
float hatch_exact_tone(const struct hatch_exact *exact, uint32_t column);

/* Returns the reflectance, 0 .. 1: evaluates each texel, then filters bilinearly within a level and linearly
 * between two.
 *   u, v  texture coordinates, repeating
 *   tone  0 paper .. 1 ink
 *   lod   level of detail: 0 is the finest level, fractions lie between levels */
float hatch_exact_sample(const struct hatch_exact *exact, float u, float v, float tone, float lod);

#endif
