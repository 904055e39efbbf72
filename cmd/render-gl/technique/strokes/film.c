/* The strokes of a film's frames, which are found before the frame is drawn: those that do not last are left out. */
#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "render-gl/technique/strokes/strokes.h"

_Static_assert(TECHNIQUE_AHEAD == HATCH_LASTING_AHEAD, "frames that are foreseen");

static uint64_t whole_of(const struct strokes_list *list, uint32_t i)
{
    return list->wholes ? list->wholes[i] : strokes_id(&list->strokes[i]);
}

static int compare_words(const void *a, const void *b)
{
    uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

static struct strokes_moment *moment_of(struct strokes_state *state, uint32_t film)
{
    return &state->moments[film % HATCH_LASTING_SPAN];
}

/* Returns a moment for a frame, emptied if it was that of an earlier one.
 *   scratch  has the limit of its memory */
static struct strokes_moment *begin_moment(struct strokes_state *state, uint32_t film,
                                           const struct hatch_arena *scratch)
{
    struct strokes_moment *moment = moment_of(state, film);
    if (moment->film == film)
        return moment;
    if (moment->film == 0)
        hatch_arena_init(&moment->arena, scratch->limit_bytes);
    hatch_arena_free(&moment->arena);
    moment->film = film;
    moment->tile_count = 0;
    moment->ids = (struct hatch_buffer){.arena = &moment->arena};
    return moment;
}

/* Adds a tile to a moment, with the buffers that the moment had for it before.
 *   found  out */
static enum hatch_status add_tile(struct strokes_moment *moment, struct hatch_arena *keep, struct strokes_tile **found,
                                  struct hatch_err *err)
{
    struct strokes_tile **link = &moment->tiles;
    for (uint32_t i = 0; i < moment->tile_count; i++)
        link = &(*link)->next;
    if (!*link)
        *link = HATCH_NEW(keep, struct strokes_tile, 1, err);
    if (!*link)
        return HATCH_LIMIT;
    moment->tile_count++;
    *found = *link;
    return HATCH_OK;
}

static struct strokes_tile *find_tile(const struct strokes_moment *moment, const struct hatch_tile *tile)
{
    struct strokes_tile *found = moment->tiles;
    while (found && memcmp(&found->tile, tile, sizeof *tile) != 0)
        found = found->next;
    assert(found); /* foreseen before it is drawn */
    return found;
}

/* Exchanges the ribbons of the state with those of a tile. */
static void swap_ribbons(struct strokes_state *state, struct strokes_tile *tile)
{
    const struct strokes_buffer points = state->points;
    const GLuint view = state->points_view;
    state->points = tile->points;
    state->points_view = tile->points_view;
    tile->points = points;
    tile->points_view = view;
}

/* Copies a list into a moment, and its ids to those of the moment's other tiles. */
static enum hatch_status keep_list(struct strokes_moment *moment, const struct strokes_list *list,
                                   struct strokes_tile *tile, struct hatch_err *err)
{
    struct strokes_slot *strokes;
    uint64_t *wholes;
    HATCH_TRY(HATCH_ALLOC_UNSET(&moment->arena, &strokes, list->count + (size_t)1, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(&moment->arena, &wholes, list->count + (size_t)1, err));
    for (uint32_t i = 0; i < list->count; i++) {
        strokes[i] = list->strokes[i];
        wholes[i] = whole_of(list, i);
    }
    tile->list =
        (struct strokes_list){.strokes = strokes, .count = list->count, .fragments = list->fragments, .wholes = wholes};
    return hatch_buffer_add(&moment->ids, wholes, sizeof *wholes * list->count, err);
}

enum hatch_status strokes_foresee(struct technique_context *context, struct technique_instance *instance, double pen_px,
                                  struct hatch_err *err)
{
    struct strokes_state *state = instance->state;
    const struct frame_request *request = &context->frame->request;
    struct hatch_arena *scratch = &context->args->scratch;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct strokes_moment *moment = begin_moment(state, request->film, scratch);
    const struct technique_counts before = state->counts;
    struct strokes_tile *tile;
    struct strokes_list list;
    HATCH_TRY(add_tile(moment, &context->args->keep, &tile, err));
    tile->tile = *request->tile;
    swap_ribbons(state, tile);
    enum hatch_status status = strokes_find(context, instance, pen_px, &list, err);
    swap_ribbons(state, tile);
    tile->counts = (struct technique_counts){.strokes = state->counts.strokes - before.strokes,
                                             .fragments = state->counts.fragments - before.fragments,
                                             .waited = state->counts.waited - before.waited};
    state->counts = before;
    if (status == HATCH_OK)
        status = keep_list(moment, &list, tile, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}

/* Finds the strokes in sight in a frame, in all of its tiles. */
static struct hatch_seen see(struct strokes_state *state, uint32_t film)
{
    struct strokes_moment *moment = moment_of(state, film);
    uint64_t *ids = (uint64_t *)(void *)moment->ids.data;
    size_t count = moment->ids.size / sizeof *ids, once = 0;
    if (film == 0 || moment->film != film)
        return (struct hatch_seen){.known = false};
    qsort(ids, count, sizeof *ids, compare_words);
    for (size_t i = 0; i < count; i++)
        if (once == 0 || ids[once - 1] != ids[i])
            ids[once++] = ids[i];
    moment->ids.size = sizeof *ids * once;
    return (struct hatch_seen){.known = true, .count = once, .ids = ids};
}

/* Finds out which strokes of a list last.
 *   moment  that of the list */
static enum hatch_status find_lasting(struct strokes_state *state, struct strokes_moment *moment,
                                      struct strokes_list *list, struct hatch_arena *scratch, struct hatch_err *err)
{
    struct hatch_seen frames[HATCH_LASTING_SPAN];
    const struct hatch_seen *middle = &frames[HATCH_LASTING_AHEAD];
    bool *lasting, *lasts;
    for (uint32_t k = 0; k < HATCH_LASTING_SPAN; k++)
        frames[k] = see(state, moment->film + k > HATCH_LASTING_AHEAD ? moment->film + k - HATCH_LASTING_AHEAD : 0);
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &lasting, middle->count + 1, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(&moment->arena, &lasts, list->count + (size_t)1, err));
    hatch_lasting_find(frames, lasting);
    for (uint32_t i = 0; i < list->count; i++) {
        const uint64_t *at = bsearch(&list->wholes[i], middle->ids, middle->count, sizeof *at, compare_words);
        lasts[i] = lasting[at - middle->ids];
    }
    list->lasts = lasts;
    return HATCH_OK;
}

enum hatch_status strokes_recall(const struct technique_context *context, struct technique_instance *instance,
                                 struct strokes_list *list, struct hatch_err *err)
{
    struct strokes_state *state = instance->state;
    const struct frame_request *request = &context->frame->request;
    struct strokes_moment *moment = moment_of(state, request->film);
    struct strokes_tile *tile = find_tile(moment, request->tile);
    HATCH_TRY(find_lasting(state, moment, &tile->list, &context->args->scratch, err));
    *list = tile->list;
    swap_ribbons(state, tile);
    state->counts.strokes += tile->counts.strokes;
    state->counts.fragments += tile->counts.fragments;
    state->counts.waited += tile->counts.waited;
    return HATCH_OK;
}

void strokes_film_free(struct strokes_state *state)
{
    for (uint32_t k = 0; k < HATCH_LASTING_SPAN; k++) {
        struct strokes_moment *moment = &state->moments[k];
        for (struct strokes_tile *tile = moment->tiles; tile; tile = tile->next) {
            glDeleteBuffers(1, &tile->points.name);
            glDeleteTextures(1, &tile->points_view);
        }
        if (moment->film)
            hatch_arena_free(&moment->arena);
    }
}
