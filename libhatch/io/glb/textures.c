/* The images of a file, and its textures, each with a sampler. */
#include <string.h>

#include "io/glb/parts.h"

const char *hatch_glb_image_kind(const struct hatch_texture *texture)
{
    static const struct {
        const char *kind, *magic;
        size_t at, size; /* of magic */
    } kinds[] = {{"png", "\x89PNG", 0, 4}, {"jpeg", "\xff\xd8\xff", 0, 3}, {HATCH_GLB_WEBP, "WEBP", 8, 4}};
    for (size_t i = 0; texture->data && i < sizeof kinds / sizeof *kinds; i++)
        if (texture->size > kinds[i].at + kinds[i].size &&
            memcmp(texture->data + kinds[i].at, kinds[i].magic, kinds[i].size) == 0)
            return kinds[i].kind;
    return NULL;
}

const struct hatch_texture_use *hatch_glb_slot(const struct hatch_glb *glb, const struct hatch_material *material,
                                               uint32_t slot)
{
    const struct hatch_texture_use *use = slot == 0                ? &material->base
                                          : material->normals.used ? &material->normals.at
                                                                   : NULL;
    return use && use->texture != HATCH_NONE && glb->image[use->texture] != HATCH_NONE ? use : NULL;
}

static bool same_text(const char *a, const char *b)
{
    return a && b ? strcmp(a, b) == 0 : a == b;
}

static bool same_kept(const struct hatch_kept *a, const struct hatch_kept *b)
{
    return same_text(a->name, b->name) && same_text(a->extras, b->extras);
}

uint32_t hatch_glb_find_texture(const struct hatch_glb *glb, const struct hatch_texture_use *use)
{
    uint32_t at = glb->image_texture[use->texture];
    for (; at != HATCH_NONE; at = glb->textures[at].next) {
        const struct hatch_texture_use *other = glb->textures[at].use;
        if (memcmp(use->wrap, other->wrap, sizeof use->wrap) == 0 &&
            memcmp(use->filters, other->filters, sizeof use->filters) == 0 && same_kept(&use->kept, &other->kept) &&
            same_kept(&use->sampler, &other->sampler))
            break;
    }
    return at;
}

static void plan_images(struct hatch_glb *glb)
{
    const struct hatch_scene *scene = glb->scene;
    uint32_t images = 0;
    for (uint32_t t = 0; t < scene->texture_count; t++) {
        bool known = hatch_glb_image_kind(&scene->textures[t]) != NULL;
        glb->image[t] = known ? images++ : HATCH_NONE;
        glb->image_texture[t] = HATCH_NONE;
        if (known)
            hatch_glb_add_view(glb, (struct hatch_glb_view){.component = HATCH_GLB_U8,
                                                            .data = scene->textures[t].data,
                                                            .count = scene->textures[t].size,
                                                            .components = 1});
    }
}

enum hatch_status hatch_glb_plan_textures(struct hatch_glb *glb)
{
    const struct hatch_scene *scene = glb->scene;
    plan_images(glb);
    HATCH_TRY(HATCH_ALLOC(glb->scratch, &glb->textures, HATCH_GLB_SLOTS * (size_t)scene->material_count, glb->err));
    for (uint32_t m = 0; m < HATCH_GLB_SLOTS * scene->material_count; m++) {
        const struct hatch_texture_use *use =
            hatch_glb_slot(glb, &scene->materials[m / HATCH_GLB_SLOTS], m % HATCH_GLB_SLOTS);
        if (!use || hatch_glb_find_texture(glb, use) != HATCH_NONE)
            continue;
        uint32_t *first = &glb->image_texture[use->texture];
        glb->textures[glb->texture_count] = (struct hatch_glb_texture){use, *first};
        *first = glb->texture_count++;
    }
    return HATCH_OK;
}
