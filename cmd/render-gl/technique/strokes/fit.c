/* From fragments to ribbons: a compute pass fits a cubic to each stroke; the few strokes that no cubic follows are
 * divided on the processor and fitted again. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fit/split.h"
#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/gpu/texture.h"
#include "render-gl/technique/strokes/strokes.h"

#define MISSED_MOST 0.05f /* share of a stroke's weight that its curve may miss */
#define REACH 1.5f        /* as in shaders/strokes/fit.comp */
#define PLACES 8u         /* places along a stroke whose parts have different ids */
#define RIBBON_BYTES (12 * sizeof(float) * RIBBON_POINTS)

/* Fits the strokes of a list.
 *   missed  out: for each, the share of its weight that its curve misses; NULL: not wanted */
static enum hatch_status fit(const struct frame *frame, struct strokes_state *state, const struct strokes_list *list,
                             float *missed, struct hatch_err *err)
{
    const size_t bytes = RIBBON_BYTES * list->count;
    if (bytes > state->points.size_bytes) {
        strokes_reserve(&state->points, bytes + bytes / 2); /* room for the parts of divided strokes */
        glDeleteTextures(1, &state->points_view);
        state->points_view = gpu_texture_of_buffer(GL_RGBA32F, state->points.name);
    }
    strokes_reserve(&state->found, sizeof *list->strokes * list->count);
    strokes_reserve(&state->missed, sizeof *missed * list->count);
    HATCH_TRY(gpu_check_memory(err, "%u strokes", list->count));
    gpu_buffer_update(state->found.name, list->strokes, sizeof *list->strokes * list->count);
    if (state->blends)
        strokes_blend_bind(state);
    else
        gpu_storage_bind(STORAGE_SORTED, state->sorted.name);
    gpu_storage_bind(STORAGE_SLOTS, state->found.name);
    gpu_storage_bind(STORAGE_RIBBON, state->points.name);
    gpu_storage_bind(STORAGE_MISSED, state->missed.name);
    glProgramUniform1ui(state->fit->name, UNIFORM_COUNT, list->count);
    state->found_count = list->count;
    frame_dispatch(&(struct frame_dispatch){.name = "fit",
                                            .program = state->fit,
                                            .groups = {(list->count + 31) / 32, 1, 1},
                                            .barrier = GL_TEXTURE_FETCH_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT},
                   frame->timer);
    if (missed)
        gpu_buffer_read(state->missed.name, missed, sizeof *missed * list->count);
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

/* Divides the strokes of a list whose curves miss too much. The first part takes the place of the stroke; the others
 * come after all strokes, ordered by ink as these are. */
static enum hatch_status divide_all(struct strokes_state *state, const float *missed, struct strokes_list *list,
                                    struct hatch_arena *scratch, struct hatch_err *err)
{
    struct strokes_slot *strokes, parts[HATCH_FIT_PARTS_MAX];
    uint32_t(*words)[2], poor = 0, count = list->count;
    for (uint32_t i = 0; i < list->count; i++)
        poor += missed[i] > MISSED_MOST;
    if (!poor)
        return HATCH_OK;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &strokes, list->count + (size_t)HATCH_FIT_PARTS_MAX * poor, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &words, list->fragments, err));
    gpu_buffer_read(state->sorted.name, words, sizeof *words * list->fragments);
    for (uint32_t i = 0; i < list->count; i++) {
        const struct strokes_slot *stroke = &list->strokes[i];
        uint32_t part_count;
        strokes[i] = *stroke;
        strokes[i].joined = STROKES_DRAWN;
        if (missed[i] <= MISSED_MOST)
            continue;
        HATCH_TRY(divide(stroke, (double)REACH * state->width_px + 1, words + stroke->first, scratch, parts,
                         &part_count, err));
        strokes[i] = parts[0];
        memcpy(&strokes[count], &parts[1], sizeof *parts * (part_count - 1));
        count += part_count - 1;
    }
    for (uint32_t i = 0; RIBBON_BYTES * count > state->points.size_bytes && i < list->count; i++)
        strokes[i].joined &= ~STROKES_DRAWN; /* the ribbons will be made in a larger buffer */
    gpu_buffer_update(state->sorted.name, words, sizeof *words * list->fragments);
    list->strokes = strokes;
    list->count = count;
    return HATCH_OK;
}

enum hatch_status strokes_fit(const struct frame *frame, struct strokes_state *state, struct strokes_list *list,
                              struct hatch_arena *scratch, struct hatch_err *err)
{
    const struct strokes_slot *before = list->strokes;
    float *missed;
    if (state->blends)
        return fit(frame, state, list, NULL, err);
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &missed, list->count, err));
    HATCH_TRY(fit(frame, state, list, missed, err));
    HATCH_TRY(divide_all(state, missed, list, scratch, err));
    return list->strokes == before ? HATCH_OK : fit(frame, state, list, NULL, err);
}
