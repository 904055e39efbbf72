#include "scene/pose.h"

#include <math.h>
#include <string.h>

#include "math/vector.h"

enum hatch_status hatch_pose_make(const struct hatch_scene *scene, struct hatch_arena *arena, struct hatch_pose *pose,
                                  struct hatch_err *err)
{
    uint32_t joints = 0, targets = 0;
    for (uint32_t i = 0; i < scene->skin_count; i++)
        if (scene->skins[i].joint_count > joints)
            joints = scene->skins[i].joint_count;
    for (uint32_t i = 0; i < scene->mesh_count; i++) {
        uint32_t more = hatch_mesh_target_count(&scene->meshes[i].mesh);
        targets = more > targets ? more : targets;
    }
    struct hatch_pose made = {.scene = scene, .animation = HATCH_NONE};
    HATCH_TRY(HATCH_ALLOC(arena, &made.world, 16u * (size_t)scene->node_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.joints, 16u * (size_t)joints, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.weights, targets, err));
    *pose = made;
    return HATCH_OK;
}

void hatch_pose_set(struct hatch_pose *pose, uint32_t animation, double time_s)
{
    pose->animation = animation;
    pose->time_s = time_s;
    hatch_scene_pose(pose->scene, animation, time_s, pose->world);
}

void hatch_pose_matrix(const struct hatch_pose *pose, uint32_t node, double matrix[16])
{
    memcpy(matrix, &pose->world[16 * (size_t)node], 16 * sizeof *matrix);
}

bool hatch_pose_normal_matrix(const double m[16], double normal[9])
{
    for (int c = 0; c < 3; c++) {
        const double *a = m + 4 * ((c + 1) % 3), *b = m + 4 * ((c + 2) % 3);
        for (int r = 0; r < 3; r++) {
            int r1 = (r + 1) % 3, r2 = (r + 2) % 3;
            normal[3 * c + r] = a[r1] * b[r2] - a[r2] * b[r1];
        }
    }
    double det = m[0] * normal[0] + m[1] * normal[1] + m[2] * normal[2];
    for (int i = 0; det < 0 && i < 9; i++)
        normal[i] = -normal[i];
    return det < 0;
}

/* Computes the skinning matrix of a vertex, with weights normalized to a sum of 1. */
static void blend_joints(const double *joints, const float *ids, const float *weights, uint32_t joint_count,
                         double matrix[16])
{
    memset(matrix, 0, 16 * sizeof *matrix);
    double sum = 0;
    for (int k = 0; k < 4; k++) {
        double weight = (double)weights[k];
        uint32_t joint = (uint32_t)ids[k];
        if (!(weight > 0) || joint >= joint_count)
            continue;
        sum += weight;
        for (int i = 0; i < 16; i++)
            matrix[i] += weight * joints[16 * (size_t)joint + (size_t)i];
    }
    if (!(sum > 0) && joint_count > 0) /* no valid weight: the vertex follows its first joint */
        for (int i = 0; i < 16; i++)
            matrix[i] = joints[16 * (size_t)(ids[0] < (float)joint_count ? ids[0] : 0) + (size_t)i];
    for (int i = 0; sum > 0 && i < 16; i++)
        matrix[i] /= sum;
}

static void transform_normal(const double matrix[16], const double in[3], float *out)
{
    double n[9], v[3];
    hatch_pose_normal_matrix(matrix, n);
    for (int r = 0; r < 3; r++)
        v[r] = n[r] * in[0] + n[3 + r] * in[1] + n[6 + r] * in[2];
    double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int r = 0; r < 3; r++)
        out[r] = length > 0 ? (float)(v[r] / length) : 0.0f;
}

void hatch_pose_vertices(struct hatch_pose *pose, uint32_t node, uint32_t mesh, double *positions, float *normals)
{
    hatch_pose_mesh(pose, node, &pose->scene->meshes[mesh].mesh, positions, normals);
}

bool hatch_pose_deforms(const struct hatch_scene *scene, uint32_t node, const struct hatch_mesh *mesh)
{
    bool skinned = scene->nodes[node].skin != HATCH_NONE && hatch_mesh_find(mesh, "JOINTS_0", 4) &&
                   hatch_mesh_find(mesh, "WEIGHTS_0", 4);
    return skinned || hatch_mesh_target_count(mesh) > 0;
}

void hatch_pose_morph(const float *at_rest, const struct hatch_mesh_attribute *moves, const double *weights,
                      size_t vertex, double out[3])
{
    hatch_vec_of(at_rest + 3 * vertex, out);
    for (uint32_t i = 0; moves && i < moves->components; i++)
        out[i % 3] += weights[i / 3] * (double)moves->data[moves->components * vertex + i];
}

void hatch_pose_mesh(struct hatch_pose *pose, uint32_t node, const struct hatch_mesh *from, double *positions,
                     float *normals)
{
    const struct hatch_scene *scene = pose->scene;
    const float *position = hatch_mesh_find(from, "POSITION", 3);
    const float *normal = hatch_mesh_find(from, "NORMAL", 3);
    const float *ids = hatch_mesh_find(from, "JOINTS_0", 4);
    const float *weights = hatch_mesh_find(from, "WEIGHTS_0", 4);
    const struct hatch_mesh_attribute *moves = hatch_mesh_attribute(from, HATCH_MORPH_POSITION);
    const struct hatch_mesh_attribute *turns = hatch_mesh_attribute(from, HATCH_MORPH_NORMAL);
    uint32_t skin = scene->nodes[node].skin;
    bool skinned = skin != HATCH_NONE && ids && weights;
    if (skinned)
        hatch_scene_skin(scene, skin, pose->world, pose->joints);
    hatch_scene_weights(scene, node, pose->animation, pose->time_s, hatch_mesh_target_count(from), pose->weights);
    double matrix[16], p[3];
    hatch_pose_matrix(pose, node, matrix);
    for (size_t v = 0; v < from->vertex_count; v++) {
        if (skinned)
            blend_joints(pose->joints, ids + 4 * v, weights + 4 * v, scene->skins[skin].joint_count, matrix);
        hatch_pose_morph(position, moves, pose->weights, v, p);
        for (int r = 0; r < 3; r++)
            positions[3 * v + (size_t)r] =
                matrix[r] * p[0] + matrix[4 + r] * p[1] + matrix[8 + r] * p[2] + matrix[12 + r];
        if (!normals || !normal)
            continue;
        hatch_pose_morph(normal, turns, pose->weights, v, p);
        transform_normal(matrix, p, normals + 3 * v);
    }
}

static enum hatch_status each_corner(struct hatch_pose *pose, uint32_t node, uint32_t mesh, struct hatch_arena *scratch,
                                     hatch_pose_visit visit, void *context, struct hatch_err *err)
{
    const struct hatch_mesh *shape = &pose->scene->meshes[mesh].mesh;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    double *positions;
    HATCH_TRY(HATCH_ALLOC(scratch, &positions, 3 * (size_t)shape->vertex_count, err));
    hatch_pose_vertices(pose, node, mesh, positions, NULL);
    for (size_t corner = 0; corner < 3 * (size_t)shape->face_count; corner++)
        visit(context, positions + 3 * (size_t)shape->indices[corner]);
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

enum hatch_status hatch_pose_each_corner(struct hatch_pose *pose, const struct hatch_pose_span *span,
                                         struct hatch_arena *scratch, hatch_pose_visit visit, void *context,
                                         struct hatch_err *err)
{
    for (uint32_t moment = 0; moment < span->moments; moment++) {
        hatch_pose_set(pose, span->animation, span->times_s ? span->times_s[moment] : 0);
        for (uint32_t node = 0; node < pose->scene->node_count; node++) {
            const struct hatch_node *at = &pose->scene->nodes[node];
            if (at->backdrop)
                continue;
            for (uint32_t i = 0; i < at->mesh_count; i++)
                HATCH_TRY(each_corner(pose, node, at->first_mesh + i, scratch, visit, context, err));
        }
    }
    return HATCH_OK;
}

struct box {
    double low[3], high[3];
    bool any;
};

static void grow_box(void *context, const double point[3])
{
    struct box *box = context;
    for (int k = 0; k < 3; k++) {
        if (!box->any || point[k] < box->low[k])
            box->low[k] = point[k];
        if (!box->any || point[k] > box->high[k])
            box->high[k] = point[k];
    }
    box->any = true;
}

enum hatch_status hatch_pose_bounds(struct hatch_pose *pose, const struct hatch_pose_span *span,
                                    struct hatch_arena *scratch, struct hatch_bounds *bounds, struct hatch_err *err)
{
    struct box box = {.any = false};
    HATCH_TRY(hatch_pose_each_corner(pose, span, scratch, grow_box, &box, err));
    double square = 0;
    for (int k = 0; k < 3; k++) {
        double half = bounds->half[k] = 0.5 * box.high[k] - 0.5 * box.low[k];
        bounds->center[k] = 0.5 * box.high[k] + 0.5 * box.low[k];
        square += half * half;
    }
    bool shows = square > 0 && isfinite(square);
    bounds->radius = shows ? sqrt(square) : 1.0;
    bounds->empty = !shows;
    return HATCH_OK;
}
