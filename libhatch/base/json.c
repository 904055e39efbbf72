#include "base/json.h"

/* Returns the length of the UTF-8 character at the start of a text: 1 to 4; 0 if the text begins with no character.
 * Overlong forms, surrogates and numbers over 0x10ffff are none (RFC 3629, section 4). */
static size_t character_length(const unsigned char *at)
{
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

enum hatch_status hatch_json_add_string(struct hatch_buffer *buffer, const char *text, struct hatch_err *err)
{
    HATCH_TRY(hatch_buffer_add(buffer, "\"", 1, err));
    while (*text) {
        unsigned char c = (unsigned char)*text;
        size_t length = character_length((const unsigned char *)text);
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
