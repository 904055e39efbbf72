#include "io/gltf/reader.h"

#include <cstring>

namespace hatch
{

namespace
{

enum hatch_status read_skin(Reader &r, size_t index, struct hatch_skin *skin)
{
    const tinygltf::Skin &from = r.model.skins[index];
    std::string where = place("skin", index);
    uint32_t count = static_cast<uint32_t>(from.joints.size()), matrices = 0;
    if (count == 0)
        return bad(r, where, "no joints");
    HATCH_TRY(keep(r, from, nullptr, &skin->kept));
    skin->joints = HATCH_NEW(r.arena, uint32_t, count, r.err);
    if (!skin->joints)
        return HATCH_LIMIT;
    bool in_scene = true;
    for (uint32_t j = 0; j < count; j++) {
        if (from.joints[j] < 0 || static_cast<size_t>(from.joints[j]) >= r.model.nodes.size())
            return bad(r, where, "joint " + std::to_string(j) + " is not a node");
        skin->joints[j] = r.node_of[from.joints[j]];
        in_scene = in_scene && skin->joints[j] != HATCH_NONE;
    }
    if (from.inverseBindMatrices != -1) {
        HATCH_TRY(read_floats(r, from.inverseBindMatrices, 16, where, &skin->inverse_bind, &matrices));
        if (matrices < count)
            return bad(r, where, std::to_string(matrices) + " matrices for " + std::to_string(count) + " joints");
    } else {
        skin->inverse_bind = HATCH_NEW(r.arena, float, static_cast<size_t>(count) * 16, r.err);
        if (!skin->inverse_bind)
            return HATCH_LIMIT;
        for (size_t i = 0; i < static_cast<size_t>(count) * 4; i++)
            skin->inverse_bind[i / 4 * 16 + i % 4 * 5] = 1;
    }
    /* A skin with a joint outside the scene stays empty; a mesh that uses it is an error. */
    skin->joint_count = in_scene ? count : 0;
    return HATCH_OK;
}

enum hatch_status read_times(Reader &r, int accessor, const std::string &where, struct hatch_animation_channel *channel)
{
    HATCH_TRY(read_floats(r, accessor, 1, where + ", input", &channel->times_s, &channel->key_count));
    for (uint32_t k = 0; k < channel->key_count; k++)
        if (channel->times_s[k] < 0 || (k > 0 && channel->times_s[k] < channel->times_s[k - 1]))
            return bad(r, where, "time " + std::to_string(k) + " is negative or less than the previous one");
    return HATCH_OK;
}

enum hatch_status read_values(Reader &r, const tinygltf::AnimationSampler &sampler, const std::string &where,
                              struct hatch_animation_channel *channel)
{
    if (sampler.interpolation == "STEP")
        channel->interpolation = HATCH_STEP;
    else if (sampler.interpolation == "CUBICSPLINE")
        channel->interpolation = HATCH_CUBIC;
    else if (sampler.interpolation == "LINEAR")
        channel->interpolation = HATCH_LINEAR;
    else
        return bad(r, where,
                   "interpolation " + sampler.interpolation + " is unknown, want STEP, LINEAR or CUBICSPLINE");
    uint32_t count;
    bool weights = channel->path == HATCH_PATH_WEIGHTS;
    int components = weights ? 1 : static_cast<int>(hatch_channel_width(channel));
    HATCH_TRY(read_floats(r, sampler.output, components, where + ", output", &channel->values, &count));
    uint64_t want = static_cast<uint64_t>(channel->key_count) * (channel->interpolation == HATCH_CUBIC ? 3 : 1) *
                    (weights ? channel->targets : 1);
    if (count != want)
        return bad(r, where, std::to_string(count) + " values, want " + std::to_string(want));
    return HATCH_OK;
}

/* Nodes that show the meshes of a node: itself or its instances. */
struct Shown {
    uint32_t first, count;
};

Shown shown_by(const Reader &r, uint32_t node)
{
    uint32_t first = r.first_instance, end;
    while (first < r.scene->node_count && r.scene->nodes[first].parent != node)
        first++;
    for (end = first; end < r.scene->node_count && r.scene->nodes[end].parent == node;)
        end++;
    return node == HATCH_NONE || end == first ? Shown{node, 1} : Shown{first, end - first};
}

/* Fills channel. Leaves key_count 0 when the target is not in the scene or there is nothing to animate. */
enum hatch_status read_channel(Reader &r, const tinygltf::Animation &animation, size_t index, const std::string &where,
                               struct hatch_animation_channel *channel)
{
    const tinygltf::AnimationChannel &from = animation.channels[index];
    if (from.sampler < 0 || static_cast<size_t>(from.sampler) >= animation.samplers.size())
        return bad(r, where,
                   "sampler " + std::to_string(from.sampler) + " does not exist, there are " +
                       std::to_string(animation.samplers.size()));
    HATCH_TRY(check_index(r, from.target_node, r.model.nodes.size(), where, "node"));
    const tinygltf::AnimationSampler &sampler = animation.samplers[static_cast<size_t>(from.sampler)];
    if (from.target_path == "translation")
        channel->path = HATCH_PATH_TRANSLATION;
    else if (from.target_path == "rotation")
        channel->path = HATCH_PATH_ROTATION;
    else if (from.target_path == "scale")
        channel->path = HATCH_PATH_SCALE;
    else if (from.target_path == "weights")
        channel->path = HATCH_PATH_WEIGHTS;
    else
        return HATCH_OK; /* the path of an extension */
    uint32_t node = from.target_node == -1 ? HATCH_NONE : r.node_of[from.target_node];
    if (channel->path == HATCH_PATH_WEIGHTS)
        node = shown_by(r, node).first;
    if (channel->path == HATCH_PATH_WEIGHTS && node != HATCH_NONE && r.scene->nodes[node].mesh_count > 0)
        channel->targets = hatch_mesh_target_count(&r.scene->meshes[r.scene->nodes[node].first_mesh].mesh);
    if (channel->path == HATCH_PATH_WEIGHTS && channel->targets == 0)
        return HATCH_OK;
    HATCH_TRY(read_times(r, sampler.input, where, channel));
    HATCH_TRY(read_values(r, sampler, where, channel));
    if (channel->path == HATCH_PATH_WEIGHTS)
        HATCH_TRY(shift_weights(r, static_cast<size_t>(from.target_node), where, channel));
    else if (node == HATCH_NONE)
        channel->key_count = 0;
    else if (r.scene->nodes[node].has_matrix)
        return bad(r, where, "node " + std::to_string(from.target_node) + " has a matrix and cannot be animated");
    channel->node = node;
    return HATCH_OK;
}

bool animates_weights(const Reader &r, const tinygltf::AnimationChannel &channel)
{
    return channel.target_path == "weights" && channel.target_node >= 0 &&
           static_cast<size_t>(channel.target_node) < r.model.nodes.size();
}

/* Adds channels as the last one of an animation, of the weights of a node, for its instances but the first. */
void repeat_for_instances(const Reader &r, uint32_t node, struct hatch_animation *animation)
{
    const Shown shown = shown_by(r, node);
    for (uint32_t i = 1; i < shown.count; i++) {
        struct hatch_animation_channel *channel = &animation->channels[animation->channel_count++];
        *channel = channel[-1];
        channel->node = shown.first + i;
    }
}

} // namespace

enum hatch_status read_skins(Reader &r)
{
    size_t count = r.model.skins.size();
    r.scene->skins = HATCH_NEW(r.arena, struct hatch_skin, count, r.err);
    if (!r.scene->skins)
        return HATCH_LIMIT;
    for (size_t i = 0; i < count; i++)
        HATCH_TRY(read_skin(r, i, &r.scene->skins[i]));
    r.scene->skin_count = static_cast<uint32_t>(count);
    return HATCH_OK;
}

enum hatch_status read_animations(Reader &r)
{
    size_t count = r.model.animations.size();
    r.scene->animations = HATCH_NEW(r.arena, struct hatch_animation, count, r.err);
    if (!r.scene->animations)
        return HATCH_LIMIT;
    for (size_t i = 0; i < count; i++) {
        const tinygltf::Animation &from = r.model.animations[i];
        struct hatch_animation *to = &r.scene->animations[i];
        size_t most = from.channels.size();
        for (const tinygltf::AnimationChannel &channel : from.channels)
            most += animates_weights(r, channel) ? shown_by(r, r.node_of[channel.target_node]).count - 1 : 0;
        to->channels = HATCH_NEW(r.arena, struct hatch_animation_channel, most, r.err);
        if (!to->channels)
            return HATCH_LIMIT;
        HATCH_TRY(keep(r, from, nullptr, &to->kept));
        for (size_t c = 0; c < from.channels.size(); c++) {
            struct hatch_animation_channel *channel = &to->channels[to->channel_count];
            *channel = {};
            HATCH_TRY(read_channel(r, from, c, place("animation", i, "channel", c), channel));
            if (channel->key_count == 0)
                continue;
            float last = channel->times_s[channel->key_count - 1];
            to->duration_s = last > to->duration_s ? last : to->duration_s;
            to->channel_count++;
            if (channel->path == HATCH_PATH_WEIGHTS)
                repeat_for_instances(r, r.node_of[from.channels[c].target_node], to);
        }
    }
    r.scene->animation_count = static_cast<uint32_t>(count);
    return HATCH_OK;
}

} // namespace hatch
