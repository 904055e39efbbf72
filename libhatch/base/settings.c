#include "base/settings.h"

#include <string.h>

bool hatch_settings_line(struct hatch_text *rest, struct hatch_text *line)
{
    if (!hatch_text_line(rest, line))
        return false;
    const char *comment = line->length ? memchr(line->at, '#', line->length) : NULL;
    if (comment)
        line->length = (size_t)(comment - line->at);
    return true;
}

enum hatch_status hatch_settings_number(struct hatch_text word, const char *key, double low, double high, double *value,
                                        struct hatch_err *err)
{
    double number;
    if (!hatch_text_number(word, &number))
        return hatch_fail(err, HATCH_BAD_INPUT, "%s: '%.*s' is not a number", key, hatch_settings_shown(word), word.at);
    if (!(number >= low && number <= high))
        return hatch_fail(err, HATCH_BAD_INPUT, "%s: %.10g, want %.10g to %.10g", key, number, low, high);
    *value = number;
    return HATCH_OK;
}

enum hatch_status hatch_settings_next(struct hatch_text *rest, const char *key, double low, double high, double *value,
                                      struct hatch_err *err)
{
    struct hatch_text word;
    if (!hatch_text_word(rest, &word))
        return hatch_fail(err, HATCH_BAD_INPUT, "%s: a value is missing", key);
    return hatch_settings_number(word, key, low, high, value, err);
}
