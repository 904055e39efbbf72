#include "io/gltf/reader.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace hatch
{

namespace
{

/* The elements of an accessor, stride bytes apart. data is NULL when the accessor has no view; all its elements are
 * then zero. */
struct Elements {
    const uint8_t *data;
    size_t stride;
    int component_type, components;
    bool normalized;
    uint32_t count;
};

size_t component_size(int type)
{
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return 4;
    default:
        return 0;
    }
}

/* Locates the elements *e in a view, from byte offset on. The comparisons are ordered so that no sum overflows. */
enum hatch_status find_in_view(Reader &r, int view, size_t offset, const std::string &where, Elements *e)
{
    struct hatch_bytes bytes;
    size_t stride, element = component_size(e->component_type) * static_cast<size_t>(e->components);
    HATCH_TRY(find_view(r, view, where, &bytes, &stride));
    e->stride = stride ? stride : element;
    if (e->stride < element)
        return bad(r, where, "byteStride " + std::to_string(stride) + " is less than an element");
    if (offset > bytes.size || element > bytes.size - offset ||
        e->count - 1 > (bytes.size - offset - element) / e->stride)
        return bad(r, where,
                   std::to_string(e->count) + " elements from byte " + std::to_string(offset) +
                       " on exceed buffer view " + std::to_string(view));
    e->data = bytes.data + offset;
    return HATCH_OK;
}

enum hatch_status find_elements(Reader &r, int index, const std::string &where, Elements *e)
{
    if (index < 0 || static_cast<size_t>(index) >= r.model.accessors.size())
        return bad(r, where,
                   "accessor " + std::to_string(index) + " does not exist, there are " +
                       std::to_string(r.model.accessors.size()));
    const tinygltf::Accessor &a = r.model.accessors[static_cast<size_t>(index)];
    e->component_type = a.componentType;
    e->components = tinygltf::GetNumComponentsInType(static_cast<uint32_t>(a.type));
    e->normalized = a.normalized;
    e->data = nullptr;
    if (component_size(e->component_type) == 0 || e->components < 1)
        return bad(r, where, place("accessor", static_cast<size_t>(index)) + ": unknown type");
    if (a.count < 1 || a.count > INT32_MAX)
        return bad(r, where,
                   place("accessor", static_cast<size_t>(index)) + ": count " + std::to_string(a.count) +
                       ", want 1 to 2147483647");
    e->count = static_cast<uint32_t>(a.count);
    if (a.bufferView == -1)
        return HATCH_OK;
    return find_in_view(r, a.bufferView, a.byteOffset, where + ", accessor " + std::to_string(index), e);
}

template <typename T> T load_as(const uint8_t *at)
{
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

/* Converts one number of the file. Copies its bytes into the machine's numbers, so the machine must be little-endian,
 * as glTF is. */
double load_number(const uint8_t *at, int type, bool normalized)
{
    double value, range;
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        value = load_as<int8_t>(at), range = 127;
        break;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        value = load_as<uint8_t>(at), range = 255;
        break;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        value = load_as<int16_t>(at), range = 32767;
        break;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        value = load_as<uint16_t>(at), range = 65535;
        break;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        value = load_as<uint32_t>(at), range = 4294967295.0;
        break;
    default:
        return static_cast<double>(load_as<float>(at));
    }
    if (!normalized)
        return value;
    return value < -range ? -1 : value / range;
}

void load_element(const Elements &e, uint32_t i, float *out)
{
    size_t size = component_size(e.component_type);
    const uint8_t *at = e.data + i * e.stride;
    for (int c = 0; c < e.components; c++)
        out[c] = static_cast<float>(load_number(at + size * static_cast<size_t>(c), e.component_type, e.normalized));
}

/* Locates the indices and values of a sparse accessor. */
enum hatch_status find_sparse(Reader &r, const tinygltf::Accessor &a, const Elements &base, const std::string &where,
                              Elements *sparse_indices, Elements *sparse_values)
{
    Elements indices = base, values = base;
    if (a.sparse.count < 1 || static_cast<uint32_t>(a.sparse.count) > base.count)
        return bad(r, where,
                   "sparse count " + std::to_string(a.sparse.count) + ", want 1 to " + std::to_string(base.count));
    indices.count = values.count = static_cast<uint32_t>(a.sparse.count);
    indices.component_type = a.sparse.indices.componentType;
    indices.components = 1;
    indices.normalized = false;
    if (indices.component_type == TINYGLTF_COMPONENT_TYPE_FLOAT || component_size(indices.component_type) == 0)
        return bad(r, where, "sparse indices of an unknown type");
    HATCH_TRY(find_in_view(r, a.sparse.indices.bufferView, static_cast<size_t>(a.sparse.indices.byteOffset),
                           where + ", sparse indices", &indices));
    HATCH_TRY(find_in_view(r, a.sparse.values.bufferView, static_cast<size_t>(a.sparse.values.byteOffset),
                           where + ", sparse values", &values));
    for (uint32_t i = 0; i < indices.count; i++) {
        double index = load_number(indices.data + i * indices.stride, indices.component_type, false);
        if (!(index >= 0 && index < base.count))
            return bad(r, where,
                       "sparse index " + std::to_string(static_cast<int64_t>(index)) + " does not exist, there are " +
                           std::to_string(base.count) + " elements");
    }
    *sparse_indices = indices;
    *sparse_values = values;
    return HATCH_OK;
}

uint32_t load_index(const Elements &e, uint32_t i)
{
    return static_cast<uint32_t>(load_number(e.data + i * e.stride, e.component_type, false));
}

} // namespace

enum hatch_status find_view(Reader &r, int view, const std::string &where, struct hatch_bytes *bytes, size_t *stride)
{
    if (view < 0 || static_cast<size_t>(view) >= r.model.bufferViews.size())
        return bad(r, where,
                   "buffer view " + std::to_string(view) + " does not exist, there are " +
                       std::to_string(r.model.bufferViews.size()));
    const tinygltf::BufferView &v = r.model.bufferViews[static_cast<size_t>(view)];
    if (v.buffer < 0 || static_cast<size_t>(v.buffer) >= r.model.buffers.size())
        return bad(r, where,
                   "buffer " + std::to_string(v.buffer) + " does not exist, there are " +
                       std::to_string(r.model.buffers.size()));
    const std::vector<unsigned char> &data = r.model.buffers[static_cast<size_t>(v.buffer)].data;
    if (v.byteOffset > data.size() || v.byteLength > data.size() - v.byteOffset)
        return bad(r, where,
                   "buffer view " + std::to_string(view) + " exceeds its buffer of " + std::to_string(data.size()) +
                       " bytes");
    bytes->data = data.data() + v.byteOffset;
    bytes->size = v.byteLength;
    *stride = v.byteStride;
    return HATCH_OK;
}

enum hatch_status read_floats(Reader &r, int accessor, int components, const std::string &where, float **data,
                              uint32_t *count, const Range *range)
{
    Elements e;
    HATCH_TRY(find_elements(r, accessor, where, &e));
    if (e.components != components)
        return bad(r, where, std::to_string(e.components) + " components, want " + std::to_string(components));
    if (range && e.count != range->count)
        return bad(r, where, std::to_string(e.count) + " elements, POSITION has " + std::to_string(range->count));
    const uint32_t first = range ? range->first : 0, end = range ? range->end : e.count;
    size_t total = static_cast<size_t>(end - first) * static_cast<size_t>(components);
    float *floats = HATCH_NEW(r.arena, float, total, r.err);
    if (!floats)
        return HATCH_LIMIT;
    for (uint32_t i = first; e.data && i < end; i++)
        load_element(e, i, floats + (i - first) * static_cast<size_t>(components));
    const tinygltf::Accessor &a = r.model.accessors[static_cast<size_t>(accessor)];
    if (a.sparse.isSparse) {
        Elements indices, values;
        HATCH_TRY(find_sparse(r, a, e, where, &indices, &values));
        for (uint32_t i = 0; i < indices.count; i++) {
            uint32_t to = load_index(indices, i);
            if (to >= first && to < end)
                load_element(values, i, floats + (to - first) * static_cast<size_t>(components));
        }
    }
    for (size_t i = 0; i < total; i++)
        if (!std::isfinite(floats[i]) && r.replaced) {
            floats[i] = 0;
            ++*r.replaced;
        } else if (!std::isfinite(floats[i]))
            return bad(r, where, place("element", first + i / static_cast<size_t>(components)) + " is not finite");
    *data = floats;
    *count = end - first;
    return HATCH_OK;
}

enum hatch_status read_indices(Reader &r, int accessor, const std::string &where, uint32_t **data, uint32_t *count)
{
    Elements e;
    HATCH_TRY(find_elements(r, accessor, where, &e));
    uint32_t restart = e.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE    ? UINT8_MAX
                       : e.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? UINT16_MAX
                       : e.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT   ? UINT32_MAX
                                                                                    : 0;
    if (e.components != 1 || restart == 0 || e.normalized)
        return bad(r, where, "indices must be unsigned integers");
    uint32_t *indices = HATCH_NEW(r.scratch, uint32_t, e.count, r.err);
    if (!indices)
        return HATCH_LIMIT;
    for (uint32_t i = 0; e.data && i < e.count; i++)
        indices[i] = load_index(e, i);
    const tinygltf::Accessor &a = r.model.accessors[static_cast<size_t>(accessor)];
    if (a.sparse.isSparse) {
        Elements places, values;
        HATCH_TRY(find_sparse(r, a, e, where, &places, &values));
        for (uint32_t i = 0; i < places.count; i++)
            indices[load_index(places, i)] = load_index(values, i);
    }
    for (uint32_t i = 0; i < e.count; i++)
        if (indices[i] >= restart)
            return bad(r, where, place("index", i) + " is the primitive restart value");
    *data = indices;
    *count = e.count;
    return HATCH_OK;
}

} // namespace hatch
