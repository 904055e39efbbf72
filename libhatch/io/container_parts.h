/* What the KTX2 and DDS code share. */
#ifndef HATCH_IO_CONTAINER_PARTS_H
#define HATCH_IO_CONTAINER_PARTS_H

#include "io/container.h"

#define HATCH_KTX2_IDENTIFIER                                                                      \
    {                                                                                              \
        0xab, 'K', 'T', 'X', ' ', '2', '0', 0xbb, '\r', '\n', 0x1a, '\n'                           \
    }
#define HATCH_KTX2_IDENTIFIER_BYTES 12u
#define HATCH_KTX2_HEADER_BYTES 80u
#define HATCH_KTX2_LEVEL_BYTES 24u /* of the level index */

/* How many levels a full chain has: down to 1x1, or 1x1x1. */
uint32_t hatch_texels_chain_length(const struct hatch_texels *texture);

/* A texture that is no texture is its caller's mistake. */
void hatch_texels_assert(const struct hatch_texels *texture);

#endif
