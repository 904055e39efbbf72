/* A drawing's elements, read whole, because clones and style sheets may stand behind what needs them. Private to
 * io/svg*. */
#ifndef HATCH_IO_SVG_TREE_H
#define HATCH_IO_SVG_TREE_H

#include <stdbool.h>

#include "base/text.h"

#define HATCH_SVG_DEPTH_MAX 256u
#define HATCH_SVG_CLONED_MAX 1000000u /* elements that are drawn because of clones */

struct hatch_svg_node {
    const char *name;              /* "svg:" taken off */
    const char *const *attributes; /* names and values in turn, NULL-terminated */
    struct hatch_svg_node *parent, *first, *last, *next;
    uint32_t line, number; /* in the file */
    bool counting;         /* it is being counted: a clone that leads here holds itself */
    uint32_t height;       /* elements below one another from here on, with clones; 0: not counted yet */
    uint64_t elements;     /* from here on, with clones */
};

struct hatch_svg_tree {
    struct hatch_svg_node *root;
    struct hatch_svg_node **named; /* those with an id, in its order; of equal ones the first of the file */
    uint32_t count, named_count;
    struct hatch_buffer sheet; /* what stands in all <style> elements */
    uint32_t others;           /* style sheets that are not in the file */
};

/* Reads by expat. HATCH_BAD_INPUT with the line for XML that is not well-formed, a first element that is no
 * <svg>, elements nested deeper than HATCH_SVG_DEPTH_MAX, entities that name entities or other files, clones
 * that hold themselves or nest too deep; HATCH_LIMIT for more than HATCH_SVG_CLONED_MAX elements by clones, and
 * when arena is too small. */
enum hatch_status hatch_svg_tree_read(struct hatch_bytes file, struct hatch_arena *arena, struct hatch_svg_tree *tree,
                                      struct hatch_err *err) HATCH_MUST_USE;

/* What a clone names: "#id", in its href or xlink:href; empty where there is none. */
struct hatch_text hatch_svg_href(const struct hatch_svg_node *node);

/* The element of that id ("#id"), or NULL. */
struct hatch_svg_node *hatch_svg_find(const struct hatch_svg_tree *tree, struct hatch_text href);

#endif
