#include "render-gl/mode/needs/measure.h"

#include <math.h>
#include <string.h>

#define BAND_PX 64u      /* rows that are read from the GPU at a time */
#define UNIT_PX_MAX 1e29 /* of a unit of length; a table of needs holds ten times as many */

void needs_begin(struct job *job, double tolerance, struct needs_measure *measure)
{
    const struct hatch_unit_scene *unit = &job->scene.unit;
    const struct options *options = job->options;
    struct hatch_arena *keep = &job->args.keep;
    struct hatch_err err;
    *measure = (struct needs_measure){.map_px = asset_size_px(&job->asset),
                                      .levels = asset_levels(&job->asset),
                                      .dense_levels = asset_dense_levels(&job->asset),
                                      .tolerance = tolerance,
                                      .unseen_tolerance = 1,
                                      .inks = options->inks.two ? 2 : 1,
                                      .lightest = {1, 1}};
    cmd_check(picture_canvas(&job->frame, options->width, options->height, 1, &measure->canvas, &err), NULL, &err);
    for (int i = 0; i < 2; i++)
        cmd_check(HATCH_ALLOC(keep, &measure->texels_read[i], (size_t)4 * measure->canvas.width * BAND_PX, &err), NULL,
                  &err);
    cmd_check(HATCH_ALLOC(keep, &measure->view_tones, 2, &err), NULL, &err);
    cmd_check(HATCH_ALLOC(keep, &measure->items, unit->item_count, &err), NULL, &err);
    for (uint32_t i = 0; i < unit->item_count; i++) {
        struct needs_item *item = &measure->items[i];
        double unseen = (double)job->values.meshes[unit->items[i].mesh].unseen_tolerance;
        if (unseen > 0)
            measure->unseen_tolerance = fmin(measure->unseen_tolerance, unseen);
        item->faces = unit->meshes[unit->items[i].mesh].surface->face_count;
        cmd_check(HATCH_ALLOC(keep, &item->unit_px, item->faces, &err), NULL, &err);
        cmd_check(HATCH_ALLOC(keep, &item->growth, item->faces, &err), NULL, &err);
    }
    cmd_check(HATCH_ALLOC(keep, &measure->strokes, unit->item_count, &err), NULL, &err);
    needs_growth_begin(job, &measure->growth);
}

/* Counts a pixel that shows the scene.
 *   at          in the picture
 *   tone, face  as shaders/needs/needs.frag writes them */
static void count_pixel(const struct job *job, const uint32_t at[2], const float tone[4], const float face[4],
                        struct needs_measure *measure)
{
    uint32_t index = (uint32_t)tone[3] - 1, number = (uint32_t)face[0] + 4096 * (uint32_t)face[1];
    const struct hatch_unit_mesh *mesh = &job->scene.unit.meshes[job->scene.unit.items[index].mesh];
    struct needs_item *item = &measure->items[index];
    double octave = (double)face[2], unit_px = (double)tone[2] * measure->unit_w_px;
    if (number < item->faces)
        unit_px = fmin(unit_px * (double)item->growth[number], UNIT_PX_MAX);
    const struct needs_strokes *strokes = &measure->strokes[index];
    bool few = false;
    for (uint32_t ink = 0; ink < measure->inks; ink++) {
        double amount = fmin(fmax((double)tone[ink], 0), 1);
        hatch_needs_add(&measure->view_tones[ink], amount);
        uint32_t part = (uint32_t)fmin(amount * HATCH_NEEDS_TONES, HATCH_NEEDS_TONES - 1);
        measure->tones[ink][part]++;
        measure->unit_px[part] = fmax(measure->unit_px[part], unit_px);
        few = few || unit_px * strokes->per_px[part] > strokes->most;
    }
    measure->few += few;
    item->pixels++;
    for (int k = 0; k < 2; k++) {
        item->low_px[k] = at[k] < item->low_px[k] ? at[k] : item->low_px[k];
        item->high_px[k] = at[k] + 1 > item->high_px[k] ? at[k] + 1 : item->high_px[k];
    }
    measure->unseen += job->values.meshes[job->scene.unit.items[index].mesh].unseen_tolerance > 0;
    if (number < item->faces)
        item->unit_px[number] = fmaxf(item->unit_px[number], (float)unit_px);
    if (mesh->patches || !hatch_mesh_find(mesh->surface, "TEXCOORD_0", 2)) /* strokes as large as those of the map */
        octave = HATCH_NEEDS_OCTAVES - 1;
    measure->texels[(uint32_t)fmin(fmax(octave, 0), HATCH_NEEDS_OCTAVES - 1)]++;
    double level = measure->map_px > 0 ? log2(measure->map_px) - octave : 0;
    measure->finer += level < -0.5;
    measure->sparse += level > measure->dense_levels - 0.5 && level < measure->levels - 0.5;
}

/* Counts the pixels of a rectangle of the frame just drawn. Returns how many show the scene.
 *   corner  of the tile in the picture */
static uint64_t count_tile(const struct job *job, const struct gpu_target *target, const uint32_t corner[2],
                           struct gpu_rectangle all, struct needs_measure *measure)
{
    uint64_t drawn = 0;
    for (uint32_t y = 0; y < all.height; y += BAND_PX) {
        const struct gpu_rectangle band = {all.x, all.y + y, all.width,
                                           all.height - y < BAND_PX ? all.height - y : BAND_PX};
        for (uint32_t i = 0; i < 2; i++)
            gpu_target_read(target, i, band, GL_RGBA, GL_FLOAT, 0, measure->texels_read[i]);
        for (size_t i = 0; i < (size_t)band.width * band.height; i++) {
            const float *tone = measure->texels_read[0] + 4 * i, *face = measure->texels_read[1] + 4 * i;
            if (tone[3] < 0.5f)
                continue;
            drawn++;
            const uint32_t at[2] = {corner[0] + band.x + (uint32_t)(i % band.width),
                                    corner[1] + band.y + (uint32_t)(i / band.width)};
            count_pixel(job, at, tone, face, measure);
        }
    }
    return drawn;
}

/* Returns the pixels that a unit of the scene's lengths covers where w is 1. */
static double pixels_per_unit(const struct job *job, const struct hatch_view *view)
{
    const struct options *options = job->options;
    const struct hatch_tile all = {0, 0, options->width, options->height, options->width, options->height};
    float clip[16];
    hatch_view_matrix(view, &all, clip);
    double row = sqrt((double)(clip[1] * clip[1] + clip[5] * clip[5] + clip[9] * clip[9]));
    return row * options->height / 2 / job->scene.unit.bounds.radius;
}

static void begin_boxes(struct needs_measure *measure, uint32_t item_count)
{
    for (uint32_t i = 0; i < item_count; i++)
        for (int k = 0; k < 2; k++) {
            measure->items[i].low_px[k] = UINT32_MAX;
            measure->items[i].high_px[k] = 0;
        }
}

static void end_boxes(struct needs_measure *measure, uint32_t item_count)
{
    for (uint32_t i = 0; i < item_count; i++) {
        struct needs_item *item = &measure->items[i];
        if (item->high_px[0] > 0)
            item->extent_px = fmax(item->extent_px, hypot((double)item->high_px[0] - item->low_px[0],
                                                          (double)item->high_px[1] - item->low_px[1]));
    }
}

uint64_t needs_add(struct job *job, const struct hatch_view *view, struct needs_measure *measure)
{
    static const float nothing[3] = {0, 0, 0};
    const struct options *options = job->options;
    const struct canvas *canvas = &measure->canvas;
    struct technique_instance *instance = job_use(job, &needs_technique);
    struct hatch_err err;
    uint64_t drawn = 0;
    measure->finer = measure->sparse = measure->unseen = measure->few = 0;
    measure->unit_w_px = pixels_per_unit(job, view);
    memset(measure->view_tones, 0, 2 * sizeof *measure->view_tones);
    begin_boxes(measure, job->scene.unit.item_count);
    for (uint32_t i = 0; i < job->scene.unit.item_count; i++)
        needs_growth_find(job, &measure->growth, i, measure->items[i].growth);
    for (uint32_t y = 0; y < options->height; y += canvas->height)
        for (uint32_t x = 0; x < options->width; x += canvas->width) {
            const struct hatch_tile tile = {x, y, canvas->width, canvas->height, options->width, options->height};
            const struct frame_request request = {.view = view, .tile = &tile, .canvas = canvas, .background = nothing};
            uint32_t right = options->width - x, above = options->height - y;
            const struct gpu_rectangle seen = {0, 0, right < canvas->width ? right : canvas->width,
                                               above < canvas->height ? above : canvas->height};
            cmd_check(technique_draw(&job->context, instance, &request, &err), NULL, &err);
            const uint32_t corner[2] = {x, y};
            drawn += count_tile(job, needs_target(instance), corner, seen, measure);
        }
    for (uint32_t ink = 0; ink < measure->inks; ink++) {
        const struct hatch_needs_tones *tones = &measure->view_tones[ink];
        double tolerance = NEEDS_TONES_SHARE * measure->tolerance;
        measure->darkest[ink] = fmax(measure->darkest[ink], hatch_needs_darkest(tones, drawn, tolerance));
        if (drawn)
            measure->lightest[ink] = fmin(measure->lightest[ink], hatch_needs_lightest(tones, drawn, tolerance));
    }
    end_boxes(measure, job->scene.unit.item_count);
    measure->views++;
    measure->drawn += drawn;
    measure->pixels += (uint64_t)options->width * options->height;
    return drawn;
}

void needs_end(struct needs_measure *measure)
{
    canvas_free(&measure->canvas);
}
