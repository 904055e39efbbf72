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

bool hatch_glb_can_hold(const struct hatch_texture *texture)
{
    return hatch_glb_image_kind(texture) != NULL;
}

static bool is_written(const struct hatch_glb *glb, const struct hatch_texture_use *use)
{
    return use->texture != HATCH_NONE && glb->image[use->texture] != HATCH_NONE;
}

bool hatch_glb_has_member(const struct hatch_glb *glb, const struct hatch_kept_member *member)
{
    for (uint32_t i = 0; i < member->use_count; i++)
        if (!is_written(glb, &member->uses[i]))
            return false;
    return true;
}

uint32_t hatch_glb_slot_count(const struct hatch_material *material)
{
    uint32_t count = 2;
    for (uint32_t i = 0; i < material->member_count; i++)
        count += material->members[i].use_count;
    return count;
}

const struct hatch_texture_use *hatch_glb_slot(const struct hatch_glb *glb, const struct hatch_material *material,
                                               uint32_t slot)
{
    if (slot == 0)
        return is_written(glb, &material->base) ? &material->base : NULL;
    if (slot == 1)
        return material->normals.used && is_written(glb, &material->normals.at) ? &material->normals.at : NULL;
    const struct hatch_kept_member *member = material->members;
    for (slot -= 2; slot >= member->use_count; member++)
        slot -= member->use_count;
    return hatch_glb_has_member(glb, member) ? &member->uses[slot] : NULL;
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
        bool known = hatch_glb_can_hold(&scene->textures[t]);
        glb->image[t] = known ? images++ : HATCH_NONE;
        glb->image_texture[t] = HATCH_NONE;
        if (known)
            hatch_glb_add_view(glb, (struct hatch_glb_view){.component = HATCH_GLB_U8,
                                                            .data = scene->textures[t].data,
                                                            .count = scene->textures[t].size,
                                                            .components = 1});
    }
}

static void add_texture(struct hatch_glb *glb, const struct hatch_texture_use *use)
{
    if (!use || hatch_glb_find_texture(glb, use) != HATCH_NONE)
        return;
    uint32_t *first = &glb->image_texture[use->texture];
    glb->textures[glb->texture_count] = (struct hatch_glb_texture){use, *first};
    *first = glb->texture_count++;
}

enum hatch_status hatch_glb_plan_textures(struct hatch_glb *glb)
{
    const struct hatch_scene *scene = glb->scene;
    size_t slots = 0;
    plan_images(glb);
    for (uint32_t m = 0; m < scene->material_count; m++)
        slots += hatch_glb_slot_count(&scene->materials[m]);
    HATCH_TRY(HATCH_ALLOC(glb->scratch, &glb->textures, slots, glb->err));
    for (uint32_t m = 0; m < scene->material_count; m++)
        for (uint32_t i = 0; i < hatch_glb_slot_count(&scene->materials[m]); i++)
            add_texture(glb, hatch_glb_slot(glb, &scene->materials[m], i));
    return HATCH_OK;
}
