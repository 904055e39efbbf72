/* Fills tonal art maps with strokes (Praun et al. 2001, §4). */
#ifndef HATCH_PLACEMENT_FILL_H
#define HATCH_PLACEMENT_FILL_H

#include "base/progress.h"
#include "base/parallel.h"
#include "stroke/stroke.h"
#include "placement/style.h"
#include "tam/sink.h"
#include "tam/tam.h"

enum hatch_fill_method {
    HATCH_FILL_FIELD,     /* default: scores candidates on a potential field, then refines their positions */
    HATCH_FILL_EXHAUSTIVE /* the loop of the paper: scores each candidate's footprint on every level of every pyramid */
};

struct hatch_fill_options {
    const struct hatch_style *style;
    const struct hatch_brush *brush; /* of the style */
    uint32_t size_px;                /* HATCH_TAM_SIZE_MIN .. HATCH_TAM_SIZE_MAX, a power of two */
    uint32_t tones;                  /* number of columns, 1 .. HATCH_TAM_TONES_MAX */
    uint32_t needed;                 /* number of columns that are filled, the first ones; 0: all */
    uint32_t every;                  /* of those, only each every-th one is passed on, and the map has the columns of
                                        one of tones / every; divides tones and needed; 0: 1 */
    uint32_t whole_size_px;          /* size_px of the whole map of which this is a part; 0: the same */
    float tolerance;                 /* that the map names: struct hatch_tam_whole; 0: it is whole, and not rounded */
    uint32_t levels;                 /* number of drawn levels, 1 upwards; the coarsest has at least 32 pixels */
    enum hatch_fill_method method;
    uint64_t seed;                         /* random seed */
    const struct hatch_progress *progress; /* kept by reference; NULL: nobody is told */
    float growth; /* 0 .. 0.9: at first strokes are shorter by this share, and thinner by half of it; they grow to full
                     size over a third of the columns (Praun et al. 2001, §8, "stroke growth") */
    bool color;   /* columns hold R, G and B, strokes have the colours of the style */
    bool ids;     /* columns also hold the channels id (0: no stroke) and t (0 .. 1 along the stroke); where strokes
                     cross, the first one drawn keeps the pixel. The last column has the list of the strokes if they
                     darken one another (tam(5)) */
};

/* Difference of a mean tone that is no longer that of the last stroke: the installed styles stay below it. */
#define HATCH_FILL_TONE 0.05f

/* Images of a map whose mean tones are not those of their columns. */
struct hatch_fill_misses {
    uint32_t images; /* number of images that differ by more than HATCH_FILL_TONE */
    float most;      /* largest difference of an image, 0 .. 1 */
    uint32_t level;  /* that image's */
    bool light_ink;  /* more strokes do not darken that image; otherwise, its strokes are too large for the tone */
};

/* Fills a map and passes each column to sink. Deterministic for any number of threads.
 *   arena    receives the strokes
 *   strokes  out: in drawing order; may be NULL
 *   misses   out, of the columns that were passed on; may be NULL; unchanged on failure
 * The status of sink; HATCH_LIMIT when memory does not suffice. */
enum hatch_status hatch_tam_fill(const struct hatch_fill_options *options, struct hatch_arena *arena,
                                 struct hatch_arena *scratch, const struct hatch_tam_sink *sink,
                                 struct hatch_stroke_list *strokes, struct hatch_fill_misses *misses,
                                 struct hatch_err *err) HATCH_MUST_USE;

#endif
