/* A posed scene as a list of items to draw: one item for each mesh of each node.
 *
 * World coordinates are doubles, so that scenes of any scale and at any distance from the origin keep their precision.
 * Items are placed in the unit scene, (world - center) / radius of the scene's bounds, for floats and GPUs. */
#ifndef HATCH_SCENE_UNIT_SCENE_H
#define HATCH_SCENE_UNIT_SCENE_H

#include "scene/patches.h"
#include "scene/pose.h"

/* A mesh, shared by its items. */
struct hatch_unit_mesh {
    const struct hatch_mesh *mesh;    /* all faces; of a lapped texture, the faces of all patches, which overlap */
    const struct hatch_mesh *surface; /* each face of the surface once; equals mesh for an ordinary mesh */
    const struct hatch_patch_mesh *patches; /* NULL: an ordinary mesh */
    double origin[3];   /* centre of the mesh's bounding box; subtracted from positions before to_unit
                           converts them, except for deformed items */
    double half[3];     /* half the sides of that box */
    double areas[3][3]; /* from hatch_mesh_sum_areas */
};

struct hatch_item {
    uint32_t mesh, node;
    bool deformed;          /* a skin or morph targets move its vertices for each pose; to_unit is then the identity */
    bool mirrored;          /* the node's matrix reverses the winding of faces */
    bool double_sided;      /* faces are visible from behind, too */
    bool cut_out;           /* a texture with holes cuts its shape out of larger faces; set by the renderer */
    float alpha_cutoff;     /* texels with less alpha are holes; 0: no holes */
    float to_unit[16];      /* converts positions minus the mesh's origin to the unit scene, column-major */
    float normal[9];        /* normal matrix of to_unit, column-major; it changes the lengths of normals */
    double low[3], high[3]; /* bounding box in the unit scene */
    double uv_reach;        /* as hatch_uv_reach computes it; 0: unset */
    float repeat[2];        /* tiles of the hatching pattern per unit of u and of v, on the largest chart */
    float *repeats;         /* 2 per vertex: repeats on the vertex's chart; NULL: `repeat` everywhere */
    uint32_t chart_count;   /* number of charts with repeats of their own */
};

struct hatch_unit_scene {
    const struct hatch_scene *scene;
    struct hatch_bounds bounds;
    struct hatch_pose pose;
    uint32_t pose_number; /* increases with each change of the pose; 0: not posed yet */
    uint32_t animation;   /* animation that the items are posed by; `pose` may be at another moment */
    double time_s;        /* time that the items are posed at */
    uint32_t item_count;
    struct hatch_unit_mesh *meshes; /* scene->mesh_count */
    struct hatch_item *items;
    double rest_axes[3][3]; /* axes of solid textures in coordinates of meshes: hatch_unit_scene_turn_rest */
};

/* Lists the items of a scene. They are not posed yet: call hatch_unit_scene_pose next.
 *   scene    kept by reference
 *   patches  an entry per mesh of the scene, kept by reference; NULL: no mesh has patches
 *   bounds   of all moments that will be posed */
enum hatch_status hatch_unit_scene_make(const struct hatch_scene *scene, const struct hatch_patch_mesh *patches,
                                        const struct hatch_bounds *bounds, struct hatch_arena *arena,
                                        struct hatch_unit_scene *unit, struct hatch_err *err) HATCH_MUST_USE;

/* Poses all items. For deformed items this sets the matrices only; hatch_item_deform computes their vertices and boxes.
 *   animation, time_s  as for hatch_scene_pose */
void hatch_unit_scene_pose(struct hatch_unit_scene *unit, uint32_t animation, double time_s);

/* Computes the vertices of a deformed item at the pose, and its box.
 *   positions  out: 3 per vertex, world coordinates
 *   normals    out: 3 per vertex, unit length; NULL: not computed */
void hatch_item_deform(struct hatch_unit_scene *unit, struct hatch_item *item, double *positions, float *normals);

/* Computes the vertices of an item's surface at the pose, in the unit scene.
 *   positions  out: 3 per vertex of the surface
 *   normals    out: 3 per vertex, unit length; NULL: not computed */
void hatch_item_surface(const struct hatch_unit_scene *unit, const struct hatch_item *item, double *positions,
                        float *normals);

/* Where the undeformed surface of an item lies in a solid texture: the place of a vertex is
 *     (its position in the mesh at rest - the mesh's origin) along the axes of the texture / unit + offset
 * Meshes of one node have the same units, so that a texture continues from one to the next. Place 0, where copies of
 * the texture at all scales meet, lies outside of most surfaces. */
struct hatch_item_rest {
    double unit;       /* a power of two, about the size of the node's meshes */
    double axes[3][3]; /* unit vectors, orthogonal to each other */
    double offset[3];  /* the mesh's origin in units along the axes, less a multiple of 64, plus a constant */
    double scale;      /* length in the unit scene, at the pose, of a unit: the root of the factor by which the
                          areas of the node's faces change, as a quadratic mean */
};

/* Turns solid textures against the meshes of all items, from alignment: around x first, then around y, then around z.
 * Surfaces along two axes of a mesh then show more than one slice of the texture.
 *   turn_rad  angles, counter-clockwise seen from the end of the axis */
void hatch_unit_scene_turn_rest(struct hatch_unit_scene *unit, const double turn_rad[3]);

/* Finds it for a posed item. A skinned item has the scale of its first joint. */
struct hatch_item_rest hatch_item_rest(const struct hatch_unit_scene *unit, uint32_t item);

/* Returns the number of vertices of the item with the largest surface. */
uint32_t hatch_unit_scene_vertices_max(const struct hatch_unit_scene *unit);

#endif
