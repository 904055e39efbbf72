#include "coarse/scene.h"

#include <math.h>

#include "coarse/coarse.h"
#include "math/pca.h"
#include "math/vector.h"
#include "scene/extent.h"

/* Returns the largest factor by which a matrix changes lengths. */
static double largest_stretch(const double matrix[16])
{
    double products[9], direction[3], next[3], image[3] = {0, 0, 0};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            products[3 * i + j] = hatch_vec_dot(matrix + 4 * i, matrix + 4 * j);
    hatch_pca_directions(products, 3, 1, direction, next);
    for (int i = 0; i < 3; i++)
        hatch_vec_add_scaled(image, direction[i], matrix + 4 * i, image);
    return hatch_vec_length(image);
}

/* Computes, per vertex, the largest factor by which the pose changes the length of an edge there.
 *   posed  3 per vertex */
static void find_stretch(const struct hatch_mesh *mesh, const double *posed, double *stretch)
{
    for (uint32_t f = 0; f < mesh->face_count; f++)
        for (size_t c = 0; c < 3; c++) {
            size_t a = mesh->indices[3 * (size_t)f + c], b = mesh->indices[3 * (size_t)f + (c + 1) % 3];
            double from[3], to[3];
            hatch_vec_of(&mesh->attributes[0].data[3 * a], from);
            hatch_vec_of(&mesh->attributes[0].data[3 * b], to);
            double length = hatch_vec_distance(from, to);
            double by = length > 0 ? hatch_vec_distance(&posed[3 * a], &posed[3 * b]) / length : 0;
            stretch[a] = fmax(stretch[a], by);
            stretch[b] = fmax(stretch[b], by);
        }
}

/* Lowers the tolerances of a mesh's vertices to what a node allows.
 *   scale  of the mesh, where the node gives it no size at rest */
static enum hatch_status add_node(struct hatch_pose *pose, const struct hatch_view_set *views, uint32_t node,
                                  uint32_t index, double scale, double error_px, const float *share,
                                  struct hatch_arena *scratch, double *tolerance, struct hatch_err *err)
{
    const struct hatch_mesh *mesh = &pose->scene->meshes[index].mesh;
    double *posed, *stretch, matrix[16];
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    HATCH_TRY(HATCH_ALLOC(scratch, &posed, 3 * (size_t)mesh->vertex_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &stretch, mesh->vertex_count, err));
    hatch_pose_vertices(pose, node, index, posed, NULL);
    hatch_pose_matrix(pose, node, matrix);
    double whole = hatch_pose_deforms(pose->scene, node, mesh) ? 0 : largest_stretch(matrix);
    if (whole == 0)
        find_stretch(mesh, posed, stretch);
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        double by = fmax(whole, stretch[v]);
        double pixels = hatch_views_pixels(views, &posed[3 * v]) * (by > 0 ? by : scale);
        if (pixels > 0)
            tolerance[v] = fmin(tolerance[v], error_px * (share ? (double)share[v] : 1) / pixels);
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

/* The nodes that draw the same meshes, and where their vertices begin among those of all nodes. */
struct drawers {
    uint32_t *first; /* per mesh: the first node whose meshes begin with it; HATCH_NONE: none */
    uint32_t *next;  /* per node: the next one with the same meshes, or HATCH_NONE */
    size_t *start;   /* per node: number of vertices of the nodes before it */
};

static enum hatch_status find_drawers(const struct hatch_scene *scene, struct hatch_arena *scratch,
                                      struct drawers *drawers, struct hatch_err *err)
{
    size_t vertices = 0;
    HATCH_TRY(HATCH_ALLOC(scratch, &drawers->first, scene->mesh_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &drawers->next, scene->node_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &drawers->start, scene->node_count, err));
    for (uint32_t m = 0; m < scene->mesh_count; m++)
        drawers->first[m] = HATCH_NONE;
    for (uint32_t n = scene->node_count; n-- > 0;) {
        if (scene->nodes[n].mesh_count == 0)
            continue;
        uint32_t *first = &drawers->first[scene->nodes[n].first_mesh];
        drawers->next[n] = *first;
        *first = n;
    }
    for (uint32_t n = 0; n < scene->node_count; n++) {
        drawers->start[n] = vertices;
        for (uint32_t m = 0; m < scene->nodes[n].mesh_count; m++)
            vertices += scene->meshes[scene->nodes[n].first_mesh + m].mesh.vertex_count;
    }
    return HATCH_OK;
}

/* Makes the meshes of a node coarser.
 *   scale  per mesh of the scene (struct hatch_scene_extent)
 *   node   the first that draws them */
static enum hatch_status coarsen(struct hatch_pose *pose, const struct hatch_view_set *views,
                                 const struct drawers *drawers, const double *scale, double error_px,
                                 const float *share, uint32_t node, struct hatch_arena *arena,
                                 struct hatch_arena *scratch, struct hatch_mesh *meshes, struct hatch_err *err)
{
    const struct hatch_scene *scene = pose->scene;
    uint32_t first = scene->nodes[node].first_mesh, count = scene->nodes[node].mesh_count;
    struct hatch_coarse_part *parts;
    size_t before = 0; /* vertices of the node's meshes before this one */
    HATCH_TRY(HATCH_ALLOC(scratch, &parts, count, err));
    for (uint32_t m = 0; m < count; m++) {
        double *tolerance;
        parts[m].mesh = &scene->meshes[first + m].mesh;
        HATCH_TRY(HATCH_ALLOC(scratch, &tolerance, parts[m].mesh->vertex_count, err));
        for (size_t v = 0; v < parts[m].mesh->vertex_count; v++)
            tolerance[v] = INFINITY;
        for (uint32_t n = node; n != HATCH_NONE; n = drawers->next[n])
            HATCH_TRY(add_node(pose, views, n, first + m, scale[first + m], error_px,
                               share ? share + drawers->start[n] + before : NULL, scratch, tolerance, err));
        before += parts[m].mesh->vertex_count;
        parts[m].tolerance = tolerance;
    }
    return hatch_coarse_make(parts, count, arena, scratch, &meshes[first], err);
}

enum hatch_status hatch_coarse_scene(struct hatch_pose *pose, const struct hatch_view_set *views, double error_px,
                                     const float *share, struct hatch_arena *arena, struct hatch_arena *scratch,
                                     struct hatch_mesh *meshes, struct hatch_err *err)
{
    const struct hatch_scene *scene = pose->scene;
    struct hatch_scene_extent extent;
    struct drawers drawers;
    struct hatch_arena_mark begin = hatch_arena_mark(scratch);
    HATCH_TRY(hatch_scene_find_extent(scene, scratch, arena, &extent, err));
    HATCH_TRY(find_drawers(scene, scratch, &drawers, err));
    for (uint32_t m = 0; m < scene->mesh_count; m++)
        meshes[m] = scene->meshes[m].mesh;
    for (uint32_t m = 0; m < scene->mesh_count; m++) {
        if (drawers.first[m] == HATCH_NONE)
            continue;
        struct hatch_arena_mark mark = hatch_arena_mark(scratch);
        enum hatch_status status = coarsen(pose, views, &drawers, extent.scale, error_px, share, drawers.first[m],
                                           arena, scratch, meshes, err);
        hatch_arena_rewind(scratch, mark);
        if (status != HATCH_OK)
            return status;
    }
    hatch_arena_rewind(scratch, begin);
    return HATCH_OK;
}
