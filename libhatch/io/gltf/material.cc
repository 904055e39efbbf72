#include "io/gltf/reader.h"

#include <cstdio>

namespace hatch
{

namespace
{

enum hatch_wrap wrap_of(int mode)
{
    return mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE     ? HATCH_WRAP_CLAMP
           : mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? HATCH_WRAP_MIRROR
                                                           : HATCH_WRAP_REPEAT;
}

/* Returns the number of a filter, or 0 for one that is unset or unknown. */
int filter_of(int filter)
{
    bool plain = filter == TINYGLTF_TEXTURE_FILTER_NEAREST || filter == TINYGLTF_TEXTURE_FILTER_LINEAR;
    bool mipped = filter >= TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST &&
                  filter <= TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
    return plain || mipped ? filter : 0;
}

/* Returns the array under a key of an extension; empty when absent. */
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

/* Reads KHR_texture_transform: the transform of the texture coordinates, and their set if the extension names one.
 *   set  in, out: index of the set of texture coordinates */
enum hatch_status read_transform(Reader &r, const tinygltf::ExtensionMap &extensions, const std::string &where,
                                 int *set, struct hatch_texture_use *use)
{
    auto found = extensions.find("KHR_texture_transform");
    if (found == extensions.end() || !found->second.IsObject())
        return HATCH_OK;
    const tinygltf::Value &transform = found->second;
    const tinygltf::Value &turn = transform.Get("rotation");
    *set = index_of(transform, "texCoord", *set);
    use->has_transform = true;
    use->scale[0] = use->scale[1] = 1;
    HATCH_TRY(copy_numbers(r, numbers_of(transform, "offset"), 2, where, "offset", use->offset));
    HATCH_TRY(copy_numbers(r, numbers_of(transform, "scale"), 2, where, "scale", use->scale));
    if (turn.IsNumber())
        HATCH_TRY(copy_numbers(r, {turn.GetNumberAsDouble()}, 1, where, "rotation", &use->turn_rad));
    return HATCH_OK;
}

/* Returns the index of a texture's image, or -1. The image of the core format takes precedence over those of
 * extensions. */
int image_of(const tinygltf::Texture &texture)
{
    static const char *const names[] = {"EXT_texture_webp", "EXT_texture_avif", "KHR_texture_basisu"};
    int image = texture.source;
    for (const char *name : names) {
        auto found = texture.extensions.find(name);
        if (image == -1 && found != texture.extensions.end() && found->second.IsObject())
            image = index_of(found->second, "source", -1);
    }
    return image;
}

void note_missing(Reader &r, size_t image)
{
    if (r.image_noted[image])
        return;
    r.image_noted[image] = true;
    if (r.notes->images_missing++ > 0)
        return;
    const tinygltf::Image &from = r.model.images[image];
    bool file = !from.uri.empty() && from.uri.compare(0, 5, "data:") != 0;
    std::string name = file ? from.uri : !from.name.empty() ? from.name : place("number", image);
    std::snprintf(r.notes->image_missing, sizeof r.notes->image_missing, "%s", name.c_str());
}

} // namespace

tinygltf::TextureInfo info_of(const tinygltf::Value &texture)
{
    tinygltf::TextureInfo info;
    info.index = index_of(texture, "index", -1);
    info.texCoord = index_of(texture, "texCoord", 0);
    const tinygltf::Value &extensions = texture.Get("extensions");
    if (extensions.IsObject())
        for (const std::string &key : extensions.Keys())
            info.extensions[key] = extensions.Get(key);
    return info;
}

enum hatch_status read_use(Reader &r, const tinygltf::TextureInfo &info, const std::string &where, bool drawn,
                           struct hatch_texture_use *use)
{
    *use = {};
    use->texture = HATCH_NONE;
    use->wrap[0] = use->wrap[1] = HATCH_WRAP_REPEAT;
    HATCH_TRY(check_index(r, info.index, r.model.textures.size(), where, "texture"));
    if (info.index == -1)
        return HATCH_OK;
    const tinygltf::Texture &texture = r.model.textures[static_cast<size_t>(info.index)];
    int image = image_of(texture), set = info.texCoord;
    HATCH_TRY(check_index(r, image, r.model.images.size(), where, "image"));
    HATCH_TRY(check_index(r, texture.sampler, r.model.samplers.size(), where, "sampler"));
    HATCH_TRY(read_transform(r, info.extensions, where, &set, use));
    HATCH_TRY(keep(r, texture, nullptr, &use->kept));
    if (texture.sampler != -1) {
        const tinygltf::Sampler &sampler = r.model.samplers[static_cast<size_t>(texture.sampler)];
        use->wrap[0] = wrap_of(sampler.wrapS);
        use->wrap[1] = wrap_of(sampler.wrapT);
        use->filters[0] = filter_of(sampler.magFilter);
        use->filters[1] = filter_of(sampler.minFilter);
        HATCH_TRY(keep(r, sampler, nullptr, &use->sampler));
    }
    bool known = set >= 0 && set <= static_cast<int>(HATCH_TEXCOORD_MAX);
    use->texcoord = known ? static_cast<uint32_t>(set) : 0;
    bool available = image != -1 && r.scene->textures[image].data;
    if (drawn && image != -1 && !available)
        note_missing(r, static_cast<size_t>(image));
    if (known && available)
        use->texture = static_cast<uint32_t>(image);
    else
        use->has_transform = false;
    return HATCH_OK;
}

namespace
{

enum hatch_status read_normals(Reader &r, const tinygltf::NormalTextureInfo &from, const std::string &where,
                               struct hatch_normal_map *normals)
{
    tinygltf::TextureInfo info;
    info.index = from.index;
    info.texCoord = from.texCoord;
    info.extensions = from.extensions;
    HATCH_TRY(read_use(r, info, where, true, &normals->at));
    normals->used = normals->at.texture != HATCH_NONE;
    return copy_numbers(r, {from.scale}, 1, where, "normalTexture scale", &normals->strength);
}

/* Reads the base colour of KHR_materials_pbrSpecularGlossiness, an older form of material. */
enum hatch_status read_diffuse(Reader &r, const tinygltf::Value &from, const std::string &where,
                               struct hatch_material *material)
{
    const tinygltf::Value &texture = from.Get("diffuseTexture");
    HATCH_TRY(copy_numbers(r, numbers_of(from, "diffuseFactor"), 4, where, "diffuseFactor", material->base_color));
    return texture.IsObject() ? read_use(r, info_of(texture), where, true, &material->base) : HATCH_OK;
}

/* Returns whether a material is that of lapped patches, as hatch_glb_write_scene marks it. */
bool is_outline(const tinygltf::Material &material)
{
    if (!material.extras.IsObject() || !material.extras.Has("hatch"))
        return false;
    const tinygltf::Value &mark = material.extras.Get("hatch");
    return mark.IsString() && mark.Get<std::string>() == "outline";
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
        to->base.texture = HATCH_NONE;
        to->base.wrap[0] = to->base.wrap[1] = HATCH_WRAP_REPEAT;
        to->double_sided = from.doubleSided;
        HATCH_TRY(keep(r, from, "hatch", &to->kept));
        to->outline = is_outline(from);
        to->blend = from.alphaMode == "BLEND" && !to->outline;
        to->alpha_cutoff = to->blend ? 0.5f : from.alphaMode == "MASK" ? static_cast<float>(from.alphaCutoff) : 0;
        for (float &c : to->base_color)
            c = 1;
        HATCH_TRY(read_normals(r, from.normalTexture, where, &to->normals));
        auto diffuse = from.extensions.find("KHR_materials_pbrSpecularGlossiness");
        to->keeps_metal = diffuse == from.extensions.end() || !diffuse->second.IsObject();
        HATCH_TRY(keep_members(r, from, where, to));
        if (!to->keeps_metal) {
            HATCH_TRY(read_diffuse(r, diffuse->second, where, to));
            continue;
        }
        HATCH_TRY(
            copy_numbers(r, from.pbrMetallicRoughness.baseColorFactor, 4, where, "baseColorFactor", to->base_color));
        HATCH_TRY(read_use(r, from.pbrMetallicRoughness.baseColorTexture, where, true, &to->base));
    }
    r.scene->material_count = static_cast<uint32_t>(count);
    return HATCH_OK;
}

} // namespace hatch
