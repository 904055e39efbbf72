/* Maps of which a part was made, and textures made from such maps, which name the whole map in the keys of their
 * files. */
#ifndef HATCH_TAM_WHOLE_H
#define HATCH_TAM_WHOLE_H

#include "tam/tam.h"

#define HATCH_TAM_ATTR_LAST_TONE                                                                                       \
    "hatch:last-tone" /* of textures: tone of the last column of the part that was made                                \
                       */

/* Keys and values of a texture that is made from a map, for its file. */
struct hatch_tam_whole_keys {
    char values[4][32];
    const char *pairs[9]; /* keys and values alternate; NULL-terminated */
};

/* Fills the keys: none where the map is whole. The pairs point into `keys`. */
void hatch_tam_whole_print(const struct hatch_tam *tam, struct hatch_tam_whole_keys *keys);

/* Reads them.
 *   key_values  of a file, as from hatch_ktx2_read_keys
 *   size_px     side of the texture's finest level
 *   whole       out: tolerance 0 where the map was whole; `tones` is 0. Unchanged on failure
 *   last        out: tone of the last column; unchanged where the map was whole
 * HATCH_BAD_INPUT for a value out of range, or a key that is missing. */
enum hatch_status hatch_tam_whole_read(const char *const *key_values, uint32_t size_px, struct hatch_tam_whole *whole,
                                       float *last, struct hatch_err *err) HATCH_MUST_USE;

/* Leaves the darkest columns and the finest levels of a map out.
 *   tones      number of columns that stay, 1 .. tam->tones
 *   finer      number of levels that go, below the number of drawn levels
 *   tolerance  that the map then names */
void hatch_tam_cut(struct hatch_tam *tam, uint32_t tones, uint32_t finer, double tolerance);

/* Returns the largest step of hatch_tam_round, a power of 1/2: at most 1/8 and 16 times the tolerance; 0 for steps
 * under 2^-11, the precision of a file, which are not made. A pixel gets lighter by at most half of a step.
 *   tolerance  0 upwards */
float hatch_tam_step_max(double tolerance);

/* Rounds the reflectance of the drawn levels of a column, which then takes fewer bytes in a file. The step of a level
 * is a power of 1/2, at most hatch_tam_step_max, by which means over blocks of 8 × 8 pixels that have ink
 * change by half of the tolerance at most (root mean square), unless a finer step would change more: pixels that the
 * column before has rounded down stay so.
 *   levels     number of drawn levels
 *   tolerance  mean difference of tone, over 0
 *   rounded    in: the column before as it was rounded, or paper; out: no pixel is lighter. The size and the channels
 *              are those of column */
void hatch_tam_round(const struct hatch_mipmap *column, uint32_t levels, double tolerance,
                     struct hatch_mipmap *rounded);

#endif
