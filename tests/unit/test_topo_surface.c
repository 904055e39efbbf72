#include "fail_alloc.h"
#include "mesh/shapes.h"
#include "surface_check.h"

static struct hatch_arena keep, scratch;
static struct hatch_err err;

static void begin(void)
{
    hatch_arena_init(&keep, (size_t)1 << 30);
    hatch_arena_init(&scratch, (size_t)1 << 30);
}

static void end(void)
{
    hatch_arena_free(&scratch);
    hatch_arena_free(&keep);
}

static struct hatch_mesh shape(enum hatch_shape kind, uint32_t faces)
{
    struct hatch_mesh mesh;
    const struct hatch_shape_options options = {.faces = faces};
    HATCH_TEST_OK(hatch_shape_make(kind, &options, &keep, &scratch, &mesh, &err), &err);
    return mesh;
}

static struct hatch_surface make(const struct hatch_mesh *mesh, struct hatch_surface_notes *notes)
{
    struct hatch_surface surface;
    HATCH_TEST_OK(hatch_surface_make(mesh, &keep, &scratch, &surface, notes, &err), &err);
    surface_check(mesh, &surface);
    return surface;
}

START_TEST(shapes_have_their_euler_characteristic)
{
    static const struct {
        enum hatch_shape shape;
        uint32_t components;
        int euler;
        uint32_t loops;
    } want[] = {{HATCH_SHAPE_SPHERE, 1, 2, 0}, {HATCH_SHAPE_ELLIPSOID, 1, 2, 0},
                {HATCH_SHAPE_TORUS, 1, 0, 0},  {HATCH_SHAPE_CYLINDER, 1, 0, 2},
                {HATCH_SHAPE_CONE, 1, 1, 1},   {HATCH_SHAPE_PLANE, 1, 1, 1}};
    for (size_t i = 0; i < sizeof want / sizeof *want; i++) {
        struct hatch_mesh mesh = shape(want[i].shape, 1000);
        struct hatch_surface_notes notes;
        struct hatch_surface s = make(&mesh, &notes);
        ck_assert_uint_eq(s.component_count, want[i].components);
        ck_assert_int_eq(s.components[0].euler, want[i].euler);
        ck_assert_uint_eq(s.components[0].border_loops, want[i].loops);
        ck_assert(s.components[0].orientable);
        ck_assert_uint_eq(notes.flipped + notes.degenerate + notes.duplicate + notes.contrary, 0);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("topo surface");
    TCase *tests = tcase_create("surface");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, shapes_have_their_euler_characteristic);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
