#include <math.h>
#include <string.h>

#include "shared/field.h"
#include "base/keys.h"
#include "lapped_param.h"
#include "mesh/splits.h"

#define ATLAS_MARGIN (1.0 / 256) /* distance between charts as a share of the atlas: 2 of 512 texels */

/* Data needed only while a mesh is covered. */
struct work {
    struct hatch_arena arena;
    struct hatch_surface surface;
    struct hatch_frames frames;
    struct hatch_lapped_input input;
    struct hatch_lapped lapped;
};

/* Replaces the mesh by its cleaned surface with a direction field and normals, as dirfield writes it by default, so
 * that running dirfield first makes no difference. A mesh with a field comes from a glTF file, whose reader has added
 * normals where there were none. */
static void prepare(struct cmd_args *args, struct lapped_param_part *part)
{
    struct hatch_err err;
    struct hatch_mesh mesh;
    uint32_t *vertex_point;
    if (!hatch_mesh_find(&part->mesh->mesh, "_HATCH_DIR", 4)) {
        cmd_add_field(args, part->name, part->surface, part->mesh);
        return;
    }
    cmd_check(hatch_surface_to_mesh(part->surface, &part->mesh->mesh, &args->keep, &args->scratch, &mesh, &vertex_point,
                                    &err),
              part->name, &err);
    part->mesh->mesh = mesh;
}

/* Returns whether two meshes have the same surface: the same indices and positions. */
static bool same_surface(const struct hatch_mesh *a, const struct hatch_mesh *b)
{
    return a->vertex_count == b->vertex_count && a->face_count == b->face_count &&
           memcmp(a->indices, b->indices, (size_t)a->face_count * 3 * sizeof *a->indices) == 0 &&
           memcmp(a->attributes[0].data, b->attributes[0].data,
                  (size_t)a->vertex_count * 3 * sizeof *a->attributes[0].data) == 0;
}

static enum hatch_status make_patches(struct cmd_args *args, const struct lapped_param_options *options,
                                      const struct lapped_param_part *part, const struct hatch_mesh *source,
                                      struct work *work, struct hatch_err *err)
{
    const struct hatch_mesh *mesh = &part->mesh->mesh;
    struct hatch_surface_notes notes;
    struct hatch_lapped_options lapped_options = options->lapped;
    lapped_options.size = part->size;
    if (same_surface(source, mesh))
        work->surface = *part->surface;
    else
        HATCH_TRY(hatch_surface_make_cut(mesh, &work->arena, &args->scratch, &work->surface, &notes, err));
    HATCH_TRY(hatch_frames_make(&work->surface, &work->arena, &args->scratch, &work->frames, err));
    size_t points = work->surface.point_count;
    double *direction, *confidence;
    HATCH_TRY(HATCH_ALLOC(&work->arena, &direction, 3 * points, err));
    HATCH_TRY(HATCH_ALLOC(&work->arena, &confidence, points, err));
    hatch_field_of_mesh(&work->surface, &work->frames, mesh, direction, confidence);
    work->input.surface = &work->surface;
    work->input.frames = &work->frames;
    work->input.direction = direction;
    work->input.confidence = confidence;
    work->input.mesh = mesh;
    return hatch_lapped_make(&work->input, &lapped_options, cmd_pool(args), &work->arena, &args->scratch, &work->lapped,
                             err);
}

static enum hatch_status make_meshes(struct cmd_args *args, const struct work *work, struct lapped_param_part *part,
                                     struct hatch_err *err)
{
    const struct hatch_lapped *lapped = &work->lapped;
    HATCH_TRY(HATCH_ALLOC(&args->keep, &part->made, lapped->patch_count, err));
    for (uint32_t p = 0; p < lapped->patch_count; p++) {
        part->made[p] = *part->mesh;
        if (p > 0)
            part->made[p].kept = (struct hatch_kept){0}; /* extras are written once */
        HATCH_TRY(hatch_lapped_mesh(&work->input, lapped, p, &args->keep, &args->scratch, &part->made[p].mesh, err));
    }
    part->made_count = lapped->patch_count;
    return HATCH_OK;
}

/* Gives each corner a class: the number of its texture coordinates.
 *   texcoords  2 per corner
 *   places     numbers the different texture coordinates, whose bits are the keys
 *   class_of   out: per corner */
static enum hatch_status find_classes(const float *texcoords, size_t corner_count, struct hatch_keys *places,
                                      uint32_t *class_of, struct hatch_err *err)
{
    for (size_t c = 0; c < corner_count; c++) {
        uint64_t key;
        memcpy(&key, &texcoords[2 * c], sizeof key);
        HATCH_TRY(hatch_keys_number(places, key, &class_of[c], err));
    }
    return HATCH_OK;
}

/* Splits the vertices of a mesh so that each has one position in the atlas, and adds TEXCOORD_0. */
static enum hatch_status split(struct cmd_args *args, const struct work *work, const float *texcoords,
                               struct hatch_scene_mesh *made, struct hatch_err *err)
{
    const struct hatch_surface *surface = &work->surface;
    const struct hatch_mesh source = made->mesh;
    struct hatch_arena *scratch = &args->scratch;
    size_t corners = 3 * (size_t)surface->face_count;
    struct hatch_splits splits;
    float *uv;
    struct hatch_keys places;
    uint32_t *class_of;
    HATCH_TRY(HATCH_ALLOC(scratch, &class_of, corners, err));
    HATCH_TRY(hatch_keys_make(scratch, &places, err));
    HATCH_TRY(find_classes(texcoords, corners, &places, class_of, err));
    HATCH_TRY(hatch_splits_make(surface->corner_vertex, class_of, corners, source.vertex_count, scratch, &splits, err));
    HATCH_TRY(
        hatch_mesh_gather(&source, splits.origin, splits.count, surface->face_count, &args->keep, &made->mesh, err));
    HATCH_TRY(hatch_mesh_add(&args->keep, &made->mesh, "TEXCOORD_0", 2, &uv, err));
    memcpy(made->mesh.indices, splits.indices, corners * sizeof *splits.indices);
    for (size_t v = 0; v < splits.count; v++)
        if (splits.class_at[v] != HATCH_NO_CLASS)
            memcpy(&uv[2 * v], &places.keys[splits.class_at[v]], 2 * sizeof *uv);
    return HATCH_OK;
}

static enum hatch_status make_atlas(struct cmd_args *args, const struct work *work, struct lapped_param_part *part,
                                    struct hatch_err *err)
{
    double scale;
    struct hatch_arena_mark mark = hatch_arena_mark(&args->scratch);
    float *texcoords;
    HATCH_TRY(HATCH_ALLOC(&args->scratch, &texcoords, 6 * (size_t)work->surface.face_count, err));
    HATCH_TRY(HATCH_ALLOC(&args->keep, &part->made, 1, err));
    part->made[0] = *part->mesh;
    part->made_count = 1;
    HATCH_TRY(hatch_lapped_atlas(&work->input, &work->lapped, ATLAS_MARGIN, &args->scratch, texcoords, &scale, err));
    part->atlas_side = 1 / scale;
    HATCH_TRY(split(args, work, texcoords, &part->made[0], err));
    hatch_arena_rewind(&args->scratch, mark);
    return HATCH_OK;
}

void lapped_param_cover(struct cmd_args *args, const struct lapped_param_options *options,
                        const struct hatch_outline *outline, struct lapped_param_part *part)
{
    struct work work = {.input = {.outline = outline, .tile = part->tile}};
    struct hatch_err err;
    const struct hatch_mesh source = part->mesh->mesh;
    hatch_arena_init(&work.arena, args->max_memory);
    prepare(args, part);
    cmd_check(make_patches(args, options, part, &source, &work, &err), part->name, &err);
    cmd_check(options->atlas ? make_atlas(args, &work, part, &err) : make_meshes(args, &work, part, &err), part->name,
              &err);
    part->patches = work.lapped.patch_count;
    part->patch_faces = work.lapped.face_count;
    part->faces = work.surface.face_count;
    part->cut = work.lapped.cut_count;
    part->enlarged = work.lapped.enlarged_count;
    part->solved_faces = work.lapped.solved_faces;
    for (uint32_t p = 0; p < work.lapped.patch_count; p++)
        part->outline_side = fmax(part->outline_side, 2 * work.lapped.patches[p].radius);
    hatch_arena_free(&work.arena);
}

void lapped_param_keep(struct cmd_args *args, struct lapped_param_part *part)
{
    struct hatch_err err;
    struct hatch_mesh *mesh;
    float *uv;
    cmd_check(HATCH_ALLOC(&args->keep, &part->made, 1, &err), part->name, &err);
    part->made[0] = *part->mesh;
    part->made_count = 1;
    mesh = &part->made[0].mesh;
    lapped_param_clear_mesh(mesh, NULL, false);
    cmd_check(hatch_mesh_add(&args->keep, mesh, "TEXCOORD_0", 2, &uv, &err), part->name, &err);
    for (size_t v = 0; v < mesh->vertex_count; v++)
        for (size_t k = 0; k < 2; k++)
            uv[2 * v + k] = (float)((double)mesh->attributes[0].data[3 * v + k] / part->tile);
}
