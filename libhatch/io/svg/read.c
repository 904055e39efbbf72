#include <string.h>

#include "io/svg/sheet.h"
#include "io/svg/tree.h"
#include "stroke/script.h"

#define PAGE_MAX 1e6
#define ASPECT_TOLERANCE 1e-3
#define TOLERANCE_PX 0.05

/* State of drawing the elements of a tree. */
struct drawing {
    uint32_t size_px;
    struct hatch_arena *arena;
    struct hatch_svg_tree tree;
    struct hatch_svg_sheet sheet;
    struct hatch_svg_style *styles; /* by depth: of the current element and those around it; [0]: the initial style */
    uint32_t depth;
    double page; /* side of the page, user units */
    struct hatch_svg_pen pen;
    struct hatch_svg_dasher dasher;
    struct hatch_stroke_list strokes;
    struct hatch_svg_notes notes;
    bool located; /* the error message names its line already */
};

bool hatch_svg_is(struct hatch_bytes file)
{
    static const uint8_t utf8[] = {0xef, 0xbb, 0xbf};
    size_t at = file.size >= 3 && memcmp(file.data, utf8, 3) == 0 ? 3 : 0;
    if (file.size >= 2 && file.data[0] + file.data[1] == 0xfe + 0xff)
        return true; /* UTF-16 */
    while (at < file.size && strchr(" \t\r\n", file.data[at]) && file.data[at])
        at++;
    return at < file.size && file.data[at] == '<';
}

static bool is_any(const char *name, const char *const *list)
{
    return hatch_svg_is_any((struct hatch_text){name, strlen(name)}, list);
}

/* Returns the mean scale of a matrix. */
static double scale_of(const struct hatch_svg_matrix *m)
{
    return sqrt(fabs(hatch_svg_determinant(m)));
}

static const float *stroke_color_of(const struct hatch_svg_style *style)
{
    return style->stroke_current ? style->color_rgba : style->stroke_rgba;
}

/* Returns the product of all opacities of a stroke. */
static double opacity_of(const struct hatch_svg_style *style)
{
    return (double)stroke_color_of(style)[3] * style->stroke_opacity * style->opacity;
}

/* Whether the fill of a shape can be seen. */
static bool is_filled(const struct hatch_svg_style *style)
{
    return style->filled && style->fill_opacity > 0 && (!style->fill_current || style->color_rgba[3] > 0);
}

static bool is_outside(const struct hatch_path_builder *line, double margin)
{
    bool left = true, right = true, above = true, below = true;
    for (uint32_t i = 0; i < line->count; i++) {
        left &= line->xy[2 * i] < -margin;
        right &= line->xy[2 * i] > 1 + margin;
        above &= line->xy[2 * i + 1] < -margin;
        below &= line->xy[2 * i + 1] > 1 + margin;
    }
    return left || right || above || below;
}

/* Adds a line as a stroke. */
static enum hatch_status add_stroke(void *context, struct hatch_path_builder *line, struct hatch_err *err)
{
    struct drawing *d = context;
    const struct hatch_svg_style *style = &d->styles[d->depth];
    double width = style->width * scale_of(&d->styles[style->own_pen ? 0 : d->depth].matrix);
    float width_px = (float)(width * d->size_px);
    if (!(width_px > 0) || (line->count == 1 && !style->capped))
        return HATCH_OK;
    if (is_outside(line, width / 2)) {
        d->notes.outside++;
        return HATCH_OK;
    }
    if (hatch_path_is_far(line)) {
        d->notes.far++;
        return HATCH_OK;
    }
    if (!(width <= HATCH_SCRIPT_WIDTH_MAX))
        return hatch_fail(err, HATCH_BAD_INPUT, "a stroke is %g page widths wide, want at most %g", width,
                          HATCH_SCRIPT_WIDTH_MAX);
    struct hatch_stroke stroke = {.width_px = width_px,
                                  .tone = (float)opacity_of(style),
                                  .id = d->strokes.count + 1,
                                  .texture_seed = d->strokes.count + 1};
    memcpy(stroke.rgb, stroke_color_of(style), sizeof stroke.rgb);
    HATCH_TRY(hatch_path_finish(line, d->arena, &stroke, err));
    d->notes.strokes++;
    return hatch_stroke_list_add(&d->strokes, d->arena, &stroke, err);
}

/* Adds a subpath as a stroke, or each of its dashes as one. */
static enum hatch_status add_line(void *context, struct hatch_path_builder *line, struct hatch_err *err)
{
    struct drawing *d = context;
    return hatch_svg_dash(&d->dasher, line, &d->styles[d->depth], d->page, err);
}

/* Applies the transform of an element. A property that cannot be applied is left out, and a malformed attribute
 * refused.
 *   attribute  the transform that the element has without style sheets */
static enum hatch_status apply_transform(struct drawing *d, struct hatch_text attribute, struct hatch_err *err)
{
    struct hatch_svg_style *style = &d->styles[d->depth];
    struct hatch_svg_matrix own, origin = {1, 0, 0, 1, 0, 0}, back = origin;
    double at[3] = {0};
    uint32_t count = 0;
    if (style->own_transform.length == 0)
        return HATCH_OK;
    if (hatch_svg_transform(style->own_transform, d->page, &own, err) != HATCH_OK) {
        style->incomplete = true;
        return style->own_transform.at == attribute.at ? HATCH_BAD_INPUT : HATCH_OK;
    }
    bool shifts = own.a == 1 && own.b == 0 && own.c == 0 && own.d == 1; /* which is the same about every origin */
    bool placed = hatch_svg_lengths(style->own_origin, d->page, 3, at, &count, err) == HATCH_OK && count != 1;
    if (!shifts && (!placed || style->own_box)) {
        style->incomplete = true;
        return HATCH_OK;
    }
    if (!shifts) {
        origin.e = at[0];
        origin.f = at[1];
        back.e = -at[0];
        back.f = -at[1];
    }
    own = hatch_svg_multiply(&own, &back);
    own = hatch_svg_multiply(&origin, &own);
    style->matrix = hatch_svg_multiply(&style->matrix, &own);
    return HATCH_OK;
}

/* Computes an element's style: its parent's, changed by attributes, then by style sheets, then by the style
 * attribute, and by what is important in these two. */
static enum hatch_status compute_style(struct drawing *d, const struct hatch_svg_node *node, struct hatch_err *err)
{
    struct hatch_svg_style *style = &d->styles[d->depth];
    const char *const *attributes = node->attributes;
    *style = d->styles[d->depth - 1];
    style->own_opacity = 1;
    style->own_undisplayed = style->own_box = style->own_pen = false;
    style->own_transform = style->own_origin = (struct hatch_text){"", 0};
    for (const char *const *a = attributes; *a; a += 2)
        HATCH_TRY(hatch_svg_property((struct hatch_text){a[0], strlen(a[0])}, (struct hatch_text){a[1], strlen(a[1])},
                                     d->page, style, err));
    struct hatch_text attribute = style->own_transform;
    for (int important = 0; important < 2; important++) {
        hatch_svg_sheet_apply(&d->sheet, node->name, attributes, d->page, important, style);
        hatch_svg_declarations(hatch_svg_attribute(attributes, "style"), d->page, important, style);
    }
    if (style->dashes.length && hatch_svg_attribute(attributes, "pathLength").length) {
        style->dashes.length = 0;
        style->incomplete = true;
    }
    style->opacity *= style->own_opacity;
    style->undisplayed = style->undisplayed || style->own_undisplayed;
    return apply_transform(d, attribute, err);
}

static const char *const sides[] = {"width", "height"};

static enum hatch_status read_page(struct drawing *d, const char *const *attributes, struct hatch_err *err)
{
    double box[4] = {0, 0, 100, 100};
    struct hatch_text view = hatch_svg_attribute(attributes, "viewBox");
    struct hatch_text size[2] = {hatch_svg_attribute(attributes, sides[0]), hatch_svg_attribute(attributes, sides[1])};
    bool has_view = view.length > 0;
    hatch_svg_skip(&view);
    if (has_view && !hatch_svg_numbers(&view, 4, box))
        return hatch_fail(err, HATCH_BAD_INPUT, "viewBox: want four numbers");
    for (int axis = 0; axis < 2 && !has_view; axis++)
        if (size[axis].length && hatch_svg_length(size[axis], 100, &box[2 + axis], err) != HATCH_OK)
            return hatch_fail_at(err, "%s: ", sides[axis]);
    if (!(box[2] > 0 && box[3] > 0))
        return hatch_fail(err, HATCH_BAD_INPUT, "the page is %g x %g, want a positive size", box[2], box[3]);
    if (box[2] > PAGE_MAX || box[3] > PAGE_MAX)
        return hatch_fail(err, HATCH_LIMIT, "a page of %g x %g units, want at most %g", box[2], box[3], PAGE_MAX);
    if (fabs(box[2] - box[3]) > ASPECT_TOLERANCE * fmax(box[2], box[3]))
        return hatch_fail(err, HATCH_BAD_INPUT, "the page is %g x %g, want a square", box[2], box[3]);
    d->page = box[2];
    d->styles[0] =
        (struct hatch_svg_style){.filled = true,
                                 .color_rgba = {0, 0, 0, 1},
                                 .width = 1,
                                 .stroke_opacity = 1,
                                 .fill_opacity = 1,
                                 .opacity = 1,
                                 .dashes = {"", 0},
                                 .matrix = {1 / box[2], 0, 0, 1 / box[3], -box[0] / box[2], -box[1] / box[3]}};
    return HATCH_OK;
}

/* Counts an element that is neither a shape nor a group. */
static void count_ignored(struct drawing *d, const char *element)
{
    static const char *const silent[] = {"defs",           "symbol",         "clipPath", "mask",      "marker",
                                         "style",          "pattern",        "title",    "desc",      "metadata",
                                         "linearGradient", "radialGradient", "filter",   "namedview", NULL};
    static const char *const texts[] = {"text", "tspan", "textPath", "foreignObject", NULL};
    if (is_any(element, texts))
        d->notes.texts++;
    else if (strcmp(element, "image") == 0)
        d->notes.images++;
    else if (!is_any(element, silent) && !strchr(element, ':'))
        d->notes.others++;
}

/* Draws an element if it is a stroked shape. */
static enum hatch_status draw(struct drawing *d, const struct hatch_svg_node *node, struct hatch_err *err)
{
    static const char *const shapes[] = {"path", "line", "polyline", "polygon", "circle", "ellipse", "rect", NULL};
    const struct hatch_svg_style *style = &d->styles[d->depth];
    if (!is_any(node->name, shapes)) {
        count_ignored(d, node->name);
        return HATCH_OK;
    }
    if (style->invisible || style->undisplayed)
        return HATCH_OK;
    d->notes.fills += is_filled(style) && strcmp(node->name, "line") != 0;
    d->notes.gradients += style->stroke == HATCH_SVG_SERVER;
    if (style->stroke != HATCH_SVG_COLOR || !(opacity_of(style) > 0) || !(scale_of(&style->matrix) > 0))
        return HATCH_OK;
    d->notes.others += style->incomplete;
    d->pen.matrix = style->matrix;
    d->pen.x = d->pen.y = 0;
    d->pen.line.count = 0;
    return hatch_svg_shape(node->name, node->attributes, d->page, &d->pen, err);
}

/* Returns whether a list of languages has English, the language of the program. */
static bool has_english(struct hatch_text list)
{
    static const char separators[] = ", \t\r\n", ends[] = "-, \t\r\n";
    bool begins = true;
    for (size_t i = 0; i + 2 <= list.length; begins = strchr(separators, list.at[i++]) != NULL)
        if (begins && (list.at[i] | 32) == 'e' && (list.at[i + 1] | 32) == 'n' &&
            (i + 2 == list.length || strchr(ends, list.at[i + 2])))
            return true;
    return false;
}

/* Returns whether an element is drawn at all: it needs no extension, and is in any or the right language (SVG 2,
 * section 5.7). */
static bool is_suitable(const struct hatch_svg_node *node)
{
    for (const char *const *a = node->attributes; *a; a += 2)
        if (strcmp(a[0], "requiredExtensions") == 0 ||
            (strcmp(a[0], "systemLanguage") == 0 && !has_english((struct hatch_text){a[1], strlen(a[1])})))
            return false;
    return true;
}

static enum hatch_status draw_element(struct drawing *d, const struct hatch_svg_node *node, struct hatch_err *err);

/* Draws the first suitable element of a <switch>. */
static enum hatch_status draw_alternative(struct drawing *d, const struct hatch_svg_node *node, struct hatch_err *err)
{
    static const char *const others[] = {"title", "desc", "metadata", "style", "defs", "script", NULL};
    for (const struct hatch_svg_node *child = node->first; child; child = child->next)
        if (is_suitable(child) && !is_any(child->name, others) && !strchr(child->name, ':'))
            return draw_element(d, child, err);
    return HATCH_OK;
}

static enum hatch_status draw_content(struct drawing *d, const struct hatch_svg_node *node, struct hatch_err *err)
{
    enum hatch_status status = HATCH_OK;
    for (const struct hatch_svg_node *child = node->first; child && status == HATCH_OK; child = child->next)
        status = draw_element(d, child, err);
    return status;
}

/* Fits a symbol's viewBox, if any, into the clone's width and height, centred. */
static enum hatch_status fit_symbol(struct drawing *d, const struct hatch_svg_node *clone,
                                    const struct hatch_svg_node *symbol, struct hatch_err *err)
{
    struct hatch_text view = hatch_svg_attribute(symbol->attributes, "viewBox");
    double box[4], size[2] = {d->page, d->page};
    hatch_svg_skip(&view);
    if (view.length == 0)
        return HATCH_OK;
    if (!hatch_svg_numbers(&view, 4, box) || !(box[2] > 0 && box[3] > 0))
        return hatch_fail(err, HATCH_BAD_INPUT, "viewBox: want four numbers and a positive size");
    for (int axis = 0; axis < 2; axis++) {
        struct hatch_text text = hatch_svg_attribute(clone->attributes, sides[axis]);
        if (text.length == 0)
            text = hatch_svg_attribute(symbol->attributes, sides[axis]);
        if (text.length && hatch_svg_length(text, d->page, &size[axis], err) != HATCH_OK)
            return hatch_fail_at(err, "%s: ", sides[axis]);
    }
    double scale = fmin(size[0] / box[2], size[1] / box[3]);
    struct hatch_svg_matrix fit = {
        scale, 0, 0, scale, size[0] / 2 - scale * (box[0] + box[2] / 2), size[1] / 2 - scale * (box[1] + box[3] / 2)};
    struct hatch_svg_style *style = &d->styles[d->depth];
    style->matrix = hatch_svg_multiply(&style->matrix, &fit);
    return HATCH_OK;
}

/* Draws the element that a clone refers to, at the clone's position and in its style. The recursion ends, since
 * hatch_svg_tree_read has refused elements that contain clones of themselves. */
static enum hatch_status draw_clone(struct drawing *d, const struct hatch_svg_node *node, struct hatch_err *err)
{
    static const char *const axes[] = {"x", "y"};
    struct hatch_text href = hatch_svg_href(node);
    const struct hatch_svg_node *original = hatch_svg_find(&d->tree, href);
    struct hatch_svg_style *style = &d->styles[d->depth];
    double at[2] = {0, 0};
    if (href.length && *href.at != '#')
        return hatch_fail(err, HATCH_BAD_INPUT, "<use> of '%.*s': other files are not read",
                          (int)(href.length < 60 ? href.length : 60), href.at);
    d->notes.others += !original;
    for (int axis = 0; axis < 2; axis++) {
        struct hatch_text text = hatch_svg_attribute(node->attributes, axes[axis]);
        if (text.length && hatch_svg_length(text, d->page, &at[axis], err) != HATCH_OK)
            return hatch_fail_at(err, "%s: ", axes[axis]);
    }
    struct hatch_svg_matrix moved = {1, 0, 0, 1, at[0], at[1]};
    style->matrix = hatch_svg_multiply(&style->matrix, &moved);
    if (!original)
        return HATCH_OK;
    if (strcmp(original->name, "symbol") != 0)
        return draw_element(d, original, err);
    d->depth++;
    HATCH_TRY(compute_style(d, original, err));
    HATCH_TRY(fit_symbol(d, node, original, err));
    HATCH_TRY(draw_content(d, original, err));
    d->depth--;
    return HATCH_OK;
}

/* Draws an element and those in it. Recurses at most HATCH_SVG_DEPTH_MAX levels, which hatch_svg_tree_read has
 * checked. */
static enum hatch_status draw_element(struct drawing *d, const struct hatch_svg_node *node, struct hatch_err *err)
{
    static const char *const groups[] = {"g", "a", NULL};
    enum hatch_status status;
    if (strchr(node->name, ':')) {
        count_ignored(d, node->name);
        return HATCH_OK;
    }
    if (!is_suitable(node))
        return HATCH_OK;
    d->depth++;
    status = compute_style(d, node, err);
    if (status == HATCH_OK && (node == d->tree.root || is_any(node->name, groups)))
        status = draw_content(d, node, err);
    else if (status == HATCH_OK && strcmp(node->name, "switch") == 0)
        status = draw_alternative(d, node, err);
    else if (status == HATCH_OK && strcmp(node->name, "use") == 0)
        status = draw_clone(d, node, err);
    else if (status == HATCH_OK)
        status = draw(d, node, err);
    d->depth--;
    if (status != HATCH_OK && !d->located) {
        d->located = true;
        return hatch_fail_at(err, "line %u: ", node->line);
    }
    return status;
}

static enum hatch_status read_drawing(struct drawing *d, struct hatch_bytes file, struct hatch_arena *scratch,
                                      struct hatch_err *err)
{
    HATCH_TRY(hatch_svg_tree_read(file, scratch, &d->tree, err));
    struct hatch_text sheet = {(const char *)d->tree.sheet.data, d->tree.sheet.size};
    HATCH_TRY(hatch_svg_sheet_read(sheet, scratch, &d->sheet, err));
    d->notes.others = d->tree.others + d->sheet.others;
    HATCH_TRY(HATCH_ALLOC(scratch, &d->styles, HATCH_SVG_DEPTH_MAX + 2, err));
    if (read_page(d, d->tree.root->attributes, err) != HATCH_OK)
        return hatch_fail_at(err, "line %u: ", d->tree.root->line);
    return draw_element(d, d->tree.root, err);
}

enum hatch_status hatch_svg_read(struct hatch_bytes file, uint32_t size_px, struct hatch_arena *arena,
                                 struct hatch_arena *scratch, struct hatch_stroke_list *strokes,
                                 struct hatch_svg_notes *notes, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    const struct hatch_path_builder line = {.arena = scratch, .tolerance = TOLERANCE_PX / size_px};
    struct drawing d = {.size_px = size_px, .arena = arena};
    d.dasher = (struct hatch_svg_dasher){.dash = line, .finish = add_stroke, .context = &d};
    d.pen = (struct hatch_svg_pen){.line = line, .finish = add_line, .context = &d};
    enum hatch_status status = read_drawing(&d, file, scratch, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK) {
        *strokes = d.strokes;
        *notes = d.notes;
    }
    return status;
}
