/* Vertex attributes that small primitives share. */
#include <string.h>

#include "io/glb/parts.h"

/* Most vertices that share accessors: enough that the text of accessors is small beside that of primitives, and few
 * since programs copy all of them for each primitive. */
#define SHARED_MAX 256u

static bool can_share(const struct hatch_scene_mesh *from)
{
    return from->mesh.face_count > 0 && from->mesh.vertex_count <= SHARED_MAX && from->curves.set_count == 0 &&
           hatch_mesh_target_count(&from->mesh) == 0;
}

/* Returns whether two meshes have attributes of the same names and sizes. */
static bool are_alike(const struct hatch_mesh *a, const struct hatch_mesh *b)
{
    uint32_t order[2][HATCH_MESH_ATTRIBUTES_MAX], count = hatch_glb_order(a, order[0]);
    if (hatch_glb_order(b, order[1]) != count)
        return false;
    for (uint32_t i = 0; i < count; i++) {
        const struct hatch_mesh_attribute *p = &a->attributes[order[0][i]], *q = &b->attributes[order[1][i]];
        if (p->components != q->components || strcmp(p->name, q->name) != 0)
            return false;
    }
    return true;
}

uint32_t hatch_glb_count_shared(const struct hatch_glb *glb, uint32_t first, uint32_t end)
{
    const struct hatch_scene_mesh *meshes = glb->scene->meshes;
    uint32_t count = 0, vertices = 0;
    for (uint32_t m = first; m < end; m++) {
        vertices += meshes[m].mesh.vertex_count;
        if (!can_share(&meshes[m]) || vertices > SHARED_MAX || !are_alike(&meshes[first].mesh, &meshes[m].mesh))
            break;
        count++;
    }
    return count;
}

/* Lays the vertices of meshes one after another.
 *   all  out: in scratch */
static enum hatch_status join(struct hatch_glb *glb, const struct hatch_scene_mesh *meshes, uint32_t count,
                              struct hatch_mesh *all)
{
    uint32_t order[HATCH_MESH_ATTRIBUTES_MAX], done = 0, *corner;
    *all = (struct hatch_mesh){.attribute_count = hatch_glb_order(&meshes[0].mesh, order)};
    for (uint32_t m = 0; m < count; m++) {
        all->vertex_count += meshes[m].mesh.vertex_count;
        all->face_count += meshes[m].mesh.face_count;
    }
    HATCH_TRY(HATCH_ALLOC_UNSET(glb->scratch, &all->indices, 3 * (size_t)all->face_count, glb->err));
    corner = all->indices;
    for (uint32_t i = 0; i < all->attribute_count; i++) {
        struct hatch_mesh_attribute *to = &all->attributes[i];
        *to = meshes[0].mesh.attributes[order[i]];
        HATCH_TRY(HATCH_ALLOC_UNSET(glb->scratch, &to->data, (size_t)all->vertex_count * to->components, glb->err));
    }
    for (uint32_t m = 0; m < count; m++) {
        const struct hatch_mesh *mesh = &meshes[m].mesh;
        hatch_glb_order(mesh, order);
        for (uint32_t i = 0; i < all->attribute_count; i++) {
            struct hatch_mesh_attribute *to = &all->attributes[i];
            memcpy(&to->data[(size_t)done * to->components], mesh->attributes[order[i]].data,
                   (size_t)mesh->vertex_count * to->components * sizeof *to->data);
        }
        for (size_t k = 0; k < 3 * (size_t)mesh->face_count; k++)
            *corner++ = done + mesh->indices[k];
        done += mesh->vertex_count;
    }
    return HATCH_OK;
}

enum hatch_status hatch_glb_add_shared(struct hatch_glb *glb, uint32_t first, uint32_t count)
{
    const struct hatch_scene_mesh *meshes = &glb->scene->meshes[first];
    struct hatch_mesh all;
    uint32_t position = glb->view_count, before = 0;
    HATCH_TRY(join(glb, meshes, count, &all));
    hatch_glb_add_attributes(glb, &all);
    for (uint32_t m = 0; m < count; m++) {
        const struct hatch_mesh *mesh = &meshes[m].mesh;
        uint32_t *indices;
        size_t corners = 3 * (size_t)mesh->face_count;
        HATCH_TRY(HATCH_ALLOC_UNSET(glb->scratch, &indices, corners, glb->err));
        for (size_t i = 0; i < corners; i++)
            indices[i] = before + mesh->indices[i];
        before += mesh->vertex_count;
        glb->mesh_first[first + m] = position;
        glb->mesh_indices[first + m] = glb->view_count;
        hatch_glb_add_view(glb, (struct hatch_glb_view){.component = HATCH_GLB_U16,
                                                        .target = HATCH_GLB_INDICES,
                                                        .data = indices,
                                                        .count = corners,
                                                        .components = 1,
                                                        .goes_on = m > 0});
    }
    return HATCH_OK;
}
