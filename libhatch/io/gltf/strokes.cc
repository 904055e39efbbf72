/* Reads the strokes of a surface: primitives of lines that follow it in its glTF mesh. */
#include "io/gltf/reader.h"

#include <cmath>

namespace hatch
{

bool is_strokes(const tinygltf::Primitive &primitive)
{
    return primitive.mode == TINYGLTF_MODE_LINE && primitive.extras.IsObject() && primitive.extras.Has("hatch") &&
           primitive.extras.Get("hatch").IsObject() && primitive.extras.Get("hatch").Has("family");
}

namespace
{

/* A primitive of strokes as it is in the file. */
struct Lines {
    struct hatch_mesh vertices;
    uint32_t *indices, count;
};

double number_of(const tinygltf::Primitive &primitive, const char *key)
{
    const tinygltf::Value &extras = primitive.extras.Get("hatch");
    return extras.Has(key) && extras.Get(key).IsNumber() ? extras.Get(key).GetNumberAsDouble() : NAN;
}

/* Reads the vertices and the lines; the vertices are at rest, as the surface is.
 *   mesh  index of the glTF mesh */
enum hatch_status read_lines(Reader &r, const tinygltf::Primitive &primitive, size_t mesh, const std::string &where,
                             Lines *lines)
{
    *lines = {};
    HATCH_TRY(read_attributes(r, primitive, where, &lines->vertices));
    HATCH_TRY(read_morph(r, primitive, mesh, where, &lines->vertices));
    if (primitive.indices == -1)
        return bad(r, where, "strokes without indices");
    HATCH_TRY(read_indices(r, primitive.indices, where + ", indices", &lines->indices, &lines->count));
    if (lines->count % 2 != 0)
        return bad(r, where, std::to_string(lines->count) + " ends do not form lines");
    return HATCH_OK;
}

enum hatch_status read_set(Reader &r, const tinygltf::Primitive &primitive, const std::string &where,
                           struct hatch_curve_set *set)
{
    double family = number_of(primitive, "family"), level = number_of(primitive, "level");
    double angle = number_of(primitive, "angle"), gap = number_of(primitive, "gap");
    if (!(family >= 0 && family < HATCH_CURVE_FAMILIES_MAX && level >= 0 && level < HATCH_CURVE_LEVELS_MAX &&
          std::fabs(angle) < 100 && gap > 0 && gap < 1e38))
        return bad(r, where, "strokes: family, level, angle or gap is missing or out of range");
    double length = number_of(primitive, "length"), hard = number_of(primitive, "hard");
    *set = {};
    set->family = static_cast<uint32_t>(family);
    set->level = static_cast<uint32_t>(level);
    set->angle_rad = static_cast<float>(angle);
    set->gap = static_cast<float>(gap);
    set->length = length > 1 && length <= HATCH_CURVE_LENGTH_MAX ? static_cast<float>(length) : 0;
    set->hard_rad = hard >= 0 && hard < 4 ? static_cast<float>(hard) : -1;
    return HATCH_OK;
}

/* Reads the needs of views that strokes were made for, if they were. */
void read_needs(const tinygltf::Primitive &primitive, struct hatch_curves *curves)
{
    double needs = number_of(primitive, "needs"), finest = number_of(primitive, "finest");
    if (needs > 0 && needs <= 1 && finest > 0 && finest < 1e38) {
        curves->needs = static_cast<float>(needs);
        curves->finest = static_cast<float>(finest);
    }
}

/* Adds the strokes of a primitive: to the last set, if they are of the same family and level, else to a new one. */
enum hatch_status add_strokes(Reader &r, const tinygltf::Primitive &primitive, const std::string &where,
                              const Lines &lines, const struct hatch_mesh &surface, struct hatch_curves *curves)
{
    struct hatch_curve_set set, *last = curves->set_count > 0 ? &curves->sets[curves->set_count - 1] : nullptr;
    HATCH_TRY(read_set(r, primitive, where, &set));
    bool continues = last && set.family == last->family && set.level == last->level;
    if (continues && (set.angle_rad != last->angle_rad || set.gap != last->gap))
        return bad(r, where, "strokes: angle or gap differs from the primitive before, of the same family and level");
    if (!continues) {
        last = &curves->sets[curves->set_count++];
        *last = set;
        last->first = curves->count;
        if (curves->set_count == 1)
            read_needs(primitive, curves);
    }
    if (hatch_curves_from_vertices(&lines.vertices, lines.indices, lines.count / 2, set.gap, &surface, curves, r.err) !=
        HATCH_OK)
        return hatch_fail_at(r.err, "%s: ", where.c_str());
    last->count = curves->count - last->first;
    return HATCH_OK;
}

} // namespace

enum hatch_status read_strokes(Reader &r, const std::vector<tinygltf::Primitive> &list, size_t mesh, size_t first,
                               struct hatch_scene_mesh *surface)
{
    size_t count = 0, points = 0, lines = 0;
    struct hatch_arena_mark mark = hatch_arena_mark(r.scratch);
    while (first + count < list.size() && is_strokes(list[first + count]))
        count++;
    if (count == 0)
        return HATCH_OK;
    Reader passing = r; /* vertices are needed until they are points */
    passing.arena = r.scratch;
    Lines *parts = HATCH_NEW(r.scratch, Lines, count, r.err);
    if (!parts)
        return HATCH_LIMIT;
    for (size_t i = 0; i < count; i++) {
        HATCH_TRY(read_lines(passing, list[first + i], mesh, place("mesh", mesh, "primitive", first + i), &parts[i]));
        points += parts[i].vertices.vertex_count;
        lines += parts[i].count / 2;
    }
    struct hatch_curves curves = {};
    curves.sets = HATCH_NEW(r.arena, struct hatch_curve_set, count, r.err);
    curves.curves = HATCH_NEW(r.arena, struct hatch_curve, lines, r.err);
    curves.points = HATCH_NEW(r.arena, struct hatch_curve_point, points, r.err);
    if (!curves.sets || !curves.curves || !curves.points)
        return HATCH_LIMIT;
    for (size_t i = 0; i < count; i++)
        HATCH_TRY(add_strokes(r, list[first + i], place("mesh", mesh, "primitive", first + i), parts[i], surface->mesh,
                              &curves));
    if (hatch_curves_check(&curves, &surface->mesh, r.err) != HATCH_OK)
        return hatch_fail_at(r.err, "%s: ", place("mesh", mesh, "primitive", first - 1).c_str());
    hatch_arena_rewind(r.scratch, mark);
    surface->curves = curves;
    return HATCH_OK;
}

} // namespace hatch
