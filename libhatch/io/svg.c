#include "io/svg.h"

#define XML_DTD /* or expat's header hides its limits on entities */
#include <expat.h>
#include <limits.h>
#include <math.h>
#include <string.h>

#include "io/svg_parts.h"

#define DEPTH_MAX 256u
#define PAGE_MAX 1e6
#define NOT_SQUARE 1e-3
#define TOLERANCE_PX 0.05
#define GROWTH_MAX 4           /* of a file by its entities, */
#define GROWTH_BYTES_MIN 65536 /* from that size on */
#define WIDTH_SHARE_MAX 0.25 /* of the page */

/* A drawing while expat reads it. */
struct drawing {
    XML_Parser parser;
    uint32_t size_px;
    struct hatch_arena *arena;
    struct hatch_svg_look *looks; /* of the open groups */
    uint32_t depth;               /* elements that are open */
    uint32_t skip;                /* the depth of an element whose content draws nothing, or 0 */
    double page;                  /* user units */
    struct hatch_svg_pen pen;
    struct hatch_stroke_list strokes;
    struct hatch_svg_notes notes;
    enum hatch_status status;
    struct hatch_err *err;
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

/* Nothing that expat still says counts. */
static void stop(struct drawing *d, enum hatch_status status)
{
    if (status == HATCH_OK || d->status != HATCH_OK)
        return;
    d->status = hatch_fail_at(d->err, "line %lu: ", (unsigned long)XML_GetCurrentLineNumber(d->parser));
    XML_StopParser(d->parser, XML_FALSE);
}

static bool is_any(const char *name, const char *const *list)
{
    for (; *list; list++)
        if (strcmp(name, *list) == 0)
            return true;
    return false;
}

static double root_of_area(const struct hatch_svg_matrix *m)
{
    return sqrt(fabs(m->a * m->d - m->b * m->c));
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

/* One subpath has become a line of the tile. */
static enum hatch_status add_stroke(void *context, struct hatch_path_builder *line, struct hatch_err *err)
{
    struct drawing *d = context;
    const struct hatch_svg_look *look = &d->looks[d->depth];
    double width = look->width * root_of_area(&look->matrix);
    if (!(width > 0))
        return HATCH_OK;
    if (!(width <= WIDTH_SHARE_MAX))
        return hatch_fail(err, HATCH_BAD_INPUT, "a stroke %g of the page wide, want %g at most", width,
                          WIDTH_SHARE_MAX);
    if (is_outside(line, width / 2)) {
        d->notes.outside++;
        return HATCH_OK;
    }
    struct hatch_stroke stroke = {.width_px = (float)(width * d->size_px),
                                  .tone = (float)(look->stroke_opacity * look->opacity),
                                  .id = d->strokes.count + 1,
                                  .texture_seed = d->strokes.count + 1};
    memcpy(stroke.rgb, look->stroke_rgb, sizeof stroke.rgb);
    HATCH_TRY(hatch_path_finish(line, d->arena, &stroke, err));
    d->notes.strokes++;
    return hatch_stroke_list_add(&d->strokes, d->arena, &stroke, err);
}

/* The group's look, changed by the element's attributes and then by its style, which is stronger. */
static enum hatch_status look_at(struct drawing *d, const char *const *attributes, struct hatch_err *err)
{
    struct hatch_svg_look *look = &d->looks[d->depth];
    struct hatch_svg_matrix own;
    *look = d->looks[d->depth - 1];
    for (const char *const *a = attributes; *a; a += 2)
        HATCH_TRY(hatch_svg_property((struct hatch_text){a[0], strlen(a[0])},
                                     (struct hatch_text){a[1], strlen(a[1])}, d->page, look, err));
    HATCH_TRY(hatch_svg_style(hatch_svg_attribute(attributes, "style"), d->page, look, err));
    struct hatch_text transform = hatch_svg_attribute(attributes, "transform");
    if (transform.length == 0)
        return HATCH_OK;
    HATCH_TRY(hatch_svg_transform(transform, &own, err));
    look->matrix = hatch_svg_multiply(&look->matrix, &own);
    return HATCH_OK;
}

static enum hatch_status read_page(struct drawing *d, const char *const *attributes, struct hatch_err *err)
{
    double box[4] = {0, 0, 100, 100};
    struct hatch_text view = hatch_svg_attribute(attributes, "viewBox");
    struct hatch_text size[2] = {hatch_svg_attribute(attributes, "width"),
                                 hatch_svg_attribute(attributes, "height")};
    bool viewed = view.length > 0;
    hatch_svg_skip(&view);
    if (viewed && !hatch_svg_numbers(&view, 4, box))
        return hatch_fail(err, HATCH_BAD_INPUT, "viewBox: want four numbers");
    for (int axis = 0; axis < 2 && !viewed; axis++)
        if (size[axis].length)
            HATCH_TRY(hatch_svg_length(size[axis], 100, &box[2 + axis], err));
    if (!(box[2] > 0 && box[3] > 0))
        return hatch_fail(err, HATCH_BAD_INPUT, "the page is %g x %g", box[2], box[3]);
    if (box[2] > PAGE_MAX || box[3] > PAGE_MAX)
        return hatch_fail(err, HATCH_LIMIT, "a page of %g x %g units, want %g at most", box[2], box[3], PAGE_MAX);
    if (fabs(box[2] - box[3]) > NOT_SQUARE * fmax(box[2], box[3]))
        return hatch_fail(err, HATCH_BAD_INPUT, "a page of %g x %g, but a tile is a square", box[2], box[3]);
    d->page = box[2];
    d->looks[0] = (struct hatch_svg_look){
        .fill = HATCH_SVG_COLOR,
        .width = 1,
        .stroke_opacity = 1,
        .opacity = 1,
        .matrix = {1 / box[2], 0, 0, 1 / box[3], -box[0] / box[2], -box[1] / box[3]}};
    return HATCH_OK;
}

/* What is no shape and no group. */
static enum hatch_status pass_over(struct drawing *d, const char *element, const char *const *attributes,
                                   struct hatch_err *err)
{
    static const char *const silent[] = {"defs",   "symbol", "clipPath", "mask",  "marker",
                                         "pattern", "title",  "desc",     "metadata", "linearGradient",
                                         "radialGradient", "filter", "namedview", NULL};
    static const char *const texts[] = {"text", "tspan", "textPath", "foreignObject", NULL};
    struct hatch_text href = hatch_svg_attribute(attributes, "href");
    if (href.length == 0)
        href = hatch_svg_attribute(attributes, "xlink:href");
    if (strcmp(element, "use") == 0 && href.length && *href.at != '#')
        return hatch_fail(err, HATCH_BAD_INPUT, "a clone of '%.*s': other files are not opened",
                          (int)(href.length < 60 ? href.length : 60), href.at);
    d->skip = d->depth;
    if (is_any(element, texts))
        d->notes.texts++;
    else if (strcmp(element, "image") == 0)
        d->notes.images++;
    else if (!is_any(element, silent) && !strchr(element, ':'))
        d->notes.others++;
    return HATCH_OK;
}

/* Draws the element if it is a shape that is stroked. */
static enum hatch_status draw(struct drawing *d, const char *element, const char *const *attributes,
                              struct hatch_err *err)
{
    static const char *const shapes[] = {"path",     "line",   "polyline", "polygon",
                                         "circle",   "ellipse", "rect",     NULL};
    const struct hatch_svg_look *look = &d->looks[d->depth];
    bool drawn;
    if (!is_any(element, shapes))
        return pass_over(d, element, attributes, err);
    d->skip = d->depth; /* what may stand in a shape draws nothing */
    if (look->hidden)
        return HATCH_OK;
    d->notes.fills += look->fill != HATCH_SVG_NONE && strcmp(element, "line") != 0;
    d->notes.gradients += look->stroke == HATCH_SVG_SERVER;
    if (look->stroke != HATCH_SVG_COLOR || !(look->stroke_opacity * look->opacity > 0))
        return HATCH_OK;
    d->notes.others += look->dashed || look->masked;
    d->pen.matrix = look->matrix;
    d->pen.x = d->pen.y = 0;
    d->pen.line.count = 0;
    return hatch_svg_shape(element, attributes, d->page, &d->pen, &drawn, err);
}

static enum hatch_status open_element(struct drawing *d, const char *element, const char *const *attributes,
                                      struct hatch_err *err)
{
    static const char *const groups[] = {"g", "a", "switch", NULL};
    if (d->depth == DEPTH_MAX)
        return hatch_fail(err, HATCH_BAD_INPUT, "elements nested deeper than %u", DEPTH_MAX);
    d->depth++;
    if (d->skip)
        return HATCH_OK;
    if (strncmp(element, "svg:", 4) == 0)
        element += 4;
    if (d->depth == 1 && strcmp(element, "svg") != 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "'%.40s' where <svg> must stand", element);
    if (d->depth == 1)
        HATCH_TRY(read_page(d, attributes, err));
    if (strchr(element, ':'))
        return pass_over(d, element, attributes, err);
    HATCH_TRY(look_at(d, attributes, err));
    if (d->depth == 1 || is_any(element, groups))
        return HATCH_OK;
    return draw(d, element, attributes, err);
}

static void on_start(void *context, const char *element, const char **attributes)
{
    struct drawing *d = context;
    if (d->status == HATCH_OK)
        stop(d, open_element(d, element, (const char *const *)attributes, d->err));
}

static void on_end(void *context, const char *element)
{
    struct drawing *d = context;
    (void)element;
    if (d->skip == d->depth)
        d->skip = 0;
    d->depth--;
}

static void on_entity(void *context, const char *name, int is_parameter, const char *value, int length,
                      const char *base, const char *system, const char *public, const char *notation)
{
    struct drawing *d = context;
    (void)base;
    (void)system;
    (void)public;
    (void)notation;
    if (!value)
        stop(d, hatch_fail(d->err, HATCH_BAD_INPUT, "entity '%.40s' lies outside the file", name));
    else if (is_parameter || memchr(value, '&', (size_t)length) || memchr(value, '%', (size_t)length))
        stop(d, hatch_fail(d->err, HATCH_BAD_INPUT, "entity '%.40s' is made of entities", name));
}

static void on_instruction(void *context, const char *target, const char *data)
{
    struct drawing *d = context;
    (void)data;
    d->notes.others += strcmp(target, "xml-stylesheet") == 0;
}

static enum hatch_status parse(struct drawing *d, struct hatch_bytes file, struct hatch_err *err)
{
    XML_SetUserData(d->parser, d);
    XML_SetBillionLaughsAttackProtectionMaximumAmplification(d->parser, GROWTH_MAX);
    XML_SetBillionLaughsAttackProtectionActivationThreshold(d->parser, GROWTH_BYTES_MIN);
    XML_SetElementHandler(d->parser, on_start, on_end);
    XML_SetEntityDeclHandler(d->parser, on_entity);
    XML_SetProcessingInstructionHandler(d->parser, on_instruction);
    enum XML_Status ended = XML_Parse(d->parser, (const char *)file.data, (int)file.size, XML_TRUE);
    if (d->status != HATCH_OK)
        return d->status;
    if (ended == XML_STATUS_OK)
        return HATCH_OK;
    enum XML_Error code = XML_GetErrorCode(d->parser);
    return hatch_fail(err, code == XML_ERROR_NO_MEMORY ? HATCH_LIMIT : HATCH_BAD_INPUT, "line %lu: %s",
                      (unsigned long)XML_GetCurrentLineNumber(d->parser), XML_ErrorString(code));
}

enum hatch_status hatch_svg_read(struct hatch_bytes file, uint32_t size_px, struct hatch_arena *arena,
                                 struct hatch_arena *scratch, struct hatch_stroke_list *strokes,
                                 struct hatch_svg_notes *notes, struct hatch_err *err)
{
    if (file.size > INT_MAX / 2)
        return hatch_fail(err, HATCH_LIMIT, "%zu bytes of drawing", file.size);
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct drawing d = {.size_px = size_px, .arena = arena, .err = err};
    d.pen = (struct hatch_svg_pen){.line = {.arena = scratch, .tolerance = TOLERANCE_PX / size_px},
                                   .finish = add_stroke,
                                   .context = &d};
    d.looks = HATCH_NEW(scratch, struct hatch_svg_look, DEPTH_MAX + 1, err);
    d.parser = d.looks ? XML_ParserCreate(NULL) : NULL;
    enum hatch_status status = HATCH_LIMIT;
    if (d.parser)
        status = parse(&d, file, err);
    else if (d.looks)
        status = hatch_fail(err, HATCH_LIMIT, "no memory for a parser of XML");
    if (d.parser)
        XML_ParserFree(d.parser);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK) {
        *strokes = d.strokes;
        *notes = d.notes;
    }
    return status;
}
