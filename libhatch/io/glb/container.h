/* The GLB container: a header and two chunks (Khronos, "glTF 2.0 Specification", §4.4). */
#ifndef HATCH_IO_GLB_CONTAINER_H
#define HATCH_IO_GLB_CONTAINER_H

#include "base/bytes.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Appends a GLB file with the given JSON and a binary chunk of zeros, which the caller fills: the last bytes of file.
 *   json         padded with spaces to a multiple of 4 bytes
 *   binary_size  a multiple of 4; 0: there is no such chunk
 * HATCH_LIMIT also above 4 GiB. */
enum hatch_status hatch_glb_add_container(struct hatch_bytes json, size_t binary_size, struct hatch_buffer *file,
                                          struct hatch_err *err) HATCH_MUST_USE;

#ifdef __cplusplus
}
#endif

#endif
