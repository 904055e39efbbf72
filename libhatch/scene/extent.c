#include "scene/extent.h"

#include <math.h>

#include "math/box.h"
#include "math/pca.h"
#include "math/vector.h"

/* Ratio of the smallest to the largest scale below which a matrix flattens. */
#define FLAT 1e-6

/* Extends a box by the transformed bounding box of a mesh.
 *   matrix  column-major */
static void add_mesh(struct hatch_box *box, const struct hatch_mesh *mesh, const float *matrix)
{
    float ends[2][3];
    if (!hatch_mesh_bounds(mesh, ends[0], ends[1]))
        return;
    for (int corner = 0; corner < 8; corner++) {
        double point[3];
        for (int row = 0; row < 3; row++) {
            point[row] = (double)matrix[12 + row];
            for (int k = 0; k < 3; k++)
                point[row] += (double)matrix[4 * k + row] * (double)ends[corner >> k & 1][k];
        }
        hatch_box_add(box, point);
    }
}

/* Returns the mean scale of a matrix: the cube root of the absolute value of its determinant. */
static double scale_of(const float *matrix)
{
    double columns[3][3], cross[3];
    for (int column = 0; column < 3; column++)
        hatch_vec_of(&matrix[4 * column], columns[column]);
    hatch_vec_cross(columns[0], columns[1], cross);
    return cbrt(fabs(hatch_vec_dot(cross, columns[2])));
}

/* Returns the ratio of the largest to the smallest length of the images of unit vectors; 1 for a matrix that flattens.
 */
static double unevenness_of(const float *matrix)
{
    double columns[3][3], products[9], axes[9], next[9], lengths[2];
    for (int column = 0; column < 3; column++)
        hatch_vec_of(&matrix[4 * column], columns[column]);
    for (int k = 0; k < 9; k++)
        products[k] = hatch_vec_dot(columns[k / 3], columns[k % 3]);
    hatch_pca_directions(products, 3, 3, axes, next);
    for (int end = 0; end < 2; end++) {
        double image[3] = {0, 0, 0};
        for (int column = 0; column < 3; column++)
            hatch_vec_add_scaled(image, axes[6 * end + column], columns[column], image);
        lengths[end] = hatch_vec_length(image);
    }
    return lengths[1] > FLAT * lengths[0] ? lengths[0] / lengths[1] : 1;
}

/* Returns the matrix that places a node's meshes in the scene. For a node with a skin, whose own transform does not
 * move its meshes, this is the matrix of the skin's first joint.
 *   joints  room for the matrices of the largest skin */
static const float *matrix_of(const struct hatch_scene *scene, uint32_t n, const float *world, float *joints)
{
    if (scene->nodes[n].skin == HATCH_NONE)
        return world + 16 * (size_t)n;
    hatch_scene_skin(scene, scene->nodes[n].skin, world, joints);
    return joints;
}

/* Measures without rewinding scratch. */
static enum hatch_status measure(const struct hatch_scene *scene, struct hatch_arena *arena,
                                 struct hatch_arena *scratch, struct hatch_scene_extent *extent, struct hatch_err *err)
{
    static const float identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    struct hatch_scene_extent made;
    struct hatch_box box = {.any = false};
    size_t joint_count = 0;
    for (uint32_t s = 0; s < scene->skin_count; s++)
        joint_count = scene->skins[s].joint_count > joint_count ? scene->skins[s].joint_count : joint_count;
    float *world, *joints;
    HATCH_TRY(HATCH_ALLOC(scratch, &world, 16 * (size_t)scene->node_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &joints, 16 * joint_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.scale, scene->mesh_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.unevenness, scene->mesh_count, err));
    hatch_scene_pose(scene, HATCH_NONE, 0, world);
    for (uint32_t n = 0; n < scene->node_count; n++) {
        const struct hatch_node *node = &scene->nodes[n];
        if (node->mesh_count == 0)
            continue;
        const float *matrix = matrix_of(scene, n, world, joints);
        const double unevenness = unevenness_of(matrix);
        for (uint32_t m = node->first_mesh; m < node->first_mesh + node->mesh_count; m++) {
            add_mesh(&box, &scene->meshes[m].mesh, matrix);
            made.scale[m] = made.scale[m] > 0 ? made.scale[m] : scale_of(matrix);
            made.unevenness[m] = fmax(made.unevenness[m], unevenness);
        }
    }
    bool drawn = box.any;
    for (uint32_t m = 0; m < scene->mesh_count; m++) {
        made.scale[m] = made.scale[m] > 0 ? made.scale[m] : 1;
        made.unevenness[m] = fmax(made.unevenness[m], 1);
        if (!drawn)
            add_mesh(&box, &scene->meshes[m].mesh, identity);
    }
    made.diagonal = hatch_vec_distance(box.low, box.high);
    *extent = made;
    return HATCH_OK;
}

enum hatch_status hatch_scene_find_extent(const struct hatch_scene *scene, struct hatch_arena *arena,
                                          struct hatch_arena *scratch, struct hatch_scene_extent *extent,
                                          struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = measure(scene, arena, scratch, extent, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}
