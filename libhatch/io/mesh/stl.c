/* Reads STL, binary and text. Each triangle has three vertices of its own. Normals are not read: many are wrong or
 * zero, and they follow from the corners. */
#include <math.h>
#include <string.h>

#include "io/mesh/polygon.h"
#include "io/mesh/text.h"

enum { HEADER = 80, TRIANGLE = 50 };

/* Compares a keyword without regard to case. */
static bool is(struct hatch_text word, const char *keyword)
{
    size_t i = 0;
    for (; i < word.length && keyword[i]; i++) {
        char c = word.at[i];
        if ((c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c) != keyword[i])
            return false;
    }
    return i == word.length && !keyword[i];
}

bool hatch_stl_begins(struct hatch_bytes file)
{
    struct hatch_mesh_text text = hatch_mesh_text_of(file);
    return is(hatch_mesh_text_any_word(&text), "solid");
}

/* Returns whether a file looks like text. Binary files may begin with "solid", too, but soon contain bytes that text
 * does not have. */
static bool looks_like_text(struct hatch_bytes file)
{
    const size_t checked = 1024;
    if (!hatch_stl_begins(file))
        return false;
    for (size_t i = 0; i < file.size && i < checked; i++)
        if (file.data[i] < '\t')
            return false;
    return true;
}

bool hatch_stl_has_size(struct hatch_bytes file)
{
    struct hatch_reader reader = hatch_reader_of(file);
    hatch_read_bytes(&reader, HEADER);
    uint64_t count = hatch_read_u32(&reader);
    return !reader.cut && file.size == HEADER + 4 + count * TRIANGLE;
}

static bool is_binary(struct hatch_bytes file)
{
    return file.size >= HEADER + 4 && (hatch_stl_has_size(file) || !looks_like_text(file));
}

static enum hatch_status make(size_t faces, struct hatch_arena *arena, struct hatch_mesh *mesh, struct hatch_err *err)
{
    if (faces == 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "no faces");
    if (faces > UINT32_MAX / 3 - 1)
        return hatch_fail(err, HATCH_LIMIT, "%zu triangles, a mesh holds at most %u", faces, UINT32_MAX / 3 - 1);
    uint32_t corners = (uint32_t)faces * 3;
    HATCH_TRY(hatch_mesh_make(arena, corners, (uint32_t)faces, mesh, err));
    for (uint32_t i = 0; i < corners; i++)
        mesh->indices[i] = i;
    return HATCH_OK;
}

static enum hatch_status read_binary(struct hatch_bytes file, const double origin[3], struct hatch_arena *arena,
                                     struct hatch_mesh *mesh, struct hatch_err *err)
{
    struct hatch_reader reader = hatch_reader_of(file);
    hatch_read_bytes(&reader, HEADER);
    uint32_t count = hatch_read_u32(&reader);
    if (hatch_reader_left(&reader) / TRIANGLE < count)
        return hatch_fail(
            err, HATCH_BAD_INPUT,
            "truncated: the header counts %u triangles, the file holds %zu (or this is a text STL that does "
            "not begin with solid)",
            count, hatch_reader_left(&reader) / TRIANGLE);
    struct hatch_mesh made;
    HATCH_TRY(make(count, arena, &made, err));
    float *to = made.attributes[0].data;
    for (uint32_t f = 0; f < count; f++) {
        hatch_read_bytes(&reader, 12);
        for (int i = 0; i < 9; i++) {
            *to = (float)((double)hatch_read_f32(&reader) - origin[i % 3]);
            if (!isfinite(*to++))
                return hatch_fail(err, HATCH_BAD_INPUT, "triangle %u: a position is not finite", f);
        }
        hatch_read_u16(&reader);
    }
    *mesh = made;
    return HATCH_OK;
}

/* State of reading an STL as text. */
struct solids {
    const double *origin;
    struct hatch_mesh_text text;
    struct hatch_buffer positions;
    uint32_t corners; /* corners so far in the facet being read */
    bool first;       /* the next word is the first of its line */
    bool in_name;     /* words belong to the name of a solid, which ends with the line or at a facet */
    bool ended;       /* the last solid has an endsolid */
};

static enum hatch_status read_word(struct solids *s, struct hatch_text word, struct hatch_err *err)
{
    bool first = s->first, facet = is(word, "facet");
    s->first = false;
    if (s->in_name && !facet)
        return HATCH_OK;
    s->in_name = is(word, "solid") || is(word, "endsolid");
    s->ended = s->in_name ? is(word, "endsolid") : s->ended;
    if (is(word, "vertex")) {
        float p[3];
        HATCH_TRY(hatch_mesh_text_position(&s->text, "vertex", s->origin, p, err));
        s->corners++;
        return hatch_buffer_add(&s->positions, p, sizeof p, err);
    }
    if (is(word, "endfacet")) {
        if (s->corners != 3)
            return hatch_fail(err, HATCH_BAD_INPUT, "line %u: a facet with %u corner%s, want 3", s->text.line,
                              s->corners, s->corners == 1 ? "" : "s");
        s->corners = 0;
        return HATCH_OK;
    }
    /* Skips normals, and any word that is not the first of its line. */
    if (!first || s->in_name || facet || is(word, "outer") || is(word, "endloop"))
        return HATCH_OK;
    return hatch_fail(err, HATCH_BAD_INPUT, "line %u: unknown keyword %.*s", s->text.line, hatch_mesh_text_shown(word),
                      word.at);
}

/* Reads an STL as text. Line ends matter only after the name of a solid, since some programs write no others. */
static enum hatch_status read_text(struct hatch_bytes file, const double origin[3], struct hatch_arena *arena,
                                   struct hatch_arena *scratch, struct hatch_mesh *mesh, struct hatch_err *err)
{
    struct solids s = {.origin = origin, .text = hatch_mesh_text_of(file), .positions = {.arena = scratch}};
    do {
        s.first = true;
        s.in_name = false;
        for (struct hatch_text word; (word = hatch_mesh_text_word(&s.text)).length > 0;)
            HATCH_TRY(read_word(&s, word, err));
    } while (hatch_mesh_text_next_line(&s.text));
    if (!s.ended || s.corners)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: truncated before endsolid", s.text.line);
    struct hatch_mesh made;
    HATCH_TRY(make(s.positions.size / (9 * sizeof(float)), arena, &made, err));
    memcpy(made.attributes[0].data, s.positions.data, s.positions.size);
    *mesh = made;
    return HATCH_OK;
}

enum hatch_status hatch_stl_read(struct hatch_bytes file, const double origin[3], struct hatch_arena *arena,
                                 struct hatch_arena *scratch, struct hatch_mesh *mesh, struct hatch_mesh_notes *notes,
                                 struct hatch_err *err)
{
    (void)notes;
    return is_binary(file) ? read_binary(file, origin, arena, mesh, err)
                           : read_text(file, origin, arena, scratch, mesh, err);
}
