/* Strokes that were made for the needs of other views, on meshes on which no finer ones can be traced. */
#ifndef RENDER_MODE_NEEDS_STROKES_H
#define RENDER_MODE_NEEDS_STROKES_H

#include "needs/needs.h"
#include "render-gl/mode/job.h"

/* How many strokes an item has, and how many a pixel of it needs. Zeroed: as many as any view needs. */
struct needs_strokes {
    double tolerance;                 /* of the needs; 0: there is nothing to compare */
    double most;                      /* strokes side by side in a unit of the scene's lengths at rest, at most, that
                                         look like what is wanted */
    double per_px[HATCH_NEEDS_TONES]; /* per part of the scale: strokes that are wanted side by side in a pixel */
};

/* Finds the strokes of all items that the technique of the job draws, in files that strokegen --needs made. Strokes
 * count as those do: as wide as they are without options. Exits with a message when memory does not suffice.
 *   items  out: one per item of the scene */
void needs_strokes_find(struct job *job, struct needs_strokes *items);

#endif
