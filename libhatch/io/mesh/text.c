#include "io/mesh/text.h"

#include <math.h>
#include <string.h>

struct hatch_mesh_text hatch_mesh_text_of(struct hatch_bytes bytes)
{
    struct hatch_text text = hatch_text_of(bytes);
    return (struct hatch_mesh_text){.at = text.at, .end = text.at + text.length, .line = 1};
}

size_t hatch_mesh_text_remaining(const struct hatch_mesh_text *text)
{
    return (size_t)(text->end - text->at);
}

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

static bool ends_line(char c)
{
    return c == '\n' || c == '\r';
}

/* Returns the length of the line end at a place of the text; 0 if there is none. */
static size_t line_end(const struct hatch_mesh_text *text, const char *at)
{
    if (at == text->end || !ends_line(*at))
        return 0;
    return *at == '\r' && at + 1 < text->end && at[1] == '\n' ? 2 : 1;
}

/* Returns the length of a backslash and the line end after it, or 0 if there is none. */
static size_t continuation(const struct hatch_mesh_text *text)
{
    if (!text->continues || text->at == text->end || *text->at != '\\')
        return 0;
    size_t end = line_end(text, text->at + 1);
    return end ? 1 + end : 0;
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
        while (text->at < text->end && !ends_line(*text->at))
            text->at++;
}

struct hatch_text hatch_mesh_text_word(struct hatch_mesh_text *text)
{
    skip_blanks(text);
    const char *start = text->at;
    while (text->at < text->end && !is_blank(*text->at) && !ends_line(*text->at) &&
           !(*text->at == '\\' && continuation(text)))
        text->at++;
    return (struct hatch_text){start, (size_t)(text->at - start)};
}

bool hatch_mesh_text_next_line(struct hatch_mesh_text *text)
{
    while (hatch_mesh_text_word(text).length > 0)
        continue;
    if (text->at == text->end)
        return false;
    text->at += line_end(text, text->at);
    text->line++;
    return text->at < text->end;
}

struct hatch_text hatch_mesh_text_any_word(struct hatch_mesh_text *text)
{
    for (;;) {
        struct hatch_text word = hatch_mesh_text_word(text);
        if (word.length || !hatch_mesh_text_next_line(text))
            return word;
    }
}

int hatch_mesh_text_shown(struct hatch_text word)
{
    return word.length < 40 ? (int)word.length : 40;
}

bool hatch_mesh_has_extension(struct hatch_text name, const char *extension)
{
    size_t suffix = strlen(extension);
    if (name.length < suffix)
        return false;
    for (size_t i = 0; i < suffix; i++) {
        char c = name.at[name.length - suffix + i];
        if ((c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c) != extension[i])
            return false;
    }
    return true;
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

bool hatch_mesh_text_integer(struct hatch_text word, int64_t *number)
{
    const char *at = word.at, *end = word.at + word.length;
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

static enum hatch_status next_number(struct hatch_mesh_text *text, const char *what, double *number,
                                     struct hatch_err *err)
{
    struct hatch_text word = hatch_mesh_text_word(text);
    double value;
    if (word.length == 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: %s has too few numbers", text->line, what);
    if (!hatch_text_decimal(word, &value))
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: %s: %.*s is not a number", text->line, what,
                          hatch_mesh_text_shown(word), word.at);
    if (!isfinite((float)value))
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: %s: %.*s is too large", text->line, what,
                          hatch_mesh_text_shown(word), word.at);
    *number = value;
    return HATCH_OK;
}

enum hatch_status hatch_mesh_text_float(struct hatch_mesh_text *text, const char *what, float *number,
                                        struct hatch_err *err)
{
    double value = 0;
    HATCH_TRY(next_number(text, what, &value, err));
    *number = (float)value;
    return HATCH_OK;
}

uint32_t hatch_mesh_text_floats(struct hatch_mesh_text *text, uint32_t most, float *numbers)
{
    uint32_t count = 0;
    double value;
    while (count < most && hatch_text_decimal(hatch_mesh_text_word(text), &value) && isfinite((float)value))
        numbers[count++] = (float)value;
    return count;
}

enum hatch_status hatch_mesh_text_position(struct hatch_mesh_text *text, const char *what, const double origin[3],
                                           float position[3], struct hatch_err *err)
{
    double value = 0;
    for (int k = 0; k < 3; k++) {
        HATCH_TRY(next_number(text, what, &value, err));
        position[k] = (float)(value - origin[k]);
    }
    return HATCH_OK;
}
