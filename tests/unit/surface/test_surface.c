#include "base/random.h"
#include "fail_alloc.h"
#include "measure/mesh_figures.h"
#include "meshes.h"
#include "surface_check.h"

static void expect(const struct hatch_component *part, int euler, uint32_t loops, bool orientable)
{
    ck_assert_int_eq(part->euler, euler);
    ck_assert_uint_eq(part->border_loops, loops);
    ck_assert(part->orientable == orientable);
}

START_TEST(shapes_have_their_euler_characteristic)
{
    static const struct {
        enum hatch_shape kind;
        int euler;
        uint32_t loops;
    } want[] = {{HATCH_SHAPE_SPHERE, 2, 0},   {HATCH_SHAPE_ELLIPSOID, 2, 0}, {HATCH_SHAPE_TORUS, 0, 0},
                {HATCH_SHAPE_CYLINDER, 0, 2}, {HATCH_SHAPE_CONE, 1, 1},      {HATCH_SHAPE_PLANE, 1, 1}};
    const struct hatch_surface_notes nothing = {.components = 1};
    for (size_t i = 0; i < sizeof want / sizeof *want; i++) {
        struct hatch_mesh mesh = bare_shape(want[i].kind, 1000);
        struct hatch_surface s = surface_of(&mesh);
        ck_assert_uint_eq(s.component_count, 1);
        expect(&s.components[0], want[i].euler, want[i].loops, true);
        ck_assert_uint_eq(s.face_count, mesh.face_count);
        notes.welded = 0;
        ck_assert_mem_eq(&notes, &nothing, sizeof notes);
    }
}
END_TEST

static bool turned_between(const struct hatch_surface *s, uint32_t p, uint32_t q)
{
    for (uint32_t i = s->ring_first[p]; i < s->ring_first[p + 1]; i++)
        if (s->ring_point[i] == q)
            return s->ring_turned[i];
    ck_abort_msg("%u is no neighbour of %u", q, p);
}

/* Returns the only point of a vertex. */
static uint32_t point_of(const struct hatch_surface *s, uint32_t vertex)
{
    for (uint32_t i = 0; i < 3 * s->face_count; i++)
        if (s->corner_vertex[i] == vertex)
            return s->corners[i];
    ck_abort_msg("vertex %u has no point", vertex);
}

/* The number of sides of a face with ring_turned is even. */
static void check_faces_turn_evenly(const struct hatch_surface *s)
{
    for (uint32_t f = 0; f < s->face_count; f++) {
        const uint32_t *p = &s->corners[3 * f];
        ck_assert(!(turned_between(s, p[0], p[1]) ^ turned_between(s, p[1], p[2]) ^ turned_between(s, p[2], p[0])));
    }
}

START_TEST(a_moebius_strip_turns_once)
{
    const uint32_t n = 24;
    for (int twisted = 0; twisted < 2; twisted++) {
        struct hatch_mesh mesh = band(n, 1, twisted);
        struct hatch_surface s = surface_of(&mesh);
        expect(&s.components[0], 0, twisted ? 1 : 2, !twisted);
        ck_assert_uint_eq(notes.contrary, twisted ? 1 : 0);
        check_faces_turn_evenly(&s);
        bool over = false;
        for (uint32_t i = 0; i + 1 < n; i++)
            over ^= turned_between(&s, point_of(&s, 2 * i), point_of(&s, 2 * i + 2));
        if (twisted)
            over ^= turned_between(&s, point_of(&s, 2 * n - 2), point_of(&s, 1)) ^
                    turned_between(&s, point_of(&s, 1), point_of(&s, 0));
        else
            over ^= turned_between(&s, point_of(&s, 2 * n - 2), point_of(&s, 0));
        ck_assert(over == twisted);
    }
}
END_TEST

START_TEST(a_klein_bottle_is_closed_and_one_sided)
{
    const uint32_t m = 20, n = 12;
    struct hatch_mesh mesh = klein(m, n);
    struct hatch_surface s = surface_of(&mesh);
    ck_assert_uint_eq(s.component_count, 1);
    ck_assert_uint_eq(s.point_count, m * n);
    expect(&s.components[0], 0, 0, false);
    ck_assert_uint_eq(notes.contrary, n);
    ck_assert_uint_eq(notes.flipped, 0);
    check_faces_turn_evenly(&s);
    bool along = false, around = false;
    for (uint32_t i = 0; i < m; i++) /* row 0 comes back as row n - 1, its neighbour */
        along ^= turned_between(&s, point_of(&s, i * n), point_of(&s, i + 1 < m ? (i + 1) * n : n - 1));
    along ^= turned_between(&s, point_of(&s, n - 1), point_of(&s, 0));
    for (uint32_t j = 0; j < n; j++)
        around ^= turned_between(&s, point_of(&s, j), point_of(&s, (j + 1) % n));
    ck_assert(along && !around);
}
END_TEST

/* The angles around a ring, seen from outside, sum to 2π; to π on a straight border, to π/2 at a corner of it. */
START_TEST(rings_run_counter_clockwise_seen_from_outside)
{
    static const enum hatch_shape kinds[] = {HATCH_SHAPE_SPHERE, HATCH_SHAPE_PLANE};
    for (int i = 0; i < 2; i++) {
        struct hatch_mesh mesh = bare_shape(kinds[i], 600);
        struct hatch_surface s = surface_of(&mesh);
        uint32_t half = 0;
        for (uint32_t p = 0; p < s.point_count; p++) {
            double out[3] = {0, 0, 1}, turn = 0, a[3], b[3], cross[3];
            const double *at = &s.points[3 * p];
            if (kinds[i] == HATCH_SHAPE_SPHERE)
                hatch_vec_copy(at, out);
            hatch_vec_normalize(out);
            for (uint32_t k = s.ring_first[p]; k < s.ring_first[p + 1]; k++) {
                if (s.ring_face[k] == HATCH_NO_SIDE)
                    continue;
                uint32_t next = k + 1 < s.ring_first[p + 1] ? k + 1 : s.ring_first[p];
                hatch_vec_sub(&s.points[3 * s.ring_point[k]], at, a);
                hatch_vec_sub(&s.points[3 * s.ring_point[next]], at, b);
                hatch_vec_add_scaled(a, -hatch_vec_dot(a, out), out, a);
                hatch_vec_add_scaled(b, -hatch_vec_dot(b, out), out, b);
                hatch_vec_cross(a, b, cross);
                turn += atan2(hatch_vec_dot(cross, out), hatch_vec_dot(a, b)) / 3.14159265358979;
            }
            if (kinds[i] == HATCH_SHAPE_SPHERE)
                ck_assert_double_eq_tol(turn, 2, 1e-9);
            ck_assert(fabs(turn - 2) < 1e-9 || fabs(turn - 1) < 1e-9 || fabs(turn - 0.5) < 1e-9);
            half += fabs(turn - 1) < 1e-9;
        }
        ck_assert((half > 0) == (kinds[i] == HATCH_SHAPE_PLANE));
    }
}
END_TEST

START_TEST(components_do_not_affect_each_other)
{
    struct hatch_mesh parts[4] = {bare_shape(HATCH_SHAPE_TORUS, 500), band(30, 1, true),
                                  bare_shape(HATCH_SHAPE_CYLINDER, 300), klein(16, 10)};
    struct hatch_mesh all = parts[0];
    for (int i = 1; i < 4; i++) {
        move(&parts[i], (float)i, 100 * (float)i);
        all = both(&all, &parts[i]);
    }
    struct hatch_surface s = surface_of(&all), one;
    ck_assert_uint_eq(s.component_count, 4);
    struct hatch_mesh_figures figures;
    HATCH_TEST_OK(hatch_measure_mesh(&all, &scratch, &figures, &err), &err);
    int euler = 0;
    uint32_t loops = 0;
    for (uint32_t i = 0; i < 4; i++) {
        one = surface_of(&parts[i]);
        const struct hatch_component *a = &s.components[i], *b = &one.components[0];
        expect(a, b->euler, b->border_loops, b->orientable);
        ck_assert_uint_eq(a->face_count, b->face_count);
        ck_assert_mem_eq(&a->scale, &b->scale, sizeof a->scale);
        ck_assert_mem_eq(a->center, b->center, sizeof a->center);
        ck_assert_mem_eq(&s.points[3 * a->first_point], one.points, one.point_count * 24);
        euler += a->euler;
        loops += a->border_loops;
    }
    ck_assert_int_eq(euler, figures.euler);
    ck_assert_uint_eq(loops, figures.boundary_loops);
    ck_assert_uint_eq(s.point_count, figures.points);
}
END_TEST

/* A one-sided component, closed and open ones, unwelded and flipped faces, superfluous faces and vertices. */
static struct hatch_mesh mixture(void)
{
    struct hatch_mesh ball = bare_shape(HATCH_SHAPE_SPHERE, 400), strip = band(20, 1, true);
    struct hatch_mesh box = cube(0, 1), loose = soup(&ball), twice = both(&box, &box);
    for (uint32_t f = 0; f < ball.face_count; f += 3)
        turn(&ball, f);
    move(&loose, 0.5f, 4);
    move(&strip, 2, 12);
    move(&twice, 1, -5);
    struct hatch_mesh all = both(&ball, &loose);
    all = both(&all, &strip);
    all = both(&all, &twice);
    all.indices[3] = all.indices[4];
    return all;
}

static void shuffle(uint32_t *list, uint32_t count, uint64_t stream)
{
    for (uint32_t i = 0; i < count; i++)
        list[i] = i;
    for (uint32_t i = count; i-- > 1;) {
        uint32_t k = (uint32_t)(hatch_random_u64(7, stream, i) % (i + 1)), swap = list[i];
        list[i] = list[k];
        list[k] = swap;
    }
}

/* Checks that corners, sides, rings and points of two surfaces are the same up to numbering.
 *   to_face  per face of a its face in b */
static void check_same(const struct hatch_surface *a, const struct hatch_surface *b, const uint32_t *to_face,
                       double tolerance)
{
    ck_assert_uint_eq(a->face_count, b->face_count);
    ck_assert_uint_eq(a->point_count, b->point_count);
    ck_assert_uint_eq(a->component_count, b->component_count);
    uint32_t *to = HATCH_NEW(&keep, uint32_t, a->point_count, &err);
    memset(to, 0xff, a->point_count * sizeof *to);
    for (uint32_t i = 0; i < 3 * a->face_count; i++) {
        uint32_t other = 3 * to_face[i / 3] + i % 3, far = a->opposite[i];
        uint32_t want = far == HATCH_NO_SIDE ? far : 3 * to_face[far / 3] + far % 3;
        ck_assert_uint_eq(b->opposite[other], want);
        ck_assert(to[a->corners[i]] == HATCH_NO_SIDE || to[a->corners[i]] == b->corners[other]);
        to[a->corners[i]] = b->corners[other];
    }
    for (uint32_t p = 0; p < a->point_count; p++) {
        ck_assert_double_le(hatch_vec_distance(&a->points[3 * p], &b->points[3 * to[p]]), tolerance);
        ck_assert_uint_eq(a->ring_first[p + 1] - a->ring_first[p], b->ring_first[to[p] + 1] - b->ring_first[to[p]]);
        const struct hatch_component *part = &b->components[b->point_component[to[p]]];
        expect(&a->components[a->point_component[p]], part->euler, part->border_loops, part->orientable);
    }
}

START_TEST(the_order_of_faces_and_vertices_does_not_matter)
{
    struct hatch_mesh mesh = mixture(), mixed = both(&mesh, &mesh);
    uint32_t *face = HATCH_NEW(&keep, uint32_t, mesh.face_count, &err);
    uint32_t *vertex = HATCH_NEW(&keep, uint32_t, mesh.vertex_count, &err);
    uint32_t *from = HATCH_NEW(&keep, uint32_t, mesh.face_count, &err);
    uint32_t *to = HATCH_NEW(&keep, uint32_t, mesh.face_count, &err);
    struct hatch_surface s = surface_of(&mesh);
    struct hatch_surface_notes first = notes;
    shuffle(face, mesh.face_count, 1);
    shuffle(vertex, mesh.vertex_count, 2);
    mixed.face_count = mesh.face_count;
    mixed.vertex_count = mesh.vertex_count;
    for (uint32_t i = 0; i < 3 * mesh.face_count; i++)
        mixed.indices[3 * face[i / 3] + i % 3] = vertex[mesh.indices[i]];
    for (uint32_t v = 0; v < mesh.vertex_count; v++)
        memcpy(&mixed.attributes[0].data[3 * vertex[v]], &mesh.attributes[0].data[3 * v], 12);
    struct hatch_surface t = surface_of(&mixed);
    /* Either of two duplicate faces may remain, and with it its vertices. */
    ck_assert_uint_eq(notes.welded + notes.unreferenced, first.welded + first.unreferenced);
    notes.welded = first.welded;
    notes.unreferenced = first.unreferenced;
    ck_assert_mem_eq(&notes, &first, sizeof notes);
    memset(from, 0xff, mesh.face_count * sizeof *from);
    for (uint32_t f = 0; f < t.face_count; f++)
        from[t.face_source[f]] = f;
    for (uint32_t f = 0; f < s.face_count; f++) {
        uint32_t source = s.face_source[f], twin = source < mesh.face_count - 12 ? source + 12 : source - 12;
        to[f] = from[face[source]] != UINT32_MAX ? from[face[source]] : from[face[twin]];
        ck_assert_uint_lt(to[f], t.face_count);
    }
    check_same(&s, &t, to, 1e-12);
}
END_TEST

static void check_same_order(const struct hatch_surface *a, const struct hatch_surface *b, double tolerance)
{
    uint32_t *same = HATCH_NEW(&keep, uint32_t, a->face_count, &err);
    for (uint32_t f = 0; f < a->face_count; f++)
        same[f] = f;
    check_same(a, b, same, tolerance);
    ck_assert_mem_eq(a->corners, b->corners, a->face_count * 12);
    ck_assert_mem_eq(a->ring_point, b->ring_point, a->ring_first[a->point_count] * 4);
    ck_assert_mem_eq(a->ring_turned, b->ring_turned, a->ring_first[a->point_count]);
}

START_TEST(scale_does_not_matter)
{
    struct hatch_mesh mesh = mixture();
    struct hatch_surface s = surface_of(&mesh);
    static const float scales[] = {1e-20f, 1e20f, 1e-3f, 1e-30f, 1e30f};
    for (int i = 0; i < 5; i++) {
        struct hatch_mesh scaled = mixture();
        move(&scaled, scales[i], 0);
        struct hatch_surface t = surface_of(&scaled);
        check_same_order(&s, &t, 1e-4);
        double ratio = t.components[0].scale / s.components[0].scale;
        ck_assert_double_eq_tol(ratio / (double)scales[i], 1, 1e-6);
    }
}
END_TEST

START_TEST(a_large_offset_does_not_matter)
{
    struct hatch_mesh mesh = bare_shape(HATCH_SHAPE_SPHERE, 2000), far;
    float *p = mesh.attributes[0].data;
    for (uint32_t i = 0; i < 3 * mesh.vertex_count; i++)
        p[i] = roundf(p[i] * 8000) / 8; /* floats at 10⁶ are 1/16 apart */
    for (uint32_t f = 0; f < mesh.face_count; f += 2)
        turn(&mesh, f);
    struct hatch_surface s = surface_of(&mesh);
    far = both(&mesh, &mesh);
    far.vertex_count /= 2;
    far.face_count /= 2;
    move(&far, 1, 1e6f);
    struct hatch_surface t = surface_of(&far);
    check_same_order(&s, &t, 1e-10);
    ck_assert_double_eq_tol(t.components[0].center[0] - s.components[0].center[0], 1e6, 1e-9);
}
END_TEST

START_TEST(a_clean_mesh_is_returned_unchanged)
{
    struct hatch_mesh mesh = bare_shape(HATCH_SHAPE_TORUS, 800), back;
    uint32_t *point;
    mesh.attribute_count = 4; /* with normals, tangents and texture coordinates */
    struct hatch_surface s = surface_of(&mesh);
    HATCH_TEST_OK(hatch_surface_to_mesh(&s, &mesh, &keep, &scratch, &back, &point, &err), &err);
    ck_assert_uint_eq(back.vertex_count, mesh.vertex_count);
    ck_assert_uint_eq(back.attribute_count, 4);
    ck_assert_mem_eq(back.indices, mesh.indices, mesh.face_count * 12);
    for (uint32_t i = 0; i < 4; i++) {
        const struct hatch_mesh_attribute *a = &mesh.attributes[i], *b = &back.attributes[i];
        ck_assert_str_eq(a->name, b->name);
        ck_assert_mem_eq(a->data, b->data, mesh.vertex_count * a->components * 4);
    }
    for (uint32_t i = 0; i < 3 * mesh.face_count; i++)
        ck_assert_uint_eq(point[back.indices[i]], s.corners[i]);
}
END_TEST

START_TEST(a_vertex_of_two_points_is_duplicated)
{
    /* Two triangles that share vertex 2; vertex 3 is unused; the second face is flipped. */
    const float positions[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 9, 9, 9, 2, 1, 0, 2, 2, 0};
    const uint32_t faces[] = {0, 1, 2, 2, 4, 5};
    struct hatch_mesh mesh = mesh_of(positions, 6, faces, 2), back;
    float *uv;
    uint32_t *point;
    HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, "TEXCOORD_0", 2, &uv, &err), &err);
    for (int i = 0; i < 12; i++)
        uv[i] = (float)i;
    struct hatch_surface s = surface_of(&mesh);
    ck_assert_uint_eq(notes.points_split, 1);
    ck_assert_uint_eq(s.component_count, 2);
    HATCH_TEST_OK(hatch_surface_to_mesh(&s, &mesh, &keep, &scratch, &back, &point, &err), &err);
    const uint32_t want[] = {0, 1, 2, 5, 3, 4};
    const float want_uv[] = {0, 1, 2, 3, 4, 5, 8, 9, 10, 11, 4, 5};
    ck_assert_uint_eq(back.vertex_count, 6);
    ck_assert_mem_eq(back.indices, want, sizeof want);
    ck_assert_mem_eq(hatch_mesh_find(&back, "TEXCOORD_0", 2), want_uv, sizeof want_uv);
    for (int i = 0; i < 6; i++)
        ck_assert_uint_eq(point[want[i]], s.corners[i]);
}
END_TEST

START_TEST(normals_flip_when_all_their_faces_do)
{
    /* A strip of three faces; the last is flipped, and only it uses vertex 4. */
    const float positions[] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 2, 0, 0};
    const uint32_t faces[] = {0, 2, 1, 1, 2, 3, 2, 3, 4};
    struct hatch_mesh mesh = mesh_of(positions, 5, faces, 3), back;
    float *normal, *tangent, *moves; /* of two morph targets */
    uint32_t *point;
    HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, "NORMAL", 3, &normal, &err), &err);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, "TANGENT", 4, &tangent, &err), &err);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, HATCH_MORPH_NORMAL, 6, &moves, &err), &err);
    for (int v = 0; v < 5; v++)
        normal[3 * v + 2] = tangent[4 * v] = tangent[4 * v + 3] = moves[6 * v + 1] = moves[6 * v + 5] = 1;
    struct hatch_surface s = surface_of(&mesh);
    ck_assert_uint_eq(notes.flipped, 1);
    HATCH_TEST_OK(hatch_surface_to_mesh(&s, &mesh, &keep, &scratch, &back, &point, &err), &err);
    const uint32_t want[] = {2, 4, 3};
    ck_assert_mem_eq(&back.indices[6], want, sizeof want);
    normal = hatch_mesh_find(&back, "NORMAL", 3);
    tangent = hatch_mesh_find(&back, "TANGENT", 4);
    moves = hatch_mesh_find(&back, HATCH_MORPH_NORMAL, 6);
    for (int v = 0; v < 5; v++) {
        ck_assert_float_eq(moves[6 * v + 1], v == 4 ? -1 : 1);
        ck_assert_float_eq(moves[6 * v + 5], v == 4 ? -1 : 1);
        ck_assert_float_eq(normal[3 * v + 2], v == 4 ? -1 : 1);
        ck_assert_float_eq(tangent[4 * v], 1);
        ck_assert_float_eq(tangent[4 * v + 3], v == 4 ? -1 : 1);
    }
}
END_TEST

static enum hatch_status make_one(void *context, struct hatch_arena *kept, struct hatch_arena *temporary,
                                  struct hatch_err *error)
{
    struct hatch_surface surface;
    struct hatch_surface_notes noted;
    return hatch_surface_make(context, kept, temporary, &surface, &noted, error);
}

struct source {
    const struct hatch_mesh *mesh;
    const struct hatch_surface *surface;
};

static enum hatch_status mesh_one(void *context, struct hatch_arena *kept, struct hatch_arena *temporary,
                                  struct hatch_err *error)
{
    const struct source *from = context;
    struct hatch_mesh mesh;
    uint32_t *point;
    return hatch_surface_to_mesh(from->surface, from->mesh, kept, temporary, &mesh, &point, error);
}

START_TEST(every_failed_allocation_is_a_limit)
{
    struct hatch_mesh mesh = mixture();
    ck_assert_uint_ge(hatch_test_fail_alloc(make_one, &mesh, NULL, 0), 20);
    struct hatch_surface s = surface_of(&mesh);
    struct source from = {&mesh, &s};
    ck_assert_uint_ge(hatch_test_fail_alloc(mesh_one, &from, NULL, 0), 5);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("surface");
    TCase *tests = tcase_create("surface");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, shapes_have_their_euler_characteristic);
    tcase_add_test(tests, a_moebius_strip_turns_once);
    tcase_add_test(tests, a_klein_bottle_is_closed_and_one_sided);
    tcase_add_test(tests, rings_run_counter_clockwise_seen_from_outside);
    tcase_add_test(tests, components_do_not_affect_each_other);
    tcase_add_test(tests, the_order_of_faces_and_vertices_does_not_matter);
    tcase_add_test(tests, scale_does_not_matter);
    tcase_add_test(tests, a_large_offset_does_not_matter);
    tcase_add_test(tests, a_clean_mesh_is_returned_unchanged);
    tcase_add_test(tests, a_vertex_of_two_points_is_duplicated);
    tcase_add_test(tests, normals_flip_when_all_their_faces_do);
    tcase_add_test(tests, every_failed_allocation_is_a_limit);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
