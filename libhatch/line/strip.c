#include "line/strip.h"

#include "math/range.h"
#include "math/vector.h"

#define PIECE_PX 1.5      /* largest length of a piece */
#define STEP_PX 4.0       /* least step in depth across a silhouette, in pixels at its distance */
#define DOT_PX 0.1        /* chains that reach less far are left out; beside others, nobody misses them */
#define DEPTH_LEAST 1e-30 /* of what lies behind a silhouette: over that of the far plane */
#define ERROR_MAX_PX 0.5  /* lines are drawn only where the error of float positions is at most this */

/* A segment after projection and clipping. */
struct cut {
    double at[2][2];     /* both ends, in pixels from the tile's lower left corner */
    double limit[2];     /* at both ends, as in struct hatch_line_sample */
    double behind[2];    /* the same */
    double depth[2];     /* the same */
    double place[2][3];  /* in the unit scene */
    double pixel[2];     /* size of a pixel */
    double count;        /* number of pieces, inside and outside the tile */
    double first, after; /* pieces to keep: first .. after - 1 */
    bool begins, ends;   /* whether these contain the start, the end of the segment */
};

/* State of a pass over chains. The first pass has no arrays and only counts their entries. */
struct walk {
    const struct hatch_line_trace *trace;
    const struct hatch_view *view;
    const struct hatch_tile *tile;
    double margin_px;
    struct hatch_line_strips strips;
    struct hatch_line_strip strip; /* the current strip */
    bool open;                     /* there is a current strip */
};

/* Returns the value in the depth buffer at a distance along the view axis. */
static double buffer_depth(const struct hatch_view *view, double depth)
{
    if (view->orthographic)
        return (view->far - depth) / (view->far - view->near);
    double shift = hatch_view_depth_shift(view);
    return (1 + shift) * view->near / fmax(depth, view->near) - shift;
}

static void project(const struct hatch_view *view, const struct hatch_tile *tile, const double point[3], double depth,
                    double out[2])
{
    double from[3], distance = view->orthographic ? 1.0 : depth;
    hatch_vec_sub(point, view->eye, from);
    double y = hatch_vec_dot(from, view->up) / (distance * view->half_height);
    double x = hatch_vec_dot(from, view->right) / (distance * view->half_height * view->aspect);
    out[0] = 0.5 * (1 + x) * tile->full_width - tile->x;
    out[1] = 0.5 * (1 + y) * tile->full_height - tile->y;
}

/* Clips a segment at the near and far planes, and where the error of float positions is too large. Returns false if
 * nothing remains.
 *   whole  out: whether its start, its end is not clipped */
static bool clip_depth(const struct hatch_view *view, const struct hatch_tile *tile, double points[2][3],
                       double depth[2], bool whole[2])
{
    double begin = 0, end = 1, a[3], along[3];
    double least = hatch_view_float_error(view, tile) / ERROR_MAX_PX;
    if (view->orthographic) /* the error is the same everywhere */
        least = least > 1 ? INFINITY : view->near;
    double nearest = fmax(view->near, least);
    hatch_range_keep(depth[0] - nearest, depth[1] - nearest, &begin, &end);
    if (hatch_view_ends(view))
        hatch_range_keep(view->far - depth[0], view->far - depth[1], &begin, &end);
    whole[0] = begin <= 0;
    whole[1] = end >= 1;
    if (!(begin < end))
        return false;
    hatch_vec_copy(points[0], a);
    hatch_vec_sub(points[1], a, along);
    double from = depth[0], change = depth[1] - depth[0];
    const double shares[2] = {begin, end};
    for (int i = 0; i < 2; i++)
        if (!whole[i]) {
            hatch_vec_add_scaled(a, shares[i], along, points[i]);
            depth[i] = from + shares[i] * change;
        }
    return true;
}

/* Projects a segment and clips it to the tile. Returns false when nothing remains. */
static bool cut_segment(const struct walk *w, double points[2][3], double slack_px, struct cut *cut)
{
    const struct hatch_view *view = w->view;
    const struct hatch_tile *tile = w->tile;
    double depth[2] = {hatch_line_depth(view, points[0]), hatch_line_depth(view, points[1])};
    double begin = 0, end = 1;
    bool whole[2];
    if (!(slack_px >= 0) || !clip_depth(view, tile, points, depth, whole))
        return false;
    for (int i = 0; i < 2; i++) {
        project(view, tile, points[i], depth[i], cut->at[i]);
        double pixel = 2 * view->half_height * (view->orthographic ? 1 : depth[i]) / tile->full_height;
        cut->limit[i] = buffer_depth(view, depth[i] - slack_px * pixel);
        cut->depth[i] = buffer_depth(view, depth[i]);
        cut->behind[i] = fmax(buffer_depth(view, depth[i] + STEP_PX * pixel), DEPTH_LEAST);
        hatch_vec_copy(points[i], cut->place[i]);
        cut->pixel[i] = pixel;
    }
    const double sizes[2] = {tile->width, tile->height};
    for (int k = 0; k < 2; k++) {
        double a = cut->at[0][k] + w->margin_px, b = cut->at[1][k] + w->margin_px;
        double most = sizes[k] + 2 * w->margin_px;
        hatch_range_keep(a, b, &begin, &end);
        hatch_range_keep(most - a, most - b, &begin, &end);
    }
    double x = cut->at[1][0] - cut->at[0][0], y = cut->at[1][1] - cut->at[0][1];
    double length = sqrt(x * x + y * y);
    if (!(begin <= end) || !isfinite(length))
        return false;
    cut->count = fmax(ceil(length / PIECE_PX), 1);
    cut->first = fmin(floor(begin * cut->count), cut->count - 1);
    cut->after = fmax(ceil(end * cut->count), cut->first + 1);
    cut->begins = whole[0] && cut->first <= 0;
    cut->ends = whole[1] && cut->after >= cut->count;
    return true;
}

static void mix(const double a[2], const double b[2], double t, float out[2])
{
    for (int k = 0; k < 2; k++)
        out[k] = (float)(a[k] + t * (b[k] - a[k]));
}

static float between(const double ends[2], double share)
{
    return (float)(ends[0] + share * (ends[1] - ends[0]));
}

static void begin_strip(struct walk *w, bool joined)
{
    if (!w->open)
        w->strip = (struct hatch_line_strip){.first = w->strips.piece_count, .joined = {joined, false}};
    w->open = true;
}

static void end_strip(struct walk *w, bool joined)
{
    if (!w->open)
        return;
    w->open = false;
    w->strip.joined[1] = joined;
    w->strip.count = w->strips.piece_count - w->strip.first;
    if (w->strips.strips)
        w->strips.strips[w->strips.strip_count] = w->strip;
    w->strips.strip_count++;
}

/* Fills in what is tested beyond a silhouette.
 *   surface  side of its surface: 1: left, -1: right; 0: another line */
static void look_beyond(const struct cut *cut, double middle, int surface, struct hatch_line_sample *sample)
{
    double x = cut->at[1][0] - cut->at[0][0], y = cut->at[1][1] - cut->at[0][1], length = sqrt(x * x + y * y);
    if (surface == 0 || !(length > 0))
        return;
    sample->away[0] = (float)(surface * y / length);
    sample->away[1] = (float)(-surface * x / length);
    sample->behind = between(cut->behind, middle);
    sample->depth = between(cut->depth, middle);
}

static void add_pieces(struct walk *w, const struct cut *cut, uint32_t segment)
{
    struct hatch_line_strips *strips = &w->strips;
    if (!strips->pieces) {
        strips->piece_count += (uint32_t)(cut->after - cut->first);
        return;
    }
    for (double k = cut->first; k < cut->after; k++) {
        struct hatch_line_piece *piece = &strips->pieces[strips->piece_count];
        struct hatch_line_sample *sample = &strips->samples[strips->piece_count++];
        double middle = (k + 0.5) / cut->count;
        piece->segment = segment;
        mix(cut->at[0], cut->at[1], k / cut->count, piece->a);
        mix(cut->at[0], cut->at[1], (k + 1) / cut->count, piece->b);
        mix(cut->at[0], cut->at[1], middle, sample->at);
        sample->limit = between(cut->limit, middle);
        sample->turn_rad = (float)atan2(cut->at[1][1] - cut->at[0][1], cut->at[1][0] - cut->at[0][0]);
        look_beyond(cut, middle, w->trace->surface ? w->trace->surface[segment] : 0, sample);
        piece->pixel = between(cut->pixel, k / cut->count);
        for (int axis = 0; axis < 3; axis++)
            piece->place[axis] =
                (float)(cut->place[0][axis] + k / cut->count * (cut->place[1][axis] - cut->place[0][axis]));
        for (int end = 0; end < 2; end++)
            piece->depth[end] = between(cut->limit, (k + end) / cut->count);
    }
}

/* Returns whether a chain is a dot in the picture, inside or outside the tile: of an object that is scaled to nothing,
 * all chains are. */
static bool is_dot(const struct walk *w, const uint32_t *nodes, uint32_t segment_count)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (uint32_t i = 0; i <= segment_count; i++) {
        const double *point = &w->trace->nodes[3 * (size_t)nodes[i]];
        double depth = hatch_line_depth(w->view, point), at[2];
        project(w->view, w->tile, point, depth, at);
        for (int k = 0; k < 2; k++) {
            low[k] = fmin(low[k], at[k]);
            high[k] = fmax(high[k], at[k]);
        }
        if (!(depth > 0 && high[0] - low[0] < DOT_PX && high[1] - low[1] < DOT_PX))
            return false;
    }
    return true;
}

static void walk_chain(struct walk *w, const struct hatch_line_chains *chains, uint32_t number)
{
    const struct hatch_line_chain *chain = &chains->chains[number];
    const uint32_t *nodes = &chains->nodes[chain->first + number];
    if (is_dot(w, nodes, chain->segment_count))
        return;
    bool whole = true, joined = chain->closed || chain->joined[0];
    for (uint32_t i = 0; i < chain->segment_count; i++) {
        struct cut cut = {.count = 0};
        double points[2][3];
        uint32_t segment = chains->segments[chain->first + i];
        for (uint32_t k = 0; k < 2; k++)
            hatch_vec_copy(&w->trace->nodes[3 * (size_t)nodes[i + k]], points[k]);
        bool drawn = cut_segment(w, points, (double)w->trace->slack_px[segment], &cut);
        whole = whole && drawn && cut.begins && cut.ends;
        if (!drawn || !cut.begins)
            end_strip(w, w->trace->slack_px[segment] >= 0);
        if (drawn) {
            begin_strip(w, joined);
            add_pieces(w, &cut, segment);
        }
        if (drawn && !cut.ends)
            end_strip(w, true);
        joined = w->trace->slack_px[segment] >= 0;
    }
    w->strip.closed = chain->closed && whole;
    end_strip(w, chain->closed || chain->joined[1]);
}

static void walk_chains(struct walk *w, const struct hatch_line_chains *chains)
{
    w->strips.strip_count = w->strips.piece_count = 0;
    for (uint32_t i = 0; i < chains->count; i++)
        walk_chain(w, chains, i);
}

enum hatch_status hatch_line_strips_make(const struct hatch_line_trace *trace, const struct hatch_line_chains *chains,
                                         const struct hatch_line_picture *picture, struct hatch_arena *arena,
                                         struct hatch_line_strips *strips, struct hatch_err *err)
{
    struct walk walk = {.trace = trace, .view = picture->view, .tile = picture->tile, .margin_px = picture->margin_px};
    walk_chains(&walk, chains);
    struct hatch_line_strips *made = &walk.strips;
    size_t pieces = made->piece_count;
    struct hatch_line_strip *list;
    HATCH_TRY(HATCH_ALLOC(arena, &list, made->strip_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made->pieces, pieces, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made->samples, pieces, err));
    made->strips = list;
    walk_chains(&walk, chains);
    *strips = walk.strips;
    return HATCH_OK;
}
