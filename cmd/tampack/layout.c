#include "layout.h"

#include <stdio.h>

#include "shared/map.h"
#include "io/texture/container.h"
#include "io/exr/exr.h"
#include "io/png/png.h"
#include "tam/pack.h"

#define NUMBER_BYTES 16 /* room for " 0.123456789" and a terminating zero */

static uint32_t count_one(const struct hatch_tam *tam)
{
    (void)tam;
    return 1;
}

static uint32_t count_tones(const struct hatch_tam *tam)
{
    return tam->tones;
}

static uint32_t count_pictures(const struct hatch_tam *tam)
{
    return tam->tones * tam->columns[0].level_count;
}

static void suffix_index(const struct hatch_tam *tam, uint32_t index, char *suffix, size_t size)
{
    (void)tam;
    snprintf(suffix, size, ".%u", index);
}

static void suffix_tone(const struct hatch_tam *tam, uint32_t index, char *suffix, size_t size)
{
    (void)tam;
    snprintf(suffix, size, ".%03u", index);
}

static void suffix_picture(const struct hatch_tam *tam, uint32_t index, char *suffix, size_t size)
{
    uint32_t levels = tam->columns[0].level_count;
    snprintf(suffix, size, ".%03u.%02u", index / levels, index % levels);
}

/* Writes a texture with the metadata that a shader needs: the tones of the channels or layers, the number that stands
 * for ink, and the number of drawn levels. */
static enum hatch_status write_ktx2(const struct pack_job *job, uint32_t first, uint32_t count,
                                    const struct hatch_texels *texture, struct hatch_buffer *file,
                                    struct hatch_err *err)
{
    char tones[HATCH_TAM_TONES_MAX * NUMBER_BYTES] = "", levels[NUMBER_BYTES];
    int at = 0;
    for (uint32_t tone = first; tone < first + count && tone < job->tam.tones; tone++)
        at += snprintf(tones + at, sizeof tones - (size_t)at, "%s%.6g", at ? " " : "", (double)job->tam.target[tone]);
    snprintf(levels, sizeof levels, "%u", job->tam.levels);
    const char *seed = cmd_map_seed(&job->tam);
    const char *const pairs[] = {HATCH_TAM_ATTR_TONE,
                                 tones,
                                 HATCH_TAM_ATTR_LEVELS,
                                 levels,
                                 "hatch:ink",
                                 job->ink_is_one ? "1" : "0",
                                 seed ? HATCH_TAM_ATTR_SEED : NULL,
                                 seed,
                                 NULL};
    return hatch_ktx2_write(texture, pairs, file, err);
}

static enum hatch_status encode_rgb(const struct pack_job *job, uint32_t index, struct hatch_arena *scratch,
                                    struct hatch_buffer *file, struct hatch_err *err)
{
    const uint32_t tones = HATCH_PACK_TONES_PER_TEXTURE;
    struct hatch_texels texture;
    HATCH_TRY(hatch_tam_pack_rgb(&job->tam, index, job->ink_is_one, scratch, &texture, err));
    return write_ktx2(job, index * tones, tones, &texture, file, err);
}

static enum hatch_status encode_array(const struct pack_job *job, uint32_t index, struct hatch_arena *scratch,
                                      struct hatch_buffer *file, struct hatch_err *err)
{
    (void)index;
    struct hatch_texels texture;
    HATCH_TRY(hatch_tam_pack_array(&job->tam, job->ink_is_one, scratch, &texture, err));
    return write_ktx2(job, 0, job->tam.tones, &texture, file, err);
}

static enum hatch_status encode_dds(const struct pack_job *job, uint32_t index, struct hatch_arena *scratch,
                                    struct hatch_buffer *file, struct hatch_err *err)
{
    (void)index;
    struct hatch_texels texture;
    HATCH_TRY(hatch_tam_pack_array(&job->tam, job->ink_is_one, scratch, &texture, err));
    return hatch_dds_write(&texture, file, err);
}

static enum hatch_status encode_png(const struct pack_job *job, uint32_t index, struct hatch_arena *scratch,
                                    struct hatch_buffer *file, struct hatch_err *err)
{
    uint32_t levels = job->tam.columns[0].level_count;
    struct hatch_image picture = job->tam.columns[index / levels].levels[index % levels];
    struct hatch_image shown;
    HATCH_TRY(hatch_image_make(scratch, picture.width, picture.height, job->tam.color ? "RGB" : "Y", &shown, err));
    size_t texels = (size_t)picture.width * picture.height;
    for (size_t i = 0; i < texels; i++)
        for (uint32_t c = 0; c < shown.channel_count; c++) {
            float reflectance = picture.pixels[i * picture.channel_count + c];
            shown.pixels[i * shown.channel_count + c] = job->ink_is_one ? 1 - reflectance : reflectance;
        }
    return hatch_png_write(&shown, HATCH_PNG_SRGB, 8, job->comment, scratch, file, err);
}

static enum hatch_status encode_exr(const struct pack_job *job, uint32_t index, struct hatch_arena *scratch,
                                    struct hatch_buffer *file, struct hatch_err *err)
{
    return hatch_exr_write(&job->tam.columns[index], scratch, file, err);
}

const struct pack_layout pack_layouts[] = {
    {"rgb", ".ktx2", NULL, false, false, hatch_tam_rgb_count, suffix_index, encode_rgb},
    {"array", ".ktx2", "three.js reads a KTX2 array as a plain texture and Godot rejects it: see --layout rgb and dds",
     false, true, count_one, suffix_index, encode_array},
    {"dds", ".dds", NULL, false, true, count_one, suffix_index, encode_dds},
    {"png", ".png", "importers make their own mip levels, which thins the strokes: see --layout rgb", false, false,
     count_pictures, suffix_picture, encode_png},
    {"exr", ".exr", "three.js and most importers read the finest level only and make their own mip levels", true, false,
     count_tones, suffix_tone, encode_exr},
};
