/* Recursive procedural tonal art maps on the GPU: the seeds, the lists of the strokes near each place, the
 * strokes' images. What the shader rptam.frag reads. */
#ifndef RENDER_SEEDS_H
#define RENDER_SEEDS_H

#include <epoxy/gl.h>

#include "render-gl/scene.h"
#include "seed/rptam.h"

#define SEEDS_VIEWS 5

struct gpu_seeds {
    GLuint layers;                                   /* a buffer */
    GLuint buffers[SEEDS_VIEWS], views[SEEDS_VIEWS]; /* strokes, seeds, lists, ways, seeds' numbers; they as
                                                       textures */
    bool vary, shrink; /* what programs are compiled for: strokes differ, and they fade by size */
};

/* Uploads the model. all: the shader looks at every seed at every place, which is slow. */
enum hatch_status seeds_upload(const struct hatch_rptam *rptam, bool all, struct hatch_arena *scratch,
                               struct gpu_seeds *seeds, struct hatch_err *err) HATCH_MUST_USE;

/* Binds them for drawing. */
void seeds_bind(const struct gpu_seeds *seeds);

void seeds_free(struct gpu_seeds *seeds);

/* Gives every item's vertices their spans: where the surface goes with a unit of u and of v (the columns of T in
 * §5.1), each the mean of the faces around the vertex by their area, so that strokes have one scale on both
 * sides of an edge. Zero where texture coordinates are degenerate, and on skinned items, whose
 * surface moves: the shader then takes the derivatives of the picture. */
enum hatch_status seeds_set_spans(struct gpu_scene *scene, struct hatch_arena *scratch,
                                  struct hatch_err *err) HATCH_MUST_USE;

#endif
