/* Sums over the fragments of strokes by blending (Szécsi, Szirányi & Kacsó, §3). Each fragment is drawn as a point,
 * into the slot that its stroke has in the table of the frame before, or into the first free one. Strokes that meet in
 * a free slot wait for the next frame: one of them owns the slot then. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/gpu/texture.h"
#include "render-gl/technique/strokes/strokes.h"

#define TABLE_WIDTH 1024u
#define SLOTS_LEAST (4 * TABLE_WIDTH)
#define SLOTS_PER_STROKE 4u
#define FARTHEST -1e9f /* less than any of the extremes */

/* Outputs of shaders/strokes/blend.frag. */
enum { OUTPUT_POWERS, OUTPUT_HIGHER, OUTPUT_X, OUTPUT_Y, OUTPUT_EXTREMES, OUTPUT_IDS };

/* Content of a table after the fragments have been drawn. */
struct survey {
    uint32_t found;  /* slots of one stroke alone */
    uint32_t shared; /* slots of several strokes */
    bool lost;       /* a stroke has found neither its own slot nor a free one */
};

/* Makes both tables, without strokes. */
static enum hatch_status make_tables(struct strokes_blend *blend, uint32_t slots, struct hatch_err *err)
{
    const struct gpu_target_form form = {
        .width = TABLE_WIDTH,
        .height = slots / TABLE_WIDTH + 1, /* fragments without a slot are drawn into the last row */
        .outputs = {GL_RGBA32F, GL_RGBA32F, GL_RGBA32F, GL_RGBA32F, GL_RGBA32F, GL_RG32UI}};
    blend->slots = 0; /* until both are made */
    for (int i = 0; i < 2; i++) {
        struct gpu_target *table = &blend->tables[i];
        gpu_target_free(table);
        HATCH_TRY(gpu_target_make(&form, table, err));
        glTextureParameteri(table->outputs[OUTPUT_IDS], GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTextureParameteri(table->outputs[OUTPUT_IDS], GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        gpu_target_clear(table, OUTPUT_IDS, GL_RG_INTEGER, GL_UNSIGNED_INT, NULL);
    }
    blend->slots = slots;
    return HATCH_OK;
}

/* Draws the fragments into the older table. It is the last one then. */
static void draw_points(struct strokes_state *state, uint32_t count)
{
    static const struct gpu_attribute attribute = {ATTRIBUTE_FRAGMENT, 4, GL_UNSIGNED_INT,
                                                   sizeof(struct strokes_fragments_head)};
    static const float nothing[4] = {FARTHEST, FARTHEST, FARTHEST, FARTHEST};
    struct strokes_blend *blend = &state->blend;
    const struct gpu_target *table = &blend->tables[!blend->last];
    const struct frame_pass pass = {.name = "blend", .target = table, .blend = FRAME_BLEND_ADD};
    if (!blend->array)
        glCreateVertexArrays(1, &blend->array);
    gpu_array_attach(blend->array, 0, state->fragments.name, STROKES_FRAGMENT_BYTES, &attribute, 1);
    for (uint32_t i = 0; i < OUTPUT_EXTREMES; i++)
        gpu_target_clear(table, i, GL_RGBA, GL_FLOAT, NULL);
    gpu_target_clear(table, OUTPUT_EXTREMES, GL_RGBA, GL_FLOAT, nothing);
    gpu_target_clear(table, OUTPUT_IDS, GL_RG_INTEGER, GL_UNSIGNED_INT, NULL);
    frame_pass_begin(&pass);
    frame_pass_blend_output(OUTPUT_EXTREMES, FRAME_BLEND_MAX);
    frame_pass_blend_output(OUTPUT_IDS, FRAME_BLEND_REPLACE);
    gpu_texture_bind(UNIT_TECHNIQUE, blend->tables[blend->last].outputs[OUTPUT_IDS], 0);
    frame_pass_points(blend->points, blend->array, (GLsizei)count);
    blend->last = !blend->last;
}

static void read_output(const struct gpu_target *table, uint32_t output, GLenum layout, GLenum type, void *texels)
{
    const struct gpu_rectangle all = {0, 0, table->form.width, table->form.height};
    gpu_target_read(table, output, all, layout, type, 0, texels);
}

/* Reads the last table back.
 *   found  out: strokes with a slot of their own, room for all slots; `first` is the slot, `count` the
 *          pixels that it covers */
static enum hatch_status look(const struct strokes_blend *blend, struct strokes_slot *found, struct survey *survey,
                              struct hatch_arena *scratch, struct hatch_err *err)
{
    const struct gpu_target *table = &blend->tables[blend->last];
    size_t texels = (size_t)table->form.width * table->form.height;
    uint32_t(*ids)[2];
    float(*extremes)[4], (*higher)[4];
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &ids, texels, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &extremes, texels, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &higher, texels, err));
    read_output(table, OUTPUT_IDS, GL_RG_INTEGER, GL_UNSIGNED_INT, ids);
    read_output(table, OUTPUT_EXTREMES, GL_RGBA, GL_FLOAT, extremes);
    read_output(table, OUTPUT_HIGHER, GL_RGBA, GL_FLOAT, higher);
    *survey = (struct survey){.lost = ids[blend->slots][1] != 0};
    for (uint32_t i = 0; i < blend->slots; i++)
        if (ids[i][1] == 0)
            continue;
        else if (extremes[i][2] + extremes[i][3] > 0) /* strokes with different hashes */
            survey->shared++;
        else
            found[survey->found++] =
                (struct strokes_slot){.id = {ids[i][0], ids[i][1]}, .count = (uint32_t)ceilf(higher[i][3]), .first = i};
    return HATCH_OK;
}

static int compare_ids(const void *a, const void *b)
{
    return memcmp(a, b, 2 * sizeof(uint32_t));
}

/* Counts the strokes that share a slot of the last table. */
static enum hatch_status count_waiting(const struct frame *frame, struct strokes_state *state, uint32_t count,
                                       uint32_t *strokes, struct hatch_arena *scratch, struct hatch_err *err)
{
    static const uint32_t none[2];
    const struct strokes_blend *blend = &state->blend;
    uint32_t head, (*ids)[2];
    strokes_reserve(&state->sorted, sizeof none + sizeof *ids * count);
    HATCH_TRY(gpu_check_memory(err, "%u fragments of strokes", count));
    gpu_buffer_update(state->sorted.name, none, sizeof none);
    gpu_storage_bind(STORAGE_FRAGMENTS, state->fragments.name);
    gpu_storage_bind(STORAGE_SORTED, state->sorted.name);
    gpu_texture_bind(UNIT_TECHNIQUE, blend->tables[!blend->last].outputs[OUTPUT_IDS], 0);
    gpu_texture_bind(UNIT_TECHNIQUE + 1, blend->tables[blend->last].outputs[OUTPUT_EXTREMES], 0);
    strokes_dispatch(frame, blend->waiting, "waiting", count);
    gpu_buffer_read(state->sorted.name, &head, sizeof head);
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &ids, head + 1, err));
    gpu_buffer_read(state->sorted.name, ids, sizeof *ids * (head + 1));
    qsort(ids + 1, head, sizeof *ids, compare_ids);
    *strokes = 0;
    for (uint32_t i = 1; i <= head; i++)
        *strokes += i == 1 || compare_ids(ids[i], ids[i - 1]) != 0;
    return HATCH_OK;
}

/* Draws the fragments once, and again until the table is large enough.
 *   fresh  out: set if the table had to be made anew */
static enum hatch_status blend_once(struct strokes_state *state, uint32_t count, bool *fresh,
                                    struct strokes_slot **found, struct survey *survey, struct hatch_arena *scratch,
                                    struct hatch_err *err)
{
    struct strokes_blend *blend = &state->blend;
    for (;;) {
        HATCH_TRY(HATCH_ALLOC_UNSET(scratch, found, blend->slots, err));
        draw_points(state, count);
        HATCH_TRY(look(blend, *found, survey, scratch, err));
        if (!survey->lost && SLOTS_PER_STROKE * (survey->found + survey->shared) <= blend->slots)
            return HATCH_OK;
        HATCH_TRY(make_tables(blend, SLOTS_PER_STROKE * blend->slots, err));
        *fresh = true;
    }
}

enum hatch_status strokes_blend(const struct frame *frame, struct strokes_state *state, uint32_t count,
                                struct strokes_list *list, struct hatch_arena *scratch, struct hatch_err *err)
{
    struct strokes_blend *blend = &state->blend;
    const struct hatch_tile *tile = frame->request.tile;
    bool fresh = memcmp(&blend->tile, tile, sizeof *tile) != 0, counted = false;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct strokes_slot *found;
    struct survey survey;
    if (!blend->slots)
        HATCH_TRY(make_tables(blend, SLOTS_LEAST, err));
    do {
        hatch_arena_rewind(scratch, mark);
        HATCH_TRY(blend_once(state, count, &fresh, &found, &survey, scratch, err));
        if (!counted && survey.shared)
            HATCH_TRY(count_waiting(frame, state, count, &state->waited, scratch, err));
        counted = true;
    } while (fresh && survey.shared);
    gpu_timer_end_pass(frame->timer, "blend");
    blend->tile = *tile;
    list->strokes = found;
    list->count = survey.found;
    return HATCH_OK;
}

void strokes_blend_bind(const struct strokes_state *state)
{
    const struct strokes_blend *blend = &state->blend;
    for (uint32_t i = 0; i <= OUTPUT_EXTREMES; i++)
        gpu_texture_bind(UNIT_TECHNIQUE + i, blend->tables[blend->last].outputs[i], 0);
}

void strokes_blend_free(struct strokes_blend *blend)
{
    for (int i = 0; i < 2; i++)
        gpu_target_free(&blend->tables[i]);
    glDeleteVertexArrays(1, &blend->array);
}
