#include "io/foreign/plugin.h"

#include <dlfcn.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/oiioversion.h>

namespace
{

/* An open image. reader refers to memory and so must be destroyed first; members are destroyed in reverse order. */
struct Image {
    Image(const uint8_t *data, size_t size) : memory(data, size)
    {
    }
    OIIO::Filesystem::IOMemReader memory;
    std::unique_ptr<OIIO::ImageInput> reader;
    int first_channel = 0, channels = 0; /* of the channels that are read */
};

/* Name by which readers that want one know the file in memory. */
const std::string name_in_memory = "memory.";

/* Replaces the name of the file in memory, which the user does not know. */
void set_message(const std::string &text, char *message, size_t size)
{
    std::string shown = text;
    for (size_t at; (at = shown.find(name_in_memory)) != std::string::npos;) {
        size_t end = at + name_in_memory.size();
        while (end < shown.size() && std::isalnum(static_cast<unsigned char>(shown[end])))
            end++;
        shown.replace(at, end - at, "the file");
    }
    std::snprintf(message, size, "%s", shown.c_str());
}

/* Returns the extension of a name without its dot, in lower case, or "". */
std::string extension_of(const char *name)
{
    std::string path = name ? name : "";
    size_t dot = path.find_last_of("./");
    bool has_extension = dot != std::string::npos && path[dot] == '.';
    return has_extension ? OIIO::Strutil::lower(path.substr(dot + 1)) : std::string();
}

/* Returns whether the size of tiles is plausible. OpenImageIO allocates a whole tile, however small the image is, so a
 * file of 200 bytes could ask for any amount of memory. Ordinary tiles have at most 2048 x 2048 pixels. */
bool tiles_are_plausible(const OIIO::ImageSpec &spec)
{
    const uint64_t ordinary_pixels = 1 << 22;
    uint64_t image_pixels = static_cast<uint64_t>(spec.width) * static_cast<uint64_t>(spec.height);
    return spec.tile_width == 0 || spec.tile_pixels() <= ordinary_pixels + 4 * image_pixels;
}

bool is_encoded(const OIIO::ImageSpec &spec)
{
    if (spec.format.basetype != OIIO::TypeDesc::UINT8 && spec.format.basetype != OIIO::TypeDesc::UINT16)
        return false;
    return !OIIO::Strutil::iequals(spec.get_string_attribute("oiio:ColorSpace"), "linear");
}

/* Returns whether colours are multiplied by alpha if there is one: in OpenEXR files always, in WebP and TIFF where the
 * reader does not say that it has left them as oiio:UnassociatedAlpha asks. That of WebP multiplies them in any case.
 */
bool is_premultiplied(const OIIO::ImageInput &reader)
{
    std::string format = reader.format_name();
    const OIIO::ImageSpec &spec = reader.spec();
    if (format == "webp" || format == "tiff")
        return spec.alpha_channel >= 0 && spec.get_int_attribute("oiio:UnassociatedAlpha") == 0;
    return format == "openexr";
}

/* Splits the name of a channel, "left.R", into its layer with the dot, and the rest. */
std::pair<std::string, std::string> split(const std::string &name)
{
    size_t dot = name.rfind('.');
    size_t layer = dot == std::string::npos ? 0 : dot + 1;
    return {name.substr(0, layer), name.substr(layer)};
}

/* Counts the names of a list that channels from one on have, all in one layer. */
int count_names(const OIIO::ImageSpec &spec, int first, const std::vector<std::string> &names)
{
    int count = 0;
    std::string layer = split(spec.channelnames[static_cast<size_t>(first)]).first;
    for (const std::string &name : names) {
        if (first + count == spec.nchannels || spec.channelnames[static_cast<size_t>(first + count)] != layer + name)
            break;
        count++;
    }
    return count;
}

/* Chooses the colours among the channels of an OpenEXR file, which OpenImageIO sorts by layer, colours first. Returns
 * false if there are none. */
bool choose_colors(Image &image)
{
    const OIIO::ImageSpec spec = image.reader->spec();
    for (int i = 0; i < spec.nchannels; i++) {
        int gray = count_names(spec, i, {"Y", "A"}), color = count_names(spec, i, {"R", "G", "B", "A"});
        image.first_channel = i;
        image.channels = color >= 3 ? color : gray;
        if (image.channels > 0)
            return true;
    }
    return false;
}

/* Returns the orientation of the pixels of a Radiance file, which those of other files have as they are stored: 1 as
 * they should be, 2 from right to left, 3 also from the bottom up, 4 from the bottom up only, 5 .. 8 column by column.
 */
int orientation_of(const OIIO::ImageInput &reader)
{
    return std::string(reader.format_name()) == "hdr" ? reader.spec().get_int_attribute("Orientation", 1) : 1;
}

/* Returns the reason why an image is not read, or "". Chooses the channels of an OpenEXR file. */
std::string fault_of(Image &image)
{
    const OIIO::ImageSpec &spec = image.reader->spec();
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1)
        return "not a two-dimensional image";
    if (!tiles_are_plausible(spec))
        return "tiles of " + std::to_string(spec.tile_width) + "x" + std::to_string(spec.tile_height) +
               " pixels, the image has " + std::to_string(spec.width) + "x" + std::to_string(spec.height);
    if (std::string(image.reader->format_name()) == "openexr" && !choose_colors(image))
        return "neither a channel Y nor channels R, G and B";
    if (orientation_of(*image.reader) > 4)
        return "its pixels are stored column by column (+X or -X first); store them row by row";
    return "";
}

/* Turns the pixels of a Radiance file the right way round. */
void turn(const Image &image, float *pixels)
{
    int orientation = orientation_of(*image.reader);
    bool upwards = orientation == 3 || orientation == 4, leftwards = orientation == 2 || orientation == 3;
    size_t width = static_cast<size_t>(image.reader->spec().width);
    size_t height = static_cast<size_t>(image.reader->spec().height), channels = static_cast<size_t>(image.channels);
    for (size_t y = 0; y < height && (upwards || leftwards); y++)
        for (size_t x = 0; x < width; x++) {
            size_t from = y * width + x;
            size_t to = (upwards ? height - 1 - y : y) * width + (leftwards ? width - 1 - x : x);
            if (from < to)
                std::swap_ranges(pixels + from * channels, pixels + (from + 1) * channels, pixels + to * channels);
        }
}

/* Since 2.5, OpenImageIO takes messages of libtiff, which it is linked to, per file; libtiff then prints them, too. */
void silence_libtiff()
{
#if OIIO_VERSION >= OIIO_MAKE_VERSION(2, 5, 0)
    using set_handler = void *(*)(void *);
    for (const char *name : {"TIFFSetErrorHandler", "TIFFSetWarningHandler"})
        if (auto set = reinterpret_cast<set_handler>(dlsym(RTLD_DEFAULT, name)))
            set(nullptr);
#endif
}

/* Says what the exception is that is being handled. A thread that cannot be started lacks room for its stack. */
void explain(char *message, size_t size)
{
    try {
        throw;
    } catch (const std::bad_alloc &) {
        set_message(HATCH_OIIO_OUT_OF_MEMORY, message, size);
    } catch (const std::system_error &error) {
        bool no_thread = error.code() == std::errc::resource_unavailable_try_again;
        set_message(no_thread ? HATCH_OIIO_OUT_OF_MEMORY : error.what(), message, size);
    } catch (const std::exception &error) {
        set_message(error.what(), message, size);
    } catch (...) {
        set_message("unknown error", message, size);
    }
}

void *open_image(const uint8_t *data, size_t data_size, const char *name, hatch_oiio_info *info, char *message,
                 size_t size)
{
    try {
        silence_libtiff();
        OIIO::attribute("threads", 1);
        OIIO::attribute("exr_threads", 1);
        OIIO::attribute("tiff:multithread", 0); /* the multithreaded reader ignores damaged tiles */
        OIIO::ImageSpec config;
        config.attribute("oiio:UnassociatedAlpha", 1);
        auto image = std::make_unique<Image>(data, data_size);
        std::string format = extension_of(name);
        image->reader = format.empty() ? nullptr : OIIO::ImageInput::create(format);
        if (!image->reader) {
            OIIO::geterror(); /* discarded: its text names files that do not matter here */
            set_message("not an image of a known format, neither by content nor by extension", message, size);
            return nullptr;
        }
        if (!image->reader->supports("ioproxy")) {
            set_message(std::string(image->reader->format_name()) + " files are not supported; convert to PNG", message,
                        size);
            return nullptr;
        }
        OIIO::Filesystem::IOProxy *proxy = &image->memory;
        config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
        image->reader->set_ioproxy(proxy);
        OIIO::ImageSpec opened;
        if (!image->reader->open(name_in_memory + format, opened, config)) {
            set_message(image->reader->geterror(), message, size);
            return nullptr;
        }
        const OIIO::ImageSpec &spec = image->reader->spec();
        image->channels = spec.nchannels;
        std::string fault = fault_of(*image);
        if (!fault.empty()) {
            set_message(fault, message, size);
            return nullptr;
        }
        *info = {static_cast<uint32_t>(spec.width), static_cast<uint32_t>(spec.height),
                 static_cast<uint32_t>(image->channels), is_encoded(spec), is_premultiplied(*image->reader)};
        return image.release();
    } catch (...) {
        explain(message, size);
    }
    return nullptr;
}

/* Reads the pixels row by row where possible, since read_image leaves damaged strips of deflated TIFF files black and
 * reports nothing. It reads tiles and separate planes at once: row by row, each strip of a separate plane would be
 * decoded again for every row. */
bool read_pixels(Image &image, float *pixels)
{
    OIIO::ImageInput &reader = *image.reader;
    const OIIO::ImageSpec spec = reader.spec();
    int first = image.first_channel, end = first + image.channels;
    if (spec.tile_width > 0 || spec.get_string_attribute("planarconfig") == "separate")
        return reader.read_image(0, 0, first, end, OIIO::TypeFloat, pixels);
    size_t row = static_cast<size_t>(spec.width) * static_cast<size_t>(image.channels);
    for (int y = spec.y; y < spec.y + spec.height; y++, pixels += row)
        if (!reader.read_scanlines(0, 0, y, y + 1, spec.z, first, end, OIIO::TypeFloat, pixels))
            return false;
    return true;
}

int read_image(void *opened, float *pixels, char *message, size_t size)
{
    try {
        Image &image = *static_cast<Image *>(opened);
        OIIO::ImageInput &reader = *image.reader;
        bool done = read_pixels(image, pixels);
        std::string error = reader.geterror();
        if (done && error.empty()) {
            turn(image, pixels);
            return 1;
        }
        set_message(error, message, size);
    } catch (...) {
        explain(message, size);
    }
    return 0;
}

void close_image(void *opened)
{
    try {
        delete static_cast<Image *>(opened);
    } catch (...) {
        return; /* no exception may leave the plugin */
    }
}

const hatch_oiio_plugin table = {HATCH_OIIO_VERSION, open_image, read_image, close_image};

} // namespace

extern "C" const hatch_oiio_plugin *hatch_oiio_plugin_table(void)
{
    return &table;
}
