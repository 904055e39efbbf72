/* hatchstat frames A B ...: measures flicker in a sequence of pictures; the report has one row per picture. */
#include <math.h>

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

struct ring {
    struct hatch_arena arenas[HELD];
    struct hatch_image images[HELD];
};

static struct hatch_image *load(struct cmd_args *args, int index, bool srgb, struct ring *ring)
{
    struct hatch_arena *arena = &ring->arenas[index % HELD];
    struct hatch_image *image = &ring->images[index % HELD];
    const char *path = args->operands[1 + index];
    hatch_arena_free(arena);
    hatch_arena_init(arena, args->max_memory);
    stat_read_picture(args, path, srgb, arena, image);
    const struct hatch_image *previous = &ring->images[(index + HELD - 1) % HELD];
    struct hatch_err err;
    if (index > 0 && (image->width != previous->width || image->height != previous->height ||
                      image->channel_count != previous->channel_count)) {
        hatch_fail(&err, HATCH_BAD_INPUT, "%ux%u pixels of %u channels, the previous frame has %ux%u of %u",
                   image->width, image->height, image->channel_count, previous->width, previous->height,
                   previous->channel_count);
        cmd_die(cmd_input_name(path), &err);
    }
    return image;
}

static void measure(struct cmd_args *args, bool srgb, int count, struct figures *figures)
{
    struct ring ring = {0};
    struct hatch_err err;
    for (int i = 0; i < count; i++) {
        struct hatch_image *image = load(args, i, srgb, &ring);
        struct hatch_difference difference;
        figures[i] = (struct figures){hatch_image_mean(image), NAN, NAN, NAN};
        struct hatch_image *previous = &ring.images[(i + HELD - 1) % HELD];
        if (i >= 1) {
            hatch_image_difference(previous, image, &difference);
            figures[i].change = difference.mean;
        }
        if (i >= 2) { /* the second difference is written over the oldest frame, which is not needed again */
            struct hatch_image *oldest = &ring.images[(i + HELD - 2) % HELD];
            struct figures *middle = &figures[i - 1];
            middle->pop = hatch_image_second_difference(oldest, previous, image, oldest);
            cmd_check(hatch_image_low_difference(oldest, NULL, POP_BOX_PX, &args->scratch, &middle->pop_low, &err),
                      NULL, &err);
        }
        cmd_progress("frames", (double)(i + 1) / count);
    }
    for (int i = 0; i < HELD; i++)
        hatch_arena_free(&ring.arenas[i]);
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

enum hatch_status stat_frames(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output)
{
    int count = args->operand_count - 1;
    struct hatch_err err;
    struct figures *figures;
    cmd_check(HATCH_ALLOC(&args->keep, &figures, (size_t)count, &err), NULL, &err);
    measure(args, options->srgb, count, figures);
    struct cmd_report report;
    cmd_report_begin(&report, args, columns);
    for (int i = 0; i < count; i++)
        put_row(&report, cmd_input_name(args->operands[1 + i]), &figures[i], figures[i].mean - figures[0].mean);
    put_summary(&report, figures, count);
    cmd_report_write(&report, output);
    return HATCH_OK;
}
