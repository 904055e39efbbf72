/* Filling a tonal art map with strokes (Praun et al. 2001, §4). */
#ifndef HATCH_TAM_FILL_H
#define HATCH_TAM_FILL_H

#include "base/parallel.h"
#include "stroke/stroke.h"
#include "placement/style.h"
#include "tam/tam.h"

enum hatch_fill_method {
    HATCH_FILL_FIELD,     /* candidates scored on one potential field, then refined: the default */
    HATCH_FILL_EXHAUSTIVE /* the paper's loop: every candidate's footprint, every level, every pyramid */
};

struct hatch_fill_options {
    uint32_t size_px; /* HATCH_TAM_SIZE_MIN .. MAX, a power of two */
    uint32_t tones;   /* 1 .. HATCH_TAM_TONES_MAX */
    uint32_t levels;  /* 1 .. ; size_px >> (levels - 1) at least 32 */
    enum hatch_fill_method method;
    uint64_t seed;
    float growth; /* 0 .. 0.9: a stroke begins that share shorter and thinner, and grows to
                     its full size over a third of the columns (§8, "stroke growth") */
    bool color;   /* columns hold R, G and B, and strokes the style's colours */
    bool ids;     /* add the channels id (0: no stroke) and t (0..1 along it); where strokes
                     cross, the first one drawn keeps the pixel */
};

/* Called once per tone, lightest first, with the finished column; the images live until it returns. */
typedef enum hatch_status (*hatch_tam_sink)(void *context, uint32_t tone, const struct hatch_mipmap *column,
                                            struct hatch_err *err);

/* Fills the map and hands each column to sink. Strokes go to list, in drawing order, where list is not
 * NULL. The result does not depend on the number of threads. brush: the style's. */
enum hatch_status hatch_tam_fill(const struct hatch_style *style, const struct hatch_brush *brush,
                                 const struct hatch_fill_options *options, struct hatch_arena *arena,
                                 struct hatch_arena *scratch, hatch_tam_sink sink, void *context,
                                 struct hatch_stroke_list *list, struct hatch_err *err) HATCH_MUST_USE;

#endif
