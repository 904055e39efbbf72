/* The linear systems of patches. */
#include "lapped/work.h"
#include "lapped_make.h"

enum { RIM = 500, FACES = 2 * RIM, VERTICES = FACES + 1 };

/* A flat star, somewhat wider than high, whose hub is vertex 0; its other vertices are numbered at random. */
struct star {
    double at[VERTICES][2], xy[VERTICES][2], flattened[FACES][4];
    uint32_t corners[FACES][3], faces[FACES];
    uint8_t singular[FACES];
    int8_t sign[FACES];
};

static void number_at_random(uint32_t number[VERTICES])
{
    for (uint32_t v = 0; v < VERTICES; v++)
        number[v] = v;
    for (uint32_t v = VERTICES - 1; v > 1; v--) {
        uint32_t other = 1 + (uint32_t)(hatch_random_unit(3, 0, v) * (float)v), was = number[v];
        number[v] = number[other];
        number[other] = was;
    }
}

static void make_star(struct star *star)
{
    uint32_t number[VERTICES];
    number_at_random(number);
    for (uint32_t i = 0; i < RIM; i++) {
        uint32_t next = (i + 1) % RIM, tip = 1 + RIM + i;
        const uint32_t inner[3] = {0, 1 + i, 1 + next}, outer[3] = {1 + next, 1 + i, tip};
        for (uint32_t c = 0; c < 3; c++) {
            star->corners[i][c] = number[inner[c]];
            star->corners[RIM + i][c] = number[outer[c]];
        }
        for (uint32_t v = 1 + i; v <= tip; v += RIM) {
            double angle = 2 * PI * (v == tip ? i + 0.5 : i) / RIM, radius = v == tip ? 2 : 1;
            star->at[number[v]][0] = 1.1 * radius * cos(angle);
            star->at[number[v]][1] = radius * sin(angle);
        }
    }
    for (uint32_t f = 0; f < FACES; f++) {
        const uint32_t *corner = star->corners[f];
        star->faces[f] = f;
        star->sign[f] = 1;
        for (int i = 0; i < 4; i++)
            star->flattened[f][i] = star->at[corner[1 + i / 2]][i % 2] - star->at[corner[0]][i % 2];
    }
    memcpy(star->xy, star->at, sizeof star->xy);
}

/* Returns the number of entries between the first of each row and the diagonal, with the vertices in reverse order. */
static uint64_t reverse_envelope(const struct star *star)
{
    uint32_t first[VERTICES];
    uint64_t size = 0;
    for (uint32_t v = 0; v < VERTICES; v++)
        first[v] = v;
    for (uint32_t i = 0; i < 9 * FACES; i++) {
        const uint32_t *corner = star->corners[i / 9];
        uint32_t row = VERTICES - 1 - corner[i % 3], column = VERTICES - 1 - corner[i / 3 % 3];
        first[row] = column < first[row] ? column : first[row];
    }
    for (uint32_t v = 0; v < VERTICES; v++)
        size += v - first[v] + 1;
    return size;
}

static struct star star;
static struct hatch_patch_domain domain;
static struct hatch_patch patch;
static struct hatch_solver solver;

static void begin_star(void)
{
    begin();
    make_star(&star);
    domain = (struct hatch_patch_domain){.flattened = star.flattened[0], .singular = star.singular};
    patch = (struct hatch_patch){.face_count = FACES,
                                 .vertex_count = VERTICES,
                                 .faces = star.faces,
                                 .corners = star.corners[0],
                                 .sign = star.sign,
                                 .xy = star.xy[0]};
    solver = (struct hatch_solver){.arena = &keep};
    HATCH_TEST_OK(hatch_solver_solve(&solver, &domain, &patch, &err), &err);
}

START_TEST(the_shortest_envelope_is_chosen)
{
    uint64_t size = 0, reverse = reverse_envelope(&star);
    for (uint32_t v = 0; v < VERTICES; v++)
        size += v - solver.first_column[v] + 1;
    ck_assert_msg(size < reverse / 2, "%lu entries, in reverse order %lu", size, reverse);
    for (uint32_t v = 0; v < VERTICES; v++)
        for (int i = 0; i < 2; i++)
            ck_assert_double_eq_tol(star.xy[v][i], star.at[v][i], 1e-9);
}
END_TEST

/* The arrays fit into the arena before the factors fit beside them. */
START_TEST(factors_keep_to_the_limit_of_the_arena)
{
    enum hatch_status status = HATCH_LIMIT;
    bool met = false;
    const size_t limit = keep.limit_bytes;
    for (keep.limit_bytes = keep.used_bytes; status != HATCH_OK; keep.limit_bytes += 1024) {
        struct hatch_sparse_solver made = {.column = NULL};
        struct hatch_arena_mark mark = hatch_arena_mark(&keep);
        status = hatch_sparse_solver_make(&solver, &patch, &made, &err);
        met = met || (status == HATCH_LIMIT &&
                      strncmp(err.text, "out of memory for the factors of a patch of 1001 vertices, ", 59) == 0);
        ck_assert(keep.limit_bytes < limit);
        hatch_sparse_solver_free(&made);
        hatch_arena_rewind(&keep, mark);
    }
    ck_assert(met);
}
END_TEST

/* Faces of negative weight make a matrix that has no factors, whatever is added to its diagonal. */
START_TEST(a_patch_without_solution_is_refused)
{
    struct hatch_sparse_solver made = {.column = NULL};
    for (uint32_t f = 0; f < FACES; f++)
        solver.gradients[8 * f + 6] = -1;
    ck_assert_int_eq(hatch_sparse_solver_make(&solver, &patch, &made, &err), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "no solution for a patch of 1001 vertices: want a smaller size");
    hatch_sparse_solver_free(&made);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("lapped solve");
    TCase *tests = tcase_create("solve");
    tcase_add_checked_fixture(tests, begin_star, end);
    tcase_add_test(tests, the_shortest_envelope_is_chosen);
    tcase_add_test(tests, factors_keep_to_the_limit_of_the_arena);
    tcase_add_test(tests, a_patch_without_solution_is_refused);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
