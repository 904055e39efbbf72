#include "shared/scene.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/gltf/gltf.h"
#include "io/mesh/file.h"
#include "scene/up.h"

/* The folder of a glTF. */
struct folder {
    const char *path; /* of the glTF */
    struct cmd_companions *companions;
};

/* Adds a file to a list, unless it is there; NULL: there is no list. */
static enum hatch_status list_companion(struct cmd_companions *companions, const char *path, size_t bytes,
                                        struct hatch_err *err)
{
    if (!companions)
        return HATCH_OK;
    struct cmd_companion **at = &companions->first;
    while (*at && strcmp((*at)->path, path) != 0)
        at = &(*at)->next;
    if (*at)
        return HATCH_OK;
    struct cmd_companion *added = HATCH_NEW(companions->arena, struct cmd_companion, 1, err);
    char *copy = hatch_arena_text(companions->arena, path, strlen(path), err);
    if (!added || !copy)
        return HATCH_LIMIT;
    *added = (struct cmd_companion){.path = copy, .bytes = bytes};
    *at = added;
    return HATCH_OK;
}

/* Reads a companion file of a glTF.
 *   context  its folder
 *   uri      relative to that */
static enum hatch_status read_companion(void *context, const char *uri, struct hatch_arena *arena,
                                        struct hatch_bytes *bytes, struct hatch_err *err)
{
    const struct folder *folder = context;
    const char *path = folder->path, *slash = strrchr(path, '/');
    char joined[4096];
    int length = snprintf(joined, sizeof joined, "%.*s%s", slash ? (int)(slash - path) + 1 : 0, path, uri);
    if (length < 0 || (size_t)length >= sizeof joined)
        return hatch_fail(err, HATCH_BAD_INPUT, "%.100s: the path is too long", uri);
    /* Opening a pipe would wait for a writer, and reading a device might never end. */
    struct stat info;
    if (stat(joined, &info) == 0 && !S_ISREG(info.st_mode) && !S_ISDIR(info.st_mode))
        return hatch_fail(err, HATCH_BAD_INPUT, "%s: is a pipe or a device, not a file", uri);
    enum hatch_status status = cmd_try_read(arena, joined, bytes, err);
    return status == HATCH_OK ? list_companion(folder->companions, joined, bytes->size, err)
                              : hatch_fail_at(err, "%s: ", uri);
}

/* A warning that begins with a count; 0: there is none. */
struct warning {
    uint32_t count;
    const char *one, *many;
};

static void warn_all(const char *name, const struct warning *warnings, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (warnings[i].count > 0)
            cmd_warn(name, "%u %s", warnings[i].count,
                     cmd_plural(warnings[i].count, warnings[i].one, warnings[i].many));
}

void cmd_warn_mesh(const char *name, const struct hatch_mesh_notes *notes)
{
    const struct warning warnings[] = {
        {notes->degenerate_dropped, "face without an area is left out", "faces without an area are left out"},
        {notes->duplicates_dropped, "face given twice is left out", "faces given twice are left out"},
        {notes->unreferenced_dropped, "vertex that no face uses is left out",
         "vertices that no face uses are left out"},
        {notes->vertices_apart, "vertex has the position of another one and counts as the same",
         "vertices have the position of others and count as the same"},
        {notes->faces_flipped, "face has the opposite orientation to its neighbours",
         "faces have the opposite orientation to their neighbours"},
        {notes->non_manifold_edges, "edge has more than two faces", "edges have more than two faces"},
        {notes->non_manifold_points, "point joins faces that share no edge there",
         "points join faces that share no edge there"},
        {notes->contrary_edges, "edge between faces that cannot be oriented alike: the surface has one side only",
         "edges between faces that cannot be oriented alike: the surface has one side only"},
        {notes->primitives_skipped, "set of points or lines is skipped", "sets of points or lines are skipped"},
        {notes->primitives_unplaced, "primitive without positions is skipped",
         "primitives without positions are skipped"},
        {notes->free_forms_dropped, "free-form curve or surface is left out",
         "free-form curves or surfaces are left out"},
        {notes->texcoords_missing, "vertex has no texture coordinates: those of the others are not used",
         "vertices have no texture coordinates: those of the others are not used"},
        {notes->morphs_ignored, "mesh has morph targets that nothing moves: it stays as at rest",
         "meshes have morph targets that nothing moves: they stay as at rest"},
        {notes->attributes_dropped, "vertex attribute is left out: unknown, or more than a mesh holds",
         "vertex attributes are left out: unknown, or more than a mesh holds"},
        {notes->colors_replaced, "colour is not a finite number and is read as 0",
         "colours are not finite numbers and are read as 0"},
        {notes->normals_replaced, "normal is missing or has no length and is replaced by that of a face",
         "normals are missing or have no length and are replaced by those of faces"},
        {notes->joints_dropped, "vertex has more than four joints: the four that weigh most are used",
         "vertices have more than four joints: the four that weigh most are used"},
        {notes->normals_not_unit, "normal is not of length 1: only its direction is used",
         "normals are not of length 1: only their directions are used"},
        {notes->normals_inward, "normal points inwards, against its faces: it is used as it is",
         "normals point inwards, against their faces: they are used as they are"},
        {notes->meshes_inside_out, "closed mesh is inside out: its faces are used as they are",
         "closed meshes are inside out: their faces are used as they are"},
        {notes->needles, "face is a needle, over 1000 times as long as high: it is used as it is",
         "faces are needles, over 1000 times as long as high: they are used as they are"},
        {notes->texcoords_flat, "mesh has the same texture coordinates everywhere: strokes have no direction on it",
         "meshes have the same texture coordinates everywhere: strokes have no direction on them"},
        {notes->weights_wrong, "vertex has joint weights that do not add up to 1: they count as shares of their sum",
         "vertices have joint weights that do not add up to 1: they count as shares of their sum"},
        {notes->nodes_flat, "node has a scale of 0: its meshes are flat",
         "nodes have a scale of 0: their meshes are flat"},
        {notes->transparent_dropped, "transparent mesh is left out", "transparent meshes are left out"},
    };
    warn_all(name, warnings, sizeof warnings / sizeof *warnings);
    if (notes->images_missing)
        cmd_warn(
            name, "%u %s left out: %s%s", notes->images_missing,
            cmd_plural(notes->images_missing, "image could not be read and is", "images could not be read and are"),
            notes->image_missing, cmd_plural(notes->images_missing, "", " and others"));
}

/* Warns of the parts of a file that a scene does not have.
 *   textures  whether images matter */
static void warn_lost(const char *name, bool textures, const struct hatch_mesh_notes *notes)
{
    const struct warning warnings[] = {
        {notes->scenes_dropped, "scene is left out: only the default one is read",
         "scenes are left out: only the default one is read"},
        {notes->meshes_undrawn, "mesh that no node draws is left out", "meshes that no node draws are left out"},
        {notes->levels_dropped, "node has levels of detail, which are left out: meshfit --levels makes them",
         "nodes have levels of detail, which are left out: meshfit --levels makes them"},
        {textures ? notes->images_dropped : 0,
         "image is neither PNG nor JPEG nor WebP or could not be read, and is left out",
         "images are neither PNG nor JPEG nor WebP or could not be read, and are left out"},
        {notes->attributes_rounded, "vertex attribute has integers over 16777216: they are rounded to floats",
         "vertex attributes have integers over 16777216: they are rounded to floats"},
    };
    warn_all(name, warnings, sizeof warnings / sizeof *warnings);
    if (notes->extensions_dropped > 0)
        cmd_warn(name, "%u %s left out: %s", notes->extensions_dropped,
                 cmd_plural(notes->extensions_dropped, "extension is", "extensions are"), notes->extension_dropped);
}

/* Warns of a material library that is not beside its OBJ file.
 *   library  NULL: none */
static void warn_library(const char *path, const char *library)
{
    char joined[4096];
    const char *slash = strrchr(path, '/');
    if (!library)
        return;
    snprintf(joined, sizeof joined, "%.*s%s", slash && library[0] != '/' ? (int)(slash - path) + 1 : 0, path, library);
    if (access(joined, F_OK) != 0)
        cmd_warn(path, "material library %s does not exist: materials of OBJ files are not used", library);
}

void cmd_add_normals(struct cmd_args *args, const char *name, struct hatch_scene *scene)
{
    struct hatch_err err;
    for (uint32_t m = 0; scene->up_undefined && m < scene->mesh_count; m++) {
        struct hatch_scene_mesh *mesh = &scene->meshes[m];
        if (mesh->had_normals)
            continue;
        cmd_check(hatch_mesh_add_normals(&args->keep, &args->scratch, &mesh->mesh, CMD_CREASE_RAD, &err), name, &err);
        mesh->had_normals = true;
        mesh->file_vertices = mesh->mesh.vertex_count;
        mesh->numbers = NULL;
    }
}

void cmd_warn_up(const char *name, const struct hatch_scene *scene)
{
    if (scene->up_undefined && hatch_mesh_stands_along_z(&scene->meshes[0].mesh))
        cmd_warn(name, "the mesh seems to stand along z, but y points up: to turn it, draw it with render-gl --up z");
}

void cmd_warn_strokes(const char *name, const struct hatch_scene *scene)
{
    for (uint32_t i = 0; i < scene->mesh_count; i++)
        if (scene->meshes[i].curves.count > 0) {
            cmd_warn(name, "its strokes are left out; strokegen traces them anew");
            return;
        }
}

void cmd_refuse_lapped(const char *name, const struct hatch_scene *scene)
{
    struct hatch_err err;
    for (uint32_t i = 0; i < scene->mesh_count; i++) {
        uint32_t material = scene->meshes[i].material;
        if (material != HATCH_NONE && scene->materials[material].outline)
            cmd_check(hatch_fail(&err, HATCH_BAD_INPUT, "is lapped already: use the file that it was made from"), name,
                      &err);
    }
}

static bool is_file(const char *path)
{
    return path && strcmp(path, "-") != 0;
}

void cmd_read_scene_silently(struct cmd_args *args, const char *path, enum cmd_scene_cleaning care,
                             struct hatch_scene *scene, struct hatch_mesh_notes *notes,
                             struct cmd_companions *companions)
{
    const char *name = cmd_input_name(path);
    struct hatch_bytes file = cmd_read(args, path);
    struct hatch_mesh mesh;
    struct hatch_err err;
    enum hatch_mesh_format format = hatch_mesh_format_of(file, path);
    if (format == HATCH_MESH_GLTF) {
        struct folder folder = {path, companions};
        const struct hatch_gltf_resolver resolver = {read_companion, &folder};
        cmd_check(
            hatch_gltf_read(file, is_file(path) ? &resolver : NULL, &args->keep, &args->scratch, scene, notes, &err),
            name, &err);
    } else {
        const uint32_t apart = notes->vertices_apart; /* of the files before */
        double origin[3];
        notes->library = NULL;
        notes->numbers = NULL;
        cmd_check(hatch_mesh_read((struct hatch_mesh_file){file, format}, &args->keep, &args->scratch, &mesh, origin,
                                  notes, &err),
                  name, &err);
        if (care == CMD_SCENE_CLEANED)
            cmd_check(hatch_mesh_clean(&args->keep, &args->scratch, &mesh, notes, &err), name, &err);
        cmd_check(hatch_scene_of_mesh(&mesh, &args->keep, scene, &err), name, &err);
        for (int k = 0; k < 3; k++) /* large coordinates are moved to the node, to keep their precision */
            scene->nodes[0].translation[k] = origin[k];
        if (is_file(path))
            warn_library(path, notes->library);
        if (care == CMD_SCENE_AS_IS) {
            scene->meshes[0].numbers = notes->numbers;
            scene->meshes[0].numbers_end = notes->numbers_end;
        }
        scene->up_undefined = true;
        scene->meshes[0].is_soup = format == HATCH_MESH_STL;
        if (scene->meshes[0].is_soup)
            notes->vertices_apart = apart;
    }
}

static void read_scene(struct cmd_args *args, const char *path, enum cmd_scene_cleaning care, struct hatch_scene *scene,
                       struct hatch_mesh_notes *notes)
{
    struct hatch_err err;
    *notes = (struct hatch_mesh_notes){0};
    cmd_read_scene_silently(args, path, care, scene, notes, NULL);
    if (scene->mesh_count == 0 && notes->primitives_skipped > 0)
        cmd_check(hatch_fail(&err, HATCH_BAD_INPUT, "no faces, only %u set%s of points or lines",
                             notes->primitives_skipped, notes->primitives_skipped == 1 ? "" : "s"),
                  cmd_input_name(path), &err);
    if (scene->mesh_count == 0 && notes->primitives_unplaced > 0)
        cmd_check(hatch_fail(&err, HATCH_BAD_INPUT, "no faces: primitives with no POSITION"), cmd_input_name(path),
                  &err);
    hatch_scene_doubt(scene, &args->scratch, notes);
    cmd_warn_mesh(cmd_input_name(path), notes);
}

void cmd_read_scene(struct cmd_args *args, const char *path, enum cmd_scene_cleaning care, struct hatch_scene *scene)
{
    struct hatch_mesh_notes notes;
    read_scene(args, path, care, scene, &notes);
}

void cmd_read_scene_to_write(struct cmd_args *args, const char *path, bool textures, struct hatch_scene *scene)
{
    struct hatch_mesh_notes notes;
    read_scene(args, path, CMD_SCENE_AS_IS, scene, &notes);
    warn_lost(cmd_input_name(path), textures, &notes);
}
