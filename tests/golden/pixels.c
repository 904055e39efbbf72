/* pixels FILE ...: prints a line for each PNG, OpenEXR or KTX2 file: its name, a tab, and for each level, separated by
 * spaces: the number of its values, the first of them, the mean and the root mean square of their differences from the
 * first, and the mean change of a value to the next column, row and layer. The parts of an EXR file are layers. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/exr/exr.h"
#include "io/png/png.h"
#include "io/texture/container.h"

static struct hatch_arena arena, scratch;
static struct hatch_err err;

static void check(enum hatch_status status)
{
    if (status == HATCH_OK)
        return;
    fprintf(stderr, "pixels: %s\n", err.text);
    exit(1);
}

/* Values in rows, [((layer * height + y) * width + x) * channels + c]. */
struct grid {
    size_t width, height, layers, channels;
    double *values;
};

static struct grid grid_make(size_t width, size_t height, size_t layers, size_t channels)
{
    struct grid grid = {.width = width, .height = height, .layers = layers, .channels = channels};
    check(HATCH_ALLOC(&arena, &grid.values, width * height * layers * channels, &err));
    return grid;
}

/* Returns the mean change of a value to the one stride entries on, over count of them that begin every period. */
static double mean_change(const struct grid *grid, size_t stride, size_t period)
{
    size_t all = grid->width * grid->height * grid->layers * grid->channels, pairs = 0;
    double sum = 0;
    for (size_t i = 0; i + stride < all; i++)
        if (i % period + stride < period) {
            sum += fabs(grid->values[i + stride] - grid->values[i]);
            pairs++;
        }
    return pairs ? sum / (double)pairs : 0;
}

static void print_level(const struct grid *grid)
{
    size_t row = grid->width * grid->channels, layer = row * grid->height, all = layer * grid->layers;
    double sum = 0, squares = 0;
    for (size_t i = 0; i < all; i++) {
        double value = grid->values[i] - grid->values[0];
        sum += value;
        squares += value * value;
    }
    printf(" %zu %.6g %.6g %.6g %.6g %.6g %.6g", all, grid->values[0], sum / (double)all, sqrt(squares / (double)all),
           mean_change(grid, grid->channels, row), mean_change(grid, row, layer), mean_change(grid, layer, all));
}

static void print_parts(const struct hatch_mipmap *parts, uint32_t count)
{
    for (uint32_t level = 0; level < parts[0].level_count; level++) {
        const struct hatch_image *first = &parts[0].levels[level];
        struct grid grid = grid_make(first->width, first->height, count, first->channel_count);
        size_t layer = grid.width * grid.height * grid.channels;
        for (size_t i = 0; i < layer * count; i++) {
            const struct hatch_mipmap *part = &parts[i / layer];
            grid.values[i] = level < part->level_count ? (double)part->levels[level].pixels[i % layer] : 0;
        }
        print_level(&grid);
    }
}

static void print_texels(const struct hatch_texels *texture)
{
    bool words = texture->code == HATCH_TEXELS_R32UI, plain = texture->code == HATCH_TEXELS_PLAIN;
    for (uint32_t level = 0; level < texture->level_count; level++) {
        size_t bytes = hatch_texels_level_size(texture, level), of_one = words ? 4 : 1;
        size_t width = hatch_mip_size(texture->width, level), height = hatch_mip_size(texture->height, level);
        size_t channels = plain ? texture->channels : 1;
        size_t layers = plain || words ? bytes / of_one / (width * height * channels) : 1;
        struct grid grid = plain || words ? grid_make(width, height, layers, channels) : grid_make(bytes, 1, 1, 1);
        for (size_t i = 0; i < bytes / of_one; i++) {
            uint32_t word;
            if (words)
                memcpy(&word, texture->texels[level] + 4 * i, sizeof word);
            grid.values[i] = words ? (double)word : texture->texels[level][i];
        }
        print_level(&grid);
    }
}

static struct hatch_bytes read_file(const char *path)
{
    FILE *from = fopen(path, "rb");
    long size = from && fseek(from, 0, SEEK_END) == 0 ? ftell(from) : -1;
    uint8_t *data = size > 0 ? HATCH_NEW(&arena, uint8_t, (size_t)size, &err) : NULL;
    if (!data || fseek(from, 0, SEEK_SET) != 0 || fread(data, 1, (size_t)size, from) != (size_t)size) {
        fprintf(stderr, "pixels: cannot read %s\n", path);
        exit(1);
    }
    fclose(from);
    return (struct hatch_bytes){.data = data, .size = (size_t)size};
}

static void print_file(const char *path)
{
    struct hatch_bytes file = read_file(path);
    printf("%s\t", path);
    if (hatch_exr_is(file)) {
        struct hatch_mipmap *parts;
        uint32_t count;
        check(hatch_exr_read(file, NULL, &arena, &scratch, &parts, &count, &err));
        print_parts(parts, count);
    } else if (hatch_ktx2_is(file)) {
        struct hatch_texels texture;
        check(hatch_ktx2_read(file, &arena, &texture, &err));
        print_texels(&texture);
    } else {
        struct hatch_image image;
        check(hatch_png_read(file, &arena, &scratch, &image, &err));
        print_parts(&(struct hatch_mipmap){.level_count = 1, .levels = &image}, 1);
    }
    printf("\n");
    hatch_arena_free(&arena);
    hatch_arena_free(&scratch);
}

int main(int argc, char **argv)
{
    hatch_arena_init(&arena, (size_t)1 << 30);
    hatch_arena_init(&scratch, (size_t)1 << 30);
    for (int i = 1; i < argc; i++)
        print_file(argv[i]);
    return 0;
}
