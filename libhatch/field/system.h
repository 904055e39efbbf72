/* Inside topo/field: the energy of a line field as a Hermitian system, and how it is solved.
 *
 * E(z) = z*Az - 2 Re b*z + constant, A = diagonal - link: a link of node p to q is w e^(2i turn). A point of a
 * component with one side (a Möbius strip) is two nodes, z and its conjugate, which is z seen from the other side:
 * the orientable double cover, where every link is a rotation. The minimum there is that of the component twice. */
#ifndef HATCH_TOPO_FIELD_SYSTEM_H
#define HATCH_TOPO_FIELD_SYSTEM_H

#include "field/field.h"

/* Complex numbers are pairs of doubles, real part first. */
struct hatch_field_system {
    uint32_t count;
    uint32_t *first; /* count + 1: links of node n are first[n] .. first[n + 1] - 1 */
    uint32_t *to;
    double *link;     /* 2 a link */
    double *diagonal; /* per node: sum of its edges' weights and its data's */
    double *mass;     /* per node: the data's weight, part of the diagonal */
    double *right;    /* 2 a node: b, mass times the data */
    uint32_t *order;  /* the surface's points as hatch_surface_order has them: nodes follow one another so */
    uint32_t *node;   /* per point of the surface: its first node (of two on a component with one side), or
                         HATCH_NO_SIDE where the point is not in the system */
};

/* z of a direction at a point: its unit vector in the plane, squared. 0 where it has no part in the plane. */
void hatch_field_square(const struct hatch_frames *frames, uint32_t point, const double direction[3], double z[2]);

/* What a component's data weighs. */
struct hatch_field_scale {
    bool directed; /* false: no data to speak of; all masses are 0 */
    double length; /* over which the field is smoothed where confidence is 1/2, in mean edges */
};

struct hatch_field_scale hatch_field_scale_of(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                              const struct hatch_field_data *data, double smooth, uint32_t component);

/* The data's weight at a point of the component: m of field/field.h. */
double hatch_field_mass(const struct hatch_surface *surface, const struct hatch_frames *frames,
                        const struct hatch_field_data *data, const struct hatch_field_scale *scale, uint32_t point);

/* Σ w |z_p - turn(z_q)|² and Σ m |z_p - d_p|², each component once. */
void hatch_field_system_energy(const struct hatch_surface *surface, const struct hatch_field_system *system,
                               const double *z, double energy[2]);

/* The system of the components that include[] names (per component). */
enum hatch_status hatch_field_assemble(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                       const struct hatch_field_data *data, const struct hatch_field_scale *scales,
                                       const bool *include, struct hatch_arena *arena,
                                       struct hatch_field_system *system, struct hatch_err *err) HATCH_MUST_USE;

/* out = Az. */
void hatch_field_apply(const struct hatch_field_system *system, const double *z, double *out);

/* Σ Re(conj(a) b) over count complex numbers. */
double hatch_field_dot(const double *a, const double *b, uint32_t count);

/* A hierarchy of ever coarser systems: the preconditioner of the multigrid solver. */
struct hatch_field_levels;

enum hatch_status hatch_field_coarsen(const struct hatch_field_system *system, struct hatch_arena *arena,
                                      struct hatch_field_levels **levels, struct hatch_err *err) HATCH_MUST_USE;

/* Solves Az = right by conjugate gradients, preconditioned by a multigrid cycle, from the z given, until the
 * residual is tolerance times the right side's, in the norm of the preconditioner. */
struct hatch_field_progress {
    uint32_t iterations;
    double residual;
};

enum hatch_status hatch_field_iterate(const struct hatch_field_system *system, const struct hatch_field_levels *levels,
                                      const double *right, double tolerance, uint32_t iterations_max,
                                      struct hatch_arena *scratch, double *z, struct hatch_field_progress *progress,
                                      struct hatch_err *err) HATCH_MUST_USE;

/* The same by Cholesky's factors. */
enum hatch_status hatch_field_factor_solve(const struct hatch_field_system *system, size_t limit_bytes,
                                           struct hatch_arena *scratch, double *z,
                                           struct hatch_err *err) HATCH_MUST_USE;

/* For data that is principal directions: gives right the axis that a roughly smooth field lies nearer to, and leaves
 * links over which lines of known axes then still are nearer to a right angle a small share of their weight.
 * z: 0; that rough field, where there are such. */
enum hatch_status hatch_field_loosen_jumps(const struct hatch_surface *surface, const struct hatch_field_data *data,
                                           uint32_t iterations_max, struct hatch_arena *scratch,
                                           struct hatch_field_system *system, double *z,
                                           struct hatch_field_progress *progress, struct hatch_err *err) HATCH_MUST_USE;

/* Least E over fields of |z| = 1, from the unit z given, downhill: L-BFGS on the angles (Liu & Nocedal 1989). */
enum hatch_status hatch_field_descend(const struct hatch_field_system *system, double tolerance,
                                      uint32_t iterations_max, struct hatch_arena *scratch, double *z,
                                      struct hatch_field_progress *progress, struct hatch_err *err) HATCH_MUST_USE;

#endif
