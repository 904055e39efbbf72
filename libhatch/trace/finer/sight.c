/* The part of the ground that a view shows, and the levels that are needed there. */
#include <float.h>
#include <math.h>

#include "math/vector.h"
#include "trace/finer/store.h"

#define DEPTH_PX 4.0      /* side of a pixel of the picture of depths */
#define DEPTHS_MAX 4096.0 /* pixels along its sides */
#define CORNERS_MAX 12    /* of a triangle cut by six planes, and one to spare */

/* A corner of the visible part of a face. */
struct corner {
    double clip[4], share[2]; /* shares of the face's corners 1 and 2 */
};

struct polygon {
    struct corner corners[CORNERS_MAX];
    int count;
};

/* A face on its way through the view. */
struct looking {
    struct hatch_store *store;
    const struct hatch_mesh *mesh;
    const struct hatch_finer_view *view;
    uint32_t face;
    double scale;      /* mesh units per surface unit */
    double clip[3][4]; /* of the corners of the ground's face */
    double ink[3];
    double side[2]; /* greatest |x| and |y|, as shares of w */
};

/* Cuts a polygon by the half space where the product with a plane is at least 0. */
static void cut(struct polygon *polygon, const double plane[4])
{
    struct polygon made = {.count = 0};
    for (int i = 0; i < polygon->count; i++) {
        const struct corner *a = &polygon->corners[i], *b = &polygon->corners[(i + 1) % polygon->count];
        double da = 0, db = 0;
        for (int k = 0; k < 4; k++) {
            da += plane[k] * a->clip[k];
            db += plane[k] * b->clip[k];
        }
        if (da >= 0 && made.count < CORNERS_MAX)
            made.corners[made.count++] = *a;
        if ((da >= 0) == (db >= 0) || made.count == CORNERS_MAX)
            continue;
        double t = da / (da - db);
        struct corner *between = &made.corners[made.count++];
        for (int k = 0; k < 4; k++)
            between->clip[k] = a->clip[k] + t * (b->clip[k] - a->clip[k]);
        for (int k = 0; k < 2; k++)
            between->share[k] = a->share[k] + t * (b->share[k] - a->share[k]);
    }
    *polygon = made;
}

static void project(struct looking *looking)
{
    const struct hatch_trace_ground *ground = &looking->store->ground;
    const uint32_t *vertex = &ground->surface->corner_vertex[3 * (size_t)ground->source[looking->face]];
    const float *positions = looking->mesh->attributes[0].data;
    const double *m = looking->view->clip_from_mesh;
    for (int c = 0; c < 3; c++) {
        double at[3];
        hatch_vec_of(&positions[3 * (size_t)vertex[c]], at);
        for (int k = 0; k < 4; k++)
            looking->clip[c][k] = m[k] * at[0] + m[4 + k] * at[1] + m[8 + k] * at[2] + m[12 + k];
    }
}

/* Finds the ink on the side of the face that is towards the eye. Returns whether that side is seen. */
static bool find_ink(struct looking *looking)
{
    const struct hatch_trace_ground *ground = &looking->store->ground;
    uint32_t from = ground->source[looking->face];
    const uint32_t *vertex = &ground->surface->corner_vertex[3 * (size_t)from];
    const uint32_t *corner = &looking->mesh->indices[3 * (size_t)ground->surface->face_source[from]];
    double m[3][3], edges[3];
    for (int c = 0; c < 3; c++) {
        m[c][0] = looking->clip[c][0];
        m[c][1] = looking->clip[c][1];
        m[c][2] = looking->clip[c][3];
    }
    hatch_vec_cross(m[1], m[2], edges);
    bool reversed =
        !((vertex[0] == corner[0] && vertex[1] == corner[1]) || (vertex[0] == corner[1] && vertex[1] == corner[2]) ||
          (vertex[0] == corner[2] && vertex[1] == corner[0]));
    bool front = (hatch_vec_dot(m[0], edges) > 0) != reversed;
    for (int c = 0; c < 3; c++)
        looking->ink[c] = looking->view->ink ? (double)looking->view->ink[2 * (size_t)vertex[c] + !front] : 1;
    return front ? looking->view->front : looking->view->behind;
}

/* Returns the part of the face that is in the picture. */
static struct polygon clip_face(const struct looking *looking)
{
    struct polygon polygon = {.count = 3};
    for (int c = 0; c < 3; c++) {
        for (int k = 0; k < 4; k++)
            polygon.corners[c].clip[k] = looking->clip[c][k];
        polygon.corners[c].share[0] = c == 1;
        polygon.corners[c].share[1] = c == 2;
    }
    cut(&polygon, (const double[4]){0, 0, 0, 1});
    for (int k = 0; k < 2 && polygon.count > 0; k++)
        for (int sign = -1; sign <= 1; sign += 2) {
            double plane[4] = {0, 0, 0, looking->side[k]};
            plane[k] = sign;
            cut(&polygon, plane);
        }
    return polygon;
}

/* Computes the change in pixels along an edge of the face. */
static void slope_along(const struct looking *looking, int corner, const double at[4], double slope[2])
{
    double size[2] = {looking->view->width_px / 2, looking->view->height_px / 2}, edge[4];
    for (int k = 0; k < 4; k++)
        edge[k] = looking->clip[corner][k] - looking->clip[0][k];
    for (int k = 0; k < 2; k++)
        slope[k] = (edge[k] - at[k] / at[3] * edge[3]) / at[3] * size[k];
}

/* Returns how many strokes per pixel may be drawn at a corner. */
static double most_at(const struct looking *looking, const struct corner *corner)
{
    const float *most = looking->view->most[looking->store->family];
    double ink = looking->ink[0];
    for (int k = 0; k < 2; k++)
        ink += corner->share[k] * (looking->ink[k + 1] - looking->ink[0]);
    double at = fmin(fmax(ink, 0), 1) * (HATCH_STROKE_TONES - 1), before = floor(at);
    uint32_t low = (uint32_t)before, high = low + 1 < HATCH_STROKE_TONES ? low + 1 : low;
    return (double)most[low] + (at - before) * ((double)most[high] - (double)most[low]);
}

/* Returns how many strokes per mesh unit may be drawn at a corner, times its w. */
static double wanted_at(const struct looking *looking, const struct corner *corner)
{
    const struct hatch_trace_face *face = &looking->store->ground.faces[looking->face];
    double slope[2][2], along[2], share[2];
    struct hatch_trace_place place = {.face = looking->face, .heading = {1, 0}};
    place.x = corner->share[0] * (double)face->x1 + corner->share[1] * (double)face->x2;
    place.y = corner->share[1] * (double)face->y2;
    slope_along(looking, 1, corner->clip, slope[0]);
    slope_along(looking, 2, corner->clip, slope[1]);
    double area_px = fabs(slope[0][0] * slope[1][1] - slope[0][1] * slope[1][0]);
    double area = (double)face->x1 * (double)face->y2 * looking->scale * looking->scale;
    double most = most_at(looking, corner) * corner->clip[3];
    if (!hatch_trace_direction(&looking->store->ground, &place, place.heading))
        return most * sqrt(area_px / area);
    share[1] = place.heading[1] / ((double)face->y2 * looking->scale);
    share[0] = (place.heading[0] / looking->scale - share[1] * (double)face->x2) / (double)face->x1;
    for (int k = 0; k < 2; k++)
        along[k] = share[0] * slope[0][k] + share[1] * slope[1][k];
    return most * area_px / (area * fmax(hypot(along[0], along[1]), DBL_MIN));
}

static enum hatch_status add_window(const struct looking *looking, const struct polygon *polygon,
                                    struct hatch_arena *arena, struct hatch_store_windows *windows,
                                    struct hatch_err *err)
{
    const struct hatch_trace_face *face = &looking->store->ground.faces[looking->face];
    struct hatch_trace_window window = {looking->face, {HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
    for (int i = 0; i < polygon->count; i++) {
        const double *share = polygon->corners[i].share;
        double at[2] = {share[0] * (double)face->x1 + share[1] * (double)face->x2, share[1] * (double)face->y2};
        for (int k = 0; k < 2; k++) {
            window.low[k] = fmin(window.low[k], at[k]);
            window.high[k] = fmax(window.high[k], at[k]);
        }
    }
    HATCH_TRY(
        hatch_curve_reserve(arena, &windows->items, sizeof *windows->items, windows->count, &windows->capacity, err));
    windows->items[windows->count++] = window;
    return HATCH_OK;
}

/* Finds the part of the face that is in the picture. Returns whether there is one. */
static bool find_polygon(struct looking *looking, struct polygon *polygon)
{
    project(looking);
    if (!find_ink(looking))
        return false;
    *polygon = clip_face(looking);
    for (int i = 0; i < polygon->count; i++)
        if (!(polygon->corners[i].clip[3] > 0))
            return false;
    return polygon->count >= 3;
}

/* Converts the corners of a polygon to the small picture of depths. */
static void find_depths(const struct looking *looking, const struct polygon *polygon,
                        struct hatch_depths_corner corners[CORNERS_MAX])
{
    double size[2] = {looking->store->depths.width, looking->store->depths.height};
    for (int i = 0; i < polygon->count; i++) {
        const double *clip = polygon->corners[i].clip;
        corners[i] =
            (struct hatch_depths_corner){(clip[0] / clip[3] / looking->side[0] + 1) / 2 * size[0],
                                         (clip[1] / clip[3] / looking->side[1] + 1) / 2 * size[1], clip[2] / clip[3]};
    }
}

/* Returns whether a part of the face that is in the picture may be seen. */
static bool shows(const struct looking *looking, const struct polygon *polygon)
{
    struct hatch_depths_corner corners[CORNERS_MAX] = {{0, 0, 0}};
    find_depths(looking, polygon, corners);
    return hatch_depths_show(&looking->store->depths, corners, polygon->count);
}

/* Returns the area of a polygon in the picture, in pixels. */
static double area_px(const struct looking *looking, const struct polygon *polygon)
{
    double sum = 0;
    for (int i = 0; i < polygon->count; i++) {
        const double *a = polygon->corners[i].clip, *b = polygon->corners[(i + 1) % polygon->count].clip;
        sum += (a[0] * b[1] - a[1] * b[0]) / (a[3] * b[3]);
    }
    return fabs(sum) / 8 * looking->view->width_px * looking->view->height_px;
}

/* Finds how many strokes the face wants, and how much ink. */
static void measure_face(struct looking *looking)
{
    struct hatch_store *store = looking->store;
    const double fade = looking->view->alike ? 1 : HATCH_STROKE_FADE;
    double densest = looking->view->densest, area;
    struct polygon polygon;
    if (!find_polygon(looking, &polygon) || !shows(looking, &polygon))
        return;
    area = area_px(looking, &polygon) / polygon.count;
    for (int i = 0; i < polygon.count; i++) {
        const struct corner *corner = &polygon.corners[i];
        double wanted = wanted_at(looking, corner) / (fade * corner->clip[3]), ink = area * most_at(looking, corner);
        store->wanted = fmax(store->wanted, wanted);
        store->ink += ink;
        store->lack += wanted > densest ? ink * (1 - densest / wanted) : 0;
    }
}

/* Adds the windows of the face. */
static enum hatch_status add_windows(struct looking *looking, struct hatch_arena *arena,
                                     struct hatch_store_windows *windows, struct hatch_err *err)
{
    struct hatch_store *store = looking->store;
    struct polygon polygon;
    double wanted = 0;
    if (!find_polygon(looking, &polygon))
        return HATCH_OK;
    HATCH_TRY(add_window(looking, &polygon, arena, &windows[0], err));
    if (!shows(looking, &polygon))
        return HATCH_OK;
    for (int i = 0; i < polygon.count; i++)
        wanted = fmax(wanted, fmin(wanted_at(looking, &polygon.corners[i]), store->drawn * polygon.corners[i].clip[3]));
    for (uint32_t i = 1; i <= looking->view->levels; i++) {
        double gap = ldexp(store->options.gap, 1 - (int)(store->level_count + i));
        struct polygon part = polygon;
        for (int c = 0; c < part.count; c++) /* how much nearer a corner is than the level is needed */
            part.corners[c].clip[3] = wanted * gap / (HATCH_STORE_LEAST * store->raised) - part.corners[c].clip[3];
        cut(&part, (const double[4]){0, 0, 0, 1});
        if (part.count < 3)
            break;
        store->enough = store->enough && i < looking->view->levels;
        HATCH_TRY(add_window(looking, &part, arena, &windows[i], err));
    }
    return HATCH_OK;
}

/* Draws the faces in the small picture of depths. */
static enum hatch_status draw_depths(struct looking *looking, struct hatch_arena *arena, struct hatch_err *err)
{
    const struct hatch_finer_view *view = looking->view;
    struct hatch_depths *depths = &looking->store->depths;
    double size[2] = {view->width_px * looking->side[0], view->height_px * looking->side[1]};
    HATCH_TRY(hatch_depths_make((int)fmin(fmax(size[0] / DEPTH_PX, 1), DEPTHS_MAX),
                                (int)fmin(fmax(size[1] / DEPTH_PX, 1), DEPTHS_MAX), arena, depths, err));
    for (looking->face = 0; looking->face < looking->store->ground.surface->face_count; looking->face++) {
        struct hatch_depths_corner corners[CORNERS_MAX];
        struct polygon polygon;
        if (!find_polygon(looking, &polygon))
            continue;
        find_depths(looking, &polygon, corners);
        hatch_depths_draw(depths, corners, polygon.count);
    }
    return HATCH_OK;
}

static struct looking begin_looking(struct hatch_store *store, const struct hatch_mesh *mesh,
                                    const struct hatch_finer_view *view)
{
    struct looking looking = {.store = store, .mesh = mesh, .view = view};
    looking.side[0] = 1 + 2 * view->margin_px / view->width_px;
    looking.side[1] = 1 + 2 * view->margin_px / view->height_px;
    return looking;
}

/* Looks at all faces.
 *   windows  NULL: what they want is measured */
static enum hatch_status look_at_faces(struct looking *looking, struct hatch_arena *arena,
                                       struct hatch_store_windows *windows, struct hatch_err *err)
{
    const struct hatch_surface *surface = looking->store->ground.surface;
    for (uint32_t c = 0; c < surface->component_count; c++) {
        const struct hatch_component *component = &surface->components[c];
        looking->scale = component->scale;
        for (uint32_t f = component->first_face; f < component->first_face + component->face_count; f++) {
            looking->face = f;
            if (windows)
                HATCH_TRY(add_windows(looking, arena, windows, err));
            else
                measure_face(looking);
        }
    }
    return HATCH_OK;
}

enum hatch_status hatch_store_look(struct hatch_store *store, const struct hatch_mesh *mesh,
                                   const struct hatch_finer_view *view, struct hatch_arena *arena,
                                   struct hatch_err *err)
{
    struct looking looking = begin_looking(store, mesh, view);
    store->wanted = store->ink = store->lack = 0;
    HATCH_TRY(draw_depths(&looking, arena, err));
    return look_at_faces(&looking, arena, NULL, err);
}

enum hatch_status hatch_store_find_windows(struct hatch_store *store, const struct hatch_mesh *mesh,
                                           const struct hatch_finer_view *view, struct hatch_arena *arena,
                                           struct hatch_store_windows windows[HATCH_FINER_LEVELS_MAX + 1],
                                           struct hatch_err *err)
{
    struct looking looking = begin_looking(store, mesh, view);
    store->enough = true;
    return look_at_faces(&looking, arena, windows, err);
}
