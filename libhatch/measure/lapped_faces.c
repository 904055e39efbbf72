#include "measure/lapped_faces.h"

#include <stdlib.h>
#include <string.h>

bool hatch_lapped_faces_coincide(const struct hatch_lapped_face *a, const struct hatch_lapped_face *b)
{
    return a->group == b->group && memcmp(a->point, b->point, sizeof a->point) == 0;
}

static int compare(const void *pa, const void *pb)
{
    const struct hatch_lapped_face *a = pa, *b = pb;
    const uint32_t keys[][2] = {{a->group, b->group},       {a->point[0], b->point[0]}, {a->point[1], b->point[1]},
                                {a->point[2], b->point[2]}, {a->patch, b->patch},       {a->face, b->face}};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        if (keys[i][0] != keys[i][1])
            return keys[i][0] < keys[i][1] ? -1 : 1;
    return 0;
}

/* Collects the patches. group: per mesh, the first mesh of its node, or HATCH_NONE unless it is a patch that a
 * node uses. */
static enum hatch_status find_patches(const struct hatch_scene *scene, const struct hatch_image *masks, uint32_t *group,
                                      struct hatch_lapped_faces *faces, struct hatch_err *err)
{
    memset(group, 0xff, scene->mesh_count * sizeof *group);
    for (uint32_t n = 0; n < scene->node_count; n++) {
        const struct hatch_node *node = &scene->nodes[n];
        for (uint32_t m = node->first_mesh; m < node->first_mesh + node->mesh_count; m++)
            if (scene->meshes[m].material != HATCH_NONE && scene->materials[scene->meshes[m].material].outline)
                group[m] = node->first_mesh;
    }
    for (uint32_t m = 0; m < scene->mesh_count; m++) {
        if (group[m] == HATCH_NONE)
            continue;
        const struct hatch_scene_mesh *patch = &scene->meshes[m];
        uint32_t texture = scene->materials[patch->material].base.texture;
        if (!hatch_mesh_find(&patch->mesh, "TEXCOORD_0", 2) || !hatch_mesh_find(&patch->mesh, "TEXCOORD_1", 2))
            return hatch_fail(err, HATCH_BAD_INPUT, "patch %u: no TEXCOORD_0 or no TEXCOORD_1", m);
        if (texture == HATCH_NONE || !masks[texture].pixels)
            return hatch_fail(err, HATCH_BAD_INPUT, "patch %u: no outline (alpha mask)", m);
        faces->masks[faces->patch_count] = &masks[texture];
        faces->patches[faces->patch_count++] = patch;
    }
    if (faces->patch_count == 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "no patches; make some with lapped-param");
    return HATCH_OK;
}

/* Joins all patches' positions in one mesh. first: per patch, its first vertex. */
static enum hatch_status gather(const struct hatch_lapped_faces *faces, struct hatch_arena *scratch,
                                struct hatch_mesh *all, size_t *first, struct hatch_err *err)
{
    size_t vertices = 0, face_count = 0;
    for (uint32_t p = 0; p < faces->patch_count; p++) {
        first[p] = vertices;
        vertices += faces->patches[p]->mesh.vertex_count;
        face_count += faces->patches[p]->mesh.face_count;
    }
    if (vertices >= UINT32_MAX || face_count >= UINT32_MAX)
        return hatch_fail(err, HATCH_LIMIT, "%zu vertices and %zu faces are too many", vertices, face_count);
    HATCH_TRY(hatch_mesh_make(scratch, (uint32_t)vertices, 1, all, err));
    for (uint32_t p = 0; p < faces->patch_count; p++)
        memcpy(&all->attributes[0].data[3 * first[p]], faces->patches[p]->mesh.attributes[0].data,
               (size_t)faces->patches[p]->mesh.vertex_count * 3 * sizeof(float));
    return HATCH_OK;
}

/* Sorts the three points and records their corners. */
static void set_points(const uint32_t points[3], struct hatch_lapped_face *face)
{
    for (uint8_t c = 0; c < 3; c++) {
        int rank = 0;
        for (uint8_t other = 0; other < 3; other++)
            rank += points[other] < points[c] || (points[other] == points[c] && other < c);
        face->point[rank] = points[c];
        face->corner[rank] = c;
    }
}

static enum hatch_status fill(const struct hatch_scene *scene, const uint32_t *group, struct hatch_arena *scratch,
                              struct hatch_lapped_faces *faces, struct hatch_err *err)
{
    struct hatch_mesh all;
    uint32_t points;
    size_t *first = HATCH_NEW(scratch, size_t, faces->patch_count, err), total = 0;
    if (!first)
        return HATCH_LIMIT;
    HATCH_TRY(gather(faces, scratch, &all, first, err));
    uint32_t *point;
    HATCH_TRY(HATCH_ALLOC(scratch, &point, all.vertex_count, err));
    HATCH_TRY(hatch_mesh_weld(&all, scratch, point, &points, err));
    for (uint32_t p = 0; p < faces->patch_count; p++)
        total += faces->patches[p]->mesh.face_count;
    HATCH_TRY(HATCH_ALLOC(scratch, &faces->list, total, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &faces->first, total + 1, err));
    for (uint32_t p = 0; p < faces->patch_count; p++) {
        const struct hatch_mesh *mesh = &faces->patches[p]->mesh;
        for (uint32_t f = 0; f < mesh->face_count; f++) {
            struct hatch_lapped_face *face = &faces->list[faces->count++];
            uint32_t corners[3];
            for (size_t c = 0; c < 3; c++)
                corners[c] = point[first[p] + mesh->indices[3 * (size_t)f + c]];
            *face =
                (struct hatch_lapped_face){.group = group[faces->patches[p] - scene->meshes], .patch = p, .face = f};
            set_points(corners, face);
        }
    }
    return HATCH_OK;
}

enum hatch_status hatch_lapped_faces_find(const struct hatch_scene *scene, const struct hatch_image *masks,
                                          struct hatch_arena *scratch, struct hatch_lapped_faces *faces,
                                          struct hatch_err *err)
{
    struct hatch_lapped_faces made = {.count = 0};
    uint32_t *group;
    HATCH_TRY(HATCH_ALLOC(scratch, &group, scene->mesh_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &made.patches, scene->mesh_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &made.masks, scene->mesh_count, err));
    HATCH_TRY(find_patches(scene, masks, group, &made, err));
    HATCH_TRY(fill(scene, group, scratch, &made, err));
    qsort(made.list, made.count, sizeof *made.list, compare);
    for (uint32_t s = 0; s < made.count; s++)
        if (s == 0 || !hatch_lapped_faces_coincide(&made.list[s - 1], &made.list[s]))
            made.first[made.surface_count++] = s;
    made.first[made.surface_count] = made.count;
    *faces = made;
    return HATCH_OK;
}
