/* Prints the JSON of materials, textures, cameras and lights. */
#include <string.h>

#include "io/glb/parts.h"

static enum hatch_status print_transform(struct hatch_glb *glb, const struct hatch_texture_use *use)
{
    HATCH_TRY(hatch_glb_put(glb, ",\"extensions\":{\"KHR_texture_transform\":{"));
    HATCH_TRY(hatch_glb_number(glb, "rotation", use->turn_rad));
    HATCH_TRY(hatch_glb_numbers(glb, "scale", use->scale, 2));
    HATCH_TRY(hatch_glb_numbers(glb, "offset", use->offset, 2));
    return hatch_glb_put(glb, "}}");
}

/* Prints the members of a reference to a texture. */
static enum hatch_status print_use(struct hatch_glb *glb, const struct hatch_texture_use *use)
{
    HATCH_TRY(hatch_glb_integer(glb, "index", hatch_glb_find_texture(glb, use)));
    HATCH_TRY(hatch_glb_integer(glb, "texCoord", use->texcoord));
    return use->has_transform ? print_transform(glb, use) : HATCH_OK;
}

static enum hatch_status print_member(struct hatch_glb *glb, const struct hatch_kept_member *member)
{
    const char *at = member->text;
    HATCH_TRY(hatch_glb_comma(glb));
    for (uint32_t i = 0; i < member->use_count; i++) {
        size_t length = strcspn(at, (const char[]){HATCH_KEPT_USE, '\0'});
        HATCH_TRY(hatch_buffer_add(&glb->json, at, length, glb->err));
        HATCH_TRY(print_use(glb, &member->uses[i]));
        at += length + 1;
    }
    return hatch_glb_put(glb, at);
}

/* Prints the members that are kept of a part of a material. */
static enum hatch_status print_members(struct hatch_glb *glb, const struct hatch_material *material,
                                       enum hatch_material_part part)
{
    for (uint32_t i = 0; i < material->member_count; i++)
        if (material->members[i].part == part && hatch_glb_has_member(glb, &material->members[i]))
            HATCH_TRY(print_member(glb, &material->members[i]));
    return HATCH_OK;
}

static enum hatch_status print_base(struct hatch_glb *glb, const struct hatch_material *material)
{
    static const float white[4] = {1, 1, 1, 1};
    const struct hatch_texture_use *use = hatch_glb_slot(glb, material, 0);
    HATCH_TRY(hatch_glb_key(glb, "pbrMetallicRoughness"));
    HATCH_TRY(hatch_glb_put(glb, material->keeps_metal ? "{" : "{\"metallicFactor\":0"));
    HATCH_TRY(print_members(glb, material, HATCH_PART_PBR));
    if (memcmp(material->base_color, white, sizeof white) != 0)
        HATCH_TRY(hatch_glb_numbers(glb, "baseColorFactor", material->base_color, 4));
    if (!use)
        return hatch_glb_put(glb, "}");
    HATCH_TRY(hatch_glb_key(glb, "baseColorTexture"));
    HATCH_TRY(hatch_glb_put(glb, "{"));
    HATCH_TRY(print_use(glb, use));
    return hatch_glb_put(glb, "}}");
}

static enum hatch_status print_normals(struct hatch_glb *glb, const struct hatch_material *material)
{
    const struct hatch_texture_use *use = hatch_glb_slot(glb, material, 1);
    if (!use)
        return HATCH_OK;
    HATCH_TRY(hatch_glb_key(glb, "normalTexture"));
    HATCH_TRY(hatch_glb_put(glb, "{"));
    HATCH_TRY(print_use(glb, use));
    HATCH_TRY(hatch_glb_number(glb, "scale", material->normals.strength));
    return hatch_glb_put(glb, "}");
}

static enum hatch_status print_material_extras(struct hatch_glb *glb, const struct hatch_material *material)
{
    if (!material->outline)
        return hatch_glb_print_extras(glb, &material->kept);
    HATCH_TRY(hatch_glb_put(glb, ",\"extras\":{\"hatch\":\"outline\""));
    return hatch_glb_close_extras(glb, &material->kept);
}

static bool has_extensions(const struct hatch_glb *glb, const struct hatch_material *material)
{
    for (uint32_t i = 0; i < material->member_count; i++)
        if (material->members[i].part == HATCH_PART_EXTENSIONS && hatch_glb_has_member(glb, &material->members[i]))
            return true;
    return false;
}

static enum hatch_status print_material(struct hatch_glb *glb, const struct hatch_material *material)
{
    HATCH_TRY(hatch_glb_open_named(glb, &material->kept));
    HATCH_TRY(print_base(glb, material));
    HATCH_TRY(print_normals(glb, material));
    HATCH_TRY(print_members(glb, material, HATCH_PART_MATERIAL));
    if (material->outline || material->blend)
        HATCH_TRY(hatch_glb_put(glb, ",\"alphaMode\":\"BLEND\""));
    if (!material->outline && material->alpha_cutoff > 0 && !material->blend) {
        HATCH_TRY(hatch_glb_put(glb, ",\"alphaMode\":\"MASK\""));
        HATCH_TRY(hatch_glb_number(glb, "alphaCutoff", material->alpha_cutoff));
    }
    HATCH_TRY(print_material_extras(glb, material));
    HATCH_TRY(hatch_glb_put(glb, material->double_sided ? ",\"doubleSided\":true" : ""));
    if (has_extensions(glb, material)) {
        HATCH_TRY(hatch_glb_put(glb, ",\"extensions\":{"));
        HATCH_TRY(print_members(glb, material, HATCH_PART_EXTENSIONS));
        HATCH_TRY(hatch_glb_put(glb, "}"));
    }
    return hatch_glb_put(glb, "}");
}

static enum hatch_status print_images(struct hatch_glb *glb)
{
    const struct hatch_scene *scene = glb->scene;
    uint32_t images = 0;
    for (uint32_t t = 0; t < scene->texture_count; t++) {
        if (glb->image[t] == HATCH_NONE)
            continue;
        if (images == 0)
            HATCH_TRY(hatch_glb_open_array(glb, "images"));
        HATCH_TRY(hatch_glb_open_named(glb, &scene->textures[t].kept));
        HATCH_TRY(hatch_glb_integer(glb, "bufferView", glb->image_view + images++));
        HATCH_TRY(hatch_buffer_print(&glb->json, glb->err, ",\"mimeType\":\"image/%s\"",
                                     hatch_glb_image_kind(&scene->textures[t])));
        HATCH_TRY(hatch_glb_close_kept(glb, &scene->textures[t].kept));
    }
    return hatch_glb_put(glb, images ? "]" : "");
}

static enum hatch_status print_sampler(struct hatch_glb *glb, uint32_t index)
{
    static const uint32_t modes[] = {
        [HATCH_WRAP_CLAMP] = 33071, [HATCH_WRAP_REPEAT] = 10497, [HATCH_WRAP_MIRROR] = 33648};
    static const uint32_t linear = 9729, trilinear = 9987;
    const struct hatch_texture_use *use = glb->textures[index].use;
    HATCH_TRY(hatch_glb_open_named(glb, &use->sampler));
    HATCH_TRY(hatch_glb_integer(glb, "magFilter", use->filters[0] ? (uint32_t)use->filters[0] : linear));
    HATCH_TRY(hatch_glb_integer(glb, "minFilter", use->filters[1] ? (uint32_t)use->filters[1] : trilinear));
    HATCH_TRY(hatch_glb_integer(glb, "wrapS", modes[use->wrap[0]]));
    HATCH_TRY(hatch_glb_integer(glb, "wrapT", modes[use->wrap[1]]));
    return hatch_glb_close_kept(glb, &use->sampler);
}

static bool is_webp(const struct hatch_glb *glb, const struct hatch_texture_use *use)
{
    return strcmp(hatch_glb_image_kind(&glb->scene->textures[use->texture]), HATCH_GLB_WEBP) == 0;
}

static enum hatch_status print_texture(struct hatch_glb *glb, uint32_t index)
{
    const struct hatch_texture_use *use = glb->textures[index].use;
    HATCH_TRY(hatch_glb_open_named(glb, &use->kept));
    HATCH_TRY(hatch_glb_integer(glb, "sampler", index));
    if (is_webp(glb, use))
        HATCH_TRY(hatch_buffer_print(&glb->json, glb->err, ",\"extensions\":{\"EXT_texture_webp\":{\"source\":%u}}",
                                     glb->image[use->texture]));
    else
        HATCH_TRY(hatch_glb_integer(glb, "source", glb->image[use->texture]));
    return hatch_glb_close_kept(glb, &use->kept);
}

static enum hatch_status print_textures(struct hatch_glb *glb)
{
    if (glb->texture_count == 0)
        return HATCH_OK;
    HATCH_TRY(hatch_glb_open_array(glb, "textures"));
    for (uint32_t t = 0; t < glb->texture_count; t++)
        HATCH_TRY(print_texture(glb, t));
    HATCH_TRY(hatch_glb_put(glb, "]"));
    HATCH_TRY(hatch_glb_open_array(glb, "samplers"));
    for (uint32_t t = 0; t < glb->texture_count; t++)
        HATCH_TRY(print_sampler(glb, t));
    return hatch_glb_put(glb, "]");
}

static enum hatch_status print_camera(struct hatch_glb *glb, const struct hatch_camera *camera)
{
    const char *type = camera->orthographic ? "orthographic" : "perspective";
    HATCH_TRY(hatch_glb_open_named(glb, &camera->kept));
    HATCH_TRY(hatch_glb_string(glb, "type", type));
    HATCH_TRY(hatch_glb_key(glb, type));
    HATCH_TRY(hatch_glb_put(glb, "{"));
    HATCH_TRY(hatch_glb_number(glb, "znear", camera->znear));
    if (camera->zfar > 0)
        HATCH_TRY(hatch_glb_number(glb, "zfar", camera->zfar));
    if (camera->orthographic) {
        HATCH_TRY(hatch_glb_number(glb, "ymag", camera->ymag));
        /* Computed as a double, so that the reader's division gives the same aspect. */
        double xmag = (double)camera->ymag * (camera->aspect > 0 ? (double)camera->aspect : 1);
        HATCH_TRY(hatch_buffer_print(&glb->json, glb->err, ",\"xmag\":%.9g", xmag));
    } else {
        HATCH_TRY(hatch_glb_number(glb, "yfov", camera->yfov_rad));
        if (camera->aspect > 0)
            HATCH_TRY(hatch_glb_number(glb, "aspectRatio", camera->aspect));
    }
    HATCH_TRY(hatch_glb_put(glb, "}"));
    return hatch_glb_close_kept(glb, &camera->kept);
}

static enum hatch_status print_light(struct hatch_glb *glb, const struct hatch_light *light)
{
    static const char *const types[] = {"directional", "point", "spot"};
    HATCH_TRY(hatch_glb_open_named(glb, &light->kept));
    HATCH_TRY(hatch_glb_string(glb, "type", types[light->type]));
    HATCH_TRY(hatch_glb_numbers(glb, "color", light->color, 3));
    HATCH_TRY(hatch_glb_number(glb, "intensity", light->intensity));
    if (light->range > 0)
        HATCH_TRY(hatch_glb_number(glb, "range", light->range));
    if (light->type == HATCH_LIGHT_SPOT) {
        HATCH_TRY(hatch_glb_put(glb, ",\"spot\":{"));
        HATCH_TRY(hatch_glb_number(glb, "innerConeAngle", light->inner_cone_rad));
        HATCH_TRY(hatch_glb_number(glb, "outerConeAngle", light->outer_cone_rad));
        HATCH_TRY(hatch_glb_put(glb, "}"));
    }
    return hatch_glb_close_kept(glb, &light->kept);
}

/* Appends the name of an extension to a list of the file, unless it is there.
 *   key    of the list
 *   names  in, out: where they begin in the JSON; 0: there are none yet
 *   name   in quotes, which need not be the end of the text */
static enum hatch_status print_extension(struct hatch_glb *glb, const char *key, size_t *names, const char *name)
{
    const size_t length = (size_t)(strchr(name + 1, '"') + 1 - name);
    if (*names == 0) {
        HATCH_TRY(hatch_glb_open_array(glb, key));
        *names = glb->json.size;
    }
    for (size_t at = *names; at + length <= glb->json.size; at++)
        if (memcmp(glb->json.data + at, name, length) == 0)
            return HATCH_OK;
    HATCH_TRY(hatch_glb_comma(glb));
    return hatch_buffer_add(&glb->json, name, length, glb->err);
}

static enum hatch_status print_extensions(struct hatch_glb *glb)
{
    const struct hatch_scene *scene = glb->scene;
    bool placed = false, webp = false;
    for (uint32_t m = 0; m < scene->material_count; m++)
        for (uint32_t i = 0; i < hatch_glb_slot_count(&scene->materials[m]); i++) {
            const struct hatch_texture_use *use = hatch_glb_slot(glb, &scene->materials[m], i);
            placed = placed || (use && use->has_transform);
            webp = webp || (use && is_webp(glb, use));
        }
    const struct {
        bool used, required;
        const char *name;
    } extensions[] = {{placed, false, "\"KHR_texture_transform\""},
                      {webp, true, "\"EXT_texture_webp\""},
                      {scene->light_count > 0, false, "\"KHR_lights_punctual\""},
                      {glb->quantized, true, "\"KHR_mesh_quantization\""},
                      {scene->lod_count > 0, false, "\"MSFT_lod\""}};
    size_t names = 0;
    for (size_t i = 0; i < sizeof extensions / sizeof *extensions; i++)
        if (extensions[i].used)
            HATCH_TRY(print_extension(glb, "extensionsUsed", &names, extensions[i].name));
    for (uint32_t m = 0; m < scene->material_count; m++)
        for (uint32_t i = 0; i < scene->materials[m].member_count; i++) {
            const struct hatch_kept_member *member = &scene->materials[m].members[i];
            if (member->part == HATCH_PART_EXTENSIONS && hatch_glb_has_member(glb, member))
                HATCH_TRY(print_extension(glb, "extensionsUsed", &names, member->text));
        }
    HATCH_TRY(hatch_glb_put(glb, names > 0 ? "]" : ""));
    names = 0;
    for (size_t i = 0; i < sizeof extensions / sizeof *extensions; i++)
        if (extensions[i].used && extensions[i].required)
            HATCH_TRY(print_extension(glb, "extensionsRequired", &names, extensions[i].name));
    return hatch_glb_put(glb, names > 0 ? "]" : "");
}

enum hatch_status hatch_glb_print_looks(struct hatch_glb *glb)
{
    const struct hatch_scene *scene = glb->scene;
    HATCH_TRY(hatch_glb_put(glb, scene->material_count ? ",\"materials\":[" : ""));
    for (uint32_t m = 0; m < scene->material_count; m++)
        HATCH_TRY(print_material(glb, &scene->materials[m]));
    HATCH_TRY(hatch_glb_put(glb, scene->material_count ? "]" : ""));
    HATCH_TRY(print_textures(glb));
    HATCH_TRY(print_images(glb));
    HATCH_TRY(hatch_glb_put(glb, scene->camera_count ? ",\"cameras\":[" : ""));
    for (uint32_t c = 0; c < scene->camera_count; c++)
        HATCH_TRY(print_camera(glb, &scene->cameras[c]));
    HATCH_TRY(hatch_glb_put(glb, scene->camera_count ? "]" : ""));
    HATCH_TRY(print_extensions(glb));
    if (scene->light_count == 0)
        return HATCH_OK;
    HATCH_TRY(hatch_glb_put(glb, ",\"extensions\":{\"KHR_lights_punctual\":{\"lights\":["));
    for (uint32_t l = 0; l < scene->light_count; l++)
        HATCH_TRY(print_light(glb, &scene->lights[l]));
    return hatch_glb_put(glb, "]}}");
}
