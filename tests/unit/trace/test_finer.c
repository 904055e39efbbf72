/* Strokes that near views add to those of a mesh. */
#include "curve/density.h"
#include "trace/finer.h"
#include "trace_make.h"

static float most[HATCH_CURVE_FAMILIES_MAX][HATCH_STROKE_TONES];

/* A mesh with strokes and its field as an attribute, and what makes finer ones. */
struct finer_case {
    struct field_case field;
    struct hatch_curves curves;
    struct hatch_finer_source source;
};

/* Writes the field to the attribute _HATCH_DIR. */
static void keep_field(struct field_case *field)
{
    float *values;
    HATCH_TEST_OK(hatch_mesh_add(&keep, &field->mesh, "_HATCH_DIR", 4, &values, &err), &err);
    for (uint32_t c = 0; c < 3 * field->surface.face_count; c++) {
        float *to = &values[4 * (size_t)field->surface.corner_vertex[c]];
        hatch_vec_round(&field->direction[3 * (size_t)field->surface.corners[c]], to);
        to[3] = 1;
    }
}

static void make_case(struct finer_case *made, struct field_case field, const struct hatch_trace_options *options)
{
    struct hatch_curve_groups groups;
    float *thresholds;
    made->field = field;
    keep_field(&made->field);
    made->curves = trace_with(&made->field, options, NULL);
    HATCH_TEST_OK(HATCH_ALLOC(&keep, &thresholds, made->curves.point_count, &err), &err);
    for (uint32_t i = 0; i < made->curves.point_count; i++)
        thresholds[i] = made->curves.points[i].threshold;
    HATCH_TEST_OK(hatch_curves_group(&made->curves, &made->field.mesh, &keep, &scratch, &groups, &err), &err);
    HATCH_TEST_OK(hatch_curves_even_thresholds(&made->curves, &made->field.mesh, &groups, &scratch, thresholds, &err),
                  &err);
    made->source = (struct hatch_finer_source){
        .mesh = &made->field.mesh, .curves = &made->curves, .thresholds = thresholds, .limit_bytes = (size_t)1 << 30};
}

static void make_plane(struct finer_case *made)
{
    struct hatch_trace_options options = with_gap(0.1, 3);
    make_case(made, trace_plane(128, 0.3f), &options);
}

static struct hatch_finer *open_finer(const struct finer_case *of)
{
    struct hatch_finer *finer;
    HATCH_TEST_OK(hatch_finer_make(&of->source, &finer, &err), &err);
    return finer;
}

/* Looks straight down at a square of the plane z = 0, so that strokes `gap` apart are wanted everywhere, and so much
 * more finely that none of them fades. */
static struct hatch_finer_view view_of(double x, double y, double side, double gap)
{
    struct hatch_finer_view view = {.width_px = 512, .height_px = 512, .most = most, .levels = 24, .front = true};
    double m = 2 / side, px = 512 / side;
    const double matrix[16] = {m, 0, 0, 0, 0, m, 0, 0, 0, 0, 1, 0, -x * m, -y * m, 0, 1};
    memcpy(view.clip_from_mesh, matrix, sizeof matrix);
    for (uint32_t f = 0; f < HATCH_CURVE_FAMILIES_MAX; f++)
        for (uint32_t i = 0; i < HATCH_STROKE_TONES; i++)
            most[f][i] = (float)(1 / (gap * px));
    return view;
}

static struct hatch_finer_found find(struct hatch_finer *finer, const struct hatch_finer_view *view)
{
    struct hatch_finer_found found;
    HATCH_TEST_OK(hatch_finer_find(finer, view, &keep, &found, &err), &err);
    return found;
}

static void check_equal(const struct hatch_finer_found *a, const struct hatch_finer_found *b)
{
    ck_assert_uint_eq(b->curves.count, a->curves.count);
    ck_assert_uint_eq(b->curves.point_count, a->curves.point_count);
    ck_assert_mem_eq(b->curves.curves, a->curves.curves, a->curves.count * sizeof *a->curves.curves);
    ck_assert_mem_eq(b->curves.points, a->curves.points, a->curves.point_count * sizeof *a->curves.points);
    ck_assert_mem_eq(b->parts, a->parts, a->curves.count * sizeof *a->parts);
}

START_TEST(nothing_is_traced_where_the_strokes_suffice)
{
    struct finer_case plane;
    make_plane(&plane);
    struct hatch_finer *finer = open_finer(&plane);
    struct hatch_finer_view view = view_of(0, 0, 1, 0.01);
    const double wanted = 100 / HATCH_STROKE_FADE;
    view.densest = 1.01 * wanted / HATCH_FINER_START;
    struct hatch_finer_found found = find(finer, &view);
    ck_assert(!found.finer);
    ck_assert_uint_eq(found.curves.count, 0);
    ck_assert_uint_eq(found.traced, 0);
    view.densest = wanted / 2;
    found = find(finer, &view);
    ck_assert(found.finer && found.enough);
    ck_assert_uint_gt(found.traced, 0);
    hatch_finer_free(finer);
}
END_TEST

/* Returns the sum of the widths, in pixels, at which the middles of strokes of a level and finer ones are drawn. */
static double widths_of(const struct hatch_finer_found *found, double densest, double scale, uint32_t from_level)
{
    const struct hatch_stroke_pen pen = {.width_px = 2, .thin = 1};
    double sum = 0;
    for (uint32_t s = 0; s < found->curves.set_count; s++)
        for (uint32_t c = 0; c < found->curves.sets[s].count && found->curves.sets[s].level >= from_level; c++) {
            const struct hatch_curve *curve = &found->curves.curves[found->curves.sets[s].first + c];
            double threshold = (double)found->curves.points[curve->first + curve->count / 2].threshold;
            sum += hatch_stroke_width_px(&pen, 1, threshold, scale, densest, found->raised, 1);
        }
    return sum;
}

/* Little by little, as more strokes are wanted, those that are traced join those of the mesh, which get thinner. */
START_TEST(finer_strokes_join_gradually)
{
    struct finer_case plane;
    make_plane(&plane);
    struct hatch_finer *finer = open_finer(&plane);
    const double densest = 40, steps[] = {1.401, 1.43, 1.5, 1.6, 1.7, 1.9, 2.2, 2.6, 3.6};
    double before = 0;
    for (size_t i = 0; i < sizeof steps / sizeof *steps; i++) {
        double wanted = steps[i] * densest, scale = wanted * 2 * HATCH_STROKE_GAIN;
        struct hatch_finer_view view = view_of(0, 0, 1, 1 / (wanted * HATCH_STROKE_FADE));
        view.densest = densest;
        struct hatch_finer_found found = find(finer, &view);
        double all = widths_of(&found, found.densest, scale, 0);
        double share = widths_of(&found, found.densest, scale, 3) / all;
        ck_assert(found.finer && found.enough);
        ck_assert_msg(share >= before && share < before + 0.25, "%g wanted: %g after %g", steps[i], share, before);
        before = share;
        ck_assert(i > 0 || (share <= 0.01 && found.densest <= densest));
        ck_assert(steps[i] < 3.5 || found.densest > HATCH_STROKE_SPARE * wanted); /* no stroke is wider */
    }
    ck_assert_double_gt(before, 0.3);
    hatch_finer_free(finer);
}
END_TEST

/* Returns the length of strokes in a square, per area, where their threshold is at most a limit. */
static double drawn_length(const struct hatch_finer_found *found, const struct hatch_mesh *mesh, double x, double y,
                           double side, double limit)
{
    double sum = 0;
    for (uint32_t c = 0; c < found->curves.count; c++) {
        const struct hatch_curve *curve = &found->curves.curves[c];
        for (uint32_t i = curve->first; i + 1 < curve->first + curve->count; i++) {
            float ends[2][3];
            double a[3], b[3];
            for (int e = 0; e < 2; e++)
                hatch_curve_position(mesh, &found->curves.points[i + (uint32_t)e], ends[e]);
            hatch_vec_of(ends[0], a);
            hatch_vec_of(ends[1], b);
            double t[2] = {log((double)found->curves.points[i].threshold),
                           log((double)found->curves.points[i + 1].threshold)};
            for (int part = 0; part < 20; part++) { /* by the middles of short parts */
                double share = (part + 0.5) / 20, at[2];
                for (int k = 0; k < 2; k++)
                    at[k] = a[k] + share * (b[k] - a[k]);
                if (fabs(at[0] - x) < side / 2 && fabs(at[1] - y) < side / 2 &&
                    t[0] + share * (t[1] - t[0]) <= log(limit))
                    sum += hatch_vec_distance(a, b) / 20;
            }
        }
    }
    return sum / (side * side);
}

/* On a plane with a field along x all strokes are straight, and one that is seen whole has nothing before or after it.
 */
START_TEST(strokes_of_a_plane_are_straight_and_whole)
{
    struct finer_case plane;
    make_plane(&plane);
    struct hatch_finer *finer = open_finer(&plane);
    struct hatch_finer_view view = view_of(0, 0, 4, 0.02);
    struct hatch_finer_found found = find(finer, &view);
    uint32_t traced = 0;
    for (uint32_t s = 0; s < found.curves.set_count; s++)
        for (uint32_t c = 0; c < found.curves.sets[s].count && found.curves.sets[s].level >= 3; c++) {
            const struct hatch_curve *curve = &found.curves.curves[found.curves.sets[s].first + c];
            const struct hatch_finer_part *part = &found.parts[found.curves.sets[s].first + c];
            float first[3], last[3], at[3];
            hatch_curve_position(&plane.field.mesh, &found.curves.points[curve->first], first);
            hatch_curve_position(&plane.field.mesh, &found.curves.points[curve->first + curve->count - 1], last);
            for (uint32_t i = 0; i < curve->count; i++) {
                hatch_curve_position(&plane.field.mesh, &found.curves.points[curve->first + i], at);
                ck_assert_float_eq_tol(at[1], first[1], 1e-4f);
            }
            ck_assert_float_eq_tol(part->before, 0, 1e-5f);
            ck_assert_float_eq_tol(part->after, 0, 1e-5f);
            ck_assert_double_eq_tol(curve_length(&found.curves, curve, &plane.field.mesh),
                                    fabs((double)last[0] - (double)first[0]), 1e-5);
            traced++;
        }
    ck_assert_uint_gt(traced, 100);
    hatch_finer_free(finer);
}
END_TEST

START_TEST(as_many_strokes_are_drawn_as_are_wanted)
{
    struct finer_case plane;
    make_plane(&plane);
    struct hatch_finer *finer = open_finer(&plane);
    for (int octave = 2; octave <= 4; octave += 2) {
        double sum = 0, side = ldexp(1, -octave), gap = side / 30;
        for (int place = 0; place < 3; place++) {
            double x = 0.6 * (place & 1) - 0.31, y = 0.53 * (place >> 1) - 0.23;
            struct hatch_finer_view view = view_of(x, y, side, gap);
            struct hatch_finer_found found = find(finer, &view);
            for (double share = 0.25; share < 0.45; share *= 1.189)
                sum += drawn_length(&found, &plane.field.mesh, x, y, side, share / gap) / (share / gap);
        }
        ck_assert_msg(fabs(sum / 12 - 1) < 0.08, "octave %d: %g of the strokes wanted", octave, sum / 12);
    }
    hatch_finer_free(finer);
}
END_TEST

/* Strokes that are alike cannot get wider: finer ones are traced where there are a tenth too few, and all that are
 * wanted are drawn. */
START_TEST(strokes_that_are_alike_soon_need_finer_ones)
{
    struct finer_case plane;
    make_plane(&plane);
    struct hatch_finer *finer = open_finer(&plane);
    const double densest = 40;
    for (double wanted = 0.99 * densest; wanted < 2 * densest; wanted *= 1.1) {
        struct hatch_finer_view view = view_of(-0.31, 0.23, 0.5, 1 / wanted);
        view.alike = true;
        view.densest = densest;
        struct hatch_finer_found found = find(finer, &view);
        ck_assert(found.finer == (wanted > HATCH_FINER_ALIKE * densest));
        if (!found.finer)
            continue;
        ck_assert(found.enough && found.densest >= HUGE_VAL);
        ck_assert_double_eq(found.raised, 1);
        double drawn = drawn_length(&found, &plane.field.mesh, -0.31, 0.23, 0.5, wanted);
        ck_assert_msg(fabs(drawn / wanted - 1) < 0.1, "%g strokes, want %g", drawn, wanted);
    }
    hatch_finer_free(finer);
}
END_TEST

/* The square wants half of the strokes but for one vertex, which wants all of them: hardly any ink is lacking. */
START_TEST(a_dark_spot_spares_finer_strokes)
{
    struct finer_case plane;
    struct hatch_trace_options options = with_gap(0.1, 3);
    make_case(&plane, trace_plane(1200, 0.3f), &options);
    struct hatch_finer *finer = open_finer(&plane);
    const struct hatch_mesh *mesh = &plane.field.mesh;
    float *ink = HATCH_NEW(&keep, float, 2 * (size_t)mesh->vertex_count, &err);
    uint32_t nearest = 0;
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        const float *at = &mesh->attributes[0].data[3 * (size_t)v], *best = &mesh->attributes[0].data[3 * nearest];
        nearest = hypot((double)at[0], (double)at[1]) < hypot((double)best[0], (double)best[1]) ? v : nearest;
    }
    for (double wanted = 1.05; wanted < 1.5; wanted += 0.1)
        for (int dark = 0; dark < 2; dark++) { /* dark: all of the square is like that vertex */
            struct hatch_finer_view view = view_of(0, 0, 1.5, 0.01);
            for (uint32_t i = 0; i < HATCH_STROKE_TONES; i++)
                most[0][i] *= (float)(i + 1) / HATCH_STROKE_TONES;
            for (uint32_t i = 0; i < 2 * mesh->vertex_count; i++)
                ink[i] = dark || i / 2 == nearest ? 1 : 0.5f;
            view.alike = true;
            view.densest = 100 / wanted;
            view.ink = ink;
            struct hatch_finer_found found = find(finer, &view);
            ck_assert(found.finer == (wanted > (dark ? HATCH_FINER_ALIKE : HATCH_FINER_SPARED)));
        }
    hatch_finer_free(finer);
}
END_TEST

/* Strokes of a level are no longer than 60 of its gaps, however long those of the mesh are: else every tile would need
 * everything around it. */
START_TEST(long_strokes_do_not_need_the_whole_mesh)
{
    struct finer_case plane;
    make_plane(&plane);
    struct hatch_finer_view view = view_of(0, 0, 0.02, 0.006);
    struct hatch_finer_found found[2];
    for (int i = 0; i < 2; i++) {
        for (uint32_t s = 0; s < plane.curves.set_count; s++)
            plane.curves.sets[s].length = i ? 1000 : 60;
        struct hatch_finer *finer = open_finer(&plane);
        found[i] = find(finer, &view);
        ck_assert_uint_gt(found[i].traced, 0);
        hatch_finer_free(finer);
    }
    check_equal(&found[0], &found[1]);
}
END_TEST

/* A stroke that ends at all edges stays on its face. */
START_TEST(an_angle_of_zero_is_no_missing_one)
{
    struct finer_case shape;
    struct hatch_trace_options options = with_gap(0.1, 3);
    struct field_case field = case_of(shape_of(HATCH_SHAPE_SPHERE, 500));
    uint32_t most_faces = 0;
    follow_truth(&field, HATCH_SHAPE_SPHERE, 0, 1);
    options.hard_rad = 0;
    make_case(&shape, field, &options);
    struct hatch_finer *finer = open_finer(&shape);
    struct hatch_finer_view view = view_of(0, 0, 0.5, 0.01);
    struct hatch_finer_found found = find(finer, &view);
    ck_assert_uint_gt(found.traced, 20);
    for (uint32_t i = 0; i < found.curves.count; i++) {
        const struct hatch_curve *curve = &found.curves.curves[i];
        const struct hatch_curve_point *point = &found.curves.points[curve->first];
        uint32_t faces = 1;
        for (uint32_t p = 1; p < curve->count; p++)
            faces += point[p].face != point[p - 1].face;
        most_faces = faces > most_faces ? faces : most_faces;
    }
    ck_assert_uint_le(most_faces, 2); /* an end on an edge is on either face */
    hatch_finer_free(finer);
}
END_TEST

START_TEST(a_view_that_comes_back_has_the_same_strokes)
{
    struct finer_case plane;
    make_plane(&plane);
    struct hatch_finer *finer = open_finer(&plane);
    struct hatch_finer_view view = view_of(0.3, 0.2, 0.06, 0.004), away = view_of(-0.6, -0.5, 0.06, 0.004);
    struct hatch_finer_found first = find(finer, &view), again, back;
    ck_assert_uint_gt(first.traced, 100);
    again = find(finer, &view);
    ck_assert_uint_eq(again.traced, 0); /* nothing is dropped that the view needs */
    check_equal(&first, &again);
    ck_assert_uint_gt(find(finer, &away).traced, 100); /* keep_bytes is 0: the first view is dropped */
    back = find(finer, &view);
    ck_assert_uint_gt(back.traced, 100);
    check_equal(&first, &back);
    hatch_finer_free(finer);
}
END_TEST

/* Returns whether a curve of a view is found in another one: the same stroke, the same parts. */
static bool has_curve(const struct hatch_finer_found *found, const struct hatch_curve *curve,
                      const struct hatch_finer_found *of)
{
    for (uint32_t c = 0; c < found->curves.count; c++) {
        const struct hatch_curve *other = &found->curves.curves[c];
        if (other->id == curve->id && other->count == curve->count &&
            memcmp(&found->curves.points[other->first], &of->curves.points[curve->first],
                   curve->count * sizeof *of->curves.points) == 0)
            return true;
    }
    return false;
}

START_TEST(the_way_to_a_view_does_not_matter)
{
    struct finer_case plane;
    make_plane(&plane);
    struct hatch_finer_view wanted = view_of(0.3, 0.2, 0.03, 0.002);
    struct hatch_finer *direct = open_finer(&plane);
    struct hatch_finer_found found = find(direct, &wanted);
    uint32_t finest = 0;
    plane.source.keep_bytes = (size_t)1 << 30;
    for (int way = 0; way < 2; way++) {
        struct hatch_finer *finer = open_finer(&plane);
        struct hatch_finer_view before = way == 0 ? view_of(0.32, 0.21, 0.03, 0.002) : view_of(0.3, 0.2, 0.03, 0.004);
        find(finer, &before);
        wanted = view_of(0.3, 0.2, 0.03, 0.002);
        struct hatch_finer_found there = find(finer, &wanted);
        ck_assert_uint_lt(there.traced, found.traced); /* the views overlap */
        ck_assert_uint_eq(there.curves.count, found.curves.count);
        for (uint32_t c = 0; c < found.curves.count; c++)
            ck_assert_msg(has_curve(&there, &found.curves.curves[c], &found), "way %d: curve %u", way, c);
        hatch_finer_free(finer);
    }
    for (uint32_t s = 0; s < found.curves.set_count; s++)
        finest = found.curves.sets[s].count > 20 ? found.curves.sets[s].level : finest;
    ck_assert_uint_eq(finest, 6);
    hatch_finer_free(direct);
}
END_TEST

/* Views side by side trace in regions that overlap, until all of the mesh costs no more. It is traced then, if it can
 * be kept, and later views find what they need. */
START_TEST(many_views_trace_a_mesh_once)
{
    for (int kept = 0; kept < 2; kept++) {
        struct finer_case plane;
        uint32_t busy = 0;
        make_plane(&plane);
        plane.source.keep_bytes = kept ? (size_t)64 << 20 : 1;
        struct hatch_finer *finer = open_finer(&plane);
        for (int i = 0; i < 8; i++) {
            const struct hatch_finer_view view = view_of(-0.875 + 0.25 * i, -0.5, 0.125, 0.0125);
            const struct hatch_finer_found found = find(finer, &view);
            ck_assert(found.finer && found.enough);
            ck_assert_msg(!kept || i < 4 || found.traced == 0, "view %d: %u strokes are traced", i, found.traced);
            busy += found.traced > 0;
        }
        ck_assert(kept || busy > 5);
        hatch_finer_free(finer);
    }
}
END_TEST

START_TEST(the_number_of_threads_does_not_matter)
{
    struct finer_case plane;
    make_plane(&plane);
    struct hatch_finer_view view = view_of(0.3, 0.2, 0.1, 0.004);
    struct hatch_finer *finer = open_finer(&plane);
    struct hatch_finer_found one = find(finer, &view);
    ck_assert_uint_gt(one.traced, 100);
    hatch_finer_free(finer);
    for (uint32_t threads = 1; threads <= 7; threads += 3) {
        HATCH_TEST_OK(hatch_pool_make(threads, &keep, &plane.source.pool, &err), &err);
        finer = open_finer(&plane);
        struct hatch_finer_found many = find(finer, &view);
        hatch_finer_free(finer);
        hatch_pool_free(plane.source.pool);
        check_equal(&one, &many);
    }
}
END_TEST

/* Two equal squares, one above the other, seen in perspective from 3 above the upper one: that hides the other, where
 * no finer strokes are wanted. */
START_TEST(hidden_faces_want_no_finer_strokes)
{
    static const uint32_t indices[12] = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
    static const float positions[24] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1};
    static const double matrix[16] = {5, 0, 0, 0, 0, 5, 0, 0, 0, 0, 0, -1, 0, 0, 0.1, 4};
    struct finer_case squares;
    struct hatch_trace_options options = with_gap(0.1, 3);
    struct field_case field = case_of(mesh_of(positions, 8, indices, 4));
    uint32_t finer_ones = 0;
    set_direction(&field, 1, 0, 0);
    make_case(&squares, field, &options);
    struct hatch_finer *finer = open_finer(&squares);
    struct hatch_finer_view view = view_of(0, 0, 1.2, 0.01);
    memcpy(view.clip_from_mesh, matrix, sizeof matrix);
    struct hatch_finer_found found = find(finer, &view);
    for (uint32_t s = 0; s < found.curves.set_count; s++)
        for (uint32_t c = 0; c < found.curves.sets[s].count && found.curves.sets[s].level >= 3; c++, finer_ones++) {
            const struct hatch_curve *curve = &found.curves.curves[found.curves.sets[s].first + c];
            for (uint32_t i = 0; i < curve->count; i++)
                ck_assert_uint_ge(found.curves.points[curve->first + i].face, 2);
        }
    ck_assert_uint_gt(finer_ones, 30);
    hatch_finer_free(finer);
}
END_TEST

START_TEST(a_mesh_without_a_field_is_refused)
{
    struct finer_case plane;
    struct hatch_finer *finer;
    make_plane(&plane);
    plane.field.mesh.attribute_count--;
    ck_assert_int_eq(hatch_finer_make(&plane.source, &finer, &err), HATCH_BAD_INPUT);
    ck_assert_ptr_null(finer);
    ck_assert_str_eq(err.text, "the mesh has no direction field, _HATCH_DIR");
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("trace finer");
    TCase *tests = tcase_create("finer");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, nothing_is_traced_where_the_strokes_suffice);
    tcase_add_test(tests, finer_strokes_join_gradually);
    tcase_add_test(tests, strokes_of_a_plane_are_straight_and_whole);
    tcase_add_test(tests, as_many_strokes_are_drawn_as_are_wanted);
    tcase_add_test(tests, strokes_that_are_alike_soon_need_finer_ones);
    tcase_add_test(tests, a_dark_spot_spares_finer_strokes);
    tcase_add_test(tests, long_strokes_do_not_need_the_whole_mesh);
    tcase_add_test(tests, an_angle_of_zero_is_no_missing_one);
    tcase_add_test(tests, a_view_that_comes_back_has_the_same_strokes);
    tcase_add_test(tests, the_way_to_a_view_does_not_matter);
    tcase_add_test(tests, many_views_trace_a_mesh_once);
    tcase_add_test(tests, the_number_of_threads_does_not_matter);
    tcase_add_test(tests, a_mesh_without_a_field_is_refused);
    suite_add_tcase(suite, tests);
    TCase *sight = tcase_create("sight");
    tcase_add_checked_fixture(sight, begin, end);
    tcase_add_test(sight, hidden_faces_want_no_finer_strokes);
    suite_add_tcase(suite, sight);
    return suite;
}
HATCH_TEST_MAIN(suite)
