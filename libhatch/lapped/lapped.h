/* Lapped textures: a surface covered by overlapping patches, each a disk with texture coordinates that follow a
 * direction field (Praun, Finkelstein, Hoppe, "Lapped textures", SIGGRAPH 2000; Praun, Hoppe, Webb, Finkelstein,
 * "Real-Time Hatching", SIGGRAPH 2001, §6).
 *
 * Each patch grows from a seed face that is not covered yet. The patch's opaque core always contains the seed face; a
 * step of growth that would turn a face over, exceed a limit or lose the seed face is undone. A face counts as covered
 * only when it certainly lies in the union of the cores of the patches that contain it. Since each patch covers at
 * least one more face, there are never more patches than faces.
 *
 * A seed face is chosen at the best distance from covered faces or, if no face is at a suitable distance, in the
 * smoothest place that is left; gaps come last. Each patch is drawn below those made before it, so it leaves out the
 * faces that they cover. A patch that fills a gap therefore keeps little more than the gap's faces, and patches cut
 * short near a singularity lie lowest. */
#ifndef HATCH_LAPPED_LAPPED_H
#define HATCH_LAPPED_LAPPED_H

#include "base/parallel.h"
#include "base/progress.h"
#include "lapped/outline.h"
#include "field/field.h"

struct hatch_lapped_options {
    double size;   /* diameter of a patch on a flat part, as a share of the diagonal of the whole mesh's bounding box,
                      0.001 .. 1; 0: a tenth, adjusted so that a patch has 250 to 1000 faces */
    double curved; /* how far patches shrink where the surface is curved, though not below 250 faces, 0 .. 1; 0: all
                      have the same size */
    double stretch_max;  /* growth stops where larger / smaller singular value exceeds this, 1.01 .. 10 */
    double turn_max_rad; /* growth stops where the angle between u and the field exceeds this, 0.01 .. π/2 */
    uint64_t seed;       /* random seed */
    const struct hatch_progress *progress; /* NULL: nobody is told */
};

/* A surface with a direction field, and the texture that is laid on it. Kept by reference only during a call. */
struct hatch_lapped_input {
    const struct hatch_surface *surface;
    const struct hatch_frames *frames;   /* frames of the surface; used by hatch_lapped_make */
    const double *direction;             /* 3 per point: unit tangents, as in struct hatch_field */
    const double *confidence;            /* per point, 0 .. 1; used by hatch_lapped_mesh */
    const struct hatch_mesh *mesh;       /* the mesh that the surface was made from, with the surface's orientation, as
                                            hatch_surface_to_mesh makes it; used by hatch_lapped_mesh */
    const struct hatch_outline *outline; /* the outline that all patches share */
    double tile; /* side of a tile of hatching in the mesh's units, greater than 0; used by hatch_lapped_mesh */
};

/* A vertex of a patch with its texture coordinates. */
struct hatch_lapped_vertex {
    uint32_t point;  /* point of the surface */
    double hatch[2]; /* (u, v) of the hatching in the mesh's units, with (0, 0) in the middle of the outline. u runs
                        along the field, in either sense, and v at a right angle to it; seen from outside with u to the
                        right, v points down. Lengths are kept within a factor of 1.6, so that strokes have the same
                        size on all patches. */
    float mask[2]; /* coordinates in the outline's square; the outline is rotated at random relative to the hatching */
};

/* A patch. Its outline lies within its faces, except at borders of the surface and in the patches that cut_count
 * counts. */
struct hatch_lapped_patch {
    uint32_t first_vertex, vertex_count;
    uint32_t first_face, face_count; /* range in faces and corners */
    double radius;                   /* half the side of the outline's square, in the mesh's units */
    double shift[2];                 /* random offset that hatch_lapped_mesh adds, in tiles, -1 .. 1 */
};

struct hatch_lapped {
    uint32_t patch_count; /* in drawing order: later patches lie over earlier ones */
    struct hatch_lapped_patch *patches;
    uint32_t vertex_count, face_count; /* sums over all patches */
    struct hatch_lapped_vertex *vertices;
    uint32_t *faces;         /* per face of a patch: the surface's face */
    uint32_t *corners;       /* 3 per face: vertices, counted from the patch's first, in the order of the surface */
    uint32_t cut_count;      /* number of patches whose faces end inside their outline */
    uint32_t enlarged_count; /* number of patches made larger than the options ask for, to contain a large face */
    uint64_t solved_faces;   /* sum of the faces over all linear systems that were solved, a measure of the cost */
};

/* Covers a surface with patches. Every point of every face lies in the core of a patch that contains the face. Every
 * patch is a disk of one component that crosses no contrary edge and contains no face in which the field has an index,
 * except on its boundary (such a face need not follow the field). No face is turned over. Faces and patches
 * that the cores of later patches hide are left out. The result is the same for any number of threads.
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

/* Lays out all faces in one atlas, the unit square: each face in a chart of the patch that shows most of it. A patch
 * may yield several charts; none overlaps itself. All charts are scaled alike and none is rotated, so that strokes
 * still run along u.
 *   margin     distance between charts as a share of the square's side, 0 ..; reduced where there are many charts
 *   texcoords  out: 6 per face of the surface, 2 per corner
 *   scale      out: texture units per unit of the mesh */
enum hatch_status hatch_lapped_atlas(const struct hatch_lapped_input *input, const struct hatch_lapped *lapped,
                                     double margin, struct hatch_arena *scratch, float *texcoords, double *scale,
                                     struct hatch_err *err) HATCH_MUST_USE;

#endif
