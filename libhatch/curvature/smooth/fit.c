#include <math.h>
#include <string.h>

#include "math/vector.h"
#include "curvature/smooth/smooth.h"

/* Supports of step n have a radius of RADIUS √2^n mean edges. From step 0 on they are nodes of graphs[n], about
 * the same number each, and are centred at nodes of graphs[n + 1] (step 0: graphs[2]). The supports of the last step
 * consist of points: means of points lie off a curved surface. */
#define RADIUS 7.0
#define STEP_FIRST 4
#define STEP_LAST -1

#define DEGREE 3u             /* Q of a cubic is linear, as smoothing wants it */
#define SIGNIFICANCE 16.0     /* of the difference to degree 4, in variances: the cubic is biased */
#define COUNT_MIN 16u         /* points of a support */
#define BIAS_SIGMA 2.0        /* more of the residual is bias: in its standard deviations beyond the noise */
#define MISFIT_MAX 2.0        /* of the residual, in variances of the noise */
#define NORMAL_COSINE_MIN 0.7 /* between the normals of a fit and of the graph */
#define SAMPLE 16u            /* one node of so many is tried first, */
#define HELD_MIN 0.25         /* and the step left out where fewer of the fits hold */

struct fit {
    struct hatch_jet_frame frame;
    double coefficients[HATCH_JET_TERMS];
    uint32_t degree;       /* 0: none */
    double variance, bias; /* as in hatch_smoothing */
    bool held;             /* the residual is no more than the noise */
};

/* One step. */
struct fitting {
    const struct hatch_smoothing *s;
    const struct hatch_curvature_graph *supports, *nodes;
    double radius;
    uint32_t *support_of, *node_of; /* per point */
    bool *open;                     /* per node of nets[0]: no fit has held yet */
    bool *wanted;                   /* per node of the step */
    struct fit *fits;               /* per node of the step */
};

/* Sets, per point, its node. */
static void number_points(const struct hatch_curvature_graph *graph, uint32_t *node_of)
{
    for (uint32_t n = 0; n < graph->surface.point_count; n++) {
        struct hatch_curvature_members members = hatch_curvature_node_members(graph, n);
        for (uint32_t i = members.first; i < members.end; i++)
            node_of[graph->points ? graph->points[i] : i] = n;
    }
}

#define NEARER 0.999 /* of two at the same distance from their mean, the first counts, whatever the rounding */

/* Returns the node of the supports nearest to a node: a mean of many points would lie off a curved surface. */
static uint32_t center_of(const struct fitting *f, uint32_t node)
{
    const double *position = &f->nodes->surface.points[3 * (size_t)node];
    double least = INFINITY;
    uint32_t best = 0;
    for (uint32_t i = f->nodes->first[node]; i < f->nodes->first[node + 1]; i++) {
        uint32_t center = f->support_of[f->nodes->points[i]];
        double distance = hatch_vec_distance(position, &f->supports->surface.points[3 * (size_t)center]);
        if (distance < NEARER * least) {
            least = distance;
            best = center;
        }
    }
    return best;
}

static double noise_of(const struct fitting *f, uint32_t node)
{
    double sum = 0;
    for (uint32_t i = f->nodes->first[node]; i < f->nodes->first[node + 1]; i++)
        sum += f->s->noise[f->nodes->points[i]];
    return sum / (f->nodes->first[node + 1] - f->nodes->first[node]);
}

/* Least-squares fits of nested degrees differ by the bias of the lower one and by noise, the variance of which is the
 * difference of their variances. */
static uint32_t choose_degree(const struct fitting *f, const struct hatch_jet_system *system, double radius,
                              double noise)
{
    uint32_t fixed = f->s->run->options->degree;
    if (fixed || system->degree == DEGREE)
        return fixed && fixed < system->degree ? fixed : system->degree;
    double low[HATCH_JET_TERMS], high[HATCH_JET_TERMS];
    struct hatch_jet_variance variances[HATCH_JET_DEGREE_MAX + 1], *v = &variances[DEGREE];
    hatch_jet_solve(system, DEGREE, low);
    hatch_jet_solve(system, DEGREE + 1, high);
    hatch_jet_variances(system, variances);
    double skew = (low[3] - high[3]) - (low[5] - high[5]), mixed = low[4] - high[4];
    double expected = noise * (v[1].skew + v[1].mixed - v[0].skew - v[0].mixed);
    return (skew * skew + mixed * mixed) * radius * radius > SIGNIFICANCE * expected ? DEGREE + 1 : DEGREE;
}

static void fit_node(void *context, uint32_t node, struct hatch_support *support)
{
    const struct fitting *f = context;
    struct fit *fit = &f->fits[node];
    struct hatch_jet_sums sums;
    struct hatch_jet_system system;
    *fit = (struct fit){.degree = 0};
    if (!f->wanted[node])
        return;
    uint32_t center = center_of(f, node);
    const double *normal = &f->nodes->normals[3 * (size_t)node];
    hatch_support_gather(support, center, normal, f->radius);
    if (support->count < COUNT_MIN)
        return;
    hatch_support_sums(support, normal, f->radius, &fit->frame, &sums);
    hatch_jet_factorise(&sums, DEGREE + 1, &system);
    if (system.degree < DEGREE)
        return;
    double noise = noise_of(f, node);
    uint32_t degree = choose_degree(f, &system, f->radius, noise), terms = hatch_jet_terms(degree);
    struct hatch_curvature_tensor tensor;
    struct hatch_curvature_variance variance;
    hatch_curvature_tensor_of_system(&fit->frame, &system, degree, &tensor, &variance);
    if (system.count <= terms || hatch_vec_dot(tensor.normal, normal) < NORMAL_COSINE_MIN)
        return;
    double residual = hatch_jet_residual(&system, degree) * f->radius * f->radius / (system.count - terms);
    hatch_jet_solve(&system, degree, fit->coefficients);
    fit->degree = degree;
    fit->variance = variance.off_diagonal * fmax(noise, residual);
    fit->held = residual <= MISFIT_MAX * noise;
    double excess = residual - noise * (1 + BIAS_SIGMA * sqrt(2.0 / (system.count - terms)));
    fit->bias = variance.off_diagonal * (fit->held ? fmax(0, excess) : fmax(noise, residual));
}

/* Fits at one wanted node of SAMPLE, and no longer wants the nodes of components where few of these fits hold. */
static enum hatch_status try_sample(struct fitting *f, struct hatch_arena *scratch, struct hatch_err *err)
{
    uint32_t components = f->nodes->surface.component_count, nodes = f->nodes->surface.point_count, count = 0;
    const uint32_t *component = f->nodes->surface.point_component;
    uint32_t *tried, *held;
    bool *all;
    HATCH_TRY(HATCH_ALLOC(scratch, &tried, components, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &held, components, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &all, nodes, err));
    memcpy(all, f->wanted, nodes * sizeof *all);
    for (uint32_t n = 0; n < nodes; n++)
        f->wanted[n] = all[n] && count++ % SAMPLE == 0;
    hatch_curvature_for_each(f->s->run, nodes, fit_node, f);
    for (uint32_t n = 0; n < nodes; n++) {
        tried[component[n]] += f->wanted[n];
        held[component[n]] += f->wanted[n] && f->fits[n].held;
    }
    for (uint32_t n = 0; n < nodes; n++)
        f->wanted[n] = all[n] && held[component[n]] >= HELD_MIN * tried[component[n]];
    return HATCH_OK;
}

/* Evaluates the fits at the open nodes of nets[0]. One that does not hold is kept until a smaller one replaces it. */
static void take_fits(struct fitting *f, struct hatch_smoothing *s)
{
    const struct hatch_curvature_graph *finest = s->nets[0].graph;
    for (uint32_t n = 0; n < finest->surface.point_count; n++) {
        const struct fit *fit = &f->fits[f->node_of[finest->points[finest->first[n]]]];
        if (!f->open[n] || fit->degree == 0)
            continue;
        double offset[3], x[2], y[2], unit = 1 / fit->frame.radius;
        struct hatch_curvature_tensor tensors[2];
        hatch_vec_sub(&finest->surface.points[3 * (size_t)n], fit->frame.origin, offset);
        x[0] = x[1] = hatch_vec_dot(offset, fit->frame.axes[0]) * unit;
        y[0] = y[1] = hatch_vec_dot(offset, fit->frame.axes[1]) * unit;
        hatch_curvature_tensors_of_jet(&fit->frame, fit->coefficients, fit->degree, x, y, tensors);
        s->tensor[n] = tensors[0];
        s->variance[n] = fit->variance;
        s->bias[n] = fit->bias;
        s->radius[n] = fit->frame.radius;
        f->open[n] = !fit->held;
    }
}

static enum hatch_status run_step(struct fitting *f, struct hatch_smoothing *s, int step, struct hatch_arena *scratch,
                                  struct hatch_err *err)
{
    const struct hatch_curvature_graph *finest = s->nets[0].graph;
    uint32_t level = step > 0 ? (uint32_t)step : 0;
    f->supports = step < 0 ? &s->run->graph : &s->graphs[level];
    f->nodes = &s->graphs[step == 0 ? 2 : level + 1];
    f->radius = RADIUS * pow(2, step / 2.0);
    number_points(f->supports, f->support_of);
    number_points(f->nodes, f->node_of);
    memset(f->wanted, 0, f->nodes->surface.point_count * sizeof *f->wanted);
    for (uint32_t n = 0; n < finest->surface.point_count; n++)
        if (f->open[n])
            f->wanted[f->node_of[finest->points[finest->first[n]]]] = true;
    for (uint32_t i = 0; i < s->run->workers; i++)
        hatch_support_set_surface(&s->run->supports[i], &f->supports->surface, f->supports->normals,
                                  f->supports->weights);
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    if (step > STEP_LAST)
        HATCH_TRY(try_sample(f, scratch, err));
    hatch_arena_rewind(scratch, mark);
    hatch_curvature_for_each(s->run, f->nodes->surface.point_count, fit_node, f);
    take_fits(f, s);
    return HATCH_OK;
}

/* Moves the nodes of nets[0] to points of graphs[0], where the fits are centred. */
static void move_nodes(struct fitting *f, struct hatch_smoothing *s)
{
    f->supports = &s->graphs[0];
    f->nodes = &s->graphs[1];
    number_points(f->supports, f->support_of);
    for (uint32_t n = 0; n < f->nodes->surface.point_count; n++) {
        const double *center = &f->supports->surface.points[3 * (size_t)center_of(f, n)];
        hatch_vec_copy(center, &s->graphs[1].surface.points[3 * (size_t)n]);
    }
}

enum hatch_status hatch_smooth_fit(struct hatch_smoothing *s, struct hatch_arena *scratch, struct hatch_err *err)
{
    struct fitting f = {.s = s};
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    uint32_t nodes = s->graphs[1].surface.point_count, points = s->run->graph.surface.point_count;
    int first = s->graph_count - 2 < STEP_FIRST ? (int)s->graph_count - 2 : STEP_FIRST;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &f.support_of, points, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &f.node_of, points, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &f.open, nodes, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &f.wanted, nodes, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &f.fits, nodes, err));
    for (uint32_t n = 0; n < nodes; n++) {
        f.open[n] = s->wanted[s->graphs[1].surface.point_component[n]];
        s->variance[n] = INFINITY;
    }
    move_nodes(&f, s);
    for (int step = first; step >= STEP_LAST; step--)
        HATCH_TRY(run_step(&f, s, step, scratch, err));
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
