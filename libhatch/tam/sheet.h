/* Contact sheets: the grid of tones and levels as one picture (Praun et al. 2001, Figure 2). */
#ifndef HATCH_TAM_SHEET_H
#define HATCH_TAM_SHEET_H

#include "tam/tam.h"

struct hatch_tam_sheet_options {
    uint32_t size_px; /* of the finest level */
    uint32_t levels;  /* number of drawn levels */
    uint32_t tones;   /* number of columns of the map */
    uint32_t shown;   /* number of columns on the sheet, 1 .. tones: evenly chosen, the last one included */
    bool color;
};

/* Tones run from left to right, drawn levels from the coarsest at the top to the finest at the bottom, on
 * light grey. */
struct hatch_tam_sheet {
    struct hatch_tam_sheet_options options;
    struct hatch_image picture; /* Y, or R, G and B; in the arena of hatch_tam_sheet_make */
};

/* Makes a sheet that shows no columns yet.
 *   sheet  out; its pixels are in arena */
enum hatch_status hatch_tam_sheet_make(const struct hatch_tam_sheet_options *options, struct hatch_arena *arena,
                                       struct hatch_tam_sheet *sheet, struct hatch_err *err) HATCH_MUST_USE;

/* Copies the drawn levels of a column to the sheet; does nothing for a column that is not shown.
 *   tone  index of the column */
void hatch_tam_sheet_add(struct hatch_tam_sheet *sheet, uint32_t tone, const struct hatch_mipmap *column);

#endif
