/* Images of float pixels in linear light with named channels, and mip-mapped images with attributes.
 *
 * Row 0 is the top row. In textures it is at v = 0 (the convention of glTF): texel (x, y) covers
 * u in [x, x+1)/width and v in [y, y+1)/height.
 */
#ifndef HATCH_IMAGE_IMAGE_H
#define HATCH_IMAGE_IMAGE_H

#include <stddef.h>
#include <stdint.h>

#include "base/arena.h"

#define HATCH_IMAGE_CHANNELS_MAX 8u
#define HATCH_NAME_MAX 64u
#define HATCH_MIP_LEVELS_MAX 32u
#define HATCH_MIPMAP_ATTRIBUTES_MAX 16u

/* Type of a channel in a file whose format offers a choice (EXR). In memory all channels are floats; a UINT channel
 * holds whole numbers up to 2^24, which floats represent exactly. */
enum hatch_channel_type { HATCH_HALF, HATCH_FLOAT, HATCH_UINT };

struct hatch_channel {
    char name[HATCH_NAME_MAX]; /* "Y", "R", "G", "B", "A", "id", "t" or any other */
    enum hatch_channel_type type;
};

struct hatch_image {
    uint32_t width, height; /* 1 .. 2^24 */
    uint32_t channel_count; /* 1 .. HATCH_IMAGE_CHANNELS_MAX */
    struct hatch_channel channels[HATCH_IMAGE_CHANNELS_MAX];
    float *pixels; /* [(y * width + x) * channel_count + c], in the arena that the image was made in */
};

enum hatch_attribute_type { HATCH_ATTRIBUTE_FLOAT, HATCH_ATTRIBUTE_INT, HATCH_ATTRIBUTE_TEXT };

struct hatch_attribute {
    char name[HATCH_NAME_MAX]; /* such as "hatch:tone" */
    enum hatch_attribute_type type;
    double number;    /* value of FLOAT and INT */
    const char *text; /* value of TEXT: zero-terminated, in an arena or static */
};

/* A named image with its mip levels. All levels have the same channels. */
struct hatch_mipmap {
    char name[HATCH_NAME_MAX];
    uint32_t level_count;       /* 1 .. HATCH_MIP_LEVELS_MAX */
    struct hatch_image *levels; /* finest first; their sizes are those of hatch_mip_size */
    uint32_t attribute_count;
    struct hatch_attribute attributes[HATCH_MIPMAP_ATTRIBUTES_MAX];
};

/* Makes a zeroed image.
 *   width, height  at least 1
 *   names          one letter per channel, such as "Y", "RGB" or "RGBA"; their type is HATCH_HALF
 *   image          out, in arena
 * HATCH_LIMIT if there is not enough memory. */
enum hatch_status hatch_image_make(struct hatch_arena *arena, uint32_t width, uint32_t height, const char *names,
                                   struct hatch_image *image, struct hatch_err *err) HATCH_MUST_USE;

/* Returns the index of the channel of that name, or -1. */
int hatch_image_channel(const struct hatch_image *image, const char *name);

/* Returns the number of levels of a full mip chain, down to 1x1. */
uint32_t hatch_mip_chain_length(uint32_t width, uint32_t height);

/* Returns the size of a mip level: max(1, size >> level). */
uint32_t hatch_mip_size(uint32_t size, uint32_t level);

/* Returns the attribute of that name, or NULL. */
const struct hatch_attribute *hatch_mipmap_attribute(const struct hatch_mipmap *mipmap, const char *name);

/* Adds or replaces an attribute. A mipmap has at most HATCH_MIPMAP_ATTRIBUTES_MAX.
 *   type  HATCH_ATTRIBUTE_FLOAT or HATCH_ATTRIBUTE_INT
 *   text  kept by reference */
void hatch_mipmap_set_number(struct hatch_mipmap *mipmap, const char *name, double value,
                             enum hatch_attribute_type type);
void hatch_mipmap_set_text(struct hatch_mipmap *mipmap, const char *name, const char *text);

/* Convert between sRGB-encoded and linear values (IEC 61966-2-1), 0 .. 1. Results are rounded to float, so that they do
 * not depend on libm. */
float hatch_srgb_to_linear(float encoded);
float hatch_linear_to_srgb(float linear);

/* Convert between float and IEEE 754 binary16, rounding to nearest even. */
uint16_t hatch_half_from_float(float value);
float hatch_float_from_half(uint16_t half);

/* Convert count numbers between values[i * stride] and halves[i]. */
void hatch_halves_from_floats(const float *values, size_t stride, uint16_t *halves, size_t count);
void hatch_floats_from_halves(const uint16_t *halves, size_t count, float *values, size_t stride);

#endif
