/* Private to the mesh readers: words and numbers of a text that need not end with a zero. */
#ifndef HATCH_IO_MESH_TEXT_H
#define HATCH_IO_MESH_TEXT_H

#include "base/text.h"

struct hatch_mesh_text {
    const char *at, *end;
    uint32_t line;  /* of at, from 1 */
    bool continues; /* a backslash before a line's end joins it with the next (OBJ) */
    char comment;   /* starts a comment that runs to the line's end; 0: none does */
};

/* As hatch_text_of: without a byte order mark. */
struct hatch_mesh_text hatch_mesh_text_of(struct hatch_bytes bytes);

/* The next word of this line: what stands between blanks. Length 0: the line has no further word. */
struct hatch_text hatch_mesh_text_word(struct hatch_mesh_text *text);

/* Goes to the start of the next line; false at the end of the text. */
bool hatch_mesh_text_next_line(struct hatch_mesh_text *text);

/* The next word, on this or a later line; length 0 at the end of the text. */
struct hatch_text hatch_mesh_text_any_word(struct hatch_mesh_text *text);

/* Bytes from the reading place to the end. */
size_t hatch_mesh_text_left(const struct hatch_mesh_text *text);

/* How much of a word a message shows: for "%.*s". */
int hatch_mesh_text_shown(struct hatch_text word);

/* Digits with an optional sign, below 2^62 in size. */
bool hatch_mesh_text_integer(struct hatch_text word, int64_t *number);

/* The next word of the line as a float, finite. what: "vertex"; HATCH_BAD_INPUT with the line. */
enum hatch_status hatch_mesh_text_float(struct hatch_mesh_text *text, const char *what, float *number,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* The same for the three numbers of a position, less origin, which is taken off before they become floats. */
enum hatch_status hatch_mesh_text_position(struct hatch_mesh_text *text, const char *what, const double origin[3],
                                           float position[3], struct hatch_err *err) HATCH_MUST_USE;

#endif
