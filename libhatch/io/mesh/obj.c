/* Reads Wavefront OBJ: positions, texture coordinates, normals and polygons. Each distinct triple of their indices
 * becomes a vertex of the mesh, in order of first use. If all faces have position indices only, the vertices of the
 * mesh are those of the file. */
#include <math.h>
#include <string.h>

#include "base/random.h"
#include "io/mesh/polygon.h"
#include "io/mesh/text.h"

enum { V, VT, VN, KINDS };
#define ABSENT UINT32_MAX

/* Indices of one corner of a face; ABSENT where the file gives none. */
struct corner {
    uint32_t index[KINDS];
};

struct obj {
    struct hatch_mesh_text text;
    const double *origin;
    struct hatch_arena *scratch;
    struct hatch_buffer values[KINDS]; /* 3, 2 and 3 floats per value */
    bool positions_only;               /* faces have position indices only */
    struct hatch_buffer vertices;      /* array of struct corner; empty if positions_only */
    uint32_t vertex_count, slot_count;
    uint32_t *slots;                  /* hash table of corners: vertex + 1, or 0 if free */
    struct hatch_buffer points, used; /* of the face being read: indices of its positions; indices of its vertices */
    struct hatch_faces faces;
    uint32_t free_forms;       /* curves and surfaces that are left out */
    struct hatch_text library; /* name of the first material library; length 0: none */
};

static const uint32_t widths[KINDS] = {3, 2, 3};

static uint32_t value_count(const struct obj *o, int kind)
{
    return (uint32_t)(o->values[kind].size / (widths[kind] * sizeof(float)));
}

static const float *values(const struct obj *o, int kind)
{
    return (const float *)(const void *)o->values[kind].data;
}

static enum hatch_status read_value(struct obj *o, int kind, struct hatch_err *err)
{
    static const char *const names[KINDS] = {"v", "vt", "vn"};
    float value[3];
    if (o->values[kind].size / sizeof value >= INT32_MAX)
        return hatch_fail(err, HATCH_LIMIT, "line %u: too many %s", o->text.line, names[kind]);
    if (kind == V)
        HATCH_TRY(hatch_mesh_text_position(&o->text, names[V], o->origin, value, err));
    for (uint32_t k = 0; k < widths[kind] && kind != V; k++) {
        struct hatch_mesh_text ahead = o->text;
        if (kind == VT && k == 1 && hatch_mesh_text_word(&ahead).length == 0)
            value[k] = 0; /* one-dimensional texture */
        else
            HATCH_TRY(hatch_mesh_text_float(&o->text, names[kind], &value[k], err));
    }
    return hatch_buffer_add(&o->values[kind], value, widths[kind] * sizeof *value, err);
}

/* Reads a corner: "7", "7/1", "7//3" or "7/1/3". Negative indices count back from the last value read. */
static enum hatch_status read_corner(const struct obj *o, struct hatch_text word, struct corner *corner,
                                     struct hatch_err *err)
{
    const char *at = word.at, *end = word.at + word.length;
    for (int kind = 0; kind < KINDS; kind++) {
        corner->index[kind] = ABSENT;
        const char *stop = at;
        while (stop < end && *stop != '/')
            stop++;
        struct hatch_text part = {at, (size_t)(stop - at)};
        int64_t number, count = value_count(o, kind);
        if (part.length || kind == V) {
            if (!hatch_mesh_text_integer(part, &number) || number == 0 || number > count || number < -count)
                return hatch_fail(err, HATCH_BAD_INPUT, "line %u: corner %.*s: %s %.*s does not exist, there are %lld",
                                  o->text.line, hatch_mesh_text_shown(word), word.at,
                                  kind == V    ? "vertex"
                                  : kind == VT ? "texture coordinate"
                                               : "normal",
                                  hatch_mesh_text_shown(part), part.at, (long long)count);
            corner->index[kind] = (uint32_t)(number > 0 ? number - 1 : count + number);
        }
        at = stop < end ? stop + 1 : end;
    }
    if (at != end)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: corner %.*s has more than three parts", o->text.line,
                          hatch_mesh_text_shown(word), word.at);
    return HATCH_OK;
}

static uint64_t corner_hash(const struct corner *corner)
{
    uint64_t h = hatch_random_mix((uint64_t)corner->index[V] << 32 | corner->index[VT]);
    return hatch_random_mix(h ^ corner->index[VN]);
}

static const struct corner *vertex_corners(const struct obj *o)
{
    return (const struct corner *)(const void *)o->vertices.data;
}

static enum hatch_status grow_slots(struct obj *o, struct hatch_err *err)
{
    if (o->vertex_count < o->slot_count / 2)
        return HATCH_OK;
    uint32_t count = o->slot_count ? o->slot_count * 2 : 1024;
    uint32_t *slots = count < o->slot_count ? NULL : HATCH_NEW(o->scratch, uint32_t, count, err);
    if (!slots)
        return hatch_fail(err, HATCH_LIMIT, "line %u: %u vertices need too much memory", o->text.line, o->vertex_count);
    for (uint32_t v = 0; v < o->vertex_count; v++) {
        uint64_t slot = corner_hash(&vertex_corners(o)[v]);
        while (slots[slot & (count - 1)])
            slot++;
        slots[slot & (count - 1)] = v + 1;
    }
    o->slots = slots;
    o->slot_count = count;
    return HATCH_OK;
}

static enum hatch_status vertex_for(struct obj *o, const struct corner *corner, uint32_t *vertex, struct hatch_err *err)
{
    HATCH_TRY(grow_slots(o, err));
    uint64_t slot = corner_hash(corner);
    uint32_t found;
    while ((found = o->slots[slot & (o->slot_count - 1)]) != 0) {
        if (memcmp(&vertex_corners(o)[found - 1], corner, sizeof *corner) == 0) {
            *vertex = found - 1;
            return HATCH_OK;
        }
        slot++;
    }
    HATCH_TRY(hatch_buffer_add(&o->vertices, corner, sizeof *corner, err));
    *vertex = o->vertex_count++;
    o->slots[slot & (o->slot_count - 1)] = o->vertex_count;
    return HATCH_OK;
}

/* Returns whether any face of a text has indices of texture coordinates or normals. */
static bool has_slashes(struct hatch_mesh_text text)
{
    do {
        struct hatch_text word = hatch_mesh_text_word(&text);
        if (!hatch_text_is(word, "f"))
            continue;
        while ((word = hatch_mesh_text_word(&text)).length > 0)
            if (memchr(word.at, '/', word.length))
                return true;
    } while (hatch_mesh_text_next_line(&text));
    return false;
}

static enum hatch_status read_face(struct obj *o, struct hatch_err *err)
{
    o->points.size = o->used.size = 0;
    uint32_t count = 0;
    for (;;) {
        struct hatch_text word = hatch_mesh_text_word(&o->text);
        struct corner corner;
        if (word.length == 0)
            break;
        HATCH_TRY(read_corner(o, word, &corner, err));
        uint32_t vertex = corner.index[V];
        if (!o->positions_only)
            HATCH_TRY(vertex_for(o, &corner, &vertex, err));
        HATCH_TRY(hatch_buffer_add(&o->points, &corner.index[V], sizeof vertex, err));
        HATCH_TRY(hatch_buffer_add(&o->used, &vertex, sizeof vertex, err));
        count++;
    }
    if (count == 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: a face without corners", o->text.line);
    return hatch_faces_add(&o->faces, values(o, V), (const uint32_t *)(const void *)o->points.data,
                           (const uint32_t *)(const void *)o->used.data, count, err);
}

/* Groups, materials, lines, display hints and properties of free-form objects, which do not change the surface. */
static const char *const ignored[] = {
    "o",    "g",     "s",   "mg",    "usemtl", "mtllib", "usemap", "maplib",     "l",         "p",    "vp",
    "lod",  "bevel", "res", "ctech", "stech",  "cstype", "deg",    "c_interp",   "d_interp",  "parm", "trim",
    "hole", "scrv",  "sp",  "end",   "con",    "bmat",   "step",   "shadow_obj", "trace_obj", NULL};

/* Free-form curves and surfaces. */
static const char *const free_forms[] = {"curv", "curv2", "surf", "bsp", "bzp", "cdc", "cdp", NULL};

static bool is_one_of(struct hatch_text word, const char *const *words)
{
    while (*words && !hatch_text_is(word, *words))
        words++;
    return *words != NULL;
}

/* Reads the first name of a list of material libraries. Names may have spaces: the first name ends where a word ends in
 * .mtl, or else with the line. */
static struct hatch_text read_name(struct hatch_mesh_text *text)
{
    struct hatch_text name = hatch_mesh_text_word(text), word = name;
    while (word.length && !hatch_mesh_has_extension(name, ".mtl")) {
        name.length = (size_t)(word.at + word.length - name.at);
        word = hatch_mesh_text_word(text);
    }
    return name;
}

static enum hatch_status read_line(struct obj *o, struct hatch_err *err)
{
    struct hatch_text word = hatch_mesh_text_word(&o->text);
    if (word.length == 0)
        return HATCH_OK;
    if (hatch_text_is(word, "v"))
        return read_value(o, V, err);
    if (hatch_text_is(word, "vt"))
        return read_value(o, VT, err);
    if (hatch_text_is(word, "vn"))
        return read_value(o, VN, err);
    if (hatch_text_is(word, "f"))
        return read_face(o, err);
    if (hatch_text_is(word, "mtllib") && o->library.length == 0)
        o->library = read_name(&o->text);
    bool is_free_form = is_one_of(word, free_forms);
    o->free_forms += is_free_form;
    if (is_free_form || is_one_of(word, ignored))
        return HATCH_OK;
    return hatch_fail(err, HATCH_BAD_INPUT, "line %u: unknown keyword %.*s", o->text.line, hatch_mesh_text_shown(word),
                      word.at);
}

/* Lists the values of a kind in the order of the vertices.
 *   missing  stands for values that the file does not give
 *   out      NULL if it gives none */
static enum hatch_status gather(struct obj *o, int kind, float missing, const float **out, struct hatch_err *err)
{
    const struct corner *corners = vertex_corners(o);
    uint32_t width = widths[kind], v = 0;
    *out = NULL;
    while (v < o->vertex_count && corners[v].index[kind] == ABSENT)
        v++;
    if (v == o->vertex_count)
        return HATCH_OK;
    float *data;
    HATCH_TRY(HATCH_ALLOC(o->scratch, &data, (size_t)o->vertex_count * width, err));
    for (v = 0; v < o->vertex_count; v++)
        for (size_t k = 0; k < width; k++) {
            uint32_t index = corners[v].index[kind];
            data[v * width + k] = index == ABSENT ? missing : values(o, kind)[index * (size_t)width + k];
        }
    *out = data;
    return HATCH_OK;
}

static enum hatch_status count_unused(struct obj *o, struct hatch_mesh_notes *notes, struct hatch_err *err)
{
    uint32_t count = value_count(o, V);
    uint8_t *seen;
    HATCH_TRY(HATCH_ALLOC(o->scratch, &seen, count, err));
    for (uint32_t v = 0; v < o->vertex_count; v++)
        seen[vertex_corners(o)[v].index[V]] = 1;
    for (uint32_t i = 0; i < count; i++)
        notes->unreferenced_dropped += !seen[i];
    return HATCH_OK;
}

static enum hatch_status finish(struct obj *o, struct hatch_arena *arena, struct hatch_mesh *mesh,
                                struct hatch_mesh_notes *notes, struct hatch_err *err)
{
    struct hatch_vertices vertices = {value_count(o, V), values(o, V), NULL, NULL};
    if (!o->positions_only) {
        vertices.count = o->vertex_count;
        HATCH_TRY(count_unused(o, notes, err));
        HATCH_TRY(gather(o, V, 0, &vertices.positions, err));
        HATCH_TRY(gather(o, VN, 0, &vertices.normals, err));
        HATCH_TRY(gather(o, VT, NAN, &vertices.texcoords, err));
    }
    return hatch_faces_finish(&o->faces, &vertices, arena, mesh, notes, err);
}

enum hatch_status hatch_obj_read(struct hatch_bytes file, const double origin[3], struct hatch_arena *arena,
                                 struct hatch_arena *scratch, struct hatch_mesh *mesh, struct hatch_mesh_notes *notes,
                                 struct hatch_err *err)
{
    struct obj o = {.text = hatch_mesh_text_of(file), .origin = origin, .scratch = scratch};
    o.text.comment = '#';
    o.text.continues = true;
    o.positions_only = !has_slashes(o.text);
    for (int kind = 0; kind < KINDS; kind++)
        o.values[kind].arena = scratch;
    o.vertices.arena = o.points.arena = o.used.arena = scratch;
    o.faces = hatch_faces_in(scratch);
    do
        HATCH_TRY(read_line(&o, err));
    while (hatch_mesh_text_next_line(&o.text));
    notes->free_forms_dropped += o.free_forms;
    notes->library = o.library.length ? hatch_arena_text(arena, o.library.at, o.library.length, err) : NULL;
    if (o.library.length && !notes->library)
        return HATCH_LIMIT;
    return finish(&o, arena, mesh, notes, err);
}
