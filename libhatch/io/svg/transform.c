/* Transforms of SVG (CSS Transforms 1), as matrices. */
#include <string.h>

#include "io/svg/parts.h"

#define RADIANS_PER_DEGREE 0.017453292519943295

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

/* Kinds of the arguments of a transform function, a letter for each: n number, l length, a angle. */
struct kinds {
    const char *name, *letters;
    uint32_t least; /* arguments that may not be left out */
};

static const struct kinds functions[] = {
    {"matrix", "nnnnnn", 6}, {"translate", "ll", 1}, {"translateX", "l", 1}, {"translateY", "l", 1},
    {"scale", "nn", 1},      {"scaleX", "n", 1},     {"scaleY", "n", 1},     {"rotate", "all", 1},
    {"skew", "aa", 1},       {"skewX", "a", 1},      {"skewY", "a", 1},
};

/* Computes the matrix of a function from its arguments; those that were left out are 0. */
static struct hatch_svg_matrix matrix_of(const char *name, const double *v, uint32_t count)
{
    if (strcmp(name, "matrix") == 0)
        return (struct hatch_svg_matrix){v[0], v[1], v[2], v[3], v[4], v[5]};
    if (strcmp(name, "rotate") == 0)
        return rotation(v, count);
    struct hatch_svg_matrix m = {1, 0, 0, 1, 0, 0};
    char axis = name[strlen(name) - 1];
    bool only_y = axis == 'Y';
    double x = only_y ? 0 : v[0], y = only_y ? v[0] : v[1];
    if (name[0] == 't') {
        m.e = x;
        m.f = y;
    } else if (strncmp(name, "scale", 5) == 0) {
        m.a = only_y ? 1 : x;
        m.d = axis == 'X' ? 1 : count == 2 || only_y ? y : x;
    } else {
        m.c = tan(x * RADIANS_PER_DEGREE);
        m.b = tan(y * RADIANS_PER_DEGREE);
    }
    return m;
}

/* Removes the arguments of a function and its closing parenthesis. */
static bool take_arguments(struct hatch_text *rest, const struct kinds *kinds, double page, double v[6],
                           uint32_t *count)
{
    for (*count = 0; kinds->letters[*count] && rest->length && *rest->at != ')'; ++*count) {
        double *to = &v[*count];
        char kind = kinds->letters[*count];
        if (!(kind == 'a'   ? hatch_svg_angle(rest, to)
              : kind == 'l' ? hatch_svg_take_length(rest, page, to)
                            : hatch_svg_number(rest, to)))
            return false;
    }
    bool closed = rest->length && *rest->at == ')';
    rest->at += closed;
    rest->length -= closed;
    return closed && *count >= kinds->least && !(*count == 2 && strcmp(kinds->name, "rotate") == 0);
}

/* Removes a function and computes its matrix. */
static bool take_function(struct hatch_text *rest, double page, struct hatch_svg_matrix *matrix)
{
    const char *open = memchr(rest->at, '(', rest->length);
    if (!open)
        return false;
    struct hatch_text name = {rest->at, (size_t)(open - rest->at)};
    rest->at += name.length + 1;
    rest->length -= name.length + 1;
    while (name.length && strchr(" \t\r\n\f", name.at[name.length - 1]))
        name.length--;
    hatch_svg_skip(rest);
    for (size_t i = 0; i < sizeof functions / sizeof *functions; i++) {
        double v[6] = {0};
        uint32_t count = 0;
        if (!hatch_text_is(name, functions[i].name))
            continue;
        if (!take_arguments(rest, &functions[i], page, v, &count))
            return false;
        *matrix = matrix_of(functions[i].name, v, count);
        return true;
    }
    return false;
}

enum hatch_status hatch_svg_transform(struct hatch_text text, double page, struct hatch_svg_matrix *matrix,
                                      struct hatch_err *err)
{
    struct hatch_svg_matrix made = {1, 0, 0, 1, 0, 0}, one;
    struct hatch_text rest = text;
    for (hatch_svg_skip(&rest); rest.length; hatch_svg_skip(&rest)) {
        if (!take_function(&rest, page, &one))
            return hatch_fail(err, HATCH_BAD_INPUT, "transform '%.*s' is malformed or unknown",
                              (int)(text.length < 60 ? text.length : 60), text.at);
        made = hatch_svg_multiply(&made, &one);
    }
    *matrix = made;
    return HATCH_OK;
}
