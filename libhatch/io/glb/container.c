#include "io/glb/container.h"

enum { GLB_HEADER = 12, CHUNK_HEADER = 8 };

enum hatch_status hatch_glb_add_container(struct hatch_bytes json, size_t binary_size, struct hatch_buffer *file,
                                          struct hatch_err *err)
{
    size_t chunk = binary_size > 0 ? CHUNK_HEADER + binary_size : 0;
    size_t total = GLB_HEADER + CHUNK_HEADER + json.size + chunk;
    if (total > UINT32_MAX)
        return hatch_fail(err, HATCH_LIMIT, "%zu bytes: a GLB file holds at most %u", total, UINT32_MAX);
    HATCH_TRY(hatch_buffer_reserve(file, total, err));
    HATCH_TRY(hatch_buffer_add(file, "glTF", 4, err));
    HATCH_TRY(hatch_buffer_add_u32le(file, 2, err));
    HATCH_TRY(hatch_buffer_add_u32le(file, (uint32_t)total, err));
    HATCH_TRY(hatch_buffer_add_u32le(file, (uint32_t)json.size, err));
    HATCH_TRY(hatch_buffer_add(file, "JSON", 4, err));
    HATCH_TRY(hatch_buffer_add(file, json.data, json.size, err));
    if (chunk == 0)
        return HATCH_OK;
    HATCH_TRY(hatch_buffer_add_u32le(file, (uint32_t)binary_size, err));
    HATCH_TRY(hatch_buffer_add(file, "BIN", 4, err));
    return hatch_buffer_add(file, NULL, binary_size, err);
}
