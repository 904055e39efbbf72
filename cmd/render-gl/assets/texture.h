/* Textures of fine tone (Webb et al. 2002), as tamvol and tamthresh write them. */
#ifndef RENDER_ASSETS_TEXTURE_H
#define RENDER_ASSETS_TEXTURE_H

#include "base/bytes.h"
#include "image/texels.h"
#include "tam/exact.h"

enum tone_texture_holds { TONE_TEXTURE_NONE, TONE_TEXTURE_VOLUME, TONE_TEXTURE_THRESHOLDS, TONE_TEXTURE_RUNS };

/* Zeroed: none. */
struct tone_texture {
    enum tone_texture_holds holds;
    struct hatch_texels texels; /* as in the file: packed in blocks, perhaps */
    struct hatch_exact exact;   /* RUNS: the same as runs */
    uint32_t size_px;           /* side of the finest level */
    uint32_t levels;            /* levels that hold strokes */
    float darkest;              /* tone beyond which no ink is added */
};

/* Whether a file is a KTX2 texture, by its first bytes. */
bool tone_texture_is(struct hatch_bytes file);

/* Reads a volume, in slices or in layers, thresholds or exact runs.
 *   arena  keeps the texels
 * HATCH_BAD_INPUT for any other texture. */
enum hatch_status tone_texture_read(struct hatch_bytes file, struct hatch_arena *arena, struct hatch_arena *scratch,
                                    struct tone_texture *texture, struct hatch_err *err) HATCH_MUST_USE;

#endif
