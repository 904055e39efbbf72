/* Internals that the files of lapped share: the surface prepared for patches, the patch being grown, the solver, and
 * the record of covered faces. Lengths are those of the surface: 1 is a component's mean edge. In a patch's plane x
 * runs along the field and y is turned 90° counter-clockwise from it, so that faces stay counter-clockwise. The
 * published coordinates (struct hatch_lapped_vertex) have v = -y. */
#ifndef HATCH_LAPPED_WORK_H
#define HATCH_LAPPED_WORK_H

#include "lapped/heap.h"
#include "lapped/lapped.h"

/* Lower bound of twice a face's area over the sum of its squared sides; smaller values are rounding errors. */
#define HATCH_LAPPED_AREA_FLOOR 1e-12

/* The surface with the data that patches need for each face. A face has one direction: the mean of its corners'
 * directions in space, without parallel transport. */
struct hatch_patch_domain {
    const struct hatch_surface *surface;
    double *flattened;     /* 4 per face: corners 1 and 2 relative to corner 0, x along the face's direction */
    double *turning_rate;  /* per face: radians by which normals and field turn per length, smoothed */
    double *target_radius; /* per face: radius of a patch that begins there, half the side of the mask's square */
    double *edge_length;   /* per face: side of an equilateral triangle with the face's smoothed area; a typical edge
                              length there */
    uint8_t *singular;     /* per face: 1 where the field has an index */
    int8_t *matching; /* per side: the sign that makes the direction of the face behind it agree with this face's, times
                         2 where the two are within 60°, else times 1; 0 where no patch may cross */
    uint32_t faces_max; /* largest number of faces of one patch; hatch_lapped_make lowers it in costly components */
};

/* Prepares a surface for patches; the result is the same for any number of threads. The arrays live in arena. */
enum hatch_status hatch_patch_domain_make(const struct hatch_lapped_input *input,
                                          const struct hatch_lapped_options *options, struct hatch_pool *pool,
                                          struct hatch_arena *arena, struct hatch_arena *scratch,
                                          struct hatch_patch_domain *domain, struct hatch_err *err);

/* Computes the position of a face's corner (0 .. 2) in the face's plane, relative to corner 0, with x along the face's
 * direction. */
static inline void hatch_patch_domain_corner(const struct hatch_patch_domain *domain, uint32_t face, uint32_t corner,
                                             double xy[2])
{
    const double *flattened = &domain->flattened[(size_t)face * 4];
    xy[0] = corner == 0 ? 0 : flattened[2 * corner - 2];
    xy[1] = corner == 0 ? 0 : flattened[2 * corner - 1];
}

/* Finds the smallest circle around a triangle of the plane; returns its radius. */
double hatch_patch_enclosing_circle(const double corners[3][2], double center[2]);

/* Least ratio of the radius of a patch's core to that of the smallest circle around its seed face; neighbours of the
 * same size then fit into the core too. */
#define HATCH_LAPPED_CORE_FACTOR 1.9

/* A side on the boundary of a patch; another face of the surface lies behind it. */
struct hatch_boundary_side {
    uint32_t side;    /* side of the surface */
    uint32_t ends[2]; /* local vertices */
    bool covered;     /* the face behind is covered */
    bool growable;    /* growth may add the face behind */
};

/* Distortion of a face compared with the limits. HATCH_LAPPED_NEAR: within all of them, but close to that of the
 * angle. */
enum hatch_limit_state { HATCH_LAPPED_WITHIN, HATCH_LAPPED_EXCEEDED, HATCH_LAPPED_NEAR };

/* The patch being grown. Local faces and vertices are numbered in order of growth: the first n faces are a disk for any
 * n. Arrays live in the growth's arena. */
struct hatch_patch {
    uint32_t seed_face;
    double center[2], radius, rotation[2]; /* of the outline; rotation: cosine and sine, from the plane to the mask */
    double offset[2];   /* from the center of the circle around the seed face to that of the outline */
    double seed_radius; /* radius that a core around the center of that circle needs to contain the seed face */
    uint32_t face_count, vertex_count;
    uint32_t *faces;        /* the surface's faces */
    uint32_t *corners;      /* 3 per face: local vertices */
    int8_t *sign;           /* per face: 1 where x runs along the face's direction, -1 where against it */
    uint32_t *points;       /* per vertex: the surface's point */
    double *xy;             /* 2 per vertex: position in the patch's plane */
    uint8_t *covered_depth; /* per face: 0 when not covered, else 1 + the depth of the face from which it was added */
    uint8_t *limit_state;   /* per face: enum hatch_limit_state */
    struct hatch_boundary_side *boundary;
    uint32_t boundary_count;
    uint32_t measured_count;             /* number of faces, from the first on, that have a limit_state */
    uint32_t exceeded_count, near_count; /* number of measured faces in the state EXCEEDED, and in NEAR */
    uint32_t face_capacity, vertex_capacity, boundary_capacity;
    uint32_t faces_max; /* growth stops at this number */
};

/* Computes a patch's texture coordinates as floats, in tiles. They are moved by up to 32 float steps where rounding
 * would turn faces over and a move can prevent it.
 *   patch  a patch of lapped
 *   tile   side of a tile, in the mesh's units
 *   hatch  out: 2 per vertex */
enum hatch_status hatch_lapped_round(const struct hatch_lapped *lapped, const struct hatch_lapped_patch *patch,
                                     double tile, struct hatch_arena *scratch, float *hatch,
                                     struct hatch_err *err) HATCH_MUST_USE;

/* Points of the plane that must stay outside the outline. Initialise with {.arena = a}. */
struct hatch_obstacles {
    struct hatch_arena *arena;
    double *xy; /* 2 per point */
    uint32_t count, capacity;
};

/* Local index of a face or point; valid only if round equals that of the growth. */
struct hatch_local_index {
    uint32_t round, local;
};

/* Position of a point in the last solution for a patch. */
struct hatch_last_position {
    double xy[2];
    uint32_t patch_number;
};

/* The state of growing one patch after another. */
struct hatch_growth {
    const struct hatch_patch_domain *domain;
    const struct hatch_outline *outline;
    const uint8_t *covered; /* per face of the surface */
    struct hatch_patch patch;
    struct hatch_arena *arena;
    struct hatch_heap heap; /* sides to grow across, by distance from the center */
    struct hatch_obstacles obstacles;
    uint32_t round, patch_number;              /* counters: restarts from a seed face, patches begun */
    struct hatch_local_index *face, *point;    /* per face, per point of the surface */
    uint32_t *excluded_from;                   /* per face: number of the patch that must not contain it */
    struct hatch_last_position *last_position; /* per point */
    uint32_t unsolved_count;                   /* vertices that no solution for this patch has placed */
    uint32_t *start_faces_max;                 /* per face: the initial faces_max of a patch that begins there */
    uint32_t *first_attempt;                   /* faces of the patch after its first round */
    uint32_t first_attempt_count, first_attempt_capacity;
};

/* Allocates a growth in arena.
 *   covered  per face; kept by reference, may change between patches */
enum hatch_status hatch_growth_make(const struct hatch_patch_domain *domain, const struct hatch_outline *outline,
                                    const uint8_t *covered, struct hatch_arena *arena, struct hatch_growth *growth,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Begins a new patch, without faces yet. */
void hatch_growth_begin(struct hatch_growth *growth, uint32_t seed_face);

/* Grows the patch anew from its seed face over all faces that the outline touches, as far as the patch keeps the
 * guarantees of lapped.h. Points keep their last position; those without one are placed by unfolding a face next to its
 * neighbours. */
enum hatch_status hatch_growth_grow(struct hatch_growth *growth, struct hatch_err *err) HATCH_MUST_USE;

/* Continues growth from the faces that the patch has, where the outline reaches beyond its boundary. */
enum hatch_status hatch_growth_extend(struct hatch_growth *growth, struct hatch_err *err) HATCH_MUST_USE;

/* Converts a position in the patch's plane to mask coordinates. */
void hatch_patch_mask(const struct hatch_patch *patch, const double xy[2], double mask[2]);

/* Returns whether a segment of the plane may contain a point with opacity greater than 0. A result of false is
 * certain. */
bool hatch_patch_touches(const struct hatch_patch *patch, const struct hatch_outline *outline, const double a[2],
                         const double b[2]);

/* Returns whether the patch contains the face behind a side of the surface and is connected to it across that side. */
bool hatch_growth_side_inside(const struct hatch_growth *growth, uint32_t side);

/* Solves for the positions of a patch's vertices by least squares to the field: normal equations for x and for y, with
 * Cholesky factors stored within their envelope. Initialise with {.arena = a}; arrays are reused from patch to
 * patch. */
struct hatch_solver {
    struct hatch_arena *arena;
    uint32_t *rank;         /* per vertex: its row */
    uint32_t *strip_rank;   /* per strip of the plane: rank of the next vertex there */
    uint32_t *first_column; /* per row: where its envelope begins */
    uint32_t *row_start;    /* per row: index in matrix that its column 0 would have, modulo 2^32 */
    double *gradients; /* 8 per face: gradients of its corners' hat functions, 2 numbers each; weight; target scale */
    double (*matrix)[2], (*right_side)[2]; /* [0] for x, [1] for y */
    uint32_t rank_capacity, strip_capacity, column_capacity, start_capacity;
    uint32_t gradient_capacity, matrix_capacity, right_capacity;
};

/* The same systems for patches whose envelope would be long, because long faces lie across each other: their factors
 * are sparse. */
struct hatch_sparse_solver {
    struct hatch_sparse_factor *factor[2]; /* for x and for y */
    double *column;                        /* per vertex */
};

/* Factorizes the systems with the solver's gradients. The array of the result lives in the solver's arena; factors are
 * freed with hatch_sparse_solver_free, also after a failure. */
enum hatch_status hatch_sparse_solver_make(const struct hatch_solver *solver, const struct hatch_patch *patch,
                                           struct hatch_sparse_solver *made, struct hatch_err *err) HATCH_MUST_USE;
void hatch_sparse_solver_free(struct hatch_sparse_solver *made);

/* Replaces right-hand sides, 2 per vertex, by the solutions. */
enum hatch_status hatch_sparse_solver_solve(const struct hatch_sparse_solver *made, double (*right_side)[2],
                                            uint32_t count, struct hatch_err *err) HATCH_MUST_USE;

/* Computes what a face adds to the matrices for x and for y, in the row and column of two of its corners (0 .. 2). */
void hatch_solver_entry(const struct hatch_solver *solver, uint32_t local, uint32_t row, uint32_t column,
                        double entry[2]);

/* Computes new positions for the patch's vertices. */
enum hatch_status hatch_solver_solve(struct hatch_solver *solver, const struct hatch_patch_domain *domain,
                                     struct hatch_patch *patch, struct hatch_err *err) HATCH_MUST_USE;

/* Distortion of a face by its map into the plane. */
struct hatch_fit {
    double determinant; /* 1 keeps the area; negative when turned over */
    double stretch;     /* larger over smaller singular value, 1 ..; infinite when turned over */
    double angle_tan;   /* tangent of the angle between field and x axis; infinite when turned over or when the angle
                           exceeds 90° */
};

/* Measures the distortion of a local face. */
void hatch_patch_fit(const struct hatch_patch_domain *domain, const struct hatch_patch *patch, uint32_t local,
                     struct hatch_fit *fit);

/* Stores the vertices' positions as the last ones of their points. */
void hatch_growth_store_positions(struct hatch_growth *growth);

/* Adds obstacle points along the segment from a to b. */
enum hatch_status hatch_obstacles_add(struct hatch_obstacles *obstacles, const double a[2], const double b[2],
                                      struct hatch_err *err) HATCH_MUST_USE;

/* Moves the outline to where it can be largest without containing an obstacle, as far as its core still contains the
 * seed face, and sets its radius to that size. If no radius over radius_min is possible, the radius becomes about
 * radius_min, or hatch_patch_radius_min if that is larger. */
void hatch_patch_avoid_obstacles(struct hatch_patch *patch, const struct hatch_outline *outline,
                                 const struct hatch_obstacles *obstacles, double radius_min);

/* Returns the smallest radius with which the core contains the seed face. */
double hatch_patch_radius_min(const struct hatch_patch *patch, const struct hatch_outline *outline);

struct hatch_patch_notes {
    bool cut;              /* its faces end inside its outline */
    bool enlarged;         /* its outline is larger than the options ask for, to hold the seed face */
    bool given_up;         /* it would be smaller than radius_min, or its seed face exceeds a limit */
    uint64_t solved_faces; /* sum of the faces over all systems solved, a measure of the cost */
};

/* Grows and solves a patch from a seed face until it is within the limits; the result is growth->patch.
 *   radius_min  radius below which the patch is given up; 0: never */
enum hatch_status hatch_patch_make(struct hatch_growth *growth, struct hatch_solver *solver,
                                   const struct hatch_lapped_options *options, uint32_t seed_face, double radius_min,
                                   struct hatch_patch_notes *notes, struct hatch_err *err) HATCH_MUST_USE;

/* The faces covered by the union of the cores of all patches so far. A new patch is drawn below these patches, so it
 * leaves out the faces that are already covered. */
struct hatch_core_coverage_entry {
    uint32_t next;     /* next entry of the same face, or UINT32_MAX */
    double mask[3][2]; /* mask coordinates of the face's corners in one patch */
};

struct hatch_core_coverage {
    const struct hatch_outline *outline;
    struct hatch_arena *arena;
    uint8_t *covered; /* per face */
    uint32_t *head;   /* per face: its first entry, or UINT32_MAX */
    struct hatch_core_coverage_entry *entries;
    uint32_t entry_count, entry_capacity;
};

/* Makes a coverage that has no patches yet, in arena. */
enum hatch_status hatch_core_coverage_make(const struct hatch_outline *outline, uint32_t face_count,
                                           struct hatch_arena *arena, struct hatch_core_coverage *coverage,
                                           struct hatch_err *err) HATCH_MUST_USE;

/* Whether a patch is visible on a face below earlier patches. HATCH_LAPPED_HIDDEN and HATCH_LAPPED_VISIBLE are
 * certain. */
enum hatch_visibility { HATCH_LAPPED_HIDDEN, HATCH_LAPPED_UNDECIDED, HATCH_LAPPED_VISIBLE };

/* Adds a face of a patch. covered[face] becomes 1 only when the cores certainly contain the whole face.
 *   mask     mask coordinates of the face's corners
 *   visible  out: whether the patch is visible on the face */
enum hatch_status hatch_core_coverage_add(struct hatch_core_coverage *coverage, uint32_t face, const double mask[3][2],
                                          enum hatch_visibility *visible, struct hatch_err *err) HATCH_MUST_USE;

/* Returns whether a patch is certainly invisible on a face. This test is finer than that of hatch_core_coverage_add.
 *   entry_count  number of entries before the first face of the patch was added
 *   mask         mask coordinates of the face's corners */
bool hatch_core_coverage_hides(const struct hatch_core_coverage *coverage, uint32_t entry_count, uint32_t face,
                               const double mask[3][2]);

struct hatch_order_item {
    uint32_t key, face;
};

/* The order in which faces become seed faces: at the best distance from covered faces, else in the smoothest place that
 * is left, and in gaps at the end. */
struct hatch_order {
    const struct hatch_patch_domain *domain;
    double core_ratio; /* radius of the core over that of the outline's square */
    const uint8_t *covered;
    double *distance;   /* per face: distance over the surface to the nearest covered face; infinite when far */
    double *middle;     /* 3 per face */
    uint8_t *postponed; /* per face: no patch begins here before gaps are filled */
    uint32_t *smooth;   /* faces of the component, in ascending order of turning_rate */
    uint32_t smooth_count, smooth_next;
    struct hatch_order_item *items, *spare; /* per face: for sorting */
    struct hatch_heap queue;                /* queue of Dijkstra's algorithm: faces whose distance has fallen */
    struct hatch_heap candidates;           /* faces at a suitable distance from covered ones, best first */
    struct hatch_heap gaps;                 /* remaining faces, farthest first */
    bool filling_gaps;                      /* only gaps remain in this component */
    uint32_t first_face, face_count;        /* of the component */
};

/* Allocates an order in arena.
 *   covered  per face; kept by reference */
enum hatch_status hatch_order_make(const struct hatch_patch_domain *domain, const struct hatch_outline *outline,
                                   const uint8_t *covered, struct hatch_arena *arena, struct hatch_order *order,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Starts a component of the surface. */
void hatch_order_start_component(struct hatch_order *order, uint32_t component);

/* Returns in *face the next seed face, or HATCH_NO_SIDE when the component is covered. */
enum hatch_status hatch_order_next(struct hatch_order *order, uint32_t *face, struct hatch_err *err) HATCH_MUST_USE;

/* Updates distances for faces that have just become covered. */
enum hatch_status hatch_order_add_covered(struct hatch_order *order, const uint32_t *faces, uint32_t count,
                                          struct hatch_err *err) HATCH_MUST_USE;

#endif
