/* Strokes as curves of the mesh: points where pieces meet, without those that a straight line passes closely enough. */
#include <math.h>
#include <string.h>

#include "trace/work.h"

#define TOLERANCE 0.15 /* of the finest gap: how far a line may pass beside the stroke, */
#define LENGTH_MIN 1.0 /* of the gap of its level: shorter strokes are left out */

double hatch_trace_threshold_at(const struct hatch_tracer *tracer, const struct hatch_trace_stroke *stroke, double arc)
{
    double step = HATCH_TRACE_STEP * ldexp(tracer->gap, (int)(tracer->level - stroke->level));
    double last = (double)stroke->threshold_count[0] + stroke->threshold_count[1] - 1;
    double at = fmin(fmax(arc / step + stroke->threshold_count[1], 0), last), before = floor(at);
    const float *threshold = &tracer->thresholds[stroke->first_threshold];
    double a = log((double)threshold[(size_t)before]), b = log((double)threshold[(size_t)fmin(before + 1, last)]);
    return a + (at - before) * (b - a);
}

/* The joints of a stroke, from its back to its front. */
struct joints {
    struct hatch_trace_joint *list;
    uint32_t count, capacity;
};

static enum hatch_status add_joint(const struct hatch_tracer *tracer, const struct hatch_trace_stroke *stroke,
                                   uint32_t face, const double place[2], double arc, struct joints *joints,
                                   struct hatch_err *err)
{
    HATCH_TRY(hatch_curve_reserve(tracer->scratch, &joints->list, sizeof *joints->list, joints->count,
                                  &joints->capacity, err));
    struct hatch_trace_joint *joint = &joints->list[joints->count++];
    const struct hatch_trace_pose *pose = &tracer->ground.poses[face];
    *joint = (struct hatch_trace_joint){.face = face, .x = place[0], .y = place[1], .arc = arc};
    hatch_trace_position(pose, joint->x, joint->y, joint->at);
    hatch_trace_normal(pose, joint->normal);
    joint->log_threshold = hatch_trace_threshold_at(tracer, stroke, arc);
    return HATCH_OK;
}

/* Adds the joints of half a stroke, without its seed, in the order from the seed. */
static enum hatch_status add_half(const struct hatch_tracer *tracer, const struct hatch_trace_stroke *stroke,
                                  uint32_t way, struct joints *joints, struct hatch_err *err)
{
    for (uint32_t n = stroke->first[way]; n != HATCH_TRACE_NONE; n = tracer->pieces[n].next) {
        const struct hatch_trace_piece *piece = &tracer->pieces[n];
        const double place[2] = {(double)piece->to[0], (double)piece->to[1]};
        double arc = way ? -(double)piece->arc : (double)piece->arc;
        HATCH_TRY(add_joint(tracer, stroke, piece->face, place, arc, joints, err));
    }
    return HATCH_OK;
}

static enum hatch_status list_joints(const struct hatch_tracer *tracer, const struct hatch_trace_stroke *stroke,
                                     struct joints *joints, struct hatch_err *err)
{
    const double seed[2] = {stroke->seed.x, stroke->seed.y};
    joints->count = 0;
    HATCH_TRY(add_half(tracer, stroke, 1, joints, err));
    for (uint32_t i = 0; i < joints->count / 2; i++) {
        struct hatch_trace_joint swapped = joints->list[i];
        joints->list[i] = joints->list[joints->count - 1 - i];
        joints->list[joints->count - 1 - i] = swapped;
    }
    HATCH_TRY(add_joint(tracer, stroke, stroke->seed.face, seed, 0, joints, err));
    return add_half(tracer, stroke, 0, joints, err);
}

/* Adds a stroke.
 *   gap  of its level */
static enum hatch_status add_curve(const struct hatch_tracer *tracer, const struct hatch_trace_stroke *stroke,
                                   double gap, const struct hatch_trace_joint *joints, uint32_t count,
                                   struct hatch_trace_sink *sink, struct hatch_err *err)
{
    struct hatch_curves *to = &sink->curves;
    HATCH_TRY(hatch_curve_reserve(sink->arena, &to->curves, sizeof *to->curves, to->count, &sink->capacity, err));
    HATCH_TRY(
        hatch_curve_reserve(sink->arena, &sink->levels, sizeof *sink->levels, to->count, &sink->level_capacity, err));
    sink->levels[to->count] = (uint8_t)stroke->level;
    to->curves[to->count++] =
        (struct hatch_curve){.first = to->point_count,
                             .count = count,
                             .id = (uint32_t)(stroke->id >> 32) & HATCH_CURVE_ID_MAX,
                             .free_ends = (stroke->bound[1] ? 0u : 1u) | (stroke->bound[0] ? 0u : 2u)};
    for (uint32_t i = 0; i < count; i++) {
        HATCH_TRY(hatch_curve_reserve(sink->arena, &to->points, sizeof *to->points, to->point_count,
                                      &sink->point_capacity, err));
        struct hatch_curve_point *point = &to->points[to->point_count++];
        double scale = tracer->component->scale;
        hatch_trace_fill_point(&tracer->ground, sink->mesh, &joints[i], exp(joints[i].log_threshold) / scale, point);
        hatch_trace_find_narrow(&tracer->ground, tracer->options, tracer->family, &joints[i], gap, scale, point);
    }
    return HATCH_OK;
}

static enum hatch_status add_curves(const struct hatch_tracer *tracer, struct hatch_trace_sink *sink,
                                    struct hatch_err *err)
{
    double tolerance = TOLERANCE * tracer->gap;
    struct joints joints = {0};
    for (uint32_t s = 0; s < tracer->stroke_count; s++) {
        const struct hatch_trace_stroke *stroke = &tracer->strokes[s];
        double gap = ldexp(tracer->gap, (int)(tracer->level - stroke->level));
        if (stroke->length[0] + stroke->length[1] < LENGTH_MIN * gap)
            continue;
        HATCH_TRY(list_joints(tracer, stroke, &joints, err));
        uint32_t count = hatch_trace_simplify(joints.list, joints.count, tolerance);
        if (count > 1)
            HATCH_TRY(add_curve(tracer, stroke, gap, joints.list, count, sink, err));
    }
    return HATCH_OK;
}

enum hatch_status hatch_trace_collect(const struct hatch_tracer *tracer, struct hatch_trace_sink *sink,
                                      struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(tracer->scratch);
    enum hatch_status status = add_curves(tracer, sink, err);
    hatch_arena_rewind(tracer->scratch, mark);
    return status;
}
