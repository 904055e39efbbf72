/* A scene with the content of a glTF file: meshes, a tree of nodes, materials, cameras, lights, animations, skins.
 * io/gltf/gltf.h reads it; all arrays are owned by the reader's arena. */
#ifndef HATCH_SCENE_SCENE_H
#define HATCH_SCENE_SCENE_H

#include "curve/curves.h"

#define HATCH_NONE UINT32_MAX /* an index that refers to nothing */

/* Name and extras of an object of a glTF file, kept for writing. Zeroed: none. */
struct hatch_kept {
    const char *name;   /* UTF-8; may be NULL */
    const char *extras; /* JSON, without the members that the writer adds itself; may be NULL */
};

/* Texture wrapping outside of 0 .. 1. */
enum hatch_wrap { HATCH_WRAP_CLAMP, HATCH_WRAP_REPEAT, HATCH_WRAP_MIRROR };

/* A reference of a material to a texture. */
struct hatch_texture_use {
    uint32_t texture;        /* index into scene.textures, or HATCH_NONE */
    uint32_t texcoord;       /* n of TEXCOORD_n, at most HATCH_TEXCOORD_MAX */
    enum hatch_wrap wrap[2]; /* of u, of v */
    bool has_transform;      /* coordinates are scaled, then rotated, then moved; false: the members below are unset */
    float scale[2], turn_rad, offset[2]; /* turn_rad: rotates v towards u */
    int filters[2]; /* for writing: the numbers that glTF gives to filters for magnification and minification; 0: linear
                       and trilinear */
    struct hatch_kept kept, sampler; /* of the glTF texture and of its sampler */
};

#define HATCH_TEXCOORD_MAX 9u

/* Objects of a glTF material: itself, its pbrMetallicRoughness, its extensions. */
enum hatch_material_part { HATCH_PART_MATERIAL, HATCH_PART_PBR, HATCH_PART_EXTENSIONS };

/* A member of a glTF material that hatching does not need, kept for writing. */
struct hatch_kept_member {
    enum hatch_material_part part;
    const char *text; /* key and value as JSON; each HATCH_KEPT_USE in it stands for the members of a texture's use */
    const struct hatch_texture_use *uses;
    uint32_t use_count;
};

#define HATCH_KEPT_USE '\1' /* JSON does not contain it */

/* A normal map in tangent space (glTF 2.0, normalTextureInfo). */
struct hatch_normal_map {
    bool used; /* false: the other members are unset */
    struct hatch_texture_use at;
    float strength; /* factor of the tangential components of its normals */
};

struct hatch_material {
    float base_color[4]; /* linear, 0..1 */
    struct hatch_texture_use base;
    bool double_sided;
    float alpha_cutoff; /* texels with less alpha are holes; 0: opaque */
    bool blend;         /* the file asks for alpha blending, which is replaced by alpha_cutoff 1/2 */
    struct hatch_normal_map normals;
    bool outline; /* of lapped textures: the alpha of base, read with TEXCOORD_1, is the patch outline; the material's
                     meshes are patches, drawn in order over each other */
    struct hatch_kept kept;
    struct hatch_kept_member *members;
    uint32_t member_count;
    bool keeps_metal; /* whether members tell how metallic it is, a missing metallicFactor being 1; false: not at all */
};

/* An encoded PNG, JPEG or WebP image, copied from the file. */
struct hatch_texture {
    const uint8_t *data; /* NULL where the image's own file could not be read; no material refers to it then */
    size_t size;
    struct hatch_kept kept;
};

struct hatch_scene_mesh {
    struct hatch_mesh mesh;     /* one glTF primitive */
    uint32_t material;          /* index, or HATCH_NONE */
    uint32_t joints_used;       /* largest index of a joint in the file plus 1; 0 without joints */
    uint32_t file_vertices;     /* vertices in the file; computing flat normals may have duplicated some */
    const uint32_t *numbers;    /* per vertex, its number in the file, where copies have that of their original; NULL:
                                   its index */
    uint32_t numbers_end;       /* with numbers: 1 more than the highest that a vertex of the file has */
    uint64_t file_first;        /* number of the first vertex, counted through all meshes of the file; for dirfield */
    bool had_texcoords;         /* the file has TEXCOORD_0 */
    bool had_normals;           /* the file has NORMAL; else normals were computed from the faces */
    bool normals_computed;      /* NORMAL, if the mesh has it, follows from the faces, and tells nothing else: the file
                                   has none, or it was written by a command that computed it */
    bool is_soup;               /* unconnected triangles, as in STL: the format cannot share vertices */
    float unseen_tolerance;     /* over 0: made for views that do not show it, within this tolerance (needs(5)) */
    struct hatch_curves curves; /* strokes on the mesh; zeroed: none */
    struct hatch_kept kept;     /* of the primitive */
    struct hatch_kept whole; /* of the glTF mesh that has it; meshes of one node are written with that of the first */
};

#define HATCH_NEEDLE 1000 /* ratio of a face's longest edge to its height over which it is a needle */

struct hatch_node {
    uint32_t parent; /* lower than the node's own index, or HATCH_NONE */
    double translation[3], rotation[4] /* x y z w */, scale[3];
    double matrix[16];               /* column-major; see has_matrix */
    bool has_matrix;                 /* matrix replaces translation, rotation and scale */
    uint32_t first_mesh, mesh_count; /* range in scene.meshes */
    float *weights;  /* rest weights of its meshes' morph targets, less those already applied; NULL: all 0 */
    uint32_t skin;   /* index, or HATCH_NONE */
    uint32_t camera; /* index, or HATCH_NONE */
    uint32_t light;  /* index, or HATCH_NONE */
    bool backdrop;   /* not part of the scene's bounds, and not framed by views */
    struct hatch_kept kept;
};

struct hatch_camera {
    bool orthographic;
    float yfov_rad;    /* perspective: vertical field of view, over 0 .. π */
    float ymag;        /* orthographic: half the height, world units */
    float aspect;      /* width / height; 0: the picture's */
    float znear, zfar; /* distances, world units; zfar 0: infinite */
    struct hatch_kept kept;
};

enum hatch_light_type { HATCH_LIGHT_DIRECTIONAL, HATCH_LIGHT_POINT, HATCH_LIGHT_SPOT };

struct hatch_light {
    enum hatch_light_type type;
    float color[3];                       /* linear RGB */
    float intensity;                      /* lux (directional) or candela (point, spot) */
    float range;                          /* distance beyond which there is no light, world units; 0: unlimited */
    float inner_cone_rad, outer_cone_rad; /* of a spot: angles from its axis */
    struct hatch_kept kept;
};

struct hatch_skin {
    uint32_t joint_count;
    uint32_t *joints;    /* node index of each joint */
    float *inverse_bind; /* inverse bind matrices: 16 per joint, column-major */
    struct hatch_kept kept;
};

enum hatch_channel_path { HATCH_PATH_TRANSLATION, HATCH_PATH_ROTATION, HATCH_PATH_SCALE, HATCH_PATH_WEIGHTS };
enum hatch_interpolation { HATCH_STEP, HATCH_LINEAR, HATCH_CUBIC };

struct hatch_animation_channel {
    uint32_t node;
    enum hatch_channel_path path;
    enum hatch_interpolation interpolation;
    uint32_t key_count;
    float *times_s;   /* per key, ascending; where several keys have the same time, the last of them is used */
    float *values;    /* hatch_channel_width floats per key; HATCH_CUBIC: in-tangent, value, out-tangent per key */
    uint32_t targets; /* HATCH_PATH_WEIGHTS: number of morph targets of the node's meshes */
};

/* Returns the number of floats in one value of a channel. */
static inline uint32_t hatch_channel_width(const struct hatch_animation_channel *channel)
{
    return channel->path == HATCH_PATH_WEIGHTS ? channel->targets : channel->path == HATCH_PATH_ROTATION ? 4 : 3;
}

struct hatch_animation {
    uint32_t channel_count;
    struct hatch_animation_channel *channels;
    float duration_s; /* time of the last key of all channels */
    struct hatch_kept kept;
};

/* Levels of detail of a node's meshes, for writing: nodes with coarser meshes that stand for the node when it is small
 * in the picture (the extension MSFT_lod). They are not part of the scene; hatch_gltf_read does not read them. */
struct hatch_lod {
    uint32_t node;
    uint32_t first, count; /* the coarser nodes, which have no parent */
    const float *coverage; /* count + 1: share of the picture down to which the node and each coarser one are drawn */
};

struct hatch_scene {
    uint32_t mesh_count, node_count, material_count, texture_count;
    uint32_t camera_count, light_count, skin_count, animation_count;
    struct hatch_scene_mesh *meshes;
    struct hatch_node *nodes;
    struct hatch_material *materials;
    struct hatch_texture *textures;
    struct hatch_camera *cameras;
    struct hatch_light *lights;
    struct hatch_skin *skins;
    struct hatch_animation *animations;
    struct hatch_lod *lods; /* ascending by node */
    uint32_t lod_count;
    float rounding;    /* for writing: over 0: normals, directions and texture coordinates may be integers; of vectors
                          none is then off by more than this, of texture coordinates by more than 1 / 65534 */
    bool up_undefined; /* from a format that does not define which axis points up: one node with one mesh */
    struct hatch_kept kept;  /* of the glTF scene */
    struct hatch_kept asset; /* of the file; name: its copyright */
};

/* Makes a scene of one node with one mesh, which shares the arrays of `mesh`. */
enum hatch_status hatch_scene_of_mesh(const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                      struct hatch_scene *scene, struct hatch_err *err) HATCH_MUST_USE;

/* Makes nodes draw the meshes that have taken the place of theirs.
 *   first  per mesh and one more: the number of the first of those that take its place; rising */
void hatch_scene_renumber(struct hatch_scene *scene, const uint32_t *first);

/* Leaves meshes out of a scene, in place; nodes draw what is left of theirs.
 *   kept   per mesh: whether it stays
 *   first  out: per mesh and one more, as for hatch_scene_renumber */
void hatch_scene_keep(struct hatch_scene *scene, const bool *kept, uint32_t *first);

/* Returns a time of an animation, which repeats, within 0 .. duration_s. */
double hatch_animation_wrap(const struct hatch_animation *animation, double time_s);

/* Computes the world matrix of every node at a time of an animation. A matrix with a negative determinant mirrors;
 * front faces are then clockwise.
 *   animation  index, or HATCH_NONE: the rest pose
 *   time_s     any time; wrapped by hatch_animation_wrap
 *   world      out: 16 per node, column-major */
void hatch_scene_pose(const struct hatch_scene *scene, uint32_t animation, double time_s, double *world);

/* Computes the weights of the morph targets of a node's meshes at a time of an animation.
 *   animation, time_s  as for hatch_scene_pose
 *   count              of morph targets
 *   weights            out: one per morph target */
void hatch_scene_weights(const struct hatch_scene *scene, uint32_t node, uint32_t animation, double time_s,
                         uint32_t count, double *weights);

/* Computes the skinning matrices of a skin (glTF 2.0 §3.7.3): joint world matrix × inverse bind matrix. They replace
 * the matrix of the skinned node.
 *   world   from hatch_scene_pose
 *   joints  out: 16 per joint, column-major */
void hatch_scene_skin(const struct hatch_scene *scene, uint32_t skin, const double *world, double *joints);

/* Joins the meshes of all nodes at rest into one mesh in world coordinates, relative to an origin: floats are precise
 * near it only. It has POSITION, and NORMAL and TEXCOORD_0 if all meshes have them. Under the mirroring matrix of a
 * node the winding of faces is reversed, so that they stay counter-clockwise.
 *   origin  of the mesh, in the world
 *   skins   skinned meshes have the pose that their skins give them at rest, not their bind pose
 *   mesh    out: in arena
 * HATCH_BAD_INPUT for a scene without faces; HATCH_LIMIT also if there are too many faces for one mesh. */
enum hatch_status hatch_scene_flatten(const struct hatch_scene *scene, const double origin[3], bool skins,
                                      struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_mesh *mesh,
                                      struct hatch_err *err) HATCH_MUST_USE;

/* Counts in notes what a scene may have been meant otherwise: see struct hatch_mesh_notes. Changes nothing. Normals are
 * not looked at where scratch has no memory for it. */
void hatch_scene_doubt(const struct hatch_scene *scene, struct hatch_arena *scratch, struct hatch_mesh_notes *notes);

#endif
