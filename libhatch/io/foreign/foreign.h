/* Reads images of any format: PNG and OpenEXR with libhatch, others (JPEG, TIFF, TGA, HDR, WebP ..., and OpenEXR with
 * lossy compression, only layers, or more than 8 channels) with the OpenImageIO plugin. The plugin is opened on demand,
 * since linking OpenImageIO would load 260 shared objects into every process. */
#ifndef HATCH_IO_FOREIGN_FOREIGN_H
#define HATCH_IO_FOREIGN_FOREIGN_H

#include "base/bytes.h"
#include "image/image.h"

/* Reads an image as linear light with channels Y, YA, RGB or RGBA. The format is recognised by the content, else by the
 * extension of name. Integers are decoded from sRGB, except where a file other than PNG declares them linear; floats
 * are taken as linear. Colours that are multiplied by alpha, as in OpenEXR and in some TIFF files, are divided by it.
 * Of an OpenEXR file, the finest level of the first part is read, and placed in its display window: pixels outside are
 * cut off, missing ones are 0.
 *   name    the file's name or "", for its extension; no file is opened
 *   plugin  path of hatch-oiio.so
 *   image   out: pixels in arena
 * HATCH_BAD_INPUT also when the plugin is needed and missing, and for a display window far larger than the pixels in it
 * and than 8192 x 4096; HATCH_IO when the plugin cannot be loaded; HATCH_LIMIT, before any pixel is read, when the
 * pixels exceed the arena's limit. */
enum hatch_status hatch_image_read_any(struct hatch_bytes file, const char *name, const char *plugin,
                                       struct hatch_arena *arena, struct hatch_arena *scratch,
                                       struct hatch_image *image, struct hatch_err *err) HATCH_MUST_USE;

#endif
