/* Headers of foreign images; the plugin itself is OpenImageIO's to test. */
#include "fuzz.h"

#include "io/foreign/header.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct hatch_foreign_header header;
    if (hatch_foreign_header_read((struct hatch_bytes){data, size}, &header))
        fuzz_touch(header.extension, 2);
    return 0;
}
