/* The scene on the GPU: buffers of each mesh, vertex arrays and textures of each item. */
#ifndef RENDER_SCENE_SCENE_H
#define RENDER_SCENE_SCENE_H

#include <epoxy/gl.h>

#include "scene/unit_scene.h"

/* A vertex as the vertex stage reads it; 40 bytes. */
struct scene_vertex {
    float position[3]; /* minus the mesh's origin; of a deformed item: in the unit scene */
    float normal[3];
    float texcoord[2];
    float base_texcoord[2];
};

/* Slots of items' vertex arrays, one for each buffer. */
enum { SCENE_SLOT_VERTICES, SCENE_SLOT_REPEATS, SCENE_SLOT_PATCHES, SCENE_SLOT_UV_TANGENTS, SCENE_SLOT_TANGENTS };

struct scene_mesh {
    GLuint vertices, indices;
    uint32_t index_count;
    GLuint surface_indices; /* of a lapped mesh: of the surface's faces; else 0 */
    GLuint patch_tones;     /* of a lapped mesh: a tone per vertex; 0: unset */
};

struct scene_item {
    GLuint vertex_array;
    GLuint surface_array; /* of a lapped mesh: of the surface's faces; else 0 */
    GLuint posed;         /* own vertices of a deformed item, renewed with the pose; else 0 */
    GLuint repeats;       /* two floats per vertex: struct hatch_item's; 0: its repeat for all */
    GLuint uv_tangents;   /* six floats per vertex: hatch_uv_tangents; 0: unset */
    GLuint base_texture;  /* the material's; of a lapped mesh the patches' outline, in red; 0: none */
    float base_side_px;   /* its longer side */
    float base_alpha;     /* the least alpha in it */
    float base_lod;       /* the level of it that is as coarse as the vertices are */
    float base_lightness; /* luminance of the material's colour; 1 where it does not count */
    GLuint normals;       /* normal map; 0: none */
    float normals_strength;
    GLuint tangents;                  /* struct scene_tangent per vertex; 0: none */
    const struct scene_tangent *rest; /* the same at rest */
};

/* items and meshes have the numbers of unit's. */
struct scene {
    struct hatch_unit_scene unit;
    struct scene_mesh *meshes;
    struct scene_item *items;
};

/* A scene as values. */
struct scene_source {
    const struct hatch_scene *scene;        /* kept by reference */
    const struct hatch_patch_mesh *patches; /* of each of its meshes, or NULL; kept by reference */
    struct hatch_bounds bounds;             /* of all moments that will be drawn */
};

/* Uploads every mesh and lists the items. Nothing is posed yet: call scene_set_pose.
 *   arena  keeps the lists
 * HATCH_LIMIT when memory, the GPU's too, does not suffice. */
enum hatch_status scene_upload(const struct scene_source *source, struct hatch_arena *arena,
                               struct hatch_arena *scratch, struct scene *scene, struct hatch_err *err) HATCH_MUST_USE;

/* Builds the vertices of a mesh.
 *   origin  subtracted from positions */
enum hatch_status scene_make_vertices(const struct hatch_scene *scene, uint32_t mesh, const double origin[3],
                                      struct hatch_arena *arena, struct scene_vertex **vertices,
                                      struct hatch_err *err) HATCH_MUST_USE;

/* Moves texture coordinates to where a texture is read (KHR_texture_transform). */
void scene_place_texcoord(const struct hatch_texture_use *use, float at[2]);

/* TEXCOORD_n, or NULL. set: at most HATCH_TEXCOORD_MAX. */
const float *scene_texcoords(const struct hatch_mesh *mesh, uint32_t set);

/* Releases everything, textures too; leaves *scene zeroed. */
void scene_free(struct scene *scene);

#endif
