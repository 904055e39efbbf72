/* Private to the SVG reader: style sheets, as far as vector editors use them: rules for elements, classes
 * and ids. */
#ifndef HATCH_IO_SVG_SHEET_H
#define HATCH_IO_SVG_SHEET_H

#include "io/svg/parts.h"

#define HATCH_SVG_RULES_MAX 4096u

/* A selector with its declarations. */
struct hatch_svg_rule {
    struct hatch_text selector, declarations;
    uint32_t specificity; /* CSS 2.1, section 6.4.3, in one number */
};

struct hatch_svg_sheet {
    struct hatch_svg_rule *rules; /* in ascending order of precedence */
    uint32_t count;
    uint32_t others; /* combined selectors and at-rules, which are ignored */
};

/* Parses style sheets; unknown rules are counted and ignored.
 *   text  of all sheets; must outlive the sheet
 * HATCH_LIMIT also for more than HATCH_SVG_RULES_MAX selectors. */
enum hatch_status hatch_svg_sheet_read(struct hatch_text text, struct hatch_arena *arena, struct hatch_svg_sheet *sheet,
                                       struct hatch_err *err) HATCH_MUST_USE;

/* Applies all rules that match an element to its style. */
enum hatch_status hatch_svg_sheet_apply(const struct hatch_svg_sheet *sheet, const char *element,
                                        const char *const *attributes, double page, struct hatch_svg_style *style,
                                        struct hatch_err *err) HATCH_MUST_USE;

#endif
