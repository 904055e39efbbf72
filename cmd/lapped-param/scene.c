#include <string.h>

#include "io/png/png.h"
#include "lapped_param.h"

/* Returns whether an attribute is to be removed: texture coordinates, tangents, and a _HATCH_DIR that does not have
 * four components. */
static bool is_replaced(const struct hatch_mesh_attribute *attribute)
{
    return strncmp(attribute->name, "TEXCOORD_", 9) == 0 || strcmp(attribute->name, "TANGENT") == 0 ||
           (strcmp(attribute->name, "_HATCH_DIR") == 0 && attribute->components != 4);
}

/* Returns the set of texture coordinates of normal maps: hatching has the first, the outline of patches the second. */
static uint32_t set_of_normals(bool atlas)
{
    return atlas ? 1 : 2;
}

void lapped_param_clear_mesh(struct hatch_mesh *mesh, const struct hatch_normal_map *normals, bool atlas)
{
    char name[] = "TEXCOORD_n";
    uint32_t kept = 1;
    name[9] = (char)('0' + (normals ? normals->at.texcoord : 0));
    for (uint32_t a = 1; a < mesh->attribute_count; a++) {
        struct hatch_mesh_attribute *attribute = &mesh->attributes[a];
        bool wanted = normals && strcmp(attribute->name, name) == 0;
        if (!wanted && is_replaced(attribute) && !(normals && strcmp(attribute->name, "TANGENT") == 0))
            continue;
        mesh->attributes[kept] = *attribute;
        if (wanted)
            mesh->attributes[kept].name[9] = (char)('0' + set_of_normals(atlas));
        kept++;
    }
    mesh->attribute_count = kept;
}

/* Returns whether a member of a material, outside of its extensions, has a name that begins so.
 *   name  with a quotation mark before it */
static bool is_named(const struct hatch_kept_member *member, const char *name)
{
    return member->part != HATCH_PART_EXTENSIONS && strncmp(member->text, name, strlen(name)) == 0;
}

static bool has_member(const struct hatch_material *material, const char *name)
{
    for (uint32_t i = 0; i < material->member_count; i++)
        if (is_named(&material->members[i], name))
            return true;
    return false;
}

/* Removes the textures that a material has beside its base colour and normals, with the factors that they multiply.
 * Returns their number. */
static uint32_t drop_textures(struct hatch_material *material)
{
    const bool metal = has_member(material, "\"metallicRoughnessTexture");
    const bool emissive = has_member(material, "\"emissiveTexture");
    uint32_t kept = 0, textures = 0;
    for (uint32_t i = 0; i < material->member_count; i++) {
        const struct hatch_kept_member *member = &material->members[i];
        bool multiplied = metal && (is_named(member, "\"metallicFactor") || is_named(member, "\"roughnessFactor"));
        multiplied = multiplied || (emissive && is_named(member, "\"emissiveFactor"));
        textures += member->use_count;
        if (member->use_count == 0 && !multiplied)
            material->members[kept++] = *member;
    }
    material->member_count = kept;
    material->keeps_metal = material->keeps_metal && !metal;
    return textures;
}

/* Removes all textures except normal maps, and renumbers these. */
static void keep_normals(struct cmd_args *args, const char *name, bool atlas, struct hatch_scene *scene)
{
    struct hatch_err err;
    struct hatch_texture *textures;
    uint32_t *number;
    cmd_check(HATCH_ALLOC(&args->keep, &textures, scene->texture_count, &err), name, &err);
    cmd_check(HATCH_ALLOC(&args->keep, &number, scene->texture_count, &err), name, &err);
    uint32_t count = 0;
    for (uint32_t m = 0; m < scene->material_count; m++) {
        struct hatch_normal_map *normals = &scene->materials[m].normals;
        if (!normals->used)
            continue;
        uint32_t *to = &number[normals->at.texture]; /* new index plus 1; 0: none yet */
        if (*to == 0) {
            textures[count] = scene->textures[normals->at.texture];
            *to = ++count;
        }
        normals->at.texture = *to - 1;
        normals->at.texcoord = set_of_normals(atlas);
    }
    scene->textures = textures;
    scene->texture_count = count;
}

/* Adapts the alpha of a material to its meshes. Patches need alpha for blending, so a material whose alpha is below its
 * cutoff becomes invisible, and all others become opaque. With an atlas the alpha stays; the holes of a texture that is
 * left out close.
 *   textured  the material has a texture, which is left out */
static void set_alpha(struct hatch_material *material, bool atlas, bool textured)
{
    bool visible = material->base_color[3] >= material->alpha_cutoff;
    if (!atlas)
        material->base_color[3] = visible ? 1 : 0;
    if (!atlas || (textured && visible))
        material->alpha_cutoff = 0;
}

/* Vertex colours multiply the alpha by which patches blend. */
static void make_opaque(struct hatch_mesh *mesh)
{
    float *color = hatch_mesh_find(mesh, "COLOR_0", 4);
    for (size_t v = 0; color && v < mesh->vertex_count; v++)
        color[4 * v + 3] = 1;
}

void lapped_param_clear(struct cmd_args *args, const char *name, bool atlas, struct hatch_scene *scene)
{
    struct hatch_err err;
    bool *textured;
    cmd_check(HATCH_ALLOC(&args->keep, &textured, scene->material_count, &err), name, &err);
    for (uint32_t i = 0; i < scene->mesh_count; i++) {
        struct hatch_scene_mesh *mesh = &scene->meshes[i];
        const struct hatch_material *material = mesh->material == HATCH_NONE ? NULL : &scene->materials[mesh->material];
        if (material && material->base.texture != HATCH_NONE)
            textured[mesh->material] = true;
        mesh->curves = (struct hatch_curves){0};
        lapped_param_clear_mesh(&mesh->mesh, material && material->normals.used ? &material->normals : NULL, atlas);
        if (!atlas)
            make_opaque(&mesh->mesh);
    }
    uint32_t count = 0;
    for (uint32_t m = 0; m < scene->material_count; m++) {
        struct hatch_material *material = &scene->materials[m];
        count += textured[m] + drop_textures(material);
        material->base.texture = HATCH_NONE;
        set_alpha(material, atlas, textured[m]);
    }
    keep_normals(args, name, atlas, scene);
    if (count > 0)
        cmd_warn(name, "%u %s left out: their texture coordinates have been replaced", count,
                 cmd_plural(count, "texture", "textures"));
}

void lapped_param_replace(struct cmd_args *args, struct hatch_scene *scene, const struct lapped_param_part *parts)
{
    struct hatch_err err;
    size_t total = 0;
    uint32_t *first;
    cmd_check(HATCH_ALLOC(&args->keep, &first, (size_t)scene->mesh_count + 1, &err), NULL, &err);
    for (uint32_t i = 0; i < scene->mesh_count; i++) {
        first[i] = (uint32_t)total;
        total += parts[i].made_count;
    }
    first[scene->mesh_count] = (uint32_t)total;
    struct hatch_scene_mesh *meshes = HATCH_NEW(&args->keep, struct hatch_scene_mesh, total, &err);
    cmd_check(meshes && total < HATCH_NONE ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    for (uint32_t i = 0; i < scene->mesh_count; i++)
        memcpy(meshes + first[i], parts[i].made, parts[i].made_count * sizeof *meshes);
    hatch_scene_renumber(scene, first);
    scene->meshes = meshes;
    scene->mesh_count = (uint32_t)total;
}

/* Encodes the mask as the alpha of a white PNG, so that a viewer that knows nothing of hatching shows the plain
 * surface. */
static void encode_mask(struct cmd_args *args, const struct hatch_outline *outline, uint32_t side_px,
                        struct hatch_texture *texture)
{
    struct hatch_err err;
    struct hatch_image mask, image;
    struct hatch_buffer file = {.arena = &args->keep};
    cmd_check(hatch_outline_raster(outline, side_px, &args->keep, &mask, &err), NULL, &err);
    cmd_check(hatch_image_make(&args->keep, side_px, side_px, "YA", &image, &err), NULL, &err);
    for (size_t i = 0; i < (size_t)side_px * side_px; i++) {
        image.pixels[2 * i] = 1;
        image.pixels[2 * i + 1] = mask.pixels[i];
    }
    cmd_check(hatch_png_write(&image, HATCH_PNG_RAW, 8, NULL, &args->scratch, &file, &err), NULL, &err);
    *texture = (struct hatch_texture){.data = file.data, .size = file.size};
}

void lapped_param_mask(struct cmd_args *args, const struct hatch_outline *outline, uint32_t side_px,
                       struct hatch_scene *scene)
{
    struct hatch_err err;
    uint32_t plain = scene->material_count;
    struct hatch_material *materials = HATCH_NEW(&args->keep, struct hatch_material, 2 * (size_t)plain + 1, &err);
    struct hatch_texture *textures = HATCH_NEW(&args->keep, struct hatch_texture, scene->texture_count + 1, &err);
    cmd_check(materials && textures ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    for (uint32_t m = 0; m < plain; m++) {
        struct hatch_material *unseen = &materials[plain + 1 + m];
        materials[m] = *unseen = scene->materials[m];
        unseen->alpha_cutoff = unseen->base_color[3] < 0.5f ? 0.5f : 0; /* what is invisible stays so */
        unseen->normals.used = false;
    }
    /* The material for meshes that have none; both sides of their faces are visible. */
    materials[plain] = (struct hatch_material){.base_color = {1, 1, 1, 1}, .double_sided = true};
    for (uint32_t m = 0; m <= plain; m++) {
        materials[m].base = (struct hatch_texture_use){.texcoord = 1, .wrap = {HATCH_WRAP_CLAMP, HATCH_WRAP_CLAMP}};
        materials[m].normals.at.texture++; /* the mask becomes texture 0 */
        materials[m].blend = false;
        materials[m].outline = true;
    }
    scene->materials = materials;
    for (uint32_t i = 0; i < scene->mesh_count; i++)
        if (scene->meshes[i].material == HATCH_NONE && !(scene->meshes[i].unseen_tolerance > 0)) {
            scene->meshes[i].material = plain;
            scene->material_count = plain + 1;
        }
    for (uint32_t i = 0; i < scene->mesh_count; i++)
        if (scene->meshes[i].material < plain && scene->meshes[i].unseen_tolerance > 0) {
            scene->meshes[i].material += plain + 1;
            scene->material_count = 2 * plain + 1;
        }
    encode_mask(args, outline, side_px, textures);
    if (scene->texture_count > 0)
        memcpy(textures + 1, scene->textures, scene->texture_count * sizeof *textures);
    scene->textures = textures;
    scene->texture_count++;
}
