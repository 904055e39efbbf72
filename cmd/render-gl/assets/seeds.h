/* Recursive procedural tonal art maps on the GPU: seed points, coverage lists, and the images of strokes. */
#ifndef RENDER_ASSETS_SEEDS_H
#define RENDER_ASSETS_SEEDS_H

#include <epoxy/gl.h>

#include "seed/rptam.h"

#define SEEDS_VIEWS 5

/* A model (struct hatch_rptam) on the GPU. Zeroed: none. */
struct seeds {
    GLuint layers;               /* uniform buffer: struct hatch_rptam_block */
    GLuint buffers[SEEDS_VIEWS]; /* images of strokes, seed points, coverage lists, tone curve, seed numbers */
    GLuint views[SEEDS_VIEWS];   /* textures through which shaders read the buffers */
    bool vary;                   /* strokes differ from seed point to seed point */
    bool shrink;                 /* strokes fade by getting smaller */
};

/* Uploads a model.
 *   all    true: every coverage list holds all strokes that may reach into the tile (slow; for comparison)
 *   seeds  out: owned by the caller
 * HATCH_LIMIT when the GPU's textures or memory are too small. */
enum hatch_status seeds_upload(const struct hatch_rptam *rptam, bool all, struct hatch_arena *scratch,
                               struct seeds *seeds, struct hatch_err *err) HATCH_MUST_USE;

/* Binds the model to BLOCK_TECHNIQUE and to the units from UNIT_TECHNIQUE on. */
void seeds_use(const struct seeds *seeds);

/* Releases the model; leaves *seeds zeroed. */
void seeds_free(struct seeds *seeds);

#endif
