/* Writes the binary chunk of a GLB: one buffer with a view for each vertex attribute, index list, morph target, skin,
 * animation input and output, and image. */
#include <assert.h>
#include <string.h>

#include "io/glb/parts.h"

void hatch_glb_add_view(struct hatch_glb *glb, struct hatch_glb_view view)
{
    const struct hatch_glb_view *before = view.goes_on ? &glb->views[glb->view_count - 1] : NULL;
    view.offset = before ? before->offset + before->size : glb->size;
    view.size = view.count * hatch_glb_stride(&view);
    glb->size = (view.offset + view.size + 3) / 4 * 4;
    glb->views[glb->view_count++] = view;
}

static void add_floats(struct hatch_glb *glb, const float *data, size_t count, uint32_t components, bool bounds)
{
    hatch_glb_add_view(
        glb, (struct hatch_glb_view){
                 .component = HATCH_GLB_F32, .data = data, .count = count, .components = components, .bounds = bounds});
}

uint32_t hatch_glb_order(const struct hatch_mesh *mesh, uint32_t order[HATCH_MESH_ATTRIBUTES_MAX])
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < mesh->attribute_count; i++) {
        const char *name = mesh->attributes[i].name;
        if (strcmp(name, HATCH_MORPH_POSITION) == 0 || strcmp(name, HATCH_MORPH_NORMAL) == 0)
            continue;
        uint32_t at = count++;
        for (; at > 1 && strcmp(mesh->attributes[order[at - 1]].name, name) > 0; at--)
            order[at] = order[at - 1];
        order[at] = i;
    }
    return count;
}

/* Adds a view of one morph target. Its displacements are copied from the attribute, in which all targets are
 * interleaved. */
static enum hatch_status add_target(struct hatch_glb *glb, const struct hatch_mesh *mesh,
                                    const struct hatch_mesh_attribute *targets, uint32_t target, bool bounds)
{
    float *data;
    HATCH_TRY(HATCH_ALLOC(glb->scratch, &data, (size_t)mesh->vertex_count * 3, glb->err));
    for (size_t v = 0; v < mesh->vertex_count; v++)
        memcpy(&data[3 * v], &targets->data[targets->components * v + 3 * target], 3 * sizeof *data);
    hatch_glb_add_view(glb, (struct hatch_glb_view){.component = HATCH_GLB_F32,
                                                    .target = HATCH_GLB_VERTICES,
                                                    .data = data,
                                                    .count = mesh->vertex_count,
                                                    .components = 3,
                                                    .bounds = bounds});
    return HATCH_OK;
}

void hatch_glb_add_attributes(struct hatch_glb *glb, const struct hatch_mesh *mesh)
{
    uint32_t order[HATCH_MESH_ATTRIBUTES_MAX], count = hatch_glb_order(mesh, order);
    for (uint32_t i = 0; i < count; i++) {
        const struct hatch_mesh_attribute *a = &mesh->attributes[order[i]];
        struct hatch_glb_view view = {.target = HATCH_GLB_VERTICES,
                                      .data = a->data,
                                      .count = mesh->vertex_count,
                                      .components = a->components,
                                      .bounds = i == 0};
        hatch_glb_choose_numbers(glb, mesh, a, &view);
        hatch_glb_add_view(glb, view);
    }
}

/* Adds the views of a primitive's attributes, indices and morph targets.
 *   indices  out: index of the accessor of its indices */
static enum hatch_status add_primitive(struct hatch_glb *glb, const struct hatch_mesh *mesh, size_t index_count,
                                       uint32_t *indices)
{
    hatch_glb_add_attributes(glb, mesh);
    *indices = glb->view_count;
    /* The largest value of an index type is reserved for primitive restart. */
    hatch_glb_add_view(
        glb, (struct hatch_glb_view){.component = mesh->vertex_count <= UINT16_MAX ? HATCH_GLB_U16 : HATCH_GLB_U32,
                                     .target = HATCH_GLB_INDICES,
                                     .data = mesh->indices,
                                     .count = index_count,
                                     .components = 1});
    const struct hatch_mesh_attribute *normals = hatch_mesh_attribute(mesh, HATCH_MORPH_NORMAL);
    for (uint32_t t = 0; t < hatch_mesh_target_count(mesh); t++) {
        HATCH_TRY(add_target(glb, mesh, hatch_mesh_attribute(mesh, HATCH_MORPH_POSITION), t, true));
        if (normals)
            HATCH_TRY(add_target(glb, mesh, normals, t, false));
    }
    return HATCH_OK;
}

/* Lists the primitives that hold the strokes of a mesh: the parts of its sets.
 *   lines  out: NULL: they are only counted
 * Returns their number. */
static uint32_t list_lines(const struct hatch_curves *curves, struct hatch_glb_lines *lines)
{
    uint32_t count = 0;
    for (uint32_t s = 0; s < curves->set_count; s++) {
        const struct hatch_curve_set *set = &curves->sets[s];
        for (uint32_t first = set->first; first < set->first + set->count; count++) {
            struct hatch_curve_set part = hatch_curve_set_part(curves, set, first);
            if (lines)
                lines[count].part = part;
            first += part.count;
        }
    }
    return count;
}

static enum hatch_status add_mesh(struct hatch_glb *glb, uint32_t index)
{
    const struct hatch_scene_mesh *from = &glb->scene->meshes[index];
    struct hatch_glb_lines *lines;
    HATCH_TRY(add_primitive(glb, &from->mesh, 3 * (size_t)from->mesh.face_count, &glb->mesh_indices[index]));
    HATCH_TRY(HATCH_ALLOC(glb->scratch, &lines, glb->line_count[index], glb->err));
    glb->lines[index] = lines;
    list_lines(&from->curves, lines);
    for (uint32_t i = 0; i < glb->line_count[index]; i++) {
        uint32_t count;
        HATCH_TRY(hatch_curves_as_vertices(&from->curves, &lines[i].part, &from->mesh, glb->scratch, &lines[i].vertices,
                                           &count, glb->err));
        lines[i].first = glb->view_count;
        HATCH_TRY(add_primitive(glb, &lines[i].vertices, 2 * (size_t)count, &lines[i].indices));
    }
    return HATCH_OK;
}

/* The meshes of a node become one glTF mesh; a mesh that no node uses becomes a glTF mesh by itself. */
static enum hatch_status plan_meshes(struct hatch_glb *glb)
{
    const struct hatch_scene *scene = glb->scene;
    for (uint32_t n = 0; n < scene->node_count; n++) {
        const struct hatch_node *node = &scene->nodes[n];
        if (node->mesh_count == 0)
            continue;
        uint32_t *size = &glb->group_size[node->first_mesh];
        assert(*size == 0 || *size == node->mesh_count);
        *size = node->mesh_count;
    }
    uint32_t groups = 0, end = 0, shared_end = 0;
    for (uint32_t m = 0; m < scene->mesh_count; m++) {
        const struct hatch_mesh *mesh = &scene->meshes[m].mesh;
        assert(m >= end || glb->group_size[m] == 0);
        if (m >= end) {
            if (glb->group_size[m] == 0)
                glb->group_size[m] = 1;
            end = m + glb->group_size[m];
            bool faces = false;
            for (uint32_t i = m; i < end; i++)
                faces = faces || scene->meshes[i].mesh.face_count > 0;
            glb->group[m] = faces ? groups++ : HATCH_NONE;
        }
        if (m < shared_end)
            continue;
        uint32_t shared = hatch_glb_count_shared(glb, m, end);
        shared_end = m + shared;
        glb->mesh_first[m] = mesh->face_count > 0 ? glb->view_count : HATCH_NONE;
        if (shared > 1)
            HATCH_TRY(hatch_glb_add_shared(glb, m, shared));
        else if (mesh->face_count > 0)
            HATCH_TRY(add_mesh(glb, m));
    }
    return HATCH_OK;
}

static void plan_motion(struct hatch_glb *glb)
{
    const struct hatch_scene *scene = glb->scene;
    uint32_t skins = 0;
    glb->skin_first = glb->view_count;
    for (uint32_t s = 0; s < scene->skin_count; s++) {
        const struct hatch_skin *skin = &scene->skins[s];
        glb->skin[s] = skin->joint_count > 0 ? skins++ : HATCH_NONE;
        if (skin->joint_count > 0)
            add_floats(glb, skin->inverse_bind, skin->joint_count, 16, false);
    }
    glb->channel_first = glb->view_count;
    for (uint32_t a = 0; a < scene->animation_count; a++)
        for (uint32_t c = 0; c < scene->animations[a].channel_count; c++) {
            const struct hatch_animation_channel *channel = &scene->animations[a].channels[c];
            size_t values = (size_t)channel->key_count * (channel->interpolation == HATCH_CUBIC ? 3 : 1);
            uint32_t components = hatch_channel_width(channel);
            if (channel->path == HATCH_PATH_WEIGHTS) {
                values *= components;
                components = 1;
            }
            add_floats(glb, channel->times_s, channel->key_count, 1, true);
            add_floats(glb, channel->values, values, components, false);
        }
}

static size_t count_views(const struct hatch_glb *glb)
{
    const struct hatch_scene *scene = glb->scene;
    size_t count = (size_t)scene->skin_count + scene->texture_count;
    for (uint32_t m = 0; m < scene->mesh_count; m++)
        count += (glb->line_count[m] + (size_t)1) *
                 (HATCH_MESH_ATTRIBUTES_MAX + 1 + 2 * (size_t)hatch_mesh_target_count(&scene->meshes[m].mesh));
    for (uint32_t a = 0; a < scene->animation_count; a++)
        count += 2 * (size_t)scene->animations[a].channel_count;
    return count;
}

enum hatch_status hatch_glb_plan(struct hatch_glb *glb)
{
    const struct hatch_scene *scene = glb->scene;
    uint32_t **lists[] = {&glb->group_size, &glb->group, &glb->mesh_first, &glb->mesh_indices,
                          &glb->line_count, &glb->skin,  &glb->image,      &glb->image_texture};
    const size_t sizes[] = {scene->mesh_count, scene->mesh_count, scene->mesh_count,    scene->mesh_count,
                            scene->mesh_count, scene->skin_count, scene->texture_count, scene->texture_count};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        HATCH_TRY(HATCH_ALLOC(glb->scratch, lists[i], sizes[i], glb->err));
    }
    HATCH_TRY(HATCH_ALLOC(glb->scratch, &glb->lines, scene->mesh_count, glb->err));
    for (uint32_t m = 0; m < scene->mesh_count; m++)
        glb->line_count[m] = list_lines(&scene->meshes[m].curves, NULL);
    HATCH_TRY(HATCH_ALLOC(glb->scratch, &glb->views, count_views(glb), glb->err));
    HATCH_TRY(plan_meshes(glb));
    plan_motion(glb);
    glb->accessor_count = glb->view_count;
    for (uint32_t i = 0; i < glb->view_count; i++)
        glb->image_view += !glb->views[i].goes_on;
    return hatch_glb_plan_textures(glb);
}

static enum hatch_status print_bounds(struct hatch_glb *glb, const struct hatch_glb_view *view)
{
    const float *values = view->data;
    float low[4], high[4];
    memcpy(low, values, view->components * sizeof *low);
    memcpy(high, values, view->components * sizeof *high);
    for (size_t i = 0; i < view->count; i++)
        for (uint32_t c = 0; c < view->components; c++) {
            float value = values[i * view->components + c];
            low[c] = value < low[c] ? value : low[c];
            high[c] = value > high[c] ? value : high[c];
        }
    HATCH_TRY(hatch_glb_numbers(glb, "min", low, view->components));
    return hatch_glb_numbers(glb, "max", high, view->components);
}

static enum hatch_status print_accessors(struct hatch_glb *glb)
{
    static const char *const types[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
    HATCH_TRY(hatch_glb_open_array(glb, "accessors"));
    size_t begin = 0; /* of the buffer view */
    for (uint32_t i = 0, views = 0; i < glb->accessor_count; i++) {
        const struct hatch_glb_view *view = &glb->views[i];
        views += !view->goes_on;
        begin = view->goes_on ? begin : view->offset;
        HATCH_TRY(hatch_glb_comma(glb));
        HATCH_TRY(hatch_buffer_print(&glb->json, glb->err, "{\"bufferView\":%u", views - 1));
        if (view->goes_on)
            HATCH_TRY(hatch_buffer_print(&glb->json, glb->err, ",\"byteOffset\":%zu", view->offset - begin));
        HATCH_TRY(hatch_buffer_print(&glb->json, glb->err, ",\"componentType\":%d,\"count\":%zu,\"type\":\"%s\"",
                                     (int)view->component, view->count,
                                     view->components == 16 ? "MAT4" : types[view->components - 1]));
        if (view->bounds)
            HATCH_TRY(print_bounds(glb, view));
        HATCH_TRY(hatch_glb_put(glb, view->normalized ? ",\"normalized\":true}" : "}"));
    }
    return hatch_glb_put(glb, "]");
}

enum hatch_status hatch_glb_print_views(struct hatch_glb *glb)
{
    if (glb->accessor_count > 0)
        HATCH_TRY(print_accessors(glb));
    if (glb->view_count == 0)
        return HATCH_OK;
    HATCH_TRY(hatch_glb_open_array(glb, "bufferViews"));
    for (uint32_t i = 0; i < glb->view_count; i++) {
        const struct hatch_glb_view *view = &glb->views[i];
        size_t end = view->offset + view->size;
        if (view->goes_on)
            continue;
        for (uint32_t k = i + 1; k < glb->view_count && glb->views[k].goes_on; k++)
            end = glb->views[k].offset + glb->views[k].size;
        HATCH_TRY(hatch_glb_comma(glb));
        HATCH_TRY(hatch_buffer_print(&glb->json, glb->err, "{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu",
                                     view->offset, end - view->offset));
        if (view->components * hatch_glb_number_bytes(view->component) < hatch_glb_stride(view))
            HATCH_TRY(hatch_buffer_print(&glb->json, glb->err, ",\"byteStride\":%zu", hatch_glb_stride(view)));
        if (view->target)
            HATCH_TRY(hatch_buffer_print(&glb->json, glb->err, ",\"target\":%d", (int)view->target));
        HATCH_TRY(hatch_glb_put(glb, "}"));
    }
    return hatch_buffer_print(&glb->json, glb->err, "],\"buffers\":[{\"byteLength\":%zu}]", glb->size);
}

void hatch_glb_put_views(const struct hatch_glb *glb, uint8_t *at)
{
    for (uint32_t i = 0; i < glb->view_count; i++) {
        const struct hatch_glb_view *view = &glb->views[i];
        if (view->component == HATCH_GLB_U8)
            memcpy(at + view->offset, view->data, view->size);
        else
            hatch_glb_put_numbers(view, at + view->offset);
    }
}
