/* tamgen: makes a tonal art map from strokes of a style, or from those of a drawing. */
#include <stdio.h>

#include "shared/style.h"
#include "io/svg/svg.h"
#include "shared/needs/map.h"
#include "job.h"

#define SMALLEST_LEVEL_PX 32u

static const char *style_name, *palette, *brush_path, *strokes_path, *sheet_path, *needs_path;
static struct cmd_texts settings;
static int64_t tones = 6, size_px = 256, levels;
static double candidates[2], growth;
static bool candidates_given, levels_given;
static int method;
static struct replay_job replay = {.keep = 1};
static bool ids;

static const char *const methods[] = {"field", "exhaustive", NULL};

static const struct cmd_option options[] = {
    {'S', "style", CMD_TEXT, 0, 0, "STYLE", "drawing style: a name, or a file (default ink)", &style_name, NULL, NULL},
    {'e', "set", CMD_TEXTS, 0, 0, "LINES", "style lines to add: 'width 3; jitter 2'; repeatable", &settings, NULL,
     NULL},
    {'p', "palette", CMD_TEXT, 0, 0, "PALETTE", "colours of strokes by tone: a name, or a file", &palette, NULL, NULL},
    {'b', "brush", CMD_TEXT, 0, 0, "IMAGE", "grey image of a stroke, dark on white", &brush_path, NULL, NULL},
    {'t', "tones", CMD_INT, 1, HATCH_TAM_TONES_MAX, "N", "number of tones: columns of the map (default 6)", &tones,
     NULL, NULL},
    {'n', "size", CMD_INT, HATCH_TAM_SIZE_MIN, HATCH_TAM_SIZE_MAX, "PX",
     "width of the finest level, a power of two (default 256)", &size_px, NULL, NULL},
    {'l', "levels", CMD_INT, 1, 8, "N", "drawn levels (default: down to 32 px)", &levels, NULL, &levels_given},
    {'c', "candidates", CMD_WHOLES, 1, 1e6, "A:B", "candidates per stroke, in the lightest and darkest column",
     candidates, NULL, &candidates_given},
    {'m', "method", CMD_CHOICE, 0, 0, "METHOD",
     "how the best candidate is found: field (default) or exhaustive (Praun et al. 2001)", &method, methods, NULL},
    {'g', "growth", CMD_REAL, 0, 0.9, "SHARE", "strokes start shorter by SHARE and grow over darker tones (default 0)",
     &growth, NULL, NULL},
    {'N', "needs", CMD_TEXT, 0, 0, "FILE", "make no columns darker than views need (render-gl --needs)", &needs_path,
     NULL, NULL},
    {'R', "replay", CMD_TEXT, 0, 0, "FILE", "replay the strokes of a script or an SVG drawing", &replay.path, NULL,
     NULL},
    {'k', "keep", CMD_REAL, 0.01, 1, "SHARE", "replay: share of strokes kept from level to level (default 1)",
     &replay.keep, NULL, NULL},
    {'f', "fit", CMD_FLAG, 0, 0, NULL, "replay: compute the share to keep per image, report errors", &replay.fit, NULL,
     NULL},
    {'i', "ids", CMD_FLAG, 0, 0, NULL, "store the number of each pixel's stroke", &ids, NULL, NULL},
    {'r', "strokes", CMD_TEXT, 0, 0, "FILE", "write the strokes as a script (TSV)", &strokes_path, NULL, NULL},
    {'x', "contact-sheet", CMD_TEXT, 0, 0, "PNG", "draw the grid of tones and levels", &sheet_path, NULL, NULL},
    {0},
};

static const struct cmd_rule rules[] = {
    {"keep fit", "replay", NULL},
    {"keep", "!fit", "which computes the share"},
    {"method growth candidates", "!replay", "its strokes are given"},
    {"ids", "!replay|!needs", "whose strokes are listed in the last column"},
    {NULL, NULL, NULL},
};

static const char *const examples[] = {
    "tamgen --style pencil --contact-sheet sheet.png -o pencil.exr",
    "tamgen --replay drawing.svg --tones 12 -o drawing.exr",
    "tamgen --size 512 --set 'width 3; direction 45 0 1' | tampack -o hatch",
    NULL,
};

static const struct cmd_program program = {
    .name = "tamgen",
    .operands = "",
    .summary = "make a tonal art map: each stroke stays in all darker tones and finer mip levels",
    .examples = examples,
    .options = options,
    .rules = rules,
    .seeded = true,
    .binary = true,
};

static void check_sizes(void)
{
    if ((size_px & (size_px - 1)) != 0)
        cmd_usage("--size %d: want a power of two", (int)size_px);
    int64_t deepest = 1;
    while (size_px >> deepest >= SMALLEST_LEVEL_PX)
        deepest++;
    if (levels > deepest)
        cmd_usage("--levels %d: the coarsest would be under %u pixels wide; want %d at most", (int)levels,
                  SMALLEST_LEVEL_PX, (int)deepest);
    if (levels == 0)
        levels = deepest;
}

/* Reads the drawing first, because its format decides the default style. */
static void read_style(struct job *job)
{
    if (replay.path) {
        replay.file = cmd_read(&job->args, replay.path);
        replay.is_svg = hatch_svg_is(replay.file);
    }
    if (!style_name)
        style_name = replay.is_svg ? "drawing" : "ink";
    cmd_read_style(&job->args, style_name, &settings, brush_path, &job->style, &job->brush);
    if (palette)
        cmd_read_palette(&job->args, palette, &job->style);
    if (candidates_given) {
        job->style.candidates_light = (uint32_t)candidates[0];
        job->style.candidates_dark = (uint32_t)candidates[1];
    }
}

/* Reads how large tiles must be on patches, and how many of the columns and levels are needed. The others are left
 * out. */
static void read_needs(struct job *job)
{
    float targets[HATCH_TAM_TONES_MAX];
    struct hatch_needs needs;
    cmd_read_needs(&job->args, needs_path, &needs);
    uint32_t tile_px = levels_given ? job->size_px : hatch_needs_tile(&needs, job->size_px, HATCH_TAM_SIZE_MIN);
    if (tile_px < job->size_px)
        cmd_note("a tile of %u pixels, not %u: no patch is larger in the pictures", tile_px, job->size_px);
    for (; tile_px < job->size_px; job->size_px /= 2)
        job->levels--;
    hatch_style_targets(&job->style, job->tones, targets);
    job->every = hatch_needs_every(&needs, targets, job->tones);
    if (job->every > 1)
        cmd_note("1 of %u columns is made: they are at most %g tolerances apart", job->every, HATCH_NEEDS_COLUMN);
    job->tones /= job->every;
    hatch_style_targets(&job->style, job->tones, targets);
    const struct cmd_map_part part = cmd_find_map_part(&needs, targets, job->tones, targets[job->tones - 1],
                                                       job->size_px, levels_given ? 1 : job->levels);
    job->tones = part.tones;
    job->tolerance = (float)part.tolerance;
    job->whole_size_px = job->size_px;
    job->size_px >>= part.finer;
    job->levels -= part.finer;
}

/* Warns of images whose tone is not that of their column. */
static void warn_of_misses(const struct job *job, const struct hatch_fill_misses *misses)
{
    char why[64] = "the ink is too light";
    if (misses->images == 0)
        return;
    if (!misses->light_ink)
        snprintf(why, sizeof why, "strokes are too large for the level of %u pixels", job->size_px >> misses->level);
    cmd_warn(cmd_input_name(style_name), "%u of %u images miss their tone, by up to %.2f: %s", misses->images,
             job->tones * job->levels, (double)misses->most, why);
}

/* Fills the map with strokes of the style and passes its columns to job->columns. */
static void fill_map(struct job *job)
{
    const struct hatch_progress progress = cmd_progress_of("columns");
    struct hatch_err err;
    struct hatch_fill_options fill = {.style = &job->style,
                                      .brush = &job->brush,
                                      .size_px = job->size_px,
                                      .tones = (uint32_t)tones,
                                      .needed = job->tones * job->every,
                                      .every = job->every,
                                      .whole_size_px = job->whole_size_px,
                                      .tolerance = job->tolerance,
                                      .levels = job->levels,
                                      .method = (enum hatch_fill_method)method,
                                      .seed = job->args.seed,
                                      .progress = &progress,
                                      .growth = (float)growth,
                                      .color = job->color,
                                      .ids = job->ids};
    const struct hatch_tam_sink sink = {columns_take, &job->columns};
    struct hatch_fill_misses misses;
    cmd_check(hatch_tam_fill(&fill, &job->args.keep, &job->args.scratch, &sink, &job->strokes, &misses, &err), NULL,
              &err);
    warn_of_misses(job, &misses);
    cmd_note("%u strokes, tone within %.4f on every level", job->strokes.count, (double)misses.most);
}

int main(int argc, char **argv)
{
    static struct job job;
    cmd_begin(&program, argc, argv, &job.args);
    check_sizes();
    job.size_px = (uint32_t)size_px;
    job.tones = (uint32_t)tones;
    job.every = 1;
    job.levels = (uint32_t)levels;
    job.ids = ids;
    job.strokes_path = strokes_path;
    job.sheet_path = sheet_path;
    struct outputs outputs = open_outputs(&job);

    read_style(&job);
    job.color = job.style.color_count > 0;
    replay.needs = needs_path;
    replay.all_levels = levels_given;
    if (needs_path && !replay.path)
        read_needs(&job);
    if (replay.path)
        read_drawing(&job, &replay);
    if (!replay.path || !needs_path)
        begin_columns(&job);
    if (replay.path)
        replay_drawing(&job, &replay);
    else
        fill_map(&job);
    write_outputs(&job, &outputs);
    return cmd_end(&job.args, HATCH_OK);
}
