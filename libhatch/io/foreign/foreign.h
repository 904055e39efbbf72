/* Images of any format. PNG and OpenEXR are read by libhatch, others (JPEG, TIFF, TGA, HDR, WebP ...) by
 * the OpenImageIO plugin, which is opened on demand: linking OpenImageIO would load 260 shared objects
 * into every process. */
#ifndef HATCH_IO_FOREIGN_FOREIGN_H
#define HATCH_IO_FOREIGN_FOREIGN_H

#include "base/bytes.h"
#include "image/image.h"

/* Reads an image as linear light with channels Y, YA, RGB or RGBA. The format is found from the
 * content, else from the extension of name. Values of 8 and 16 bits are decoded from sRGB unless the
 * file declares them linear. Of an OpenEXR file the first part's finest level is read.
 *   name    the file's name or "", for its extension; no file is opened
 *   plugin  path of hatch-oiio.so
 *   image   out: pixels in arena
 * HATCH_BAD_INPUT also when the plugin is needed and missing; HATCH_LIMIT before any pixel is read. */
enum hatch_status hatch_image_read_any(struct hatch_bytes file, const char *name, const char *plugin,
                                       struct hatch_arena *arena, struct hatch_arena *scratch,
                                       struct hatch_image *image, struct hatch_err *err) HATCH_MUST_USE;

#endif
