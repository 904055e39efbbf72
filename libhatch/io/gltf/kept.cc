/* What a scene keeps of a file for writing alone: names, extras. */
#include "io/gltf/reader.h"

#include <cstring>

namespace hatch
{

namespace
{

/* Returns the end of the key or value that begins at a place of JSON without spaces. */
size_t end_of(const std::string &json, size_t at)
{
    bool quoted = false;
    for (int depth = 0; at < json.size(); at++) {
        const char c = json[at];
        if (quoted) {
            quoted = c != '"';
            at += c == '\\';
        } else if (c == '"') {
            quoted = true;
        } else if (c == '{' || c == '[') {
            depth++;
        } else if (depth == 0 && std::strchr(",:}]", c)) {
            return at;
        } else if (c == '}' || c == ']') {
            depth--;
        }
    }
    return json.size();
}

/* Calls use with the key, in quotes, and the value of each member of an object. */
template <class Use> void each_member(const std::string &object, Use use)
{
    for (size_t at = 1; at < object.size() && object[at] == '"';) {
        const size_t colon = end_of(object, at), end = end_of(object, colon + 1);
        use(object.substr(at, colon - at), object.substr(colon + 1, end - colon - 1));
        at = end + 1;
    }
}

/* Returns an object without one of its members; empty if no other is left. */
std::string without(const std::string &object, const char *key)
{
    const std::string quoted = std::string("\"") + key + "\"";
    std::string rest;
    each_member(object, [&](const std::string &name, const std::string &value) {
        if (name != quoted)
            rest += (rest.empty() ? "{" : ",") + name + ":" + value;
    });
    return rest.empty() ? rest : rest + "}";
}

enum hatch_status copy_text(Reader &r, const std::string &text, const char **copy)
{
    char *bytes = HATCH_NEW(r.arena, char, text.size() + 1, r.err);
    if (!bytes)
        return HATCH_LIMIT;
    std::memcpy(bytes, text.c_str(), text.size() + 1);
    *copy = bytes;
    return HATCH_OK;
}

} // namespace

enum hatch_status keep(Reader &r, const std::string &name, const std::string &extras, const char *own,
                       struct hatch_kept *kept)
{
    const std::string rest = own && extras[0] == '{' ? without(extras, own) : extras;
    *kept = {};
    if (!name.empty())
        HATCH_TRY(copy_text(r, name, &kept->name));
    return rest.empty() ? HATCH_OK : copy_text(r, rest, &kept->extras);
}

} // namespace hatch
