#include "io/svg/write.h"

#include <math.h>

#include "base/keys.h"
#include "io/drawing/rounded.h"

#define NUMBER_BYTES 32u /* more than a number takes */

/* Writes the decimal digits of a rounded number, without zeros at the end. Returns the number of bytes. */
static size_t put_number(char *text, double value)
{
    char digits[NUMBER_BYTES];
    int64_t units = llround(value * HATCH_DRAWING_UNITS);
    uint64_t rest = units < 0 ? (uint64_t)-units : (uint64_t)units, fraction = rest % (uint64_t)HATCH_DRAWING_UNITS;
    size_t count = 0, used = 0;
    if (units < 0)
        text[used++] = '-';
    for (rest /= (uint64_t)HATCH_DRAWING_UNITS; rest || !count; rest /= 10)
        digits[count++] = (char)('0' + rest % 10);
    while (count)
        text[used++] = digits[--count];
    if (!fraction)
        return used;
    text[used++] = '.';
    for (uint64_t place = (uint64_t)HATCH_DRAWING_UNITS / 10; fraction; place /= 10) {
        text[used++] = (char)('0' + fraction / place);
        fraction %= place;
    }
    return used;
}

static enum hatch_status put_points(const struct hatch_vector_paths *paths, const struct hatch_vector_path *path,
                                    struct hatch_buffer *file, struct hatch_err *err)
{
    char text[2 * NUMBER_BYTES];
    for (uint32_t i = 0; i < path->count; i++) {
        const double *at = hatch_vector_point(paths, path, i);
        size_t used = 0;
        text[used++] = i == 0 ? 'M' : i == 1 ? 'L' : ' ';
        used += put_number(text + used, at[0]);
        text[used++] = ' ';
        used += put_number(text + used, at[1]);
        HATCH_TRY(hatch_buffer_add(file, text, used, err));
    }
    /* A path of one point is a dot: it has no extent, and its round cap is drawn. */
    return path->count == 1 ? hatch_buffer_add(file, "h0", 2, err)
           : path->closed   ? hatch_buffer_add(file, "Z", 1, err)
                            : HATCH_OK;
}

static void put_color(const float linear[3], char text[8])
{
    static const char hex[] = "0123456789abcdef";
    uint8_t codes[3];
    hatch_drawing_codes(linear, codes);
    text[0] = '#';
    for (int k = 0; k < 3; k++) {
        text[2 * k + 1] = hex[codes[k] / 16];
        text[2 * k + 2] = hex[codes[k] % 16];
    }
    text[7] = '\0';
}

static enum hatch_status put_path(const struct hatch_drawing *drawing, const struct hatch_vector_path *path,
                                  uint32_t part, struct hatch_buffer *file, struct hatch_err *err)
{
    const struct hatch_drawing_layer *layer = &drawing->layers[path->layer];
    const char *name = layer->name;
    if (part > 1)
        HATCH_TRY(hatch_buffer_print(file, err, "<path id=\"%s-%u-%u\" d=\"", name, path->id, part));
    else
        HATCH_TRY(hatch_buffer_print(file, err, "<path id=\"%s-%u\" d=\"", name, path->id));
    HATCH_TRY(put_points(&drawing->paths, path, file, err));
    if (hatch_drawing_has_colors(layer)) {
        float rgb[3];
        char color[8];
        hatch_stroke_color(layer->look, path->id, rgb);
        put_color(rgb, color);
        HATCH_TRY(hatch_buffer_print(file, err, "\" stroke=\"%s", color));
    }
    return hatch_buffer_add(file, "\"/>\n", 4, err);
}

static enum hatch_status put_layer(const struct hatch_drawing *drawing, uint32_t layer, struct hatch_arena *scratch,
                                   struct hatch_buffer *file, struct hatch_err *err)
{
    const struct hatch_drawing_layer *from = &drawing->layers[layer];
    struct hatch_buffer parts = {.arena = scratch}; /* per id: number of paths so far */
    struct hatch_keys ids;
    char color[8], pen[NUMBER_BYTES];
    put_color(from->color, color);
    HATCH_TRY(hatch_keys_make(scratch, &ids, err));
    size_t pen_bytes = put_number(pen, hatch_drawing_pen(from)); /* 0 would draw nothing */
    HATCH_TRY(hatch_buffer_print(file, err,
                                 "<g id=\"%s\" inkscape:groupmode=\"layer\" inkscape:label=\"%s\" stroke=\"%s\" "
                                 "stroke-width=\"%.*s\">\n",
                                 from->name, from->name, color, (int)pen_bytes, pen));
    for (uint32_t i = 0; i < drawing->paths.count; i++) {
        const struct hatch_vector_path *path = &drawing->paths.paths[i];
        uint32_t number;
        if (path->layer != layer)
            continue;
        HATCH_TRY(hatch_keys_number(&ids, path->id, &number, err));
        if (number * sizeof(uint32_t) == parts.size)
            HATCH_TRY(hatch_buffer_add(&parts, NULL, sizeof(uint32_t), err));
        uint32_t part = ++((uint32_t *)(void *)parts.data)[number];
        HATCH_TRY(put_path(drawing, path, part, file, err));
    }
    return hatch_buffer_print(file, err, "</g>\n");
}

static enum hatch_status put_drawing(const struct hatch_drawing *drawing, struct hatch_arena *scratch,
                                     struct hatch_buffer *file, struct hatch_err *err)
{
    char width[NUMBER_BYTES], height[NUMBER_BYTES], paper[8];
    int wide = (int)put_number(width, drawing->width_mm), high = (int)put_number(height, drawing->height_mm);
    put_color(drawing->paper, paper);
    HATCH_TRY(hatch_buffer_print(file, err,
                                 "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                                 "<svg xmlns=\"http://www.w3.org/2000/svg\" "
                                 "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
                                 "width=\"%.*smm\" height=\"%.*smm\" viewBox=\"0 0 %.*s %.*s\" "
                                 "fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\" "
                                 "style=\"background:%s\">\n",
                                 wide, width, high, height, wide, width, high, height, paper));
    for (uint32_t layer = 0; layer < drawing->layer_count; layer++)
        HATCH_TRY(put_layer(drawing, layer, scratch, file, err));
    return hatch_buffer_print(file, err, "</svg>\n");
}

enum hatch_status hatch_svg_write(const struct hatch_drawing *drawing, struct hatch_arena *scratch,
                                  struct hatch_buffer *file, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = put_drawing(drawing, scratch, file, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}
