/* Style sheets as vector editors write them: rules for elements, classes and ids. Private to io/svg*. */
#ifndef HATCH_IO_SVG_SHEET_H
#define HATCH_IO_SVG_SHEET_H

#include "io/svg/parts.h"

#define HATCH_SVG_RULES_MAX 4096u

/* One selector with its declarations. */
struct hatch_svg_rule {
    struct hatch_text selector, declarations;
    uint32_t weight; /* of ids, of classes, of elements: the heavier is applied later */
};

struct hatch_svg_sheet {
    struct hatch_svg_rule *rules; /* in the order in which they apply */
    uint32_t count;
    uint32_t others; /* selectors that are more than names joined, and rules that begin with '@' */
};

/* Reads the text of all sheets, which must stay. HATCH_LIMIT for more than HATCH_SVG_RULES_MAX selectors and when
 * arena is too small; what is no CSS is counted and left out. */
enum hatch_status hatch_svg_sheet_read(struct hatch_text text, struct hatch_arena *arena, struct hatch_svg_sheet *sheet,
                                       struct hatch_err *err) HATCH_MUST_USE;

/* Puts the properties of all rules that fit an element into its look. */
enum hatch_status hatch_svg_sheet_apply(const struct hatch_svg_sheet *sheet, const char *element,
                                        const char *const *attributes, double page, struct hatch_svg_look *look,
                                        struct hatch_err *err) HATCH_MUST_USE;

#endif
