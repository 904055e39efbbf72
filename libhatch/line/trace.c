#include "line/trace.h"

#include "math/vector.h"

#define SLACK_PX 1.5f /* an edge's own faces, at their full slope, must not hide it within this distance from it */
#define SLOPE_MAX 4.0 /* largest slope that counts: steeper faces recede from the line, or are seen from behind */

double hatch_line_depth(const struct hatch_view *view, const double point[3])
{
    double from[3];
    hatch_vec_sub(view->eye, point, from);
    return hatch_vec_dot(from, view->back);
}

double hatch_line_pixel(const struct hatch_line_eye *eye, const double point[3])
{
    double depth = eye->view->orthographic ? 1.0 : fmax(hatch_line_depth(eye->view, point), eye->view->near);
    return depth / eye->focal_px;
}

void hatch_line_place(const struct hatch_line_shape *shape, uint32_t vertex, double out[3])
{
    const double *m = shape->to_unit;
    double p[3];
    hatch_vec_of(&shape->positions[3 * (size_t)vertex], p);
    for (int r = 0; r < 3; r++)
        out[r] = m[r] * p[0] + m[4 + r] * p[1] + m[8 + r] * p[2] + m[12 + r];
}

/* Returns the cosine between a face's normal and the direction to the eye; over 0: the face's front is visible. */
static double facing(const struct hatch_line_shape *shape, const struct hatch_line_eye *eye, uint32_t face)
{
    const struct hatch_view *view = eye->view;
    double p[3][3], normal[3], to_eye[3];
    for (uint32_t c = 0; c < 3; c++)
        hatch_line_place(shape, shape->lines->mesh.indices[3 * (size_t)face + c], p[c]);
    hatch_vec_triangle(p[0], p[1], p[2], normal);
    hatch_vec_sub(view->eye, p[0], to_eye);
    if (view->orthographic)
        hatch_vec_copy(view->back, to_eye);
    double sizes = hatch_vec_length(normal) * hatch_vec_length(to_eye);
    double cosine = sizes > 0 ? hatch_vec_dot(normal, to_eye) / sizes : 0.0;
    return shape->mirrored ? -cosine : cosine;
}

/* Returns the slack of an edge, from the slope of its visible face that is turned most towards the eye; -1 if no face
 * is visible. */
static float feature_slack(const struct hatch_line_shape *shape, const struct hatch_line_eye *eye,
                           const struct hatch_line_feature *feature)
{
    double flattest = -1; /* the largest cosine, of the face that is turned most towards the eye */
    for (int i = 0; i < 2 && feature->faces[i] != HATCH_NONE; i++) {
        double cosine = facing(shape, eye, feature->faces[i]);
        bool double_sided = shape->double_sided[feature->faces[i]] || feature->more_faces;
        flattest = fmax(flattest, double_sided ? fabs(cosine) : cosine);
    }
    if (flattest < 0)
        return -1.0f;
    if (feature->faces[1] == HATCH_NONE)
        return SLACK_PX; /* no surface on the other side */
    double slope = sqrt(fmax(1 - flattest * flattest, 0)) / fmax(flattest, 1 / SLOPE_MAX);
    return SLACK_PX * (float)(1 + slope);
}

enum hatch_status hatch_line_trace_features(const struct hatch_line_shape *shape, const struct hatch_line_eye *eye,
                                            struct hatch_arena *arena, struct hatch_line_trace *trace,
                                            struct hatch_err *err)
{
    const struct hatch_line_mesh *lines = shape->lines;
    size_t nodes = lines->node_count, segments = lines->feature_count;
    struct hatch_line_trace made = {.node_count = lines->node_count, .segment_count = lines->feature_count};
    HATCH_TRY(HATCH_ALLOC(arena, &made.nodes, 3 * nodes, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.slack_px, segments, err));
    for (size_t i = 0; i < nodes; i++)
        hatch_line_place(shape, lines->node_vertices[i], &made.nodes[3 * i]);
    for (size_t s = 0; s < segments; s++)
        made.slack_px[s] = feature_slack(shape, eye, &lines->features[s]);
    *trace = made;
    return HATCH_OK;
}
