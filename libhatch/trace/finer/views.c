/* The finer strokes of a mesh: preparation, views, and the bound of memory. */
#include "trace/finer.h"

#include <math.h>
#include <string.h>

#include "base/random.h"
#include "field/field.h"
#include "trace/finer/store.h"

#define STREAM_FINER 12
#define OCTAVE_LOW 0.35     /* threshold, times the finest gap, at which the last complete octave begins */
#define LENGTH_DEFAULT 40.0 /* where the strokes do not say what they were traced with */
#define LENGTH_MAX 60.0     /* of longer strokes, far too much surface would matter to a tile */
#define JOINED 1.6          /* times the densest strokes of the mesh: from here on, thresholds are not raised */
#define THINNING 2.0        /* exponent of what is wanted: strokes are as thin as others at 2.24 times JOINED */
#define HARD_DEFAULT 0.69813170079773183

struct hatch_finer {
    struct hatch_arena keep, scratch;
    struct hatch_finer_source source;
    struct hatch_surface surface;
    struct hatch_frames frames;
    double *direction;
    float angles_rad[HATCH_CURVE_FAMILIES_MAX]; /* of all families; NAN: there is none of that number */
    struct hatch_store stores[HATCH_CURVE_FAMILIES_MAX];
    uint32_t store_count;
    enum hatch_status statuses[HATCH_CURVE_FAMILIES_MAX];
    struct hatch_err errs[HATCH_CURVE_FAMILIES_MAX];
    /* of a view */
    const struct hatch_finer_view *view;
    struct hatch_arena seen[HATCH_CURVE_FAMILIES_MAX];
    struct hatch_store_windows windows[HATCH_CURVE_FAMILIES_MAX][HATCH_FINER_LEVELS_MAX + 1];
};

double hatch_store_octaves(const struct hatch_store *store, double log_threshold)
{
    double finest = ldexp(store->options.gap, 1 - (int)store->level_count);
    return (log_threshold - log(OCTAVE_LOW / finest)) / log(2);
}

enum hatch_status hatch_store_add_line(struct hatch_store_batch *batch, struct hatch_arena *arena,
                                       const struct hatch_store_line *line, struct hatch_err *err)
{
    HATCH_TRY(
        hatch_curve_reserve(arena, &batch->lines, sizeof *batch->lines, batch->line_count, &batch->line_capacity, err));
    batch->lines[batch->line_count] = *line;
    batch->lines[batch->line_count++].first = batch->piece_count;
    return HATCH_OK;
}

enum hatch_status hatch_store_add_piece(struct hatch_store_batch *batch, struct hatch_arena *arena,
                                        const struct hatch_store_piece *piece, struct hatch_err *err)
{
    HATCH_TRY(hatch_curve_reserve(arena, &batch->pieces, sizeof *batch->pieces, batch->piece_count,
                                  &batch->piece_capacity, err));
    batch->pieces[batch->piece_count++] = *piece;
    batch->lines[batch->line_count - 1].count++;
    return HATCH_OK;
}

/* Prepares the store of a family. */
static void open_store(void *context, uint32_t index)
{
    struct hatch_finer *finer = context;
    struct hatch_store *store = &finer->stores[index];
    struct hatch_err *err = &finer->errs[index];
    finer->statuses[index] =
        hatch_trace_lay_out(&finer->surface, &finer->frames, finer->direction, (double)store->angle_rad,
                            store->options.hard_rad, &store->keep, &store->ground, err);
}

/* Takes the strokes of the mesh into the store of a family, before the first strokes are traced between them. */
static void take_curves(void *context, uint32_t index)
{
    struct hatch_finer *finer = context;
    struct hatch_store *store = &finer->stores[index];
    struct hatch_arena_mark kept = hatch_arena_mark(&store->keep), mark = hatch_arena_mark(&store->scratch);
    finer->statuses[index] = HATCH_OK;
    if (store->taken)
        return;
    finer->statuses[index] = hatch_store_take_curves(store, &finer->source, &finer->errs[index]);
    hatch_arena_rewind(&store->scratch, mark);
    store->taken = finer->statuses[index] == HATCH_OK;
    if (store->taken)
        return;
    hatch_arena_rewind(&store->keep, kept);
    store->given = (struct hatch_store_batch){.line_count = 0};
}

/* Lists the families of the curves. */
static void list_families(struct hatch_finer *finer)
{
    const struct hatch_curves *curves = finer->source.curves;
    for (uint32_t f = 0; f < HATCH_CURVE_FAMILIES_MAX; f++)
        finer->angles_rad[f] = NAN;
    for (uint32_t s = 0; s < curves->set_count; s++) {
        const struct hatch_curve_set *set = &curves->sets[s];
        finer->angles_rad[set->family] = set->angle_rad;
        if (finer->store_count == 0 || finer->stores[finer->store_count - 1].family != set->family) {
            struct hatch_store *added = &finer->stores[finer->store_count++];
            *added = (struct hatch_store){.family = set->family, .angle_rad = set->angle_rad};
            added->options = (struct hatch_trace_options){
                .family_count = HATCH_CURVE_FAMILIES_MAX,
                .angle_rad = finer->angles_rad,
                .gap = ldexp((double)set->gap, (int)set->level),
                .length = fmin(set->length > 1 ? (double)set->length : LENGTH_DEFAULT, LENGTH_MAX),
                .hard_rad = set->hard_rad >= 0 ? (double)set->hard_rad : HARD_DEFAULT,
                .seed = hatch_random_u64(0, STREAM_FINER, set->family)};
        }
        finer->stores[finer->store_count - 1].level_count = set->level + 1;
    }
    for (uint32_t i = 0; i < finer->store_count; i++) {
        struct hatch_store *store = &finer->stores[i];
        hatch_budget_init(&store->budget, finer->source.limit_bytes);
        hatch_arena_init_shared(&store->keep, &store->budget);
        hatch_arena_init_shared(&store->scratch, &store->budget);
        hatch_arena_init_shared(&finer->seen[i], &store->budget);
        store->pool = finer->store_count == 1 ? finer->source.pool : NULL;
        store->keep_bytes = finer->source.keep_bytes / finer->store_count;
    }
}

static enum hatch_status first_failure(const struct hatch_finer *finer, struct hatch_err *err)
{
    for (uint32_t i = 0; i < finer->store_count; i++)
        if (finer->statuses[i] != HATCH_OK) {
            *err = finer->errs[i];
            return err->status;
        }
    return HATCH_OK;
}

static enum hatch_status prepare(struct hatch_finer *finer, struct hatch_err *err)
{
    const struct hatch_mesh *mesh = finer->source.mesh;
    struct hatch_surface_notes notes;
    double *confidence;
    HATCH_TRY(hatch_surface_make_cut(mesh, &finer->keep, &finer->scratch, &finer->surface, &notes, err));
    HATCH_TRY(hatch_frames_make(&finer->surface, &finer->keep, &finer->scratch, &finer->frames, err));
    HATCH_TRY(HATCH_ALLOC(&finer->keep, &finer->direction, 3 * (size_t)finer->surface.point_count, err));
    struct hatch_arena_mark mark = hatch_arena_mark(&finer->scratch);
    HATCH_TRY(HATCH_ALLOC(&finer->scratch, &confidence, finer->surface.point_count, err));
    if (!hatch_field_of_mesh(&finer->surface, &finer->frames, mesh, finer->direction, confidence))
        return hatch_fail(err, HATCH_BAD_INPUT, "the mesh has no direction field, _HATCH_DIR");
    hatch_arena_rewind(&finer->scratch, mark);
    list_families(finer);
    hatch_parallel_for(finer->source.pool, finer->store_count, open_store, finer);
    return first_failure(finer, err);
}

enum hatch_status hatch_finer_make(const struct hatch_finer_source *source, struct hatch_finer **finer,
                                   struct hatch_err *err)
{
    struct hatch_arena keep;
    struct hatch_finer *made;
    *finer = NULL;
    hatch_arena_init(&keep, source->limit_bytes);
    made = hatch_arena_array(&keep, 1, sizeof *made, err);
    if (!made)
        return HATCH_LIMIT;
    made->keep = keep;
    made->source = *source;
    hatch_arena_init(&made->scratch, source->limit_bytes);
    enum hatch_status status = prepare(made, err);
    if (status == HATCH_OK)
        *finer = made;
    else
        hatch_finer_free(made);
    return status;
}

static void look(void *context, uint32_t index)
{
    struct hatch_finer *finer = context;
    finer->statuses[index] = hatch_store_look(&finer->stores[index], finer->source.mesh, finer->view,
                                              &finer->seen[index], &finer->errs[index]);
}

static void find_windows(void *context, uint32_t index)
{
    struct hatch_finer *finer = context;
    finer->statuses[index] = hatch_store_find_windows(&finer->stores[index], finer->source.mesh, finer->view,
                                                      &finer->seen[index], finer->windows[index], &finer->errs[index]);
}

/* Decides how traced strokes join those of the mesh: first their thresholds are raised, by less and less, while wide
 * strokes make the tone; then these get thinner.
 *   wanted  most strokes per mesh unit */
static void join_strokes(struct hatch_finer *finer, double wanted, struct hatch_finer_found *found)
{
    double densest = finer->view->alike ? 0 : finer->view->densest, more = densest > 0 ? wanted / densest : HUGE_VAL;
    double unraised = fmin(log(more / HATCH_FINER_START) / log(JOINED / HATCH_FINER_START), 1);
    found->densest = densest > 0 ? densest * pow(fmax(more / JOINED, 1), THINNING) : HUGE_VAL;
    for (uint32_t i = 0; i < finer->store_count; i++) {
        struct hatch_store *store = &finer->stores[i];
        double gap = ldexp(store->options.gap, -(int)store->level_count);
        double first = HATCH_STROKE_FADE * densest / HATCH_STROKE_SPARE * gap / HATCH_STORE_LEAST;
        store->drawn = HATCH_STROKE_FADE * found->densest / HATCH_STROKE_SPARE;
        store->raised = pow(fmax(first, 1), 1 - unraised);
        found->raised = fmax(found->raised, store->raised);
    }
}

/* Traces what the view of a family needs, component by component: windows are ordered by face. */
static void trace(void *context, uint32_t index)
{
    struct hatch_finer *finer = context;
    struct hatch_store *store = &finer->stores[index];
    enum hatch_status status = HATCH_OK;
    struct hatch_store_windows of_component[HATCH_FINER_LEVELS_MAX], rest[HATCH_FINER_LEVELS_MAX];
    store->view++;
    store->traced = 0;
    memcpy(rest, &finer->windows[index][1], sizeof rest);
    for (uint32_t c = 0; c < finer->surface.component_count && status == HATCH_OK; c++) {
        const struct hatch_component *component = &finer->surface.components[c];
        uint32_t any = 0;
        for (uint32_t i = 0; i < HATCH_FINER_LEVELS_MAX; i++) {
            uint32_t count = 0;
            while (count < rest[i].count && rest[i].items[count].face < component->first_face + component->face_count)
                count++;
            of_component[i] = (struct hatch_store_windows){.items = rest[i].items, .count = count};
            rest[i].count -= count;
            if (count > 0)
                rest[i].items += count;
            any += count;
        }
        if (any > 0)
            status = hatch_store_trace(store, component, of_component, &finer->errs[index]);
    }
    finer->statuses[index] = status;
}

/* Adds the strokes of a family that the view shows. */
static enum hatch_status gather(struct hatch_finer *finer, uint32_t index, struct hatch_store_sink *sink,
                                struct hatch_err *err)
{
    struct hatch_store *store = &finer->stores[index];
    for (uint32_t level = 0; level < store->level_count + HATCH_FINER_LEVELS_MAX; level++) {
        const struct hatch_store_windows *windows =
            &finer->windows[index][level < store->level_count ? 0 : level + 1 - store->level_count];
        struct hatch_trace_region region;
        if (windows->count == 0)
            break;
        struct hatch_arena_mark mark = hatch_arena_mark(&finer->seen[index]);
        HATCH_TRY(hatch_trace_region_around(&store->ground, windows->items, windows->count, 0, &finer->seen[index],
                                            &store->scratch, &region, err));
        HATCH_TRY(hatch_store_add_parts(store, level, &region, sink, err));
        hatch_arena_rewind(&finer->seen[index], mark);
    }
    sink->found->traced += store->traced;
    return HATCH_OK;
}

/* Frees the batches that the view does not need, the oldest first, until the others fit. */
static void drop_unused(struct hatch_store *store)
{
    size_t sum = 0;
    struct hatch_store_batch **link = &store->batches;
    while (*link) { /* newest first */
        struct hatch_store_batch *batch = *link;
        sum += batch->arena.used_bytes;
        if (batch->used == store->view || sum <= store->keep_bytes) {
            link = &batch->next;
            continue;
        }
        sum -= batch->arena.used_bytes;
        *link = batch->next;
        hatch_store_free_batch(batch);
    }
}

/* Returns the gap of the finest level that the view needs. */
static double finest_gap(const struct hatch_finer *finer)
{
    double finest = HUGE_VAL;
    for (uint32_t i = 0; i < finer->store_count; i++)
        for (uint32_t level = 0; level <= HATCH_FINER_LEVELS_MAX && finer->windows[i][level].count > 0; level++)
            finest = fmin(finest, ldexp(finer->stores[i].options.gap, 1 - (int)(finer->stores[i].level_count + level)));
    return finest;
}

/* Finds the strokes of a view that wants more than the mesh's own. */
static enum hatch_status trace_all(struct hatch_finer *finer, struct hatch_arena *arena,
                                   struct hatch_finer_found *found, struct hatch_err *err)
{
    struct hatch_store_sink sink = {.arena = arena, .mesh = finer->source.mesh, .found = found};
    sink.scratch = &finer->scratch;
    hatch_parallel_for(finer->source.pool, finer->store_count, take_curves, finer);
    HATCH_TRY(first_failure(finer, err));
    hatch_parallel_for(finer->source.pool, finer->store_count, find_windows, finer);
    HATCH_TRY(first_failure(finer, err));
    sink.finest = finest_gap(finer);
    hatch_parallel_for(finer->source.pool, finer->store_count, trace, finer);
    HATCH_TRY(first_failure(finer, err));
    for (uint32_t i = 0; i < finer->store_count; i++)
        HATCH_TRY(gather(finer, i, &sink, err));
    for (uint32_t i = 0; i < finer->store_count; i++)
        drop_unused(&finer->stores[i]);
    found->finer = found->enough = true;
    for (uint32_t i = 0; i < finer->store_count; i++)
        found->enough = found->enough && finer->stores[i].enough;
    return HATCH_OK;
}

/* Returns whether the view wants finer strokes than the mesh came with.
 *   most  out: strokes that it wants anywhere, per mesh unit */
static bool wants_finer(const struct hatch_finer *finer, double *most)
{
    double ink = 0, lack = 0, densest = finer->view->densest;
    *most = 0;
    for (uint32_t i = 0; i < finer->store_count; i++) {
        *most = fmax(*most, finer->stores[i].wanted);
        ink += finer->stores[i].ink;
        lack += finer->stores[i].lack;
    }
    if (!finer->view->alike)
        return *most > HATCH_FINER_START * densest;
    return *most > HATCH_FINER_ALIKE * densest &&
           (*most > HATCH_FINER_SPARED * densest || lack > HATCH_FINER_LACK * ink);
}

enum hatch_status hatch_finer_find(struct hatch_finer *finer, const struct hatch_finer_view *view,
                                   struct hatch_arena *arena, struct hatch_finer_found *found, struct hatch_err *err)
{
    double wanted;
    *found = (struct hatch_finer_found){.traced = 0};
    finer->view = view;
    for (uint32_t i = 0; i < finer->store_count; i++)
        for (uint32_t level = 0; level <= HATCH_FINER_LEVELS_MAX; level++)
            finer->windows[i][level] = (struct hatch_store_windows){NULL, 0, 0};
    hatch_parallel_for(finer->source.pool, finer->store_count, look, finer);
    enum hatch_status status = first_failure(finer, err);
    if (status == HATCH_OK && wants_finer(finer, &wanted)) {
        join_strokes(finer, wanted, found);
        status = trace_all(finer, arena, found, err);
    }
    for (uint32_t i = 0; i < finer->store_count; i++)
        hatch_arena_free(&finer->seen[i]);
    return status;
}

void hatch_finer_free(struct hatch_finer *finer)
{
    if (!finer)
        return;
    for (uint32_t i = 0; i < finer->store_count; i++) {
        while (finer->stores[i].batches) {
            struct hatch_store_batch *batch = finer->stores[i].batches;
            finer->stores[i].batches = batch->next;
            hatch_store_free_batch(batch);
        }
        hatch_arena_free(&finer->stores[i].keep);
        hatch_arena_free(&finer->stores[i].scratch);
        hatch_arena_free(&finer->seen[i]);
    }
    hatch_arena_free(&finer->scratch);
    struct hatch_arena keep = finer->keep; /* which holds *finer */
    hatch_arena_free(&keep);
}
