/* The look at foreign headers; what the plugin does is OpenImageIO's own. */
#include "fuzz.h"

#include "io/foreign/header.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct hatch_foreign_header header;
    if (hatch_foreign_header_read((struct hatch_bytes){data, size}, &header))
        fuzz_touch(header.ending, 2);
    return 0;
}
