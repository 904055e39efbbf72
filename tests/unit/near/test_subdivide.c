/* Subdivision of triangles: pieces cover the face without gaps, and the recursion ends. */
#include "run.h"

#include <math.h>
#include <string.h>

#include "base/random.h"
#include "math/vector.h"
#include "near/subdivide.h"

enum { MOST = 40000 };

struct list {
    uint32_t count;
    struct hatch_piece_corner corners[MOST][3];
};

static struct list lists[2];

static enum hatch_status keep(void *context, const struct hatch_piece_corner *const corner[3], struct hatch_err *err)
{
    struct list *list = context;
    if (list->count == MOST)
        return hatch_fail(err, HATCH_LIMIT, "too many");
    for (int i = 0; i < 3; i++)
        list->corners[list->count][i] = *corner[i];
    list->count++;
    return HATCH_OK;
}

static const struct hatch_piece_view wide = {.low = {-1e9, -1e9}, .high = {1e9, 1e9}, .near = 0x1p-50, .ratio = 2};

static void make_face(const double at[3][3], struct hatch_piece_corner face[3])
{
    memset(face, 0, 3 * sizeof *face);
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            face[i].at[k] = hatch_pair_of(at[i][k]);
            face[i].weight[k] = i == k;
        }
        face[i].place[0] = hatch_pair_sum(at[i][0] + 0.3, 0x1p-60);
        face[i].place[1] = hatch_pair_of(at[i][1]);
        face[i].place[2] = hatch_pair_sum(at[i][2], 0x1p-70);
    }
}

static void cut(const double at[3][3], const struct hatch_piece_view *view, struct list *list)
{
    struct hatch_piece_corner face[3];
    struct hatch_err err;
    make_face(at, face);
    list->count = 0;
    HATCH_TEST_OK(hatch_pieces_cut(face, view, keep, list, &err), &err);
}

/* Returns twice the signed area in the x-y plane. */
static double area_of(const struct hatch_piece_corner corner[3])
{
    double a[2], b[2];
    for (int k = 0; k < 2; k++) {
        a[k] = hatch_pair_round(hatch_pair_sub(corner[1].at[k], corner[0].at[k]));
        b[k] = hatch_pair_round(hatch_pair_sub(corner[2].at[k], corner[0].at[k]));
    }
    return a[0] * b[1] - a[1] * b[0];
}

static double part(uint64_t stream, uint64_t index)
{
    return 2 * (double)hatch_random_unit(7, stream, index) - 1;
}

/* Makes a face in front of the eye, inside the picture. */
static void random_face(uint64_t number, double at[3][3])
{
    for (int i = 0; i < 9; i++)
        at[i / 3][i % 3] = part(number, (uint64_t)i);
    for (int i = 0; i < 3; i++)
        at[i][2] = -0.05 - fabs(at[i][2]) * exp2(-10 * fabs(at[i][1]));
}

START_TEST(pieces_are_the_face)
{
    for (uint64_t number = 0; number < 40; number++) {
        double at[3][3], sum = 0, whole;
        struct hatch_piece_corner face[3];
        random_face(number, at);
        make_face((const double(*)[3])at, face);
        whole = area_of(face);
        cut((const double(*)[3])at, &wide, &lists[0]);
        ck_assert_uint_gt(lists[0].count, 0);
        for (uint32_t i = 0; i < lists[0].count; i++) {
            double piece = area_of(lists[0].corners[i]);
            ck_assert_double_gt(piece / whole, 0); /* winding as the face */
            sum += piece;
        }
        ck_assert_double_eq_tol(sum / whole, 1, 1e-12);
    }
}
END_TEST

/* Every corner is the sum of the face's corners times its weights, to the last bit of a pair. */
START_TEST(corners_are_exact)
{
    double at[3][3] = {{-1, -0x1p-40, 1}, {0.9, -0x1p-41, 0.5}, {0.1, -0x1p-40, -1}};
    struct hatch_piece_corner face[3];
    make_face((const double(*)[3])at, face);
    cut((const double(*)[3])at, &wide, &lists[0]);
    ck_assert_uint_gt(lists[0].count, 100);
    for (uint32_t i = 0; i < 3 * lists[0].count; i++) {
        const struct hatch_piece_corner *corner = &lists[0].corners[i / 3][i % 3];
        struct hatch_pair uv = {0, 0};
        ck_assert(corner->weight[0] + corner->weight[1] + corner->weight[2] == 1);
        for (int k = 0; k < 3; k++)
            uv = hatch_pair_add(uv, hatch_pair_scale(face[k].place[0], corner->weight[k]));
        ck_assert(fabs(hatch_pair_round(hatch_pair_sub(uv, corner->place[0]))) <= 0x1p-100);
    }
}
END_TEST

static bool same(const struct hatch_piece_corner *a, const struct hatch_piece_corner *b)
{
    for (int k = 0; k < 3; k++)
        if (!(a->at[k].high == b->at[k].high && a->at[k].low == b->at[k].low))
            return false;
    return true;
}

static bool has_corner(const struct list *list, const struct hatch_piece_corner *corner)
{
    for (uint32_t i = 0; i < 3 * list->count; i++)
        if (same(&list->corners[i / 3][i % 3], corner))
            return true;
    return false;
}

/* Two faces share an edge near the eye: on it their corners are equal, bit by bit. */
START_TEST(neighbours_meet_corner_to_corner)
{
    for (uint64_t number = 0; number < 30; number++) {
        double a[3] = {part(number, 20), part(number, 21), -0.3}, b[3] = {0, 0, 0};
        double gap = exp2(-0.4 * (double)number - 3);
        for (int k = 0; k < 3; k++)
            b[k] = -a[k] - (k == 2 ? gap : 0); /* the edge is at about half the gap from the eye */
        const double faces[2][3][3] = {{{a[0], a[1], a[2]}, {b[0], b[1], b[2]}, {part(number, 22), 1, -1}},
                                       {{part(number, 23), -1, -1}, {b[0], b[1], b[2]}, {a[0], a[1], a[2]}}};
        uint32_t shared = 0;
        for (int i = 0; i < 2; i++)
            cut(faces[i], &wide, &lists[i]);
        for (int i = 0; i < 2; i++)
            for (uint32_t k = 0; k < 3 * lists[i].count; k++) {
                const struct hatch_piece_corner *corner = &lists[i].corners[k / 3][k % 3];
                bool on_edge = corner->weight[i ? 0 : 2] == 0 && corner->at[2].high < -0x1p-45;
                shared += on_edge;
                ck_assert(!on_edge || has_corner(&lists[1 - i], corner));
            }
        ck_assert_uint_gt(shared, 10);
    }
}
END_TEST

/* A face of size 1 at a distance of 2^-octave has a few tens of pieces per octave, each no longer than twice its
 * distance. */
START_TEST(pieces_stay_few)
{
    const struct hatch_piece_view narrow = {.low = {-0.3, -0.3}, .high = {0.3, 0.3}, .near = 0x1p-60, .ratio = 2};
    for (int octave = 0; octave <= 50; octave += 10) {
        double d = exp2(-octave);
        const double at[3][3] = {{-1, -d, 1}, {1, -d, 1}, {0.1, -0.5 * d, -1}};
        cut(at, &wide, &lists[0]);
        ck_assert_uint_le(lists[0].count, 60 * ((unsigned)octave + 1));
        cut(at, &narrow, &lists[1]);
        ck_assert_uint_le(lists[1].count, 30 * ((unsigned)octave + 1));
        ck_assert_uint_le(lists[1].count, lists[0].count);
    }
}
END_TEST

/* The eye in the face, at a corner, on an edge; a face without area; a face behind the eye. */
START_TEST(recursion_ends_for_degenerate_positions)
{
    static const double faces[][3][3] = {
        {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}},
        {{0, 0, 0}, {1, 0, -1}, {0, 1, -1}},
        {{-1, 0, -1}, {1, 0, 1}, {0, 1, -1}},
        {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
        {{-1, 0, -1}, {0, 0, 0}, {1, 0, 1}},
        {{-1, -1, 1}, {1, -1, 1}, {0, 1, 2}},
        {{-1, 1e-7, 1}, {0, 1.1e-7, 0.5e-7}, {1, 1e-7, -1}},
        {{-1e30, 0, -1}, {1e30, 0, 1}, {0, 1e30, -1}},
    };
    for (size_t i = 0; i < sizeof faces / sizeof *faces; i++) {
        cut(faces[i], &wide, &lists[0]);
        ck_assert_msg(lists[0].count < 4000, "face %zu: %u pieces", i, lists[0].count);
    }
    cut(faces[5], &wide, &lists[0]);
    ck_assert_uint_eq(lists[0].count, 0); /* behind the eye */
}
END_TEST

START_TEST(distance_is_to_the_nearest_point)
{
    const double over[3][3] = {{-1, -1, 3}, {1, -1, 3}, {0, 1, 3}};
    const double beside[3][3] = {{1, 2, 0}, {1, -2, 0}, {5, 0, 1}};
    const double beyond[3][3] = {{3, 4, 0}, {4, 4, 0}, {3, 5, 0}};
    ck_assert_double_eq_tol(hatch_piece_distance(over), 3, 1e-15);
    ck_assert_double_eq_tol(hatch_piece_distance(beside), 1, 1e-15);
    ck_assert_double_eq_tol(hatch_piece_distance(beyond), 5, 1e-15);
}
END_TEST

START_TEST(fixed_point_holds_every_bit)
{
    static const double highs[] = {0, 0.75, -0.75, 5.5, -1e6 - 0.125, 0x1p61, -0x1p61, 0x1p-64, -0x1p-64, 0.1};
    for (size_t i = 0; i < sizeof highs / sizeof *highs; i++)
        for (int more = -1; more <= 1; more++) {
            struct hatch_pair a = hatch_pair_sum(highs[i], more * 0x1p-62), back = {0, 0};
            uint32_t words[4];
            struct hatch_pair rest = hatch_piece_fixed(a, words);
            for (int k = 0; k < 4; k++)
                back = hatch_pair_add(
                    back, hatch_pair_of(ldexp(k == 3 ? (double)(int32_t)words[k] : (double)words[k], 32 * k - 64)));
            ck_assert(rest.high >= 0 && rest.high < 0x1p-64);
            ck_assert_double_eq(hatch_pair_round(hatch_pair_sub(hatch_pair_add(back, rest), a)), 0);
        }
}
END_TEST

START_TEST(pairs_have_twice_the_digits)
{
    for (uint64_t i = 0; i < 200; i++) {
        struct hatch_pair a = hatch_pair_sum(part(i, 0), 0x1p-60 * part(i, 1));
        struct hatch_pair b = hatch_pair_sum(part(i, 2), 0x1p-60 * part(i, 3));
        struct hatch_pair one = hatch_pair_add(a, b), other = hatch_pair_add(b, a);
        ck_assert(one.high == other.high && one.low == other.low);
        ck_assert(hatch_pair_round(hatch_pair_sub(hatch_pair_sub(one, a), b)) == 0);
        struct hatch_pair again = hatch_pair_mul(hatch_pair_div(a, b), b);
        ck_assert_double_le(fabs(hatch_pair_round(hatch_pair_sub(again, a))), 0x1p-98 * fabs(a.high));
        struct hatch_pair floored = hatch_pair_floor(a), left = hatch_pair_sub(a, floored);
        ck_assert(left.high >= 0 && left.high < 1.0000001 && floored.high == floor(floored.high));
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("mesh pieces");
    TCase *tests = tcase_create("pieces");
    tcase_add_test(tests, pieces_are_the_face);
    tcase_add_test(tests, corners_are_exact);
    tcase_add_test(tests, neighbours_meet_corner_to_corner);
    tcase_add_test(tests, pieces_stay_few);
    tcase_add_test(tests, recursion_ends_for_degenerate_positions);
    tcase_add_test(tests, distance_is_to_the_nearest_point);
    tcase_add_test(tests, fixed_point_holds_every_bit);
    tcase_add_test(tests, pairs_have_twice_the_digits);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
