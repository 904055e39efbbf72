#include "fit/lasting.h"

/* Returns whether a frame has a stroke. Ids must be asked for in ascending order.
 *   at  in, out: index of the first stroke that is not below the last id */
static bool has(const struct hatch_seen *frame, uint64_t id, size_t *at)
{
    if (!frame->known)
        return true;
    while (*at < frame->count && frame->ids[*at] < id)
        (*at)++;
    return *at < frame->count && frame->ids[*at] == id;
}

/* Returns whether the view jumps between two frames. */
static bool jumps(const struct hatch_seen *a, const struct hatch_seen *b)
{
    size_t shared = 0, at = 0;
    for (size_t i = 0; i < a->count; i++)
        shared += has(b, a->ids[i], &at);
    return 2 * shared <= (a->count < b->count ? a->count : b->count);
}

/* Copies frames up to those, before and after the middle, of which nothing is known.
 *   step  1 or -1: to those after or before */
static void copy_to_jump(const struct hatch_seen *frames, int step, struct hatch_seen *copies)
{
    const int middle = (int)HATCH_LASTING_AHEAD;
    for (int k = middle + step; k >= 0 && k < (int)HATCH_LASTING_SPAN; k += step)
        if (copies[k - step].known && frames[k].known && !jumps(&frames[k - step], &frames[k]))
            copies[k] = frames[k];
}

void hatch_lasting_find(const struct hatch_seen *all, bool *lasts)
{
    const struct hatch_seen *middle = &all[HATCH_LASTING_AHEAD];
    struct hatch_seen frames[HATCH_LASTING_SPAN] = {{.known = false}};
    size_t at[HATCH_LASTING_SPAN] = {0};
    frames[HATCH_LASTING_AHEAD] = *middle;
    copy_to_jump(all, 1, frames);
    copy_to_jump(all, -1, frames);
    for (size_t i = 0; i < middle->count; i++) {
        uint32_t row = 0, longest = 0; /* any frames in a row that are enough have the one in the middle among them */
        for (uint32_t k = 0; k < HATCH_LASTING_SPAN; k++) {
            row = has(&frames[k], middle->ids[i], &at[k]) ? row + 1 : 0;
            longest = row > longest ? row : longest;
        }
        lasts[i] = longest >= HATCH_LASTING;
    }
}
