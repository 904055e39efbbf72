/* Indexed triangle meshes with named vertex attributes. Coordinates are right-handed with y pointing up; faces are
 * counter-clockwise when seen from outside. */
#ifndef HATCH_MESH_MESH_H
#define HATCH_MESH_MESH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/arena.h"

#define HATCH_MESH_ATTRIBUTES_MAX 24u
#define HATCH_MESH_ATTRIBUTES_READ 18u /* largest number that is read from a file; commands add others */
#define HATCH_MESH_NAME_MAX 64u        /* with the terminating zero */

/* Attribute names are glTF's: POSITION (3 components), NORMAL (3), TANGENT (4: the unit direction of increasing u, and
 * a sign w; w * (NORMAL × TANGENT) is the direction of decreasing v, so w is 1 unless the texture is mirrored),
 * TEXCOORD_0 (2), TEXCOORD_1 (2) and so on, COLOR_0 (4), JOINTS_0 (4, whole numbers), WEIGHTS_0 (4), _HATCH_DIR (4). */
#define HATCH_MORPH_POSITION "morph POSITION" /* 3 per morph target: displacement of the vertex */
#define HATCH_MORPH_NORMAL "morph NORMAL"     /* 3 per target: change of the normal; only with the above */

struct hatch_mesh_attribute {
    char name[HATCH_MESH_NAME_MAX];
    uint32_t components; /* 1 .. 4; more for morph targets */
    float *data;         /* `components` floats per vertex; in the mesh's arena */
};

struct hatch_mesh {
    uint32_t vertex_count;
    uint32_t face_count;
    uint32_t *indices; /* 3 per face, each below vertex_count */
    uint32_t attribute_count;
    struct hatch_mesh_attribute attributes[HATCH_MESH_ATTRIBUTES_MAX]; /* [0] is POSITION */
};

/* Counts of the things that reading or cleaning a mesh has changed or ignored, for warnings. */
struct hatch_mesh_notes {
    uint32_t polygons_split;       /* faces of more than three corners, triangulated */
    uint32_t degenerate_dropped;   /* faces with a repeated corner or without area */
    uint32_t duplicates_dropped;   /* faces with the same points as an earlier face */
    uint32_t unreferenced_dropped; /* vertices that no face uses */
    uint32_t faces_flipped;        /* faces flipped to agree with their neighbours */
    uint32_t vertices_apart;       /* in meshes without other attributes: vertices at the position of an earlier one */
    uint32_t non_manifold_edges;   /* edges of more than two faces */
    uint32_t non_manifold_points;  /* points where faces meet that share no edge there */
    uint32_t contrary_edges;       /* edges whose two faces cannot agree, as on a Möbius strip */
    uint32_t primitives_skipped;   /* glTF: points and lines */
    uint32_t primitives_unplaced;  /* glTF: faces without positions, which are left out */
    uint32_t texcoords_missing;    /* vertices without texture coordinates, where others have some: none are used */
    uint32_t free_forms_dropped;   /* OBJ: free-form curves and surfaces */
    uint32_t morphs_ignored;     /* glTF: meshes with morph targets that nothing animates; they keep their rest shape */
    uint32_t attributes_dropped; /* glTF: vertex attributes that are unknown, or beyond HATCH_MESH_ATTRIBUTES_READ */
    uint32_t transparent_dropped; /* meshes with an opacity below their material's cutoff */
    uint32_t colors_replaced;     /* glTF: colours that are not finite, read as 0 */
    uint32_t normals_replaced;    /* normals that are missing or 0 0 0, replaced by those of faces */
    uint32_t joints_dropped;      /* glTF: vertices of more than four joints, of which the heaviest four are kept */
    /* Doubts, counted by hatch_scene_doubt. */
    uint32_t normals_not_unit;  /* normals whose length is not 1 */
    uint32_t normals_inward;    /* normals that point to the inside of all faces around them, where they are many */
    uint32_t meshes_inside_out; /* closed meshes whose faces point inwards */
    uint32_t needles;           /* faces over HATCH_NEEDLE times as long as high */
    uint32_t texcoords_flat;    /* meshes whose texture coordinates have no extent */
    uint32_t weights_wrong;     /* vertices whose joint weights do not add up to 1 */
    uint32_t nodes_flat;        /* nodes with meshes and a scale of 0 */
    const char *library;        /* OBJ: name of the first material library, in the mesh's arena; NULL: none */
    const uint32_t *numbers;    /* OBJ, PLY: per vertex, its number in the file, in the mesh's arena; NULL: its index */
    uint32_t numbers_end;       /* with numbers: 1 more than the highest that a vertex of the file has */
    uint32_t images_missing;    /* glTF: images that could not be read; their materials are used without them */
    char image_missing[HATCH_MESH_NAME_MAX]; /* name of the first of them */
    /* Parts of a glTF that its scene does not have, and that are therefore missing in a file written from it. */
    uint32_t meshes_undrawn;     /* meshes that no node of the scene draws */
    uint32_t levels_dropped;     /* nodes whose levels of detail (MSFT_lod) are not read: only the finest is */
    uint32_t scenes_dropped;     /* scenes beside the default one */
    uint32_t images_dropped;     /* images of other kinds than PNG, JPEG and WebP, or missing; not images_missing */
    uint32_t attributes_rounded; /* vertex attributes with integers over 2^24, for which floats are too short */
    uint32_t extensions_dropped; /* extensions that are neither read nor kept */
    char extension_dropped[192]; /* names of the first of them, with commas */
};

/* Makes a mesh with zeroed indices and POSITION, in arena. */
enum hatch_status hatch_mesh_make(struct hatch_arena *arena, uint32_t vertex_count, uint32_t face_count,
                                  struct hatch_mesh *mesh, struct hatch_err *err) HATCH_MUST_USE;

/* Adds a zeroed attribute. HATCH_LIMIT also if the mesh already has HATCH_MESH_ATTRIBUTES_MAX.
 *   arena  of the mesh
 *   name   shorter than HATCH_MESH_NAME_MAX
 *   data   out: the attribute's floats */
enum hatch_status hatch_mesh_add(struct hatch_arena *arena, struct hatch_mesh *mesh, const char *name,
                                 uint32_t components, float **data, struct hatch_err *err) HATCH_MUST_USE;

/* Makes a mesh whose vertices are copies of another mesh's, with all their attributes. Its indices are zeroed.
 *   origin  per vertex of the new mesh: the vertex of `from` that it copies */
enum hatch_status hatch_mesh_gather(const struct hatch_mesh *from, const uint32_t *origin, uint32_t vertex_count,
                                    uint32_t face_count, struct hatch_arena *arena, struct hatch_mesh *mesh,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Returns the floats of an attribute, or NULL when the mesh has none with this name and number of components. */
float *hatch_mesh_find(const struct hatch_mesh *mesh, const char *name, uint32_t components);

/* Returns an attribute by its name alone, or NULL. */
const struct hatch_mesh_attribute *hatch_mesh_attribute(const struct hatch_mesh *mesh, const char *name);

/* Returns the number of morph targets. */
uint32_t hatch_mesh_target_count(const struct hatch_mesh *mesh);

/* Computes the positions of a face's corners; returns false if the face has no area. The test of the area works for
 * faces with sizes of 1e-30 to 1e30. */
bool hatch_mesh_corners(const struct hatch_mesh *mesh, uint32_t face, double corners[3][3]);

/* Returns the area of a face. */
double hatch_mesh_face_area(const struct hatch_mesh *mesh, uint32_t face);

/* Checks a mesh from a file. HATCH_BAD_INPUT for an index out of range, a position that is not finite, no faces, or no
 * face with an area. */
enum hatch_status hatch_mesh_check(const struct hatch_mesh *mesh, struct hatch_err *err) HATCH_MUST_USE;

/* Computes the axis-aligned bounding box of the vertices that faces use, but for faces with one position alone. Returns
 * false if there are no others. */
bool hatch_mesh_bounds(const struct hatch_mesh *mesh, float low[3], float high[3]);

/* Returns the diagonal of that box; 0 without one. */
double hatch_mesh_diagonal(const struct hatch_mesh *mesh);

/* Adds NORMAL where it is missing: the mean of the normals of the faces around a vertex, weighted by their angles there
 * (Thürmer & Wüthrich 1998), in doubles. Vertices at one position share a normal.
 *   crease_rad  vertices are split at edges sharper than this, over 0 and under π; 0: at no edge. Where such an edge
 *               between two planes of several faces each ends at a point around which no other edge is as sharp, as at
 * a cube's corner that is cut off, the vertex there is split at the sharpest of the others, too */
enum hatch_status hatch_mesh_add_normals(struct hatch_arena *arena, struct hatch_arena *scratch,
                                         struct hatch_mesh *mesh, float crease_rad,
                                         struct hatch_err *err) HATCH_MUST_USE;

/* Adds NORMAL to a mesh with HATCH_MORPH_POSITION and without NORMAL: each face gets vertices and a normal of its own.
 * Adds HATCH_MORPH_NORMAL: what each target alone turns, exact where its weight is as at rest, and where it is by 1
 * more, or less: flat faces stay flat when they move.
 *   mesh  in, out
 *   less  per target: whether the turn is exact for a weight that is by 1 less */
enum hatch_status hatch_mesh_add_flat_normals(struct hatch_arena *arena, struct hatch_mesh *mesh, const bool *less,
                                              struct hatch_err *err) HATCH_MUST_USE;

/* Replaces normals 0 0 0, which some exporters write, by the mean of the normals of the faces that use the vertex,
 * weighted by their angles there. A vertex without a face that has an area gets any unit vector.
 *   mesh      in, out: may have no NORMAL
 *   replaced  in, out: the number of normals that are now those of faces is added */
enum hatch_status hatch_mesh_replace_normals(struct hatch_arena *scratch, struct hatch_mesh *mesh, uint32_t *replaced,
                                             struct hatch_err *err) HATCH_MUST_USE;

/* Adds TANGENT where it is missing: the area-weighted mean direction of increasing u, made orthogonal to the normal.
 * Where the texture coordinates are degenerate it is any direction orthogonal to the normal. The mesh must have NORMAL
 * and TEXCOORD_0. */
enum hatch_status hatch_mesh_add_tangents(struct hatch_arena *arena, struct hatch_arena *scratch,
                                          struct hatch_mesh *mesh, struct hatch_err *err) HATCH_MUST_USE;

/* Drops degenerate faces, duplicate faces and unreferenced vertices, and flips faces so that neighbours agree
 * (hatch_mesh_orient). Vertices keep their order. HATCH_BAD_INPUT if no face remains.
 *   mesh   in, out: rebuilt in arena
 *   notes  in, out: counts are added */
enum hatch_status hatch_mesh_clean(struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_mesh *mesh,
                                   struct hatch_mesh_notes *notes, struct hatch_err *err) HATCH_MUST_USE;

/* Numbers the different positions of a mesh's vertices, from 0 in order of appearance. -0 equals 0; coordinates of at
 * most 2^-40 of the faces' extent count as 0.
 *   vertex_to_point  out: per vertex: the number of its position
 *   point_count      out: number of different positions */
enum hatch_status hatch_mesh_weld(const struct hatch_mesh *mesh, struct hatch_arena *scratch, uint32_t *vertex_to_point,
                                  uint32_t *point_count, struct hatch_err *err) HATCH_MUST_USE;

#endif
