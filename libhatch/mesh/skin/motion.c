#include "mesh/skin/motion.h"

#include "base/random.h"
#include "math/vector.h"

/* Streams of random numbers. */
enum stream { JOINTS, TARGETS };

static double random_between(double low, double high, enum stream stream, uint64_t index)
{
    return low + (high - low) * (double)hatch_random_unit(0, stream, index);
}

/* Adds the motion of the joints of a vertex. Its weights are shares of their sum; without a valid one it follows its
 * first joint. */
static void add_joints(const float *ids, const float *weights, double size, double motion[3])
{
    double sum = 0;
    for (int k = 0; k < 4; k++)
        sum += weights[k] > 0 ? (double)weights[k] : 0;
    for (int k = 0; k < 4; k++) {
        double share = sum > 0 ? fmax((double)weights[k], 0) / sum : k == 0;
        for (uint32_t axis = 0; axis < 3 && share > 0; axis++)
            motion[axis] += share * size * random_between(-1, 1, JOINTS, 3 * (uint64_t)ids[k] + axis);
    }
}

bool hatch_mesh_moves(const struct hatch_mesh *mesh)
{
    return (hatch_mesh_find(mesh, "JOINTS_0", 4) && hatch_mesh_find(mesh, "WEIGHTS_0", 4)) ||
           hatch_mesh_attribute(mesh, HATCH_MORPH_POSITION);
}

void hatch_mesh_motion(const struct hatch_mesh *mesh, float *motion)
{
    const double size = hatch_mesh_diagonal(mesh);
    const float *ids = hatch_mesh_find(mesh, "JOINTS_0", 4);
    const float *weights = hatch_mesh_find(mesh, "WEIGHTS_0", 4);
    const struct hatch_mesh_attribute *moves = hatch_mesh_attribute(mesh, HATCH_MORPH_POSITION);
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        double at[3] = {0, 0, 0};
        if (ids && weights)
            add_joints(ids + 4 * v, weights + 4 * v, size, at);
        for (uint32_t i = 0; moves && i < moves->components; i++)
            at[i % 3] += random_between(0.5, 1, TARGETS, i / 3) * (double)moves->data[moves->components * v + i];
        hatch_vec_round(at, motion + 3 * v);
    }
}

enum hatch_status hatch_mesh_weld_moving(const struct hatch_mesh *mesh, struct hatch_arena *scratch,
                                         uint32_t *vertex_to_point, uint32_t *point_count, struct hatch_err *err)
{
    float *motion;
    if (!hatch_mesh_moves(mesh))
        return hatch_mesh_weld(mesh, scratch, vertex_to_point, point_count, err);
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    HATCH_TRY(HATCH_ALLOC(scratch, &motion, 3 * (size_t)mesh->vertex_count, err));
    hatch_mesh_motion(mesh, motion);
    enum hatch_status status = hatch_remap_weld(mesh, motion, scratch, vertex_to_point, point_count, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}

enum hatch_status hatch_mesh_remap_by_normal(const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                             struct hatch_arena *scratch, struct hatch_remap *remap,
                                             struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    uint32_t *point, count;
    HATCH_TRY(HATCH_ALLOC(scratch, &point, mesh->vertex_count, err));
    enum hatch_status status = hatch_mesh_weld_moving(mesh, scratch, point, &count, err);
    if (status == HATCH_OK)
        status = hatch_remap_by_values(mesh, point, hatch_mesh_find(mesh, "NORMAL", 3), arena, scratch, remap, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}
