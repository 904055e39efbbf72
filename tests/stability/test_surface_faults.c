/* Damaged meshes: what a naive reading finds in each, and the surface made of it. */
#include "mesh/edges.h"
#include "meshes.h"
#include "surface_check.h"

/* Returns the sum of all notes but components; a test sets those it has checked to 0. */
static uint32_t other_notes(void)
{
    return notes.welded + notes.degenerate + notes.duplicate + notes.unreferenced + notes.flipped + notes.edges_cut +
           notes.points_split + notes.contrary;
}

static void expect(const struct hatch_surface *s, uint32_t components, int euler, uint32_t loops)
{
    ck_assert_uint_eq(s->component_count, components);
    ck_assert_uint_eq(notes.components, components);
    for (uint32_t c = 0; c < components; c++) {
        ck_assert_int_eq(s->components[c].euler, euler);
        ck_assert_uint_eq(s->components[c].border_loops, loops);
    }
}

/* The edges that a naive reading finds: vertices are points, faces stay as they are. */
struct naive {
    uint32_t borders;      /* edges with one face */
    uint32_t agreeing;     /* with two faces of consistent orientation */
    uint32_t contrary;     /* with two others */
    uint32_t non_manifold; /* with more */
};

static struct naive read_naively(const struct hatch_mesh *mesh)
{
    struct hatch_edges edges;
    struct naive seen = {0};
    const struct hatch_connectivity connectivity = {mesh->indices, mesh->face_count, mesh->vertex_count, NULL};
    HATCH_TEST_OK(hatch_edges_find(&connectivity, &keep, &scratch, &edges, &err), &err);
    for (uint32_t e = 0; e < edges.count; e++) {
        const uint32_t *sides = &edges.sides[edges.first[e]];
        uint32_t faces = edges.first[e + 1] - edges.first[e];
        bool same_way = faces == 2 && mesh->indices[sides[0]] == mesh->indices[sides[1]];
        seen.borders += faces == 1;
        seen.agreeing += faces == 2 && !same_way;
        seen.contrary += faces == 2 && same_way;
        seen.non_manifold += faces > 2;
    }
    return seen;
}

static struct hatch_mesh sphere(uint32_t faces)
{
    struct hatch_mesh mesh = bare_shape(HATCH_SHAPE_SPHERE, faces);
    struct hatch_mesh welded = mesh;
    uint32_t *point = HATCH_NEW(&keep, uint32_t, mesh.vertex_count, &err);
    HATCH_TEST_OK(hatch_mesh_weld(&mesh, &keep, point, &welded.vertex_count, &err), &err);
    for (uint32_t v = 0; v < mesh.vertex_count; v++) /* no vertex moves up */
        memmove(&mesh.attributes[0].data[3 * point[v]], &mesh.attributes[0].data[3 * v], 12);
    hatch_mesh_corner_points(&mesh, point, welded.indices);
    return welded;
}

static void add_face(struct hatch_mesh *mesh, uint32_t a, uint32_t b, uint32_t c)
{
    uint32_t *indices = HATCH_NEW(&keep, uint32_t, 3 * (mesh->face_count + 1), &err);
    const uint32_t face[3] = {a, b, c};
    memcpy(indices, mesh->indices, mesh->face_count * 12);
    memcpy(&indices[3 * mesh->face_count], face, sizeof face);
    mesh->indices = indices;
    mesh->face_count++;
}

START_TEST(faces_without_area_are_left_out)
{
    struct hatch_mesh mesh = sphere(300), spare = sphere(4), dirty = both(&mesh, &spare);
    uint32_t *f = dirty.indices, last = dirty.vertex_count - 1;
    dirty.face_count = mesh.face_count;
    add_face(&dirty, f[0], f[0], f[1]);
    add_face(&dirty, f[1], f[1], f[1]);
    add_face(&dirty, f[1], last, f[1]);
    ck_assert_uint_gt(read_naively(&dirty).non_manifold, 0);
    struct hatch_surface want = surface_of(&mesh), s = surface_of(&dirty);
    ck_assert_uint_eq(notes.degenerate, 3);
    ck_assert_uint_eq(notes.unreferenced, spare.vertex_count);
    ck_assert_uint_eq(notes.welded, 0);
    expect(&s, 1, 2, 0);
    ck_assert_mem_eq(s.points, want.points, want.point_count * 24);
    ck_assert_mem_eq(s.corners, want.corners, want.face_count * 12);
}
END_TEST

/* A square of four faces, one of which has its three corners on a line. */
START_TEST(a_face_with_corners_on_a_line_leaves_a_slit)
{
    const float positions[] = {0, 0, 0, 2, 0, 0, 1, 0, 0, 1, 1, 0, 1, -1, 0};
    const uint32_t faces[] = {0, 1, 3, 0, 2, 1, 0, 4, 2, 2, 4, 1};
    struct hatch_mesh mesh = mesh_of(positions, 5, faces, 4);
    struct hatch_surface s = surface_of(&mesh);
    ck_assert_uint_eq(notes.degenerate, 1);
    ck_assert_uint_eq(s.face_count, 3);
    expect(&s, 2, 1, 1);
}
END_TEST

/* A strip of faces a millionth as high as long. */
START_TEST(slivers_are_kept)
{
    enum { COUNT = 50 };
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 2 * COUNT, 2 * COUNT - 2, &mesh, &err), &err);
    for (uint32_t i = 0; i < COUNT; i++) {
        float *p = &mesh.attributes[0].data[6 * i];
        p[1] = p[4] = 1e-6f * (float)i;
        p[3] = 1;
    }
    for (uint32_t i = 0; i + 1 < COUNT; i++) {
        const uint32_t faces[6] = {2 * i, 2 * i + 1, 2 * i + 2, 2 * i + 1, 2 * i + 3, 2 * i + 2};
        memcpy(&mesh.indices[6 * i], faces, sizeof faces);
    }
    struct hatch_surface s = surface_of(&mesh);
    ck_assert_uint_eq(s.face_count, 2 * COUNT - 2);
    ck_assert_uint_eq(other_notes(), 0);
    expect(&s, 1, 1, 1);
}
END_TEST

START_TEST(unwelded_triangles_are_one_surface)
{
    struct hatch_mesh mesh = sphere(500), loose = soup(&mesh);
    ck_assert_uint_eq(read_naively(&loose).borders, 3 * loose.face_count);
    uint32_t points = surface_of(&mesh).point_count;
    struct hatch_surface s = surface_of(&loose);
    expect(&s, 1, 2, 0);
    ck_assert_uint_eq(s.point_count, points);
    ck_assert_uint_eq(notes.welded, 3 * loose.face_count - points);
}
END_TEST

/* Five faces at one edge: two pairs and a single one. */
START_TEST(faces_at_an_edge_are_joined_in_pairs)
{
    float positions[21] = {0, 0, 0, 0, 0, 1};
    uint32_t faces[15];
    for (uint32_t i = 0; i < 5; i++) {
        double angle = 1.2566370614 * i;
        float *p = &positions[6 + 3 * i];
        p[0] = (float)cos(angle);
        p[1] = (float)sin(angle);
        const uint32_t face[3] = {i % 2, 1 - i % 2, 2 + i};
        memcpy(&faces[3 * i], face, sizeof face);
    }
    struct hatch_mesh mesh = mesh_of(positions, 7, faces, 5);
    ck_assert_uint_eq(read_naively(&mesh).non_manifold, 1);
    struct hatch_surface s = surface_of(&mesh);
    ck_assert_uint_eq(notes.edges_cut, 1);
    ck_assert_uint_eq(other_notes(), 1);
    expect(&s, 3, 1, 1);
    ck_assert_uint_eq(s.point_count, 4 + 4 + 3);
}
END_TEST

START_TEST(solids_that_share_an_edge_are_separated)
{
    struct hatch_mesh a = cube(0, 1), b = cube(0, 1);
    for (uint32_t i = 0; i < 8; i++) {
        b.attributes[0].data[3 * i]++;
        b.attributes[0].data[3 * i + 1]++;
    }
    struct hatch_mesh mesh = both(&a, &b), good = both(&a, &b);
    struct hatch_surface want = surface_of(&good);
    for (uint32_t step = 1; step < 6; step++) { /* none flipped, then every second face, every third, ... */
        struct hatch_surface s = surface_of(&mesh);
        ck_assert_uint_eq(notes.edges_cut, 1);
        ck_assert_uint_eq(notes.points_split, 0);
        expect(&s, 2, 2, 0);
        ck_assert_uint_eq(s.point_count, 16);
        ck_assert_mem_eq(s.corners, want.corners, want.face_count * 12);
        mesh = both(&good, &good);
        mesh.face_count = good.face_count;
        for (uint32_t f = 0; f < mesh.face_count; f += step + 1)
            turn(&mesh, f);
    }
}
END_TEST

/* Of three faces at an edge the two coplanar ones are joined, in any order. */
START_TEST(coplanar_faces_at_an_edge_are_joined)
{
    const float positions[] = {0, 0, 0, 0, 1, 0, -1, 0, 0, 1, 0, 0, 0, 0, 1};
    const uint32_t pages[3][3] = {{0, 1, 2}, {1, 0, 3}, {1, 0, 4}};
    for (uint32_t first = 0; first < 3; first++) {
        uint32_t faces[9];
        for (uint32_t i = 0; i < 3; i++)
            memcpy(&faces[3 * i], pages[(first + i) % 3], 12);
        struct hatch_mesh mesh = mesh_of(positions, 5, faces, 3);
        struct hatch_surface s = surface_of(&mesh);
        expect(&s, 2, 1, 1);
        for (uint32_t f = 0; f < 3; f++) {
            bool leaf = (first + s.face_source[f]) % 3 == 2;
            ck_assert_uint_eq(s.components[s.point_component[s.corners[3 * f]]].face_count, leaf ? 1 : 2);
        }
    }
}
END_TEST

/* One edge with many faces, one point with many: time must not be quadratic. */
START_TEST(many_faces_at_an_edge_or_a_point_take_linear_time)
{
    enum { COUNT = 100000 };
    struct hatch_mesh pages, slices = fan(COUNT);
    HATCH_TEST_OK(hatch_mesh_make(&keep, COUNT + 2, COUNT, &pages, &err), &err);
    pages.attributes[0].data[5] = 1;
    for (uint32_t i = 0; i < COUNT; i++) {
        const uint32_t page[3] = {i % 2, 1 - i % 2, 2 + i};
        memcpy(&pages.attributes[0].data[6 + 3 * i], &slices.attributes[0].data[3 * i], 12);
        memcpy(&pages.indices[3 * i], page, sizeof page);
    }
    struct hatch_surface s;
    HATCH_TEST_OK(hatch_surface_make(&pages, &keep, &scratch, &s, &notes, &err), &err);
    expect(&s, COUNT, 1, 1);
    HATCH_TEST_OK(hatch_surface_make(&slices, &keep, &scratch, &s, &notes, &err), &err);
    expect(&s, 1, 1, 1);
    ck_assert_uint_eq(s.ring_first[s.corners[2] + 1] - s.ring_first[s.corners[2]], COUNT);
}
END_TEST

START_TEST(solids_that_share_a_point_are_separated)
{
    struct hatch_mesh a = cube(0, 1), b = cube(0, 1);
    for (uint32_t i = 0; i < 24; i++)
        b.attributes[0].data[i]++;
    struct hatch_mesh mesh = both(&a, &b);
    struct hatch_surface s = surface_of(&mesh);
    ck_assert_uint_eq(notes.points_split, 1);
    expect(&s, 2, 2, 0);
    ck_assert_uint_eq(s.point_count, 16);
}
END_TEST

START_TEST(mixed_orientation_is_made_consistent)
{
    struct hatch_mesh mesh = sphere(400), good = sphere(400);
    for (uint32_t f = 0; f < mesh.face_count; f += 2)
        turn(&mesh, f);
    ck_assert_uint_gt(read_naively(&mesh).contrary, 100);
    struct hatch_surface want = surface_of(&good), s = surface_of(&mesh);
    ck_assert_uint_eq(notes.flipped, (mesh.face_count + 1) / 2);
    ck_assert_uint_eq(notes.contrary, 0);
    ck_assert_mem_eq(s.corners, want.corners, want.face_count * 12);
    ck_assert_mem_eq(s.opposite, want.opposite, want.face_count * 12);
}
END_TEST

START_TEST(one_sided_surfaces_are_not_cut)
{
    struct hatch_mesh strip = band(30, 1, true), bottle = klein(20, 10);
    for (uint32_t f = 0; f < 30; f += 3) {
        turn(&strip, f);
        turn(&bottle, 5 * f);
    }
    struct hatch_surface s = surface_of(&strip);
    expect(&s, 1, 0, 1);
    ck_assert(!s.components[0].orientable);
    ck_assert_uint_gt(notes.contrary, 0);
    ck_assert_uint_le(notes.contrary, read_naively(&strip).contrary);
    s = surface_of(&bottle);
    expect(&s, 1, 0, 0);
    ck_assert(!s.components[0].orientable);
    ck_assert_uint_gt(notes.contrary, 0);
    ck_assert_uint_le(notes.contrary, read_naively(&bottle).contrary);
}
END_TEST

START_TEST(duplicate_faces_are_left_out)
{
    struct hatch_mesh mesh = sphere(300), dirty = sphere(300);
    for (uint32_t f = 0; f < 50; f++) {
        const uint32_t *c = &mesh.indices[3 * f];
        add_face(&dirty, c[f % 3], c[(f + 1 + f % 2) % 3], c[(f + 2 - f % 2) % 3]);
    }
    ck_assert_uint_gt(read_naively(&dirty).non_manifold, 50);
    struct hatch_surface want = surface_of(&mesh), s = surface_of(&dirty);
    ck_assert_uint_eq(notes.duplicate, 50);
    ck_assert_uint_eq(notes.reversed, 25);
    notes.duplicate = 0;
    ck_assert_uint_eq(other_notes(), 0);
    ck_assert_mem_eq(s.corners, want.corners, want.face_count * 12);
}
END_TEST

START_TEST(unused_vertices_do_not_affect_the_center)
{
    struct hatch_mesh mesh = sphere(300), stray = sphere(4), far;
    struct hatch_surface want = surface_of(&mesh);
    move(&stray, 1, 1e6f);
    far = both(&mesh, &stray);
    far.face_count = mesh.face_count;
    struct hatch_surface s = surface_of(&far);
    ck_assert_uint_eq(notes.unreferenced, stray.vertex_count);
    ck_assert_mem_eq(s.points, want.points, want.point_count * 24);
    ck_assert_mem_eq(&s.components[0], &want.components[0], sizeof want.components[0]);
}
END_TEST

START_TEST(one_triangle_is_a_surface)
{
    const float positions[] = {10, 0, 0, 14, 0, 0, 10, 3, 0};
    const uint32_t face[] = {0, 1, 2}, want[] = {1, 2, 2, 0, 0, 1};
    struct hatch_mesh mesh = mesh_of(positions, 3, face, 1);
    struct hatch_surface s = surface_of(&mesh);
    expect(&s, 1, 1, 1);
    ck_assert_double_eq_tol(s.components[0].scale, 4, 1e-15);
    ck_assert_double_eq(s.components[0].center[0], 12);
    ck_assert_double_eq_tol(s.points[4], -0.375, 1e-15);
    ck_assert_mem_eq(s.ring_point, want, sizeof want);
    for (uint32_t i = 0; i < 6; i++)
        ck_assert_uint_eq(s.ring_face[i], i % 2 ? HATCH_NO_SIDE : 0);
}
END_TEST

START_TEST(a_strip_one_face_wide_is_all_border)
{
    struct hatch_mesh mesh = band(20, 1, false);
    mesh.face_count -= 2;
    struct hatch_surface s = surface_of(&mesh);
    expect(&s, 1, 1, 1);
    for (uint32_t p = 0; p < s.point_count; p++)
        ck_assert_uint_eq(s.ring_face[s.ring_first[p + 1] - 1], HATCH_NO_SIDE);
}
END_TEST

/* Separate triangles of very different sizes, far apart. */
START_TEST(components_are_scaled_separately)
{
    enum { COUNT = 10000 };
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 3 * COUNT, COUNT, &mesh, &err), &err);
    for (uint32_t i = 0; i < 3 * COUNT; i++) {
        float *p = &mesh.attributes[0].data[3 * i], size = i / 3 % 2 ? 64 : 1.0f / 64;
        p[0] = (i % 3 == 1 ? size : 0) + (float)(i / 3 % 100) * 100;
        p[1] = (i % 3 == 2 ? size : 0) + (float)(i / 300) * 100;
        mesh.indices[i] = i;
    }
    struct hatch_surface s = surface_of(&mesh);
    expect(&s, COUNT, 1, 1);
    for (uint32_t p = 3; p < s.point_count; p++)
        for (uint32_t k = 0; k < 3; k++)
            ck_assert_double_eq_tol(s.points[3 * p + k], s.points[3 * (p % 3) + k], 1e-12);
}
END_TEST

START_TEST(invalid_meshes_are_refused)
{
    static const struct {
        float x;
        uint32_t index;
        const char *says;
    } bad[] = {{NAN, 2, "vertex 1: position is not finite"},
               {INFINITY, 2, "vertex 1: position is not finite"},
               {1, 3, "face 0: vertex index 3, want one below 3"},
               {0, 2, "no face has an area"},
               {1, 0, "no face has an area"}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        const float positions[] = {0, 0, 0, bad[i].x, 0, 0, 0, 1, 0};
        const uint32_t face[] = {0, 1, bad[i].index};
        struct hatch_mesh mesh = mesh_of(positions, 3, face, 1);
        struct hatch_surface surface = {.face_count = 7};
        notes.components = 7;
        ck_assert_int_eq(hatch_surface_make(&mesh, &keep, &scratch, &surface, &notes, &err), HATCH_BAD_INPUT);
        ck_assert_str_eq(err.text, bad[i].says);
        ck_assert_uint_eq(surface.face_count, 7);
        ck_assert_uint_eq(notes.components, 7);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("surface faults");
    TCase *tests = tcase_create("faults");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, faces_without_area_are_left_out);
    tcase_add_test(tests, a_face_with_corners_on_a_line_leaves_a_slit);
    tcase_add_test(tests, slivers_are_kept);
    tcase_add_test(tests, unwelded_triangles_are_one_surface);
    tcase_add_test(tests, faces_at_an_edge_are_joined_in_pairs);
    tcase_add_test(tests, solids_that_share_an_edge_are_separated);
    tcase_add_test(tests, coplanar_faces_at_an_edge_are_joined);
    tcase_add_test(tests, many_faces_at_an_edge_or_a_point_take_linear_time);
    tcase_add_test(tests, solids_that_share_a_point_are_separated);
    tcase_add_test(tests, mixed_orientation_is_made_consistent);
    tcase_add_test(tests, one_sided_surfaces_are_not_cut);
    tcase_add_test(tests, duplicate_faces_are_left_out);
    tcase_add_test(tests, unused_vertices_do_not_affect_the_center);
    tcase_add_test(tests, one_triangle_is_a_surface);
    tcase_add_test(tests, a_strip_one_face_wide_is_all_border);
    tcase_add_test(tests, components_are_scaled_separately);
    tcase_add_test(tests, invalid_meshes_are_refused);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
