/* Private to the glTF reader: what must be known about a file before its package sees it. */
#ifndef HATCH_IO_GLTF_CHECK_H
#define HATCH_IO_GLTF_CHECK_H

#include <stdbool.h>

#include "base/bytes.h"

#ifdef __cplusplus
extern "C" {
#endif

#define HATCH_GLTF_DEPTH_MAX 64u

struct hatch_gltf_parts {
    struct hatch_bytes file; /* without zeros behind its end */
    struct hatch_bytes json;
    struct hatch_bytes binary; /* the BIN chunk; size 0 where there is none */
};

/* Takes a GLB apart, or takes the whole file for JSON. HATCH_BAD_INPUT for a version that is not 2,
 * lengths that do not add up, chunks out of order. */
enum hatch_status hatch_gltf_split(struct hatch_bytes file, struct hatch_gltf_parts *parts,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* What the buffers with a file of their own say of its length, in their order. */
struct hatch_gltf_lengths {
    struct hatch_buffer bytes; /* of uint64_t */
};

/* Refuses by its name an extension that the file requires and that is not known here, nesting deeper than
 * HATCH_GLTF_DEPTH_MAX, and every index, count and offset that is not written as a whole number within
 * 0 .. 2^31 - 1 (offsets and lengths: 2^53): the package cuts larger ones to 32 bits and skips others, both
 * without a word. What stands in extras and in other extensions than lights is let be. The syntax itself is
 * the package's to check. lengths: begun with an arena, or NULL. */
enum hatch_status hatch_gltf_check_json(struct hatch_bytes json, struct hatch_gltf_lengths *lengths,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* Whether a decoded URI stays in its folder: relative, no scheme, no "..", no backslash. */
bool hatch_gltf_uri_is_local(const char *uri);

#ifdef __cplusplus
}
#endif

#endif
