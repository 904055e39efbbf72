/* Private to the curvature: shared by its methods. */
#ifndef HATCH_CURVATURE_WORK_H
#define HATCH_CURVATURE_WORK_H

#include "curvature/curvature.h"
#include "curvature/tensor.h"
#include "curvature/support.h"

/* The smallest support, in mean edges, and its degree: the most accurate choice on clean points. */
#define HATCH_CURVATURE_RADIUS_MIN 2.6
#define HATCH_CURVATURE_DEGREE 4u

/* The points of a surface and their neighbours, in the order of hatch_surface_order_points; or a coarser graph, each
 * node of which stands for several points. */
struct hatch_curvature_graph {
    struct hatch_surface surface; /* nodes, rings and components; no faces */
    double *normals;              /* 3 per node: of the frames, repaired; later those of the fits */
    uint32_t *order;              /* per point: its number in the full surface; NULL on a coarse graph */
    /* Only on a coarse graph, otherwise NULL. */
    double *weights;          /* per node: number of points */
    uint32_t *first, *points; /* points of node n: points[first[n]] .. points[first[n + 1] - 1] */
    int8_t *sides;            /* per entry of points: -1 where the point's outside is not that of the node, else 1 */
    uint32_t *parent;         /* per node of the finer graph: its node here */
    int8_t *parent_side;      /* per node of the finer graph: -1 where its outside is not that of its parent, else 1 */
};

/* Makes the graph of all points; it and temporary memory in arena. */
enum hatch_status hatch_curvature_graph_make(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                             struct hatch_arena *arena, struct hatch_curvature_graph *graph,
                                             struct hatch_err *err) HATCH_MUST_USE;

/* A range of entries of graph->points. */
struct hatch_curvature_members {
    uint32_t first, end;
};

/* Returns the points of a node; on the graph of all points, the number of the node itself. */
static inline struct hatch_curvature_members hatch_curvature_node_members(const struct hatch_curvature_graph *graph,
                                                                          uint32_t node)
{
    if (!graph->points)
        return (struct hatch_curvature_members){node, node + 1};
    return (struct hatch_curvature_members){graph->first[node], graph->first[node + 1]};
}

/* Merges neighbouring nodes in pairs, each at the mean of its points: large supports need not hold all points. The
 * mean of points averages their noise; the mean of a polynomial over a patch much smaller than the support is its
 * value at the centre, up to a constant.
 *   finest  graph of all points; may be fine
 *   arena   for the coarse graph and temporary memory */
enum hatch_status hatch_curvature_graph_coarsen(const struct hatch_curvature_graph *finest,
                                                const struct hatch_curvature_graph *fine, struct hatch_arena *arena,
                                                struct hatch_curvature_graph *coarse,
                                                struct hatch_err *err) HATCH_MUST_USE;

/* One estimation. Points are numbered as in graph; in curvature and frames as in the surface. */
struct hatch_curvature_run {
    struct hatch_curvature_graph graph;
    const struct hatch_frames *frames;
    const struct hatch_curvature_options *options;
    uint32_t workers;
    struct hatch_support *supports; /* one per worker */
    struct hatch_curvature *curvature;
};

/* Returns the degree of fits to the smallest supports, and to those of a given radius. */
static inline uint32_t hatch_curvature_degree(const struct hatch_curvature_run *run)
{
    return run->options->degree ? run->options->degree : HATCH_CURVATURE_DEGREE;
}

/* Allocates zeroed arrays in arena. */
enum hatch_status hatch_curvature_allocate(uint32_t points, struct hatch_arena *arena,
                                           struct hatch_curvature *curvature, struct hatch_err *err) HATCH_MUST_USE;

/* Returns the rounding error of a point's position, in surface units: half the last place of a float at its largest
 * coordinate. Files hold floats, and no fit is more accurate than its points. */
double hatch_curvature_rounding_error(const struct hatch_surface *surface, uint32_t point);

/* Fits a polynomial over a support of a given radius, enlarged where it holds too few points for the degree. */
void hatch_curvature_fit(struct hatch_support *support, uint32_t point, const double normal[3], double radius,
                         uint32_t degree, struct hatch_jet_frame *frame, struct hatch_jet_system *system);

/* Writes the result at a point.
 *   tensor    NULL when no fit succeeded
 *   variance  of the tensor; unused without one */
void hatch_curvature_store(const struct hatch_curvature_run *run, uint32_t point,
                           const struct hatch_curvature_tensor *tensor, const struct hatch_curvature_variance *variance,
                           double radius);

/* Runs task(context, item, support) for item = 0 .. count - 1 on all workers. A task writes only to its item, so that
 * the result does not depend on the worker. */
typedef void (*hatch_curvature_task)(void *context, uint32_t item, struct hatch_support *support);
void hatch_curvature_for_each(const struct hatch_curvature_run *run, uint32_t count, hatch_curvature_task task,
                              void *context);

/* The estimate at a point. */
struct hatch_curvature_sample {
    struct hatch_curvature_tensor tensor;
    struct hatch_curvature_variance variance; /* off_diagonal INFINITY: no fit */
    double radius;                            /* of the support */
};

/* Returns whether the standard error of the direction is at most limit_rad. */
bool hatch_curvature_is_certain(const struct hatch_curvature_sample *sample, double limit_rad);

/* Estimates curvature from the smallest supports.
 *   samples  out: per point
 *   noise    out: per point, variance of its height */
enum hatch_status hatch_curvature_fit_small(const struct hatch_curvature_run *run, struct hatch_arena *scratch,
                                            struct hatch_curvature_sample *samples, double *noise,
                                            struct hatch_err *err) HATCH_MUST_USE;

/* Estimates curvature from large supports, smoothed (curvature/smooth/smooth.h).
 *   noise    per point: variance of its height
 *   wanted   per point; components without wanted points are not fitted
 *   samples  out, where wanted */
enum hatch_status hatch_curvature_smooth(const struct hatch_curvature_run *run, const double *noise, const bool *wanted,
                                         struct hatch_arena *scratch, struct hatch_curvature_sample *samples,
                                         struct hatch_err *err) HATCH_MUST_USE;

/* Estimates curvature from the smallest supports, and where noise leaves a share of a component uncertain also from
 * smoothed ones. */
enum hatch_status hatch_curvature_estimate_adaptive(const struct hatch_curvature_run *run, struct hatch_arena *scratch,
                                                    struct hatch_err *err) HATCH_MUST_USE;

#endif
