/* Narrow faces: parts of the ground between two ends of it, a border or a hard edge each, that are some times as long
 * as wide. */
#include <math.h>
#include <string.h>

#include "trace/work.h"

#define REACH_GAPS 32.0 /* widest of them, in gaps of the point's level */
#define SLENDER 3.0     /* least ratio of their length to their width */
#define ASIDE 2.0       /* widths to both sides of a point at which the width is measured, too */
#define EVEN 1.1        /* ratio of widths that are the same */
#define INSIDE 1e-5     /* of the way to the middle of a face */
#define ROUNDS_MAX 6    /* of measuring farther around a place */
#define LEGS_MAX 1024u  /* faces across which a way is walked: over more of them, none is narrow */
#define CLEARLY 0.85    /* a family crosses instead of one before it if its way is at most so long */

/* A straight way. */
struct way {
    double length;
    bool ended;       /* the ground has ended there; else its length is the reach */
    double to_end[2]; /* cosine and sine of the angle from the way to the edge where it ended */
};

static void rotate(const double vector[2], const double by[2], double rotated[2])
{
    double x = vector[0] * by[0] - vector[1] * by[1];
    rotated[1] = vector[0] * by[1] + vector[1] * by[0];
    rotated[0] = x;
}

/* Walks straight on.
 *   place  in, out */
static struct way walk(const struct hatch_trace_ground *ground, struct hatch_trace_place *place, double reach)
{
    struct way way = {.ended = false};
    for (uint32_t n = 0; n < LEGS_MAX && reach - way.length > 1e-6 * reach; n++) {
        struct hatch_trace_leg leg;
        bool goes_on = hatch_trace_walk(ground, place, reach - way.length, HATCH_TRACE_STRAIGHT, &leg);
        way.length += leg.length;
        if (goes_on)
            continue;
        double corner[3][2];
        hatch_trace_corners(&ground->faces[leg.face], corner);
        const double *from = corner[leg.side % 3], *to = corner[(leg.side + 1) % 3],
                     back[2] = {place->heading[0], -place->heading[1]};
        double edge[2] = {to[0] - from[0], to[1] - from[1]}, size = hypot(edge[0], edge[1]);
        way.ended = true;
        rotate(edge, back, way.to_end);
        for (int k = 0; k < 2 && size > 0; k++)
            way.to_end[k] /= size;
        return way;
    }
    return way;
}

/* The straight ways to both sides of a place: along its heading, and against it. */
struct span {
    struct way ways[2];
    double width; /* of both together; HUGE_VAL if one does not end within the reach */
};

/* Finds the ways, up to a reach of both together.
 *   least  no way ends before that */
static struct span span_at(const struct hatch_trace_ground *ground, const struct hatch_trace_place *place, double reach,
                           double least)
{
    struct span span = {.width = 0};
    for (int side = 0; side < 2; side++) {
        struct hatch_trace_place there = *place;
        there.heading[0] *= 1 - 2 * side;
        there.heading[1] *= 1 - 2 * side;
        span.ways[side] = walk(ground, &there, reach - (side ? span.width : least));
        span.width = span.ways[side].ended ? span.width + span.ways[side].length : HUGE_VAL;
        if (span.width >= reach)
            span.width = HUGE_VAL;
        if (span.width == HUGE_VAL)
            break;
    }
    return span;
}

/* Moves a place to the middle of its span, where ways along the face do not run on its border. */
static void move_to_middle(const struct hatch_trace_ground *ground, const struct span *span,
                           struct hatch_trace_place *place)
{
    double ahead = (span->ways[0].length - span->ways[1].length) / 2, sign = ahead < 0 ? -1 : 1;
    for (int pass = 0; pass < 2; pass++) { /* the heading stays what it was */
        place->heading[0] *= sign;
        place->heading[1] *= sign;
        if (pass == 0)
            walk(ground, place, fabs(ahead));
    }
}

/* A narrow face around a place. */
struct extent {
    double width, length;
};

/* Measures how far a face goes on along an end of it, up to some widths, and the widths on the way.
 *   place   its heading is that of the way across
 *   to_end  cosine and sine of the angle from there to the end of the ground
 *   width   at the place
 * Returns the greatest width, HUGE_VAL if it is longer than the reach. */
static struct extent measure(const struct hatch_trace_ground *ground, const struct hatch_trace_place *place,
                             const double to_end[2], double width, double reach)
{
    const double back[2] = {to_end[0], -to_end[1]};
    struct extent extent = {width, 0};
    for (int side = 0; side < 2; side++) {
        struct hatch_trace_place aside = *place;
        rotate(place->heading, to_end, aside.heading);
        aside.heading[0] *= 1 - 2 * side;
        aside.heading[1] *= 1 - 2 * side;
        struct way way = walk(ground, &aside, ASIDE * width);
        extent.length += way.length;
        if (way.ended) /* at the end itself, there is no width */
            continue;
        struct hatch_trace_place across = aside;
        rotate(aside.heading, back, across.heading);
        extent.width = fmax(extent.width, span_at(ground, &across, reach, 0).width);
        extent.length += walk(ground, &aside, ASIDE * width).length;
    }
    return extent;
}

/* Returns the width of the face around a place, or HUGE_VAL if it is not much longer than wide. In a corner of it, the
 * way across is shorter than elsewhere; the arguments are those of measure(). */
static double find_width(const struct hatch_trace_ground *ground, const struct hatch_trace_place *place,
                         const double to_end[2], double width, double reach)
{
    for (int n = 0; n < ROUNDS_MAX; n++) {
        struct extent extent = measure(ground, place, to_end, width, reach);
        if (!(extent.width <= reach))
            return HUGE_VAL;
        if (extent.width <= EVEN * width)
            return extent.length >= SLENDER * extent.width ? extent.width : HUGE_VAL;
        width = extent.width;
    }
    return HUGE_VAL;
}

/* Returns the place of a joint, a little inside of its face: rounding may have put it outside. */
static struct hatch_trace_place place_in(const struct hatch_trace_ground *ground, const struct hatch_trace_joint *joint)
{
    const struct hatch_trace_face *face = &ground->faces[joint->face];
    double middle[2] = {((double)face->x1 + (double)face->x2) / 3, (double)face->y2 / 3};
    return (struct hatch_trace_place){
        joint->face, joint->x + INSIDE * (middle[0] - joint->x), joint->y + INSIDE * (middle[1] - joint->y), {1, 0}};
}

/* Returns the width of the face around a place, along its heading; HUGE_VAL if it is not narrow.
 *   least  as in span_at */
static double width_along(const struct hatch_trace_ground *ground, const struct hatch_trace_place *place, double reach,
                          double least)
{
    struct hatch_trace_place middle = *place;
    struct span span = span_at(ground, place, reach, least);
    double width = HUGE_VAL;
    if (!(span.width > 0 && span.width < HUGE_VAL))
        return HUGE_VAL;
    move_to_middle(ground, &span, &middle);
    for (int side = 0; side < 2; side++) /* the angle from the way back to its end is the same but for half a turn */
        width = fmin(width, find_width(ground, &middle, span.ways[side].to_end, span.width, reach));
    return width;
}

void hatch_trace_find_narrow(const struct hatch_trace_ground *ground, const struct hatch_trace_options *options,
                             uint32_t family, const struct hatch_trace_joint *joint, double gap, double scale,
                             struct hatch_curve_point *point)
{
    struct hatch_trace_place here = place_in(ground, joint);
    struct hatch_trace_end end = hatch_trace_end_near(ground, joint->face);
    double direction[2], least = HUGE_VAL;
    double reach = fmin(REACH_GAPS * gap, (double)end.length); /* no narrow face is wider than its ends are long */
    /* One end is within half of the reach, and the way along edges less than twice as long. */
    if ((double)end.distance > reach || !hatch_trace_direction(ground, &here, direction))
        return;
    for (uint32_t f = 0; f < options->family_count; f++) {
        double angle = (double)options->angle_rad[f] - (double)options->angle_rad[family];
        if (!isfinite(angle))
            continue;
        rotate(direction, (const double[]){cos(angle), sin(angle)}, here.heading);
        double width = width_along(ground, &here, reach, 0.5 * (double)end.distance);
        if (width < (least < HUGE_VAL ? CLEARLY * least : HUGE_VAL)) {
            least = width;
            point->across = f;
        }
    }
    point->width = least < HUGE_VAL ? (float)(least * scale) : 0;
}
