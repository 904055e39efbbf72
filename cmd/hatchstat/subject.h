/* What hatchstat measures: one file of this folder each, one line in main.c's table. */
#ifndef HATCHSTAT_SUBJECT_H
#define HATCHSTAT_SUBJECT_H

#include "shared/cmd.h"
#include "shared/report.h"
#include "image/image.h"

/* The options of all subjects; each looks at its own. */
struct stat_options {
    double max_difference;                          /* diff: negative when not given */
    bool srgb;                                      /* diff, frames, ink: sRGB numbers in place of linear light */
    const char *strokes, *style, *settings, *brush; /* tam: of its strokes; NULL when not given */
    int64_t throws;                                 /* tam, seeds: how many random drawings to compare with */
    bool check;                                     /* tam, lapped, seeds: what must hold decides the exit status */
    const char *reference;                          /* field, tones, ink: NULL when not given */
    double share;                                   /* field: of the reference's points, the most confident first */
    int64_t samples;                                /* lapped: for coverage; tones: of each level */
};

/* Measures the operands after the subject's name and writes the report. Returns HATCH_OK, or
 * HATCH_DIFFERS when a limit that the user gave is passed. */
typedef enum hatch_status (*stat_measure)(struct cmd_args *args, const struct stat_options *options,
                                          struct cmd_output *output);

enum hatch_status stat_diff(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output);
enum hatch_status stat_frames(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output);
enum hatch_status stat_field(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output);
enum hatch_status stat_ink(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output);
enum hatch_status stat_lapped(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output);
enum hatch_status stat_mesh(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output);

enum hatch_status stat_seeds(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output);
enum hatch_status stat_tam(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output);
enum hatch_status stat_tones(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output);

/* Reads a picture of any format; dies on failure. Warns when pixels are not finite. srgb: its
 * colours as sRGB numbers. Memory: args->keep, or arena where it is not NULL. */
void stat_read_picture(struct cmd_args *args, const char *path, bool srgb, struct hatch_arena *arena,
                       struct hatch_image *image);

/* Dies when path's image has not the size of the first; where their channels differ, both become
 * RGBA in arena: grey is equal red, green and blue, and no alpha is 1. */
void stat_make_alike(struct hatch_arena *arena, const char *path, struct hatch_image *first, struct hatch_image *image);

#endif
