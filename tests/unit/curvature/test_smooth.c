#include "curvature_make.h"
#include "fail_alloc.h"
#include "curvature/smooth/smooth.h"

/* A mesh as a run, with the net of half of half of its points. */
struct net_case {
    struct field_case of;
    struct hatch_curvature_options options;
    struct hatch_curvature_run run;
    struct hatch_curvature_graph pairs, nodes;
    struct hatch_curvature_net net;
};

static void make_net(struct net_case *made)
{
    made->run = (struct hatch_curvature_run){.frames = &made->of.frames, .options = &made->options, .workers = 1};
    HATCH_TEST_OK(hatch_curvature_graph_make(&made->of.surface, &made->of.frames, &keep, &made->run.graph, &err), &err);
    HATCH_TEST_OK(hatch_curvature_graph_coarsen(&made->run.graph, &made->run.graph, &keep, &made->pairs, &err), &err);
    HATCH_TEST_OK(hatch_curvature_graph_coarsen(&made->run.graph, &made->pairs, &keep, &made->nodes, &err), &err);
    HATCH_TEST_OK(hatch_curvature_net_make(&made->run, &made->nodes, &keep, &made->net, &err), &err);
}

/* Jittered. */
static void make_plane(struct net_case *made)
{
    made->of = case_with_truth(HATCH_SHAPE_PLANE, 4000, 0);
    make_net(made);
}

static const double gradient[HATCH_NET_CHANNELS][3] = {{1, 2, -1}, {-3, 1, 2}, {0.5, -1, 4}};

/* Per channel, a linear function of the position. */
static double linear_at(const double point[3], uint32_t channel)
{
    return 7 + channel + hatch_vec_dot(point, gradient[channel]);
}

static double linear(const struct hatch_curvature_net *net, uint32_t node, uint32_t channel)
{
    return linear_at(&net->graph->surface.points[3 * (size_t)node], channel);
}

START_TEST(linear_values_stay_up_to_the_border)
{
    struct net_case plane;
    make_plane(&plane);
    struct hatch_curvature_net *net = &plane.net;
    for (uint32_t n = 0; n < net->graph->surface.point_count; n++) {
        net->certainty[n] = 0.1 + hatch_random_unit(1, 0, n);
        net->bending[n] = 1e4;
        for (uint32_t k = 0; k < HATCH_NET_CHANNELS; k++)
            net->fit[HATCH_NET_CHANNELS * n + k] = linear(net, n, k);
    }
    HATCH_TEST_OK(hatch_curvature_net_solve(net, 1e-12, 20000, &scratch, &err), &err);
    for (uint32_t n = 0; n < net->graph->surface.point_count; n++)
        for (uint32_t k = 0; k < HATCH_NET_CHANNELS; k++)
            ck_assert_double_eq_tol(net->z[HATCH_NET_CHANNELS * n + k], linear(net, n, k), 1e-3);
}
END_TEST

/* The data of the first plane is so certain that the other's is no share of the whole. */
START_TEST(components_are_solved_on_their_own)
{
    struct net_case planes;
    struct hatch_mesh plane = bare_shape(HATCH_SHAPE_PLANE, 2000), other = bare_shape(HATCH_SHAPE_PLANE, 2000);
    move(&other, 1, 9);
    planes.of = case_of(both(&plane, &other));
    make_net(&planes);
    struct hatch_curvature_net *net = &planes.net;
    const struct hatch_surface *nodes = &net->graph->surface;
    ck_assert_uint_eq(nodes->component_count, 2);
    for (uint32_t n = 0; n < nodes->point_count; n++) {
        net->certainty[n] = nodes->point_component[n] == 0 ? 1e12 : 1;
        net->bending[n] = 1;
        for (uint32_t k = 0; k < HATCH_NET_CHANNELS; k++)
            net->fit[HATCH_NET_CHANNELS * n + k] = linear(net, n, k);
    }
    HATCH_TEST_OK(hatch_curvature_net_solve(net, 1e-6, 100, &scratch, &err), &err);
    for (uint32_t n = 0; n < nodes->point_count; n++)
        for (uint32_t k = 0; k < HATCH_NET_CHANNELS; k++)
            ck_assert_double_eq_tol(net->z[HATCH_NET_CHANNELS * n + k], linear(net, n, k), 1e-2);
}
END_TEST

START_TEST(noise_is_averaged_the_more_the_larger_the_strength)
{
    double before = 0.8;
    struct net_case plane;
    make_plane(&plane);
    struct hatch_curvature_net *net = &plane.net;
    uint32_t nodes = net->graph->surface.point_count;
    for (double strength = 1; strength < 2e4; strength *= 100) {
        double squares = 0;
        memset(net->z, 0, HATCH_NET_CHANNELS * nodes * sizeof *net->z);
        for (size_t n = 0; n < nodes; n++) {
            net->certainty[n] = 1;
            net->bending[n] = strength;
            for (size_t k = 0; k < HATCH_NET_CHANNELS; k++)
                net->fit[HATCH_NET_CHANNELS * n + k] = sqrt(12) * (hatch_random_unit(2, k, n) - 0.5f);
        }
        HATCH_TEST_OK(hatch_curvature_net_solve(net, 1e-6, 5000, &scratch, &err), &err);
        for (size_t i = 0; i < HATCH_NET_CHANNELS * nodes; i++)
            squares += net->z[i] * net->z[i] / (HATCH_NET_CHANNELS * nodes);
        ck_assert_double_lt(sqrt(squares), before);
        before = 0.8 * sqrt(squares);
    }
}
END_TEST

/* A coarser net holds the mean of a linear function, and continues it exactly. */
START_TEST(a_coarser_net_continues_linear_values)
{
    struct net_case plane;
    struct hatch_curvature_graph graph;
    struct hatch_curvature_net coarser;
    make_plane(&plane);
    struct hatch_curvature_net *net = &plane.net;
    for (uint32_t n = 0; n < net->graph->surface.point_count; n++)
        net->certainty[n] = 1;
    HATCH_TEST_OK(hatch_curvature_graph_coarsen(&plane.run.graph, &plane.nodes, &keep, &graph, &err), &err);
    HATCH_TEST_OK(hatch_curvature_net_coarsen(&plane.run, net, &graph, &keep, &coarser, &err), &err);
    ck_assert_double_lt(graph.surface.point_count, 0.7 * net->graph->surface.point_count);
    for (uint32_t n = 0; n < graph.surface.point_count; n++)
        for (uint32_t k = 0; k < HATCH_NET_CHANNELS; k++)
            coarser.z[HATCH_NET_CHANNELS * n + k] = linear(&coarser, n, k);
    HATCH_TEST_OK(hatch_curvature_net_prolong(&coarser, &scratch, &err), &err);
    for (uint32_t n = 0; n < net->graph->surface.point_count; n++)
        for (uint32_t k = 0; k < HATCH_NET_CHANNELS; k++)
            ck_assert_double_eq_tol(net->z[HATCH_NET_CHANNELS * n + k], linear(net, n, k), 0.01);
}
END_TEST

START_TEST(slopes_of_linear_values_are_their_gradient)
{
    struct net_case plane;
    make_plane(&plane);
    struct hatch_curvature_net *net = &plane.net;
    for (uint32_t n = 0; n < net->graph->surface.point_count; n++)
        for (uint32_t k = 0; k < HATCH_NET_CHANNELS; k++)
            net->z[HATCH_NET_CHANNELS * n + k] = linear(net, n, k);
    for (uint32_t n = 0; n < net->graph->surface.point_count; n++) {
        double slope[HATCH_NET_CHANNELS][2], across[3];
        const double *axis = &net->axis[3 * (size_t)n];
        hatch_vec_cross(&net->graph->normals[3 * (size_t)n], axis, across);
        hatch_curvature_net_slope(net, n, slope);
        for (uint32_t k = 0; k < HATCH_NET_CHANNELS && net->own[n] <= 0; k++)
            ck_assert(slope[k][0] == 0 && slope[k][1] == 0);
        for (uint32_t k = 0; k < HATCH_NET_CHANNELS && net->own[n] > 0; k++) {
            ck_assert_double_eq_tol(slope[k][0], hatch_vec_dot(gradient[k], axis), 1e-4);
            ck_assert_double_eq_tol(slope[k][1], hatch_vec_dot(gradient[k], across), 1e-4);
        }
    }
}
END_TEST

/* The plane with a solution: what hatch_smooth_spread reads. */
struct spread_case {
    struct net_case plane;
    struct hatch_smoothing smoothing;
    struct hatch_curvature_sample *samples;
    uint32_t points;
};

/* Every node has the same variance, bias and radius, and a value of `scale` times the linear function. */
static void make_solution(struct spread_case *made, double scale, double variance, double bias)
{
    struct hatch_smoothing *s = &made->smoothing;
    make_plane(&made->plane);
    uint32_t nodes = made->plane.nodes.surface.point_count;
    made->points = made->plane.run.graph.surface.point_count;
    *s = (struct hatch_smoothing){.run = &made->plane.run, .nets = {made->plane.net}};
    s->variance = HATCH_NEW(&keep, double, nodes, &err);
    s->bias = HATCH_NEW(&keep, double, nodes, &err);
    s->radius = HATCH_NEW(&keep, double, nodes, &err);
    s->typical = HATCH_NEW(&keep, double, 1, &err);
    s->length = HATCH_NEW(&keep, double, 1, &err);
    made->samples = HATCH_NEW(&keep, struct hatch_curvature_sample, made->points, &err);
    ck_assert(s->length && made->samples);
    for (uint32_t n = 0; n < nodes; n++) {
        s->variance[n] = variance;
        s->bias[n] = bias;
        s->radius[n] = 7;
        s->nets[0].own[n] = 1;
        for (uint32_t k = 0; k < HATCH_NET_CHANNELS; k++) {
            s->nets[0].z[HATCH_NET_CHANNELS * n + k] = scale * linear(&s->nets[0], n, k);
            s->nets[0].fit[HATCH_NET_CHANNELS * n + k] = scale * linear(&s->nets[0], n, k);
        }
    }
}

START_TEST(a_plane_keeps_its_normals)
{
    struct spread_case of;
    make_solution(&of, 1e-9, 1, 0);
    struct hatch_smoothing *s = &of.smoothing;
    const struct hatch_curvature_net *net = &s->nets[0];
    uint32_t nodes = net->graph->surface.point_count;
    s->net_count = 1;
    *s->typical = 1;
    s->tensor = HATCH_NEW(&keep, struct hatch_curvature_tensor, nodes, &err);
    ck_assert_ptr_nonnull(s->tensor);
    for (uint32_t n = 0; n < nodes; n++) {
        net->certainty[n] = 1;
        hatch_vec_copy(&net->graph->normals[3 * (size_t)n], s->tensor[n].normal);
    }
    HATCH_TEST_OK(hatch_smooth_solve(s, &scratch, &err), &err);
    HATCH_TEST_OK(hatch_smooth_correct_normals(s, &scratch, &err), &err);
    for (uint32_t n = 0; n < nodes; n++)
        ck_assert_double_eq_tol(hatch_vec_dot(&net->graph->normals[3 * (size_t)n], s->tensor[n].normal), 1, 1e-12);
}
END_TEST

static void spread_all(struct spread_case *of)
{
    bool *wanted = HATCH_NEW(&keep, bool, of->points, &err);
    ck_assert_ptr_nonnull(wanted);
    memset(wanted, true, of->points);
    HATCH_TEST_OK(hatch_smooth_spread(&of->smoothing, wanted, &scratch, of->samples, &err), &err);
}

/* The curvatures are so small that the surface stays a plane. Nodes at the corners have too few neighbours for a
 * slope. */
START_TEST(points_between_nodes_have_the_linear_values)
{
    const double scale = 1e-9;
    struct spread_case of;
    make_solution(&of, scale, 1, 0);
    *of.smoothing.typical = 1;
    spread_all(&of);
    double half = of.plane.run.graph.surface.points[0];
    for (uint32_t p = 0; p < of.points; p++)
        half = fmax(half, of.plane.run.graph.surface.points[3 * (size_t)p]);
    for (uint32_t p = 0; p < of.points; p++) {
        const struct hatch_curvature_sample *sample = &of.samples[p];
        const double *at = &of.plane.run.graph.surface.points[3 * (size_t)p];
        double value[HATCH_NET_CHANNELS];
        if (fmin(fabs(at[0]), fabs(at[1])) > half - 6)
            continue;
        hatch_curvature_net_value(&sample->tensor, of.plane.net.axis, value);
        for (uint32_t k = 0; k < HATCH_NET_CHANNELS; k++)
            ck_assert_double_eq_tol(value[k] / scale, linear_at(at, k), 1e-3);
        ck_assert_double_eq_tol(sample->radius, 7, 1e-12);
        ck_assert_double_eq_tol(hatch_vec_length(sample->tensor.normal), 1, 1e-12);
    }
}
END_TEST

static void check_variance(struct spread_case *of, double want)
{
    spread_all(of);
    for (uint32_t p = 0; p < of->points; p++) {
        ck_assert_double_eq_tol(of->samples[p].variance.off_diagonal / want, 1, 1e-9);
        ck_assert_double_eq_tol(of->samples[p].variance.mean / want, 2, 1e-9);
    }
}

/* Smoothing over a length divides the variance by 1 + (length * 7 / radius / 1.15)³, a node of which much depends
 * multiplies it, bias is added, and so is the squared angle between fit and solution beyond nine variances. */
START_TEST(the_variance_follows_its_formula)
{
    struct spread_case of;
    make_solution(&of, 1e-9, 4e-6, 1e-6);
    struct hatch_smoothing *s = &of.smoothing;
    *s->typical = 1e-3;
    check_variance(&of, 4e-6);
    *s->length = 2 * 1.15;
    check_variance(&of, 3e-6 / 9 + 1e-6);
    for (uint32_t n = 0; n < of.plane.nodes.surface.point_count; n++)
        s->nets[0].own[n] = 0.5;
    check_variance(&of, 3e-6 / 9 * 3.5 * 3.5 + 1e-6);
    *s->typical = 5e-7;
    check_variance(&of, 2e-6 / 9 * 3.5 * 3.5 + 1e-6);
    for (uint32_t n = 0; n < of.plane.nodes.surface.point_count; n++) {
        double *z = &s->nets[0].z[HATCH_NET_CHANNELS * n], *fit = &s->nets[0].fit[HATCH_NET_CHANNELS * n];
        z[0] = fit[1] = 0.02;
        z[1] = fit[0] = 0;
    }
    check_variance(&of, 2e-6 / 9 * 3.5 * 3.5 + 1e-6 + 1e-4 - 9 * 4e-6);
}
END_TEST

/* Nodes without a fit have four times the typical variance, and none where no node of the component has a fit. */
START_TEST(nodes_without_a_fit_depend_on_the_others)
{
    struct spread_case of;
    make_solution(&of, 1e-9, INFINITY, 0);
    *of.smoothing.typical = 0.25;
    check_variance(&of, 1);
    *of.smoothing.typical = INFINITY;
    spread_all(&of);
    for (uint32_t p = 0; p < of.points; p++)
        ck_assert(isinf(of.samples[p].variance.off_diagonal));
}
END_TEST

/* The value of a tensor seen from the other side is the value carried there. */
START_TEST(values_change_sides)
{
    const double axis[3] = {0, 1, 0}, value[HATCH_NET_CHANNELS] = {0.3, -1.2, 0.7}, still[2] = {1, 0};
    struct hatch_curvature_tensor tensor = {.normal = {0, 0, 1}};
    double back[HATCH_NET_CHANNELS], carried[HATCH_NET_CHANNELS];
    hatch_curvature_net_tensor(tensor.normal, axis, value, 1, tensor.matrix);
    hatch_curvature_net_value(&tensor, axis, back);
    for (uint32_t k = 0; k < HATCH_NET_CHANNELS; k++)
        ck_assert_double_eq_tol(back[k], value[k], 1e-12);
    for (int k = 0; k < 6; k++)
        tensor.matrix[k] = -tensor.matrix[k];
    tensor.normal[2] = -1;
    hatch_curvature_net_value(&tensor, axis, back);
    hatch_curvature_net_carry(value, still, -1, carried);
    for (uint32_t k = 0; k < HATCH_NET_CHANNELS; k++)
        ck_assert_double_eq_tol(back[k], carried[k], 1e-12);
}
END_TEST

/* A strip of a cylinder of radius 20 around the x-axis. Four points across determine a cubic alone there, so that fits
 * have a lower degree than they might. */
START_TEST(a_narrow_strip_is_followed)
{
    enum { LONG = 400, WIDE = 4 };
    struct hatch_mesh strip;
    HATCH_TEST_OK(hatch_mesh_make(&keep, WIDE * LONG, 2 * (WIDE - 1) * (LONG - 1), &strip, &err), &err);
    for (uint32_t v = 0; v < WIDE * LONG; v++) {
        double angle = 0.005 * (v / WIDE);
        float *at = &strip.attributes[0].data[3 * v];
        at[0] = 0.1f * (float)(v % WIDE);
        at[1] = (float)(20 * cos(angle));
        at[2] = (float)(20 * sin(angle));
    }
    for (uint32_t q = 0; q < (WIDE - 1) * (LONG - 1); q++) {
        uint32_t v = q / (WIDE - 1) * WIDE + q % (WIDE - 1);
        const uint32_t faces[6] = {v, v + 1, v + WIDE, v + 1, v + WIDE + 1, v + WIDE};
        memcpy(&strip.indices[6 * (size_t)q], faces, sizeof faces);
    }
    struct field_case of = case_of(strip);
    struct hatch_curvature found = estimate_case(&of, 0, 0);
    double sum = 0;
    for (uint32_t p = 0; p < of.surface.point_count; p++) {
        ck_assert(found.confidence[p] < 0.5 || fabs(found.direction[3 * (size_t)p]) < 0.02);
        sum += found.confidence[p];
    }
    ck_assert_double_gt(sum, 0.87 * of.surface.point_count);
}
END_TEST

static double to_nearer_axis(double degrees)
{
    return degrees < 45 ? degrees : 90 - degrees;
}

/* Median and 95th percentile of the angle to the nearer axis, over all points or those at borders. */
static void measure(enum hatch_shape shape, float noise, bool border, double angles_deg[2])
{
    struct field_case of = case_with_truth(shape, 10000, noise);
    struct angles angles = {0};
    add_angles(&angles, &of, estimate_case(&of, 0, 0).direction, border);
    for (uint32_t i = 0; i < angles.count; i++)
        angles.degrees[i] = to_nearer_axis(angles.degrees[i]);
    angles_deg[0] = percentile(&angles, 0.5);
    angles_deg[1] = percentile(&angles, 0.95);
}

/* Before smoothing, 1.05 and 11.0 (Monge), 1.82 and 15.9 (egg box), 2.16 and 28.9 (helicoid). */
START_TEST(noisy_lines_that_turn_are_followed)
{
    static const struct {
        enum hatch_shape shape;
        double median_deg, most_deg;
    } cases[] = {{HATCH_SHAPE_MONGE, 1.6, 20}, {HATCH_SHAPE_EGGBOX, 2.6, 22}, {HATCH_SHAPE_HELICOID, 1.7, 20}};
    for (int i = 0; i < 3; i++) {
        double found[2];
        measure(cases[i].shape, 0.2f, false, found);
        ck_assert_msg(found[0] < cases[i].median_deg && found[1] < cases[i].most_deg, "%s: %g and %g degrees",
                      hatch_shape_names[cases[i].shape], found[0], found[1]);
    }
}
END_TEST

START_TEST(noisy_borders_are_followed)
{
    double saddle[2], catenoid[2];
    measure(HATCH_SHAPE_SADDLE, 0.05f, true, saddle);
    measure(HATCH_SHAPE_CATENOID, 0.05f, true, catenoid);
    ck_assert_msg(saddle[1] < 4 && catenoid[1] < 10, "%g and %g degrees", saddle[1], catenoid[1]);
}
END_TEST

START_TEST(normals_are_those_of_the_surface_without_noise)
{
    struct field_case of = case_with_truth(HATCH_SHAPE_TORUS, 10000, 0.2f);
    struct hatch_curvature found = estimate_case(&of, 0, 0);
    struct angles angles = {HATCH_NEW(&keep, double, of.surface.point_count, &err), 0};
    for (uint32_t p = 0; p < of.surface.point_count; p++) {
        double at[3], normal[3], line[3], value[2];
        hatch_surface_position(&of.surface, p, at);
        hatch_shape_curvature(HATCH_SHAPE_TORUS, at, normal, line, value);
        angles.degrees[angles.count++] = degrees_apart(&found.normal[3 * (size_t)p], normal);
    }
    ck_assert_msg(percentile(&angles, 0.5) < 1.1 && percentile(&angles, 0.95) < 2.4, "%g and %g degrees",
                  percentile(&angles, 0.5), percentile(&angles, 0.95));
}
END_TEST

static struct hatch_mesh noisy_shape(enum hatch_shape shape, uint32_t faces, float noise)
{
    struct hatch_mesh mesh =
        shape_with(shape, (struct hatch_shape_options){.faces = faces, .jitter = 1, .noise = noise, .seed = 3});
    mesh.attribute_count = 1;
    return mesh;
}

/* Median of the angle to the nearer axis between a component of one estimate and the same in another. */
static double median_between(const struct hatch_component *component, const double *a, const double *b)
{
    struct angles angles = {HATCH_NEW(&keep, double, component->point_count, &err), 0};
    for (size_t p = component->first_point; p < (size_t)component->first_point + component->point_count; p++)
        angles.degrees[angles.count++] = to_nearer_axis(degrees_apart(&a[3 * p], &b[3 * p]));
    return percentile(&angles, 0.5);
}

/* A small noisy body is smoothed beside a large clean one, which holds nearly all points. */
START_TEST(components_are_smoothed_on_their_own)
{
    struct hatch_mesh small = noisy_shape(HATCH_SHAPE_MONGE, 2000, 0.2f);
    struct hatch_mesh large = noisy_shape(HATCH_SHAPE_TORUS, 50000, 0), pair = both(&small, &large);
    struct field_case alone = case_of(small), beside = case_of(pair);
    const struct hatch_component *component = &beside.surface.components[0];
    ck_assert_uint_eq(component->point_count, alone.surface.point_count);
    ck_assert_double_lt(component->point_count, 0.05 * beside.surface.point_count);
    struct hatch_curvature a = estimate_case(&alone, 0, 0), b = estimate_case(&beside, 0, 0);
    ck_assert_double_lt(median_between(component, a.direction, b.direction), 0.1);
}
END_TEST

static Suite *suite(void)
{
    Suite *all = suite_create("smooth");
    TCase *tests = tcase_create("smooth");
    tcase_set_timeout(tests, 120);
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, linear_values_stay_up_to_the_border);
    tcase_add_test(tests, components_are_solved_on_their_own);
    tcase_add_test(tests, noise_is_averaged_the_more_the_larger_the_strength);
    tcase_add_test(tests, a_coarser_net_continues_linear_values);
    tcase_add_test(tests, slopes_of_linear_values_are_their_gradient);
    tcase_add_test(tests, a_plane_keeps_its_normals);
    tcase_add_test(tests, points_between_nodes_have_the_linear_values);
    tcase_add_test(tests, the_variance_follows_its_formula);
    tcase_add_test(tests, nodes_without_a_fit_depend_on_the_others);
    tcase_add_test(tests, a_narrow_strip_is_followed);
    tcase_add_test(tests, values_change_sides);
    tcase_add_test(tests, noisy_lines_that_turn_are_followed);
    tcase_add_test(tests, noisy_borders_are_followed);
    tcase_add_test(tests, normals_are_those_of_the_surface_without_noise);
    tcase_add_test(tests, components_are_smoothed_on_their_own);
    suite_add_tcase(all, tests);
    return all;
}
HATCH_TEST_MAIN(suite)
