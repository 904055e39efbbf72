/* Feature lines: silhouettes, creases and boundaries, over the picture of any technique. */
#ifndef RENDER_LINES_H
#define RENDER_LINES_H

#include "render-gl/lines/gl.h"
#include "render-gl/scene.h"

struct line_style {
    uint32_t kinds; /* enum hatch_line_kind, joined; HATCH_LINES_NONE: nothing is drawn */
    bool haloes;    /* lines end where the haloes of what is nearer begin */
    bool asked;     /* by name; else only techniques of strokes have lines */
    double width_px;
    double crease_rad; /* edges that turn by more are creases */
    float color[3];    /* linear light */
};

struct lines {
    struct line_style style;
    struct gpu_scene *scene;
    struct hatch_arena frame; /* the lines of a frame */
    struct hatch_arena *scratch;
    struct hatch_line_mesh *meshes; /* of each of the scene's meshes two: as it is, and for a skin */
    struct line_gl gl;
};

/* Extracts what does not change with view and pose, and compiles. max_memory: bytes for a frame's
 * lines. arena holds the meshes' lines; scratch and scene are kept. */
enum hatch_status lines_make(struct gpu_scene *scene, const struct line_style *style,
                             const struct shader_source *shaders, uint64_t max_memory, struct hatch_arena *arena,
                             struct hatch_arena *scratch, struct lines *lines, struct hatch_err *err) HATCH_MUST_USE;

/* Draws the lines of the posed scene over the target's resolved picture. The target's depth holds the
 * surfaces that hide them. HATCH_LIMIT when memory does not suffice. */
enum hatch_status lines_draw(struct lines *lines, const struct hatch_view *view, const struct hatch_tile *tile,
                             const struct target *target, struct hatch_err *err) HATCH_MUST_USE;

/* A zeroed struct is allowed. */
void lines_free(struct lines *lines);

#endif
