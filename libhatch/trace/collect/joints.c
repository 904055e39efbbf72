/* Joints of strokes, and the points of curves that are made from them. */
#include <math.h>

#include "math/vector.h"
#include "trace/work.h"

#define DEPTH 2.0           /* a line may pass so many times as far above or under a joint as beside it */
#define SPAN_MAX 64u        /* pieces that a line may replace */
#define THRESHOLD_RATIO 0.1 /* logarithm of the ratio by which a line's threshold may differ */

/* Returns whether a straight line from one joint to another is as good as the way over the joints between them. */
static bool is_straight(const struct hatch_trace_joint *joints, uint32_t from, uint32_t to, double tolerance)
{
    const double *a = joints[from].at;
    double line[3], length = joints[to].arc - joints[from].arc;
    hatch_vec_sub(joints[to].at, a, line);
    for (uint32_t i = from + 1; i < to; i++) {
        double share = length > 0 ? (joints[i].arc - joints[from].arc) / length : 0, off[3], normal[3];
        double wanted = joints[from].log_threshold + share * (joints[to].log_threshold - joints[from].log_threshold);
        hatch_vec_sub(joints[i].at, a, off);
        hatch_vec_add_scaled(off, -share, line, off);
        hatch_vec_of(joints[i].normal, normal);
        double depth = hatch_vec_dot(off, normal), square = hatch_vec_dot(off, off);
        if (!(square - (1 - 1 / (DEPTH * DEPTH)) * depth * depth <= tolerance * tolerance) ||
            !(fabs(joints[i].log_threshold - wanted) <= THRESHOLD_RATIO))
            return false;
    }
    return true;
}

uint32_t hatch_trace_simplify(struct hatch_trace_joint *joints, uint32_t count, double tolerance)
{
    uint32_t kept = 1, from = 0;
    while (from + 1 < count) { /* to the farthest joint that doubling and halving of the distance find */
        uint32_t good = 1, bad = 2;
        while (bad <= SPAN_MAX && from + bad < count && is_straight(joints, from, from + bad, tolerance)) {
            good = bad;
            bad *= 2;
        }
        bad = bad < count - from ? bad : count - from;
        while (bad - good > 1) {
            uint32_t middle = (good + bad) / 2;
            if (is_straight(joints, from, from + middle, tolerance))
                good = middle;
            else
                bad = middle;
        }
        from += good;
        joints[kept++] = joints[from];
    }
    return kept;
}

void hatch_trace_fill_point(const struct hatch_trace_ground *ground, const struct hatch_mesh *mesh,
                            const struct hatch_trace_joint *joint, double threshold, struct hatch_curve_point *point)
{
    const struct hatch_surface *surface = ground->surface;
    uint32_t from = ground->source[joint->face], face = surface->face_source[from];
    const uint32_t *vertex = &surface->corner_vertex[3 * (size_t)from];
    double share[3], of_mesh[3] = {0, 0, 0}, sum = 0;
    hatch_trace_shares(&ground->faces[joint->face], joint->x, joint->y, share);
    for (int c = 0; c < 3; c++) {
        share[c] = fmin(fmax(share[c], 0), 1);
        sum += share[c];
    }
    for (int c = 0; c < 3; c++)
        for (int to = 0; to < 3; to++)
            if (mesh->indices[3 * (size_t)face + (size_t)to] == vertex[c])
                of_mesh[to] = share[c] / sum;
    *point = (struct hatch_curve_point){
        .face = face, .share = {(float)of_mesh[1], (float)of_mesh[2]}, .threshold = (float)threshold};
}
