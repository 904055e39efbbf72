#include "measure/lapped_sheets.h"

#include <stdlib.h>
#include <string.h>

bool hatch_sheets_same(const struct hatch_sheet *a, const struct hatch_sheet *b)
{
    return a->group == b->group && memcmp(a->point, b->point, sizeof a->point) == 0;
}

static int compare(const void *pa, const void *pb)
{
    const struct hatch_sheet *a = pa, *b = pb;
    const uint32_t keys[][2] = {{a->group, b->group},       {a->point[0], b->point[0]}, {a->point[1], b->point[1]},
                                {a->point[2], b->point[2]}, {a->patch, b->patch},       {a->face, b->face}};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        if (keys[i][0] != keys[i][1])
            return keys[i][0] < keys[i][1] ? -1 : 1;
    return 0;
}

/* group: per mesh the first of those that are drawn with it, or HATCH_NONE: it is no patch that a node
 * draws. */
static enum hatch_status find_patches(const struct hatch_scene *scene, const struct hatch_image *masks, uint32_t *group,
                                      struct hatch_sheets *sheets, struct hatch_err *err)
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
            return hatch_fail(err, HATCH_BAD_INPUT, "patch %u: no mask", m);
        sheets->masks[sheets->patch_count] = &masks[texture];
        sheets->patches[sheets->patch_count++] = patch;
    }
    if (sheets->patch_count == 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "no patches: is this a file of lapped-param's?");
    return HATCH_OK;
}

/* All patches' positions as one mesh; first: per patch its first vertex. */
static enum hatch_status gather(const struct hatch_sheets *sheets, struct hatch_arena *scratch, struct hatch_mesh *all,
                                size_t *first, struct hatch_err *err)
{
    size_t vertices = 0, faces = 0;
    for (uint32_t p = 0; p < sheets->patch_count; p++) {
        first[p] = vertices;
        vertices += sheets->patches[p]->mesh.vertex_count;
        faces += sheets->patches[p]->mesh.face_count;
    }
    if (vertices >= UINT32_MAX || faces >= UINT32_MAX)
        return hatch_fail(err, HATCH_LIMIT, "%zu vertices and %zu faces are too many", vertices, faces);
    HATCH_TRY(hatch_mesh_make(scratch, (uint32_t)vertices, 1, all, err));
    for (uint32_t p = 0; p < sheets->patch_count; p++)
        memcpy(&all->attributes[0].data[3 * first[p]], sheets->patches[p]->mesh.attributes[0].data,
               (size_t)sheets->patches[p]->mesh.vertex_count * 3 * sizeof(float));
    return HATCH_OK;
}

/* The three points in rising order, and which corner has each. */
static void set_points(const uint32_t points[3], struct hatch_sheet *sheet)
{
    for (uint8_t c = 0; c < 3; c++) {
        int rank = 0;
        for (uint8_t other = 0; other < 3; other++)
            rank += points[other] < points[c] || (points[other] == points[c] && other < c);
        sheet->point[rank] = points[c];
        sheet->corner[rank] = c;
    }
}

static enum hatch_status fill(const struct hatch_scene *scene, const uint32_t *group, struct hatch_arena *scratch,
                              struct hatch_sheets *sheets, struct hatch_err *err)
{
    struct hatch_mesh all;
    uint32_t points;
    size_t *first = HATCH_NEW(scratch, size_t, sheets->patch_count, err), faces = 0;
    if (!first)
        return HATCH_LIMIT;
    HATCH_TRY(gather(sheets, scratch, &all, first, err));
    uint32_t *point = HATCH_NEW(scratch, uint32_t, all.vertex_count, err);
    if (!point)
        return HATCH_LIMIT;
    HATCH_TRY(hatch_mesh_weld(&all, scratch, point, &points, err));
    for (uint32_t p = 0; p < sheets->patch_count; p++)
        faces += sheets->patches[p]->mesh.face_count;
    sheets->list = HATCH_NEW(scratch, struct hatch_sheet, faces, err);
    sheets->first = sheets->list ? HATCH_NEW(scratch, uint32_t, faces + 1, err) : NULL;
    if (!sheets->first)
        return HATCH_LIMIT;
    for (uint32_t p = 0; p < sheets->patch_count; p++) {
        const struct hatch_mesh *mesh = &sheets->patches[p]->mesh;
        for (uint32_t f = 0; f < mesh->face_count; f++) {
            struct hatch_sheet *sheet = &sheets->list[sheets->count++];
            uint32_t at[3];
            for (size_t c = 0; c < 3; c++)
                at[c] = point[first[p] + mesh->indices[3 * (size_t)f + c]];
            *sheet = (struct hatch_sheet){.group = group[sheets->patches[p] - scene->meshes], .patch = p, .face = f};
            set_points(at, sheet);
        }
    }
    return HATCH_OK;
}

enum hatch_status hatch_sheets_make(const struct hatch_scene *scene, const struct hatch_image *masks,
                                    struct hatch_arena *scratch, struct hatch_sheets *sheets, struct hatch_err *err)
{
    struct hatch_sheets made = {.count = 0};
    uint32_t *group = HATCH_NEW(scratch, uint32_t, scene->mesh_count, err);
    made.patches = group ? HATCH_NEW(scratch, const struct hatch_scene_mesh *, scene->mesh_count, err) : NULL;
    made.masks = made.patches ? HATCH_NEW(scratch, const struct hatch_image *, scene->mesh_count, err) : NULL;
    if (!made.masks)
        return HATCH_LIMIT;
    HATCH_TRY(find_patches(scene, masks, group, &made, err));
    HATCH_TRY(fill(scene, group, scratch, &made, err));
    qsort(made.list, made.count, sizeof *made.list, compare);
    for (uint32_t s = 0; s < made.count; s++)
        if (s == 0 || !hatch_sheets_same(&made.list[s - 1], &made.list[s]))
            made.first[made.face_count++] = s;
    made.first[made.face_count] = made.count;
    *sheets = made;
    return HATCH_OK;
}
