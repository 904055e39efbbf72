/* What the parts of lapped share: the ground that patches grow on, the patch that grows, and who
 * covers what. Lengths are those of the surface: one is a component's mean edge. In the plane of a
 * patch x runs along the field and y at a right angle, counter-clockwise as the faces are; only the
 * coordinates that leave this module are turned so that v falls. */
#ifndef HATCH_LAPPED_WORK_H
#define HATCH_LAPPED_WORK_H

#include "lapped/heap.h"
#include "lapped/lapped.h"

/* Twice the area of a face counts as so much at least, in squares of its sides: the rest is rounding. */
#define HATCH_LAPPED_THIN 1e-12

/* Faces as the patches see them. */
struct hatch_ground {
    const struct hatch_surface *surface;
    double *flat;       /* 4 a face: corners 1 and 2 seen from corner 0, in the frame of the face's line */
    double *rough;      /* per face: turning of normals and of the field, smoothed, per length */
    double *wish;       /* per face: radius wanted of a patch that begins there; one that holds it, and neighbours
                           of its size */
    double *grain;      /* per face: the length of an edge around it */
    uint8_t *singular;  /* per face: the field has an index */
    int8_t *bend;       /* per side: the sign with which the line of the face behind goes on in this one; doubled
                           where the two are coherent; 0 where no patch goes on */
    uint32_t faces_max; /* of a patch */
};

enum hatch_status hatch_ground_make(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                    const double *direction, const struct hatch_outline *outline,
                                    const struct hatch_lapped_options *options, struct hatch_pool *pool,
                                    struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_ground *ground,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* A face's corner in the frame of its line. */
static inline void hatch_ground_corner(const struct hatch_ground *ground, uint32_t face, uint32_t corner, double at[2])
{
    const double *flat = &ground->flat[(size_t)face * 4];
    at[0] = corner == 0 ? 0 : flat[2 * corner - 2];
    at[1] = corner == 0 ? 0 : flat[2 * corner - 1];
}

/* The smallest circle around a triangle of the plane; returns its radius. */
double hatch_patch_circle(const double at[3][2], double center[2]);

/* By how much the core of a patch is larger than a face must be for it to hold neighbours of its size as well. */
#define HATCH_LAPPED_HOLD 1.9

/* A side of the patch behind which it has no face but there is one. */
struct hatch_rim {
    uint32_t side;    /* the surface's */
    uint32_t ends[2]; /* local vertices */
    bool covered;     /* the face behind is */
    bool may;         /* growth may take it */
};

/* How a face lies: nearly as the field is, past a limit, or between. */
enum hatch_past { HATCH_LAPPED_WITHIN, HATCH_LAPPED_PAST, HATCH_LAPPED_WIDE };

/* The patch that grows. Local faces and vertices are numbered in order of growth: any first part of
 * the faces is a disk too. */
struct hatch_patch {
    uint32_t seed;
    double center[2], radius, turn[2]; /* turn: cosine and sine from the plane to the mask */
    double offset[2];                  /* of the center, from that of the smallest circle around the first face */
    double seed_radius;                /* of that circle */
    uint32_t face_count, vertex_count;
    uint32_t *faces;   /* surface's faces */
    uint32_t *corners; /* 3 a face: local vertices */
    int8_t *sign;      /* per face: 1 or -1: which way its line counts */
    uint32_t *points;  /* surface's points of local vertices */
    double *place;     /* 2 a vertex: in the plane */
    uint8_t *steps;    /* per face: how far it lies inside covered ground, in faces from one that is bare */
    uint8_t *past;     /* per face: enum hatch_past */
    struct hatch_rim *rim;
    uint32_t rim_count;
    uint32_t measured;               /* faces at the beginning of which it is known whether they are past a limit */
    uint32_t past_count, wide_count; /* of them */
    uint32_t face_room, point_room, rim_room; /* of what there is per face, per vertex, per side of the rim */
    uint32_t faces_max;                       /* growth ends at so many */
};

/* Texture coordinates of a patch's vertices, two each, in floats of which none turns a face over, where a
 * way was found. Statuses: HATCH_LIMIT. */
enum hatch_status hatch_lapped_round(const struct hatch_lapped *lapped, const struct hatch_lapped_patch *patch,
                                     double tile, struct hatch_arena *scratch, float *hatch,
                                     struct hatch_err *err) HATCH_MUST_USE;

/* Places of the plane that the outline must leave outside. */
struct hatch_obstacles {
    struct hatch_arena *arena;
    double *at; /* 2 each */
    uint32_t count, room;
};

/* Where a face or point stands in the patch that had this round. */
struct hatch_stamp {
    uint32_t round, local;
};

/* Where a solution last placed a point, and for which patch. */
struct hatch_known {
    double place[2];
    uint32_t number;
};

/* A growth's view of the whole surface: which faces and points are in the patch, by stamps. */
struct hatch_growth {
    const struct hatch_ground *ground;
    const struct hatch_outline *outline;
    const uint8_t *covered; /* per face */
    struct hatch_patch patch;
    struct hatch_arena *arena;
    struct hatch_heap heap;
    struct hatch_obstacles obstacles;
    uint32_t round, number;                   /* of this growth, of this patch */
    struct hatch_stamp *face, *point;         /* per face, per point */
    uint32_t *barred;                         /* per face: the patch that must not hold it */
    struct hatch_known *known;                /* per point */
    uint32_t unfolded;                        /* vertices of the patch that no solution has placed */
    uint32_t *budget;                         /* per face: faces that a patch that begins here begins with */
    uint32_t *tried, tried_count, tried_room; /* faces of the patch as it first was */
};

enum hatch_status hatch_growth_make(const struct hatch_ground *ground, const struct hatch_outline *outline,
                                    const uint8_t *covered, struct hatch_arena *arena, struct hatch_growth *growth,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Begins a new patch at a face. */
void hatch_growth_begin(struct hatch_growth *growth, uint32_t seed);

/* Grows anew from the seed over all faces that the outline touches, as far as the patch stays what
 * lapped.h promises; points that a solution placed keep their places, others are unfolded. */
enum hatch_status hatch_growth_grow(struct hatch_growth *growth, struct hatch_err *err) HATCH_MUST_USE;

/* Goes on from the faces that the patch has, where the outline has come over its rim. */
enum hatch_status hatch_growth_extend(struct hatch_growth *growth, struct hatch_err *err) HATCH_MUST_USE;

/* A place of the patch's plane in mask coordinates. */
void hatch_patch_mask(const struct hatch_patch *patch, const double place[2], double mask[2]);

/* Whether opacity over 0 may be found on a way between two places of the plane. Never false where it
 * is. */
bool hatch_patch_touches(const struct hatch_patch *patch, const struct hatch_outline *outline, const double a[2],
                         const double b[2]);

/* The patch's other local face across a side of local face f, or the reason why there is none. */
enum hatch_side { HATCH_SIDE_INSIDE, HATCH_SIDE_BORDER, HATCH_SIDE_OPEN };
enum hatch_side hatch_growth_side(const struct hatch_growth *growth, uint32_t side);

/* Least squares to the field. */
struct hatch_solver {
    struct hatch_arena *arena;
    uint32_t *rank;                   /* of each vertex along the plane's longer axis */
    uint32_t *places;                 /* per strip of the plane: the next rank there */
    uint32_t *first;                  /* per row: the envelope's first column */
    uint32_t *start;                  /* per row: where column 0 would stand in matrix; wraps */
    double *gradients;                /* 8 a face: of its corners' hat functions, 2 each, its weight, its scale */
    double (*matrix)[2], (*right)[2]; /* of x and of y side by side */
    uint32_t places_room, rank_room, first_room, start_room, gradient_room, matrix_room, right_room;
};

/* Places the patch's vertices anew. */
enum hatch_status hatch_solver_solve(struct hatch_solver *solver, const struct hatch_ground *ground,
                                     struct hatch_patch *patch, struct hatch_err *err) HATCH_MUST_USE;

/* How one face lies in the plane: its determinant, its larger singular value over the smaller, and
 * the tangent of the angle between line and strokes; infinite where it is turned over. */
struct hatch_fit {
    double determinant, stretch, turn;
};
void hatch_patch_fit(const struct hatch_ground *ground, const struct hatch_patch *patch, uint32_t local,
                     struct hatch_fit *fit);

/* Remembers the places that the vertices have now. */
void hatch_growth_keep(struct hatch_growth *growth);

enum hatch_status hatch_obstacles_add(struct hatch_obstacles *obstacles, const double a[2], const double b[2],
                                      struct hatch_err *err) HATCH_MUST_USE;

/* Slides the outline so that it stays large and clear of the obstacles and its core still holds the
 * first face; false, and no larger than floor or that needs, where it cannot. */
bool hatch_patch_slide(struct hatch_patch *patch, const struct hatch_outline *outline,
                       const struct hatch_obstacles *obstacles, double floor);

/* The smallest radius with which the core holds the first face. */
double hatch_patch_least(const struct hatch_patch *patch, const struct hatch_outline *outline);

/* Grows and places a patch that begins at a face, within the limits. least: the radius below which it
 * is given up. */
struct hatch_patch_notes {
    bool cut;      /* its faces end inside its outline */
    bool enlarged; /* the outline is larger than was wished */
    bool given_up;
    uint64_t placed; /* faces in all systems solved */
};
enum hatch_status hatch_patch_make(struct hatch_growth *growth, struct hatch_solver *solver,
                                   const struct hatch_lapped_options *options, uint32_t seed, double least,
                                   struct hatch_patch_notes *notes, struct hatch_err *err) HATCH_MUST_USE;

/* Who covers what. Patches are laid under those that were there: a face is left out of a patch once
 * the cores of earlier ones cover it. */
struct hatch_cover_entry {
    uint32_t next;     /* of the same face, or UINT32_MAX */
    double mask[3][2]; /* of the face's corners */
};

struct hatch_cover {
    const struct hatch_outline *outline;
    struct hatch_arena *arena;
    uint8_t *covered; /* per face */
    uint32_t *head;   /* per face: its first entry */
    struct hatch_cover_entry *entries;
    uint32_t entry_count, entry_room;
};

enum hatch_status hatch_cover_make(const struct hatch_outline *outline, uint32_t face_count, struct hatch_arena *arena,
                                   struct hatch_cover *cover, struct hatch_err *err) HATCH_MUST_USE;

/* Adds a face of a patch. *shows: whether the patch may be seen on it. covered[face] is set once the cores hold
 * the whole face, and never where they do not. */
enum hatch_status hatch_cover_add(struct hatch_cover *cover, uint32_t face, const double mask[3][2], bool *shows,
                                  struct hatch_err *err) HATCH_MUST_USE;

struct hatch_order_item {
    uint32_t key, face;
};

/* Where the next patch begins. */
struct hatch_order {
    const struct hatch_ground *ground;
    double core; /* radius of the core over that of the outline's square */
    const uint8_t *covered;
    double *distance; /* per face: to covered ground, or infinite */
    double *middle;   /* 3 a face */
    uint8_t *late;    /* per face: no patch begins here before gaps are filled */
    uint32_t *smooth; /* faces of the component, smoothest first */
    uint32_t smooth_count, smooth_next;
    struct hatch_order_item *items, *spare; /* per face: to sort them */
    struct hatch_heap wave, front, gaps;
    bool filling; /* only gaps are left */
    uint32_t first_face, face_count;
};

enum hatch_status hatch_order_make(const struct hatch_ground *ground, const struct hatch_outline *outline,
                                   const uint8_t *covered, struct hatch_arena *arena, struct hatch_order *order,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Goes on to a component. */
void hatch_order_component(struct hatch_order *order, uint32_t component);

/* The next face to begin with, or HATCH_NO_SIDE when the component is covered. */
enum hatch_status hatch_order_next(struct hatch_order *order, uint32_t *face, struct hatch_err *err) HATCH_MUST_USE;

/* Tells of faces newly covered. */
enum hatch_status hatch_order_covered(struct hatch_order *order, const uint32_t *faces, uint32_t count,
                                      struct hatch_err *err) HATCH_MUST_USE;

#endif
