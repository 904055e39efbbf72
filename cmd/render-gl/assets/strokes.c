/* Uploads maps with ids as lists of the strokes that cover each texel: integers in rows of ROW_WORDS, which shaders
 * fetch one by one.
 *
 *     0              unused
 *     1              width and height of the finest level, in texels
 *     2              number of drawn levels
 *     3              word at which the marks begin
 *     4 .. 7         unused
 *     8 ..           per level, the word at which its ends begin
 *     then the ends:  for each texel from the top row on, the number of its first mark; a last entry holds the end of
 *                     the last texel's marks
 *     then the marks: two words each, struct hatch_cover_mark of cover/cover.h */
#include <string.h>

#include "render-gl/assets/asset.h"
#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/gpu/texture.h"
#include "cover/cover.h"

#define ROW_WORDS (1u << LIST_ROW_BITS)
#define HEAD 8u
#define MARK_WORDS (sizeof(struct hatch_cover_mark) / sizeof(uint32_t))

static bool is_map_with_ids(const struct asset *asset)
{
    return asset_is_map(asset) && asset->map.ids && hatch_image_channel(asset->map.columns[0].levels, "t") >= 0;
}

static void fill(const struct asset *asset, const struct hatch_cover *cover, uint32_t *words)
{
    size_t ends = HEAD + cover->levels, marks = ends + cover->texel_count + 1;
    words[1] = asset->map.size_px;
    words[2] = cover->levels;
    words[3] = (uint32_t)marks;
    for (uint32_t level = 0; level < cover->levels; level++)
        words[HEAD + level] = (uint32_t)ends + cover->first[level];
    memcpy(words + ends, cover->ends, sizeof *words * ((size_t)cover->texel_count + 1));
    memcpy(words + marks, cover->marks, sizeof *cover->marks * cover->mark_count);
}

static enum hatch_status upload_cover(const struct asset *asset, const struct hatch_cover *cover, uint32_t size_max_px,
                                      struct hatch_arena *arena, struct asset_tones *tones, struct hatch_err *err)
{
    size_t count = HEAD + cover->levels + (size_t)cover->texel_count + 1 + MARK_WORDS * cover->mark_count;
    size_t rows = (count + ROW_WORDS - 1) / ROW_WORDS;
    uint32_t *words;
    if (rows > size_max_px)
        return hatch_fail(err, HATCH_LIMIT,
                          "the lists of the map's strokes have %zu rows, the GPU's limit is %u: use a smaller map",
                          rows, size_max_px);
    HATCH_TRY(HATCH_ALLOC(arena, &words, rows * ROW_WORDS, err));
    fill(asset, cover, words);
    tones->stroke_px = cover->width_px;
    tones->stroke_ink = cover->ink;
    tones->flat = asset->map.flat;
    tones->texture = gpu_texture_2d(GL_R32UI, ROW_WORDS, (uint32_t)rows);
    glTextureSubImage2D(tones->texture, 0, 0, 0, ROW_WORDS, (GLsizei)rows, GL_RED_INTEGER, GL_UNSIGNED_INT, words);
    return gpu_check_memory(err, "%zu rows of lists of strokes", rows);
}

static enum hatch_status upload(const struct asset *asset, uint32_t size_max_px, struct hatch_arena *scratch,
                                struct asset_tones *tones, struct hatch_err *err)
{
    struct hatch_arena arena; /* the lists are as large as what they are made from */
    struct hatch_cover cover;
    hatch_arena_init(&arena, scratch->limit_bytes);
    enum hatch_status status = hatch_cover_make(&asset->map, &asset->strokes, &arena, scratch, &cover, err);
    tones->exact = true;
    tones->count = asset->map.tones;
    memcpy(tones->targets, asset->map.target, sizeof *tones->targets * asset->map.tones);
    if (status == HATCH_OK)
        status = upload_cover(asset, &cover, size_max_px, &arena, tones, err);
    hatch_arena_free(&arena);
    return status;
}

const struct asset_kind asset_strokes = {"a tonal art map with ids (tamgen --ids makes one)", is_map_with_ids, upload};
