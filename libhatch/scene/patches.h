/* Lapped parametrizations: a file has a mesh for each patch, thousands of them; here those of a node
 * become one mesh, and the surface that they cover is told from their overlaps. */
#ifndef HATCH_SCENE_PATCHES_H
#define HATCH_SCENE_PATCHES_H

#include "scene/scene.h"

/* What belongs to one of a scene's meshes. */
struct hatch_patch_mesh {
    uint32_t patch_count;   /* 0: an ordinary mesh, and nothing else here is set */
    uint32_t *first_vertex; /* of each patch in the joined mesh, and the end of the last */
    uint32_t layer_count;
    uint32_t *layer_end;       /* of each layer's indices in the joined mesh */
    struct hatch_mesh surface; /* each face and vertex once, without texture coordinates */
    uint32_t *vertex_of;       /* of each of the surface's vertices: one in the joined mesh */
};

/* Joins meshes that follow one another in a node and share a material with an outline; nodes and
 * meshes of the scene are numbered anew. Patches keep their drawing order where they overlap. They are
 * sorted into layers in which none overlaps another, so that a layer can be drawn at once. Faces on the
 * same points begin with the same one in every patch, so that their depths are equal to the last bit.
 * *patches: of each of the scene's meshes then. */
enum hatch_status hatch_patches_join(struct hatch_scene *scene, struct hatch_arena *arena, struct hatch_arena *scratch,
                                     struct hatch_patch_mesh **patches, struct hatch_err *err) HATCH_MUST_USE;

#endif
