/* The technique strokes: the strokes of a texture are found in the picture, fitted with curves and drawn anew (Szécsi,
 * Szirányi & Kacsó, "Tonal Art Maps with Image Space Strokes"). Included by the technique's own files. */
#ifndef RENDER_TECHNIQUE_STROKES_H
#define RENDER_TECHNIQUE_STROKES_H

#include "render-gl/technique/rptam.h"
#include "render-gl/technique/technique.h"

/* A buffer that grows. Zeroed: none. */
struct strokes_buffer {
    GLuint name;
    size_t size_bytes;
};

/* A stroke and the range of its fragments, as shaders/strokes/route.comp has it. In the table of strokes, an id of 0
 * marks a free slot. */
struct strokes_slot {
    uint32_t id[2]; /* of [0], bit 0 is the index of the ink, and the six bits above are the layer */
    uint32_t count, first;
    uint32_t joined; /* bits STROKES_JOINED_..., of parts of a divided stroke */
};
#define STROKES_JOINED_START 4u /* it goes on before its start, after its end */
#define STROKES_JOINED_END 8u

/* std430: the head of the buffer of fragments, which are 4 words each. */
struct strokes_fragments_head {
    uint32_t count, unused[3];
};

struct strokes_state {
    struct rptam_state seeds;   /* first: functions of the technique rptam find it there */
    struct frame_shader paper;  /* programs that draw bare paper */
    struct frame_shader map;    /* programs that gather the strokes of a map */
    struct frame_shader owners; /* programs that draw which patch lies on top */
    const struct gpu_program *route, *sort, *fit, *ribbon;
    struct strokes_buffer fragments, table, sorted, found, missed, points, indices;
    uint32_t found_count; /* strokes of the last frame, in the buffer `found` */
    size_t capacity;      /* fragments that the buffer holds */
    uint32_t slot_count;  /* of the table, a power of two */
    uint32_t most;        /* strokes that are drawn */
    double width_px;      /* nominal width of the frame's strokes */
    bool warned;          /* that there are more */
    GLuint points_view;   /* texture through which the points are read */
    GLuint array, block_buffer;
    bool has_brush;  /* the ribbons have the image of a brush */
    GLuint brush[2]; /* textures: its alpha, its grain */
};

/* A fragment in the buffer `sorted`: as shaders/strokes/fragments.glsl has it, without the id. */
#define STROKES_FRAGMENT_BYTES (2 * sizeof(uint32_t))

/* The strokes of a frame, ordered by strokes_compare. */
struct strokes_list {
    struct strokes_slot *strokes; /* in the scratch arena */
    uint32_t count;
    uint32_t fragments; /* of all strokes together */
};

/* Orders strokes by ink, layer and id. */
int strokes_compare(const void *a, const void *b);

/* Draws the surfaces as bare paper. */
extern const struct frame_shading strokes_paper;

/* Nominal size in pixels and darkness of a stroke, of which widths are multiples. */
struct strokes_look {
    float width_px, ink;
};

/* Compiles what gathers strokes, and uploads what they come from: the asset if there is one, or else seed points. */
enum hatch_status strokes_prepare_source(struct technique_context *context, struct technique_instance *instance,
                                         struct hatch_err *err) HATCH_MUST_USE;

/* Gathers the fragments of the items that a target's depth lets through. */
enum hatch_status strokes_draw_source(struct technique_context *context, struct technique_instance *instance,
                                      const struct gpu_target *target, struct hatch_err *err) HATCH_MUST_USE;

struct strokes_look strokes_look(const struct technique_instance *instance);

/* Finds the fragments of the frame and the strokes that they belong to, and puts the fragments of each side by side in
 * the buffer `sorted`. */
enum hatch_status strokes_gather(struct technique_context *context, struct technique_instance *instance,
                                 struct strokes_list *list, struct hatch_err *err) HATCH_MUST_USE;

/* Fits the strokes and computes the points of their ribbons. Strokes that no cubic follows are divided.
 *   list  in, out: with the parts of divided strokes */
enum hatch_status strokes_fit(const struct frame *frame, struct strokes_state *state, struct strokes_list *list,
                              struct hatch_arena *scratch, struct hatch_err *err) HATCH_MUST_USE;

/* A pen draws a stroke where it is this wide, in its mean widths. */
#define STROKES_THIN 0.3

/* Finds the strokes of the frame and computes their ribbons.
 *   pen_px  width of a pen that draws all strokes alike; 0: strokes as the options say
 *   list    out: in the scratch arena */
enum hatch_status strokes_find(struct technique_context *context, struct technique_instance *instance, double pen_px,
                               struct strokes_list *list, struct hatch_err *err) HATCH_MUST_USE;

/* Finds the strokes of a frame as paths: the function `curves` of the technique. */
enum hatch_status strokes_curves(struct technique_context *context, struct technique_instance *instance, double pen_px,
                                 struct hatch_arena *arena, struct technique_curves *curves,
                                 struct hatch_err *err) HATCH_MUST_USE;

/* Uploads the brush of the drawing style if it has an image. Repeated calls do nothing. */
void strokes_take_brush(struct strokes_state *state);

/* Sets the uniforms and textures of the brush, and returns its mean ink.
 *   even  all strokes are alike, as a pen draws them */
double strokes_use_brush(const struct strokes_state *state, bool even);

/* Makes a buffer at least as large as wanted; its content is lost if it grows. */
void strokes_reserve(struct strokes_buffer *buffer, size_t size_bytes);

#endif
