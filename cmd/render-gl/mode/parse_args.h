/* Arguments of the command line that are more than a number. */
#ifndef RENDER_MODE_PARSE_ARGS_H
#define RENDER_MODE_PARSE_ARGS_H

#include "base/text.h"
#include "line/mesh.h"
#include "view/view.h"
#include "shared/cmd.h"

/* Parses a colour into linear light; dies on any other text as wrong usage of the option. */
void parse_color(const char *option, struct hatch_text text, float rgb[3]);

/* Parses a whole number up to `most`. Returns false for any other text. */
bool parse_whole(const char *text, uint32_t most, uint32_t *value);

/* Parses X,Y,Z[:X,Y,Z]: the eye, and the point that it looks at. Returns false for any other text. */
bool parse_camera_place(const char *text, struct hatch_view_choice *view);

/* Parses a list of kinds of lines with commas between; dies on any other word as wrong usage of --lines. Returns enum
 * hatch_line_kind, joined. */
uint32_t parse_line_kinds(const char *list);

/* Whether an output's name has one place for the number of a frame: %d, %3d or %03d. pattern: may be NULL. */
bool parse_has_frame(const char *pattern);

/* Writes the name of a frame's file: `pattern` with that place replaced by the number. size_bytes: of name. */
void parse_frame_name(const char *pattern, uint32_t number, char *name, size_t size_bytes);

#endif
