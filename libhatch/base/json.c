#include "base/json.h"

enum hatch_status hatch_json_add_string(struct hatch_buffer *buffer, const char *text, struct hatch_err *err)
{
    HATCH_TRY(hatch_buffer_add(buffer, "\"", 1, err));
    while (*text) {
        unsigned char c = (unsigned char)*text;
        size_t length = hatch_utf8_length(text);
        if (length == 0)
            HATCH_TRY(hatch_buffer_print(buffer, err, "\xef\xbf\xbd"));
        else if (c < 0x20 || c == 0x7f)
            HATCH_TRY(hatch_buffer_print(buffer, err, "\\u%04x", (unsigned)c));
        else if (c == '"' || c == '\\')
            HATCH_TRY(hatch_buffer_print(buffer, err, "\\%c", c));
        else
            HATCH_TRY(hatch_buffer_add(buffer, text, length, err));
        text += length ? length : 1;
    }
    return hatch_buffer_add(buffer, "\"", 1, err);
}
