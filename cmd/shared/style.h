/* Drawing styles as input of a command: a style's file, changes to it, and its brush. A command that uses this links
 * the packages exr, png and foreign. */
#ifndef SHARED_STYLE_H
#define SHARED_STYLE_H

#include "shared/cmd.h"
#include "placement/style.h"

/* Reads a style and its brush. A style without a name line is named after its file. Dies on failure; an unknown style
 * and wrong settings are wrong usage.
 *   name        an installed style, such as "pencil", or the path of a file; a name with a slash or a dot is always a
 *               path; "-" is standard input
 *   settings    values of --set: style lines that follow those of the file; NULL: none
 *   brush_path  an image that replaces the brush of the style; NULL: none
 *   brush       out, in args->keep */
void cmd_read_style(struct cmd_args *args, const char *name, const struct cmd_texts *settings, const char *brush_path,
                    struct hatch_style *style, struct hatch_brush *brush);

/* Replaces the colours of a style by those of a palette, a file with "color" lines. Dies on failure.
 *   name  as for cmd_read_style */
void cmd_read_palette(struct cmd_args *args, const char *name, struct hatch_style *style);

/* Returns the path of a style or a similar file. Installed ones take precedence over files of the same name, so that
 * the content of a folder cannot change the meaning of "ink". Dies for an unknown name, which is wrong usage.
 *   name  as for cmd_read_style
 *   kind  "style", "palette" or "solid": what it is, and the ending of installed ones */
const char *cmd_find_style(struct cmd_args *args, const char *name, const char *kind);

/* Names a style after its file, without folders and ending; "custom" if that is empty.
 *   name  out */
void cmd_name_style(const char *path, char name[HATCH_NAME_MAX]);

/* Returns the values of --set, style lines that are separated by ';', as a text of lines, in args->keep. */
struct hatch_bytes cmd_split_settings(struct cmd_args *args, const struct cmd_texts *settings);

/* Returns the path of a file that another file names: an absolute name is returned as it is, a relative one is taken
 * from the folder of the other file. The path may be in args->keep.
 *   path  path of the other file */
const char *cmd_path_beside(struct cmd_args *args, const char *path, const char *name);

/* Reads a brush from a picture into args->keep. Dies on failure. */
void cmd_read_brush(struct cmd_args *args, const char *path, struct hatch_brush *brush);

/* Returns whether a style of that name is installed; false for paths. A style name stored in a file therefore cannot
 * make a command open other files. */
bool cmd_has_style(struct cmd_args *args, const char *name);

#endif
