/* Strokes that lie on a mesh: curves whose points are places on faces, so that they follow the mesh when it moves
 * (strokes(5)). trace/trace.h makes them.
 *
 * A set holds the strokes of one family (the strokes of one direction) and one level (the strokes that halve the gaps
 * of the level before). Each point has a threshold: the stroke is drawn there where the strokes that are wanted, per
 * unit of length across them, are at least as many. Sets are ordered by family, then by level, and the strokes of a set
 * by their least threshold, so that the strokes of a lighter picture come before those of a darker one. */
#ifndef HATCH_CURVE_CURVES_H
#define HATCH_CURVE_CURVES_H

#include "mesh/mesh.h"

#define HATCH_CURVE_FAMILIES_MAX 8u
#define HATCH_CURVE_LEVELS_MAX 16u
#define HATCH_CURVE_ID_MAX 0x3fffffffu
#define HATCH_CURVE_LENGTH_MAX 1000.0 /* gaps */

struct hatch_curve_point {
    uint32_t face;   /* of the mesh */
    float share[2];  /* barycentric coordinates of the face's corners 1 and 2; that of corner 0 is the rest to 1 */
    float threshold; /* strokes per mesh unit, greater than 0 */
    float width; /* of a narrow face that the point lies on, along the strokes of the family `across`, in mesh units;
                    0: of none */
    uint32_t across; /* the family whose strokes cross the narrow face by the shortest way; 0 without one */
};

struct hatch_curve {
    uint32_t first, count; /* its points: at least two */
    uint32_t id;           /* a hash, at most HATCH_CURVE_ID_MAX: the same for the same stroke whenever it is traced */
    uint32_t free_ends;    /* bit 0: the first point, bit 1: the last: the surface and its direction go on there */
};

struct hatch_curve_set {
    uint32_t family, level;
    float angle_rad;       /* from the direction field to the strokes, counter-clockwise seen from outside */
    float gap;             /* mean gap between strokes where this level is complete, in mesh units */
    uint32_t first, count; /* its curves */
    float length;   /* greatest length of a stroke, in gaps of its level, <= HATCH_CURVE_LENGTH_MAX; 0: unknown */
    float hard_rad; /* strokes end at edges with a larger angle, 0 .. pi; under 0: unknown */
};

/* The strokes of a mesh. Zeroed: none. */
struct hatch_curves {
    uint32_t set_count, count, point_count;
    struct hatch_curve_set *sets;
    struct hatch_curve *curves;       /* count of them; their points are consecutive, without gaps */
    struct hatch_curve_point *points; /* point_count of them */
    float needs; /* tolerance of the needs of views that the strokes were made for (needs(5)), over 0 .. 1; 0: they were
                    made for any view */
    float finest; /* with needs: gap of the finest level that those views ask for, in mesh units, over 0, whether it has
                     strokes or not */
};

/* Computes the position of a point, in mesh units. */
void hatch_curve_position(const struct hatch_mesh *mesh, const struct hatch_curve_point *point, float position[3]);

/* Checks strokes from a file.
 *   mesh  that they lie on
 * HATCH_BAD_INPUT for a face that does not exist, a place outside of its face, a threshold that is not greater than 0,
 * and sets out of order. */
enum hatch_status hatch_curves_check(const struct hatch_curves *curves, const struct hatch_mesh *mesh,
                                     struct hatch_err *err) HATCH_MUST_USE;

/* Finds the place on a face that is nearest to a position.
 *   face      of the mesh
 *   position  in mesh units
 *   share     out: barycentric coordinates of corners 1 and 2
 * Returns false if the position is farther from the face than rounding can place it. */
bool hatch_curve_find_share(const struct hatch_mesh *mesh, uint32_t face, const float position[3], float share[2]);

/* Names of the attributes of hatch_curves_as_vertices, besides POSITION, JOINTS_0, WEIGHTS_0 and morph targets. Their
 * values are whole numbers of 16 bits. */
#define HATCH_CURVE_FACE "_HATCH_FACE"     /* 2: the face's number: its low and its high 16 bits */
#define HATCH_CURVE_STROKE "_HATCH_STROKE" /* 2: the threshold's code; at a stroke's ends, half of its id */
#define HATCH_CURVE_NARROW                                                                                             \
    "_HATCH_NARROW" /* 2: on a narrow face 1 + the family across, and the width's code; else 0. Missing where under a  \
                       hundredth of the points lie on one */

#define HATCH_CURVE_CODE_STEPS 4096.0   /* codes of thresholds and widths in an octave */
#define HATCH_CURVE_CODE_MIDDLE 32768.0 /* that of one stroke per gap of the set, and of a width of one gap */
#define HATCH_CURVE_HALF_BITS 15u       /* bits of half an id; the one above them is set where the end is free */

#define HATCH_CURVE_PART_MAX 65535u /* vertices that indices of 16 bits name; the largest index is reserved */

/* Returns the part of a set that begins with its curve `first`, a number among all curves: as many curves as have
 * HATCH_CURVE_PART_MAX points together, and at least one. */
struct hatch_curve_set hatch_curve_set_part(const struct hatch_curves *curves, const struct hatch_curve_set *set,
                                            uint32_t first);

/* Makes the points of a set the vertices of a mesh without faces, whose indices are pairs: the ends of each line from a
 * point to the next of the same stroke. Where the surface has joints or morph targets, so have its points: of the
 * joints of a face's corners, the four that weigh most. Thresholds are rounded to 1/HATCH_CURVE_CODE_STEPS of an octave
 * and limited to 8 octaves around one stroke per gap.
 *   set         or a part of one
 *   vertices    out: in arena; face_count is 0
 *   line_count  out: pairs in vertices->indices */
enum hatch_status hatch_curves_as_vertices(const struct hatch_curves *curves, const struct hatch_curve_set *set,
                                           const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                           struct hatch_mesh *vertices, uint32_t *line_count,
                                           struct hatch_err *err) HATCH_MUST_USE;

/* Makes the curves of a set from such vertices: the opposite of hatch_curves_as_vertices, but for rounding.
 *   vertices    has the two attributes above
 *   indices     2 * line_count vertices
 *   gap         of the set
 *   mesh        that the strokes lie on
 *   curves      in, out: the set's curves and points are appended; its arrays have room for line_count curves and
 *               vertices->vertex_count points more
 * HATCH_BAD_INPUT where an attribute is missing or has a number that is not one of 16 bits, a face does not exist, a
 * position is not on its face, or a line does not join a vertex to the next. */
enum hatch_status hatch_curves_from_vertices(const struct hatch_mesh *vertices, const uint32_t *indices,
                                             uint32_t line_count, float gap, const struct hatch_mesh *mesh,
                                             struct hatch_curves *curves, struct hatch_err *err) HATCH_MUST_USE;

#endif
