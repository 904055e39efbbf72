/* The regions of the scene at rest that views show. */
#ifndef RENDER_MODE_NEEDS_REGIONS_H
#define RENDER_MODE_NEEDS_REGIONS_H

#include "needs/regions.h"
#include "render-gl/mode/needs/measure.h"

/* Finds the regions of the faces that were seen, except for those of backdrops.
 *   regions  out: its cells are in job->args.keep */
void needs_find_regions(struct job *job, const struct needs_measure *measure, struct hatch_needs_regions *regions);

#endif
