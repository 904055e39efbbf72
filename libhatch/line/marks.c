#include "line/marks.h"

#include "base/random.h"
#include "math/vector.h"

#define SPACING_PX 11.0 /* least distance between marks */
#define LENGTH 0.9      /* length of a mark, in spacings */
#define MARKS_MAX 200000u
#define TRIES 8  /* random positions that are tried per square with the spacing as its side */
#define CELLS 96 /* number of cells along a side of the grid over the unit scene */

static const struct hatch_mesh *surface_of(const struct hatch_unit_scene *scene, const struct hatch_item *item)
{
    return scene->meshes[item->mesh].surface;
}

/* The marks made so far. For tests of distance they are in lists, one for each cell of a grid. */
struct spread {
    struct hatch_marks *marks;
    double spacing;
    uint32_t *head; /* per cell: its first mark + 1; 0: none */
    uint32_t *next; /* per mark: the next one in its cell + 1; 0: none */
    double *place;  /* 6 per mark: position, and normal of its face */
    uint64_t tried; /* number of random positions so far */
};

static void corners_of(const struct hatch_marks *marks, const struct hatch_mesh *surface, uint32_t face,
                       const double *corner[3])
{
    for (size_t c = 0; c < 3; c++)
        corner[c] = marks->positions + 3 * (size_t)surface->indices[3 * (size_t)face + c];
}

static int cell_along(double at)
{
    double cell = floor((at + 1) * (0.5 * CELLS));
    return cell < 0 ? 0 : cell >= CELLS ? CELLS - 1 : (int)cell;
}

/* Returns whether no other mark is within the spacing. Marks on faces that point the opposite way are ignored, so that
 * both sides of a thin sheet get marks. */
static bool is_free(const struct spread *spread, const double place[6])
{
    int low[3], high[3];
    for (int k = 0; k < 3; k++) {
        low[k] = cell_along(place[k] - spread->spacing);
        high[k] = cell_along(place[k] + spread->spacing);
    }
    for (int x = low[0]; x <= high[0]; x++)
        for (int y = low[1]; y <= high[1]; y++)
            for (int z = low[2]; z <= high[2]; z++)
                for (uint32_t m = spread->head[(x * CELLS + y) * CELLS + z]; m; m = spread->next[m - 1]) {
                    const double *other = spread->place + 6 * (size_t)(m - 1);
                    if (hatch_vec_distance(place, other) < spread->spacing && hatch_vec_dot(place + 3, other + 3) > 0)
                        return false;
                }
    return true;
}

/* Computes the direction and confidence at a mark's position from those of the face's corners, whose signs are first
 * made consistent. Returns false where the direction is undefined. */
static bool direction_at(const struct hatch_mesh *surface, struct hatch_mark *mark)
{
    const float *directions = hatch_mesh_find(surface, "_HATCH_DIR", 4);
    const uint32_t *index = surface->indices + 3 * (size_t)mark->face;
    double sum[3] = {0, 0, 0}, first[3], corners[3][3], edges[2][3];
    hatch_vec_of(directions + 4 * (size_t)index[0], first);
    mark->confidence = 0;
    for (int c = 0; c < 3; c++) {
        double direction[3];
        hatch_vec_of(directions + 4 * (size_t)index[c], direction);
        double share = (double)mark->share[c];
        mark->confidence += mark->share[c] * directions[4 * (size_t)index[c] + 3];
        hatch_vec_add_scaled(sum, hatch_vec_dot(direction, first) < 0 ? -share : share, direction, sum);
    }
    if (!hatch_mesh_corners(surface, mark->face, corners))
        return false;
    for (int e = 0; e < 2; e++)
        hatch_vec_sub(corners[e + 1], corners[0], edges[e]);
    double aa = hatch_vec_dot(edges[0], edges[0]), ab = hatch_vec_dot(edges[0], edges[1]);
    double bb = hatch_vec_dot(edges[1], edges[1]), det = aa * bb - ab * ab;
    double a = hatch_vec_dot(edges[0], sum), b = hatch_vec_dot(edges[1], sum);
    double along[2] = {(a * bb - b * ab) / det, (b * aa - a * ab) / det};
    mark->velocity[0] = (float)(-along[0] - along[1]);
    mark->velocity[1] = (float)along[0];
    mark->velocity[2] = (float)along[1];
    return det > 0 && isfinite(along[0]) && isfinite(along[1]) && (along[0] != 0 || along[1] != 0);
}

/* Adds a mark at a random position of a face, unless another one is too close or there is no direction. */
static void try_mark(struct spread *spread, const struct hatch_mesh *surface, uint32_t face,
                     const double *const corner[3])
{
    struct hatch_marks *marks = spread->marks;
    struct hatch_mark mark = {.face = face};
    double place[6] = {0, 0, 0};
    double u = (double)hatch_random_unit(1, 0, spread->tried), v = (double)hatch_random_unit(1, 1, spread->tried);
    spread->tried++;
    if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
    }
    const double share[3] = {1 - u - v, u, v};
    for (int c = 0; c < 3; c++) {
        mark.share[c] = (float)share[c];
        hatch_vec_add_scaled(place, share[c], corner[c], place);
    }
    hatch_vec_triangle(corner[0], corner[1], corner[2], place + 3);
    if (marks->count == MARKS_MAX || !is_free(spread, place) || !direction_at(surface, &mark))
        return;
    uint32_t *head =
        &spread->head[(cell_along(place[0]) * CELLS + cell_along(place[1])) * CELLS + cell_along(place[2])];
    for (int i = 0; i < 6; i++)
        spread->place[6 * (size_t)marks->count + (size_t)i] = place[i];
    marks->at[marks->count] = mark;
    spread->next[marks->count++] = *head;
    *head = marks->count;
}

static double area_of(const double *const corner[3])
{
    double normal[3];
    hatch_vec_triangle(corner[0], corner[1], corner[2], normal);
    return 0.5 * hatch_vec_length(normal);
}

/* Makes marks on all faces with directions; returns the area of these faces.
 *   spread  NULL: computes the area only */
static double visit_faces(struct hatch_marks *marks, struct spread *spread)
{
    const struct hatch_unit_scene *scene = marks->scene;
    double area = 0, owed = 0;
    for (uint32_t i = 0; i < scene->item_count; i++) {
        const struct hatch_mesh *surface = surface_of(scene, &scene->items[i]);
        bool has = hatch_mesh_find(surface, "_HATCH_DIR", 4) != NULL;
        if (has)
            hatch_item_surface(scene, &scene->items[i], marks->positions, NULL);
        for (uint32_t face = 0; face < surface->face_count && has; face++) {
            const double *corner[3];
            corners_of(marks, surface, face, corner);
            double here = area_of(corner);
            area += isfinite(here) ? here : 0;
            if (!spread || !isfinite(here))
                continue;
            for (owed += TRIES * here / (spread->spacing * spread->spacing); owed >= 1; owed--)
                try_mark(spread, surface, face, corner);
        }
        marks->item_end[i] = marks->count;
    }
    return area;
}

static enum hatch_status spread_marks(struct hatch_marks *marks, const struct hatch_view *view, double height_px,
                                      struct hatch_arena *scratch, struct hatch_err *err)
{
    static const double middle[3] = {0, 0, 0};
    double area = visit_faces(marks, NULL);
    struct spread spread = {.marks = marks,
                            .spacing = SPACING_PX / hatch_view_pixels_per_unit(view, middle, height_px)};
    if (!(spread.spacing > 0) || !isfinite(spread.spacing))
        spread.spacing = 0.02;
    /* Limits the number of marks, of which there are about area / spacing². */
    spread.spacing = fmax(spread.spacing, sqrt(area / MARKS_MAX));
    marks->half_length = 0.5 * LENGTH * spread.spacing;
    HATCH_TRY(HATCH_ALLOC(scratch, &spread.head, (size_t)CELLS * CELLS * CELLS, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &spread.next, MARKS_MAX, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &spread.place, 6 * (size_t)MARKS_MAX, err));
    visit_faces(marks, &spread);
    return HATCH_OK;
}

enum hatch_status hatch_marks_make(const struct hatch_unit_scene *scene, const struct hatch_view *view,
                                   double height_px, struct hatch_arena *arena, struct hatch_arena *scratch,
                                   struct hatch_marks *marks, struct hatch_err *err)
{
    struct hatch_marks made = {.scene = scene};
    bool any = false;
    for (uint32_t i = 0; i < scene->item_count; i++)
        any = any || hatch_mesh_find(surface_of(scene, &scene->items[i]), "_HATCH_DIR", 4);
    if (!any)
        return hatch_fail(err, HATCH_BAD_INPUT, "no mesh has directions; add them with dirfield");
    HATCH_TRY(HATCH_ALLOC(arena, &made.positions, 3 * (size_t)hatch_unit_scene_vertices_max(scene), err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.item_end, scene->item_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.at, MARKS_MAX, err));
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = spread_marks(&made, view, height_px, scratch, err);
    hatch_arena_rewind(scratch, mark);
    HATCH_TRY(status);
    HATCH_TRY(HATCH_ALLOC(arena, &made.lines, made.count, err));
    *marks = made;
    return HATCH_OK;
}

static void place_mark(const struct hatch_marks *marks, const struct hatch_mesh *surface, const struct hatch_mark *mark,
                       struct hatch_mark_line *line)
{
    const double *corner[3];
    double middle[3] = {0, 0, 0}, along[3] = {0, 0, 0};
    corners_of(marks, surface, mark->face, corner);
    for (int c = 0; c < 3; c++) {
        hatch_vec_add_scaled(middle, (double)mark->share[c], corner[c], middle);
        hatch_vec_add_scaled(along, (double)mark->velocity[c], corner[c], along);
    }
    double length = hatch_vec_length(along);
    for (int k = 0; k < 3; k++) {
        line->middle[k] = (float)middle[k];
        line->half[k] = length > 0 ? (float)(marks->half_length * along[k] / length) : 0.0f;
    }
    line->confidence = mark->confidence;
}

void hatch_marks_place(struct hatch_marks *marks)
{
    const struct hatch_unit_scene *scene = marks->scene;
    uint32_t at = 0;
    for (uint32_t i = 0; i < scene->item_count; i++) {
        const struct hatch_item *item = &scene->items[i];
        if (at < marks->item_end[i])
            hatch_item_surface(scene, item, marks->positions, NULL);
        for (; at < marks->item_end[i]; at++)
            place_mark(marks, surface_of(scene, item), &marks->at[at], &marks->lines[at]);
    }
}
