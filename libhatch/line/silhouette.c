/* The silhouette of a posed mesh. */
#include "math/vector.h"
#include "line/edges.h"
#include "line/trace.h"

#define EDGE_ON 1e-7  /* cosine between a face's normal and the view below which the face counts as seen edge-on */
#define SLACK_PX 2.0f /* slack of every segment */

struct work {
    const struct hatch_line_shape *shape;
    const struct hatch_line_eye *eye;
    double local_eye[3]; /* eye in the coordinates of positions; orthographic: direction to it */
    double eye_w;        /* homogeneous coordinate of local_eye: 1; orthographic: 0 */
    int8_t
        *turned; /* per face: 1: its corners run anticlockwise in the picture; -1: clockwise; 0: it is seen edge-on */
    uint32_t *node; /* per vertex: its node + 1; 0: none */
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

static void find_turned(const struct work *w)
{
    const struct hatch_mesh *mesh = &w->shape->lines->mesh;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        const uint32_t *i = &mesh->indices[3 * (size_t)f];
        double p[3][3], normal[3], to_eye[3];
        for (int c = 0; c < 3; c++)
            hatch_vec_of(&w->shape->positions[3 * (size_t)i[c]], p[c]);
        hatch_vec_triangle(p[0], p[1], p[2], normal);
        for (int k = 0; k < 3; k++)
            to_eye[k] = w->local_eye[k] - w->eye_w * p[0][k];
        double facing = hatch_vec_dot(normal, to_eye);
        double least = EDGE_ON * hatch_vec_length(normal) * hatch_vec_length(to_eye);
        bool front = (facing > 0) != w->shape->mirrored;
        w->turned[f] = fabs(facing) > least ? (front ? 1 : -1) : 0;
    }
}

/* Returns on which side of an edge, from its first end to its second, the picture shows its faces if the silhouette
 * runs along it: 1: on the left, -1: on the right; else 0. */
static int side_of(const struct work *w, uint32_t edge)
{
    const struct hatch_line_mesh *lines = w->shape->lines;
    bool left = false, right = false, visible = false;
    for (uint32_t i = lines->turns.first[edge]; i < lines->turns.first[edge + 1]; i++) {
        uint32_t side = lines->turns.sides[i];
        int turned = w->turned[side / 3];
        bool rises = lines->mesh.indices[side] < lines->mesh.indices[hatch_side_end(side)];
        left = left || turned == (rises ? 1 : -1);
        right = right || turned == (rises ? -1 : 1);
        visible = visible || turned > 0 || (turned < 0 && w->shape->double_sided[side / 3]);
    }
    return !visible || left == right ? 0 : left ? 1 : -1;
}

static uint32_t add_node(struct work *w, uint32_t vertex)
{
    if (!w->node[vertex]) {
        hatch_line_place(w->shape, vertex, &w->trace.nodes[3 * (size_t)w->trace.node_count]);
        w->node[vertex] = ++w->trace.node_count;
    }
    return w->node[vertex] - 1;
}

static enum hatch_status find(struct work *w, struct hatch_arena *arena, struct hatch_arena *scratch,
                              struct hatch_err *err)
{
    const struct hatch_line_mesh *lines = w->shape->lines;
    struct hatch_line_trace *trace = &w->trace;
    size_t segments = 0;
    HATCH_TRY(HATCH_ALLOC(scratch, &w->turned, lines->mesh.face_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->node, lines->mesh.vertex_count, err));
    find_turned(w);
    for (uint32_t e = 0; e < lines->turns.count; e++)
        segments += side_of(w, e) != 0;
    HATCH_TRY(HATCH_ALLOC(arena, &trace->nodes, 6 * segments, err));
    HATCH_TRY(HATCH_ALLOC(arena, &trace->ends, 2 * segments, err));
    HATCH_TRY(HATCH_ALLOC(arena, &trace->slack_px, segments, err));
    HATCH_TRY(HATCH_ALLOC(arena, &trace->surface, segments, err));
    HATCH_TRY(HATCH_ALLOC(arena, &trace->fixed, 2 * segments, err));
    for (uint32_t e = 0; e < lines->turns.count; e++) {
        int side = side_of(w, e);
        if (!side)
            continue;
        uint32_t corners[2], segment = trace->segment_count++;
        hatch_line_side_corners(lines->mesh.indices, lines->turns.sides[lines->turns.first[e]], corners);
        for (uint32_t k = 0; k < 2; k++) {
            uint32_t node = trace->ends[2 * segment + k] = add_node(w, lines->mesh.indices[corners[k]]);
            trace->fixed[node] = trace->fixed[node] || lines->turns.creases[e];
        }
        trace->slack_px[segment] = SLACK_PX;
        trace->surface[segment] = (int8_t)side;
    }
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
