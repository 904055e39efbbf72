/* Levels of detail: the nodes that carry coarser meshes. */
#include <math.h>
#include <string.h>

#include "math/vector.h"
#include "meshfit.h"

#define FRAMED 0.85 /* share of the picture that a framed scene fills */

/* The scene that is being made. */
struct making {
    struct meshfit *fit;
    struct hatch_scene *scene; /* its nodes, meshes and animations are copies with room for more */
    uint32_t levels;
    uint32_t *carrier; /* per node of the first scene: the node that draws its meshes; HATCH_NONE: it draws none */
    float *coverage;   /* per node of the first scene and level: the least share of the picture for which it is drawn */
};

/* Finds the box of a node's meshes at rest, in the world.
 *   low, high  out: low is above high if they have no vertices */
static void find_box(struct meshfit *fit, uint32_t node, double low[3], double high[3])
{
    const struct hatch_node *at = &fit->scene->nodes[node];
    struct hatch_arena *scratch = &fit->args->scratch;
    struct hatch_err err;
    for (int k = 0; k < 3; k++) {
        low[k] = INFINITY;
        high[k] = -INFINITY;
    }
    for (uint32_t m = at->first_mesh; m < at->first_mesh + at->mesh_count; m++) {
        struct hatch_arena_mark mark = hatch_arena_mark(scratch);
        size_t count = fit->scene->meshes[m].mesh.vertex_count;
        double *places;
        cmd_check(HATCH_ALLOC(scratch, &places, 3 * count, &err), fit->name, &err);
        hatch_pose_vertices(&fit->pose, node, m, places, NULL);
        for (size_t i = 0; i < 3 * count; i++) {
            low[i % 3] = fmin(low[i % 3], places[i]);
            high[i % 3] = fmax(high[i % 3], places[i]);
        }
        hatch_arena_rewind(scratch, mark);
    }
}

/* Returns the share that a node's meshes have of what the scene fills of the picture, at most 1: in the views in which
 * each is largest, as if both were balls around their boxes. */
static double share_of(struct meshfit *fit, uint32_t node)
{
    double low[3], high[3], middle[3];
    find_box(fit, node, low, high);
    if (fit->bounds.empty || !(low[0] <= high[0]))
        return 1;
    for (int k = 0; k < 3; k++)
        middle[k] = 0.5 * high[k] + 0.5 * low[k];
    double size = hatch_vec_distance(low, high) / 2 * hatch_views_pixels(&fit->views, middle);
    double whole = fit->bounds.radius * hatch_views_pixels(&fit->views, fit->bounds.center);
    return fmin(size * size / (whole * whole), 1);
}

/* Sets how large a node's meshes are in the picture at each level. Where all of the scene is half as large as framed, a
 * quarter of the picture, twice the error is as small. */
static void set_coverage(struct making *making, uint32_t node, float *coverage)
{
    double share = FRAMED * share_of(making->fit, node);
    for (uint32_t level = 0; level + 1 < making->levels; level++)
        coverage[level] = (float)ldexp(share, -2 * (int)(level + 1));
}

/* Returns a node that draws the meshes of another at its place. */
static struct hatch_node carrier_of(const struct hatch_node *from, uint32_t first_mesh)
{
    return (struct hatch_node){.parent = HATCH_NONE,
                               .rotation = {0, 0, 0, 1},
                               .scale = {1, 1, 1},
                               .first_mesh = first_mesh,
                               .mesh_count = from->mesh_count,
                               .weights = from->weights,
                               .skin = from->skin,
                               .camera = HATCH_NONE,
                               .light = HATCH_NONE};
}

/* Moves the meshes of each node to a child of it, so that its other children and its animation are at all levels. */
static void add_nodes(struct making *making, uint32_t node_count, uint32_t mesh_count)
{
    struct hatch_scene *scene = making->scene;
    for (uint32_t n = 0; n < node_count; n++) {
        struct hatch_node *node = &scene->nodes[n];
        making->carrier[n] = HATCH_NONE;
        if (node->mesh_count == 0)
            continue;
        making->carrier[n] = scene->node_count;
        float *coverage = making->coverage + (size_t)n * making->levels;
        set_coverage(making, n, coverage);
        scene->lods[scene->lod_count++] =
            (struct hatch_lod){scene->node_count, scene->node_count + 1, making->levels - 1, coverage};
        for (uint32_t level = 0; level < making->levels; level++)
            scene->nodes[scene->node_count++] = carrier_of(node, node->first_mesh + level * mesh_count);
        /* A skinned mesh ignores the transforms of its parents, and should have none. */
        scene->nodes[making->carrier[n]].parent = node->skin == HATCH_NONE ? n : HATCH_NONE;
        node->mesh_count = 0;
        node->weights = NULL;
        node->skin = HATCH_NONE;
    }
}

/* Lets the channels of morph targets' weights act on the carriers of all levels. */
static void add_channels(struct making *making, struct hatch_animation *animation)
{
    struct hatch_err err;
    struct hatch_animation_channel *channels;
    size_t most = (size_t)animation->channel_count * making->levels;
    uint32_t count = 0;
    cmd_check(HATCH_ALLOC(&making->fit->args->keep, &channels, most, &err), making->fit->name, &err);
    for (uint32_t c = 0; c < animation->channel_count; c++) {
        uint32_t node = animation->channels[c].node;
        bool moves = animation->channels[c].path == HATCH_PATH_WEIGHTS && making->carrier[node] != HATCH_NONE;
        for (uint32_t level = 0; level < (moves ? making->levels : 1); level++) {
            channels[count] = animation->channels[c];
            channels[count++].node = moves ? making->carrier[node] + level : node;
        }
    }
    animation->channels = channels;
    animation->channel_count = count;
}

static void allocate(struct making *making, const struct hatch_scene *from)
{
    struct hatch_arena *keep = &making->fit->args->keep;
    const char *name = making->fit->name;
    struct hatch_scene *scene = making->scene;
    struct hatch_err err;
    size_t nodes = from->node_count, levels = making->levels;
    if (levels * from->mesh_count > UINT32_MAX || nodes * (levels + 1) > UINT32_MAX)
        cmd_check(hatch_fail(&err, HATCH_LIMIT, "too many nodes and meshes for %u levels", making->levels), name, &err);
    cmd_check(HATCH_ALLOC(keep, &scene->nodes, nodes * (levels + 1), &err), name, &err);
    cmd_check(HATCH_ALLOC(keep, &scene->meshes, levels * from->mesh_count, &err), name, &err);
    cmd_check(HATCH_ALLOC(keep, &scene->animations, from->animation_count, &err), name, &err);
    cmd_check(HATCH_ALLOC(keep, &scene->lods, nodes, &err), name, &err);
    cmd_check(HATCH_ALLOC(keep, &making->carrier, nodes, &err), name, &err);
    cmd_check(HATCH_ALLOC(keep, &making->coverage, nodes * levels, &err), name, &err);
    memcpy(scene->nodes, from->nodes, nodes * sizeof *from->nodes);
    if (from->animation_count > 0)
        memcpy(scene->animations, from->animations, from->animation_count * sizeof *from->animations);
}

/* Returns whether a mesh was made of another, and is not that itself. */
static bool is_made(const struct hatch_scene_mesh *from, const struct hatch_mesh *mesh)
{
    return mesh->indices != from->mesh.indices;
}

/* Returns a mesh of the scene in the shape that it has at a level. */
static struct hatch_scene_mesh fitted(const struct hatch_scene_mesh *from, const struct hatch_mesh *mesh)
{
    struct hatch_scene_mesh to = *from;
    to.mesh = *mesh;
    if (is_made(from, mesh)) {
        to.curves = (struct hatch_curves){0}; /* they lie on the old faces */
        to.file_vertices = mesh->vertex_count;
    }
    return to;
}

void meshfit_join_levels(struct meshfit *fit, const struct meshfit_level *levels, uint32_t count,
                         struct hatch_scene *scene)
{
    const struct hatch_scene *from = fit->scene;
    struct making making = {.fit = fit, .scene = scene, .levels = count};
    *scene = *from;
    allocate(&making, from);
    bool lost = false; /* strokes of a mesh */
    for (uint32_t level = 0; level < count; level++) {
        for (uint32_t m = 0; m < from->mesh_count; m++) {
            const struct hatch_mesh *mesh = &levels[level].meshes[m];
            lost = lost || (from->meshes[m].curves.count > 0 && is_made(&from->meshes[m], mesh));
            scene->meshes[level * from->mesh_count + m] = fitted(&from->meshes[m], mesh);
        }
    }
    if (lost)
        cmd_warn(fit->name, "strokes are left out where meshes became coarser; strokegen traces them anew");
    scene->mesh_count = count * from->mesh_count;
    if (count > 1) {
        add_nodes(&making, from->node_count, from->mesh_count);
        for (uint32_t a = 0; a < scene->animation_count; a++)
            add_channels(&making, &scene->animations[a]);
    }
}
