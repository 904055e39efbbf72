#include "cmd_field.h"
#include "cmd_scene.h"
#include "lapped_param.h"

/* What covering a mesh needs and nothing later does. */
struct work {
    struct hatch_arena arena;
    struct hatch_mesh_notes notes;
    struct hatch_surface surface;
    struct hatch_frames frames;
    double *direction, *confidence;
    struct hatch_lapped lapped;
};

/* Makes the mesh what its surface is, with a field and normals, as dirfield would write it: so that with
 * dirfield before it or without the same comes out. */
static void prepare(struct cmd_args *args, struct lapped_param_part *part)
{
    struct hatch_err err;
    struct hatch_mesh mesh;
    uint32_t *vertex_point;
    if (!hatch_mesh_find(&part->mesh->mesh, "_HATCH_DIR", 4)) {
        cmd_add_field(args, part->name, part->surface, part->mesh);
        return;
    }
    cmd_check(hatch_surface_mesh(part->surface, &part->mesh->mesh, &args->keep, &args->scratch, &mesh,
                                 &vertex_point, &err),
              part->name, &err);
    cmd_check(hatch_mesh_add_normals(&args->keep, &args->scratch, &mesh, CMD_CREASE_RAD, &err),
              part->name, &err);
    part->mesh->mesh = mesh;
}

static enum hatch_status make_patches(struct cmd_args *args, const struct lapped_param_options *options,
                                      const struct hatch_outline *outline,
                                      const struct lapped_param_part *part, struct work *work,
                                      struct hatch_err *err)
{
    const struct hatch_mesh *mesh = &part->mesh->mesh;
    struct hatch_surface_notes notes;
    struct hatch_lapped_options how = options->lapped;
    how.size = part->size;
    HATCH_TRY(hatch_surface_make(mesh, &work->arena, &args->scratch, &work->surface, &notes, err));
    HATCH_TRY(hatch_frames_make(&work->surface, &work->arena, &args->scratch, &work->frames, err));
    size_t points = work->surface.point_count;
    work->direction = HATCH_NEW(&work->arena, double, 3 * points, err);
    work->confidence = work->direction ? HATCH_NEW(&work->arena, double, points, err) : NULL;
    if (!work->confidence)
        return HATCH_LIMIT;
    hatch_field_of_mesh(&work->surface, &work->frames, mesh, work->direction, work->confidence);
    return hatch_lapped_make(&work->surface, &work->frames, work->direction, work->confidence, outline, &how,
                             cmd_pool(args), &work->arena, &args->scratch, &work->lapped, err);
}

static enum hatch_status make_meshes(struct cmd_args *args, const struct work *work,
                                     struct lapped_param_part *part, struct hatch_err *err)
{
    const struct hatch_lapped *lapped = &work->lapped;
    part->made = HATCH_NEW(&args->keep, struct hatch_scene_mesh, lapped->patch_count, err);
    if (!part->made)
        return HATCH_LIMIT;
    for (uint32_t p = 0; p < lapped->patch_count; p++) {
        part->made[p] = *part->mesh;
        HATCH_TRY(hatch_lapped_mesh(&work->surface, &part->mesh->mesh, lapped, p, work->direction,
                                    work->confidence, part->tile, &args->keep, &args->scratch,
                                    &part->made[p].mesh, err));
    }
    part->made_count = lapped->patch_count;
    return HATCH_OK;
}

void lapped_param_cover(struct cmd_args *args, const struct lapped_param_options *options,
                        const struct hatch_outline *outline, struct lapped_param_part *part)
{
    struct work work = {.direction = NULL};
    struct hatch_err err;
    hatch_arena_init(&work.arena, args->max_memory);
    prepare(args, part);
    cmd_check(make_patches(args, options, outline, part, &work, &err), part->name, &err);
    cmd_check(make_meshes(args, &work, part, &err), part->name, &err);
    part->patches = work.lapped.patch_count;
    part->patch_faces = work.lapped.face_count;
    part->faces = work.surface.face_count;
    part->cut = work.lapped.cut;
    part->enlarged = work.lapped.enlarged;
    part->hidden = work.lapped.hidden;
    hatch_arena_free(&work.arena);
}
