/* Lists the strokes of the frames of a film:
 *     bench_stroke_ids WHAT OPTION ...   options as render-gl, for several frames with --technique strokes
 * Standard output has a row for each stroke in sight of each frame: the frame's index from 0, the stroke's id and its
 * ink in pixels. If WHAT is `drawn`, two columns more tell whether it is drawn, and whether it waits for a slot with
 * --aggregate blend, with which each frame is drawn again. Of strokes that are in sight on a patch that they do not
 * belong to, the third column is `patch`. tests/bench/fit/stroke_ids.awk follows the ids. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "render-gl/gpu/buffer.h"
#include "render-gl/mode/modes.h"
#include "render-gl/technique/strokes/strokes.h"

static struct job job;
static struct hatch_err err;

/* Strokes of a frame, by id. */
struct strokes {
    uint32_t count;
    struct strokes_slot *slots;
    uint32_t (*words)[2]; /* their fragments */
};

/* Ids of the strokes that are drawn in a frame, in ascending order. */
struct drawn {
    uint32_t count;
    uint64_t *ids;
};

static int compare_ids(const void *a, const void *b)
{
    const uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

static bool has(const struct drawn *drawn, uint64_t id)
{
    return bsearch(&id, drawn->ids, drawn->count, sizeof id, compare_ids);
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

/* Reads the strokes of a frame that was drawn by sorting, as they were before any were divided. Prints those that
 * belong to no patch. */
static void read_sorted(uint32_t frame, const struct strokes_state *state, struct strokes *strokes)
{
    uint32_t total = 0;
    *strokes = (struct strokes){.slots = malloc(sizeof *strokes->slots * state->slot_count)};
    gpu_buffer_read(state->table.name, strokes->slots, sizeof *strokes->slots * state->slot_count);
    for (uint32_t i = 0; i < state->slot_count; i++)
        if (strokes->slots[i].count > 0 && strokes->slots[i].first == UINT32_MAX)
            printf("%u\t%016" PRIx64 "\tpatch\n", frame, strokes_id(&strokes->slots[i]));
        else if (strokes->slots[i].count > 0) {
            total += strokes->slots[i].count;
            strokes->slots[strokes->count++] = strokes->slots[i];
        }
    strokes->words = malloc(sizeof *strokes->words * (total + 1));
    gpu_buffer_read(state->sorted.name, strokes->words, sizeof *strokes->words * total);
}

/* The picture of a frame that is foreseen, and its canvas. */
struct film {
    struct picture picture;
    const struct canvas *canvas;
};

static enum hatch_status foresee(void *data, uint32_t number, const struct hatch_view *view, struct hatch_err *error)
{
    struct film *film = data;
    film->picture.film = number;
    return picture_foresee(&film->picture, view, film->canvas, job.options->width, job.options->height, error);
}

/* Draws the film as render-gl does.
 *   all  out: an entry for each frame */
static void draw_film(const struct picture *picture, const struct canvas *canvas, struct hatch_image *image,
                      struct drawn *all)
{
    struct film film = {*picture, canvas};
    const struct strokes_state *state = picture->instance->state;
    for (uint32_t frame = 0; frame < job.options->frames; frame++) {
        struct drawn *drawn = &all[frame];
        struct hatch_view view;
        film.picture.film = job_set_film_frame(&job, frame, foresee, &film, &view);
        draw(&film.picture, &view, canvas, 0, image);
        const struct strokes_moment *moment = &state->moments[film.picture.film % HATCH_LASTING_SPAN];
        const struct strokes_list *list = &moment->tiles->list;
        *drawn = (struct drawn){.ids = malloc(sizeof *drawn->ids * (list->count + 1))};
        for (uint32_t i = 0; i < list->count; i++)
            if (list->lasts[i])
                drawn->ids[drawn->count++] = list->wholes[i];
        qsort(drawn->ids, drawn->count, sizeof *drawn->ids, compare_ids);
    }
}

static void read_blended(const struct strokes_state *state, struct drawn *blended)
{
    struct strokes_slot *slots = malloc(sizeof *slots * (state->found_count + 1));
    gpu_buffer_read(state->found.name, slots, sizeof *slots * state->found_count);
    *blended =
        (struct drawn){.count = state->found_count, .ids = malloc(sizeof *blended->ids * (state->found_count + 1))};
    for (uint32_t i = 0; i < blended->count; i++)
        blended->ids[i] = strokes_id(&slots[i]);
    qsort(blended->ids, blended->count, sizeof *blended->ids, compare_ids);
    free(slots);
}

/* drawn: NULL: not asked for */
static void print_rows(uint32_t frame, const struct strokes *strokes, const struct drawn *drawn,
                       const struct drawn *blended)
{
    for (uint32_t i = 0; i < strokes->count; i++) {
        const struct strokes_slot *slot = &strokes->slots[i];
        const uint64_t id = strokes_id(slot);
        double ink = 0;
        for (uint32_t k = slot->first; k < slot->first + slot->count; k++)
            ink += (strokes->words[k][1] >> 16) / 65535.0;
        printf("%u\t%016" PRIx64 "\t%.3f", frame, id, ink);
        if (drawn)
            printf("\t%d\t%d", has(drawn, id), !has(blended, id));
        printf("\n");
    }
}

int main(int argc, char **argv)
{
    const bool all = argc > 1 && strcmp(argv[1], "drawn") == 0;
    struct strokes strokes;
    struct drawn *drawn, blended;
    struct canvas canvas;
    struct hatch_image image;
    job.options = options_read(argc - (argc > 1), argv + (argc > 1), &job.args);
    params_read(job.options);
    job_read(&job);
    job_prepare(&job);
    job_make_canvas(&job, &canvas);
    cmd_check(hatch_image_make(&job.args.keep, job.options->width, job.options->height, "RGB", &image, &err), NULL,
              &err);
    const struct picture picture = job_picture(&job, job_use(&job, job.options->technique));
    const struct strokes_state *state = picture.instance->state;
    drawn = malloc(sizeof *drawn * job.options->frames);
    if (all)
        draw_film(&picture, &canvas, &image, drawn);
    for (uint32_t frame = 0; frame < job.options->frames; frame++) {
        struct hatch_view view;
        job_set_frame(&job, frame, &view);
        draw(&picture, &view, &canvas, 0, &image);
        read_sorted(frame, state, &strokes);
        if (all) {
            draw(&picture, &view, &canvas, 1, &image);
            read_blended(state, &blended);
        }
        print_rows(frame, &strokes, all ? &drawn[frame] : NULL, &blended);
        if (all) {
            free(blended.ids);
            free(drawn[frame].ids);
        }
        free(strokes.slots);
        free(strokes.words);
    }
    free(drawn);
    canvas_free(&canvas);
    job_end(&job);
    return cmd_end(&job.args, HATCH_OK);
}
