#include "io/png/png.h"
#include "job.h"
#include "stroke/script.h"

#define SHEET_COLUMNS_MAX 12u

struct outputs open_outputs(const struct job *job)
{
    return (struct outputs){cmd_open_output(job->args.output, "exr", true),
                            job->strokes_path ? cmd_open_output(job->strokes_path, "tsv txt", false) : NULL,
                            job->sheet_path ? cmd_open_output(job->sheet_path, "png", true) : NULL};
}

void begin_columns(struct job *job)
{
    struct hatch_err err;
    job->columns = (struct columns){.arena = &job->args.keep,
                                    .pool = cmd_pool(&job->args),
                                    .tones = job->tones,
                                    .levels = job->levels,
                                    .tolerance = (double)job->tolerance,
                                    .sheet = job->sheet_path ? &job->sheet : NULL};
    if (job->tolerance > 0)
        cmd_note("reflectance is rounded: means over 8 x 8 pixels change by about %.2g, root mean square",
                 (double)job->tolerance / 2);
    uint32_t shown = job->tones < SHEET_COLUMNS_MAX ? job->tones : SHEET_COLUMNS_MAX;
    const struct hatch_tam_sheet_options sheet = {job->size_px, job->levels, job->tones, shown, job->color};
    if (job->sheet_path)
        cmd_check(hatch_tam_sheet_make(&sheet, &job->args.keep, &job->sheet, &err), job->sheet_path, &err);
}

void write_outputs(struct job *job, const struct outputs *outputs)
{
    struct hatch_err err;
    struct hatch_bytes pieces[HATCH_TAM_TONES_MAX];
    struct hatch_buffer map = {.arena = &job->args.keep}, script = map, picture = map;
    cmd_check(columns_finish(&job->columns, &map, pieces, &err), job->args.output, &err);
    if (job->strokes_path)
        cmd_check(hatch_script_print(job->strokes.items, job->strokes.count, job->size_px, NULL, &script, &err),
                  job->strokes_path, &err);
    if (job->sheet_path)
        cmd_check(hatch_png_write(&job->sheet.picture, HATCH_PNG_SRGB, 8, NULL, &job->args.scratch, &picture, &err),
                  job->sheet_path, &err);
    struct cmd_file files[3] = {{outputs->map, map.data, map.size, pieces, job->tones}};
    size_t count = 1;
    if (job->strokes_path)
        files[count++] = (struct cmd_file){.output = outputs->strokes, .data = script.data, .size = script.size};
    if (job->sheet_path)
        files[count++] = (struct cmd_file){.output = outputs->sheet, .data = picture.data, .size = picture.size};
    cmd_write_all(files, count);
    hatch_exr_abandon(job->columns.writer);
}
