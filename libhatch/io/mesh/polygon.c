#include "io/mesh/polygon.h"

#include <string.h>

#include "image/image.h"
#include "math/vector.h"

/* Limit of the steps of ear clipping per file, which take some seconds. */
#define STEP_LIMIT ((uint64_t)500000000)

struct hatch_faces hatch_faces_in(struct hatch_arena *scratch)
{
    return (struct hatch_faces){.indices = {.arena = scratch}, .steps_left = STEP_LIMIT, .scratch = scratch};
}

static enum hatch_status add_triangle(struct hatch_faces *faces, const uint32_t *vertex, uint32_t a, uint32_t b,
                                      uint32_t c, struct hatch_err *err)
{
    const uint32_t triangle[3] = {vertex[a], vertex[b], vertex[c]};
    if (faces->face_count >= UINT32_MAX / 3 - 1)
        return hatch_fail(err, HATCH_LIMIT, "more than %u triangles", faces->face_count);
    faces->face_count++;
    return hatch_buffer_add(&faces->indices, triangle, sizeof triangle, err);
}

/* A polygon projected to a plane, counter-clockwise. */
struct outline {
    double (*at)[2];
    uint32_t *next, *previous;
    uint32_t *reflex; /* corners that are not convex, in no order */
    uint32_t *place;  /* of each corner in reflex; UINT32_MAX: it is convex or clipped */
    uint32_t count, reflex_count;
};

static void newell_normal(const float *positions, const uint32_t *point, uint32_t count, double normal[3])
{
    double origin[3], a[3], b[3], cross[3];
    hatch_vec_of(&positions[(size_t)point[0] * 3], origin);
    normal[0] = normal[1] = normal[2] = 0;
    for (uint32_t i = 0; i < count; i++) {
        hatch_vec_of(&positions[(size_t)point[i] * 3], a);
        hatch_vec_of(&positions[(size_t)point[(i + 1) % count] * 3], b);
        hatch_vec_sub(a, origin, a);
        hatch_vec_sub(b, origin, b);
        hatch_vec_cross(a, b, cross);
        hatch_vec_add_scaled(normal, 1, cross, normal);
    }
}

/* Returns whether no triangle of the fan from a corner is reversed. */
static bool fan_is_proper(const float *positions, const uint32_t *point, uint32_t count, uint32_t start,
                          const double normal[3])
{
    double p[3], a[3], b[3], cross[3];
    hatch_vec_of(&positions[(size_t)point[start] * 3], p);
    for (uint32_t i = 1; i + 1 < count; i++) {
        hatch_vec_of(&positions[(size_t)point[(start + i) % count] * 3], a);
        hatch_vec_of(&positions[(size_t)point[(start + i + 1) % count] * 3], b);
        hatch_vec_triangle(p, a, b, cross);
        if (hatch_vec_dot(cross, normal) < 0)
            return false;
    }
    return true;
}

static enum hatch_status add_fan(struct hatch_faces *faces, const uint32_t *vertex, uint32_t count, uint32_t start,
                                 struct hatch_err *err)
{
    for (uint32_t i = 1; i + 1 < count; i++)
        HATCH_TRY(add_triangle(faces, vertex, start, (start + i) % count, (start + i + 1) % count, err));
    return HATCH_OK;
}

/* Returns twice the signed area of the triangle of three corners. */
static double area2(const struct outline *o, uint32_t a, uint32_t b, uint32_t c)
{
    const double *p = o->at[a], *q = o->at[b], *r = o->at[c];
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

static double corner_area2(const struct outline *o, uint32_t corner)
{
    return area2(o, o->previous[corner], corner, o->next[corner]);
}

static bool coincide(const struct outline *o, uint32_t a, uint32_t b)
{
    return o->at[a][0] == o->at[b][0] && o->at[a][1] == o->at[b][1];
}

/* Returns whether a corner is an ear: it is convex, and its triangle contains no reflex corner. */
static bool is_ear(const struct outline *o, uint32_t corner)
{
    uint32_t a = o->previous[corner], c = o->next[corner];
    const double *u = o->at[a], *v = o->at[corner], *w = o->at[c];
    if (!(area2(o, a, corner, c) > 0))
        return false;
    double low = fmin(fmin(u[0], v[0]), w[0]), high = fmax(fmax(u[0], v[0]), w[0]);
    for (uint32_t i = 0; i < o->reflex_count; i++) {
        uint32_t p = o->reflex[i];
        if (!(o->at[p][0] >= low && o->at[p][0] <= high) || p == a || p == corner || p == c || coincide(o, p, a) ||
            coincide(o, p, corner) || coincide(o, p, c))
            continue;
        if (area2(o, a, corner, p) >= 0 && area2(o, corner, c, p) >= 0 && area2(o, c, a, p) >= 0)
            return false;
    }
    return true;
}

static void set_reflex(struct outline *o, uint32_t corner)
{
    o->place[corner] = o->reflex_count;
    o->reflex[o->reflex_count++] = corner;
}

/* Removes a corner from the reflex corners, if it is one of them. */
static void clear_reflex(struct outline *o, uint32_t corner)
{
    if (o->place[corner] == UINT32_MAX)
        return;
    uint32_t last = o->reflex[--o->reflex_count];
    o->reflex[o->place[corner]] = last;
    o->place[last] = o->place[corner];
    o->place[corner] = UINT32_MAX;
}

/* Clips a corner. This changes the angles of its two neighbours alone; a reflex corner may become convex, but never the
 * reverse. */
static void clip(struct outline *o, uint32_t corner)
{
    const uint32_t side[2] = {o->previous[corner], o->next[corner]};
    o->next[side[0]] = side[1];
    o->previous[side[1]] = side[0];
    clear_reflex(o, corner);
    for (int k = 0; k < 2; k++)
        if (corner_area2(o, side[k]) > 0)
            clear_reflex(o, side[k]);
}

static enum hatch_status clip_ears(struct hatch_faces *faces, struct outline *o, const uint32_t *vertex,
                                   struct hatch_err *err)
{
    uint32_t corner = 0, remaining = o->count, misses = 0;
    while (remaining > 3) {
        uint64_t cost = (uint64_t)o->reflex_count + 1;
        if (cost > faces->steps_left)
            return hatch_fail(err, HATCH_LIMIT, "a concave polygon of %u corners is too large; triangulate it",
                              o->count);
        faces->steps_left -= cost;
        /* A polygon without an ear intersects itself; any of its corners is clipped then. */
        if (misses < remaining && !is_ear(o, corner)) {
            corner = o->next[corner];
            misses++;
            continue;
        }
        uint32_t a = o->previous[corner], c = o->next[corner];
        HATCH_TRY(add_triangle(faces, vertex, a, corner, c, err));
        clip(o, corner);
        remaining--;
        misses = 0;
        corner = c;
    }
    return add_triangle(faces, vertex, o->previous[corner], corner, o->next[corner], err);
}

/* Projects the polygon along the axis on which its normal has the largest component. */
static void project(const float *positions, const uint32_t *point, const double normal[3], struct outline *o)
{
    int axis = 0;
    for (int k = 1; k < 3; k++)
        if (fabs(normal[k]) > fabs(normal[axis]))
            axis = k;
    int x = (axis + 1) % 3, y = (axis + 2) % 3;
    double side = normal[axis] < 0 ? -1 : 1;
    for (uint32_t i = 0; i < o->count; i++) {
        o->at[i][0] = (double)positions[(size_t)point[i] * 3 + (size_t)x];
        o->at[i][1] = side * (double)positions[(size_t)point[i] * 3 + (size_t)y];
        o->next[i] = (i + 1) % o->count;
        o->previous[i] = (i + o->count - 1) % o->count;
    }
    o->reflex_count = 0;
    for (uint32_t i = 0; i < o->count; i++) {
        o->place[i] = UINT32_MAX;
        if (!(corner_area2(o, i) > 0))
            set_reflex(o, i);
    }
}

static enum hatch_status add_concave(struct hatch_faces *faces, const float *positions, const uint32_t *point,
                                     const uint32_t *vertex, uint32_t count, const double normal[3],
                                     struct hatch_err *err)
{
    /* Room for the triangles is reserved first, so that the outline, allocated after them, can be freed. */
    HATCH_TRY(hatch_buffer_reserve(&faces->indices, (size_t)count * 3 * sizeof(uint32_t), err));
    struct hatch_arena_mark mark = hatch_arena_mark(faces->scratch);
    struct outline o = {.count = count};
    o.at = hatch_arena_array(faces->scratch, count, sizeof *o.at, err);
    o.next = o.at ? HATCH_NEW(faces->scratch, uint32_t, count, err) : NULL;
    o.previous = o.next ? HATCH_NEW(faces->scratch, uint32_t, count, err) : NULL;
    o.reflex = o.previous ? HATCH_NEW(faces->scratch, uint32_t, count, err) : NULL;
    o.place = o.reflex ? HATCH_NEW(faces->scratch, uint32_t, count, err) : NULL;
    enum hatch_status status = o.place ? HATCH_OK : HATCH_LIMIT;
    if (status == HATCH_OK) {
        project(positions, point, normal, &o);
        status = clip_ears(faces, &o, vertex, err);
    }
    hatch_arena_rewind(faces->scratch, mark);
    return status;
}

enum hatch_status hatch_faces_add(struct hatch_faces *faces, const float *positions, const uint32_t *point,
                                  const uint32_t *vertex, uint32_t count, struct hatch_err *err)
{
    if (count < 3) {
        faces->lines_dropped++;
        return HATCH_OK;
    }
    if (count == 3)
        return add_triangle(faces, vertex, 0, 1, 2, err);
    faces->polygons_split++;
    double normal[3];
    newell_normal(positions, point, count, normal);
    for (uint32_t start = 0; start < 2; start++)
        if (fan_is_proper(positions, point, count, start, normal))
            return add_fan(faces, vertex, count, start, err);
    return add_concave(faces, positions, point, vertex, count, normal, err);
}

static enum hatch_status add_normals(const struct hatch_vertices *vertices, struct hatch_arena *arena,
                                     struct hatch_arena *scratch, struct hatch_mesh *mesh,
                                     struct hatch_mesh_notes *notes, struct hatch_err *err)
{
    double normal[3];
    bool any = false;
    for (size_t v = 0; v < vertices->count && !any; v++) {
        hatch_vec_of(&vertices->normals[v * 3], normal);
        any = hatch_vec_length(normal) > 0;
    }
    if (!any)
        return HATCH_OK;
    float *data;
    HATCH_TRY(hatch_mesh_add(arena, mesh, "NORMAL", 3, &data, err));
    for (size_t v = 0; v < vertices->count; v++) {
        hatch_vec_of(&vertices->normals[v * 3], normal);
        hatch_vec_normalize(normal);
        hatch_vec_round(normal, &data[v * 3]);
    }
    return hatch_mesh_replace_normals(scratch, mesh, &notes->normals_replaced, err);
}

static enum hatch_status add_texcoords(const struct hatch_vertices *vertices, struct hatch_arena *arena,
                                       struct hatch_mesh *mesh, struct hatch_mesh_notes *notes, struct hatch_err *err)
{
    uint32_t missing = 0;
    for (size_t v = 0; v < vertices->count; v++)
        missing += isnan(vertices->texcoords[v * 2]) != 0;
    notes->texcoords_missing += missing < vertices->count ? missing : 0;
    if (missing)
        return HATCH_OK;
    float *data;
    HATCH_TRY(hatch_mesh_add(arena, mesh, "TEXCOORD_0", 2, &data, err));
    for (size_t v = 0; v < vertices->count; v++) {
        data[v * 2] = vertices->texcoords[v * 2];
        data[v * 2 + 1] = 1 - vertices->texcoords[v * 2 + 1]; /* glTF's v points downwards */
    }
    return HATCH_OK;
}

static enum hatch_status add_colors(const struct hatch_vertices *vertices, struct hatch_arena *arena,
                                    struct hatch_mesh *mesh, struct hatch_err *err)
{
    float *data;
    HATCH_TRY(hatch_mesh_add(arena, mesh, "COLOR_0", 4, &data, err));
    for (size_t i = 0; i < 4 * (size_t)vertices->count; i++) {
        float value = isnan(vertices->colors[i]) ? 1 : fminf(fmaxf(vertices->colors[i], 0), 1);
        data[i] = i % 4 == 3 ? value : hatch_srgb_to_linear(value);
    }
    return HATCH_OK;
}

enum hatch_status hatch_faces_finish(const struct hatch_faces *faces, const struct hatch_vertices *vertices,
                                     struct hatch_arena *arena, struct hatch_mesh *mesh, struct hatch_mesh_notes *notes,
                                     struct hatch_err *err)
{
    struct hatch_mesh made;
    if (faces->face_count == 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "no faces, only %u vertices", vertices->count);
    HATCH_TRY(hatch_mesh_make(arena, vertices->count, faces->face_count, &made, err));
    memcpy(made.indices, faces->indices.data, faces->indices.size);
    memcpy(made.attributes[0].data, vertices->positions, (size_t)made.vertex_count * 3 * sizeof(float));
    notes->polygons_split += faces->polygons_split;
    notes->degenerate_dropped += faces->lines_dropped;
    if (vertices->normals)
        HATCH_TRY(add_normals(vertices, arena, faces->scratch, &made, notes, err));
    if (vertices->texcoords)
        HATCH_TRY(add_texcoords(vertices, arena, &made, notes, err));
    if (vertices->colors)
        HATCH_TRY(add_colors(vertices, arena, &made, err));
    *mesh = made;
    return HATCH_OK;
}
