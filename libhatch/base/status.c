#include "base/status.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

size_t hatch_utf8_length(const char *text)
{
    const unsigned char *at = (const unsigned char *)text;
    size_t length = at[0] < 0x80 ? 1 : at[0] < 0xc2 ? 0 : at[0] < 0xe0 ? 2 : at[0] < 0xf0 ? 3 : at[0] < 0xf5 ? 4 : 0;
    unsigned char low = at[0] == 0xe0 ? 0xa0 : at[0] == 0xf0 ? 0x90 : 0x80;
    unsigned char high = at[0] == 0xed ? 0x9f : at[0] == 0xf4 ? 0x8f : 0xbf;
    if (length > 1 && (at[1] < low || at[1] > high))
        return 0;
    for (size_t i = 2; i < length; i++)
        if ((at[i] & 0xc0) != 0x80)
            return 0;
    return length;
}

/* Returns whether the first of a character's bytes begins a control character, or is a control character of its own in
 * encodings of one byte. */
static bool is_control(const char *at, size_t length)
{
    unsigned char first = (unsigned char)at[0], second = (unsigned char)at[1];
    return first < 0x20 || first == 0x7f || (length == 0 && first >= 0x80 && first < 0xa0) ||
           (length == 2 && first == 0xc2 && second < 0xa0);
}

void hatch_utf8_make_plain(char *text, size_t length)
{
    size_t bytes;
    for (size_t i = 0; i < length; i += bytes ? bytes : 1) {
        bytes = hatch_utf8_length(text + i);
        if (is_control(text + i, bytes))
            memset(text + i, '?', bytes ? bytes : 1);
    }
}

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
