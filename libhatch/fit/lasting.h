/* Strokes of a film that last. A stroke that comes into sight for a frame or two, where an end of it shows at a rim or
 * between others, flickers. Nothing in such a frame tells it from a stroke that is about to come out: which ones last
 * is seen in the frames before and after (docs/notes/strokes.md). */
#ifndef HATCH_FIT_LASTING_H
#define HATCH_FIT_LASTING_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define HATCH_LASTING 3u                                 /* frames in a row in which a stroke that lasts is in sight */
#define HATCH_LASTING_AHEAD (HATCH_LASTING - 1)          /* frames after one that decide about its strokes */
#define HATCH_LASTING_SPAN (2 * HATCH_LASTING_AHEAD + 1) /* frames before, itself and after */

/* The strokes in sight in a frame. */
struct hatch_seen {
    bool known; /* false: there is no such frame, or nothing is known of it; all strokes count as in sight */
    size_t count;
    const uint64_t *ids; /* in ascending order, each once */
};

/* Finds the strokes of a frame that are in sight for HATCH_LASTING frames in a row, this one among them. If two frames
 * have no more than half of the strokes of the smaller one in common, the view has jumped: of the frames on the other
 * side nothing is known then.
 *   all    HATCH_LASTING_SPAN of them, one after another; the one in the middle is known
 *   lasts  out: an entry for each stroke of the frame in the middle */
void hatch_lasting_find(const struct hatch_seen *all, bool *lasts);

#endif
