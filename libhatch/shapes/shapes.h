/* Built-in shapes with NORMAL, TANGENT and TEXCOORD_0.
 *
 * TEXCOORD_0 counts repeats of a tile of about HATCH_SHAPE_TILE by HATCH_SHAPE_TILE: u and v run from 0 to whole
 * numbers, so that strokes have one size on all shapes and a texture has no seam on closed surfaces. Seen from outside
 * u rises to the right and v downwards: no texture is mirrored. Points on seams and at poles have several vertices,
 * equal in position to the last bit. */
#ifndef HATCH_SHAPES_SHAPES_H
#define HATCH_SHAPES_SHAPES_H

#include "mesh/mesh.h"

#define HATCH_SHAPE_TILE 0.65
#define HATCH_SHAPE_FACES_MAX 20000000u

enum hatch_shape {
    HATCH_SHAPE_TEAPOT,    /* Newell's 32 bicubic patches, 3 wide, spout to +x, centred; u runs around wall, lid, handle
                              and spout across their patches, v along them */
    HATCH_SHAPE_SPHERE,    /* radius 1; u: longitude, v: latitude from the north pole */
    HATCH_SHAPE_CYLINDER,  /* radius 1, height 2, open; u around, v from top to bottom */
    HATCH_SHAPE_CONE,      /* radius 1, height 2, open */
    HATCH_SHAPE_TORUS,     /* radii 1 and 0.4; u around the axis, v around the tube */
    HATCH_SHAPE_PLANE,     /* 2 by 2 in x and y, facing +z */
    HATCH_SHAPE_ELLIPSOID, /* semi-axes 1, 0.7, 0.5 along x, y, z */
    HATCH_SHAPE_SADDLE,    /* z = (x² − y²)/2 over [-1,1]² */
    HATCH_SHAPE_WAVE,      /* z = sin(4x)/8 over [-1,1]² */
    HATCH_SHAPE_FRUSTUM,   /* cone from radius 1 to radius 0.5, height 2, open */
    HATCH_SHAPE_MONGE,     /* z = sin(2x) cos(1.5y)/4 + x²/10 over [-1,1]² */
    HATCH_SHAPE_EGGBOX,    /* z = 0.15 sin(3x) sin(3y) over [-1,1]² */
    HATCH_SHAPE_SUPERQUADRIC, /* x⁴ + (y/0.8)⁴ + (z/0.6)⁴ = 1 */
    HATCH_SHAPE_BUMP,         /* sphere of radius 1 with a bump, 0.25 high, within 60° of (0, 0.6, 0.8) */
    HATCH_SHAPE_HELICOID,     /* (s cos t, 0.35 t, -s sin t), s in [-1,1], t in [-π,π]: a minimal surface */
    HATCH_SHAPE_CATENOID,     /* radius 0.5 cosh(2y) around y, y in [-0.75,0.75]: a minimal surface */
    HATCH_SHAPE_COUNT
};

/* Distribution of texture coordinates. A patch of the teapot has the same range of v in the first two. */
enum hatch_shape_uv {
    HATCH_SHAPE_UV_NATURAL, /* proportional to the patch's parameter */
    HATCH_SHAPE_UV_EVEN,    /* v proportional to the length along the patch: strokes have an even distance */
    HATCH_SHAPE_UV_WHOLE    /* natural, 0 .. 1 once over each surface of the shape: for pictures and maps */
};

struct hatch_shape_options {
    uint32_t faces; /* approximate number, 2 .. HATCH_SHAPE_FACES_MAX; the grid has whole rows */
    float jitter; /* 0 .. 1: inner vertices move over the surface by up to jitter times a quarter of a grid step in each
                     direction, along u divided by stretch, and diagonals are chosen at random. No triangle turns over
                     where triangles are small against the radius of curvature */
    float stretch; /* 1 .. 16: ratio of the sides of a grid cell, along u and along v; 0: 1 */
    float noise;   /* 0 .. 1: standard deviation of a displacement along the normal, in mean edge lengths; normals stay
                      those of the smooth surface, poles are not displaced */
    uint64_t seed; /* random seed */
    enum hatch_shape_uv uv;
    bool field; /* add _HATCH_DIR: the first principal direction by hatch_shape_curvature at the vertex without noise,
                   with confidence 1; where the curvatures differ by less than 0.01 of the sum of their absolute
                   values, the tangent with confidence 0 */
};

/* "teapot" and so on, in the order of enum hatch_shape; NULL at the end. */
extern const char *const hatch_shape_names[HATCH_SHAPE_COUNT + 1];

/* Makes a shape. Closed surfaces have two vertices at each point of their seam, with the u of either side; poles have a
 * vertex per triangle.
 *   mesh  out: in arena */
enum hatch_status hatch_shape_make(enum hatch_shape shape, const struct hatch_shape_options *options,
                                   struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_mesh *mesh,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Computes the true normal and curvature of a shape in closed form; false where the first principal direction is
 * undefined (on a plane, a sphere, at an umbilic: direction is then zero) and for shapes without a closed form (the
 * teapot, the cone's apex: nothing is then written).
 *   position   of a vertex of the shape made without noise
 *   normal     out: unit
 *   direction  out: first principal direction (of the curvature with the larger absolute value), unit
 *   curvature  out: the one with the larger absolute value first; positive where the surface bends away from the normal
 *              (1, 1 on the sphere) */
bool hatch_shape_curvature(enum hatch_shape shape, const double position[3], double normal[3], double direction[3],
                           double curvature[2]);

#endif
