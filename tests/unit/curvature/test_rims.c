/* Long faces between rims: directions run around the sides of turned parts, which all have a single row of faces. */
#include "curvature_make.h"
#include "fail_alloc.h"
#include "curvature/bending.h"

#define CREASE_RAD (75 * PI / 180)
#define ROWS_MAX 12u

/* A part turned about its axis: radius and height of each row of points, from below; both ends are closed by fans. */
struct profile {
    uint32_t rows;
    double at[ROWS_MAX][2];
    uint32_t side[2]; /* the rows at which the side begins and ends */
};

/* A cylinder or cone with chamfers at which the surface turns by an angle. */
static struct profile chamfered(double below, double above, double height, double turn_degrees)
{
    double depth = 0.05, slope = (below - above) / height, in = depth * tan(turn_degrees * PI / 180 - atan(slope));
    double out = depth * tan(turn_degrees * PI / 180 + atan(slope));
    return (struct profile){
        4, {{below - in, 0}, {below, depth}, {above, depth + height}, {above - out, 2 * depth + height}}, {1, 2}};
}

/* The axes of the part in space; the first is that about which it is turned. */
static const double axes[3][3] = {
    {2.0 / 7, 3.0 / 7, 6.0 / 7}, {3.0 / 7, -6.0 / 7, 2.0 / 7}, {6.0 / 7, 2.0 / 7, -3.0 / 7}};

/* A way to divide the same surface into triangles. */
struct division {
    uint32_t sides;
    bool flipped;  /* the other diagonal of each quad */
    bool mirrored; /* the other way around */
};

static struct hatch_mesh turned(const struct profile *profile, struct division by)
{
    struct hatch_mesh mesh;
    uint32_t n = by.sides, rows = profile->rows, faces = 0;
    HATCH_TEST_OK(hatch_mesh_make(&keep, n * rows, 2 * n * rows - 4, &mesh, &err), &err);
    for (uint32_t row = 0; row < rows; row++)
        for (uint32_t i = 0; i < n; i++) {
            double turn = 2 * PI * i / n, radius = profile->at[row][0];
            double local[3] = {profile->at[row][1], radius * cos(turn), radius * sin(turn) * (by.mirrored ? -1 : 1)};
            for (int k = 0; k < 3; k++)
                mesh.attributes[0].data[3 * (row * n + i) + (uint32_t)k] =
                    (float)(local[0] * axes[0][k] + local[1] * axes[1][k] + local[2] * axes[2][k]);
        }
    for (uint32_t row = 0; row + 1 < rows; row++)
        for (uint32_t i = 0; i < n; i++) {
            uint32_t a = row * n + i, b = row * n + (i + 1) % n, c = b + n, d = a + n;
            const uint32_t quad[2][6] = {{a, b, c, a, c, d}, {a, b, d, b, c, d}};
            memcpy(&mesh.indices[3 * (size_t)faces], quad[by.flipped], sizeof quad[0]);
            faces += 2;
        }
    for (uint32_t end = 0; end < 2; end++)
        for (uint32_t i = 1; i + 1 < n; i++) {
            uint32_t first = end ? (rows - 1) * n : 0;
            const uint32_t face[3] = {first, first + i + (end ? 0 : 1), first + i + (end ? 1 : 0)};
            memcpy(&mesh.indices[3 * (size_t)faces++], face, sizeof face);
        }
    return mesh;
}

/* Computes the field as dirfield does by default. */
static struct field_case solved(struct hatch_mesh mesh)
{
    struct field_case of = {.mesh = mesh};
    struct hatch_surface_notes notes = {0};
    struct hatch_field field;
    HATCH_TEST_OK(hatch_surface_make_cut(&mesh, &keep, &scratch, &of.surface, &notes, &err), &err);
    HATCH_TEST_OK(hatch_frames_begin(&of.surface, &keep, &scratch, &of.frames, &err), &err);
    struct hatch_curvature found = estimate_case(&of, 0, 0);
    hatch_curvature_clear_crease_confidence(&of.surface, CREASE_RAD, &found);
    HATCH_TEST_OK(hatch_curvature_follow_rims(&of.surface, &of.frames, CREASE_RAD, &scratch, &found, &err), &err);
    hatch_curvature_set_planes(&of.surface, &found);
    HATCH_TEST_OK(hatch_frames_set_normals(&of.surface, found.normal, &scratch, &of.frames, &err), &err);
    HATCH_TEST_OK(hatch_curvature_continue_axes(&of.surface, &of.frames, &scratch, &found, &err), &err);
    const struct hatch_field_problem problem = {&of.surface, &of.frames, found.direction, found.confidence, NULL, true};
    const struct hatch_field_options options = {HATCH_FIELD_LINEAR, HATCH_FIELD_MULTIGRID, 0.35, 3e-5, 10000};
    HATCH_TEST_OK(hatch_field_solve(&problem, &options, &keep, &scratch, &field, &err), &err);
    of.direction = field.direction;
    of.confidence = field.confidence;
    return of;
}

/* Computes the place of a point: its height, and the unit tangent of the circle through it. Returns its radius. */
static double place_of(const struct field_case *of, uint32_t point, double *height, double circle[3])
{
    double at[3];
    hatch_surface_position(&of->surface, point, at);
    *height = hatch_vec_dot(at, axes[0]);
    hatch_vec_cross(axes[0], at, circle);
    return hatch_vec_normalize(circle);
}

/* Checks that directions run around and that all singularities are on the ends.
 *   side_degrees, other_degrees  largest angles to the circle, on the side and elsewhere */
static void check_runs_around(const struct profile *profile, struct division by, double side_degrees,
                              double other_degrees)
{
    struct field_case of = solved(turned(profile, by));
    struct hatch_singularities found = singularities_of(&of, of.direction);
    double top = profile->at[profile->rows - 1][1], bottom = profile->at[0][1], height, circle[3];
    for (uint32_t p = 0; p < of.surface.point_count; p++) {
        const double *from = profile->at[profile->side[0]], *to = profile->at[profile->side[1]];
        double radius = place_of(&of, p, &height, circle), normal = hatch_vec_dot(&of.frames.normal[3 * p], axes[0]);
        bool on_side = height > from[1] - 1e-6 && height < to[1] + 1e-6;
        if (radius > 1e-6 && fabs(normal) < 0.99)
            ck_assert_double_lt(degrees_apart(&of.direction[3 * p], circle), on_side ? side_degrees : other_degrees);
    }
    for (uint32_t i = 0; i < found.count; i++)
        for (uint32_t c = 0; c < 3; c++) {
            place_of(&of, of.surface.corners[3 * (size_t)found.faces[i] + c], &height, circle);
            ck_assert(fabs(height - top) < 1e-6 || fabs(height - bottom) < 1e-6);
        }
}

static const uint32_t sides[] = {8, 12, 16, 24, 32, 40};

/* Checks a profile with the numbers of sides from the one at index `first` on, and both diagonals of its faces.
 *   other_degrees  as for check_runs_around */
static void check_sides(const struct profile *profile, uint32_t first, bool mirrored, double other_degrees)
{
    for (uint32_t s = first; s < sizeof sides / sizeof *sides; s++)
        for (uint32_t k = 0; k < 2; k++)
            check_runs_around(profile, (struct division){sides[s], k, mirrored}, 1, other_degrees);
}

START_TEST(directions_run_around_a_cylinder_with_chamfers)
{
    for (uint32_t k = 0; k < 6; k++) {
        struct profile profile = chamfered(0.4, 0.4, 0.9, 30 + 15 * (k / 2));
        check_sides(&profile, 0, k & 1, 10);
    }
}
END_TEST

START_TEST(directions_run_around_a_cone_with_chamfers)
{
    struct profile profile = chamfered(0.5, 0.3, 0.9, 40);
    check_sides(&profile, 1, false, 12);
}
END_TEST

/* A disc would bend more at its chamfers than around, if these counted. */
START_TEST(directions_run_around_a_disc_with_chamfers)
{
    struct profile profile = chamfered(0.4, 0.4, 0.2, 45);
    check_sides(&profile, 0, false, 10);
}
END_TEST

/* The flat end below is cut off, so that the side ends at a border. Then a fillet between a rim and a crease. */
START_TEST(directions_run_around_a_side_with_one_chamfer_and_above_a_fillet)
{
    struct profile one = {3, {{0.4, 0}, {0.4, 0.95}, {0.35, 1}}, {0, 1}};
    struct profile fillet = {10, {{0.55, -0.2}}, {7, 8}};
    for (uint32_t row = 0; row < 7; row++) {
        double turn = row * PI / 12;
        fillet.at[1 + row][0] = 0.4 + 0.15 * (1 - sin(turn));
        fillet.at[1 + row][1] = 0.15 * (1 - cos(turn));
    }
    fillet.at[8][0] = 0.4;
    fillet.at[8][1] = 1;
    fillet.at[9][0] = 0.37;
    fillet.at[9][1] = 1.03;
    for (uint32_t k = 0; k < 2; k++) {
        check_runs_around(&one, (struct division){32, k, false}, 1, 10);
        check_runs_around(&fillet, (struct division){32, k, false}, 1, 10);
    }
}
END_TEST

/* Rows of faces that divide the side make no difference to its ends. */
START_TEST(directions_run_around_a_side_of_several_rows)
{
    struct profile profile = {12, {{0.35, 0}}, {1, 10}};
    for (uint32_t row = 0; row < 10; row++) {
        profile.at[1 + row][0] = 0.4;
        profile.at[1 + row][1] = 0.05 + 0.1 * row;
    }
    profile.at[11][0] = 0.35;
    profile.at[11][1] = 1;
    for (uint32_t k = 0; k < 2; k++)
        check_runs_around(&profile, (struct division){32, k, false}, 5, 10);
}
END_TEST

START_TEST(surfaces_without_long_faces_stay_as_they_are)
{
    const enum hatch_shape shapes[] = {HATCH_SHAPE_TORUS, HATCH_SHAPE_CYLINDER, HATCH_SHAPE_ELLIPSOID,
                                       HATCH_SHAPE_TEAPOT};
    for (int k = 0; k < 4; k++) {
        struct field_case of = case_of_shape(shapes[k], 3000, 1);
        struct hatch_curvature before = estimate_case(&of, 0, 0), after = estimate_case(&of, 0, 0);
        HATCH_TEST_OK(hatch_curvature_follow_rims(&of.surface, &of.frames, CREASE_RAD, &scratch, &after, &err), &err);
        ck_assert_mem_eq(before.direction, after.direction, 3 * sizeof(double) * of.surface.point_count);
        ck_assert_mem_eq(before.confidence, after.confidence, sizeof(double) * of.surface.point_count);
    }
}
END_TEST

struct call {
    struct field_case of;
    struct hatch_curvature curvature;
};

static enum hatch_status run(void *context, struct hatch_arena *kept, struct hatch_arena *temporary,
                             struct hatch_err *error)
{
    struct call *call = context;
    (void)kept;
    return hatch_curvature_follow_rims(&call->of.surface, &call->of.frames, CREASE_RAD, temporary, &call->curvature,
                                       error);
}

START_TEST(failed_allocations_are_reported)
{
    struct profile profile = chamfered(0.4, 0.4, 0.9, 45);
    struct call call = {.of = case_of(turned(&profile, (struct division){12, false, false}))};
    call.curvature = estimate_case(&call.of, 0, 0);
    hatch_test_fail_alloc(run, &call, call.curvature.direction, 3 * sizeof(double) * call.of.surface.point_count);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("rims");
    TCase *tests = tcase_create("rims");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, directions_run_around_a_cylinder_with_chamfers);
    tcase_add_test(tests, directions_run_around_a_cone_with_chamfers);
    tcase_add_test(tests, directions_run_around_a_disc_with_chamfers);
    tcase_add_test(tests, directions_run_around_a_side_with_one_chamfer_and_above_a_fillet);
    tcase_add_test(tests, directions_run_around_a_side_of_several_rows);
    tcase_add_test(tests, surfaces_without_long_faces_stay_as_they_are);
    tcase_add_test(tests, failed_allocations_are_reported);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
