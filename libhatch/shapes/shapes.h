/* Built-in shapes, with NORMAL, TANGENT and TEXCOORD_0 in their natural parametrization.
 *
 * TEXCOORD_0 counts repeats of a tile of about HATCH_SHAPE_TILE by HATCH_SHAPE_TILE: u and v run from 0
 * to whole numbers, so that strokes have one size on all shapes and a tile meets itself around closed
 * surfaces. Seen from outside u rises to the right and v downwards: no texture is mirrored. Seams and
 * poles are points of the surface with several vertices, equal in position to the last bit. */
#ifndef HATCH_MESH_SHAPES_H
#define HATCH_MESH_SHAPES_H

#include "mesh/mesh.h"

#define HATCH_SHAPE_TILE 0.65
#define HATCH_SHAPE_FACES_MAX 20000000u

enum hatch_shape {
    HATCH_SHAPE_TEAPOT,    /* Newell's 32 bicubic patches, 3 wide, spout to +x, centred; u runs around
                              wall, lid, handle and spout over all their patches, v along them */
    HATCH_SHAPE_SPHERE,    /* radius 1, u: longitude, v: latitude from the north pole */
    HATCH_SHAPE_CYLINDER,  /* radius 1, height 2, open: u around, v from top to bottom */
    HATCH_SHAPE_CONE,      /* radius 1, height 2, open */
    HATCH_SHAPE_TORUS,     /* radii 1 and 0.4: u around the axis, v around the tube */
    HATCH_SHAPE_PLANE,     /* 2 by 2 in x and y, facing +z */
    HATCH_SHAPE_ELLIPSOID, /* semi-axes 1, 0.7, 0.5 along x, y, z */
    HATCH_SHAPE_SADDLE,    /* z = (x² − y²)/2 over [-1,1]² */
    HATCH_SHAPE_WAVE,      /* z = sin(4x)/8 over [-1,1]² */
    HATCH_SHAPE_COUNT
};

/* How texture coordinates run. The first two give a patch the same range of v. */
enum hatch_shape_uv {
    HATCH_SHAPE_UV_NATURAL, /* with the patch's own parameter */
    HATCH_SHAPE_UV_EVEN,    /* with the length along it: strokes keep their distance */
    HATCH_SHAPE_UV_WHOLE    /* natural, 0 .. 1 once over each surface of the shape: for a picture, a map */
};

struct hatch_shape_options {
    uint32_t faces; /* about how many, 2 .. HATCH_SHAPE_FACES_MAX; the result differs by a grid's
                       rounding */
    float jitter;   /* 0 .. 1: inner vertices move over the surface within jitter times half a grid
                       step (a quarter each way: no triangle turns over), and the diagonals are
                       turned at random: an irregular triangulation */
    float noise;    /* 0 .. 1: standard deviation of a displacement along the normal, as a share of
                       the mean edge; normals stay those of the smooth surface, poles stay */
    uint64_t seed;
    enum hatch_shape_uv uv;
    bool field; /* also make _HATCH_DIR: the first principal direction by hatch_shape_curvature
                   where the vertex stood before noise, confidence 1, or 0 and any tangent
                   where none is defined */
};

/* "teapot" and so on; NULL beyond the last. */
const char *hatch_shape_name(enum hatch_shape shape);

/* Makes the shape. Closed surfaces repeat the vertices of their seam, with the u of each side; poles
 * are one vertex per triangle. */
enum hatch_status hatch_shape_make(enum hatch_shape shape, const struct hatch_shape_options *options,
                                   struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_mesh *mesh,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* The surface's unit normal and first principal direction (of largest |curvature|) at a vertex of a
 * shape made without noise, and both curvatures, the larger |one| first, positive where the surface
 * bends away from the normal (sphere: 1 1); for tests and measurements. false where the direction is
 * not defined (plane, sphere, an umbilic; direction is then zero) or the shape has no closed form
 * (teapot, a cone's apex; nothing is then written). */
bool hatch_shape_curvature(enum hatch_shape shape, const double position[3], double normal[3], double direction[3],
                           double curvature[2]);

#endif
