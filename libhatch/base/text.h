/* Parsing of small text formats: lines, fields, words and numbers, in the C locale (no command calls setlocale). */
#ifndef HATCH_BASE_TEXT_H
#define HATCH_BASE_TEXT_H

#include <stdbool.h>

#include "base/bytes.h"

/* A part of a text, without a terminating zero. The caller owns the text. */
struct hatch_text {
    const char *at;
    size_t length;
};

/* Returns a file's text, without the UTF-8 byte order mark that may precede it. */
struct hatch_text hatch_text_of(struct hatch_bytes file);

/* Removes the next line from *rest and returns it in *line, without its LF or CR LF; returns false at the end of the
 * text. */
bool hatch_text_line(struct hatch_text *rest, struct hatch_text *line);

/* Removes the next word from *rest; words are separated by spaces and tabs. Returns false where there is none. */
bool hatch_text_word(struct hatch_text *rest, struct hatch_text *word);

/* Removes the next field, which may be empty, from *rest; fields are separated by tabs. Returns false at the end of the
 * line. */
bool hatch_text_field(struct hatch_text *rest, struct hatch_text *field);

/* Returns whether the text equals a word. */
bool hatch_text_is(struct hatch_text text, const char *word);

/* Returns whether the text equals a word except for at most one typing error: a letter added, missing or wrong, or two
 * adjacent letters exchanged. */
bool hatch_text_is_near(struct hatch_text text, const char *word);

/* Parses the whole text as a decimal number ("1", "-0.5", "1e-3"; no hexadecimal, "inf" or spaces); returns false for
 * any other text. Rounds as strtod does, but digits after the nineteenth may be ignored.
 *   number  out: infinite where the number is too large for a double */
bool hatch_text_decimal(struct hatch_text text, double *number);

/* Parses a decimal number as hatch_text_decimal does, but returns false where it is infinite, too. */
bool hatch_text_number(struct hatch_text text, double *number);

/* Parses three finite numbers separated by commas, as in "0,1.5,2"; returns false for any other text. */
bool hatch_text_vector(struct hatch_text text, double xyz[3]);

#endif
