/* Transient targets: their content lasts until the frame ends, and frames of one size share them. */
#ifndef RENDER_FRAME_TARGETS_H
#define RENDER_FRAME_TARGETS_H

#include "render-gl/gpu/target.h"

#define FRAME_TARGETS_MAX 16u

struct frame_targets {
    struct {
        struct gpu_target target;
        bool taken;            /* in this frame */
        uint32_t frames_spare; /* number of frames since its last use */
    } entries[FRAME_TARGETS_MAX];
};

/* Makes all targets available again, and frees those that the last two frames have not used. */
void frame_targets_begin(struct frame_targets *targets);

/* Returns a target of a size and formats for use until the next frame_targets_begin. Its content is undefined.
 *   target  out: owned by targets
 * HATCH_LIMIT when the GPU has no memory for it, or FRAME_TARGETS_MAX are in use. */
enum hatch_status frame_target(struct frame_targets *targets, const struct gpu_target_form *form,
                               const struct gpu_target **target, struct hatch_err *err) HATCH_MUST_USE;

void frame_targets_free(struct frame_targets *targets);

#endif
