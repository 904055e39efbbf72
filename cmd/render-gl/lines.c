#include "render-gl/lines.h"

#include "render-gl/lines_trace.h"

#define GAP_PX 4.0    /* hidden for shorter than this: a surface that grazes the line */
#define CRUMB_PX 6.0  /* visible for shorter than this, and alone: dirt */
#define TRIM_PX 1.0   /* visible because the test looks around itself */

/* Skins pose a mesh from where it lies in the file, other nodes from around its middle. */
static struct line_mesh *mesh_of(const struct lines *lines, const struct gpu_item *item)
{
    return &lines->meshes[2 * (size_t)item->mesh + (item->posed ? 1 : 0)];
}

enum hatch_status lines_make(struct gpu_scene *scene, const struct line_style *style,
                             const struct shader_source *shaders, uint64_t max_memory,
                             struct hatch_arena *arena, struct hatch_arena *scratch,
                             struct lines *lines, struct hatch_err *err)
{
    static const double zero[3] = {0, 0, 0};
    struct lines made = {.style = *style, .scene = scene, .scratch = scratch};
    made.meshes = HATCH_NEW(arena, struct line_mesh, 2 * (size_t)scene->scene->mesh_count, err);
    if (!made.meshes)
        return HATCH_LIMIT;
    for (uint32_t i = 0; i < scene->item_count && style->kinds; i++) {
        const struct gpu_item *item = &scene->items[i];
        struct line_mesh *mesh = mesh_of(&made, item);
        if (mesh->mesh.face_count)
            continue;
        const double *origin = item->posed ? zero : scene->meshes[item->mesh].origin;
        HATCH_TRY(line_mesh_make(&scene->scene->meshes[item->mesh].mesh, origin, style->kinds,
                                 style->crease_rad, arena, scratch, mesh, err));
    }
    HATCH_TRY(line_gl_make(shaders, &made.gl, err));
    hatch_arena_init(&made.frame, max_memory);
    *lines = made;
    return HATCH_OK;
}

/* The item's mesh where it stands: skinned ones are posed anew, others keep their vertices. */
static enum hatch_status place(struct lines *lines, const struct gpu_item *item,
                               struct line_shape *shape, struct hatch_err *err)
{
    const struct line_mesh *mesh = mesh_of(lines, item);
    const struct bounds *bounds = &lines->scene->bounds;
    *shape = (struct line_shape){.lines = mesh,
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
    pose_mesh(&lines->scene->pose, item->node, &mesh->mesh, positions, normals);
    for (size_t i = 0; i < count; i++)
        moved[i] = (float)((positions[i] - bounds->center[i % 3]) / bounds->radius);
    shape->positions = moved;
    shape->normals = normals;
    return HATCH_OK;
}

/* Cuts, tests and strokes the lines of one trace. */
static enum hatch_status draw_trace(struct lines *lines, const struct line_trace *trace,
                                    const struct line_chains *chains, const struct view *view,
                                    const struct tile *tile, const struct target *target,
                                    struct hatch_err *err)
{
    struct line_strips strips;
    double width_px = lines->style.width_px;
    HATCH_TRY(line_strips_make(trace, chains, view, tile, width_px + 2, &lines->frame, &strips, err));
    if (!strips.piece_count)
        return HATCH_OK;
    uint8_t *visible =
        HATCH_NEW(&lines->frame, uint8_t, (size_t)strips.piece_count + LINE_BATCH, err);
    float *segments =
        visible ? HATCH_NEW(&lines->frame, float, 4 * (size_t)strips.piece_count, err) : NULL;
    if (!segments)
        return HATCH_LIMIT;
    line_gl_test(&lines->gl, target, strips.samples, strips.piece_count, visible);
    line_strips_smooth(&strips, GAP_PX, CRUMB_PX + 2 * width_px, TRIM_PX, visible);
    uint32_t count = line_strips_visible(&strips, visible, segments);
    line_gl_stroke(&lines->gl, segments, count, width_px);
    return HATCH_OK;
}

static enum hatch_status draw_item(struct lines *lines, const struct gpu_item *item,
                                   const struct view *view, const struct tile *tile,
                                   const struct target *target, struct hatch_err *err)
{
    const struct line_eye eye = {view, 0.5 * tile->full_height / view->half_height};
    struct line_shape shape;
    struct line_trace trace;
    HATCH_TRY(place(lines, item, &shape, err));
    if (shape.lines->feature_count) {
        HATCH_TRY(line_trace_features(&shape, &eye, &lines->frame, &trace, err));
        HATCH_TRY(draw_trace(lines, &trace, &shape.lines->chains, view, tile, target, err));
    }
    if (!(lines->style.kinds & LINES_SILHOUETTES))
        return HATCH_OK;
    HATCH_TRY(line_trace_silhouettes(&shape, &eye, &lines->frame, lines->scratch, &trace, err));
    struct line_chains chains;
    const struct line_graph graph = {trace.node_count, trace.segment_count, trace.nodes, trace.ends};
    HATCH_TRY(line_chains_make(&graph, &lines->frame, lines->scratch, &chains, err));
    return draw_trace(lines, &trace, &chains, view, tile, target, err);
}

enum hatch_status lines_draw(struct lines *lines, const struct view *view, const struct tile *tile,
                             const struct target *target, struct hatch_err *err)
{
    HATCH_TRY(line_gl_begin(&lines->gl, target, err));
    enum hatch_status status = HATCH_OK;
    for (uint32_t i = 0; i < lines->scene->item_count && status == HATCH_OK; i++) {
        struct hatch_arena_mark mark = hatch_arena_mark(&lines->frame);
        const struct gpu_item *item = &lines->scene->items[i];
        if (mesh_of(lines, item)->mesh.face_count)
            status = draw_item(lines, item, view, tile, target, err);
        hatch_arena_rewind(&lines->frame, mark);
    }
    line_gl_end(&lines->gl, target, lines->style.color);
    return status;
}

void lines_free(struct lines *lines)
{
    line_gl_free(&lines->gl);
    hatch_arena_free(&lines->frame);
    *lines = (struct lines){.scene = NULL};
}
