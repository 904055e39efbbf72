/* Parses the numbers, angles and lengths of SVG. */
#include <string.h>

#include "io/svg/parts.h"

#define DEGREES_PER_RADIAN 57.29577951308232

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

static void advance(struct hatch_text *text, size_t by)
{
    text->at += by;
    text->length -= by;
}

void hatch_svg_skip(struct hatch_text *rest)
{
    while (rest->length && is_blank(*rest->at))
        advance(rest, 1);
    if (rest->length && *rest->at == ',')
        advance(rest, 1);
    while (rest->length && is_blank(*rest->at))
        advance(rest, 1);
}

static size_t digits_at(const struct hatch_text *text, size_t at)
{
    size_t count = 0;
    while (at + count < text->length && text->at[at + count] >= '0' && text->at[at + count] <= '9')
        count++;
    return count;
}

/* Returns the length of the number at the start of a text: of "-.5e3" in "-.5e3-2", and of "-.5" in "-.5em". */
static size_t number_length(const struct hatch_text *text)
{
    size_t at = text->length && (*text->at == '+' || *text->at == '-');
    size_t whole = digits_at(text, at), fraction = 0;
    at += whole;
    if (at < text->length && text->at[at] == '.') {
        fraction = digits_at(text, at + 1);
        at += fraction || whole ? 1 + fraction : 0;
    }
    if (!whole && !fraction)
        return 0;
    if (at + 1 < text->length && (text->at[at] == 'e' || text->at[at] == 'E')) {
        size_t sign = text->at[at + 1] == '+' || text->at[at + 1] == '-';
        size_t exponent = digits_at(text, at + 1 + sign);
        at += exponent ? 1 + sign + exponent : 0;
    }
    return at;
}

static bool take_number(struct hatch_text *rest, double *number)
{
    size_t length = number_length(rest), plus = length && *rest->at == '+';
    struct hatch_text digits = {rest->at + plus, length - plus};
    if (length && digits.at[digits.length - 1] == '.')
        digits.length--;
    if (!length || !hatch_text_number(digits, number))
        return false;
    advance(rest, length);
    return true;
}

bool hatch_svg_number(struct hatch_text *rest, double *number)
{
    if (!take_number(rest, number))
        return false;
    hatch_svg_skip(rest);
    return true;
}

bool hatch_svg_numbers(struct hatch_text *rest, uint32_t count, double *numbers)
{
    for (uint32_t i = 0; i < count; i++)
        if (!hatch_svg_number(rest, &numbers[i]))
            return false;
    return true;
}

/* Removes and returns the letters, or the percent sign, at the start of a text. */
static struct hatch_text take_unit(struct hatch_text *rest)
{
    struct hatch_text unit = {rest->at, 0};
    while (unit.length < rest->length && ((unit.at[unit.length] | 32) >= 'a' && (unit.at[unit.length] | 32) <= 'z'))
        unit.length++;
    unit.length += unit.length == 0 && rest->length && *rest->at == '%';
    advance(rest, unit.length);
    return unit;
}

/* A unit of angles or lengths. */
struct unit {
    const char *name;
    double size; /* degrees, or user units */
};

/* Removes a number with one of some units, and the blanks after it. Returns false if there is none.
 *   value  out: in degrees or user units */
static bool take_quantity(struct hatch_text *rest, const struct unit *units, size_t count, double *value)
{
    double number;
    if (!take_number(rest, &number))
        return false;
    struct hatch_text name = take_unit(rest);
    hatch_svg_skip(rest);
    for (size_t i = 0; i < count; i++)
        if (hatch_text_is(name, units[i].name)) {
            *value = number * units[i].size;
            return true;
        }
    return false;
}

bool hatch_svg_angle(struct hatch_text *rest, double *angle_deg)
{
    static const struct unit units[] = {{"", 1}, {"deg", 1}, {"grad", 0.9}, {"rad", DEGREES_PER_RADIAN}, {"turn", 360}};
    return take_quantity(rest, units, sizeof units / sizeof *units, angle_deg);
}

bool hatch_svg_take_length(struct hatch_text *rest, double whole, double *length)
{
    const struct unit units[] = {{"", 1},           {"px", 1},  {"pt", 96.0 / 72}, {"pc", 16}, {"mm", 96 / 25.4},
                                 {"cm", 96 / 2.54}, {"in", 96}, {"em", 16},        {"ex", 8},  {"%", whole / 100}};
    return take_quantity(rest, units, sizeof units / sizeof *units, length);
}

enum hatch_status hatch_svg_length(struct hatch_text text, double whole, double *length, struct hatch_err *err)
{
    struct hatch_text rest = text;
    double made;
    hatch_svg_skip(&rest);
    if (!hatch_svg_take_length(&rest, whole, &made) || rest.length)
        return hatch_fail(err, HATCH_BAD_INPUT, "'%.*s' is not a length", (int)(text.length < 40 ? text.length : 40),
                          text.at);
    *length = made;
    return HATCH_OK;
}

enum hatch_status hatch_svg_lengths(struct hatch_text text, double whole, uint32_t max, double *lengths,
                                    uint32_t *count, struct hatch_err *err)
{
    *count = 0;
    for (hatch_svg_skip(&text); text.length; hatch_svg_skip(&text)) {
        struct hatch_text one = {text.at, 0};
        for (; text.length && !is_blank(*text.at) && *text.at != ','; advance(&text, 1))
            one.length++;
        if (*count == max)
            return hatch_fail(err, HATCH_BAD_INPUT, "more than %u lengths", max);
        HATCH_TRY(hatch_svg_length(one, whole, &lengths[*count], err));
        ++*count;
    }
    return HATCH_OK;
}
