/* Private to the curvature: what its methods share. */
#ifndef HATCH_TOPO_CURVATURE_WORK_H
#define HATCH_TOPO_CURVATURE_WORK_H

#include "curvature/curvature.h"
#include "curvature/bend.h"
#include "curvature/support.h"

/* The smallest support, in mean edges, and its degree: on clean points nothing is more accurate. */
#define HATCH_CURVATURE_RADIUS 2.6
#define HATCH_CURVATURE_DEGREE 4u

/* The points, rings and components of a surface, with its points in the order of hatch_surface_order. */
struct hatch_curvature_terrain {
    struct hatch_surface surface; /* no faces */
    double *normals;              /* 3 a point: the frames', later the best that is known */
    uint32_t *order;              /* per point: its number in the whole surface; NULL on a thinned one */
    /* Of a thinned one, whose points are nodes that stand for several; NULL on others. */
    double *weights;          /* per node: how many points it stands for */
    uint32_t *first, *points; /* node n: points[first[n]] .. points[first[n + 1] - 1] */
    int8_t *sides;            /* per entry of points: -1 where the point's outside is not the node's */
};

/* Memory of the terrain, and a little more: arena. */
enum hatch_status hatch_curvature_order(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                        struct hatch_arena *arena, struct hatch_curvature_terrain *terrain,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* The entries in points of a node; of a point, its own number. */
struct hatch_curvature_span {
    uint32_t first, end;
};

static inline struct hatch_curvature_span hatch_curvature_points(const struct hatch_curvature_terrain *terrain,
                                                                 uint32_t node)
{
    if (!terrain->points)
        return (struct hatch_curvature_span){node, node + 1};
    return (struct hatch_curvature_span){terrain->first[node], terrain->first[node + 1]};
}

/* Joins two or three neighbouring nodes to one in the middle of their points: a large support need not hold them
 * all. The mean of points has the mean of their noise, and a polynomial's mean over a patch much smaller than the
 * support is its value in the middle, but for a constant. finest: the terrain of points, where normals are taken
 * from; may be fine. Memory of the new one, and a little more: arena. */
enum hatch_status hatch_curvature_thin(const struct hatch_curvature_terrain *finest,
                                       const struct hatch_curvature_terrain *fine, struct hatch_arena *arena,
                                       struct hatch_curvature_terrain *coarse, struct hatch_err *err) HATCH_MUST_USE;

/* Points are those of the terrain but in curvature and frames. */
struct hatch_curvature_run {
    struct hatch_curvature_terrain terrain;
    const struct hatch_frames *frames;
    const struct hatch_curvature_options *options;
    struct hatch_pool *pool;
    uint32_t workers;
    struct hatch_support *supports; /* one a worker */
    struct hatch_curvature *curvature;
};

/* Zeroed, from arena. */
enum hatch_status hatch_curvature_allocate(uint32_t points, struct hatch_arena *arena,
                                           struct hatch_curvature *curvature, struct hatch_err *err) HATCH_MUST_USE;

/* Half the last place of a float at a point's largest coordinate, in units of the surface: files hold
 * floats, and no fit is better known than its points. */
double hatch_curvature_grain(const struct hatch_surface *surface, uint32_t point);

/* A fit over a support of the radius wanted, larger where it holds too few points for the degree. */
void hatch_curvature_fit(struct hatch_support *support, uint32_t point, const double normal[3], double radius,
                         uint32_t degree, struct hatch_jet_frame *frame, struct hatch_jet_system *system);

/* Writes what was found for a point. bend: NULL when nothing was. variance: of the curvatures themselves. */
void hatch_curvature_store(const struct hatch_curvature_run *run, uint32_t point, const struct hatch_bend *bend,
                           const struct hatch_bend_variance *variance, double radius);

/* Runs task(context, item, support) for item = 0 .. count - 1, shared out among the workers. A task writes
 * only what is its item's, so that nothing depends on who runs it. */
typedef void (*hatch_curvature_task)(void *context, uint32_t item, struct hatch_support *support);
void hatch_curvature_each(const struct hatch_curvature_run *run, uint32_t count, hatch_curvature_task task,
                          void *context);

/* Supports that grow with the noise. */
enum hatch_status hatch_curvature_adapt(const struct hatch_curvature_run *run, struct hatch_arena *scratch,
                                        struct hatch_err *err) HATCH_MUST_USE;

#endif
