#include "io/foreign/plugin.h"

#include <cstdio>
#include <exception>
#include <memory>
#include <string>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

namespace
{

/* The reader refers to the memory that it reads, and goes first. */
struct Image {
    Image(const uint8_t *data, size_t size) : memory(data, size)
    {
    }
    OIIO::Filesystem::IOMemReader memory;
    std::unique_ptr<OIIO::ImageInput> reader;
};

void say(const std::string &text, char *message, size_t size)
{
    std::string line = text.substr(0, text.find('\n'));
    std::snprintf(message, size, "%s", line.empty() ? "the image cannot be decoded" : line.c_str());
}

/* What stands behind the last dot: the name of a format. */
std::string ending(const char *name)
{
    std::string whole = name ? name : "";
    size_t dot = whole.find_last_of("./");
    bool has_ending = dot != std::string::npos && whole[dot] == '.';
    return has_ending ? OIIO::Strutil::lower(whole.substr(dot + 1)) : std::string();
}

bool is_encoded(const OIIO::ImageSpec &spec)
{
    if (spec.format.basetype != OIIO::TypeDesc::UINT8 && spec.format.basetype != OIIO::TypeDesc::UINT16)
        return false;
    return !OIIO::Strutil::iequals(spec.get_string_attribute("oiio:ColorSpace"), "linear");
}

void *open_image(const uint8_t *data, size_t data_size, const char *name, hatch_oiio_info *info, char *message,
                 size_t size)
{
    try {
        OIIO::attribute("threads", 1);
        OIIO::attribute("exr_threads", 1);
        OIIO::ImageSpec config;
        config.attribute("oiio:UnassociatedAlpha", 1);
        auto image = std::make_unique<Image>(data, data_size);
        std::string format = ending(name);
        image->reader = format.empty() ? nullptr : OIIO::ImageInput::create(format);
        if (!image->reader) {
            OIIO::geterror(); /* it speaks of files that this has nothing to do with */
            say("not an image of a known format, by its content and its name", message, size);
            return nullptr;
        }
        if (!image->reader->supports("ioproxy")) {
            say(std::string(image->reader->format_name()) + " files are not read; convert to PNG", message, size);
            return nullptr;
        }
        OIIO::Filesystem::IOProxy *proxy = &image->memory;
        config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
        image->reader->set_ioproxy(proxy);
        OIIO::ImageSpec opened;
        if (!image->reader->open("memory." + format, opened, config)) {
            say(image->reader->geterror(), message, size);
            return nullptr;
        }
        const OIIO::ImageSpec &spec = image->reader->spec();
        if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1) {
            say("not a picture of two dimensions", message, size);
            return nullptr;
        }
        *info = {static_cast<uint32_t>(spec.width), static_cast<uint32_t>(spec.height),
                 static_cast<uint32_t>(spec.nchannels), is_encoded(spec)};
        return image.release();
    } catch (const std::exception &fault) {
        say(fault.what(), message, size);
    } catch (...) {
        say("an unknown fault", message, size);
    }
    return nullptr;
}

int read_image(void *opened, float *pixels, char *message, size_t size)
{
    try {
        OIIO::ImageInput &reader = *static_cast<Image *>(opened)->reader;
        int channels = reader.spec().nchannels;
        bool done = reader.read_image(0, 0, 0, channels, OIIO::TypeFloat, pixels);
        std::string complaint = reader.geterror();
        if (done && complaint.empty())
            return 1;
        say(complaint, message, size);
    } catch (const std::exception &fault) {
        say(fault.what(), message, size);
    } catch (...) {
        say("an unknown fault", message, size);
    }
    return 0;
}

void close_image(void *opened)
{
    try {
        delete static_cast<Image *>(opened);
    } catch (...) {
        return; /* nothing is left to be done with it */
    }
}

const hatch_oiio_plugin table = {HATCH_OIIO_VERSION, open_image, read_image, close_image};

} // namespace

extern "C" const hatch_oiio_plugin *hatch_oiio_plugin_table(void)
{
    return &table;
}
