/* Private to the SVG reader: the tree of a drawing's elements. It is read before anything is drawn, since an element
 * may come before the style sheet that applies to it or the element that it clones. */
#ifndef HATCH_IO_SVG_TREE_H
#define HATCH_IO_SVG_TREE_H

#include <stdbool.h>

#include "base/text.h"

#define HATCH_SVG_DEPTH_MAX 256u
#define HATCH_SVG_CLONED_MAX 1000000u /* limit of the elements drawn by clones */

struct hatch_svg_node {
    const char *name;              /* without the prefix "svg:" */
    const char *const *attributes; /* names and values alternating, NULL-terminated */
    struct hatch_svg_node *parent, *first, *last, *next;
    uint32_t line;   /* line in the file */
    uint32_t number; /* position in document order */
    bool visiting; /* set while the elements inside are counted; one that is reached again contains a clone of itself */
    uint32_t height;   /* levels of elements from this one down, with clones expanded; 0: not yet counted */
    uint64_t elements; /* number of elements: this one and those inside, with clones expanded */
};

struct hatch_svg_tree {
    struct hatch_svg_node *root;
    struct hatch_svg_node **named; /* elements with an id, sorted by id, then by document order */
    uint32_t count, named_count;
    struct hatch_buffer sheet; /* text of all <style> elements */
    uint32_t others;           /* number of external style sheets, which are ignored */
};

/* Reads the tree and checks its clones. HATCH_BAD_INPUT with the line for malformed XML, a root other than <svg>,
 * elements nested deeper than HATCH_SVG_DEPTH_MAX, entities that are external or refer to entities, and elements that
 * contain clones of themselves; HATCH_LIMIT also for more than HATCH_SVG_CLONED_MAX elements drawn by clones. */
enum hatch_status hatch_svg_tree_read(struct hatch_bytes file, struct hatch_arena *arena, struct hatch_svg_tree *tree,
                                      struct hatch_err *err) HATCH_MUST_USE;

/* Returns the href or xlink:href of a clone ("#id"); empty when absent. */
struct hatch_text hatch_svg_href(const struct hatch_svg_node *node);

/* Finds the element that an href ("#id") refers to; NULL when there is none. */
struct hatch_svg_node *hatch_svg_find(const struct hatch_svg_tree *tree, struct hatch_text href);

#endif
