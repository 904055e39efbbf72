/* The points of strokes as vertices with attributes, as files hold them. */
#include <math.h>
#include <string.h>

#include "curve/curves.h"

#define JOINTS 4u

/* Joints of a face's corners and their weights at a point. */
struct mixture {
    uint32_t count;
    float joint[3 * JOINTS], weight[3 * JOINTS];
};

static void shares_of(const struct hatch_curve_point *point, float shares[3])
{
    shares[1] = point->share[0];
    shares[2] = point->share[1];
    shares[0] = 1 - shares[1] - shares[2];
}

/* Keeps the joints that weigh most; their weights sum to 1. */
static void keep_heaviest(struct mixture *mixture, float joints[JOINTS], float weights[JOINTS])
{
    float sum = 0;
    for (uint32_t i = 0; i < JOINTS; i++) {
        uint32_t best = 0;
        for (uint32_t j = 1; j < mixture->count; j++)
            if (mixture->weight[j] > mixture->weight[best])
                best = j;
        bool any = mixture->count > 0 && mixture->weight[best] > 0;
        joints[i] = any ? mixture->joint[best] : 0;
        weights[i] = any ? mixture->weight[best] : 0;
        sum += weights[i];
        if (any)
            mixture->weight[best] = 0;
    }
    for (uint32_t i = 0; i < JOINTS && sum > 0; i++)
        weights[i] /= sum;
}

static void mix_joints(const float *joints, const float *weights, const uint32_t corners[3], const float shares[3],
                       float joint[JOINTS], float weight[JOINTS])
{
    struct mixture mixture = {0};
    for (int c = 0; c < 3; c++)
        for (uint32_t i = 0; i < JOINTS; i++) {
            float number = joints[JOINTS * (size_t)corners[c] + i];
            uint32_t at = 0;
            while (at < mixture.count && mixture.joint[at] != number)
                at++;
            mixture.count += at == mixture.count;
            mixture.joint[at] = number;
            mixture.weight[at] += shares[c] * weights[JOINTS * (size_t)corners[c] + i];
        }
    keep_heaviest(&mixture, joint, weight);
}

static enum hatch_status add_joints(const struct hatch_curve_point *points, uint32_t count,
                                    const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                    struct hatch_mesh *vertices, struct hatch_err *err)
{
    const float *from = hatch_mesh_find(mesh, "JOINTS_0", JOINTS),
                *from_weights = hatch_mesh_find(mesh, "WEIGHTS_0", JOINTS);
    float *joints, *weights, shares[3];
    if (!from || !from_weights)
        return HATCH_OK;
    HATCH_TRY(hatch_mesh_add(arena, vertices, "JOINTS_0", JOINTS, &joints, err));
    HATCH_TRY(hatch_mesh_add(arena, vertices, "WEIGHTS_0", JOINTS, &weights, err));
    for (size_t i = 0; i < count; i++) {
        shares_of(&points[i], shares);
        mix_joints(from, from_weights, &mesh->indices[3 * (size_t)points[i].face], shares, &joints[JOINTS * i],
                   &weights[JOINTS * i]);
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

/* Adds the attributes that are the point's own. */
static enum hatch_status add_places(const struct hatch_curves *curves, const struct hatch_curve_set *set,
                                    uint32_t first_point, struct hatch_arena *arena, struct hatch_mesh *vertices,
                                    struct hatch_err *err)
{
    float *face, *share, *id, *threshold;
    HATCH_TRY(hatch_mesh_add(arena, vertices, HATCH_CURVE_FACE, 1, &face, err));
    HATCH_TRY(hatch_mesh_add(arena, vertices, HATCH_CURVE_SHARE, 2, &share, err));
    HATCH_TRY(hatch_mesh_add(arena, vertices, HATCH_CURVE_STROKE, 2, &id, err));
    HATCH_TRY(hatch_mesh_add(arena, vertices, HATCH_CURVE_THRESHOLD, 1, &threshold, err));
    for (uint32_t s = set->first; s < set->first + set->count; s++) {
        const struct hatch_curve *curve = &curves->curves[s];
        for (uint32_t i = curve->first; i < curve->first + curve->count; i++) {
            size_t to = i - first_point;
            face[to] = (float)curves->points[i].face;
            memcpy(&share[2 * to], curves->points[i].share, 2 * sizeof *share);
            id[2 * to] = (float)(curve->id & 0xffff);
            id[2 * to + 1] = (float)(curve->id >> 16);
            threshold[to] = curves->points[i].threshold;
        }
    }
    return HATCH_OK;
}

enum hatch_status hatch_curves_as_vertices(const struct hatch_curves *curves, const struct hatch_curve_set *set,
                                           const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                           struct hatch_mesh *vertices, uint32_t *line_count, struct hatch_err *err)
{
    const struct hatch_curve *first = &curves->curves[set->first], *last = first + set->count - 1;
    uint32_t count = set->count > 0 ? last->first + last->count - first->first : 0, lines = 0;
    const struct hatch_curve_point *points = &curves->points[set->count > 0 ? first->first : 0];
    if (mesh->face_count > HATCH_CURVE_FACES_MAX)
        return hatch_fail(err, HATCH_LIMIT, "strokes on a mesh of %u faces; a file holds those of at most %u",
                          mesh->face_count, HATCH_CURVE_FACES_MAX);
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
    HATCH_TRY(add_joints(points, count, mesh, arena, vertices, err));
    return add_targets(points, count, mesh, arena, vertices, err);
}

/* Returns whether a number is whole and less than a limit. */
static bool is_below(float number, uint32_t limit)
{
    return number >= 0 && number < (float)limit && number == floorf(number);
}

enum hatch_status hatch_curves_from_vertices(const struct hatch_mesh *vertices, const uint32_t *indices,
                                             uint32_t line_count, struct hatch_curves *curves, struct hatch_err *err)
{
    const float *face = hatch_mesh_find(vertices, HATCH_CURVE_FACE, 1),
                *share = hatch_mesh_find(vertices, HATCH_CURVE_SHARE, 2),
                *id = hatch_mesh_find(vertices, HATCH_CURVE_STROKE, 2),
                *threshold = hatch_mesh_find(vertices, HATCH_CURVE_THRESHOLD, 1);
    if (!face || !share || !id || !threshold)
        return hatch_fail(err, HATCH_BAD_INPUT, "strokes: %s, %s, %s or %s is missing", HATCH_CURVE_FACE,
                          HATCH_CURVE_SHARE, HATCH_CURVE_STROKE, HATCH_CURVE_THRESHOLD);
    uint32_t next = 0; /* first vertex that is in no stroke yet */
    for (uint32_t line = 0; line < line_count; line++) {
        uint32_t from = indices[2 * (size_t)line], to = indices[2 * (size_t)line + 1];
        bool begins = from == next;
        if (to >= vertices->vertex_count || to != from + 1 || !(begins || (line > 0 && to == next)))
            return hatch_fail(err, HATCH_BAD_INPUT, "strokes: line %u does not join a vertex to the next", line);
        if (begins)
            curves->curves[curves->count++] = (struct hatch_curve){.first = curves->point_count};
        struct hatch_curve *curve = &curves->curves[curves->count - 1];
        for (uint32_t v = begins ? from : to; v <= to; v++) {
            if (!is_below(face[v], HATCH_CURVE_FACES_MAX) || !is_below(id[2 * (size_t)v], 0x10000) ||
                !is_below(id[2 * (size_t)v + 1], 0x10000))
                return hatch_fail(err, HATCH_BAD_INPUT, "strokes: vertex %u: %s or %s is no whole number in range", v,
                                  HATCH_CURVE_FACE, HATCH_CURVE_STROKE);
            curves->points[curves->point_count++] =
                (struct hatch_curve_point){.face = (uint32_t)face[v],
                                           .share = {share[2 * (size_t)v], share[2 * (size_t)v + 1]},
                                           .threshold = threshold[v]};
            curve->id = (uint32_t)id[2 * (size_t)v] | (uint32_t)id[2 * (size_t)v + 1] << 16;
            curve->count++;
        }
        next = to + 1;
    }
    return HATCH_OK;
}
