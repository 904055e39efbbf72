/* The subjects of hatchstat, that is, the kinds of things that it measures. Each has its own file and a line in
 * main.c's table. */
#ifndef HATCHSTAT_SUBJECT_H
#define HATCHSTAT_SUBJECT_H

#include "shared/cmd.h"
#include "shared/report.h"
#include "image/image.h"

/* Options. Each comment begins with the subjects that use the option. */
struct stat_options {
    double max_difference;               /* diff: negative when not given */
    bool srgb;                           /* diff, frames, ink: measure sRGB values, not linear light */
    const char *strokes, *style, *brush; /* tam: options that describe the strokes; NULL when not given */
    struct cmd_texts settings;           /* tam: the same */
    int64_t throws;                      /* tam, seeds: random drawings or sets to compare with */
    bool check;                          /* tam, lapped, seeds: return HATCH_DIFFERS when a limit is exceeded */
    const char *reference;               /* field, tones, ink, solid: NULL when not given */
    const char *patches;                 /* ink: NULL when not given */
    double share;                        /* field: share of the compared points that counts, the most confident first */
    double size_px[2];                   /* coarse: of the pictures */
    int64_t samples;                     /* lapped: number of samples; tones: number per level of detail */
};

/* Measures the operands after the subject's name and writes the report. Returns HATCH_OK, or HATCH_DIFFERS when a limit
 * is exceeded. */
typedef enum hatch_status (*stat_measure)(struct cmd_args *args, const struct stat_options *options,
                                          struct cmd_output *output);

enum hatch_status stat_coarse(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output);
enum hatch_status stat_diff(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output);
enum hatch_status stat_frames(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output);
enum hatch_status stat_field(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output);
enum hatch_status stat_ink(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output);
enum hatch_status stat_lapped(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output);
enum hatch_status stat_mesh(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output);
enum hatch_status stat_seeds(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output);
enum hatch_status stat_solid(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output);
enum hatch_status stat_tam(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output);
enum hatch_status stat_tones(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output);

/* Reads a picture of any format. Numbers that are not finite become 0, with a warning. Ends the process on failure.
 *   srgb   true: encode the colours as sRGB; false: keep linear light
 *   arena  for the pixels; NULL: args->keep */
void stat_read_picture(struct cmd_args *args, const char *path, bool srgb, struct hatch_arena *arena,
                       struct hatch_image *image);

/* The same, but numbers that are not finite become NaN; the pixels are in args->keep. */
void stat_read_picture_as_is(struct cmd_args *args, const char *path, bool srgb, struct hatch_image *image);

/* Converts an image to RGBA, in arena: grey becomes equal red, green and blue, and a missing alpha becomes 1. */
void stat_widen(struct hatch_arena *arena, struct hatch_image *image);

/* Converts both images to RGBA when their channels differ. Ends the process when their sizes differ.
 *   path  path of image, for messages */
void stat_make_alike(struct hatch_arena *arena, const char *path, struct hatch_image *first, struct hatch_image *image);

#endif
