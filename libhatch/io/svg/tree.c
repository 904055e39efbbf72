#include "io/svg/tree.h"

#define XML_DTD /* or expat's header hides its limits on entities */
#include <expat.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "io/svg/parts.h"

#define GROWTH_MAX 4           /* of a file by its entities, */
#define GROWTH_BYTES_MIN 65536 /* from that size on */

/* A tree while expat reads it. */
struct growth {
    XML_Parser parser;
    struct hatch_arena *arena;
    struct hatch_svg_tree tree;
    struct hatch_svg_node *open; /* the innermost one, or NULL */
    uint32_t depth;
    enum hatch_status status;
    struct hatch_err *err;
};

/* Nothing that expat still says counts. */
static void stop(struct growth *g, enum hatch_status status)
{
    if (status == HATCH_OK || g->status != HATCH_OK)
        return;
    g->status = hatch_fail_at(g->err, "line %lu: ", (unsigned long)XML_GetCurrentLineNumber(g->parser));
    XML_StopParser(g->parser, XML_FALSE);
}

static const char *keep_text(struct growth *g, const char *text)
{
    return hatch_arena_text(g->arena, text, strlen(text), g->err);
}

static const char *const *keep_attributes(struct growth *g, const char *const *attributes)
{
    size_t count = 0;
    while (attributes[count])
        count++;
    const char **kept = HATCH_NEW(g->arena, const char *, count + 1, g->err);
    for (size_t i = 0; kept && i < count; i++)
        if (!(kept[i] = keep_text(g, attributes[i])))
            return NULL;
    return kept;
}

static enum hatch_status open_element(struct growth *g, const char *name, const char *const *attributes)
{
    if (g->depth == HATCH_SVG_DEPTH_MAX)
        return hatch_fail(g->err, HATCH_BAD_INPUT, "elements nested deeper than %u", HATCH_SVG_DEPTH_MAX);
    if (strncmp(name, "svg:", 4) == 0)
        name += 4;
    if (g->depth == 0 && strcmp(name, "svg") != 0)
        return hatch_fail(g->err, HATCH_BAD_INPUT, "'%.40s' where <svg> must stand", name);
    struct hatch_svg_node *node = HATCH_NEW(g->arena, struct hatch_svg_node, 1, g->err);
    if (!node || !(node->name = keep_text(g, name)) || !(node->attributes = keep_attributes(g, attributes)))
        return HATCH_LIMIT;
    node->line = (uint32_t)XML_GetCurrentLineNumber(g->parser);
    node->parent = g->open;
    if (!g->open)
        g->tree.root = node;
    else if (g->open->last)
        g->open->last->next = node;
    else
        g->open->first = node;
    if (g->open)
        g->open->last = node;
    g->tree.named_count += hatch_svg_attribute(node->attributes, "id").length > 0;
    node->number = g->tree.count++;
    g->open = node;
    g->depth++;
    return HATCH_OK;
}

static void on_start(void *context, const char *name, const char **attributes)
{
    struct growth *g = context;
    if (g->status == HATCH_OK)
        stop(g, open_element(g, name, (const char *const *)attributes));
}

static void on_end(void *context, const char *name)
{
    struct growth *g = context;
    (void)name;
    if (g->status != HATCH_OK)
        return;
    g->open = g->open->parent;
    g->depth--;
}

static void on_text(void *context, const char *text, int length)
{
    struct growth *g = context;
    if (g->status == HATCH_OK && g->open && strcmp(g->open->name, "style") == 0)
        stop(g, hatch_buffer_add(&g->tree.sheet, text, (size_t)length, g->err));
}

static void on_entity(void *context, const char *name, int is_parameter, const char *value, int length,
                      const char *base, const char *system, const char *public, const char *notation)
{
    struct growth *g = context;
    (void)base;
    (void)system;
    (void)public;
    (void)notation;
    if (!value)
        stop(g, hatch_fail(g->err, HATCH_BAD_INPUT, "entity '%.40s' lies outside the file", name));
    else if (is_parameter || memchr(value, '&', (size_t)length) || memchr(value, '%', (size_t)length))
        stop(g, hatch_fail(g->err, HATCH_BAD_INPUT, "entity '%.40s' is made of entities", name));
}

static void on_instruction(void *context, const char *target, const char *data)
{
    struct growth *g = context;
    (void)data;
    g->tree.others += strcmp(target, "xml-stylesheet") == 0;
}

static enum hatch_status parse(struct growth *g, struct hatch_bytes file, struct hatch_err *err)
{
    XML_SetUserData(g->parser, g);
    XML_SetBillionLaughsAttackProtectionMaximumAmplification(g->parser, GROWTH_MAX);
    XML_SetBillionLaughsAttackProtectionActivationThreshold(g->parser, GROWTH_BYTES_MIN);
    XML_SetElementHandler(g->parser, on_start, on_end);
    XML_SetCharacterDataHandler(g->parser, on_text);
    XML_SetEntityDeclHandler(g->parser, on_entity);
    XML_SetProcessingInstructionHandler(g->parser, on_instruction);
    enum XML_Status ended = XML_Parse(g->parser, (const char *)file.data, (int)file.size, XML_TRUE);
    if (g->status != HATCH_OK)
        return g->status;
    if (ended == XML_STATUS_OK)
        return HATCH_OK;
    enum XML_Error code = XML_GetErrorCode(g->parser);
    return hatch_fail(err, code == XML_ERROR_NO_MEMORY ? HATCH_LIMIT : HATCH_BAD_INPUT, "line %lu: %s",
                      (unsigned long)XML_GetCurrentLineNumber(g->parser), XML_ErrorString(code));
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
    tree->named = HATCH_NEW(arena, struct hatch_svg_node *, tree->named_count, err);
    if (!tree->named)
        return HATCH_LIMIT;
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

/* Counts what a node becomes. It descends no deeper than it allows drawings to be. */
static enum hatch_status count(const struct hatch_svg_tree *tree, struct hatch_svg_node *node, uint32_t depth,
                               struct hatch_err *err)
{
    if (node->counting)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: a clone of '%.40s' in itself", node->line, id_of(node));
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
    node->counting = true;
    for (; child; child = is_clone ? NULL : child->next) {
        HATCH_TRY(count(tree, child, depth + 1, err));
        below = child->height > below ? child->height : below;
        elements += child->elements;
        if (elements > (uint64_t)HATCH_SVG_CLONED_MAX + tree->count)
            return hatch_fail(err, HATCH_LIMIT, "line %u: clones of more than %u elements", node->line,
                              HATCH_SVG_CLONED_MAX);
    }
    node->counting = false;
    node->height = below + 1;
    node->elements = elements;
    return HATCH_OK;
}

enum hatch_status hatch_svg_tree_read(struct hatch_bytes file, struct hatch_arena *arena, struct hatch_svg_tree *tree,
                                      struct hatch_err *err)
{
    if (file.size > INT_MAX / 2)
        return hatch_fail(err, HATCH_LIMIT, "%zu bytes of drawing", file.size);
    struct growth g = {.arena = arena, .tree = {.sheet = {.arena = arena}}, .err = err};
    g.parser = XML_ParserCreate(NULL);
    if (!g.parser)
        return hatch_fail(err, HATCH_LIMIT, "no memory for a parser of XML");
    enum hatch_status status = parse(&g, file, err);
    XML_ParserFree(g.parser);
    HATCH_TRY(status);
    HATCH_TRY(list_ids(&g.tree, arena, err));
    HATCH_TRY(count(&g.tree, g.tree.root, 0, err));
    *tree = g.tree;
    return HATCH_OK;
}
