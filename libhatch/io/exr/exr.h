/* Reads and writes OpenEXR files of one or more named parts, each mip-mapped or of one level, with OpenEXR's C core.
 * Files are read from and written to memory. */
#ifndef HATCH_IO_EXR_EXR_H
#define HATCH_IO_EXR_EXR_H

#include <stdbool.h>

#include "base/bytes.h"
#include "base/parallel.h"
#include "image/image.h"

/* Returns whether a file begins as OpenEXR files do. */
bool hatch_exr_is(struct hatch_bytes file);

/* Reads every part. Supported are scanlines and tiles; a single level and mip-maps; no compression, RLE, ZIPS, ZIP and
 * PIZ; and 1 to 8 channels of type HALF, FLOAT or UINT. Channels are ordered R, G, B, Y, A, then the others in file
 * order. The first HATCH_MIPMAP_ATTRIBUTES_MAX attributes of type float, int or string whose names begin with "hatch:"
 * are kept, and so are values that are not finite. The result is the same for any number of threads.
 *   pool     decodes parts in parallel; NULL: on the caller's thread
 *   scratch  may be arena
 *   parts    out: part_count mip-mapped images, in arena
 * HATCH_BAD_INPUT for deep data, rip-maps, sub-sampled channels, lossy compression, a truncated or damaged file, and a
 * header that claims more pixels than the file's bytes can hold; HATCH_LIMIT, before any allocation, when the pixels
 * exceed the arena's limit. */
enum hatch_status hatch_exr_read(struct hatch_bytes file, struct hatch_pool *pool, struct hatch_arena *arena,
                                 struct hatch_arena *scratch, struct hatch_mipmap **parts, uint32_t *part_count,
                                 struct hatch_err *err) HATCH_MUST_USE;

/* Returns whether hatch_exr_read refuses a file although its header is sound, or reads no colours of it: a part has
 * lossy compression, more than 8 channels, or neither Y nor R, G and B.
 *   width, height  out: of the first part, pixels; the height is that of whole chunks, which decoders hold in memory;
 *                  unchanged if the result is false */
bool hatch_exr_is_other_kind(struct hatch_bytes file, uint32_t *width, uint32_t *height);

/* The place of a picture's pixels, its data window, in the picture, its display window. */
struct hatch_exr_frame {
    uint32_t width, height; /* of the picture */
    int64_t left, top;      /* of the pixels' first one; outside the picture if it is not in 0 .. width, height */
};

/* Finds out where the pixels of a file's first part belong.
 *   frame  out: all 0 if the pixels are just those of the picture
 * HATCH_BAD_INPUT and HATCH_LIMIT as from hatch_exr_read. */
enum hatch_status hatch_exr_frame_read(struct hatch_bytes file, struct hatch_exr_frame *frame,
                                       struct hatch_err *err) HATCH_MUST_USE;

struct hatch_exr_writer;

/* Begins a file in which all parts have the size, the number of levels and the channels of base. Several levels are
 * written as ZIP-compressed mip-mapped tiles, a single level as ZIP-compressed scanlines.
 *   base        its pixels are not read; one level, or the full chain down to 1x1
 *   part_count  at least 1
 *   arena       holds the writer; the memory left in it is also the limit of the compressed parts */
enum hatch_status hatch_exr_begin(const struct hatch_mipmap *base, uint32_t part_count, struct hatch_arena *arena,
                                  struct hatch_exr_writer **writer, struct hatch_err *err) HATCH_MUST_USE;

/* Compresses one part; the writer keeps the compressed bytes and copies of name and attributes. Safe to
 * call from several threads at once for different parts.
 *   part    index, 0 .. part_count - 1; each is added once
 *   mipmap  UINT channels: integers 0 .. 2^24 */
enum hatch_status hatch_exr_add_part(struct hatch_exr_writer *writer, uint32_t part, const struct hatch_mipmap *mipmap,
                                     struct hatch_err *err) HATCH_MUST_USE;

/* Joins the parts into one file and frees the writer, even on failure. The bytes depend on the parts
 * alone, not on threads or the order in which they were added.
 *   file  out: empty buffer; stays empty on failure
 * HATCH_IO when the header cannot be written. */
enum hatch_status hatch_exr_end(struct hatch_exr_writer *writer, struct hatch_buffer *file,
                                struct hatch_err *err) HATCH_MUST_USE;

/* Returns the bytes of hatch_exr_end without joining them, for files too large to copy. The caller must then call
 * hatch_exr_abandon, even on failure; the pieces are valid until then.
 *   head    out: empty buffer; receives the file's first bytes
 *   pieces  out: part_count byte strings that follow head, in this order
 * HATCH_IO when the header cannot be written. */
enum hatch_status hatch_exr_pieces(struct hatch_exr_writer *writer, struct hatch_buffer *head,
                                   struct hatch_bytes *pieces, struct hatch_err *err) HATCH_MUST_USE;

/* Frees the memory that the writer has outside its arena. Call it after hatch_exr_pieces, or after a failure instead of
 * hatch_exr_end. NULL is allowed. */
void hatch_exr_abandon(struct hatch_exr_writer *writer);

/* Writes a file of one part, by hatch_exr_begin, hatch_exr_add_part and hatch_exr_end. */
enum hatch_status hatch_exr_write(const struct hatch_mipmap *part, struct hatch_arena *scratch,
                                  struct hatch_buffer *file, struct hatch_err *err) HATCH_MUST_USE;

#endif
