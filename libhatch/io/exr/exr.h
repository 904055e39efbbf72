/* OpenEXR files: several named parts, each tiled and mip-mapped (or flat scanlines, when reading),
 * on OpenEXR's C core. Everything is encoded in and decoded from memory. */
#ifndef HATCH_IO_EXR_H
#define HATCH_IO_EXR_H

#include "base/bytes.h"
#include "base/parallel.h"
#include "image/image.h"

/* Reads every part: scanline or tiled, one level or mip-mapped, HALF, FLOAT or UINT channels (at
 * most 8: R, G, B, Y and A come first, then the others as in the file), any lossless compression;
 * float, int and string attributes that the format itself does not need, the first 16 of them. Deep
 * data, rip-maps, sub-sampled channels and cut or damaged files are HATCH_BAD_INPUT; so is a header
 * that claims more than its compression can have packed into the file. Sizes are checked against
 * the arena's limit before anything is allocated: HATCH_LIMIT. Pixels that are not finite are kept;
 * the caller decides. arena and scratch may be one. Parts are decoded on pool's threads, NULL: on one;
 * what comes out is the same. */
enum hatch_status hatch_exr_read(struct hatch_bytes file, struct hatch_pool *pool, struct hatch_arena *arena,
                                 struct hatch_arena *scratch, struct hatch_mipmap **parts, uint32_t *part_count,
                                 struct hatch_err *err) HATCH_MUST_USE;

struct hatch_exr_writer;

/* Begins a file of part_count parts, all of base's size, levels and channels (its pixels are not
 * looked at). More than one level makes tiled mip-maps, ZIP compressed; one level makes scanlines.
 */
enum hatch_status hatch_exr_begin(const struct hatch_mipmap *base, uint32_t part_count, struct hatch_arena *arena,
                                  struct hatch_exr_writer **writer, struct hatch_err *err) HATCH_MUST_USE;

/* Converts and compresses one part and keeps the compressed bytes, not the pixels. Different parts
 * may be added from different threads at once; each part once. */
enum hatch_status hatch_exr_add_part(struct hatch_exr_writer *writer, uint32_t part, const struct hatch_mipmap *mipmap,
                                     struct hatch_err *err) HATCH_MUST_USE;

/* Writes the file's bytes into an empty buffer; whatever happens, the writer is done then. The
 * bytes depend on the parts alone. */
enum hatch_status hatch_exr_end(struct hatch_exr_writer *writer, struct hatch_buffer *file,
                                struct hatch_err *err) HATCH_MUST_USE;

/* The same bytes where they lie, for a file that is too large to be laid out once more: what comes first goes into an
 * empty head, and pieces[part_count] are what follows, in this order. They live until hatch_exr_abandon, which the
 * caller owes in any case. */
enum hatch_status hatch_exr_pieces(struct hatch_exr_writer *writer, struct hatch_buffer *head,
                                   struct hatch_bytes *pieces, struct hatch_err *err) HATCH_MUST_USE;

/* Frees what the writer holds outside its arena: after hatch_exr_pieces, or on the way out after a failure. NULL is
 * allowed. */
void hatch_exr_abandon(struct hatch_exr_writer *writer);

/* A whole file of one part. */
enum hatch_status hatch_exr_write(const struct hatch_mipmap *part, struct hatch_arena *scratch,
                                  struct hatch_buffer *file, struct hatch_err *err) HATCH_MUST_USE;

#endif
