/* Tonal art maps (Praun, Hoppe, Webb & Finkelstein, "Real-Time Hatching", SIGGRAPH 2001, §3): a grid
 * of tones × mip levels whose strokes nest: every stroke of an image is also in all darker images of
 * its size and in all finer images of its tone. */
#ifndef HATCH_TAM_TAM_H
#define HATCH_TAM_TAM_H

#include <stdbool.h>

#include "base/parallel.h"
#include "image/image.h"

#define HATCH_TAM_TONES_MAX 256u
#define HATCH_TAM_SIZE_MIN 64u
#define HATCH_TAM_SIZE_MAX 4096u

/* columns[tone], lightest first, each a full mip chain of size_px² images down to 1×1, level 0 the
 * finest. The channel is Y, or R, G and B: reflectance, 1 = paper, 0 = ink; then id and t where the
 * map holds them. */
struct hatch_tam {
    uint32_t size_px;
    uint32_t tones;
    uint32_t levels; /* levels that hold strokes; coarser ones are box-filtered */
    bool color;
    bool ids;
    float target[HATCH_TAM_TONES_MAX]; /* darkness that each column aims at, rising, 0 .. 1 */
    struct hatch_mipmap *columns;
};

/* The attributes of the file format tam(5). */
#define HATCH_TAM_ATTR_TONE "hatch:tone"
#define HATCH_TAM_ATTR_LEVELS "hatch:levels"
#define HATCH_TAM_ATTR_SEED "hatch:seed" /* text: EXR's integers have 32 bits, seeds 64 */
#define HATCH_TAM_ATTR_STYLE "hatch:style"
#define HATCH_TAM_ATTR_GROWTH "hatch:growth"

/* Checks that the parts of a file are a tonal art map and takes them over (nothing is copied):
 * names tone.000 upwards without gaps, equal square sizes, powers of two not required, full chains,
 * rising targets, finite pixels. HATCH_BAD_INPUT names the part. */
enum hatch_status hatch_tam_from_mipmaps(struct hatch_mipmap *parts, uint32_t count, struct hatch_tam *tam,
                                         struct hatch_err *err) HATCH_MUST_USE;

/* Whether no pixel gets lighter with tone, in any colour, by more than a step when rounded to 8 bits:
 * HATCH_BAD_INPUT names the first that does. pool: NULL is one thread. */
enum hatch_status hatch_tam_check_nesting(const struct hatch_tam *tam, struct hatch_pool *pool,
                                          struct hatch_arena *scratch, struct hatch_err *err) HATCH_MUST_USE;

/* What a texture unit returns of a column at (u, v), repeating, and a level of detail (0 is the finest, may
 * be between levels), the mean of R, G and B where there are three. column: -1 is paper. */
float hatch_tam_sample(const struct hatch_tam *tam, int column, float u, float v, float lod);

/* What is known of a map beside its pixels. Texts are not copied. */
struct hatch_tam_label {
    uint32_t levels;
    const char *seed, *style;
    float growth;
};

/* Gives one column the name and the attributes that the format wants. */
void hatch_tam_label_column(const struct hatch_tam_label *label, uint32_t tone, float target,
                            struct hatch_mipmap *column);

#endif
