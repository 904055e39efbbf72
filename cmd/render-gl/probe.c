/* What the picture uses of scene and map, as TSV or JSON. */
#include <math.h>

#include "shared/report.h"
#include "render-gl/job.h"
#include "render-gl/picture.h"

#define LEVELS_MAX 32

struct probe {
    uint64_t pixels, drawn;
    uint64_t tones[HATCH_TAM_TONES_MAX]; /* pixels in which a column of the map has a weight */
    uint64_t bare;                       /* pixels of the scene that ask for no ink */
    uint64_t levels[LEVELS_MAX];         /* pixels that read a level */
    uint64_t magnified;                  /* pixels finer than the finest level */
};

/* Marks the columns whose blend makes an amount of ink. */
static void count_tones(const struct hatch_tam *map, float amount, uint64_t *tones)
{
    uint32_t above = 0;
    while (above < map->tones - 1 && map->target[above] < amount)
        above++;
    float below = above ? map->target[above - 1] : 0.0f;
    if (amount > below)
        tones[above]++;
    if (above && amount < map->target[above])
        tones[above - 1]++;
}

static void count_pixel(const struct hatch_tam *map, const float rgba[4], struct probe *probe)
{
    if (rgba[3] < 0.5f || rgba[2] < -LEVELS_MAX)
        return;
    probe->drawn++;
    probe->bare += rgba[0] <= 0.0f && rgba[1] <= 0.0f;
    for (int ink = 0; ink < 2; ink++)
        if (rgba[ink] > 0.0f)
            count_tones(map, rgba[ink], probe->tones);
    uint32_t last = map->columns[0].level_count - 1;
    float level = fminf(fmaxf(rgba[2], 0.0f), (float)last);
    uint32_t fine = (uint32_t)level;
    probe->levels[fine]++;
    if (level > (float)fine)
        probe->levels[fine + 1]++;
    probe->magnified += rgba[2] < -0.5f;
}

static void measure(struct job *job, struct probe *probe)
{
    struct hatch_arena *scratch = &job->args.scratch;
    static const float nothing[3] = {0, 0, 0};
    struct hatch_err err;
    struct target target;
    struct hatch_view view;
    cmd_check(renderer_prepare(&job->renderer, TECHNIQUE_PROBE, scratch, &err), NULL, &err);
    job_make_target(job, &target);
    size_t count = (size_t)target.side * target.side * target.width * target.height;
    float *rgba = HATCH_NEW(scratch, float, 4 * count, &err);
    cmd_check(rgba ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    for (uint32_t frame = 0; frame < job->options.frames; frame++) {
        struct hatch_tile tile = {0, 0, target.width, target.height, job->options.width, job->options.height};
        job_set_frame(job, frame, &view);
        cmd_check(renderer_draw_over(&job->renderer, TECHNIQUE_PROBE, nothing, &view, &tile, &target, &err), NULL,
                  &err);
        target_read_samples(&target, rgba);
        for (size_t i = 0; i < count; i++)
            count_pixel(&job->map, rgba + 4 * i, probe);
        probe->pixels += count;
    }
    target_free(&target);
}

static void report_row(struct cmd_report *report, const char *thing, uint32_t index, double value, const char *unit)
{
    cmd_report_text(report, thing);
    cmd_report_integer(report, index);
    if (value == floor(value))
        cmd_report_integer(report, (uint64_t)value); /* all digits of a number of texels */
    else
        cmd_report_number(report, value);
    cmd_report_text(report, unit);
}

static void report_map(struct cmd_report *report, const struct hatch_tam *map, const struct probe *probe)
{
    double drawn = probe->drawn ? (double)probe->drawn : 1.0, used = 0, whole = 0;
    uint32_t tones = 0;
    for (uint32_t i = 0; i < map->tones; i++) {
        tones += probe->tones[i] > 0;
        report_row(report, "tone", i, (double)probe->tones[i] / drawn, "of the scene's pixels");
    }
    for (uint32_t i = 0; i < map->columns[0].level_count; i++) {
        double size = hatch_mip_size(map->size_px, i);
        whole += size * size * map->tones;
        used += probe->levels[i] ? size * size * tones : 0;
        report_row(report, "level", i, (double)probe->levels[i] / drawn, "of the scene's pixels");
    }
    report_row(report, "bare", 0, (double)probe->bare / drawn, "of the scene's pixels");
    report_row(report, "magnified", 0, (double)probe->magnified / drawn, "of the scene's pixels");
    report_row(report, "used", 0, used, "texels");
    report_row(report, "map", 0, whole, "texels");
}

static void report_all(struct cmd_report *report, const struct job *job, const struct probe *probe)
{
    const struct gpu_scene *gpu = &job->gpu;
    double faces = 0, patches = 0, patch_faces = 0;
    for (uint32_t i = 0; i < gpu->item_count; i++) {
        const struct gpu_mesh *mesh = &gpu->meshes[gpu->items[i].mesh];
        faces += mesh->surface->face_count;
        patches += mesh->patches ? mesh->patches->patch_count : 0;
        patch_faces += mesh->patches ? mesh->index_count / 3 : 0;
    }
    report_row(report, "items", 0, gpu->item_count, "");
    report_row(report, "faces", 0, faces, "");
    report_row(report, "patches", 0, patches, "");
    report_row(report, "patch-faces", 0, patch_faces, "");
    report_row(report, "lights", 0, job->renderer.block.counts[0], "");
    report_row(report, "drawn", 0, (double)probe->drawn / (double)probe->pixels, "of the picture's pixels");
    report_map(report, &job->map, probe);
    for (uint32_t i = 0; i < gpu->item_count; i++) {
        report_row(report, "charts", i, gpu->items[i].chart_count, "");
        report_row(report, "repeat-u", i, (double)gpu->items[i].repeat[0], "tiles");
        report_row(report, "repeat-v", i, (double)gpu->items[i].repeat[1], "tiles");
    }
}

void probe_report(struct job *job)
{
    static const char *const columns[] = {"thing", "index", "value", "unit", NULL};
    struct cmd_report report;
    struct hatch_err err;
    struct probe *probe = HATCH_NEW(&job->args.keep, struct probe, 1, &err);
    cmd_check(probe ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    measure(job, probe);
    cmd_report_begin(&report, &job->args, columns);
    report_all(&report, job, probe);
    cmd_report_write(&report, job->outputs[0]);
}
