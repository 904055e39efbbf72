/* Style sheets: the parts of CSS 2.1, sections 4 to 6, that drawings use. */
#include "io/svg/sheet.h"

#include <string.h>

#define SPECIFICITY_ID 10000u
#define SPECIFICITY_CLASS 100u

static bool is_name(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
           (c & 0x80) != 0;
}

static void skip(struct hatch_text *text, size_t length)
{
    text->at += length;
    text->length -= length;
}

static void skip_blanks(struct hatch_text *text)
{
    while (text->length && *text->at && strchr(" \t\r\n\f", *text->at))
        skip(text, 1);
}

enum hatch_status hatch_svg_blank_comments(struct hatch_text *text, struct hatch_arena *arena, struct hatch_err *err)
{
    char *made = HATCH_NEW(arena, char, text->length + 1, err);
    bool comment = false;
    size_t begin = 0;
    if (!made)
        return HATCH_LIMIT;
    for (size_t i = 0; i < text->length; i++) {
        bool ends = comment && i >= begin + 3 && text->at[i - 1] == '*' && text->at[i] == '/';
        if (!comment && i + 1 < text->length && text->at[i] == '/' && text->at[i + 1] == '*') {
            comment = true;
            begin = i;
        }
        made[i] = comment ? ' ' : text->at[i];
        comment &= !ends;
    }
    text->at = made;
    return HATCH_OK;
}

/* Removes and returns the text before the first character that is one of ends. */
static struct hatch_text take_until(struct hatch_text *text, const char *ends)
{
    struct hatch_text taken = *text;
    while (text->length && !(*text->at && strchr(ends, *text->at)))
        skip(text, 1);
    taken.length -= text->length;
    return taken;
}

static struct hatch_text without_trailing_blanks(struct hatch_text text)
{
    while (text.length && strchr(" \t\r\n\f", text.at[text.length - 1]))
        text.length--;
    return text;
}

/* Removes the first part of a selector: an element, a class or an id. Returns false when there is none.
 *   kind  out: '.' for a class, '#' for an id, 0 for an element
 *   name  out: without the '.' or '#' */
static bool take_part(struct hatch_text *selector, char *kind, struct hatch_text *name)
{
    *kind = 0;
    if (selector->length && (*selector->at == '.' || *selector->at == '#')) {
        *kind = *selector->at;
        skip(selector, 1);
    }
    *name = *selector;
    if (!*kind && selector->length && *selector->at == '*')
        skip(selector, 1);
    else
        while (selector->length && is_name(*selector->at))
            skip(selector, 1);
    name->length -= selector->length;
    return name->length > 0;
}

/* Returns the specificity of a selector, and 1 more; 0 if it has combinators or pseudo-classes, which are not
 * supported. */
static uint32_t specificity_of(struct hatch_text selector)
{
    uint32_t specificity = selector.length > 0;
    char kind;
    struct hatch_text name;
    for (bool first = true; selector.length; first = false) {
        if (!take_part(&selector, &kind, &name) || (!kind && !first))
            return 0;
        bool any = !kind && hatch_text_is(name, "*");
        specificity += kind == '#' ? SPECIFICITY_ID : kind == '.' ? SPECIFICITY_CLASS : any ? 0 : 1;
    }
    return specificity;
}

/* Inserts a rule after those of equal specificity, since later rules take precedence. */
static enum hatch_status add_rule(struct hatch_svg_sheet *sheet, const struct hatch_svg_rule *rule,
                                  struct hatch_err *err)
{
    if (sheet->count == HATCH_SVG_RULES_MAX)
        return hatch_fail(err, HATCH_LIMIT, "more than %u CSS rules", HATCH_SVG_RULES_MAX);
    uint32_t at = sheet->count++;
    for (; at > 0 && sheet->rules[at - 1].specificity > rule->specificity; at--)
        sheet->rules[at] = sheet->rules[at - 1];
    sheet->rules[at] = *rule;
    return HATCH_OK;
}

/* Removes the text before the first character that is one of ends and is in no string and in no parentheses. */
static void skip_until(struct hatch_text *text, const char *ends)
{
    char closing = 0; /* of the string or the parentheses; 0: outside */
    for (; text->length && (closing || !*text->at || !strchr(ends, *text->at)); skip(text, 1)) {
        char c = *text->at;
        if (closing)
            closing = c == closing ? 0 : closing;
        else if (c == '"' || c == '\'' || c == '(')
            closing = c == '(' ? ')' : c;
    }
}

/* Skips an at-rule, up to its semicolon or closing brace. */
static void skip_at_rule(struct hatch_text *text)
{
    uint32_t depth = 0;
    skip_until(text, ";{");
    do {
        if (text->length)
            depth += *text->at == '{' ? 1u : *text->at == '}' ? UINT32_MAX : 0u;
        skip(text, text->length > 0);
        if (depth)
            skip_until(text, "{}");
    } while (depth && text->length);
}

static enum hatch_status read_rule(struct hatch_text *text, struct hatch_svg_sheet *sheet, struct hatch_err *err)
{
    struct hatch_text selectors = take_until(text, "{");
    skip(text, text->length > 0);
    struct hatch_svg_rule rule = {.declarations = take_until(text, "}")};
    skip(text, text->length > 0);
    while (selectors.length) {
        skip_blanks(&selectors);
        rule.selector = without_trailing_blanks(take_until(&selectors, ","));
        skip(&selectors, selectors.length > 0);
        rule.specificity = specificity_of(rule.selector);
        if (rule.specificity)
            HATCH_TRY(add_rule(sheet, &rule, err));
        sheet->others += !rule.specificity && rule.selector.length > 0;
    }
    return HATCH_OK;
}

enum hatch_status hatch_svg_sheet_read(struct hatch_text text, struct hatch_arena *arena, struct hatch_svg_sheet *sheet,
                                       struct hatch_err *err)
{
    struct hatch_svg_sheet made = {0};
    HATCH_TRY(hatch_svg_blank_comments(&text, arena, err));
    skip_blanks(&text);
    if (text.length && !(made.rules = HATCH_NEW(arena, struct hatch_svg_rule, HATCH_SVG_RULES_MAX, err)))
        return HATCH_LIMIT;
    for (; text.length; skip_blanks(&text)) {
        if (*text.at == '@') {
            made.others++;
            skip_at_rule(&text);
        } else {
            HATCH_TRY(read_rule(&text, &made, err));
        }
    }
    *sheet = made;
    return HATCH_OK;
}

static bool has_class(struct hatch_text classes, struct hatch_text name)
{
    struct hatch_text one;
    while (hatch_text_word(&classes, &one))
        if (one.length == name.length && memcmp(one.at, name.at, name.length) == 0)
            return true;
    return false;
}

static bool matches(struct hatch_text selector, const char *element, struct hatch_text classes, struct hatch_text id)
{
    char kind;
    struct hatch_text name;
    while (take_part(&selector, &kind, &name)) {
        bool same = kind == '.'   ? has_class(classes, name)
                    : kind == '#' ? id.length == name.length && memcmp(id.at, name.at, name.length) == 0
                                  : hatch_text_is(name, "*") || hatch_text_is(name, element);
        if (!same)
            return false;
    }
    return true;
}

void hatch_svg_sheet_apply(const struct hatch_svg_sheet *sheet, const char *element, const char *const *attributes,
                           double page, bool important, struct hatch_svg_style *style)
{
    struct hatch_text classes = hatch_svg_attribute(attributes, "class"), id = hatch_svg_attribute(attributes, "id");
    for (uint32_t i = 0; i < sheet->count; i++)
        if (matches(sheet->rules[i].selector, element, classes, id))
            hatch_svg_declarations(sheet->rules[i].declarations, page, important, style);
}
