/* Parsing of styles and similar text files: one "key value ..." per line, '#' begins a comment. */
#ifndef HATCH_BASE_SETTINGS_H
#define HATCH_BASE_SETTINGS_H

#include "base/text.h"

#define HATCH_SETTINGS_SHOWN_MAX 40u /* characters of a wrong word in a message */

/* Returns how many characters of a word a message shows. */
static inline int hatch_settings_shown(struct hatch_text word)
{
    return (int)(word.length < HATCH_SETTINGS_SHOWN_MAX ? word.length : HATCH_SETTINGS_SHOWN_MAX);
}

/* Removes the next line from *rest and returns it in *line, without its comment; returns false at the end of the
 * text. */
bool hatch_settings_line(struct hatch_text *rest, struct hatch_text *line);

/* Parses a number.
 *   key  names the value in messages
 * HATCH_BAD_INPUT when the word is no number or is out of range. */
enum hatch_status hatch_settings_number(struct hatch_text word, const char *key, double low, double high, double *value,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* Removes the next word from *rest and parses it as hatch_settings_number does.
 * HATCH_BAD_INPUT when it is missing, too. */
enum hatch_status hatch_settings_next(struct hatch_text *rest, const char *key, double low, double high, double *value,
                                      struct hatch_err *err) HATCH_MUST_USE;

#endif
