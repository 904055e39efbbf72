/* Reads OFF (Geomview's object file format) in its text form, with optional texture coordinates (ST), colours (C) and
 * normals (N) of the vertices. The rest of a line after these, or after a face's corners, is skipped. */
#include <math.h>
#include <string.h>

#include "io/mesh/polygon.h"
#include "io/mesh/text.h"

size_t hatch_off_keyword(const char *at, size_t size)
{
    static const char *const parts[] = {"ST", "C", "N"};
    bool taken[sizeof parts / sizeof *parts] = {false};
    size_t length = 0;
    for (bool more = true; more;) { /* in any order: MeshLab writes CSTOFF */
        more = false;
        for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
            size_t part = strlen(parts[i]);
            if (taken[i] || size - length < part || memcmp(at + length, parts[i], part) != 0)
                continue;
            taken[i] = more = true;
            length += part;
        }
    }
    return size - length >= 3 && memcmp(at + length, "OFF", 3) == 0 ? length + 3 : 0;
}

struct off {
    struct hatch_mesh_text text;
    const double *origin;
    float *positions, *normals, *texcoords, *colors; /* as in struct hatch_vertices, except for the range of colours */
    bool has_normals, has_texcoords, has_colors;     /* by the keyword */
};

/* Reads the keyword. In some files the counts follow it without a space ("OFF490 518 0"). */
static enum hatch_status read_header(struct off *o, struct hatch_err *err)
{
    struct hatch_text word = hatch_mesh_text_any_word(&o->text);
    size_t length = hatch_off_keyword(word.at, word.length);
    if (!length)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: %.*s, want OFF", o->text.line, hatch_mesh_text_shown(word),
                          word.at);
    o->has_texcoords = memchr(word.at, 'S', length) != NULL;
    o->has_colors = memchr(word.at, 'C', length) != NULL;
    o->has_normals = memchr(word.at, 'N', length) != NULL;
    o->text.at = word.at + length;
    return HATCH_OK;
}

/* Reads the counts and checks them against the size of the file: a vertex takes at least six bytes ("0 0 0\n"), a face
 * at least eight ("3 0 0 0\n"). */
static enum hatch_status read_counts(struct hatch_mesh_text *text, int64_t counts[2], struct hatch_err *err)
{
    static const char *const names[] = {"vertices", "faces"};
    static const int64_t bytes[] = {6, 8};
    for (int i = 0; i < 2; i++) {
        struct hatch_text word = hatch_mesh_text_any_word(text);
        if (!hatch_mesh_text_integer(word, &counts[i]) || counts[i] < 0)
            return hatch_fail(err, HATCH_BAD_INPUT, "line %u: %.*s is not a number of %s", text->line,
                              hatch_mesh_text_shown(word), word.at, names[i]);
        if (counts[i] > (int64_t)hatch_mesh_text_remaining(text) / bytes[i] + 1)
            return hatch_fail(err, HATCH_BAD_INPUT, "line %u: %.*s %s do not fit into %zu bytes", text->line,
                              hatch_mesh_text_shown(word), word.at, names[i], hatch_mesh_text_remaining(text));
    }
    hatch_mesh_text_next_line(text);
    return HATCH_OK;
}

/* Moves to the next word, on this or a later line; false at the end of the text. */
static bool find_word(struct hatch_mesh_text *text)
{
    struct hatch_mesh_text ahead = *text;
    struct hatch_text word = hatch_mesh_text_any_word(&ahead);
    if (word.length == 0)
        return false;
    text->at = word.at;
    text->line = ahead.line;
    return true;
}

static enum hatch_status read_face(struct hatch_mesh_text *text, int64_t vertex_count, struct hatch_buffer *corners,
                                   struct hatch_err *err)
{
    int64_t count, index;
    struct hatch_text word = hatch_mesh_text_word(text);
    if (!hatch_mesh_text_integer(word, &count) || count < 1)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: a face with %.*s corners, want a whole number over 0",
                          text->line, hatch_mesh_text_shown(word), word.at);
    corners->size = 0;
    for (int64_t i = 0; i < count; i++) {
        word = hatch_mesh_text_word(text);
        if (word.length == 0)
            return hatch_fail(err, HATCH_BAD_INPUT, "line %u: a face of %lld corners ends after %lld", text->line,
                              (long long)count, (long long)i);
        if (!hatch_mesh_text_integer(word, &index) || index < 0 || index >= vertex_count)
            return hatch_fail(err, HATCH_BAD_INPUT, "line %u: vertex %.*s does not exist, there are %lld", text->line,
                              hatch_mesh_text_shown(word), word.at, (long long)vertex_count);
        uint32_t corner = (uint32_t)index;
        HATCH_TRY(hatch_buffer_add(corners, &corner, sizeof corner, err));
    }
    return HATCH_OK;
}

static enum hatch_status allocate(struct off *o, size_t vertices, struct hatch_arena *scratch, struct hatch_err *err)
{
    HATCH_TRY(HATCH_ALLOC(scratch, &o->positions, vertices * 3, err));
    if (o->has_normals)
        HATCH_TRY(HATCH_ALLOC(scratch, &o->normals, vertices * 3, err));
    if (o->has_texcoords)
        HATCH_TRY(HATCH_ALLOC(scratch, &o->texcoords, vertices * 2, err));
    if (o->has_colors)
        HATCH_TRY(HATCH_ALLOC(scratch, &o->colors, vertices * 4, err));
    return HATCH_OK;
}

/* Reads the values of a vertex that follow its position: three numbers of the normal, three or four of the colour, and
 * two texture coordinates. Some may be missing. */
static void read_values(struct off *o, size_t vertex)
{
    float numbers[9];
    uint32_t first = 0, end = hatch_mesh_text_floats(&o->text, 9, numbers);
    if (o->has_normals && end >= 3) {
        memcpy(&o->normals[vertex * 3], numbers, 3 * sizeof *numbers);
        first = 3;
    }
    if (o->has_texcoords) {
        bool given = end >= first + 2;
        end -= given ? 2 : 0;
        for (size_t k = 0; k < 2; k++)
            o->texcoords[vertex * 2 + k] = given ? numbers[end + k] : NAN;
    }
    for (uint32_t k = 0; o->has_colors && k < 4; k++)
        o->colors[vertex * 4 + k] = end >= first + 3 && first + k < end ? numbers[first + k] : NAN;
}

/* Divides colours by 255 if any component is over 1: Geomview's are of 0 .. 1, but many programs write bytes. */
static void scale_colors(float *colors, size_t vertices)
{
    bool bytes = false;
    for (size_t i = 0; i < vertices * 4; i++)
        bytes = bytes || colors[i] > 1;
    for (size_t i = 0; bytes && i < vertices * 4; i++)
        colors[i] /= 255;
}

static enum hatch_status read_vertices(struct off *o, int64_t count, struct hatch_err *err)
{
    for (int64_t v = 0; v < count; v++) {
        if (!find_word(&o->text))
            return hatch_fail(err, HATCH_BAD_INPUT, "truncated after %lld of %lld vertices", (long long)v,
                              (long long)count);
        HATCH_TRY(hatch_mesh_text_position(&o->text, "vertex", o->origin, &o->positions[v * 3], err));
        read_values(o, (size_t)v);
        hatch_mesh_text_next_line(&o->text);
    }
    if (o->colors)
        scale_colors(o->colors, (size_t)count);
    return HATCH_OK;
}

enum hatch_status hatch_off_read(struct hatch_bytes file, const double origin[3], struct hatch_arena *arena,
                                 struct hatch_arena *scratch, struct hatch_mesh *mesh, struct hatch_mesh_notes *notes,
                                 struct hatch_err *err)
{
    struct off o = {.text = hatch_mesh_text_of(file), .origin = origin};
    o.text.comment = '#';
    int64_t counts[2];
    HATCH_TRY(read_header(&o, err));
    HATCH_TRY(read_counts(&o.text, counts, err));
    HATCH_TRY(allocate(&o, (size_t)counts[0], scratch, err));
    HATCH_TRY(read_vertices(&o, counts[0], err));
    struct hatch_faces faces = hatch_faces_in(scratch);
    struct hatch_buffer corners = {.arena = scratch};
    for (int64_t f = 0; f < counts[1]; f++) {
        if (!find_word(&o.text))
            return hatch_fail(err, HATCH_BAD_INPUT, "truncated after %lld of %lld faces", (long long)f,
                              (long long)counts[1]);
        HATCH_TRY(read_face(&o.text, counts[0], &corners, err));
        const uint32_t *corner = (const uint32_t *)(const void *)corners.data;
        HATCH_TRY(hatch_faces_add(&faces, o.positions, corner, corner, (uint32_t)(corners.size / sizeof *corner), err));
        hatch_mesh_text_next_line(&o.text);
    }
    const struct hatch_vertices vertices = {(uint32_t)counts[0], o.positions, o.normals, o.texcoords, o.colors};
    return hatch_faces_finish(&faces, &vertices, arena, mesh, notes, err);
}
