/* Private to the curvature: noisy points take their curvature from a smoothed net (curvature/smooth/net.h). The steps
 * of hatch_curvature_smooth, one file each. */
#ifndef HATCH_CURVATURE_SMOOTH_H
#define HATCH_CURVATURE_SMOOTH_H

#include "curvature/smooth/net.h"

#define HATCH_SMOOTH_GRAPHS_MAX 24u

/* Graphs and nets by rising coarseness. nets[k] lies on graphs[k + 1], which has half the nodes of graphs[k]; graphs[0]
 * has half the points of the surface. `Nodes` without more are those of nets[0]. */
struct hatch_smoothing {
    const struct hatch_curvature_run *run;
    const double *noise; /* per point: variance of its height */
    uint32_t graph_count, net_count;
    struct hatch_curvature_graph graphs[HATCH_SMOOTH_GRAPHS_MAX];
    struct hatch_curvature_net nets[HATCH_SMOOTH_GRAPHS_MAX - 1];
    /* Per node: the fit. */
    struct hatch_curvature_tensor *tensor;
    double *variance; /* of its off-diagonal entry; INFINITY: no fit */
    double *bias;     /* part of it by which the residual exceeds the noise */
    double *radius;
    /* Per component. */
    bool *wanted;    /* whether a point of it wants a smoothed sample; the others have no fits */
    double *typical; /* mean variance of the fits; INFINITY: no fit */
    double *length;  /* smoothing length, in mean edges */
};

/* Coarsens the graph of the run until few nodes are left. */
enum hatch_status hatch_smooth_make_graphs(struct hatch_smoothing *s, struct hatch_arena *scratch,
                                           struct hatch_err *err) HATCH_MUST_USE;

/* Fits polynomials at the nodes: of the largest supports whose residual is no more than the noise. */
enum hatch_status hatch_smooth_fit(struct hatch_smoothing *s, struct hatch_arena *scratch,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Gives the nodes the means of the fits' normals around them: transport between noisy normals would turn at random. */
enum hatch_status hatch_smooth_find_normals(struct hatch_smoothing *s, struct hatch_arena *scratch,
                                            struct hatch_err *err) HATCH_MUST_USE;

/* The same with the solution: means of the normals that the curvature of the neighbours predicts, free of the bias
 * that a mean over a curved surface has. The axes of the nodes follow. */
enum hatch_status hatch_smooth_correct_normals(struct hatch_smoothing *s, struct hatch_arena *scratch,
                                               struct hatch_err *err) HATCH_MUST_USE;

/* Finds the smoothing lengths and the solution. */
enum hatch_status hatch_smooth_solve(struct hatch_smoothing *s, struct hatch_arena *scratch,
                                     struct hatch_err *err) HATCH_MUST_USE;

/* Computes the solution at points.
 *   wanted   per point
 *   samples  out, where wanted: variance.off_diagonal is INFINITY where no fit is near */
enum hatch_status hatch_smooth_spread(const struct hatch_smoothing *s, const bool *wanted, struct hatch_arena *scratch,
                                      struct hatch_curvature_sample *samples, struct hatch_err *err) HATCH_MUST_USE;

#endif
