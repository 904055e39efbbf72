/* Prints the JSON of nodes, meshes, skins and animations; default values are left out. */
#include <string.h>

#include "io/glb/parts.h"

/* Writes a comma where one is needed, and an opening brace. */
static enum hatch_status open_item(struct hatch_glb *glb)
{
    HATCH_TRY(hatch_glb_comma(glb));
    return hatch_glb_put(glb, "{");
}

/* The children of each node as a list in ascending order: first child, then next sibling, or HATCH_NONE. The list of
 * root nodes begins at first[node_count]. */
struct children {
    uint32_t *first, *next;
};

static enum hatch_status find_children(struct hatch_glb *glb, struct children *children)
{
    uint32_t count = glb->scene->node_count;
    uint8_t *coarser; /* per node: 1 for one that stands for another */
    HATCH_TRY(HATCH_ALLOC(glb->scratch, &coarser, count, glb->err));
    for (uint32_t i = 0; i < glb->scene->lod_count; i++)
        memset(coarser + glb->scene->lods[i].first, 1, glb->scene->lods[i].count);
    HATCH_TRY(HATCH_ALLOC(glb->scratch, &children->first, (size_t)count + 1, glb->err));
    HATCH_TRY(HATCH_ALLOC(glb->scratch, &children->next, count, glb->err));
    for (uint32_t i = 0; i <= count; i++)
        children->first[i] = HATCH_NONE;
    for (uint32_t i = count; i-- > 0;) {
        if (coarser[i])
            continue;
        uint32_t parent = glb->scene->nodes[i].parent;
        uint32_t *first = &children->first[parent == HATCH_NONE ? count : parent];
        children->next[i] = *first;
        *first = i;
    }
    return HATCH_OK;
}

static enum hatch_status print_children(struct hatch_glb *glb, const char *key, const struct children *children,
                                        uint32_t parent)
{
    if (children->first[parent] == HATCH_NONE)
        return HATCH_OK;
    HATCH_TRY(hatch_glb_open_array(glb, key));
    for (uint32_t i = children->first[parent]; i != HATCH_NONE; i = children->next[i]) {
        HATCH_TRY(hatch_glb_comma(glb));
        HATCH_TRY(hatch_buffer_print(&glb->json, glb->err, "%u", i));
    }
    return hatch_glb_put(glb, "]");
}

static enum hatch_status print_transform(struct hatch_glb *glb, const struct hatch_node *node)
{
    static const double no_translation[3], no_rotation[4] = {0, 0, 0, 1}, no_scale[3] = {1, 1, 1};
    if (node->has_matrix)
        return hatch_glb_doubles(glb, "matrix", node->matrix, 16);
    if (memcmp(node->translation, no_translation, sizeof no_translation) != 0)
        HATCH_TRY(hatch_glb_doubles(glb, "translation", node->translation, 3));
    if (memcmp(node->rotation, no_rotation, sizeof no_rotation) != 0)
        HATCH_TRY(hatch_glb_doubles(glb, "rotation", node->rotation, 4));
    if (memcmp(node->scale, no_scale, sizeof no_scale) != 0)
        HATCH_TRY(hatch_glb_doubles(glb, "scale", node->scale, 3));
    return HATCH_OK;
}

/* Prints the light and the levels of detail of a node, and closes it. */
static enum hatch_status close_node(struct hatch_glb *glb, uint32_t index)
{
    const struct hatch_scene *scene = glb->scene;
    const struct hatch_lod *lod = NULL;
    uint32_t light = scene->nodes[index].light;
    for (uint32_t i = 0; i < scene->lod_count && !lod; i++)
        lod = scene->lods[i].node == index ? &scene->lods[i] : NULL;
    if (light == HATCH_NONE && !lod)
        return hatch_glb_close_kept(glb, &scene->nodes[index].kept);
    HATCH_TRY(hatch_glb_key(glb, "extensions"));
    HATCH_TRY(hatch_glb_put(glb, "{"));
    if (light != HATCH_NONE)
        HATCH_TRY(hatch_buffer_print(&glb->json, glb->err, "\"KHR_lights_punctual\":{\"light\":%u}", light));
    if (!lod) {
        HATCH_TRY(hatch_glb_put(glb, "}"));
        return hatch_glb_close_kept(glb, &scene->nodes[index].kept);
    }
    HATCH_TRY(hatch_glb_put(glb, light != HATCH_NONE ? ",\"MSFT_lod\":{" : "\"MSFT_lod\":{"));
    HATCH_TRY(hatch_glb_open_array(glb, "ids"));
    for (uint32_t i = 0; i < lod->count; i++)
        HATCH_TRY(hatch_buffer_print(&glb->json, glb->err, i ? ",%u" : "%u", lod->first + i));
    HATCH_TRY(hatch_glb_put(glb, "]}},\"extras\":{"));
    HATCH_TRY(hatch_glb_numbers(glb, "MSFT_screencoverage", lod->coverage, lod->count + 1));
    HATCH_TRY(hatch_glb_close_extras(glb, &scene->nodes[index].kept));
    return hatch_glb_put(glb, "}");
}

static enum hatch_status print_node(struct hatch_glb *glb, uint32_t index, const struct children *children)
{
    const struct hatch_node *node = &glb->scene->nodes[index];
    HATCH_TRY(hatch_glb_open_named(glb, &node->kept));
    HATCH_TRY(print_children(glb, "children", children, index));
    HATCH_TRY(print_transform(glb, node));
    if (node->mesh_count > 0 && glb->group[node->first_mesh] != HATCH_NONE) {
        HATCH_TRY(hatch_glb_integer(glb, "mesh", glb->group[node->first_mesh]));
        if (node->skin != HATCH_NONE)
            HATCH_TRY(hatch_glb_integer(glb, "skin", glb->skin[node->skin]));
        uint32_t targets = hatch_mesh_target_count(&glb->scene->meshes[node->first_mesh].mesh);
        if (node->weights && targets > 0)
            HATCH_TRY(hatch_glb_numbers(glb, "weights", node->weights, targets));
    }
    if (node->camera != HATCH_NONE)
        HATCH_TRY(hatch_glb_integer(glb, "camera", node->camera));
    return close_node(glb, index);
}

enum hatch_status hatch_glb_print_nodes(struct hatch_glb *glb)
{
    struct children children;
    uint32_t count = glb->scene->node_count;
    HATCH_TRY(find_children(glb, &children));
    HATCH_TRY(hatch_glb_put(glb, ",\"scene\":0,\"scenes\":["));
    HATCH_TRY(hatch_glb_open_named(glb, &glb->scene->kept));
    HATCH_TRY(print_children(glb, "nodes", &children, count));
    HATCH_TRY(hatch_glb_close_kept(glb, &glb->scene->kept));
    HATCH_TRY(hatch_glb_put(glb, "]"));
    if (count == 0)
        return HATCH_OK;
    HATCH_TRY(hatch_glb_open_array(glb, "nodes"));
    for (uint32_t i = 0; i < count; i++)
        HATCH_TRY(print_node(glb, i, &children));
    return hatch_glb_put(glb, "]");
}

static enum hatch_status print_targets(struct hatch_glb *glb, const struct hatch_mesh *mesh, uint32_t accessor)
{
    bool has_normals = hatch_mesh_attribute(mesh, HATCH_MORPH_NORMAL) != NULL;
    uint32_t targets = hatch_mesh_target_count(mesh);
    if (targets == 0)
        return HATCH_OK;
    HATCH_TRY(hatch_glb_open_array(glb, "targets"));
    for (uint32_t t = 0; t < targets; t++) {
        HATCH_TRY(open_item(glb));
        HATCH_TRY(hatch_glb_integer(glb, "POSITION", accessor++));
        if (has_normals)
            HATCH_TRY(hatch_glb_integer(glb, "NORMAL", accessor++));
        HATCH_TRY(hatch_glb_put(glb, "}"));
    }
    return hatch_glb_put(glb, "]");
}

/* Prints attributes, indices and morph targets.
 *   first    index of the accessor of POSITION
 *   indices  of that of the indices, which those of the targets follow */
static enum hatch_status print_accessors(struct hatch_glb *glb, const struct hatch_mesh *mesh, uint32_t first,
                                         uint32_t indices)
{
    uint32_t order[HATCH_MESH_ATTRIBUTES_MAX], count = hatch_glb_order(mesh, order);
    HATCH_TRY(hatch_glb_key(glb, "attributes"));
    HATCH_TRY(hatch_glb_put(glb, "{"));
    for (uint32_t i = 0; i < count; i++) {
        HATCH_TRY(hatch_glb_escaped_key(glb, mesh->attributes[order[i]].name));
        HATCH_TRY(hatch_buffer_print(&glb->json, glb->err, "%u", first + i));
    }
    HATCH_TRY(hatch_glb_put(glb, "}"));
    HATCH_TRY(hatch_glb_integer(glb, "indices", indices));
    return print_targets(glb, mesh, indices + 1);
}

/* Prints the strokes of a mesh: primitives of mode LINES. */
static enum hatch_status print_strokes(struct hatch_glb *glb, uint32_t index)
{
    const struct hatch_curves *curves = &glb->scene->meshes[index].curves;
    for (uint32_t i = 0; i < glb->line_count[index]; i++) {
        const struct hatch_glb_lines *lines = &glb->lines[index][i];
        HATCH_TRY(open_item(glb));
        HATCH_TRY(print_accessors(glb, &lines->vertices, lines->first, lines->indices));
        HATCH_TRY(hatch_glb_integer(glb, "mode", 1));
        HATCH_TRY(hatch_glb_put(glb, ",\"extras\":{\"hatch\":{"));
        HATCH_TRY(hatch_glb_integer(glb, "family", lines->part.family));
        HATCH_TRY(hatch_glb_integer(glb, "level", lines->part.level));
        HATCH_TRY(hatch_glb_number(glb, "angle", lines->part.angle_rad));
        HATCH_TRY(hatch_glb_number(glb, "gap", lines->part.gap));
        if (lines->part.length > 0)
            HATCH_TRY(hatch_glb_number(glb, "length", lines->part.length));
        if (lines->part.hard_rad >= 0)
            HATCH_TRY(hatch_glb_number(glb, "hard", lines->part.hard_rad));
        if (curves->needs > 0) {
            HATCH_TRY(hatch_glb_number(glb, "needs", curves->needs));
            HATCH_TRY(hatch_glb_number(glb, "finest", curves->finest));
        }
        HATCH_TRY(hatch_glb_put(glb, "}}}"));
    }
    return HATCH_OK;
}

/* Closes a primitive with its extras. Those that are no object are kept, without a mark of computed normals. */
static enum hatch_status close_primitive(struct hatch_glb *glb, const struct hatch_scene_mesh *from)
{
    bool has_room = !from->kept.extras || from->kept.extras[0] == '{';
    bool computed = has_room && from->normals_computed && hatch_mesh_find(&from->mesh, "NORMAL", 3);
    if (!(from->unseen_tolerance > 0) && !computed)
        return hatch_glb_close_kept(glb, &from->kept);
    HATCH_TRY(hatch_glb_put(glb, ",\"extras\":{\"hatch\":{"));
    if (from->unseen_tolerance > 0)
        HATCH_TRY(hatch_glb_number(glb, "unseen", from->unseen_tolerance));
    if (computed)
        HATCH_TRY(hatch_glb_string(glb, "normals", "computed"));
    HATCH_TRY(hatch_glb_put(glb, "}"));
    HATCH_TRY(hatch_glb_close_extras(glb, &from->kept));
    return hatch_glb_put(glb, "}");
}

static enum hatch_status print_primitive(struct hatch_glb *glb, uint32_t index)
{
    const struct hatch_scene_mesh *from = &glb->scene->meshes[index];
    HATCH_TRY(open_item(glb));
    HATCH_TRY(print_accessors(glb, &from->mesh, glb->mesh_first[index], glb->mesh_indices[index]));
    if (from->material != HATCH_NONE)
        HATCH_TRY(hatch_glb_integer(glb, "material", from->material));
    HATCH_TRY(close_primitive(glb, from));
    return print_strokes(glb, index);
}

static enum hatch_status print_mesh(struct hatch_glb *glb, uint32_t first)
{
    const struct hatch_kept *whole = &glb->scene->meshes[first].whole;
    HATCH_TRY(hatch_glb_open_named(glb, whole));
    HATCH_TRY(hatch_glb_open_array(glb, "primitives"));
    for (uint32_t i = first; i < first + glb->group_size[first]; i++)
        if (glb->mesh_first[i] != HATCH_NONE)
            HATCH_TRY(print_primitive(glb, i));
    HATCH_TRY(hatch_glb_put(glb, "]"));
    return hatch_glb_close_kept(glb, whole);
}

enum hatch_status hatch_glb_print_meshes(struct hatch_glb *glb)
{
    bool any = false;
    for (uint32_t m = 0; m < glb->scene->mesh_count; m += glb->group_size[m]) {
        if (glb->group[m] == HATCH_NONE)
            continue;
        if (!any)
            HATCH_TRY(hatch_glb_open_array(glb, "meshes"));
        any = true;
        HATCH_TRY(print_mesh(glb, m));
    }
    return any ? hatch_glb_put(glb, "]") : HATCH_OK;
}

static enum hatch_status print_skin(struct hatch_glb *glb, uint32_t index)
{
    const struct hatch_skin *skin = &glb->scene->skins[index];
    HATCH_TRY(hatch_glb_open_named(glb, &skin->kept));
    HATCH_TRY(hatch_glb_integer(glb, "inverseBindMatrices", glb->skin_first + glb->skin[index]));
    HATCH_TRY(hatch_glb_open_array(glb, "joints"));
    for (uint32_t j = 0; j < skin->joint_count; j++) {
        HATCH_TRY(hatch_glb_comma(glb));
        HATCH_TRY(hatch_buffer_print(&glb->json, glb->err, "%u", skin->joints[j]));
    }
    HATCH_TRY(hatch_glb_put(glb, "]"));
    return hatch_glb_close_kept(glb, &skin->kept);
}

/* Prints an animation. Each channel has its own sampler, with the same index. */
static enum hatch_status print_animation(struct hatch_glb *glb, const struct hatch_animation *animation,
                                         uint32_t accessor)
{
    static const char *const paths[] = {"translation", "rotation", "scale", "weights"};
    static const char *const interpolations[] = {"STEP", "LINEAR", "CUBICSPLINE"};
    HATCH_TRY(hatch_glb_open_named(glb, &animation->kept));
    HATCH_TRY(hatch_glb_open_array(glb, "channels"));
    for (uint32_t c = 0; c < animation->channel_count; c++) {
        const struct hatch_animation_channel *channel = &animation->channels[c];
        HATCH_TRY(hatch_glb_comma(glb));
        HATCH_TRY(hatch_buffer_print(&glb->json, glb->err, "{\"sampler\":%u,\"target\":{\"node\":%u,\"path\":\"%s\"}}",
                                     c, channel->node, paths[channel->path]));
    }
    HATCH_TRY(hatch_glb_put(glb, "]"));
    HATCH_TRY(hatch_glb_open_array(glb, "samplers"));
    for (uint32_t c = 0; c < animation->channel_count; c++, accessor += 2) {
        HATCH_TRY(hatch_glb_comma(glb));
        HATCH_TRY(hatch_buffer_print(&glb->json, glb->err, "{\"input\":%u,\"interpolation\":\"%s\",\"output\":%u}",
                                     accessor, interpolations[animation->channels[c].interpolation], accessor + 1));
    }
    HATCH_TRY(hatch_glb_put(glb, "]"));
    return hatch_glb_close_kept(glb, &animation->kept);
}

enum hatch_status hatch_glb_print_motion(struct hatch_glb *glb)
{
    const struct hatch_scene *scene = glb->scene;
    bool any = false;
    for (uint32_t s = 0; s < scene->skin_count; s++) {
        if (glb->skin[s] == HATCH_NONE)
            continue;
        if (!any)
            HATCH_TRY(hatch_glb_open_array(glb, "skins"));
        any = true;
        HATCH_TRY(print_skin(glb, s));
    }
    HATCH_TRY(hatch_glb_put(glb, any ? "]" : ""));
    any = false;
    uint32_t accessor = glb->channel_first;
    for (uint32_t a = 0; a < scene->animation_count; a++) {
        if (scene->animations[a].channel_count == 0)
            continue;
        if (!any)
            HATCH_TRY(hatch_glb_open_array(glb, "animations"));
        any = true;
        HATCH_TRY(print_animation(glb, &scene->animations[a], accessor));
        accessor += 2 * scene->animations[a].channel_count;
    }
    return hatch_glb_put(glb, any ? "]" : "");
}
