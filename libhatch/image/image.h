/* Images: float pixels, linear light, channels by name; and mip-mapped images with attributes.
 *
 * Row 0 is the top row. In textures it holds v = 0 (glTF's convention), so that texel (x, y) covers
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

/* How a channel's numbers are kept in a file that has the choice (EXR). In memory all are floats;
 * a UINT channel holds whole numbers up to 2^24, which floats hold exactly. */
enum hatch_channel_type { HATCH_HALF, HATCH_FLOAT, HATCH_UINT };

struct hatch_channel {
    char name[HATCH_NAME_MAX]; /* "Y", "R", "G", "B", "A", "id", "t" or any other */
    enum hatch_channel_type type;
};

/* pixels[(y * width + x) * channel_count + c], owned by the arena that the image came from. */
struct hatch_image {
    uint32_t width, height; /* 1 .. 2^24 */
    uint32_t channel_count; /* 1 .. HATCH_IMAGE_CHANNELS_MAX */
    struct hatch_channel channels[HATCH_IMAGE_CHANNELS_MAX];
    float *pixels;
};

enum hatch_attribute_type { HATCH_ATTRIBUTE_FLOAT, HATCH_ATTRIBUTE_INT, HATCH_ATTRIBUTE_TEXT };

struct hatch_attribute {
    char name[HATCH_NAME_MAX]; /* "hatch:tone" */
    enum hatch_attribute_type type;
    double number;    /* FLOAT and INT */
    const char *text; /* TEXT: zero-terminated, owned by the arena or static */
};

/* One named image with its mip levels: level 0 is the finest; each level is half the one before,
 * rounded down, at least 1. All levels have the same channels. */
struct hatch_mipmap {
    char name[HATCH_NAME_MAX];
    uint32_t level_count; /* 1 .. HATCH_MIP_LEVELS_MAX */
    struct hatch_image *levels;
    uint32_t attribute_count;
    struct hatch_attribute attributes[HATCH_MIPMAP_ATTRIBUTES_MAX];
};

/* Makes a zeroed image whose channels are the letters of names ("Y", "RGB", "RGBA"), all HALF.
 * width, height: at least 1. HATCH_LIMIT when arena is too small. */
enum hatch_status hatch_image_make(struct hatch_arena *arena, uint32_t width, uint32_t height, const char *names,
                                   struct hatch_image *image, struct hatch_err *err) HATCH_MUST_USE;

/* The index of the channel of that name, or -1. */
int hatch_image_channel(const struct hatch_image *image, const char *name);

/* How many mip levels a full chain has: down to 1×1. */
uint32_t hatch_mip_chain_length(uint32_t width, uint32_t height);

/* The size of a mip level: max(1, size >> level). */
uint32_t hatch_mip_size(uint32_t size, uint32_t level);

/* The attribute of that name, or NULL. */
const struct hatch_attribute *hatch_mipmap_attribute(const struct hatch_mipmap *mipmap, const char *name);

/* Adds or replaces an attribute; an assert when there is no room. text is not copied. */
void hatch_mipmap_set_number(struct hatch_mipmap *mipmap, const char *name, double value,
                             enum hatch_attribute_type type);
void hatch_mipmap_set_text(struct hatch_mipmap *mipmap, const char *name, const char *text);

/* The sRGB transfer curve (IEC 61966-2-1); 0..1 each way. Results are rounded to float, so that
 * they do not depend on the processor's libm. */
float hatch_srgb_to_linear(float encoded);
float hatch_linear_to_srgb(float linear);

/* The IEEE 754 binary16 of a float, rounded to nearest even, and back. */
uint16_t hatch_half_from_float(float value);
float hatch_float_from_half(uint16_t half);

/* The same for count numbers: values[i * stride] and halves[i]. */
void hatch_halves_from_floats(const float *values, size_t stride, uint16_t *halves, size_t count);
void hatch_floats_from_halves(const uint16_t *halves, size_t count, float *values, size_t stride);

#endif
