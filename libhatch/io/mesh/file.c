#include "io/mesh/file.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "io/mesh/polygon.h"
#include "io/mesh/text.h"

/* Largest distance from the origin, in extents of the mesh; floats are spaced there by up to 2^-15 of the extent. */
#define FAR 256

static bool starts_with(struct hatch_bytes file, const char *magic)
{
    size_t length = strlen(magic);
    return file.size >= length && memcmp(file.data, magic, length) == 0;
}

static uint8_t first_visible(struct hatch_bytes file)
{
    for (size_t i = 0; i < file.size; i++)
        if (file.data[i] > ' ')
            return file.data[i];
    return 0;
}

/* Returns what follows lines of comments and empty ones. */
static struct hatch_bytes after_comments(struct hatch_bytes file)
{
    struct hatch_mesh_text text = hatch_mesh_text_of(file);
    text.comment = '#';
    struct hatch_text word = hatch_mesh_text_any_word(&text);
    return (struct hatch_bytes){(const uint8_t *)word.at, (size_t)(text.end - word.at)};
}

/* Returns whether a file looks like OBJ. The format has no magic word, so the first line that is not a comment must
 * begin with a common keyword. */
static bool looks_like_obj(struct hatch_bytes file)
{
    const struct hatch_bytes rest = after_comments(file);
    static const char *const words[] = {"v", "vt", "vn", "o", "g", "mtllib", "usemtl", NULL};
    for (const char *const *w = words; *w; w++) {
        size_t length = strlen(*w);
        if (starts_with(rest, *w) && rest.size > length && (rest.data[length] == ' ' || rest.data[length] == '\t'))
            return true;
    }
    return false;
}

static enum hatch_mesh_format by_content(struct hatch_bytes file)
{
    const struct hatch_bytes rest = after_comments(file);
    if (starts_with(file, "glTF"))
        return HATCH_MESH_GLTF;
    if (hatch_stl_has_size(file))
        return HATCH_MESH_STL;
    if (first_visible(file) == '{')
        return HATCH_MESH_GLTF;
    if (starts_with(file, "ply"))
        return HATCH_MESH_PLY;
    if (hatch_off_keyword((const char *)rest.data, rest.size))
        return HATCH_MESH_OFF;
    return starts_with(file, "solid") || hatch_stl_begins(file) ? HATCH_MESH_STL : HATCH_MESH_UNKNOWN;
}

enum hatch_mesh_format hatch_mesh_format_of(struct hatch_bytes file, const char *name)
{
    static const struct {
        const char *extension;
        enum hatch_mesh_format format;
    } extensions[] = {
        {".glb", HATCH_MESH_GLTF}, {".gltf", HATCH_MESH_GLTF}, {".ply", HATCH_MESH_PLY},
        {".obj", HATCH_MESH_OBJ},  {".off", HATCH_MESH_OFF},   {".stl", HATCH_MESH_STL},
    };
    struct hatch_mesh_text text = hatch_mesh_text_of(file);
    file = (struct hatch_bytes){(const uint8_t *)text.at, hatch_mesh_text_remaining(&text)};
    struct hatch_text ending = {name, name ? strlen(name) : 0};
    enum hatch_mesh_format format = by_content(file);
    for (size_t i = 0; !format && i < sizeof extensions / sizeof *extensions; i++)
        if (hatch_mesh_has_extension(ending, extensions[i].extension))
            format = extensions[i].format;
    return !format && looks_like_obj(file) ? HATCH_MESH_OBJ : format;
}

/* Returns whether a mesh is so far from the origin that floats are coarse for its size.
 *   origin  out: the mesh's centre on the axes along which it is far, 0 on the others */
static bool is_far(const struct hatch_mesh *mesh, double origin[3])
{
    float low[3], high[3];
    double extent = 0;
    bool far = false, any = hatch_mesh_bounds(mesh, low, high);
    for (int k = 0; k < 3 && any; k++)
        extent = fmax(extent, (double)high[k] - (double)low[k]);
    for (int k = 0; k < 3; k++) {
        double centre = any ? 0.5 * ((double)low[k] + (double)high[k]) : 0;
        bool axis_far = fabs(centre) > FAR * extent;
        origin[k] = axis_far ? (double)(float)centre : 0;
        far = far || axis_far;
    }
    return far;
}

enum hatch_status hatch_mesh_read(struct hatch_mesh_file file, struct hatch_arena *arena, struct hatch_arena *scratch,
                                  struct hatch_mesh *mesh, double origin[3], struct hatch_mesh_notes *notes,
                                  struct hatch_err *err)
{
    static const hatch_mesh_reader readers[] = {[HATCH_MESH_PLY] = hatch_ply_read,
                                                [HATCH_MESH_OBJ] = hatch_obj_read,
                                                [HATCH_MESH_OFF] = hatch_off_read,
                                                [HATCH_MESH_STL] = hatch_stl_read};
    assert(file.format != HATCH_MESH_GLTF);
    if (file.bytes.size == 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "empty");
    if (file.format == HATCH_MESH_UNKNOWN)
        return hatch_fail(err, HATCH_BAD_INPUT, "not a GLB, glTF, PLY, OBJ, OFF or STL file");
    struct hatch_arena_mark mark = hatch_arena_mark(scratch), kept = hatch_arena_mark(arena);
    struct hatch_mesh_notes noted = *notes;
    struct hatch_mesh made;
    double centre[3] = {0, 0, 0};
    enum hatch_status status = readers[file.format](file.bytes, centre, arena, scratch, &made, &noted, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK && origin && is_far(&made, centre)) {
        hatch_arena_rewind(arena, kept);
        noted = *notes;
        status = readers[file.format](file.bytes, centre, arena, scratch, &made, &noted, err);
        hatch_arena_rewind(scratch, mark);
    }
    if (status == HATCH_OK)
        status = hatch_mesh_check(&made, err);
    HATCH_TRY(status);
    *mesh = made;
    *notes = noted;
    if (origin)
        memcpy(origin, centre, sizeof centre);
    return HATCH_OK;
}
