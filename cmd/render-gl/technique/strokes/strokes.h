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
};

/* std430: the head of the buffer of fragments, which are 4 words each. */
struct strokes_fragments_head {
    uint32_t count, unused[3];
};

struct strokes_state {
    struct rptam_state seeds;  /* first: functions of the technique rptam find it there */
    struct frame_shader paper; /* programs that draw bare paper */
    const struct gpu_program *route, *sort, *fit, *ribbon;
    struct strokes_buffer fragments, table, sorted, found, points, indices;
    size_t capacity;     /* fragments that the buffer holds */
    uint32_t slot_count; /* of the table, a power of two */
    GLuint points_view;  /* texture through which the points are read */
    GLuint array, block_buffer;
    uint32_t counts[2]; /* strokes of the frame, by ink */
};

/* Draws the surfaces as bare paper. */
extern const struct frame_shading strokes_paper;

/* Finds the fragments of the frame and the strokes that they belong to: the slots of `found`, sorted by ink, layer and
 * id, and the fragments of each side by side. */
enum hatch_status strokes_gather(struct technique_context *context, struct technique_instance *instance,
                                 struct hatch_err *err) HATCH_MUST_USE;

/* Fits the strokes and computes the points of their ribbons. */
enum hatch_status strokes_fit(const struct frame *frame, struct strokes_state *state,
                              struct hatch_err *err) HATCH_MUST_USE;

/* Makes a buffer at least as large as wanted; its content is lost if it grows. */
void strokes_reserve(struct strokes_buffer *buffer, size_t size_bytes);

#endif
