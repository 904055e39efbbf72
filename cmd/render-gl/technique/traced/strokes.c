#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/random.h"
#include "curve/density.h"
#include "curve/places.h"
#include "math/vector.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/gpu/texture.h"
#include "render-gl/technique/traced/traced.h"

#define SHEAF 6.0    /* side of the cells whose strokes turn together, in gaps of their level */
#define TIP_GAPS 1.2 /* greatest length of pointed ends, in gaps of their level: longer ones leave white in between */

/* A stroke of a mesh, and its place in the order of drawing. */
struct entry {
    const struct hatch_curve *curve;
    const struct hatch_curve_set *set;
    float least;
};

static int compare(const void *a, const void *b)
{
    const struct entry *x = a, *y = b;
    if (x->least < y->least || x->least > y->least)
        return x->least < y->least ? -1 : 1;
    return (x->curve > y->curve) - (x->curve < y->curve);
}

static void list_entries(const struct hatch_curves *curves, const float *thresholds, struct entry *entries)
{
    for (uint32_t s = 0; s < curves->set_count; s++) {
        const struct hatch_curve_set *set = &curves->sets[s];
        for (uint32_t i = set->first; i < set->first + set->count; i++) {
            const struct hatch_curve *curve = &curves->curves[i];
            float least = FLT_MAX;
            for (uint32_t p = curve->first; p < curve->first + curve->count; p++)
                least = fminf(least, thresholds[p]);
            *entries++ = (struct entry){curve, set, least};
        }
    }
}

/* Computes the change of the shares of corners 1 and 2 along a vector, of which the part in the plane counts.
 *   edge  from corner 0 to 1 and to 2 */
static void shares_along(double edge[2][3], const double along[3], double way[2])
{
    double aa = hatch_vec_dot(edge[0], edge[0]), ab = hatch_vec_dot(edge[0], edge[1]);
    double bb = hatch_vec_dot(edge[1], edge[1]), det = fmax(aa * bb - ab * ab, DBL_MIN);
    double a = hatch_vec_dot(edge[0], along), b = hatch_vec_dot(edge[1], along);
    way[0] = (bb * a - ab * b) / det;
    way[1] = (aa * b - ab * a) / det;
}

/* Sets the way across a narrow face.
 *   edge, normal  of the point's face
 *   along         the stroke's direction in its plane, of length 1
 *   turn_rad      from there to the strokes that cross it */
static void set_across(const struct hatch_curve_point *from, double edge[2][3], const double normal[3],
                       const double along[3], double turn_rad, struct traced_point *point)
{
    double left[3], across[3], way[2], size = hatch_vec_length(normal);
    hatch_vec_cross(normal, along, left);
    for (int k = 0; k < 3; k++)
        across[k] = (double)from->width * (cos(turn_rad) * along[k] + sin(turn_rad) * left[k] / fmax(size, DBL_MIN));
    shares_along(edge, across, way);
    point->across[0] = (float)way[0];
    point->across[1] = (float)way[1];
    point->crossing = 1 + (float)from->across;
}

/* Sets the part of a point that follows from its face.
 *   along     direction of the stroke, of any length
 *   turn_rad  per family: the angle from the stroke to the strokes of the family */
static void set_face(const struct hatch_mesh *mesh, const struct hatch_curve_point *from, const double along[3],
                     const double turn_rad[HATCH_CURVE_FAMILIES_MAX], struct traced_point *point)
{
    const float *data = mesh->attributes[0].data;
    const uint32_t *corners = &mesh->indices[3 * (size_t)from->face];
    double edge[2][3], normal[3], way[2], moved[3];
    for (int k = 0; k < 3; k++) {
        double origin = (double)data[3 * (size_t)corners[0] + (size_t)k];
        point->corners[k] = corners[k];
        for (int e = 0; e < 2; e++)
            edge[e][k] = (double)data[3 * (size_t)corners[e + 1] + (size_t)k] - origin;
    }
    hatch_vec_cross(edge[0], edge[1], normal);
    shares_along(edge, along, way);
    for (int k = 0; k < 3; k++)
        moved[k] = way[0] * edge[0][k] + way[1] * edge[1][k];
    double length = fmax(hatch_vec_length(moved), DBL_MIN);
    for (int k = 0; k < 3; k++)
        moved[k] /= length;
    point->way[0] = (float)(way[0] / length);
    point->way[1] = (float)(way[1] / length);
    point->area = (float)fmax(hatch_vec_length(normal), DBL_MIN);
    if (from->width > 0)
        set_across(from, edge, normal, moved, turn_rad[from->across], point);
}

/* Returns a random number, -1 .. 1, that a stroke shares with the neighbours of its set. */
static float shared_random(const struct traced_source *source, const struct entry *entry, uint64_t stream)
{
    const struct hatch_curves *curves = source->curves;
    float middle[3];
    uint64_t cell = entry->set->family;
    if (source->parts)
        memcpy(middle, source->parts[entry->curve - curves->curves].middle, sizeof middle);
    else
        hatch_curve_position(source->mesh, &curves->points[entry->curve->first + entry->curve->count / 2], middle);
    for (int k = 0; k < 3; k++) {
        double at = floor((double)middle[k] / (SHEAF * (double)entry->set->gap));
        cell = cell * 0x9e3779b97f4a7c15u + (uint64_t)(int64_t)fmin(fmax(at, -0x1p40), 0x1p40);
    }
    return 2 * (float)hatch_random_unit(0, stream, cell) - 1;
}

/* How the points are drawn. */
struct densities {
    struct hatch_curve_groups groups;
    float *thresholds; /* per point */
    float *reached;    /* per group: hatch_curves_densest */
    float densest;     /* the greatest of them */
    float fewest;      /* that of the family whose strokes are the fewest */
};

/* Makes the points of a stroke. */
static void make_points(const struct traced_source *source, const struct densities *densities,
                        const struct entry *entry, struct traced_point *points)
{
    const struct hatch_mesh *mesh = source->mesh;
    const struct hatch_curve *curve = entry->curve;
    const struct hatch_curve_point *from = &source->curves->points[curve->first];
    const struct hatch_finer_part whole = {0, 0, {0, 0, 0}};
    const struct hatch_finer_part *part = source->parts ? &source->parts[curve - source->curves->curves] : &whole;
    float turn = shared_random(source, entry, 0), tip = (float)TIP_GAPS * entry->set->gap;
    float reached = densities->reached[hatch_curves_group_of(&densities->groups, from)];
    double length = (double)part->before;
    const int bound = (int)(~curve->free_ends & 3);
    double turn_rad[HATCH_CURVE_FAMILIES_MAX] = {0};
    for (uint32_t s = 0; s < source->curves->set_count; s++)
        turn_rad[source->curves->sets[s].family] =
            (double)source->curves->sets[s].angle_rad - (double)entry->set->angle_rad;
    for (uint32_t i = 0; i < curve->count; i++) {
        uint32_t before = i > 0 ? i - 1 : 0, after = i + 1 < curve->count ? i + 1 : i;
        float ends[2][3], here[3];
        double along[3], step[3];
        hatch_curve_position(mesh, &from[before], ends[0]);
        hatch_curve_position(mesh, &from[after], ends[1]);
        hatch_curve_position(mesh, &from[i], here);
        for (int k = 0; k < 3; k++) {
            along[k] = (double)ends[1][k] - (double)ends[0][k];
            step[k] = (double)here[k] - (double)ends[0][k];
        }
        length += hatch_vec_length(step);
        points[i] = (struct traced_point){.hash = curve->id,
                                          .share = {from[i].share[0], from[i].share[1]},
                                          .threshold = densities->thresholds[curve->first + i],
                                          .from_start = (float)length,
                                          .family = (float)entry->set->family,
                                          .turn = turn,
                                          .tip = tip,
                                          .reached = reached / densities->densest,
                                          .ends = (float)((i == 0) | (i + 1 == curve->count) << 1 | bound << 2)};
        set_face(mesh, &from[i], along, turn_rad, &points[i]);
    }
    for (uint32_t i = 0; i < curve->count; i++)
        points[i].to_end = (float)length + part->after - points[i].from_start;
}

/* Writes the triangles between the points of a stroke; returns the end of them. */
static uint32_t *make_triangles(uint32_t first, uint32_t count, uint32_t *indices)
{
    for (uint32_t i = first; i + 1 < first + count; i++) {
        const uint32_t corners[6] = {2 * i, 2 * i + 1, 2 * i + 2, 2 * i + 2, 2 * i + 1, 2 * i + 3};
        for (int k = 0; k < 6; k++)
            *indices++ = corners[k];
    }
    return indices;
}

/* Finds the family whose densest strokes are the fewest, on the whole mesh. */
static enum hatch_status find_fewest(const struct hatch_curves *curves, const float *thresholds,
                                     struct hatch_arena *scratch, float *fewest, struct hatch_err *err)
{
    const struct hatch_curve_groups whole = {.count = 1};
    *fewest = FLT_MAX;
    for (uint32_t s = 0, next; s < curves->set_count; s = next) {
        struct hatch_curves family = {.points = curves->points + curves->curves[curves->sets[s].first].first};
        float densest;
        for (next = s; next < curves->set_count && curves->sets[next].family == curves->sets[s].family; next++)
            for (uint32_t i = 0; i < curves->sets[next].count; i++)
                family.point_count += curves->curves[curves->sets[next].first + i].count;
        HATCH_TRY(hatch_curves_densest(&family, &whole, thresholds + (family.points - curves->points), scratch,
                                       &densest, err));
        *fewest = densest > 0 ? fminf(*fewest, densest) : *fewest;
    }
    return HATCH_OK;
}

static enum hatch_status find_densities(const struct traced_source *source, struct hatch_arena *arena,
                                        struct hatch_arena *scratch, struct densities *densities, struct hatch_err *err)
{
    const struct hatch_curves *curves = source->curves;
    *densities = (struct densities){.groups.count = 1};
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &densities->thresholds, curves->point_count, err));
    for (uint32_t i = 0; i < curves->point_count; i++)
        densities->thresholds[i] = curves->points[i].threshold;
    if (!source->parts) {
        HATCH_TRY(hatch_curves_group(curves, source->mesh, arena, scratch, &densities->groups, err));
        HATCH_TRY(hatch_curves_even_places(curves, source->mesh, source->pool, scratch, densities->thresholds, err));
        HATCH_TRY(hatch_curves_even_thresholds(curves, source->mesh, &densities->groups, scratch, densities->thresholds,
                                               err));
    }
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &densities->reached, densities->groups.count, err));
    HATCH_TRY(
        hatch_curves_densest(curves, &densities->groups, densities->thresholds, scratch, densities->reached, err));
    for (uint32_t g = 0; g < densities->groups.count; g++)
        densities->densest = fmaxf(densities->densest, densities->reached[g]);
    return find_fewest(curves, densities->thresholds, scratch, &densities->fewest, err);
}

enum hatch_status traced_upload(const struct traced_source *source, struct hatch_arena *arena,
                                struct hatch_arena *scratch, struct traced_strokes *strokes, struct hatch_err *err)
{
    const struct hatch_curves *curves = source->curves;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct entry *entries;
    struct traced_point *points;
    uint32_t *indices, *end, first = 0;
    float *least;
    struct densities densities;
    struct traced_stroke *sources;
    *strokes = (struct traced_strokes){.count = curves->count, .curve_points = curves->points, .raised = FLT_MAX};
    HATCH_TRY(HATCH_ALLOC(arena, &least, curves->count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &sources, curves->count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &end, curves->count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &entries, curves->count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &points, curves->point_count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &indices, 6 * (size_t)curves->point_count, err));
    HATCH_TRY(find_densities(source, arena, scratch, &densities, err));
    list_entries(curves, densities.thresholds, entries);
    qsort(entries, curves->count, sizeof *entries, compare);
    uint32_t *next = indices;
    for (uint32_t i = 0; i < curves->count; i++) {
        make_points(source, &densities, &entries[i], points + first);
        next = make_triangles(first, entries[i].curve->count, next);
        first += entries[i].curve->count;
        least[i] = entries[i].least;
        sources[i] = (struct traced_stroke){entries[i].curve, entries[i].set->family};
        end[i] = first;
    }
    strokes->least = least;
    strokes->thresholds = densities.thresholds;
    strokes->densest = densities.densest;
    strokes->fewest = densities.fewest;
    strokes->sources = sources;
    strokes->end = end;
    strokes->finest = curves->sets[0].gap;
    strokes->coarsest = ldexpf(curves->sets[0].gap, (int)curves->sets[0].level);
    for (uint32_t s = 0; s < curves->set_count; s++) {
        strokes->finest = fminf(strokes->finest, curves->sets[s].gap);
        strokes->families =
            curves->sets[s].family >= strokes->families ? curves->sets[s].family + 1 : strokes->families;
    }
    for (uint32_t i = 0; i < first; i++)
        strokes->narrow = strokes->narrow || points[i].crossing > 0;
    strokes->points = gpu_buffer_make(points, sizeof *points * first);
    strokes->indices = gpu_buffer_make(indices, sizeof *indices * (size_t)(next - indices));
    hatch_arena_rewind(scratch, mark);
    return gpu_check_memory(err, "%u strokes", curves->count);
}

enum hatch_status traced_make_ribbon(const struct traced_strokes *strokes, struct traced_ribbon *ribbon,
                                     struct hatch_err *err)
{
    const size_t floats = (size_t)TRACED_RIBBON_FLOATS * strokes->end[strokes->count - 1];
    HATCH_TRY(gpu_check_texels(floats / 4, "points of strokes", err));
    ribbon->buffer = gpu_buffer_make(NULL, sizeof(float) * floats);
    ribbon->view = gpu_texture_of_buffer(GL_RGBA32F, ribbon->buffer);
    return gpu_check_memory(err, "%u strokes", strokes->count);
}

void traced_free_strokes(const struct traced_strokes *strokes)
{
    const GLuint buffers[] = {strokes->points, strokes->indices};
    glDeleteBuffers(2, buffers);
}

void traced_free_ribbon(const struct traced_ribbon *ribbon)
{
    glDeleteTextures(1, &ribbon->view);
    glDeleteBuffers(1, &ribbon->buffer);
}

const struct traced_strokes *traced_strokes_of(const struct frame *frame, const struct traced_state *state,
                                               uint32_t item)
{
    const struct traced_item *own = &state->items[item];
    return own->strokes.count > 0 ? &own->strokes : &state->strokes[frame->scene->unit.items[item].mesh];
}

const struct traced_ribbon *traced_ribbon_of(const struct traced_state *state, uint32_t item)
{
    const struct traced_item *own = &state->items[item];
    return own->strokes.count > 0 ? &own->near : &own->ribbon;
}

uint32_t traced_count_under(const struct traced_strokes *strokes, double threshold)
{
    uint32_t low = 0, high = strokes->count;
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        if ((double)strokes->least[middle] < threshold)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}
