#include "line/lines.h"

#include <math.h>
#include <string.h>

#include "math/vector.h"

#define GAP_PX 4.0   /* shorter hidden gaps are closed: they arise where a surface just touches the line */
#define SPECK_PX 6.0 /* isolated visible parts are hidden if they are shorter than this plus twice the line width */

/* About this much is cut off a visible part where it meets a hidden one: the visibility test looks up to 1.25 pixels
 * around a sample, so lines show slightly too far. */
#define TRIM_PX 1.0

#define CLOSED_PX 17.0 /* gaps and folds that are closed are shorter than this (smooth.c), with what is cut off */

/* The strips of a surface's features, or those of its silhouettes. */
struct hatch_line_part {
    struct hatch_line_strips strips;
    const struct hatch_item *item; /* that places the surface */
    struct hatch_line_part *next;
};

enum hatch_status hatch_lines_make(struct hatch_unit_scene *scene, const struct hatch_line_style *style,
                                   struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_lines *lines,
                                   struct hatch_err *err)
{
    struct hatch_lines made = {.style = *style, .scene = scene, .scratch = scratch};
    const struct hatch_line_choice choice = {.kinds = style->kinds, .crease_rad = style->crease_rad};
    if (style->kinds)
        HATCH_TRY(hatch_line_surfaces_make(scene, &choice, arena, scratch, &made.surfaces, &made.surface_count, err));
    *lines = made;
    return HATCH_OK;
}

static double speck_px(const struct hatch_line_style *style)
{
    return SPECK_PX + 2 * style->width_px;
}

uint32_t hatch_lines_reach_px(const struct hatch_line_style *style)
{
    double reach_px = 0.5 * style->width_px + speck_px(style) + CLOSED_PX;
    return (uint32_t)ceil(fmax(HATCH_LINES_REACH_PX, reach_px));
}

/* State of tracing a frame. */
struct tracing {
    const struct hatch_lines *lines;
    struct hatch_line_eye eye;
    const struct hatch_tile *tile;
    struct hatch_arena *arena;
    struct hatch_line_frame frame;
};

static enum hatch_status add_trace(struct tracing *tracing, const struct hatch_item *item,
                                   const struct hatch_line_trace *trace, const struct hatch_line_chains *chains,
                                   struct hatch_err *err)
{
    const struct hatch_line_style *style = &tracing->lines->style;
    const struct hatch_line_picture picture = {tracing->eye.view, tracing->tile,
                                               hatch_line_brush_is_used(&style->brush) ? hatch_lines_reach_px(style)
                                                                                       : style->width_px + 2};
    struct hatch_line_part *part;
    HATCH_TRY(HATCH_ALLOC(tracing->arena, &part, 1, err));
    HATCH_TRY(hatch_line_strips_make(trace, chains, &picture, tracing->arena, &part->strips, err));
    part->item = item;
    part->next = tracing->frame.parts;
    tracing->frame.parts = part;
    tracing->frame.sample_count += part->strips.piece_count;
    return HATCH_OK;
}

/* Traces the lines of a surface: its features, then its silhouettes.
 *   curves  room for 2
 *   count   out: number of curves */
static enum hatch_status trace_surface(const struct hatch_lines *lines, const struct hatch_line_surface *surface,
                                       const struct hatch_line_eye *eye, struct hatch_arena *arena,
                                       struct hatch_line_curves *curves, uint32_t *count, struct hatch_err *err)
{
    struct hatch_line_shape shape;
    *count = 0;
    HATCH_TRY(hatch_line_surface_pose(lines->scene, surface, arena, lines->scratch, &shape, err));
    if (shape.lines->feature_count) {
        struct hatch_line_curves *features = &curves[(*count)++];
        *features = (struct hatch_line_curves){.chains = shape.lines->chains, .deformed = surface->item->deformed};
        HATCH_TRY(hatch_line_trace_features(&shape, eye, arena, &features->trace, err));
    }
    if (!(lines->style.kinds & HATCH_LINES_SILHOUETTES))
        return HATCH_OK;
    struct hatch_line_curves *outlines = &curves[(*count)++];
    *outlines = (struct hatch_line_curves){.silhouettes = true, .deformed = surface->item->deformed};
    HATCH_TRY(hatch_line_trace_silhouettes(&shape, eye, arena, lines->scratch, &outlines->trace, err));
    const struct hatch_line_trace *trace = &outlines->trace;
    const struct hatch_line_graph graph = {trace->node_count, trace->segment_count, trace->nodes, trace->ends};
    HATCH_TRY(hatch_line_chains_make(&graph, arena, lines->scratch, &outlines->chains, err));
    return hatch_line_refine(eye, &outlines->trace, &outlines->chains, arena, err);
}

/* Returns the view, and the size of a pixel of a picture. */
static struct hatch_line_eye eye_of(const struct hatch_view *view, double height_px)
{
    return (struct hatch_line_eye){view, 0.5 * height_px / view->half_height};
}

enum hatch_status hatch_lines_pose(const struct hatch_lines *lines, const struct hatch_view *view, double height_px,
                                   struct hatch_arena *arena, struct hatch_line_curves **curves, uint32_t *count,
                                   struct hatch_err *err)
{
    const struct hatch_line_eye eye = eye_of(view, height_px);
    HATCH_TRY(HATCH_ALLOC(arena, curves, 2 * (size_t)lines->surface_count, err));
    *count = 0;
    for (uint32_t i = 0; i < lines->surface_count; i++) {
        uint32_t more;
        HATCH_TRY(trace_surface(lines, &lines->surfaces[i], &eye, arena, *curves + *count, &more, err));
        *count += more;
    }
    return HATCH_OK;
}

enum hatch_status hatch_lines_trace(const struct hatch_lines *lines, const struct hatch_view *view,
                                    const struct hatch_tile *tile, struct hatch_arena *arena,
                                    struct hatch_line_frame *frame, struct hatch_err *err)
{
    struct tracing tracing = {.lines = lines, .eye = eye_of(view, tile->full_height), .tile = tile, .arena = arena};
    struct hatch_line_curves curves[2];
    size_t at = 0;
    for (uint32_t i = 0; i < lines->surface_count; i++) {
        uint32_t count;
        HATCH_TRY(trace_surface(lines, &lines->surfaces[i], &tracing.eye, arena, curves, &count, err));
        for (uint32_t k = 0; k < count; k++)
            HATCH_TRY(add_trace(&tracing, lines->surfaces[i].item, &curves[k].trace, &curves[k].chains, err));
    }
    HATCH_TRY(HATCH_ALLOC(arena, &tracing.frame.samples, tracing.frame.sample_count, err));
    for (const struct hatch_line_part *part = tracing.frame.parts; part; part = part->next) {
        memcpy(tracing.frame.samples + at, part->strips.samples,
               part->strips.piece_count * sizeof *part->strips.samples);
        at += part->strips.piece_count;
    }
    *frame = tracing.frame;
    return HATCH_OK;
}

enum hatch_status hatch_lines_join(const struct hatch_lines *lines, const struct hatch_line_frame *frame,
                                   const uint8_t *seen, struct hatch_arena *arena, struct hatch_line_segment **segments,
                                   size_t *count, struct hatch_err *err)
{
    const struct hatch_line_brush *brush = &lines->style.brush;
    size_t at = 0;
    uint8_t *visible;
    HATCH_TRY(HATCH_ALLOC(arena, &visible, frame->sample_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, segments, frame->sample_count, err));
    *count = 0;
    for (const struct hatch_line_part *part = frame->parts; part; part = part->next) {
        hatch_line_strips_smooth(&part->strips, GAP_PX, speck_px(&lines->style), TRIM_PX, seen + at, visible + at);
        HATCH_TRY(hatch_line_strips_drop_doubles(&part->strips, visible + at, arena, err));
        struct hatch_line_touch *touches = NULL;
        if (hatch_line_brush_is_used(brush))
            HATCH_TRY(hatch_line_brush_touch(brush, part->item,
                                             hatch_vec_length(lines->scene->meshes[part->item->mesh].half),
                                             &part->strips, visible + at, seen + at, arena, &touches, err));
        *count += hatch_line_strips_visible(&part->strips, visible + at, seen + at, touches, *segments + *count);
        at += part->strips.piece_count;
    }
    return HATCH_OK;
}
