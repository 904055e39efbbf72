#include "base/status.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"

enum hatch_status hatch_fail(struct hatch_err *err, enum hatch_status status, const char *format, ...)
{
    if (err) {
        va_list args;
        va_start(args, format);
        vsnprintf(err->text, sizeof err->text, format, args);
        va_end(args);
        hatch_utf8_make_plain(err->text, strlen(err->text));
        err->status = status;
    }
    return status;
}

/* Returns whether a word is written in capitals, as IHDR is: then its first letter stays as it is. */
static bool is_acronym(const char *text)
{
    return text[0] >= 'A' && text[0] <= 'Z' && text[1] >= 'A' && text[1] <= 'Z';
}

enum hatch_status hatch_fail_quoting(struct hatch_err *err, enum hatch_status status, const char *text,
                                     const char *format, ...)
{
    char sentence[sizeof err->text], quoted[sizeof err->text];
    va_list args;
    va_start(args, format);
    vsnprintf(sentence, sizeof sentence, format, args);
    va_end(args);
    text = text ? text : "";
    snprintf(quoted, sizeof quoted, "%.*s", (int)strcspn(text, "\r\n"), text);
    size_t length = strlen(quoted);
    while (length > 0 && strchr(". ", quoted[length - 1]))
        quoted[--length] = '\0';
    if (quoted[0] >= 'A' && quoted[0] <= 'Z' && !is_acronym(quoted))
        quoted[0] = (char)(quoted[0] - 'A' + 'a');
    return hatch_fail(err, status, "%s%s%s", sentence, length ? ": " : "", quoted);
}

enum hatch_status hatch_fail_at(struct hatch_err *err, const char *format, ...)
{
    char joined[sizeof err->text];
    va_list args;
    va_start(args, format);
    vsnprintf(joined, sizeof joined, format, args);
    va_end(args);
    hatch_utf8_make_plain(joined, strlen(joined));
    size_t used = strlen(joined);
    snprintf(joined + used, sizeof joined - used, "%s", err->text);
    memcpy(err->text, joined, sizeof joined);
    return err->status;
}
