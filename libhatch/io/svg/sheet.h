/* Private to the SVG reader: style sheets with the rules that vector editors write, which are for elements, classes and
 * ids. */
#ifndef HATCH_IO_SVG_SHEET_H
#define HATCH_IO_SVG_SHEET_H

#include "io/svg/parts.h"

#define HATCH_SVG_RULES_MAX 4096u

/* A selector with its declarations. */
struct hatch_svg_rule {
    struct hatch_text selector, declarations;
    uint32_t specificity; /* 1, and the specificity of CSS 2.1, section 6.4.3, as one number */
};

struct hatch_svg_sheet {
    struct hatch_svg_rule *rules; /* in ascending order of precedence */
    uint32_t count;
    uint32_t others; /* number of at-rules and unsupported selectors, which are ignored */
};

/* Parses style sheets; rules that are not supported are counted and ignored.
 *   text  text of all sheets together
 * HATCH_LIMIT also for more than HATCH_SVG_RULES_MAX selectors. */
enum hatch_status hatch_svg_sheet_read(struct hatch_text text, struct hatch_arena *arena, struct hatch_svg_sheet *sheet,
                                       struct hatch_err *err) HATCH_MUST_USE;

/* Applies all rules that match an element to its style.
 *   page       side of the page in user units, for percentages
 *   important  as for hatch_svg_declarations */
void hatch_svg_sheet_apply(const struct hatch_svg_sheet *sheet, const char *element, const char *const *attributes,
                           double page, bool important, struct hatch_svg_style *style);

#endif
