/* Declarations shared by the files of lapped-param. Functions allocate in args->keep and end the process on failure. */
#ifndef LAPPED_PARAM_LAPPED_PARAM_H
#define LAPPED_PARAM_LAPPED_PARAM_H

#include "shared/cmd.h"
#include "lapped/lapped.h"
#include "scene/scene.h"

struct lapped_param_options {
    struct hatch_lapped_options lapped; /* its size is a share of the scene's diagonal, or 0 */
    double tile;               /* side of a tile in the scene's units; 0: the default share of the scene's diagonal */
    double roughness, feather; /* as in hatch_outline_make */
    uint32_t mask_px;          /* width and height of the outline's image */
    bool atlas;                /* make one atlas per mesh in place of patches */
};

/* A mesh of the scene and the meshes made from it. */
struct lapped_param_part {
    const char *name; /* name of the input, for messages */
    struct hatch_scene_mesh *mesh;
    const struct hatch_surface *surface;
    double size, tile; /* patch diameter as a share of the mesh's diagonal; side of a tile in the mesh's units */
    struct hatch_scene_mesh *made; /* one mesh per patch, or a single mesh with an atlas */
    uint32_t made_count;
    uint32_t patches, faces, patch_faces, cut, enlarged; /* counts for --verbose */
    uint64_t solved_faces;
    double outline_side; /* greatest side of the square of a patch's outline, in the mesh's units; 0: no patch */
    double atlas_side;   /* side of the atlas on the mesh, in the scene's units; 0: no atlas */
};

/* Removes the old texture coordinates of the scene, and the tangents and textures that depend on them; warns of the
 * textures. Normal maps stay, and so do their tangents; their texture coordinates become TEXCOORD_2. A scene that
 * lapped-param has made is an error.
 *   atlas  whether meshes get an atlas, with which materials keep their alpha; for patches they become opaque, or
 *          invisible if their alpha is below their cutoff */
void lapped_param_clear(struct cmd_args *args, const char *name, bool atlas, struct hatch_scene *scene);

/* Covers a mesh with patches; fills the members of part from made on. */
void lapped_param_cover(struct cmd_args *args, const struct lapped_param_options *options,
                        const struct hatch_outline *outline, struct lapped_param_part *part);

/* Removes texture coordinates, tangents, and a _HATCH_DIR that does not have four components. If the mesh has a normal
 * map, keeps its tangents and the texture coordinates of the map.
 *   normals  NULL: the mesh has no normal map */
void lapped_param_clear_mesh(struct hatch_mesh *mesh, const struct hatch_normal_map *normals, bool atlas);

/* Keeps a mesh that no view shows without patches, with texture coordinates that repeat over two axes. */
void lapped_param_keep(struct cmd_args *args, struct lapped_param_part *part);

/* Replaces the scene's meshes by those made from them. */
void lapped_param_replace(struct cmd_args *args, struct hatch_scene *scene, const struct lapped_param_part *parts);

/* Adds the outline to the scene as a PNG texture that all materials read with TEXCOORD_1. */
void lapped_param_mask(struct cmd_args *args, const struct hatch_outline *outline, uint32_t side_px,
                       struct hatch_scene *scene);

#endif
