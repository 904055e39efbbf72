/* What the files of lapped-param share. */
#ifndef LAPPED_PARAM_H
#define LAPPED_PARAM_H

#include "shared/cmd.h"
#include "lapped/lapped.h"
#include "scene/scene.h"

struct lapped_param_options {
    struct hatch_lapped_options lapped; /* size: as a share of the scene's diagonal, or 0 */
    double tile;                        /* a tile's side in the scene's units; 0: a share of its diagonal */
    double roughness, feather;
    uint32_t mask_px;
    bool atlas;
};

/* How large things are at rest, in the scene's units. */
struct lapped_param_extent {
    double diagonal; /* of the box around all that the nodes draw */
    double *scale;   /* per mesh: the scene's units for one of its own, where its first node puts it */
};

/* One mesh of the scene and what is made of it. */
struct lapped_param_part {
    const char *name; /* of the input, for messages */
    struct hatch_scene_mesh *mesh;
    const struct hatch_surface *surface;
    double size, tile; /* in the mesh's own terms */
    struct hatch_scene_mesh *made;
    uint32_t made_count;
    uint32_t patches, faces, patch_faces, cut, enlarged, hidden; /* figures for --verbose */
    uint64_t placed;
    double atlas_side; /* length of a unit of texture coordinates on the mesh; 0: no atlas */
};

/* Memory: args->keep. Dies on failure, as all of these do. */
void lapped_param_measure(struct cmd_args *args, const struct hatch_scene *scene, struct lapped_param_extent *extent);

/* Takes out of the scene what belongs to its old texture coordinates: those, tangents, and textures of
 * materials, about which it warns. Refuses a scene that is lapped. */
void lapped_param_clear(struct cmd_args *args, const char *name, struct hatch_scene *scene);

/* Fills the part's made and figures: a mesh for each patch, or one with an atlas. */
void lapped_param_cover(struct cmd_args *args, const struct lapped_param_options *options,
                        const struct hatch_outline *outline, struct lapped_param_part *part);

/* Puts what was made in place of the scene's meshes. */
void lapped_param_replace(struct cmd_args *args, struct hatch_scene *scene, const struct lapped_param_part *parts);

/* Gives all meshes materials that show them where the mask does, and the scene the mask as a PNG. */
void lapped_param_mask(struct cmd_args *args, const struct hatch_outline *outline, uint32_t side_px,
                       struct hatch_scene *scene);

#endif
