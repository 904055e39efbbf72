/* Strokes as curves of the mesh: points where pieces meet, without those that a straight line passes closely enough. */
#include <math.h>
#include <string.h>

#include "trace/work.h"

#define TOLERANCE 0.15 /* of the finest gap: how far a line may pass from the stroke */
#define LENGTH_MIN 1.0 /* of the gap of its level: shorter strokes are left out, unless an edge ends them */

double hatch_trace_threshold_at(const struct hatch_tracer *tracer, const struct hatch_trace_stroke *stroke, double arc)
{
    double step = HATCH_TRACE_STEP * ldexp(tracer->gap, (int)(tracer->level - stroke->level));
    double last = (double)stroke->threshold_count[0] + stroke->threshold_count[1] - 1;
    double at = fmin(fmax(arc / step + stroke->threshold_count[1], 0), last), before = floor(at);
    const float *threshold = &tracer->thresholds[stroke->first_threshold];
    double a = log((double)threshold[(size_t)before]), b = log((double)threshold[(size_t)fmin(before + 1, last)]);
    return a + (at - before) * (b - a);
}

static void set_joint(const struct hatch_tracer *tracer, const struct hatch_trace_stroke *stroke, uint32_t face,
                      const float place[2], double arc, struct hatch_trace_joint *joint)
{
    *joint = (struct hatch_trace_joint){.face = face, .x = (double)place[0], .y = (double)place[1], .arc = arc};
    hatch_trace_position(&tracer->ground.poses[face], joint->x, joint->y, joint->at);
    joint->log_threshold = hatch_trace_threshold_at(tracer, stroke, arc);
}

/* Lists the joints of a stroke from its back to its front.
 *   joints  out: room for one per piece, and one */
static uint32_t list_joints(const struct hatch_tracer *tracer, const struct hatch_trace_stroke *stroke,
                            struct hatch_trace_joint *joints)
{
    uint32_t count = 0;
    const float seed[2] = {(float)stroke->seed.x, (float)stroke->seed.y};
    for (uint32_t n = stroke->first[1]; n != HATCH_TRACE_NONE; n = tracer->pieces[n].next)
        set_joint(tracer, stroke, tracer->pieces[n].face, tracer->pieces[n].to, -(double)tracer->pieces[n].arc,
                  &joints[count++]);
    for (uint32_t i = 0; i < count / 2; i++) {
        struct hatch_trace_joint swapped = joints[i];
        joints[i] = joints[count - 1 - i];
        joints[count - 1 - i] = swapped;
    }
    set_joint(tracer, stroke, stroke->seed.face, seed, 0, &joints[count++]);
    for (uint32_t n = stroke->first[0]; n != HATCH_TRACE_NONE; n = tracer->pieces[n].next)
        set_joint(tracer, stroke, tracer->pieces[n].face, tracer->pieces[n].to, (double)tracer->pieces[n].arc,
                  &joints[count++]);
    return count;
}

static enum hatch_status add_curve(const struct hatch_tracer *tracer, const struct hatch_trace_stroke *stroke,
                                   const struct hatch_trace_joint *joints, uint32_t count,
                                   struct hatch_trace_sink *sink, struct hatch_err *err)
{
    struct hatch_curves *to = &sink->curves;
    HATCH_TRY(hatch_trace_reserve(sink->arena, &to->curves, sizeof *to->curves, to->count, &sink->capacity, err));
    HATCH_TRY(
        hatch_trace_reserve(sink->arena, &sink->levels, sizeof *sink->levels, to->count, &sink->level_capacity, err));
    sink->levels[to->count] = (uint8_t)stroke->level;
    to->curves[to->count++] =
        (struct hatch_curve){.first = to->point_count,
                             .count = count,
                             .id = (uint32_t)(stroke->id >> 32) & HATCH_CURVE_ID_MAX,
                             .free_ends = (stroke->bound[1] ? 0u : 1u) | (stroke->bound[0] ? 0u : 2u)};
    for (uint32_t i = 0; i < count; i++) {
        HATCH_TRY(hatch_trace_reserve(sink->arena, &to->points, sizeof *to->points, to->point_count,
                                      &sink->point_capacity, err));
        hatch_trace_fill_point(&tracer->ground, sink->mesh, &joints[i],
                               exp(joints[i].log_threshold) / tracer->component->scale, &to->points[to->point_count++]);
    }
    return HATCH_OK;
}

enum hatch_status hatch_trace_collect(const struct hatch_tracer *tracer, struct hatch_trace_sink *sink,
                                      struct hatch_err *err)
{
    double tolerance = TOLERANCE * tracer->gap;
    struct hatch_trace_joint *joints;
    HATCH_TRY(HATCH_ALLOC_UNSET(tracer->scratch, &joints, (size_t)tracer->piece_count + 1, err));
    for (uint32_t s = 0; s < tracer->stroke_count; s++) {
        const struct hatch_trace_stroke *stroke = &tracer->strokes[s];
        double gap = ldexp(tracer->gap, (int)(tracer->level - stroke->level));
        if (stroke->length[0] + stroke->length[1] < LENGTH_MIN * gap)
            continue;
        uint32_t count = hatch_trace_simplify(joints, list_joints(tracer, stroke, joints), tolerance);
        if (count > 1)
            HATCH_TRY(add_curve(tracer, stroke, joints, count, sink, err));
    }
    return HATCH_OK;
}
