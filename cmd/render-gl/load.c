#include "render-gl/load.h"

#include <stdio.h>
#include <string.h>

#include "io/exr.h"
#include "io/gltf.h"
#include "io/mesh_file.h"

/* A glTF's companions lie beside it; context is the glTF's path. */
static enum hatch_status read_companion(void *context, const char *uri, struct hatch_arena *arena,
                                        struct hatch_bytes *bytes, struct hatch_err *err)
{
    const char *path = context, *slash = path ? strrchr(path, '/') : NULL;
    char joined[4096];
    int length = snprintf(joined, sizeof joined, "%.*s%s", slash ? (int)(slash - path) + 1 : 0,
                          path ? path : "", uri);
    if (length < 0 || (size_t)length >= sizeof joined)
        return hatch_fail(err, HATCH_BAD_INPUT, "companion file: name too long");
    return cmd_try_read(arena, joined, bytes, err);
}

static void say_notes(const char *name, const struct hatch_mesh_notes *notes)
{
    if (notes->degenerate_dropped)
        cmd_note("%s: %u faces without area dropped", name, notes->degenerate_dropped);
    if (notes->duplicates_dropped)
        cmd_note("%s: %u faces given twice dropped", name, notes->duplicates_dropped);
}

void load_scene(struct cmd_args *args, const char *path, struct hatch_scene *scene)
{
    const char *name = cmd_input_name(path);
    struct hatch_bytes file = cmd_read(args, path);
    struct hatch_err err;
    struct hatch_mesh_notes notes = {0};
    enum hatch_mesh_format format = hatch_mesh_format_of(file, path);
    if (format == HATCH_MESH_GLTF) {
        cmd_check(hatch_gltf_read(file, read_companion, (void *)path, &args->keep, &args->scratch,
                                  scene, &notes, &err),
                  name, &err);
    } else {
        struct hatch_mesh mesh;
        cmd_check(hatch_mesh_read(file, format, &args->keep, &args->scratch, &mesh, &notes, &err),
                  name, &err);
        cmd_check(hatch_mesh_add_normals(&args->keep, &args->scratch, &mesh, 0.0f, &err), name,
                  &err);
        cmd_check(hatch_scene_of_mesh(&mesh, &args->keep, scene, &err), name, &err);
    }
    say_notes(name, &notes);
}

void load_map(struct cmd_args *args, const char *path, struct hatch_tam *map)
{
    const char *name = cmd_input_name(path);
    struct hatch_bytes file = cmd_read(args, path);
    struct hatch_err err;
    struct hatch_mipmap *parts;
    uint32_t count;
    cmd_check(hatch_exr_read(file, &args->keep, &args->scratch, &parts, &count, &err), name, &err);
    cmd_check(hatch_tam_from_mipmaps(parts, count, map, &err), name, &err);
}

void load_check_texcoords(const struct hatch_scene *scene, const char *path)
{
    for (uint32_t i = 0; i < scene->mesh_count; i++) {
        if (hatch_mesh_find(&scene->meshes[i].mesh, "TEXCOORD_0", 2))
            continue;
        struct hatch_err err;
        hatch_fail(&err, HATCH_BAD_INPUT,
                   "mesh %u has no texture coordinates for strokes to follow: give it some with "
                   "your modelling program or with lapped-param",
                   i);
        cmd_die(cmd_input_name(path), &err);
    }
}
