/* Reads OFF (Geomview's object file format) in its text form, with optional texture coordinates (ST), colours (C) and
 * normals (N). They are skipped, as is the rest of any line after a position or a face's corners. */
#include <string.h>

#include "io/mesh/polygon.h"
#include "io/mesh/text.h"

size_t hatch_off_keyword(const char *at, size_t size)
{
    static const char *const parts[] = {"ST", "C", "N"};
    size_t length = 0;
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        size_t part = strlen(parts[i]);
        if (size - length >= part && memcmp(at + length, parts[i], part) == 0)
            length += part;
    }
    return size - length >= 3 && memcmp(at + length, "OFF", 3) == 0 ? length + 3 : 0;
}

/* Reads the keyword. In some files the counts follow it without a space ("OFF490 518 0"). */
static enum hatch_status read_header(struct hatch_mesh_text *text, struct hatch_err *err)
{
    struct hatch_text word = hatch_mesh_text_any_word(text);
    size_t length = hatch_off_keyword(word.at, word.length);
    if (!length)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: %.*s, want OFF", text->line, hatch_mesh_text_shown(word),
                          word.at);
    text->at = word.at + length;
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

enum hatch_status hatch_off_read(struct hatch_bytes file, const double origin[3], struct hatch_arena *arena,
                                 struct hatch_arena *scratch, struct hatch_mesh *mesh, struct hatch_mesh_notes *notes,
                                 struct hatch_err *err)
{
    struct hatch_mesh_text text = hatch_mesh_text_of(file);
    text.comment = '#';
    int64_t counts[2];
    HATCH_TRY(read_header(&text, err));
    HATCH_TRY(read_counts(&text, counts, err));
    float *positions;
    HATCH_TRY(HATCH_ALLOC(scratch, &positions, (size_t)counts[0] * 3, err));
    for (int64_t v = 0; v < counts[0]; v++) {
        if (!find_word(&text))
            return hatch_fail(err, HATCH_BAD_INPUT, "truncated after %lld of %lld vertices", (long long)v,
                              (long long)counts[0]);
        HATCH_TRY(hatch_mesh_text_position(&text, "vertex", origin, &positions[v * 3], err));
        hatch_mesh_text_next_line(&text);
    }
    struct hatch_faces faces = hatch_faces_in(scratch);
    struct hatch_buffer corners = {.arena = scratch};
    for (int64_t f = 0; f < counts[1]; f++) {
        if (!find_word(&text))
            return hatch_fail(err, HATCH_BAD_INPUT, "truncated after %lld of %lld faces", (long long)f,
                              (long long)counts[1]);
        HATCH_TRY(read_face(&text, counts[0], &corners, err));
        const uint32_t *corner = (const uint32_t *)(const void *)corners.data;
        HATCH_TRY(hatch_faces_add(&faces, positions, corner, corner, (uint32_t)(corners.size / sizeof *corner), err));
        hatch_mesh_text_next_line(&text);
    }
    const struct hatch_vertices vertices = {.count = (uint32_t)counts[0], .positions = positions};
    return hatch_faces_finish(&faces, &vertices, arena, mesh, notes, err);
}
