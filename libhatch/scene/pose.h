/* A scene posed at one moment: node matrices, and vertices in world coordinates.
 *
 * World coordinates are doubles, so that scenes of any scale and at any distance from the origin keep their precision.
 * The GPU gets coordinates of the unit scene: (world - center) / radius. */
#ifndef HATCH_SCENE_POSE_H
#define HATCH_SCENE_POSE_H

#include <stdbool.h>

#include "scene/scene.h"

struct hatch_pose {
    const struct hatch_scene *scene;
    double *world;      /* world matrices: 16 per node, column-major */
    double *joints;     /* scratch: 16 per joint of the largest skin */
    double *weights;    /* scratch: one per morph target of the mesh that has most */
    uint32_t animation; /* index, or HATCH_NONE: the rest pose */
    double time_s;
};

/* Bounds of a scene in world coordinates; they define the unit scene. */
struct hatch_bounds {
    double center[3]; /* of the bounding box */
    double radius;    /* half the box's diagonal, over 0; 1 where empty */
    double half[3];   /* half the box's sides */
    bool empty;       /* the scene has no faces, no extent, or one that doubles cannot hold */
};

/* Converts a point from world coordinates to the unit scene.
 *   unit  out: may be world */
static inline void hatch_bounds_to_unit(const struct hatch_bounds *bounds, const double world[3], double unit[3])
{
    for (int k = 0; k < 3; k++)
        unit[k] = (world[k] - bounds->center[k]) / bounds->radius;
}

/* Allocates a pose, which hatch_pose_set fills.
 *   scene  kept by reference
 *   pose   out: its arrays are in arena */
enum hatch_status hatch_pose_make(const struct hatch_scene *scene, struct hatch_arena *arena, struct hatch_pose *pose,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* Computes the node matrices at a time.
 *   animation  index, or HATCH_NONE: the rest pose
 *   time_s     as for hatch_scene_pose */
void hatch_pose_set(struct hatch_pose *pose, uint32_t animation, double time_s);

/* Computes the vertices of a mesh of the scene, as a node poses it.
 *   positions  out: 3 per vertex, world coordinates
 *   normals    out: 3 per vertex, unit length, or 0 0 0 where undefined; NULL: not computed */
void hatch_pose_vertices(struct hatch_pose *pose, uint32_t node, uint32_t mesh, double *positions, float *normals);

/* Computes the vertices of a mesh that is not in the scene, as a node would pose it. Arguments as for
 * hatch_pose_vertices; normals are not written if the mesh has none. */
void hatch_pose_mesh(struct hatch_pose *pose, uint32_t node, const struct hatch_mesh *mesh, double *positions,
                     float *normals);

/* Computes a vertex's position or normal with morph targets applied.
 *   at_rest  3 per vertex
 *   moves    3 components per target; NULL: no targets
 *   weights  one per target */
void hatch_pose_morph(const float *at_rest, const struct hatch_mesh_attribute *moves, const double *weights,
                      size_t vertex, double out[3]);

/* Returns whether a skin or morph targets deform a mesh at a node. */
bool hatch_pose_deforms(const struct hatch_scene *scene, uint32_t node, const struct hatch_mesh *mesh);

/* Returns a node's world matrix, which places its meshes unless they are skinned.
 *   matrix  out: column-major */
void hatch_pose_matrix(const struct hatch_pose *pose, uint32_t node, double matrix[16]);

/* Computes the matrix that transforms normals: the cofactors of the upper left 3×3 part, with their signs changed if
 * the matrix mirrors, so that outward normals stay outward. Returns whether the matrix mirrors.
 *   matrix  column-major
 *   normal  out: column-major; it changes the lengths of normals */
bool hatch_pose_normal_matrix(const double matrix[16], double normal[9]);

/* Moments of an animation. */
struct hatch_pose_span {
    uint32_t animation;    /* index, or HATCH_NONE: the rest pose */
    const double *times_s; /* one per moment; NULL: all are 0 */
    uint32_t moments;      /* number of moments, at least 1 */
};

/* The pictures of a film. The time of each is begin_s + its number from 0 / rate. */
struct hatch_film {
    uint32_t animation; /* index, or HATCH_NONE: the rest pose */
    double begin_s;
    double rate;     /* frames per second, over 0 */
    uint32_t frames; /* number of pictures, at least 1 */
};

/* Chooses moments whose bounds are those of a whole film: the times of its pictures and of the keys that it passes,
 * each once although the animation repeats. Where a film is long or its meshes are large, times are left out evenly, so
 * that posing the scene at all moments takes bounded time; 17 are always left.
 *   span  out: its times, 0 .. the animation's duration and ascending, are in arena; a film of one picture or at rest
 *         has one moment */
enum hatch_status hatch_film_span(const struct hatch_scene *scene, const struct hatch_film *film,
                                  struct hatch_arena *arena, struct hatch_pose_span *span,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* A callback that receives a face corner in world coordinates; three successive calls are one face. */
typedef void (*hatch_pose_visit)(void *context, const double point[3]);

/* Calls visit for every corner of every face at every moment, except for faces of backdrops. Leaves the pose at the
 * last moment. */
enum hatch_status hatch_pose_each_corner(struct hatch_pose *pose, const struct hatch_pose_span *span,
                                         struct hatch_arena *scratch, hatch_pose_visit visit, void *context,
                                         struct hatch_err *err) HATCH_MUST_USE;

/* Computes the bounds of all faces at all moments, except for faces of backdrops. Leaves the pose at the last
 * moment. */
enum hatch_status hatch_pose_bounds(struct hatch_pose *pose, const struct hatch_pose_span *span,
                                    struct hatch_arena *scratch, struct hatch_bounds *bounds,
                                    struct hatch_err *err) HATCH_MUST_USE;

#endif
