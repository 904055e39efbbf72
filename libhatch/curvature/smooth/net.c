#include "curvature/smooth/net.h"

#include <string.h>

#include "math/vector.h"

#define STRETCH_MAX 2.0 /* of a steep offset laid into a plane */
#define COLLINEAR 1e-6  /* added to the moments of a ring, in squared spacings: the nodes may lie on a line */

void hatch_curvature_net_carry_tangent(const double from[3], const double to[3], double tangent[3])
{
    double sum[3], cosine = hatch_vec_dot(from, to);
    for (int k = 0; k < 3; k++)
        sum[k] = from[k] + to[k];
    if (cosine > -0.999)
        hatch_vec_add_scaled(tangent, -hatch_vec_dot(tangent, to) / (1 + cosine), sum, tangent);
    hatch_vec_normalize(tangent);
}

/* Computes e^(2iφ), with φ the angle of a tangent after the smallest rotation between two planes.
 *   side  -1 where the normal `from` is on the other side, else 1 */
static void find_turn(const double from[3], const double tangent[3], double side, const double to[3],
                      const double axis[3], double turn[2])
{
    double turned[3] = {side * from[0], side * from[1], side * from[2]}, moved[3], across[3];
    hatch_vec_copy(tangent, moved);
    hatch_curvature_net_carry_tangent(turned, to, moved);
    hatch_vec_cross(to, axis, across);
    double x = hatch_vec_dot(moved, axis), y = hatch_vec_dot(moved, across), square = x * x + y * y;
    turn[0] = square > 0 ? (x * x - y * y) / square : 1;
    turn[1] = square > 0 ? 2 * x * y / square : 0;
}

void hatch_curvature_net_local(const struct hatch_curvature_net *net, uint32_t node, const double offset[3],
                               double at[2])
{
    const double *normal = &net->graph->normals[3 * (size_t)node], *axis = &net->axis[3 * (size_t)node];
    double across[3];
    hatch_vec_cross(normal, axis, across);
    at[0] = hatch_vec_dot(offset, axis);
    at[1] = hatch_vec_dot(offset, across);
    double square = at[0] * at[0] + at[1] * at[1];
    double stretch = square > 0 ? fmin(sqrt(hatch_vec_dot(offset, offset) / square), STRETCH_MAX) : 1;
    at[0] *= stretch;
    at[1] *= stretch;
}

void hatch_curvature_net_tensor(const double normal[3], const double axis[3], const double value[HATCH_NET_CHANNELS],
                                double scale, double matrix[6])
{
    double across[3], xx = scale * (value[2] + value[0] / 2), yy = scale * (value[2] - value[0] / 2);
    hatch_vec_cross(normal, axis, across);
    for (int row = 0, entry = 0; row < 3; row++)
        for (int column = row; column < 3; column++, entry++)
            matrix[entry] = xx * axis[row] * axis[column] + yy * across[row] * across[column] +
                            scale * value[1] / 2 * (axis[row] * across[column] + across[row] * axis[column]);
}

void hatch_curvature_net_value(const struct hatch_curvature_tensor *tensor, const double axis[3],
                               double value[HATCH_NET_CHANNELS])
{
    double across[3];
    hatch_vec_cross(tensor->normal, axis, across);
    double xx = hatch_curvature_tensor_form(tensor, axis, axis),
           yy = hatch_curvature_tensor_form(tensor, across, across);
    value[0] = xx - yy;
    value[1] = 2 * hatch_curvature_tensor_form(tensor, axis, across);
    value[2] = (xx + yy) / 2;
}

static void local_of_entry(const struct hatch_curvature_net *net, uint32_t node, uint32_t entry, double at[2])
{
    const double *points = net->graph->surface.points;
    double offset[3];
    hatch_vec_sub(&points[3 * (size_t)net->graph->surface.ring_point[entry]], &points[3 * (size_t)node], offset);
    hatch_curvature_net_local(net, node, offset, at);
}

/* The inverse of the moments of 1, x, y over a node and its ring. */
struct plane {
    double inverse[3][3];
    bool determined;
};

static void find_plane(const struct hatch_curvature_net *net, uint32_t node, struct plane *plane)
{
    const struct hatch_surface *s = &net->graph->surface;
    uint32_t first = s->ring_first[node], end = s->ring_first[node + 1];
    double one = 1, x = 0, y = 0, xx = 0, xy = 0, yy = 0, spread = COLLINEAR * net->spacing[node] * net->spacing[node];
    for (uint32_t i = first; i < end; i++) {
        double at[2];
        local_of_entry(net, node, i, at);
        one += 1;
        x += at[0];
        y += at[1];
        xx += at[0] * at[0];
        xy += at[0] * at[1];
        yy += at[1] * at[1];
    }
    xx += spread;
    yy += spread;
    double a = xx * yy - xy * xy, b = xy * y - x * yy, c = x * xy - xx * y, determinant = one * a + x * b + y * c;
    plane->determined = end - first >= 3 && determinant > 0;
    if (!plane->determined)
        return;
    const double inverse[3][3] = {
        {a, b, c}, {b, one * yy - y * y, x * y - one * xy}, {c, x * y - one * xy, one * xx - x * x}};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            plane->inverse[i][k] = inverse[i][k] / determinant;
}

static enum hatch_status allocate(const struct hatch_curvature_graph *graph, struct hatch_arena *arena,
                                  struct hatch_curvature_net *net, struct hatch_err *err)
{
    size_t nodes = graph->surface.point_count, entries = graph->surface.ring_first[nodes];
    HATCH_TRY(HATCH_ALLOC(arena, &net->axis, 3 * nodes, err));
    HATCH_TRY(HATCH_ALLOC(arena, &net->turn, 2 * entries, err));
    HATCH_TRY(HATCH_ALLOC(arena, &net->weight, entries, err));
    HATCH_TRY(HATCH_ALLOC(arena, &net->own, nodes, err));
    HATCH_TRY(HATCH_ALLOC(arena, &net->area, nodes, err));
    HATCH_TRY(HATCH_ALLOC(arena, &net->spacing, nodes, err));
    HATCH_TRY(HATCH_ALLOC(arena, &net->certainty, nodes, err));
    HATCH_TRY(HATCH_ALLOC(arena, &net->fit, HATCH_NET_CHANNELS * nodes, err));
    HATCH_TRY(HATCH_ALLOC(arena, &net->bending, nodes, err));
    return HATCH_ALLOC(arena, &net->z, HATCH_NET_CHANNELS * nodes, err);
}

static void measure_node(const struct hatch_curvature_run *run, struct hatch_curvature_net *net, uint32_t node)
{
    const struct hatch_curvature_graph *graph = net->graph;
    const struct hatch_surface *s = &graph->surface;
    const double *normal = &graph->normals[3 * (size_t)node];
    double squares = 0;
    hatch_vec_any_orthogonal(normal, &net->axis[3 * (size_t)node]);
    for (uint32_t i = graph->first[node]; i < graph->first[node + 1]; i++)
        net->area[node] += run->frames->area[run->graph.order[graph->points[i]]];
    uint32_t first = s->ring_first[node], end = s->ring_first[node + 1];
    for (uint32_t i = first; i < end; i++) {
        double length = hatch_vec_distance(&s->points[3 * (size_t)s->ring_point[i]], &s->points[3 * (size_t)node]);
        squares += length * length;
    }
    net->spacing[node] = end > first ? sqrt(squares / (end - first)) : 0;
}

static void link_node(struct hatch_curvature_net *net, uint32_t node)
{
    const struct hatch_curvature_graph *graph = net->graph;
    const struct hatch_surface *s = &graph->surface;
    struct plane plane;
    find_plane(net, node, &plane);
    net->own[node] = plane.determined ? 1 - plane.inverse[0][0] : 0;
    for (uint32_t i = s->ring_first[node]; i < s->ring_first[node + 1]; i++) {
        size_t q = s->ring_point[i];
        double at[2];
        local_of_entry(net, node, i, at);
        find_turn(&graph->normals[3 * q], &net->axis[3 * q], s->ring_turned[i] ? -1 : 1,
                  &graph->normals[3 * (size_t)node], &net->axis[3 * (size_t)node], &net->turn[2 * (size_t)i]);
        net->weight[i] =
            plane.determined ? plane.inverse[0][0] + plane.inverse[0][1] * at[0] + plane.inverse[0][2] * at[1] : 0;
    }
}

enum hatch_status hatch_curvature_net_make(const struct hatch_curvature_run *run, struct hatch_curvature_graph *graph,
                                           struct hatch_arena *arena, struct hatch_curvature_net *net,
                                           struct hatch_err *err)
{
    *net = (struct hatch_curvature_net){.graph = graph};
    HATCH_TRY(allocate(graph, arena, net, err));
    for (uint32_t n = 0; n < graph->surface.point_count; n++)
        measure_node(run, net, n);
    for (uint32_t n = 0; n < graph->surface.point_count; n++)
        link_node(net, n);
    return HATCH_OK;
}

void hatch_curvature_net_slope(const struct hatch_curvature_net *net, uint32_t node,
                               double slope[HATCH_NET_CHANNELS][2])
{
    const struct hatch_surface *s = &net->graph->surface;
    struct plane plane;
    find_plane(net, node, &plane);
    memset(slope, 0, HATCH_NET_CHANNELS * sizeof *slope);
    if (!plane.determined)
        return;
    for (uint32_t k = 0; k < HATCH_NET_CHANNELS; k++)
        for (int i = 0; i < 2; i++)
            slope[k][i] = plane.inverse[i + 1][0] * net->z[HATCH_NET_CHANNELS * (size_t)node + k];
    for (uint32_t e = s->ring_first[node]; e < s->ring_first[node + 1]; e++) {
        double at[2], value[HATCH_NET_CHANNELS];
        local_of_entry(net, node, e, at);
        hatch_curvature_net_carry(&net->z[HATCH_NET_CHANNELS * (size_t)s->ring_point[e]], &net->turn[2 * (size_t)e],
                                  s->ring_turned[e] ? -1 : 1, value);
        for (int i = 0; i < 2; i++) {
            double weight = plane.inverse[i + 1][0] + plane.inverse[i + 1][1] * at[0] + plane.inverse[i + 1][2] * at[1];
            for (uint32_t k = 0; k < HATCH_NET_CHANNELS; k++)
                slope[k][i] += weight * value[k];
        }
    }
}

/* Gives the nodes of a graph the mean normals of the finer net, weighted by area. */
static void mean_normals(const struct hatch_curvature_net *finer, struct hatch_curvature_graph *graph)
{
    double *normals = graph->normals;
    memset(normals, 0, 3 * sizeof *normals * graph->surface.point_count);
    for (uint32_t n = 0; n < finer->graph->surface.point_count; n++) {
        double *sum = &normals[3 * (size_t)graph->parent[n]];
        hatch_vec_add_scaled(sum, graph->parent_side[n] * finer->area[n], &finer->graph->normals[3 * (size_t)n], sum);
    }
    for (uint32_t n = 0; n < graph->surface.point_count; n++)
        hatch_vec_normalize(&normals[3 * (size_t)n]);
}

static void mean_data(struct hatch_curvature_net *net)
{
    const struct hatch_curvature_net *finer = net->finer;
    for (uint32_t n = 0; n < finer->graph->surface.point_count; n++) {
        size_t parent = net->graph->parent[n];
        double value[HATCH_NET_CHANNELS];
        find_turn(&finer->graph->normals[3 * (size_t)n], &finer->axis[3 * (size_t)n], net->graph->parent_side[n],
                  &net->graph->normals[3 * parent], &net->axis[3 * parent], &net->parent_turn[2 * (size_t)n]);
        hatch_curvature_net_carry(&finer->fit[HATCH_NET_CHANNELS * (size_t)n], &net->parent_turn[2 * (size_t)n],
                                  net->graph->parent_side[n], value);
        for (uint32_t k = 0; k < HATCH_NET_CHANNELS; k++)
            net->fit[HATCH_NET_CHANNELS * parent + k] += finer->certainty[n] * value[k];
        net->certainty[parent] += finer->certainty[n];
    }
    for (size_t n = 0; n < net->graph->surface.point_count; n++)
        for (uint32_t k = 0; k < HATCH_NET_CHANNELS && net->certainty[n] > 0; k++)
            net->fit[HATCH_NET_CHANNELS * n + k] /= net->certainty[n];
}

enum hatch_status hatch_curvature_net_coarsen(const struct hatch_curvature_run *run, struct hatch_curvature_net *finer,
                                              struct hatch_curvature_graph *graph, struct hatch_arena *arena,
                                              struct hatch_curvature_net *net, struct hatch_err *err)
{
    mean_normals(finer, graph);
    HATCH_TRY(hatch_curvature_net_make(run, graph, arena, net, err));
    HATCH_TRY(HATCH_ALLOC(arena, &net->parent_turn, 2 * (size_t)finer->graph->surface.point_count, err));
    net->finer = finer;
    mean_data(net);
    return HATCH_OK;
}

enum hatch_status hatch_curvature_net_prolong(const struct hatch_curvature_net *coarser, struct hatch_arena *scratch,
                                              struct hatch_err *err)
{
    struct hatch_curvature_net *finer = coarser->finer;
    const struct hatch_curvature_graph *graph = coarser->graph;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    double(*slopes)[HATCH_NET_CHANNELS][2];
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &slopes, graph->surface.point_count, err));
    for (uint32_t c = 0; c < graph->surface.point_count; c++)
        hatch_curvature_net_slope(coarser, c, slopes[c]);
    for (uint32_t n = 0; n < finer->graph->surface.point_count; n++) {
        size_t c = graph->parent[n];
        double offset[3], at[2], value[HATCH_NET_CHANNELS];
        hatch_vec_sub(&finer->graph->surface.points[3 * (size_t)n], &graph->surface.points[3 * c], offset);
        hatch_curvature_net_local(coarser, (uint32_t)c, offset, at);
        for (uint32_t k = 0; k < HATCH_NET_CHANNELS; k++)
            value[k] = coarser->z[HATCH_NET_CHANNELS * c + k] + slopes[c][k][0] * at[0] + slopes[c][k][1] * at[1];
        const double *turn = &coarser->parent_turn[2 * (size_t)n];
        double *z = &finer->z[HATCH_NET_CHANNELS * (size_t)n];
        z[0] = graph->parent_side[n] * (turn[0] * value[0] + turn[1] * value[1]);
        z[1] = turn[0] * value[1] - turn[1] * value[0];
        z[2] = graph->parent_side[n] * value[2];
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
