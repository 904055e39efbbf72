#include "io/gltf_reader.h"

namespace hatch {

namespace {

enum hatch_wrap wrap_of(int mode)
{
    return mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE     ? HATCH_WRAP_CLAMP
           : mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? HATCH_WRAP_MIRROR
                                                           : HATCH_WRAP_REPEAT;
}

/* Numbers that stand in an extension, as copy_numbers takes them. */
std::vector<double> numbers_of(const tinygltf::Value &object, const char *key)
{
    std::vector<double> numbers;
    const tinygltf::Value &list = object.Get(key);
    for (size_t i = 0; list.IsArray() && i < list.ArrayLen(); i++)
        numbers.push_back(list.Get(i).IsNumber() ? list.Get(i).GetNumberAsDouble() : 0);
    return numbers;
}

int index_of(const tinygltf::Value &object, const char *key, int absent)
{
    const tinygltf::Value &value = object.Get(key);
    return value.IsInt() ? value.GetNumberAsInt() : absent;
}

/* KHR_texture_transform: where the texture lies, and which coordinates it is read at. */
enum hatch_status place_texture(Reader &r, const tinygltf::ExtensionMap &extensions, const std::string &where,
                                struct hatch_material *material)
{
    auto found = extensions.find("KHR_texture_transform");
    if (found == extensions.end() || !found->second.IsObject())
        return HATCH_OK;
    const tinygltf::Value &said = found->second;
    const tinygltf::Value &turn = said.Get("rotation");
    int set = index_of(said, "texCoord", static_cast<int>(material->base_texcoord));
    material->base_placed = true;
    material->base_scale[0] = material->base_scale[1] = 1;
    HATCH_TRY(copy_numbers(r, numbers_of(said, "offset"), 2, where, "offset", material->base_offset));
    HATCH_TRY(copy_numbers(r, numbers_of(said, "scale"), 2, where, "scale", material->base_scale));
    if (turn.IsNumber())
        HATCH_TRY(copy_numbers(r, {turn.GetNumberAsDouble()}, 1, where, "rotation", &material->base_turn_rad));
    if (set < 0 || set > 1)
        material->base_texture = HATCH_NONE;
    else
        material->base_texcoord = static_cast<uint32_t>(set);
    return HATCH_OK;
}

enum hatch_status texture_image(Reader &r, const tinygltf::TextureInfo &info,
                                const std::string &where, struct hatch_material *material)
{
    HATCH_TRY(check_index(r, info.index, r.model.textures.size(), where, "texture"));
    if (info.index == -1 || info.texCoord < 0 || info.texCoord > 1)
        return HATCH_OK;
    const tinygltf::Texture &texture = r.model.textures[static_cast<size_t>(info.index)];
    HATCH_TRY(check_index(r, texture.source, r.model.images.size(), where, "image"));
    HATCH_TRY(check_index(r, texture.sampler, r.model.samplers.size(), where, "sampler"));
    material->base_texture = static_cast<uint32_t>(texture.source);
    material->base_texcoord = static_cast<uint32_t>(info.texCoord);
    if (texture.sampler != -1) {
        const tinygltf::Sampler &sampler = r.model.samplers[static_cast<size_t>(texture.sampler)];
        material->base_wrap[0] = wrap_of(sampler.wrapS);
        material->base_wrap[1] = wrap_of(sampler.wrapT);
    }
    return place_texture(r, info.extensions, where, material);
}

/* Read as a base texture is, and put in its own place. */
enum hatch_status read_normals(Reader &r, const tinygltf::NormalTextureInfo &said, const std::string &where,
                               struct hatch_normal_map *normals)
{
    struct hatch_material read = {};
    tinygltf::TextureInfo info;
    info.index = said.index;
    info.texCoord = said.texCoord;
    info.extensions = said.extensions;
    read.base_texture = HATCH_NONE;
    read.base_wrap[0] = read.base_wrap[1] = HATCH_WRAP_REPEAT;
    HATCH_TRY(texture_image(r, info, where, &read));
    HATCH_TRY(copy_numbers(r, {said.scale}, 1, where, "scale of the normals", &normals->strength));
    normals->used = read.base_texture != HATCH_NONE;
    normals->texture = normals->used ? read.base_texture : 0;
    normals->texcoord = read.base_texcoord;
    normals->placed = read.base_placed;
    normals->turn_rad = read.base_turn_rad;
    for (int k = 0; k < 2; k++) {
        normals->wrap[k] = read.base_wrap[k];
        normals->scale[k] = read.base_scale[k];
        normals->offset[k] = read.base_offset[k];
    }
    return HATCH_OK;
}

/* KHR_materials_pbrSpecularGlossiness, the older way to say what colour a surface has. */
enum hatch_status read_diffuse(Reader &r, const tinygltf::Value &said, const std::string &where,
                               struct hatch_material *material)
{
    tinygltf::TextureInfo info;
    const tinygltf::Value &texture = said.Get("diffuseTexture");
    HATCH_TRY(copy_numbers(r, numbers_of(said, "diffuseFactor"), 4, where, "diffuseFactor",
                           material->base_color));
    if (!texture.IsObject())
        return HATCH_OK;
    info.index = index_of(texture, "index", -1);
    info.texCoord = index_of(texture, "texCoord", 0);
    const tinygltf::Value &extensions = texture.Get("extensions");
    if (extensions.IsObject())
        for (const std::string &key : extensions.Keys())
            info.extensions[key] = extensions.Get(key);
    return texture_image(r, info, where, material);
}

/* hatch_glb_write_scene's mark of a lapped parametrization. */
bool is_outline(const tinygltf::Material &material)
{
    if (!material.extras.IsObject() || !material.extras.Has("hatch"))
        return false;
    const tinygltf::Value &said = material.extras.Get("hatch");
    return said.IsString() && said.Get<std::string>() == "outline";
}

} // namespace

enum hatch_status read_materials(Reader &r)
{
    size_t count = r.model.materials.size();
    r.scene->materials = HATCH_NEW(r.arena, struct hatch_material, count, r.err);
    if (!r.scene->materials)
        return HATCH_LIMIT;
    for (size_t i = 0; i < count; i++) {
        const tinygltf::Material &from = r.model.materials[i];
        struct hatch_material *to = &r.scene->materials[i];
        std::string where = place("material", i);
        *to = {};
        to->base_texture = HATCH_NONE;
        to->base_wrap[0] = to->base_wrap[1] = HATCH_WRAP_REPEAT;
        to->double_sided = from.doubleSided;
        to->alpha_cutoff = from.alphaMode == "MASK" ? static_cast<float>(from.alphaCutoff) : 0;
        to->outline = is_outline(from);
        for (float &c : to->base_color)
            c = 1;
        HATCH_TRY(read_normals(r, from.normalTexture, where, &to->normals));
        auto diffuse = from.extensions.find("KHR_materials_pbrSpecularGlossiness");
        if (diffuse != from.extensions.end() && diffuse->second.IsObject()) {
            HATCH_TRY(read_diffuse(r, diffuse->second, where, to));
            continue;
        }
        HATCH_TRY(copy_numbers(r, from.pbrMetallicRoughness.baseColorFactor, 4, where,
                               "baseColorFactor", to->base_color));
        HATCH_TRY(texture_image(r, from.pbrMetallicRoughness.baseColorTexture, where, to));
    }
    r.scene->material_count = static_cast<uint32_t>(count);
    return HATCH_OK;
}

} // namespace hatch
