/* Follows the strokes of a film by their ids:
 *     bench_stroke_ids NAME OPTION ...   as render-gl, for several frames with --technique strokes
 * A sighting is a run of frames in which a stroke is in sight. It is short if it lasts less than three frames, none of
 * them the first or the last of the film. Standard output gets a row: NAME, frames, strokes per frame, sightings, short
 * ones of strokes with at least SEEN pixels of ink, how many of these show less than PART of their length, and short
 * ones of strokes with less ink. Each frame is drawn again with --aggregate blend; the last columns are the number of
 * strokes that then wait for a slot in all frames but the first, and the most frames for which one waits. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "render-gl/gpu/buffer.h"
#include "render-gl/mode/modes.h"
#include "render-gl/technique/strokes/strokes.h"

#define MOST (1u << 20)
#define SEEN 4.0
#define PART 0.25

static struct job job;
static struct hatch_err err;

/* A stroke: its last sighting, and for how many frames it has been waiting. */
struct sighting {
    uint32_t id[2];
    int first, last;
    double ink, t[2]; /* most ink of a frame, in pixels; least and greatest t */
    uint32_t waiting;
};

/* Strokes of a frame, by id. */
struct strokes {
    uint32_t count;
    struct strokes_slot *slots;
    uint32_t (*words)[2]; /* their fragments */
};

static struct sighting all[MOST];
static uint32_t known;
static struct {
    uint32_t shown, sightings, few, parts, faint, waited, longest;
} sums;

static int compare(const void *a, const void *b)
{
    return memcmp(a, b, sizeof all->id);
}

/* Counts a sighting that has ended. */
static void end_sighting(const struct sighting *sighting)
{
    sums.sightings++;
    if (sighting->first == 0 || sighting->last + 1 == (int)job.options->frames || sighting->last - sighting->first > 1)
        return;
    sums.faint += sighting->ink < SEEN;
    sums.few += sighting->ink >= SEEN;
    sums.parts += sighting->ink >= SEEN && sighting->t[1] - sighting->t[0] < PART;
}

/* Notes that a stroke is in sight.
 *   before  number of strokes known before this frame
 *   words   the fragments of all strokes
 * Returns what is known of it. */
static struct sighting *note(int frame, uint32_t before, const struct strokes_slot *slot, uint32_t (*words)[2])
{
    struct sighting *sighting = bsearch(slot->id, all, before, sizeof *all, compare);
    const struct sighting begun = {{slot->id[0], slot->id[1]}, frame, frame, 0, {1, 0}, 0};
    double ink = 0;
    if (!sighting) {
        if (known == MOST)
            cmd_usage("more than %u strokes: draw fewer frames", MOST);
        sighting = &all[known++];
        *sighting = begun;
    } else if (sighting->last + 1 < frame) {
        end_sighting(sighting);
        *sighting = begun;
    }
    sighting->last = frame;
    for (uint32_t i = slot->first; i < slot->first + slot->count; i++) {
        const double t = (words[i][1] & 0xffff) / 65535.0;
        ink += (words[i][1] >> 16) / 65535.0;
        sighting->t[0] = fmin(sighting->t[0], t);
        sighting->t[1] = fmax(sighting->t[1], t);
    }
    sighting->ink = fmax(sighting->ink, ink);
    return sighting;
}

static void draw(const struct picture *picture, const struct hatch_view *view, const struct canvas *canvas, int blends,
                 struct hatch_image *image)
{
    for (const struct cmd_option *row = picture->instance->technique->options; row->name; row++)
        if (strcmp(row->name, "aggregate") == 0)
            *(int *)row->value = blends;
    cmd_check(technique_prepare(picture->context, picture->instance, &err), NULL, &err);
    cmd_check(picture_draw(picture, view, canvas, image, &err), NULL, &err);
}

/* Reads the strokes of a frame that was drawn by sorting, as they were before any were divided. */
static void read_sorted(const struct strokes_state *state, struct strokes *strokes)
{
    uint32_t total = 0;
    *strokes = (struct strokes){.slots = malloc(sizeof *strokes->slots * state->slot_count)};
    gpu_buffer_read(state->table.name, strokes->slots, sizeof *strokes->slots * state->slot_count);
    for (uint32_t i = 0; i < state->slot_count; i++)
        if (strokes->slots[i].count > 0 && strokes->slots[i].first != UINT32_MAX) {
            total += strokes->slots[i].count;
            strokes->slots[strokes->count++] = strokes->slots[i];
        }
    strokes->words = malloc(sizeof *strokes->words * (total + 1));
    gpu_buffer_read(state->sorted.name, strokes->words, sizeof *strokes->words * total);
}

/* Notes the strokes of a frame.
 *   blended  those that were drawn by blending, sorted by id */
static void note_all(int frame, const struct strokes *strokes, const struct strokes *blended)
{
    const uint32_t before = known;
    sums.shown += strokes->count;
    for (uint32_t i = 0; i < strokes->count; i++) {
        struct sighting *sighting = note(frame, before, &strokes->slots[i], strokes->words);
        bool drawn = bsearch(sighting->id, blended->slots, blended->count, sizeof *blended->slots, compare);
        sighting->waiting = drawn ? 0 : sighting->waiting + 1;
        sums.waited += !drawn && frame > 0;
        sums.longest = sighting->waiting > sums.longest ? sighting->waiting : sums.longest;
    }
    qsort(all, known, sizeof *all, compare);
}

int main(int argc, char **argv)
{
    struct strokes strokes, blended;
    struct canvas canvas;
    struct hatch_image image;
    const char *name = argc > 1 ? argv[1] : "";
    job.options = options_read(argc - (argc > 1), argv + (argc > 1), &job.args);
    params_read(job.options);
    job_read(&job);
    job_prepare(&job);
    job_make_canvas(&job, &canvas);
    cmd_check(hatch_image_make(&job.args.keep, job.options->width, job.options->height, "RGB", &image, &err), NULL,
              &err);
    const struct picture picture = job_picture(&job, job_use(&job, job.options->technique));
    const struct strokes_state *state = picture.instance->state;
    for (uint32_t frame = 0; frame < job.options->frames; frame++) {
        struct hatch_view view;
        job_set_frame(&job, frame, &view);
        draw(&picture, &view, &canvas, 0, &image);
        read_sorted(state, &strokes);
        draw(&picture, &view, &canvas, 1, &image);
        blended = (struct strokes){.count = state->found_count,
                                   .slots = malloc(sizeof *blended.slots * (state->found_count + 1))};
        gpu_buffer_read(state->found.name, blended.slots, sizeof *blended.slots * blended.count);
        qsort(blended.slots, blended.count, sizeof *blended.slots, compare);
        note_all((int)frame, &strokes, &blended);
        free(blended.slots);
        free(strokes.slots);
        free(strokes.words);
    }
    for (uint32_t i = 0; i < known; i++)
        end_sighting(&all[i]);
    printf("%s\t%u\t%u\t%u\t%u\t%u\t%u\t%u\t%u\n", name, job.options->frames, sums.shown / job.options->frames,
           sums.sightings, sums.few, sums.parts, sums.faint, sums.waited, sums.longest);
    canvas_free(&canvas);
    job_end(&job);
    return cmd_end(&job.args, HATCH_OK);
}
