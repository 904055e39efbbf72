/* Private to the mesh readers: words and numbers of a text that is not zero-terminated. Lines end with LF, CR LF or
 * CR. */
#ifndef HATCH_IO_MESH_TEXT_H
#define HATCH_IO_MESH_TEXT_H

#include "base/text.h"

struct hatch_mesh_text {
    const char *at, *end; /* at: the next character; end: after the last one */
    uint32_t line;        /* line that at is in, counted from 1 */
    bool continues;       /* a backslash at a line's end joins it with the next line (OBJ) */
    char comment;         /* begins a comment that runs to the line's end; 0: none */
};

/* Returns a reader at the start of a text, after the byte order mark if there is one. */
struct hatch_mesh_text hatch_mesh_text_of(struct hatch_bytes bytes);

/* Reads the next word of this line, up to white space; length 0 at the line's end. */
struct hatch_text hatch_mesh_text_word(struct hatch_mesh_text *text);

/* Moves to the start of the next line; false at the end of the text. */
bool hatch_mesh_text_next_line(struct hatch_mesh_text *text);

/* Reads the next word of this or a later line; length 0 at the end of the text. */
struct hatch_text hatch_mesh_text_any_word(struct hatch_mesh_text *text);

/* Returns the number of bytes not yet read. */
size_t hatch_mesh_text_remaining(const struct hatch_mesh_text *text);

/* Returns how much of a word a message quotes, for "%.*s". */
int hatch_mesh_text_shown(struct hatch_text word);

/* Returns whether a name has an extension, in either case. tolower would depend on the locale.
 *   extension  lower case, with its point */
bool hatch_mesh_has_extension(struct hatch_text name, const char *extension);

/* Parses an integer: digits with an optional sign, of a magnitude up to about 2^61. */
bool hatch_mesh_text_integer(struct hatch_text word, int64_t *number);

/* Reads the next word of the line as a finite float.
 *   what  name of the number, such as "vertex", for messages
 * HATCH_BAD_INPUT with the line. */
enum hatch_status hatch_mesh_text_float(struct hatch_mesh_text *text, const char *what, float *number,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* Reads up to `most` finite numbers, until the line's end or another word; returns how many. */
uint32_t hatch_mesh_text_floats(struct hatch_mesh_text *text, uint32_t most, float *numbers);

/* Reads the next three words of the line as a position.
 *   origin  subtracted in double precision
 * HATCH_BAD_INPUT with the line. */
enum hatch_status hatch_mesh_text_position(struct hatch_mesh_text *text, const char *what, const double origin[3],
                                           float position[3], struct hatch_err *err) HATCH_MUST_USE;

#endif
