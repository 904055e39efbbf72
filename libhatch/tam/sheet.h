/* A contact sheet: the grid of tones × levels as one picture (Praun et al. 2001, Figure 2). */
#ifndef HATCH_TAM_SHEET_H
#define HATCH_TAM_SHEET_H

#include "tam/tam.h"

/* Tones from left to right, drawn levels from the coarsest at the top to the finest at the bottom, on
 * a light grey ground. */
struct hatch_tam_sheet {
    struct hatch_image picture;             /* Y, or R, G and B */
    uint32_t size_px, levels, tones, shown; /* shown: columns on the sheet */
};

/* shown: 1 .. tones; that many columns, evenly chosen, the last one included. */
enum hatch_status hatch_tam_sheet_make(uint32_t size_px, uint32_t levels, uint32_t tones, bool color, uint32_t shown,
                                       struct hatch_arena *arena, struct hatch_tam_sheet *sheet,
                                       struct hatch_err *err) HATCH_MUST_USE;

/* Puts a column into its place; does nothing for one that is not shown. */
void hatch_tam_sheet_add(struct hatch_tam_sheet *sheet, uint32_t tone, const struct hatch_mipmap *column);

#endif
