/* Visible parts of segments against rays that are cast at every triangle, along each segment. */
#include "base/random.h"
#include "lines.h"
#include "occluders.h"

#define SEGMENTS 200u
#define NEAR_PX 0.5 /* the rays' result may change at most this far from a cut */
#define STEP_PX 0.25
#define SAMPLES_MAX 4000u /* of a segment */

/* Segments of a test: their ends, and the faces on which they lie. */
struct segments {
    double points[6 * SEGMENTS];
    uint32_t faces[2 * SEGMENTS];
};

static double unit_random(uint32_t stream, uint32_t index)
{
    return (double)hatch_random_unit(7, stream, index);
}

/* Returns whether a triangle lies between the eye and a point. One that the point itself lies on does not. */
static bool blocks(const double p[3][3], const double eye[3], const double to[3])
{
    double ab[3], ac[3], h[3], s[3], q[3];
    hatch_vec_sub(p[1], p[0], ab);
    hatch_vec_sub(p[2], p[0], ac);
    hatch_vec_cross(to, ac, h);
    double det = hatch_vec_dot(ab, h);
    if (fabs(det) < 1e-18)
        return false;
    hatch_vec_sub(eye, p[0], s);
    double u = hatch_vec_dot(s, h) / det;
    hatch_vec_cross(s, ab, q);
    double v = hatch_vec_dot(to, q) / det, t = hatch_vec_dot(ac, q) / det;
    return u >= 0 && v >= 0 && u + v <= 1 && t > 1e-9 && t < 1 - 1e-7;
}

/* Casts a ray from the eye to a point. */
static bool ray_reaches(const struct hatch_mesh *mesh, const struct hatch_view *view, const double at[3])
{
    double eye[3], to[3], p[3][3];
    hatch_vec_copy(view->eye, eye);
    if (view->orthographic) {
        hatch_vec_sub(at, view->eye, to);
        hatch_vec_add_scaled(at, -hatch_vec_dot(to, view->back), view->back, eye);
    }
    hatch_vec_sub(at, eye, to);
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        for (int c = 0; c < 3; c++)
            hatch_vec_of(&mesh->attributes[0].data[3 * (size_t)mesh->indices[3 * (size_t)f + (size_t)c]], p[c]);
        if (blocks((const double(*)[3])p, eye, to))
            return false;
    }
    return true;
}

/* A point of a segment whose place in the picture is a share of the way between the places of its ends. */
static void point_at(const struct hatch_view *view, const double *ends, double share, double out[3])
{
    double depth[2], t = share, along[3];
    for (int i = 0; i < 2; i++) {
        double from[3];
        hatch_vec_sub(view->eye, ends + 3 * i, from);
        depth[i] = hatch_vec_dot(from, view->back);
    }
    if (!view->orthographic)
        t = share * depth[0] / (share * depth[0] + (1 - share) * depth[1]);
    hatch_vec_sub(ends + 3, ends, along);
    hatch_vec_add_scaled(ends, t, along, out);
}

static void place(const double *point, double at[2])
{
    double projected[3];
    hatch_occluders_project(&hiding, point, projected);
    for (int k = 0; k < 2; k++)
        at[k] = projected[k] / (hiding.view.orthographic ? 1 : projected[2]);
}

/* Returns whether one of a curve's paths contains a point of it. */
static bool contains(const struct hatch_vector_paths *paths, uint32_t id, const double at[2])
{
    for (uint32_t i = 0; i < paths->count; i++) {
        const struct hatch_vector_path *path = &paths->paths[i];
        if (path->id != id)
            continue;
        for (uint32_t k = 0; k + 1 < path->count; k++) {
            const double *a = hatch_vector_point(paths, path, k), *b = hatch_vector_point(paths, path, k + 1);
            double whole = hatch_vector_distance(a, b);
            if (hatch_vector_distance(a, at) + hatch_vector_distance(at, b) <= whole + 1e-6)
                return true;
        }
    }
    return false;
}

/* Samples of a segment: whether a ray reaches it, and whether it is in a visible or hidden part. */
struct samples {
    uint32_t count;
    bool inside[SAMPLES_MAX], ray[SAMPLES_MAX], visible[SAMPLES_MAX], hidden[SAMPLES_MAX];
};

static void sample(const struct hatch_mesh *mesh, const struct hatch_view *view, const double *ends, uint32_t id,
                   const struct hatch_vector_paths *visible, const struct hatch_vector_paths *hidden,
                   struct samples *samples)
{
    double places[2][2], at[3], here[2];
    for (int k = 0; k < 2; k++)
        place(ends + 3 * k, places[k]);
    samples->count = (uint32_t)fmin(hatch_vector_distance(places[0], places[1]) / STEP_PX, SAMPLES_MAX);
    for (uint32_t s = 0; s < samples->count; s++) {
        point_at(view, ends, (s + 0.5) / samples->count, at);
        place(at, here);
        samples->inside[s] = here[0] > 0 && here[1] > 0 && here[0] < SIDE_PX && here[1] < SIDE_PX;
        samples->ray[s] = samples->inside[s] && ray_reaches(mesh, view, at);
        samples->visible[s] = contains(visible, id, here);
        samples->hidden[s] = contains(hidden, id, here);
    }
}

/* Returns whether the rays at a sample and within NEAR_PX of it have the same result. */
static bool is_clear(const struct samples *samples, uint32_t s)
{
    uint32_t reach = (uint32_t)ceil(NEAR_PX / STEP_PX);
    for (uint32_t i = s < reach ? 0 : s - reach; i <= s + reach && i < samples->count; i++)
        if (samples->ray[i] != samples->ray[s] || !samples->inside[i])
            return false;
    return samples->inside[s];
}

/* Compares the visible parts of segments with rays. Every part is visible or hidden. */
static void check(const struct hatch_mesh *mesh, const struct hatch_view *view, const struct segments *segments,
                  const uint32_t *faces)
{
    static struct hatch_vector_curve curves[SEGMENTS];
    static struct samples samples;
    static float slack[2 * SEGMENTS];
    struct hatch_vector_paths visible, hidden;
    uint32_t missing = 0, left = 0, seen = 0, clear = 0;
    for (uint32_t i = 0; i < SEGMENTS; i++) {
        curves[i] = (struct hatch_vector_curve){.first = 2 * i, .count = 2, .id = i};
        slack[2 * i] = slack[2 * i + 1] = 1e-6f;
    }
    const struct hatch_vector_curves all = {
        .count = SEGMENTS, .curves = curves, .points = segments->points, .faces = faces, .slack = slack};
    hide_behind(mesh, view);
    see(&all, &visible, &hidden);
    for (uint32_t i = 0; i < SEGMENTS; i++) {
        sample(mesh, view, &segments->points[6 * i], i, &visible, &hidden, &samples);
        for (uint32_t s = 0; s < samples.count; s++) {
            ck_assert(!samples.inside[s] || samples.visible[s] || samples.hidden[s]);
            if (!is_clear(&samples, s))
                continue;
            clear++;
            seen += samples.ray[s];
            missing += samples.ray[s] && !samples.visible[s];
            left += !samples.ray[s] && samples.visible[s];
        }
    }
    ck_assert_uint_eq(missing, 0);
    ck_assert_uint_eq(left, 0);
    ck_assert_uint_gt(seen, clear / 20);
    ck_assert_uint_lt(seen, clear - clear / 20);
}

/* Segments between random points of a cube. */
static void scatter(struct segments *segments, double half, uint32_t stream)
{
    for (uint32_t i = 0; i < 6 * SEGMENTS; i++)
        segments->points[i] = half * (2 * unit_random(stream, i) - 1);
}

/* Segments on random faces. */
static void lay(const struct hatch_mesh *mesh, struct segments *segments, uint32_t stream)
{
    for (uint32_t i = 0; i < SEGMENTS; i++) {
        uint32_t face = (uint32_t)(unit_random(stream, 7 * i) * mesh->face_count);
        for (uint32_t k = 0; k < 2; k++) {
            double u = unit_random(stream, 7 * i + 1 + k), v = unit_random(stream, 7 * i + 3 + k), at[3][3];
            double shares[3] = {1 - fmax(u, v), fabs(u - v), fmin(u, v)};
            for (uint32_t c = 0; c < 3; c++)
                hatch_vec_of(&mesh->attributes[0].data[3 * (size_t)mesh->indices[3 * (size_t)face + c]], at[c]);
            for (int j = 0; j < 3; j++)
                segments->points[6 * i + 3 * k + (uint32_t)j] =
                    shares[0] * at[0][j] + shares[1] * at[1][j] + shares[2] * at[2][j];
            segments->faces[2 * i + k] = face;
        }
    }
}

static struct hatch_mesh teapot_and_torus(void)
{
    struct hatch_mesh teapot = shape_of(HATCH_SHAPE_TEAPOT, 900), torus = shape_of(HATCH_SHAPE_TORUS, 500);
    return joined(&teapot, &torus, 0.6, (const double[3]){0.3, 0.2, 0.9});
}

/* Triangles in all directions. */
static struct hatch_mesh triangles(uint32_t count, double size)
{
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 3 * count, count, &mesh, &err), &err);
    for (uint32_t i = 0; i < 9 * count; i++)
        mesh.attributes[0].data[i] =
            (float)(2 * unit_random(3, i / 9 * 3 + i % 3) - 1 + size * (2 * unit_random(4, i) - 1));
    for (uint32_t i = 0; i < 3 * count; i++)
        mesh.indices[i] = i;
    return mesh;
}

static struct segments made;

START_TEST(free_segments_among_curved_surfaces)
{
    struct hatch_mesh mesh = teapot_and_torus();
    struct hatch_view view = view_from(2, 1.5, 3.5, false);
    scatter(&made, 1.2, 1);
    check(&mesh, &view, &made, NULL);
}
END_TEST

START_TEST(segments_on_curved_surfaces)
{
    struct hatch_mesh mesh = teapot_and_torus();
    struct hatch_view view = view_from(-2, 2.5, 3, false);
    lay(&mesh, &made, 2);
    check(&mesh, &view, &made, made.faces);
}
END_TEST

START_TEST(segments_among_loose_triangles)
{
    struct hatch_mesh mesh = triangles(60, 0.5);
    struct hatch_view view = view_from(3, -2, 2, false);
    scatter(&made, 1.2, 5);
    check(&mesh, &view, &made, NULL);
}
END_TEST

START_TEST(segments_in_an_orthographic_view)
{
    struct hatch_mesh mesh = triangles(40, 0.6);
    struct hatch_view view = view_from(1, 2, 3, true);
    scatter(&made, 1.2, 6);
    check(&mesh, &view, &made, NULL);
}
END_TEST

/* The camera is among the triangles, of which some reach behind it. */
START_TEST(segments_around_the_camera)
{
    struct hatch_mesh mesh = triangles(60, 0.7);
    struct hatch_view view = view_from(0.2, 0.1, 0.15, false);
    view.near = 1e-6;
    scatter(&made, 1.2, 8);
    for (uint32_t i = 0; i < 2 * SEGMENTS; i++) { /* in front of the camera */
        double from[3];
        hatch_vec_sub(&made.points[3 * i], view.eye, from);
        double depth = -hatch_vec_dot(from, view.back);
        if (depth < 0.05)
            hatch_vec_add_scaled(&made.points[3 * i], depth - 0.1, view.back, &made.points[3 * i]);
    }
    check(&mesh, &view, &made, NULL);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("vector hidden rays");
    TCase *tests = tcase_create("rays");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, free_segments_among_curved_surfaces);
    tcase_add_test(tests, segments_on_curved_surfaces);
    tcase_add_test(tests, segments_among_loose_triangles);
    tcase_add_test(tests, segments_in_an_orthographic_view);
    tcase_add_test(tests, segments_around_the_camera);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
