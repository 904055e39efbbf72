/* PNG on libpng. */
#ifndef HATCH_IO_PNG_H
#define HATCH_IO_PNG_H

#include "base/bytes.h"
#include "image/image.h"

/* Any PNG as linear floats: Y, Y A, RGB or RGBA; palettes and low depths expanded, sRGB decoded
 * (gamma and ICC chunks are ignored). HATCH_BAD_INPUT for what is cut or damaged; the header's size is
 * checked against the arena's limit first: HATCH_LIMIT. */
enum hatch_status hatch_png_read(struct hatch_bytes file, struct hatch_arena *arena, struct hatch_arena *scratch,
                                 struct hatch_image *image, struct hatch_err *err) HATCH_MUST_USE;

/* How the floats become bytes: SRGB encodes linear light, the default for pictures; RAW writes the
 * numbers as they are, for data. */
enum hatch_png_encoding { HATCH_PNG_SRGB, HATCH_PNG_RAW };

/* The first 1, 2, 3 or 4 channels of the image, clamped to 0..1 and rounded to nearest. depth: 8 or
 * 16 bits. No time, no text but "Software" and what comment says ("seed 1"; may be NULL). */
enum hatch_status hatch_png_write(const struct hatch_image *image, enum hatch_png_encoding encoding, uint32_t depth,
                                  const char *comment, struct hatch_arena *scratch, struct hatch_buffer *file,
                                  struct hatch_err *err) HATCH_MUST_USE;

#endif
