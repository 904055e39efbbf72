/* What of a scene is so near the eye that floats cannot place it: those faces are cut into pieces on the
 * processor, in pairs of doubles, and floats carry what is left (near/pieces.h). Around them lies a ring of
 * faces that are drawn both ways, so that nothing gapes between the two ways of rounding. */
#ifndef RENDER_NEAR_H
#define RENDER_NEAR_H

#include "render-gl/scene.h"
#include "scene/view.h"

#define NEAR_PIXELS 0.02 /* by how much floats may be off, in pixels of the picture */

/* Where pieces' corners find what their face's corners hold, among texture units and uniforms: the same as
 * in shaders/pieces.glsl. */
#define NEAR_UNIT 10u /* vertices; then spans, repeats */
#define NEAR_UNIFORM_LENS 20
#define NEAR_UNIFORM_HAS 21

/* How faces are drawn: ranges of the index buffer, and pieces. */
struct near_cut {
    bool is_cut; /* else all faces are drawn as usual */
    uint32_t range_count;
    GLsizei *counts;
    const void **offsets;
    GLint first; /* of the pieces' corners */
    GLsizei count;
};

struct near_item {
    struct near_cut surface, patches; /* patches: where the item has some */
};

struct near_shape;

struct near {
    bool is_open;
    struct hatch_arena kept, posed, frame;
    uint32_t pose_number, frame_number;
    struct near_shape *shapes; /* per item */
    struct near_item *items;   /* of this frame; NULL: nothing is near */
    GLuint array, buffer, views[3];
    float lens[16];
    double plane; /* where the last frame's near plane was */
};

/* What is wanted of a frame. */
struct near_wish {
    bool pieces;     /* else only the near plane is looked for */
    double hatch[2]; /* how texture coordinates are turned and scaled: cosine and sine */
    const struct hatch_tile *tile;
};

/* Finds what is near, cuts it and uploads the pieces; moves the view's near plane, where it is nobody's
 * wish, before what is nearest. */
enum hatch_status near_begin(struct near *near, const struct gpu_scene *scene, const struct near_wish *wish,
                             struct hatch_view *view, uint64_t max_memory, struct hatch_err *err) HATCH_MUST_USE;

/* What the item's cut is, or NULL when it has none in this frame. */
const struct near_item *near_find(const struct near *near, uint32_t item);

/* Binds what the item's pieces are drawn with; the program is in use. */
void near_use(const struct near *near, const struct gpu_scene *scene, const struct gpu_item *item);

void near_free(struct near *near);

#endif
