/* Smooth direction fields of 180° symmetry (lines without heads) on a surface.
 *
 * Both methods weigh, over edges and points, smoothness against agreement with data (curvature directions and
 * constraints). linear: z = r e^(2iθ), one complex number a point; the quadratic energy
 *     Σ_edges w |z_p − turn(z_q)|²  +  Σ_points  area · data weight · |z_p − d_p|²
 * has one minimum, found by a sparse solve (Knöppel et al. 2013 §4, aligned). hz: the paper's own: the sum over
 * edges of −w cos 2(θ_p − turned θ_q) and over points of −data weight · cos 2(θ_p − data), non-linear, started
 * from the data (Hertzmann & Zorin, "Illustrating smooth surfaces", SIGGRAPH 2000, §5.2, with the 90° made 180°;
 * Real-Time Hatching §6). */
#ifndef HATCH_TOPO_FIELD_H
#define HATCH_TOPO_FIELD_H

#include "base/parallel.h"
#include "topo/frames.h"

enum hatch_field_method { HATCH_FIELD_LINEAR, HATCH_FIELD_HZ };
enum hatch_field_solver { HATCH_FIELD_MULTIGRID, HATCH_FIELD_CHOLESKY }; /* of linear: same minimum */

/* What the field should agree with, per point. */
struct hatch_field_data {
    const double *direction;  /* 3: any length, its part in the tangent plane counts */
    const double *confidence; /* 0 .. 1: weight of the term; 0 leaves the point to its neighbours */
    const double *hard;       /* NULL, or per point the weight of a direction given by hand instead: 0 none, over 0
                                 replaces the confidence; not limited to 1 */
};

struct hatch_field_options {
    enum hatch_field_method method;
    enum hatch_field_solver solver;
    double smooth;       /* 0 .. 1, no dimension: 0 keeps the data as it is, 1 keeps no more of it than the smoothest
                            field needs to be turned one way; the same number means the same at any scale,
                            resolution and position */
    double tolerance;    /* multigrid, hz: relative change at which to stop, 1e-12 .. 1e-1 */
    uint32_t iterations_max;
};

struct hatch_field {
    double *direction;   /* 3 a point: unit, tangent */
    double *confidence;  /* 0 .. 1: |z|, how much the neighbours and the data agree */
    uint32_t iterations;
    double residual;     /* relative, at the end */
    double energy[2];    /* of the unit field: smoothness, data; as hz weighs them, less its least: 0 is best */
    uint32_t undirected; /* components that have no data at all: their field is smooth and arbitrary */
};

enum hatch_status hatch_field_solve(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                    const struct hatch_field_data *data,
                                    const struct hatch_field_options *options, struct hatch_pool *pool,
                                    struct hatch_arena *arena, struct hatch_arena *scratch,
                                    struct hatch_field *field, struct hatch_err *err) HATCH_MUST_USE;

/* energy[2] of any unit field, as in hatch_field. */
void hatch_field_energy(const struct hatch_surface *surface, const struct hatch_frames *frames,
                        const struct hatch_field_data *data, double smooth, const double *direction,
                        double energy[2]);

/* The index of a face, in half turns: how often the field turns around its border (for a triangle -1, 0 or 1). 0 on a
 * component that is not orientable where no sign can be given. */
int hatch_field_face_index(const struct hatch_surface *surface, const struct hatch_frames *frames,
                           const double *direction, uint32_t face);

/* Faces with an index, and per component the sum of indices (with what borders turn, so that it equals the Euler
 * characteristic, in half turns: twice it). */
struct hatch_singularities {
    uint32_t count;
    uint32_t *faces;     /* rising */
    int8_t *half_turns;  /* index times two */
    int32_t *component_half_turns; /* per component, borders included */
};

enum hatch_status hatch_field_singularities(const struct hatch_surface *surface,
                                            const struct hatch_frames *frames, const double *direction,
                                            struct hatch_arena *arena, struct hatch_arena *scratch,
                                            struct hatch_singularities *found, struct hatch_err *err)
    HATCH_MUST_USE;

#endif
