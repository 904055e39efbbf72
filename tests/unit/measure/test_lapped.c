/* Lapped textures of few patches, whose figures are known. */
#include <math.h>
#include <string.h>

#include "arenas.h"
#include "fail_alloc.h"
#include "math/vector.h"
#include "measure/lapped_figures.h"
#include "measure/stretch.h"

#define SAMPLES 200000
#define SIDE 64u

static struct hatch_scene scene;
static struct hatch_scene_mesh patches[4];
static struct hatch_node nodes[2];
static struct hatch_material material = {.base.texture = 0, .base.texcoord = 1, .outline = true};
static struct hatch_image masks[1];
static struct hatch_lapped_figures figures;

/* A unit square of two faces, split by x = y: face 0 below it, face 1 above. */
static const float corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
static const uint32_t faces[2][3] = {{0, 1, 2}, {0, 2, 3}};

/* A patch on some of the faces. */
struct made {
    uint32_t first, count;       /* faces */
    double u_of_x, v_of_y;       /* derivatives of the texture coordinates */
    double mask_from, mask_size; /* mask coordinates: from + size * (x, y) */
    double field_deg;
};

static void add_patch(const struct made *from)
{
    struct hatch_mesh *mesh = &patches[scene.mesh_count++].mesh;
    float *uv, *mask, *field;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 4, from->count, mesh, &err), &err);
    HATCH_TEST_OK(hatch_mesh_add(&keep, mesh, "TEXCOORD_0", 2, &uv, &err), &err);
    HATCH_TEST_OK(hatch_mesh_add(&keep, mesh, "TEXCOORD_1", 2, &mask, &err), &err);
    HATCH_TEST_OK(hatch_mesh_add(&keep, mesh, "_HATCH_DIR", 4, &field, &err), &err);
    for (uint32_t i = 0; i < from->count * 3; i++) /* each patch begins at another corner */
        mesh->indices[i] = faces[from->first + i / 3][(i + scene.mesh_count) % 3];
    double angle = from->field_deg * 3.14159265358979323846 / 180;
    for (uint32_t v = 0; v < 4; v++) {
        double x = (double)corners[v][0], y = (double)corners[v][1];
        memcpy(&mesh->attributes[0].data[3 * v], corners[v], sizeof corners[v]);
        uv[2 * v] = (float)(from->u_of_x * x);
        uv[2 * v + 1] = (float)(from->v_of_y * y);
        mask[2 * v] = (float)(from->mask_from + from->mask_size * x);
        mask[2 * v + 1] = (float)(from->mask_from + from->mask_size * y);
        field[4 * v] = (float)cos(angle) * (v % 2 ? -1 : 1); /* lines have no sign */
        field[4 * v + 1] = (float)sin(angle) * (v % 2 ? -1 : 1);
        field[4 * v + 3] = 1;
    }
    nodes[0].mesh_count = scene.mesh_count;
}

static void begin_patches(void)
{
    begin();
    memset(nodes, 0, sizeof nodes);
    memset(patches, 0, sizeof patches);
    scene = (struct hatch_scene){.node_count = 1,
                                 .material_count = 1,
                                 .texture_count = 1,
                                 .meshes = patches,
                                 .nodes = nodes,
                                 .materials = &material};
    /* Opaque in the left half. */
    HATCH_TEST_OK(hatch_image_make(&keep, SIDE, SIDE, "YA", &masks[0], &err), &err);
    for (uint32_t i = 0; i < SIDE * SIDE; i++)
        masks[0].pixels[2 * i + 1] = i % SIDE < SIDE / 2;
}

static void measure(void)
{
    HATCH_TEST_OK(hatch_measure_lapped(&scene, masks, SAMPLES, 1, NULL, &scratch, &figures, &err), &err);
}

static const struct made plain = {0, 2, 3, -3, 0, 1, 0};
static const struct made first_face = {0, 1, 3, -3, 0.1, 0.2, 0}; /* in the opaque half of the mask */

START_TEST(half_a_mask_covers_half)
{
    add_patch(&plain);
    measure();
    ck_assert_uint_eq(figures.patches, 1);
    ck_assert_uint_eq(figures.faces, 2);
    ck_assert_double_eq(figures.overlap, 1);
    /* Opacity is 1 up to the centre of the last opaque texel. */
    double want = (SIDE / 2 - 0.5) / SIDE;
    ck_assert_double_eq_tol(figures.covered, want, 0.004);
    ck_assert_double_eq(figures.opacity_min, 0);
    ck_assert_uint_eq(figures.hidden, 0);
}
END_TEST

START_TEST(a_mask_without_alpha_covers_all)
{
    HATCH_TEST_OK(hatch_image_make(&keep, 4, 4, "Y", &masks[0], &err), &err);
    add_patch(&plain);
    measure();
    ck_assert_double_eq(figures.covered, 1);
    ck_assert_double_eq(figures.opacity_min, 1);
}
END_TEST

/* Beyond the border the mask continues its border: transparent to the right, opaque to the left. */
START_TEST(masks_are_clamped)
{
    struct made left = plain, right = plain;
    left.mask_from = -5;
    right.mask_from = 1.5;
    add_patch(&right);
    measure();
    ck_assert_double_eq(figures.covered, 0);
    add_patch(&left);
    measure();
    ck_assert_double_eq(figures.covered, 1);
}
END_TEST

START_TEST(two_patches_cover_the_union)
{
    add_patch(&plain);
    add_patch(&first_face);
    measure();
    ck_assert_uint_eq(figures.faces, 2);
    ck_assert_uint_eq(figures.patch_faces, 3);
    ck_assert_double_eq(figures.overlap, 1.5);
    double c = (SIDE / 2 - 0.5) / SIDE; /* and of the face above x = y, the part left of c */
    ck_assert_double_eq_tol(figures.covered, 0.5 + c - c * c / 2, 0.004);
}
END_TEST

/* Opacities of 1/2 compose to 3/4, which does not count as covered. */
START_TEST(opacities_compose)
{
    for (uint32_t i = 0; i < SIDE * SIDE; i++)
        masks[0].pixels[2 * i + 1] = 0.5f;
    add_patch(&plain);
    add_patch(&plain);
    measure();
    ck_assert_double_eq(figures.covered, 0);
    ck_assert_double_eq(figures.opacity_min, 0.75);
}
END_TEST

/* One is opaque on the left, the other on the right. */
START_TEST(complements_cover_all)
{
    struct made right = plain;
    right.mask_from = 0.9;
    right.mask_size = -1;
    add_patch(&plain);
    add_patch(&right);
    measure();
    ck_assert_double_eq(figures.covered, 1);
}
END_TEST

START_TEST(a_patch_under_an_opaque_one_is_hidden)
{
    struct made half = first_face;
    half.mask_from = 0;
    half.mask_size = 1;
    add_patch(&half);
    add_patch(&first_face);
    measure();
    ck_assert_uint_eq(figures.hidden, 1);
    ck_assert_double_eq(figures.covered, 1);
    ck_assert_double_eq(figures.overlap, 2);
    add_patch(&half); /* visible, since drawn last */
    measure();
    ck_assert_uint_eq(figures.hidden, 1);
}
END_TEST

/* A face of which the texture is a line or a point is stretched without bound, and u has no direction on it. */
START_TEST(a_face_whose_texture_has_no_area_has_no_direction)
{
    static const float textures[][6] = {{0, 0, 1, 1, 2, 2}, {0, 0, 1, 0, 2, 0}, {3, 3, 3, 3, 3, 3}};
    struct hatch_mesh triangle;
    struct hatch_stretch stretch;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 3, 1, &triangle, &err), &err);
    static const float at[9] = {0, 0, 0, 2, 0, 0, 0, 1, 0};
    memcpy(triangle.attributes[0].data, at, sizeof at);
    for (uint32_t i = 0; i < 3; i++)
        triangle.indices[i] = i;
    for (size_t i = 0; i < sizeof textures / sizeof *textures; i++) {
        ck_assert(hatch_measure_stretch(&triangle, textures[i], 0, &stretch));
        ck_assert(isinf(stretch.ratio) && stretch.uv_area == 0);
        ck_assert_double_eq(hatch_vec_length(stretch.u), 0);
    }
}
END_TEST

START_TEST(stretch_is_the_ratio_of_singular_values)
{
    struct made wide = plain;
    wide.u_of_x = 7.5;
    add_patch(&wide);
    measure();
    for (int i = 0; i < HATCH_LAPPED_SHARES; i++) {
        ck_assert_double_eq_tol(figures.stretch[i], 2.5, 1e-12);
        ck_assert_double_eq_tol(figures.area[i], 1, 1e-12);
    }
    /* Two faces have stretch 2.5, one has 1; their texture areas per area are 22.5, 22.5 and 9, mean 18. */
    add_patch(&first_face);
    measure();
    ck_assert_double_eq_tol(figures.stretch[HATCH_LAPPED_P50], 2.5, 1e-12);
    ck_assert_double_eq_tol(figures.area[HATCH_LAPPED_P50], 22.5 / 18, 1e-12);
    ck_assert_double_eq_tol(figures.area[HATCH_LAPPED_MAX], 2, 1e-12);
}
END_TEST

START_TEST(mirrored_and_flat_faces_are_flipped)
{
    struct made mirrored = plain, flat = first_face;
    mirrored.v_of_y = 3;
    flat.u_of_x = 0;
    add_patch(&plain);
    measure();
    ck_assert_uint_eq(figures.flipped, 0);
    add_patch(&mirrored);
    add_patch(&flat);
    measure();
    ck_assert_uint_eq(figures.flipped, 3);
    ck_assert_double_eq_tol(figures.stretch[HATCH_LAPPED_MAX], 1,
                            1e-12); /* a face without texture area has no stretch */
}
END_TEST

START_TEST(angles_are_measured_to_rising_u)
{
    struct made turned = plain;
    turned.field_deg = 10;
    add_patch(&turned);
    measure();
    for (int i = 0; i < HATCH_LAPPED_SHARES; i++)
        ck_assert_double_eq_tol(figures.angle_deg[i], 10, 1e-5);
    patches[0].mesh.attribute_count--; /* removes _HATCH_DIR */
    measure();
    ck_assert_double_nan(figures.angle_deg[HATCH_LAPPED_P50]);
}
END_TEST

/* A corner whose direction is zero counts for nothing: the angle is that of the others. */
START_TEST(corners_without_a_direction_are_left_out)
{
    struct made turned = plain;
    turned.field_deg = 10;
    add_patch(&turned);
    memset(hatch_mesh_find(&patches[0].mesh, "_HATCH_DIR", 4), 0, 3 * sizeof(float));
    measure();
    ck_assert_double_eq_tol(figures.angle_deg[HATCH_LAPPED_P50], 10, 1e-5);
    ck_assert_double_eq_tol(figures.angle_deg[HATCH_LAPPED_MAX], 10, 1e-5);
}
END_TEST

/* Two faces of area 1/2 at 0 degrees, one of a sixteenth of that at 30 degrees. */
START_TEST(angles_are_also_weighted_by_area)
{
    struct made small = first_face;
    small.field_deg = 30;
    add_patch(&plain);
    add_patch(&small);
    float *at = hatch_mesh_find(&patches[1].mesh, "POSITION", 3);
    for (uint32_t i = 0; i < 12; i++)
        at[i] /= 4;
    measure();
    ck_assert_double_eq_tol(figures.angle_deg[HATCH_LAPPED_P50], 0, 1e-5);
    ck_assert_double_eq_tol(figures.angle_deg[HATCH_LAPPED_P95], 30, 1e-5);
    ck_assert_double_eq_tol(figures.angle_area_deg[HATCH_LAPPED_P95], 0, 1e-5);
    ck_assert_double_eq_tol(figures.angle_area_deg[HATCH_LAPPED_P99], 30, 1e-5);
}
END_TEST

/* In a sheared square the direction in which u rises and v is constant is not the gradient of u. */
START_TEST(rising_u_keeps_v_constant)
{
    add_patch(&plain);
    float *uv = hatch_mesh_find(&patches[0].mesh, "TEXCOORD_0", 2);
    float *field = hatch_mesh_find(&patches[0].mesh, "_HATCH_DIR", 4);
    for (uint32_t v = 0; v < 4; v++) {
        uv[2 * v + 1] = corners[v][0] - corners[v][1];
        field[4 * v] = field[4 * v + 1] = 1;
    }
    measure();
    ck_assert_double_eq_tol(figures.angle_deg[HATCH_LAPPED_MAX], 0, 1e-5);
}
END_TEST

START_TEST(coincident_meshes_of_two_nodes_stay_separate)
{
    add_patch(&first_face);
    add_patch(&first_face);
    nodes[0].mesh_count = 1;
    nodes[1] = (struct hatch_node){.first_mesh = 1, .mesh_count = 1};
    scene.node_count = 2;
    measure();
    ck_assert_uint_eq(figures.faces, 2);
    ck_assert_double_eq(figures.overlap, 1);
}
END_TEST

START_TEST(scenes_without_patches_are_refused)
{
    add_patch(&plain);
    struct hatch_lapped_figures before = figures;
    struct hatch_mesh full = patches[0].mesh;
    patches[0].mesh.attribute_count = 2;
    ck_assert_int_eq(hatch_measure_lapped(&scene, masks, 1, 1, NULL, &scratch, &figures, &err), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "patch 0: no TEXCOORD_0 or no TEXCOORD_1");
    patches[0].mesh = full;
    masks[0].pixels = NULL;
    ck_assert_int_eq(hatch_measure_lapped(&scene, masks, 1, 1, NULL, &scratch, &figures, &err), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "patch 0: no outline (alpha mask)");
    patches[0].material = HATCH_NONE;
    ck_assert_int_eq(hatch_measure_lapped(&scene, masks, 1, 1, NULL, &scratch, &figures, &err), HATCH_BAD_INPUT);
    ck_assert_msg(strstr(err.text, "no patches") != NULL, "%s", err.text);
    ck_assert_mem_eq(&before, &figures, sizeof before);
}
END_TEST

static enum hatch_status measure_one(void *context, struct hatch_arena *kept, struct hatch_arena *temporary,
                                     struct hatch_err *error)
{
    (void)context;
    HATCH_TRY(hatch_arena_array(kept, 1, 1, error) ? HATCH_OK : HATCH_LIMIT);
    return hatch_measure_lapped(&scene, masks, 10, 1, NULL, temporary, &figures, error);
}

START_TEST(every_failed_allocation_is_a_limit)
{
    add_patch(&plain);
    hatch_test_fail_alloc(measure_one, NULL, &figures, sizeof figures);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("measure lapped");
    TCase *tests = tcase_create("lapped");
    tcase_add_checked_fixture(tests, begin_patches, end);
    tcase_add_test(tests, half_a_mask_covers_half);
    tcase_add_test(tests, a_mask_without_alpha_covers_all);
    tcase_add_test(tests, masks_are_clamped);
    tcase_add_test(tests, two_patches_cover_the_union);
    tcase_add_test(tests, opacities_compose);
    tcase_add_test(tests, complements_cover_all);
    tcase_add_test(tests, a_patch_under_an_opaque_one_is_hidden);
    tcase_add_test(tests, a_face_whose_texture_has_no_area_has_no_direction);
    tcase_add_test(tests, stretch_is_the_ratio_of_singular_values);
    tcase_add_test(tests, mirrored_and_flat_faces_are_flipped);
    tcase_add_test(tests, angles_are_measured_to_rising_u);
    tcase_add_test(tests, corners_without_a_direction_are_left_out);
    tcase_add_test(tests, angles_are_also_weighted_by_area);
    tcase_add_test(tests, rising_u_keeps_v_constant);
    tcase_add_test(tests, coincident_meshes_of_two_nodes_stay_separate);
    tcase_add_test(tests, scenes_without_patches_are_refused);
    tcase_add_test(tests, every_failed_allocation_is_a_limit);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
