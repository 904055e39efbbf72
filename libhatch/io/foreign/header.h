/* A look at the header of a foreign image, before the plugin is opened: that takes a fifth of a
 * second and 130 MB, too much for a file that will be refused. */
#ifndef HATCH_IO_FOREIGN_HEADER_H
#define HATCH_IO_FOREIGN_HEADER_H

#include <stdbool.h>

#include "base/bytes.h"

struct hatch_foreign_header {
    const char *ending;     /* of the names of such files: ".jpeg" */
    uint32_t width, height; /* as the file claims */
    bool whole;             /* false: the file is known to end too early */
};

/* Knows JPEG, TIFF, GIF and BMP; false for anything else, and where the header is too short. */
bool hatch_foreign_header_read(struct hatch_bytes file, struct hatch_foreign_header *header);

#endif
