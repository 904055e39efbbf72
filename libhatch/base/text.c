#include "base/text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Takes everything up to the separator off *rest; the separator goes too. */
static struct hatch_text take_until(struct hatch_text *rest, char separator)
{
    const char *end = memchr(rest->at, separator, rest->length);
    struct hatch_text taken = {rest->at, end ? (size_t)(end - rest->at) : rest->length};
    size_t used = taken.length + (end ? 1 : 0);
    rest->at += used;
    rest->length -= used;
    return taken;
}

bool hatch_text_line(struct hatch_text *rest, struct hatch_text *line)
{
    if (rest->length == 0)
        return false;
    *line = take_until(rest, '\n');
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
    *field = take_until(rest, '\t');
    bool ended_by_tab = field->length < before;
    if (!ended_by_tab)
        rest->at = NULL; /* a last, empty field after a tab is still to come otherwise */
    return true;
}

bool hatch_text_is(struct hatch_text text, const char *word)
{
    return strlen(word) == text.length && memcmp(text.at, word, text.length) == 0;
}

bool hatch_text_number(struct hatch_text text, double *number)
{
    char copy[64], *end;
    if (text.length == 0 || text.length >= sizeof copy)
        return false;
    for (size_t i = 0; i < text.length; i++)
        if (!strchr("0123456789+-.eE", text.at[i]) || text.at[i] == '\0')
            return false;
    memcpy(copy, text.at, text.length);
    copy[text.length] = '\0';
    double value = strtod(copy, &end);
    if (end != copy + text.length || !isfinite(value))
        return false;
    *number = value;
    return true;
}
