/* Lapped textures: a file has a mesh for each patch, often thousands. Here the patches of a node are joined into one
 * mesh, and the surface that they cover is rebuilt by keeping each face once, however many patches contain it. */
#ifndef HATCH_SCENE_PATCHES_H
#define HATCH_SCENE_PATCHES_H

#include "scene/scene.h"

/* The patches of one mesh of a scene. */
struct hatch_patch_mesh {
    uint32_t patch_count;   /* 0: an ordinary mesh; all other members are zero */
    uint32_t *first_vertex; /* per patch: its first vertex in the joined mesh; then the number of all vertices */
    uint32_t layer_count;
    uint32_t *layer_end;       /* per layer: one past its last index in the index buffer of the joined mesh */
    struct hatch_mesh surface; /* the covered surface: each face and vertex once, without texture coordinates */
    uint32_t *vertex_of;       /* per vertex of the surface: a vertex of the joined mesh at the same position */
};

/* Joins successive meshes of a node that share a material with a patch outline, and renumbers the scene's meshes.
 * Patches are put into layers in which none overlap, so that each layer can be drawn at once; overlapping patches keep
 * their drawing order. Faces on the same points begin with the same point in every patch, so that their depths are
 * equal to the last bit.
 *   scene    its meshes are replaced, and the mesh ranges of its nodes adjusted
 *   patches  out: an entry per mesh of the changed scene, in arena
 *   numbers  out: per mesh of the scene as it was, its number now, in arena; NULL: not wanted */
enum hatch_status hatch_patches_join(struct hatch_scene *scene, struct hatch_arena *arena, struct hatch_arena *scratch,
                                     struct hatch_patch_mesh **patches, uint32_t **numbers,
                                     struct hatch_err *err) HATCH_MUST_USE;

#endif
