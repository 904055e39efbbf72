#include "io/mesh_text.h"

#include <math.h>
#include <string.h>

struct hatch_mesh_text hatch_mesh_text_of(struct hatch_bytes bytes)
{
    const char *start = (const char *)bytes.data;
    return (struct hatch_mesh_text){.at = start, .end = start + bytes.size, .line = 1};
}

size_t hatch_mesh_text_left(const struct hatch_mesh_text *text)
{
    return (size_t)(text->end - text->at);
}

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/* The length of a backslash with the line's end behind it, or 0. */
static size_t continuation(const struct hatch_mesh_text *text)
{
    size_t left = hatch_mesh_text_left(text);
    if (!text->continues || left < 2 || text->at[0] != '\\')
        return 0;
    if (text->at[1] == '\n')
        return 2;
    return left > 2 && text->at[1] == '\r' && text->at[2] == '\n' ? 3 : 0;
}

static void skip_blanks(struct hatch_mesh_text *text)
{
    while (text->at < text->end) {
        size_t joined = continuation(text);
        if (joined) {
            text->at += joined;
            text->line++;
        } else if (is_blank(*text->at)) {
            text->at++;
        } else {
            break;
        }
    }
    if (text->comment && text->at < text->end && *text->at == text->comment)
        while (text->at < text->end && *text->at != '\n')
            text->at++;
}

struct hatch_word hatch_mesh_text_word(struct hatch_mesh_text *text)
{
    skip_blanks(text);
    const char *start = text->at;
    while (text->at < text->end && !is_blank(*text->at) && *text->at != '\n' &&
           !(*text->at == '\\' && continuation(text)))
        text->at++;
    return (struct hatch_word){start, (size_t)(text->at - start)};
}

bool hatch_mesh_text_next_line(struct hatch_mesh_text *text)
{
    const char *newline = memchr(text->at, '\n', hatch_mesh_text_left(text));
    if (!newline) {
        text->at = text->end;
        return false;
    }
    text->at = newline + 1;
    text->line++;
    return text->at < text->end;
}

struct hatch_word hatch_mesh_text_any_word(struct hatch_mesh_text *text)
{
    for (;;) {
        struct hatch_word word = hatch_mesh_text_word(text);
        if (word.length || !hatch_mesh_text_next_line(text))
            return word;
    }
}

bool hatch_word_is(struct hatch_word word, const char *name)
{
    return word.length == strlen(name) && memcmp(word.start, name, word.length) == 0;
}

int hatch_word_shown(struct hatch_word word)
{
    return word.length < 40 ? (int)word.length : 40;
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* A power of ten times value; the powers up to 10^22 are exact in double. */
static double scale(double value, int exponent)
{
    static const double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                    1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                    1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    for (; exponent > 22; exponent -= 22)
        value *= powers[22];
    for (; exponent < -22; exponent += 22)
        value /= powers[22];
    return exponent < 0 ? value / powers[-exponent] : value * powers[exponent];
}

struct digits {
    uint64_t mantissa; /* the first nineteen significant digits */
    int exponent;      /* of ten */
    bool any;
};

#define MANTISSA_FULL 1000000000000000000u /* one digit more still fits 64 bits */
#define EXPONENT_MOST 10000

static const char *read_digits(const char *at, const char *end, bool fraction, struct digits *d)
{
    for (; at < end && is_digit(*at); at++) {
        d->any = true;
        bool room = d->mantissa < MANTISSA_FULL;
        if (room)
            d->mantissa = d->mantissa * 10 + (uint64_t)(*at - '0');
        if (fraction && room && d->exponent > -EXPONENT_MOST)
            d->exponent--;
        if (!fraction && !room && d->exponent < EXPONENT_MOST)
            d->exponent++;
    }
    return at;
}

static const char *read_exponent(const char *at, const char *end, int *exponent)
{
    if (at >= end || (*at != 'e' && *at != 'E'))
        return at;
    const char *p = at + 1;
    bool negative = p < end && *p == '-';
    p += p < end && (*p == '-' || *p == '+');
    if (p >= end || !is_digit(*p))
        return at;
    int value = 0;
    for (; p < end && is_digit(*p); p++)
        value = value < EXPONENT_MOST ? value * 10 + (*p - '0') : value;
    *exponent += negative ? -value : value;
    return p;
}

bool hatch_word_number(struct hatch_word word, double *number)
{
    const char *at = word.start, *end = word.start + word.length;
    struct digits d = {0, 0, false};
    bool negative = at < end && *at == '-';
    at += at < end && (*at == '-' || *at == '+');
    at = read_digits(at, end, false, &d);
    if (at < end && *at == '.')
        at = read_digits(at + 1, end, true, &d);
    if (!d.any)
        return false;
    at = read_exponent(at, end, &d.exponent);
    if (at != end)
        return false;
    double value = d.mantissa == 0 ? 0 : scale((double)d.mantissa, d.exponent);
    *number = negative ? -value : value;
    return true;
}

bool hatch_word_integer(struct hatch_word word, int64_t *number)
{
    const char *at = word.start, *end = word.start + word.length;
    bool negative = at < end && *at == '-';
    at += at < end && (*at == '-' || *at == '+');
    if (at == end)
        return false;
    int64_t value = 0;
    for (; at < end; at++) {
        if (!is_digit(*at) || value > ((int64_t)1 << 58))
            return false;
        value = value * 10 + (*at - '0');
    }
    *number = negative ? -value : value;
    return true;
}

enum hatch_status hatch_mesh_text_float(struct hatch_mesh_text *text, const char *what, float *number,
                                   struct hatch_err *err)
{
    struct hatch_word word = hatch_mesh_text_word(text);
    double value;
    if (word.length == 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: %s has too few numbers", text->line, what);
    if (!hatch_word_number(word, &value))
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: %s: %.*s is no number", text->line, what,
                          hatch_word_shown(word), word.start);
    if (!isfinite((float)value))
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: %s: %.*s is too large", text->line, what,
                          hatch_word_shown(word), word.start);
    *number = (float)value;
    return HATCH_OK;
}
