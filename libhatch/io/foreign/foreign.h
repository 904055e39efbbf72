/* Image formats that are not ours (JPEG, TIFF, TGA, HDR, WebP …), by the OpenImageIO plugin, which
 * is opened on demand: linking OpenImageIO would cost every process 260 shared objects. */
#ifndef HATCH_IO_FOREIGN_H
#define HATCH_IO_FOREIGN_H

#include "base/bytes.h"
#include "image/image.h"

/* Reads any image: PNG and EXR (its first part's finest level) by our own adapters, by content; all
 * else through the plugin, with the name's ending as a hint. Linear floats, channels Y, Y A, RGB or
 * RGBA: numbers of 8 and 16 bits are taken for sRGB unless the file says linear. Sizes are checked
 * before pixels are read: HATCH_LIMIT. plugin: the path of hatch-oiio.so. HATCH_BAD_INPUT says when
 * the plugin is not there. */
enum hatch_status hatch_image_read_any(struct hatch_bytes file, const char *name, const char *plugin,
                                       struct hatch_arena *arena, struct hatch_arena *scratch,
                                       struct hatch_image *image, struct hatch_err *err) HATCH_MUST_USE;

#endif
