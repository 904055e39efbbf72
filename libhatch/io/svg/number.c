/* Parses the numbers, lengths and transforms of SVG. */
#include <string.h>

#include "io/svg/parts.h"

#define DEGREES_PER_RADIAN 57.29577951308232
#define RADIANS_PER_DEGREE 0.017453292519943295

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

bool hatch_svg_angle(struct hatch_text *rest, double *angle_deg)
{
    static const struct {
        const char *name;
        double degrees;
    } units[] = {{"", 1}, {"deg", 1}, {"grad", 0.9}, {"rad", DEGREES_PER_RADIAN}, {"turn", 360}};
    double number;
    if (!take_number(rest, &number))
        return false;
    struct hatch_text unit = take_unit(rest);
    hatch_svg_skip(rest);
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (hatch_text_is(unit, units[i].name)) {
            *angle_deg = number * units[i].degrees;
            return true;
        }
    return false;
}

enum hatch_status hatch_svg_length(struct hatch_text text, double whole, double *length, struct hatch_err *err)
{
    static const struct {
        const char *name;
        double units;
    } units[] = {{"px", 1},         {"pt", 96.0 / 72}, {"pc", 16}, {"mm", 96 / 25.4},
                 {"cm", 96 / 2.54}, {"in", 96},        {"em", 16}, {"ex", 8}};
    struct hatch_text rest = text;
    double number;
    hatch_svg_skip(&rest);
    if (take_number(&rest, &number)) {
        while (rest.length && is_blank(rest.at[rest.length - 1]))
            rest.length--;
        if (rest.length == 0 || hatch_text_is(rest, "%")) {
            *length = rest.length ? number / 100 * whole : number;
            return HATCH_OK;
        }
        for (size_t i = 0; i < sizeof units / sizeof *units; i++)
            if (hatch_text_is(rest, units[i].name)) {
                *length = number * units[i].units;
                return HATCH_OK;
            }
    }
    return hatch_fail(err, HATCH_BAD_INPUT, "'%.*s' is not a length", (int)(text.length < 40 ? text.length : 40),
                      text.at);
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

void hatch_svg_apply(const struct hatch_svg_matrix *m, double x, double y, double point[2])
{
    point[0] = m->a * x + m->c * y + m->e;
    point[1] = m->b * x + m->d * y + m->f;
}

struct hatch_svg_matrix hatch_svg_multiply(const struct hatch_svg_matrix *outer, const struct hatch_svg_matrix *inner)
{
    double offset[2];
    hatch_svg_apply(outer, inner->e, inner->f, offset);
    return (struct hatch_svg_matrix){outer->a * inner->a + outer->c * inner->b,
                                     outer->b * inner->a + outer->d * inner->b,
                                     outer->a * inner->c + outer->c * inner->d,
                                     outer->b * inner->c + outer->d * inner->d,
                                     offset[0],
                                     offset[1]};
}

double hatch_svg_determinant(const struct hatch_svg_matrix *m)
{
    return m->a * m->d - m->b * m->c;
}

static struct hatch_svg_matrix rotation(const double *v, uint32_t count)
{
    double cosine = cos(v[0] * RADIANS_PER_DEGREE), sine = sin(v[0] * RADIANS_PER_DEGREE);
    struct hatch_svg_matrix m = {cosine, sine, -sine, cosine, 0, 0};
    if (count == 3) {
        m.e = v[1] - cosine * v[1] + sine * v[2];
        m.f = v[2] - sine * v[1] - cosine * v[2];
    }
    return m;
}

/* Computes the matrix of a transform function; returns false when its name or the number of arguments is wrong. */
static bool transform_of(struct hatch_text name, const double *v, uint32_t count, struct hatch_svg_matrix *m)
{
    *m = (struct hatch_svg_matrix){1, 0, 0, 1, 0, 0};
    if (hatch_text_is(name, "matrix") && count == 6)
        *m = (struct hatch_svg_matrix){v[0], v[1], v[2], v[3], v[4], v[5]};
    else if (hatch_text_is(name, "translate") && (count == 1 || count == 2))
        m->e = v[0], m->f = count == 2 ? v[1] : 0;
    else if (hatch_text_is(name, "scale") && (count == 1 || count == 2))
        m->a = v[0], m->d = count == 2 ? v[1] : v[0];
    else if (hatch_text_is(name, "rotate") && (count == 1 || count == 3))
        *m = rotation(v, count);
    else if (hatch_text_is(name, "skewX") && count == 1)
        m->c = tan(v[0] * RADIANS_PER_DEGREE);
    else if (hatch_text_is(name, "skewY") && count == 1)
        m->b = tan(v[0] * RADIANS_PER_DEGREE);
    else
        return false;
    return true;
}

enum hatch_status hatch_svg_transform(struct hatch_text text, struct hatch_svg_matrix *matrix, struct hatch_err *err)
{
    struct hatch_svg_matrix made = {1, 0, 0, 1, 0, 0}, one;
    struct hatch_text rest = text;
    for (hatch_svg_skip(&rest); rest.length; hatch_svg_skip(&rest)) {
        const char *open = memchr(rest.at, '(', rest.length);
        struct hatch_text name = {rest.at, open ? (size_t)(open - rest.at) : 0};
        double v[6] = {0};
        uint32_t count = 0;
        advance(&rest, open ? name.length + 1 : 0);
        while (name.length && is_blank(name.at[name.length - 1]))
            name.length--;
        hatch_svg_skip(&rest);
        while (open && count < 6 && hatch_svg_number(&rest, &v[count]))
            count++;
        if (!open || !rest.length || *rest.at != ')' || !transform_of(name, v, count, &one))
            return hatch_fail(err, HATCH_BAD_INPUT, "transform '%.*s' is malformed or unknown",
                              (int)(text.length < 60 ? text.length : 60), text.at);
        advance(&rest, 1);
        made = hatch_svg_multiply(&made, &one);
    }
    *matrix = made;
    return HATCH_OK;
}
