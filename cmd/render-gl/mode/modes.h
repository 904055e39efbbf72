/* The command's work on a prepared job: write pictures, report times, report a probe. The functions exit with a
 * message on failure. */
#ifndef RENDER_MODE_MODES_H
#define RENDER_MODE_MODES_H

#include "render-gl/mode/job.h"

void pictures_write(struct job *job);
void timing_report(struct job *job); /* --time */
void probe_report(struct job *job);  /* --probe */

/* Encodes a picture: as OpenEXR if the path ends in .exr, else as PNG.
 *   path  NULL: PNG
 *   file  out: empty before */
void pictures_encode(const char *path, const struct hatch_image *image, struct hatch_arena *scratch,
                     struct hatch_buffer *file);

#endif
