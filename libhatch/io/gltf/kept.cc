/* Parts of a file that a scene keeps for writing alone: names, extras, members of materials. */
#include "io/gltf/reader.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <iterator>

namespace hatch
{

namespace
{

/* Returns the end of the key or value that begins at a place of JSON without spaces. */
size_t end_of(const std::string &json, size_t at)
{
    bool quoted = false;
    for (int depth = 0; at < json.size(); at++) {
        const char c = json[at];
        if (quoted) {
            quoted = c != '"';
            at += c == '\\';
        } else if (c == '"') {
            quoted = true;
        } else if (c == '{' || c == '[') {
            depth++;
        } else if (depth == 0 && std::strchr(",:}]", c)) {
            return at;
        } else if (c == '}' || c == ']') {
            depth--;
        }
    }
    return json.size();
}

struct Member {
    std::string key, value; /* JSON: the key in quotes */
};

/* Returns the members of an object, or nothing for an empty text. */
std::vector<Member> members_of(const std::string &object)
{
    std::vector<Member> members;
    for (size_t at = 1; at < object.size() && object[at] == '"';) {
        const size_t colon = end_of(object, at), end = end_of(object, colon + 1);
        members.push_back({object.substr(at, colon - at), object.substr(colon + 1, end - colon - 1)});
        at = end + 1;
    }
    return members;
}

/* Returns an object without one of its members; empty if no other is left. */
std::string without(const std::string &object, const char *key)
{
    const std::string quoted = std::string("\"") + key + "\"";
    std::string rest;
    for (const Member &member : members_of(object))
        if (member.key != quoted)
            rest += (rest.empty() ? "{" : ",") + member.key + ":" + member.value;
    return rest.empty() ? rest : rest + "}";
}

enum hatch_status copy_text(Reader &r, const std::string &text, const char **copy)
{
    char *bytes = HATCH_NEW(r.arena, char, text.size() + 1, r.err);
    if (!bytes)
        return HATCH_LIMIT;
    std::memcpy(bytes, text.c_str(), text.size() + 1);
    *copy = bytes;
    return HATCH_OK;
}

/* A member of a material while it is put together. */
struct Kept {
    enum hatch_material_part part;
    std::string text;
    std::vector<struct hatch_texture_use> uses;
};

/* Appends a reference to a texture to the text of a member, unless its image is missing.
 *   before  text before its key
 *   rest    its further members, each after a comma */
enum hatch_status add_use(Reader &r, const std::string &before, const std::string &key,
                          const tinygltf::TextureInfo &info, const std::string &rest, const std::string &where,
                          Kept *kept)
{
    struct hatch_texture_use use;
    HATCH_TRY(read_use(r, info, where, false, &use));
    if (use.texture == HATCH_NONE)
        return HATCH_OK;
    kept->text += before + key + ":{" + HATCH_KEPT_USE + rest + "}";
    kept->uses.push_back(use);
    return HATCH_OK;
}

/* Returns the shortest text of a number. */
std::string text_of(double number)
{
    char text[32];
    return std::string(text, std::to_chars(text, text + sizeof text, number).ptr);
}

/* Appends a member that is a number, unless it has the value of a missing one. */
void add_number(enum hatch_material_part part, const char *key, double value, double missing, std::vector<Kept> *list)
{
    if (value < missing || value > missing)
        list->push_back({part, std::string("\"") + key + "\":" + text_of(value), {}});
}

/* Appends a member that is a reference to a texture. */
enum hatch_status add_texture(Reader &r, enum hatch_material_part part, const char *key,
                              const tinygltf::TextureInfo &info, const std::string &rest, const std::string &where,
                              std::vector<Kept> *list)
{
    Kept kept = {part, "", {}};
    HATCH_TRY(add_use(r, "", std::string("\"") + key + "\"", info, rest, where, &kept));
    if (!kept.uses.empty())
        list->push_back(kept);
    return HATCH_OK;
}

/* Returns the members of a reference to a texture that read_use does not read, each after a comma. */
std::string rest_of(const std::string &texture)
{
    std::string rest;
    for (const Member &member : members_of(texture))
        if (member.key != "\"index\"" && member.key != "\"texCoord\"" && member.key != "\"extensions\"")
            rest += "," + member.key + ":" + member.value;
    return rest;
}

/* Appends an extension of a material. Members that are objects and whose name ends in Texture are its textures;
 * tinygltf has left out those without members, which refer to nothing. */
enum hatch_status add_extension(Reader &r, const Member &extension, const tinygltf::Value &values,
                                const std::string &where, std::vector<Kept> *list)
{
    static const std::string ending = "Texture\"";
    Kept kept = {HATCH_PART_EXTENSIONS, extension.key + ":{", {}};
    for (const Member &member : members_of(extension.value)) {
        const std::string before = kept.text.back() == '{' ? "" : ",", &key = member.key;
        if (key == "\"extensions\"")
            continue;
        if (member.value[0] != '{' || key.size() <= ending.size() ||
            key.compare(key.size() - ending.size(), ending.size(), ending) != 0) {
            kept.text += before + key + ":" + member.value;
            continue;
        }
        const tinygltf::Value &texture = values.Get(key.substr(1, key.size() - 2));
        if (texture.IsObject())
            HATCH_TRY(add_use(r, before, key, info_of(texture), rest_of(member.value), where, &kept));
    }
    kept.text += "}";
    list->push_back(kept);
    return HATCH_OK;
}

/* Returns whether an extension of materials is kept: all of Khronos' but the one that becomes the base colour, and the
 * one that concerns meshes. Their names are plain. */
bool is_kept(const std::string &name)
{
    static const std::string prefix = "KHR_materials_";
    return name.compare(0, prefix.size(), prefix) == 0 && name != prefix + "pbrSpecularGlossiness" &&
           name != prefix + "variants" && name.find_first_of("\"\\") == std::string::npos;
}

/* Returns whether an extension is read, so that its effect is in the scene, or noted otherwise. */
bool is_read(const std::string &name)
{
    static const char *const names[] = {"EXT_mesh_gpu_instancing", "EXT_meshopt_compression", "EXT_texture_avif",
                                        "EXT_texture_webp",        "KHR_lights_punctual",     "KHR_mesh_quantization",
                                        "KHR_texture_basisu",      "KHR_texture_transform",   "MSFT_lod"};
    return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

void note_extension(struct hatch_mesh_notes *notes, const std::string &name)
{
    const size_t used = std::strlen(notes->extension_dropped), room = sizeof notes->extension_dropped - used;
    notes->extensions_dropped++;
    if (name.size() + 2 < room)
        std::snprintf(notes->extension_dropped + used, room, "%s%s", used > 0 ? ", " : "", name.c_str());
}

enum hatch_status copy_members(Reader &r, const std::vector<Kept> &list, struct hatch_material *material)
{
    material->members = HATCH_NEW(r.arena, struct hatch_kept_member, list.size(), r.err);
    if (!material->members)
        return HATCH_LIMIT;
    for (const Kept &from : list) {
        struct hatch_texture_use *uses = HATCH_NEW(r.arena, struct hatch_texture_use, from.uses.size(), r.err);
        if (!uses)
            return HATCH_LIMIT;
        std::copy(from.uses.begin(), from.uses.end(), uses);
        struct hatch_kept_member *to = &material->members[material->member_count++];
        *to = {from.part, nullptr, uses, static_cast<uint32_t>(from.uses.size())};
        HATCH_TRY(copy_text(r, from.text, &to->text));
    }
    return HATCH_OK;
}

} // namespace

enum hatch_status keep_members(Reader &r, const tinygltf::Material &from, const std::string &where,
                               struct hatch_material *material)
{
    std::vector<Kept> list;
    const tinygltf::PbrMetallicRoughness &pbr = from.pbrMetallicRoughness;
    if (material->keeps_metal) {
        add_number(HATCH_PART_PBR, "metallicFactor", pbr.metallicFactor, 1, &list);
        add_number(HATCH_PART_PBR, "roughnessFactor", pbr.roughnessFactor, 1, &list);
        HATCH_TRY(
            add_texture(r, HATCH_PART_PBR, "metallicRoughnessTexture", pbr.metallicRoughnessTexture, "", where, &list));
    }
    tinygltf::TextureInfo occlusion;
    occlusion.index = from.occlusionTexture.index;
    occlusion.texCoord = from.occlusionTexture.texCoord;
    occlusion.extensions = from.occlusionTexture.extensions;
    HATCH_TRY(add_texture(r, HATCH_PART_MATERIAL, "occlusionTexture", occlusion,
                          ",\"strength\":" + text_of(from.occlusionTexture.strength), where, &list));
    const std::vector<double> &light = from.emissiveFactor;
    if (light.size() == 3 && light != std::vector<double>(3))
        list.push_back(
            {HATCH_PART_MATERIAL,
             "\"emissiveFactor\":[" + text_of(light[0]) + "," + text_of(light[1]) + "," + text_of(light[2]) + "]",
             {}});
    HATCH_TRY(add_texture(r, HATCH_PART_MATERIAL, "emissiveTexture", from.emissiveTexture, "", where, &list));
    for (const Member &extension : members_of(from.extensions_json_string)) {
        auto values = from.extensions.find(extension.key.substr(1, extension.key.size() - 2));
        if (values != from.extensions.end() && values->second.IsObject() && is_kept(values->first))
            HATCH_TRY(add_extension(r, extension, values->second, where, &list));
    }
    return copy_members(r, list, material);
}

enum hatch_status keep(Reader &r, const std::string &name, const std::string &extras, const char *own,
                       struct hatch_kept *kept)
{
    const std::string rest = own && extras[0] == '{' ? without(extras, own) : extras;
    *kept = {};
    if (!name.empty())
        HATCH_TRY(copy_text(r, name, &kept->name));
    return rest.empty() ? HATCH_OK : copy_text(r, rest, &kept->extras);
}

void note_lost(Reader &r)
{
    const size_t scenes = r.model.scenes.size();
    r.notes->scenes_dropped += static_cast<uint32_t>(scenes > 1 ? scenes - 1 : 0);
    for (uint32_t i = 0; i < r.scene->texture_count; i++)
        r.notes->images_dropped += !r.image_noted[i] && !hatch_glb_can_hold(&r.scene->textures[i]);
    for (const std::string &name : r.model.extensionsUsed)
        if (!is_read(name) && !is_kept(name))
            note_extension(r.notes, name);
}

} // namespace hatch
