/* Parsers for arguments that are not plain numbers. */
#ifndef RENDER_MODE_PARSE_ARGS_H
#define RENDER_MODE_PARSE_ARGS_H

#include "base/text.h"
#include "line/mesh.h"
#include "view/view.h"
#include "shared/cmd.h"

/* Parses a colour name or #rrggbb. Exits with a usage message if the text is neither.
 *   option  name of the option, for the message
 *   rgb     out: linear light */
void parse_color(const char *option, struct hatch_text text, float rgb[3]);

/* Parses an integer from 0 to `most`. Returns false for any other text. */
bool parse_whole(const char *text, uint32_t most, uint32_t *value);

/* Parses X,Y,Z[:X,Y,Z]: the camera's position and the point that it looks at. Returns false for any other text. */
bool parse_camera_place(const char *text, struct hatch_view_choice *view);

/* Words of --lines, NULL at the end. */
extern const char *const line_kind_names[];

/* Parses the comma-separated list of --lines. Returns bits of enum hatch_line_kind. Exits with a usage message on an
 * unknown word. */
uint32_t parse_line_kinds(const char *list);

/* Parses a length in millimetres, with or without the unit "mm". Exits with a usage message if it is not from least to
 * most.
 *   option  name of the option, for the message */
double parse_length(const char *option, const char *text, double least, double most);

/* Returns whether a file name has an ending, in small or capital letters.
 *   path    may be NULL
 *   ending  small letters, without the dot */
bool parse_has_ending(const char *path, const char *ending);

/* Returns whether a file name has exactly one field for the frame number, such as %d, %3d or %03d. Beside a field, two
 * percent signs stand for one.
 *   pattern  the file name; NULL: the result is false */
bool parse_has_frame(const char *pattern);

/* Writes the file name of a frame: `pattern` with its field, if any, replaced by the number.
 *   size_bytes  size of name; a longer name is truncated */
void parse_frame_name(const char *pattern, uint32_t number, char *name, size_t size_bytes);

#endif
