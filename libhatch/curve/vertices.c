/* The points of strokes as vertices with attributes, as files hold them. */
#include <math.h>
#include <string.h>

#include "curve/curves.h"
#include "mesh/skin/influences.h"

#define NARROW_SHARE 0.01 /* of points on narrow faces: sets with fewer are written without */

static void shares_of(const struct hatch_curve_point *point, float shares[3])
{
    shares[1] = point->share[0];
    shares[2] = point->share[1];
    shares[0] = 1 - shares[1] - shares[2];
}

/* Mixes the joints of a face's corners, of which the heaviest are kept; their weights sum to 1. */
static void mix_joints(const float *joints, const float *weights, const uint32_t corners[3], const float shares[3],
                       float joint[HATCH_INFLUENCES], float weight[HATCH_INFLUENCES])
{
    struct hatch_influences mixture = {.count = 0};
    float sum = 0;
    for (int c = 0; c < 3; c++)
        for (uint32_t i = 0; i < HATCH_INFLUENCES; i++) {
            size_t at = HATCH_INFLUENCES * (size_t)corners[c] + i;
            hatch_influences_add(&mixture, joints[at], shares[c] * weights[at]);
        }
    hatch_influences_keep(&mixture, joint, weight);
    for (uint32_t i = 0; i < HATCH_INFLUENCES; i++)
        sum += weight[i];
    for (uint32_t i = 0; i < HATCH_INFLUENCES && sum > 0; i++)
        weight[i] /= sum;
}

static enum hatch_status add_joints(const struct hatch_curve_point *points, uint32_t count,
                                    const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                    struct hatch_mesh *vertices, struct hatch_err *err)
{
    const float *from = hatch_mesh_find(mesh, "JOINTS_0", HATCH_INFLUENCES),
                *from_weights = hatch_mesh_find(mesh, "WEIGHTS_0", HATCH_INFLUENCES);
    float *joints, *weights, shares[3];
    if (!from || !from_weights)
        return HATCH_OK;
    HATCH_TRY(hatch_mesh_add(arena, vertices, "JOINTS_0", HATCH_INFLUENCES, &joints, err));
    HATCH_TRY(hatch_mesh_add(arena, vertices, "WEIGHTS_0", HATCH_INFLUENCES, &weights, err));
    for (size_t i = 0; i < count; i++) {
        shares_of(&points[i], shares);
        mix_joints(from, from_weights, &mesh->indices[3 * (size_t)points[i].face], shares,
                   &joints[HATCH_INFLUENCES * i], &weights[HATCH_INFLUENCES * i]);
    }
    return HATCH_OK;
}

/* Adds the morph targets' displacements of the positions, interpolated. */
static enum hatch_status add_targets(const struct hatch_curve_point *points, uint32_t count,
                                     const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                     struct hatch_mesh *vertices, struct hatch_err *err)
{
    const struct hatch_mesh_attribute *from = hatch_mesh_attribute(mesh, HATCH_MORPH_POSITION);
    float *moves, shares[3];
    if (!from)
        return HATCH_OK;
    HATCH_TRY(hatch_mesh_add(arena, vertices, HATCH_MORPH_POSITION, from->components, &moves, err));
    for (size_t i = 0; i < count; i++) {
        const uint32_t *corners = &mesh->indices[3 * (size_t)points[i].face];
        shares_of(&points[i], shares);
        for (size_t k = 0; k < from->components; k++)
            for (int c = 0; c < 3; c++)
                moves[from->components * i + k] += shares[c] * from->data[from->components * corners[c] + k];
    }
    return HATCH_OK;
}

/* Returns the code of a ratio. */
static float code_of(double ratio)
{
    double code = HATCH_CURVE_CODE_MIDDLE + HATCH_CURVE_CODE_STEPS * log2(ratio);
    return (float)floor(fmin(fmax(code, 0), UINT16_MAX) + 0.5);
}

static double ratio_of(float code)
{
    return exp2(((double)code - HATCH_CURVE_CODE_MIDDLE) / HATCH_CURVE_CODE_STEPS);
}

/* Returns what the first or the last vertex of a stroke says about it.
 *   end  0: the first, 1: the last */
static float half_of(const struct hatch_curve *curve, uint32_t end)
{
    uint32_t mask = (1u << HATCH_CURVE_HALF_BITS) - 1, is_free = curve->free_ends >> end & 1;
    return (float)((curve->id >> end * HATCH_CURVE_HALF_BITS & mask) | is_free << HATCH_CURVE_HALF_BITS);
}

/* Adds the attributes that are the point's own. */
static enum hatch_status add_places(const struct hatch_curves *curves, const struct hatch_curve_set *set,
                                    uint32_t first_point, struct hatch_arena *arena, struct hatch_mesh *vertices,
                                    struct hatch_err *err)
{
    float *face, *stroke;
    HATCH_TRY(hatch_mesh_add(arena, vertices, HATCH_CURVE_FACE, 2, &face, err));
    HATCH_TRY(hatch_mesh_add(arena, vertices, HATCH_CURVE_STROKE, 2, &stroke, err));
    for (uint32_t s = set->first; s < set->first + set->count; s++) {
        const struct hatch_curve *curve = &curves->curves[s];
        for (uint32_t i = curve->first; i < curve->first + curve->count; i++) {
            size_t to = i - first_point;
            face[2 * to] = (float)(curves->points[i].face & 0xffff);
            face[2 * to + 1] = (float)(curves->points[i].face >> 16);
            stroke[2 * to] = code_of((double)curves->points[i].threshold * (double)set->gap);
        }
        stroke[2 * (size_t)(curve->first - first_point) + 1] = half_of(curve, 0);
        stroke[2 * (size_t)(curve->first + curve->count - 1 - first_point) + 1] = half_of(curve, 1);
    }
    return HATCH_OK;
}

/* Adds the widths of narrow faces, if enough points lie on one. */
static enum hatch_status add_narrow(const struct hatch_curve_point *points, uint32_t count, float gap,
                                    struct hatch_arena *arena, struct hatch_mesh *vertices, struct hatch_err *err)
{
    float *narrow;
    uint32_t some = 0;
    for (size_t i = 0; i < count; i++)
        some += points[i].width > 0;
    if (some == 0 || some < NARROW_SHARE * count)
        return HATCH_OK;
    HATCH_TRY(hatch_mesh_add(arena, vertices, HATCH_CURVE_NARROW, 2, &narrow, err));
    for (size_t i = 0; i < count; i++)
        if (points[i].width > 0) {
            narrow[2 * i] = (float)(1 + points[i].across);
            narrow[2 * i + 1] = code_of((double)points[i].width / (double)gap);
        }
    return HATCH_OK;
}

struct hatch_curve_set hatch_curve_set_part(const struct hatch_curves *curves, const struct hatch_curve_set *set,
                                            uint32_t first)
{
    struct hatch_curve_set part = *set;
    uint32_t end = set->first + set->count, begin = curves->curves[first].first;
    part.first = first;
    part.count = 1;
    for (uint32_t c = first + 1; c < end; c++, part.count++)
        if (curves->curves[c].first + curves->curves[c].count - begin > HATCH_CURVE_PART_MAX)
            break;
    return part;
}

enum hatch_status hatch_curves_as_vertices(const struct hatch_curves *curves, const struct hatch_curve_set *set,
                                           const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                           struct hatch_mesh *vertices, uint32_t *line_count, struct hatch_err *err)
{
    const struct hatch_curve *first = &curves->curves[set->first], *last = first + set->count - 1;
    uint32_t count = set->count > 0 ? last->first + last->count - first->first : 0, lines = 0;
    const struct hatch_curve_point *points = &curves->points[set->count > 0 ? first->first : 0];
    HATCH_TRY(hatch_mesh_make(arena, count, 0, vertices, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &vertices->indices, 2 * (size_t)count, err));
    for (size_t i = 0; i < count; i++)
        hatch_curve_position(mesh, &points[i], &vertices->attributes[0].data[3 * i]);
    for (uint32_t s = 0; s < set->count; s++)
        for (uint32_t i = 0; i + 1 < first[s].count; i++) {
            vertices->indices[2 * (size_t)lines] = first[s].first + i - first->first;
            vertices->indices[2 * (size_t)lines + 1] = first[s].first + i + 1 - first->first;
            lines++;
        }
    *line_count = lines;
    HATCH_TRY(add_places(curves, set, set->count > 0 ? first->first : 0, arena, vertices, err));
    HATCH_TRY(add_narrow(points, count, set->gap, arena, vertices, err));
    HATCH_TRY(add_joints(points, count, mesh, arena, vertices, err));
    return add_targets(points, count, mesh, arena, vertices, err);
}

/* Vertices that become points. */
struct source {
    const struct hatch_mesh *vertices, *mesh;
    const float *face, *stroke, *narrow; /* the attributes; narrow: may be NULL */
    float gap;
};

/* Checks that an attribute has whole numbers of 16 bits. */
static enum hatch_status check_numbers(const struct hatch_mesh *vertices, const char *name, const float *numbers,
                                       struct hatch_err *err)
{
    for (size_t i = 0; i < 2 * (size_t)vertices->vertex_count; i++)
        if (!(numbers[i] >= 0 && numbers[i] <= UINT16_MAX && numbers[i] == floorf(numbers[i])))
            return hatch_fail(err, HATCH_BAD_INPUT, "strokes: vertex %zu: %s is no whole number of 16 bits", i / 2,
                              name);
    return HATCH_OK;
}

/* Makes a vertex a point. */
static enum hatch_status fill_point(const struct source *source, uint32_t v, struct hatch_curve_point *point,
                                    struct hatch_err *err)
{
    const float *face = &source->face[2 * (size_t)v];
    uint32_t number = (uint32_t)face[0] | (uint32_t)face[1] << 16;
    *point = (struct hatch_curve_point){
        .face = number, .threshold = (float)(ratio_of(source->stroke[2 * (size_t)v]) / (double)source->gap)};
    const float *narrow = source->narrow ? &source->narrow[2 * (size_t)v] : NULL;
    if (narrow && narrow[0] > HATCH_CURVE_FAMILIES_MAX)
        return hatch_fail(err, HATCH_BAD_INPUT, "strokes: vertex %u: there are at most %u families", v,
                          HATCH_CURVE_FAMILIES_MAX);
    if (narrow && narrow[0] > 0) {
        point->across = (uint32_t)narrow[0] - 1;
        point->width = (float)(ratio_of(narrow[1]) * (double)source->gap);
    }
    if (number >= source->mesh->face_count)
        return hatch_fail(err, HATCH_BAD_INPUT, "strokes: vertex %u: face %u does not exist, there are %u", v, number,
                          source->mesh->face_count);
    if (!hatch_curve_find_share(source->mesh, number, &source->vertices->attributes[0].data[3 * (size_t)v],
                                point->share))
        return hatch_fail(err, HATCH_BAD_INPUT, "strokes: vertex %u is not on its face %u", v, number);
    return HATCH_OK;
}

/* Reads what the first and the last vertex of a stroke say about it; those between them say nothing. */
static enum hatch_status read_ends(const struct source *source, uint32_t first, struct hatch_curve *curve,
                                   struct hatch_err *err)
{
    for (uint32_t i = 0; i < curve->count; i++) {
        uint32_t half = (uint32_t)source->stroke[2 * (size_t)(first + i) + 1], end = i > 0;
        if (half != 0 && i > 0 && i + 1 < curve->count)
            return hatch_fail(err, HATCH_BAD_INPUT, "strokes: vertex %u has half an identifier, but ends no stroke",
                              first + i);
        curve->id |= (half & ((1u << HATCH_CURVE_HALF_BITS) - 1)) << end * HATCH_CURVE_HALF_BITS;
        curve->free_ends |= half >> HATCH_CURVE_HALF_BITS << end;
    }
    return HATCH_OK;
}

enum hatch_status hatch_curves_from_vertices(const struct hatch_mesh *vertices, const uint32_t *indices,
                                             uint32_t line_count, float gap, const struct hatch_mesh *mesh,
                                             struct hatch_curves *curves, struct hatch_err *err)
{
    const struct source source = {vertices,
                                  mesh,
                                  hatch_mesh_find(vertices, HATCH_CURVE_FACE, 2),
                                  hatch_mesh_find(vertices, HATCH_CURVE_STROKE, 2),
                                  hatch_mesh_find(vertices, HATCH_CURVE_NARROW, 2),
                                  gap};
    if (!source.face || !source.stroke)
        return hatch_fail(err, HATCH_BAD_INPUT, "strokes: %s or %s is missing", HATCH_CURVE_FACE, HATCH_CURVE_STROKE);
    HATCH_TRY(check_numbers(vertices, HATCH_CURVE_FACE, source.face, err));
    HATCH_TRY(check_numbers(vertices, HATCH_CURVE_STROKE, source.stroke, err));
    if (source.narrow)
        HATCH_TRY(check_numbers(vertices, HATCH_CURVE_NARROW, source.narrow, err));
    for (uint32_t line = 0, next = 0; line < line_count;) {
        struct hatch_curve *curve = &curves->curves[curves->count];
        *curve = (struct hatch_curve){.first = curves->point_count, .count = 1};
        for (; line < line_count && (curve->count == 1 || indices[2 * (size_t)line] != next + curve->count);
             line++, curve->count++) {
            uint32_t from = next + curve->count - 1;
            if (indices[2 * (size_t)line] != from || indices[2 * (size_t)line + 1] != from + 1 ||
                from + 1 >= vertices->vertex_count)
                return hatch_fail(err, HATCH_BAD_INPUT, "strokes: line %u does not join a vertex to the next", line);
        }
        for (uint32_t v = next; v < next + curve->count; v++)
            HATCH_TRY(fill_point(&source, v, &curves->points[curves->point_count++], err));
        HATCH_TRY(read_ends(&source, next, curve, err));
        curves->count++;
        next += curve->count;
    }
    return HATCH_OK;
}
