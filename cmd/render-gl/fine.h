/* Textures of fine tone: volumes and thresholds (Webb et al. 2002), as tamvol and tamthresh write them. */
#ifndef RENDER_FINE_H
#define RENDER_FINE_H

#include "base/bytes.h"
#include "image/texels.h"
#include "render-gl/columns.h"
#include "tam/exact.h"

struct fine {
    enum columns_form form;     /* COLUMNS_NONE: there is none */
    struct hatch_texels texels; /* packed in blocks, perhaps */
    struct hatch_exact exact;   /* the same as runs; no columns where it is something else */
    uint32_t size_px;           /* of the finest level */
    uint32_t levels;            /* that hold strokes */
    float darkest;              /* tone beyond which nothing is added */
};

/* Whether a file is a KTX2 texture, by its first bytes. */
bool fine_is(struct hatch_bytes file);

/* Reads a volume, in slices or in layers, thresholds or exact runs into arena. HATCH_BAD_INPUT for any other
 * texture. */
enum hatch_status fine_read(struct hatch_bytes file, struct hatch_arena *arena, struct hatch_arena *scratch,
                            struct fine *fine, struct hatch_err *err) HATCH_MUST_USE;

/* Uploads it as it is, packed or not. HATCH_LIMIT when the GPU's textures or memory are too small. */
enum hatch_status fine_upload(const struct fine *fine, float anisotropy, struct gpu_columns *columns,
                              struct hatch_err *err) HATCH_MUST_USE;

#endif
