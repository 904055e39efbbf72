/* Private to the field: the energy as a Hermitian system, and its solvers.
 *
 * E(z) = z*Az - 2 Re b*z + constant, A = diagonal - links; the link from node p to node q is w e^(2i transport). A
 * point of a one-sided component (a Möbius strip) is two nodes, z and its conjugate, which is z seen from the other
 * side: on this orientable double cover every link is a rotation. Its minimum is that of the component, twice. */
#ifndef HATCH_FIELD_SYSTEM_H
#define HATCH_FIELD_SYSTEM_H

#include "field/field.h"

/* Complex numbers are pairs of doubles: real, imaginary. */
struct hatch_field_system {
    uint32_t count;            /* nodes */
    uint32_t component_count;  /* in the system */
    uint32_t *component_first; /* component_count + 1: the nodes of component c are component_first[c] ..
                                  component_first[c + 1] - 1; unset on coarser systems */
    uint32_t *first;           /* count + 1: the links of node n are first[n] .. first[n + 1] - 1 */
    uint32_t *to;              /* per link: the node at its end */
    double *link;              /* 2 per link */
    double *diagonal;          /* per node: sum of its edge weights and data weight */
    double *data_weight;       /* per node: m of field/field.h */
    double *rhs;               /* 2 per node: b, data weight times data */
    uint32_t *order;           /* points in the order of hatch_surface_order_points, which is that of the nodes */
    uint32_t *node; /* per point: its node (the first of two on a one-sided component), or HATCH_NO_SIDE when its
                       component is not in the system */
};

/* Computes z of a direction at a point; 0 when it has no tangent component. */
void hatch_field_encode(const struct hatch_frames *frames, uint32_t point, const double direction[3], double z[2]);

/* The weight of the data on a component. */
struct hatch_field_smoothing {
    bool constrained; /* whether the component has data; all data weights are 0 otherwise */
    double length;    /* in mean edges, of field/field.h */
};

struct hatch_field_smoothing hatch_field_smoothing_of(const struct hatch_field_problem *problem, double smooth,
                                                      uint32_t index);

/* Returns m of field/field.h at a point.
 *   smoothing  of the point's component */
double hatch_field_data_weight(const struct hatch_field_problem *problem, const struct hatch_field_smoothing *smoothing,
                               uint32_t point);

/* Computes both terms of E, counting each component once. */
void hatch_field_system_energy(const struct hatch_surface *surface, const struct hatch_field_system *system,
                               const double *z, double energy[2]);

/* Assembles the system of some components.
 *   smoothing  per component
 *   include    per component
 *   system     out: arrays in arena */
enum hatch_status hatch_field_assemble(const struct hatch_field_problem *problem,
                                       const struct hatch_field_smoothing *smoothing, const bool *include,
                                       struct hatch_arena *arena, struct hatch_field_system *system,
                                       struct hatch_err *err) HATCH_MUST_USE;

/* out = Az. */
void hatch_field_apply(const struct hatch_field_system *system, const double *z, double *out);

/* Returns Σ Re(conj(a) b) over count complex numbers. */
double hatch_field_dot(const double *a, const double *b, uint32_t count);

/* A hierarchy of coarser and coarser systems. */
struct hatch_field_levels;

/* Makes the hierarchy of a system in arena. Refers to the arrays of the system and reorders its links within each
 * row. */
enum hatch_status hatch_field_coarsen(const struct hatch_field_system *system, struct hatch_arena *arena,
                                      struct hatch_field_levels **levels, struct hatch_err *err) HATCH_MUST_USE;

struct hatch_field_convergence {
    uint32_t iterations; /* of all solves so far */
    double residual;     /* of the last solve, as its tolerance, on the component where it is largest */
};

/* Solves Az = rhs by conjugate gradients, preconditioned by a multigrid cycle. The residual of z = rhs / diagonal is
 * the measure, because a few nodes with data that is in effect exact have nearly all of that of z = 0.
 *   levels       of the system
 *   tolerance    of the residual of each component, relative to that of rhs / diagonal in the norm of the
 *                preconditioner
 *   z            in: start, 0 for rhs / diagonal; out: solution
 *   convergence  updated */
enum hatch_status hatch_field_solve_multigrid(const struct hatch_field_levels *levels, double tolerance,
                                              uint32_t iterations_max, struct hatch_arena *scratch, double *z,
                                              struct hatch_field_convergence *convergence,
                                              struct hatch_err *err) HATCH_MUST_USE;

/* Solves Az = rhs by Cholesky factorisation.
 *   limit_bytes  of the factor
 *   z            out */
enum hatch_status hatch_field_solve_cholesky(const struct hatch_field_system *system, size_t limit_bytes,
                                             struct hatch_arena *scratch, double *z,
                                             struct hatch_err *err) HATCH_MUST_USE;

/* Prepares a system of principal directions for jumps: replaces data by the other axis where a roughly smoothed field
 * is nearer to that, then reduces the weight of links across which certain directions differ by over 45°.
 *   z            in: 0; out: the rough field, or 0 when there are no jumps
 *   convergence  updated */
enum hatch_status hatch_field_weaken_jumps(const struct hatch_field_problem *problem, uint32_t iterations_max,
                                           struct hatch_arena *scratch, struct hatch_field_system *system, double *z,
                                           struct hatch_field_convergence *convergence,
                                           struct hatch_err *err) HATCH_MUST_USE;

/* Minimises E over fields of |z| = 1 by L-BFGS on the angles (Liu & Nocedal, "On the limited memory BFGS method for
 * large scale optimization", 1989).
 *   tolerance    of the gradient, as the root mean square angle, on each component, between z and its local optimum, in
 *                radians; a node counts by the weight of its edges and by their share in its optimum, so that exact
 *                data does not count
 *   scratch      for 25 numbers per node
 *   z            in: start, unit; out: solution, unit
 *   convergence  updated */
enum hatch_status hatch_field_descend(const struct hatch_field_system *system, double tolerance,
                                      uint32_t iterations_max, struct hatch_arena *scratch, double *z,
                                      struct hatch_field_convergence *convergence,
                                      struct hatch_err *err) HATCH_MUST_USE;

#endif
