#include "line/surface/surface.h"

#include "math/vector.h"

/* Computes the mesh of a deformed surface at the pose, in the unit scene: POSITION, and NORMAL where it counts. */
static enum hatch_status deform(struct hatch_unit_scene *scene, const struct hatch_line_surface *surface,
                                struct hatch_arena *arena, struct hatch_mesh *posed, struct hatch_err *err)
{
    const struct hatch_line_body *body = surface->body;
    const size_t count = 3 * (size_t)body->mesh.vertex_count;
    double *positions;
    float *normals = NULL;
    *posed = body->mesh;
    posed->attribute_count = 1;
    HATCH_TRY(HATCH_ALLOC(arena, &positions, count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &posed->attributes[0].data, count, err));
    if (body->choice.normals_authored && hatch_mesh_find(&body->mesh, "NORMAL", 3))
        HATCH_TRY(hatch_mesh_add(arena, posed, "NORMAL", 3, &normals, err));
    hatch_pose_mesh(&scene->pose, surface->item->node, &body->mesh, positions, normals);
    for (size_t i = 0; i < count; i += 3) {
        double at[3];
        hatch_bounds_to_unit(&scene->bounds, positions + i, at);
        hatch_vec_round(at, posed->attributes[0].data + i);
    }
    return HATCH_OK;
}

/* Finds the lines of a deformed surface at the pose. */
static enum hatch_status find_lines(struct hatch_unit_scene *scene, const struct hatch_line_surface *surface,
                                    struct hatch_arena *arena, struct hatch_arena *scratch,
                                    struct hatch_line_mesh *lines, struct hatch_err *err)
{
    static const double zero[3] = {0, 0, 0};
    const struct hatch_line_body *body = surface->body;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_mesh posed;
    enum hatch_status status = deform(scene, surface, scratch, &posed, err);
    if (status == HATCH_OK)
        status = hatch_line_mesh_make(&posed, body->edges, zero, &body->choice, arena, scratch, lines, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}

enum hatch_status hatch_line_surface_pose(struct hatch_unit_scene *scene, const struct hatch_line_surface *surface,
                                          struct hatch_arena *arena, struct hatch_arena *scratch,
                                          struct hatch_line_shape *shape, struct hatch_err *err)
{
    const struct hatch_item *item = surface->item;
    struct hatch_line_shape made = {
        .lines = &surface->body->lines, .mirrored = item->mirrored, .double_sided = surface->body->double_sided};
    if (item->deformed) {
        struct hatch_line_mesh *lines;
        HATCH_TRY(HATCH_ALLOC(arena, &lines, 1, err));
        HATCH_TRY(find_lines(scene, surface, arena, scratch, lines, err));
        made.lines = lines;
    }
    made.positions = made.lines->mesh.attributes[0].data;
    for (int i = 0; i < 16; i++)
        made.to_unit[i] = (double)item->to_unit[i];
    *shape = made;
    return HATCH_OK;
}
