/* maps FOLDER: writes a small tonal art map and many that are damaged, each in one way, as FOLDER/NAME.exr. */
#include <math.h>
#include <OpenEXR/openexr.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/exr/exr.h"
#include "tam/tam.h"

enum { SIZE = 16, TONES = 4 };

static struct hatch_arena arena;
static struct hatch_err err;
static struct hatch_mipmap map[TONES];

static void check(enum hatch_status status)
{
    if (status == HATCH_OK)
        return;
    fprintf(stderr, "maps: %s\n", err.text);
    exit(1);
}

/* Column t of four darkens the first t + 1 quarters of each row. */
static void make_map(const char *channels)
{
    static const struct hatch_tam_metadata label = {
        .tones = TONES, .levels = 2, .growth = 1, .seed = "1", .style = "none"};
    memset(map, 0, sizeof map);
    for (uint32_t t = 0; t < TONES; t++) {
        map[t].level_count = hatch_mip_chain_length(SIZE, SIZE);
        map[t].levels = HATCH_NEW(&arena, struct hatch_image, map[t].level_count, &err);
        for (uint32_t l = 0; l < map[t].level_count; l++) {
            struct hatch_image *level = &map[t].levels[l];
            uint32_t side = hatch_mip_size(SIZE, l);
            check(hatch_image_make(&arena, side, side, channels, level, &err));
            for (uint32_t i = 0; i < side * side * level->channel_count; i++)
                level->pixels[i] = 4 * (i / level->channel_count % side) < (t + 1) * side ? 0 : 1;
        }
        hatch_tam_set_metadata(&label, t, 0.25f * (float)(t + 1), &map[t]);
    }
}

static void save_parts(const char *folder, const char *name, uint32_t first, uint32_t count)
{
    char path[4096];
    struct hatch_exr_writer *writer;
    struct hatch_buffer file = {.arena = &arena};
    check(hatch_exr_begin(&map[first], count, &arena, &writer, &err));
    for (uint32_t t = 0; t < count; t++)
        check(hatch_exr_add_part(writer, t, &map[first + t], &err));
    check(hatch_exr_end(writer, &file, &err));
    snprintf(path, sizeof path, "%s/%s.exr", folder, name);
    FILE *to = fopen(path, "wb");
    if (!to || fwrite(file.data, 1, file.size, to) != file.size || fclose(to) != 0) {
        perror(path);
        exit(1);
    }
}

/* The whole map as it is now; the next one begins anew. */
static void save(const char *folder, const char *name)
{
    save_parts(folder, name, 0, TONES);
    make_map("Y");
}

static void set_tone(uint32_t column, double tone)
{
    hatch_mipmap_set_number(&map[column], HATCH_TAM_ATTR_TONE, tone, HATCH_ATTRIBUTE_FLOAT);
}

static void set_count(uint32_t column, double count)
{
    hatch_mipmap_set_number(&map[column], HATCH_TAM_ATTR_TONES, count, HATCH_ATTRIBUTE_INT);
}

static void set_levels(uint32_t column, double levels)
{
    hatch_mipmap_set_number(&map[column], HATCH_TAM_ATTR_LEVELS, levels, HATCH_ATTRIBUTE_INT);
}

static void save_parts_missing(const char *folder)
{
    save_parts(folder, "no-first-part", 1, TONES - 1);
    snprintf(map[2].name, sizeof map[2].name, "tone.009");
    save(folder, "part-missing-in-between");
    snprintf(map[1].name, sizeof map[1].name, "tone.001 of another");
    save(folder, "part-with-another-name");
    for (uint32_t t = 0; t < TONES; t++)
        map[t].level_count = 1;
    save(folder, "one-level");
    map[1].attribute_count = 0;
    save(folder, "attributes-missing");
    hatch_mipmap_set_text(&map[1], HATCH_TAM_ATTR_TONE, "half");
    save(folder, "tone-is-text");
    make_map("YA");
    for (uint32_t t = 0; t < TONES; t++)
        for (uint32_t l = 0; l < map[t].level_count; l++)
            snprintf(map[t].levels[l].channels[0].name, HATCH_NAME_MAX, "Z");
    save(folder, "channel-missing");
}

static void save_tones(const char *folder)
{
    set_tone(1, 0.8);
    save(folder, "tones-out-of-order");
    set_tone(0, -0.1);
    save(folder, "tone-below-0");
    set_tone(3, 1.5);
    save(folder, "tone-above-1");
    set_tone(2, NAN);
    save(folder, "tone-nan");
    set_levels(0, 0);
    save(folder, "no-levels");
    set_levels(3, 99);
    save(folder, "too-many-levels");
    set_levels(2, 3);
    save(folder, "levels-unequal");
}

/* Sound files with fewer or more parts than they say. */
static void save_counts(const char *folder)
{
    save_parts(folder, "half-the-parts", 0, TONES / 2);
    for (uint32_t t = 0; t < TONES; t++)
        set_count(t, TONES - 1);
    save(folder, "a-part-too-many");
    set_count(TONES - 1, TONES + 1);
    save(folder, "counts-unequal");
    hatch_mipmap_set_text(&map[1], HATCH_TAM_ATTR_TONES, "four");
    save(folder, "count-is-text");
}

/* Writes what a map says of the whole one into its first column.
 *   tolerance  below 0: left out */
static void set_whole(double size_px, double tones, double darkest, double tolerance)
{
    hatch_mipmap_set_number(&map[0], HATCH_TAM_ATTR_WHOLE_SIZE, size_px, HATCH_ATTRIBUTE_INT);
    hatch_mipmap_set_number(&map[0], HATCH_TAM_ATTR_WHOLE_TONES, tones, HATCH_ATTRIBUTE_INT);
    hatch_mipmap_set_number(&map[0], HATCH_TAM_ATTR_WHOLE_TONE, darkest, HATCH_ATTRIBUTE_FLOAT);
    if (tolerance >= 0)
        hatch_mipmap_set_number(&map[0], HATCH_TAM_ATTR_TOLERANCE, tolerance, HATCH_ATTRIBUTE_FLOAT);
}

static void save_wholes(const char *folder)
{
    set_whole(SIZE / 2, TONES, 1, 0.01);
    save(folder, "whole-is-smaller");
    set_whole(SIZE, TONES - 1, 1, 0.01);
    save(folder, "whole-has-fewer-tones");
    set_whole(SIZE, TONES + 1, 0.5, 0.01);
    save(folder, "whole-is-lighter");
    set_whole(SIZE, TONES + 1, 1, 2);
    save(folder, "tolerance-above-1");
    set_whole(SIZE, TONES + 1, 1, -1);
    save(folder, "no-tolerance");
}

static void save_pixels(const char *folder)
{
    map[2].levels[1].pixels[5] = NAN;
    save(folder, "pixel-nan");
    map[3].levels[0].pixels[7] = INFINITY;
    save(folder, "pixel-infinite");
    map[0].levels[4].pixels[0] = -INFINITY;
    save(folder, "last-pixel-infinite");
    make_map("RGB");
    map[1].levels[0].pixels[4] = NAN;
    save(folder, "colour-nan");
}

/* A stroke of column 1 is gone in column 2. */
static void save_broken_nesting(const char *folder)
{
    map[2].levels[1].pixels[3] = 1;
    save(folder, "nesting-broken");
    make_map("RGB");
    map[3].levels[0].pixels[4] = 1;
    save(folder, "nesting-broken-colour");
}

/* Writes parts of other sizes and channels with OpenEXR, because our writer refuses to. Flat parts of one pixel are
 * whole maps, as far as levels go. */
static void save_unequal(const char *folder, const char *name, int32_t size, const char *channel)
{
    char path[4096];
    exr_context_t context = NULL;
    snprintf(path, sizeof path, "%s/%s.exr", folder, name);
    int failed = exr_start_write(&context, path, EXR_WRITE_FILE_DIRECTLY, NULL);
    for (int part = 0; !failed && part < 2; part++) {
        int index;
        int32_t side = part ? size : 1;
        failed |= exr_add_part(context, part ? "tone.001" : "tone.000", EXR_STORAGE_SCANLINE, &index);
        failed |= exr_initialize_required_attr_simple(context, part, side, side, EXR_COMPRESSION_NONE);
        failed |= exr_add_channel(context, part, part ? channel : "Y", EXR_PIXEL_HALF, EXR_PERCEPTUALLY_LINEAR, 1, 1);
        failed |= exr_attr_set_float(context, part, HATCH_TAM_ATTR_TONE, part ? 1 : 0.5f);
    }
    failed |= exr_write_header(context);
    for (int part = 0; !failed && part < 2; part++)
        for (int32_t row = 0; row < (part ? size : 1); row++) {
            uint16_t paper[2] = {0x3c00, 0x3c00};
            failed |= exr_write_scanline_chunk(context, part, row, paper, (part ? (uint64_t)size : 1u) * sizeof *paper);
        }
    failed |= exr_finish(&context);
    if (failed) {
        fprintf(stderr, "maps: %s: not written\n", path);
        exit(1);
    }
}

int main(int argc, char **argv)
{
    if (argc != 2)
        return 2;
    hatch_arena_init(&arena, (size_t)1 << 28);
    make_map("Y");
    save(argv[1], "good");
    save_parts_missing(argv[1]);
    save_tones(argv[1]);
    save_counts(argv[1]);
    save_wholes(argv[1]);
    save_pixels(argv[1]);
    save_broken_nesting(argv[1]);
    save_unequal(argv[1], "sizes-unequal", 2, "Y");
    save_unequal(argv[1], "channels-unequal", 1, "Z");
    hatch_arena_free(&arena);
    return 0;
}
