#include "io/gltf/reader.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <new>

namespace hatch
{

std::string place(const char *what, size_t index)
{
    return std::string(what) + " " + std::to_string(index);
}

std::string place(const char *what, size_t index, const char *part, size_t part_index)
{
    return place(what, index) + ", " + place(part, part_index);
}

enum hatch_status bad(Reader &r, const std::string &where, const std::string &what)
{
    return hatch_fail(r.err, HATCH_BAD_INPUT, "%s: %s", where.c_str(), what.c_str());
}

enum hatch_status check_index(Reader &r, int index, size_t count, const std::string &where, const char *what)
{
    if (index == -1 || (index >= 0 && static_cast<size_t>(index) < count))
        return HATCH_OK;
    return bad(r, where,
               std::string(what) + " " + std::to_string(index) + " does not exist, there are " + std::to_string(count));
}

namespace
{

/* State of tinygltf's file callbacks. */
struct Files {
    const struct hatch_gltf_resolver *resolver;
    struct hatch_arena *scratch;
    struct hatch_gltf_buffers buffers; /* tinygltf reads those that are files first, in this order */
    size_t next;                       /* offset in buffers.lengths of the next file's length */
    struct hatch_err err;              /* the first failure; more precise than tinygltf's message */
    bool left_folder;
};

/* Cuts a file to its buffer's length, since tinygltf refuses longer files. */
enum hatch_status fit_length(Files &files, const char *uri, struct hatch_bytes *bytes, struct hatch_err *err)
{
    uint64_t length;
    if (files.next + sizeof length > files.buffers.lengths.size)
        return HATCH_OK; /* the file is an image */
    std::memcpy(&length, files.buffers.lengths.data + files.next, sizeof length);
    files.next += sizeof length;
    if (bytes->size < length)
        return hatch_fail(err, HATCH_BAD_INPUT, "%.100s has %zu bytes, but its byteLength is %llu", uri, bytes->size,
                          static_cast<unsigned long long>(length));
    bytes->size = static_cast<size_t>(length);
    return HATCH_OK;
}

/* Reads a companion file. tinygltf decodes a plus to a space, as in forms, but in URIs it is a plus; so a name with
 * spaces is tried again with plus signs. */
enum hatch_status find_file(Files &files, const std::string &uri, struct hatch_bytes *bytes, struct hatch_err *err)
{
    enum hatch_status status = files.resolver->read(files.resolver->context, uri.c_str(), files.scratch, bytes, err);
    std::string plus = uri;
    for (char &c : plus)
        c = c == ' ' ? '+' : c;
    struct hatch_err ignored = {};
    if (status != HATCH_OK && plus != uri &&
        files.resolver->read(files.resolver->context, plus.c_str(), files.scratch, bytes, &ignored) == HATCH_OK)
        return HATCH_OK;
    return status;
}

bool file_exists(const std::string &, void *)
{
    return true;
}

std::string keep_path(const std::string &path, void *)
{
    return path;
}

enum hatch_status copy_bytes(struct hatch_bytes bytes, const std::string &uri, std::vector<unsigned char> *out,
                             struct hatch_err *err)
{
    try {
        out->assign(bytes.data, bytes.data + bytes.size);
    } catch (const std::bad_alloc &) {
        return hatch_fail(err, HATCH_LIMIT, "out of memory for the %zu bytes of %.100s", bytes.size, uri.c_str());
    }
    return HATCH_OK;
}

/* Decodes a URI that holds a file, of a media type that tinygltf does not know. It has decoded the URI's escapes, and
 * taken each + for a space.
 * Returns false if it is not in base 64. */
bool decode(const std::string &uri, std::vector<unsigned char> *out)
{
    const std::string mark = ";base64,";
    const size_t comma = uri.find(',');
    if (comma == std::string::npos || comma + 1 < mark.size() ||
        uri.compare(comma + 1 - mark.size(), mark.size(), mark) != 0)
        return false;
    std::string text = uri.substr(comma + 1);
    std::replace(text.begin(), text.end(), ' ', '+');
    std::string type;
    return tinygltf::DecodeDataURI(out, type, "data:application/octet-stream;base64," + text, 0, false);
}

bool read_file(std::vector<unsigned char> *out, std::string *, const std::string &uri, void *data)
{
    Files &files = *static_cast<Files *>(data);
    struct hatch_bytes bytes = {nullptr, 0};
    struct hatch_err err = {};
    if (uri.compare(0, 5, "data:") == 0) {
        try {
            if (decode(uri, out))
                return true;
            hatch_fail(&err, HATCH_BAD_INPUT, "uri %.40s: unknown media type", uri.c_str());
        } catch (const std::bad_alloc &) {
            hatch_fail(&err, HATCH_LIMIT, "out of memory for uri %.40s", uri.c_str());
        }
    } else if (!hatch_gltf_uri_is_local(uri.c_str())) {
        hatch_fail(&err, HATCH_BAD_INPUT, "uri %.100s is outside the file's folder", uri.c_str());
        files.left_folder = true;
    } else if (!files.resolver) {
        hatch_fail(&err, HATCH_BAD_INPUT,
                   "uri %.100s: not found, since the glTF comes from standard input: give its path instead",
                   uri.c_str());
    } else if (find_file(files, uri, &bytes, &err) == HATCH_OK &&
               fit_length(files, uri.c_str(), &bytes, &err) == HATCH_OK &&
               copy_bytes(bytes, uri, out, &err) == HATCH_OK) {
        return true;
    } else if (err.status != HATCH_LIMIT) {
        err.status = HATCH_BAD_INPUT; /* without its companion, a glTF is incomplete */
    }
    if (files.err.status == HATCH_OK || files.left_folder)
        files.err = err;
    return false;
}

/* tinygltf calls it never, but since 2.9 refuses callbacks of which one is missing. */
bool write_nothing(std::string *, const std::string &, const std::vector<unsigned char> &, void *)
{
    return false;
}

/* read_file checks the length, when it has the file. */
[[maybe_unused]] bool file_size(size_t *size, std::string *, const std::string &, void *)
{
    *size = 1;
    return true;
}

/* Sets the callback for a file's size, which tinygltf has since 2.9. Its argument 0 prefers the first function where
 * both can be compiled. */
template <class Callbacks>
auto set_file_size(Callbacks &callbacks, int) -> decltype(callbacks.GetFileSizeInBytes, void())
{
    callbacks.GetFileSizeInBytes = file_size;
}
template <class Callbacks> void set_file_size(Callbacks &, long)
{
}

tinygltf::FsCallbacks callbacks_for(Files &files)
{
    tinygltf::FsCallbacks callbacks = {};
    callbacks.FileExists = file_exists;
    callbacks.ExpandFilePath = keep_path;
    callbacks.ReadWholeFile = read_file;
    callbacks.WriteWholeFile = write_nothing;
    callbacks.user_data = &files;
    set_file_size(callbacks, 0);
    return callbacks;
}

/* Keeps an image encoded. Images in a buffer view are read from there later; others are copied here. */
bool keep_image(tinygltf::Image *image, const int, std::string *, std::string *, int, int, const unsigned char *bytes,
                int size, void *)
{
    if (image->bufferView == -1 && size > 0)
        image->image.assign(bytes, bytes + size);
    return true;
}

/* Translates a message of the parsers. That of nlohmann's for JSON reads "[json.exception.parse_error.101] parse error
 * at line 1, column 27: syntax error while parsing object key - unexpected '}'; expected string literal". */
enum hatch_status fail_with(const std::string &text, struct hatch_err *err)
{
    const std::string mark = "[json.exception.", place_mark = " at line ", reason_mark = " - ";
    if (text.compare(0, mark.size(), mark) != 0)
        return hatch_fail_quoting(err, HATCH_BAD_INPUT, text.c_str(), "not valid glTF");
    size_t place = text.find(place_mark), colon = text.find(':', place), reason = text.find(reason_mark, colon);
    if (place == std::string::npos || colon == std::string::npos)
        return hatch_fail(err, HATCH_BAD_INPUT, "not valid glTF: a value in the JSON has the wrong type");
    std::string where = text.substr(place + 4, colon - place - 4), what;
    if (reason != std::string::npos)
        what = text.substr(reason + reason_mark.size());
    return hatch_fail_quoting(err, HATCH_BAD_INPUT, what.substr(0, what.find(';')).c_str(), "JSON %s: not valid",
                              where.c_str());
}

enum hatch_status fail_memory(struct hatch_err *err)
{
    return hatch_fail(err, HATCH_LIMIT, "out of memory while parsing glTF");
}

bool parse_parts(tinygltf::TinyGLTF &parser, const struct hatch_gltf_parts &parts, tinygltf::Model *model,
                 std::string *err)
{
    std::string warnings;
    if (parts.binary.size == 0) /* tinygltf refuses a GLB with an empty binary chunk */
        return parser.LoadASCIIFromString(model, err, &warnings, reinterpret_cast<const char *>(parts.json.data),
                                          static_cast<unsigned int>(parts.json.size), "");
    return parser.LoadBinaryFromMemory(model, err, &warnings, parts.file.data,
                                       static_cast<unsigned int>(parts.file.size), "");
}

/* Adds the JSON of a file in which each fallback buffer is one of a single byte: tinygltf refuses buffers without data,
 * and their files need not be there. */
enum hatch_status add_json(const struct hatch_buffer &fallbacks, struct hatch_bytes json, struct hatch_buffer *to,
                           struct hatch_err *err)
{
    static const char one_byte[] = "{\"byteLength\":1,\"uri\":\"data:application/octet-stream;base64,AA==\"}";
    size_t from = 0;
    for (size_t i = 0; i < fallbacks.size; i += sizeof(struct hatch_gltf_range)) {
        struct hatch_gltf_range range;
        std::memcpy(&range, fallbacks.data + i, sizeof range);
        HATCH_TRY(hatch_buffer_add(to, json.data + from, range.start - from, err));
        HATCH_TRY(hatch_buffer_add(to, one_byte, sizeof one_byte - 1, err));
        from = range.end;
    }
    return hatch_buffer_add(to, json.data + from, json.size - from, err);
}

/* Replaces the fallback buffers of a file; its parts are then in scratch. */
enum hatch_status replace_fallbacks(const struct hatch_buffer &fallbacks, struct hatch_arena *scratch,
                                    struct hatch_gltf_parts *parts, struct hatch_err *err)
{
    struct hatch_buffer json = {}, file = {};
    json.arena = file.arena = scratch;
    HATCH_TRY(add_json(fallbacks, parts->json, &json, err));
    while (json.size % 4 != 0)
        HATCH_TRY(hatch_buffer_add(&json, " ", 1, err));
    parts->json = {json.data, json.size};
    if (parts->binary.size == 0)
        return HATCH_OK;
    HATCH_TRY(hatch_glb_add_container(parts->json, parts->binary.size, &file, err));
    std::memcpy(file.data + file.size - parts->binary.size, parts->binary.data, parts->binary.size);
    parts->file = {file.data, file.size};
    return HATCH_OK;
}

/* Upper bound of the memory that parsed JSON takes, in bytes per byte of text. */
const size_t json_growth = 32;

enum hatch_status load(struct hatch_bytes file, const struct hatch_gltf_resolver *resolver, struct hatch_arena *scratch,
                       tinygltf::Model *model, struct hatch_err *err)
{
    struct hatch_gltf_parts parts;
    if (file.size == 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "empty");
    HATCH_TRY(hatch_gltf_split(file, &parts, err));
    if (file.size > UINT32_MAX || parts.json.size > scratch->limit_bytes / json_growth)
        return hatch_fail(err, HATCH_LIMIT, "parsing %zu bytes of JSON needs more memory than the limit",
                          parts.json.size);
    Files files = {resolver, scratch, {}, 0, {}, false};
    files.buffers.lengths.arena = files.buffers.fallbacks.arena = scratch;
    HATCH_TRY(hatch_gltf_check_json(parts.json, &files.buffers, err));
    if (files.buffers.fallbacks.size > 0)
        HATCH_TRY(replace_fallbacks(files.buffers.fallbacks, scratch, &parts, err));
    tinygltf::TinyGLTF parser;
    parser.SetImageLoader(keep_image, nullptr);
    parser.SetStoreOriginalJSONForExtrasAndExtensions(true);
    parser.SetFsCallbacks(callbacks_for(files));
    std::string text;
    bool parsed = parse_parts(parser, parts, model, &text);
    /* An image that cannot be read may be missing, but not for lack of memory. */
    if (files.left_folder || files.err.status == HATCH_LIMIT || (!parsed && files.err.status != HATCH_OK))
        return hatch_fail(err, files.err.status, "%s", files.err.text);
    if (!parsed && text.find(std::bad_alloc().what()) != std::string::npos)
        return fail_memory(err); /* tinygltf passes on what the JSON parser throws as text */
    return parsed ? expand_views(model, scratch, err) : fail_with(text, err);
}

/* Fails when the transform of a node in the scene is not finite as floats: products of finite transforms may overflow.
 */
enum hatch_status check_transforms(Reader &r)
{
    size_t count = r.scene->node_count;
    double *world = HATCH_NEW(r.scratch, double, 16 * count, r.err);
    if (!world)
        return HATCH_LIMIT;
    hatch_scene_pose(r.scene, HATCH_NONE, 0, world);
    size_t at = 0;
    while (at < 16 * count && std::isfinite(static_cast<float>(world[at])))
        at++;
    if (at == 16 * count)
        return HATCH_OK;
    for (size_t i = 0; i < r.model.nodes.size(); i++)
        if (r.node_of[i] == at / 16)
            return bad(r, place("node", i), "its transform in the scene is not finite");
    return bad(r, "nodes", "the transform of an instance is not finite");
}

enum hatch_status read_all(Reader &r)
{
    if (r.model.asset.version.compare(0, 2, "2.") != 0)
        return bad(r, "asset", "glTF version " + r.model.asset.version + ", want 2");
    if (!r.model.asset.minVersion.empty() && r.model.asset.minVersion != "2.0")
        return bad(r, "asset", "needs glTF " + r.model.asset.minVersion + ", only 2.0 is supported");
    uint32_t *first_mesh;
    HATCH_TRY(keep(r, r.model.asset.copyright, r.model.asset.extras_json_string, "hatch", &r.scene->asset));
    HATCH_TRY(read_nodes(r));
    HATCH_TRY(read_images(r));
    HATCH_TRY(read_materials(r));
    HATCH_TRY(read_cameras(r));
    HATCH_TRY(read_lights(r));
    HATCH_TRY(read_skins(r));
    HATCH_TRY(read_meshes(r, &first_mesh));
    HATCH_TRY(attach_to_nodes(r, first_mesh));
    HATCH_TRY(add_instances(r));
    HATCH_TRY(check_transforms(r));
    note_lost(r);
    return read_animations(r);
}

enum hatch_status read_file_bytes(struct hatch_bytes file, const struct hatch_gltf_resolver *resolver,
                                  struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_scene *scene,
                                  struct hatch_mesh_notes *notes, struct hatch_err *err)
{
    tinygltf::Model model;
    HATCH_TRY(load(file, resolver, scratch, &model, err));
    struct hatch_scene made = {};
    struct hatch_mesh_notes noted = *notes;
    Reader r = {model, arena, scratch, &made, &noted, err};
    HATCH_TRY(read_all(r));
    *scene = made;
    *notes = noted;
    return HATCH_OK;
}

} // namespace
} // namespace hatch

extern "C" enum hatch_status hatch_gltf_read(struct hatch_bytes file, const struct hatch_gltf_resolver *resolver,
                                             struct hatch_arena *arena, struct hatch_arena *scratch,
                                             struct hatch_scene *scene, struct hatch_mesh_notes *notes,
                                             struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status;
    try {
        status = hatch::read_file_bytes(file, resolver, arena, scratch, scene, notes, err);
    } catch (const std::bad_alloc &) {
        status = hatch::fail_memory(err);
    } catch (const std::exception &e) {
        status = hatch::fail_with(e.what(), err);
    }
    hatch_arena_rewind(scratch, mark);
    return status;
}
