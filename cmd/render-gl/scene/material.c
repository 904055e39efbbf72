#include "render-gl/scene/material.h"

#include <math.h>
#include <string.h>

#include "shared/picture.h"
#include "filter/pyramid.h"
#include "image/color.h"
#include "io/foreign/foreign.h"
#include "lapped/outline.h"
#include "render-gl/gpu/texture.h"

static GLuint upload(const struct hatch_image *image, const enum hatch_wrap wrap[2])
{
    static const GLint modes[] = {[HATCH_WRAP_CLAMP] = GL_CLAMP_TO_EDGE,
                                  [HATCH_WRAP_REPEAT] = GL_REPEAT,
                                  [HATCH_WRAP_MIRROR] = GL_MIRRORED_REPEAT};
    static const GLenum formats[5] = {0, GL_RED, GL_RG, GL_RGB, GL_RGBA};
    static const GLint grey_alpha[4] = {GL_RED, GL_RED, GL_RED, GL_GREEN};
    GLuint texture = gpu_texture_make(GL_TEXTURE_2D, (GLsizei)hatch_mip_chain_length(image->width, image->height),
                                      GL_RGBA16F, image->width, image->height, 1);
    glTextureSubImage2D(texture, 0, 0, 0, (GLsizei)image->width, (GLsizei)image->height, formats[image->channel_count],
                        GL_FLOAT, image->pixels);
    if (image->channel_count == 1)
        gpu_texture_read_grey(texture);
    if (image->channel_count == 2)
        glTextureParameteriv(texture, GL_TEXTURE_SWIZZLE_RGBA, grey_alpha);
    glGenerateTextureMipmap(texture);
    glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_S, modes[wrap[0]]);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_T, modes[wrap[1]]);
    return texture;
}

enum hatch_status material_outline(const struct hatch_image *image, struct hatch_arena *scratch, GLuint *texture,
                                   struct hatch_err *err)
{
    static const float transparent[4] = {0, 0, 0, 0};
    size_t count = (size_t)image->width * image->height, channels = image->channel_count;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    float *alpha = HATCH_NEW(scratch, float, count, err);
    if (!alpha)
        return HATCH_LIMIT;
    for (size_t i = 0; i < count; i++)
        alpha[i] = channels % 2 ? 1.0f : image->pixels[channels * i + channels - 1];
    uint32_t side_px = image->width < image->height ? image->width : image->height;
    GLsizei levels = (GLsizei)hatch_outline_levels(side_px);
    *texture = gpu_texture_make(GL_TEXTURE_2D, levels, GL_R8, image->width, image->height, 1);
    glTextureSubImage2D(*texture, 0, 0, 0, (GLsizei)image->width, (GLsizei)image->height, GL_RED, GL_FLOAT, alpha);
    glGenerateTextureMipmap(*texture);
    glTextureParameteri(*texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    glTextureParameteri(*texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTextureParameteri(*texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    glTextureParameterfv(*texture, GL_TEXTURE_BORDER_COLOR, transparent);
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

/* Halves an image until neither side is longer than size_max_px. */
static enum hatch_status fit(struct hatch_image *image, uint32_t size_max_px, struct hatch_arena *arena,
                             struct hatch_err *err)
{
    while (image->width > size_max_px || image->height > size_max_px) {
        struct hatch_image half = *image;
        half.width = hatch_mip_size(image->width, 1);
        half.height = hatch_mip_size(image->height, 1);
        half.pixels = HATCH_NEW(arena, float, (size_t)half.width *half.height *half.channel_count, err);
        if (!half.pixels)
            return HATCH_LIMIT;
        hatch_image_halve(image, &half);
        *image = half;
    }
    return HATCH_OK;
}

/* Decodes a texture into args->keep. */
static void read_texture(struct cmd_args *args, const char *file, const struct hatch_scene *scene, uint32_t number,
                         struct hatch_image *image)
{
    const char *plugin = cmd_installed_path(args, "lib/hatch/hatch-oiio.so");
    struct hatch_bytes bytes = {scene->textures[number].data, scene->textures[number].size};
    struct hatch_err err;
    if (hatch_image_read_any(bytes, "", plugin, &args->keep, &args->scratch, image, &err) != HATCH_OK) {
        hatch_fail_at(&err, "texture %u: ", number);
        cmd_die(file, &err);
    }
}

GLuint material_normals(struct cmd_args *args, const char *file, const struct hatch_scene *scene,
                        const struct hatch_normal_map *normals, uint32_t size_max_px)
{
    struct hatch_arena_mark mark = hatch_arena_mark(&args->scratch), kept = hatch_arena_mark(&args->keep);
    struct hatch_image image;
    struct hatch_err err;
    read_texture(args, file, scene, normals->at.texture, &image);
    if (image.channel_count < 3) {
        hatch_fail(&err, HATCH_BAD_INPUT, "texture %u: a normal map needs 3 channels, it has %u", normals->at.texture,
                   image.channel_count);
        cmd_die(file, &err);
    }
    for (size_t i = 0; i < (size_t)image.width * image.height * image.channel_count; i++)
        image.pixels[i] = hatch_linear_to_srgb(image.pixels[i]); /* undoes the sRGB decoding of colours */
    cmd_check(fit(&image, size_max_px, &args->scratch, &err), file, &err);
    GLuint made = upload(&image, normals->at.wrap);
    hatch_arena_rewind(&args->scratch, mark);
    hatch_arena_rewind(&args->keep, kept);
    return made;
}

static float smallest_alpha(const struct hatch_image *image)
{
    size_t channels = image->channel_count;
    float least = 1;
    for (size_t i = 0; channels % 2 == 0 && i < (size_t)image->width * image->height; i++)
        least = fminf(least, image->pixels[channels * i + channels - 1]);
    return least;
}

/* Context for decoding the textures of a scene. */
struct decoding {
    struct cmd_args *args;
    const char *file; /* the scene's name, for messages */
    uint32_t size_max_px;
    struct scene *scene;
};

static void decode(const struct decoding *decoding, const struct hatch_material *material, bool outline,
                   struct scene_item *item)
{
    struct hatch_arena *scratch = &decoding->args->scratch, *keep = &decoding->args->keep;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch), kept = hatch_arena_mark(keep);
    struct hatch_image image;
    struct hatch_err err;
    read_texture(decoding->args, decoding->file, decoding->scene->unit.scene, material->base.texture, &image);
    cmd_check(fit(&image, decoding->size_max_px, scratch, &err), decoding->file, &err);
    if (outline)
        cmd_check(material_outline(&image, scratch, &item->base_texture, &err), decoding->file, &err);
    else
        item->base_texture = upload(&image, material->base.wrap);
    item->base_side_px = (float)(image.width > image.height ? image.width : image.height);
    item->base_alpha = smallest_alpha(&image);
    hatch_arena_rewind(scratch, mark);
    hatch_arena_rewind(keep, kept);
}

/* Returns an earlier item that uses the same texture in the same way, or NULL. */
static const struct scene_item *find_same_texture(const struct scene *scene, uint32_t index,
                                                  const struct hatch_material *wanted, bool outline)
{
    for (uint32_t i = 0; i < index; i++) {
        uint32_t mesh = scene->unit.items[i].mesh, material = scene->unit.scene->meshes[mesh].material;
        if (!scene->items[i].base_texture || material == HATCH_NONE)
            continue;
        const struct hatch_material *has = &scene->unit.scene->materials[material];
        if (has->base.texture == wanted->base.texture && has->base.wrap[0] == wanted->base.wrap[0] &&
            has->base.wrap[1] == wanted->base.wrap[1] && (scene->unit.meshes[mesh].patches != NULL) == outline)
            return &scene->items[i];
    }
    return NULL;
}

/* Chooses the mip level for reading the texture at vertices: detail finer than the distance of vertices would alias. */
static void set_lod(struct scene_item *item, const struct hatch_mesh *mesh)
{
    float vertices_side = sqrtf((float)mesh->vertex_count);
    item->base_lod = fmaxf(0.0f, log2f(item->base_side_px / fmaxf(vertices_side, 1.0f)));
}

static void upload_item(const struct decoding *decoding, uint32_t index, bool visible)
{
    const struct scene *scene = decoding->scene;
    struct hatch_item *unit = &scene->unit.items[index];
    struct scene_item *item = &scene->items[index];
    const struct hatch_scene_mesh *mesh = &scene->unit.scene->meshes[unit->mesh];
    if (mesh->material == HATCH_NONE)
        return;
    const struct hatch_material *material = &scene->unit.scene->materials[mesh->material];
    bool outline = scene->unit.meshes[unit->mesh].patches != NULL;
    item->base_lightness = hatch_color_luminance(material->base_color);
    memcpy(item->base_color, material->base_color, sizeof item->base_color);
    if (material->base.texture == HATCH_NONE || !(visible || material->alpha_cutoff > 0 || outline))
        return;
    const struct scene_item *other = find_same_texture(scene, index, material, outline);
    if (other) {
        item->base_texture = other->base_texture;
        item->base_side_px = other->base_side_px;
        item->base_alpha = other->base_alpha;
    } else {
        decode(decoding, material, outline, item);
    }
    if (item->base_alpha >= unit->alpha_cutoff)
        unit->alpha_cutoff = 0; /* there are no holes; exporters often declare opaque textures as blended */
    unit->cut_out = unit->alpha_cutoff > 0;
    set_lod(item, &mesh->mesh);
}

static float decode_smallest_alpha(struct cmd_args *args, const char *file, const struct hatch_scene *scene,
                                   uint32_t texture)
{
    struct hatch_arena_mark kept = hatch_arena_mark(&args->keep);
    struct hatch_image image;
    read_texture(args, file, scene, texture, &image);
    float least = smallest_alpha(&image);
    hatch_arena_rewind(&args->keep, kept);
    return least;
}

void material_find_holes(struct cmd_args *args, const char *file, struct hatch_unit_scene *unit)
{
    const struct hatch_scene *scene = unit->scene;
    struct hatch_arena_mark mark = hatch_arena_mark(&args->scratch);
    float *alphas; /* per texture; less than 0: unknown yet */
    struct hatch_err err;
    cmd_check(HATCH_ALLOC(&args->scratch, &alphas, scene->texture_count, &err), file, &err);
    for (uint32_t i = 0; i < scene->texture_count; i++)
        alphas[i] = -1;
    for (uint32_t i = 0; i < unit->item_count; i++) {
        struct hatch_item *item = &unit->items[i];
        uint32_t material = scene->meshes[item->mesh].material;
        uint32_t texture = material == HATCH_NONE ? HATCH_NONE : scene->materials[material].base.texture;
        if (texture == HATCH_NONE || !(item->alpha_cutoff > 0))
            continue;
        if (alphas[texture] < 0)
            alphas[texture] = decode_smallest_alpha(args, file, scene, texture);
        item->cut_out = alphas[texture] < item->alpha_cutoff;
    }
    hatch_arena_rewind(&args->scratch, mark);
}

void material_upload(struct cmd_args *args, const char *file, bool visible, uint32_t size_max_px, struct scene *scene)
{
    const struct decoding decoding = {args, file, size_max_px, scene};
    for (uint32_t i = 0; i < scene->unit.item_count; i++)
        upload_item(&decoding, i, visible);
}

static bool is_used(const struct scene *scene, GLuint base_texture)
{
    for (uint32_t i = 0; i < scene->unit.item_count; i++)
        if (scene->items[i].base_texture == base_texture)
            return true;
    return false;
}

void material_modulate(struct cmd_args *args, const char *path, uint32_t size_max_px, struct scene *scene)
{
    static const enum hatch_wrap wrap[2] = {HATCH_WRAP_REPEAT, HATCH_WRAP_REPEAT};
    struct hatch_arena_mark mark = hatch_arena_mark(&args->scratch), kept = hatch_arena_mark(&args->keep);
    GLuint made = 0;
    struct hatch_image image;
    struct hatch_err err;
    cmd_read_picture(args, path, 1, &args->keep, &image);
    cmd_check(fit(&image, size_max_px, &args->scratch, &err), path, &err);
    for (uint32_t i = 0; i < scene->unit.item_count; i++) {
        struct hatch_item *unit = &scene->unit.items[i];
        struct scene_item *item = &scene->items[i];
        if (scene->unit.meshes[unit->mesh].patches || unit->alpha_cutoff > 0)
            continue;
        GLuint before = item->base_texture;
        made = made ? made : upload(&image, wrap);
        item->base_texture = made;
        if (before && !is_used(scene, before))
            glDeleteTextures(1, &before);
        item->base_side_px = (float)(image.width > image.height ? image.width : image.height);
        item->base_lightness = 1;
        set_lod(item, scene->unit.meshes[unit->mesh].mesh);
    }
    hatch_arena_rewind(&args->scratch, mark);
    hatch_arena_rewind(&args->keep, kept);
}
