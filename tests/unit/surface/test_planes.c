#include <stdlib.h>

#include "fail_alloc.h"
#include "meshes.h"
#include "run.h"
#include "math/vector.h"
#include "surface/surface.h"

static struct hatch_surface cut(const struct hatch_mesh *mesh)
{
    struct hatch_surface made;
    struct hatch_surface_notes notes;
    HATCH_TEST_OK(hatch_surface_make_cut(mesh, &keep, &scratch, &made, &notes, &err), &err);
    return made;
}

/* A box of 3 x 2 x 1 of twelve faces, one of which is turned over. */
static struct hatch_mesh box(void)
{
    float positions[24];
    static const uint32_t indices[36] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                         2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 5, 7};
    for (int v = 0; v < 8; v++) {
        positions[3 * v] = 3.0f * (float)(v & 1);
        positions[3 * v + 1] = 2.0f * (float)(v >> 1 & 1);
        positions[3 * v + 2] = (float)(v >> 2);
    }
    return mesh_of(positions, 8, indices, 12);
}

START_TEST(a_box_has_six_planes_along_their_longer_edges)
{
    struct hatch_mesh mesh = box();
    struct hatch_surface s = cut(&mesh);
    ck_assert_uint_eq(s.plane_count, 6);
    ck_assert_uint_eq(s.component_count, 6);
    ck_assert_uint_eq(s.point_count, 24);
    for (uint32_t f = 0; f < 12; f++) {
        double normal[3];
        hatch_surface_face_normal(&s, f, normal);
        hatch_vec_normalize(normal);
        const double *line = &s.plane_direction[3 * (size_t)s.face_plane[f]];
        int longest = fabs(normal[0]) > 0.5 ? 1 : 0;
        ck_assert_double_eq_tol(fabs(line[longest]), 1, 1e-12);
        ck_assert_uint_eq(s.components[f / 2].body, 0);
    }
}
END_TEST

START_TEST(without_planes_a_box_is_one_component)
{
    struct hatch_mesh mesh = box();
    struct hatch_surface s;
    struct hatch_surface_notes notes;
    HATCH_TEST_OK(hatch_surface_make(&mesh, &keep, &scratch, &s, &notes, &err), &err);
    ck_assert_uint_eq(s.plane_count, 0);
    ck_assert_uint_eq(s.component_count, 1);
    ck_assert_uint_eq(s.face_plane[5], HATCH_NO_SIDE);
}
END_TEST

START_TEST(curved_shapes_have_no_planes)
{
    static const enum hatch_shape shapes[] = {HATCH_SHAPE_SPHERE,   HATCH_SHAPE_TORUS,  HATCH_SHAPE_ELLIPSOID,
                                              HATCH_SHAPE_CYLINDER, HATCH_SHAPE_SADDLE, HATCH_SHAPE_FRUSTUM};
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++)
        for (int noisy = 0; noisy < 3; noisy++) {
            struct hatch_mesh mesh = shape_with(
                shapes[i], (struct hatch_shape_options){
                               .faces = noisy ? 20000 : 300, .jitter = 1, .noise = 0.2f * (float)noisy, .seed = 2});
            ck_assert_msg(cut(&mesh).plane_count == 0, "%s, noise %g", hatch_shape_names[shapes[i]], 0.2 * noisy);
        }
}
END_TEST

/* A rod of radius 1 with a corner at each end of its sides and two fans of triangles around corner 0 of its ends. */
static struct hatch_mesh rod(uint32_t sides, float height)
{
    enum { SIDES_MAX = 24 };
    static float positions[6 * SIDES_MAX];
    static uint32_t indices[12 * SIDES_MAX];
    uint32_t faces = 0;
    for (uint32_t v = 0; v < 2 * sides; v++) {
        positions[3 * v] = (float)cos(2 * 3.14159265358979 * (v / 2) / sides);
        positions[3 * v + 1] = (float)sin(2 * 3.14159265358979 * (v / 2) / sides);
        positions[3 * v + 2] = v % 2 ? height : 0;
    }
    for (uint32_t i = 0; i < sides; i++) {
        uint32_t a = 2 * i, b = 2 * ((i + 1) % sides);
        const uint32_t around[6] = {a, b, b + 1, a, b + 1, a + 1}, ends[6] = {0, b, a, 1, a + 1, b + 1};
        memcpy(&indices[3 * faces], around, sizeof around);
        faces += 2;
        if (a == 0 || b == 0)
            continue;
        memcpy(&indices[3 * faces], ends, sizeof ends);
        faces += 2;
    }
    return mesh_of(positions, 2 * sides, indices, faces);
}

/* Of 5 sides, whose edges still count as round, an end has only three faces; of 8, each face around them is larger than
 * an end; of 24 and a height of 9, the ends are a tenth of the surface. */
START_TEST(ends_of_rods_are_planes_however_long)
{
    static const uint32_t sides[] = {5, 8, 24};
    for (int i = 0; i < 3; i++)
        for (float height = 1; height < 2000; height *= 3) {
            struct hatch_mesh mesh = rod(sides[i], height);
            struct hatch_surface s = cut(&mesh);
            ck_assert_msg(s.plane_count == 2 && s.component_count == 3, "%u sides, height %g: %u planes", sides[i],
                          (double)height, s.plane_count);
        }
}
END_TEST

enum { TUBE_SIDES = 24, RIM = 2 * TUBE_SIDES };

/* A tube of height 3 whose ends are open, and at some sides of its lower rim flat petals of a length, which come first.
 */
static struct hatch_mesh tube(uint32_t petals, double length)
{
    struct hatch_mesh closed = rod(TUBE_SIDES, 3), mesh;
    const double half = 3.14159265358979 / TUBE_SIDES;
    uint32_t faces = petals;
    HATCH_TEST_OK(hatch_mesh_make(&keep, RIM + petals, petals + 2 * TUBE_SIDES, &mesh, &err), &err);
    memcpy(mesh.attributes[0].data, closed.attributes[0].data, RIM * 12);
    for (uint32_t i = 0; i < petals; i++) {
        float *tip = &mesh.attributes[0].data[3 * (RIM + i)];
        tip[0] = (float)((cos(half) + length) * cos((2 * i + 1) * half));
        tip[1] = (float)((cos(half) + length) * sin((2 * i + 1) * half));
        memcpy(&mesh.indices[3 * i], (const uint32_t[3]){2 * ((i + 1) % TUBE_SIDES), 2 * i, RIM + i}, 12);
    }
    for (uint32_t f = 0; f < closed.face_count; f++) {
        const uint32_t *corner = &closed.indices[3 * f];
        if (corner[0] % 2 != corner[1] % 2 || corner[1] % 2 != corner[2] % 2)
            memcpy(&mesh.indices[3 * faces++], corner, 12);
    }
    ck_assert_uint_eq(faces, mesh.face_count);
    return mesh;
}

/* Of a tube with a petal all is curved but this facet, which is dropped. The planes of a box beside it have the numbers
 * from 0 on. */
START_TEST(facets_of_curved_bodies_are_dropped)
{
    struct hatch_mesh bent = tube(1, 1), beside = box();
    for (uint32_t v = 0; v < beside.vertex_count; v++)
        beside.attributes[0].data[3 * v] += 9;
    struct hatch_mesh mesh = both(&bent, &beside);
    struct hatch_surface s = cut(&mesh);
    ck_assert_uint_eq(s.plane_count, 6);
    ck_assert_uint_eq(s.component_count, 7);
    for (uint32_t f = 0; f < s.face_count; f++) {
        uint32_t source = s.face_source[f];
        bool of_box = source >= bent.face_count;
        ck_assert_uint_eq(s.face_plane[f], of_box ? (source - bent.face_count) / 2 : HATCH_NO_SIDE);
    }
}
END_TEST

/* A petal of length 28.1 has 8 times the mean area of all 49 faces. Petals all round have 0.3 of the whole area where
 * they are 18 / 7 long: their area is half their length along the rim, that of the tube 3 times the rim. */
START_TEST(facets_stay_where_they_are_large_or_many)
{
    struct hatch_mesh small = tube(1, 27), large = tube(1, 29);
    struct hatch_mesh few = tube(TUBE_SIDES, 2.5), many = tube(TUBE_SIDES, 2.65);
    ck_assert_uint_eq(cut(&small).plane_count, 0);
    ck_assert_uint_eq(cut(&large).plane_count, 1);
    ck_assert_uint_eq(cut(&few).plane_count, 0);
    ck_assert_uint_eq(cut(&many).plane_count, TUBE_SIDES);
}
END_TEST

/* A sheet of 2 x 8 by 8 squares, folded in the middle. */
static struct hatch_surface fold(double degrees)
{
    enum { SIZE = 8, ROW = 2 * SIZE + 1 };
    static float positions[3 * ROW * (SIZE + 1)];
    static uint32_t indices[6 * 2 * SIZE * SIZE];
    double turn = degrees * 3.14159265358979 / 180;
    for (int v = 0; v < ROW * (SIZE + 1); v++) {
        double x = v % ROW - SIZE;
        positions[3 * v] = (float)(x > 0 ? x * cos(turn) : x);
        positions[3 * v + 1] = (float)(v / ROW);
        positions[3 * v + 2] = (float)(x > 0 ? x * sin(turn) : 0);
    }
    for (uint32_t q = 0; q < 2 * SIZE * SIZE; q++) {
        uint32_t a = q / (2 * SIZE) * ROW + q % (2 * SIZE), c = a + ROW;
        const uint32_t faces[6] = {a, a + 1, c, a + 1, c + 1, c};
        memcpy(&indices[6 * q], faces, sizeof faces);
    }
    struct hatch_mesh mesh = mesh_of(positions, ROW * (SIZE + 1), indices, 4 * SIZE * SIZE);
    return cut(&mesh);
}

START_TEST(creases_around_planes_are_cut)
{
    struct hatch_surface sharp = fold(30), blunt = fold(10), flat = fold(0.01);
    ck_assert_uint_eq(sharp.plane_count, 2);
    ck_assert_uint_eq(sharp.component_count, 2);
    ck_assert_uint_eq(sharp.point_count, blunt.point_count + 9);
    ck_assert_uint_eq(blunt.plane_count, 2);
    ck_assert_uint_eq(blunt.component_count, 1);
    ck_assert_uint_eq(flat.plane_count, 1);
}
END_TEST

/* A gutter of three strips, 6 by 3 rectangles each, ten times as long as wide, which meet at 10 degrees. The middle one
 * is open along 12 of the 18 sides of its border, but these are a sixth of its length. */
START_TEST(creases_are_counted_by_their_length)
{
    enum { STRIP = 6, ROW = 3 * STRIP + 1, ROWS = 4 };
    static float positions[3 * ROW * ROWS];
    static uint32_t indices[6 * (ROW - 1) * (ROWS - 1)];
    const double turn = 10 * 3.14159265358979 / 180;
    for (int v = 0; v < ROW * ROWS; v++) {
        double beyond = fmax(0, abs(v % ROW - ROW / 2) - STRIP / 2), side = v % ROW < ROW / 2 ? -1 : 1;
        double inside = v % ROW - ROW / 2 - side * beyond;
        positions[3 * v] = (float)(inside + side * beyond * cos(turn));
        positions[3 * v + 1] = 10.0f * (float)(v / ROW);
        positions[3 * v + 2] = (float)(beyond * sin(turn));
    }
    for (uint32_t q = 0; q < (ROW - 1) * (ROWS - 1); q++) {
        uint32_t a = q / (ROW - 1) * ROW + q % (ROW - 1), c = a + ROW;
        const uint32_t faces[6] = {a, a + 1, c, a + 1, c + 1, c};
        memcpy(&indices[6 * q], faces, sizeof faces);
    }
    struct hatch_mesh mesh = mesh_of(positions, ROW * ROWS, indices, 2 * (ROW - 1) * (ROWS - 1));
    ck_assert_uint_eq(cut(&mesh).plane_count, 2);
}
END_TEST

/* Finds a face whose edge from (x[0], 0) to (x[1], z) lies at the limit of 20 degrees to a plane z = 0: the cosine that
 * is computed for it equals the constant. */
static void find_limit(float x[2], float *z)
{
    const double limit = 0.9397;
    double normal[3] = {0};
    for (*z = 0.25f; *z < 0.5f && normal[2] != limit; *z += 0x1p-20f) {
        double along = (double)*z * limit / sqrt(1 - limit * limit);
        x[1] = (float)along;
        x[0] = (float)((double)x[1] - along);
        const double a[3] = {(double)x[0], 0, 0}, b[3] = {(double)x[1], 0, (double)*z}, c[3] = {(double)x[0], 8, 0};
        hatch_vec_triangle(a, b, c, normal);
        hatch_vec_normalize(normal);
        if (normal[2] == limit)
            return;
    }
    ck_abort_msg("no cosine equals the limit");
}

/* A strip of 6 by 3 rectangles between two that are too small for planes, at 10 degrees and at the limit: that border
 * is a crease, and with the open ends more than half of the strip's border is. */
START_TEST(a_crease_at_the_limit_counts)
{
    enum { ROW = 13, ROWS = 4 };
    static float positions[3 * ROW * ROWS];
    static uint32_t indices[6 * (ROW - 1) * (ROWS - 1)];
    float x[2], z;
    find_limit(x, &z);
    for (int v = 0; v < ROW * ROWS; v++) {
        int column = v % ROW, left = 3 - column, right = column - 9;
        positions[3 * v] = right > 0 ? (float)right * x[1] : right == 0 ? x[0] : (float)right;
        positions[3 * v + 1] = 8.0f * (float)(v / ROW);
        positions[3 * v + 2] = right > 0 ? (float)right * z : left > 0 ? 0.1763f * (float)left : 0;
    }
    for (uint32_t q = 0; q < (ROW - 1) * (ROWS - 1); q++) {
        uint32_t a = q / (ROW - 1) * ROW + q % (ROW - 1), c = a + ROW;
        const uint32_t faces[6] = {a, a + 1, c, a + 1, c + 1, c};
        memcpy(&indices[6 * q], faces, sizeof faces);
    }
    struct hatch_mesh mesh = mesh_of(positions, ROW * ROWS, indices, 2 * (ROW - 1) * (ROWS - 1));
    ck_assert_uint_eq(cut(&mesh).plane_count, 1);
}
END_TEST

/* An L of 3 x 3 squares without the last: 3 + 2 + 1 units of its border run either way; turned by 20 degrees. */
START_TEST(directions_follow_straight_borders_however_they_lie)
{
    static const float outline[12] = {0, 0, 5, 0, 5, 1, 1, 1, 1, 3, 0, 3};
    static const uint32_t indices[12] = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5};
    float positions[18];
    double turn = 0.349;
    for (size_t v = 0; v < 6; v++) {
        double x = (double)outline[2 * v], y = (double)outline[2 * v + 1];
        positions[3 * v] = (float)(cos(turn) * x - sin(turn) * y);
        positions[3 * v + 1] = 100;
        positions[3 * v + 2] = (float)(sin(turn) * x + cos(turn) * y);
    }
    struct hatch_mesh mesh = mesh_of(positions, 6, indices, 4);
    struct hatch_surface s = cut(&mesh);
    ck_assert_uint_eq(s.plane_count, 1);
    double along = cos(turn) * s.plane_direction[0] + sin(turn) * s.plane_direction[2];
    ck_assert_double_eq_tol(fabs(along), 1, 1e-6);
}
END_TEST

/* An ellipse of 2 by 1 turned by 0.6 radians, of which less than a tenth of the border runs in any direction. */
START_TEST(round_borders_leave_the_axis_of_coordinates)
{
    enum { CORNERS = 120 };
    float positions[3 * CORNERS];
    uint32_t indices[3 * (CORNERS - 2)];
    for (uint32_t v = 0; v < CORNERS; v++) {
        double t = 2 * 3.14159265358979 * v / CORNERS, x = 2 * cos(t), y = sin(t);
        positions[3 * v] = (float)(cos(0.6) * x - sin(0.6) * y);
        positions[3 * v + 1] = (float)(sin(0.6) * x + cos(0.6) * y);
        positions[3 * v + 2] = 0;
    }
    for (uint32_t f = 0; f < CORNERS - 2; f++) {
        const uint32_t corners[3] = {0, f + 1, f + 2};
        memcpy(&indices[3 * f], corners, sizeof corners);
    }
    struct hatch_mesh mesh = mesh_of(positions, CORNERS, indices, CORNERS - 2);
    struct hatch_surface s = cut(&mesh);
    ck_assert_uint_eq(s.plane_count, 1);
    ck_assert_double_eq_tol(fabs(s.plane_direction[0]), 1, 1e-9);
}
END_TEST

static enum hatch_status cut_with(void *context, struct hatch_arena *arena, struct hatch_arena *work,
                                  struct hatch_err *error)
{
    struct hatch_mesh mesh = box();
    struct hatch_surface_notes notes;
    return hatch_surface_make_cut(&mesh, arena, work, context, &notes, error);
}

START_TEST(every_failed_allocation_is_a_limit)
{
    struct hatch_surface made = {0};
    hatch_test_fail_alloc(cut_with, &made, &made, sizeof made);
}
END_TEST

static Suite *suite(void)
{
    Suite *all = suite_create("planes");
    TCase *tests = tcase_create("planes");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_box_has_six_planes_along_their_longer_edges);
    tcase_add_test(tests, ends_of_rods_are_planes_however_long);
    tcase_add_test(tests, facets_of_curved_bodies_are_dropped);
    tcase_add_test(tests, facets_stay_where_they_are_large_or_many);
    tcase_add_test(tests, without_planes_a_box_is_one_component);
    tcase_add_test(tests, curved_shapes_have_no_planes);
    tcase_add_test(tests, creases_around_planes_are_cut);
    tcase_add_test(tests, creases_are_counted_by_their_length);
    tcase_add_test(tests, a_crease_at_the_limit_counts);
    tcase_add_test(tests, directions_follow_straight_borders_however_they_lie);
    tcase_add_test(tests, round_borders_leave_the_axis_of_coordinates);
    tcase_add_test(tests, every_failed_allocation_is_a_limit);
    suite_add_tcase(all, tests);
    return all;
}
HATCH_TEST_MAIN(suite)
