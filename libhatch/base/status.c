#include "base/status.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static void make_printable(char *text)
{
    for (; *text; text++) {
        unsigned char c = (unsigned char)*text;
        if (c < 0x20 || c == 0x7f)
            *text = '?';
    }
}

enum hatch_status hatch_fail(struct hatch_err *err, enum hatch_status status, const char *format, ...)
{
    if (err) {
        va_list args;
        va_start(args, format);
        vsnprintf(err->text, sizeof err->text, format, args);
        va_end(args);
        make_printable(err->text);
        err->status = status;
    }
    return status;
}

enum hatch_status hatch_fail_at(struct hatch_err *err, const char *format, ...)
{
    char joined[sizeof err->text];
    va_list args;
    va_start(args, format);
    vsnprintf(joined, sizeof joined, format, args);
    va_end(args);
    make_printable(joined);
    size_t used = strlen(joined);
    snprintf(joined + used, sizeof joined - used, "%s", err->text);
    memcpy(err->text, joined, sizeof joined);
    return err->status;
}
