/* The scene on the GPU: one vertex and index buffer per mesh, one item per place where a node shows
 * a mesh. */
#ifndef RENDER_SCENE_H
#define RENDER_SCENE_H

#include <epoxy/gl.h>

#include "lapped/patches.h"
#include "scene/pose.h"

/* What the vertex stage reads; 40 bytes. */
struct vertex {
    float position[3]; /* minus the mesh's origin; of a posed item: in the unit scene */
    float normal[3];
    float texcoord[2];
    float base_texcoord[2];
};

/* Places among the vertex stage's inputs. */
#define REPEAT_ATTRIBUTE 4u
#define PATCH_ATTRIBUTE 5u
#define SPANS_ATTRIBUTE 6u   /* and 7 */
#define TANGENT_ATTRIBUTE 8u /* and 9: where the normals' texture is read */

struct gpu_mesh {
    GLuint vertices, indices;
    uint32_t index_count;
    double origin[3];                       /* the middle of its box: digits that floats need not carry */
    double half[3];                         /* of the box's sides */
    const struct hatch_mesh *surface;       /* what is there to see: without the overlaps of patches */
    const struct hatch_patch_mesh *patches; /* NULL: an ordinary mesh */
    GLuint surface_indices;                 /* with patches: of the surface's faces */
    GLuint patch_tones;                     /* a random tone for each vertex, its patch's; 0: not told yet */
};

struct gpu_item {
    uint32_t mesh, node;
    GLuint vertex_array;
    GLuint surface_array; /* with patches: of the surface's faces; else 0 */
    GLuint posed;         /* own vertices of what skins or morph targets shape, renewed with the pose; else 0 */
    float to_unit[16];    /* what the buffer holds, to the unit scene; column-major */
    float normal[9];
    GLuint repeats;         /* two floats a vertex: tiles of the tonal art map per unit of u and of v;
                               0: `repeat` for all */
    GLuint spans;           /* six floats a vertex: the surface along a unit of u and of v; 0: not set */
    uint32_t repeats_set;   /* how often repeats were */
    float repeat[2];        /* that of the largest chart */
    uint32_t chart_count;   /* parts of the surface that have repeats of their own */
    double low[3], high[3]; /* of its box in the unit scene */
    double uv_reach;        /* how far texture coordinates' 0 0 may be from where they are used, in the mesh */
    bool mirrored;          /* the node turns the faces' winding round */
    bool double_sided;
    float alpha_cutoff;         /* 0: no holes */
    GLuint base_texture;        /* 0: none; of patches their outline, alone in red */
    float base_side_px;         /* its longer side */
    float base_alpha;           /* the least alpha in it */
    float base_lod;             /* the level of it that is as coarse as the vertices are */
    GLuint normals;             /* a texture of them; 0: none */
    GLuint tangents;            /* struct tangent of each vertex; 0: none */
    const struct tangent *rest; /* the same, not posed */
    float normals_strength;
    float base_lightness; /* luminance of the material's colour, 1 when it does not count */
};

struct gpu_scene {
    const struct hatch_scene *scene;
    struct hatch_bounds bounds;
    struct hatch_pose pose;
    uint32_t pose_number; /* another one when the pose may have changed */
    uint32_t animation;   /* the pose's moment */
    double time_s;
    uint32_t item_count;
    struct gpu_mesh *meshes; /* scene->mesh_count */
    struct gpu_item *items;
};

/* Where a texture is read: scaled, turned, moved (KHR_texture_transform). */
void scene_place(const float scale[2], float turn_rad, const float offset[2], float at[2]);

/* TEXCOORD_n, or NULL. set: at most HATCH_TEXCOORD_MAX. */
const float *scene_texcoords(const struct hatch_mesh *mesh, uint32_t set);

/* Uploads every mesh and lists the items; pose must hold room. Nothing is drawn with: call
 * scene_set_pose. patches: of each mesh, or NULL where no mesh has any; kept. */
enum hatch_status scene_upload(const struct hatch_scene *scene, const struct hatch_patch_mesh *patches,
                               const struct hatch_bounds *bounds, struct hatch_arena *arena,
                               struct hatch_arena *scratch, struct gpu_scene *gpu,
                               struct hatch_err *err) HATCH_MUST_USE;

/* Moves the items to a moment of an animation (HATCH_NONE: the rest pose). */
enum hatch_status scene_set_pose(struct gpu_scene *gpu, uint32_t animation, double time_s, struct hatch_arena *scratch,
                                 struct hatch_err *err) HATCH_MUST_USE;

/* Gives the vertices of an item repeats of their own; count of them. NULL takes them away. */
void scene_set_repeats(struct gpu_item *item, const float *repeats, uint32_t count);

/* Gives the vertices of an item their spans; count of them. */
void scene_set_spans(struct gpu_item *item, const float *spans, uint32_t count);

/* Gives the vertices of patches a tone each, by which patches can be told apart. Again is cheap. */
enum hatch_status scene_tell_patches(struct gpu_scene *gpu, struct hatch_arena *scratch,
                                     struct hatch_err *err) HATCH_MUST_USE;

void scene_free(struct gpu_scene *gpu);

#endif
