/* Small text formats: lines, fields, strict numbers. Numbers are read in the C locale whatever the
 * process's locale is (no command calls setlocale). */
#ifndef HATCH_BASE_TEXT_H
#define HATCH_BASE_TEXT_H

#include <stdbool.h>

#include "base/bytes.h"

/* A piece of somebody else's text, not zero-terminated. */
struct hatch_text {
    const char *at;
    size_t length;
};

/* A file's text, without the byte order mark that some editors put before it. */
struct hatch_text hatch_text_of(struct hatch_bytes file);

/* Takes the next line off *rest, without its LF or CR LF; false at the end. */
bool hatch_text_line(struct hatch_text *rest, struct hatch_text *line);

/* Takes the next word (between spaces and tabs) off *rest; false when there is none. */
bool hatch_text_word(struct hatch_text *rest, struct hatch_text *word);

/* Takes the next field up to a tab off *rest, empty ones too; false at the end of the line. */
bool hatch_text_field(struct hatch_text *rest, struct hatch_text *field);

/* Whether the text is that word, to the letter. */
bool hatch_text_is(struct hatch_text text, const char *word);

/* Whether the text is that word but for one slip at most: a letter more, less or other, or two that changed places. */
bool hatch_text_is_near(struct hatch_text text, const char *word);

/* The whole text as one decimal number ("1", "-0.5", "1e-3"; no hex, no "inf", no spaces), infinite where
 * it is too large. Rounded as strtod does; digits after the nineteenth may be lost. */
bool hatch_text_decimal(struct hatch_text text, double *number);

/* The same, and finite. */
bool hatch_text_number(struct hatch_text text, double *number);

/* Parses three finite numbers with commas between, as in "0,1.5,2". Returns false for any other text. */
bool hatch_text_vector(struct hatch_text text, double xyz[3]);

#endif
