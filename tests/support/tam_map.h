/* Tonal art maps for tests, filled with strokes of a style. Pixels are rounded as in a file. Call map_begin first and
 * map_end last. */
#ifndef HATCH_TEST_TAM_MAP_H
#define HATCH_TEST_TAM_MAP_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "run.h"
#include "placement/fill.h"

static struct hatch_arena map_arena, map_scratch;
static struct hatch_err map_err;

static const char *const map_styles[] = {"ink",     "pencil", "crayon",  "charcoal", "stipple",  "arcs",
                                         "speckle", "chalk",  "wash",    "marker",   "drafting", "engraving",
                                         "etching", "sketch", "woodcut", "scribble"};
enum { MAP_STYLES = sizeof map_styles / sizeof *map_styles };

struct test_map {
    struct hatch_style style;
    struct hatch_brush brush;
    struct hatch_fill_options options;
    struct hatch_stroke_list strokes;
    struct hatch_mipmap columns[HATCH_TAM_TONES_MAX];
    struct hatch_tam tam;
};

static inline void map_begin(void)
{
    hatch_arena_init(&map_arena, (size_t)4 << 30);
    hatch_arena_init(&map_scratch, (size_t)1 << 30);
}

static inline void map_end(void)
{
    hatch_arena_free(&map_arena);
    hatch_arena_free(&map_scratch);
}

/* Sets the style, the brush and default options of a map.
 *   name   an installed style; NULL: the default
 *   lines  style lines to add; NULL: none */
static inline void map_style(const char *name, const char *lines, struct test_map *map)
{
    char path[1000], text[10000];
    size_t size = 0;
    memset(map, 0, sizeof *map);
    hatch_style_default(&map->style);
    if (name) {
        const char *top = getenv("TOP");
        snprintf(path, sizeof path, "%s/styles/%s.style", top ? top : ".", name);
        FILE *file = fopen(path, "rb");
        ck_assert_msg(file != NULL, "cannot open %s", path);
        size = fread(text, 1, sizeof text / 2, file);
        fclose(file);
    }
    if (lines)
        size += (size_t)snprintf(text + size, sizeof text - size, "\n%s", lines);
    if (size > 0)
        HATCH_TEST_OK(hatch_style_parse((struct hatch_bytes){(const uint8_t *)text, size}, &map->style, &map_err),
                      &map_err);
    HATCH_TEST_OK(hatch_brush_make(map->style.brush, &map_arena, &map->brush, &map_err), &map_err);
    map->options = (struct hatch_fill_options){.style = &map->style,
                                               .brush = &map->brush,
                                               .size_px = 64,
                                               .tones = 6,
                                               .levels = 2,
                                               .seed = 1,
                                               .color = map->style.color_count > 0};
}

/* Keeps a column with its pixels rounded as in a file; has the type of take in struct hatch_tam_sink.
 *   context  struct test_map */
static inline enum hatch_status map_keep(void *context, uint32_t tone, const struct hatch_mipmap *column,
                                         struct hatch_err *err)
{
    struct test_map *map = context;
    struct hatch_image *levels = HATCH_NEW(&map_arena, struct hatch_image, column->level_count, err);
    if (!levels)
        return HATCH_LIMIT;
    for (uint32_t level = 0; level < column->level_count; level++) {
        levels[level] = column->levels[level];
        uint32_t channels = levels[level].channel_count;
        size_t floats = (size_t)levels[level].width * levels[level].height * channels;
        levels[level].pixels = HATCH_NEW(&map_arena, float, floats, err);
        if (!levels[level].pixels)
            return HATCH_LIMIT;
        for (size_t i = 0; i < floats; i++) {
            float value = column->levels[level].pixels[i];
            bool half = levels[level].channels[i % channels].type == HATCH_HALF;
            levels[level].pixels[i] = half ? hatch_float_from_half(hatch_half_from_float(value)) : value;
        }
    }
    map->columns[tone] = *column;
    map->columns[tone].levels = levels;
    return HATCH_OK;
}

/* Fills map->tam and map->strokes. */
static inline void map_fill(struct test_map *map)
{
    map->strokes = (struct hatch_stroke_list){0};
    const struct hatch_tam_sink sink = {map_keep, map};
    HATCH_TEST_OK(hatch_tam_fill(&map->options, &map_arena, &map_scratch, &sink, &map->strokes, NULL, &map_err),
                  &map_err);
    HATCH_TEST_OK(hatch_tam_from_mipmaps(map->columns, map->options.tones, &map->tam, &map_err), &map_err);
    ck_assert_uint_eq(map->tam.levels, map->options.levels);
}

#endif
