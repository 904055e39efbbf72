/* Reads SVG drawings with expat: the strokes of their shapes, in drawing order. */
#ifndef HATCH_IO_SVG_SVG_H
#define HATCH_IO_SVG_SVG_H

#include <stdbool.h>

#include "base/bytes.h"
#include "stroke/stroke.h"

/* Counts of the contents of a drawing; everything but the strokes is ignored. */
struct hatch_svg_notes {
    uint32_t strokes;   /* strokes that were read */
    uint32_t outside;   /* strokes entirely outside the page */
    uint32_t far;       /* strokes that reach more than HATCH_PATH_REACH_MAX tiles from their middle or from the page */
    uint32_t fills;     /* filled shapes, stroked or not */
    uint32_t texts;     /* text elements */
    uint32_t images;    /* image elements */
    uint32_t gradients; /* strokes painted with a gradient or a pattern */
    uint32_t others;    /* unknown elements, external style sheets, CSS rules that are not supported, clones of missing
                           elements, filters, masks, clipping paths and transforms in CSS that are not applied */
};

/* Returns whether a file looks like XML. */
bool hatch_svg_is(struct hatch_bytes file);

/* Reads the strokes of a drawing. The page (viewBox, else width and height) becomes the tile. Each subpath, and each
 * dash, becomes a stroke: its colour is linear, its tone is the product of all opacities and its alpha,
 * and its line is flattened to 1/20 pixel and wrapped at the page's borders; ids count from 1 in drawing order. <style>
 * elements are applied (rules for elements, classes and ids), and clones (<use>) are drawn. No other file is opened.
 *   size_px  side of the tile, for stroke widths
 *   strokes  out: in arena
 * HATCH_BAD_INPUT with the line for malformed XML, numbers and paths, strokes wider than HATCH_SCRIPT_WIDTH_MAX tiles,
 * a page that is not square, elements nested deeper than 256 (with clones expanded), elements that contain clones of
 * themselves, clones of elements in other files, and entities that are external or refer to entities; HATCH_LIMIT also
 * for a page of over 10^6 units, 10^6 elements drawn by clones, and 10^6 dashes. */
enum hatch_status hatch_svg_read(struct hatch_bytes file, uint32_t size_px, struct hatch_arena *arena,
                                 struct hatch_arena *scratch, struct hatch_stroke_list *strokes,
                                 struct hatch_svg_notes *notes, struct hatch_err *err) HATCH_MUST_USE;

#endif
