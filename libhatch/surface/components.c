/* The components of a surface: their faces, corners and points, their scale and their topology. */
#include <assert.h>
#include <string.h>

#include "math/vector.h"
#include "mesh/fans.h"
#include "surface/work.h"

static enum hatch_status allocate(const struct hatch_surface_work *w, struct hatch_surface *s, struct hatch_err *err)
{
    size_t faces = s->face_count, points = s->point_count;
    HATCH_TRY(HATCH_ALLOC(w->arena, &s->components, s->component_count, err));
    HATCH_TRY(HATCH_ALLOC(w->arena, &s->points, points * 3, err));
    HATCH_TRY(HATCH_ALLOC(w->arena, &s->corners, faces * 3, err));
    HATCH_TRY(HATCH_ALLOC(w->arena, &s->opposite, faces * 3, err));
    HATCH_TRY(HATCH_ALLOC(w->arena, &s->point_component, points, err));
    HATCH_TRY(HATCH_ALLOC(w->arena, &s->corner_vertex, faces * 3, err));
    HATCH_TRY(HATCH_ALLOC(w->arena, &s->face_plane, faces, err));
    HATCH_TRY(HATCH_ALLOC(w->arena, &s->plane_direction, 3 * (size_t)s->plane_count, err));
    return HATCH_ALLOC(w->arena, &s->face_source, faces, err);
}

/* Orders the faces by component.
 *   new_face  out: per face of the mesh, its number in the surface */
static void order_faces(const struct hatch_surface_work *w, struct hatch_surface *s, uint32_t *new_face)
{
    for (uint32_t f = 0; f < w->mesh->face_count; f++)
        if (!w->dropped[f])
            s->components[w->component[f]].face_count++;
    uint32_t first = 0;
    for (uint32_t c = 0; c < s->component_count; c++) {
        s->components[c].first_face = first;
        first += s->components[c].face_count;
        s->components[c].face_count = 0;
    }
    for (uint32_t f = 0; f < w->mesh->face_count; f++) {
        if (w->dropped[f])
            continue;
        struct hatch_component *component = &s->components[w->component[f]];
        new_face[f] = component->first_face + component->face_count++;
        s->face_source[new_face[f]] = f;
        s->face_plane[new_face[f]] = w->plane ? w->plane[f] : HATCH_NO_SIDE;
    }
}

/* Numbers the points in the order in which the faces use them.
 *   new_point  in: HATCH_NO_SIDE for every fan; out: the points of the fans */
static void number_points(const struct hatch_surface_work *w, struct hatch_surface *s, uint32_t *new_point)
{
    const float *positions = w->mesh->attributes[0].data;
    uint32_t count = 0;
    for (uint32_t f = 0; f < s->face_count; f++) {
        uint32_t source = s->face_source[f], index = w->component[source];
        struct hatch_component *component = &s->components[index];
        if (f == component->first_face)
            component->first_point = count;
        for (uint32_t c = 0; c < 3; c++) {
            uint32_t from = 3 * source + (w->flipped[source] ? (3 - c) % 3 : c);
            uint32_t *point = &new_point[w->fan[from]], vertex = w->mesh->indices[from];
            if (*point == HATCH_NO_SIDE) {
                *point = count++;
                s->point_component[*point] = index;
                hatch_vec_of(&positions[(size_t)vertex * 3], &s->points[(size_t)*point * 3]);
                component->point_count++;
            }
            s->corners[3 * f + c] = *point;
            s->corner_vertex[3 * f + c] = vertex;
        }
    }
    assert(count == s->point_count);
}

/* Converts a side of the mesh to one of the surface. A flipped face has the corners 0, 2, 1, so its sides are reversed
 * and in reverse order. */
static uint32_t new_side(const struct hatch_surface_work *w, const uint32_t *new_face, uint32_t side)
{
    uint32_t face = side / 3, c = side % 3;
    return 3 * new_face[face] + (w->flipped[face] ? 2 - c : c);
}

static void join_sides(const struct hatch_surface_work *w, struct hatch_surface *s, const uint32_t *new_face)
{
    memset(s->opposite, 0xff, (size_t)s->face_count * 3 * sizeof *s->opposite);
    for (uint32_t side = 0; side < 3 * w->mesh->face_count; side++)
        if (w->partner[side] != HATCH_NO_EDGE)
            s->opposite[new_side(w, new_face, side)] = new_side(w, new_face, w->partner[side]);
}

enum hatch_status hatch_surface_build_components(const struct hatch_surface_work *w, struct hatch_surface *surface,
                                                 struct hatch_err *err)
{
    uint32_t *new_face, *new_point;
    HATCH_TRY(HATCH_ALLOC(w->scratch, &new_face, w->mesh->face_count, err));
    HATCH_TRY(HATCH_ALLOC(w->scratch, &new_point, w->fan_count, err));
    surface->component_count = w->component_count;
    surface->point_count = w->fan_count;
    surface->plane_count = w->plane_count;
    for (uint32_t f = 0; f < w->mesh->face_count; f++) {
        surface->face_count += !w->dropped[f];
        surface->point_count -= w->dropped[f] ? 3 : 0; /* each corner of a dropped face is its own fan */
    }
    HATCH_TRY(allocate(w, surface, err));
    memset(new_point, 0xff, w->fan_count * sizeof *new_point);
    if (w->plane_count > 0)
        memcpy(surface->plane_direction, w->plane_direction, 3 * sizeof(double) * w->plane_count);
    for (uint32_t c = 0; c < w->component_count; c++)
        surface->components[c].body = w->body ? w->body[c] : c;
    order_faces(w, surface, new_face);
    number_points(w, surface, new_point);
    join_sides(w, surface, new_face);
    return HATCH_OK;
}

/* Returns whether a side stands for its edge: it is the edge's only side or the lower-numbered one. */
static bool owns_edge(const struct hatch_surface *s, uint32_t side)
{
    return s->opposite[side] == HATCH_NO_SIDE || side < s->opposite[side];
}

static double mean_edge(const struct hatch_surface *s, const struct hatch_component *component)
{
    double sum = 0;
    uint32_t count = 0;
    for (uint32_t side = 3 * component->first_face; side < 3 * (component->first_face + component->face_count);
         side++) {
        if (!owns_edge(s, side))
            continue;
        sum += hatch_vec_distance(&s->points[(size_t)s->corners[side] * 3],
                                  &s->points[(size_t)s->corners[hatch_side_end(side)] * 3]);
        count++;
    }
    return sum / count;
}

void hatch_surface_normalize(struct hatch_surface *s)
{
    for (uint32_t c = 0; c < s->component_count; c++) {
        struct hatch_component *component = &s->components[c];
        double *points = &s->points[(size_t)component->first_point * 3];
        double low[3], high[3];
        hatch_vec_copy(points, low);
        hatch_vec_copy(points, high);
        for (size_t i = 0; i < (size_t)component->point_count * 3; i++) {
            low[i % 3] = fmin(low[i % 3], points[i]);
            high[i % 3] = fmax(high[i % 3], points[i]);
        }
        component->scale = mean_edge(s, component);
        for (int k = 0; k < 3; k++)
            component->center[k] = (low[k] + high[k]) / 2;
        for (size_t i = 0; i < (size_t)component->point_count * 3; i++)
            points[i] = (points[i] - component->center[i % 3]) / component->scale;
    }
}

/* A border point has one fan, hence two border sides: loops are the sets of points connected by border sides. */
enum hatch_status hatch_surface_find_topology(struct hatch_surface *s, struct hatch_arena *scratch,
                                              struct hatch_err *err)
{
    uint32_t *loop;
    uint8_t *on_border;
    HATCH_TRY(HATCH_ALLOC(scratch, &loop, s->point_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &on_border, s->point_count, err));
    hatch_sets_init(loop, s->point_count);
    for (uint32_t c = 0; c < s->component_count; c++) {
        struct hatch_component *component = &s->components[c];
        uint32_t edges = 0;
        component->orientable = true;
        for (uint32_t side = 3 * component->first_face; side < 3 * (component->first_face + component->face_count);
             side++) {
            uint32_t other = s->opposite[side], end = hatch_side_end(side);
            edges += owns_edge(s, side);
            if (other == HATCH_NO_SIDE) {
                hatch_sets_join(loop, s->corners[side], s->corners[end]);
                on_border[s->corners[side]] = on_border[s->corners[end]] = 1;
            } else if (hatch_surface_is_contrary(s, side, other)) {
                component->orientable = false;
            }
        }
        component->euler = (int32_t)((int64_t)component->point_count - edges + component->face_count);
        for (uint32_t p = component->first_point; p < component->first_point + component->point_count; p++)
            component->border_loops += on_border[p] && loop[p] == p;
    }
    return HATCH_OK;
}
