/* Words of the command line that are more than a number. */
#ifndef RENDER_WORDS_H
#define RENDER_WORDS_H

#include "base/text.h"
#include "shared/cmd.h"
#include "render-gl/lines/lines.h"
#include "scene/view.h"

/* A colour; another word is wrong usage of the option. */
void words_color(const char *option, struct hatch_text text, float rgb[3]);

/* A whole number up to `most`. */
bool words_whole(const char *text, uint32_t most, uint32_t *value);

/* X,Y,Z[:X,Y,Z]: the eye, and what it looks at. */
bool words_place(const char *text, struct hatch_view_choice *view);

/* A list of kinds of lines with commas between; another word is wrong usage. */
uint32_t words_line_kinds(const char *list);

/* Has an output's name one place for the number of a frame: %d, %3d or %03d? pattern may be NULL. */
bool words_have_place(const char *pattern);

/* The name of a frame's file: `pattern` with that place replaced by the number. */
void words_frame_name(const char *pattern, uint32_t number, char *name, size_t size);

#endif
