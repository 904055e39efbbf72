/* Solid textures: cubes of texels that repeat along each axis, in which objects are carved. A solid texture needs no
 * texture coordinates: the position of a point on the object is its place in the texture. solid(5) describes the file.
 */
#ifndef HATCH_SOLID_SOLID_H
#define HATCH_SOLID_SOLID_H

#include <stdbool.h>

#include "image/texels.h"

#define HATCH_SOLID_SIZE_MIN 8u
#define HATCH_SOLID_SIZE_MAX 512u

/* Keys of the file: the style or method that made the texture, and its random seed. */
#define HATCH_SOLID_KEY "hatch:solid"
#define HATCH_SOLID_KEY_SEED "hatch:seed"
/* Its value "yes" tells that the texture has no direction, so that it may be turned against the mesh. */
#define HATCH_SOLID_KEY_ISOTROPIC "hatch:isotropic"

/* The finest level of a solid texture. Texel (x, y, z) covers [x, x + 1) / size and so on along each axis; what lies
 * beyond is repeated. A flat texture is the same at every z. */
struct hatch_solid {
    uint32_t size;     /* texels along x and y, a power of two, HATCH_SOLID_SIZE_MIN .. HATCH_SOLID_SIZE_MAX */
    uint32_t channels; /* 1: grey; 3: R G B */
    uint8_t *texels;   /* [((z * size + y) * size + x) * channels + c]: linear reflectance, 255 is paper, 0 is ink */
    uint32_t depth;    /* texels along z: size, or 1: a flat texture */
    bool isotropic;    /* known to have no direction */
};

/* Returns the number of texels. */
static inline size_t hatch_solid_count(const struct hatch_solid *solid)
{
    return (size_t)solid->size * solid->size * solid->depth;
}

/* Makes a cube whose texels are 0.
 *   size, channels  as in struct hatch_solid
 *   solid           out, in arena
 * HATCH_LIMIT, before any work, when the memory does not suffice. */
enum hatch_status hatch_solid_make(struct hatch_arena *arena, uint32_t size, uint32_t channels,
                                   struct hatch_solid *solid, struct hatch_err *err) HATCH_MUST_USE;

/* Makes the same or, with like->depth 1, a flat texture.
 *   like  depth and channels; its texels are not read */
enum hatch_status hatch_solid_make_like(struct hatch_arena *arena, const struct hatch_solid *like, uint32_t size,
                                        uint32_t channels, struct hatch_solid *solid,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* Makes a flat texture of an image. Its side is the least power of two in range that is at least as long as both sides
 * of the image, or the largest in range; the image is stretched to that square.
 *   image  channels Y, YA, RGB or RGBA, linear; alpha is left out
 *   solid  out, in arena
 * HATCH_LIMIT when the memory does not suffice. */
enum hatch_status hatch_solid_of_image(const struct hatch_image *image, struct hatch_arena *arena,
                                       struct hatch_solid *solid, struct hatch_err *err) HATCH_MUST_USE;

/* Makes the mip chain of a solid texture, down to one texel. A texel of a coarser level is the mean of eight; of a flat
 * texture, of four.
 *   texture  out: a 3D texture in arena, of depth 1 if flat; its finest level is solid->texels itself
 * HATCH_LIMIT when the memory does not suffice. */
enum hatch_status hatch_solid_mips(const struct hatch_solid *solid, struct hatch_arena *arena,
                                   struct hatch_texels *texture, struct hatch_err *err) HATCH_MUST_USE;

/* Returns whether the parts of an OpenEXR file are the slices of a texture (solid(5)). */
bool hatch_solid_is_slices(const struct hatch_mipmap *parts, uint32_t count);

/* Makes the solid texture whose slices are these parts, in their order.
 *   solid  out: in arena, with hatch:isotropic
 * HATCH_BAD_INPUT, with the reason, when they are no cube of one of the sizes, or when their channels are neither Y nor
 * R, G and B; HATCH_LIMIT when the memory does not suffice. */
enum hatch_status hatch_solid_of_slices(const struct hatch_mipmap *parts, uint32_t count, struct hatch_arena *arena,
                                        struct hatch_solid *solid, struct hatch_err *err) HATCH_MUST_USE;

/* Takes the solid texture from a texture that a file held. Values in sRGB are decoded.
 *   solid  out: its finest level, by reference; in arena if the texture was in sRGB or had alpha, which is left out
 * HATCH_BAD_INPUT, with the reason, when it is neither a cube nor a square of plain texels with one, three or four
 * channels whose side is a power of two in range; HATCH_LIMIT when the memory does not suffice. */
enum hatch_status hatch_solid_take(const struct hatch_texels *texture, struct hatch_arena *arena,
                                   struct hatch_solid *solid, struct hatch_err *err) HATCH_MUST_USE;

#endif
