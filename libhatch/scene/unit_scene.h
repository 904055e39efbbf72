/* A scene as it is drawn: an item for each place where a node shows a mesh, posed, in the unit scene.
 *
 * World coordinates are doubles, so that scenes of any scale and at any distance from the origin keep their digits.
 * The unit scene is (world - center) / radius of the scene's bounds: what floats and GPUs see. */
#ifndef HATCH_SCENE_UNIT_SCENE_H
#define HATCH_SCENE_UNIT_SCENE_H

#include "scene/patches.h"
#include "scene/pose.h"

/* A mesh as its items share it. */
struct hatch_unit_mesh {
    const struct hatch_mesh *mesh;          /* all faces; of a lapped mesh those of all patches */
    const struct hatch_mesh *surface;       /* each face of the surface once: patches overlap */
    const struct hatch_patch_mesh *patches; /* NULL: an ordinary mesh */
    double origin[3];                       /* middle of its box, subtracted from positions that floats hold */
    double half[3];                         /* half the sides of its box */
};

struct hatch_item {
    uint32_t mesh, node;
    bool shaped;            /* a skin or morph targets shape it: its vertices are posed in the unit scene */
    bool mirrored;          /* the node turns the faces' winding round */
    bool double_sided;      /* faces are seen from behind, too */
    bool cut_out;           /* holes of a texture cut its shape out of larger faces; set by the material's reader */
    float alpha_cutoff;     /* texels with less alpha are holes; 0: no holes */
    float to_unit[16];      /* positions minus the mesh's origin to the unit scene, column-major; shaped: identity */
    float normal[9];        /* the same for normals, not of unit length */
    double low[3], high[3]; /* box in the unit scene */
    double uv_reach;        /* largest distance of texture coordinates from 0 0, as a length on the mesh; 0: unset */
    float repeat[2];        /* tiles of the hatching pattern per unit of u and of v; of the largest chart */
    float *repeats;         /* the same of each vertex, two each; NULL: repeat for all */
    uint32_t chart_count;   /* charts that have repeats of their own */
};

struct hatch_unit_scene {
    const struct hatch_scene *scene;
    struct hatch_bounds bounds;
    struct hatch_pose pose;
    uint32_t pose_number; /* counts changes of the pose, from 1 */
    uint32_t animation;   /* moment that items are posed at; measuring a span leaves `pose` at another */
    double time_s;
    uint32_t item_count;
    struct hatch_unit_mesh *meshes; /* scene->mesh_count */
    struct hatch_item *items;
};

/* Lists the items of a scene. Nothing is posed yet: call hatch_unit_scene_pose.
 *   patches  of each of the scene's meshes, or NULL where no mesh has any; kept by reference, as scene is
 *   bounds   of all moments that will be posed */
enum hatch_status hatch_unit_scene_make(const struct hatch_scene *scene, const struct hatch_patch_mesh *patches,
                                        const struct hatch_bounds *bounds, struct hatch_arena *arena,
                                        struct hatch_unit_scene *unit, struct hatch_err *err) HATCH_MUST_USE;

/* Poses all items at a moment of an animation (HATCH_NONE: the rest pose); of shaped ones the matrices alone:
 * hatch_item_shape computes their vertices and boxes. */
void hatch_unit_scene_pose(struct hatch_unit_scene *unit, uint32_t animation, double time_s);

/* Computes the vertices of a shaped item at the pose, and its box.
 *   positions  out: 3 per vertex, in the world
 *   normals    out: 3 per vertex, unit length; NULL: not computed */
void hatch_item_shape(struct hatch_unit_scene *unit, struct hatch_item *item, double *positions, float *normals);

/* Computes the vertices of an item's surface at the pose, in the unit scene.
 *   positions  out: 3 per vertex of the surface
 *   normals    out: 3 per vertex, unit length; NULL: not computed */
void hatch_item_surface(const struct hatch_unit_scene *unit, const struct hatch_item *item, double *positions,
                        float *normals);

/* The largest number of vertices that a surface has. */
uint32_t hatch_unit_scene_vertices_max(const struct hatch_unit_scene *unit);

#endif
