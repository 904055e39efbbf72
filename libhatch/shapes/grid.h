/* Internals of shapes: parametric surfaces, and grids of triangles over them. */
#ifndef HATCH_SHAPES_GRID_H
#define HATCH_SHAPES_GRID_H

#include "shapes/shapes.h"

#define HATCH_PARAMETRIC_PIECES_MAX 4u

struct hatch_parametric_point {
    double position[3], normal[3]; /* normal: unit, outwards */
    double along_u[3];             /* direction of rising u: unit, orthogonal to the normal */
};

/* A surface over 0 .. u_pieces by 0 .. v_pieces. Seen from outside u rises to the right and v downwards. Grid lines run
 * along every whole number, so that the borders of pieces (the patches of the teapot) stay exact. */
struct hatch_parametric {
    void (*at)(const struct hatch_parametric *surface, double u, double v, struct hatch_parametric_point *point);
    const void *context;         /* for at: of the teapot */
    enum hatch_shape shape;      /* for at: of other shapes */
    uint32_t u_pieces, v_pieces; /* v_pieces: at most HATCH_PARAMETRIC_PIECES_MAX */
    bool wraps_u, wraps_v;       /* the surface is closed in this direction */
    bool pole_first, pole_last;  /* v = 0 or v = v_pieces is a single point */
};

/* Numbers of the shapes, for their points and for their curvature. */
#define HATCH_TUBE_RADIUS 0.4
#define HATCH_FRUSTUM_SLOPE 0.25 /* of its radius, 0.75 at y = 0, downwards */
#define HATCH_HELICOID_RISE 0.35
#define HATCH_CATENOID_WAIST 0.5
static const double hatch_superquadric_axes[3] = {1.0, 0.8, 0.6};
static const double hatch_bump_axis[3] = {0.0, 0.6, 0.8};

/* A graph z = f(x, y): height and derivatives. */
struct hatch_height {
    double z, zx, zy, zxx, zxy, zyy;
};

/* Computes the height of a saddle, wave, Monge patch or eggbox; false for other shapes. */
bool hatch_shape_height(enum hatch_shape shape, double x, double y, struct hatch_height *height);

/* Computes the radius of a bump in a direction.
 *   cosine   of the angle between the direction and hatch_bump_axis
 *   slope    out: first and second derivative by the cosine */
double hatch_bump_radius(double cosine, double slope[2]);

/* Lengths measured on the surface. */
struct hatch_parametric_size {
    double u;                              /* mean length of a line of constant v, weighted by area */
    double v[HATCH_PARAMETRIC_PIECES_MAX]; /* per piece: mean length of a line of constant u */
};

/* A grid of triangles over a surface, with its texture coordinates. */
struct hatch_grid {
    struct hatch_parametric surface;
    uint32_t columns;                                  /* over all of u */
    uint32_t rows[HATCH_PARAMETRIC_PIECES_MAX];        /* per piece of v */
    double u_repeats;                                  /* TEXCOORD_0's u at the largest u */
    double v_texture[HATCH_PARAMETRIC_PIECES_MAX + 1]; /* TEXCOORD_0's v at v = 0, 1, 2 .. */
    const double *v_even; /* from hatch_parametric_even; NULL: texture coordinates follow the parameter */
};

#define HATCH_GRID_SAMPLES 64u

/* Measures a surface by sampling. */
void hatch_parametric_measure(const struct hatch_parametric *surface, struct hatch_parametric_size *size);

/* Computes the arc length along v as a share of each piece's.
 *   share  out: [piece * (HATCH_GRID_SAMPLES + 1) + i]: share of the piece's length before i / HATCH_GRID_SAMPLES */
void hatch_parametric_even(const struct hatch_parametric *surface, double *share);

/* Return the number of vertices and faces that hatch_grid_fill writes. */
uint32_t hatch_grid_vertex_count(const struct hatch_grid *grid);
uint32_t hatch_grid_face_count(const struct hatch_grid *grid);

/* Writes the vertices and faces of a grid.
 *   stream        random stream, different for each grid of a shape
 *   first_vertex  index of the first vertex written
 *   first_face    index of the first face written
 *   mesh          has POSITION, NORMAL, TANGENT and TEXCOORD_0 */
void hatch_grid_fill(const struct hatch_grid *grid, const struct hatch_shape_options *options, uint64_t stream,
                     uint32_t first_vertex, uint32_t first_face, struct hatch_mesh *mesh);

/* Displaces the vertices of a grid at random along their normals; vertices of one grid point move alike.
 *   distance      standard deviation
 *   seed, stream  random seed and stream
 *   first_vertex  index of the grid's first vertex */
void hatch_grid_displace(const struct hatch_grid *grid, double distance, uint64_t seed, uint64_t stream,
                         uint32_t first_vertex, struct hatch_mesh *mesh);

/* Fill the surfaces of a shape, and of the teapot; return their number. */
#define HATCH_SHAPE_SURFACES_MAX 4u
uint32_t hatch_shape_surfaces(enum hatch_shape shape, struct hatch_parametric *surfaces);
uint32_t hatch_teapot_surfaces(struct hatch_parametric *surfaces);

#endif
