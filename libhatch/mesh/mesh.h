/* Indexed triangles with named vertex attributes. y up, right-handed; faces counter-clockwise seen
 * from outside. */
#ifndef HATCH_MESH_MESH_H
#define HATCH_MESH_MESH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/arena.h"

#define HATCH_MESH_ATTRIBUTES_MAX 24u
#define HATCH_MESH_ATTRIBUTES_READ 18u /* of a file: commands add some */
#define HATCH_MESH_NAME_MAX 64u

/* data[vertex * components + i], owned by the mesh's arena. Names are glTF's: POSITION (3), NORMAL
 * (3), TANGENT (4: unit direction of rising u, and the sign w that makes w * (NORMAL × TANGENT) the
 * direction of falling v, up in the picture: 1 unless the texture is mirrored), TEXCOORD_0 (2),
 * TEXCOORD_1 (2) and so on, COLOR_0 (4), JOINTS_0 (4, whole numbers), WEIGHTS_0 (4), _HATCH_DIR (4). */
#define HATCH_MORPH_POSITION "morph POSITION" /* 3 for each morph target: how far it moves the vertex */
#define HATCH_MORPH_NORMAL "morph NORMAL"     /* of as many targets; never without the other */

struct hatch_mesh_attribute {
    char name[HATCH_MESH_NAME_MAX];
    uint32_t components; /* 1 .. 4, but of morph targets */
    float *data;
};

struct hatch_mesh {
    uint32_t vertex_count;
    uint32_t face_count;
    uint32_t *indices; /* 3 * face_count, each below vertex_count */
    uint32_t attribute_count;
    struct hatch_mesh_attribute attributes[HATCH_MESH_ATTRIBUTES_MAX]; /* [0] is POSITION */
};

/* What reading or cleaning a mesh did that its user should hear of: counts, 0 where nothing was. */
struct hatch_mesh_notes {
    uint32_t polygons_split;       /* faces of more than three corners, triangulated */
    uint32_t degenerate_dropped;   /* faces with a repeated corner or without area */
    uint32_t duplicates_dropped;   /* faces given twice */
    uint32_t unreferenced_dropped; /* vertices that no face uses */
    uint32_t faces_flipped;        /* faces turned to agree with their neighbours */
    uint32_t vertices_apart;       /* where vertices have positions alone: those at the
                                      position of an earlier one */
    uint32_t non_manifold_edges;   /* edges of more than two faces */
    uint32_t non_manifold_points;  /* points where faces meet that share no edge there */
    uint32_t contrary_edges;       /* edges whose two faces no turning makes agree: a Möbius strip */
    uint32_t primitives_skipped;   /* glTF: points and lines */
    uint32_t morphs_ignored;       /* glTF: meshes with morph targets that nothing moves: they stay as they rest */
    uint32_t attributes_dropped;   /* glTF: vertex attributes of no known name, or too many */
    uint32_t transparent_dropped;  /* meshes that are less opaque than their material asks for */
    uint32_t images_missing;       /* glTF: images that could not be read: materials do without */
    char image_missing[HATCH_MESH_NAME_MAX]; /* what the first of them is called */
};

/* Makes an empty mesh with room: indices and POSITION zeroed. */
enum hatch_status hatch_mesh_make(struct hatch_arena *arena, uint32_t vertex_count, uint32_t face_count,
                                  struct hatch_mesh *mesh, struct hatch_err *err) HATCH_MUST_USE;

/* Adds a zeroed attribute; *data receives its floats. HATCH_LIMIT when there is no room for it. */
enum hatch_status hatch_mesh_add(struct hatch_arena *arena, struct hatch_mesh *mesh, const char *name,
                                 uint32_t components, float **data, struct hatch_err *err) HATCH_MUST_USE;

/* Makes a mesh with room for face_count faces, indices zeroed, whose vertex v has every attribute of
 * from's vertex origin[v]. */
enum hatch_status hatch_mesh_gather(const struct hatch_mesh *from, const uint32_t *origin, uint32_t vertex_count,
                                    uint32_t face_count, struct hatch_arena *arena, struct hatch_mesh *mesh,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* The attribute's floats, or NULL. components: the number that it must have. */
float *hatch_mesh_find(const struct hatch_mesh *mesh, const char *name, uint32_t components);

/* The attribute of a name, whatever its components, or NULL. */
const struct hatch_mesh_attribute *hatch_mesh_attribute(const struct hatch_mesh *mesh, const char *name);

/* How many morph targets the mesh has. */
uint32_t hatch_mesh_targets(const struct hatch_mesh *mesh);

/* The positions of a face's corners. false when the face has no area (in doubles, which hold the
 * square of every float's product: 1e-30 and 1e30 are sizes like any other). face: below face_count. */
bool hatch_mesh_corners(const struct hatch_mesh *mesh, uint32_t face, double corners[3][3]);

/* Fails with HATCH_BAD_INPUT on an index out of range, a position that is not finite, no faces, or
 * no face with an area. */
enum hatch_status hatch_mesh_check(const struct hatch_mesh *mesh, struct hatch_err *err) HATCH_MUST_USE;

/* The smallest axis-aligned box around the vertices that faces use. false when there is none. */
bool hatch_mesh_bounds(const struct hatch_mesh *mesh, float low[3], float high[3]);

/* Adds NORMAL where it is missing: the mean of the faces' normals around a vertex, each weighted by
 * its angle there (Thürmer & Wüthrich 1998), in doubles. With crease_rad in (0, π) vertices on edges
 * sharper than it are doubled; 0 smooths everything; vertices at one position count as one. */
enum hatch_status hatch_mesh_add_normals(struct hatch_arena *arena, struct hatch_arena *scratch,
                                         struct hatch_mesh *mesh, float crease_rad,
                                         struct hatch_err *err) HATCH_MUST_USE;

/* Adds TANGENT from NORMAL and TEXCOORD_0 where it is missing: the direction of rising u, area
 * weighted, made orthogonal to the normal; where the UVs are degenerate, any direction orthogonal to
 * the normal. Needs both attributes. */
enum hatch_status hatch_mesh_add_tangents(struct hatch_arena *arena, struct hatch_arena *scratch,
                                          struct hatch_mesh *mesh, struct hatch_err *err) HATCH_MUST_USE;

/* Drops faces with a repeated corner or without area, faces given twice and unreferenced vertices;
 * turns faces so that neighbours agree (a component keeps the side that most of its faces had; a
 * closed one whose faces disagreed takes the side of positive volume); adds what it did to notes.
 * Vertices keep their order. HATCH_BAD_INPUT when no face is left. */
enum hatch_status hatch_mesh_clean(struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_mesh *mesh,
                                   struct hatch_mesh_notes *notes, struct hatch_err *err) HATCH_MUST_USE;

/* vertex_to_point[v]: the same number, 0 .. *point_count-1, for vertices at exactly one position,
 * in order of first appearance; coordinates below 2^-40 of the faces' extent count as 0.
 * vertex_to_point: vertex_count entries. */
enum hatch_status hatch_mesh_weld(const struct hatch_mesh *mesh, struct hatch_arena *scratch, uint32_t *vertex_to_point,
                                  uint32_t *point_count, struct hatch_err *err) HATCH_MUST_USE;

#endif
