/* Writing of JSON. */
#ifndef HATCH_BASE_JSON_H
#define HATCH_BASE_JSON_H

#include "base/bytes.h"

/* Appends a text as a JSON string with its quotes. The result is valid JSON and UTF-8 for any bytes: quotes,
 * backslashes and control characters are escaped, and each byte that does not belong to a UTF-8 character becomes
 * U+FFFD, the replacement character. */
enum hatch_status hatch_json_add_string(struct hatch_buffer *buffer, const char *text,
                                        struct hatch_err *err) HATCH_MUST_USE;

#endif
