#include "vector/curves.h"

#include "math/range.h"
#include "math/vector.h"
#include "vector/runs.h"
#include "vector/sight.h"

#define ROUNDING 1e-9 /* slack of all segments, relative to the depth: a surface does not hide a line on it */

struct work {
    const struct hatch_occluders *occluders;
    const struct hatch_vector_curves *curves;
    const struct hatch_vector_pen *pen;
    struct hatch_sight sight;
    struct hatch_vector_runs runs; /* of one curve; visible parts are kept */
    bool hidden;                   /* hidden parts are wanted */
};

double hatch_vector_half_width(const struct hatch_vector_pen *pen, double wanted_px)
{
    return wanted_px - 0.5 * pen->width_px;
}

/* Adds the visible and the hidden pieces of a segment inside the picture.
 *   unseen  it is hidden
 *   blank   it is not drawn where it is in sight */
static enum hatch_status add_line(struct work *w, const struct hatch_sight_line *line, bool unseen, bool blank,
                                  struct hatch_err *err)
{
    const double *a = line->at[0], *b = line->at[1];
    double at = 0;
    if (unseen || (blank && !w->hidden))
        return hatch_vector_runs_add(&w->runs, a, b, 0, 1, false, err);
    HATCH_TRY(hatch_sight_find(&w->sight, line, err));
    for (uint32_t i = 0; i < w->sight.count; i++) {
        const double *part = w->sight.parts[i];
        HATCH_TRY(hatch_vector_runs_add(&w->runs, a, b, at, part[0], false, err));
        HATCH_TRY(blank ? hatch_vector_runs_add_blank(&w->runs, a, b, part[0], part[1], err)
                        : hatch_vector_runs_add(&w->runs, a, b, part[0], part[1], true, err));
        at = part[1];
    }
    return hatch_vector_runs_add(&w->runs, a, b, at, 1, false, err);
}

/* Cuts a segment at the planes of the view. Returns false if nothing remains.
 *   ends    in, out: projected, as hatch_occluders_project returns them
 *   shares  out: what remains, 0 .. 1 along the segment */
static bool cut_depth(const struct hatch_occluders *occluders, double ends[2][3], double shares[2])
{
    const struct hatch_view *view = &occluders->view;
    double near = view->orthographic ? -occluders->nearest : 1 / occluders->nearest;
    double from[3], along[3];
    shares[0] = 0;
    shares[1] = 1;
    if (!hatch_range_keep(ends[0][2] - near, ends[1][2] - near, &shares[0], &shares[1]))
        return false;
    if (hatch_view_ends(view) &&
        !hatch_range_keep(view->far - ends[0][2], view->far - ends[1][2], &shares[0], &shares[1]))
        return false;
    hatch_vec_copy(ends[0], from);
    hatch_vec_sub(ends[1], ends[0], along);
    if (shares[0] > 0)
        hatch_vec_add_scaled(from, shares[0], along, ends[0]);
    if (shares[1] < 1)
        hatch_vec_add_scaled(from, shares[1], along, ends[1]);
    return true;
}

/* Narrows begin .. end, along a segment in the picture, to the picture and to where the pen draws. Returns false if
 * nothing remains.
 *   wanted_px  widths at the ends of the segment */
static bool cut_picture(const struct work *w, const struct hatch_sight_line *line, const double wanted_px[2],
                        double *begin, double *end)
{
    const double sizes[2] = {w->occluders->width_px, w->occluders->height_px};
    for (int k = 0; k < 2; k++)
        if (!hatch_range_keep(line->at[0][k], line->at[1][k], begin, end) ||
            !hatch_range_keep(sizes[k] - line->at[0][k], sizes[k] - line->at[1][k], begin, end))
            return false;
    return !w->curves->widths_px ||
           hatch_range_keep(w->pen->drawn(w->pen, wanted_px[0]), w->pen->drawn(w->pen, wanted_px[1]), begin, end);
}

/* Moves the ends of a line to positions along it. */
static void shorten(struct hatch_sight_line *line, double begin, double end)
{
    const struct hatch_sight_line whole = *line;
    const double shares[2] = {begin, end};
    for (int i = 0; i < 2; i++) {
        if (i == 0 ? !(begin > 0) : !(end < 1))
            continue;
        for (int k = 0; k < 2; k++)
            line->at[i][k] = whole.at[0][k] + shares[i] * (whole.at[1][k] - whole.at[0][k]);
        line->limit[i] = whole.limit[0] + shares[i] * (whole.limit[1] - whole.limit[0]);
    }
}

/* Adds slack to the limits of a line, which are the nearness of its ends so far. The line is a part of a segment.
 *   ends    of the segment, projected
 *   slacks  at these ends; linear between them in space
 *   shares  of the line's ends, 0 .. 1 along the segment in the picture */
static void give_slack(const struct hatch_occluders *occluders, double ends[2][3], const double slacks[2],
                       const double shares[2], struct hatch_sight_line *line)
{
    bool orthographic = occluders->view.orthographic;
    for (int i = 0; i < 2; i++) {
        double depth = orthographic ? -line->limit[i] : 1 / line->limit[i];
        double near = shares[i] * (orthographic ? 1 : ends[0][2]),
               far = (1 - shares[i]) * (orthographic ? 1 : ends[1][2]);
        double slack = fmax(slacks[0] + near / (near + far) * (slacks[1] - slacks[0]), 0);
        line->limit[i] = hatch_occluders_nearness(occluders, depth - slack - ROUNDING * (1 + fabs(depth)));
    }
}

/* Adds the pieces of a curve's segment from a point to the next one. Where its end is cut off, the begin of the next
 * segment is, too. */
static enum hatch_status add_segment(struct work *w, const struct hatch_vector_curve *curve, uint32_t point,
                                     struct hatch_err *err)
{
    const struct hatch_vector_curves *curves = w->curves;
    const struct hatch_occluders *occluders = w->occluders;
    double ends[2][3], shares[2], wanted_px[2], slacks[2] = {0, 0}, begin = 0, end = 1;
    const bool unseen = curves->slack && curves->slack[point] < 0;
    struct hatch_sight_line line = {.reach_px = curve->reach_px};
    for (uint32_t i = 0; i < 2; i++) {
        hatch_occluders_project(occluders, &curves->points[3 * (size_t)(point + i)], ends[i]);
        line.faces[i] = curves->faces ? curves->faces[point + i] : HATCH_NONE;
    }
    if (!cut_depth(occluders, ends, shares)) {
        hatch_vector_runs_skip(&w->runs);
        return HATCH_OK;
    }
    for (uint32_t i = 0; i < 2; i++) {
        double size = occluders->view.orthographic ? 1 : ends[i][2];
        for (int k = 0; k < 2; k++)
            line.at[i][k] = ends[i][k] / size;
        line.limit[i] = hatch_occluders_nearness(occluders, ends[i][2]);
        if (curves->slack)
            slacks[i] = (1 - shares[i]) * (double)curves->slack[point] + shares[i] * (double)curves->slack[point + 1];
        if (curves->widths_px)
            wanted_px[i] =
                (1 - shares[i]) * (double)curves->widths_px[point] + shares[i] * (double)curves->widths_px[point + 1];
    }
    bool drawn = cut_picture(w, &line, wanted_px, &begin, &end);
    if (shares[0] > 0 || !drawn || begin > 0)
        hatch_vector_runs_skip(&w->runs);
    if (drawn) {
        shorten(&line, begin, end);
        give_slack(occluders, ends, slacks, (const double[]){begin, end}, &line);
        HATCH_TRY(add_line(w, &line, unseen, curves->blank && curves->blank[point], err));
    }
    return HATCH_OK;
}

static enum hatch_status see_curve(struct work *w, const struct hatch_vector_curve *curve,
                                   const struct hatch_vector_care *care, struct hatch_vector_builder *visible,
                                   struct hatch_vector_builder *hidden, struct hatch_err *err)
{
    const struct hatch_vector_path like = {.layer = curve->layer, .id = curve->id};
    struct hatch_vector_runs *runs = &w->runs;
    hatch_vector_runs_clear(runs);
    for (uint32_t i = 0; i + 1 < curve->count; i++)
        HATCH_TRY(add_segment(w, curve, curve->first + i, err));
    HATCH_TRY(hatch_vector_runs_make(runs, err));
    hatch_vector_runs_fill(runs, care->gap_px);
    hatch_vector_runs_drop(runs, care->speck_px, curve->closed);
    HATCH_TRY(hatch_vector_runs_deliver(runs, &like, curve->closed, true, visible, err));
    return hidden->paths.arena ? hatch_vector_runs_deliver(runs, &like, curve->closed, false, hidden, err) : HATCH_OK;
}

enum hatch_status hatch_vector_see(const struct hatch_occluders *occluders, const struct hatch_vector_curves *curves,
                                   const struct hatch_vector_pen *pen, const struct hatch_vector_care *care,
                                   struct hatch_arena *arena, struct hatch_arena *scratch,
                                   struct hatch_vector_paths *visible, struct hatch_vector_paths *hidden,
                                   struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_vector_builder seen = hatch_vector_builder_of(arena), unseen = hatch_vector_builder_of(NULL);
    struct work work = {.occluders = occluders, .curves = curves, .pen = pen, .hidden = hidden != NULL};
    work.runs = hatch_vector_runs_of(scratch);
    if (hidden)
        unseen = hatch_vector_builder_of(arena);
    enum hatch_status status = hatch_sight_make(occluders, scratch, &work.sight, err);
    for (uint32_t i = 0; i < curves->count && status == HATCH_OK; i++)
        status = see_curve(&work, &curves->curves[i], care, &seen, &unseen, err);
    hatch_arena_rewind(scratch, mark);
    if (status != HATCH_OK)
        return status;
    *visible = hatch_vector_built(&seen);
    if (hidden)
        *hidden = hatch_vector_built(&unseen);
    return HATCH_OK;
}
