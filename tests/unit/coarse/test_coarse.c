/* Coarse meshes whose numbers of faces and errors are known. */
#include "coarse/work.h"

#include "math/triangle.h"
#include "math/vector.h"
#include "fail_alloc.h"
#include "meshes.h"
#include "run.h"

/* Makes a mesh coarser with one tolerance everywhere. */
static struct hatch_mesh coarse_of(const struct hatch_mesh *mesh, double tolerance)
{
    struct hatch_mesh out;
    double *tolerances = HATCH_NEW(&keep, double, mesh->vertex_count, &err);
    ck_assert_ptr_nonnull(tolerances);
    for (uint32_t v = 0; v < mesh->vertex_count; v++)
        tolerances[v] = tolerance;
    const struct hatch_coarse_part part = {mesh, tolerances, NULL};
    HATCH_TEST_OK(hatch_coarse_make(&part, 1, &keep, &scratch, &out, &err), &err);
    return out;
}

static double area_of(const struct hatch_mesh *mesh)
{
    double sum = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        double corners[3][3], normal[3];
        hatch_mesh_corners(mesh, f, corners);
        hatch_vec_triangle(corners[0], corners[1], corners[2], normal);
        sum += hatch_vec_length(normal) / 2;
    }
    return sum;
}

/* Makes a square of n² squares in the plane z = 0, from 0 to 1, with waves of a height. */
static struct hatch_mesh sheet(uint32_t n, double height)
{
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, (n + 1) * (n + 1), 2 * n * n, &mesh, &err), &err);
    for (uint32_t i = 0; i < (n + 1) * (n + 1); i++) {
        float *at = &mesh.attributes[0].data[3 * i];
        at[0] = (float)(i % (n + 1)) / (float)n;
        at[1] = (float)(i / (n + 1)) / (float)n;
        at[2] = (float)(height * sin(2 * PI * (double)at[0]));
    }
    for (uint32_t q = 0; q < n * n; q++) {
        uint32_t a = q / n * (n + 1) + q % n, b = a + 1, c = a + n + 1, d = c + 1;
        const uint32_t faces[6] = {a, b, c, b, d, c};
        memcpy(&mesh.indices[6 * (size_t)q], faces, sizeof faces);
    }
    return mesh;
}

/* Adds the plane at a distance from the origin along an axis. */
static void add_plane(struct hatch_coarse_quadric *quadric, int axis, double distance, double weight)
{
    static const int square[3] = {0, 4, 7}, linear[3] = {3, 6, 8}; /* of x x, y y, z z, and of x, y, z */
    quadric->terms[square[axis]] += weight;
    quadric->terms[linear[axis]] -= weight * distance;
    quadric->terms[9] += weight * distance * distance;
    quadric->weight += weight;
}

/* A point at (1, 2, 3) collapses onto one at (4, 6, 3), 5 away. Both have the plane z = 3; then also one each, from
 * which the second point is 2 and 3 away. */
START_TEST(a_collapse_costs_squared_distances_from_planes)
{
    double at[6] = {1, 2, 3, 4, 6, 3}, tolerance[2] = {7, 0.5};
    struct hatch_coarse_quadric quadrics[2] = {{.weight = 0}};
    const struct hatch_coarse_work work = {.at = at, .tolerance = tolerance, .quadric = quadrics};
    add_plane(&quadrics[0], 2, 3, 8);
    add_plane(&quadrics[1], 2, 3, 10);
    /* Where all is flat, the shortest edge goes first. */
    ck_assert_double_eq_tol(hatch_coarse_cost(&work, 0, 1), 1e-6 * 25 * 8 / 0.25, 1e-12);
    add_plane(&quadrics[0], 0, 2, 1);
    add_plane(&quadrics[1], 1, 9, 0.5);
    ck_assert_double_eq_tol(hatch_coarse_cost(&work, 0, 1), (2 * 2 + 0.5 * 3 * 3 + 1e-6 * 25 * 9) / 0.25, 1e-9);
}
END_TEST

START_TEST(a_plane_becomes_two_faces)
{
    struct hatch_mesh plane = sheet(70, 0), coarse = coarse_of(&plane, 1e-4);
    ck_assert_uint_eq(coarse.face_count, 2);
    ck_assert_uint_eq(coarse.vertex_count, 4);
    ck_assert_double_eq_tol(area_of(&coarse), 1, 1e-6);
}
END_TEST

START_TEST(a_box_keeps_its_twelve_faces)
{
    struct hatch_mesh box = cube(-1, 1), coarse = coarse_of(&box, 1e-3);
    ck_assert_uint_eq(coarse.face_count, 12);
    ck_assert_double_eq_tol(area_of(&coarse), 24, 1e-6);
}
END_TEST

/* A sphere of radius 1 whose surface may move by e has faces of circumradius r with r^2 / 2 = e: about 4 pi / (3
 * sqrt(3) / 4 r^2) of them, if they were all equilateral. */
START_TEST(a_sphere_follows_the_sagitta)
{
    struct hatch_mesh sphere = bare_shape(HATCH_SHAPE_SPHERE, 30000);
    for (double e = 2e-3; e < 2e-2; e *= 3) {
        struct hatch_mesh coarse = coarse_of(&sphere, e);
        double ideal = 4 * PI / (3 * sqrt(3) / 4 * 2 * e), deepest = 1;
        ck_assert_double_ge(coarse.face_count, 0.9 * ideal);
        ck_assert_double_le(coarse.face_count, 2 * ideal);
        for (uint32_t f = 0; f < coarse.face_count; f++) {
            double corners[3][3], share[3];
            hatch_mesh_corners(&coarse, f, corners);
            double squared =
                hatch_triangle_distance_squared(corners[0], corners[1], corners[2], (const double[3]){0, 0, 0}, share);
            deepest = fmin(deepest, sqrt(squared));
        }
        ck_assert_double_ge(deepest, 1 - 1.3 * e);
    }
}
END_TEST

/* Returns the distance of a vertex of a mesh from another mesh. */
static double distance_from(const struct hatch_mesh *coarse, const struct hatch_mesh *mesh, uint32_t vertex)
{
    double at[3], least = INFINITY;
    hatch_vec_of(&mesh->attributes[0].data[3 * (size_t)vertex], at);
    for (uint32_t f = 0; f < coarse->face_count; f++) {
        double corners[3][3], share[3];
        hatch_mesh_corners(coarse, f, corners);
        least = fmin(least, hatch_triangle_distance_squared(corners[0], corners[1], corners[2], at, share));
    }
    return sqrt(least);
}

START_TEST(no_removed_point_is_farther_than_its_tolerance)
{
    struct hatch_mesh waves = sheet(40, 0.1), coarse = coarse_of(&waves, 0.01);
    ck_assert_uint_lt(coarse.face_count, 200);
    for (uint32_t v = 0; v < waves.vertex_count; v++) {
        ck_assert_double_le(distance_from(&coarse, &waves, v), 0.01 + 1e-7);
    }
}
END_TEST

/* Returns the difference of a vertex's colour from that of the nearest place on a coarse mesh. */
static double colour_error(const struct hatch_mesh *coarse, const struct hatch_mesh *mesh, uint32_t vertex)
{
    const float *colors = hatch_mesh_find(coarse, "COLOR_0", 3);
    double at[3], least = INFINITY, color = 0;
    hatch_vec_of(&mesh->attributes[0].data[3 * (size_t)vertex], at);
    for (uint32_t f = 0; f < coarse->face_count; f++) {
        double corners[3][3], share[3], distance, sum = 0;
        hatch_mesh_corners(coarse, f, corners);
        distance = hatch_triangle_distance_squared(corners[0], corners[1], corners[2], at, share);
        for (uint32_t c = 0; c < 3; c++)
            sum += share[c] * (double)colors[3 * coarse->indices[3 * f + c]];
        color = distance < least ? sum : color;
        least = fmin(least, distance);
    }
    return fabs(color - (double)hatch_mesh_find(mesh, "COLOR_0", 3)[3 * vertex]);
}

/* Colours may differ by 0.03 on the nearest face, and on others that are hardly farther; here many are within the
 * tolerance. */
START_TEST(colours_are_compared_where_they_are_near)
{
    struct hatch_mesh waves = sheet(40, 0.3);
    float *colors;
    HATCH_TEST_OK(hatch_mesh_add(&keep, &waves, "COLOR_0", 3, &colors, &err), &err);
    for (uint32_t v = 0; v < waves.vertex_count; v++) {
        const float *at = &waves.attributes[0].data[3 * (size_t)v];
        colors[3 * v] = 0.5f + 0.5f * sinf(9 * at[0] + 5 * at[1]);
    }
    struct hatch_mesh coarse = coarse_of(&waves, 0.05);
    double largest = 0;
    ck_assert_uint_lt(coarse.face_count, waves.face_count / 2);
    for (uint32_t v = 0; v < waves.vertex_count; v++)
        largest = fmax(largest, colour_error(&coarse, &waves, v));
    ck_assert_double_le(largest, 0.035);
}
END_TEST

/* Makes a mesh coarser, loosely.
 *   cosine  of the normals, at all vertices */
static struct hatch_mesh loose_of(const struct hatch_mesh *mesh, double tolerance, float cosine)
{
    struct hatch_mesh out;
    double *tolerances = HATCH_NEW(&keep, double, mesh->vertex_count, &err);
    float *cosines = HATCH_NEW(&keep, float, mesh->vertex_count, &err);
    ck_assert(tolerances && cosines);
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        tolerances[v] = tolerance;
        cosines[v] = cosine;
    }
    const struct hatch_coarse_part part = {mesh, tolerances, cosines};
    HATCH_TEST_OK(hatch_coarse_make_loosely(&part, 1, &keep, &scratch, &out, &err), &err);
    return out;
}

START_TEST(loosely_a_plane_stays_a_square_without_needles)
{
    struct hatch_mesh plane = sheet(40, 0), coarse = loose_of(&plane, 1e-2, -1);
    ck_assert_uint_le(coarse.face_count, 40);
    ck_assert_double_eq_tol(area_of(&coarse), 1, 1e-6);
}
END_TEST

/* Waves too flat for faces to turn much keep their height of .005 where the mean distance may be a fiftieth of it. */
START_TEST(loosely_waves_keep_their_height)
{
    struct hatch_mesh waves = sheet(60, 0.005), coarse = loose_of(&waves, 1e-4, -1);
    double farthest = 0;
    ck_assert_uint_lt(coarse.face_count, waves.face_count / 4);
    ck_assert_uint_gt(coarse.face_count, 2 * loose_of(&waves, 1e-2, -1).face_count);
    for (uint32_t v = 0; v < waves.vertex_count; v++) {
        farthest = fmax(farthest, distance_from(&coarse, &waves, v));
    }
    ck_assert_double_le(farthest, 5e-4);
}
END_TEST

/* Faces of a sphere whose normals are within an angle a of their corners' have edges of at most about 2 a, and a
 * circumradius of a. */
START_TEST(loosely_faces_keep_near_the_normals_of_their_corners)
{
    struct hatch_mesh sphere = bare_shape(HATCH_SHAPE_SPHERE, 30000);
    HATCH_TEST_OK(hatch_mesh_add_normals(&keep, &scratch, &sphere, 0, &err), &err);
    for (double cosine = 0.995; cosine > 0.96; cosine -= 0.015) {
        struct hatch_mesh coarse = loose_of(&sphere, 10, (float)cosine);
        const float *normals = hatch_mesh_find(&coarse, "NORMAL", 3);
        ck_assert_uint_lt(coarse.face_count, 30000 / 4);
        for (uint32_t f = 0; f < coarse.face_count; f++)
            for (size_t c = 0; c < 3; c++) {
                double corners[3][3], normal[3], at[3];
                hatch_mesh_corners(&coarse, f, corners);
                hatch_vec_triangle(corners[0], corners[1], corners[2], normal);
                hatch_vec_normalize(normal);
                hatch_vec_of(&normals[3 * (size_t)coarse.indices[3 * (size_t)f + c]], at);
                ck_assert_double_ge(hatch_vec_dot(normal, at), cosine - 1e-6);
            }
    }
}
END_TEST

/* Two flat fans that meet at their middles alone, one of which has a dent to near its middle, and which differ in
 * texture: the shared point stays, although each fan alone would lose it. */
START_TEST(a_point_where_surfaces_touch_stays)
{
    struct hatch_mesh one = fan(6), dented = fan(6), both;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 14, 12, &both, &err), &err);
    float *texcoords;
    HATCH_TEST_OK(hatch_mesh_add(&keep, &both, "TEXCOORD_0", 2, &texcoords, &err), &err);
    texcoords[2 * 13] = 1;
    dented.attributes[0].data[0] = 0.005f;
    for (uint32_t i = 0; i < 14; i++)
        for (size_t k = 0; k < 3; k++)
            both.attributes[0].data[3 * i + k] =
                (i < 7 ? &one : &dented)->attributes[0].data[3 * (i % 7) + (k + i / 7) % 3];
    for (uint32_t i = 0; i < 36; i++)
        both.indices[i] = one.indices[i % 18] + 7 * (i / 18);
    ck_assert_uint_eq(coarse_of(&one, 0.01).face_count, 4);
    ck_assert_uint_eq(coarse_of(&dented, 0.01).face_count, 4);
    ck_assert_uint_eq(coarse_of(&both, 0.01).face_count, 12);
}
END_TEST

/* Counts the corners of borders whose position is at most a distance from the middle. */
static uint32_t border_within(const struct hatch_mesh *mesh, double limit)
{
    uint32_t count = 0;
    for (uint32_t side = 0; side < 3 * mesh->face_count; side++) {
        uint32_t from = mesh->indices[side], to = mesh->indices[side / 3 * 3 + (side + 1) % 3], back = 0;
        for (uint32_t other = 0; other < 3 * mesh->face_count; other++)
            back += mesh->indices[other] == to && mesh->indices[other / 3 * 3 + (other + 1) % 3] == from;
        const float *at = &mesh->attributes[0].data[3 * (size_t)from];
        count += !back && hypot((double)at[0], (double)at[1]) <= limit;
    }
    return count;
}

/* A disc whose rim has teeth that are lower than the tolerance. Points of the rim move along it alone, although there
 * are points beside it that are nearer. */
START_TEST(points_of_a_border_stay_on_it)
{
    enum { AROUND = 96 };
    struct hatch_mesh disc;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 2 * AROUND + 1, 3 * AROUND, &disc, &err), &err);
    for (uint32_t i = 0; i < AROUND; i++) {
        uint32_t next = (i + 1) % AROUND;
        const uint32_t faces[9] = {i,          next,       AROUND + i,    next,      AROUND + next,
                                   AROUND + i, AROUND + i, AROUND + next, 2 * AROUND};
        memcpy(&disc.indices[9 * (size_t)i], faces, sizeof faces);
        for (uint32_t ring = 0; ring < 2; ring++) {
            double radius = ring ? 0.97 : i % 3 ? 1 : 1.02;
            float *at = &disc.attributes[0].data[3 * (size_t)(ring * AROUND + i)];
            at[0] = (float)(radius * cos(2 * PI * i / AROUND));
            at[1] = (float)(radius * sin(2 * PI * i / AROUND));
        }
    }
    ck_assert_uint_eq(border_within(&disc, 2), AROUND);
    struct hatch_mesh coarse = coarse_of(&disc, 0.1);
    ck_assert_uint_lt(border_within(&coarse, 2), AROUND / 2);
    ck_assert_uint_eq(border_within(&coarse, 0.98), 0);
}
END_TEST

/* Whatever the tolerance allows, closed surfaces stay closed: each side of a face has one face on its other side, and
 * vertices less edges and faces are as many as before. */
START_TEST(closed_surfaces_stay_closed)
{
    static const enum hatch_shape shapes[] = {HATCH_SHAPE_SPHERE, HATCH_SHAPE_TORUS};
    for (int round = 0; round < 10; round++) {
        const struct hatch_shape_options options = {.faces = 300, .jitter = 1, .seed = (uint64_t)round};
        struct hatch_mesh mesh = shape_with(shapes[round % 2], options), coarse;
        struct hatch_mesh_notes notes = {0};
        mesh.attribute_count = 1;
        HATCH_TEST_OK(hatch_mesh_clean(&keep, &scratch, &mesh, &notes, &err), &err);
        coarse = coarse_of(&mesh, 0.1 * (round + 1));
        ck_assert_uint_lt(coarse.face_count, 150);
        for (uint32_t side = 0; side < 3 * coarse.face_count; side++) {
            uint32_t from = coarse.indices[side], to = coarse.indices[side / 3 * 3 + (side + 1) % 3];
            uint32_t same = 0, back = 0;
            for (uint32_t other = 0; other < 3 * coarse.face_count; other++) {
                uint32_t a = coarse.indices[other], b = coarse.indices[other / 3 * 3 + (other + 1) % 3];
                same += a == from && b == to;
                back += a == to && b == from;
            }
            ck_assert_uint_eq(same, 1);
            ck_assert_uint_eq(back, 1);
        }
        ck_assert_int_eq((int)coarse.vertex_count - (int)coarse.face_count / 2, round % 2 ? 0 : 2);
    }
}
END_TEST

/* Texture coordinates that bend by more than the tolerance keep points on a flat sheet. */
START_TEST(bent_texture_coordinates_keep_points)
{
    struct hatch_mesh plane = sheet(32, 0);
    float *texcoords;
    HATCH_TEST_OK(hatch_mesh_add(&keep, &plane, "TEXCOORD_0", 2, &texcoords, &err), &err);
    for (uint32_t v = 0; v < plane.vertex_count; v++)
        memcpy(&texcoords[2 * (size_t)v], &plane.attributes[0].data[3 * (size_t)v], 8);
    ck_assert_uint_eq(coarse_of(&plane, 0.01).face_count, 2);
    for (uint32_t v = 0; v < plane.vertex_count; v++)
        texcoords[2 * v] += (float)(0.1 * sin(2 * PI * (double)texcoords[2 * v]));
    ck_assert_uint_gt(coarse_of(&plane, 0.01).face_count, 8);
    ck_assert_uint_eq(coarse_of(&plane, 0.5).face_count, 2);
}
END_TEST

/* Two parts that share a border, as primitives of one glTF mesh do: the border's points are the same on both. */
START_TEST(borders_of_parts_stay_closed)
{
    struct hatch_mesh all = sheet(24, 0.1), halves[2] = {all, all}, out[2];
    struct hatch_coarse_part parts[2];
    double *tolerances = HATCH_NEW(&keep, double, all.vertex_count, &err);
    for (uint32_t v = 0; v < all.vertex_count; v++)
        tolerances[v] = 0.004;
    for (int i = 0; i < 2; i++) {
        halves[i].face_count /= 2;
        halves[i].indices += i * 3 * (int)halves[i].face_count;
        parts[i] = (struct hatch_coarse_part){&halves[i], tolerances, NULL};
    }
    HATCH_TEST_OK(hatch_coarse_make(parts, 2, &keep, &scratch, out, &err), &err);
    uint32_t counts[2] = {0, 0};
    double sums[2] = {0, 0};
    for (int i = 0; i < 2; i++) {
        ck_assert_uint_lt(out[i].face_count, 100);
        for (uint32_t v = 0; v < out[i].vertex_count; v++)
            if (out[i].attributes[0].data[3 * v + 1] == 0.5f) {
                counts[i]++;
                sums[i] += (double)out[i].attributes[0].data[3 * v];
            }
    }
    ck_assert_uint_gt(counts[0], 4);
    ck_assert_uint_lt(counts[0], 25);
    ck_assert_uint_eq(counts[0], counts[1]);
    ck_assert_double_eq(sums[0], sums[1]);
}
END_TEST

/* A border between parts that winds on a flat sheet: the shape alone would allow a straight one. */
START_TEST(borders_on_flat_sheets_keep_their_course)
{
    struct hatch_mesh all = sheet(24, 0), halves[2] = {all, all}, out[2];
    struct hatch_coarse_part parts[2];
    double *tolerances = HATCH_NEW(&keep, double, all.vertex_count, &err);
    for (uint32_t v = 0; v < all.vertex_count; v++) {
        float *at = &all.attributes[0].data[3 * (size_t)v];
        tolerances[v] = 0.004;
        at[1] += (float)(0.2 * (double)(at[1] * (1 - at[1])) * sin(2 * PI * (double)at[0]));
    }
    for (int i = 0; i < 2; i++) {
        halves[i].face_count /= 2;
        halves[i].indices += i * 3 * (int)halves[i].face_count;
        parts[i] = (struct hatch_coarse_part){&halves[i], tolerances, NULL};
    }
    HATCH_TEST_OK(hatch_coarse_make(parts, 2, &keep, &scratch, out, &err), &err);
    ck_assert_uint_lt(out[0].face_count, 60);
    ck_assert_uint_gt(out[0].vertex_count, 8);
    /* The area under the winding border is half of the sheet's. */
    ck_assert_double_eq_tol(area_of(&out[0]), 0.5, 0.004);
    ck_assert_double_eq_tol(area_of(&out[0]) + area_of(&out[1]), 1, 1e-5);
}
END_TEST

START_TEST(scale_and_place_do_not_matter)
{
    struct hatch_mesh torus = bare_shape(HATCH_SHAPE_TORUS, 4000);
    uint32_t faces = coarse_of(&torus, 0x1p-7).face_count;
    ck_assert_uint_lt(faces, 2000);
    for (uint32_t i = 0; i < 3 * torus.vertex_count; i++)
        torus.attributes[0].data[i] *= 0x1p-20f;
    ck_assert_uint_eq(coarse_of(&torus, 0x1p-27).face_count, faces);
}
END_TEST

START_TEST(faces_without_points_apart_are_left_out)
{
    static const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0};
    static const uint32_t faces[] = {0, 1, 2, 0, 3, 1};
    struct hatch_mesh mesh = mesh_of(positions, 4, faces, 2);
    ck_assert_uint_eq(coarse_of(&mesh, 0.1).face_count, 1);
    /* Such a face may be the nearest to a place on a new one. */
    struct hatch_mesh plane = sheet(12, 0);
    for (uint32_t f = 0; f < plane.face_count; f += 16)
        plane.indices[3 * f] = plane.indices[3 * f + 1];
    plane.indices[0] = 0;
    ck_assert_uint_lt(coarse_of(&plane, 1e-3).face_count, plane.face_count / 2);
}
END_TEST

struct again {
    struct hatch_coarse_part part;
    struct hatch_mesh out;
};

static enum hatch_status make_again(void *context, struct hatch_arena *arena, struct hatch_arena *temporary,
                                    struct hatch_err *error)
{
    struct again *again = context;
    return hatch_coarse_make(&again->part, 1, arena, temporary, &again->out, error);
}

START_TEST(allocations_may_fail)
{
    struct hatch_mesh torus = shape_of(HATCH_SHAPE_TORUS, 200);
    double tolerances[400];
    ck_assert_uint_le(torus.vertex_count, 400);
    for (uint32_t v = 0; v < torus.vertex_count; v++)
        tolerances[v] = 0.01;
    struct again again = {.part = {&torus, tolerances, NULL}};
    hatch_test_fail_alloc(make_again, &again, &again, sizeof again);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("coarse");
    TCase *tests = tcase_create("coarse");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_collapse_costs_squared_distances_from_planes);
    tcase_add_test(tests, a_plane_becomes_two_faces);
    tcase_add_test(tests, a_box_keeps_its_twelve_faces);
    tcase_add_test(tests, a_sphere_follows_the_sagitta);
    tcase_add_test(tests, loosely_a_plane_stays_a_square_without_needles);
    tcase_add_test(tests, loosely_waves_keep_their_height);
    tcase_add_test(tests, loosely_faces_keep_near_the_normals_of_their_corners);
    tcase_add_test(tests, no_removed_point_is_farther_than_its_tolerance);
    tcase_add_test(tests, colours_are_compared_where_they_are_near);
    tcase_add_test(tests, a_point_where_surfaces_touch_stays);
    tcase_add_test(tests, points_of_a_border_stay_on_it);
    tcase_add_test(tests, closed_surfaces_stay_closed);
    tcase_add_test(tests, bent_texture_coordinates_keep_points);
    tcase_add_test(tests, borders_of_parts_stay_closed);
    tcase_add_test(tests, borders_on_flat_sheets_keep_their_course);
    tcase_add_test(tests, scale_and_place_do_not_matter);
    tcase_add_test(tests, faces_without_points_apart_are_left_out);
    tcase_add_test(tests, allocations_may_fail);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
