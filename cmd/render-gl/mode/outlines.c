#include "render-gl/mode/outlines.h"

#include <math.h>

#include "vector/step.h"

#define REACH_PX 0.5 /* largest distance in the picture from a smooth silhouette to the outline of the faces */
#define FEATURE_SLACK_PX 0.05f /* an edge's own faces do not hide it */
#define FLOAT_SLACK 5e-7       /* rounding of positions in the unit scene to floats */
#define PIECE_PX 4.0           /* steps are looked for at least this often */
#define PIECES_MAX 10000.0     /* of a segment */
#define STEP_PX 4.0            /* a part has a step in depth if it is deeper somewhere, */
#define SHALLOW_PX 1.5         /* and nowhere shallower */
#define GAP_PX 16.0            /* shorter parts without a step are drawn, between parts with one */
#define SPECK_PX 4.0           /* shorter parts with a step are not, between parts without one */

#define RANKS 3 /* of curves: rank_of */

/* Curves under construction. */
struct gathering {
    struct hatch_line_eye eye;
    const struct hatch_occluders *occluders;
    uint32_t count;
    struct hatch_buffer curves, points, slack, blank, pieces;
};

/* A part of a silhouette. */
struct piece {
    double length_px;
    double step_px; /* in depth, across it */
    bool step;      /* it is drawn as one */
};

static uint32_t point_count(const struct gathering *gathering)
{
    return (uint32_t)(gathering->slack.size / sizeof(float));
}

/* Adds a point with the distance by which a surface may be nearer without hiding it.
 *   slack_px  of that, in the size that a pixel has there */
static enum hatch_status add_point(struct gathering *gathering, const double at[3], float slack_px, bool blank,
                                   struct hatch_err *err)
{
    const float slack = (float)((double)slack_px * hatch_line_pixel(&gathering->eye, at) + FLOAT_SLACK);
    HATCH_TRY(hatch_buffer_add(&gathering->points, at, 3 * sizeof *at, err));
    HATCH_TRY(hatch_buffer_add(&gathering->blank, &blank, sizeof blank, err));
    return hatch_buffer_add(&gathering->slack, &slack, sizeof slack, err);
}

/* Computes a place in the picture, and the depth; the place is NaN or infinite at the eye. */
static double project(const struct hatch_occluders *occluders, const double point[3], double at_px[2])
{
    double out[3];
    hatch_occluders_project(occluders, point, out);
    double w = occluders->view.orthographic ? 1 : out[2];
    at_px[0] = out[0] / w;
    at_px[1] = out[1] / w;
    return out[2];
}

static void mix(const double a[3], const double b[3], double share, double out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = a[k] + share * (b[k] - a[k]);
}

/* Adds a segment of a silhouette, without its last point, in pieces, and finds the step across each. */
static enum hatch_status add_silhouette(struct gathering *gathering, const double a[3], const double b[3],
                                        float slack_px, int surface, struct hatch_err *err)
{
    double ends[2][2], depth[2];
    depth[0] = project(gathering->occluders, a, ends[0]);
    depth[1] = project(gathering->occluders, b, ends[1]);
    double x = ends[1][0] - ends[0][0], y = ends[1][1] - ends[0][1], length = sqrt(x * x + y * y);
    bool known = depth[0] > 0 && depth[1] > 0 && isfinite(length) && length > 0;
    double count = known ? fmin(fmax(ceil(length / PIECE_PX), 1), PIECES_MAX) : 1;
    const double away[2] = {surface * y / length, -surface * x / length};
    for (double i = 0; i < count; i++) {
        double at[3], middle[3], at_px[2];
        mix(a, b, i / count, at);
        mix(a, b, (i + 0.5) / count, middle);
        double here = project(gathering->occluders, middle, at_px);
        double step = known ? hatch_occluders_step(gathering->occluders, at_px, away, here) : HUGE_VAL;
        const struct piece piece = {known ? length / count : 0, step, step > STEP_PX};
        HATCH_TRY(add_point(gathering, at, slack_px, false, err));
        HATCH_TRY(hatch_buffer_add(&gathering->pieces, &piece, sizeof piece, err));
    }
    return HATCH_OK;
}

/* Continues deep steps where they become shallow, so that a line does not stop and go where they are about STEP_PX. */
static void continue_steps(struct piece *pieces, uint32_t count)
{
    for (uint32_t i = 1; i < count; i++)
        pieces[i].step = pieces[i].step || (pieces[i - 1].step && pieces[i].step_px > SHALLOW_PX);
    for (uint32_t i = count; i-- > 1;)
        pieces[i - 1].step = pieces[i - 1].step || (pieces[i].step && pieces[i - 1].step_px > SHALLOW_PX);
}

/* Changes runs of pieces that are shorter than a length, and lie between runs of the other kind.
 *   step  kind of the runs to change */
static void change_short(struct piece *pieces, uint32_t count, bool step, double length_px)
{
    for (uint32_t i = 0; i < count;) {
        uint32_t begin = i;
        double length = 0;
        for (; i < count && pieces[i].step == pieces[begin].step; i++)
            length += pieces[i].length_px;
        if (pieces[begin].step != step || begin == 0 || i == count || length >= length_px)
            continue;
        for (uint32_t k = begin; k < i; k++)
            pieces[k].step = !step;
    }
}

/* Leaves out the parts of the last curve that have no step.
 *   first  its first point */
static void blank_flat(struct gathering *gathering, uint32_t first)
{
    struct piece *pieces = (void *)gathering->pieces.data;
    bool *blank = (void *)gathering->blank.data;
    uint32_t count = (uint32_t)(gathering->pieces.size / sizeof *pieces);
    continue_steps(pieces, count);
    change_short(pieces, count, false, GAP_PX);
    change_short(pieces, count, true, SPECK_PX);
    for (uint32_t i = 0; i < count; i++)
        blank[first + i] = !pieces[i].step;
    gathering->pieces.size = 0;
}

/* Adds a chain of silhouettes. */
static enum hatch_status add_outline(struct gathering *gathering, const struct hatch_line_curves *from,
                                     const struct hatch_line_chain *chain, const uint32_t *nodes, struct hatch_err *err)
{
    uint32_t first = point_count(gathering);
    const struct hatch_line_trace *trace = &from->trace;
    for (uint32_t k = 0; k < chain->segment_count; k++) {
        uint32_t segment = from->chains.segments[chain->first + k];
        HATCH_TRY(add_silhouette(gathering, &trace->nodes[3 * (size_t)nodes[k]],
                                 &trace->nodes[3 * (size_t)nodes[k + 1]], trace->slack_px[segment],
                                 trace->surface[segment], err));
    }
    uint32_t last = from->chains.segments[chain->first + chain->segment_count - 1];
    HATCH_TRY(add_point(gathering, &trace->nodes[3 * (size_t)nodes[chain->segment_count]], trace->slack_px[last], false,
                        err));
    blank_flat(gathering, first);
    return HATCH_OK;
}

/* Adds a chain of creases or boundaries. Where no face at an edge can be seen, the edge is not drawn either, but it is
 * hidden only where surfaces hide it. */
static enum hatch_status add_feature(struct gathering *gathering, const struct hatch_line_curves *from,
                                     const struct hatch_line_chain *chain, const uint32_t *nodes, struct hatch_err *err)
{
    for (uint32_t k = 0; k <= chain->segment_count; k++) {
        uint32_t segment = from->chains.segments[chain->first + (k < chain->segment_count ? k : k - 1)];
        const double *at = &from->trace.nodes[3 * (size_t)nodes[k]];
        HATCH_TRY(add_point(gathering, at, FEATURE_SLACK_PX, from->trace.slack_px[segment] < 0, err));
    }
    return HATCH_OK;
}

static enum hatch_status add_chains(struct gathering *gathering, const struct hatch_line_curves *from,
                                    struct hatch_err *err)
{
    for (uint32_t i = 0; i < from->chains.count; i++) {
        const struct hatch_line_chain *chain = &from->chains.chains[i];
        const uint32_t *nodes = &from->chains.nodes[chain->first + i];
        struct hatch_vector_curve curve = {.first = point_count(gathering),
                                           .id = ++gathering->count,
                                           .reach_px = from->silhouettes ? REACH_PX : 0,
                                           .closed = chain->closed};
        HATCH_TRY((from->silhouettes ? add_outline : add_feature)(gathering, from, chain, nodes, err));
        curve.count = point_count(gathering) - curve.first;
        HATCH_TRY(hatch_buffer_add(&gathering->curves, &curve, sizeof curve, err));
    }
    return HATCH_OK;
}

/* Returns the place of curves among those of a frame: curves that are the same in all frames come first, so that their
 * numbers are the same, too. */
static int rank_of(const struct hatch_line_curves *curves)
{
    return curves->silhouettes ? 2 : curves->deformed ? 1 : 0;
}

enum hatch_status outlines_trace(const struct hatch_lines *lines, const struct hatch_view *view, double height_px,
                                 const struct hatch_occluders *occluders, struct hatch_arena *arena,
                                 struct hatch_vector_curves *curves, struct hatch_err *err)
{
    struct gathering gathering = {.eye = {view, 0.5 * height_px / view->half_height},
                                  .occluders = occluders,
                                  .curves = {.arena = arena},
                                  .points = {.arena = arena},
                                  .slack = {.arena = arena},
                                  .blank = {.arena = arena},
                                  .pieces = {.arena = arena}};
    struct hatch_line_curves *sets;
    uint32_t count;
    HATCH_TRY(hatch_lines_pose(lines, view, height_px, arena, &sets, &count, err));
    for (int rank = 0; rank < RANKS; rank++)
        for (uint32_t i = 0; i < count; i++)
            if (rank_of(&sets[i]) == rank)
                HATCH_TRY(add_chains(&gathering, &sets[i], err));
    *curves = (struct hatch_vector_curves){.count = gathering.count,
                                           .curves = (const void *)gathering.curves.data,
                                           .points = (const void *)gathering.points.data,
                                           .slack = (const void *)gathering.slack.data,
                                           .blank = (const void *)gathering.blank.data};
    return HATCH_OK;
}
