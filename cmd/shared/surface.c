#include "shared/surface.h"

#include <stdio.h>
#include <string.h>

static bool has_area(const struct hatch_mesh *mesh)
{
    double corners[3][3];
    for (uint32_t f = 0; f < mesh->face_count; f++)
        if (hatch_mesh_corners(mesh, f, corners))
            return true;
    return false;
}

/* Removes meshes without area from the scene and its nodes; returns how many were removed. */
static uint32_t drop_empty(struct cmd_args *args, const char *name, struct hatch_scene *scene)
{
    struct hatch_arena_mark mark = hatch_arena_mark(&args->scratch);
    struct hatch_err err;
    uint32_t all = scene->mesh_count;
    uint32_t *first;
    bool *kept;
    cmd_check(HATCH_ALLOC(&args->scratch, &first, (size_t)all + 1, &err), name, &err);
    cmd_check(HATCH_ALLOC(&args->scratch, &kept, all, &err), name, &err);
    for (uint32_t i = 0; i < all; i++)
        kept[i] = has_area(&scene->meshes[i].mesh);
    hatch_scene_keep(scene, kept, first);
    hatch_arena_rewind(&args->scratch, mark);
    return all - scene->mesh_count;
}

/* Returns whether the back of a mesh is drawn. */
static bool is_double_sided(const struct hatch_scene *scene, uint32_t mesh)
{
    uint32_t material = scene->meshes[mesh].material;
    return material == HATCH_NONE || scene->materials[material].double_sided;
}

/* Makes the materials of meshes double-sided, whose faces are given once for each side and are kept once. Materials
 * that other meshes have, too, are copied. Returns the number of meshes that were changed.
 *   both  per mesh: whether such faces were left out; changed */
static uint32_t show_backs(struct cmd_args *args, const char *name, bool *both, struct hatch_scene *scene)
{
    struct hatch_err err;
    struct hatch_material *materials;
    uint32_t changed = 0, count = scene->material_count;
    for (uint32_t i = 0; i < scene->mesh_count; i++) {
        both[i] = both[i] && !is_double_sided(scene, i);
        changed += both[i];
    }
    if (changed == 0)
        return 0;
    cmd_check(HATCH_ALLOC(&args->keep, &materials, 2 * (size_t)count, &err), name, &err);
    memcpy(materials, scene->materials, count * sizeof *materials);
    for (uint32_t m = 0; m < count; m++) {
        bool wanted = false, shared = false;
        for (uint32_t i = 0; i < scene->mesh_count; i++)
            *(both[i] ? &wanted : &shared) |= scene->meshes[i].material == m;
        uint32_t made = wanted && shared ? scene->material_count++ : m;
        materials[made] = materials[m];
        materials[made].double_sided |= wanted;
        for (uint32_t i = 0; i < scene->mesh_count; i++)
            if (both[i] && scene->meshes[i].material == m)
                scene->meshes[i].material = made;
    }
    scene->materials = materials;
    return changed;
}

static void add(struct hatch_surface_notes *sum, const struct hatch_surface_notes *notes)
{
    sum->welded += notes->welded;
    sum->degenerate += notes->degenerate;
    sum->duplicate += notes->duplicate;
    sum->unreferenced += notes->unreferenced;
    sum->flipped += notes->flipped;
    sum->edges_cut += notes->edges_cut;
    sum->points_split += notes->points_split;
    sum->contrary += notes->contrary;
    sum->components += notes->components;
}

static void warn(const char *name, const struct hatch_surface_notes *notes, uint32_t empty, uint32_t backs)
{
    const struct {
        uint32_t count;
        const char *one, *many;
    } repairs[] = {
        {empty, "mesh without an area left out", "meshes without an area left out"},
        {notes->unreferenced, "vertex that no face uses left out", "vertices that no face uses left out"},
        {notes->degenerate, "face without an area left out", "faces without an area left out"},
        {notes->duplicate, "face given twice left out", "faces given twice left out"},
        {backs, "mesh whose faces are given for both sides made double-sided",
         "meshes whose faces are given for both sides made double-sided"},
        {notes->welded, "vertex welded", "vertices welded"},
        {notes->flipped, "face flipped", "faces flipped"},
        {notes->edges_cut, "edge of more than two faces cut", "edges of more than two faces cut"},
        {notes->points_split, "point split where faces share no edge", "points split where faces share no edge"},
        {notes->contrary, "edge where a one-sided surface turns over", "edges where a one-sided surface turns over"},
    };
    char line[HATCH_ERR_TEXT_MAX * 2] = "";
    size_t length = 0;
    for (size_t i = 0; i < sizeof repairs / sizeof *repairs; i++)
        if (repairs[i].count)
            length += (size_t)snprintf(line + length, sizeof line - length, "%s%u %s", length ? ", " : "",
                                       repairs[i].count, cmd_plural(repairs[i].count, repairs[i].one, repairs[i].many));
    if (length)
        cmd_warn(name, "%s", line);
}

struct hatch_surface *cmd_make_surfaces(struct cmd_args *args, const char *path, struct hatch_scene *scene)
{
    const char *name = cmd_input_name(path);
    struct hatch_surface_notes sum = {0}, notes;
    struct hatch_err err;
    uint32_t empty = drop_empty(args, name, scene);
    if (scene->mesh_count == 0)
        cmd_check(hatch_fail(&err, HATCH_BAD_INPUT, "no face has an area"), name, &err);
    struct hatch_surface *surfaces;
    bool *both;
    cmd_check(HATCH_ALLOC(&args->keep, &surfaces, scene->mesh_count, &err), name, &err);
    cmd_check(HATCH_ALLOC(&args->keep, &both, scene->mesh_count, &err), name, &err);
    for (uint32_t i = 0; i < scene->mesh_count; i++) {
        const struct hatch_scene_mesh *from = &scene->meshes[i];
        cmd_check(hatch_surface_make_cut(&from->mesh, &args->keep, &args->scratch, &surfaces[i], &notes, &err), name,
                  &err);
        /* Several vertices at one position are no defect in a triangle soup, or where other attributes may differ
         * between them. */
        if (from->is_soup || from->mesh.attribute_count > 1)
            notes.welded = 0;
        if (hatch_mesh_find(&from->mesh, "_HATCH_DIR", 4)) /* dirfield has already reported these */
            notes.edges_cut = notes.points_split = notes.contrary = 0;
        both[i] = notes.reversed > 0;
        add(&sum, &notes);
    }
    warn(name, &sum, empty, show_backs(args, name, both, scene));
    cmd_note("%u %s", sum.components, cmd_plural(sum.components, "surface", "surfaces"));
    return surfaces;
}
