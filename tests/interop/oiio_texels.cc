// oiio_texels FILE CHANNEL ...: prints the texels of an image as read by OpenImageIO: part after part, level after
// level, as floats, the channels in the given order.
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>

// One channel as floats. Integers keep their values, which OpenImageIO would scale to 0..1.
static bool read_channel(OIIO::ImageInput &input, int part, int level, int channel, std::vector<float> &values)
{
    OIIO::ImageSpec spec = input.spec(part, level);
    values.resize(size_t(spec.width) * size_t(spec.height));
    if (spec.channelformat(channel) != OIIO::TypeDesc::UINT)
        return input.read_image(part, level, channel, channel + 1, OIIO::TypeFloat, values.data());
    std::vector<uint32_t> whole(values.size());
    if (!input.read_image(part, level, channel, channel + 1, OIIO::TypeUInt32, whole.data()))
        return false;
    for (size_t i = 0; i < whole.size(); i++)
        values[i] = float(whole[i]);
    return true;
}

static bool write_level(OIIO::ImageInput &input, int part, int level, int count, char **names)
{
    std::vector<std::vector<float>> channels;
    channels.resize(size_t(count));
    for (size_t c = 0; c < channels.size(); c++) {
        int channel = input.spec(part, level).channelindex(names[c]);
        if (channel < 0 || !read_channel(input, part, level, channel, channels[c]))
            return false;
    }
    std::vector<float> texels;
    for (size_t i = 0; i < channels[0].size(); i++)
        for (const std::vector<float> &channel : channels)
            texels.push_back(channel[i]);
    return std::fwrite(texels.data(), sizeof(float), texels.size(), stdout) == texels.size();
}

int main(int argc, char **argv)
{
    auto input = argc > 2 ? OIIO::ImageInput::open(argv[1]) : nullptr;
    if (!input) {
        std::fprintf(stderr, "oiio_texels: %s\n", OIIO::geterror().c_str());
        return 3;
    }
    for (int part = 0; input->seek_subimage(part, 0); part++)
        for (int level = 0; input->seek_subimage(part, level); level++)
            if (!write_level(*input, part, level, argc - 2, argv + 2)) {
                std::fprintf(stderr, "oiio_texels: part %d level %d: %s\n", part, level, input->geterror().c_str());
                return 3;
            }
    return 0;
}
