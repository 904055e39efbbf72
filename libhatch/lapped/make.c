#include <assert.h>
#include <string.h>

#include "base/random.h"
#include "lapped/work.h"

/* Share of the target radius below which a patch is postponed. */
#define RADIUS_SHARE_MIN 0.5

/* When texture coordinates were computed this many times per face of a component, its later patches have at most
 * FACES_LATE faces: around a point of thousands of faces, each patch would take most of them in vain. */
#define SOLVED_MAX 64
#define FACES_LATE 64u

/* A patch stored until all are made. */
struct finished_patch {
    struct hatch_lapped_patch patch;
    struct hatch_lapped_vertex *vertices;
    uint32_t *faces, *corners;
};

struct making {
    struct hatch_patch_domain domain;
    struct hatch_growth growth;
    struct hatch_solver solver;
    struct hatch_core_coverage coverage;
    struct hatch_order order;
    const struct hatch_lapped_options *options;
    struct hatch_arena *arena;
    struct finished_patch *finished;
    uint32_t count, capacity;
    uint32_t *shown;         /* local faces of the patch that are visible */
    uint32_t *newly_covered; /* the surface's faces that the patch has covered */
    uint32_t shown_count, newly_covered_count, shown_capacity, newly_covered_capacity;
    uint32_t *renumbered, renumbered_capacity; /* per local vertex: its number in the stored patch, or UINT32_MAX */
    struct hatch_lapped totals;
    uint32_t covered;                        /* number of faces that patches cover */
    const struct hatch_component *component; /* the present one */
    uint64_t component_solved;               /* solved_faces of its patches */
    uint32_t faces_max;                      /* largest number of faces of one patch before a component is limited */
};

static enum hatch_status reserve_arrays(struct making *making, struct hatch_err *err)
{
    void *array = making->finished;
    HATCH_TRY(hatch_lapped_reserve(making->arena, &array, &making->capacity, making->count + 1,
                                   sizeof *making->finished, err));
    making->finished = array;
    array = making->shown;
    HATCH_TRY(hatch_lapped_reserve(making->arena, &array, &making->shown_capacity, making->growth.patch.face_count,
                                   sizeof *making->shown, err));
    making->shown = array;
    array = making->newly_covered;
    HATCH_TRY(hatch_lapped_reserve(making->arena, &array, &making->newly_covered_capacity,
                                   making->growth.patch.face_count, sizeof *making->newly_covered, err));
    making->newly_covered = array;
    array = making->renumbered;
    HATCH_TRY(hatch_lapped_reserve(making->arena, &array, &making->renumbered_capacity,
                                   making->growth.patch.vertex_count, sizeof *making->renumbered, err));
    making->renumbered = array;
    return HATCH_OK;
}

/* Computes the mask coordinates of a local face's corners. */
static void face_mask(const struct hatch_patch *patch, uint32_t local, double mask[3][2])
{
    for (uint32_t c = 0; c < 3; c++)
        hatch_patch_mask(patch, &patch->xy[2 * patch->corners[3 * local + c]], mask[c]);
}

/* Returns whether the patches before it, which had entry_count entries, hide the patch on all faces listed in shown. */
static bool is_hidden(const struct making *making, uint32_t entry_count)
{
    const struct hatch_patch *patch = &making->growth.patch;
    for (uint32_t i = 0; i < making->shown_count; i++) {
        double mask[3][2];
        face_mask(patch, making->shown[i], mask);
        if (!hatch_core_coverage_hides(&making->coverage, entry_count, patch->faces[making->shown[i]],
                                       (const double(*)[2])mask))
            return false;
    }
    return true;
}

/* Adds the patch below the earlier ones: lists the faces on which it is visible and those that it covers. The seed face
 * counts as covered even where, on a needle, rounding makes it appear uncovered. A hidden patch has no visible faces;
 * the faces that it covers are covered by the earlier patches alone. */
static enum hatch_status add_to_coverage(struct making *making, struct hatch_err *err)
{
    const struct hatch_patch *patch = &making->growth.patch;
    uint32_t entry_count = making->coverage.entry_count;
    bool certain = false;
    making->shown_count = making->newly_covered_count = 0;
    for (uint32_t f = 0; f < patch->face_count; f++) {
        double mask[3][2];
        /* Faces that exceed a limit lie outside the outline. */
        if (f > 0 && patch->limit_state[f] == HATCH_LAPPED_EXCEEDED)
            continue;
        face_mask(patch, f, mask);
        enum hatch_visibility visible;
        HATCH_TRY(hatch_core_coverage_add(&making->coverage, patch->faces[f], (const double(*)[2])mask, &visible, err));
        if (f == 0)
            making->coverage.covered[patch->seed_face] = 1;
        if (visible != HATCH_LAPPED_HIDDEN)
            making->shown[making->shown_count++] = f;
        if ((visible != HATCH_LAPPED_HIDDEN || f == 0) && making->coverage.covered[patch->faces[f]])
            making->newly_covered[making->newly_covered_count++] = patch->faces[f];
        certain = certain || visible == HATCH_LAPPED_VISIBLE;
    }
    if (!certain && is_hidden(making, entry_count))
        making->shown_count = 0;
    return HATCH_OK;
}

/* Converts a vertex from the patch's plane to the mesh's units, with v = -y. */
static void write_vertex(const struct making *making, uint32_t vertex, double scale, struct hatch_lapped_vertex *to)
{
    const struct hatch_patch *patch = &making->growth.patch;
    const double *xy = &patch->xy[2 * vertex];
    double mask[2];
    hatch_patch_mask(patch, xy, mask);
    to->point = patch->points[vertex];
    for (int i = 0; i < 2; i++) {
        to->hatch[i] = (i == 0 ? scale : -scale) * (xy[i] - patch->center[i]);
        to->mask[i] = (float)mask[i];
    }
}

static enum hatch_status store_patch(struct making *making, double scale, struct hatch_err *err)
{
    const struct hatch_patch *patch = &making->growth.patch;
    struct finished_patch finished = {.patch = {.face_count = making->shown_count, .radius = scale * patch->radius}};
    for (uint64_t i = 0; i < 2; i++)
        finished.patch.shift[i] = 2 * (double)hatch_random_unit(making->options->seed, patch->seed_face, i + 100) - 1;
    HATCH_TRY(HATCH_ALLOC(making->arena, &finished.faces, making->shown_count, err));
    HATCH_TRY(HATCH_ALLOC(making->arena, &finished.corners, 3 * (size_t)making->shown_count, err));
    memset(making->renumbered, 0xff, patch->vertex_count * sizeof *making->renumbered);
    for (uint32_t i = 0; i < making->shown_count; i++) {
        finished.faces[i] = patch->faces[making->shown[i]];
        for (uint32_t c = 0; c < 3; c++) {
            uint32_t *number = &making->renumbered[patch->corners[3 * making->shown[i] + c]];
            if (*number == UINT32_MAX)
                *number = finished.patch.vertex_count++;
            finished.corners[3 * i + c] = *number;
        }
    }
    HATCH_TRY(HATCH_ALLOC(making->arena, &finished.vertices, finished.patch.vertex_count, err));
    for (uint32_t v = 0; v < patch->vertex_count; v++)
        if (making->renumbered[v] != UINT32_MAX)
            write_vertex(making, v, scale, &finished.vertices[making->renumbered[v]]);
    making->totals.vertex_count += finished.patch.vertex_count;
    making->totals.face_count += finished.patch.face_count;
    making->finished[making->count++] = finished;
    return HATCH_OK;
}

/* Called for a patch that had to shrink much: postpones its seed face, and the faces in its core, until their
 * neighbours are covered. A patch made there then lies below those of its neighbours, and the faces that hindered it
 * may be covered. */
static void postpone(struct making *making, uint32_t seed_face)
{
    const struct hatch_patch *patch = &making->growth.patch;
    making->order.postponed[seed_face] = 1;
    for (uint32_t f = 0; f < patch->face_count; f++) {
        double mask[2];
        hatch_patch_mask(patch, &patch->xy[2 * patch->corners[3 * f]], mask);
        if (hatch_outline_depth(making->growth.outline, mask) > 0)
            making->order.postponed[patch->faces[f]] = 1;
    }
}

static void start_component(struct making *making, uint32_t component)
{
    making->component = &making->domain.surface->components[component];
    making->component_solved = 0;
    making->domain.faces_max = making->faces_max;
    hatch_order_start_component(&making->order, component);
}

/* Limits later patches of the component to FACES_LATE faces. */
static void limit_later(struct making *making)
{
    uint32_t *most = &making->growth.start_faces_max[making->component->first_face];
    making->domain.faces_max = FACES_LATE;
    for (uint32_t f = 0; f < making->component->face_count; f++)
        most[f] = most[f] < FACES_LATE ? most[f] : FACES_LATE;
}

static enum hatch_status make_patch(struct making *making, uint32_t seed_face, double scale, struct hatch_err *err)
{
    struct hatch_patch_notes notes;
    double radius_min = making->order.filling_gaps ? 0 : RADIUS_SHARE_MIN * making->domain.target_radius[seed_face];
    HATCH_TRY(hatch_patch_make(&making->growth, &making->solver, making->options, seed_face, radius_min, &notes, err));
    making->totals.solved_faces += notes.solved_faces;
    making->component_solved += notes.solved_faces;
    if (making->component_solved > SOLVED_MAX * (uint64_t)making->component->face_count &&
        making->domain.faces_max > FACES_LATE)
        limit_later(making);
    if (notes.given_up) {
        postpone(making, seed_face);
        return HATCH_OK;
    }
    HATCH_TRY(reserve_arrays(making, err));
    HATCH_TRY(add_to_coverage(making, err));
    if (making->shown_count > 0) {
        making->totals.cut_count += notes.cut;
        making->totals.enlarged_count += notes.enlarged;
        HATCH_TRY(store_patch(making, scale, err));
    }
    making->covered += making->newly_covered_count;
    hatch_progress_report(making->options->progress, (double)making->covered / making->domain.surface->face_count);
    return hatch_order_add_covered(&making->order, making->newly_covered, making->newly_covered_count, err);
}

static enum hatch_status make_all(struct making *making, struct hatch_err *err)
{
    const struct hatch_surface *surface = making->domain.surface;
    for (uint32_t c = 0; c < surface->component_count; c++) {
        start_component(making, c);
        for (;;) {
            uint32_t seed_face;
            HATCH_TRY(hatch_order_next(&making->order, &seed_face, err));
            if (seed_face == HATCH_NO_SIDE)
                break;
            HATCH_TRY(make_patch(making, seed_face, surface->components[c].scale, err));
        }
    }
    return HATCH_OK;
}

/* Copies the patches to arena in drawing order, in which the last one made is the lowest. */
static enum hatch_status gather(const struct making *making, struct hatch_arena *arena, struct hatch_lapped *lapped,
                                struct hatch_err *err)
{
    struct hatch_lapped made = making->totals;
    made.patch_count = making->count;
    HATCH_TRY(HATCH_ALLOC(arena, &made.patches, made.patch_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.vertices, made.vertex_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.faces, made.face_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.corners, 3 * (size_t)made.face_count, err));
    uint32_t vertex = 0, face = 0;
    for (uint32_t i = 0; i < making->count; i++) {
        const struct finished_patch *finished = &making->finished[making->count - 1 - i];
        made.patches[i] = finished->patch;
        made.patches[i].first_vertex = vertex;
        made.patches[i].first_face = face;
        memcpy(&made.vertices[vertex], finished->vertices, finished->patch.vertex_count * sizeof *finished->vertices);
        memcpy(&made.faces[face], finished->faces, finished->patch.face_count * sizeof *finished->faces);
        memcpy(&made.corners[3 * (size_t)face], finished->corners,
               3 * (size_t)finished->patch.face_count * sizeof *finished->corners);
        vertex += finished->patch.vertex_count;
        face += finished->patch.face_count;
    }
    *lapped = made;
    return HATCH_OK;
}

static enum hatch_status prepare(struct making *making, const struct hatch_lapped_input *input, struct hatch_pool *pool,
                                 struct hatch_err *err)
{
    struct hatch_arena *arena = making->arena;
    uint32_t face_count = input->surface->face_count;
    HATCH_TRY(hatch_patch_domain_make(input, making->options, pool, arena, arena, &making->domain, err));
    making->faces_max = making->domain.faces_max;
    HATCH_TRY(hatch_core_coverage_make(input->outline, face_count, arena, &making->coverage, err));
    const uint8_t *covered = making->coverage.covered;
    HATCH_TRY(hatch_growth_make(&making->domain, input->outline, covered, arena, &making->growth, err));
    making->solver.arena = arena;
    return hatch_order_make(&making->domain, input->outline, covered, arena, &making->order, err);
}

enum hatch_status hatch_lapped_make(const struct hatch_lapped_input *input, const struct hatch_lapped_options *options,
                                    struct hatch_pool *pool, struct hatch_arena *arena, struct hatch_arena *scratch,
                                    struct hatch_lapped *lapped, struct hatch_err *err)
{
    assert(options->size >= 0 && options->size <= 1 && options->curved >= 0 && options->curved <= 1);
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct making making = {.options = options, .arena = scratch};
    enum hatch_status status = prepare(&making, input, pool, err);
    if (status == HATCH_OK)
        status = make_all(&making, err);
    if (status == HATCH_OK)
        status = gather(&making, arena, lapped, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}
