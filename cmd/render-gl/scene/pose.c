#include "render-gl/scene/pose.h"

#include "math/vector.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/scene/normals.h"

static enum hatch_status pose_item(struct scene *scene, uint32_t index, struct hatch_arena *scratch,
                                   struct hatch_err *err)
{
    static const double zero[3] = {0, 0, 0};
    struct hatch_item *item = &scene->unit.items[index];
    size_t count = scene->unit.meshes[item->mesh].mesh->vertex_count;
    struct scene_vertex *vertices;
    HATCH_TRY(scene_make_vertices(scene->unit.scene, item->mesh, zero, scratch, &vertices, err));
    double *positions = HATCH_NEW(scratch, double, 3 * count, err);
    float *normals = positions ? HATCH_NEW(scratch, float, 3 * count, err) : NULL;
    if (!normals)
        return HATCH_LIMIT;
    hatch_item_deform(&scene->unit, item, positions, normals);
    for (size_t v = 0; v < count; v++) {
        double at[3];
        hatch_bounds_to_unit(&scene->unit.bounds, positions + 3 * v, at);
        hatch_vec_round(at, vertices[v].position);
        for (size_t k = 0; k < 3; k++)
            vertices[v].normal[k] = normals[3 * v + k];
    }
    gpu_buffer_update(scene->items[index].posed, vertices, sizeof *vertices * count);
    return scene->items[index].tangents ? normals_pose(scene, index, positions, scratch, err) : HATCH_OK;
}

enum hatch_status scene_set_pose(struct scene *scene, uint32_t animation, double time_s, struct hatch_arena *scratch,
                                 struct hatch_err *err)
{
    hatch_unit_scene_pose(&scene->unit, animation, time_s);
    for (uint32_t i = 0; i < scene->unit.item_count; i++) {
        struct hatch_arena_mark mark = hatch_arena_mark(scratch);
        enum hatch_status status = HATCH_OK;
        if (scene->unit.items[i].deformed)
            status = pose_item(scene, i, scratch, err);
        hatch_arena_rewind(scratch, mark);
        HATCH_TRY(status);
    }
    return HATCH_OK;
}
