/* --probe: reports which tones and mip levels of the map a picture uses, and how many faces, patches and so on the
 * scene has, as TSV or JSON. */
#include <math.h>

#include "render-gl/mode/modes.h"
#include "shared/report.h"

#define LEVELS_MAX 32

/* Numbers of samples of the picture. */
struct probe {
    uint64_t pixels;                     /* all samples */
    uint64_t drawn;                      /* samples that show the scene */
    uint64_t tones[HATCH_TAM_TONES_MAX]; /* per column of the map: samples that read it */
    uint64_t bare;                       /* samples that show the scene with tone 0 */
    uint64_t levels[LEVELS_MAX];         /* per mip level: samples that read it */
    uint64_t magnified;                  /* samples that need a level finer by more than 0.5 than the finest */
};

/* Counts a sample for the one or two columns that are blended to its tone. */
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

/* Counts all samples of the pixels of a rectangle, which begins at the lower left corner of the canvas. */
static void count_tile(const struct job *job, const struct canvas *canvas, const float *rgba, uint32_t width,
                       uint32_t height, struct probe *probe)
{
    const uint32_t side = canvas->side;
    for (uint32_t y = 0; y < side * height; y++)
        for (uint32_t x = 0; x < side * width; x++)
            count_pixel(&job->asset.map, rgba + 4 * ((size_t)side * canvas->width * y + x), probe);
    probe->pixels += (uint64_t)side * side * width * height;
}

/* A technique that writes tones and mip levels instead of colours. */
static const struct technique probe_technique = {
    .name = "probe",
    .asset = &asset_six_columns,
    .features = TECHNIQUE_STROKES | TECHNIQUE_NO_COLOR,
    .shading = {.stages = {.vertex = "probe/probe.vert", .fragment = "probe/probe.frag"},
                .patches = FRAME_PATCHES_COVER,
                .passes = {{.name = "probe", .depth = FRAME_DEPTH_NEARER}}},
};

static void measure(struct job *job, struct probe *probe)
{
    static const float nothing[3] = {0, 0, 0};
    struct hatch_err err;
    struct canvas canvas;
    struct hatch_view view;
    struct technique_instance *instance = job_use(job, &probe_technique);
    job_make_canvas(job, &canvas);
    const struct options *options = job->options;
    size_t count = (size_t)canvas.side * canvas.side * canvas.width * canvas.height;
    float *rgba = HATCH_NEW(&job->args.scratch, float, 4 * count, &err);
    cmd_check(rgba ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    for (uint32_t frame = 0; frame < options->frames; frame++) {
        job_set_frame(job, frame, &view);
        for (uint32_t y = 0; y < options->height; y += canvas.height)
            for (uint32_t x = 0; x < options->width; x += canvas.width) {
                const struct hatch_tile tile = {x, y, canvas.width, canvas.height, options->width, options->height};
                const struct frame_request request = {
                    .view = &view, .tile = &tile, .canvas = &canvas, .background = nothing};
                cmd_check(technique_draw(&job->context, instance, &request, &err), NULL, &err);
                canvas_read_samples(&canvas, rgba);
                uint32_t right = options->width - x, above = options->height - y;
                count_tile(job, &canvas, rgba, right < canvas.width ? right : canvas.width,
                           above < canvas.height ? above : canvas.height, probe);
            }
    }
    canvas_free(&canvas);
}

static void report_row(struct cmd_report *report, const char *thing, uint32_t index, double value, const char *unit)
{
    cmd_report_text(report, thing);
    cmd_report_integer(report, index);
    if (value == floor(value))
        cmd_report_integer(report, (uint64_t)value); /* prints large counts in full */
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
    const struct hatch_unit_scene *unit = &job->scene.unit;
    double faces = 0, patches = 0, patch_faces = 0;
    for (uint32_t i = 0; i < unit->item_count; i++) {
        const struct hatch_unit_mesh *mesh = &unit->meshes[unit->items[i].mesh];
        faces += mesh->surface->face_count;
        patches += mesh->patches ? mesh->patches->patch_count : 0;
        patch_faces += mesh->patches ? mesh->mesh->face_count : 0;
    }
    report_row(report, "items", 0, unit->item_count, "");
    report_row(report, "faces", 0, faces, "");
    report_row(report, "patches", 0, patches, "");
    report_row(report, "patch-faces", 0, patch_faces, "");
    report_row(report, "lights", 0, job->frame.block.counts[0], "");
    report_row(report, "drawn", 0, (double)probe->drawn / (double)probe->pixels, "of the picture's pixels");
    report_map(report, &job->asset.map, probe);
    for (uint32_t i = 0; i < unit->item_count; i++) {
        report_row(report, "charts", i, unit->items[i].chart_count, "");
        report_row(report, "repeat-u", i, (double)unit->items[i].repeat[0], "tiles");
        report_row(report, "repeat-v", i, (double)unit->items[i].repeat[1], "tiles");
    }
}

void probe_report(struct job *job)
{
    static const char *const columns[] = {"thing", "index", "value", "unit", NULL};
    struct cmd_report report;
    struct probe probe = {.pixels = 0};
    measure(job, &probe);
    cmd_report_begin(&report, &job->args, columns);
    report_all(&report, job, &probe);
    cmd_report_write(&report, job->outputs[0]);
}
