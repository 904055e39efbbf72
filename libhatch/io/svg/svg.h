/* Drawings in SVG, by expat: the strokes of its paths in drawing order. */
#ifndef HATCH_IO_SVG_H
#define HATCH_IO_SVG_H

#include <stdbool.h>

#include "base/bytes.h"
#include "stroke/stroke.h"

/* What was passed over, counted. */
struct hatch_svg_notes {
    uint32_t strokes; /* made */
    uint32_t outside; /* strokes that lie beyond the page altogether */
    uint32_t fills;   /* shapes that are filled, stroked or not */
    uint32_t texts;
    uint32_t images;
    uint32_t gradients; /* strokes of a gradient or a pattern */
    uint32_t others;    /* style sheets elsewhere, rules that are not understood,
                           clones of nothing, filters, masks and clips */
};

/* Whether the file looks like XML rather than a table. */
bool hatch_svg_is(struct hatch_bytes file);

/* The page (the viewBox, or else width and height) becomes the tile; it must be a square. A stroke's
 * colour becomes linear, its opacity (its own, its shape's and its groups') its tone, its width pixels of
 * size_px; its line is flattened to a twentieth of such a pixel, and wraps where it leaves the page. ids
 * count from 1 in drawing order. Subpaths, and dashes, are strokes of their own. Style sheets in the file are
 * read: rules for elements, classes and ids. Clones (<use>) draw what they name again.
 * Nothing outside the file is ever opened: an external entity, and a clone of another file's shape, are
 * refused. HATCH_BAD_INPUT with the line for XML that is not well-formed, no SVG, a number or a path that is
 * malformed, elements nested deeper than 256 with clones, clones of themselves, entities that name entities, a
 * page that is no square. HATCH_LIMIT for a page of more than a million units, a million elements by clones or
 * dashes, and when arena or scratch is too small. */
enum hatch_status hatch_svg_read(struct hatch_bytes file, uint32_t size_px, struct hatch_arena *arena,
                                 struct hatch_arena *scratch, struct hatch_stroke_list *strokes,
                                 struct hatch_svg_notes *notes, struct hatch_err *err) HATCH_MUST_USE;

#endif
