#include <math.h>

#include "math/vector.h"
#include "curvature/smooth/smooth.h"

#define GRAPHS_MIN 3u      /* the fits need them */
#define NODES_MIN 60u      /* of the coarsest graph */
#define COARSENING_MAX 0.8 /* a graph that keeps more of the nodes is the last */

enum hatch_status hatch_smooth_make_graphs(struct hatch_smoothing *s, struct hatch_arena *scratch,
                                           struct hatch_err *err)
{
    const struct hatch_curvature_graph *finest = &s->run->graph, *fine = finest;
    bool more = true;
    while (s->graph_count < GRAPHS_MIN || (more && s->graph_count < HATCH_SMOOTH_GRAPHS_MAX)) {
        struct hatch_curvature_graph *coarse = &s->graphs[s->graph_count++];
        HATCH_TRY(hatch_curvature_graph_coarsen(finest, fine, scratch, coarse, err));
        uint32_t count = coarse->surface.point_count;
        more = count > NODES_MIN && count < COARSENING_MAX * fine->surface.point_count;
        fine = coarse;
    }
    return HATCH_OK;
}

static enum hatch_status allocate(struct hatch_smoothing *s, struct hatch_arena *scratch, struct hatch_err *err)
{
    uint32_t nodes = s->graphs[1].surface.point_count, components = s->run->graph.surface.component_count;
    HATCH_TRY(HATCH_ALLOC(scratch, &s->tensor, nodes, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &s->variance, nodes, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &s->bias, nodes, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &s->radius, nodes, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &s->wanted, components, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &s->typical, components, err));
    return HATCH_ALLOC(scratch, &s->length, components, err);
}

/* Sets data and certainty of the finest net. The fit's plane is turned into that of the node. */
static void set_data(struct hatch_smoothing *s)
{
    struct hatch_curvature_net *net = &s->nets[0];
    for (size_t n = 0; n < net->graph->surface.point_count; n++) {
        const struct hatch_curvature_tensor *tensor = &s->tensor[n];
        double axis[3];
        if (!(s->variance[n] < INFINITY))
            continue;
        hatch_vec_copy(&net->axis[3 * n], axis);
        hatch_curvature_net_carry_tangent(&net->graph->normals[3 * n], tensor->normal, axis);
        hatch_curvature_net_value(tensor, axis, &net->fit[HATCH_NET_CHANNELS * n]);
        net->certainty[n] = net->area[n] / s->variance[n];
    }
}

static void find_typical(struct hatch_smoothing *s, double *area)
{
    const struct hatch_curvature_net *net = &s->nets[0];
    for (uint32_t n = 0; n < net->graph->surface.point_count; n++) {
        uint32_t c = net->graph->surface.point_component[n];
        s->typical[c] += net->certainty[n];
        area[c] += net->certainty[n] > 0 ? net->area[n] : 0;
    }
    for (uint32_t c = 0; c < s->run->graph.surface.component_count; c++)
        s->typical[c] = s->typical[c] > 0 ? area[c] / s->typical[c] : INFINITY;
}

enum hatch_status hatch_curvature_smooth(const struct hatch_curvature_run *run, const double *noise, const bool *wanted,
                                         struct hatch_arena *scratch, struct hatch_curvature_sample *samples,
                                         struct hatch_err *err)
{
    struct hatch_smoothing *s;
    double *area;
    HATCH_TRY(HATCH_ALLOC(scratch, &s, 1, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &area, run->graph.surface.component_count, err));
    *s = (struct hatch_smoothing){.run = run, .noise = noise};
    HATCH_TRY(hatch_smooth_make_graphs(s, scratch, err));
    HATCH_TRY(allocate(s, scratch, err));
    for (uint32_t p = 0; p < run->graph.surface.point_count; p++)
        if (wanted[p])
            s->wanted[run->graph.surface.point_component[p]] = true;
    s->nets[0].graph = &s->graphs[1];
    HATCH_TRY(hatch_smooth_fit(s, scratch, err));
    HATCH_TRY(hatch_smooth_find_normals(s, scratch, err));
    HATCH_TRY(hatch_curvature_net_make(run, &s->graphs[1], scratch, &s->nets[0], err));
    set_data(s);
    find_typical(s, area);
    for (s->net_count = 1; s->net_count + 1 < s->graph_count; s->net_count++)
        HATCH_TRY(hatch_curvature_net_coarsen(run, &s->nets[s->net_count - 1], &s->graphs[s->net_count + 1], scratch,
                                              &s->nets[s->net_count], err));
    HATCH_TRY(hatch_smooth_solve(s, scratch, err));
    HATCH_TRY(hatch_smooth_correct_normals(s, scratch, err));
    return hatch_smooth_spread(s, wanted, scratch, samples, err);
}
