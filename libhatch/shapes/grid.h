/* Private to the shapes: a surface over a parameter rectangle, and the grid of triangles over it. */
#ifndef HATCH_MESH_SHAPES_GRID_H
#define HATCH_MESH_SHAPES_GRID_H

#include "shapes/shapes.h"

#define HATCH_FORMULA_PIECES_MAX 4u

struct hatch_formula_point {
    double position[3], normal[3]; /* normal: unit, outwards */
    double along_u[3];             /* direction of rising u, unit, orthogonal to the normal */
};

/* Seen from outside, u rises to the right and v downwards, so that no texture is mirrored. u runs
 * from 0 to u_pieces, v from 0 to v_pieces; grid lines stand on every whole number, so that the
 * pieces (the patches of the teapot) keep their borders. */
struct hatch_formula {
    void (*at)(const struct hatch_formula *surface, double u, double v, struct hatch_formula_point *point);
    const void *context;         /* for at */
    uint32_t u_pieces, v_pieces; /* v_pieces: at most HATCH_FORMULA_PIECES_MAX */
    bool wraps_u, wraps_v;
    bool pole_first, pole_last; /* the first or last row is one point */
};

/* Sizes in space, measured on the surface. */
struct hatch_formula_size {
    double u;                           /* mean length of a line of constant v, weighted by area */
    double v[HATCH_FORMULA_PIECES_MAX]; /* mean length of each piece of a line of constant u */
};

/* How fine a surface is cut, and how its texture lies on it. */
struct hatch_grid {
    struct hatch_formula surface;
    uint32_t columns;                               /* over all of u */
    uint32_t rows[HATCH_FORMULA_PIECES_MAX];        /* of each piece of v */
    double u_repeats;                               /* TEXCOORD_0's u at the end of the surface's u */
    double v_texture[HATCH_FORMULA_PIECES_MAX + 1]; /* TEXCOORD_0's v at every whole v */
    const double *v_even; /* NULL, or: share of a piece's length at HATCH_GRID_SAMPLES + 1 even
                             parameters, piece after piece */
};

#define HATCH_GRID_SAMPLES 64u

/* The surface's sizes, by sums over fine pieces of the formula. */
void hatch_formula_measure(const struct hatch_formula *surface, struct hatch_formula_size *size);

/* share[piece * (HATCH_GRID_SAMPLES + 1) + i]: how much of the piece's length lies before parameter
 * i / HATCH_GRID_SAMPLES; for hatch_grid.v_even. */
void hatch_formula_even(const struct hatch_formula *surface, double *share);

/* What hatch_grid_fill will write. */
uint32_t hatch_grid_vertex_count(const struct hatch_grid *grid);
uint32_t hatch_grid_face_count(const struct hatch_grid *grid);

/* Fills the mesh's attributes from first_vertex on and its indices from first_face on. stream: a
 * number of its own for each grid of a shape. mesh: has POSITION, NORMAL, TANGENT, TEXCOORD_0. */
void hatch_grid_fill(const struct hatch_grid *grid, const struct hatch_shape_options *options, uint64_t stream,
                     uint32_t first_vertex, uint32_t first_face, struct hatch_mesh *mesh);

/* Moves the vertices along their normals; vertices of one grid point move alike. distance: standard
 * deviation. */
void hatch_grid_displace(const struct hatch_grid *grid, double distance, uint64_t seed, uint64_t stream,
                         uint32_t first_vertex, struct hatch_mesh *mesh);

/* The surfaces of a shape: 1, or the teapot's 4. */
#define HATCH_SHAPE_SURFACES_MAX 4u
uint32_t hatch_shape_surfaces(enum hatch_shape shape, struct hatch_formula *surfaces);
uint32_t hatch_teapot_surfaces(struct hatch_formula *surfaces);

#endif
