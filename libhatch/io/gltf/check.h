/* Private to the glTF reader: checks of a file before tinygltf parses it. */
#ifndef HATCH_IO_GLTF_CHECK_H
#define HATCH_IO_GLTF_CHECK_H

#include <stdbool.h>

#include "base/bytes.h"

#ifdef __cplusplus
extern "C" {
#endif

#define HATCH_GLTF_DEPTH_MAX 64u

struct hatch_gltf_parts {
    struct hatch_bytes file; /* of a GLB: without trailing zeros */
    struct hatch_bytes json;
    struct hatch_bytes binary; /* the BIN chunk; size 0 when absent */
};

/* Splits a GLB into its chunks; any other file is taken as JSON. The parts point into file.
 * HATCH_BAD_INPUT for a version other than 2, inconsistent lengths and chunks out of order. */
enum hatch_status hatch_gltf_split(struct hatch_bytes file, struct hatch_gltf_parts *parts,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* The JSON of an object, from its opening brace to after its closing one, in bytes. */
struct hatch_gltf_range {
    size_t start, end;
};

/* The buffers of a file. */
struct hatch_gltf_buffers {
    struct hatch_buffer lengths;   /* array of uint64_t: byteLength of each that is an external file, in file order */
    struct hatch_buffer fallbacks; /* array of struct hatch_gltf_range: those that hold nothing but what compressed
                                    * views stand for (EXT_meshopt_compression, "fallback"); they may have no data */
};

/* Checks JSON for errors that tinygltf accepts silently: required extensions that are not supported; nesting deeper
 * than HATCH_GLTF_DEPTH_MAX; and indices and counts that are not integers 0 .. 2^31 - 1 (offsets and lengths: 0 ..
 * 2^53), which tinygltf truncates to 32 bits or skips. Checks neither the syntax nor extras, and no extension other
 * than lights.
 *   buffers  out: appended to; its members have an arena; may be NULL
 * HATCH_BAD_INPUT with the place in the JSON, in bytes, or the name of the extension. */
enum hatch_status hatch_gltf_check_json(struct hatch_bytes json, struct hatch_gltf_buffers *buffers,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* Returns whether a decoded URI stays in its folder: it is relative and has no scheme, no ".." and no backslash. */
bool hatch_gltf_uri_is_local(const char *uri);

#ifdef __cplusplus
}
#endif

#endif
