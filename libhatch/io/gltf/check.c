#include "io/gltf/check.h"

#include <string.h>

#define MAGIC "glTF"
#define CHUNK_JSON 0x4e4f534au
#define CHUNK_BIN 0x004e4942u

static enum hatch_status read_chunk(struct hatch_reader *reader, uint32_t *type, struct hatch_bytes *chunk,
                                    struct hatch_err *err)
{
    size_t start = reader->at;
    uint32_t length = hatch_read_u32(reader);
    *type = hatch_read_u32(reader);
    if (reader->cut)
        return hatch_fail(err, HATCH_BAD_INPUT, "byte %zu: truncated in a chunk header", start);
    if (length % 4 != 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "byte %zu: chunk of %u bytes, want a multiple of 4", start, length);
    if (length > hatch_reader_left(reader))
        return hatch_fail(err, HATCH_BAD_INPUT, "byte %zu: truncated: chunk of %u bytes, but %zu follow", start, length,
                          hatch_reader_left(reader));
    chunk->size = length;
    chunk->data = hatch_read_bytes(reader, length);
    return HATCH_OK;
}

/* Returns whether the rest of a file is zeros, which some programs and disks append. */
static bool is_padding(struct hatch_bytes file, size_t from)
{
    while (from < file.size && file.data[from] == 0)
        from++;
    return from == file.size;
}

enum hatch_status hatch_gltf_split(struct hatch_bytes file, struct hatch_gltf_parts *parts, struct hatch_err *err)
{
    *parts = (struct hatch_gltf_parts){.file = file, .json = file};
    while (parts->json.size > 0 && file.data[parts->json.size - 1] == 0)
        parts->json.size--;
    if (file.size < 4 || memcmp(file.data, MAGIC, 4) != 0)
        return HATCH_OK;
    struct hatch_reader reader = hatch_reader_of(file);
    hatch_read_u32(&reader);
    uint32_t version = hatch_read_u32(&reader), length = hatch_read_u32(&reader), type;
    if (reader.cut)
        return hatch_fail(err, HATCH_BAD_INPUT, "truncated in the header: %zu bytes", file.size);
    if (version != 2)
        return hatch_fail(err, HATCH_BAD_INPUT, "glTF version %u, want 2", version);
    if (length < reader.at || length > file.size || !is_padding(file, length))
        return hatch_fail(err, HATCH_BAD_INPUT, "the header claims %u bytes, the file has %zu", length, file.size);
    parts->file.size = reader.size = length;
    HATCH_TRY(read_chunk(&reader, &type, &parts->json, err));
    if (type != CHUNK_JSON)
        return hatch_fail(err, HATCH_BAD_INPUT, "the first chunk is not JSON");
    for (bool first = true; hatch_reader_left(&reader) > 0; first = false) {
        struct hatch_bytes chunk;
        HATCH_TRY(read_chunk(&reader, &type, &chunk, err));
        if (type == CHUNK_BIN && !first)
            return hatch_fail(err, HATCH_BAD_INPUT, "the BIN chunk is not the second chunk");
        if (type == CHUNK_BIN)
            parts->binary = chunk;
    }
    return HATCH_OK;
}

struct text {
    const char *start;
    size_t length;
};

/* An object or array that is not yet closed. */
struct level {
    bool object, key_next; /* key_next: the next string is a key */
    struct text name, key; /* name: its own key in the object around it; key: the last key read in it */
};

struct scan {
    const char *text;
    size_t size, at;
    uint32_t depth;
    struct level levels[HATCH_GLTF_DEPTH_MAX + 1]; /* [0]: outside the root */
    struct hatch_gltf_buffers *buffers;
    size_t buffer_start;     /* place of the glTF buffer whose JSON is being read */
    uint64_t buffer_length;  /* its byteLength */
    bool buffer_has_file;    /* whether it is an external file */
    bool buffer_is_fallback; /* whether only compressed views are read instead of it */
};

static bool is(struct text text, const char *word)
{
    return text.length == strlen(word) && memcmp(text.start, word, text.length) == 0;
}

static bool in_list(struct text text, const char *const *list)
{
    for (; *list; list++)
        if (is(text, *list))
            return true;
    return false;
}

enum number_rule { RULE_NONE, RULE_INDEX, RULE_SIZE };

static enum number_rule current_rule(const struct scan *s)
{
    static const char *const indices[] = {
        "bufferView", "buffer",  "mesh",          "node",     "skin",    "camera", "scene",  "skeleton", "source",
        "sampler",    "texture", "index",         "texCoord", "indices", "input",  "output", "joints",   "material",
        "children",   "nodes",   "componentType", "mode",     "count",   "light",  NULL};
    static const char *const sizes[] = {"byteOffset", "byteLength", "byteStride", NULL};
    bool extension = false;
    for (uint32_t i = 1; i <= s->depth; i++) {
        if (is(s->levels[i].name, "extras"))
            return RULE_NONE;
        extension = extension || is(s->levels[i].name, "extensions");
    }
    const struct level *level = &s->levels[s->depth];
    struct text key = level->object ? level->key : level->name;
    if (extension)
        return is(key, "light") ? RULE_INDEX : RULE_NONE;
    if (in_list(key, indices) || (level->object && is(level->name, "attributes")))
        return RULE_INDEX;
    return in_list(key, sizes) ? RULE_SIZE : RULE_NONE;
}

/* Reads a string and moves past its closing quote. Escapes are not decoded. */
static struct text scan_string(struct scan *s)
{
    size_t start = ++s->at;
    while (s->at < s->size && s->text[s->at] != '"')
        s->at += s->text[s->at] == '\\' ? 2 : 1;
    if (s->at > s->size)
        s->at = s->size;
    struct text text = {s->text + start, s->at - start};
    if (s->at < s->size)
        s->at++;
    return text;
}

/* Reads a number, true, false or null: everything up to the next delimiter. */
static struct text scan_word(struct scan *s)
{
    size_t start = s->at;
    while (s->at < s->size && !strchr(",:]}[{\" \t\r\n", s->text[s->at]))
        s->at++;
    if (s->at == start)
        s->at++;
    return (struct text){s->text + start, s->at - start};
}

static bool is_integer(struct text text, uint64_t largest, uint64_t *number)
{
    uint64_t value = 0;
    for (size_t i = 0; i < text.length; i++) {
        if (text.start[i] < '0' || text.start[i] > '9' || i > 18)
            return false;
        value = value * 10 + (uint64_t)(text.start[i] - '0');
    }
    *number = value;
    return text.length > 0 && value <= largest;
}

static bool in_buffer(const struct scan *s)
{
    return s->depth == 3 && s->levels[3].object && is(s->levels[2].name, "buffers");
}

/* Returns whether the value being read says that the buffer around it is a fallback. */
static bool in_fallback(const struct scan *s)
{
    return s->depth == 5 && is(s->levels[2].name, "buffers") && is(s->levels[5].name, "EXT_meshopt_compression") &&
           is(s->levels[5].key, "fallback");
}

/* Fails for a required extension that is not supported. This comes before parsing, since a file that needs one may not
 * look like glTF otherwise. Extensions of materials are accepted: apart from the base colour, they do not matter for
 * strokes. */
static enum hatch_status check_extension(struct text name, struct hatch_err *err)
{
    static const char materials[] = "KHR_materials_";
    static const char *const known[] = {"EXT_mesh_gpu_instancing", "EXT_meshopt_compression", "EXT_texture_avif",
                                        "EXT_texture_webp",        "KHR_lights_punctual",     "KHR_mesh_quantization",
                                        "KHR_texture_basisu",      "KHR_texture_transform",   NULL};
    size_t prefix = sizeof materials - 1;
    if (in_list(name, known) || (name.length > prefix && memcmp(name.start, materials, prefix) == 0))
        return HATCH_OK;
    return hatch_fail(err, HATCH_BAD_INPUT, "extensionsRequired: %.*s is not supported",
                      (int)(name.length < 64 ? name.length : 64), name.start);
}

static bool in_required(const struct scan *s)
{
    return s->depth == 2 && !s->levels[2].object && is(s->levels[2].name, "extensionsRequired");
}

static enum hatch_status check_value(struct scan *s, struct text word, struct hatch_err *err)
{
    static const char data[] = "\"data:";
    enum number_rule rule = current_rule(s);
    uint64_t largest = rule == RULE_SIZE ? (uint64_t)1 << 53 : INT32_MAX, number = 0;
    const struct level *level = &s->levels[s->depth];
    bool good = rule == RULE_NONE || is_integer(word, largest, &number);
    if (in_required(s) && word.length > 1 && word.start[0] == '"')
        HATCH_TRY(check_extension((struct text){word.start + 1, word.length - 1}, err));
    if (in_buffer(s) && is(level->key, "uri"))
        s->buffer_has_file = word.length < strlen(data) || memcmp(word.start, data, strlen(data)) != 0;
    if (in_buffer(s) && is(level->key, "byteLength"))
        s->buffer_length = number;
    if (in_fallback(s))
        s->buffer_is_fallback = is(word, "true");
    if (good)
        return HATCH_OK;
    struct text key = level->object ? level->key : level->name;
    return hatch_fail(err, HATCH_BAD_INPUT, "JSON byte %zu: %.*s is %.*s%s, want an integer, 0 .. %llu",
                      (size_t)(word.start - s->text), (int)(key.length < 32 ? key.length : 32), key.start,
                      (int)(word.length < 32 ? word.length : 32), word.start, word.start[0] == '"' ? "\"" : "",
                      (unsigned long long)largest);
}

static enum hatch_status open_level(struct scan *s, bool object, struct hatch_err *err)
{
    if (s->depth >= HATCH_GLTF_DEPTH_MAX)
        return hatch_fail(err, HATCH_BAD_INPUT, "JSON byte %zu: nested deeper than %u", s->at, HATCH_GLTF_DEPTH_MAX);
    const struct level *around = &s->levels[s->depth];
    struct text name = around->object ? around->key : around->name;
    s->levels[++s->depth] = (struct level){.object = object, .key_next = object, .name = name};
    if (in_buffer(s))
        s->buffer_start = s->at;
    s->at++;
    return HATCH_OK;
}

/* Notes the buffer whose JSON ends here. */
static enum hatch_status close_buffer(struct scan *s, struct hatch_err *err)
{
    struct hatch_gltf_range range = {s->buffer_start, s->at + 1};
    uint64_t length = s->buffer_length;
    bool has_file = s->buffer_has_file, is_fallback = s->buffer_is_fallback;
    s->buffer_length = 0;
    s->buffer_has_file = s->buffer_is_fallback = false;
    if (s->buffers && is_fallback)
        return hatch_buffer_add(&s->buffers->fallbacks, &range, sizeof range, err);
    return s->buffers && has_file ? hatch_buffer_add(&s->buffers->lengths, &length, sizeof length, err) : HATCH_OK;
}

static enum hatch_status close_level(struct scan *s, struct hatch_err *err)
{
    if (in_buffer(s))
        HATCH_TRY(close_buffer(s, err));
    s->depth -= s->depth > 0;
    s->at++;
    return HATCH_OK;
}

static enum hatch_status scan_token(struct scan *s, struct hatch_err *err)
{
    struct level *level = &s->levels[s->depth];
    switch (s->text[s->at]) {
    case '{':
    case '[':
        return open_level(s, s->text[s->at] == '{', err);
    case '}':
    case ']':
        return close_level(s, err);
    case ',':
        level->key_next = level->object;
        s->at++;
        return HATCH_OK;
    case ':':
        level->key_next = false;
        s->at++;
        return HATCH_OK;
    case ' ':
    case '\t':
    case '\r':
    case '\n':
        s->at++;
        return HATCH_OK;
    case '"': {
        struct text text = scan_string(s);
        if (!level->key_next) /* with its quote, so that "3" is not a number */
            return check_value(s, (struct text){text.start - 1, text.length + 1}, err);
        level->key = text;
        return HATCH_OK;
    }
    default:
        return check_value(s, scan_word(s), err);
    }
}

enum hatch_status hatch_gltf_check_json(struct hatch_bytes json, struct hatch_gltf_buffers *buffers,
                                        struct hatch_err *err)
{
    struct scan s = {.text = (const char *)json.data, .size = json.size, .buffers = buffers};
    s.levels[0].name = s.levels[0].key = (struct text){"", 0};
    while (s.at < s.size)
        HATCH_TRY(scan_token(&s, err));
    return HATCH_OK;
}

bool hatch_gltf_uri_is_local(const char *uri)
{
    if (uri[0] == '\0' || uri[0] == '/' || strchr(uri, '\\') || strchr(uri, ':'))
        return false;
    for (const char *part = uri; part; part = strchr(part, '/')) {
        part += *part == '/';
        size_t length = strcspn(part, "/");
        if (length == 2 && memcmp(part, "..", 2) == 0)
            return false;
    }
    return true;
}
