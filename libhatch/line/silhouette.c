/* The silhouette of a posed mesh. */
#include <assert.h>

#include "math/vector.h"
#include "base/keys.h"
#include "line/trace.h"

#define BULGE_MAX 0.12 /* largest distance of a curve from its edge, in lengths of the edge: an arc of 54° */
#define BACK_LEAST 0.5 /* reach of the surface beyond an edge, in its lengths, from which normal_weight is 1 */
#define RING_SEEN 64u  /* about how many neighbours of a vertex are examined */
#define SLACK_PX 2.0   /* slack of every segment; one across a face gets more for the depth of the face */
#define POINTS_KEY ((uint64_t)UINT32_MAX << 32) /* plus the number of a point: key of the node at that point */

struct work {
    const struct hatch_line_shape *shape;
    const struct hatch_line_eye *eye;
    double local_eye[3]; /* eye in the coordinates of positions; orthographic: direction to it */
    double eye_w;        /* homogeneous coordinate of local_eye: 1; orthographic: 0 */
    float *facing;       /* per vertex: normal · vector to the eye */
    uint32_t *crossed;   /* faces that the silhouette crosses */
    uint32_t crossed_count;
    struct hatch_keys keys; /* of nodes: pairs of vertices, or points */
    struct hatch_line_trace trace;
};

/* Applies the inverse of a matrix to a point (w 1) or a direction (w 0). Returns false when the matrix is singular. */
static bool to_local(const double m[16], const double in[3], double w, double out[3])
{
    double columns[3][3], cross[3][3], from[3];
    for (int c = 0; c < 3; c++)
        for (int r = 0; r < 3; r++)
            columns[c][r] = m[4 * c + r];
    for (int c = 0; c < 3; c++)
        hatch_vec_cross(columns[(c + 1) % 3], columns[(c + 2) % 3], cross[c]);
    double determinant = hatch_vec_dot(columns[0], cross[0]);
    for (int k = 0; k < 3; k++)
        from[k] = in[k] - w * m[12 + k];
    for (int k = 0; k < 3; k++)
        out[k] = hatch_vec_dot(cross[k], from) / determinant;
    return isfinite(out[0] + out[1] + out[2]);
}

static void find_facing(const struct work *w)
{
    const float *p = w->shape->positions, *n = w->shape->normals;
    float e[3], eye_w = (float)w->eye_w;
    hatch_vec_round(w->local_eye, e);
    for (size_t v = 0; v < w->shape->lines->mesh.vertex_count; v++)
        w->facing[v] = n[3 * v] * (e[0] - eye_w * p[3 * v]) + n[3 * v + 1] * (e[1] - eye_w * p[3 * v + 1]) +
                       n[3 * v + 2] * (e[2] - eye_w * p[3 * v + 2]);
}

static bool faces_away(const struct work *w, uint32_t vertex)
{
    return w->facing[vertex] < 0;
}

static void list_crossed(struct work *w)
{
    const struct hatch_mesh *mesh = &w->shape->lines->mesh;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        const uint32_t *i = &mesh->indices[3 * (size_t)f];
        int count = faces_away(w, i[0]) + faces_away(w, i[1]) + faces_away(w, i[2]);
        w->crossed[w->crossed_count] = f;
        w->crossed_count += count == 1 || count == 2;
    }
}

/* Returns the position along an edge, 0 .. 1, where facing is zero. Its signs must differ at the ends. */
static double root(const struct work *w, uint32_t low, uint32_t high)
{
    double a = (double)w->facing[low], b = (double)w->facing[high];
    return a / (a - b);
}

/* Returns the weight, 0 .. 1, that the normal at an end of an edge has for the curve over that edge. It is small if the
 * faces beyond this end are short, as at a chamfer: the normal then turns mostly because of those faces.
 *   along  vector from this end to the other one */
static double normal_weight(const struct work *w, uint32_t end, const double along[3])
{
    const struct hatch_line_ring *ring = &w->shape->lines->ring;
    const float *positions = w->shape->positions;
    uint32_t first = ring->first[end], count = ring->first[end + 1] - first;
    double square = hatch_vec_dot(along, along), back = 0, at[3], p[3], away[3];
    if (count == 0 || !(square > 0))
        return 1;
    hatch_vec_of(&positions[3 * (size_t)end], at);
    for (uint32_t i = 0; i < count; i += 1 + count / RING_SEEN) {
        hatch_vec_of(&positions[3 * (size_t)ring->neighbours[first + i]], p);
        hatch_vec_sub(at, p, away);
        back = fmax(back, hatch_vec_dot(away, along));
    }
    return fmin(1, back / (BACK_LEAST * square));
}

/* Computes a point of the silhouette at an edge, in the unit scene. It lies on the cubic that is orthogonal to the
 * normals at the edge's ends, or on the edge itself where the cubic would be inside the surface.
 *   t         position along the edge, 0 .. 1
 *   straight  true: on the edge itself */
static void point_on(const struct work *w, uint32_t low, uint32_t high, double t, bool straight, double out[3])
{
    double p[2][3], n[2][3], along[3], back[3], bulge[3] = {0, 0, 0}, mean[3], unit[3];
    const uint32_t ends[2] = {low, high};
    for (int i = 0; i < 2; i++) {
        hatch_vec_of(&w->shape->positions[3 * (size_t)ends[i]], p[i]);
        hatch_vec_of(&w->shape->normals[3 * (size_t)ends[i]], n[i]);
        hatch_vec_normalize(n[i]);
    }
    hatch_vec_sub(p[1], p[0], along);
    hatch_vec_sub(p[0], p[1], back);
    double rise[2] = {hatch_vec_dot(along, n[0]) * normal_weight(w, low, along),
                      hatch_vec_dot(back, n[1]) * normal_weight(w, high, back)};
    hatch_vec_add_scaled(bulge, -(1 - t) * (1 - t) * t * rise[0], n[0], bulge);
    hatch_vec_add_scaled(bulge, -(1 - t) * t * t * rise[1], n[1], bulge);
    hatch_vec_add_scaled(n[0], 1, n[1], mean);
    double size = hatch_vec_length(bulge), most = BULGE_MAX * hatch_vec_length(along), share = 1;
    if (straight || !(hatch_vec_dot(bulge, mean) > 0))
        share = 0;
    else if (size > most)
        share = most / size;
    hatch_vec_add_scaled(p[0], t, along, unit);
    hatch_vec_add_scaled(unit, share, bulge, unit);
    const double *m = w->shape->to_unit;
    for (int r = 0; r < 3; r++)
        out[r] = m[r] * unit[0] + m[4 + r] * unit[1] + m[8 + r] * unit[2] + m[12 + r];
}

/* Finds the node with a key, or adds it. */
static enum hatch_status add_node(struct work *w, uint64_t key, const double at[3], bool smooth, uint32_t *node,
                                  struct hatch_err *err)
{
    HATCH_TRY(hatch_keys_number(&w->keys, key, node, err));
    if (*node == w->trace.node_count) {
        w->trace.smooth[*node] = smooth;
        hatch_vec_copy(at, &w->trace.nodes[3 * (size_t)*node]);
        w->trace.node_count++;
    }
    return HATCH_OK;
}

/* Finds or adds the node where the silhouette crosses the edge between two vertices. */
static enum hatch_status add_crossing(struct work *w, uint32_t a, uint32_t b, bool straight, uint32_t *node,
                                      struct hatch_err *err)
{
    uint32_t low = a < b ? a : b, high = a < b ? b : a;
    double at[3];
    point_on(w, low, high, root(w, low, high), straight, at);
    return add_node(w, hatch_keys_pair(low, high), at, !straight, node, err);
}

/* Returns the part of a segment's slack that is due to the face it crosses. On a coarse mesh the smooth silhouette runs
 * beside that of the polygons, and so behind some of them: by up to about half the depth of that face.
 *   share  barycentric coordinates of the middle of the segment */
static double face_depth(const struct work *w, uint32_t face, const double share[3])
{
    const uint32_t *i = &w->shape->lines->mesh.indices[3 * (size_t)face];
    const double *m = w->shape->to_unit;
    double p[3][3], e1[3], e2[3], to_eye[3], deep = 0;
    for (int c = 0; c < 3; c++)
        hatch_vec_of(&w->shape->positions[3 * (size_t)i[c]], p[c]);
    hatch_vec_sub(p[1], p[0], e1);
    hatch_vec_sub(p[2], p[0], e2);
    for (int k = 0; k < 3; k++)
        to_eye[k] = w->local_eye[k] - w->eye_w * p[0][k];
    double a = hatch_vec_dot(e1, e1), b = hatch_vec_dot(e1, e2), c = hatch_vec_dot(e2, e2);
    double x = hatch_vec_dot(e1, to_eye), y = hatch_vec_dot(e2, to_eye);
    double determinant = a * c - b * b;
    double rate[3] = {0, (c * x - b * y) / determinant, (a * y - b * x) / determinant};
    rate[0] = -rate[1] - rate[2];
    double ahead = INFINITY, behind = INFINITY;
    for (int k = 0; k < 3; k++) {
        if (rate[k] < 0)
            ahead = fmin(ahead, share[k] / -rate[k]);
        if (rate[k] > 0)
            behind = fmin(behind, share[k] / rate[k]);
    }
    for (int r = 0; r < 3; r++)
        for (int k = 0; k < 3; k++)
            deep += w->eye->view->back[r] * m[4 * k + r] * (rate[1] * e1[k] + rate[2] * e2[k]);
    deep = 0.5 * fabs(deep) * (ahead + behind);
    return isfinite(deep) ? deep : 0.0;
}

static void add_segment(struct work *w, uint32_t a, uint32_t b, double slack)
{
    uint32_t segment = w->trace.segment_count++;
    w->trace.ends[2 * segment] = a;
    w->trace.ends[2 * segment + 1] = b;
    w->trace.slack[segment] = (float)slack;
}

static enum hatch_status cross_face(struct work *w, uint32_t face, struct hatch_err *err)
{
    const uint32_t *i = &w->shape->lines->mesh.indices[3 * (size_t)face];
    uint32_t nodes[2], count = 0;
    double share[3] = {0, 0, 0};
    for (uint32_t c = 0; c < 3 && count < 2; c++) {
        uint32_t a = i[c], b = i[(c + 1) % 3];
        if (faces_away(w, a) == faces_away(w, b))
            continue;
        bool straight = w->shape->lines->hard_sides[face] >> c & 1;
        HATCH_TRY(add_crossing(w, a, b, straight, &nodes[count++], err));
        double t = root(w, a, b);
        share[c] += 0.5 * (1 - t);
        share[(c + 1) % 3] += 0.5 * t;
    }
    add_segment(w, nodes[0], nodes[1],
                SLACK_PX * hatch_line_pixel(w->eye, &w->trace.nodes[3 * (size_t)nodes[0]]) +
                    face_depth(w, face, share));
    return HATCH_OK;
}

/* Adds the silhouette along a hard edge. The facing of either side varies linearly along it. The silhouette runs where
 * the two have different signs: between the ends of the edge and the points where the facing of a side is zero. */
static enum hatch_status follow_edge(struct work *w, const struct hatch_line_hard_edge *edge, struct hatch_err *err)
{
    double at[3], roots[2];
    uint32_t stops[4], count = 0, sides[2], root_count = 0;
    for (uint32_t i = 0; i < 2; i++)
        if (faces_away(w, edge->low[i]) != faces_away(w, edge->high[i])) {
            roots[root_count] = root(w, edge->low[i], edge->high[i]);
            sides[root_count++] = i;
        }
    if (root_count == 2 && roots[1] < roots[0]) {
        sides[0] = 1;
        sides[1] = 0;
    }
    if (faces_away(w, edge->low[0]) != faces_away(w, edge->low[1])) {
        point_on(w, edge->low[0], edge->high[0], 0, true, at);
        HATCH_TRY(add_node(w, POINTS_KEY | edge->points[0], at, false, &stops[count++], err));
    }
    for (uint32_t i = 0; i < root_count; i++)
        HATCH_TRY(add_crossing(w, edge->low[sides[i]], edge->high[sides[i]], true, &stops[count++], err));
    if (faces_away(w, edge->high[0]) != faces_away(w, edge->high[1])) {
        point_on(w, edge->low[0], edge->high[0], 1, true, at);
        HATCH_TRY(add_node(w, POINTS_KEY | edge->points[1], at, false, &stops[count++], err));
    }
    assert(count % 2 == 0);
    for (uint32_t i = 0; i < count; i += 2)
        add_segment(w, stops[i], stops[i + 1],
                    SLACK_PX * hatch_line_pixel(w->eye, &w->trace.nodes[3 * (size_t)stops[i]]));
    return HATCH_OK;
}

/* Returns whether the silhouette runs along any part of an edge. */
static bool has_silhouette(const struct work *w, const struct hatch_line_hard_edge *edge)
{
    bool first = faces_away(w, edge->low[0]);
    return faces_away(w, edge->low[1]) != first || faces_away(w, edge->high[0]) != first ||
           faces_away(w, edge->high[1]) != first;
}

static enum hatch_status find(struct work *w, struct hatch_arena *arena, struct hatch_arena *scratch,
                              struct hatch_err *err)
{
    const struct hatch_line_mesh *lines = w->shape->lines;
    HATCH_TRY(HATCH_ALLOC(scratch, &w->facing, lines->mesh.vertex_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->crossed, (size_t)lines->mesh.face_count + 1, err));
    find_facing(w);
    list_crossed(w);
    size_t segments = w->crossed_count;
    for (uint32_t i = 0; i < lines->hard_edge_count; i++)
        segments += has_silhouette(w, &lines->hard_edges[i]) ? 2 : 0;
    HATCH_TRY(HATCH_ALLOC(arena, &w->trace.nodes, 6 * segments, err));
    HATCH_TRY(HATCH_ALLOC(arena, &w->trace.ends, 2 * segments, err));
    HATCH_TRY(HATCH_ALLOC(arena, &w->trace.slack, segments, err));
    HATCH_TRY(HATCH_ALLOC(arena, &w->trace.smooth, 2 * segments, err));
    HATCH_TRY(hatch_keys_make(scratch, &w->keys, err));
    for (uint32_t i = 0; i < w->crossed_count; i++)
        HATCH_TRY(cross_face(w, w->crossed[i], err));
    for (uint32_t i = 0; i < lines->hard_edge_count; i++)
        if (has_silhouette(w, &lines->hard_edges[i]))
            HATCH_TRY(follow_edge(w, &lines->hard_edges[i], err));
    return HATCH_OK;
}

enum hatch_status hatch_line_trace_silhouettes(const struct hatch_line_shape *shape, const struct hatch_line_eye *eye,
                                               struct hatch_arena *arena, struct hatch_arena *scratch,
                                               struct hatch_line_trace *trace, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct work work = {.shape = shape, .eye = eye, .eye_w = eye->view->orthographic ? 0 : 1};
    const double *from = eye->view->orthographic ? eye->view->back : eye->view->eye;
    enum hatch_status status = HATCH_OK;
    if (to_local(shape->to_unit, from, work.eye_w, work.local_eye))
        status = find(&work, arena, scratch, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *trace = work.trace;
    return status;
}
