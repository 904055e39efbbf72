#include "scene/patches.h"

#include <string.h>

#include "base/keys.h"
#include "mesh/remap.h"
#include "mesh/skin/motion.h"

static bool is_patch(const struct hatch_scene *scene, const struct hatch_scene_mesh *mesh)
{
    if (mesh->material == HATCH_NONE)
        return false;
    const struct hatch_material *material = &scene->materials[mesh->material];
    return material->outline && material->base.texture != HATCH_NONE && hatch_mesh_find(&mesh->mesh, "TEXCOORD_0", 2) &&
           hatch_mesh_find(&mesh->mesh, "TEXCOORD_1", 2) && hatch_mesh_find(&mesh->mesh, "NORMAL", 3);
}

/* Returns whether two meshes can be joined: they have the same material, and the same attributes in the same order. */
static bool are_alike(const struct hatch_scene_mesh *a, const struct hatch_scene_mesh *b)
{
    bool alike = a->material == b->material && a->mesh.attribute_count == b->mesh.attribute_count;
    for (uint32_t i = 0; alike && i < a->mesh.attribute_count; i++)
        alike = strcmp(a->mesh.attributes[i].name, b->mesh.attributes[i].name) == 0 &&
                a->mesh.attributes[i].components == b->mesh.attributes[i].components;
    return alike;
}

/* Concatenates the vertices of the patches, and allocates their faces. */
static enum hatch_status concatenate(const struct hatch_scene_mesh *from, uint32_t count, struct hatch_arena *arena,
                                     struct hatch_patch_mesh *patches, struct hatch_mesh *joined, struct hatch_err *err)
{
    uint64_t vertices = 0, faces = 0;
    HATCH_TRY(HATCH_ALLOC(arena, &patches->first_vertex, count + (size_t)1, err));
    for (uint32_t i = 0; i < count; i++) {
        patches->first_vertex[i] = (uint32_t)vertices;
        vertices += from[i].mesh.vertex_count;
        faces += from[i].mesh.face_count;
        if (vertices > UINT32_MAX / 4 || faces > UINT32_MAX / 4)
            return hatch_fail(err, HATCH_LIMIT, "the patches of a node have more than 2^30 faces");
    }
    patches->patch_count = count;
    patches->first_vertex[count] = (uint32_t)vertices;
    HATCH_TRY(hatch_mesh_make(arena, (uint32_t)vertices, (uint32_t)faces, joined, err));
    for (uint32_t a = 0; a < from->mesh.attribute_count; a++) {
        const struct hatch_mesh_attribute *like = &from->mesh.attributes[a];
        size_t n = like->components;
        float *data = joined->attributes[0].data;
        if (a > 0)
            HATCH_TRY(hatch_mesh_add(arena, joined, like->name, like->components, &data, err));
        for (uint32_t i = 0; i < count; i++)
            memcpy(data + n * patches->first_vertex[i], from[i].mesh.attributes[a].data,
                   n * from[i].mesh.vertex_count * sizeof *data);
    }
    return HATCH_OK;
}

/* State of joining the patches of a surface. */
struct joining {
    const struct hatch_scene_mesh *from;
    struct hatch_patch_mesh *patches;
    struct hatch_mesh *joined;
    struct hatch_remap weld;        /* new indices of the joined vertices: vertices of the surface */
    struct hatch_keys pairs, faces; /* pairs: numbers the pairs of a face's first two points; faces: numbers such a pair
                                       with the third point */
    uint32_t *layer_of;             /* per surface face: 1 + highest layer that covers it */
    uint32_t *layer;                /* per patch */
};

/* Returns a face's corners in the joined mesh, starting with the lowest point, so that faces on the same points are
 * interpolated alike and get equal depths. */
static void corners_of(const struct joining *joining, uint32_t patch, uint32_t face, uint32_t corner[3])
{
    const uint32_t *index = &joining->from[patch].mesh.indices[3 * (size_t)face];
    uint32_t base = joining->patches->first_vertex[patch], least = 0;
    const uint32_t *number = joining->weld.number;
    for (uint32_t c = 1; c < 3; c++)
        if (number[base + index[c]] < number[base + index[least]])
            least = c;
    for (uint32_t c = 0; c < 3; c++)
        corner[c] = base + index[(least + c) % 3];
}

/* Numbers the surface's faces in order of appearance, and assigns each patch the lowest layer above all earlier patches
 * that it overlaps. */
static enum hatch_status find_faces(struct joining *joining, struct hatch_mesh *surface, struct hatch_err *err)
{
    for (uint32_t patch = 0; patch < joining->patches->patch_count; patch++) {
        uint32_t count = joining->from[patch].mesh.face_count, layer = 0;
        uint32_t *surface_face = joining->joined->indices; /* used as scratch here; order_faces fills it later */
        for (uint32_t f = 0; f < count; f++) {
            uint32_t corner[3], point[3], pair, before = joining->faces.count;
            corners_of(joining, patch, f, corner);
            for (int c = 0; c < 3; c++)
                point[c] = joining->weld.number[corner[c]];
            HATCH_TRY(hatch_keys_number(&joining->pairs, (uint64_t)point[0] << 32 | point[1], &pair, err));
            HATCH_TRY(hatch_keys_number(&joining->faces, (uint64_t)pair << 32 | point[2], &surface_face[f], err));
            if (joining->faces.count > before)
                memcpy(&surface->indices[3 * (size_t)before], point, sizeof point);
            if (joining->layer_of[surface_face[f]] > layer)
                layer = joining->layer_of[surface_face[f]];
        }
        for (uint32_t f = 0; f < count; f++)
            joining->layer_of[surface_face[f]] = layer + 1;
        joining->layer[patch] = layer;
        if (layer >= joining->patches->layer_count)
            joining->patches->layer_count = layer + 1;
    }
    surface->face_count = joining->faces.count;
    return HATCH_OK;
}

/* Writes the faces of the joined mesh, layer by layer (a counting sort). */
static enum hatch_status order_faces(struct joining *joining, struct hatch_arena *arena, struct hatch_err *err)
{
    struct hatch_patch_mesh *patches = joining->patches;
    HATCH_TRY(HATCH_ALLOC(arena, &patches->layer_end, patches->layer_count, err));
    for (uint32_t i = 0; i < patches->patch_count; i++)
        if (joining->layer[i] + 1 < patches->layer_count)
            patches->layer_end[joining->layer[i] + 1] += 3 * joining->from[i].mesh.face_count;
    for (uint32_t i = 1; i < patches->layer_count; i++)
        patches->layer_end[i] += patches->layer_end[i - 1];
    for (uint32_t i = 0; i < patches->patch_count; i++)
        for (uint32_t f = 0; f < joining->from[i].mesh.face_count; f++) {
            uint32_t *at = &patches->layer_end[joining->layer[i]];
            corners_of(joining, i, f, &joining->joined->indices[*at]);
            *at += 3;
        }
    return HATCH_OK;
}

static enum hatch_status join(const struct hatch_scene_mesh *from, uint32_t count, struct hatch_arena *arena,
                              struct hatch_arena *scratch, struct hatch_patch_mesh *patches, struct hatch_mesh *joined,
                              struct hatch_err *err)
{
    struct joining joining = {.from = from, .patches = patches, .joined = joined};
    struct hatch_mesh *surface = &patches->surface;
    HATCH_TRY(concatenate(from, count, arena, patches, joined, err));
    HATCH_TRY(hatch_mesh_remap_by_normal(joined, arena, scratch, &joining.weld, err));
    patches->vertex_of = joining.weld.first;
    HATCH_TRY(hatch_mesh_make(arena, joining.weld.count, joined->face_count, surface, err));
    HATCH_TRY(hatch_remap_attributes(joined, joining.weld.first, arena, surface, err));
    HATCH_TRY(hatch_keys_make(scratch, &joining.pairs, err));
    HATCH_TRY(hatch_keys_make(scratch, &joining.faces, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &joining.layer_of, joined->face_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &joining.layer, count, err));
    HATCH_TRY(find_faces(&joining, surface, err));
    return order_faces(&joining, arena, err);
}

/* Returns the number of meshes from `first` on that are patches of one surface; 1 for an ordinary mesh.
 *   begins  per mesh, and one more: not 0 for the first mesh of a node and for the mesh after its last one */
static uint32_t run_length(const struct hatch_scene *scene, const uint8_t *begins, uint32_t first)
{
    uint32_t end = first + 1;
    while (is_patch(scene, &scene->meshes[first]) && end < scene->mesh_count && !begins[end] &&
           is_patch(scene, &scene->meshes[end]) && are_alike(&scene->meshes[first], &scene->meshes[end]))
        end++;
    return end - first;
}

/* Adjusts the mesh ranges of the nodes.
 *   new_index  per old mesh */
static void renumber_nodes(struct hatch_scene *scene, const uint32_t *new_index)
{
    for (uint32_t i = 0; i < scene->node_count; i++) {
        struct hatch_node *node = &scene->nodes[i];
        if (!node->mesh_count)
            continue;
        uint32_t last = new_index[node->first_mesh + node->mesh_count - 1];
        node->first_mesh = new_index[node->first_mesh];
        node->mesh_count = last - node->first_mesh + 1;
    }
}

/*   new_index  out: per old mesh */
static enum hatch_status join_all(struct hatch_scene *scene, struct hatch_arena *arena, struct hatch_arena *scratch,
                                  struct hatch_patch_mesh *patches, uint32_t *new_index, struct hatch_err *err)
{
    uint8_t *begins;
    struct hatch_scene_mesh *meshes;
    HATCH_TRY(HATCH_ALLOC(scratch, &begins, scene->mesh_count + (size_t)1, err));
    HATCH_TRY(HATCH_ALLOC(arena, &meshes, scene->mesh_count, err));
    for (uint32_t i = 0; i < scene->node_count; i++) {
        const struct hatch_node *node = &scene->nodes[i];
        if (node->mesh_count)
            begins[node->first_mesh] = begins[node->first_mesh + node->mesh_count] = 1;
    }
    uint32_t made = 0;
    for (uint32_t first = 0, count; first < scene->mesh_count; first += count) {
        const struct hatch_scene_mesh *from = &scene->meshes[first];
        count = run_length(scene, begins, first);
        meshes[made] = *from;
        for (uint32_t i = 0; i < count; i++) {
            new_index[first + i] = made;
            if (from[i].joints_used > meshes[made].joints_used)
                meshes[made].joints_used = from[i].joints_used;
        }
        if (is_patch(scene, from)) {
            struct hatch_arena_mark mark = hatch_arena_mark(scratch);
            HATCH_TRY(join(from, count, arena, scratch, &patches[made], &meshes[made].mesh, err));
            hatch_arena_rewind(scratch, mark);
        }
        made++;
    }
    scene->meshes = meshes;
    scene->mesh_count = made;
    renumber_nodes(scene, new_index);
    return HATCH_OK;
}

enum hatch_status hatch_patches_join(struct hatch_scene *scene, struct hatch_arena *arena, struct hatch_arena *scratch,
                                     struct hatch_patch_mesh **patches, uint32_t **numbers, struct hatch_err *err)
{
    struct hatch_patch_mesh *made;
    uint32_t *new_index;
    HATCH_TRY(HATCH_ALLOC(arena, &made, scene->mesh_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &new_index, scene->mesh_count, err));
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = join_all(scene, arena, scratch, made, new_index, err);
    hatch_arena_rewind(scratch, mark);
    if (status != HATCH_OK)
        return status;
    *patches = made;
    if (numbers)
        *numbers = new_index;
    return HATCH_OK;
}
