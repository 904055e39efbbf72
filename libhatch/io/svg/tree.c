#include "io/svg/tree.h"

#define XML_DTD /* without this, expat's header does not declare its limits on entities */
#include <expat.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "io/svg/parts.h"

/* Expanding entities may enlarge a file to at most GROWTH_MAX times its size; this is checked only once the expanded
 * size exceeds GROWTH_BYTES_MIN. */
#define GROWTH_MAX 4
#define GROWTH_BYTES_MIN 65536

/* State of reading a tree by expat. */
struct reading {
    XML_Parser parser;
    struct hatch_arena *arena;
    struct hatch_svg_tree tree;
    struct hatch_svg_node *open; /* the innermost open element, or NULL */
    uint32_t depth;
    enum hatch_status status;
    struct hatch_err *err;
};

/* Returns the line that the parser has reached. */
static uint64_t line_of(XML_Parser parser)
{
#if XML_MAJOR_VERSION > 2 || (XML_MAJOR_VERSION == 2 && XML_MINOR_VERSION >= 9)
    return XML_GetCurrentLineNumber64(parser);
#else
    return XML_GetCurrentLineNumber(parser); /* deprecated from 2.9 on */
#endif
}

/* Stops the parser after a failure; later callbacks are ignored. */
static void stop(struct reading *r, enum hatch_status status)
{
    if (status == HATCH_OK || r->status != HATCH_OK)
        return;
    r->status = hatch_fail_at(r->err, "line %lu: ", (unsigned long)line_of(r->parser));
    XML_StopParser(r->parser, XML_FALSE);
}

static const char *keep_text(struct reading *r, const char *text)
{
    return hatch_arena_text(r->arena, text, strlen(text), r->err);
}

/* Keeps a style attribute, whose comments become spaces. */
static const char *keep_declarations(struct reading *r, const char *text)
{
    struct hatch_text kept = {text, strlen(text)};
    return hatch_svg_blank_comments(&kept, r->arena, r->err) == HATCH_OK ? kept.at : NULL;
}

static const char *const *keep_attributes(struct reading *r, const char *const *attributes)
{
    size_t count = 0;
    while (attributes[count])
        count++;
    const char **kept = HATCH_NEW(r->arena, const char *, count + 1, r->err);
    for (size_t i = 0; kept && i < count; i++) {
        bool style = i % 2 && strcmp(attributes[i - 1], "style") == 0;
        kept[i] = style ? keep_declarations(r, attributes[i]) : keep_text(r, attributes[i]);
        if (!kept[i])
            return NULL;
    }
    return kept;
}

static enum hatch_status open_element(struct reading *r, const char *name, const char *const *attributes)
{
    if (r->depth == HATCH_SVG_DEPTH_MAX)
        return hatch_fail(r->err, HATCH_BAD_INPUT, "elements nested deeper than %u", HATCH_SVG_DEPTH_MAX);
    if (strncmp(name, "svg:", 4) == 0)
        name += 4;
    if (r->depth == 0 && strcmp(name, "svg") != 0)
        return hatch_fail(r->err, HATCH_BAD_INPUT, "the root element is <%.40s>, want <svg>", name);
    struct hatch_svg_node *node = HATCH_NEW(r->arena, struct hatch_svg_node, 1, r->err);
    if (!node || !(node->name = keep_text(r, name)) || !(node->attributes = keep_attributes(r, attributes)))
        return HATCH_LIMIT;
    node->line = (uint32_t)line_of(r->parser);
    node->parent = r->open;
    if (!r->open)
        r->tree.root = node;
    else if (r->open->last)
        r->open->last->next = node;
    else
        r->open->first = node;
    if (r->open)
        r->open->last = node;
    r->tree.named_count += hatch_svg_attribute(node->attributes, "id").length > 0;
    node->number = r->tree.count++;
    r->open = node;
    r->depth++;
    return HATCH_OK;
}

static void on_start(void *context, const char *name, const char **attributes)
{
    struct reading *r = context;
    if (r->status == HATCH_OK)
        stop(r, open_element(r, name, (const char *const *)attributes));
}

static void on_end(void *context, const char *name)
{
    struct reading *r = context;
    (void)name;
    if (r->status != HATCH_OK)
        return;
    r->open = r->open->parent;
    r->depth--;
}

static void on_text(void *context, const char *text, int length)
{
    struct reading *r = context;
    if (r->status == HATCH_OK && r->open && strcmp(r->open->name, "style") == 0)
        stop(r, hatch_buffer_add(&r->tree.sheet, text, (size_t)length, r->err));
}

static void on_entity(void *context, const char *name, int is_parameter, const char *value, int length,
                      const char *base, const char *system, const char *public, const char *notation)
{
    struct reading *r = context;
    (void)base;
    (void)system;
    (void)public;
    (void)notation;
    if (!value)
        stop(r, hatch_fail(r->err, HATCH_BAD_INPUT, "entity '%.40s' is external, which is not allowed", name));
    else if (is_parameter || memchr(value, '&', (size_t)length) || memchr(value, '%', (size_t)length))
        stop(r, hatch_fail(r->err, HATCH_BAD_INPUT, "entity '%.40s' refers to entities, which is not allowed", name));
}

static void on_instruction(void *context, const char *target, const char *data)
{
    struct reading *r = context;
    (void)data;
    r->tree.others += strcmp(target, "xml-stylesheet") == 0;
}

static enum hatch_status parse(struct reading *r, struct hatch_bytes file, struct hatch_err *err)
{
    XML_SetUserData(r->parser, r);
    XML_SetBillionLaughsAttackProtectionMaximumAmplification(r->parser, GROWTH_MAX);
    XML_SetBillionLaughsAttackProtectionActivationThreshold(r->parser, GROWTH_BYTES_MIN);
    XML_SetElementHandler(r->parser, on_start, on_end);
    XML_SetCharacterDataHandler(r->parser, on_text);
    XML_SetEntityDeclHandler(r->parser, on_entity);
    XML_SetProcessingInstructionHandler(r->parser, on_instruction);
    enum XML_Status ended = XML_Parse(r->parser, (const char *)file.data, (int)file.size, XML_TRUE);
    if (r->status != HATCH_OK)
        return r->status;
    if (ended == XML_STATUS_OK)
        return HATCH_OK;
    enum XML_Error code = XML_GetErrorCode(r->parser);
    return hatch_fail_quoting(err, code == XML_ERROR_NO_MEMORY ? HATCH_LIMIT : HATCH_BAD_INPUT, XML_ErrorString(code),
                              "line %lu: not valid XML", (unsigned long)line_of(r->parser));
}

static const char *id_of(const struct hatch_svg_node *node)
{
    return hatch_svg_attribute(node->attributes, "id").at;
}

static int compare_ids(const void *a, const void *b)
{
    const struct hatch_svg_node *first = *(const struct hatch_svg_node *const *)a;
    const struct hatch_svg_node *second = *(const struct hatch_svg_node *const *)b;
    int order = strcmp(id_of(first), id_of(second));
    return order ? order : (first->number > second->number) - (first->number < second->number);
}

static struct hatch_svg_node *next_of(struct hatch_svg_node *node)
{
    if (node->first)
        return node->first;
    while (node && !node->next)
        node = node->parent;
    return node ? node->next : NULL;
}

static enum hatch_status list_ids(struct hatch_svg_tree *tree, struct hatch_arena *arena, struct hatch_err *err)
{
    uint32_t at = 0;
    HATCH_TRY(HATCH_ALLOC(arena, &tree->named, tree->named_count, err));
    for (struct hatch_svg_node *node = tree->root; node; node = next_of(node))
        if (*id_of(node))
            tree->named[at++] = node;
    qsort(tree->named, at, sizeof *tree->named, compare_ids);
    return HATCH_OK;
}

struct hatch_text hatch_svg_href(const struct hatch_svg_node *node)
{
    struct hatch_text href = hatch_svg_attribute(node->attributes, "href");
    return href.length ? href : hatch_svg_attribute(node->attributes, "xlink:href");
}

struct hatch_svg_node *hatch_svg_find(const struct hatch_svg_tree *tree, struct hatch_text href)
{
    uint32_t low = 0, high = tree->named_count;
    if (href.length < 2 || *href.at != '#')
        return NULL;
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        if (strcmp(id_of(tree->named[middle]), href.at + 1) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    bool found = low < tree->named_count && strcmp(id_of(tree->named[low]), href.at + 1) == 0;
    return found ? tree->named[low] : NULL;
}

/* Sets the height and the number of elements of a node, with clones expanded. Recurses at most HATCH_SVG_DEPTH_MAX
 * levels. */
static enum hatch_status count(const struct hatch_svg_tree *tree, struct hatch_svg_node *node, uint32_t depth,
                               struct hatch_err *err)
{
    if (node->visiting)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: '%.40s' contains a <use> of itself", node->line, id_of(node));
    if (depth + node->height > HATCH_SVG_DEPTH_MAX)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: elements nested deeper than %u", node->line,
                          HATCH_SVG_DEPTH_MAX);
    if (node->height)
        return HATCH_OK;
    uint32_t below = 0;
    uint64_t elements = 1;
    bool is_clone = strcmp(node->name, "use") == 0;
    struct hatch_svg_node *child = node->first;
    if (is_clone)
        child = hatch_svg_find(tree, hatch_svg_href(node));
    node->visiting = true;
    for (; child; child = is_clone ? NULL : child->next) {
        HATCH_TRY(count(tree, child, depth + 1, err));
        below = child->height > below ? child->height : below;
        elements += child->elements;
        if (elements > (uint64_t)HATCH_SVG_CLONED_MAX + tree->count)
            return hatch_fail(err, HATCH_LIMIT, "line %u: <use> elements draw more than %u elements", node->line,
                              HATCH_SVG_CLONED_MAX);
    }
    node->visiting = false;
    node->height = below + 1;
    node->elements = elements;
    return HATCH_OK;
}

enum hatch_status hatch_svg_tree_read(struct hatch_bytes file, struct hatch_arena *arena, struct hatch_svg_tree *tree,
                                      struct hatch_err *err)
{
    if (file.size > INT_MAX / 2)
        return hatch_fail(err, HATCH_LIMIT, "%zu bytes are too many for a drawing", file.size);
    struct reading r = {.arena = arena, .tree = {.sheet = {.arena = arena}}, .err = err};
    r.parser = XML_ParserCreate(NULL);
    if (!r.parser)
        return hatch_fail(err, HATCH_LIMIT, "out of memory for parsing XML");
    enum hatch_status status = parse(&r, file, err);
    XML_ParserFree(r.parser);
    HATCH_TRY(status);
    HATCH_TRY(list_ids(&r.tree, arena, err));
    HATCH_TRY(count(&r.tree, r.tree.root, 0, err));
    *tree = r.tree;
    return HATCH_OK;
}
