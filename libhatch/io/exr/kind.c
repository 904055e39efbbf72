/* Tells files that hatch_exr_read refuses although they are sound, and those whose pixels are not the whole picture. */
#include <string.h>

#include "io/exr/exr.h"
#include "io/exr/stream.h"

#define CHUNK_OFFSET_BYTES 8u

static bool has_channel(const exr_attr_chlist_t *list, const char *name)
{
    for (int c = 0; c < list->num_channels; c++)
        if (strcmp(list->entries[c].name.str, name) == 0)
            return true;
    return false;
}

static bool is_lossy(exr_compression_t compression)
{
    return compression == EXR_COMPRESSION_PXR24 || compression == EXR_COMPRESSION_B44 ||
           compression == EXR_COMPRESSION_B44A || compression == EXR_COMPRESSION_DWAA ||
           compression == EXR_COMPRESSION_DWAB;
}

/* Returns whether a part is of another kind than hatch_exr_read reads.
 *   bytes  of the file: a part whose table of chunks is larger is damaged */
static bool is_other(exr_const_context_t context, int part, size_t bytes)
{
    exr_compression_t compression = EXR_COMPRESSION_NONE;
    const exr_attr_chlist_t *list = NULL;
    int32_t chunks = 0;
    if (exr_get_compression(context, part, &compression) != EXR_ERR_SUCCESS ||
        exr_get_channels(context, part, &list) != EXR_ERR_SUCCESS ||
        exr_get_chunk_count(context, part, &chunks) != EXR_ERR_SUCCESS || (uint64_t)chunks * CHUNK_OFFSET_BYTES > bytes)
        return false;
    bool has_colors =
        has_channel(list, "Y") || (has_channel(list, "R") && has_channel(list, "G") && has_channel(list, "B"));
    return is_lossy(compression) || list->num_channels > (int)HATCH_IMAGE_CHANNELS_MAX || !has_colors;
}

/* Returns the number of rows that are compressed together; 1 in tiles, whose size the plugin checks. */
static uint32_t chunk_rows(exr_const_context_t context)
{
    exr_storage_t storage = EXR_STORAGE_TILED;
    int32_t rows = 1;
    if (exr_get_storage(context, 0, &storage) != EXR_ERR_SUCCESS || storage != EXR_STORAGE_SCANLINE ||
        exr_get_scanlines_per_chunk(context, 0, &rows) != EXR_ERR_SUCCESS)
        return 1;
    return (uint32_t)rows;
}

bool hatch_exr_is_other_kind(struct hatch_bytes file, uint32_t *width, uint32_t *height)
{
    struct hatch_exr_stream stream = {.file = file};
    exr_context_t context;
    exr_attr_box2i_t window;
    int count = 0;
    bool other = false;
    if (!hatch_exr_is(file) || hatch_exr_open_read(&stream, &context) != EXR_ERR_SUCCESS)
        return false;
    bool known = exr_get_count(context, &count) == EXR_ERR_SUCCESS &&
                 exr_get_data_window(context, 0, &window) == EXR_ERR_SUCCESS;
    for (int part = 0; part < count && known; part++)
        other |= is_other(context, part, file.size);
    if (known && other) {
        *width = (uint32_t)((int64_t)window.max.x - window.min.x + 1);
        uint32_t rows = chunk_rows(context), most = (uint32_t)((int64_t)window.max.y - window.min.y + 1);
        *height = (most + rows - 1) / rows * rows;
    }
    exr_finish(&context);
    return known && other;
}

enum hatch_status hatch_exr_frame_read(struct hatch_bytes file, struct hatch_exr_frame *frame, struct hatch_err *err)
{
    struct hatch_exr_stream stream = {.file = file};
    exr_context_t context;
    exr_attr_box2i_t data, display;
    exr_result_t result = hatch_exr_open_read(&stream, &context);
    if (result != EXR_ERR_SUCCESS)
        return hatch_exr_fail(&stream, result, HATCH_BAD_INPUT, err);
    result = exr_get_data_window(context, 0, &data);
    if (result == EXR_ERR_SUCCESS)
        result = exr_get_display_window(context, 0, &display);
    exr_finish(&context);
    if (result != EXR_ERR_SUCCESS)
        return hatch_exr_fail(&stream, result, HATCH_BAD_INPUT, err);
    *frame = (struct hatch_exr_frame){0};
    if (memcmp(&data, &display, sizeof data) != 0)
        *frame = (struct hatch_exr_frame){.width = (uint32_t)((int64_t)display.max.x - display.min.x + 1),
                                          .height = (uint32_t)((int64_t)display.max.y - display.min.y + 1),
                                          .left = (int64_t)data.min.x - display.min.x,
                                          .top = (int64_t)data.min.y - display.min.y};
    return HATCH_OK;
}
