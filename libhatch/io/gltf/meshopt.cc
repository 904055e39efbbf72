/* EXT_meshopt_compression: buffer views that are compressed by meshoptimizer. The specification of the extension is in
 * the Khronos registry of glTF extensions (2.0/Vendor/EXT_meshopt_compression). */
#include "io/gltf/reader.h"

#include <meshoptimizer.h>

namespace hatch
{

namespace
{

const char extension[] = "EXT_meshopt_compression";

/* A compressed view; numbers that the file leaves out, or that are none, are -1. */
struct Compressed {
    double buffer, offset, length, stride, count;
    std::string mode, filter;
};

/* Upper bound of the bytes that one compressed byte can stand for: of a vertex, a byte of the data of 64 vertices takes
 * at least 8 bits. */
const double growth_max = 64;

double number_in(const tinygltf::Value &object, const char *key, double missing)
{
    if (!object.Has(key))
        return missing;
    const tinygltf::Value &value = object.Get(key);
    return value.IsNumber() ? value.GetNumberAsDouble() : -1;
}

std::string word_in(const tinygltf::Value &object, const char *key, const char *missing)
{
    if (!object.Has(key))
        return missing;
    return object.Get(key).IsString() ? object.Get(key).Get<std::string>() : "";
}

enum hatch_status refuse(struct hatch_err *err, size_t view, const char *what)
{
    return hatch_fail(err, HATCH_BAD_INPUT, "buffer view %zu, %s: %s", view, extension, what);
}

/* Returns whether a number is an integer, least .. greatest. */
bool is_within(double number, double least, double greatest)
{
    return number >= least && number <= greatest && number == static_cast<double>(static_cast<uint64_t>(number));
}

bool fits_mode(const Compressed &c)
{
    bool indices = c.stride == 2 || c.stride == 4;
    if (c.mode == "ATTRIBUTES")
        return is_within(c.stride / 4, 1, 64);
    return indices && c.filter == "NONE" &&
           (c.mode == "INDICES" || (c.mode == "TRIANGLES" && is_within(c.count / 3, 0, INT32_MAX)));
}

bool fits_filter(const Compressed &c)
{
    return c.filter == "NONE" || c.filter == "EXPONENTIAL" || (c.filter == "QUATERNION" && c.stride == 8) ||
           (c.filter == "OCTAHEDRAL" && (c.stride == 4 || c.stride == 8));
}

/* Reads what the extension says of a view, and finds its compressed bytes. */
enum hatch_status read_compressed(const tinygltf::Model &model, size_t index, Compressed *c, struct hatch_bytes *bytes,
                                  struct hatch_err *err)
{
    const tinygltf::BufferView &view = model.bufferViews[index];
    const tinygltf::Value &object = view.extensions.at(extension);
    *c = {number_in(object, "buffer", -1),     number_in(object, "byteOffset", 0), number_in(object, "byteLength", -1),
          number_in(object, "byteStride", -1), number_in(object, "count", -1),     word_in(object, "mode", ""),
          word_in(object, "filter", "NONE")};
    double buffers = static_cast<double>(model.buffers.size());
    if (!is_within(c->buffer, 0, buffers - 1))
        return refuse(err, index, "its buffer does not exist");
    const std::vector<unsigned char> &data = model.buffers[static_cast<size_t>(c->buffer)].data;
    double size = static_cast<double>(data.size());
    if (!is_within(c->offset, 0, size) || !is_within(c->length, 1, size - c->offset))
        return refuse(err, index, "byteOffset and byteLength exceed its buffer");
    if (!is_within(c->count, 1, INT32_MAX) || !fits_mode(*c) || !fits_filter(*c))
        return refuse(err, index, "mode, filter, byteStride and count do not fit together");
    if (static_cast<double>(view.byteLength) != c->count * c->stride)
        return refuse(err, index, "count times byteStride is not the view's byteLength");
    if (c->count * c->stride > growth_max * c->length)
        return refuse(err, index, "it is too short for its count");
    *bytes = {data.data() + static_cast<size_t>(c->offset), static_cast<size_t>(c->length)};
    return HATCH_OK;
}

/* Decompresses a view. Returns whether its bytes are valid. */
bool decode(const Compressed &c, struct hatch_bytes bytes, unsigned char *to)
{
    size_t count = static_cast<size_t>(c.count), stride = static_cast<size_t>(c.stride);
    if (c.mode == "TRIANGLES")
        return meshopt_decodeIndexBuffer(to, count, stride, bytes.data, bytes.size) == 0;
    if (c.mode == "INDICES")
        return meshopt_decodeIndexSequence(to, count, stride, bytes.data, bytes.size) == 0;
    if (meshopt_decodeVertexBuffer(to, count, stride, bytes.data, bytes.size) != 0)
        return false;
    if (c.filter == "OCTAHEDRAL")
        meshopt_decodeFilterOct(to, count, stride);
    else if (c.filter == "QUATERNION")
        meshopt_decodeFilterQuat(to, count, stride);
    else if (c.filter == "EXPONENTIAL")
        meshopt_decodeFilterExp(to, count, stride);
    return true;
}

} // namespace

enum hatch_status expand_views(tinygltf::Model *model, const struct hatch_arena *limit, struct hatch_err *err)
{
    size_t total = 0;
    for (size_t i = 0; i < model->bufferViews.size(); i++) {
        tinygltf::BufferView &view = model->bufferViews[i];
        if (view.extensions.count(extension) == 0)
            continue;
        Compressed compressed;
        struct hatch_bytes bytes = {nullptr, 0};
        HATCH_TRY(read_compressed(*model, i, &compressed, &bytes, err));
        total += view.byteLength;
        if (total > limit->limit_bytes)
            return hatch_fail(err, HATCH_LIMIT, "its decompressed buffer views need more memory than the limit");
        tinygltf::Buffer whole;
        whole.data.resize(view.byteLength);
        if (!decode(compressed, bytes, whole.data.data()))
            return refuse(err, i, "its data are damaged");
        view.buffer = static_cast<int>(model->buffers.size());
        view.byteOffset = 0;
        model->buffers.push_back(std::move(whole));
    }
    return HATCH_OK;
}

} // namespace hatch
