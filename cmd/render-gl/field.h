/* Directions to look at: short lines along _HATCH_DIR, spread evenly over the surfaces that have it. */
#ifndef RENDER_FIELD_H
#define RENDER_FIELD_H

#include "render-gl/scene.h"
#include "render-gl/target.h"
#include "scene/view.h"

/* A place on a surface and a way to go there, by the corners of a face, so that both move with it. */
struct field_mark {
    uint32_t face;
    float share[3];    /* of the corners: the place; their sum is 1 */
    float velocity[3]; /* of the corners: the direction; their sum is 0 */
    float confidence;
};

struct field {
    const struct gpu_scene *scene;
    uint32_t count;
    struct field_mark *marks; /* by item */
    uint32_t *item_end;       /* of each item's marks */
    double half_length;       /* in the unit scene */
    double *positions;        /* room for a surface's vertices */
    float *lines;             /* what is uploaded: FIELD_FLOATS for each mark */
    GLuint program, array, buffer;
};

#define FIELD_FLOATS 7u

/* Spreads marks over the posed scene, so far apart as suits a picture height_px high from the view.
 * HATCH_BAD_INPUT where no mesh has directions. scene is kept. */
enum hatch_status field_make(const struct gpu_scene *scene, const struct hatch_view *view, double height_px,
                             const struct shader_source *shaders, struct hatch_arena *arena,
                             struct hatch_arena *scratch, struct field *field, struct hatch_err *err) HATCH_MUST_USE;

/* Draws them as they lie in the scene's pose, in front of the surfaces in the target, whose uniform block
 * is bound. */
void field_draw(struct field *field, const struct target *target);

/* A zeroed struct is allowed. */
void field_free(struct field *field);

#endif
