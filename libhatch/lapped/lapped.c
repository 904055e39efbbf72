#include "lapped/lapped.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "base/random.h"
#include "lapped/work.h"

/* The share of the radius wanted below which a patch is put off. */
#define KEPT_SHARE 0.5

/* A patch as it is kept until all are there. */
struct kept {
    struct hatch_lapped_patch patch;
    struct hatch_lapped_vertex *vertices;
    uint32_t *faces, *corners;
};

struct making {
    struct hatch_ground ground;
    struct hatch_growth growth;
    struct hatch_solver solver;
    struct hatch_cover cover;
    struct hatch_order order;
    const struct hatch_lapped_options *options;
    struct hatch_arena *arena;
    struct kept *kept;
    uint32_t count, room;
    uint32_t *shown, *fresh; /* local faces that show; faces newly covered */
    uint32_t shown_count, fresh_count, shown_room, fresh_room;
    uint32_t *renumbered, renumbered_room;
    struct hatch_lapped totals;
};

static enum hatch_status make_room(struct making *of, struct hatch_err *err)
{
    void *array = of->kept;
    HATCH_TRY(hatch_heap_reserve(of->arena, &array, &of->room, of->count + 1, sizeof *of->kept, err));
    of->kept = array;
    array = of->shown;
    HATCH_TRY(
        hatch_heap_reserve(of->arena, &array, &of->shown_room, of->growth.patch.face_count, sizeof *of->shown, err));
    of->shown = array;
    array = of->fresh;
    HATCH_TRY(
        hatch_heap_reserve(of->arena, &array, &of->fresh_room, of->growth.patch.face_count, sizeof *of->fresh, err));
    of->fresh = array;
    array = of->renumbered;
    HATCH_TRY(hatch_heap_reserve(of->arena, &array, &of->renumbered_room, of->growth.patch.vertex_count,
                                 sizeof *of->renumbered, err));
    of->renumbered = array;
    return HATCH_OK;
}

/* Lays the grown patch under what is there: notes which of its faces show and which it covers. The first face is
 * covered then, whatever rounding says of it where it is a needle. */
static enum hatch_status lay(struct making *of, struct hatch_err *err)
{
    const struct hatch_patch *patch = &of->growth.patch;
    of->shown_count = of->fresh_count = 0;
    for (uint32_t f = 0; f < patch->face_count; f++) {
        double mask[3][2];
        /* Outside the outline faces may be past the limits. */
        if (f > 0 && patch->past[f] == HATCH_LAPPED_PAST)
            continue;
        for (uint32_t c = 0; c < 3; c++)
            hatch_patch_mask(patch, &patch->place[2 * patch->corners[3 * f + c]], mask[c]);
        bool shows;
        of->totals.hidden_faces += of->cover.covered[patch->faces[f]];
        HATCH_TRY(hatch_cover_add(&of->cover, patch->faces[f], (const double(*)[2])mask, &shows, err));
        if (f == 0)
            of->cover.covered[patch->seed] = 1;
        if (shows)
            of->shown[of->shown_count++] = f;
        if ((shows || f == 0) && of->cover.covered[patch->faces[f]])
            of->fresh[of->fresh_count++] = patch->faces[f];
    }
    return HATCH_OK;
}

/* Out of the plane into what lapped.h says: y falls, lengths are the mesh's. */
static void write_vertex(const struct making *of, uint32_t vertex, double scale, struct hatch_lapped_vertex *to)
{
    const struct hatch_patch *patch = &of->growth.patch;
    const double *place = &patch->place[2 * vertex];
    double mask[2];
    hatch_patch_mask(patch, place, mask);
    to->point = patch->points[vertex];
    for (int i = 0; i < 2; i++) {
        to->hatch[i] = (i == 0 ? scale : -scale) * (place[i] - patch->center[i]);
        to->mask[i] = (float)mask[i];
    }
}

static enum hatch_status keep(struct making *of, double scale, struct hatch_err *err)
{
    const struct hatch_patch *patch = &of->growth.patch;
    struct kept kept = {.patch = {.face_count = of->shown_count, .radius = scale * patch->radius}};
    for (uint64_t i = 0; i < 2; i++)
        kept.patch.shift[i] = 2 * (double)hatch_random_unit(of->options->seed, patch->seed, i + 100) - 1;
    kept.faces = HATCH_NEW(of->arena, uint32_t, of->shown_count, err);
    kept.corners = kept.faces ? HATCH_NEW(of->arena, uint32_t, 3 * (size_t)of->shown_count, err) : NULL;
    if (!kept.corners)
        return HATCH_LIMIT;
    memset(of->renumbered, 0xff, patch->vertex_count * sizeof *of->renumbered);
    for (uint32_t i = 0; i < of->shown_count; i++) {
        kept.faces[i] = patch->faces[of->shown[i]];
        for (uint32_t c = 0; c < 3; c++) {
            uint32_t *number = &of->renumbered[patch->corners[3 * of->shown[i] + c]];
            if (*number == UINT32_MAX)
                *number = kept.patch.vertex_count++;
            kept.corners[3 * i + c] = *number;
        }
    }
    kept.vertices = HATCH_NEW(of->arena, struct hatch_lapped_vertex, kept.patch.vertex_count, err);
    if (!kept.vertices)
        return HATCH_LIMIT;
    for (uint32_t v = 0; v < patch->vertex_count; v++)
        if (of->renumbered[v] != UINT32_MAX)
            write_vertex(of, v, scale, &kept.vertices[of->renumbered[v]]);
    of->totals.vertex_count += kept.patch.vertex_count;
    of->totals.face_count += kept.patch.face_count;
    of->kept[of->count++] = kept;
    return HATCH_OK;
}

/* A patch that had to shrink much is better made when its neighbours are there: then it lies under
 * them, and what hindered it may be covered. The same is to be expected of the faces around. */
static void put_off(struct making *of, uint32_t seed)
{
    const struct hatch_patch *patch = &of->growth.patch;
    of->order.late[seed] = 1;
    for (uint32_t f = 0; f < patch->face_count; f++) {
        double mask[2];
        hatch_patch_mask(patch, &patch->place[2 * patch->corners[3 * f]], mask);
        if (hatch_outline_depth(of->growth.outline, mask) > 0)
            of->order.late[patch->faces[f]] = 1;
    }
}

static enum hatch_status make_patch(struct making *of, uint32_t seed, double scale, struct hatch_err *err)
{
    struct hatch_patch_notes notes;
    double least = of->order.filling ? 0 : KEPT_SHARE * of->ground.wish[seed];
    HATCH_TRY(hatch_patch_make(&of->growth, &of->solver, of->options, seed, least, &notes, err));
    of->totals.placed += notes.placed;
    if (notes.given_up) {
        put_off(of, seed);
        return HATCH_OK;
    }
    of->totals.cut += notes.cut;
    of->totals.enlarged += notes.enlarged;
    HATCH_TRY(make_room(of, err));
    HATCH_TRY(lay(of, err));
    if (of->shown_count > 0)
        HATCH_TRY(keep(of, scale, err));
    return hatch_order_covered(&of->order, of->fresh, of->fresh_count, err);
}

static enum hatch_status make_all(struct making *of, struct hatch_err *err)
{
    const struct hatch_surface *surface = of->ground.surface;
    for (uint32_t c = 0; c < surface->component_count; c++) {
        hatch_order_component(&of->order, c);
        for (;;) {
            uint32_t seed;
            HATCH_TRY(hatch_order_next(&of->order, &seed, err));
            if (seed == HATCH_NO_SIDE)
                break;
            HATCH_TRY(make_patch(of, seed, surface->components[c].scale, err));
        }
    }
    return HATCH_OK;
}

/* The patches in drawing order: the last one made lies lowest. */
static enum hatch_status gather(const struct making *of, struct hatch_arena *arena, struct hatch_lapped *lapped,
                                struct hatch_err *err)
{
    struct hatch_lapped made = of->totals;
    made.patch_count = of->count;
    made.patches = HATCH_NEW(arena, struct hatch_lapped_patch, made.patch_count, err);
    made.vertices = made.patches ? HATCH_NEW(arena, struct hatch_lapped_vertex, made.vertex_count, err) : NULL;
    made.faces = made.vertices ? HATCH_NEW(arena, uint32_t, made.face_count, err) : NULL;
    made.corners = made.faces ? HATCH_NEW(arena, uint32_t, 3 * (size_t)made.face_count, err) : NULL;
    if (!made.corners)
        return HATCH_LIMIT;
    uint32_t vertex = 0, face = 0;
    for (uint32_t i = 0; i < of->count; i++) {
        const struct kept *kept = &of->kept[of->count - 1 - i];
        made.patches[i] = kept->patch;
        made.patches[i].first_vertex = vertex;
        made.patches[i].first_face = face;
        memcpy(&made.vertices[vertex], kept->vertices, kept->patch.vertex_count * sizeof *kept->vertices);
        memcpy(&made.faces[face], kept->faces, kept->patch.face_count * sizeof *kept->faces);
        memcpy(&made.corners[3 * (size_t)face], kept->corners,
               3 * (size_t)kept->patch.face_count * sizeof *kept->corners);
        vertex += kept->patch.vertex_count;
        face += kept->patch.face_count;
    }
    *lapped = made;
    return HATCH_OK;
}

static enum hatch_status prepare(struct making *of, const struct hatch_surface *surface,
                                 const struct hatch_frames *frames, const double *direction,
                                 const struct hatch_outline *outline, struct hatch_pool *pool, struct hatch_err *err)
{
    struct hatch_arena *arena = of->arena;
    HATCH_TRY(
        hatch_ground_make(surface, frames, direction, outline, of->options, pool, arena, arena, &of->ground, err));
    HATCH_TRY(hatch_cover_make(outline, surface->face_count, arena, &of->cover, err));
    HATCH_TRY(hatch_growth_make(&of->ground, outline, of->cover.covered, arena, &of->growth, err));
    of->solver.arena = arena;
    return hatch_order_make(&of->ground, outline, of->cover.covered, arena, &of->order, err);
}

enum hatch_status hatch_lapped_make(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                    const double *direction, const double *confidence,
                                    const struct hatch_outline *outline, const struct hatch_lapped_options *options,
                                    struct hatch_pool *pool, struct hatch_arena *arena, struct hatch_arena *scratch,
                                    struct hatch_lapped *lapped, struct hatch_err *err)
{
    (void)confidence;
    assert(options->size >= 0 && options->size <= 1 && options->curved >= 0 && options->curved <= 1);
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct making making = {.options = options, .arena = scratch};
    enum hatch_status status = prepare(&making, surface, frames, direction, outline, pool, err);
    if (status == HATCH_OK)
        status = make_all(&making, err);
    if (status == HATCH_OK)
        status = gather(&making, arena, lapped, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}
