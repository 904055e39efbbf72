#include "io/exr/exr.h"

#include <assert.h>
#include <libdeflate.h>
#include <stdatomic.h>
#include <string.h>

#include "io/exr/stream.h"
#include "io/exr/zip.h"

/* Chosen by measurements on tonal art maps: larger tiles hardly compress better, smaller tiles take longer. */
#define TILE_SIDE 256u
#define SCANLINES_PER_CHUNK 16u /* fixed by the format for ZIP */
#define ZIP_LEVEL 1
#define SHORT_NAME_MAX 31u

/* Buffers for compressing a part. They are reused, since allocating them for each part takes a tenth of the time. */
struct workspace {
    struct hatch_arena arena; /* holds the workspace itself, too */
    struct libdeflate_compressor *compressor;
    uint8_t *raw; /* room for three chunks: raw, filtered and compressed */
    struct hatch_buffer packed;
};
#define IDLE_MAX 16u

struct part {
    struct hatch_arena arena;  /* holds the members below; one per part, since threads add parts in parallel */
    struct hatch_mipmap label; /* name and attributes; levels is NULL */
    uint32_t *chunk_sizes;     /* in bytes, headers included */
    struct hatch_bytes packed; /* the chunks with their headers, as in the file */
};

/* The texels of one chunk: a tile, or a few whole rows. */
struct area {
    uint32_t level, x, y; /* x and y count chunks */
    uint32_t left, top, width, height;
};

struct hatch_exr_writer {
    uint32_t width, height, level_count, channel_count, chunk_count, part_count;
    uint32_t chunk_width, chunk_height;
    struct hatch_channel channels[HATCH_IMAGE_CHANNELS_MAX];
    uint32_t order[HATCH_IMAGE_CHANNELS_MAX]; /* [n]: index in an image of the file's n-th channel, sorted by name */
    struct part *parts;
    size_t limit_bytes;
    atomic_size_t packed_bytes;               /* of all parts together; at most limit_bytes */
    struct workspace *_Atomic idle[IDLE_MAX]; /* workspaces not in use, or NULL */
};

static uint32_t chunks_across(uint32_t size, uint32_t chunk)
{
    return (size + chunk - 1) / chunk;
}

static void sort_channels(struct hatch_exr_writer *writer)
{
    for (uint32_t i = 0; i < writer->channel_count; i++) {
        uint32_t at = i;
        for (; at > 0; at--) {
            uint32_t before = writer->order[at - 1];
            if (strcmp(writer->channels[before].name, writer->channels[i].name) < 0)
                break;
            writer->order[at] = before;
        }
        writer->order[at] = i;
    }
}

static void choose_chunks(struct hatch_exr_writer *writer)
{
    bool tiled = writer->level_count > 1;
    uint32_t width = writer->width, height = writer->height;
    writer->chunk_width = tiled && width > TILE_SIDE ? TILE_SIDE : width;
    writer->chunk_height = tiled ? (height > TILE_SIDE ? TILE_SIDE : height) : SCANLINES_PER_CHUNK;
    for (uint32_t level = 0; level < writer->level_count; level++)
        writer->chunk_count += chunks_across(hatch_mip_size(width, level), writer->chunk_width) *
                               chunks_across(hatch_mip_size(height, level), writer->chunk_height);
}

enum hatch_status hatch_exr_begin(const struct hatch_mipmap *base, uint32_t part_count, struct hatch_arena *arena,
                                  struct hatch_exr_writer **writer, struct hatch_err *err)
{
    const struct hatch_image *finest = &base->levels[0];
    assert(part_count > 0 && base->level_count > 0);
    assert(base->level_count == 1 || base->level_count == hatch_mip_chain_length(finest->width, finest->height));
    struct hatch_exr_writer *made;
    HATCH_TRY(HATCH_ALLOC(arena, &made, 1, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made->parts, part_count, err));
    made->width = finest->width;
    made->height = finest->height;
    made->level_count = base->level_count;
    made->channel_count = finest->channel_count;
    made->part_count = part_count;
    memcpy(made->channels, finest->channels, sizeof made->channels);
    sort_channels(made);
    choose_chunks(made);
    size_t available = arena->limit_bytes - arena->used_bytes;
    made->limit_bytes = available ? available : 1;
    atomic_init(&made->packed_bytes, 0);
    for (uint32_t i = 0; i < part_count; i++)
        hatch_arena_init(&made->parts[i].arena, made->limit_bytes);
    *writer = made;
    return HATCH_OK;
}

/* Advances to the next chunk in file order: by level, then row by row. Returns false after the last. */
static bool next_area(const struct hatch_exr_writer *writer, struct area *area)
{
    uint32_t width = hatch_mip_size(writer->width, area->level);
    uint32_t height = hatch_mip_size(writer->height, area->level);
    if (area->width && ++area->x == chunks_across(width, writer->chunk_width)) {
        area->x = 0;
        if (++area->y == chunks_across(height, writer->chunk_height)) {
            area->y = 0;
            if (++area->level == writer->level_count)
                return false;
            width = hatch_mip_size(writer->width, area->level);
            height = hatch_mip_size(writer->height, area->level);
        }
    }
    area->left = area->x * writer->chunk_width;
    area->top = area->y * writer->chunk_height;
    uint32_t right = width - area->left, below = height - area->top;
    area->width = right < writer->chunk_width ? right : writer->chunk_width;
    area->height = below < writer->chunk_height ? below : writer->chunk_height;
    return true;
}

/* Converts a row of values to the file's little-endian numbers. It copies the machine's numbers, so the machine must be
 * little-endian, too. */
static void put_row(const float *values, size_t stride, enum hatch_channel_type type, uint32_t count, uint8_t *out)
{
    if (type == HATCH_HALF) {
        hatch_halves_from_floats(values, stride, (uint16_t *)(void *)out, count);
        return;
    }
    for (uint32_t i = 0; i < count; i++) {
        float value = values[i * stride];
        uint32_t bits = 0;
        if (type == HATCH_FLOAT)
            memcpy(&bits, &value, sizeof bits);
        else {
            assert(value >= 0 && value <= 0x1p24f);
            bits = (uint32_t)value;
        }
        memcpy(out + 4 * (size_t)i, &bits, sizeof bits);
    }
}

/* Writes the texels of an area in the format's order: row by row, and within a row channel by channel. */
static size_t lay_out(const struct hatch_exr_writer *writer, const struct hatch_image *image, const struct area *area,
                      uint8_t *raw)
{
    uint8_t *at = raw;
    size_t stride = image->channel_count;
    for (uint32_t row = 0; row < area->height; row++) {
        const float *first = image->pixels + ((size_t)(area->top + row) * image->width + area->left) * stride;
        for (uint32_t i = 0; i < writer->channel_count; i++) {
            uint32_t c = writer->order[i];
            put_row(first + c, stride, writer->channels[c].type, area->width, at);
            at += hatch_exr_channel_bytes(writer->channels[c].type) * area->width;
        }
    }
    return (size_t)(at - raw);
}

static void free_workspace(struct workspace *work)
{
    if (!work)
        return;
    struct hatch_arena arena = work->arena;
    libdeflate_free_compressor(work->compressor);
    hatch_arena_free(&arena);
}

static void free_workspaces(struct hatch_exr_writer *writer)
{
    for (uint32_t i = 0; writer && i < IDLE_MAX; i++)
        free_workspace(atomic_exchange(&writer->idle[i], NULL));
}

static size_t chunk_bytes(const struct hatch_exr_writer *writer)
{
    size_t texel = 0;
    for (uint32_t c = 0; c < writer->channel_count; c++)
        texel += hatch_exr_channel_bytes(writer->channels[c].type);
    return texel * writer->chunk_width * writer->chunk_height;
}

static enum hatch_status make_workspace(const struct hatch_exr_writer *writer, struct workspace **work,
                                        struct hatch_err *err)
{
    struct hatch_arena arena;
    hatch_arena_init(&arena, writer->limit_bytes);
    struct workspace *made = HATCH_NEW(&arena, struct workspace, 1, err);
    uint8_t *raw = made ? HATCH_NEW_UNSET(&arena, uint8_t, 3 * chunk_bytes(writer), err) : NULL;
    struct libdeflate_compressor *compressor = raw ? libdeflate_alloc_compressor(ZIP_LEVEL) : NULL;
    if (!compressor) {
        enum hatch_status status = raw ? hatch_fail(err, HATCH_LIMIT, "out of memory for compression") : HATCH_LIMIT;
        hatch_arena_free(&arena);
        return status;
    }
    *made = (struct workspace){.arena = arena, .compressor = compressor, .raw = raw};
    made->packed.arena = &made->arena;
    *work = made;
    return HATCH_OK;
}

static enum hatch_status take_workspace(struct hatch_exr_writer *writer, struct workspace **work, struct hatch_err *err)
{
    for (uint32_t i = 0; i < IDLE_MAX; i++)
        if ((*work = atomic_exchange(&writer->idle[i], NULL)))
            return HATCH_OK;
    return make_workspace(writer, work, err);
}

static void give_workspace_back(struct hatch_exr_writer *writer, struct workspace *work)
{
    work->packed.size = 0;
    for (uint32_t i = 0; work && i < IDLE_MAX; i++)
        work = atomic_exchange(&writer->idle[i], work);
    free_workspace(work);
}

/* Adds what comes before a chunk's data: part, coordinates and size in bytes ("OpenEXR File Layout", Chunk Layout). */
static enum hatch_status add_chunk_header(const struct hatch_exr_writer *writer, uint32_t part, const struct area *area,
                                          size_t size, struct hatch_buffer *out, struct hatch_err *err)
{
    if (writer->part_count > 1)
        HATCH_TRY(hatch_buffer_add_u32le(out, part, err));
    if (writer->level_count > 1) {
        const uint32_t coordinates[] = {area->x, area->y, area->level, area->level};
        for (uint32_t i = 0; i < 4; i++)
            HATCH_TRY(hatch_buffer_add_u32le(out, coordinates[i], err));
    } else {
        HATCH_TRY(hatch_buffer_add_u32le(out, area->top, err));
    }
    return hatch_buffer_add_u32le(out, (uint32_t)size, err);
}

static enum hatch_status pack_chunks(struct hatch_exr_writer *writer, uint32_t part, const struct hatch_mipmap *mipmap,
                                     struct workspace *work, struct hatch_err *err)
{
    size_t raw_size = chunk_bytes(writer);
    uint8_t *filtered = work->raw + raw_size, *zipped = work->raw + 2 * raw_size;
    struct area area = {0};
    for (uint32_t chunk = 0; next_area(writer, &area); chunk++) {
        size_t size = lay_out(writer, &mipmap->levels[area.level], &area, work->raw), before = work->packed.size;
        size = hatch_exr_zip(work->compressor, work->raw, size, filtered, zipped);
        HATCH_TRY(add_chunk_header(writer, part, &area, size, &work->packed, err));
        HATCH_TRY(hatch_buffer_add(&work->packed, zipped, size, err));
        writer->parts[part].chunk_sizes[chunk] = (uint32_t)(work->packed.size - before);
    }
    return HATCH_OK;
}

static enum hatch_status keep_label(struct part *part, const struct hatch_mipmap *mipmap, struct hatch_err *err)
{
    part->label = *mipmap;
    part->label.levels = NULL;
    for (uint32_t i = 0; i < mipmap->attribute_count; i++) {
        struct hatch_attribute *attribute = &part->label.attributes[i];
        if (attribute->type != HATCH_ATTRIBUTE_TEXT)
            continue;
        attribute->text = hatch_arena_text(&part->arena, attribute->text, strlen(attribute->text), err);
        if (!attribute->text)
            return HATCH_LIMIT;
    }
    return HATCH_OK;
}

static enum hatch_status add_part(struct hatch_exr_writer *writer, uint32_t index, const struct hatch_mipmap *mipmap,
                                  struct workspace *work, struct hatch_err *err)
{
    struct part *part = &writer->parts[index];
    HATCH_TRY(keep_label(part, mipmap, err));
    HATCH_TRY(HATCH_ALLOC(&part->arena, &part->chunk_sizes, writer->chunk_count, err));
    HATCH_TRY(pack_chunks(writer, index, mipmap, work, err));
    size_t size = work->packed.size;
    if (atomic_fetch_add(&writer->packed_bytes, size) + size > writer->limit_bytes)
        return hatch_fail(err, HATCH_LIMIT, "compressed images exceed the memory limit of %zu bytes",
                          writer->limit_bytes);
    uint8_t *packed;
    HATCH_TRY(HATCH_ALLOC_UNSET(&part->arena, &packed, size, err));
    part->packed = (struct hatch_bytes){memcpy(packed, work->packed.data, size), size};
    return HATCH_OK;
}

enum hatch_status hatch_exr_add_part(struct hatch_exr_writer *writer, uint32_t part, const struct hatch_mipmap *mipmap,
                                     struct hatch_err *err)
{
    assert(part < writer->part_count && !writer->parts[part].packed.data);
    assert(mipmap->level_count == writer->level_count);
    assert(mipmap->levels[0].width == writer->width && mipmap->levels[0].height == writer->height);
    assert(mipmap->levels[0].channel_count == writer->channel_count);
    struct workspace *work;
    HATCH_TRY(take_workspace(writer, &work, err));
    enum hatch_status status = add_part(writer, part, mipmap, work, err);
    give_workspace_back(writer, work);
    return status;
}

static const exr_pixel_type_t pixel_types[] = {
    [HATCH_HALF] = EXR_PIXEL_HALF, [HATCH_FLOAT] = EXR_PIXEL_FLOAT, [HATCH_UINT] = EXR_PIXEL_UINT};

static exr_result_t declare_attribute(exr_context_t context, int index, const struct hatch_attribute *attribute)
{
    switch (attribute->type) {
    case HATCH_ATTRIBUTE_FLOAT:
        return exr_attr_set_float(context, index, attribute->name, (float)attribute->number);
    case HATCH_ATTRIBUTE_INT:
        return exr_attr_set_int(context, index, attribute->name, (int32_t)attribute->number);
    case HATCH_ATTRIBUTE_TEXT:
        break;
    }
    return exr_attr_set_string(context, index, attribute->name, attribute->text);
}

static exr_result_t declare_part(const struct hatch_exr_writer *writer, const struct part *part, exr_context_t context)
{
    bool tiled = writer->level_count > 1;
    int index = 0;
    exr_result_t result =
        exr_add_part(context, part->label.name, tiled ? EXR_STORAGE_TILED : EXR_STORAGE_SCANLINE, &index);
    if (result == EXR_ERR_SUCCESS)
        result = exr_initialize_required_attr_simple(context, index, (int32_t)writer->width, (int32_t)writer->height,
                                                     EXR_COMPRESSION_ZIP);
    if (result == EXR_ERR_SUCCESS && tiled)
        result = exr_set_tile_descriptor(context, index, writer->chunk_width, writer->chunk_height,
                                         EXR_TILE_MIPMAP_LEVELS, EXR_TILE_ROUND_DOWN);
    for (uint32_t i = 0; result == EXR_ERR_SUCCESS && i < writer->channel_count; i++) {
        const struct hatch_channel *channel = &writer->channels[writer->order[i]];
        result = exr_add_channel(context, index, channel->name, pixel_types[channel->type],
                                 EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1);
    }
    for (uint32_t i = 0; result == EXR_ERR_SUCCESS && i < part->label.attribute_count; i++)
        result = declare_attribute(context, index, &part->label.attributes[i]);
    return result;
}

static bool has_long_names(const struct hatch_exr_writer *writer)
{
    bool is_long = false;
    for (uint32_t c = 0; c < writer->channel_count; c++)
        is_long |= strlen(writer->channels[c].name) > SHORT_NAME_MAX;
    for (uint32_t i = 0; i < writer->part_count; i++)
        for (uint32_t a = 0; a < writer->parts[i].label.attribute_count; a++)
            is_long |= strlen(writer->parts[i].label.attributes[a].name) > SHORT_NAME_MAX;
    return is_long;
}

static exr_result_t write_header(struct hatch_exr_writer *writer, exr_context_t context)
{
    exr_result_t result = EXR_ERR_SUCCESS;
    if (has_long_names(writer))
        result = exr_set_longname_support(context, 1);
    for (uint32_t i = 0; result == EXR_ERR_SUCCESS && i < writer->part_count; i++)
        result = declare_part(writer, &writer->parts[i], context);
    return result == EXR_ERR_SUCCESS ? exr_write_header(context) : result;
}

/* Adds the file's table of chunk offsets. */
static enum hatch_status add_offsets(const struct hatch_exr_writer *writer, struct hatch_buffer *head,
                                     struct hatch_err *err)
{
    uint64_t offset = head->size + (uint64_t)writer->part_count * writer->chunk_count * sizeof offset;
    for (uint32_t i = 0; i < writer->part_count; i++)
        for (uint32_t chunk = 0; chunk < writer->chunk_count; chunk++) {
            HATCH_TRY(hatch_buffer_add_u64le(head, offset, err));
            offset += writer->parts[i].chunk_sizes[chunk];
        }
    return HATCH_OK;
}

static enum hatch_status make_head(struct hatch_exr_writer *writer, struct hatch_buffer *head, struct hatch_err *err)
{
    struct hatch_exr_stream stream = {.buffer = head};
    exr_context_t context = NULL;
    exr_result_t result = hatch_exr_open_write(&stream, &context);
    if (result == EXR_ERR_SUCCESS) {
        result = write_header(writer, context);
        size_t size = head->size;
        exr_finish(&context); /* reports an error, since no chunk was written; bytes that it adds are dropped */
        head->size = size;
    }
    if (result != EXR_ERR_SUCCESS)
        return hatch_exr_fail(&stream, result, HATCH_IO, err);
    return add_offsets(writer, head, err);
}

enum hatch_status hatch_exr_pieces(struct hatch_exr_writer *writer, struct hatch_buffer *head,
                                   struct hatch_bytes *pieces, struct hatch_err *err)
{
    assert(head->size == 0);
    free_workspaces(writer);
    for (uint32_t i = 0; i < writer->part_count; i++) {
        assert(writer->parts[i].packed.data);
        pieces[i] = writer->parts[i].packed;
    }
    enum hatch_status status = make_head(writer, head, err);
    if (status != HATCH_OK)
        head->size = 0;
    return status;
}

static enum hatch_status join(struct hatch_exr_writer *writer, struct hatch_buffer *file, struct hatch_err *err)
{
    struct hatch_bytes *pieces;
    HATCH_TRY(HATCH_ALLOC(file->arena, &pieces, writer->part_count, err));
    size_t overhead = (size_t)writer->part_count * (writer->chunk_count * sizeof(uint64_t) + 1024u);
    HATCH_TRY(hatch_buffer_reserve(file, writer->packed_bytes + overhead, err));
    HATCH_TRY(hatch_exr_pieces(writer, file, pieces, err));
    for (uint32_t i = 0; i < writer->part_count; i++) {
        HATCH_TRY(hatch_buffer_add(file, pieces[i].data, pieces[i].size, err));
        hatch_arena_free(&writer->parts[i].arena);
    }
    return HATCH_OK;
}

enum hatch_status hatch_exr_end(struct hatch_exr_writer *writer, struct hatch_buffer *file, struct hatch_err *err)
{
    enum hatch_status status = join(writer, file, err);
    if (status != HATCH_OK)
        file->size = 0;
    hatch_exr_abandon(writer);
    return status;
}

void hatch_exr_abandon(struct hatch_exr_writer *writer)
{
    for (uint32_t i = 0; writer && i < writer->part_count; i++)
        hatch_arena_free(&writer->parts[i].arena);
    free_workspaces(writer);
}

enum hatch_status hatch_exr_write(const struct hatch_mipmap *part, struct hatch_arena *scratch,
                                  struct hatch_buffer *file, struct hatch_err *err)
{
    struct hatch_exr_writer *writer;
    HATCH_TRY(hatch_exr_begin(part, 1, scratch, &writer, err));
    enum hatch_status status = hatch_exr_add_part(writer, 0, part, err);
    if (status == HATCH_OK)
        return hatch_exr_end(writer, file, err);
    hatch_exr_abandon(writer);
    return status;
}
