/* EXT_mesh_gpu_instancing: each instance of a node's mesh becomes a child of the node. */
#include "io/gltf/reader.h"

#include <cstring>

namespace hatch
{

namespace
{

/* Transforms of the instances of a node; an array is NULL where the file has none. */
struct Transforms {
    float *translation, *rotation, *scale;
    uint32_t count;
};

const tinygltf::Value *attributes_of(const tinygltf::Node &node)
{
    auto found = node.extensions.find("EXT_mesh_gpu_instancing");
    if (node.mesh == -1 || found == node.extensions.end() || !found->second.IsObject() ||
        !found->second.Get("attributes").IsObject())
        return nullptr;
    return &found->second.Get("attributes");
}

enum hatch_status read_transforms(Reader &r, const tinygltf::Value &attributes, const std::string &where,
                                  Transforms *to)
{
    const struct {
        const char *name;
        int components;
        float **data;
    } kinds[] = {{"TRANSLATION", 3, &to->translation}, {"ROTATION", 4, &to->rotation}, {"SCALE", 3, &to->scale}};
    *to = {};
    bool any = false;
    for (const auto &kind : kinds) {
        const tinygltf::Value &accessor = attributes.Get(kind.name);
        uint32_t count;
        if (!accessor.IsInt())
            continue;
        std::string at = where + ", instances' " + kind.name;
        HATCH_TRY(read_floats(r, accessor.GetNumberAsInt(), kind.components, at, kind.data, &count));
        /* An accessor without a view is all zeros, so that a small file could claim any number of instances. */
        if (r.model.accessors[static_cast<size_t>(accessor.GetNumberAsInt())].bufferView == -1)
            return bad(r, at, "its accessor has no buffer view");
        if (any && count != to->count)
            return bad(r, at, std::to_string(count) + " elements, other attributes have " + std::to_string(to->count));
        to->count = count;
        any = true;
    }
    return HATCH_OK;
}

void fill(const Transforms &transforms, uint32_t instance, uint32_t parent, struct hatch_node *node)
{
    *node = {};
    node->parent = parent;
    node->skin = node->camera = node->light = HATCH_NONE;
    node->rotation[3] = node->scale[0] = node->scale[1] = node->scale[2] = 1;
    for (size_t k = 0; transforms.translation && k < 3; k++)
        node->translation[k] = static_cast<double>(transforms.translation[3 * static_cast<size_t>(instance) + k]);
    for (size_t k = 0; transforms.rotation && k < 4; k++)
        node->rotation[k] = static_cast<double>(transforms.rotation[4 * static_cast<size_t>(instance) + k]);
    for (size_t k = 0; transforms.scale && k < 3; k++)
        node->scale[k] = static_cast<double>(transforms.scale[3 * static_cast<size_t>(instance) + k]);
}

/* Makes room for more nodes; if that needs memory, the capacity at least doubles. */
enum hatch_status reserve_nodes(Reader &r, uint32_t more, size_t *capacity)
{
    size_t count = r.scene->node_count;
    if (more > INT32_MAX - count)
        return hatch_fail(r.err, HATCH_LIMIT, "%zu instances and nodes exceed 2^31 - 1", count + more);
    if (count + more <= *capacity)
        return HATCH_OK;
    *capacity = 2 * count + more;
    struct hatch_node *nodes = HATCH_NEW(r.arena, struct hatch_node, *capacity, r.err);
    if (!nodes)
        return HATCH_LIMIT;
    std::memcpy(nodes, r.scene->nodes, count * sizeof *nodes);
    r.scene->nodes = nodes;
    return HATCH_OK;
}

} // namespace

enum hatch_status add_instances(Reader &r)
{
    size_t capacity = r.first_instance = r.scene->node_count;
    for (size_t i = 0; i < r.model.nodes.size(); i++) {
        const tinygltf::Value *attributes = attributes_of(r.model.nodes[i]);
        uint32_t parent = r.node_of[i];
        Transforms transforms;
        if (!attributes || parent == HATCH_NONE)
            continue;
        HATCH_TRY(read_transforms(r, *attributes, place("node", i), &transforms));
        HATCH_TRY(reserve_nodes(r, transforms.count, &capacity));
        struct hatch_node *instanced = &r.scene->nodes[parent];
        for (uint32_t k = 0; k < transforms.count; k++) {
            struct hatch_node *node = &r.scene->nodes[r.scene->node_count++];
            fill(transforms, k, parent, node);
            HATCH_TRY(normalize_rotation(r, node, place("node", i)));
            node->first_mesh = instanced->first_mesh;
            node->mesh_count = instanced->mesh_count;
            node->weights = instanced->weights;
        }
        if (transforms.count > 0)
            instanced->mesh_count = 0;
    }
    return HATCH_OK;
}

} // namespace hatch
