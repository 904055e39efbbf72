/* The functions of techniques that draw every item with one struct frame_shading and need nothing else. */
#ifndef RENDER_TECHNIQUE_SHADED_H
#define RENDER_TECHNIQUE_SHADED_H

#include "render-gl/technique/technique.h"

#define SHADED_DEFINES_BYTES 256u

/* The state of such a technique, or the first member of its state. */
struct shaded_state {
    struct frame_shader shader;
    char defines[SHADED_DEFINES_BYTES]; /* lines with which the shader was compiled, beside the shading's */
};

/* Compiles the programs for the scene's items: struct technique's prepare. */
enum hatch_status shaded_prepare(struct technique_context *context, struct technique_instance *instance,
                                 struct hatch_err *err) HATCH_MUST_USE;

/* Does the same with additional definitions, which may differ from call to call.
 *   defines  lines before every stage */
enum hatch_status shaded_prepare_with(struct technique_context *context, struct technique_instance *instance,
                                      const char *defines, struct hatch_err *err) HATCH_MUST_USE;

/* Draws every item: struct technique's draw. */
enum hatch_status shaded_draw(struct technique_context *context, struct technique_instance *instance,
                              struct hatch_err *err) HATCH_MUST_USE;

#endif
