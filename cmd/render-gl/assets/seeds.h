/* Recursive procedural tonal art maps on the GPU: seed points, the lists of the strokes near each place, the strokes'
 * images. */
#ifndef RENDER_ASSETS_SEEDS_H
#define RENDER_ASSETS_SEEDS_H

#include <epoxy/gl.h>

#include "seed/rptam.h"

#define SEEDS_VIEWS 5

/* Zeroed: none. */
struct seeds {
    GLuint layers;                                   /* uniform block */
    GLuint buffers[SEEDS_VIEWS], views[SEEDS_VIEWS]; /* strokes, seeds, lists, ways, seeds' numbers; as textures */
    bool vary, shrink;                               /* strokes differ; they fade by size */
};

/* Uploads a model.
 *   all  shaders look at every seed at every place, which is slow
 * HATCH_LIMIT where the GPU's textures or memory are too small. */
enum hatch_status seeds_upload(const struct hatch_rptam *rptam, bool all, struct hatch_arena *scratch,
                               struct seeds *seeds, struct hatch_err *err) HATCH_MUST_USE;

/* Binds them for shaders, as the technique's own block and units. */
void seeds_use(const struct seeds *seeds);

/* Leaves *seeds zeroed. */
void seeds_free(struct seeds *seeds);

#endif
