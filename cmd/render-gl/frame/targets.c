#include "render-gl/frame/targets.h"

#include <string.h>

void frame_targets_begin(struct frame_targets *targets)
{
    for (uint32_t i = 0; i < FRAME_TARGETS_MAX; i++) {
        targets->entries[i].frames_spare = targets->entries[i].taken ? 0 : targets->entries[i].frames_spare + 1;
        targets->entries[i].taken = false;
        if (targets->entries[i].frames_spare >= 2)
            gpu_target_free(&targets->entries[i].target);
    }
}

enum hatch_status frame_target(struct frame_targets *targets, const struct gpu_target_form *form,
                               const struct gpu_target **target, struct hatch_err *err)
{
    uint32_t chosen = FRAME_TARGETS_MAX;
    for (uint32_t i = FRAME_TARGETS_MAX; i-- > 0;) {
        const struct gpu_target *made = &targets->entries[i].target;
        bool fits = made->framebuffer && memcmp(&made->form, form, sizeof *form) == 0;
        bool better = fits || chosen == FRAME_TARGETS_MAX || !targets->entries[chosen].target.framebuffer;
        if (!targets->entries[i].taken && (fits || !made->framebuffer) && better)
            chosen = i;
    }
    if (chosen == FRAME_TARGETS_MAX)
        return hatch_fail(err, HATCH_LIMIT, "a frame needs more than %u transient targets", FRAME_TARGETS_MAX);
    if (!targets->entries[chosen].target.framebuffer)
        HATCH_TRY(gpu_target_make(form, &targets->entries[chosen].target, err));
    targets->entries[chosen].taken = true;
    *target = &targets->entries[chosen].target;
    return HATCH_OK;
}

void frame_target_release(struct frame_targets *targets, const struct gpu_target *target)
{
    for (uint32_t i = 0; i < FRAME_TARGETS_MAX; i++)
        if (target == &targets->entries[i].target) {
            targets->entries[i].taken = false;
            targets->entries[i].frames_spare = 0;
        }
}

void frame_targets_free(struct frame_targets *targets)
{
    for (uint32_t i = 0; i < FRAME_TARGETS_MAX; i++)
        gpu_target_free(&targets->entries[i].target);
}
