#include "line/surface/surface.h"

#include <string.h>

#include "line/edges.h"

/* Items that are one surface: those from first to before end that are not cut out. */
struct run {
    uint32_t first, end;
    uint32_t parts, vertex_count, face_count; /* of their meshes */
    bool normals_authored;                    /* of any of them */
};

static const struct hatch_mesh *mesh_of(const struct hatch_unit_scene *scene, uint32_t item)
{
    return scene->meshes[scene->items[item].mesh].surface;
}

/* Returns whether the vertices of two meshes have the same kind of data for skins and morph targets. */
static bool move_alike(const struct hatch_mesh *a, const struct hatch_mesh *b)
{
    return !hatch_mesh_find(a, "JOINTS_0", 4) == !hatch_mesh_find(b, "JOINTS_0", 4) &&
           !hatch_mesh_find(a, "WEIGHTS_0", 4) == !hatch_mesh_find(b, "WEIGHTS_0", 4) &&
           hatch_mesh_target_count(a) == hatch_mesh_target_count(b);
}

/* Finds the run that begins with an item, which is not cut out. A run has no more corners than can be numbered. */
static struct run find_run(const struct hatch_unit_scene *scene, uint32_t first)
{
    struct run run = {.first = first, .end = first};
    for (; run.end < scene->item_count && scene->items[run.end].node == scene->items[first].node; run.end++) {
        const struct hatch_mesh *mesh = mesh_of(scene, run.end);
        uint64_t vertices = (uint64_t)run.vertex_count + mesh->vertex_count;
        uint64_t faces = (uint64_t)run.face_count + mesh->face_count;
        if (scene->items[run.end].cut_out)
            continue;
        if (run.parts && (!move_alike(mesh_of(scene, first), mesh) || vertices > UINT32_MAX || 3 * faces > UINT32_MAX))
            break;
        run.parts++;
        run.vertex_count = (uint32_t)vertices;
        run.face_count = (uint32_t)faces;
        run.normals_authored =
            run.normals_authored || !scene->scene->meshes[scene->items[run.end].mesh].normals_computed;
    }
    return run;
}

static bool all_have(const struct hatch_unit_scene *scene, const struct run *run,
                     const struct hatch_mesh_attribute *attribute)
{
    for (uint32_t i = run->first; i < run->end; i++)
        if (!scene->items[i].cut_out && !hatch_mesh_find(mesh_of(scene, i), attribute->name, attribute->components))
            return false;
    return true;
}

/* Copies an attribute of all meshes of a run. */
static void copy_attribute(const struct hatch_unit_scene *scene, const struct run *run,
                           const struct hatch_mesh_attribute *attribute, float *to)
{
    for (uint32_t i = run->first; i < run->end; i++) {
        const struct hatch_mesh *mesh = mesh_of(scene, i);
        size_t count = (size_t)mesh->vertex_count * attribute->components;
        if (scene->items[i].cut_out)
            continue;
        memcpy(to, hatch_mesh_find(mesh, attribute->name, attribute->components), count * sizeof *to);
        to += count;
    }
}

static void copy_faces(const struct hatch_unit_scene *scene, const struct run *run, uint32_t *to)
{
    uint32_t base = 0;
    for (uint32_t i = run->first; i < run->end; i++) {
        const struct hatch_mesh *mesh = mesh_of(scene, i);
        if (scene->items[i].cut_out)
            continue;
        for (size_t k = 0; k < 3 * (size_t)mesh->face_count; k++)
            *to++ = base + mesh->indices[k];
        base += mesh->vertex_count;
    }
}

/* Joins the meshes of a run into one, with the attributes that place vertices, and NORMAL if all have it.
 *   joined  out: in arena; of a single mesh, that mesh itself */
static enum hatch_status join(const struct hatch_unit_scene *scene, const struct run *run, struct hatch_arena *arena,
                              struct hatch_mesh *joined, struct hatch_err *err)
{
    static const char *const used[] = {"NORMAL", "JOINTS_0", "WEIGHTS_0", HATCH_MORPH_POSITION, HATCH_MORPH_NORMAL};
    const struct hatch_mesh *first = mesh_of(scene, run->first);
    struct hatch_mesh made = *first;
    if (run->parts > 1) {
        HATCH_TRY(hatch_mesh_make(arena, run->vertex_count, run->face_count, &made, err));
        copy_faces(scene, run, made.indices);
        copy_attribute(scene, run, &first->attributes[0], made.attributes[0].data);
    }
    for (size_t i = 0; i < sizeof used / sizeof *used && run->parts > 1; i++) {
        const struct hatch_mesh_attribute *attribute = hatch_mesh_attribute(first, used[i]);
        float *data;
        if (!attribute || !all_have(scene, run, attribute))
            continue;
        HATCH_TRY(hatch_mesh_add(arena, &made, attribute->name, attribute->components, &data, err));
        copy_attribute(scene, run, attribute, data);
    }
    *joined = made;
    return HATCH_OK;
}

static enum hatch_status make_body(const struct hatch_unit_scene *scene, const struct run *run,
                                   const struct hatch_line_choice *choice, struct hatch_arena *arena,
                                   struct hatch_arena *scratch, struct hatch_line_body *body, struct hatch_err *err)
{
    const struct hatch_item *item = &scene->items[run->first];
    struct hatch_mesh joined;
    uint32_t face = 0;
    body->choice = (struct hatch_line_choice){choice->kinds, choice->crease_rad, run->normals_authored};
    HATCH_TRY(HATCH_ALLOC(arena, &body->double_sided, run->face_count, err));
    for (uint32_t i = run->first; i < run->end; i++)
        for (uint32_t f = 0; f < mesh_of(scene, i)->face_count && !scene->items[i].cut_out; f++)
            body->double_sided[face++] = scene->items[i].double_sided;
    if (item->deformed) {
        HATCH_TRY(join(scene, run, arena, &body->mesh, err));
        HATCH_TRY(HATCH_ALLOC(arena, &body->edges, 1, err));
        return hatch_line_edges_find(&body->mesh, true, arena, scratch, body->edges, err);
    }
    HATCH_TRY(join(scene, run, scratch, &joined, err));
    return hatch_line_mesh_make(&joined, NULL, scene->meshes[item->mesh].origin, &body->choice, arena, scratch,
                                &body->lines, err);
}

/* Finds the surfaces, in room for one per item. */
static enum hatch_status find(const struct hatch_unit_scene *scene, const struct hatch_line_choice *choice,
                              struct hatch_arena *arena, struct hatch_arena *scratch,
                              struct hatch_line_surface *surfaces, uint32_t *count, struct hatch_err *err)
{
    const struct hatch_line_body **bodies; /* 2 per mesh that is the first of a run: rigid, deformed; NULL: none yet */
    HATCH_TRY(HATCH_ALLOC(scratch, &bodies, 2 * (size_t)scene->scene->mesh_count, err));
    for (uint32_t i = 0; i < scene->item_count; i++) {
        const struct hatch_item *item = &scene->items[i];
        const struct hatch_line_body **body = &bodies[2 * (size_t)item->mesh + (item->deformed ? 1 : 0)];
        if (item->cut_out)
            continue;
        const struct run run = find_run(scene, i);
        if (!*body) {
            struct hatch_arena_mark mark = hatch_arena_mark(scratch);
            struct hatch_line_body *made;
            HATCH_TRY(HATCH_ALLOC(arena, &made, 1, err));
            HATCH_TRY(make_body(scene, &run, choice, arena, scratch, made, err));
            hatch_arena_rewind(scratch, mark);
            *body = made;
        }
        surfaces[(*count)++] = (struct hatch_line_surface){item, *body};
        i = run.end - 1;
    }
    return HATCH_OK;
}

enum hatch_status hatch_line_surfaces_make(const struct hatch_unit_scene *scene, const struct hatch_line_choice *choice,
                                           struct hatch_arena *arena, struct hatch_arena *scratch,
                                           struct hatch_line_surface **surfaces, uint32_t *count, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_line_surface *made;
    uint32_t found = 0;
    HATCH_TRY(HATCH_ALLOC(arena, &made, scene->item_count, err));
    enum hatch_status status = find(scene, choice, arena, scratch, made, &found, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK) {
        *surfaces = made;
        *count = found;
    }
    return status;
}
