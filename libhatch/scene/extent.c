#include "scene/extent.h"

#include <math.h>
#include <string.h>

#include "math/box.h"
#include "math/pca.h"
#include "math/vector.h"

/* Ratio of the smallest to the largest scale below which a matrix flattens. */
#define FLAT 1e-6

static const double identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

/* Extends a box by the transformed bounding box of a mesh.
 *   matrix  column-major */
static void add_mesh(struct hatch_box *box, const struct hatch_mesh *mesh, const double *matrix)
{
    float ends[2][3];
    if (!hatch_mesh_bounds(mesh, ends[0], ends[1]))
        return;
    for (int corner = 0; corner < 8; corner++) {
        double point[3];
        for (int row = 0; row < 3; row++) {
            point[row] = matrix[12 + row];
            for (int k = 0; k < 3; k++)
                point[row] += matrix[4 * k + row] * (double)ends[corner >> k & 1][k];
        }
        hatch_box_add(box, point);
    }
}

void hatch_mesh_sum_areas(const struct hatch_mesh *mesh, double areas[3][3])
{
    memset(areas, 0, sizeof(double[3][3]));
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        double corners[3][3], normal[3];
        if (!hatch_mesh_corners(mesh, f, corners))
            continue;
        hatch_vec_triangle(corners[0], corners[1], corners[2], normal);
        double area = hatch_vec_normalize(normal) / 2;
        for (int row = 0; row < 3; row++)
            hatch_vec_add_scaled(areas[row], area * normal[row], normal, areas[row]);
    }
}

/* Sums areas of a mesh; the result is the unit matrix if no face has an area. */
static void sum_areas(const struct hatch_mesh *mesh, double areas[3][3])
{
    hatch_mesh_sum_areas(mesh, areas);
    bool any = areas[0][0] + areas[1][1] + areas[2][2] > 0;
    for (int k = 0; k < 3 && !any; k++)
        areas[k][k] = 1;
}

/* Returns the scale of a matrix for a mesh: the root of the factor by which it makes the areas of faces larger, in the
 * root mean square.
 *   areas  of the mesh, from sum_areas */
static double scale_of(const double *matrix, double areas[3][3])
{
    double columns[3][3], across[3][3], sum = 0;
    for (int column = 0; column < 3; column++)
        hatch_vec_copy(&matrix[4 * column], columns[column]);
    for (int k = 0; k < 3; k++) /* an area with normal n gets the normal across' n */
        hatch_vec_cross(columns[(k + 1) % 3], columns[(k + 2) % 3], across[k]);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            sum += areas[i][k] * hatch_vec_dot(across[i], across[k]);
    return sqrt(sqrt(sum / (areas[0][0] + areas[1][1] + areas[2][2])));
}

/* Finds the largest and the smallest length of the images of unit vectors. */
static void find_lengths(const double *matrix, double lengths[2])
{
    double columns[3][3], products[9], axes[9], next[9];
    for (int column = 0; column < 3; column++)
        hatch_vec_copy(&matrix[4 * column], columns[column]);
    for (int k = 0; k < 9; k++)
        products[k] = hatch_vec_dot(columns[k / 3], columns[k % 3]);
    hatch_pca_directions(products, 3, 3, axes, next);
    for (int end = 0; end < 2; end++) {
        double image[3] = {0, 0, 0};
        for (int column = 0; column < 3; column++)
            hatch_vec_add_scaled(image, axes[6 * end + column], columns[column], image);
        lengths[end] = hatch_vec_length(image);
    }
}

/* Returns the ratio of these lengths; 1 for a matrix that flattens. */
static double unevenness_of(const double lengths[2])
{
    return lengths[1] > FLAT * lengths[0] ? lengths[0] / lengths[1] : 1;
}

/* Returns the matrix that places a node's meshes in the scene. For a node with a skin, whose own transform does not
 * move its meshes, this is the matrix of the skin's first joint.
 *   joints  room for the matrices of the largest skin */
static const double *matrix_of(const struct hatch_scene *scene, uint32_t n, const double *world, double *joints)
{
    if (scene->nodes[n].skin == HATCH_NONE)
        return world + 16 * (size_t)n;
    hatch_scene_skin(scene, scene->nodes[n].skin, world, joints);
    return joints;
}

/* A scene while it is measured. */
struct measuring {
    const struct hatch_scene *scene;
    double *world, *joints; /* matrices of all nodes, and of the largest skin */
    double (*areas)[3][3];  /* per mesh, from sum_areas */
    double *scale;          /* per mesh: the largest so far */
    double *stretch;        /* per mesh: the largest so far */
    double *unevenness;     /* per mesh: the largest so far, at rest */
    bool *known;            /* per mesh: its scale no longer changes */
    struct hatch_box box;   /* of all that is drawn */
    bool box_known;         /* it no longer changes */
};

static enum hatch_status begin(struct measuring *measuring, struct hatch_arena *arena, struct hatch_arena *scratch,
                               struct hatch_err *err)
{
    const struct hatch_scene *scene = measuring->scene;
    size_t joint_count = 0;
    for (uint32_t s = 0; s < scene->skin_count; s++)
        joint_count = scene->skins[s].joint_count > joint_count ? scene->skins[s].joint_count : joint_count;
    HATCH_TRY(HATCH_ALLOC(scratch, &measuring->world, 16 * (size_t)scene->node_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &measuring->joints, 16 * joint_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &measuring->areas, scene->mesh_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &measuring->known, scene->mesh_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &measuring->scale, scene->mesh_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &measuring->stretch, scene->mesh_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &measuring->unevenness, scene->mesh_count, err));
    for (uint32_t m = 0; m < scene->mesh_count; m++)
        sum_areas(&scene->meshes[m].mesh, measuring->areas[m]);
    return HATCH_OK;
}

/* Measures the meshes at a time of an animation, or at rest. */
static void measure_pose(struct measuring *measuring, uint32_t animation, double time_s)
{
    const struct hatch_scene *scene = measuring->scene;
    hatch_scene_pose(scene, animation, time_s, measuring->world);
    for (uint32_t n = 0; n < scene->node_count; n++) {
        const struct hatch_node *node = &scene->nodes[n];
        if (node->mesh_count == 0)
            continue;
        const double *matrix = matrix_of(scene, n, measuring->world, measuring->joints);
        double lengths[2];
        find_lengths(matrix, lengths);
        const double unevenness = animation == HATCH_NONE ? unevenness_of(lengths) : 1;
        for (uint32_t m = node->first_mesh; m < node->first_mesh + node->mesh_count; m++) {
            if (!measuring->box_known)
                add_mesh(&measuring->box, &scene->meshes[m].mesh, matrix);
            if (!measuring->known[m]) {
                measuring->scale[m] = fmax(measuring->scale[m], scale_of(matrix, measuring->areas[m]));
                measuring->stretch[m] = fmax(measuring->stretch[m], lengths[0]);
            }
            measuring->unevenness[m] = fmax(measuring->unevenness[m], unevenness);
        }
    }
}

/* Measures what has no size at rest at the times at which animations set scales. */
static void measure_animations(struct measuring *measuring)
{
    const struct hatch_scene *scene = measuring->scene;
    bool all_known = true;
    measuring->box_known = hatch_vec_distance(measuring->box.low, measuring->box.high) > 0;
    for (uint32_t m = 0; m < scene->mesh_count; m++) {
        measuring->known[m] = measuring->scale[m] > 0;
        all_known = all_known && measuring->known[m];
    }
    for (uint32_t a = 0; a < scene->animation_count && !all_known; a++)
        for (uint32_t c = 0; c < scene->animations[a].channel_count; c++) {
            const struct hatch_animation_channel *channel = &scene->animations[a].channels[c];
            for (uint32_t i = 0; i < channel->key_count && channel->path == HATCH_PATH_SCALE; i++)
                measure_pose(measuring, a, (double)channel->times_s[i]);
        }
}

/* Returns the scale at which a mesh that is nowhere drawn with a size is as large as the scene. */
static double scale_to(double diagonal, const struct hatch_mesh *mesh)
{
    struct hatch_box box = {.any = false};
    add_mesh(&box, mesh, identity);
    double own = hatch_vec_distance(box.low, box.high);
    return box.any && diagonal > 0 && own > 0 ? diagonal / own : 1;
}

/* Measures without rewinding scratch. */
static enum hatch_status measure(const struct hatch_scene *scene, struct hatch_arena *arena,
                                 struct hatch_arena *scratch, struct hatch_scene_extent *extent, struct hatch_err *err)
{
    struct measuring measuring = {.scene = scene};
    HATCH_TRY(begin(&measuring, arena, scratch, err));
    measure_pose(&measuring, HATCH_NONE, 0);
    if (measuring.box.any)
        measure_animations(&measuring);
    bool drawn = measuring.box.any;
    for (uint32_t m = 0; m < scene->mesh_count && !drawn; m++) {
        add_mesh(&measuring.box, &scene->meshes[m].mesh, identity);
        measuring.scale[m] = 1;
    }
    double diagonal = hatch_vec_distance(measuring.box.low, measuring.box.high);
    for (uint32_t m = 0; m < scene->mesh_count; m++) {
        if (!(measuring.scale[m] > 0))
            measuring.scale[m] = scale_to(diagonal, &scene->meshes[m].mesh);
        measuring.stretch[m] = fmax(measuring.stretch[m], measuring.scale[m]);
        measuring.unevenness[m] = fmax(measuring.unevenness[m], 1);
    }
    *extent = (struct hatch_scene_extent){diagonal, measuring.scale, measuring.stretch, measuring.unevenness};
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
