/* A drawing style by name, as every command takes it: its text, changes to it, and its brush. A
 * command that uses this links the packages exr, png and foreign. */
#ifndef HATCH_CMD_STYLE_H
#define HATCH_CMD_STYLE_H

#include "shared/cmd.h"
#include "placement/style.h"

/* name: a style that comes with the commands ("pencil"), or else a file; with a slash or a dot in
 * it always a file; "-" is standard input. settings: style lines that go last, with ';' for the
 * ends of lines, or NULL. brush_path: an image that replaces the style's brush, or NULL. The style
 * is called after its file where it does not say its name. The brush lives in args->keep. Dies on
 * failure; a style that is nowhere and settings that are wrong are wrong usage. */
void cmd_read_style(struct cmd_args *args, const char *name, const char *settings, const char *brush_path,
                    struct hatch_style *style, struct hatch_brush *brush);

/* The colours of a palette, by name or file as a style is, in place of the style's own: a file of "color"
 * lines, or any style that has some. */
void cmd_read_palette(struct cmd_args *args, const char *name, struct hatch_style *style);

/* A file that another one names: beside it, unless the name begins at the root. */
const char *cmd_beside(struct cmd_args *args, const char *path, const char *name);

/* A brush from a picture, in args->keep. Dies on failure. */
void cmd_read_brush(struct cmd_args *args, const char *path, struct hatch_brush *brush);

/* Whether a style of that name comes with the commands. A path is no such name, so that what a file says
 * of its style opens no other file. */
bool cmd_has_style(struct cmd_args *args, const char *name);

#endif
