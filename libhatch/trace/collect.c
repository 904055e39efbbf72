/* Strokes as curves of the mesh: points where pieces meet, without those that a straight line passes closely enough. */
#include <math.h>
#include <string.h>

#include "math/vector.h"
#include "trace/work.h"

#define TOLERANCE 0.15      /* of the finest gap: how far a line may pass from the stroke */
#define SPAN_MAX 64u        /* pieces that a line may replace */
#define THRESHOLD_RATIO 0.1 /* logarithm of the ratio by which a line's threshold may differ */
#define LENGTH_MIN 1.0      /* of the gap of its level: shorter strokes are left out, unless an edge ends them */

/* A place on a stroke where two pieces meet, or where it begins or ends. */
struct joint {
    uint32_t face;
    float x, y, at[3];
    double arc; /* from the seed, negative behind it */
    double log_threshold;
};

/* Returns the logarithm of the threshold at a length from the seed, by interpolation. */
static double threshold_at(const struct hatch_tracer *tracer, const struct hatch_trace_stroke *stroke, double arc)
{
    double step = HATCH_TRACE_STEP * ldexp(tracer->gap, (int)(tracer->level - stroke->level));
    double last = (double)stroke->threshold_count[0] + stroke->threshold_count[1] - 1;
    double at = fmin(fmax(arc / step + stroke->threshold_count[1], 0), last), before = floor(at);
    const float *threshold = &tracer->thresholds[stroke->first_threshold];
    double a = log((double)threshold[(size_t)before]), b = log((double)threshold[(size_t)fmin(before + 1, last)]);
    return a + (at - before) * (b - a);
}

static void set_joint(const struct hatch_tracer *tracer, const struct hatch_trace_stroke *stroke, uint32_t face,
                      const float place[2], double arc, struct joint *joint)
{
    *joint = (struct joint){.face = face, .x = place[0], .y = place[1], .arc = arc};
    hatch_trace_position(&tracer->ground.poses[face], (double)place[0], (double)place[1], joint->at);
    joint->log_threshold = threshold_at(tracer, stroke, arc);
}

/* Lists the joints of a stroke from its back to its front.
 *   joints  out: room for one per piece, and one */
static uint32_t list_joints(const struct hatch_tracer *tracer, const struct hatch_trace_stroke *stroke,
                            struct joint *joints)
{
    uint32_t count = 0;
    const float seed[2] = {(float)stroke->seed.x, (float)stroke->seed.y};
    for (uint32_t n = stroke->first[1]; n != HATCH_TRACE_NONE; n = tracer->pieces[n].next)
        set_joint(tracer, stroke, tracer->pieces[n].face, tracer->pieces[n].to, -(double)tracer->pieces[n].arc,
                  &joints[count++]);
    for (uint32_t i = 0; i < count / 2; i++) {
        struct joint swapped = joints[i];
        joints[i] = joints[count - 1 - i];
        joints[count - 1 - i] = swapped;
    }
    set_joint(tracer, stroke, stroke->seed.face, seed, 0, &joints[count++]);
    for (uint32_t n = stroke->first[0]; n != HATCH_TRACE_NONE; n = tracer->pieces[n].next)
        set_joint(tracer, stroke, tracer->pieces[n].face, tracer->pieces[n].to, (double)tracer->pieces[n].arc,
                  &joints[count++]);
    return count;
}

/* Returns whether a straight line from one joint to another is as good as the way over the joints between them. */
static bool is_straight(const struct joint *joints, uint32_t from, uint32_t to, double tolerance)
{
    double a[3], b[3], line[3], length = joints[to].arc - joints[from].arc;
    hatch_vec_of(joints[from].at, a);
    hatch_vec_of(joints[to].at, b);
    hatch_vec_sub(b, a, line);
    for (uint32_t i = from + 1; i < to; i++) {
        double share = length > 0 ? (joints[i].arc - joints[from].arc) / length : 0, p[3], on_line[3];
        double wanted = joints[from].log_threshold + share * (joints[to].log_threshold - joints[from].log_threshold);
        hatch_vec_of(joints[i].at, p);
        hatch_vec_add_scaled(a, share, line, on_line);
        if (!(hatch_vec_distance(p, on_line) <= tolerance) ||
            !(fabs(joints[i].log_threshold - wanted) <= THRESHOLD_RATIO))
            return false;
    }
    return true;
}

/* Keeps the joints that are needed, moved to the front of the list; returns their number. From each, the line to the
 * farthest that doubling and halving of the distance find. */
static uint32_t simplify(struct joint *joints, uint32_t count, double tolerance)
{
    uint32_t kept = 1, from = 0;
    while (from + 1 < count) {
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

/* Converts a joint to a point of the mesh, whose faces may list their corners in another order. */
static void fill_point(const struct hatch_tracer *tracer, const struct hatch_mesh *mesh, const struct joint *joint,
                       struct hatch_curve_point *point)
{
    const struct hatch_surface *surface = tracer->ground.surface;
    uint32_t from = tracer->ground.source[joint->face], face = surface->face_source[from];
    const uint32_t *vertex = &surface->corner_vertex[3 * (size_t)from];
    double share[3], of_mesh[3] = {0, 0, 0}, sum = 0;
    hatch_trace_shares(&tracer->ground.faces[joint->face], (double)joint->x, (double)joint->y, share);
    for (int c = 0; c < 3; c++) {
        share[c] = fmin(fmax(share[c], 0), 1);
        sum += share[c];
    }
    for (int c = 0; c < 3; c++)
        for (int to = 0; to < 3; to++)
            if (mesh->indices[3 * (size_t)face + (size_t)to] == vertex[c])
                of_mesh[to] = share[c] / sum;
    *point = (struct hatch_curve_point){
        .face = face,
        .share = {(float)of_mesh[1], (float)of_mesh[2]},
        .threshold = (float)(exp(joint->log_threshold) / tracer->component->scale),
    };
}

static enum hatch_status add_curve(const struct hatch_tracer *tracer, const struct hatch_trace_stroke *stroke,
                                   const struct joint *joints, uint32_t count, struct hatch_trace_sink *sink,
                                   struct hatch_err *err)
{
    struct hatch_curves *to = &sink->curves;
    HATCH_TRY(hatch_trace_reserve(sink->arena, &to->curves, sizeof *to->curves, to->count, &sink->capacity, err));
    HATCH_TRY(
        hatch_trace_reserve(sink->arena, &sink->levels, sizeof *sink->levels, to->count, &sink->level_capacity, err));
    sink->levels[to->count] = (uint8_t)stroke->level;
    to->curves[to->count++] =
        (struct hatch_curve){.first = to->point_count, .count = count, .id = (uint32_t)(stroke->id >> 32)};
    for (uint32_t i = 0; i < count; i++) {
        HATCH_TRY(hatch_trace_reserve(sink->arena, &to->points, sizeof *to->points, to->point_count,
                                      &sink->point_capacity, err));
        fill_point(tracer, sink->mesh, &joints[i], &to->points[to->point_count++]);
    }
    return HATCH_OK;
}

enum hatch_status hatch_trace_collect(const struct hatch_tracer *tracer, struct hatch_trace_sink *sink,
                                      struct hatch_err *err)
{
    double tolerance = TOLERANCE * tracer->gap;
    struct joint *joints;
    HATCH_TRY(HATCH_ALLOC_UNSET(tracer->scratch, &joints, (size_t)tracer->piece_count + 1, err));
    for (uint32_t s = 0; s < tracer->stroke_count; s++) {
        const struct hatch_trace_stroke *stroke = &tracer->strokes[s];
        double gap = ldexp(tracer->gap, (int)(tracer->level - stroke->level));
        if (stroke->length[0] + stroke->length[1] < LENGTH_MIN * gap)
            continue;
        uint32_t count = simplify(joints, list_joints(tracer, stroke, joints), tolerance);
        if (count > 1)
            HATCH_TRY(add_curve(tracer, stroke, joints, count, sink, err));
    }
    return HATCH_OK;
}
