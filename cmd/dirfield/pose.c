#include "dirfield.h"
#include "math/vector.h"

static bool shows(const struct hatch_node *node, uint32_t mesh)
{
    return mesh >= node->first_mesh && mesh - node->first_mesh < node->mesh_count;
}

/* The transform of the node does not apply to a skinned mesh (glTF). */
static struct dirfield_pose pose_of(const struct hatch_node *node, const double *world)
{
    struct dirfield_pose pose = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
    for (int row = 0; row < 3 && node->skin == HATCH_NONE; row++) {
        for (int k = 0; k < 3; k++)
            pose.matrix[row][k] = world[k * 4 + row];
        pose.offset[row] = world[12 + row];
    }
    return pose;
}

static void find_poses(struct cmd_args *args, const struct hatch_scene *scene, const double *world,
                       struct dirfield_job *job)
{
    struct hatch_err err;
    for (uint32_t n = 0; n < scene->node_count; n++)
        job->pose_count += shows(&scene->nodes[n], job->number);
    cmd_check(HATCH_ALLOC(&args->keep, &job->poses, job->pose_count, &err), NULL, &err);
    uint32_t found = 0;
    for (uint32_t n = 0; n < scene->node_count; n++)
        if (shows(&scene->nodes[n], job->number))
            job->poses[found++] = pose_of(&scene->nodes[n], &world[(size_t)n * 16]);
}

void dirfield_find_poses(struct cmd_args *args, const struct hatch_scene *scene, struct dirfield_job *jobs)
{
    struct hatch_err err;
    double *world;
    cmd_check(HATCH_ALLOC(&args->keep, &world, (size_t)scene->node_count * 16, &err), NULL, &err);
    hatch_scene_pose(scene, HATCH_NONE, 0, world);
    for (uint32_t i = 0; i < scene->mesh_count; i++)
        find_poses(args, scene, world, &jobs[i]);
}

void dirfield_to_scene(const struct dirfield_pose *pose, const double mesh[3], double scene[3])
{
    for (int row = 0; row < 3; row++)
        scene[row] = pose->offset[row] + hatch_vec_dot(pose->matrix[row], mesh);
}

/* The inverse of the matrix is the transpose of this over the determinant. */
static void find_cofactors(const struct dirfield_pose *pose, double cofactors[3][3])
{
    for (int row = 0; row < 3; row++)
        hatch_vec_cross(pose->matrix[(row + 1) % 3], pose->matrix[(row + 2) % 3], cofactors[row]);
}

/* Cramer's rule. */
bool dirfield_to_mesh(const struct dirfield_pose *pose, const double vector[3], double mesh[3])
{
    double cofactors[3][3];
    find_cofactors(pose, cofactors);
    double determinant = hatch_vec_dot(pose->matrix[0], cofactors[0]);
    for (int k = 0; k < 3; k++)
        mesh[k] =
            (cofactors[0][k] * vector[0] + cofactors[1][k] * vector[1] + cofactors[2][k] * vector[2]) / determinant;
    return isfinite(hatch_vec_length(mesh));
}

bool dirfield_is_similarity(const struct dirfield_pose *pose)
{
    double square = hatch_vec_dot(pose->matrix[0], pose->matrix[0]), most = 0;
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++)
            most = fmax(most, fabs(hatch_vec_dot(pose->matrix[a], pose->matrix[b]) - (a == b ? square : 0)));
    return most <= 1e-5 * square;
}

/* 1 over the Frobenius norm of the inverse, which is at least its largest stretch. */
double dirfield_least_scale(const struct dirfield_pose *pose)
{
    double cofactors[3][3], square = 0;
    find_cofactors(pose, cofactors);
    for (int row = 0; row < 3; row++)
        square += hatch_vec_dot(cofactors[row], cofactors[row]);
    double scale = fabs(hatch_vec_dot(pose->matrix[0], cofactors[0])) / sqrt(square);
    return scale > 0 ? scale : 0;
}

double dirfield_to_tangent(const struct dirfield_pose *pose, const double direction[3], const double normal[3],
                           double tangent[3])
{
    double cofactors[3][3], unit[3], posed_normal[3];
    find_cofactors(pose, cofactors);
    for (int row = 0; row < 3; row++)
        posed_normal[row] = hatch_vec_dot(cofactors[row], normal);
    hatch_vec_normalize(posed_normal);
    hatch_vec_copy(direction, unit);
    hatch_vec_normalize(unit);
    hatch_vec_add_scaled(unit, -hatch_vec_dot(unit, posed_normal), posed_normal, unit);
    double share = hatch_vec_length(unit);
    dirfield_to_mesh(pose, unit, tangent);
    hatch_vec_normalize(tangent);
    return share;
}
