/* Smooth direction fields of 180° symmetry (lines without heads) on a surface.
 *
 * Both methods weigh smoothness over edges against agreement with data at points (curvature
 * directions and constraints), by one energy of z = r e^(2iθ), a complex number a point:
 *     E(z) = Σ_edges w |z_p − turn(z_q)|²  +  Σ_points m |z_p − d_p|²
 * with w of the frames, d the data and m its weight,
 *     m = area c / (1 − c) / length²,  length = 0.0115 √(area of the component) (smooth / (1 − smooth))²
 * so that confidence c counts as odds, like the inverse of a variance (c = 1/2: a smoothing length of `length`;
 * the more certain the shorter: clean data is not smoothed away), and so that a number for `smooth` means the
 * same at any scale and any resolution.
 * linear lets the lengths |z| go free: E has one minimum, found by a sparse solve (Knöppel et al.
 * 2013 §4, aligned). hz keeps |z| = 1: then E is, but for a constant, the paper's sum of −cos
 * 2(θ_p − turned θ_q) and −cos 2(θ_p − data), non-linear, started from the data (Hertzmann &
 * Zorin, "Illustrating smooth surfaces", SIGGRAPH 2000, §5.2, with the 90° made 180°; Real-Time
 * Hatching §6). So linear's minimum is never above hz's. The
 * unit field of that minimum may be: where data disagrees z is short there and costs little, so
 * that what is certain stays as it is, and what noise has made goes; descent from it would lower E
 * and lose both.
 *
 * Principal directions jump by a right angle where the curvatures' absolute values pass one another, though both
 * axes go on: z changes its sign there. Smoothing over such a jump would bend the axes on both sides. So, first, a
 * roughly smooth field says which axis is meant where a few points claim another than all around them; then edges
 * over which lines still are nearer to a right angle than to none count a tenth, where axes are certain. */
#ifndef HATCH_TOPO_FIELD_H
#define HATCH_TOPO_FIELD_H

#include "base/parallel.h"
#include "surface/frames.h"

enum hatch_field_method { HATCH_FIELD_LINEAR, HATCH_FIELD_HZ };
enum hatch_field_solver { HATCH_FIELD_MULTIGRID, HATCH_FIELD_CHOLESKY }; /* of linear: same minimum */

/* What the field should agree with, per point. */
struct hatch_field_data {
    const double *direction;  /* 3: any length, its part in the tangent plane counts */
    const double *confidence; /* 0 .. 1: its odds weigh the term; 0 leaves the point to its neighbours, 1 holds it */
    const double *hard;       /* NULL, or per point the weight of a direction given by hand: 0 none; over 0: direction
                                 is that one, and m is this times the sum of the point's edge weights, whatever
                                 `smooth` and the confidence say */
    bool principal;           /* directions are principal ones, which may jump to the other axis */
};

struct hatch_field_options {
    enum hatch_field_method method;
    enum hatch_field_solver solver;
    double smooth;    /* 0 .. 1, no dimension: 0 keeps the data as it is, 1 keeps no more of it than the smoothest
                         field needs to be turned one way */
    double tolerance; /* multigrid, hz: relative residual at which to stop, 1e-12 .. 1e-1 */
    uint32_t iterations_max;
};

struct hatch_field {
    double *direction;  /* 3 a point: unit, tangent */
    double *confidence; /* 0 .. 1: how much of the data around, weighed as the solution weighs it, agrees; 0 on
                           components without data */
    uint32_t iterations;
    double residual;     /* relative, at the end */
    double energy[2];    /* E of the unit field, its two sums: smoothness, data; with what is said of jumps */
    double solved;       /* E of z as solved (linear; hz: of the unit field) */
    uint32_t undirected; /* components without data (confidence of root mean square under 0.001, and nothing by
                            hand): their field is the smoothest there is, otherwise arbitrary */
};

/* Solves for the field of least energy (see above) on all components; the arrays of *field live in arena. pool: NULL is
 * one thread; the result is the same. */
enum hatch_status hatch_field_solve(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                    const struct hatch_field_data *data, const struct hatch_field_options *options,
                                    struct hatch_pool *pool, struct hatch_arena *arena, struct hatch_arena *scratch,
                                    struct hatch_field *field, struct hatch_err *err) HATCH_MUST_USE;

/* Gives components without data to speak of that are mostly round, at points on hard edges, the direction across which
 * the soft edges there fold, with little confidence: a tube of long faces, all of whose points lie on its rims, bends
 * one way although no fit can be made anywhere (folds as curvature: Cohen-Steiner & Morvan, "Restricted Delaunay
 * triangulations and normal cycle", SoCG 2003). What is mostly flat is hatched calmly, whatever its holes and teeth do.
 * crease_rad: what is hard, over 0 and under π/2; hard: as in hatch_field_data. direction, confidence: of the data,
 * changed. Comes before hatch_field_make_up. */
void hatch_field_follow_folds(const struct hatch_surface *surface, const struct hatch_frames *frames, double crease_rad,
                              const double *hard, double *direction, double *confidence);

/* Gives components without data to speak of (planes, spheres, boxes) lines across the longest of their sides along
 * the axes, as data: the smoothest field of all could lie any way, and swirls on a box. hard: as in
 * hatch_field_data. direction, confidence: of the data, changed. made_up: per component, written. */
void hatch_field_make_up(const struct hatch_surface *surface, const struct hatch_frames *frames, const double *hard,
                         double *direction, double *confidence, bool *made_up);

/* Takes the confidence from components whose data was made up; they count as undirected. */
void hatch_field_own_up(const struct hatch_surface *surface, const bool *made_up, struct hatch_field *field);

/* energy[2] of any unit field, as in hatch_field, of data that is not principal. */
void hatch_field_energy(const struct hatch_surface *surface, const struct hatch_frames *frames,
                        const struct hatch_field_data *data, double smooth, const double *direction, double energy[2]);

/* The index of a face, in half turns: how often the field turns around its border. A line field's
 * index does not depend on the side that the face is seen from. angle_rad: hatch_frames_angle of the field at each
 * point. */
int hatch_field_face_index(const struct hatch_surface *surface, const struct hatch_frames *frames,
                           const double *angle_rad, uint32_t face);

/* The field of a mesh that carries `_HATCH_DIR` (three floats of direction, one of confidence):
 * per point the mean line of its faces' vertices there, weighed by confidence, in the tangent plane.
 * What is not finite or has no tangent part counts as confidence 0; false when the mesh has none.
 * direction: 3 a point; confidence: one. */
bool hatch_field_of_mesh(const struct hatch_surface *surface, const struct hatch_frames *frames,
                         const struct hatch_mesh *mesh, double *direction, double *confidence);

/* The line of a face from its three points, in the face's plane, unit; spread_rad: the largest
 * angle between it and a point's own (0 .. π/2; over π/3 the face is not coherent). */
void hatch_field_face(const struct hatch_surface *surface, const struct hatch_frames *frames, const double *direction,
                      uint32_t face, double line[3], double *spread_rad);

/* The mean of three lines in the plane of two axes, unit and at right angles: z is a line's direction against them
 * at twice its angle, unit, 0 for none. line: unit, u where they cancel; nearest: the cosine of twice the
 * largest angle between it and one of the three. */
void hatch_field_mean(const double z[3][2], const double u[3], const double side[3], double line[3], double *nearest);

/* Faces with an index, and per component the sum of indices (with what borders turn, so that it
 * equals the Euler characteristic, in half turns: twice it). */
struct hatch_singularities {
    uint32_t count;
    uint32_t *faces;               /* rising */
    int8_t *half_turns;            /* index times two */
    int32_t *component_half_turns; /* per component, borders included */
};

/* Finds the singularities of a field of unit directions, 3 a point; the arrays of *found live in arena. */
enum hatch_status hatch_field_singularities(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                            const double *direction, struct hatch_arena *arena,
                                            struct hatch_arena *scratch, struct hatch_singularities *found,
                                            struct hatch_err *err) HATCH_MUST_USE;

#endif
