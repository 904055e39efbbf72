/* Reads and writes PNG files with libpng. */
#ifndef HATCH_IO_PNG_PNG_H
#define HATCH_IO_PNG_PNG_H

#include "base/bytes.h"
#include "image/image.h"

/* Reads a PNG as linear light with channels Y, YA, RGB or RGBA: palettes and low bit depths are expanded, sRGB is
 * decoded; gamma and ICC chunks are ignored.
 *   image  out: pixels in arena
 * HATCH_BAD_INPUT for a truncated or damaged file; HATCH_LIMIT, before any pixel is read, when the pixels exceed the
 * arena's limit. */
enum hatch_status hatch_png_read(struct hatch_bytes file, struct hatch_arena *arena, struct hatch_arena *scratch,
                                 struct hatch_image *image, struct hatch_err *err) HATCH_MUST_USE;

/* Encoding of colours: SRGB for pictures, which are in linear light; RAW for data, which is written as it is. */
enum hatch_png_encoding { HATCH_PNG_SRGB, HATCH_PNG_RAW };

/* Writes the first four channels of an image, clamped to 0 .. 1 and rounded to nearest. The bytes depend on
 * the arguments alone: no time is written.
 *   depth    bits per channel: 8 or 16
 *   comment  text chunk "Comment" ("seed 1"), up to 1023 bytes; may be NULL
 *   file     out: appended to; its arena is not scratch */
enum hatch_status hatch_png_write(const struct hatch_image *image, enum hatch_png_encoding encoding, uint32_t depth,
                                  const char *comment, struct hatch_arena *scratch, struct hatch_buffer *file,
                                  struct hatch_err *err) HATCH_MUST_USE;

#endif
