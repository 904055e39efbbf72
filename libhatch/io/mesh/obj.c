/* Reads Wavefront OBJ: positions, texture coordinates, normals and polygons. Each distinct triple of their indices
 * becomes a vertex of the mesh, in order of first use. If all faces have position indices only, the vertices of the
 * mesh are those of the file. */
#include <math.h>
#include <string.h>

#include "io/mesh/corners.h"
#include "io/mesh/polygon.h"
#include "io/mesh/text.h"

enum { V, VT, VN, KINDS };
_Static_assert(KINDS == HATCH_CORNER_PARTS, "the parts of a corner are indices of the kinds");

struct obj {
    struct hatch_mesh_text text;
    const double *origin;
    struct hatch_buffer values[KINDS]; /* 3, 2 and 3 floats per value */
    struct hatch_buffer colors;        /* 4 floats for each position; empty before the first colour */
    bool positions_only;               /* faces have position indices only */
    struct hatch_corners corners;      /* empty if positions_only */
    struct hatch_buffer points, used;  /* of the face being read: indices of its positions; indices of its vertices */
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

/* Adds colours that the file does not give, so that there are as many as count. */
static enum hatch_status pad_colors(struct obj *o, uint32_t count, struct hatch_err *err)
{
    static const float missing[4] = {NAN, NAN, NAN, NAN};
    while (o->colors.size < count * sizeof missing)
        HATCH_TRY(hatch_buffer_add(&o->colors, missing, sizeof missing, err));
    return HATCH_OK;
}

/* Reads a vertex: its position and, after it, its colour, which many programs add. */
static enum hatch_status read_vertex(struct obj *o, struct hatch_err *err)
{
    float color[4];
    HATCH_TRY(read_value(o, V, err));
    if (hatch_mesh_text_floats(&o->text, 3, color) < 3)
        return HATCH_OK;
    color[3] = 1;
    HATCH_TRY(pad_colors(o, value_count(o, V) - 1, err));
    return hatch_buffer_add(&o->colors, color, sizeof color, err);
}

/* Reads a corner: "7", "7/1", "7//3" or "7/1/3". Negative indices count back from the last value read. */
static enum hatch_status read_corner(const struct obj *o, struct hatch_text word, struct hatch_corner *corner,
                                     struct hatch_err *err)
{
    const char *at = word.at, *end = word.at + word.length;
    for (int kind = 0; kind < KINDS; kind++) {
        corner->part[kind] = HATCH_CORNER_ABSENT;
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
            corner->part[kind] = (uint32_t)(number > 0 ? number - 1 : count + number);
        }
        at = stop < end ? stop + 1 : end;
    }
    if (at != end)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: corner %.*s has more than three parts", o->text.line,
                          hatch_mesh_text_shown(word), word.at);
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
        struct hatch_corner corner;
        if (word.length == 0)
            break;
        HATCH_TRY(read_corner(o, word, &corner, err));
        uint32_t vertex = corner.part[V];
        if (!o->positions_only)
            HATCH_TRY(hatch_corners_add(&o->corners, &corner, &vertex, err));
        HATCH_TRY(hatch_buffer_add(&o->points, &corner.part[V], sizeof vertex, err));
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
        return read_vertex(o, err);
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

static enum hatch_status gather(const struct obj *o, int kind, float missing, const float **out, struct hatch_err *err)
{
    return hatch_corners_gather(&o->corners, kind, values(o, kind), widths[kind], missing, out, err);
}

static enum hatch_status finish(struct obj *o, struct hatch_arena *arena, struct hatch_mesh *mesh,
                                struct hatch_mesh_notes *notes, struct hatch_err *err)
{
    struct hatch_vertices vertices = {value_count(o, V), values(o, V), NULL, NULL, NULL};
    if (o->colors.size > 0) {
        HATCH_TRY(pad_colors(o, vertices.count, err));
        vertices.colors = (const float *)(const void *)o->colors.data;
    }
    if (!o->positions_only) {
        vertices.count = o->corners.count;
        notes->numbers_end = value_count(o, V);
        HATCH_TRY(hatch_corners_numbers(&o->corners, arena, &notes->numbers, err));
        HATCH_TRY(hatch_corners_count_unused(&o->corners, value_count(o, V), &notes->unreferenced_dropped, err));
        HATCH_TRY(gather(o, V, 0, &vertices.positions, err));
        HATCH_TRY(gather(o, VN, 0, &vertices.normals, err));
        if (vertices.colors)
            HATCH_TRY(hatch_corners_gather(&o->corners, V, vertices.colors, 4, 0, &vertices.colors, err));
        HATCH_TRY(gather(o, VT, NAN, &vertices.texcoords, err));
    }
    return hatch_faces_finish(&o->faces, &vertices, arena, mesh, notes, err);
}

enum hatch_status hatch_obj_read(struct hatch_bytes file, const double origin[3], struct hatch_arena *arena,
                                 struct hatch_arena *scratch, struct hatch_mesh *mesh, struct hatch_mesh_notes *notes,
                                 struct hatch_err *err)
{
    struct obj o = {.text = hatch_mesh_text_of(file), .origin = origin, .corners = hatch_corners_in(scratch)};
    o.text.comment = '#';
    o.text.continues = true;
    o.positions_only = !has_slashes(o.text);
    for (int kind = 0; kind < KINDS; kind++)
        o.values[kind].arena = scratch;
    o.colors.arena = o.points.arena = o.used.arena = scratch;
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
