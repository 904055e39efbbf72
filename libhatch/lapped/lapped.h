/* Lapped parametrization: a surface covered by overlapping patches, each a disk with coordinates
 * that follow a direction field (Praun, Finkelstein, Hoppe, "Lapped textures", SIGGRAPH 2000;
 * Real-Time Hatching §6).
 *
 * Each patch begins with a whole face that is not covered yet, and its opaque core always contains
 * that face: a step of growth after which it would not, or that turns a face over or passes a
 * limit, is undone. A face is covered when it lies in the union of the cores of patches that hold
 * it, decided conservatively. So each patch covers a face more, and there are never more patches
 * than faces.
 *
 * Patches are made from the smoothest place on, each beside what is covered, and each lies under those
 * made before it: so a face is left out of a patch as soon as earlier ones cover it, gaps cost no more
 * than their own faces, and what is cut short near an index lies lowest. */
#ifndef HATCH_LAPPED_LAPPED_H
#define HATCH_LAPPED_LAPPED_H

#include "base/parallel.h"
#include "lapped/outline.h"
#include "field/field.h"

struct hatch_lapped_options {
    double size;         /* diameter of a patch on a flat part, as a share of the diagonal of the box around the
                            whole mesh, 0.001 .. 1; 0: chosen: a tenth, but 250 to 1000 faces */
    double curved;       /* 0 .. 1: how far patches shrink where the surface is curved, down to 250 faces; 0: all
                            are alike */
    double stretch_max;  /* the larger over the smaller singular value at which growth ends, 1.01 .. 10 */
    double turn_max_rad; /* angle between coordinates and field at which growth ends, 0.01 .. π/2 */
    uint64_t seed;
};

/* Coordinates of a patch: hatch u runs along the field (either way), v is at a right angle, so
 * that seen from outside with u to the right v rises downwards, as in shapes/shapes.h; both in the
 * mesh's units, so that a tile of hatching has one size on all patches, but that within one it may
 * grow or shrink by a factor of 1.6 where strokes run apart or the surface cannot be flattened. Mask
 * coordinates lie in the outline's square where the outline is; the outline is turned at random against
 * the hatching, and slid and shrunk so that it stays inside the faces that the patch has, but at borders
 * of the surface: where that cannot be, the patch is counted in `cut`. */
struct hatch_lapped_vertex {
    uint32_t point;
    double hatch[2]; /* (0, 0) in the middle of the outline */
    float mask[2];
};

struct hatch_lapped_patch {
    uint32_t first_vertex, vertex_count;
    uint32_t first_face, face_count; /* into faces and corners */
    double radius;                   /* of the outline's square, half its side, in the mesh's units */
    double shift[2];                 /* -1 .. 1, at random: what hatch_lapped_mesh adds, in tiles */
};

struct hatch_lapped {
    uint32_t patch_count; /* in drawing order: later ones lie over earlier ones */
    struct hatch_lapped_patch *patches;
    uint32_t vertex_count, face_count; /* over all patches */
    struct hatch_lapped_vertex *vertices;
    uint32_t *faces;               /* the surface's face of each patch's face */
    uint32_t *corners;             /* 3 a face: vertices, counted from the patch's first; in the
                                      order of the surface's corners */
    uint32_t hidden, hidden_faces; /* patches (none is made that is), and faces of others, left out because later
                                      cores hide them */
    uint32_t cut;                  /* patches whose faces end inside their outline */
    uint32_t enlarged;             /* patches made larger than asked, to hold a large face */
    uint64_t placed;               /* faces in all linear systems that were solved: what it took */
};

/* direction, confidence: per point, as hatch_field's. Guarantees: every face is covered at opacity
 * 1 (each of its points by the core of some patch that holds the face); every patch, before hidden
 * faces are left out, is a topological disk of one component that crosses no contrary edge and
 * encloses no face whose field has an index (one may lie on its rim, and is then not asked to
 * follow the field); no face is turned over. The same for any number of threads. Curvature, for
 * order and size, is taken from the turning of the frames' normals. */
enum hatch_status hatch_lapped_make(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                    const double *direction, const double *confidence,
                                    const struct hatch_outline *outline, const struct hatch_lapped_options *options,
                                    struct hatch_pool *pool, struct hatch_arena *arena, struct hatch_arena *scratch,
                                    struct hatch_lapped *lapped, struct hatch_err *err) HATCH_MUST_USE;

/* One patch as a mesh to be written: the source's attributes at each corner, TEXCOORD_0 (hatch
 * divided by tile, so that 1 is a tile, and shifted; where rounding to floats would turn faces over, vertices
 * are moved by a few times the distance between floats), TEXCOORD_1 (mask) and _HATCH_DIR. Positions are the
 * source's to the last bit, whatever the patch. source: the mesh that the surface was made of;
 * tile: in its units, over 0. */
enum hatch_status hatch_lapped_mesh(const struct hatch_surface *surface, const struct hatch_mesh *source,
                                    const struct hatch_lapped *lapped, uint32_t patch, const double *direction,
                                    const double *confidence, double tile, struct hatch_arena *arena,
                                    struct hatch_arena *scratch, struct hatch_mesh *mesh,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* One ordinary layout: every face in the chart of the patch that shows most of it (a patch may
 * give several charts; none overlaps itself), charts moved and scaled alike (never turned, so that
 * strokes still run along u) to lie side by side in the unit square. texcoords: two floats for
 * each of the 3 * face_count corners of the surface. margin: distance wanted between charts, as a
 * share of the square; less where charts are too many. *scale receives texture units per unit of
 * the mesh. */
enum hatch_status hatch_lapped_atlas(const struct hatch_surface *surface, const struct hatch_lapped *lapped,
                                     const struct hatch_outline *outline, double margin, struct hatch_arena *scratch,
                                     float *texcoords, double *scale, struct hatch_err *err) HATCH_MUST_USE;

#endif
