/* Morph targets are applied with their weights at rest, and kept if a node or an animation changes the weights. */
#include "io/gltf/reader.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace hatch
{

namespace
{

/* Returns the weight of a target; 0 for targets that the list does not reach. */
double weight_of(const std::vector<double> &weights, size_t target)
{
    return target < weights.size() ? weights[target] : 0;
}

/* Returns the weights of a node that has a mesh: the node's own, else the mesh's. */
const std::vector<double> &node_weights(const Reader &r, size_t node)
{
    const tinygltf::Node &from = r.model.nodes[node];
    return from.weights.empty() ? r.model.meshes[static_cast<size_t>(from.mesh)].weights : from.weights;
}

/* Returns whether a node gives one of its mesh's targets another weight than at rest. */
bool has_other_weights(const Reader &r, size_t node, const Morph &morph)
{
    const std::vector<double> &own = node_weights(r, node), &rest = *morph.rest;
    for (size_t t = 0; t < morph.targets; t++)
        if (weight_of(own, t) < weight_of(rest, t) || weight_of(own, t) > weight_of(rest, t))
            return true;
    return false;
}

/* Returns the targets of a node's mesh; NULL if it has no mesh. */
Morph *morph_of(const Reader &r, int node)
{
    if (node < 0 || static_cast<size_t>(node) >= r.model.nodes.size())
        return nullptr;
    const int mesh = r.model.nodes[static_cast<size_t>(node)].mesh;
    return mesh >= 0 && static_cast<size_t>(mesh) < r.model.meshes.size() ? &r.morphs[mesh] : nullptr;
}

/* Calls use with the displacements of each target that has the attribute name.
 *   weights  targets of weight 0 are skipped; NULL: no target is skipped */
template <typename Use>
enum hatch_status each_target(Reader &r, const tinygltf::Primitive &primitive, const char *name,
                              const std::vector<double> *weights, const std::string &where, uint32_t count, Use use)
{
    for (size_t t = 0; t < primitive.targets.size(); t++) {
        auto target = primitive.targets[t].find(name);
        struct hatch_arena_mark mark = hatch_arena_mark(r.arena);
        if (target == primitive.targets[t].end() || (weights && static_cast<float>(weight_of(*weights, t)) == 0))
            continue;
        std::string at = where + ", " + place("target", t) + ", " + name;
        float *displacements;
        uint32_t read;
        HATCH_TRY(read_floats(r, target->second, 3, at, &displacements, &read));
        if (read != count)
            return bad(r, at, std::to_string(read) + " elements, POSITION has " + std::to_string(count));
        HATCH_TRY(use(t, displacements, at));
        hatch_arena_rewind(r.arena, mark);
    }
    return HATCH_OK;
}

enum hatch_status apply_at_rest(Reader &r, const tinygltf::Primitive &primitive, const std::vector<double> &weights,
                                const char *name, const std::string &where, struct hatch_mesh *mesh)
{
    float *values = hatch_mesh_find(mesh, name, 3);
    if (!values)
        return HATCH_OK;
    size_t numbers = static_cast<size_t>(mesh->vertex_count) * 3;
    return each_target(r, primitive, name, &weights, where, mesh->vertex_count,
                       [&](size_t t, const float *displacements, const std::string &at) {
                           float weight = static_cast<float>(weight_of(weights, t));
                           for (size_t i = 0; i < numbers; i++) {
                               values[i] += weight * displacements[i];
                               if (!std::isfinite(values[i]))
                                   return bad(r, at, place("element", i / 3) + " is not finite when morphed");
                           }
                           return HATCH_OK;
                       });
}

/* Makes normals unit vectors that a target has moved; those without length stay. */
void normalize_moved(const std::vector<double> &weights, struct hatch_mesh *mesh)
{
    float *normals = hatch_mesh_find(mesh, "NORMAL", 3);
    if (!normals || std::none_of(weights.begin(), weights.end(), [](double weight) { return weight != 0; }))
        return;
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        float *normal = normals + 3 * v, length = std::hypot(normal[0], normal[1], normal[2]);
        for (int k = 0; k < 3 && length > 0; k++)
            normal[k] /= length;
    }
}

enum hatch_status keep_targets(Reader &r, const tinygltf::Primitive &primitive, const char *name, const char *attribute,
                               const std::string &where, struct hatch_mesh *mesh)
{
    size_t width = 3 * primitive.targets.size();
    float *data;
    HATCH_TRY(hatch_mesh_add(r.arena, mesh, attribute, static_cast<uint32_t>(width), &data, r.err));
    return each_target(r, primitive, name, nullptr, where, mesh->vertex_count,
                       [&](size_t t, const float *displacements, const std::string &) {
                           for (size_t v = 0; v < mesh->vertex_count; v++)
                               std::memcpy(data + width * v + 3 * t, displacements + 3 * v, 3 * sizeof *data);
                           return HATCH_OK;
                       });
}

} // namespace

enum hatch_status find_morphs(Reader &r)
{
    const size_t nodes = r.model.nodes.size();
    r.morphs = HATCH_NEW(r.scratch, Morph, r.model.meshes.size(), r.err);
    if (!r.morphs)
        return HATCH_LIMIT;
    for (size_t m = 0; m < r.model.meshes.size(); m++) {
        r.morphs[m].rest = &r.model.meshes[m].weights;
        for (const tinygltf::Primitive &primitive : r.model.meshes[m].primitives)
            if (primitive.mode >= TINYGLTF_MODE_TRIANGLES)
                r.morphs[m].targets = std::max(r.morphs[m].targets, primitive.targets.size());
    }
    for (size_t i = nodes; i-- > 0;) /* backwards: the first node counts */
        if (Morph *morph = morph_of(r, static_cast<int>(i)))
            morph->rest = r.model.nodes[i].weights.empty() ? morph->rest : &r.model.nodes[i].weights;
    for (size_t i = 0; i < nodes; i++)
        if (Morph *morph = morph_of(r, static_cast<int>(i)))
            morph->varies = morph->varies || has_other_weights(r, i, *morph);
    for (const tinygltf::Animation &animation : r.model.animations)
        for (const tinygltf::AnimationChannel &channel : animation.channels)
            if (Morph *morph = morph_of(r, channel.target_node))
                morph->varies = morph->varies || channel.target_path == "weights";
    return HATCH_OK;
}

enum hatch_status read_morph(Reader &r, const tinygltf::Primitive &primitive, size_t index, const std::string &where,
                             struct hatch_mesh *mesh)
{
    const Morph &morph = r.morphs[index];
    const size_t targets = primitive.targets.size();
    if (morph.targets == 0)
        return HATCH_OK;
    HATCH_TRY(apply_at_rest(r, primitive, *morph.rest, "POSITION", where, mesh));
    HATCH_TRY(apply_at_rest(r, primitive, *morph.rest, "NORMAL", where, mesh));
    if (!morph.varies) {
        normalize_moved(*morph.rest, mesh);
        r.notes->morphs_ignored += targets > 0 && primitive.mode >= TINYGLTF_MODE_TRIANGLES;
        return HATCH_OK;
    }
    if (targets != morph.targets)
        return bad(r, where,
                   std::to_string(targets) + " morph targets, another primitive has " + std::to_string(morph.targets));
    HATCH_TRY(keep_targets(r, primitive, "POSITION", HATCH_MORPH_POSITION, where, mesh));
    bool has_normals = false;
    for (const auto &target : primitive.targets)
        has_normals = has_normals || target.count("NORMAL") > 0;
    if (!has_normals || !hatch_mesh_find(mesh, "NORMAL", 3))
        return HATCH_OK;
    return keep_targets(r, primitive, "NORMAL", HATCH_MORPH_NORMAL, where, mesh);
}

enum hatch_status add_moving_normals(Reader &r, size_t index, struct hatch_mesh *mesh)
{
    const Morph &morph = r.morphs[index];
    bool *less = HATCH_NEW(r.scratch, bool, morph.targets, r.err);
    if (!less)
        return HATCH_LIMIT;
    for (size_t t = 0; t < morph.targets; t++)
        less[t] = weight_of(*morph.rest, t) > 0.5;
    return hatch_mesh_add_flat_normals(r.arena, mesh, less, r.err);
}

enum hatch_status set_weights(Reader &r, size_t index, struct hatch_node *node)
{
    uint32_t targets = node->mesh_count ? hatch_mesh_target_count(&r.scene->meshes[node->first_mesh].mesh) : 0;
    if (targets == 0)
        return HATCH_OK;
    const std::vector<double> &own = node_weights(r, index);
    const std::vector<double> &rest = *morph_of(r, static_cast<int>(index))->rest;
    std::vector<double> relative;
    bool any = false;
    for (size_t t = 0; t < targets; t++) {
        relative.push_back(weight_of(own, t) - weight_of(rest, t));
        any = any || relative[t] < 0 || relative[t] > 0;
    }
    if (!any)
        return HATCH_OK;
    node->weights = HATCH_NEW(r.arena, float, targets, r.err);
    return node->weights ? copy_numbers(r, relative, targets, place("node", index), "weights", node->weights)
                         : HATCH_LIMIT;
}

enum hatch_status shift_weights(Reader &r, size_t node, const std::string &where,
                                struct hatch_animation_channel *channel)
{
    const std::vector<double> &rest = *morph_of(r, static_cast<int>(node))->rest;
    size_t n = channel->targets, groups = channel->interpolation == HATCH_CUBIC ? 3 : 1;
    for (size_t k = 0; k < channel->key_count; k++)
        for (size_t t = 0; t < n; t++) {
            float *value = channel->values + (groups * k + groups / 2) * n + t;
            *value -= static_cast<float>(weight_of(rest, t));
            if (!std::isfinite(*value))
                return bad(r, where, place("value", k) + " is not finite");
        }
    return HATCH_OK;
}

} // namespace hatch
