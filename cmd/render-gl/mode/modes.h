/* The modes of the command that need no window: writing pictures, writing drawings, --time, --probe and --needs. Each
 * function works on a prepared job and exits with a message on failure. */
#ifndef RENDER_MODE_MODES_H
#define RENDER_MODE_MODES_H

#include "render-gl/mode/job.h"

void pictures_write(struct job *job);
void vectors_write(struct job *job); /* -o NAME.svg or NAME.tsv; without the GPU, unless the technique has curves */
void timing_report(struct job *job); /* --time */
void probe_report(struct job *job);  /* --probe */
void needs_report(struct job *job);  /* --needs */

#define TIMES_KINDS 3 /* gpu_ms, wall_ms, cpu_ms */

/* Times of pictures, for --times. */
struct picture_times {
    double *ms; /* per frame TIMES_KINDS, in the order of the columns */
    struct gpu_timer timer;
};

/* Begins the times of all frames. */
void times_begin(struct job *job, struct picture_times *times);

/* Draws the picture of a frame again, `draws` times, and notes the shortest times.
 *   image  in, out: the picture */
void times_add(struct job *job, const struct picture *picture, const struct hatch_view *view,
               const struct canvas *canvas, uint32_t frame, struct hatch_image *image, struct picture_times *times);

/* Returns the file with the table, which is written with the pictures. */
struct cmd_file times_end(struct job *job, struct picture_times *times);

/* Exit with a message if the map was made for needs (needs(5)): the first one if the mode is a window, which shows any
 * view, the second one if a view of the job exceeds these needs. The job need not be prepared for the first. */
void needs_check_mode(const struct job *job);
void needs_check(struct job *job);

/* Encodes a picture: as OpenEXR if the path ends in .exr, else as PNG.
 *   path  NULL: standard output, as PNG
 *   file  in: empty; out: the encoded picture */
void pictures_encode(const char *path, const struct hatch_image *image, struct hatch_arena *scratch,
                     struct hatch_buffer *file);

#endif
