/* Lapped parametrization: a surface covered by overlapping patches, each a disk with coordinates that follow a
 * direction field (Praun, Finkelstein, Hoppe, "Lapped textures", SIGGRAPH 2000; Real-Time Hatching §6).
 *
 * Each patch begins with a whole face that is not covered yet, which its opaque core contains; so it covers at least
 * that face, and there are never more patches than faces. */
#ifndef HATCH_LAPPED_LAPPED_H
#define HATCH_LAPPED_LAPPED_H

#include "base/parallel.h"
#include "lapped/outline.h"
#include "topo/field.h"

struct hatch_lapped_options {
    double size;        /* 0: chosen; else diameter of a patch on a flat part, as a share of the diagonal of the box
                           around the whole mesh, 0.001 .. 1 */
    double curved;      /* 0 .. 1: how far patches shrink where the surface is curved; 0: all are alike */
    double stretch_max; /* the larger over the smaller singular value at which growth ends, 1.01 .. 10 */
    double turn_max_rad; /* angle between coordinates and field at which growth ends */
    uint64_t seed;
};

/* Coordinates of a patch: hatch u runs along the field (either way), v is at a right angle, counter-clockwise; both in
 * the mesh's units, so that a tile of hatching has one size on all patches. Mask coordinates lie in the outline's
 * square where the outline is. */
struct hatch_lapped_vertex {
    uint32_t point;
    float hatch[2], mask[2];
};

struct hatch_lapped_patch {
    uint32_t first_vertex, vertex_count;
    uint32_t first_face, face_count; /* into faces and corners */
    double radius;                   /* of the outline's square, half its side, in the mesh's units */
};

struct hatch_lapped {
    uint32_t patch_count;            /* in drawing order: later ones lie over earlier ones */
    struct hatch_lapped_patch *patches;
    uint32_t vertex_count, face_count; /* over all patches */
    struct hatch_lapped_vertex *vertices;
    uint32_t *faces;                 /* the surface's face of each patch's face */
    uint32_t *corners;               /* 3 a face: vertices, counted from the patch's first; in the order of the surface's */
    uint32_t hidden;                 /* patches left out because later ones hide them */
    uint32_t enlarged;               /* patches made larger than asked, to hold a large face */
};

/* direction, confidence: per point, as hatch_field's. Guarantees: every face is covered at opacity 1 (each of its
 * points by the core of some patch that holds the face); every patch is a topological disk of one component, without a
 * face whose field has an index unless it is that one face; no face is turned over. The same for any number of
 * threads. */
enum hatch_status hatch_lapped_make(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                    const double *direction, const double *confidence,
                                    const struct hatch_outline *outline,
                                    const struct hatch_lapped_options *options, struct hatch_pool *pool,
                                    struct hatch_arena *arena, struct hatch_arena *scratch,
                                    struct hatch_lapped *lapped, struct hatch_err *err) HATCH_MUST_USE;

/* One ordinary layout: every face in the chart of the patch that shows most of it, charts moved and scaled alike (never
 * turned, so that strokes still run along u) to lie side by side in the unit square. texcoords: two floats for each of the
 * 3 * face_count corners of the surface. margin: least distance between charts, as a share of the square. *scale receives
 * texture units per unit of the mesh. */
enum hatch_status hatch_lapped_atlas(const struct hatch_surface *surface, const struct hatch_lapped *lapped,
                                     const struct hatch_outline *outline, double margin,
                                     struct hatch_arena *scratch, float *texcoords, double *scale,
                                     struct hatch_err *err) HATCH_MUST_USE;

#endif
