#include "fail_alloc.h"
#include "field_make.h"

#define DEG (PI / 180)

/* One constraint on a plane determines the whole field. */
START_TEST(one_constraint_determines_the_field_of_a_plane)
{
    struct field_case of = case_of_shape(HATCH_SHAPE_PLANE, 800, 1);
    const double line[3] = {3, 4, 0};
    double *constraint_weight = HATCH_NEW(&keep, double, of.surface.point_count, &err);
    constraint_weight[of.surface.point_count / 3] = 10;
    hatch_vec_copy(line, &of.direction[of.surface.point_count / 3 * 3]);
    const struct hatch_field_problem problem = {&of.surface,   &of.frames,        of.direction,
                                                of.confidence, constraint_weight, false};
    for (int k = 0; k < 3; k++) {
        const struct hatch_field_options options = {k == 2 ? HATCH_FIELD_HZ : HATCH_FIELD_LINEAR,
                                                    k == 1 ? HATCH_FIELD_CHOLESKY : HATCH_FIELD_MULTIGRID, 0.5, 1e-10,
                                                    5000};
        struct hatch_field field;
        HATCH_TEST_OK(hatch_field_solve(&problem, &options, &keep, &scratch, &field, &err), &err);
        ck_assert_uint_eq(field.unconstrained, 0);
        for (uint32_t p = 0; p < of.surface.point_count; p++) {
            ck_assert_double_lt(line_angle(&of, p, &field.direction[3 * (size_t)p], line), 1e-3 * DEG);
            ck_assert_double_eq_tol(field.confidence[p], 1, 1e-4);
        }
    }
}
END_TEST

/* The indices of any field, also a random one, sum to the Euler characteristic. */
static void check_sums(const struct field_case *of, const double *direction)
{
    struct hatch_singularities found = singularities_of(of, direction);
    double *angle_rad = HATCH_NEW(&keep, double, of->surface.point_count, &err);
    int32_t sum = 0;
    for (uint32_t p = 0; p < of->surface.point_count; p++)
        angle_rad[p] = hatch_frames_angle(&of->frames, p, &direction[3 * p]);
    ck_assert_int_eq(found.component_half_turns[0], 2 * of->surface.components[0].euler);
    for (uint32_t i = 0; i < found.count; i++) {
        ck_assert(i == 0 || found.faces[i] > found.faces[i - 1]);
        ck_assert_int_eq(found.half_turns[i],
                         hatch_field_face_index(&of->surface, &of->frames, angle_rad, found.faces[i]));
        ck_assert_int_ne(found.half_turns[i], 0);
        sum += found.half_turns[i];
    }
    if (of->surface.components[0].border_loops == 0)
        ck_assert_int_eq(sum, 2 * of->surface.components[0].euler);
}

START_TEST(indices_sum_to_the_euler_characteristic)
{
    struct field_case cases[HATCH_SHAPE_COUNT + 2];
    uint32_t count = 0;
    for (; count < HATCH_SHAPE_COUNT; count++)
        cases[count] = case_of_shape((enum hatch_shape)count, 600, 1);
    cases[count++] = case_of(band(30, 5, true));
    cases[count++] = case_of(klein(24, 12));
    for (uint32_t k = 0; k < count; k++) {
        struct field_case *of = &cases[k];
        for (uint32_t p = 0; p < of->surface.point_count; p++)
            hatch_frames_direction(&of->frames, p, 7 * (double)hatch_random_unit(3, k, p),
                                   &of->direction[3 * (size_t)p]);
        if (of->surface.component_count == 1)
            check_sums(of, of->direction);
        struct hatch_field smooth = solve_case(of, HATCH_FIELD_LINEAR, HATCH_FIELD_MULTIGRID, 0.5);
        ck_assert_uint_eq(smooth.unconstrained, of->surface.component_count);
        if (of->surface.component_count == 1)
            check_sums(of, smooth.direction);
    }
}
END_TEST

START_TEST(smoothest_fields_have_the_fewest_singularities)
{
    const struct {
        struct field_case of;
        uint32_t singularities;
        double energy_max;
    } known[] = {
        {case_of_shape(HATCH_SHAPE_SPHERE, 2000, 0.5f), 4, 120},
        {case_of_shape(HATCH_SHAPE_TORUS, 2000, 0.5f), 0, 60},
        {case_of_shape(HATCH_SHAPE_PLANE, 500, 0.5f), 0, 1e-4},
        {case_of_shape(HATCH_SHAPE_CYLINDER, 2000, 0.5f), 0, 1},
        {case_of(band(60, 5, true)), 0, 20},
        {case_of(klein(60, 30)), 0, 60},
    };
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        struct hatch_field field = solve_case(&known[k].of, HATCH_FIELD_LINEAR, HATCH_FIELD_MULTIGRID, 0.5);
        struct hatch_singularities found = singularities_of(&known[k].of, field.direction);
        ck_assert_msg(found.count == known[k].singularities, "case %zu: %u singularities", k, found.count);
        ck_assert_msg(field.energy[0] <= known[k].energy_max, "case %zu: energy %g", k, field.energy[0]);
        ck_assert_uint_eq(field.unconstrained, 1);
        ck_assert_double_eq(field.energy[1], 0);
        for (uint32_t p = 0; p < known[k].of.surface.point_count; p++)
            ck_assert_double_eq(field.confidence[p], 0);
    }
}
END_TEST

/* Returns the mean confidence of a field. */
static double mean_confidence(const struct field_case *of, double smooth)
{
    struct hatch_field field = solve_case(of, HATCH_FIELD_LINEAR, HATCH_FIELD_MULTIGRID, smooth);
    double sum = 0;
    for (uint32_t p = 0; p < of->surface.point_count; p++) {
        ck_assert(field.confidence[p] >= 0 && field.confidence[p] <= 1);
        sum += field.confidence[p];
    }
    return sum / of->surface.point_count;
}

/* All directions of a torus agree with the smoothest field, and random ones with none, from much smoothing to all. */
START_TEST(confidence_tells_how_far_data_agree)
{
    struct field_case torus = case_of_shape(HATCH_SHAPE_TORUS, 1000, 1);
    for (double smooth = 0.75; smooth <= 1; smooth += 0.125) {
        follow_truth(&torus, HATCH_SHAPE_TORUS, 0, 0.5);
        double agreeing = mean_confidence(&torus, smooth);
        follow_truth(&torus, HATCH_SHAPE_TORUS, 1000, 0.5);
        double random = mean_confidence(&torus, smooth);
        ck_assert_msg(agreeing > 0.8, "smooth %g: %g", smooth, agreeing);
        ck_assert_msg(random < 0.3, "smooth %g: %g of random data", smooth, random);
    }
}
END_TEST

static const enum hatch_shape analytic[] = {HATCH_SHAPE_TORUS, HATCH_SHAPE_ELLIPSOID, HATCH_SHAPE_CYLINDER};

/* Normally distributed errors of 20 degrees. Four singularities of index 1/2 on the ellipsoid, none elsewhere. */
START_TEST(noise_is_smoothed_without_extra_singularities)
{
    for (size_t k = 0; k < 3; k++) {
        struct field_case of = case_of_shape(analytic[k], 4000, 1);
        follow_truth(&of, analytic[k], 20 * DEG, 0.02);
        struct hatch_field field = solve_case(&of, HATCH_FIELD_LINEAR, HATCH_FIELD_MULTIGRID, 0.5);
        struct hatch_singularities found = singularities_of(&of, field.direction);
        ck_assert_uint_eq(found.count, analytic[k] == HATCH_SHAPE_ELLIPSOID ? 4 : 0);
        for (uint32_t i = 0; i < found.count; i++)
            ck_assert_int_eq(found.half_turns[i], 1);
        struct field_case truth = of;
        truth.direction = HATCH_NEW(&keep, double, (size_t)of.surface.point_count * 3, &err);
        follow_truth(&truth, analytic[k], 0, 1);
        uint32_t close = 0;
        for (uint32_t p = 0; p < of.surface.point_count; p++)
            close += line_angle(&of, p, &field.direction[3 * (size_t)p], &truth.direction[3 * (size_t)p]) < 5 * DEG;
        ck_assert_uint_gt(close, of.surface.point_count * 85 / 100);
    }
}
END_TEST

START_TEST(multigrid_and_cholesky_agree)
{
    struct field_case cases[] = {case_of_shape(HATCH_SHAPE_ELLIPSOID, 2000, 1), case_of(band(60, 6, true))};
    follow_truth(&cases[0], HATCH_SHAPE_ELLIPSOID, 30 * DEG, 0.02);
    for (uint32_t p = 0; p < cases[1].surface.point_count; p++) {
        hatch_frames_direction(&cases[1].frames, p, 7 * (double)hatch_random_unit(3, 1, p),
                               &cases[1].direction[3 * (size_t)p]);
        cases[1].confidence[p] = 0.3;
    }
    for (size_t k = 0; k < 2; k++)
        for (int smooth = 0; smooth <= 4; smooth++) {
            struct hatch_field a = solve_case(&cases[k], HATCH_FIELD_LINEAR, HATCH_FIELD_MULTIGRID, smooth / 4.0);
            struct hatch_field b = solve_case(&cases[k], HATCH_FIELD_LINEAR, HATCH_FIELD_CHOLESKY, smooth / 4.0);
            ck_assert_double_lt(largest_angle(&cases[k], a.direction, b.direction), 0.01 * DEG);
            ck_assert_double_eq_tol(a.solution_energy, b.solution_energy, 1e-6 * b.solution_energy);
            ck_assert_uint_lt(a.iterations, 60);
        }
}
END_TEST

/* The minimum of linear is over more fields than that of hz; reported energies are those of the field. */
START_TEST(the_linear_method_has_no_more_energy_than_hz)
{
    struct field_case cases[] = {
        case_of_shape(HATCH_SHAPE_TORUS, 1000, 1), case_of_shape(HATCH_SHAPE_ELLIPSOID, 1000, 1),
        case_of_shape(HATCH_SHAPE_SADDLE, 1000, 1), case_of(band(40, 6, true)), case_of(klein(24, 12))};
    const enum hatch_shape shapes[] = {HATCH_SHAPE_TORUS, HATCH_SHAPE_ELLIPSOID, HATCH_SHAPE_SADDLE};
    for (size_t k = 0; k < 5; k++) {
        struct field_case *of = &cases[k];
        if (k < 3)
            follow_truth(of, shapes[k], 40 * DEG, 0.2);
        for (uint32_t p = 0; k >= 3 && p < of->surface.point_count; p++) {
            hatch_frames_direction(&of->frames, p, 7 * (double)hatch_random_unit(3, k, p),
                                   &of->direction[3 * (size_t)p]);
            of->confidence[p] = 0.2;
        }
        const struct hatch_field_problem problem = {&of->surface,   &of->frames, of->direction,
                                                    of->confidence, NULL,        false};
        for (int smooth = 1; smooth < 5; smooth++) {
            struct hatch_field linear = solve_case(of, HATCH_FIELD_LINEAR, HATCH_FIELD_MULTIGRID, smooth / 5.0);
            struct hatch_field hz = solve_case(of, HATCH_FIELD_HZ, HATCH_FIELD_MULTIGRID, smooth / 5.0);
            double sum = hz.energy[0] + hz.energy[1], energy[2], start[2];
            ck_assert_double_le(linear.solution_energy, hz.solution_energy * (1 + 1e-9));
            ck_assert_double_eq_tol(hz.solution_energy, sum, 1e-9 * sum);
            hatch_field_energy(&problem, smooth / 5.0, hz.direction, energy);
            ck_assert_double_eq_tol(energy[0] + energy[1], sum, 1e-6 * sum);
            hatch_field_energy(&problem, smooth / 5.0, of->direction, start);
            ck_assert_double_le(sum, start[0] + start[1]);
            hatch_field_energy(&problem, smooth / 5.0, linear.direction, energy);
            ck_assert_double_eq_tol(energy[0], linear.energy[0], 1e-6 * energy[0]);
            ck_assert_double_eq_tol(energy[1], linear.energy[1], 1e-6 * energy[1]);
        }
    }
}
END_TEST

START_TEST(smoothness_0_keeps_the_data)
{
    struct field_case of = case_of_shape(HATCH_SHAPE_TORUS, 1000, 1);
    follow_truth(&of, HATCH_SHAPE_TORUS, 30 * DEG, 0.5);
    struct hatch_field field = solve_case(&of, HATCH_FIELD_LINEAR, HATCH_FIELD_MULTIGRID, 0);
    ck_assert_double_lt(largest_angle(&of, field.direction, of.direction), 1e-3 * DEG);
}
END_TEST

/* The same `smooth` has the same effect on four times as many faces. */
START_TEST(smoothness_is_independent_of_resolution)
{
    double mean[2];
    for (int fine = 0; fine < 2; fine++) {
        struct field_case of = case_of_shape(HATCH_SHAPE_PLANE, fine ? 8000 : 2000, 0);
        double scale = of.surface.components[0].scale, sum = 0, area = 0;
        for (uint32_t p = 0; p < of.surface.point_count; p++) {
            bool left = of.surface.points[3 * (size_t)p] * scale < 0;
            const double line[3] = {left ? 1 : 0.5, left ? 0 : 0.8, 0};
            hatch_vec_copy(line, &of.direction[3 * (size_t)p]);
            of.confidence[p] = 0.5;
        }
        struct hatch_field field = solve_case(&of, HATCH_FIELD_LINEAR, HATCH_FIELD_MULTIGRID, 0.75);
        for (uint32_t p = 0; p < of.surface.point_count; p++) {
            sum +=
                of.frames.area[p] * line_angle(&of, p, &field.direction[3 * (size_t)p], &of.direction[3 * (size_t)p]);
            area += of.frames.area[p];
        }
        mean[fine] = sum / area;
    }
    ck_assert_double_gt(mean[0], 2 * DEG);
    ck_assert_double_eq_tol(mean[0], mean[1], 0.05 * mean[0]);
}
END_TEST

/* Results are identical when the mesh is scaled by a power of two. */
START_TEST(scale_does_not_matter)
{
    const float scales[] = {0x1p66f, 0x1p-66f};
    struct field_case of = case_of_shape(HATCH_SHAPE_ELLIPSOID, 1000, 1);
    follow_truth(&of, HATCH_SHAPE_ELLIPSOID, 20 * DEG, 0.1);
    struct hatch_field field = solve_case(&of, HATCH_FIELD_LINEAR, HATCH_FIELD_MULTIGRID, 0.5);
    for (size_t k = 0; k < 2; k++) {
        struct hatch_mesh mesh = of.mesh;
        mesh.attributes[0].data = HATCH_NEW(&keep, float, (size_t)mesh.vertex_count * 3, &err);
        for (uint32_t i = 0; i < 3 * mesh.vertex_count; i++)
            mesh.attributes[0].data[i] = of.mesh.attributes[0].data[i] * scales[k];
        struct field_case scaled = case_of(mesh);
        scaled.direction = of.direction;
        scaled.confidence = of.confidence;
        struct hatch_field same = solve_case(&scaled, HATCH_FIELD_LINEAR, HATCH_FIELD_MULTIGRID, 0.5);
        ck_assert_mem_eq(same.direction, field.direction, (size_t)of.surface.point_count * 3 * sizeof(double));
        ck_assert_mem_eq(same.confidence, field.confidence, of.surface.point_count * sizeof(double));
    }
}
END_TEST

/* Rotates the mesh in space and reorders its faces and vertices.
 *   renamed  per vertex, its new number */
static struct field_case turned_and_shuffled(const struct field_case *of, const uint32_t *renamed)
{
    struct hatch_mesh mesh;
    uint32_t vertices = of->mesh.vertex_count, faces = of->mesh.face_count;
    HATCH_TEST_OK(hatch_mesh_make(&keep, vertices, faces, &mesh, &err), &err);
    for (uint32_t v = 0; v < vertices; v++)
        for (uint32_t k = 0; k < 3; k++)
            mesh.attributes[0].data[3 * renamed[v] + (k + 1) % 3] = of->mesh.attributes[0].data[3 * v + k];
    for (uint32_t f = 0; f < faces; f++)
        for (uint32_t c = 0; c < 3; c++)
            mesh.indices[3 * (faces - 1 - f) + (c + f) % 3] = renamed[of->mesh.indices[3 * f + c]];
    return case_of(mesh);
}

START_TEST(rotation_and_order_do_not_matter)
{
    struct field_case of = case_of_shape(HATCH_SHAPE_ELLIPSOID, 1000, 1);
    follow_truth(&of, HATCH_SHAPE_ELLIPSOID, 20 * DEG, 0.1);
    uint32_t vertices = of.mesh.vertex_count, *renamed = HATCH_NEW(&keep, uint32_t, vertices, &err);
    for (uint32_t v = 0; v < vertices; v++)
        renamed[v] = v;
    for (uint32_t v = vertices - 1; v > 0; v--) {
        uint32_t other = (uint32_t)(hatch_random_u64(1, 2, v) % (v + 1)), was = renamed[v];
        renamed[v] = renamed[other];
        renamed[other] = was;
    }
    struct field_case turned = turned_and_shuffled(&of, renamed);
    uint32_t *point_of = HATCH_NEW(&keep, uint32_t, vertices, &err);
    for (uint32_t i = 0; i < 3 * turned.surface.face_count; i++)
        point_of[turned.surface.corner_vertex[i]] = turned.surface.corners[i];
    uint32_t *twin = HATCH_NEW(&keep, uint32_t, of.surface.point_count, &err);
    for (uint32_t i = 0; i < 3 * of.surface.face_count; i++)
        twin[of.surface.corners[i]] = point_of[renamed[of.surface.corner_vertex[i]]];
    for (uint32_t p = 0; p < of.surface.point_count; p++) {
        turned.confidence[twin[p]] = of.confidence[p];
        for (uint32_t k = 0; k < 3; k++)
            turned.direction[3 * twin[p] + (k + 1) % 3] = of.direction[3 * p + k];
    }
    struct hatch_field a = solve_case(&of, HATCH_FIELD_LINEAR, HATCH_FIELD_MULTIGRID, 0.5);
    struct hatch_field b = solve_case(&turned, HATCH_FIELD_LINEAR, HATCH_FIELD_MULTIGRID, 0.5);
    for (uint32_t p = 0; p < of.surface.point_count; p++) {
        double back[3];
        for (uint32_t k = 0; k < 3; k++)
            back[k] = b.direction[3 * twin[p] + (k + 1) % 3];
        ck_assert_double_lt(line_angle(&of, p, back, &a.direction[3 * (size_t)p]), 1e-3 * DEG);
    }
}
END_TEST

START_TEST(small_components_have_fields_too)
{
    struct hatch_mesh mesh;
    const float places[9][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0},
                                {5, 1, 0}, {6, 1, 0}, {5, 2, 0}, {6, 2, 0}};
    const uint32_t faces[5][3] = {{0, 1, 2}, {3, 4, 5}, {4, 6, 5}, {5, 6, 7}, {6, 8, 7}};
    HATCH_TEST_OK(hatch_mesh_make(&keep, 9, 5, &mesh, &err), &err);
    memcpy(mesh.attributes[0].data, places, sizeof places);
    memcpy(mesh.indices, faces, sizeof faces);
    struct field_case of = case_of(mesh);
    const double across[3] = {0, 1, 0};
    hatch_vec_copy(across, of.direction);
    of.confidence[0] = 0.9;
    for (int method = 0; method < 2; method++) {
        struct hatch_field field = solve_case(&of, (enum hatch_field_method)method, HATCH_FIELD_MULTIGRID, 0.5);
        ck_assert_uint_eq(field.unconstrained, 1);
        for (uint32_t p = 0; p < 9; p++)
            ck_assert_double_eq_tol(hatch_vec_length(&field.direction[3 * (size_t)p]), 1, 1e-12);
        for (uint32_t p = 0; p < 3; p++)
            ck_assert_double_lt(line_angle(&of, p, &field.direction[3 * (size_t)p], across), 1e-3 * DEG);
        struct hatch_singularities found = singularities_of(&of, field.direction);
        ck_assert_uint_eq(found.count, 0);
        ck_assert_int_eq(found.component_half_turns[0], 2);
        ck_assert_int_eq(found.component_half_turns[1], 2);
    }
}
END_TEST

START_TEST(a_face_has_the_direction_of_its_points)
{
    struct field_case of = case_of_shape(HATCH_SHAPE_CYLINDER, 4000, 1);
    follow_truth(&of, HATCH_SHAPE_CYLINDER, 0, 1);
    for (uint32_t f = 0; f < of.surface.face_count; f++) {
        double line[3], spread, normal[3];
        const uint32_t *c = &of.surface.corners[3 * (size_t)f];
        hatch_field_face_direction(&of.surface, &of.frames, of.direction, f, line, &spread);
        hatch_vec_triangle(&of.surface.points[3 * (size_t)c[0]], &of.surface.points[3 * (size_t)c[1]],
                           &of.surface.points[3 * (size_t)c[2]], normal);
        ck_assert_double_eq_tol(hatch_vec_length(line), 1, 1e-9);
        ck_assert_double_eq_tol(hatch_vec_dot(line, normal), 0, 1e-9);
        ck_assert_double_lt(fabs(line[1]), 0.02); /* around the axis, which is y */
        ck_assert_double_lt(spread, 2 * DEG);
    }
}
END_TEST

START_TEST(the_field_of_a_mesh_is_read_back)
{
    struct field_case of = case_of_shape(HATCH_SHAPE_TORUS, 500, 1);
    float *lines;
    double *direction = HATCH_NEW(&keep, double, (size_t)of.surface.point_count * 3, &err);
    double *confidence = HATCH_NEW(&keep, double, of.surface.point_count, &err);
    ck_assert(!hatch_field_of_mesh(&of.surface, &of.frames, &of.mesh, direction, confidence));
    HATCH_TEST_OK(hatch_mesh_add(&keep, &of.mesh, "_HATCH_DIR", 4, &lines, &err), &err);
    follow_truth(&of, HATCH_SHAPE_TORUS, 0, 0.5);
    for (uint32_t i = 0; i < 3 * of.surface.face_count; i++) {
        float *line = &lines[4 * (size_t)of.surface.corner_vertex[i]];
        hatch_vec_round(&of.direction[3 * (size_t)of.surface.corners[i]], line);
        line[3] = 0.5f;
    }
    for (uint32_t p = 0; p < 2; p++)
        for (uint32_t i = 0; i < 3 * of.surface.face_count; i++)
            if (of.surface.corners[i] == p)
                lines[4 * (size_t)of.surface.corner_vertex[i] + 3 * p] = p ? -1 : NAN;
    ck_assert(hatch_field_of_mesh(&of.surface, &of.frames, &of.mesh, direction, confidence));
    for (uint32_t p = 0; p < of.surface.point_count; p++) {
        ck_assert_double_eq_tol(confidence[p], p < 2 ? 0 : 0.5, 1e-6);
        ck_assert_double_eq_tol(hatch_vec_length(&direction[3 * (size_t)p]), 1, 1e-9);
        if (p > 0)
            ck_assert_double_lt(line_angle(&of, p, &direction[3 * (size_t)p], &of.direction[3 * (size_t)p]), 1e-3);
    }
}
END_TEST

struct call {
    struct field_case of;
    enum hatch_field_method method;
    struct hatch_field field;
    struct hatch_singularities found;
};

static enum hatch_status solve(void *context, struct hatch_arena *to, struct hatch_arena *temporary,
                               struct hatch_err *why)
{
    struct call *call = context;
    const struct hatch_field_problem problem = {
        &call->of.surface, &call->of.frames, call->of.direction, call->of.confidence, NULL, true};
    const struct hatch_field_options options = {call->method, HATCH_FIELD_MULTIGRID, 0.5, 1e-4, 100};
    return hatch_field_solve(&problem, &options, to, temporary, &call->field, why);
}

static enum hatch_status find(void *context, struct hatch_arena *to, struct hatch_arena *temporary,
                              struct hatch_err *why)
{
    struct call *call = context;
    return hatch_field_singularities(&call->of.surface, &call->of.frames, call->of.direction, to, temporary,
                                     &call->found, why);
}

START_TEST(every_failed_allocation_is_a_limit)
{
    struct call call = {.of = case_of_shape(HATCH_SHAPE_ELLIPSOID, 300, 0)};
    hatch_test_fail_alloc(solve, &call, &call.field, sizeof call.field);
    follow_truth(&call.of, HATCH_SHAPE_ELLIPSOID, 0.2, 0.5);
    for (int method = 0; method < 2; method++) {
        call.method = (enum hatch_field_method)method;
        hatch_test_fail_alloc(solve, &call, &call.field, sizeof call.field);
    }
    hatch_test_fail_alloc(find, &call, &call.found, sizeof call.found);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("field");
    TCase *tests = tcase_create("field");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, one_constraint_determines_the_field_of_a_plane);
    tcase_add_test(tests, indices_sum_to_the_euler_characteristic);
    tcase_add_test(tests, smoothest_fields_have_the_fewest_singularities);
    tcase_add_test(tests, confidence_tells_how_far_data_agree);
    tcase_add_test(tests, noise_is_smoothed_without_extra_singularities);
    tcase_add_test(tests, multigrid_and_cholesky_agree);
    tcase_add_test(tests, the_linear_method_has_no_more_energy_than_hz);
    tcase_add_test(tests, smoothness_0_keeps_the_data);
    tcase_add_test(tests, smoothness_is_independent_of_resolution);
    tcase_add_test(tests, scale_does_not_matter);
    tcase_add_test(tests, rotation_and_order_do_not_matter);
    tcase_add_test(tests, small_components_have_fields_too);
    tcase_add_test(tests, a_face_has_the_direction_of_its_points);
    tcase_add_test(tests, the_field_of_a_mesh_is_read_back);
    tcase_add_test(tests, every_failed_allocation_is_a_limit);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
