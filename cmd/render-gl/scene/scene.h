/* The scene on the GPU: buffers of each mesh, vertex arrays and textures of each item. An item is a mesh placed by a
 * node; a deformed item has a skin or morph targets, so that its vertices move with the pose. A lapped mesh consists of
 * the patches of a lapped texture (scene/patches.h). The unit scene is the world, moved and scaled so that the scene
 * has radius 1 around the origin (scene/unit_scene.h). */
#ifndef RENDER_SCENE_SCENE_H
#define RENDER_SCENE_SCENE_H

#include <epoxy/gl.h>

#include "scene/unit_scene.h"

/* A vertex as shaders read it; 40 bytes. */
struct scene_vertex {
    float position[3];      /* in mesh space relative to the mesh's origin (a deformed item: in the unit scene) */
    float normal[3];        /* in mesh space (a deformed item: in the unit scene); of any length */
    float texcoord[2];      /* TEXCOORD_0, which strokes follow */
    float base_texcoord[2]; /* where the base-colour texture, or the patch outline, is read */
};

/* Buffer slots of an item's vertex arrays (gpu_array_attach). */
enum {
    SCENE_SLOT_VERTICES,
    SCENE_SLOT_REPEATS,
    SCENE_SLOT_PATCHES,
    SCENE_SLOT_UV_TANGENTS,
    SCENE_SLOT_TANGENTS,
    SCENE_SLOT_CHARTS,
    SCENE_SLOT_REST
};

/* Buffers of a mesh. */
struct scene_mesh {
    GLuint vertices; /* struct scene_vertex */
    GLuint indices;  /* index_count of them, three per face; for a lapped mesh, the faces of its patches */
    uint32_t index_count;
    GLuint surface_indices; /* for a lapped mesh: indices of the surface below the patches; else 0 */
    GLuint patch_tones;     /* for a lapped mesh: tone per vertex, 0 .. 1; 0: not made */
    GLuint charts;          /* number of each vertex's chart, or of its patch; 0: not made */
};

/* Vertex arrays, buffers and textures of an item. Items may share textures. */
struct scene_item {
    GLuint vertex_array;              /* vertex array with the mesh's indices */
    GLuint surface_array;             /* vertex array with surface_indices; 0: the mesh is not lapped */
    GLuint posed;                     /* for a deformed item: struct scene_vertex at the current pose; else 0 */
    GLuint repeats;                   /* 2 floats per vertex: hatch_item's repeats; 0: repeat applies to all vertices */
    GLuint uv_tangents;               /* 6 floats per vertex: hatch_uv_tangents; 0: not made */
    GLuint base_texture;              /* base-colour texture; of a lapped mesh the patch outline, in red; 0: none */
    float base_side_px;               /* longer side of base_texture */
    float base_alpha;                 /* smallest alpha in base_texture */
    float base_lod;                   /* mip level of base_texture that is about as coarse as the mesh's vertices */
    float base_color[3];              /* the material's colour, linear; white without a material */
    float base_lightness;             /* luminance of the material's colour, 0 .. 1; 1 without a material */
    GLuint normals;                   /* normal map; 0: none */
    float normals_strength;           /* factor for x and y of the normal map */
    GLuint tangents;                  /* struct scene_tangent per vertex; 0: none */
    const struct scene_tangent *rest; /* the tangents at rest; NULL: none */
};

/* Repeats of an item: members of struct hatch_item. */
struct scene_repeats {
    float repeat[2], *repeats;
    uint32_t chart_count;
};

struct scene {
    struct hatch_unit_scene unit;
    struct scene_mesh *meshes;    /* one per unit.meshes */
    struct scene_item *items;     /* one per unit.items */
    struct scene_repeats *others; /* one per item: repeats that are not in use; NULL: none */
    bool replaced;                /* these are those of the map (scene_replace_repeats) */
};

/* Uploads all meshes of a scene and lists its items. The scene is not posed yet: call scene_set_pose next.
 *   from     kept by reference
 *   patches  one per mesh; NULL: no mesh is lapped; kept by reference
 *   bounds   bounds of all poses that will be drawn
 *   arena    holds the lists of meshes and items
 * HATCH_LIMIT when main memory or the GPU's memory does not suffice. */
enum hatch_status scene_upload(const struct hatch_scene *from, const struct hatch_patch_mesh *patches,
                               const struct hatch_bounds *bounds, struct hatch_arena *arena,
                               struct hatch_arena *scratch, struct scene *scene, struct hatch_err *err) HATCH_MUST_USE;

/* Builds the vertices of a mesh.
 *   mesh      index in scene->meshes
 *   origin    subtracted from the positions
 *   vertices  out: vertex_count entries, in arena */
enum hatch_status scene_make_vertices(const struct hatch_scene *scene, uint32_t mesh, const double origin[3],
                                      struct hatch_arena *arena, struct scene_vertex **vertices,
                                      struct hatch_err *err) HATCH_MUST_USE;

/* Applies a texture's KHR_texture_transform to texture coordinates.
 *   at  in, out */
void scene_place_texcoord(const struct hatch_texture_use *use, float at[2]);

/* Returns a mesh's TEXCOORD_n, two floats per vertex; NULL: the mesh has none.
 *   set  n, at most HATCH_TEXCOORD_MAX */
const float *scene_texcoords(const struct hatch_mesh *mesh, uint32_t set);

/* Releases all buffers, arrays and textures; leaves *scene zeroed. */
void scene_free(struct scene *scene);

#endif
