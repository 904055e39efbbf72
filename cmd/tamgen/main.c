/* tamgen: fills a tonal art map with strokes of a style. */
#include "cmd_style.h"
#include "columns.h"
#include "io/png.h"
#include "stroke/script.h"
#include "tam/fill.h"

#define SMALLEST_LEVEL_PX 32u
#define SHEET_COLUMNS_MAX 12u

static const char *style_name = "ink", *settings, *brush_path, *strokes_path, *sheet_path;
static int64_t tones = 6, size_px = 256, levels;
static double candidates[2], growth;
static bool candidates_given, ids;
static int method;

static const char *const methods[] = {"field", "exhaustive", NULL};

static const struct cmd_option options[] = {
    {'S', "style", CMD_TEXT, 0, 0, "STYLE", "a style's name, or a file (default ink)", &style_name, NULL,
     NULL},
    {'e', "set", CMD_TEXT, 0, 0, "LINES", "style lines that go last: 'width 3; jitter 2'", &settings, NULL,
     NULL},
    {'b', "brush", CMD_TEXT, 0, 0, "IMAGE", "a grey image of one stroke, dark on white", &brush_path, NULL,
     NULL},
    {'t', "tones", CMD_INT, 1, HATCH_TAM_TONES_MAX, "N", "columns, lightest first (default 6)", &tones, NULL,
     NULL},
    {'n', "size", CMD_INT, HATCH_TAM_SIZE_MIN, HATCH_TAM_SIZE_MAX, "PX",
     "finest level, a power of two (default 256)", &size_px, NULL, NULL},
    {'l', "levels", CMD_INT, 1, 8, "N", "levels that hold strokes (default: down to 32 px)", &levels, NULL,
     NULL},
    {'c', "candidates", CMD_PAIR, 1, 1e6, "A:B", "strokes tried per stroke, light to dark columns",
     candidates, NULL, &candidates_given},
    {'m', "method", CMD_CHOICE, 0, 0, "METHOD", "field (default) or exhaustive, the paper's loop", &method,
     methods, NULL},
    {'g', "growth", CMD_REAL, 0, 0.9, "SHARE", "strokes begin that much smaller and grow (default 0)",
     &growth, NULL, NULL},
    {'i', "ids", CMD_FLAG, 0, 0, NULL, "store which stroke each pixel belongs to", &ids, NULL, NULL},
    {'r', "strokes", CMD_TEXT, 0, 0, "FILE", "write the strokes as a script (TSV)", &strokes_path, NULL,
     NULL},
    {'x', "contact-sheet", CMD_TEXT, 0, 0, "PNG", "draw the grid of tones and levels", &sheet_path, NULL,
     NULL},
    {0},
};

static const char *const examples[] = {
    "tamgen --style pencil --contact-sheet sheet.png -o pencil.exr",
    "tamgen --size 512 --set 'width 3; direction 45 0 1' | tampack --layout rgb -o hatch",
    NULL,
};

static const struct cmd_program program = {
    .name = "tamgen",
    .operands = "",
    .summary = "make a tonal art map: strokes that nest over tones and mip levels",
    .examples = examples,
    .options = options,
    .seeded = true,
    .binary = true,
};

static void check_sizes(void)
{
    if ((size_px & (size_px - 1)) != 0)
        cmd_usage("--size %d: want a power of two", (int)size_px);
    if (candidates[0] != (double)(uint32_t)candidates[0] || candidates[1] != (double)(uint32_t)candidates[1])
        cmd_usage("--candidates %g:%g: want whole numbers", candidates[0], candidates[1]);
    int64_t deepest = 1;
    while (size_px >> deepest >= SMALLEST_LEVEL_PX)
        deepest++;
    if (levels > deepest)
        cmd_usage("--levels %d: the coarsest would be under %u pixels; %d at most", (int)levels,
                  SMALLEST_LEVEL_PX, (int)deepest);
    if (levels == 0)
        levels = deepest;
}

/* Everything that tamgen writes; opened before the work, written after it. */
struct outputs {
    struct cmd_output *map, *strokes, *sheet;
};

static struct outputs open_outputs(const struct cmd_args *args)
{
    cmd_check_ending(args->output, "exr");
    cmd_check_ending(sheet_path, "png");
    return (struct outputs){cmd_open_output(args->output, true),
                            strokes_path ? cmd_open_output(strokes_path, false) : NULL,
                            sheet_path ? cmd_open_output(sheet_path, true) : NULL};
}

/* Encodes all, then writes all. */
static void write_outputs(struct cmd_args *args, const struct outputs *outputs, struct columns *columns,
                          const struct hatch_stroke_list *strokes)
{
    struct hatch_err err;
    struct hatch_buffer map = {.arena = &args->keep}, script = map, picture = map;
    cmd_check(columns_finish(columns, &map, &err), args->output, &err);
    if (strokes_path)
        cmd_check(hatch_script_print(strokes->items, strokes->count, (uint32_t)size_px, NULL, &script, &err),
                  strokes_path, &err);
    if (sheet_path)
        cmd_check(hatch_png_write(&columns->sheet->picture, HATCH_PNG_SRGB, 8, NULL, &args->scratch, &picture,
                                  &err),
                  sheet_path, &err);
    struct cmd_file files[] = {{outputs->map, map.data, map.size}, {NULL, NULL, 0}, {NULL, NULL, 0}};
    size_t count = 1;
    if (strokes_path)
        files[count++] = (struct cmd_file){outputs->strokes, script.data, script.size};
    if (sheet_path)
        files[count++] = (struct cmd_file){outputs->sheet, picture.data, picture.size};
    cmd_write_all(files, count);
}

/* Fills the map; columns receives it. */
static void fill_map(struct cmd_args *args, const struct hatch_style *style, const struct hatch_brush *brush,
                     struct columns *columns, struct hatch_stroke_list *strokes)
{
    struct hatch_err err;
    struct hatch_fill_options fill = {.size_px = (uint32_t)size_px,
                                      .tones = (uint32_t)tones,
                                      .levels = (uint32_t)levels,
                                      .method = (enum hatch_fill_method)method,
                                      .seed = args->seed,
                                      .growth = (float)growth,
                                      .ids = ids};
    if (columns->sheet) {
        uint32_t shown = fill.tones < SHEET_COLUMNS_MAX ? fill.tones : SHEET_COLUMNS_MAX;
        cmd_check(hatch_tam_sheet_make(fill.size_px, fill.levels, fill.tones, false, shown, &args->keep,
                                       columns->sheet, &err),
                  sheet_path, &err);
    }
    cmd_check(hatch_tam_fill(style, brush, &fill, &args->keep, &args->scratch, columns_take, columns, strokes,
                             &err),
              NULL, &err);
    cmd_note("%u strokes", strokes->count);
}

int main(int argc, char **argv)
{
    struct cmd_args args;
    cmd_begin(&program, argc, argv, &args);
    check_sizes();
    struct outputs outputs = open_outputs(&args);

    struct hatch_style style;
    struct hatch_brush brush;
    cmd_read_style(&args, style_name, settings, brush_path, &style, &brush);
    if (candidates_given) {
        style.candidates_light = (uint32_t)candidates[0];
        style.candidates_dark = (uint32_t)candidates[1];
    }

    struct hatch_tam_sheet sheet;
    struct columns columns = {.arena = &args.keep,
                              .pool = cmd_pool(&args),
                              .tones = (uint32_t)tones,
                              .sheet = sheet_path ? &sheet : NULL};
    struct hatch_stroke_list strokes = {0};
    fill_map(&args, &style, &brush, &columns, &strokes);
    write_outputs(&args, &outputs, &columns, &strokes);
    return cmd_end(&args, HATCH_OK);
}
