#include "io/gltf/reader.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace hatch
{

namespace
{

/* When flat normals are added, neighbouring faces share vertices if their normals differ by less than this. */
const float flat_rad = 1e-4f;

/* Returns whether a name consists of a prefix and a number, as "COLOR_0" does for "COLOR_". */
bool is_set(const std::string &name, const char *set)
{
    size_t length = std::strlen(set);
    return name.compare(0, length, set) == 0 && name.size() > length && name.size() < HATCH_MESH_NAME_MAX &&
           name.find_first_not_of("0123456789", length) == std::string::npos;
}

/* Returns the number of components with which an attribute is read; 0 for one that is not read.
 *   available  components that its accessor has */
int wanted_components(const std::string &name, int available)
{
    if (name == "POSITION" || name == "NORMAL")
        return 3;
    if (name == "TANGENT" || is_set(name, "JOINTS_") || is_set(name, "WEIGHTS_"))
        return 4;
    if (is_set(name, "TEXCOORD_"))
        return 2;
    if (is_set(name, "COLOR_"))
        return available == 3 ? 3 : 4;
    bool custom = name.size() > 1 && name[0] == '_' && name.size() < HATCH_MESH_NAME_MAX;
    return custom && available <= 4 ? available : 0;
}

int components_of(const Reader &r, int accessor)
{
    if (accessor < 0 || static_cast<size_t>(accessor) >= r.model.accessors.size())
        return 0;
    return tinygltf::GetNumComponentsInType(
        static_cast<uint32_t>(r.model.accessors[static_cast<size_t>(accessor)].type));
}

/* Adds an alpha of 1 to colours of three components, since colours in a mesh have four. */
enum hatch_status add_alpha(Reader &r, uint32_t count, float **data)
{
    float *wide = HATCH_NEW(r.arena, float, static_cast<size_t>(count) * 4, r.err);
    if (!wide)
        return HATCH_LIMIT;
    for (size_t i = 0; i < count; i++) {
        std::memcpy(wide + 4 * i, *data + 3 * i, 3 * sizeof *wide);
        wide[4 * i + 3] = 1;
    }
    *data = wide;
    return HATCH_OK;
}

/* Notes an attribute of integers that are so large that floats may have rounded them. */
void note_rounding(Reader &r, int accessor, const float *data, size_t count)
{
    const float exact = 16777216;
    if (r.model.accessors[static_cast<size_t>(accessor)].componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)
        r.notes->attributes_rounded += std::any_of(data, data + count, [=](float number) { return number >= exact; });
}

enum hatch_status read_attribute(Reader &r, const std::string &name, int accessor, const std::string &where,
                                 const Range *range, struct hatch_mesh *mesh)
{
    int components = wanted_components(name, components_of(r, accessor));
    if (components == 0 || mesh->attribute_count >= HATCH_MESH_ATTRIBUTES_READ) {
        r.notes->attributes_dropped++;
        return HATCH_OK;
    }
    std::string at = where + ", " + name;
    float *data;
    uint32_t count;
    r.replaced = is_set(name, "COLOR_") ? &r.notes->colors_replaced : nullptr;
    enum hatch_status status = read_floats(r, accessor, components, at, &data, &count, range);
    r.replaced = nullptr;
    HATCH_TRY(status);
    if (mesh->attribute_count > 0 && count != mesh->vertex_count)
        return bad(r, at, std::to_string(count) + " elements, POSITION has " + std::to_string(mesh->vertex_count));
    if (is_set(name, "COLOR_") && components == 3) {
        HATCH_TRY(add_alpha(r, count, &data));
        components = 4;
    }
    note_rounding(r, accessor, data, static_cast<size_t>(count) * static_cast<size_t>(components));
    struct hatch_mesh_attribute *a = &mesh->attributes[mesh->attribute_count++];
    std::memcpy(a->name, name.c_str(), name.size() + 1);
    a->components = static_cast<uint32_t>(components);
    a->data = data;
    mesh->vertex_count = count;
    return HATCH_OK;
}

} // namespace

enum hatch_status read_attributes(Reader &r, const tinygltf::Primitive &primitive, const std::string &where,
                                  struct hatch_mesh *mesh, const Range *range)
{
    auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end())
        return bad(r, where, "no POSITION");
    HATCH_TRY(read_attribute(r, "POSITION", position->second, where, range, mesh));
    bool normals = primitive.attributes.count("NORMAL") > 0;
    for (const auto &attribute : primitive.attributes) {
        /* Tangents without normals are ignored (glTF 2.0, §3.7.2.1). */
        if (attribute.first == "POSITION" || (attribute.first == "TANGENT" && !normals))
            continue;
        HATCH_TRY(read_attribute(r, attribute.first, attribute.second, where, range, mesh));
    }
    return HATCH_OK;
}

namespace
{

/* Computes the largest joint index plus 1, or 0 without joints. Fails for an index that is not an integer of 16
 * bits. */
enum hatch_status count_joints(Reader &r, const struct hatch_mesh *mesh, const std::string &where, uint32_t *count)
{
    *count = 0;
    for (uint32_t a = 0; a < mesh->attribute_count; a++) {
        const std::string name = mesh->attributes[a].name;
        const float *joints = mesh->attributes[a].data;
        for (size_t i = 0; is_set(name, "JOINTS_") && i < static_cast<size_t>(mesh->vertex_count) * 4; i++) {
            if (!(joints[i] >= 0 && joints[i] <= UINT16_MAX && std::floor(joints[i]) == joints[i]))
                return bad(r, where, place((name + ": element").c_str(), i / 4) + " is not a joint index");
            uint32_t needed = static_cast<uint32_t>(joints[i]) + 1;
            *count = needed > *count ? needed : *count;
        }
    }
    return HATCH_OK;
}

/* Returns the position in a strip of corner k of its triangle i. Odd triangles are reversed, so that all have the same
 * orientation. */
uint32_t strip_corner(uint32_t i, uint32_t k)
{
    return i + (i % 2 == 1 && k > 0 ? 3 - k : k);
}

enum hatch_status triangulate(Reader &r, int mode, const uint32_t *list, uint32_t count, const std::string &where,
                              struct hatch_mesh *mesh)
{
    bool separate = mode == TINYGLTF_MODE_TRIANGLES, fan = mode == TINYGLTF_MODE_TRIANGLE_FAN;
    if (count < 3 || (separate && count % 3 != 0))
        return bad(r, where, std::to_string(count) + " corners do not form triangles");
    uint32_t faces = separate ? count / 3 : count - 2;
    mesh->indices = HATCH_NEW(r.arena, uint32_t, static_cast<size_t>(faces) * 3, r.err);
    if (!mesh->indices)
        return HATCH_LIMIT;
    mesh->face_count = 0;
    for (uint32_t i = 0; i < faces; i++) {
        uint32_t *face = mesh->indices + static_cast<size_t>(mesh->face_count) * 3;
        for (uint32_t k = 0; k < 3; k++) {
            uint32_t corner = separate ? 3 * i + k : fan ? (k == 0 ? 0 : i + k) : strip_corner(i, k);
            face[k] = list ? list[corner] : corner;
            if (face[k] >= mesh->vertex_count)
                return bad(r, where,
                           "index " + std::to_string(face[k]) + " does not exist, there are " +
                               std::to_string(mesh->vertex_count) + " vertices");
        }
        /* Degenerate triangles of a strip or fan only join its parts and are not part of the surface. */
        bool joint = face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
        mesh->face_count += separate || !joint;
    }
    return HATCH_OK;
}

/* Returns a member of what the writer notes in the extras of a primitive; a null value: there is none. */
const tinygltf::Value &noted(const tinygltf::Primitive &primitive, const char *key)
{
    static const tinygltf::Value none;
    return primitive.extras.IsObject() && primitive.extras.Has("hatch") && primitive.extras.Get("hatch").IsObject()
               ? primitive.extras.Get("hatch").Get(key)
               : none;
}

/* Returns the tolerance of views that do not show a primitive; 0: there is none. */
float unseen_tolerance(const tinygltf::Primitive &primitive)
{
    const tinygltf::Value &unseen = noted(primitive, "unseen");
    double tolerance = unseen.IsNumber() ? unseen.GetNumberAsDouble() : 0;
    return tolerance > 0 && tolerance <= 1 ? static_cast<float>(tolerance) : 0;
}

bool has_computed_normals(const tinygltf::Primitive &primitive)
{
    const tinygltf::Value &normals = noted(primitive, "normals");
    return normals.IsString() && normals.Get<std::string>() == "computed";
}

/* Finds the vertices of a primitive that shares its accessors with others, from the lowest to the highest index, and
 * counts indices from the lowest. Other primitives have all vertices of theirs.
 *   list   in, out: indices
 *   range  out
 * Returns whether there is such a range. */
bool find_range(const Reader &r, const tinygltf::Primitive &primitive, uint32_t *list, uint32_t count, Range *range)
{
    auto position = primitive.attributes.find("POSITION");
    size_t accessor = position == primitive.attributes.end() ? SIZE_MAX : static_cast<size_t>(position->second);
    if (!list || count == 0 || accessor >= r.model.accessors.size() || r.users[accessor] < 2 ||
        !primitive.targets.empty())
        return false;
    uint32_t low = *std::min_element(list, list + count), high = *std::max_element(list, list + count);
    size_t elements = r.model.accessors[accessor].count;
    if (high >= elements || elements > INT32_MAX)
        return false; /* which the message of reading them all tells */
    for (uint32_t i = 0; i < count; i++)
        list[i] -= low;
    *range = {low, high + 1, static_cast<uint32_t>(elements)};
    return true;
}

/* Adds normals to a mesh that has none. They may copy vertices, or replace all by one for each corner.
 *   number  per corner, in scratch; out: its vertex before that */
enum hatch_status add_normals(Reader &r, size_t index, struct hatch_mesh *mesh, uint32_t **number)
{
    const size_t corners = 3 * static_cast<size_t>(mesh->face_count);
    if (!(*number = HATCH_NEW_UNSET(r.scratch, uint32_t, corners, r.err)))
        return HATCH_LIMIT;
    std::copy_n(mesh->indices, corners, *number);
    return hatch_mesh_target_count(mesh) > 0 ? add_moving_normals(r, index, mesh)
                                             : hatch_mesh_add_normals(r.arena, r.scratch, mesh, flat_rad, r.err);
}

/* Numbers the vertices of a mesh as the file does.
 *   range   of the file's vertices that the mesh has; nullptr: all of them
 *   number  per corner, its number in the range; nullptr: that of its vertex */
enum hatch_status number_vertices(Reader &r, const Range *range, const uint32_t *number, struct hatch_scene_mesh *out)
{
    const uint32_t first = range ? range->first : 0, vertices = out->mesh.vertex_count;
    uint32_t *numbers = HATCH_NEW(r.arena, uint32_t, vertices, r.err);
    if (!numbers)
        return HATCH_LIMIT;
    for (uint32_t v = 0; v < vertices; v++)
        numbers[v] = first + std::min(v, out->file_vertices - 1);
    for (size_t i = 0; number && i < 3 * static_cast<size_t>(out->mesh.face_count); i++)
        numbers[out->mesh.indices[i]] = first + number[i];
    out->numbers = numbers;
    out->numbers_end = range ? range->count : out->file_vertices;
    return HATCH_OK;
}

enum hatch_status read_primitive(Reader &r, const tinygltf::Primitive &primitive, size_t index,
                                 const std::string &where, struct hatch_scene_mesh *out)
{
    struct hatch_mesh mesh = {};
    uint32_t *list = nullptr, count = 0, *number = nullptr;
    Range range;
    struct hatch_arena_mark mark = hatch_arena_mark(r.scratch);
    if (primitive.indices != -1)
        HATCH_TRY(read_indices(r, primitive.indices, where + ", indices", &list, &count));
    const Range *part = find_range(r, primitive, list, count, &range) ? &range : nullptr;
    HATCH_TRY(read_attributes(r, primitive, where, &mesh, part));
    HATCH_TRY(read_morph(r, primitive, index, where, &mesh));
    HATCH_TRY(triangulate(r, primitive.mode, list, list ? count : mesh.vertex_count, where, &mesh));
    hatch_arena_rewind(r.scratch, mark);
    HATCH_TRY(check_index(r, primitive.material, r.model.materials.size(), where, "material"));
    out->material = static_cast<uint32_t>(primitive.material); /* -1 is HATCH_NONE */
    HATCH_TRY(keep(r, "", primitive.extras_json_string, "hatch", &out->kept));
    HATCH_TRY(count_joints(r, &mesh, where, &out->joints_used));
    r.notes->joints_dropped += hatch_mesh_keep_influences(&mesh);
    HATCH_TRY(hatch_mesh_replace_normals(r.scratch, &mesh, &r.notes->normals_replaced, r.err));
    out->file_vertices = mesh.vertex_count;
    out->unseen_tolerance = unseen_tolerance(primitive);
    out->had_texcoords = hatch_mesh_find(&mesh, "TEXCOORD_0", 2) != nullptr;
    out->had_normals = hatch_mesh_find(&mesh, "NORMAL", 3) != nullptr;
    out->normals_computed = !out->had_normals || has_computed_normals(primitive);
    if (!out->had_normals && mesh.face_count > 0)
        HATCH_TRY(add_normals(r, index, &mesh, &number));
    out->mesh = mesh;
    if (part || number)
        HATCH_TRY(number_vertices(r, part, number, out));
    hatch_arena_rewind(r.scratch, mark);
    return HATCH_OK;
}

bool has_faces(const tinygltf::Primitive &primitive)
{
    return primitive.mode >= TINYGLTF_MODE_TRIANGLES;
}

enum hatch_status count_users(Reader &r)
{
    r.users = HATCH_NEW(r.scratch, uint32_t, r.model.accessors.size(), r.err);
    if (!r.users)
        return HATCH_LIMIT;
    for (const tinygltf::Mesh &mesh : r.model.meshes)
        for (const tinygltf::Primitive &primitive : mesh.primitives) {
            auto position = primitive.attributes.find("POSITION");
            if (position != primitive.attributes.end() && has_faces(primitive) &&
                static_cast<size_t>(position->second) < r.model.accessors.size())
                r.users[static_cast<size_t>(position->second)]++;
        }
    return HATCH_OK;
}

/* Use of a glTF mesh: by nobody, by a coarser level of detail only, or by a node of the scene. */
enum use { UNDRAWN, COARSER, DRAWN };

void mark(const tinygltf::Model &model, int node, use kind, std::vector<use> *uses)
{
    if (node < 0 || static_cast<size_t>(node) >= model.nodes.size())
        return;
    const int mesh = model.nodes[static_cast<size_t>(node)].mesh;
    if (mesh >= 0 && static_cast<size_t>(mesh) < uses->size())
        (*uses)[static_cast<size_t>(mesh)] = std::max((*uses)[static_cast<size_t>(mesh)], kind);
}

/* Finds the use of each glTF mesh, and notes the meshes and the levels of detail that are not read. A file whose scene
 * has no nodes is one of meshes alone: all of them are read. */
std::vector<use> find_uses(Reader &r)
{
    std::vector<use> uses(r.model.meshes.size(), r.scene->node_count == 0 ? DRAWN : UNDRAWN);
    for (size_t i = 0; i < r.model.nodes.size(); i++) {
        if (r.node_of[i] == HATCH_NONE)
            continue;
        mark(r.model, static_cast<int>(i), DRAWN, &uses);
        auto levels = r.model.nodes[i].extensions.find("MSFT_lod");
        if (levels == r.model.nodes[i].extensions.end() || !levels->second.IsObject())
            continue;
        r.notes->levels_dropped++;
        const tinygltf::Value &ids = levels->second.Get("ids");
        for (size_t k = 0; ids.IsArray() && k < ids.ArrayLen(); k++)
            mark(r.model, ids.Get(k).IsInt() ? ids.Get(k).GetNumberAsInt() : -1, COARSER, &uses);
    }
    r.notes->meshes_undrawn += static_cast<uint32_t>(std::count(uses.begin(), uses.end(), UNDRAWN));
    return uses;
}

} // namespace

enum hatch_status read_meshes(Reader &r, uint32_t **first_mesh)
{
    size_t count = r.model.meshes.size(), primitives = 0;
    uint32_t *first = HATCH_NEW(r.scratch, uint32_t, count + 1, r.err);
    if (!first)
        return HATCH_LIMIT;
    const std::vector<use> uses = find_uses(r);
    for (size_t m = 0; m < count; m++)
        primitives += uses[m] == DRAWN ? r.model.meshes[m].primitives.size() : 0;
    HATCH_TRY(count_users(r));
    HATCH_TRY(find_morphs(r));
    r.scene->meshes = HATCH_NEW(r.arena, struct hatch_scene_mesh, primitives, r.err);
    if (!r.scene->meshes)
        return HATCH_LIMIT;
    for (size_t m = 0; m < count; m++) {
        const std::vector<tinygltf::Primitive> &list = r.model.meshes[m].primitives;
        struct hatch_kept whole;
        first[m] = r.scene->mesh_count;
        HATCH_TRY(keep(r, r.model.meshes[m], nullptr, &whole));
        for (size_t p = 0; uses[m] == DRAWN && p < list.size(); p++) {
            if (list[p].mode < 0 || list[p].mode > TINYGLTF_MODE_TRIANGLE_FAN)
                return bad(r, place("mesh", m, "primitive", p),
                           "mode " + std::to_string(list[p].mode) + ", want 0 .. 6");
            if (!has_faces(list[p])) {
                r.notes->primitives_skipped += p == 0 || !is_strokes(list[p]);
                continue;
            }
            if (list[p].attributes.count("POSITION") == 0) {
                r.notes->primitives_unplaced++;
                continue;
            }
            HATCH_TRY(
                read_primitive(r, list[p], m, place("mesh", m, "primitive", p), &r.scene->meshes[r.scene->mesh_count]));
            HATCH_TRY(read_strokes(r, list, m, p + 1, &r.scene->meshes[r.scene->mesh_count]));
            r.scene->meshes[r.scene->mesh_count++].whole = whole;
        }
    }
    first[count] = r.scene->mesh_count;
    *first_mesh = first;
    return HATCH_OK;
}

} // namespace hatch
