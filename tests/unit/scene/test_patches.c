/* Patches joined to one mesh. */
#include "fail_alloc.h"
#include "lapped_scene.h"
#include "meshes.h"

static struct hatch_scene scene;
static struct hatch_patch_mesh *patches;

static uint32_t layer_of(const struct hatch_patch_mesh *from, const struct hatch_mesh *mesh, uint32_t patch)
{
    uint32_t layer = 0;
    for (uint32_t i = 0; i < 3 * mesh->face_count; i++) {
        while (i >= from->layer_end[layer])
            layer++;
        if (mesh->indices[i] >= from->first_vertex[patch] && mesh->indices[i] < from->first_vertex[patch + 1])
            return layer;
    }
    ck_abort_msg("patch %u has no face", patch);
    return 0;
}

/* Returns whether two patches share a face, by the faces' centres. */
static bool overlap(uint32_t a, uint32_t b, const struct hatch_mesh *sphere)
{
    for (size_t f = 0; f < sphere->face_count; f++) {
        double middle[3];
        middle_of(sphere, f, middle);
        if (cap_holds(a, middle) && cap_holds(b, middle))
            return true;
    }
    return false;
}

START_TEST(joined_patches_are_the_surface)
{
    struct hatch_mesh sphere = shape_of(HATCH_SHAPE_SPHERE, 500);
    lapped_scene(&sphere, &caps, &keep, &scene);
    HATCH_TEST_OK(hatch_patches_join(&scene, &keep, &scratch, &patches, NULL, &err), &err);
    ck_assert_uint_eq(scene.mesh_count, 1);
    ck_assert_uint_eq(scene.nodes[0].mesh_count, 1);
    ck_assert_uint_eq(patches[0].patch_count, CAPS);
    const struct hatch_mesh *joined = &scene.meshes[0].mesh, *surface = &patches[0].surface;
    ck_assert_uint_eq(surface->face_count, sphere.face_count);
    ck_assert_uint_gt(joined->face_count, surface->face_count);
    for (uint32_t v = 0; v < surface->vertex_count; v++)
        ck_assert_mem_eq(surface->attributes[0].data + 3 * v, joined->attributes[0].data + 3 * patches[0].vertex_of[v],
                         3 * sizeof(float));
    ck_assert_uint_eq(patches[0].layer_end[patches[0].layer_count - 1], 3 * joined->face_count);
    for (uint32_t a = 0; a < CAPS; a++)
        for (uint32_t b = a + 1; b < CAPS; b++)
            if (overlap(a, b, &sphere))
                ck_assert_uint_lt(layer_of(&patches[0], joined, a), layer_of(&patches[0], joined, b));
}
END_TEST

static enum hatch_status join(void *context, struct hatch_arena *lasting, struct hatch_arena *temporary,
                              struct hatch_err *why)
{
    struct hatch_scene *given = context, before = *given;
    struct hatch_node node = given->nodes[0];
    enum hatch_status status = hatch_patches_join(given, lasting, temporary, &patches, NULL, why);
    if (status == HATCH_OK) {
        *given = before;
        given->nodes[0] = node;
    }
    return status;
}

START_TEST(joining_survives_every_failed_allocation)
{
    struct hatch_mesh sphere = shape_of(HATCH_SHAPE_SPHERE, 100);
    lapped_scene(&sphere, &caps, &keep, &scene);
    ck_assert_uint_gt(hatch_test_fail_alloc(join, &scene, &scene, sizeof scene), 20);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("patches");
    TCase *tests = tcase_create("patches");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, joined_patches_are_the_surface);
    tcase_add_test(tests, joining_survives_every_failed_allocation);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
