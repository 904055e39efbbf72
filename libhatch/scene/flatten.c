#include <string.h>

#include "math/vector.h"
#include "scene/pose.h"

struct flat {
    const struct hatch_scene *scene;
    struct hatch_pose pose; /* at rest */
    bool skins;             /* skins pose their meshes */
    double origin[3];
    struct hatch_mesh mesh;
    float *normals, *texcoords; /* NULL: omitted */
    uint32_t vertex, face;      /* numbers of vertices and faces added so far */
};

static void transform(const double *matrix, const double origin[3], const double p[3], float *out)
{
    for (int row = 0; row < 3; row++) {
        double sum = matrix[12 + row] - origin[row];
        for (int k = 0; k < 3; k++)
            sum += matrix[k * 4 + row] * p[k];
        out[row] = (float)sum;
    }
}

/* Computes the cofactors of a matrix; returns its determinant. They transform normals, because they are the transposed
 * inverse times the determinant; for a mirroring matrix their sign must be changed. */
static double cofactors(const double *matrix, double out[3][3])
{
    double column[3][3];
    for (int k = 0; k < 3; k++)
        hatch_vec_copy(matrix + 4 * k, column[k]);
    for (int k = 0; k < 3; k++)
        hatch_vec_cross(column[(k + 1) % 3], column[(k + 2) % 3], out[k]);
    return hatch_vec_dot(column[0], out[0]);
}

static void turn_normal(double cofactor[3][3], double determinant, const double normal[3], float *out)
{
    double turned[3] = {0, 0, 0};
    for (int k = 0; k < 3; k++)
        hatch_vec_add_scaled(turned, (determinant < 0 ? -1 : 1) * normal[k], cofactor[k], turned);
    hatch_vec_normalize(turned);
    hatch_vec_round(turned, out);
}

/* Adds the vertices of a mesh that its node's matrix places. Returns whether the matrix mirrors. */
static bool add_placed(struct flat *f, uint32_t node, const struct hatch_mesh *mesh, const double *matrix)
{
    double cofactor[3][3], determinant = cofactors(matrix, cofactor), at[3];
    const float *positions = mesh->attributes[0].data;
    const float *normals = hatch_mesh_find(mesh, "NORMAL", 3);
    const struct hatch_mesh_attribute *moves = hatch_mesh_attribute(mesh, HATCH_MORPH_POSITION);
    const struct hatch_mesh_attribute *turns = hatch_mesh_attribute(mesh, HATCH_MORPH_NORMAL);
    hatch_scene_weights(f->scene, node, HATCH_NONE, 0, hatch_mesh_target_count(mesh), f->pose.weights);
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        size_t to = f->vertex + v;
        hatch_pose_morph(positions, moves, f->pose.weights, v, at);
        transform(matrix, f->origin, at, &f->mesh.attributes[0].data[to * 3]);
        if (f->normals) {
            hatch_pose_morph(normals, turns, f->pose.weights, v, at);
            turn_normal(cofactor, determinant, at, &f->normals[to * 3]);
        }
    }
    return determinant < 0;
}

/* Adds the vertices of a mesh that a skin poses. */
static enum hatch_status add_skinned(struct flat *f, uint32_t node, const struct hatch_mesh *mesh,
                                     struct hatch_arena *scratch, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    double *posed;
    HATCH_TRY(HATCH_ALLOC(scratch, &posed, 3 * (size_t)mesh->vertex_count, err));
    hatch_pose_mesh(&f->pose, node, mesh, posed, f->normals ? &f->normals[3 * (size_t)f->vertex] : NULL);
    for (size_t v = 0; v < 3 * (size_t)mesh->vertex_count; v++)
        f->mesh.attributes[0].data[3 * (size_t)f->vertex + v] = (float)(posed[v] - f->origin[v % 3]);
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

static enum hatch_status add_mesh(struct flat *f, uint32_t node, const struct hatch_mesh *mesh,
                                  struct hatch_arena *scratch, struct hatch_err *err)
{
    static const double identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    const float *texcoords = hatch_mesh_find(mesh, "TEXCOORD_0", 2);
    bool skinned = f->scene->nodes[node].skin != HATCH_NONE, mirrored = false;
    if (skinned && f->skins)
        HATCH_TRY(add_skinned(f, node, mesh, scratch, err));
    else
        mirrored = add_placed(f, node, mesh, skinned ? identity : &f->pose.world[(size_t)node * 16]);
    if (f->texcoords)
        memcpy(&f->texcoords[2 * (size_t)f->vertex], texcoords, 2 * sizeof *texcoords * mesh->vertex_count);
    for (uint32_t i = 0; i < mesh->face_count; i++)
        for (uint32_t c = 0; c < 3; c++) {
            uint32_t from = mirrored ? (3 - c) % 3 : c;
            f->mesh.indices[(size_t)(f->face + i) * 3 + c] = mesh->indices[(size_t)i * 3 + from] + f->vertex;
        }
    f->vertex += mesh->vertex_count;
    f->face += mesh->face_count;
    return HATCH_OK;
}

struct totals {
    uint64_t vertices, faces;
    bool normals, texcoords; /* all meshes have them */
};

static struct totals count(const struct hatch_scene *scene)
{
    struct totals t = {0, 0, true, true};
    for (uint32_t n = 0; n < scene->node_count; n++)
        for (uint32_t m = 0; m < scene->nodes[n].mesh_count; m++) {
            const struct hatch_mesh *mesh = &scene->meshes[scene->nodes[n].first_mesh + m].mesh;
            t.vertices += mesh->vertex_count;
            t.faces += mesh->face_count;
            t.normals = t.normals && hatch_mesh_find(mesh, "NORMAL", 3);
            t.texcoords = t.texcoords && hatch_mesh_find(mesh, "TEXCOORD_0", 2);
        }
    return t;
}

static enum hatch_status flatten(struct flat *f, struct totals total, struct hatch_arena *arena,
                                 struct hatch_arena *scratch, struct hatch_err *err)
{
    HATCH_TRY(hatch_mesh_make(arena, (uint32_t)total.vertices, (uint32_t)total.faces, &f->mesh, err));
    if (total.normals)
        HATCH_TRY(hatch_mesh_add(arena, &f->mesh, "NORMAL", 3, &f->normals, err));
    if (total.texcoords)
        HATCH_TRY(hatch_mesh_add(arena, &f->mesh, "TEXCOORD_0", 2, &f->texcoords, err));
    for (uint32_t n = 0; n < f->scene->node_count; n++) {
        const struct hatch_node *node = &f->scene->nodes[n];
        for (uint32_t m = 0; m < node->mesh_count; m++)
            HATCH_TRY(add_mesh(f, n, &f->scene->meshes[node->first_mesh + m].mesh, scratch, err));
    }
    return hatch_mesh_check(&f->mesh, err);
}

enum hatch_status hatch_scene_flatten(const struct hatch_scene *scene, const double origin[3], bool skins,
                                      struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_mesh *mesh,
                                      struct hatch_err *err)
{
    struct totals total = count(scene);
    if (total.faces == 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "the scene has no faces");
    if (total.faces > UINT32_MAX / 3 - 1 || total.vertices > UINT32_MAX - 1)
        return hatch_fail(err, HATCH_LIMIT,
                          "the meshes of all nodes have %llu faces and %llu vertices, too many for one mesh",
                          (unsigned long long)total.faces, (unsigned long long)total.vertices);
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct flat f = {.scene = scene, .origin = {origin[0], origin[1], origin[2]}, .skins = skins};
    enum hatch_status status = hatch_pose_make(scene, scratch, &f.pose, err);
    if (status == HATCH_OK) {
        hatch_pose_set(&f.pose, HATCH_NONE, 0);
        status = flatten(&f, total, arena, scratch, err);
    }
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *mesh = f.mesh;
    return status;
}
