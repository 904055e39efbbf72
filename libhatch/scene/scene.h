/* A scene: what a glTF file describes, as values. Meshes, a tree of nodes, materials, cameras,
 * lights, animations, skins. Read by io/gltf/gltf.h, posed here. */
#ifndef HATCH_SCENE_SCENE_H
#define HATCH_SCENE_SCENE_H

#include "mesh/mesh.h"

#define HATCH_NONE UINT32_MAX /* an index that points to nothing */

/* What a texture is outside of 0..1. */
enum hatch_wrap { HATCH_WRAP_CLAMP, HATCH_WRAP_REPEAT, HATCH_WRAP_MIRROR };

/* Where a material reads one of its textures. */
struct hatch_texture_use {
    uint32_t texture;        /* index into textures, or HATCH_NONE */
    uint32_t texcoord;       /* n of TEXCOORD_n, at most HATCH_TEXCOORD_MAX */
    enum hatch_wrap wrap[2]; /* in u, in v */
    bool placed;             /* its coordinates are scaled, turned from v to u and moved by what follows */
    float scale[2], turn_rad, offset[2];
};

#define HATCH_TEXCOORD_MAX 9u

/* A texture of normals in the tangent frame (glTF 2.0, normalTextureInfo). */
struct hatch_normal_map {
    bool used; /* else nothing of it counts; its texture is then no index */
    struct hatch_texture_use at;
    float strength; /* factor for what leans along the surface */
};

struct hatch_material {
    float base_color[4]; /* linear, 0..1 */
    struct hatch_texture_use base;
    bool double_sided;
    float alpha_cutoff; /* 0: opaque; else texels below it are holes */
    bool blend;         /* the file blends them: what is less than half there is a hole, alpha_cutoff 1/2 */
    struct hatch_normal_map normals;
    bool outline; /* a lapped parametrization's: the alpha of base_texture, read with TEXCOORD_1,
                     is where a patch shows; its meshes are drawn in order over each other */
};

/* An encoded PNG or JPEG, as it stood in the file; owned by the arena. */
struct hatch_texture {
    const uint8_t *data; /* NULL where the image's own file could not be read: then no material uses it */
    size_t size;
};

struct hatch_scene_mesh {
    struct hatch_mesh mesh; /* one glTF primitive */
    uint32_t material;      /* or HATCH_NONE */
    uint32_t joints_used;   /* one more than the largest number in JOINTS_0; 0 without it */
    uint32_t file_vertices; /* vertices in the file: flat normals may have doubled some */
    bool had_texcoords;     /* TEXCOORD_0 stood in the file */
    bool had_normals;
    bool loose; /* the format has no way to say where faces meet: STL */
};

struct hatch_node {
    uint32_t parent; /* or HATCH_NONE; always lower than the node's own index */
    float translation[3], rotation[4] /* x y z w */, scale[3];
    float matrix[16]; /* column-major; used when has_matrix */
    bool has_matrix;
    uint32_t first_mesh, mesh_count; /* range of scene.meshes */
    float *weights;  /* of its meshes' morph targets at rest, beside those that the meshes have taken in;
                        NULL: 0 */
    uint32_t skin;   /* or HATCH_NONE */
    uint32_t camera; /* or HATCH_NONE */
    uint32_t light;  /* or HATCH_NONE */
    bool backdrop;   /* around what the scene is of: pictures need not show all of it */
};

struct hatch_camera {
    bool orthographic;
    float yfov_rad;    /* perspective: 0 .. π */
    float ymag;        /* orthographic: half the height */
    float aspect;      /* width over height; 0: the picture's */
    float znear, zfar; /* zfar 0: infinite */
};

enum hatch_light_type { HATCH_LIGHT_DIRECTIONAL, HATCH_LIGHT_POINT, HATCH_LIGHT_SPOT };

struct hatch_light {
    enum hatch_light_type type;
    float color[3];  /* linear */
    float intensity; /* lux for directional, candela else */
    float range;     /* 0: unlimited */
    float inner_cone_rad, outer_cone_rad;
};

struct hatch_skin {
    uint32_t joint_count;
    uint32_t *joints;    /* node indices */
    float *inverse_bind; /* 16 floats each, column-major */
};

enum hatch_channel_path { HATCH_PATH_TRANSLATION, HATCH_PATH_ROTATION, HATCH_PATH_SCALE, HATCH_PATH_WEIGHTS };
enum hatch_interpolation { HATCH_STEP, HATCH_LINEAR, HATCH_CUBIC };

struct hatch_animation_channel {
    uint32_t node;
    enum hatch_channel_path path;
    enum hatch_interpolation interpolation;
    uint32_t key_count;
    float *times_s;   /* rising; of equal ones the last counts */
    float *values;    /* its width of floats a key; for CUBIC three such groups a key */
    uint32_t targets; /* of weights: as many as the node's meshes have */
};

/* Numbers of one value. */
static inline uint32_t hatch_channel_width(const struct hatch_animation_channel *channel)
{
    return channel->path == HATCH_PATH_WEIGHTS ? channel->targets : channel->path == HATCH_PATH_ROTATION ? 4 : 3;
}

struct hatch_animation {
    uint32_t channel_count;
    struct hatch_animation_channel *channels;
    float duration_s;
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
};

/* A scene of one node with one mesh, whose arrays stay the mesh's. */
enum hatch_status hatch_scene_of_mesh(const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                      struct hatch_scene *scene, struct hatch_err *err) HATCH_MUST_USE;

/* The world matrix of every node, column-major, 16 floats each, at time_s of the given animation
 * (HATCH_NONE: the rest pose). Times beyond the animation's end are wrapped into it. A matrix of
 * negative determinant mirrors: the renderer then takes clockwise faces for front faces.
 * world: 16 * node_count floats. */
void hatch_scene_pose(const struct hatch_scene *scene, uint32_t animation, double time_s, float *world);

/* How far the morph targets of a node's meshes count at that time. weights: count of them. */
void hatch_scene_weights(const struct hatch_scene *scene, uint32_t node, uint32_t animation, double time_s,
                         uint32_t count, double *weights);

/* The skinning matrices of a node's skin (glTF 2.0 §3.7.3): joint world × inverse bind, to be applied
 * instead of the node's own matrix. joints: 16 * joint_count floats. */
void hatch_scene_skin(const struct hatch_scene *scene, uint32_t skin, const float *world, float *joints);

/* Everything that the nodes draw at rest as one mesh in world space: POSITION, and NORMAL and
 * TEXCOORD_0 where all meshes have them; skinned meshes as they were bound. Under a matrix that mirrors
 * faces are turned round, so that they stay counter-clockwise. HATCH_BAD_INPUT for a scene without
 * faces; HATCH_LIMIT when its instances are too many. */
enum hatch_status hatch_scene_flatten(const struct hatch_scene *scene, struct hatch_arena *arena,
                                      struct hatch_arena *scratch, struct hatch_mesh *mesh,
                                      struct hatch_err *err) HATCH_MUST_USE;

#endif
