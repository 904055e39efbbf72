#include "io/exr/exr.h"

#include <assert.h>
#include <stdatomic.h>
#include <string.h>

#include "io/exr/chunk.h"
#include "io/exr/zip.h"

#define CHUNK_OFFSET_BYTES 8u
#define UINT_MAX_EXACT 0x1p24f /* floats hold every integer up to this one */

struct reading {
    struct hatch_exr_stream stream;
    exr_context_t context;
    struct hatch_arena *arena, *scratch;
    struct hatch_err *err;
};

/* Size and format of a part, read from its header and checked. */
struct layout {
    const char *name;
    bool tiled;
    uint32_t width, height, level_count, channel_count;
    uint32_t pack_ratio;                /* upper bound of unpacked bytes per packed byte */
    uint32_t chunk_width, chunk_height; /* of a tile, or of the rows that are compressed together */
    int32_t top;                        /* y of the data window's first scanline */
    struct hatch_channel channels[HATCH_IMAGE_CHANNELS_MAX]; /* in image order */
    uint32_t image_channel[HATCH_IMAGE_CHANNELS_MAX];        /* [n]: index in an image of the file's n-th channel */
};

struct part {
    int number;
    struct layout layout;
    struct hatch_mipmap *mipmap;
};

static enum hatch_status bad(const struct reading *r, exr_result_t result)
{
    return hatch_exr_fail(&r->stream, result, HATCH_BAD_INPUT, r->err);
}

#define TRY_EXR(r, call)                                                                                               \
    do {                                                                                                               \
        exr_result_t try_result_ = (call);                                                                             \
        if (try_result_ != EXR_ERR_SUCCESS)                                                                            \
            return bad((r), try_result_);                                                                              \
    } while (0)

/* Finds the order of channels in an image. Files store them sorted by name (B, G, R); images list R, G, B, Y, A first,
 * then the others in file order. */
static void order_channels(const exr_attr_chlist_t *list, struct layout *layout)
{
    static const char *const colors[] = {"R", "G", "B", "Y", "A"};
    const uint32_t color_count = sizeof colors / sizeof *colors;
    uint32_t next = 0;
    for (uint32_t rank = 0; rank <= color_count; rank++)
        for (uint32_t i = 0; i < layout->channel_count; i++) {
            uint32_t color = 0;
            while (color < color_count && strcmp(list->entries[i].name.str, colors[color]) != 0)
                color++;
            if (color == rank)
                layout->image_channel[i] = next++;
        }
}

static enum hatch_status read_channels(const struct reading *r, int part, struct layout *layout)
{
    const exr_attr_chlist_t *list = NULL;
    TRY_EXR(r, exr_get_channels(r->context, part, &list));
    if (list->num_channels < 1 || list->num_channels > (int)HATCH_IMAGE_CHANNELS_MAX)
        return hatch_fail(r->err, HATCH_BAD_INPUT, "%d channels, want 1 to %u", list->num_channels,
                          HATCH_IMAGE_CHANNELS_MAX);
    layout->channel_count = (uint32_t)list->num_channels;
    order_channels(list, layout);
    for (uint32_t c = 0; c < layout->channel_count; c++) {
        const exr_attr_chlist_entry_t *entry = &list->entries[c];
        struct hatch_channel *channel = &layout->channels[layout->image_channel[c]];
        size_t length = strlen(entry->name.str);
        if (length == 0 || length >= HATCH_NAME_MAX)
            return hatch_fail(r->err, HATCH_BAD_INPUT, "channel name of %zu bytes, want 1 to %u", length,
                              HATCH_NAME_MAX - 1);
        memcpy(channel->name, entry->name.str, length + 1);
        channel->type = entry->pixel_type == EXR_PIXEL_HALF    ? HATCH_HALF
                        : entry->pixel_type == EXR_PIXEL_FLOAT ? HATCH_FLOAT
                                                               : HATCH_UINT;
        if (entry->x_sampling != 1 || entry->y_sampling != 1)
            return hatch_fail(r->err, HATCH_BAD_INPUT, "channel %s is sub-sampled, which is not supported",
                              channel->name);
    }
    return HATCH_OK;
}

static enum hatch_status read_levels(const struct reading *r, int part, struct layout *layout)
{
    exr_tile_level_mode_t mode = EXR_TILE_ONE_LEVEL;
    exr_tile_round_mode_t rounding = EXR_TILE_ROUND_DOWN;
    layout->level_count = 1;
    TRY_EXR(r,
            exr_get_tile_descriptor(r->context, part, &layout->chunk_width, &layout->chunk_height, &mode, &rounding));
    if (layout->chunk_width == 0 || layout->chunk_height == 0)
        return hatch_fail(r->err, HATCH_BAD_INPUT, "tile size is zero");
    if (mode == EXR_TILE_ONE_LEVEL)
        return HATCH_OK;
    if (mode != EXR_TILE_MIPMAP_LEVELS)
        return hatch_fail(r->err, HATCH_BAD_INPUT, "rip-maps are not supported");
    int32_t across = 0, down = 0;
    TRY_EXR(r, exr_get_tile_levels(r->context, part, &across, &down));
    for (int32_t level = 0; level < across; level++) {
        int32_t width = 0, height = 0;
        TRY_EXR(r, exr_get_level_sizes(r->context, part, level, level, &width, &height));
        if ((uint32_t)width != hatch_mip_size(layout->width, (uint32_t)level) ||
            (uint32_t)height != hatch_mip_size(layout->height, (uint32_t)level))
            return hatch_fail(r->err, HATCH_BAD_INPUT, "mip level %d is %dx%d: sizes must be rounded down", level,
                              width, height);
    }
    assert(across >= 1 && across <= (int32_t)HATCH_MIP_LEVELS_MAX); /* sides are limited, io/exr/stream.c */
    layout->level_count = (uint32_t)across;
    return HATCH_OK;
}

/* Sets pack_ratio, which bounds the pixels that a header may claim. RLE packs a run of 128 bytes into 2, deflate a
 * match of 258 bytes into 2 bits; PIZ stays below deflate. */
static enum hatch_status read_compression(const struct reading *r, int part, struct layout *layout)
{
    exr_compression_t compression = EXR_COMPRESSION_NONE;
    TRY_EXR(r, exr_get_compression(r->context, part, &compression));
    switch (compression) {
    case EXR_COMPRESSION_NONE:
        layout->pack_ratio = 1;
        return HATCH_OK;
    case EXR_COMPRESSION_RLE:
        layout->pack_ratio = 64;
        return HATCH_OK;
    case EXR_COMPRESSION_ZIPS:
    case EXR_COMPRESSION_ZIP:
    case EXR_COMPRESSION_PIZ:
        layout->pack_ratio = 1032;
        return HATCH_OK;
    default:
        return hatch_fail(r->err, HATCH_BAD_INPUT, "compression %d is lossy or unknown; use none, RLE, ZIP or PIZ",
                          (int)compression);
    }
}

/* Reads and checks a part's header. Allocates nothing: sizes are checked before the first allocation. */
static enum hatch_status read_layout(const struct reading *r, int part, struct layout *layout)
{
    exr_storage_t storage = EXR_STORAGE_SCANLINE;
    exr_attr_box2i_t window;
    TRY_EXR(r, exr_get_storage(r->context, part, &storage));
    if (storage != EXR_STORAGE_SCANLINE && storage != EXR_STORAGE_TILED)
        return hatch_fail(r->err, HATCH_BAD_INPUT, "deep data is not supported");
    layout->tiled = storage == EXR_STORAGE_TILED;
    if (exr_get_name(r->context, part, &layout->name) != EXR_ERR_SUCCESS || !layout->name)
        layout->name = "";
    if (strlen(layout->name) >= HATCH_NAME_MAX)
        return hatch_fail(r->err, HATCH_BAD_INPUT, "its name is longer than %u bytes", HATCH_NAME_MAX - 1);
    TRY_EXR(r, exr_get_data_window(r->context, part, &window));
    layout->top = window.min.y;
    layout->width = (uint32_t)((int64_t)window.max.x - window.min.x + 1);
    layout->height = (uint32_t)((int64_t)window.max.y - window.min.y + 1);
    HATCH_TRY(read_channels(r, part, layout));
    HATCH_TRY(read_compression(r, part, layout));
    if (layout->tiled)
        return read_levels(r, part, layout);
    int32_t rows = 0;
    TRY_EXR(r, exr_get_scanlines_per_chunk(r->context, part, &rows));
    assert(rows >= 1); /* a number of each compression */
    layout->level_count = 1;
    layout->chunk_width = layout->width;
    layout->chunk_height = (uint32_t)rows;
    return HATCH_OK;
}

/* Adds the bytes of the part's floats to *total. Fails when *total exceeds the arena's limit, or when the file is too
 * small to hold the part. */
static enum hatch_status check_size(const struct reading *r, int part, const struct layout *layout, uint64_t *total)
{
    uint64_t texels = 0, texel_bytes = 0;
    for (uint32_t c = 0; c < layout->channel_count; c++)
        texel_bytes += hatch_exr_channel_bytes(layout->channels[c].type);
    for (uint32_t level = 0; level < layout->level_count; level++)
        texels += (uint64_t)hatch_mip_size(layout->width, level) * hatch_mip_size(layout->height, level);
    int32_t chunks = 0;
    TRY_EXR(r, exr_get_chunk_count(r->context, part, &chunks));
    if (texels * texel_bytes / layout->pack_ratio > r->stream.file.size ||
        (uint64_t)chunks * CHUNK_OFFSET_BYTES > r->stream.file.size)
        return hatch_fail(r->err, HATCH_BAD_INPUT,
                          "%ux%u pixels in a file of %zu bytes: truncated, or the header is wrong", layout->width,
                          layout->height, r->stream.file.size);
    *total += texels * layout->channel_count * sizeof(float);
    size_t left = r->arena->limit_bytes - r->arena->used_bytes;
    if (*total > left)
        return hatch_fail(r->err, HATCH_LIMIT, "%ux%u pixels need more than the %zu bytes allowed", layout->width,
                          layout->height, left);
    return HATCH_OK;
}

/* Returns whether an attribute is kept: those of other programs would take the room of those of hatch. */
static bool is_wanted(const exr_attribute_t *attribute)
{
    static const char prefix[] = "hatch:";
    return strncmp(attribute->name, prefix, strlen(prefix)) == 0 && strlen(attribute->name) < HATCH_NAME_MAX &&
           (attribute->type == EXR_ATTR_FLOAT || attribute->type == EXR_ATTR_INT || attribute->type == EXR_ATTR_STRING);
}

static enum hatch_status read_attributes(const struct reading *r, int part, struct hatch_mipmap *mipmap)
{
    int32_t count = 0;
    TRY_EXR(r, exr_get_attribute_count(r->context, part, &count));
    for (int32_t i = 0; i < count; i++) {
        const exr_attribute_t *attribute = NULL;
        TRY_EXR(r, exr_get_attribute_by_index(r->context, part, EXR_ATTR_LIST_FILE_ORDER, i, &attribute));
        if (mipmap->attribute_count == HATCH_MIPMAP_ATTRIBUTES_MAX || !is_wanted(attribute))
            continue;
        if (attribute->type == EXR_ATTR_STRING) {
            const char *text =
                hatch_arena_text(r->arena, attribute->string->str, (size_t)attribute->string->length, r->err);
            if (!text)
                return HATCH_LIMIT;
            hatch_mipmap_set_text(mipmap, attribute->name, text);
        } else if (attribute->type == EXR_ATTR_INT) {
            hatch_mipmap_set_number(mipmap, attribute->name, attribute->i, HATCH_ATTRIBUTE_INT);
        } else {
            hatch_mipmap_set_number(mipmap, attribute->name, (double)attribute->f, HATCH_ATTRIBUTE_FLOAT);
        }
    }
    return HATCH_OK;
}

static enum hatch_status make_levels(const struct reading *r, const struct layout *layout, struct hatch_mipmap *mipmap)
{
    memcpy(mipmap->name, layout->name, strlen(layout->name) + 1);
    HATCH_TRY(HATCH_ALLOC(r->arena, &mipmap->levels, layout->level_count, r->err));
    mipmap->level_count = layout->level_count;
    for (uint32_t i = 0; i < layout->level_count; i++) {
        struct hatch_image *level = &mipmap->levels[i];
        level->width = hatch_mip_size(layout->width, i);
        level->height = hatch_mip_size(layout->height, i);
        level->channel_count = layout->channel_count;
        memcpy(level->channels, layout->channels, sizeof level->channels);
        size_t count = (size_t)level->width * level->height * level->channel_count;
        HATCH_TRY(HATCH_ALLOC_UNSET(r->arena, &level->pixels, count, r->err));
    }
    return HATCH_OK;
}

static uint32_t smaller(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

static enum hatch_status read_tiles(const struct reading *r, const struct layout *layout, struct hatch_mipmap *mipmap,
                                    struct hatch_exr_chunks *chunks)
{
    for (uint32_t l = 0; l < mipmap->level_count; l++) {
        struct hatch_image *image = &mipmap->levels[l];
        uint32_t width = layout->chunk_width, height = layout->chunk_height;
        for (uint32_t top = 0; top < image->height; top += height)
            for (uint32_t left = 0; left < image->width; left += width) {
                exr_chunk_info_t info;
                TRY_EXR(r, exr_read_tile_chunk_info(r->context, chunks->part, (int)(left / width), (int)(top / height),
                                                    (int)l, (int)l, &info));
                const struct hatch_exr_area area = {left, top, smaller(width, image->width - left),
                                                    smaller(height, image->height - top)};
                HATCH_TRY(hatch_exr_chunk_read(chunks, &info, &area, image, r->err));
            }
    }
    return HATCH_OK;
}

static enum hatch_status read_scanlines(const struct reading *r, const struct layout *layout, struct hatch_image *image,
                                        struct hatch_exr_chunks *chunks)
{
    uint32_t height = layout->chunk_height;
    for (uint32_t top = 0; top < image->height; top += height) {
        exr_chunk_info_t info;
        int y = (int)((int64_t)layout->top + top);
        TRY_EXR(r, exr_read_scanline_chunk_info(r->context, chunks->part, y, &info));
        const struct hatch_exr_area area = {0, top, image->width, smaller(height, image->height - top)};
        HATCH_TRY(hatch_exr_chunk_read(chunks, &info, &area, image, r->err));
    }
    return HATCH_OK;
}

/* Fails for integers above 2^24: UINT channels are floats in memory, which do not hold all larger integers. */
static enum hatch_status check_integers(const struct reading *r, const struct hatch_mipmap *mipmap)
{
    for (uint32_t l = 0; l < mipmap->level_count; l++) {
        const struct hatch_image *image = &mipmap->levels[l];
        size_t texels = (size_t)image->width * image->height;
        for (uint32_t c = 0; c < image->channel_count; c++)
            for (size_t i = 0; image->channels[c].type == HATCH_UINT && i < texels; i++)
                if (image->pixels[i * image->channel_count + c] > UINT_MAX_EXACT)
                    return hatch_fail(r->err, HATCH_BAD_INPUT, "channel %s has a value above 2^24",
                                      image->channels[c].name);
    }
    return HATCH_OK;
}

static enum hatch_status prepare_part(const struct reading *r, struct part *part)
{
    HATCH_TRY(read_layout(r, part->number, &part->layout));
    HATCH_TRY(read_attributes(r, part->number, part->mipmap));
    return make_levels(r, &part->layout, part->mipmap);
}

static size_t raw_bytes(const struct layout *layout)
{
    return (size_t)smaller(layout->chunk_width, layout->width) * smaller(layout->chunk_height, layout->height) *
           layout->channel_count * sizeof(float);
}

static enum hatch_status decode_part(const struct reading *r, const struct part *part)
{
    const struct layout *layout = &part->layout;
    struct hatch_arena_mark mark = hatch_arena_mark(r->scratch);
    struct hatch_exr_chunks chunks = {.stream = &r->stream,
                                      .context = r->context,
                                      .part = part->number,
                                      .raw_max = raw_bytes(layout),
                                      .image_channel = layout->image_channel};
    enum hatch_status status = hatch_exr_chunks_begin(&chunks, r->scratch, r->err);
    if (status == HATCH_OK)
        status = layout->tiled ? read_tiles(r, layout, part->mipmap, &chunks)
                               : read_scanlines(r, layout, &part->mipmap->levels[0], &chunks);
    hatch_exr_chunks_end(&chunks);
    hatch_arena_rewind(r->scratch, mark);
    return status == HATCH_OK ? check_integers(r, part->mipmap) : status;
}

static enum hatch_status check_parts(const struct reading *r, int count)
{
    uint64_t total = 0;
    for (int part = 0; part < count; part++) {
        struct layout layout = {0};
        enum hatch_status status = read_layout(r, part, &layout);
        if (status == HATCH_OK)
            status = check_size(r, part, &layout, &total);
        if (status != HATCH_OK)
            return hatch_fail_at(r->err, "part %d: ", part);
    }
    return HATCH_OK;
}

/* State of decoding the parts on several threads. Each thread opens its own context, since a context stores messages,
 * and has its own scratch arena. */
struct decoding {
    const struct reading *r;
    const struct part *parts;
    uint32_t count;
    atomic_uint next; /* index of the next part to decode */
    atomic_bool failed;
};

static void decode_on_thread(void *context, uint32_t thread)
{
    (void)thread;
    struct decoding *all = context;
    struct hatch_arena scratch;
    struct hatch_err err;
    struct reading own = {
        .stream = {.file = all->r->stream.file}, .arena = all->r->arena, .scratch = &scratch, .err = &err};
    if (hatch_exr_open_read(&own.stream, &own.context) != EXR_ERR_SUCCESS) {
        atomic_store(&all->failed, true);
        return;
    }
    hatch_arena_init(&scratch, all->r->scratch->limit_bytes);
    for (uint32_t at = atomic_fetch_add(&all->next, 1); at < all->count && !atomic_load(&all->failed);
         at = atomic_fetch_add(&all->next, 1))
        if (decode_part(&own, &all->parts[at]) != HATCH_OK)
            atomic_store(&all->failed, true);
    hatch_arena_free(&scratch);
    exr_finish(&own.context);
}

/* Decodes all parts. After a failure on any thread they are decoded again in order, so that the first error is
 * reported. */
static enum hatch_status decode_parts(const struct reading *r, struct hatch_pool *pool, const struct part *parts,
                                      uint32_t count)
{
    uint32_t threads = hatch_pool_threads(pool) < count ? hatch_pool_threads(pool) : count;
    if (threads > 1) {
        struct decoding all = {.r = r, .parts = parts, .count = count};
        hatch_parallel_for(pool, threads, decode_on_thread, &all);
        if (!atomic_load(&all.failed))
            return HATCH_OK;
    }
    for (uint32_t i = 0; i < count; i++)
        if (decode_part(r, &parts[i]) != HATCH_OK)
            return hatch_fail_at(r->err, "part %d: ", parts[i].number);
    return HATCH_OK;
}

static enum hatch_status read_parts(const struct reading *r, struct hatch_pool *pool, struct hatch_mipmap **mipmaps,
                                    uint32_t *part_count)
{
    int count = 0;
    TRY_EXR(r, exr_get_count(r->context, &count));
    HATCH_TRY(check_parts(r, count));
    struct hatch_mipmap *made;
    struct part *parts;
    HATCH_TRY(HATCH_ALLOC(r->arena, &made, (size_t)count, r->err));
    HATCH_TRY(HATCH_ALLOC(r->arena, &parts, (size_t)count, r->err));
    for (int part = 0; part < count; part++) {
        parts[part].number = part;
        parts[part].mipmap = &made[part];
        if (prepare_part(r, &parts[part]) != HATCH_OK)
            return hatch_fail_at(r->err, "part %d: ", part);
    }
    HATCH_TRY(decode_parts(r, pool, parts, (uint32_t)count));
    *mipmaps = made;
    *part_count = (uint32_t)count;
    return HATCH_OK;
}

bool hatch_exr_is(struct hatch_bytes file)
{
    static const uint8_t magic[] = {0x76, 0x2f, 0x31, 0x01};
    return file.size >= sizeof magic && memcmp(file.data, magic, sizeof magic) == 0;
}

enum hatch_status hatch_exr_read(struct hatch_bytes file, struct hatch_pool *pool, struct hatch_arena *arena,
                                 struct hatch_arena *scratch, struct hatch_mipmap **parts, uint32_t *part_count,
                                 struct hatch_err *err)
{
    struct hatch_err own;
    struct reading r = {.stream = {.file = file}, .arena = arena, .scratch = scratch, .err = err ? err : &own};
    if (!hatch_exr_is(file))
        return hatch_fail(r.err, HATCH_BAD_INPUT, file.size ? "not an OpenEXR file" : "empty");
    struct hatch_arena_mark mark = hatch_arena_mark(arena);
    exr_result_t result = hatch_exr_open_read(&r.stream, &r.context);
    if (result != EXR_ERR_SUCCESS)
        return bad(&r, result);
    enum hatch_status status = read_parts(&r, pool, parts, part_count);
    exr_finish(&r.context);
    if (status != HATCH_OK)
        hatch_arena_rewind(arena, mark);
    return status;
}
