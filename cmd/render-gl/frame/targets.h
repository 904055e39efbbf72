/* Transient render targets: their content lasts until the frame ends, and later frames use them again. */
#ifndef RENDER_FRAME_TARGETS_H
#define RENDER_FRAME_TARGETS_H

#include "render-gl/gpu/target.h"

#define FRAME_TARGETS_MAX 16u

struct frame_targets {
    struct {
        struct gpu_target target;
        bool taken;            /* this frame uses it */
        uint32_t frames_spare; /* number of frames since its last use */
    } entries[FRAME_TARGETS_MAX];
};

/* Makes all targets available again, and frees those that the last two frames have not used. */
void frame_targets_begin(struct frame_targets *targets);

/* Supplies a target for use until the next frame_targets_begin. Its content is undefined.
 *   form    size and formats of the target
 *   target  out: owned by targets
 * HATCH_LIMIT when the GPU has no memory for it, or FRAME_TARGETS_MAX are in use. */
enum hatch_status frame_target(struct frame_targets *targets, const struct gpu_target_form *form,
                               const struct gpu_target **target, struct hatch_err *err) HATCH_MUST_USE;

/* Makes a target available again before the frame ends. NULL: nothing is done. */
void frame_target_release(struct frame_targets *targets, const struct gpu_target *target);

void frame_targets_free(struct frame_targets *targets);

#endif
