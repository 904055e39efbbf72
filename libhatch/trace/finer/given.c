/* The strokes that a mesh came with, laid on the ground: between two points, on all faces that lie between them. */
#include <math.h>

#include "math/vector.h"
#include "trace/finer/store.h"

#define LEGS_MAX 4096u /* from a point to the next */
#define DETOUR 2.0     /* longest way to the next point, in distances */
#define DRIFT_MAX 0.1  /* greatest mean: drawn thresholds differ more where strokes are missing, as on small parts */

struct placing {
    struct hatch_store *store;
    const struct hatch_finer_source *source;
    const uint32_t *of_mesh; /* per face of the mesh: face of the ground, or HATCH_NO_SIDE */
};

/* Converts a point of the mesh. Returns false for one on a face that the ground lacks. */
static bool find_place(const struct placing *placing, const struct hatch_curve_point *point,
                       struct hatch_trace_place *place)
{
    const struct hatch_trace_ground *ground = &placing->store->ground;
    const struct hatch_mesh *mesh = placing->source->mesh;
    uint32_t number = placing->of_mesh[point->face];
    if (number == HATCH_NO_SIDE)
        return false;
    const uint32_t *vertex = &ground->surface->corner_vertex[3 * (size_t)ground->source[number]];
    const double shares[3] = {1 - (double)point->share[0] - (double)point->share[1], (double)point->share[0],
                              (double)point->share[1]};
    double corner[3][2];
    hatch_trace_corners(&ground->faces[number], corner);
    *place = (struct hatch_trace_place){.face = number};
    for (int c = 0; c < 3; c++)
        for (int of = 0; of < 3; of++)
            if (vertex[c] == mesh->indices[3 * (size_t)point->face + (size_t)of]) {
                place->x += shares[of] * corner[c][0];
                place->y += shares[of] * corner[c][1];
            }
    return true;
}

/* Heads for another place. Returns the distance. */
static double aim(const struct hatch_trace_ground *ground, struct hatch_trace_place *place, const double to[3])
{
    const struct hatch_trace_pose *pose = &ground->poses[place->face];
    double at[3], way[3], u[3], v[3], distance;
    hatch_trace_position(pose, place->x, place->y, at);
    hatch_vec_sub(to, at, way);
    hatch_vec_of(pose->u, u);
    hatch_vec_of(pose->v, v);
    place->heading[0] = hatch_vec_dot(way, u);
    place->heading[1] = hatch_vec_dot(way, v);
    distance = hypot(place->heading[0], place->heading[1]);
    for (int k = 0; k < 2; k++)
        place->heading[k] = distance > 0 ? place->heading[k] / distance : 1 - k;
    return hatch_vec_length(way);
}

static enum hatch_status add_leg(struct hatch_store *store, uint32_t face, const double from[2], const double to[2],
                                 double *arc, struct hatch_err *err)
{
    double length = hypot(to[0] - from[0], to[1] - from[1]);
    if (!(length > 0))
        return HATCH_OK;
    *arc += length;
    const struct hatch_store_piece piece = {
        .face = face, .from = {from[0], from[1]}, .to = {to[0], to[1]}, .arc = *arc};
    return hatch_store_add_piece(&store->given, &store->keep, &piece, err);
}

/* Adds the pieces from one place to another: straight towards it, face by face. Where the way does not lead there, as
 * across the border of the ground, it is left open. */
static enum hatch_status add_way(struct hatch_store *store, struct hatch_trace_place from,
                                 const struct hatch_trace_place *to, double *arc, struct hatch_err *err)
{
    double goal[3], walked = 0, start;
    hatch_trace_position(&store->ground.poses[to->face], to->x, to->y, goal);
    start = aim(&store->ground, &from, goal);
    for (uint32_t n = 0; n < LEGS_MAX && from.face != to->face; n++) {
        struct hatch_trace_leg leg;
        double left = aim(&store->ground, &from, goal);
        bool goes_on = left > 0 && walked <= DETOUR * start &&
                       hatch_trace_walk(&store->ground, &from, DETOUR * start, HATCH_TRACE_STRAIGHT, &leg);
        if (!goes_on)
            return HATCH_OK;
        walked += leg.length + 1e-6 * start; /* so that ways that lead nowhere end */
        HATCH_TRY(add_leg(store, leg.face, leg.from, leg.to, arc, err));
    }
    const double ends[2][2] = {{from.x, from.y}, {to->x, to->y}};
    return from.face == to->face ? add_leg(store, to->face, ends[0], ends[1], arc, err) : HATCH_OK;
}

/* Sets the thresholds of the pieces from one point to the next, by interpolation of their logarithms. */
static void set_thresholds(struct hatch_store_piece *pieces, uint32_t count, double before, double from, double to)
{
    double length = count > 0 ? pieces[count - 1].arc - before : 0;
    for (uint32_t i = 0; i < count; i++)
        pieces[i].log_threshold = (float)(from + (to - from) * (pieces[i].arc - before) / length);
}

/* Adds a curve; drops it if none of it is on the ground. */
static enum hatch_status add_curve(const struct placing *placing, const struct hatch_curve *curve, uint32_t level,
                                   struct hatch_err *err)
{
    struct hatch_store *store = placing->store;
    const struct hatch_curve_point *points = &placing->source->curves->points[curve->first];
    const float *thresholds = &placing->source->thresholds[curve->first];
    struct hatch_trace_place before, here;
    double arc = 0;
    bool known = find_place(placing, &points[0], &before);
    struct hatch_store_line line = {.level = level,
                                    .free_ends = curve->free_ends,
                                    .id = (uint64_t)curve->id << 32,
                                    .log_threshold = logf(thresholds[0])};
    hatch_curve_position(placing->source->mesh, &points[curve->count / 2], line.middle);
    HATCH_TRY(hatch_store_add_line(&store->given, &store->keep, &line, err));
    for (uint32_t i = 1; i < curve->count; i++) {
        uint32_t first = store->given.piece_count;
        double start = arc;
        bool next = find_place(placing, &points[i], &here);
        if (known && next)
            HATCH_TRY(add_way(store, before, &here, &arc, err));
        set_thresholds(&store->given.pieces[first], store->given.piece_count - first, start,
                       log((double)thresholds[i - 1]), log((double)thresholds[i]));
        before = here;
        known = next;
    }
    struct hatch_store_line *added = &store->given.lines[store->given.line_count - 1];
    added->length = arc;
    store->given.line_count -= added->count == 0;
    return HATCH_OK;
}

/* Measures the mean logarithm of drawn to measured thresholds, in the finest octave that is complete. Finer levels do
 * not take over that the given ones lack strokes shorter than their gaps. */
static void find_drift(struct hatch_store *store, const struct hatch_finer_source *source)
{
    const struct hatch_curves *curves = source->curves;
    double count[HATCH_STORE_DRIFTS] = {0};
    for (uint32_t s = 0; s < curves->set_count; s++) {
        const struct hatch_curve_set *set = &curves->sets[s];
        if (set->family != store->family || set->count == 0)
            continue;
        const struct hatch_curve *last = &curves->curves[set->first + set->count - 1];
        for (uint32_t i = curves->curves[set->first].first; i < last->first + last->count; i++) {
            double own = log((double)curves->points[i].threshold), part = hatch_store_octaves(store, own);
            if (part < 0 || part >= 1)
                continue;
            uint32_t bin = (uint32_t)(part * HATCH_STORE_DRIFTS);
            store->drift[bin] += log((double)source->thresholds[i]) - own;
            count[bin]++;
        }
    }
    double sum = 0, all = 0;
    for (uint32_t i = 0; i < HATCH_STORE_DRIFTS; i++) {
        sum += store->drift[i];
        all += count[i];
    }
    double mean = all > 0 ? sum / all : 0, missing = mean - fmin(fmax(mean, -DRIFT_MAX), DRIFT_MAX);
    for (uint32_t i = 0; i < HATCH_STORE_DRIFTS; i++)
        store->drift[i] = (count[i] > 0 ? store->drift[i] / count[i] : mean) - missing;
}

enum hatch_status hatch_store_take_curves(struct hatch_store *store, const struct hatch_finer_source *source,
                                          struct hatch_err *err)
{
    const struct hatch_surface *surface = store->ground.surface;
    const struct hatch_curves *curves = source->curves;
    uint32_t *of_mesh;
    HATCH_TRY(HATCH_ALLOC_UNSET(&store->scratch, &of_mesh, source->mesh->face_count, err));
    for (uint32_t f = 0; f < source->mesh->face_count; f++)
        of_mesh[f] = HATCH_NO_SIDE;
    for (uint32_t f = 0; f < surface->face_count; f++)
        of_mesh[surface->face_source[store->ground.source[f]]] = f;
    const struct placing placing = {store, source, of_mesh};
    for (uint32_t s = 0; s < curves->set_count; s++)
        for (uint32_t i = 0; i < curves->sets[s].count && curves->sets[s].family == store->family; i++)
            HATCH_TRY(add_curve(&placing, &curves->curves[curves->sets[s].first + i], curves->sets[s].level, err));
    find_drift(store, source);
    return HATCH_OK;
}
