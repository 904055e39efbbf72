/* Private to the reader of foreign images: sizes from a file's header. Loading the plugin takes 0.2 s and
 * 130 MB, too much for a file that will be refused. */
#ifndef HATCH_IO_FOREIGN_HEADER_H
#define HATCH_IO_FOREIGN_HEADER_H

#include <stdbool.h>

#include "base/bytes.h"

struct hatch_foreign_header {
    const char *extension;  /* of the format: ".jpeg" */
    uint32_t width, height; /* pixels, as the file claims */
    bool truncated;         /* JPEG: no end marker after the first scan */
};

/* Reads the header of a JPEG, TIFF, GIF or BMP file; false for other formats and headers that are too
 * short. */
bool hatch_foreign_header_read(struct hatch_bytes file, struct hatch_foreign_header *header);

#endif
