#include <math.h>
#include <string.h>

#include "math/vector.h"
#include "mesh/edge_kinds.h"
#include "mesh/fans.h"
#include "mesh/splits.h"

/* Corners that share a normal form a class. Without a crease angle these are all corners of a point; with one, they are
 * the corners of a point that are joined across edges that are not sharp. */
struct work {
    const struct hatch_mesh *mesh;
    uint32_t *point;    /* per corner */
    uint32_t *class_of; /* per corner */
    uint32_t class_count;
    double *sum; /* 3 per class: weighted sum of its faces' normals */
};

static bool is_sharp(const struct hatch_mesh *mesh, uint32_t a, uint32_t b, double cos_crease)
{
    double corners[3][3], na[3], nb[3];
    hatch_mesh_corners(mesh, a, corners);
    hatch_vec_triangle(corners[0], corners[1], corners[2], na);
    hatch_mesh_corners(mesh, b, corners);
    hatch_vec_triangle(corners[0], corners[1], corners[2], nb);
    return !(hatch_vec_dot(na, nb) >= cos_crease * hatch_vec_length(na) * hatch_vec_length(nb));
}

static enum hatch_status classes_by_edges(struct work *w, const struct hatch_edges *edges, const uint8_t *sharp,
                                          struct hatch_arena *scratch, struct hatch_err *err)
{
    uint32_t faces = w->mesh->face_count;
    uint32_t *partner;
    HATCH_TRY(HATCH_ALLOC(scratch, &partner, (size_t)faces * 3, err));
    hatch_edges_partners(edges, sharp, faces, partner);
    w->class_count = hatch_mesh_corner_fans(w->point, partner, faces, w->class_of);
    return HATCH_OK;
}

static enum hatch_status classes_by_crease(struct work *w, uint32_t point_count, double crease_rad,
                                           struct hatch_arena *scratch, struct hatch_err *err)
{
    const struct hatch_connectivity faces = {w->point, w->mesh->face_count, point_count, NULL};
    struct hatch_edges edges;
    HATCH_TRY(hatch_edges_find(&faces, scratch, scratch, &edges, err));
    uint8_t *sharp;
    HATCH_TRY(HATCH_ALLOC(scratch, &sharp, edges.count, err));
    for (uint32_t e = 0; e < edges.count; e++) {
        const uint32_t *sides = &edges.sides[edges.first[e]];
        sharp[e] =
            edges.first[e + 1] - edges.first[e] == 2 && is_sharp(w->mesh, sides[0] / 3, sides[1] / 3, cos(crease_rad));
    }
    return classes_by_edges(w, &edges, sharp, scratch, err);
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
