/* hatchstat frames A B ...: measures flicker in a sequence of pictures; the report has one row per picture. */
#include <math.h>
#include <string.h>

#include "filter/difference.h"
#include "subject.h"

#define POP_BOX_PX 8u
#define HELD 3 /* number of pictures in memory at once */

static const char *const columns[] = {"frame", "mean", "drift", "change", "pop", "pop_box8", NULL};

/* Measurements of a frame. change is the mean difference from the previous frame. pop and pop_low measure the second
 * difference with both neighbours: its mean absolute value, and its largest mean over a box. They are NaN where a frame
 * that they need is missing. */
struct figures {
    double mean, change, pop, pop_low;
};

/* A sequence of pictures, of which HELD are in memory at once. */
struct sequence {
    struct cmd_args *args;
    bool srgb;
    bool wide;                /* pictures are converted to RGBA: not all have the same channels */
    struct hatch_image piped; /* that of standard input, which cannot be read again, in RGBA; zeroed: not read */
    struct hatch_arena arenas[HELD];
    struct hatch_image images[HELD];
};

static void read_one(struct sequence *sequence, const char *path, struct hatch_arena *arena, struct hatch_image *image)
{
    struct cmd_args *args = sequence->args;
    bool piped = strcmp(path, "-") == 0;
    if (piped && sequence->piped.pixels) {
        *image = sequence->piped;
        return;
    }
    stat_read_picture(args, path, sequence->srgb, arena, image);
    if (piped) {
        sequence->piped = *image;
        stat_widen(&args->keep, &sequence->piped);
    }
    if (sequence->wide)
        stat_widen(arena, image);
}

/* Reads the picture at an index. Returns false if it has other channels than the one before. */
static bool load(struct sequence *sequence, int index)
{
    struct hatch_arena *arena = &sequence->arenas[index % HELD];
    struct hatch_image *image = &sequence->images[index % HELD];
    const struct hatch_image *previous = &sequence->images[(index + HELD - 1) % HELD];
    const char *path = sequence->args->operands[1 + index];
    struct hatch_err err;
    hatch_arena_free(arena);
    hatch_arena_init(arena, sequence->args->max_memory);
    read_one(sequence, path, arena, image);
    if (index == 0)
        return true;
    if (image->width != previous->width || image->height != previous->height) {
        hatch_fail(&err, HATCH_BAD_INPUT, "%ux%u pixels, the previous frame has %ux%u", image->width, image->height,
                   previous->width, previous->height);
        cmd_die(cmd_input_name(path), &err);
    }
    return image->channel_count == previous->channel_count;
}

/* Measures the pictures up to the first one that has other channels than the one before. Returns false if there is one.
 */
static bool measure(struct sequence *sequence, int count, struct figures *figures)
{
    struct hatch_err err;
    bool alike = true;
    for (int i = 0; i < count && (alike = load(sequence, i)); i++) {
        struct hatch_image *images = sequence->images, *image = &images[i % HELD];
        struct hatch_difference difference;
        figures[i] = (struct figures){hatch_image_mean(image), NAN, NAN, NAN};
        struct hatch_image *previous = &images[(i + HELD - 1) % HELD];
        if (i >= 1) {
            hatch_image_difference(previous, image, &difference);
            figures[i].change = difference.mean;
        }
        if (i >= 2) { /* the second difference is written over the oldest frame, which is not needed again */
            struct hatch_image *oldest = &images[(i + HELD - 2) % HELD];
            struct figures *middle = &figures[i - 1];
            middle->pop = hatch_image_second_difference(oldest, previous, image, oldest);
            cmd_check(
                hatch_image_low_difference(oldest, NULL, POP_BOX_PX, &sequence->args->scratch, &middle->pop_low, &err),
                NULL, &err);
        }
        cmd_progress("frames", (double)(i + 1) / count);
    }
    for (int i = 0; i < HELD; i++)
        hatch_arena_free(&sequence->arenas[i]);
    return alike;
}

static void put_row(struct cmd_report *report, const char *name, const struct figures *figures, double drift)
{
    const double numbers[] = {figures->mean, drift, figures->change, figures->pop, figures->pop_low};
    cmd_report_text(report, name);
    cmd_report_numbers(report, numbers, sizeof numbers / sizeof *numbers);
}

/* Adds the last row: means over the frames that have a value, but maxima for drift and pop_box8. */
static void put_summary(struct cmd_report *report, const struct figures *figures, int count)
{
    const double none = count > 2 ? 0 : NAN; /* two pictures have no second difference */
    struct figures all = {.pop = none, .pop_low = none};
    double drift = 0;
    for (int i = 0; i < count; i++) {
        all.mean += figures[i].mean / count;
        drift = fmax(drift, fabs(figures[i].mean - figures[0].mean));
        all.change += i >= 1 ? figures[i].change / (count - 1) : 0;
        all.pop += i >= 1 && i + 1 < count ? figures[i].pop / (count - 2) : 0;
        all.pop_low = fmax(all.pop_low, figures[i].pop_low);
    }
    put_row(report, "all", &all, drift);
}

/* Standard input is read once, and kept for a second pass: only here does a second name of it not fail by itself. */
static void refuse_two_pipes(const struct cmd_args *args)
{
    int piped = 0;
    for (int i = 1; i < args->operand_count; i++)
        piped += strcmp(args->operands[i], "-") == 0;
    if (piped > 1)
        cmd_usage("two inputs come from standard input");
}

enum hatch_status stat_frames(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output)
{
    int count = args->operand_count - 1;
    struct hatch_err err;
    struct figures *figures;
    refuse_two_pipes(args);
    cmd_check(HATCH_ALLOC(&args->keep, &figures, (size_t)count, &err), NULL, &err);
    struct sequence sequence = {.args = args, .srgb = options->srgb};
    if (!measure(&sequence, count, figures)) {
        sequence.wide = true;
        measure(&sequence, count, figures);
    }
    struct cmd_report report;
    cmd_report_begin(&report, args, columns);
    for (int i = 0; i < count; i++)
        put_row(&report, cmd_input_name(args->operands[1 + i]), &figures[i], figures[i].mean - figures[0].mean);
    put_summary(&report, figures, count);
    cmd_report_write(&report, output);
    return HATCH_OK;
}
