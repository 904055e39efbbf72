#include "io/gltf/reader.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace hatch
{

enum hatch_status copy_numbers(Reader &r, const std::vector<double> &from, size_t count, const std::string &where,
                               const char *what, double *to)
{
    if (from.empty())
        return HATCH_OK;
    if (from.size() != count)
        return bad(r, where,
                   std::string(what) + ": " + std::to_string(from.size()) + " values, want " + std::to_string(count));
    for (size_t i = 0; i < count; i++) {
        to[i] = from[i];
        if (!std::isfinite(static_cast<float>(to[i])))
            return bad(r, where, std::string(what) + " is not finite");
    }
    return HATCH_OK;
}

enum hatch_status copy_numbers(Reader &r, const std::vector<double> &from, size_t count, const std::string &where,
                               const char *what, float *to)
{
    std::vector<double> copied(from.size());
    HATCH_TRY(copy_numbers(r, from, count, where, what, copied.data()));
    std::transform(copied.begin(), copied.end(), to, [](double value) { return static_cast<float>(value); });
    return HATCH_OK;
}

namespace
{

/* Finds the parent of each node, or HATCH_NONE. Fails for a node with two parents: a small file could otherwise
 * describe 2^39 instances. */
enum hatch_status find_parents(Reader &r, uint32_t *parent)
{
    size_t count = r.model.nodes.size();
    for (size_t i = 0; i < count; i++)
        parent[i] = HATCH_NONE;
    for (size_t i = 0; i < count; i++)
        for (int child : r.model.nodes[i].children) {
            if (child < 0 || static_cast<size_t>(child) >= count)
                return bad(r, place("node", i),
                           "child " + std::to_string(child) + " does not exist, there are " + std::to_string(count));
            if (parent[child] != HATCH_NONE)
                return bad(r, place("node", static_cast<size_t>(child)), "has two parents");
            parent[child] = static_cast<uint32_t>(i);
        }
    return HATCH_OK;
}

/* Lists the root nodes of the default scene; of all nodes when the file has no scene. */
enum hatch_status list_roots(Reader &r, const uint32_t *parent, uint32_t *order, uint32_t *count)
{
    const tinygltf::Model &model = r.model;
    *count = 0;
    if (model.scenes.empty()) {
        for (uint32_t i = 0; i < model.nodes.size(); i++)
            if (parent[i] == HATCH_NONE)
                order[(*count)++] = i;
        return HATCH_OK;
    }
    size_t scene = model.defaultScene < 0 ? 0 : static_cast<size_t>(model.defaultScene);
    if (scene >= model.scenes.size())
        return bad(r, place("scene", scene), "does not exist, there are " + std::to_string(model.scenes.size()));
    HATCH_TRY(keep(r, model.scenes[scene], nullptr, &r.scene->kept));
    for (int root : model.scenes[scene].nodes) {
        if (root < 0 || static_cast<size_t>(root) >= model.nodes.size())
            return bad(r, place("scene", scene), "node " + std::to_string(root) + " does not exist");
        if (parent[root] != HATCH_NONE)
            return bad(r, place("scene", scene),
                       "node " + std::to_string(root) + " is not a root: it is a child of node " +
                           std::to_string(parent[root]));
        if (r.node_of[root] != HATCH_NONE)
            return bad(r, place("scene", scene), "node " + std::to_string(root) + " is listed twice");
        r.node_of[root] = *count;
        order[(*count)++] = static_cast<uint32_t>(root);
    }
    return HATCH_OK;
}

enum hatch_status fill_node(Reader &r, size_t index, struct hatch_node *node)
{
    const tinygltf::Node &from = r.model.nodes[index];
    std::string where = place("node", index);
    *node = {};
    node->rotation[3] = node->scale[0] = node->scale[1] = node->scale[2] = 1;
    node->skin = node->camera = node->light = HATCH_NONE;
    HATCH_TRY(copy_numbers(r, from.translation, 3, where, "translation", node->translation));
    HATCH_TRY(copy_numbers(r, from.rotation, 4, where, "rotation", node->rotation));
    HATCH_TRY(copy_numbers(r, from.scale, 3, where, "scale", node->scale));
    HATCH_TRY(copy_numbers(r, from.matrix, 16, where, "matrix", node->matrix));
    node->has_matrix = !from.matrix.empty();
    HATCH_TRY(keep(r, from, "MSFT_screencoverage", &node->kept));
    return normalize_rotation(r, node, where);
}

/* Returns the index of a node's light (KHR_lights_punctual), or -1. */
int light_of(const tinygltf::Node &node)
{
    auto extension = node.extensions.find("KHR_lights_punctual");
    if (extension == node.extensions.end() || !extension->second.IsObject() || !extension->second.Get("light").IsInt())
        return -1;
    return extension->second.Get("light").GetNumberAsInt();
}

/* Checks that the node's skin has every joint that its meshes refer to. */
enum hatch_status check_skin(Reader &r, const struct hatch_node &node, const std::string &where)
{
    if (node.skin == HATCH_NONE)
        return HATCH_OK;
    uint32_t joints = r.scene->skins[node.skin].joint_count;
    if (joints == 0)
        return bad(r, place("skin", node.skin), "a joint is not in the default scene");
    for (uint32_t m = 0; m < node.mesh_count; m++)
        if (r.scene->meshes[node.first_mesh + m].joints_used > joints)
            return bad(r, where,
                       "its mesh refers to joint " +
                           std::to_string(r.scene->meshes[node.first_mesh + m].joints_used - 1) + ", its skin has " +
                           std::to_string(joints));
    return HATCH_OK;
}

/* Returns whether an image is of a kind that is treated as missing: KTX2 (Basis Universal), which no package decodes,
 * and AVIF or another kind of HEIF, for which OpenImageIO 2.4 reads beyond its memory where a header lies. */
bool is_left_out(struct hatch_bytes bytes)
{
    static const uint8_t ktx2[] = {0xab, 'K', 'T', 'X', ' ', '2', '0', 0xbb}, heif[] = {'f', 't', 'y', 'p'};
    return bytes.size >= sizeof ktx2 &&
           (std::memcmp(bytes.data, ktx2, sizeof ktx2) == 0 || std::memcmp(bytes.data + 4, heif, sizeof heif) == 0);
}

} // namespace

enum hatch_status normalize_rotation(Reader &r, struct hatch_node *node, const std::string &where)
{
    double length = 0;
    for (double q : node->rotation)
        length += q * q;
    if (!(length > 0))
        return bad(r, where, "rotation is zero");
    /* A rotation of unit length up to rounding is kept as it is, so that reading a written file changes nothing. */
    for (double &q : node->rotation)
        q = std::fabs(length - 1) < 1e-6 ? q : q / std::sqrt(length);
    return HATCH_OK;
}

enum hatch_status read_nodes(Reader &r)
{
    size_t count = r.model.nodes.size();
    uint32_t *parent = HATCH_NEW(r.scratch, uint32_t, count, r.err);
    uint32_t *order = parent ? HATCH_NEW(r.scratch, uint32_t, count, r.err) : nullptr;
    r.node_of = order ? HATCH_NEW(r.scratch, uint32_t, count, r.err) : nullptr;
    r.scene->nodes = r.node_of ? HATCH_NEW(r.arena, struct hatch_node, count, r.err) : nullptr;
    if (!r.scene->nodes)
        return HATCH_LIMIT;
    uint32_t found;
    for (size_t i = 0; i < count; i++)
        r.node_of[i] = HATCH_NONE;
    HATCH_TRY(find_parents(r, parent));
    HATCH_TRY(list_roots(r, parent, order, &found));
    /* Breadth first. Nodes have at most one parent and roots none, so each is visited once. */
    for (uint32_t i = 0; i < found; i++) {
        uint32_t node = order[i];
        HATCH_TRY(fill_node(r, node, &r.scene->nodes[i]));
        r.node_of[node] = i;
        r.scene->nodes[i].parent = parent[node] == HATCH_NONE ? HATCH_NONE : r.node_of[parent[node]];
        for (int child : r.model.nodes[node].children)
            order[found++] = static_cast<uint32_t>(child);
    }
    r.scene->node_count = found;
    return HATCH_OK;
}

enum hatch_status attach_to_nodes(Reader &r, const uint32_t *first_mesh)
{
    for (size_t i = 0; i < r.model.nodes.size(); i++) {
        const tinygltf::Node &from = r.model.nodes[i];
        std::string where = place("node", i);
        int light = light_of(from);
        HATCH_TRY(check_index(r, from.mesh, r.model.meshes.size(), where, "mesh"));
        HATCH_TRY(check_index(r, from.skin, r.model.skins.size(), where, "skin"));
        HATCH_TRY(check_index(r, from.camera, r.model.cameras.size(), where, "camera"));
        HATCH_TRY(check_index(r, light, r.model.lights.size(), where, "light"));
        if (r.node_of[i] == HATCH_NONE)
            continue;
        struct hatch_node *node = &r.scene->nodes[r.node_of[i]];
        if (from.mesh != -1) {
            node->first_mesh = first_mesh[from.mesh];
            node->mesh_count = first_mesh[from.mesh + 1] - first_mesh[from.mesh];
            node->skin = static_cast<uint32_t>(from.skin);
            HATCH_TRY(set_weights(r, i, node));
        }
        HATCH_TRY(check_skin(r, *node, where));
        node->camera = static_cast<uint32_t>(from.camera);
        node->light = static_cast<uint32_t>(light);
    }
    return HATCH_OK;
}

enum hatch_status read_images(Reader &r)
{
    size_t count = r.model.images.size(), stride;
    r.scene->textures = HATCH_NEW(r.arena, struct hatch_texture, count, r.err);
    r.image_noted = r.scene->textures ? HATCH_NEW(r.scratch, bool, count, r.err) : nullptr;
    if (!r.image_noted)
        return HATCH_LIMIT;
    for (size_t i = 0; i < count; i++) {
        const tinygltf::Image &from = r.model.images[i];
        struct hatch_bytes bytes = {from.image.data(), from.image.size()};
        if (from.bufferView != -1)
            HATCH_TRY(find_view(r, from.bufferView, place("image", i), &bytes, &stride));
        if (bytes.size == 0 || is_left_out(bytes))
            continue;
        uint8_t *copy = HATCH_NEW(r.arena, uint8_t, bytes.size, r.err);
        if (!copy)
            return HATCH_LIMIT;
        std::memcpy(copy, bytes.data, bytes.size);
        r.scene->textures[i].data = copy;
        r.scene->textures[i].size = bytes.size;
        HATCH_TRY(keep(r, from, nullptr, &r.scene->textures[i].kept));
    }
    r.scene->texture_count = static_cast<uint32_t>(count);
    return HATCH_OK;
}

enum hatch_status read_cameras(Reader &r)
{
    size_t count = r.model.cameras.size();
    r.scene->cameras = HATCH_NEW(r.arena, struct hatch_camera, count, r.err);
    if (!r.scene->cameras)
        return HATCH_LIMIT;
    for (size_t i = 0; i < count; i++) {
        const tinygltf::Camera &from = r.model.cameras[i];
        struct hatch_camera *to = &r.scene->cameras[i];
        to->orthographic = from.type == "orthographic";
        HATCH_TRY(keep(r, from, nullptr, &to->kept));
        if (to->orthographic) {
            to->ymag = static_cast<float>(std::fabs(from.orthographic.ymag));
            to->aspect = static_cast<float>(std::fabs(from.orthographic.xmag / from.orthographic.ymag));
            to->znear = static_cast<float>(from.orthographic.znear);
            to->zfar = static_cast<float>(from.orthographic.zfar);
        } else {
            to->yfov_rad = static_cast<float>(from.perspective.yfov);
            to->aspect = static_cast<float>(from.perspective.aspectRatio);
            to->znear = static_cast<float>(from.perspective.znear);
            to->zfar = static_cast<float>(from.perspective.zfar);
        }
        bool size = to->orthographic ? to->ymag > 0 && to->znear >= 0
                                     : to->yfov_rad > 0 && to->yfov_rad < 3.14159f && to->znear > 0;
        if (!size || !(to->zfar == 0 || to->zfar > to->znear) || !std::isfinite(to->zfar) || !(to->aspect >= 0) ||
            !std::isfinite(to->aspect) || !std::isfinite(to->ymag))
            return bad(r, place("camera", i), "its size or a clipping distance is out of range");
    }
    r.scene->camera_count = static_cast<uint32_t>(count);
    return HATCH_OK;
}

enum hatch_status read_lights(Reader &r)
{
    size_t count = r.model.lights.size();
    r.scene->lights = HATCH_NEW(r.arena, struct hatch_light, count, r.err);
    if (!r.scene->lights)
        return HATCH_LIMIT;
    for (size_t i = 0; i < count; i++) {
        const tinygltf::Light &from = r.model.lights[i];
        struct hatch_light *to = &r.scene->lights[i];
        std::string where = place("light", i);
        *to = {};
        HATCH_TRY(keep(r, from, nullptr, &to->kept));
        if (from.type != "directional" && from.type != "point" && from.type != "spot")
            return bad(r, where, "type " + from.type + " is unknown, want directional, point or spot");
        to->type = from.type == "point"  ? HATCH_LIGHT_POINT
                   : from.type == "spot" ? HATCH_LIGHT_SPOT
                                         : HATCH_LIGHT_DIRECTIONAL;
        to->color[0] = to->color[1] = to->color[2] = 1;
        HATCH_TRY(copy_numbers(r, from.color, 3, where, "color", to->color));
        to->intensity = static_cast<float>(from.intensity);
        to->range = static_cast<float>(from.range);
        to->inner_cone_rad = static_cast<float>(from.spot.innerConeAngle);
        to->outer_cone_rad = static_cast<float>(from.spot.outerConeAngle);
        /* Some exporters write equal angles for a sharp cone, although the inner angle must be less. */
        if (!(to->inner_cone_rad < to->outer_cone_rad || to->inner_cone_rad > to->outer_cone_rad))
            to->inner_cone_rad = std::nextafter(to->outer_cone_rad, 0.0f);
        bool cone = to->inner_cone_rad >= 0 && to->inner_cone_rad < to->outer_cone_rad && to->outer_cone_rad <= 1.5708f;
        if (!(to->intensity >= 0) || !std::isfinite(to->intensity) || !(to->range >= 0) || !std::isfinite(to->range) ||
            (to->type == HATCH_LIGHT_SPOT && !cone))
            return bad(r, where, "intensity, range or cone is out of range");
    }
    r.scene->light_count = static_cast<uint32_t>(count);
    return HATCH_OK;
}

} // namespace hatch
