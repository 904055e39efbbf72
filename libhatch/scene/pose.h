/* A scene at a moment: node matrices, and the vertices that nodes and skins put into the world.
 * World coordinates here are doubles, so that scenes of any scale and any distance from the origin
 * keep their digits; the GPU sees the unit scene: (world - center) / radius. */
#ifndef HATCH_SCENE_POSE_H
#define HATCH_SCENE_POSE_H

#include <stdbool.h>

#include "scene/scene.h"

struct hatch_pose {
    const struct hatch_scene *scene;
    float *world;    /* 16 per node, column-major */
    float *joints;   /* 16 per joint of the largest skin */
    double *weights; /* of the most morph targets that a mesh has */
    uint32_t animation;
    double time_s;
};

/* Where the scene is: what the unit scene is made with. */
struct hatch_bounds {
    double center[3];
    double radius;  /* over 0; 1 for a scene without extent */
    double half[3]; /* of the box's sides */
    bool empty;     /* no face anywhere */
};

/* A point of the world in the unit scene. world and unit may be the same array. */
static inline void hatch_bounds_to_unit(const struct hatch_bounds *bounds, const double world[3], double unit[3])
{
    for (int k = 0; k < 3; k++)
        unit[k] = (world[k] - bounds->center[k]) / bounds->radius;
}

/* Makes room; hatch_pose_at fills it. */
enum hatch_status hatch_pose_make(const struct hatch_scene *scene, struct hatch_arena *arena, struct hatch_pose *pose,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* animation: index or HATCH_NONE. */
void hatch_pose_at(struct hatch_pose *pose, uint32_t animation, double time_s);

/* World positions (3 per vertex) and unit normals (3 per vertex, or NULL) of one mesh at one node of
 * the pose. A normal that cannot be told is 0 0 0. */
void hatch_pose_vertices(struct hatch_pose *pose, uint32_t node, uint32_t mesh, double *positions, float *normals);

/* The same of a mesh that is not the scene's own, but moves as the node's meshes do. */
void hatch_pose_mesh(struct hatch_pose *pose, uint32_t node, const struct hatch_mesh *mesh, double *positions,
                     float *normals);

/* Is a mesh's shape at a node another one from pose to pose? */
bool hatch_pose_shapes(const struct hatch_scene *scene, uint32_t node, const struct hatch_mesh *mesh);

/* The matrix that carries a node's mesh into the world, in doubles; not for skinned nodes. */
void hatch_pose_matrix(const struct hatch_pose *pose, uint32_t node, double matrix[16]);

/* The 3×3 cofactors of a 4×4 matrix, signed so that outward normals stay outward when it mirrors;
 * column-major. Returns true when it mirrors. */
bool hatch_pose_normal_matrix(const double matrix[16], double normal[9]);

/* Moments evenly spaced in begin_s .. end_s of an animation (HATCH_NONE: the rest pose). */
struct hatch_pose_span {
    uint32_t animation;
    double begin_s, end_s;
    uint32_t moments; /* at least 1 */
};

typedef void (*hatch_pose_visit)(void *context, const double point[3]);

/* Calls visit with the world position of every corner of every face but of backdrops, at every moment. The pose is at
 * the last moment then. */
enum hatch_status hatch_pose_each_corner(struct hatch_pose *pose, const struct hatch_pose_span *span,
                                         struct hatch_arena *scratch, hatch_pose_visit visit, void *context,
                                         struct hatch_err *err) HATCH_MUST_USE;

/* The box around all of it, as a centre and the radius around that. */
enum hatch_status hatch_pose_bounds(struct hatch_pose *pose, const struct hatch_pose_span *span,
                                    struct hatch_arena *scratch, struct hatch_bounds *bounds,
                                    struct hatch_err *err) HATCH_MUST_USE;

#endif
