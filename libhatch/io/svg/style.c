/* Parses presentation attributes and style declarations. */
#include <string.h>

#include "io/svg/parts.h"

static struct hatch_text trimmed(struct hatch_text text)
{
    while (text.length && strchr(" \t\r\n", *text.at)) {
        text.at++;
        text.length--;
    }
    while (text.length && strchr(" \t\r\n", text.at[text.length - 1]))
        text.length--;
    return text;
}

static enum hatch_status bad_value(struct hatch_text name, struct hatch_text value, struct hatch_err *err)
{
    return hatch_fail(err, HATCH_BAD_INPUT, "%.*s '%.*s' is malformed or unknown", (int)name.length, name.at,
                      (int)(value.length < 40 ? value.length : 40), value.at);
}

static bool is_none(struct hatch_text value)
{
    return hatch_text_is(value, "none");
}

/* Whether a value is currentColor: the colour of the property color, which may follow later in the element. */
static bool is_current(struct hatch_text value)
{
    return hatch_text_is(value, "currentColor") || hatch_text_is(value, "currentcolor");
}

static enum hatch_status read_stroke(struct hatch_text name, struct hatch_text value, struct hatch_svg_style *style,
                                     struct hatch_err *err)
{
    style->stroke_current = is_current(value);
    if (is_none(value) || hatch_text_is(value, "initial"))
        style->stroke = HATCH_SVG_NONE;
    else if (value.length > 4 && memcmp(value.at, "url(", 4) == 0)
        style->stroke = HATCH_SVG_SERVER;
    else if (style->stroke_current || hatch_svg_color(value, style->stroke_rgba))
        style->stroke = HATCH_SVG_COLOR;
    else
        return bad_value(name, value, err);
    return HATCH_OK;
}

/* Reads whether there is a fill. Any value but none and a transparent colour is one, since fills are only counted. */
static void read_fill(struct hatch_text value, struct hatch_svg_style *style)
{
    float rgba[4];
    bool transparent = hatch_svg_color(value, rgba) && !(rgba[3] > 0);
    style->fill_current = is_current(value);
    style->filled = !is_none(value) && !transparent;
}

static enum hatch_status read_opacity(struct hatch_text name, struct hatch_text value, double *opacity,
                                      struct hatch_err *err)
{
    struct hatch_text rest = value;
    double number;
    if (!hatch_svg_number(&rest, &number) || (rest.length && !hatch_text_is(rest, "%")))
        return bad_value(name, value, err);
    number /= rest.length ? 100 : 1;
    *opacity = number > 0 ? number < 1 ? number : 1 : 0;
    return HATCH_OK;
}

static enum hatch_status read_width(struct hatch_text value, double page, struct hatch_svg_style *style,
                                    struct hatch_err *err)
{
    double width;
    if (hatch_svg_length(value, page, &width, err) != HATCH_OK)
        return hatch_fail_at(err, "stroke-width: ");
    if (!(width >= 0))
        return hatch_fail(err, HATCH_BAD_INPUT, "stroke-width %g is negative", width);
    style->width = width;
    return HATCH_OK;
}

bool hatch_svg_is_any(struct hatch_text name, const char *const *list)
{
    for (; *list; list++)
        if (hatch_text_is(name, *list))
            return true;
    return false;
}

enum hatch_status hatch_svg_property(struct hatch_text name, struct hatch_text value, double page,
                                     struct hatch_svg_style *style, struct hatch_err *err)
{
    static const char *const left_out[] = {"filter", "mask", "clip-path", "translate", "rotate", "scale", NULL};
    value = trimmed(value);
    if (value.length == 0 || hatch_text_is(value, "inherit") || hatch_text_is(value, "unset"))
        return HATCH_OK;
    if (hatch_text_is(name, "stroke"))
        return read_stroke(name, value, style, err);
    if (hatch_text_is(name, "fill"))
        read_fill(value, style);
    if (hatch_text_is(name, "color"))
        hatch_svg_color(value, style->color_rgba); /* an unknown one keeps the colour of the element around */
    if (hatch_text_is(name, "stroke-width"))
        return read_width(value, page, style, err);
    if (hatch_text_is(name, "stroke-opacity"))
        return read_opacity(name, value, &style->stroke_opacity, err);
    if (hatch_text_is(name, "fill-opacity"))
        return read_opacity(name, value, &style->fill_opacity, err);
    if (hatch_text_is(name, "opacity"))
        return read_opacity(name, value, &style->own_opacity, err);
    if (hatch_text_is(name, "stroke-dasharray"))
        style->dashes = is_none(value) ? (struct hatch_text){"", 0} : value;
    if (hatch_text_is(name, "stroke-dashoffset") && hatch_svg_length(value, page, &style->dash_offset, err) != HATCH_OK)
        return hatch_fail_at(err, "stroke-dashoffset: ");
    if (hatch_text_is(name, "stroke-linecap"))
        style->capped = !hatch_text_is(value, "butt");
    if (hatch_text_is(name, "display"))
        style->own_undisplayed = is_none(value);
    if (hatch_text_is(name, "visibility"))
        style->invisible = hatch_text_is(value, "hidden") || hatch_text_is(value, "collapse");
    if (hatch_svg_is_any(name, left_out))
        style->incomplete |= !is_none(value);
    if (hatch_text_is(name, "transform"))
        style->own_transform = is_none(value) ? (struct hatch_text){"", 0} : value;
    if (hatch_text_is(name, "transform-origin"))
        style->own_origin = value;
    if (hatch_text_is(name, "vector-effect"))
        style->own_pen = hatch_text_is(value, "non-scaling-stroke");
    if (hatch_text_is(name, "transform-box"))
        style->own_box = !hatch_text_is(value, "view-box");
    return HATCH_OK;
}

/* Removes "!important" from the end of a value. Returns whether it was there. */
static bool take_important(struct hatch_text *value)
{
    static const char word[] = "important";
    const size_t length = sizeof word - 1;
    struct hatch_text rest = trimmed(*value);
    if (rest.length <= length || memcmp(rest.at + rest.length - length, word, length) != 0)
        return false;
    rest = trimmed((struct hatch_text){rest.at, rest.length - length});
    if (rest.length == 0 || rest.at[rest.length - 1] != '!')
        return false;
    *value = (struct hatch_text){rest.at, rest.length - 1};
    return true;
}

void hatch_svg_declarations(struct hatch_text rest, double page, bool important, struct hatch_svg_style *style)
{
    while (rest.length) {
        const char *end = memchr(rest.at, ';', rest.length);
        struct hatch_text declaration = {rest.at, end ? (size_t)(end - rest.at) : rest.length};
        size_t passed = declaration.length + (end != NULL);
        rest = (struct hatch_text){rest.at + passed, rest.length - passed};
        const char *colon = declaration.length ? memchr(declaration.at, ':', declaration.length) : NULL;
        if (!colon)
            continue;
        size_t name_length = (size_t)(colon - declaration.at);
        struct hatch_text name = trimmed((struct hatch_text){declaration.at, name_length});
        struct hatch_text value = {colon + 1, declaration.length - name_length - 1};
        struct hatch_svg_style changed = *style;
        struct hatch_err err;
        if (take_important(&value) != important)
            continue;
        if (hatch_svg_property(name, value, page, &changed, &err) == HATCH_OK)
            *style = changed;
        else
            style->incomplete = true;
    }
}
