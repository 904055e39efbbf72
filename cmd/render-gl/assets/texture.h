/* Textures for fine tone control (Webb et al. 2002): the volumes that tamvol writes, and the threshold textures and
 * exact runs that tamthresh writes. */
#ifndef RENDER_ASSETS_TEXTURE_H
#define RENDER_ASSETS_TEXTURE_H

#include "base/bytes.h"
#include "image/texels.h"
#include "tam/exact.h"
#include "tam/tam.h"

enum tone_texture_holds { TONE_TEXTURE_NONE, TONE_TEXTURE_VOLUME, TONE_TEXTURE_THRESHOLDS, TONE_TEXTURE_RUNS };

/* Zeroed: no texture. */
struct tone_texture {
    enum tone_texture_holds holds;
    struct hatch_texels texels; /* as in the file, possibly block-compressed */
    struct hatch_exact exact;   /* the parsed texels, if holds is TONE_TEXTURE_RUNS */
    uint32_t size_px;           /* side of the finest level */
    uint32_t levels;            /* mip levels that hold strokes */
    float darkest;              /* darkest tone, 0 .. 1; of a texture whose map was not whole, that of the whole one */
    float top;                  /* volume: tone at the end of its slices; else unset */
    float last;                 /* tone of the last column of a map that was not whole; else unset */
    struct hatch_tam_whole whole; /* of the map, as hatch_tam_whole_read sets it */
};

/* Reads a volume (3D texture or 2D array), a threshold texture or exact runs.
 *   arena  holds the texels
 * HATCH_BAD_INPUT for any other texture. */
enum hatch_status tone_texture_read(struct hatch_bytes file, struct hatch_arena *arena, struct hatch_arena *scratch,
                                    struct tone_texture *texture, struct hatch_err *err) HATCH_MUST_USE;

#endif
