#define _GNU_SOURCE
#include "io/foreign/foreign.h"

#include <dlfcn.h>
#include <math.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "base/load.h"
#include "io/exr/exr.h"
#include "io/foreign/header.h"
#include "io/foreign/plugin.h"
#include "io/png/png.h"

#define SIDE_MAX (1u << 24)
#define SRGB_CODES 65536u
#define FRAME_PIXELS ((uint64_t)1 << 25) /* 8192 x 4096 */
#define PLUGIN_BYTES ((size_t)512 << 20) /* address space for the plugin, docs/notes/io.md */

static enum hatch_status check_size(const struct hatch_arena *arena, uint64_t width, uint64_t height, uint64_t channels,
                                    struct hatch_err *err)
{
    size_t available = arena->limit_bytes - arena->used_bytes;
    if (width > SIDE_MAX || height > SIDE_MAX || width * height > available / sizeof(float) / channels)
        return hatch_fail(err, HATCH_LIMIT, "%llux%llu pixels need more than the %zu bytes allowed",
                          (unsigned long long)width, (unsigned long long)height, available);
    return HATCH_OK;
}

/* Fails when the limit of address space (ulimit -v) leaves too little for the plugin: some of the libraries that it
 * needs end the process if they cannot start threads or have no memory. */
static enum hatch_status check_address_space(const char *plugin, struct hatch_err *err)
{
    void *loaded = dlopen(plugin, RTLD_NOW | RTLD_NOLOAD);
    if (loaded) {
        dlclose(loaded);
        return HATCH_OK;
    }
    void *range = mmap(NULL, PLUGIN_BYTES, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (range == MAP_FAILED)
        return hatch_fail(err, HATCH_LIMIT,
                          "neither PNG nor OpenEXR, and the plugin for other formats needs %zu MB of address space: "
                          "raise the limit (ulimit -v), or convert the image to PNG",
                          PLUGIN_BYTES >> 20);
    munmap(range, PLUGIN_BYTES);
    return HATCH_OK;
}

static enum hatch_status open_plugin(const char *path, const struct hatch_oiio_plugin **plugin, struct hatch_err *err)
{
    void *object;
    if (access(path, F_OK) != 0)
        return hatch_fail(err, HATCH_BAD_INPUT,
                          "neither PNG nor OpenEXR, and the plugin for other formats is missing: %s", path);
    HATCH_TRY(check_address_space(path, err));
    if (hatch_load(path, &object, err) != HATCH_OK)
        return hatch_fail_at(err, "neither PNG nor OpenEXR, and the plugin for other formats cannot be loaded: ");
    const struct hatch_oiio_plugin *(*table)(void) = NULL;
    void *symbol = dlsym(object, HATCH_OIIO_PLUGIN_TABLE);
    memcpy(&table, &symbol, sizeof table); /* ISO C has no cast from object to function pointers */
    if (!table || table()->version != HATCH_OIIO_VERSION)
        return hatch_fail(err, HATCH_BAD_INPUT, "%s belongs to another version of hatch; install both together", path);
    *plugin = table();
    return HATCH_OK;
}

/* Fails with the plugin's message: with HATCH_LIMIT when memory ran out, else with HATCH_BAD_INPUT. */
static enum hatch_status fail_plugin(const char *message, struct hatch_err *err)
{
    if (strcmp(message, HATCH_OIIO_OUT_OF_MEMORY) == 0)
        return hatch_fail(err, HATCH_LIMIT, "%s", message);
    return hatch_fail_quoting(err, HATCH_BAD_INPUT, message, "the picture cannot be read");
}

/* Decodes sRGB by table: the file's values have 8 or 16 bits, so each is a multiple of 1 / 65535, or was divided by
 * alpha; quotients are limited to 1. */
static enum hatch_status decode_srgb(struct hatch_arena *scratch, struct hatch_image *image, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    float *linear;
    HATCH_TRY(HATCH_ALLOC(scratch, &linear, SRGB_CODES, err));
    for (uint32_t code = 0; code < SRGB_CODES; code++)
        linear[code] = hatch_srgb_to_linear((float)code / (SRGB_CODES - 1));
    size_t texels = (size_t)image->width * image->height;
    uint32_t channels = image->channel_count, colors = channels - (channels % 2 == 0);
    for (size_t i = 0; i < texels; i++)
        for (uint32_t c = 0; c < colors; c++) {
            float *value = &image->pixels[i * channels + c];
            *value = linear[(uint32_t)(fminf(*value, 1) * (SRGB_CODES - 1) + 0.5f)];
        }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

/* Divides colours by alpha: those of OpenEXR files, for example, are multiplied by it. Where alpha is 0, colours are
 * light alone. */
static void divide_by_alpha(struct hatch_image *image)
{
    size_t texels = (size_t)image->width * image->height;
    uint32_t channels = image->channel_count, colors = channels - 1;
    for (size_t i = 0; i < texels; i++) {
        float *pixel = &image->pixels[i * channels], alpha = pixel[colors];
        for (uint32_t c = 0; c < colors && alpha > 0 && isfinite(alpha); c++)
            pixel[c] /= alpha;
    }
}

static enum hatch_status read_opened(const struct hatch_oiio_plugin *plugin, void *opened,
                                     const struct hatch_oiio_info *info, struct hatch_arena *arena,
                                     struct hatch_arena *scratch, struct hatch_image *image, struct hatch_err *err)
{
    static const char *const names[] = {"", "Y", "YA", "RGB", "RGBA"};
    char message[HATCH_ERR_TEXT_MAX] = "";
    if (info->channels > 4)
        return hatch_fail(err, HATCH_BAD_INPUT, "%u channels, want 1 to 4", info->channels);
    HATCH_TRY(check_size(arena, info->width, info->height, info->channels, err));
    struct hatch_image made;
    HATCH_TRY(hatch_image_make(arena, info->width, info->height, names[info->channels], &made, err));
    if (!plugin->read(opened, made.pixels, message, sizeof message))
        return fail_plugin(message, err);
    if (info->is_premultiplied && info->channels % 2 == 0)
        divide_by_alpha(&made); /* encoded colours, too, are multiplied as they are in the file */
    if (info->is_encoded)
        HATCH_TRY(decode_srgb(scratch, &made, err));
    *image = made;
    return HATCH_OK;
}

/* Reads an image by the plugin, without a look at its header.
 *   name  its extension selects the format */
static enum hatch_status read_by_plugin(struct hatch_bytes file, const char *name, const char *path,
                                        struct hatch_arena *arena, struct hatch_arena *scratch,
                                        struct hatch_image *image, struct hatch_err *err)
{
    const struct hatch_oiio_plugin *plugin = NULL;
    HATCH_TRY(open_plugin(path, &plugin, err));
    struct hatch_oiio_info info = {0};
    char message[HATCH_ERR_TEXT_MAX] = "";
    void *opened = plugin->open(file.data, file.size, name, &info, message, sizeof message);
    if (!opened)
        return fail_plugin(message, err);
    enum hatch_status status = read_opened(plugin, opened, &info, arena, scratch, image, err);
    plugin->close(opened);
    return status;
}

static enum hatch_status read_foreign(struct hatch_bytes file, const char *name, const char *path,
                                      struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_image *image,
                                      struct hatch_err *err)
{
    struct hatch_foreign_header header = {0};
    if (hatch_foreign_header_read(file, &header)) {
        HATCH_TRY(check_size(arena, header.width, header.height, 1, err));
        if (header.truncated)
            return hatch_fail(err, HATCH_BAD_INPUT, "truncated: the image has no end marker");
        name = header.extension; /* content takes precedence over the name */
    }
    return read_by_plugin(file, name, path, arena, scratch, image, err);
}

/* Copies the channels of colour and alpha; drops others, such as the ids of a map. */
static enum hatch_status copy_colors(const struct hatch_image *from, struct hatch_arena *arena,
                                     struct hatch_image *image, struct hatch_err *err)
{
    char names[8] = "";
    bool is_gray = hatch_image_channel(from, "Y") >= 0;
    bool has_alpha = hatch_image_channel(from, "A") >= 0;
    if (!is_gray && (hatch_image_channel(from, "R") < 0 || hatch_image_channel(from, "G") < 0 ||
                     hatch_image_channel(from, "B") < 0))
        return hatch_fail(err, HATCH_BAD_INPUT, "neither a channel Y nor channels R, G and B");
    strcat(names, is_gray ? "Y" : "RGB");
    strcat(names, has_alpha ? "A" : "");
    struct hatch_image made;
    HATCH_TRY(hatch_image_make(arena, from->width, from->height, names, &made, err));
    size_t texels = (size_t)from->width * from->height;
    for (uint32_t c = 0; c < made.channel_count; c++) {
        size_t source = (size_t)hatch_image_channel(from, made.channels[c].name);
        for (size_t i = 0; i < texels; i++)
            made.pixels[i * made.channel_count + c] = from->pixels[i * from->channel_count + source];
    }
    if (has_alpha)
        divide_by_alpha(&made);
    *image = made;
    return HATCH_OK;
}

/* Reads the pixels of an OpenEXR file; by the plugin if it is of a kind that hatch_exr_read refuses. If both fail, the
 * message is that of hatch_exr_read. */
static enum hatch_status read_exr_pixels(struct hatch_bytes file, const char *plugin, struct hatch_arena *arena,
                                         struct hatch_arena *scratch, struct hatch_image *image, struct hatch_err *err)
{
    struct hatch_mipmap *parts = NULL;
    uint32_t count = 0, width, height;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = hatch_exr_read(file, NULL, scratch, scratch, &parts, &count, err);
    if (status == HATCH_OK)
        status = copy_colors(&parts[0].levels[0], arena, image, err);
    hatch_arena_rewind(scratch, mark);
    if (status != HATCH_BAD_INPUT || !hatch_exr_is_other_kind(file, &width, &height))
        return status;
    HATCH_TRY(check_size(arena, width, height, 1, err));
    return read_by_plugin(file, ".exr", plugin, arena, scratch, image, NULL) == HATCH_OK ? HATCH_OK : status;
}

/* Places pixels in the picture that they belong to. Those outside are cut off, missing ones are 0. Fails for pictures
 * of a size that no such pixels need: a header of 300 bytes could ask for any amount of memory. */
static enum hatch_status place(const struct hatch_image *pixels, const struct hatch_exr_frame *frame,
                               struct hatch_arena *arena, struct hatch_image *image, struct hatch_err *err)
{
    struct hatch_image made = *pixels;
    uint64_t count = (uint64_t)pixels->width * pixels->height;
    if ((uint64_t)frame->width * frame->height > FRAME_PIXELS + 16 * count)
        return hatch_fail(err, HATCH_BAD_INPUT, "a display window of %ux%u pixels, of which the file holds %ux%u",
                          frame->width, frame->height, pixels->width, pixels->height);
    HATCH_TRY(check_size(arena, frame->width, frame->height, pixels->channel_count, err));
    made.width = frame->width;
    made.height = frame->height;
    HATCH_TRY(HATCH_ALLOC(arena, &made.pixels, (size_t)made.width * made.height * made.channel_count, err));
    int64_t first = frame->left > 0 ? frame->left : 0, end = frame->left + pixels->width;
    end = end < frame->width ? end : frame->width;
    for (int64_t y = 0; y < frame->height && first < end; y++) {
        int64_t row = y - frame->top;
        if (row < 0 || row >= pixels->height)
            continue;
        const float *from = pixels->pixels + (row * pixels->width + first - frame->left) * pixels->channel_count;
        memcpy(made.pixels + (y * frame->width + first) * made.channel_count, from,
               (size_t)(end - first) * made.channel_count * sizeof *from);
    }
    *image = made;
    return HATCH_OK;
}

/* Reads an OpenEXR file: its display window. */
static enum hatch_status read_exr(struct hatch_bytes file, const char *plugin, struct hatch_arena *arena,
                                  struct hatch_arena *scratch, struct hatch_image *image, struct hatch_err *err)
{
    struct hatch_exr_frame frame;
    struct hatch_image pixels;
    struct hatch_arena window;
    HATCH_TRY(hatch_exr_frame_read(file, &frame, err));
    if (frame.width == 0)
        return read_exr_pixels(file, plugin, arena, scratch, image, err);
    hatch_arena_init(&window, arena->limit_bytes);
    enum hatch_status status = read_exr_pixels(file, plugin, &window, scratch, &pixels, err);
    if (status == HATCH_OK)
        status = place(&pixels, &frame, arena, image, err);
    hatch_arena_free(&window);
    return status;
}

enum hatch_status hatch_image_read_any(struct hatch_bytes file, const char *name, const char *plugin,
                                       struct hatch_arena *arena, struct hatch_arena *scratch,
                                       struct hatch_image *image, struct hatch_err *err)
{
    static const uint8_t png[] = {0x89, 'P', 'N', 'G'};
    if (file.size < sizeof png)
        return hatch_fail(err, HATCH_BAD_INPUT, "%zu bytes: too short for an image", file.size);
    if (memcmp(file.data, png, sizeof png) == 0)
        return hatch_png_read(file, arena, scratch, image, err);
    struct hatch_arena_mark mark = hatch_arena_mark(arena);
    enum hatch_status status = hatch_exr_is(file) ? read_exr(file, plugin, arena, scratch, image, err)
                                                  : read_foreign(file, name, plugin, arena, scratch, image, err);
    if (status != HATCH_OK)
        hatch_arena_rewind(arena, mark);
    return status;
}
