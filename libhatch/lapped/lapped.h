/* Lapped textures: a surface covered by overlapping patches, each a disk with texture coordinates that follow a
 * direction field (Praun, Finkelstein, Hoppe, "Lapped textures", SIGGRAPH 2000; Praun, Hoppe, Webb, Finkelstein,
 * "Real-Time Hatching", SIGGRAPH 2001, §6).
 *
 * Each patch grows from a seed face that is not covered yet and that its opaque core always contains: a step of growth
 * that would turn a face over, exceed a limit or lose the seed face is undone. A face is covered when it lies in the
 * union of the cores of the patches that contain it, decided conservatively. Since each patch covers at least one face
 * more, there are never more patches than faces.
 *
 * Patches are made from the smoothest place on, each next to covered faces, and each is drawn below those made before
 * it. Thus a patch leaves out faces that earlier ones cover, gaps cost no more than their own faces, and patches cut
 * short near a singularity lie lowest. */
#ifndef HATCH_LAPPED_LAPPED_H
#define HATCH_LAPPED_LAPPED_H

#include "base/parallel.h"
#include "lapped/outline.h"
#include "field/field.h"

struct hatch_lapped_options {
    double size;         /* diameter of a patch on a flat part, as a share of the diagonal of the box around the whole
                            mesh, 0.001 .. 1; 0: a tenth, but such that a patch has 250 to 1000 faces */
    double curved;       /* how far patches shrink where the surface is curved, down to 250 faces, 0 .. 1; 0: all have
                            one size */
    double stretch_max;  /* growth stops where the larger over the smaller singular value exceeds this, 1.01 .. 10 */
    double turn_max_rad; /* growth stops where the angle between u and the field exceeds this, 0.01 .. π/2 */
    uint64_t seed;       /* random seed */
};

/* A surface with a direction field, and what is laid on it. Kept by reference only during a call. */
struct hatch_lapped_input {
    const struct hatch_surface *surface;
    const struct hatch_frames *frames;   /* of the surface; used by hatch_lapped_make */
    const double *direction;             /* 3 a point: unit tangents, as in struct hatch_field */
    const double *confidence;            /* per point, 0 .. 1; used by hatch_lapped_mesh */
    const struct hatch_mesh *mesh;       /* the surface was made from it; used by hatch_lapped_mesh */
    const struct hatch_outline *outline; /* of all patches */
    double tile;                         /* side of a tile of hatching in the mesh's units, over 0; used by
                                            hatch_lapped_mesh */
};

/* A vertex of a patch with its texture coordinates. */
struct hatch_lapped_vertex {
    uint32_t point;  /* of the surface */
    double hatch[2]; /* (u, v) of the hatching in the mesh's units, (0, 0) in the middle of the outline: u runs along
                        the field, either way, v at a right angle; seen from outside with u to the right v rises
                        downwards. Lengths are kept within a factor of 1.6, so that strokes have one size on all
                        patches. */
    float mask[2];   /* coordinates in the outline's square; the outline is rotated at random against the hatching */
};

/* A patch; its outline lies inside its faces, except at borders of the surface and where the patch is counted in
 * cut_count. */
struct hatch_lapped_patch {
    uint32_t first_vertex, vertex_count;
    uint32_t first_face, face_count; /* into faces and corners */
    double radius;                   /* half the side of the outline's square, in the mesh's units */
    double shift[2];                 /* random offset that hatch_lapped_mesh adds, in tiles, -1 .. 1 */
};

struct hatch_lapped {
    uint32_t patch_count; /* in drawing order: later patches lie over earlier ones */
    struct hatch_lapped_patch *patches;
    uint32_t vertex_count, face_count; /* over all patches */
    struct hatch_lapped_vertex *vertices;
    uint32_t *faces;         /* per face of a patch: the surface's face */
    uint32_t *corners;       /* 3 a face: vertices, counted from the patch's first, in the order of the surface */
    uint32_t cut_count;      /* patches whose faces end inside their outline */
    uint32_t enlarged_count; /* patches made larger than the options ask for, to contain a large face */
    uint64_t solved_faces;   /* faces in all linear systems that were solved: the cost */
};

/* Covers a surface with patches. Every point of every face lies in the core of a patch that contains the face. Every
 * patch is a disk of one component that crosses no contrary edge and contains no face in which the field has an index,
 * except on its boundary (such a face need not follow the field). No face is turned over. Faces hidden by later patches
 * are left out. The result is the same for any number of threads.
 *   pool    NULL: one thread
 *   lapped  out: its arrays live in arena */
enum hatch_status hatch_lapped_make(const struct hatch_lapped_input *input, const struct hatch_lapped_options *options,
                                    struct hatch_pool *pool, struct hatch_arena *arena, struct hatch_arena *scratch,
                                    struct hatch_lapped *lapped, struct hatch_err *err) HATCH_MUST_USE;

/* Makes a mesh of one patch: the attributes of input->mesh at each corner, TEXCOORD_0 (hatch / tile + shift, so that 1
 * is a tile), TEXCOORD_1 (mask) and _HATCH_DIR. Positions are those of input->mesh to the last bit. Where rounding to
 * floats would turn faces over, TEXCOORD_0 of a vertex is moved by a few times the distance between floats.
 *   patch  index in drawing order */
enum hatch_status hatch_lapped_mesh(const struct hatch_lapped_input *input, const struct hatch_lapped *lapped,
                                    uint32_t patch, struct hatch_arena *arena, struct hatch_arena *scratch,
                                    struct hatch_mesh *mesh, struct hatch_err *err) HATCH_MUST_USE;

/* Lays out all faces in one atlas, the unit square: each in a chart of the patch that shows most of it. A patch may
 * give several charts; none overlaps itself. Charts are moved and scaled alike, never rotated, so that strokes still
 * run along u.
 *   margin     distance between charts as a share of the square, 0 ..; reduced where there are many charts
 *   texcoords  out: 6 a face of the surface, 2 a corner
 *   scale      out: texture units per unit of the mesh */
enum hatch_status hatch_lapped_atlas(const struct hatch_lapped_input *input, const struct hatch_lapped *lapped,
                                     double margin, struct hatch_arena *scratch, float *texcoords, double *scale,
                                     struct hatch_err *err) HATCH_MUST_USE;

#endif
