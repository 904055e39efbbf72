/* From surfaces to strokes: fragments are gathered in a pass over the items, and sorted by stroke. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "render-gl/frame/parts.h"
#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/gpu/texture.h"
#include "render-gl/technique/strokes/strokes.h"

#define MARGIN_WIDTHS 12.0 /* widths of a stroke around a tile in which fragments are gathered, too */
#define SLOTS_LEAST 65536u
#define SLOTS_MOST (1u << 22)
#define DROPPED UINT32_MAX /* first fragment of a stroke that is not drawn */

void strokes_reserve(struct strokes_buffer *buffer, size_t size_bytes)
{
    if (buffer->name && buffer->size_bytes >= size_bytes)
        return;
    glDeleteBuffers(1, &buffer->name);
    buffer->name = gpu_buffer_make(NULL, size_bytes);
    buffer->size_bytes = size_bytes;
}

/* Draws the items into a target with one sample per pixel, as large as the tile of the frame: drawings have a smaller
 * canvas. Of a map, the target gets by how much it is magnified.
 *   count  out: number of fragments found, which may exceed the capacity of the buffer */
static enum hatch_status draw_fragments(struct technique_context *context, struct technique_instance *instance,
                                        uint32_t *count, struct hatch_err *err)
{
    static const float far = 0;
    static const struct strokes_fragments_head none = {0};
    struct strokes_state *state = instance->state;
    struct frame *frame = context->frame;
    const struct hatch_tile *tile = frame->request.tile;
    const struct gpu_target_form form = {.width = (uint32_t)tile->width,
                                         .height = (uint32_t)tile->height,
                                         .outputs = {instance->tones ? GL_R32F : 0},
                                         .depth = GL_DEPTH_COMPONENT32F};
    const struct gpu_target *target;
    struct strokes_fragments_head head;
    if (form.width > frame->size_max_px || form.height > frame->size_max_px)
        return hatch_fail(err, HATCH_LIMIT, "strokes are found in pictures of at most %u pixels a side",
                          frame->size_max_px);
    HATCH_TRY(frame_target(&frame->targets, &form, &target, err));
    const struct frame_pass clear = {.name = "clear", .target = target, .clear_depth = &far};
    frame_pass_begin(&clear);
    HATCH_TRY(frame_draw_items(frame, target, &strokes_paper, "", &state->paper, err));
    gpu_buffer_update(state->fragments.name, &none, sizeof none);
    gpu_storage_bind(STORAGE_FRAGMENTS, state->fragments.name);
    if (instance->tones) {
        gpu_target_clear(target, 0, GL_RED, GL_FLOAT, NULL);
        gpu_texture_bind(UNIT_MAGNIFIED, target->outputs[0], 0);
    }
    HATCH_TRY(strokes_draw_source(context, instance, target, err));
    frame_target_release(&frame->targets, target); /* fragments may be gathered several times */
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
    gpu_buffer_read(state->fragments.name, &head, sizeof head);
    *count = head.count;
    return HATCH_OK;
}

/* Returns the tile in which fragments are gathered: with a margin around that of the frame, so that strokes which cross
 * the border of the picture are fitted there as elsewhere, and neither bend nor taper at it.
 *   most    greatest size of a target
 *   margin  in: the margin wanted; out: what the target has room for */
static struct hatch_tile with_margin(const struct hatch_tile *tile, double most, double *margin)
{
    struct hatch_tile grown = *tile;
    *margin = fmax(fmin(*margin, floor((most - fmax(tile->width, tile->height)) / 2)), 0);
    grown.x -= *margin;
    grown.y -= *margin;
    grown.width += 2 * *margin;
    grown.height += 2 * *margin;
    return grown;
}

/* Draws the fragments in the tile of the frame, again with a larger buffer if they do not all find room. */
static enum hatch_status find_all(struct technique_context *context, struct technique_instance *instance,
                                  uint32_t *count, struct hatch_err *err)
{
    struct strokes_state *state = instance->state;
    for (;;) {
        strokes_reserve(&state->fragments,
                        sizeof(struct strokes_fragments_head) + STROKES_FRAGMENT_BYTES * state->capacity);
        HATCH_TRY(gpu_check_memory(err, "%zu fragments of strokes", state->capacity));
        HATCH_TRY(draw_fragments(context, instance, count, err));
        if (*count <= state->capacity)
            return HATCH_OK;
        state->capacity = *count;
    }
}

/* Draws the fragments, with a margin around the tile of the frame. */
static enum hatch_status find_fragments(struct technique_context *context, struct technique_instance *instance,
                                        uint32_t *count, struct hatch_err *err)
{
    struct strokes_state *state = instance->state;
    struct frame *frame = context->frame;
    const struct canvas *canvas = frame->request.canvas;
    const struct hatch_tile *shown = frame->request.tile;
    if (state->capacity < (size_t)canvas->width * canvas->height)
        state->capacity = (size_t)canvas->width * canvas->height;
    state->margin_px = ceil(fmin(MARGIN_WIDTHS * state->width_px, instance->technique->reach_px(instance)));
    const struct hatch_tile grown = with_margin(shown, frame->size_max_px, &state->margin_px);
    enum hatch_status status = frame_set_tile(frame, &grown, 1, instance->places, err);
    if (status == HATCH_OK)
        status = find_all(context, instance, count, err);
    enum hatch_status back = frame_set_tile(frame, shown, canvas->side, instance->places, err);
    return status == HATCH_OK ? back : status;
}

void strokes_dispatch(const struct frame *frame, const struct gpu_program *program, const char *name, uint32_t count)
{
    const struct frame_dispatch pass = {
        .name = name, .program = program, .barrier = GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT};
    frame_dispatch_over(&pass, count, frame->timer);
}

int strokes_compare(const void *a, const void *b)
{
    const struct strokes_slot *first = a, *second = b;
    uint32_t kind = first->id[0] & 127, other = second->id[0] & 127;
    if ((kind & 1) != (other & 1))
        return (kind & 1) > (other & 1) ? 1 : -1;
    if (kind != other)
        return kind > other ? 1 : -1;
    if (first->id[0] != second->id[0])
        return first->id[0] > second->id[0] ? 1 : -1;
    return first->id[1] > second->id[1] ? 1 : first->id[1] < second->id[1] ? -1 : 0;
}

/* Gives each stroke its range of the sorted fragments, and lists the strokes: those that their patch owns. Two's
 * complement of `joined`, as shaders/strokes/route.comp leaves it, is negative for others.
 *   slots  the table; out: with the ranges
 *   found  out: the slots in use, sorted
 * Returns their number. */
static uint32_t list_strokes(struct strokes_slot *slots, uint32_t slot_count, struct strokes_slot *found)
{
    uint32_t count = 0, first = 0;
    for (uint32_t i = 0; i < slot_count; i++)
        if (slots[i].joined > INT32_MAX)
            slots[i].first = DROPPED;
        else if (slots[i].count > 0) {
            slots[i].first = first;
            slots[i].joined = 0;
            first += slots[i].count;
            found[count++] = slots[i];
        }
    return count;
}

/* Orders strokes by their numbers of fragments, the most first, then by id. */
static int compare_sizes(const void *a, const void *b)
{
    const struct strokes_slot *first = a, *second = b;
    if (first->count != second->count)
        return first->count < second->count ? 1 : -1;
    return strokes_compare(a, b);
}

/* Drops the strokes of the fewest fragments if there are more than the option allows. */
static void drop_least(struct strokes_state *state, struct strokes_list *list)
{
    if (list->count > state->most) {
        qsort(list->strokes, list->count, sizeof *list->strokes, compare_sizes);
        if (!state->warned)
            cmd_warn(NULL, "%u strokes, of which the %u largest are drawn: --most-strokes", list->count, state->most);
        state->warned = true;
        list->count = state->most;
    }
    qsort(list->strokes, list->count, sizeof *list->strokes, strokes_compare);
}

/* Routes the fragments to the slots of their strokes.
 *   slots  out: the table, in the scratch arena */
static enum hatch_status route(const struct frame *frame, struct strokes_state *state, uint32_t count,
                               struct strokes_slot **slots, struct hatch_arena *scratch, struct hatch_err *err)
{
    size_t size_bytes;
    if (!state->slot_count)
        state->slot_count = SLOTS_LEAST;
    size_bytes = sizeof **slots * state->slot_count;
    HATCH_TRY(HATCH_ALLOC(scratch, slots, state->slot_count, err));
    strokes_reserve(&state->table, size_bytes);
    glClearNamedBufferData(state->table.name, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, NULL);
    gpu_storage_bind(STORAGE_FRAGMENTS, state->fragments.name);
    gpu_storage_bind(STORAGE_SLOTS, state->table.name);
    strokes_dispatch(frame, state->route, "route", count);
    gpu_buffer_read(state->table.name, *slots, size_bytes);
    return gpu_check_memory(err, "%u strokes", state->slot_count);
}

/* Returns whether fragments found no slot. */
static bool is_full(const struct strokes_slot *slots, uint32_t slot_count, uint32_t fragments)
{
    uint32_t routed = 0;
    for (uint32_t i = 0; i < slot_count; i++)
        routed += slots[i].count;
    return routed < fragments;
}

/* Routes the fragments to their strokes, and puts those of each stroke side by side.
 *   full  out: the table was too small, and fragments have lost their ids
 *   list  out */
static enum hatch_status sort(const struct frame *frame, struct strokes_state *state, uint32_t count, bool *full,
                              struct strokes_list *list, struct hatch_arena *scratch, struct hatch_err *err)
{
    struct strokes_slot *slots;
    HATCH_TRY(route(frame, state, count, &slots, scratch, err));
    *full = is_full(slots, state->slot_count, count);
    if (*full && state->slot_count == SLOTS_MOST)
        return hatch_fail(err, HATCH_LIMIT, "more than %u strokes are in sight: make them larger", SLOTS_MOST);
    if (*full) {
        state->slot_count *= 2;
        return HATCH_OK;
    }
    HATCH_TRY(HATCH_ALLOC(scratch, &list->strokes, state->slot_count, err));
    list->count = list_strokes(slots, state->slot_count, list->strokes);
    gpu_buffer_update(state->table.name, slots, sizeof *slots * state->slot_count);
    strokes_reserve(&state->sorted, STROKES_SORTED_BYTES * (size_t)count);
    gpu_storage_bind(STORAGE_SORTED, state->sorted.name);
    strokes_dispatch(frame, state->sort, "sort", count);
    return gpu_check_memory(err, "%u fragments of strokes", count);
}

enum hatch_status strokes_gather(struct technique_context *context, struct technique_instance *instance,
                                 struct strokes_list *list, struct hatch_err *err)
{
    struct strokes_state *state = instance->state;
    const struct frame *frame = context->frame;
    struct hatch_arena *scratch = &context->args->scratch;
    *list = (struct strokes_list){.count = 0};
    state->waited = 0;
    for (bool full = true; full;) {
        HATCH_TRY(find_fragments(context, instance, &list->fragments, err));
        if (!list->fragments)
            return HATCH_OK;
        full = false;
        HATCH_TRY(state->blends ? strokes_blend(frame, state, list->fragments, list, scratch, err)
                                : sort(frame, state, list->fragments, &full, list, scratch, err));
    }
    drop_least(state, list);
    return HATCH_OK;
}
