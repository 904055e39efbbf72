#include "base/text.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Removes the text up to the next separator from *rest, together with the separator; returns the text alone. */
static struct hatch_text split_at(struct hatch_text *rest, char separator)
{
    const char *end = memchr(rest->at, separator, rest->length);
    struct hatch_text part = {rest->at, end ? (size_t)(end - rest->at) : rest->length};
    size_t used = part.length + (end ? 1 : 0);
    rest->at += used;
    rest->length -= used;
    return part;
}

struct hatch_text hatch_text_of(struct hatch_bytes file)
{
    static const char mark[] = "\xef\xbb\xbf";
    const size_t length = sizeof mark - 1;
    struct hatch_text text = {(const char *)file.data, file.size};
    if (text.length >= length && memcmp(text.at, mark, length) == 0)
        text = (struct hatch_text){text.at + length, text.length - length};
    return text;
}

bool hatch_text_line(struct hatch_text *rest, struct hatch_text *line)
{
    if (rest->length == 0)
        return false;
    *line = split_at(rest, '\n');
    if (line->length && line->at[line->length - 1] == '\r')
        line->length--;
    return true;
}

static bool is_blank(char c)
{
    return c == ' ' || c == '\t';
}

bool hatch_text_word(struct hatch_text *rest, struct hatch_text *word)
{
    size_t from = 0;
    while (from < rest->length && is_blank(rest->at[from]))
        from++;
    size_t to = from;
    while (to < rest->length && !is_blank(rest->at[to]))
        to++;
    *word = (struct hatch_text){rest->at + from, to - from};
    rest->at += to;
    rest->length -= to;
    return word->length > 0;
}

bool hatch_text_field(struct hatch_text *rest, struct hatch_text *field)
{
    if (!rest->at)
        return false;
    size_t before = rest->length;
    *field = split_at(rest, '\t');
    bool ended_by_tab = field->length < before;
    if (!ended_by_tab)
        rest->at = NULL; /* NULL: the line is over; after a tab another field follows, even an empty one */
    return true;
}

bool hatch_text_is(struct hatch_text text, const char *word)
{
    return strlen(word) == text.length && memcmp(text.at, word, text.length) == 0;
}

static bool same_tails(struct hatch_text text, size_t from, const char *word, size_t word_from)
{
    size_t length = strlen(word);
    return from <= text.length && word_from <= length && text.length - from == length - word_from &&
           memcmp(text.at + from, word + word_from, text.length - from) == 0;
}

bool hatch_text_is_near(struct hatch_text text, const char *word)
{
    size_t same = 0;
    while (same < text.length && word[same] && word[same] == text.at[same])
        same++;
    bool swapped =
        text.length - same >= 2 && word[same] && text.at[same] == word[same + 1] && text.at[same + 1] == word[same];
    return same_tails(text, same, word, same) || same_tails(text, same + 1, word, same) ||
           same_tails(text, same, word, same + 1) || same_tails(text, same + 1, word, same + 1) ||
           (swapped && same_tails(text, same + 2, word, same + 2));
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

struct digits {
    uint64_t mantissa; /* the first nineteen significant digits, as a whole number */
    int exponent;      /* power of ten by which mantissa is multiplied */
    bool any;
};

#define MANTISSA_FULL 1000000000000000000u /* below this, another digit fits into 64 bits */
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

/* Where the mantissa and the power of ten are both exact doubles, their product or quotient is rounded correctly; the C
 * library handles all other cases. */
static double value_of(const struct digits *d)
{
    static const double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    if (d->mantissa >> 53 == 0 && abs(d->exponent) <= 22)
        return d->exponent < 0 ? (double)d->mantissa / powers[-d->exponent] : (double)d->mantissa * powers[d->exponent];
    char plain[48];
    snprintf(plain, sizeof plain, "%" PRIu64 "e%d", d->mantissa, d->exponent);
    return strtod(plain, NULL);
}

bool hatch_text_decimal(struct hatch_text text, double *number)
{
    const char *at = text.at, *end = text.at + text.length;
    struct digits d = {0, 0, false};
    bool negative = at < end && *at == '-';
    at += at < end && (*at == '-' || *at == '+');
    at = read_digits(at, end, false, &d);
    if (at < end && *at == '.')
        at = read_digits(at + 1, end, true, &d);
    if (!d.any || read_exponent(at, end, &d.exponent) != end)
        return false;
    double value = value_of(&d);
    *number = negative ? -value : value;
    return true;
}

bool hatch_text_number(struct hatch_text text, double *number)
{
    double value;
    if (!hatch_text_decimal(text, &value) || !isfinite(value))
        return false;
    *number = value;
    return true;
}

bool hatch_text_vector(struct hatch_text text, double xyz[3])
{
    for (int k = 0; k < 3; k++) {
        const char *comma = memchr(text.at, ',', text.length);
        size_t length = comma ? (size_t)(comma - text.at) : text.length;
        if (!hatch_text_number((struct hatch_text){text.at, length}, &xyz[k]))
            return false;
        if (k == 2)
            return !comma;
        if (!comma)
            return false;
        text.length -= length + 1;
        text.at += length + 1;
    }
    return false;
}
