#include "image/image.h"

#include <assert.h>
#include <math.h>
#include <string.h>

enum hatch_status hatch_image_make(struct hatch_arena *arena, uint32_t width, uint32_t height, const char *names,
                                   struct hatch_image *image, struct hatch_err *err)
{
    size_t channel_count = strlen(names);
    assert(width > 0 && height > 0);
    assert(channel_count >= 1 && channel_count <= HATCH_IMAGE_CHANNELS_MAX);
    struct hatch_image made = {width, height, (uint32_t)channel_count, {{{0}, HATCH_HALF}}, NULL};
    for (size_t c = 0; c < channel_count; c++)
        made.channels[c].name[0] = names[c];
    size_t row_floats = (size_t)width * channel_count;
    if (height > SIZE_MAX / sizeof(float) / row_floats)
        return hatch_fail(err, HATCH_LIMIT, "image of %ux%u pixels is too large", width, height);
    HATCH_TRY(HATCH_ALLOC(arena, &made.pixels, row_floats * height, err));
    *image = made;
    return HATCH_OK;
}

int hatch_image_channel(const struct hatch_image *image, const char *name)
{
    for (uint32_t c = 0; c < image->channel_count; c++)
        if (strcmp(image->channels[c].name, name) == 0)
            return (int)c;
    return -1;
}

uint32_t hatch_mip_chain_length(uint32_t width, uint32_t height)
{
    uint32_t larger = width > height ? width : height;
    uint32_t length = 1;
    while (larger >>= 1)
        length++;
    return length;
}

uint32_t hatch_mip_size(uint32_t size, uint32_t level)
{
    uint32_t halved = level < 32 ? size >> level : 0;
    return halved ? halved : 1;
}

const struct hatch_attribute *hatch_mipmap_attribute(const struct hatch_mipmap *mipmap, const char *name)
{
    for (uint32_t i = 0; i < mipmap->attribute_count; i++)
        if (strcmp(mipmap->attributes[i].name, name) == 0)
            return &mipmap->attributes[i];
    return NULL;
}

static struct hatch_attribute *attribute_slot(struct hatch_mipmap *mipmap, const char *name)
{
    for (uint32_t i = 0; i < mipmap->attribute_count; i++)
        if (strcmp(mipmap->attributes[i].name, name) == 0)
            return &mipmap->attributes[i];
    assert(mipmap->attribute_count < HATCH_MIPMAP_ATTRIBUTES_MAX);
    assert(strlen(name) < HATCH_NAME_MAX);
    struct hatch_attribute *slot = &mipmap->attributes[mipmap->attribute_count++];
    memset(slot, 0, sizeof *slot);
    memcpy(slot->name, name, strlen(name) + 1);
    return slot;
}

void hatch_mipmap_set_number(struct hatch_mipmap *mipmap, const char *name, double value,
                             enum hatch_attribute_type type)
{
    assert(type != HATCH_ATTRIBUTE_TEXT);
    struct hatch_attribute *slot = attribute_slot(mipmap, name);
    slot->type = type;
    slot->number = value;
}

void hatch_mipmap_set_text(struct hatch_mipmap *mipmap, const char *name, const char *text)
{
    struct hatch_attribute *slot = attribute_slot(mipmap, name);
    slot->type = HATCH_ATTRIBUTE_TEXT;
    slot->text = text;
}

float hatch_srgb_to_linear(float encoded)
{
    if (encoded <= 0.04045f)
        return encoded / 12.92f;
    return (float)pow(((double)encoded + 0.055) / 1.055, 2.4);
}

float hatch_linear_to_srgb(float linear)
{
    if (linear <= 0.0031308f)
        return linear * 12.92f;
    return (float)(1.055 * pow((double)linear, 1.0 / 2.4) - 0.055);
}
