/* The ways to end a job: pictures into files, times and probes as text. */
#ifndef RENDER_MODE_MODES_H
#define RENDER_MODE_MODES_H

#include "render-gl/mode/job.h"

void pictures_write(struct job *job);
void timing_report(struct job *job);
void probe_report(struct job *job);

/* The bytes of a picture: EXR where the path ends so, else PNG. Dies when memory does not suffice. */
void pictures_encode(const char *path, const struct hatch_image *image, struct hatch_arena *scratch,
                     struct hatch_buffer *file);

#endif
