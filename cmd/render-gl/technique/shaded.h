/* Techniques that shade surfaces in one loop over the items: their preparation and their drawing, which differ by
 * struct frame_shading alone. */
#ifndef RENDER_TECHNIQUE_SHADED_H
#define RENDER_TECHNIQUE_SHADED_H

#include "render-gl/technique/technique.h"

#define SHADED_DEFINES_BYTES 256u

/* The state of such a technique, or the first member of it. */
struct shaded_state {
    struct frame_shader shader;
    char defines[SHADED_DEFINES_BYTES]; /* those that the shader is compiled with */
};

/* Compiles for the scene's items: struct technique's prepare. */
enum hatch_status shaded_prepare(struct technique_context *context, struct technique_instance *instance,
                                 struct hatch_err *err) HATCH_MUST_USE;

/* The same with more lines before every stage, which may differ from those of the last call. */
enum hatch_status shaded_prepare_with(struct technique_context *context, struct technique_instance *instance,
                                      const char *defines, struct hatch_err *err) HATCH_MUST_USE;

/* Draws every item: struct technique's draw. */
enum hatch_status shaded_draw(struct technique_context *context, struct technique_instance *instance,
                              struct hatch_err *err) HATCH_MUST_USE;

#endif
