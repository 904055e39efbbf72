/* Compares the curves of the strokes that a view shows with those that they should have:
 *     bench_fit_views NAME OPTION ...   as render-gl, for one picture with --technique strokes
 * The fragments of all strokes are read back from the GPU. hatch_cubic_fit, which tests/unit/render-gl/test_strokes.c
 * compares with the shaders, is compared with the pseudo-inverse in doubles (fit/reference.h), and with the problem
 * that fit/cubic.h states, solved in doubles from singular values (fit/stated.h); the distance of a stroke is the
 * largest one at its fragments. A third reference, `ranked`, is the pseudo-inverse of the Legendre polynomials' matrix
 * without its singular values under RANK_SHARE of the largest. Standard output gets rows of two kinds: `whole` strokes,
 * and those `drawn`, of which some are parts of a stroke that no cubic follows; each for all strokes, by the number of
 * different parameters, and for four kinds of systems:
 *
 * - regular: all others
 * - few: fewer than four different parameters, or a range of them under 1 / 64
 * - ill: fragments with errors of a pixel would give a factor an error of more than a pixel
 * - scattered: so much of the weight lies so far from the curve that render-gl divides the stroke; of drawn ones, what
 *   remains of strokes of too many parts */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "fit/split.h"
#include "fit/stated.h"
#include "fit/strokes.h"
#include "math/percentile.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/mode/modes.h"
#include "render-gl/technique/strokes/strokes.h"

#define RANGE_LEAST (1.0 / 64)
#define RANK_SHARE 0.03 /* singular values below this share of the largest count as 0 */
#define DETERMINED 1.0  /* fit_reference_determined */
#define POINTS 129
#define REACH 1.5 /* in widths, and a pixel more: as in technique/strokes/fit.c */
#define MISSED_MOST 0.05

enum kind { REGULAR, FEW, ILL, SCATTERED, ALL, COUNTED, KINDS = COUNTED + 7 };
static const char *const kinds[] = {"regular", "few", "ill", "scattered", "all",  "1",
                                    "2",       "3",   "4",   "5-8",       "9-16", "17-"};
static const uint32_t most_parameters[] = {1, 2, 3, 4, 8, 16, UINT32_MAX};

static struct job job;
static struct hatch_err err;

enum reference { PLAIN, RANKED, STATED, REFERENCES };

/* Of strokes that are over a pixel from the pseudo-inverse, for it and for the curve: the curve's length beyond the
 * reach of fragments, and the fragments' weight beyond the reach of the curve, in pixels; and the weight of all. */
enum cover { OFF_PLAIN, OFF, MISSED_PLAIN, MISSED, WEIGHT, COVERS };

/* Distances of strokes of one kind, in pixels. */
struct distances {
    size_t count;
    struct hatch_weighted *of[REFERENCES];
    double covers[COVERS]; /* sums */
    size_t worse[2]; /* strokes for which the curve has over a pixel more than the pseudo-inverse, off and missed */
};

/* The strokes of the picture, and their fragments. */
struct strokes {
    uint32_t count;
    struct strokes_slot *slots;
    uint32_t (*words)[2];
    double reach_px;
};

static void *memory(size_t size)
{
    void *made = hatch_arena_array(&job.args.keep, size ? size : 1, 1, &err);
    cmd_check(made ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    return made;
}

static int compare_parameters(const void *a, const void *b)
{
    const float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

/* Returns the number of different parameters. */
static uint32_t count_parameters(const struct hatch_fragment *fragments, size_t count)
{
    struct hatch_arena_mark mark = hatch_arena_mark(&job.args.keep);
    float *t = memory(sizeof *t * count);
    uint32_t different = 1;
    for (size_t i = 0; i < count; i++)
        t[i] = fragments[i].t;
    qsort(t, count, sizeof *t, compare_parameters);
    for (size_t i = 1; i < count; i++)
        different += t[i] > t[i - 1];
    hatch_arena_rewind(&job.args.keep, mark);
    return different;
}

/* Finds the largest distances of a stroke's curve from the references. */
static void find_distances(const struct hatch_fragment *fragments, size_t count, const struct hatch_cubic *cubic,
                           double largest[REFERENCES])
{
    struct fit_reference reference;
    struct fit_stated stated, ranked;
    fit_stated_ranked(fragments, count, RANK_SHARE, &ranked);
    fit_reference_find(fragments, count, &reference);
    fit_stated_find(fragments, count, &stated);
    largest[PLAIN] = largest[RANKED] = largest[STATED] = 0;
    for (size_t i = 0; i < count; i++) {
        double here[2], there[REFERENCES][2];
        fit_curve_at(cubic, (double)fragments[i].t, here);
        fit_reference_at(&reference, (double)fragments[i].t, there[PLAIN]);
        fit_stated_at(&stated, (double)fragments[i].t, there[STATED]);
        fit_stated_at(&ranked, (double)fragments[i].t, there[RANKED]);
        for (int k = 0; k < REFERENCES; k++)
            largest[k] = fmax(largest[k], hypot(here[0] - there[k][0], here[1] - there[k][1]));
    }
}

/* Finds what a curve, given by its points, leaves of its fragments. */
static void find_cover(const struct hatch_fragment *fragments, size_t count, double places[POINTS][2], double reach_px,
                       double *off, double *missed)
{
    bool near[POINTS] = {false};
    *off = *missed = 0;
    for (size_t i = 0; i < count; i++) {
        bool reached = false;
        for (int k = 0; k < POINTS; k++)
            if (hypot(places[k][0] - (double)fragments[i].x, places[k][1] - (double)fragments[i].y) <= reach_px)
                near[k] = reached = true;
        *missed += reached ? 0 : (double)fragments[i].weight;
    }
    for (int k = 1; k < POINTS; k++)
        if (!near[k - 1] && !near[k])
            *off += hypot(places[k][0] - places[k - 1][0], places[k][1] - places[k - 1][1]);
}

static void find_covers(const struct hatch_fragment *fragments, size_t count, const struct hatch_cubic *cubic,
                        double reach_px, double covers[COVERS])
{
    struct fit_reference reference;
    double plain[POINTS][2], places[POINTS][2];
    fit_reference_find(fragments, count, &reference);
    for (int k = 0; k < POINTS; k++) {
        const double t = (double)cubic->t[0] + (double)(cubic->t[1] - cubic->t[0]) * k / (POINTS - 1);
        fit_reference_at(&reference, t, plain[k]);
        fit_curve_at(cubic, t, places[k]);
    }
    find_cover(fragments, count, plain, reach_px, &covers[OFF_PLAIN], &covers[MISSED_PLAIN]);
    find_cover(fragments, count, places, reach_px, &covers[OFF], &covers[MISSED]);
    for (size_t i = 0; i < count; i++)
        covers[WEIGHT] += (double)fragments[i].weight;
}

static void note(const double largest[REFERENCES], const double covers[COVERS], struct distances *kind)
{
    for (int k = 0; k < COVERS; k++)
        kind->covers[k] += covers[k];
    kind->worse[0] += covers[OFF] > covers[OFF_PLAIN] + 1;
    kind->worse[1] += covers[MISSED] > covers[MISSED_PLAIN] + 1;
    for (int k = 0; k < REFERENCES; k++)
        kind->of[k][kind->count] = (struct hatch_weighted){largest[k], 1};
    kind->count++;
}

/* Notes the distances of a stroke among those of its kinds. */
static void compare(const struct hatch_fragment *fragments, size_t count, double reach_px, struct distances *all)
{
    struct hatch_cubic cubic;
    double largest[REFERENCES], covers[COVERS] = {0};
    hatch_cubic_fit(fragments, count, &cubic);
    find_distances(fragments, count, &cubic, largest);
    if (largest[PLAIN] > 1)
        find_covers(fragments, count, &cubic, reach_px, covers);
    uint32_t parameters = count_parameters(fragments, count), counted = 0;
    const bool few = parameters < HATCH_CUBIC_TERMS || (double)(cubic.t[1] - cubic.t[0]) < RANGE_LEAST;
    const enum kind kind = few                                                                    ? FEW
                           : hatch_cubic_missed(&cubic, fragments, count, reach_px) > MISSED_MOST ? SCATTERED
                           : fit_reference_determined(fragments, count) < DETERMINED              ? ILL
                                                                                                  : REGULAR;
    while (parameters > most_parameters[counted])
        counted++;
    note(largest, covers, &all[kind]);
    note(largest, covers, &all[ALL]);
    note(largest, covers, &all[COUNTED + counted]);
}

/* Divides the fragments of a stroke as render-gl does.
 *   parts  out: count of them */
static void divide(const struct strokes *strokes, struct hatch_fragment *fragments, uint32_t count,
                   struct hatch_stroke_part parts[HATCH_FIT_PARTS_MAX], uint32_t *part_count)
{
    struct hatch_cubic cubic;
    parts[0] = (struct hatch_stroke_part){.end = count};
    *part_count = 1;
    hatch_cubic_fit(fragments, count, &cubic);
    if (hatch_cubic_missed(&cubic, fragments, count, strokes->reach_px) > MISSED_MOST)
        cmd_check(
            hatch_fragments_split(fragments, count, strokes->reach_px, &job.args.scratch, parts, part_count, &err),
            NULL, &err);
}

static void print_rows(const char *name, const char *what, struct distances all[KINDS])
{
    static const double shares[] = {0.5, 0.99, 1};
    for (int kind = 0; kind < KINDS; kind++) {
        printf("%s\t%s\t%s\t%zu", name, what, kinds[kind], all[kind].count);
        for (int k = 0; k < REFERENCES; k++) {
            double found[3] = {NAN, NAN, NAN};
            size_t over = 0;
            for (size_t i = 0; i < all[kind].count; i++)
                over += all[kind].of[k][i].value > 1;
            if (all[kind].count)
                hatch_percentiles(all[kind].of[k], all[kind].count, shares, 3, found);
            printf("\t%.4g\t%.4g\t%.4g\t%zu", found[0], found[1], found[2], over);
        }
        for (int k = 0; k < COVERS; k++)
            printf("\t%.3g", all[kind].covers[k]);
        printf("\t%zu\t%zu\n", all[kind].worse[0], all[kind].worse[1]);
    }
}

static void compare_all(const char *name, const struct strokes *strokes)
{
    struct distances whole[KINDS] = {{0}}, drawn[KINDS] = {{0}};
    for (int kind = 0; kind < KINDS; kind++)
        for (int k = 0; k < REFERENCES; k++) {
            whole[kind].of[k] = memory(sizeof **whole->of * strokes->count);
            drawn[kind].of[k] = memory(sizeof **drawn->of * strokes->count * HATCH_FIT_PARTS_MAX);
        }
    for (uint32_t i = 0; i < strokes->count; i++) {
        const struct strokes_slot *slot = &strokes->slots[i];
        struct hatch_arena_mark mark = hatch_arena_mark(&job.args.keep);
        struct hatch_fragment *fragments = memory(sizeof *fragments * slot->count);
        struct hatch_stroke_part parts[HATCH_FIT_PARTS_MAX];
        uint32_t count, begin = 0;
        for (uint32_t k = 0; k < slot->count; k++) {
            const uint32_t *words = strokes->words[slot->first + k];
            fragments[k] = (struct hatch_fragment){.t = (float)(words[1] & 0xffff) / 65535,
                                                   .x = (float)(words[0] & 0xffff) + 0.5f,
                                                   .y = (float)(words[0] >> 16) + 0.5f,
                                                   .weight = (float)(words[1] >> 16) / 65535};
        }
        compare(fragments, slot->count, strokes->reach_px, whole);
        divide(strokes, fragments, slot->count, parts, &count);
        for (uint32_t k = 0; k < count; begin = parts[k++].end)
            compare(fragments + begin, parts[k].end - begin, strokes->reach_px, drawn);
        hatch_arena_rewind(&job.args.keep, mark);
    }
    print_rows(name, "whole", whole);
    print_rows(name, "drawn", drawn);
}

/* Reads the strokes of the last picture, as they are before any are divided. */
static void read_strokes(const struct strokes_state *state, struct strokes *strokes)
{
    const size_t size = sizeof *strokes->slots * state->slot_count;
    size_t total = 0;
    *strokes = (struct strokes){.slots = memory(size), .reach_px = REACH * state->width_px + 1};
    gpu_buffer_read(state->table.name, strokes->slots, size);
    for (uint32_t i = 0; i < state->slot_count; i++) {
        const struct strokes_slot slot = strokes->slots[i];
        if (slot.count > 0 && slot.first != UINT32_MAX) {
            strokes->slots[strokes->count++] = slot;
            total += slot.count;
        }
    }
    strokes->words = memory(sizeof *strokes->words * total);
    gpu_buffer_read(state->sorted.name, strokes->words, sizeof *strokes->words * total);
}

int main(int argc, char **argv)
{
    struct strokes strokes;
    struct hatch_view view;
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
    job_set_frame(&job, 0, &view);
    cmd_check(picture_draw(&picture, &view, &canvas, &image, &err), NULL, &err);
    read_strokes(picture.instance->state, &strokes);
    compare_all(name, &strokes);
    canvas_free(&canvas);
    job_end(&job);
    return cmd_end(&job.args, HATCH_OK);
}
