#include <math.h>
#include <string.h>

#include "math/vector.h"
#include "mesh/edge_kinds.h"
#include "mesh/fans.h"
#include "mesh/splits.h"

#define NO_TARGET UINT32_MAX
#define COS_TIE 1e-3 /* largest difference of the cosines at edges that count as equally sharp */

/* Corners that share a normal form a class. Without a crease angle these are all corners of a point; with one, they are
 * the corners of a point that are joined across edges that are not sharp. */
struct work {
    const struct hatch_mesh *mesh;
    uint32_t *point;    /* per corner */
    uint32_t *class_of; /* per corner */
    uint32_t class_count;
    double *sum; /* 3 per class: weighted sum of its faces' normals */
};

/* Edges of two faces. */
struct creases {
    struct hatch_edges edges;
    double *cosine;    /* per edge: of the angle between the normals of its faces; 1: it has other than two */
    uint8_t *sharp;    /* per edge: not 0: sharp */
    uint32_t *partner; /* per side, across edges that are not sharp */
    uint8_t *cut;      /* per side, as for hatch_mesh_corner_fans */
};

/* Compares the normals of two faces.
 *   cosine  out: of the angle between them; 1 if one of the faces has no area
 * Returns whether the cosine is less than that of a crease. */
static bool is_sharp(const struct hatch_mesh *mesh, uint32_t a, uint32_t b, double cos_crease, double *cosine)
{
    double corners[3][3], na[3], nb[3];
    hatch_mesh_corners(mesh, a, corners);
    hatch_vec_triangle(corners[0], corners[1], corners[2], na);
    hatch_mesh_corners(mesh, b, corners);
    hatch_vec_triangle(corners[0], corners[1], corners[2], nb);
    double dot = hatch_vec_dot(na, nb), length_a = hatch_vec_length(na), length_b = hatch_vec_length(nb);
    *cosine = length_a * length_b > 0 ? dot / (length_a * length_b) : 1;
    return !(dot >= cos_crease * length_a * length_b);
}

static enum hatch_status find_creases(const struct work *w, uint32_t point_count, double crease_rad,
                                      struct hatch_arena *scratch, struct creases *creases, struct hatch_err *err)
{
    const struct hatch_connectivity faces = {w->point, w->mesh->face_count, point_count, NULL};
    struct hatch_edges *edges = &creases->edges;
    HATCH_TRY(hatch_edges_find(&faces, scratch, scratch, edges, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &creases->cosine, edges->count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &creases->sharp, edges->count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &creases->partner, (size_t)faces.face_count * 3, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &creases->cut, (size_t)faces.face_count * 3, err));
    for (uint32_t e = 0; e < edges->count; e++) {
        const uint32_t *sides = &edges->sides[edges->first[e]];
        creases->cosine[e] = 1;
        creases->sharp[e] = edges->first[e + 1] - edges->first[e] == 2 &&
                            is_sharp(w->mesh, sides[0] / 3, sides[1] / 3, cos(crease_rad), &creases->cosine[e]);
    }
    hatch_edges_partners(edges, creases->sharp, faces.face_count, creases->partner);
    return HATCH_OK;
}

/* Returns the corner at one end of a side: 0: its begin; 1: its end. */
static uint32_t corner_at(uint32_t side, int end)
{
    return end ? hatch_side_end(side) : side;
}

/* Finds classes that have the corners of both faces of a sharp edge between planes: small faces at the end of that edge
 * join them.
 *   bridged  out: per class: not 0: so
 * Returns whether there are any. */
static bool find_bridged(const struct work *w, const struct creases *creases, const uint8_t *in_plane, uint8_t *bridged)
{
    bool any = false;
    for (uint32_t e = 0; e < creases->edges.count; e++) {
        const uint32_t *sides = &creases->edges.sides[creases->edges.first[e]];
        if (!creases->sharp[e] || !in_plane[sides[0] / 3] || !in_plane[sides[1] / 3])
            continue;
        bool same_way = w->point[sides[0]] == w->point[sides[1]];
        for (int end = 0; end < 2; end++) {
            uint32_t class = w->class_of[corner_at(sides[0], end)];
            if (class != w->class_of[corner_at(sides[1], same_way ? end : !end)])
                continue;
            bridged[class] = 1;
            any = true;
        }
    }
    return any;
}

/* Cuts bridged classes at the sharpest of the edges that join them. */
static enum hatch_status cut_bridges(const struct work *w, const uint8_t *bridged, struct hatch_arena *scratch,
                                     struct creases *creases, struct hatch_err *err)
{
    double *least; /* per class: cosine at the sharpest of the edges that join it */
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &least, w->class_count, err));
    for (uint32_t i = 0; i < w->class_count; i++)
        least[i] = 1;
    for (int cutting = 0; cutting < 2; cutting++)
        for (uint32_t e = 0; e < creases->edges.count; e++) {
            uint32_t side = creases->edges.sides[creases->edges.first[e]];
            for (int end = 0; end < 2 && creases->partner[side] != HATCH_NO_EDGE; end++) {
                uint32_t class = w->class_of[corner_at(side, end)];
                if (!cutting)
                    least[class] = fmin(least[class], creases->cosine[e]);
                else if (bridged[class] && creases->cosine[e] <= least[class] + COS_TIE)
                    creases->cut[side] |= (uint8_t)(1 << end);
            }
        }
    return HATCH_OK;
}

static enum hatch_status classes_by_crease(struct work *w, uint32_t point_count, double crease_rad,
                                           struct hatch_arena *scratch, struct hatch_err *err)
{
    uint32_t faces = w->mesh->face_count;
    struct creases creases;
    uint8_t *in_plane, *bridged;
    HATCH_TRY(find_creases(w, point_count, crease_rad, scratch, &creases, err));
    w->class_count = hatch_mesh_corner_fans(w->point, creases.partner, NULL, faces, w->class_of);
    HATCH_TRY(HATCH_ALLOC(scratch, &in_plane, faces, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &bridged, w->class_count, err));
    hatch_edges_find_planes(w->mesh, &creases.edges, in_plane);
    if (find_bridged(w, &creases, in_plane, bridged)) {
        HATCH_TRY(cut_bridges(w, bridged, scratch, &creases, err));
        w->class_count = hatch_mesh_corner_fans(w->point, creases.partner, creases.cut, faces, w->class_of);
    }
    return HATCH_OK;
}

static double corner_angle(double corners[3][3], int c)
{
    double a[3], b[3], cross[3];
    hatch_vec_sub(corners[(c + 1) % 3], corners[c], a);
    hatch_vec_sub(corners[(c + 2) % 3], corners[c], b);
    hatch_vec_cross(a, b, cross);
    return atan2(hatch_vec_length(cross), hatch_vec_dot(a, b));
}

static void sum_normals(struct work *w)
{
    double corners[3][3], normal[3];
    for (uint32_t f = 0; f < w->mesh->face_count; f++) {
        if (!hatch_mesh_corners(w->mesh, f, corners))
            continue;
        hatch_vec_triangle(corners[0], corners[1], corners[2], normal);
        hatch_vec_normalize(normal);
        for (int c = 0; c < 3; c++) {
            double *sum = &w->sum[(size_t)w->class_of[f * 3 + (uint32_t)c] * 3];
            hatch_vec_add_scaled(sum, corner_angle(corners, c), normal, sum);
        }
    }
}

static void store_normals(const struct work *w, const struct hatch_splits *s, float *normals)
{
    for (uint32_t v = 0; v < s->count; v++) {
        double normal[3] = {0, 0, 0};
        if (s->class_at[v] != HATCH_NO_CLASS)
            hatch_vec_copy(&w->sum[(size_t)s->class_at[v] * 3], normal);
        if (!(hatch_vec_normalize(normal) > 0))
            normal[2] = 1; /* no face with an area, or faces that cancel out: any unit vector */
        hatch_vec_round(normal, &normals[(size_t)v * 3]);
    }
}

static enum hatch_status build(const struct work *w, struct hatch_arena *arena, struct hatch_arena *scratch,
                               struct hatch_mesh *out, struct hatch_err *err)
{
    const struct hatch_mesh *mesh = w->mesh;
    size_t corners = (size_t)mesh->face_count * 3;
    struct hatch_splits s;
    struct hatch_mesh made;
    float *data;
    HATCH_TRY(hatch_splits_make(mesh->indices, w->class_of, corners, mesh->vertex_count, scratch, &s, err));
    HATCH_TRY(hatch_mesh_gather(mesh, s.origin, s.count, mesh->face_count, arena, &made, err));
    memcpy(made.indices, s.indices, corners * sizeof *s.indices);
    HATCH_TRY(hatch_mesh_add(arena, &made, "NORMAL", 3, &data, err));
    store_normals(w, &s, data);
    *out = made;
    return HATCH_OK;
}

static enum hatch_status add_normals(struct work *w, float crease_rad, struct hatch_arena *arena,
                                     struct hatch_arena *scratch, struct hatch_mesh *out, struct hatch_err *err)
{
    size_t corners = (size_t)w->mesh->face_count * 3;
    uint32_t *vertex_to_point;
    HATCH_TRY(HATCH_ALLOC(scratch, &vertex_to_point, w->mesh->vertex_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->point, corners, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->class_of, corners, err));
    uint32_t point_count;
    HATCH_TRY(hatch_mesh_weld(w->mesh, scratch, vertex_to_point, &point_count, err));
    hatch_mesh_corner_points(w->mesh, vertex_to_point, w->point);
    if (crease_rad > 0) {
        HATCH_TRY(classes_by_crease(w, point_count, (double)crease_rad, scratch, err));
    } else {
        memcpy(w->class_of, w->point, corners * sizeof *w->point);
        w->class_count = point_count;
    }
    HATCH_TRY(HATCH_ALLOC(scratch, &w->sum, (size_t)w->class_count * 3, err));
    sum_normals(w);
    return build(w, arena, scratch, out, err);
}

enum hatch_status hatch_mesh_add_normals(struct hatch_arena *arena, struct hatch_arena *scratch,
                                         struct hatch_mesh *mesh, float crease_rad, struct hatch_err *err)
{
    if (hatch_mesh_find(mesh, "NORMAL", 3))
        return HATCH_OK;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct work w = {.mesh = mesh};
    struct hatch_mesh out;
    enum hatch_status status = add_normals(&w, crease_rad, arena, scratch, &out, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *mesh = out;
    return status;
}

/* Computes the normal of a face that targets move; any unit vector if it has no area.
 *   target  NO_TARGET: none
 *   share   of the target's displacement */
static void flat_normal(const struct hatch_mesh *mesh, uint32_t face, uint32_t target, double share, double normal[3])
{
    const float *positions = hatch_mesh_find(mesh, "POSITION", 3);
    const struct hatch_mesh_attribute *moves = hatch_mesh_attribute(mesh, HATCH_MORPH_POSITION);
    double corners[3][3];
    for (size_t c = 0; c < 3; c++) {
        size_t v = mesh->indices[3 * (size_t)face + c];
        hatch_vec_of(&positions[3 * v], corners[c]);
        for (size_t k = 0; k < 3 && target != NO_TARGET; k++)
            corners[c][k] += share * (double)moves->data[v * moves->components + 3 * target + k];
    }
    hatch_vec_triangle(corners[0], corners[1], corners[2], normal);
    if (!(hatch_vec_normalize(normal) > 0))
        hatch_vec_copy((const double[]){0, 0, 1}, normal);
}

enum hatch_status hatch_mesh_add_flat_normals(struct hatch_arena *arena, struct hatch_mesh *mesh, const bool *less,
                                              struct hatch_err *err)
{
    const uint32_t corners = 3 * mesh->face_count, targets = hatch_mesh_target_count(mesh);
    struct hatch_mesh made;
    float *normals, *turns;
    HATCH_TRY(hatch_mesh_gather(mesh, mesh->indices, corners, mesh->face_count, arena, &made, err));
    for (uint32_t i = 0; i < corners; i++)
        made.indices[i] = i;
    HATCH_TRY(hatch_mesh_add(arena, &made, "NORMAL", 3, &normals, err));
    HATCH_TRY(hatch_mesh_add(arena, &made, HATCH_MORPH_NORMAL, 3 * targets, &turns, err));
    for (uint32_t i = 0; i < corners; i++) {
        double rest[3], moved[3];
        flat_normal(&made, i / 3, NO_TARGET, 0, rest);
        hatch_vec_round(rest, &normals[3 * (size_t)i]);
        for (uint32_t t = 0; t < targets; t++) {
            double side = less[t] ? -1 : 1;
            flat_normal(&made, i / 3, t, side, moved);
            for (size_t k = 0; k < 3; k++)
                turns[3 * ((size_t)i * targets + t) + k] = (float)(side * (moved[k] - rest[k]));
        }
    }
    *mesh = made;
    return HATCH_OK;
}

static bool has_length(const float *normal)
{
    return normal[0] != 0 || normal[1] != 0 || normal[2] != 0;
}

enum hatch_status hatch_mesh_replace_normals(struct hatch_arena *scratch, struct hatch_mesh *mesh, uint32_t *replaced,
                                             struct hatch_err *err)
{
    float *normals = hatch_mesh_find(mesh, "NORMAL", 3);
    size_t v = 0;
    while (normals && v < mesh->vertex_count && has_length(&normals[v * 3]))
        v++;
    if (!normals || v == mesh->vertex_count)
        return HATCH_OK;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct work w = {.mesh = mesh, .class_of = mesh->indices, .class_count = mesh->vertex_count};
    HATCH_TRY(HATCH_ALLOC(scratch, &w.sum, (size_t)w.class_count * 3, err));
    sum_normals(&w);
    for (; v < mesh->vertex_count; v++) {
        double *sum = &w.sum[v * 3];
        if (has_length(&normals[v * 3]))
            continue;
        if (hatch_vec_normalize(sum) > 0)
            ++*replaced;
        else
            sum[2] = 1;
        hatch_vec_round(sum, &normals[v * 3]);
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
