#include "io/script/write.h"

#include <string.h>

#include "image/image.h"
#include "io/drawing/rounded.h"
#include "stroke/path.h"
#include "stroke/script.h"

/* The page on its tile. */
struct tile {
    double width_mm, height_mm; /* of the page */
    double side_mm;
};

static struct tile tile_of(const struct hatch_drawing *drawing)
{
    const double width = hatch_drawing_round(drawing->width_mm), height = hatch_drawing_round(drawing->height_mm);
    return (struct tile){width, height, fmax(width, height)};
}

/* Makes a stroke of a path.
 *   line    in, out: a builder, whose points are replaced
 *   stroke  out: its geometry */
static enum hatch_status trace(const struct hatch_drawing *drawing, const struct hatch_vector_path *path,
                               struct hatch_path_builder *line, struct hatch_stroke *stroke, struct hatch_err *err)
{
    const struct tile tile = tile_of(drawing);
    const double left = 0.5 * (tile.side_mm - tile.width_mm), top = 0.5 * (tile.side_mm - tile.height_mm);
    line->count = 0;
    for (uint32_t i = 0; i < path->count + path->closed; i++) {
        const double *at = hatch_vector_point(&drawing->paths, path, i);
        HATCH_TRY(hatch_path_add_line(line, (left + hatch_drawing_round(at[0])) / tile.side_mm,
                                      (top + hatch_drawing_round(at[1])) / tile.side_mm, err));
    }
    return hatch_path_finish(line, line->arena, stroke, err);
}

/* Sets the colour of a stroke to that of its path. */
static void color(const struct hatch_drawing_layer *layer, uint32_t id, struct hatch_stroke *stroke)
{
    float linear[3];
    uint8_t codes[3];
    memcpy(linear, layer->color, sizeof linear);
    if (hatch_drawing_has_colors(layer))
        hatch_stroke_color(layer->look, id, linear);
    hatch_drawing_codes(linear, codes);
    for (int k = 0; k < 3; k++)
        stroke->rgb[k] = hatch_srgb_to_linear((float)codes[k] / 255);
}

/* Appends the paths of a layer to strokes, of which there are *count. */
static enum hatch_status add_layer(const struct hatch_drawing *drawing, uint32_t layer, struct hatch_path_builder *line,
                                   struct hatch_stroke *strokes, uint32_t *count, struct hatch_err *err)
{
    const struct hatch_drawing_layer *from = &drawing->layers[layer];
    const double width = hatch_drawing_pen(from) / tile_of(drawing).side_mm;
    if (!(width <= HATCH_SCRIPT_WIDTH_MAX))
        return hatch_fail(err, HATCH_LIMIT, "%s: a pen of %g mm on a page of %g x %g mm, want at most %g pages",
                          from->name, from->pen_mm, drawing->width_mm, drawing->height_mm, HATCH_SCRIPT_WIDTH_MAX);
    for (uint32_t i = 0; i < drawing->paths.count; i++) {
        const struct hatch_vector_path *path = &drawing->paths.paths[i];
        struct hatch_stroke *stroke = &strokes[*count];
        if (path->layer != layer)
            continue;
        *stroke = (struct hatch_stroke){
            .width_px = (float)width, .tone = 1, .id = ++*count, .texture_seed = path->id}; /* of a tile of one pixel */
        color(from, path->id, stroke);
        HATCH_TRY(trace(drawing, path, line, stroke, err));
    }
    return HATCH_OK;
}

static enum hatch_status print(const struct hatch_drawing *drawing, struct hatch_arena *scratch,
                               struct hatch_buffer *file, struct hatch_err *err)
{
    struct hatch_path_builder line = {.arena = scratch, .tolerance = 1};
    struct hatch_stroke *strokes;
    uint32_t count = 0;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &strokes, drawing->paths.count, err));
    for (uint32_t layer = 0; layer < drawing->layer_count; layer++)
        HATCH_TRY(add_layer(drawing, layer, &line, strokes, &count, err));
    return hatch_script_print(strokes, count, 1, NULL, file, err);
}

enum hatch_status hatch_script_write(const struct hatch_drawing *drawing, struct hatch_arena *scratch,
                                     struct hatch_buffer *file, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = print(drawing, scratch, file, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}
