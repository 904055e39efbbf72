/* From fragments to ribbons: a compute pass fits a cubic to each stroke; the few strokes that no cubic follows are
 * divided on the processor and fitted again; a last pass extrudes the cubics. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/parallel.h"
#include "fit/split.h"
#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/gpu/texture.h"
#include "render-gl/technique/strokes/strokes.h"

#define MISSED_MOST 0.05f /* share of a stroke's weight that its curve may miss */
#define REACH 1.5         /* as in shaders/strokes/fit.comp */
#define DIVISION_TASKS 16u
#define PLACES 8u /* places along a stroke whose parts have different ids */
#define RIBBON_BYTES (12 * sizeof(float) * RIBBON_POINTS)
#define TEXEL_BYTES (4 * sizeof(float))
#define DRAWN_BYTES 176u /* of struct Drawn in shaders/strokes/drawn.glsl, std430 */

/* How a curve follows its stroke. */
struct miss {
    float share;     /* of the stroke's weight that it misses */
    float magnified; /* pixels per texel of the stroke's map, at least 1 */
};

/* Makes room for so many fitted strokes, and keeps those that are there. */
static void reserve_drawn(struct strokes_state *state, uint32_t count)
{
    const size_t bytes = (size_t)DRAWN_BYTES * count;
    struct strokes_buffer before = state->drawn;
    if (bytes <= before.size_bytes)
        return;
    state->drawn = (struct strokes_buffer){.name = 0};
    strokes_reserve(&state->drawn, bytes + bytes / 2); /* room for the parts of divided strokes */
    gpu_buffer_copy(before.name, 0, state->drawn.name, 0, before.size_bytes);
    glDeleteBuffers(1, &before.name);
}

/* Makes room for so many ribbons. */
static enum hatch_status reserve_ribbons(struct strokes_state *state, uint32_t count, struct hatch_err *err)
{
    const size_t bytes = RIBBON_BYTES * count;
    if (bytes <= state->points.size_bytes)
        return HATCH_OK;
    HATCH_TRY(gpu_check_texels(bytes / TEXEL_BYTES, "points of strokes", err));
    strokes_reserve(&state->points, bytes);
    glDeleteTextures(1, &state->points_view);
    state->points_view = gpu_texture_of_buffer(GL_RGBA32F, state->points.name);
    return gpu_check_memory(err, "%u strokes", count);
}

/* Orders 64-bit words, the largest first. */
static int compare_words(const void *a, const void *b)
{
    uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return (x < y) - (x > y);
}

/* Binds the list of the strokes to fit, those of the most fragments first: strokes that are fitted side by side wait
 * for the longest of them.
 *   chosen  count indices of strokes, sorted in the same way; NULL: the first `count` */
static enum hatch_status bind_order(struct strokes_state *state, const struct strokes_slot *strokes,
                                    const uint32_t *chosen, uint32_t count, struct hatch_arena *scratch,
                                    struct hatch_err *err)
{
    uint32_t *order;
    uint64_t *sorted;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &order, count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &sorted, count, err));
    for (uint32_t i = 0; i < count; i++) {
        uint32_t stroke = chosen ? chosen[i] : i;
        sorted[i] = (uint64_t)strokes[stroke].count << 32 | stroke;
    }
    qsort(sorted, count, sizeof *sorted, compare_words);
    for (uint32_t i = 0; i < count; i++)
        order[i] = (uint32_t)sorted[i];
    strokes_reserve(&state->order, sizeof *order * count);
    HATCH_TRY(gpu_check_memory(err, "%u strokes", count));
    gpu_buffer_update(state->order.name, order, sizeof *order * count);
    gpu_storage_bind(STORAGE_ORDER, state->order.name);
    return HATCH_OK;
}

/* Fits strokes of a list: as many as the caller has bound the sums or the order of. */
static enum hatch_status fit(const struct frame *frame, struct strokes_state *state, const struct strokes_list *list,
                             uint32_t count, struct hatch_err *err)
{
    reserve_drawn(state, list->count);
    strokes_reserve(&state->found, sizeof *list->strokes * list->count);
    strokes_reserve(&state->missed, sizeof(struct miss) * list->count);
    HATCH_TRY(gpu_check_memory(err, "%u strokes", list->count));
    gpu_buffer_update(state->found.name, list->strokes, sizeof *list->strokes * list->count);
    gpu_storage_bind(STORAGE_SLOTS, state->found.name);
    gpu_storage_bind(STORAGE_DRAWN, state->drawn.name);
    gpu_storage_bind(STORAGE_MISSED, state->missed.name);
    state->found_count = list->count;
    strokes_dispatch(frame, state->fit, "fit", count);
    return HATCH_OK;
}

/* Makes the ribbons of fitted strokes. */
static enum hatch_status extrude(const struct frame *frame, struct strokes_state *state, uint32_t count,
                                 struct hatch_err *err)
{
    HATCH_TRY(reserve_ribbons(state, count, err));
    gpu_storage_bind(STORAGE_DRAWN, state->drawn.name);
    gpu_storage_bind(STORAGE_RIBBON, state->points.name);
    frame_dispatch_over(
        &(struct frame_dispatch){.name = "extrude",
                                 .program = state->extrude,
                                 .barrier = GL_TEXTURE_FETCH_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT},
        count, frame->timer);
    return HATCH_OK;
}

static struct hatch_fragment fragment_of(const uint32_t words[2])
{
    return (struct hatch_fragment){.t = (float)(words[1] & 0xffff) / 65535,
                                   .x = (float)(words[0] & 0xffff) + 0.5f,
                                   .y = (float)(words[0] >> 16) + 0.5f,
                                   .weight = (float)(words[1] >> 16) / 65535};
}

static void put_fragment(const struct hatch_fragment *fragment, uint32_t words[2])
{
    words[0] = (uint32_t)fragment->x | (uint32_t)fragment->y << 16;
    words[1] = (uint32_t)(fragment->t * 65535 + 0.5f) | (uint32_t)(fragment->weight * 65535 + 0.5f) << 16;
}

/* Returns the middle of the range of t of fragments. */
static double middle_of(const struct hatch_fragment *fragments, uint32_t count)
{
    float low = fragments->t, high = fragments->t;
    for (uint32_t i = 1; i < count; i++) {
        low = fminf(low, fragments[i].t);
        high = fmaxf(high, fragments[i].t);
    }
    return 0.5 * (double)(low + high);
}

/* Divides a stroke into parts. The id of a part depends on its place along the stroke: the next frame has the same one.
 *   reach_px  distance of fragments that a curve misses
 *   words     the stroke's fragments; reordered
 *   parts     out: count of them, at most HATCH_FIT_PARTS_MAX */
static enum hatch_status divide(const struct strokes_slot *stroke, double reach_px, uint32_t (*words)[2],
                                struct hatch_arena *scratch, struct strokes_slot *parts, uint32_t *count,
                                struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_fragment *fragments;
    struct hatch_stroke_part found[HATCH_FIT_PARTS_MAX];
    uint32_t taken[PLACES + 1] = {0};
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &fragments, stroke->count, err));
    for (uint32_t i = 0; i < stroke->count; i++)
        fragments[i] = fragment_of(words[i]);
    HATCH_TRY(hatch_fragments_split(fragments, stroke->count, reach_px, scratch, found, count, err));
    for (uint32_t i = 0; i < stroke->count; i++)
        put_fragment(&fragments[i], words[i]);
    for (uint32_t i = 0; i < *count; i++) {
        uint32_t begin = i > 0 ? found[i - 1].end : 0;
        parts[i] = *stroke;
        uint32_t place = (uint32_t)(PLACES * middle_of(fragments + begin, found[i].end - begin));
        parts[i].id[1] += 0x9e3779b9u * (place + PLACES * taken[place]++);
        parts[i].first += begin;
        parts[i].count = found[i].end - begin;
        parts[i].joined =
            (i > 0 && found[i - 1].goes_on ? STROKES_JOINED_START : 0) | (found[i].goes_on ? STROKES_JOINED_END : 0);
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

/* Reads the fragments of strokes.
 *   poor   count indices of the strokes
 *   words  out: the fragments of one stroke after those of another, in the scratch arena
 *   size   out: number of fragments */
static enum hatch_status read_fragments(struct strokes_state *state, const struct strokes_slot *strokes,
                                        const uint32_t *poor, uint32_t count, uint32_t (**words)[2], uint32_t *size,
                                        struct hatch_arena *scratch, struct hatch_err *err)
{
    uint32_t at = 0;
    *size = 0;
    for (uint32_t i = 0; i < count; i++)
        *size += strokes[poor[i]].count;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, words, *size, err));
    strokes_reserve(&state->divided, STROKES_SORTED_BYTES * *size);
    HATCH_TRY(gpu_check_memory(err, "%u fragments of strokes", *size));
    for (uint32_t i = 0; i < count; i++) {
        const struct strokes_slot *stroke = &strokes[poor[i]];
        gpu_buffer_copy(state->sorted.name, STROKES_SORTED_BYTES * stroke->first, state->divided.name,
                        STROKES_SORTED_BYTES * at, STROKES_SORTED_BYTES * stroke->count);
        at += stroke->count;
    }
    gpu_buffer_read(state->divided.name, *words, STROKES_SORTED_BYTES * *size);
    return HATCH_OK;
}

/* Strokes that are divided side by side. */
struct division {
    const struct strokes_slot *strokes;
    const uint32_t *poor; /* count indices of those to divide */
    uint32_t count;
    const struct miss *misses;                         /* per stroke */
    double reach_px;                                   /* where nothing is magnified */
    uint32_t (*words)[2];                              /* fragments; those of a stroke begin at its `first` */
    struct strokes_slot (*parts)[HATCH_FIT_PARTS_MAX]; /* per stroke to divide */
    uint32_t *part_counts;                             /* the same */
    size_t limit_bytes;                                /* of the memory of a task */
    enum hatch_status statuses[DIVISION_TASKS];
    struct hatch_err errs[DIVISION_TASKS];
};

static void divide_some(void *context, uint32_t task)
{
    struct division *division = context;
    enum hatch_status status = HATCH_OK;
    struct hatch_arena arena;
    hatch_arena_init(&arena, division->limit_bytes);
    for (uint32_t i = task; i < division->count && status == HATCH_OK; i += DIVISION_TASKS) {
        const struct strokes_slot *stroke = &division->strokes[division->poor[i]];
        const double reach_px = division->reach_px * (double)division->misses[division->poor[i]].magnified;
        status = divide(stroke, reach_px, division->words + stroke->first, &arena, division->parts[i],
                        &division->part_counts[i], &division->errs[task]);
    }
    division->statuses[task] = status;
    hatch_arena_free(&arena);
}

/* Divides strokes on all threads. */
static enum hatch_status divide_each(struct division *division, struct hatch_pool *pool, struct hatch_arena *scratch,
                                     struct hatch_err *err)
{
    division->limit_bytes = scratch->limit_bytes / DIVISION_TASKS;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &division->parts, division->count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &division->part_counts, division->count, err));
    hatch_parallel_for(pool, DIVISION_TASKS, divide_some, division);
    for (uint32_t task = 0; task < DIVISION_TASKS; task++)
        if (division->statuses[task] != HATCH_OK) {
            *err = division->errs[task];
            return division->statuses[task];
        }
    return HATCH_OK;
}

/* Divides strokes of a list. The first part takes the place of the stroke; the others come after all strokes, ordered
 * by ink as these are. The fragments of the parts are in the buffer `divided`.
 *   misses      per stroke
 *   poor        in: poor_count indices of the strokes; out: of their parts, with room for all that there may be */
static enum hatch_status divide_all(struct strokes_state *state, struct strokes_list *list, const struct miss *misses,
                                    uint32_t *poor, uint32_t *poor_count, struct hatch_pool *pool,
                                    struct hatch_arena *scratch, struct hatch_err *err)
{
    struct division division = {
        .poor = poor, .count = *poor_count, .misses = misses, .reach_px = REACH * state->width_px + 1};
    struct strokes_slot *strokes;
    uint32_t size, first = 0, count = list->count;
    uint64_t *wholes;
    const size_t most = count + (size_t)HATCH_FIT_PARTS_MAX * *poor_count;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &strokes, most, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &wholes, most, err));
    memcpy(strokes, list->strokes, sizeof *strokes * count);
    for (uint32_t i = 0; i < count; i++)
        wholes[i] = strokes_id(&strokes[i]);
    HATCH_TRY(read_fragments(state, strokes, poor, *poor_count, &division.words, &size, scratch, err));
    for (uint32_t i = 0; i < *poor_count; i++) {
        strokes[poor[i]].first = first;
        first += strokes[poor[i]].count;
    }
    division.strokes = strokes;
    HATCH_TRY(divide_each(&division, pool, scratch, err));
    for (uint32_t i = 0; i < division.count; i++) {
        uint32_t others = division.part_counts[i] - 1;
        strokes[poor[i]] = division.parts[i][0];
        memcpy(&strokes[count], &division.parts[i][1], sizeof *strokes * others);
        while (others--)
            wholes[count++] = wholes[poor[i]];
    }
    for (uint32_t i = list->count; i < count; i++)
        poor[(*poor_count)++] = i;
    gpu_buffer_update(state->divided.name, division.words, STROKES_SORTED_BYTES * size);
    *list = (struct strokes_list){.strokes = strokes, .count = count, .fragments = list->fragments, .wholes = wholes};
    return HATCH_OK;
}

/* Lists the strokes whose curves miss too much.
 *   misses  out: per stroke, in the scratch arena
 *   poor    out: their indices, in the scratch arena, with room for all of their parts */
static enum hatch_status find_poor(const struct strokes_state *state, const struct strokes_list *list,
                                   struct miss **misses, uint32_t **poor, uint32_t *poor_count,
                                   struct hatch_arena *scratch, struct hatch_err *err)
{
    uint32_t all = 0;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, misses, list->count, err));
    gpu_buffer_read(state->missed.name, *misses, sizeof **misses * list->count);
    for (uint32_t i = 0; i < list->count; i++)
        all += (*misses)[i].share > MISSED_MOST;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, poor, (size_t)HATCH_FIT_PARTS_MAX * all, err));
    *poor_count = 0;
    for (uint32_t i = 0; i < list->count; i++)
        if ((*misses)[i].share > MISSED_MOST)
            (*poor)[(*poor_count)++] = i;
    return HATCH_OK;
}

/* Fits the strokes to their sorted fragments, and divides those that no cubic follows. */
static enum hatch_status fit_and_divide(const struct frame *frame, struct strokes_state *state,
                                        struct strokes_list *list, struct hatch_pool *pool, struct hatch_arena *scratch,
                                        struct hatch_err *err)
{
    struct miss *misses;
    uint32_t *poor, count;
    gpu_storage_bind(STORAGE_SORTED, state->sorted.name);
    HATCH_TRY(bind_order(state, list->strokes, NULL, list->count, scratch, err));
    HATCH_TRY(fit(frame, state, list, list->count, err));
    HATCH_TRY(find_poor(state, list, &misses, &poor, &count, scratch, err));
    if (!count)
        return HATCH_OK;
    HATCH_TRY(divide_all(state, list, misses, poor, &count, pool, scratch, err));
    gpu_storage_bind(STORAGE_SORTED, state->divided.name);
    HATCH_TRY(bind_order(state, list->strokes, poor, count, scratch, err));
    return fit(frame, state, list, count, err);
}

enum hatch_status strokes_fit(const struct frame *frame, struct strokes_state *state, struct strokes_list *list,
                              struct hatch_pool *pool, struct hatch_arena *scratch, struct hatch_err *err)
{
    if (state->blends) {
        strokes_blend_bind(state);
        HATCH_TRY(fit(frame, state, list, list->count, err));
    } else {
        HATCH_TRY(fit_and_divide(frame, state, list, pool, scratch, err));
    }
    return extrude(frame, state, list->count, err);
}
