#include "io/gltf/gltf.h"
#include "mesh.h"

/* A companion file of 64 zeros for any name. */
static enum hatch_status resolve(void *context, const char *uri, struct hatch_arena *arena, struct hatch_bytes *bytes,
                                 struct hatch_err *err)
{
    (void)context;
    FUZZ_MUST_HOLD(uri[0] != '/');
    uint8_t *data = HATCH_NEW(arena, uint8_t, 64, err);
    if (!data)
        return HATCH_LIMIT;
    *bytes = (struct hatch_bytes){data, 64};
    return HATCH_OK;
}

static const struct hatch_gltf_resolver resolver = {resolve, NULL};

static void use_weights(const struct hatch_scene *scene, uint32_t animation, struct fuzz_arenas *arenas)
{
    struct hatch_err err;
    for (uint32_t n = 0; n < scene->node_count; n++)
        for (uint32_t m = 0; m < scene->nodes[n].mesh_count; m++) {
            uint32_t count = hatch_mesh_target_count(&scene->meshes[scene->nodes[n].first_mesh + m].mesh);
            struct hatch_arena_mark mark = hatch_arena_mark(&arenas->keep);
            double *weights = count ? HATCH_NEW(&arenas->keep, double, count, &err) : NULL;
            if (weights)
                hatch_scene_weights(scene, n, animation, 0.37, count, weights);
            hatch_arena_rewind(&arenas->keep, mark);
        }
}

/* Strokes that were read lie on the faces of their mesh. */
static void use_strokes(const struct hatch_scene_mesh *mesh)
{
    struct hatch_err err;
    float at[3];
    FUZZ_MUST_HOLD(hatch_curves_check(&mesh->curves, &mesh->mesh, &err) == HATCH_OK);
    for (uint32_t c = 0; c < mesh->curves.count; c++) {
        const struct hatch_curve *curve = &mesh->curves.curves[c];
        FUZZ_MUST_HOLD(curve->count >= 2 && curve->first + curve->count <= mesh->curves.point_count);
        for (uint32_t i = 0; i < curve->count; i++)
            hatch_curve_position(&mesh->mesh, &mesh->curves.points[curve->first + i], at);
    }
}

static void use_scene(const struct hatch_scene *scene, struct fuzz_arenas *arenas)
{
    struct hatch_err err;
    struct hatch_mesh mesh;
    for (uint32_t m = 0; m < scene->mesh_count; m++)
        use_strokes(&scene->meshes[m]);
    double *world = HATCH_NEW(&arenas->keep, double, (size_t)scene->node_count * 16, &err);
    for (uint32_t a = 0; world && a < scene->animation_count; a++) {
        hatch_scene_pose(scene, a, 0.37, world);
        use_weights(scene, a, arenas);
    }
    if (world)
        hatch_scene_pose(scene, HATCH_NONE, 0, world);
    for (uint32_t s = 0; world && s < scene->skin_count; s++) {
        size_t count = (size_t)scene->skins[s].joint_count * 16;
        double *joints = HATCH_NEW(&arenas->keep, double, count, &err);
        if (joints)
            hatch_scene_skin(scene, s, world, joints);
    }
    if (hatch_scene_flatten(scene, (const double[3]){0, 0, 0}, false, &arenas->keep, &arenas->scratch, &mesh, &err) ==
        HATCH_OK)
        fuzz_use_mesh(&mesh, arenas);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct fuzz_arenas arenas = fuzz_arenas_make();
    struct hatch_scene scene;
    struct hatch_mesh_notes notes = {0};
    struct hatch_err err = {HATCH_OK, ""};
    enum hatch_status status = hatch_gltf_read((struct hatch_bytes){data, size}, &resolver, &arenas.keep,
                                               &arenas.scratch, &scene, &notes, &err);
    fuzz_check(status, &err, &arenas);
    if (status == HATCH_OK)
        use_scene(&scene, &arenas);
    fuzz_arenas_free(&arenas);
    return 0;
}
