/* Private to the reader and the writer of KTX2. */
#ifndef HATCH_IO_TEXTURE_PARTS_H
#define HATCH_IO_TEXTURE_PARTS_H

#define HATCH_KTX2_IDENTIFIER                                                                                          \
    {                                                                                                                  \
        0xab, 'K', 'T', 'X', ' ', '2', '0', 0xbb, '\r', '\n', 0x1a, '\n'                                               \
    }
#define HATCH_KTX2_IDENTIFIER_BYTES 12u
#define HATCH_KTX2_HEADER_BYTES 80u
#define HATCH_KTX2_LEVEL_BYTES 24u /* size of an entry of the level index */

#endif
