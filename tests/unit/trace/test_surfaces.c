/* Strokes on curved, closed, broken and odd surfaces. */
#include "trace_make.h"

static double area_of(const struct field_case *field)
{
    double area = 0;
    for (uint32_t f = 0; f < field->mesh.face_count; f++) {
        double corner[3][3], normal[3];
        if (!hatch_mesh_corners(&field->mesh, f, corner))
            continue;
        hatch_vec_triangle(corner[0], corner[1], corner[2], normal);
        area += hatch_vec_length(normal) / 2;
    }
    return area;
}

/* Returns the length of all strokes where their thresholds are below a density. */
static double length_below(const struct hatch_curves *curves, const struct hatch_mesh *mesh, double density)
{
    double total = 0;
    for (uint32_t c = 0; c < curves->count; c++)
        for (uint32_t i = 1; i < curves->curves[c].count; i++) {
            const struct hatch_curve part = {.first = curves->curves[c].first + i - 1, .count = 2};
            const struct hatch_curve_point *ends = &curves->points[part.first];
            double a = (double)ends[0].threshold, b = (double)ends[1].threshold, low = fmin(a, b), high = fmax(a, b);
            double share = density >= high ? 1 : density <= low ? 0 : log(density / low) / log(high / low);
            total += share * curve_length(curves, &part, mesh);
        }
    return total;
}

/* The strokes that are drawn for a density have that length per area, over three octaves. */
static void check_density(const struct field_case *field, const char *name)
{
    struct hatch_trace_options options = with_gap(0.2, 5);
    struct hatch_curves curves = trace_with(field, &options, NULL);
    double area = area_of(field);
    for (double density = 1.5; density <= 12.01; density *= sqrt(2)) {
        double got = length_below(&curves, &field->mesh, density / options.gap) / area / (density / options.gap);
        ck_assert_msg(got > 0.75 && got < 1.15, "%s: %g times the length wanted at %g strokes per gap", name, got,
                      density);
    }
}

START_TEST(the_length_of_strokes_is_the_density)
{
    struct field_case flat = trace_plane(2000, 1), ball = case_of_shape(HATCH_SHAPE_SPHERE, 3000, 0.5f);
    struct field_case ring = case_of_shape(HATCH_SHAPE_TORUS, 3000, 0.5f);
    set_direction(&ball, 0, 1, 0);
    follow_truth(&ring, HATCH_SHAPE_TORUS, 0, 1);
    check_density(&flat, "plane");
    check_density(&ball, "sphere");
    check_density(&ring, "torus");
}
END_TEST

/* On a sphere with the field along the meridians, strokes at an angle to it are loxodromes; they end where both poles
 * have no direction. */
START_TEST(strokes_on_a_sphere_keep_their_angle)
{
    struct field_case ball = case_of_shape(HATCH_SHAPE_SPHERE, 20000, 0);
    static const float angles[2] = {0, (float)(PI / 3)};
    struct hatch_trace_options options = with_gap(0.2, 2);
    options.family_count = 2;
    options.angle_rad = angles;
    set_direction(&ball, 0, 1, 0);
    struct hatch_curves curves = trace_with(&ball, &options, NULL);
    uint32_t met = 0;
    double deepest = 1;
    for (uint32_t s = 0; s < curves.set_count; s++)
        for (uint32_t c = curves.sets[s].first; c < curves.sets[s].first + curves.sets[s].count; c++) {
            const struct hatch_curve *curve = &curves.curves[c];
            for (uint32_t i = 0; i < curve->count; i++) {
                double ends[2][3], way[3], up[3] = {0, 1, 0}, middle[3], left[3];
                float at[3];
                for (uint32_t k = 0; k < 2 && i + k < curve->count; k++) {
                    hatch_curve_position(&ball.mesh, &curves.points[curve->first + i + k], at);
                    hatch_vec_of(at, ends[k]);
                    ck_assert_double_eq_tol(hatch_vec_length(ends[k]), 1, 0.002);
                }
                if (i + 1 == curve->count)
                    continue;
                hatch_vec_sub(ends[1], ends[0], way);
                hatch_vec_add_scaled(ends[0], 0.5, way, middle);
                deepest = fmin(deepest, hatch_vec_length(middle));
                hatch_vec_normalize(middle);
                if (fabs(middle[1]) > 0.8 || hatch_vec_length(way) < 0.05)
                    continue;
                hatch_vec_add_scaled(up, -middle[1], middle, up);
                hatch_vec_cross(middle, up, left);
                double angle = atan2(hatch_vec_dot(left, way), hatch_vec_dot(up, way));
                double off = remainder(angle - (double)curves.sets[s].angle_rad, PI);
                ck_assert_msg(fabs(off) < 0.12, "family %u: %g radians off", curves.sets[s].family, off);
                met++;
            }
        }
    ck_assert_uint_gt(met, 300);
    ck_assert_double_ge(deepest, 1 - 0.305 * 0.1); /* lines pass up to 0.3 gaps of the finest level under it */
    ck_assert_double_le(deepest, 1 - 0.25 * 0.1);
}
END_TEST

/* Checks that no end of a stroke is free on an edge of a cube, which two sides share. Returns the number of free ends.
 */
static uint32_t check_ends(const struct hatch_curves *curves, const struct hatch_curve *curve,
                           const struct hatch_mesh *cube)
{
    uint32_t free = 0;
    for (uint32_t end = 0; end < 2; end++) {
        float at[3];
        uint32_t sides = 0;
        hatch_curve_position(cube, &curves->points[curve->first + (end > 0 ? curve->count - 1 : 0)], at);
        for (int k = 0; k < 3; k++)
            sides += fabsf(at[k]) > 0.99999f;
        bool is_free = curve->free_ends >> end & 1;
        ck_assert_msg(!is_free || sides < 2, "stroke %u: end %u at %g %g %g", curve->id, end, (double)at[0],
                      (double)at[1], (double)at[2]);
        free += is_free;
    }
    return free;
}

/* Strokes end at hard edges and stay on their side of a box. */
START_TEST(strokes_end_at_hard_edges)
{
    struct field_case box = case_of(cube(-1, 1));
    struct hatch_trace_options options = with_gap(0.3, 3);
    set_direction(&box, 0.3, 1, 0.2);
    struct hatch_curves curves = trace_with(&box, &options, NULL);
    uint32_t seen = 0, free = 0;
    for (uint32_t c = 0; c < curves.count; c++) {
        uint32_t side = curves.points[curves.curves[c].first].face / 2; /* two faces per side */
        seen |= 1u << side;
        free += check_ends(&curves, &curves.curves[c], &box.mesh);
        for (uint32_t i = 1; i < curves.curves[c].count; i++)
            ck_assert_uint_eq(curves.points[curves.curves[c].first + i].face / 2, side);
    }
    ck_assert_uint_eq(seen, 63);
    ck_assert_uint_gt(free, curves.count / 10);
    ck_assert_uint_lt(free, curves.count);
    /* Without hard edges some run on around it. */
    options.hard_rad = PI;
    curves = trace_with(&box, &options, NULL);
    uint32_t bent = 0;
    for (uint32_t c = 0; c < curves.count; c++)
        for (uint32_t i = 1; i < curves.curves[c].count; i++)
            bent += curves.points[curves.curves[c].first + i].face / 2 !=
                    curves.points[curves.curves[c].first + i - 1].face / 2;
    ck_assert_uint_gt(bent, 10);
}
END_TEST

/* Strokes that run into a jump of the direction end there and are not free; those that run beside it are. */
START_TEST(strokes_end_where_the_direction_jumps)
{
    struct field_case plane = trace_plane(800, 0); /* faces of 0.1 */
    uint32_t bound = 0;
    for (uint32_t p = 0; p < plane.surface.point_count; p++) {
        double at[3];
        hatch_surface_position(&plane.surface, p, at);
        plane.direction[3 * p] = at[0] < 0;
        plane.direction[3 * p + 1] = !(at[0] < 0);
    }
    const struct hatch_trace_options options = with_gap(0.2, 3);
    struct hatch_curves curves = trace_with(&plane, &options, NULL);
    for (uint32_t c = 0; c < curves.count; c++)
        for (uint32_t end = 0; end < 2; end++) {
            const struct hatch_curve *curve = &curves.curves[c];
            float at[3];
            hatch_curve_position(&plane.mesh, &curves.points[curve->first + (end > 0 ? curve->count - 1 : 0)], at);
            bool is_free = curve->free_ends >> end & 1, jumps = at[0] > -0.101f && at[0] < 0.001f;
            bound += jumps && !is_free;
            ck_assert_msg(is_free || jumps || fabsf(at[0]) > 0.999f || fabsf(at[1]) > 0.999f, "end at %g %g",
                          (double)at[0], (double)at[1]);
        }
    ck_assert_uint_gt(bound, 20);
}
END_TEST

/* Traces strokes along a direction in space and checks them; returns how many there are. */
static uint32_t trace_mesh(struct hatch_mesh mesh, double gap)
{
    struct field_case field = case_of(mesh);
    struct hatch_trace_options options = with_gap(gap, 3);
    set_direction(&field, 0.4, 1, 0.3);
    return trace_with(&field, &options, NULL).count;
}

START_TEST(odd_surfaces_have_valid_strokes)
{
    static const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    static const uint32_t one[3] = {0, 1, 2};
    struct hatch_mesh tall = fan(16);
    for (uint32_t v = 0; v < tall.vertex_count; v++)
        tall.attributes[0].data[3 * v] *= 1e-4f;
    ck_assert_uint_gt(trace_mesh(band(60, 4, true), 0.1), 50);
    ck_assert_uint_gt(trace_mesh(klein(24, 16), 0.5), 50);
    ck_assert_uint_gt(trace_mesh(bare_shape(HATCH_SHAPE_CYLINDER, 200), 0.2), 50);
    ck_assert_uint_gt(trace_mesh(bare_shape(HATCH_SHAPE_TEAPOT, 1000), 0.2), 50);
    ck_assert_uint_gt(trace_mesh(fan(1000), 0.1), 50);
    ck_assert_uint_gt(trace_mesh(mesh_of(corners, 3, one, 1), 0.1), 10);
    trace_mesh(mesh_of(corners, 3, one, 1), 3); /* smaller than the gap */
    trace_mesh(cube(0, 0.01f), 0.25);
    trace_mesh(tall, 0.05);
}
END_TEST

/* Makes an open tube of circumference 1 around the x axis, whose field runs around it. */
static struct field_case make_tube(uint32_t sides, uint32_t rings, float length)
{
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, sides * (rings + 1), 2 * sides * rings, &mesh, &err), &err);
    for (uint32_t v = 0; v < mesh.vertex_count; v++) {
        double turn = 2 * PI * (v % sides) / sides, radius = 0.5 / sides / sin(PI / sides);
        const float at[3] = {length * (float)(v / sides) / (float)rings, (float)(radius * cos(turn)),
                             (float)(radius * sin(turn))};
        memcpy(&mesh.attributes[0].data[3 * v], at, sizeof at);
    }
    for (uint32_t q = 0; q < sides * rings; q++) {
        uint32_t a = q, b = q % sides + 1 < sides ? q + 1 : q + 1 - sides;
        const uint32_t faces[6] = {a, b, b + sides, a, b + sides, a + sides};
        memcpy(&mesh.indices[6 * q], faces, sizeof faces);
    }
    struct field_case tube = case_of(mesh);
    for (uint32_t p = 0; p < tube.surface.point_count; p++) {
        double at[3], around[3], axis[3] = {1, 0, 0};
        hatch_surface_position(&tube.surface, p, at);
        at[0] = 0;
        hatch_vec_cross(axis, at, around);
        hatch_vec_normalize(around);
        hatch_vec_copy(around, &tube.direction[3 * p]);
    }
    return tube;
}

/* Around a thin tube, a stroke goes once, whatever the gap is: its windings would be too near to one another. */
START_TEST(strokes_go_around_a_tube_once)
{
    struct field_case tube = make_tube(16, 160, 16);
    static const double gaps[4] = {4, 1.6, 0.9, 0.5};
    for (int g = 0; g < 4; g++)
        for (int helix = 0; helix < 2; helix++) {
            struct hatch_trace_options options = with_gap(gaps[g], 1);
            const float angle = helix ? 0.2f : 0;
            double longest = 0;
            options.angle_rad = &angle;
            struct hatch_curves curves = trace_with(&tube, &options, NULL);
            for (uint32_t c = 0; c < curves.count; c++)
                longest = fmax(longest, curve_length(&curves, &curves.curves[c], &tube.mesh));
            ck_assert_msg(longest < 1.25, "gap %g, angle %g: a stroke of %g turns", gaps[g], (double)angle, longest);
            if (gaps[g] < 0.6) /* where no stroke is left out for being shorter than the gap */
                ck_assert_msg(longest > 0.7, "gap %g, angle %g: at most %g turns", gaps[g], (double)angle, longest);
        }
}
END_TEST

/* Returns the first set's strokes on faces below a number, whose order is that of thresholds. */
static uint32_t compare_below(const struct hatch_curves *a, const struct hatch_curves *b, uint32_t faces)
{
    uint32_t c = 0, same = 0;
    for (uint32_t d = 0; d < b->count; d++) {
        const struct hatch_curve *of = &b->curves[d];
        if (b->points[of->first].face >= faces)
            continue;
        ck_assert_uint_lt(c, a->count);
        ck_assert_uint_eq(of->id, a->curves[c].id);
        ck_assert_uint_eq(of->count, a->curves[c].count);
        ck_assert_mem_eq(&b->points[of->first], &a->points[a->curves[c].first], of->count * sizeof *a->points);
        c++, same++;
    }
    ck_assert_uint_eq(c, a->count);
    return same;
}

/* Gaps are measured on the surface: a second sheet just above another changes nothing on it. */
START_TEST(other_sheets_do_not_count)
{
    struct field_case one = trace_plane(300, 1);
    struct hatch_mesh above = one.mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, one.mesh.vertex_count, one.mesh.face_count, &above, &err), &err);
    memcpy(above.indices, one.mesh.indices, 12 * (size_t)one.mesh.face_count);
    memcpy(above.attributes[0].data, one.mesh.attributes[0].data, 12 * (size_t)one.mesh.vertex_count);
    for (uint32_t v = 0; v < above.vertex_count; v++)
        above.attributes[0].data[3 * v + 2] = 0x1p-10f;
    struct field_case two = case_of(both(&one.mesh, &above));
    struct hatch_trace_options options = with_gap(0.2, 3);
    set_direction(&two, 1, 0, 0);
    struct hatch_curves alone = trace_with(&one, &options, NULL), doubled = trace_with(&two, &options, NULL);
    ck_assert_uint_gt(compare_below(&alone, &doubled, one.mesh.face_count), 100);
    ck_assert_uint_gt(doubled.count, alone.count + 100);
}
END_TEST

/* A line between two points of a stroke, whose ends are angles around a torus. */
struct part {
    double a[2], b[2];
    double before, length, after; /* of the stroke's length: before, in and behind it */
    uint32_t level;
};

static double side_of(const double *a, const double *b, const double *p)
{
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

/* Returns the length from a crossing of two parts to the nearest end of their strokes that is not nearer to it than the
 * other stroke's, in gaps of the finer level; 0 where they do not cross. */
static double cross(const struct part *p, const struct part *q, double gap)
{
    static const double a[2] = {0, 0};
    double b[2], c[2], d[2];
    for (int k = 0; k < 2; k++) { /* around p's beginning */
        b[k] = remainder(p->b[k] - p->a[k], 2 * PI);
        c[k] = remainder(q->a[k] - p->a[k], 2 * PI);
        d[k] = c[k] + remainder(q->b[k] - q->a[k], 2 * PI);
    }
    if (side_of(a, b, c) * side_of(a, b, d) >= 0 || side_of(c, d, a) * side_of(c, d, b) >= 0)
        return 0;
    double on_p = p->length * side_of(c, d, a) / (side_of(c, d, a) - side_of(c, d, b));
    double on_q = q->length * side_of(a, b, c) / (side_of(a, b, c) - side_of(a, b, d));
    double to_p = fmin(p->before + on_p, p->after + p->length - on_p);
    double to_q = fmin(q->before + on_q, q->after + q->length - on_q);
    return fmax(to_p, to_q) / ldexp(gap, -(int)(p->level > q->level ? p->level : q->level));
}

/* Lists the parts of a set's strokes; returns their number. */
static uint32_t list_parts(const struct field_case *ring, const struct hatch_curves *curves,
                           const struct hatch_curve_set *set, struct part *parts)
{
    uint32_t count = 0;
    for (uint32_t c = set->first; c < set->first + set->count; c++) {
        double length = 0, whole = curve_length(curves, &curves->curves[c], &ring->mesh), last[2];
        for (uint32_t i = 0; i < curves->curves[c].count; i++) {
            const struct hatch_curve before = {.first = curves->curves[c].first + i - 1, .count = 2};
            float at[3];
            hatch_curve_position(&ring->mesh, &curves->points[curves->curves[c].first + i], at);
            const double place[2] = {atan2((double)at[2], (double)at[0]),
                                     atan2((double)at[1], hypot((double)at[0], (double)at[2]) - 1)};
            if (i > 0) {
                struct part *part = &parts[count++];
                *part = (struct part){.before = length, .level = set->level};
                memcpy(part->a, last, sizeof last);
                memcpy(part->b, place, sizeof place);
                part->length = curve_length(curves, &before, &ring->mesh);
                length += part->length;
                part->after = whole - length;
            }
            memcpy(last, place, sizeof last);
        }
    }
    return count;
}

/* No stroke crosses another of its family, nor itself: their spacing exceeds what leaving out points moves them by. Two
 * ends that grow towards one another at once may pass for half a gap. */
START_TEST(strokes_of_a_family_do_not_cross)
{
    struct field_case ring = case_of_shape(HATCH_SHAPE_TORUS, 6000, 0.5f);
    const float angle = 0.5f;
    struct hatch_trace_options options = with_gap(0.25, 3);
    options.angle_rad = &angle;
    follow_truth(&ring, HATCH_SHAPE_TORUS, 0, 1);
    struct hatch_curves curves = trace_with(&ring, &options, NULL);
    struct part *parts = HATCH_NEW(&keep, struct part, curves.point_count, &err);
    uint32_t count = 0;
    for (uint32_t s = 0; s < curves.set_count; s++)
        count += list_parts(&ring, &curves, &curves.sets[s], &parts[count]);
    ck_assert_uint_gt(count, 1000);
    for (uint32_t p = 0; p < count; p++)
        for (uint32_t q = 0; q < p; q++) {
            double from_end = cross(&parts[p], &parts[q], options.gap);
            /* Ends that meet pass one another by 0.6 gaps, and end up to a round of 0.5 later. */
            ck_assert_msg(from_end < 1.1, "strokes cross %g gaps from an end", from_end);
        }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("trace surfaces");
    TCase *tests = tcase_create("surfaces");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, the_length_of_strokes_is_the_density);
    tcase_add_test(tests, strokes_on_a_sphere_keep_their_angle);
    tcase_add_test(tests, strokes_end_at_hard_edges);
    tcase_add_test(tests, strokes_end_where_the_direction_jumps);
    tcase_add_test(tests, odd_surfaces_have_valid_strokes);
    tcase_add_test(tests, strokes_go_around_a_tube_once);
    tcase_add_test(tests, other_sheets_do_not_count);
    tcase_add_test(tests, strokes_of_a_family_do_not_cross);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
