/* Tonal art maps (Praun, Hoppe, Webb & Finkelstein, "Real-Time Hatching", SIGGRAPH 2001, §3): a grid
 * of images over tones and mip levels whose strokes nest: every stroke of an image is also in all
 * darker images of its level and in all finer images of its tone. */
#ifndef HATCH_TAM_TAM_H
#define HATCH_TAM_TAM_H

#include <stdbool.h>

#include "base/parallel.h"
#include "image/image.h"

#define HATCH_TAM_TONES_MAX 256u
#define HATCH_TAM_SIZE_MIN 64u   /* pixels, finest level */
#define HATCH_TAM_SIZE_MAX 4096u /* pixels, finest level */

/* The whole map of one whose darkest columns or finest levels were not made because no view needs them. */
struct hatch_tam_whole {
    uint32_t size_px; /* width of its finest level */
    uint32_t tones;   /* number of its columns; a map that is whole has as many */
    float darkest;    /* tone of its last column */
    float tolerance;  /* mean difference of tone that was allowed, 0 .. 1; 0: the map is whole, and not rounded */
};

/* The channels of every image are Y, or R, G and B (reflectance, 1 = paper, 0 = ink), followed by id and t if ids is
 * set. */
struct hatch_tam {
    uint32_t size_px; /* width and height of the finest level */
    uint32_t tones;   /* number of columns, 1 .. HATCH_TAM_TONES_MAX */
    uint32_t levels;  /* number of drawn levels; the coarser ones are box-filtered */
    bool color;
    bool ids;
    bool flat;                         /* crossing strokes are no darker than the darker one of them */
    float target[HATCH_TAM_TONES_MAX]; /* target tone of each column, 0 .. 1, never falling */
    struct hatch_tam_whole whole;      /* equals the members above where nothing was left out */
    struct hatch_mipmap *columns;      /* one per tone, lightest first, each a full mip chain down to 1x1 */
};

/* Attributes of the file format, tam(5). */
#define HATCH_TAM_ATTR_TONE "hatch:tone"
#define HATCH_TAM_ATTR_TONES "hatch:tones"
#define HATCH_TAM_ATTR_LEVELS "hatch:levels"
#define HATCH_TAM_ATTR_SEED "hatch:seed" /* text: EXR's integers have 32 bits, random seeds 64 */
#define HATCH_TAM_ATTR_STYLE "hatch:style"
#define HATCH_TAM_ATTR_GROWTH "hatch:growth"
#define HATCH_TAM_ATTR_OVERLAP "hatch:overlap" /* text: FLAT; missing where crossing strokes darken each other */
#define HATCH_TAM_OVERLAP_FLAT "flat"
#define HATCH_TAM_ATTR_STROKES "hatch:strokes" /* text: stroke script, in the last column of a map with ids */
/* Of maps that are not whole, or rounded */
#define HATCH_TAM_ATTR_WHOLE_SIZE "hatch:whole-size"
#define HATCH_TAM_ATTR_WHOLE_TONES "hatch:whole-tones"
#define HATCH_TAM_ATTR_WHOLE_TONE "hatch:whole-tone"
#define HATCH_TAM_ATTR_TOLERANCE "hatch:tolerance"

/* Interprets the parts of a file as a tonal art map. Checks that they are named tone.000, tone.001 and so on, and that
 * they have equal square sizes (powers of two or not), full mip chains, targets that never fall, and finite pixels, and
 * that there are as many as they say.
 *   parts  count parts in file order; kept by reference
 *   tam    out; unchanged on failure
 * HATCH_BAD_INPUT with the name of the part. */
enum hatch_status hatch_tam_from_mipmaps(struct hatch_mipmap *parts, uint32_t count, struct hatch_tam *tam,
                                         struct hatch_err *err) HATCH_MUST_USE;

/* Returns whether all columns and levels of a map were made. */
bool hatch_tam_is_whole(const struct hatch_tam *tam);

/* The message where a map must be whole. */
#define HATCH_TAM_NOT_WHOLE "was made for the needs of some views; make the map without --needs"

/* Checks that no pixel gets lighter from one column to the next, in any colour channel, by more than one step of 8
 * bits.
 *   pool  NULL: one thread
 * HATCH_BAD_INPUT with the first pixel that gets lighter. */
enum hatch_status hatch_tam_check_nesting(const struct hatch_tam *tam, struct hatch_pool *pool,
                                          struct hatch_arena *scratch, struct hatch_err *err) HATCH_MUST_USE;

/* Samples the reflectance of a column as a texture unit does, trilinearly; the mean of R, G and B in colour.
 *   column  0 .. tones - 1; -1 is paper
 *   u, v    texture coordinates, repeating
 *   lod     level of detail: 0 is the finest level, fractions lie between levels */
float hatch_tam_sample(const struct hatch_tam *tam, int column, float u, float v, float lod);

/* Metadata of a map, written to each column. Texts are kept by reference. */
struct hatch_tam_metadata {
    uint32_t tones;               /* number of columns */
    uint32_t levels;              /* number of drawn levels */
    const char *seed;             /* random seed, decimal */
    const char *style;            /* name of the style */
    bool flat;                    /* as in struct hatch_tam */
    float growth;                 /* as in struct hatch_fill_options */
    struct hatch_tam_whole whole; /* tones 0: the map is whole, and not rounded */
};

/* Sets the name and the attributes of a column, as tam(5) requires.
 *   tone    index of the column
 *   target  target tone of the column */
void hatch_tam_set_metadata(const struct hatch_tam_metadata *metadata, uint32_t tone, float target,
                            struct hatch_mipmap *column);

#endif
