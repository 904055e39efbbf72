/* Draws frames and writes them as PNG or EXR files. */
#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "io/exr/exr.h"
#include "io/png/png.h"
#include "render-gl/mode/modes.h"
#include "render-gl/mode/parse_args.h"

#define BLANK_TOLERANCE 1e-3f /* linear light; a blank picture has rounding errors */

void pictures_encode(const char *path, const struct hatch_image *image, struct hatch_arena *scratch,
                     struct hatch_buffer *file)
{
    struct hatch_image level = *image;
    const struct hatch_mipmap part = {.name = "picture", .level_count = 1, .levels = &level};
    struct hatch_err err;
    cmd_check(parse_has_ending(path, "exr") ? hatch_exr_write(&part, scratch, file, &err)
                                            : hatch_png_write(image, HATCH_PNG_SRGB, 8, NULL, scratch, file, &err),
              path, &err);
}

/* Returns whether all pixels have the colour of the paper.
 *   image  RGB */
static bool is_blank(const struct hatch_image *image, const float paper[3])
{
    size_t count = (size_t)image->width * image->height;
    for (size_t i = 0; i < 3 * count; i++)
        if (fabsf(image->pixels[i] - paper[i % 3]) > BLANK_TOLERANCE)
            return false;
    return true;
}

static void warn_of_blank(const struct job *job, uint32_t blank)
{
    const char *name = cmd_input_name(job->options->scene_path);
    static const char reason[] = "nothing is in sight, or nothing is dark enough for a stroke";
    if (blank && job->options->frames == 1)
        cmd_warn(name, "the picture is blank: %s", reason);
    else if (blank)
        cmd_warn(name, "%u of %u pictures %s blank: %s", blank, job->options->frames, cmd_plural(blank, "is", "are"),
                 reason);
}

/* Notes how many strokes a picture has, and adds them up.
 *   instance  of a technique that counts strokes, or of another */
static void note_counts(struct technique_instance *instance, struct technique_counts *all)
{
    if (!instance->technique->count)
        return;
    const struct technique_counts counts = instance->technique->count(instance);
    cmd_note("%" PRIu64 " strokes, %" PRIu64 " fragments, %" PRIu64 " waited", counts.strokes, counts.fragments,
             counts.waited);
    all->strokes += counts.strokes;
    all->fragments += counts.fragments;
    all->waited += counts.waited;
}

static void note_film(const struct options *options, const struct technique_counts *all)
{
    if (options->technique->count && options->frames > 1)
        cmd_note("%" PRIu64 " strokes, %" PRIu64 " fragments, %" PRIu64 " waited in all %u pictures", all->strokes,
                 all->fragments, all->waited, options->frames);
}

/* The picture of a frame that is foreseen, and its canvas. */
struct film {
    struct picture picture;
    const struct canvas *canvas;
    const struct options *options;
};

static enum hatch_status foresee(void *data, uint32_t film, const struct hatch_view *view, struct hatch_err *err)
{
    struct film *frames = data;
    frames->picture.film = film;
    return picture_foresee(&frames->picture, view, frames->canvas, frames->options->width, frames->options->height,
                           err);
}

void pictures_write(struct job *job)
{
    const struct options *options = job->options;
    struct hatch_arena *keep = &job->args.keep, *scratch = &job->args.scratch;
    struct hatch_image image;
    struct canvas canvas;
    struct hatch_err err;
    struct picture_times times;
    uint32_t file_count = options->frames;
    struct cmd_file *files = HATCH_NEW(keep, struct cmd_file, file_count + 1, &err); /* the last: of --times */
    cmd_check(files ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    cmd_check(hatch_image_make(keep, options->width, options->height, "RGB", &image, &err), NULL, &err);
    job_make_canvas(job, &canvas);
    const struct picture picture = job_picture(job, job_open(job, options->technique, &err));
    struct film film = {.picture = picture, .canvas = &canvas, .options = options};
    struct technique_counts all = {.strokes = 0};
    uint32_t blank = 0;
    if (job->times_output)
        times_begin(job, &times);
    for (uint32_t frame = 0; frame < options->frames; frame++) {
        struct hatch_view view;
        cmd_progress("drawing", (double)frame / options->frames);
        film.picture.film = job_set_film_frame(job, frame, foresee, &film, &view);
        cmd_check(picture_draw(&film.picture, &view, &canvas, &image, &err), NULL, &err);
        note_counts(picture.instance, &all);
        blank += !job->empty && is_blank(&image, job->frame.style.inks.paper);
        struct hatch_arena_mark mark = hatch_arena_mark(keep);
        struct hatch_buffer bytes = {.arena = keep};
        pictures_encode(job->args.output, &image, scratch, &bytes);
        files[frame] = (struct cmd_file){.output = job->outputs[frame], .data = bytes.data, .size = bytes.size};
        if (cmd_write_ahead(&files[frame])) { /* memory would not hold thousands of frames */
            files[frame] = (struct cmd_file){.output = job->outputs[frame]};
            hatch_arena_rewind(keep, mark);
        }
        if (job->times_output)
            times_add(job, &picture, &view, &canvas, frame, &image, &times);
    }
    if (job->changes)
        cmd_note("the technique's options were changed and applied %u times, %.2f ms each", job->changes,
                 job->changes_ms / job->changes);
    note_film(options, &all);
    warn_of_blank(job, blank);
    if (job->times_output)
        files[file_count++] = times_end(job, &times);
    cmd_write_all(files, file_count);
    canvas_free(&canvas);
}
