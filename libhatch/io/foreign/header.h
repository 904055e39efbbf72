/* Private to the reader of foreign images: reads the size of an image from its header, so that a file that must be
 * refused is refused without loading the plugin, which takes 0.2 s and 130 MB. */
#ifndef HATCH_IO_FOREIGN_HEADER_H
#define HATCH_IO_FOREIGN_HEADER_H

#include <stdbool.h>

#include "base/bytes.h"

struct hatch_foreign_header {
    const char *extension;  /* extension of the format, such as ".jpeg" */
    uint32_t width, height; /* pixels, as the file claims */
    bool truncated;         /* JPEG: no end marker after the first scan */
};

/* Reads the header of a JPEG, TIFF, GIF, BMP, WebP, JPEG 2000, PSD, DDS, HDR or netpbm file. Returns false
 * for other formats and for headers without a size. */
bool hatch_foreign_header_read(struct hatch_bytes file, struct hatch_foreign_header *header);

#endif
