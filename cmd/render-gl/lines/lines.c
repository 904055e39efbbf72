#include "render-gl/lines/lines.h"

#include <string.h>

#include "line/trace.h"

#define GAP_PX 4.0   /* hidden for shorter than this: a surface that grazes the line */
#define CRUMB_PX 6.0 /* visible for shorter than this, and alone: dirt */
#define TRIM_PX 1.0  /* visible because the test looks around itself */

/* Skins pose a mesh from where it lies in the file, other nodes from around its middle. */
static struct hatch_line_mesh *mesh_of(const struct lines *lines, const struct gpu_item *item)
{
    return &lines->meshes[2 * (size_t)item->mesh + (item->posed ? 1 : 0)];
}

enum hatch_status lines_make(struct gpu_scene *scene, const struct line_style *style,
                             const struct shader_source *shaders, uint64_t max_memory, struct hatch_arena *arena,
                             struct hatch_arena *scratch, struct lines *lines, struct hatch_err *err)
{
    static const double zero[3] = {0, 0, 0};
    struct lines made = {.style = *style, .scene = scene, .scratch = scratch};
    made.meshes = HATCH_NEW(arena, struct hatch_line_mesh, 2 * (size_t)scene->scene->mesh_count, err);
    if (!made.meshes)
        return HATCH_LIMIT;
    for (uint32_t i = 0; i < scene->item_count && style->kinds; i++) {
        const struct gpu_item *item = &scene->items[i];
        struct hatch_line_mesh *mesh = mesh_of(&made, item);
        if (mesh->mesh.face_count)
            continue;
        const double *origin = item->posed ? zero : scene->meshes[item->mesh].origin;
        const struct hatch_scene_mesh *from = &scene->scene->meshes[item->mesh];
        const struct hatch_line_choice choice = {style->kinds, style->crease_rad, from->had_normals};
        HATCH_TRY(hatch_line_mesh_make(scene->meshes[item->mesh].surface, origin, &choice, arena, scratch, mesh, err));
    }
    HATCH_TRY(line_gl_make(shaders, style->haloes, &made.gl, err));
    hatch_arena_init(&made.frame, max_memory);
    *lines = made;
    return HATCH_OK;
}

/* The item's mesh where it stands: skinned ones are posed anew, others keep their vertices. */
static enum hatch_status place(struct lines *lines, const struct gpu_item *item, struct hatch_line_shape *shape,
                               struct hatch_err *err)
{
    const struct hatch_line_mesh *mesh = mesh_of(lines, item);
    const struct hatch_bounds *bounds = &lines->scene->bounds;
    *shape = (struct hatch_line_shape){.lines = mesh,
                                       .positions = mesh->mesh.attributes[0].data,
                                       .normals = hatch_mesh_find(&mesh->mesh, "NORMAL", 3),
                                       .mirrored = item->mirrored,
                                       .double_sided = item->double_sided};
    for (int i = 0; i < 16; i++)
        shape->to_unit[i] = (double)item->to_unit[i];
    if (!item->posed)
        return HATCH_OK;
    size_t count = 3 * (size_t)mesh->mesh.vertex_count;
    double *positions = HATCH_NEW(&lines->frame, double, count, err);
    float *moved = positions ? HATCH_NEW(&lines->frame, float, count, err) : NULL;
    float *normals = moved ? HATCH_NEW(&lines->frame, float, count, err) : NULL;
    if (!normals)
        return HATCH_LIMIT;
    hatch_pose_mesh(&lines->scene->pose, item->node, &mesh->mesh, positions, normals);
    for (size_t i = 0; i < count; i++)
        moved[i] = (float)((positions[i] - bounds->center[i % 3]) / bounds->radius);
    shape->positions = moved;
    shape->normals = normals;
    return HATCH_OK;
}

/* A frame's strips, all of which are tested together: the GPU has to be waited for only once. */
struct part {
    struct hatch_line_strips strips;
    struct part *next;
};

struct frame_lines {
    struct lines *lines;
    const struct hatch_view *view;
    const struct hatch_tile *tile;
    struct part *parts;
    size_t piece_count;
};

static enum hatch_status add_trace(struct frame_lines *frame, const struct hatch_line_trace *trace,
                                   const struct hatch_line_chains *chains, struct hatch_err *err)
{
    struct lines *lines = frame->lines;
    struct part *part = HATCH_NEW(&lines->frame, struct part, 1, err);
    if (!part)
        return HATCH_LIMIT;
    HATCH_TRY(hatch_line_strips_make(trace, chains, frame->view, frame->tile, lines->style.width_px + 2, &lines->frame,
                                     &part->strips, err));
    part->next = frame->parts;
    frame->parts = part;
    frame->piece_count += part->strips.piece_count;
    return HATCH_OK;
}

static enum hatch_status add_item(struct frame_lines *frame, const struct gpu_item *item, struct hatch_err *err)
{
    struct lines *lines = frame->lines;
    const struct hatch_line_eye eye = {frame->view, 0.5 * frame->tile->full_height / frame->view->half_height};
    struct hatch_line_shape shape;
    struct hatch_line_trace trace;
    HATCH_TRY(place(lines, item, &shape, err));
    if (shape.lines->feature_count) {
        HATCH_TRY(hatch_line_trace_features(&shape, &eye, &lines->frame, &trace, err));
        HATCH_TRY(add_trace(frame, &trace, &shape.lines->chains, err));
    }
    if (!(lines->style.kinds & HATCH_LINES_SILHOUETTES))
        return HATCH_OK;
    HATCH_TRY(hatch_line_trace_silhouettes(&shape, &eye, &lines->frame, lines->scratch, &trace, err));
    struct hatch_line_chains chains;
    const struct hatch_line_graph graph = {trace.node_count, trace.segment_count, trace.nodes, trace.ends};
    HATCH_TRY(hatch_line_chains_make(&graph, &lines->frame, lines->scratch, &chains, err));
    HATCH_TRY(hatch_line_refine(&trace, &chains, &lines->frame, err));
    return add_trace(frame, &trace, &chains, err);
}

static enum hatch_status stroke(const struct frame_lines *frame, const struct target *target, struct hatch_err *err)
{
    struct lines *lines = frame->lines;
    double width_px = lines->style.width_px;
    size_t count = frame->piece_count, at = 0, segment_count = 0;
    struct hatch_line_sample *samples = HATCH_NEW(&lines->frame, struct hatch_line_sample, count, err);
    uint8_t *seen = samples ? HATCH_NEW(&lines->frame, uint8_t, count + LINE_BATCH, err) : NULL;
    uint8_t *visible = seen ? HATCH_NEW(&lines->frame, uint8_t, count, err) : NULL;
    struct hatch_line_segment *segments =
        visible ? HATCH_NEW(&lines->frame, struct hatch_line_segment, count, err) : NULL;
    if (!segments)
        return HATCH_LIMIT;
    for (const struct part *part = frame->parts; part; part = part->next) {
        memcpy(samples + at, part->strips.samples, part->strips.piece_count * sizeof *samples);
        at += part->strips.piece_count;
    }
    line_gl_test(&lines->gl, target, samples, count, seen);
    at = 0;
    for (const struct part *part = frame->parts; part; part = part->next) {
        hatch_line_strips_smooth(&part->strips, GAP_PX, CRUMB_PX + 2 * width_px, TRIM_PX, seen + at, visible + at);
        segment_count += hatch_line_strips_visible(&part->strips, visible + at, seen + at, segments + segment_count);
        at += part->strips.piece_count;
    }
    line_gl_stroke(&lines->gl, segments, segment_count, width_px);
    return HATCH_OK;
}

static enum hatch_status draw(struct frame_lines *frame, const struct target *target, struct hatch_err *err)
{
    struct lines *lines = frame->lines;
    for (uint32_t i = 0; i < lines->scene->item_count; i++) {
        const struct gpu_item *item = &lines->scene->items[i];
        /* Holes of a texture cut the surface's shape out of a larger face, whose edges nobody sees. */
        bool cut_out = item->base_texture && item->alpha_cutoff > 0;
        if (mesh_of(lines, item)->mesh.face_count && !cut_out)
            HATCH_TRY(add_item(frame, item, err));
    }
    if (!frame->piece_count)
        return HATCH_OK;
    HATCH_TRY(line_gl_begin(&lines->gl, target, err));
    HATCH_TRY(stroke(frame, target, err));
    line_gl_end(&lines->gl, target, lines->style.color);
    return HATCH_OK;
}

enum hatch_status lines_draw(struct lines *lines, const struct hatch_view *view, const struct hatch_tile *tile,
                             const struct target *target, struct hatch_err *err)
{
    struct frame_lines frame = {.lines = lines, .view = view, .tile = tile};
    struct hatch_arena_mark mark = hatch_arena_mark(&lines->frame);
    enum hatch_status status = draw(&frame, target, err);
    hatch_arena_rewind(&lines->frame, mark);
    return status;
}

void lines_free(struct lines *lines)
{
    line_gl_free(&lines->gl);
    hatch_arena_free(&lines->frame);
    *lines = (struct lines){.scene = NULL};
}
