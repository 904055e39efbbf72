/* Private to the curvature: smoothing of second order.
 *
 * The nodes of a net carry Q = (k1 - k2) e^(2iθ), θ the angle of k1 >= k2 in the node's axes, and the mean curvature.
 * Both are linear in the height of a fit, pass smoothly through umbilics and through places where |k1| = |k2|, and so
 * may be smoothed where directions may not. The smoothed field z minimises
 *     Σ c |z - fit|²  +  Σ b |z - plane(z)|²,    c = area / variance of the fit,  b = area strength / h⁴,
 * with plane(z) the linear function fitted to a node and its ring, transported into the node's plane: where z varies
 * linearly, borders included, smoothing changes nothing. */
#ifndef HATCH_CURVATURE_NET_H
#define HATCH_CURVATURE_NET_H

#include "curvature/work.h"

#define HATCH_NET_CHANNELS 3u /* Re Q, Im Q, mean curvature */

/* Nodes, normals and rings are those of the graph. */
struct hatch_curvature_net {
    struct hatch_curvature_graph *graph;
    double *axis;      /* 3 per node: unit tangent of angle 0 */
    double *turn;      /* 2 per ring entry: e^(2iφ), which carries Q from the neighbour to the node */
    double *weight;    /* per ring entry: of the neighbour's value in the linear fit at the node */
    double *own;       /* per node: 1 less the weight of its own value in that fit; 0: the fit is not determined */
    double *area;      /* per node: of its points */
    double *spacing;   /* per node: h, root mean square distance of its neighbours */
    double *certainty; /* per node: c; 0: no fit */
    double *fit;       /* 3 per node: the data */
    double *bending;   /* per node: b */
    double *z;         /* 3 per node: the solution */
    /* Only on a coarser net, otherwise NULL. */
    struct hatch_curvature_net *finer;
    double *parent_turn; /* 2 per node of the finer net: carries Q from it to its parent in the graph */
};

/* Makes a net of a graph whose normals are final; data, strengths and solution are 0.
 *   frames  of the surface; for the areas of its points */
enum hatch_status hatch_curvature_net_make(const struct hatch_curvature_run *run, struct hatch_curvature_graph *graph,
                                           struct hatch_arena *arena, struct hatch_curvature_net *net,
                                           struct hatch_err *err) HATCH_MUST_USE;

/* Makes a net of half as many nodes with the mean of the data, weighted by certainty. */
enum hatch_status hatch_curvature_net_coarsen(const struct hatch_curvature_run *run, struct hatch_curvature_net *finer,
                                              struct hatch_curvature_graph *graph, struct hatch_arena *arena,
                                              struct hatch_curvature_net *net, struct hatch_err *err) HATCH_MUST_USE;

/* Sets z to the linear continuation of the solution on a coarser net. */
enum hatch_status hatch_curvature_net_prolong(const struct hatch_curvature_net *coarser, struct hatch_arena *scratch,
                                              struct hatch_err *err) HATCH_MUST_USE;

/* Minimises from z on, by conjugate gradients, until the residual of each component is below `tolerance` of its data
 * or after steps_max steps. */
enum hatch_status hatch_curvature_net_solve(struct hatch_curvature_net *net, double tolerance, uint32_t steps_max,
                                            struct hatch_arena *scratch, struct hatch_err *err) HATCH_MUST_USE;

/* Value and gradient of z at a node: the linear fit to it and its ring.
 *   slope  out: derivatives along the axis and across it, per channel */
void hatch_curvature_net_slope(const struct hatch_curvature_net *net, uint32_t node,
                               double slope[HATCH_NET_CHANNELS][2]);

/* Carries a value from one node to another.
 *   side  -1 where the outsides differ, else 1
 *   turn  from `from` to the other node */
static inline void hatch_curvature_net_carry(const double from[HATCH_NET_CHANNELS], const double turn[2], int side,
                                             double to[HATCH_NET_CHANNELS])
{
    double re = side * from[0];
    to[0] = turn[0] * re - turn[1] * from[1];
    to[1] = turn[1] * re + turn[0] * from[1];
    to[2] = side * from[2];
}

/* Carries a tangent of one plane to another by the smallest rotation. Normals are unit. */
void hatch_curvature_net_carry_tangent(const double from[3], const double to[3], double tangent[3]);

/* Computes a tensor's matrix, times scale, from a value.
 *   axis  of angle 0 */
void hatch_curvature_net_tensor(const double normal[3], const double axis[3], const double value[HATCH_NET_CHANNELS],
                                double scale, double matrix[6]);

/* Computes the value of a tensor.
 *   axis  unit, in the plane of the tensor's normal */
void hatch_curvature_net_value(const struct hatch_curvature_tensor *tensor, const double axis[3],
                               double value[HATCH_NET_CHANNELS]);

/* Coordinates in a node's plane of an offset from it: the projection, lengthened to the offset's length. */
void hatch_curvature_net_local(const struct hatch_curvature_net *net, uint32_t node, const double offset[3],
                               double at[2]);

#endif
