#include "shared/needs/meshes.h"

#include <math.h>
#include <string.h>

#include "coarse/coarse.h"
#include "scene/extent.h"
#include "scene/pose.h"
#include "shared/scene.h"

#define ERROR_PX 50.0     /* times the tolerance: error of coarse meshes in the pictures, in pixels */
#define SHADE 4.0         /* times the tolerance: by how much the shade of a face may differ from that of its corners */
#define UNSEEN_SHARE 1e-3 /* of the scene's diagonal: that of what no view shows */

static void pose_at_rest(struct cmd_args *args, const char *name, const struct hatch_scene *scene,
                         struct hatch_pose *pose)
{
    struct hatch_err err;
    cmd_check(hatch_pose_make(scene, &args->keep, pose, &err), name, &err);
    hatch_pose_set(pose, HATCH_NONE, 0);
}

/* Calls a function for each face of each mesh of each node, with its corners in world coordinates at rest. */
static void each_face(struct cmd_args *args, const char *name, const struct hatch_scene *scene,
                      void (*visit)(void *context, uint32_t mesh, uint32_t face, const double corners[3][3]),
                      void *context)
{
    struct hatch_pose pose;
    struct hatch_err err;
    pose_at_rest(args, name, scene, &pose);
    for (uint32_t n = 0; n < scene->node_count; n++)
        for (uint32_t m = scene->nodes[n].first_mesh; m < scene->nodes[n].first_mesh + scene->nodes[n].mesh_count;
             m++) {
            const struct hatch_mesh *mesh = &scene->meshes[m].mesh;
            struct hatch_arena_mark mark = hatch_arena_mark(&args->scratch);
            double *places, corners[3][3];
            cmd_check(HATCH_ALLOC_UNSET(&args->scratch, &places, 3 * (size_t)mesh->vertex_count, &err), name, &err);
            hatch_pose_vertices(&pose, n, m, places, NULL);
            for (uint32_t f = 0; f < mesh->face_count; f++) {
                for (uint32_t c = 0; c < 3; c++)
                    memcpy(corners[c], &places[3 * (size_t)mesh->indices[3 * (size_t)f + c]], sizeof corners[c]);
                visit(context, m, f, (const double(*)[3])corners);
            }
            hatch_arena_rewind(&args->scratch, mark);
        }
}

struct box {
    double low[3], high[3];
};

static void add_to_box(void *context, uint32_t mesh, uint32_t face, const double corners[3][3])
{
    struct box *box = context;
    (void)mesh;
    (void)face;
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < 3; k++) {
            box->low[k] = fmin(box->low[k], corners[c][k]);
            box->high[k] = fmax(box->high[k], corners[c][k]);
        }
}

void cmd_check_needs(struct cmd_args *args, const char *path, const char *name, const struct hatch_needs *needs,
                     const struct hatch_scene *scene)
{
    const struct hatch_needs_regions *regions = &needs->regions;
    struct box box = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    struct hatch_err err;
    double cell = 0;
    bool same = true;
    each_face(args, name, scene, add_to_box, &box);
    for (int k = 0; k < 3; k++)
        cell = fmax(cell, regions->side[k]);
    for (int k = 0; k < 3; k++)
        same = same && fabs(box.low[k] - regions->low[k]) <= cell &&
               fabs(box.high[k] - regions->low[k] - HATCH_NEEDS_SIDE * regions->side[k]) <= cell;
    if (!same && box.low[0] <= box.high[0])
        cmd_check(
            hatch_fail(&err, HATCH_BAD_INPUT,
                       "the needs are those of another scene than %s: render-gl --needs of this file alone makes them",
                       name),
            cmd_input_name(path), &err);
}

static uint64_t count_faces(const struct hatch_scene *scene)
{
    uint64_t faces = 0;
    for (uint32_t m = 0; m < scene->mesh_count; m++)
        faces += scene->meshes[m].mesh.face_count;
    return faces;
}

/* Per mesh and vertex: how far the surface may move, in mesh units. */
struct errors {
    const struct hatch_scene *scene;
    const struct hatch_needs_regions *regions;
    const struct hatch_scene_extent *extent;
    double px, unseen; /* the error in pixels; that of what no view shows, in scene units */
    double shade;      /* by how much the cosine between the normals of a face and its vertices may be under 1 */
    double **vertices; /* NULL: the mesh stays as it is, or is coarser already */
    float **cosines;   /* per mesh and vertex */
};

static void lower_errors(void *context, uint32_t mesh, uint32_t face, const double corners[3][3])
{
    const struct errors *errors = context;
    const uint32_t *index = &errors->scene->meshes[mesh].mesh.indices[3 * (size_t)face];
    if (!errors->vertices[mesh])
        return;
    double px = hatch_needs_px(errors->regions, corners);
    double uneven = errors->extent->unevenness[mesh]; /* by how much angles may be larger in the scene */
    double error = (px > 0 ? fmin(errors->px / px, errors->unseen) : errors->unseen) / errors->extent->stretch[mesh];
    for (int c = 0; c < 3; c++) {
        double *vertex = &errors->vertices[mesh][index[c]];
        *vertex = fmin(*vertex, error);
        if (px > 0)
            errors->cosines[mesh][index[c]] = (float)(1 - errors->shade / (uneven * uneven));
    }
}

/* Returns whether the meshes of a node may become coarser. */
static bool may_coarsen(const struct hatch_scene *scene, const struct hatch_node *node, enum cmd_fields fields)
{
    for (uint32_t m = node->first_mesh; m < node->first_mesh + node->mesh_count; m++)
        if (!scene->meshes[m].had_normals ||
            (fields == CMD_FIELDS_KEPT && hatch_mesh_find(&scene->meshes[m].mesh, "_HATCH_DIR", 4)))
            return false;
    return true;
}

/* Lets the meshes of a node move without limit. */
static void begin_errors(struct cmd_args *args, const char *name, const struct hatch_node *node, struct errors *errors)
{
    struct hatch_err err;
    for (uint32_t m = node->first_mesh; m < node->first_mesh + node->mesh_count; m++) {
        uint32_t count = errors->scene->meshes[m].mesh.vertex_count;
        if (errors->vertices[m])
            continue; /* by another node that draws the mesh */
        cmd_check(HATCH_ALLOC_UNSET(&args->keep, &errors->vertices[m], count, &err), name, &err);
        cmd_check(HATCH_ALLOC_UNSET(&args->keep, &errors->cosines[m], count, &err), name, &err);
        for (uint32_t v = 0; v < count; v++)
            errors->vertices[m][v] = HUGE_VAL, errors->cosines[m][v] = -1;
    }
}

/* Makes the meshes of a node coarser: they are one surface, whose borders stay closed. */
static void coarsen_node(struct cmd_args *args, const char *name, const struct hatch_node *node,
                         const struct errors *errors, struct hatch_scene_mesh *meshes)
{
    struct hatch_arena_mark mark = hatch_arena_mark(&args->scratch);
    struct hatch_coarse_part *parts;
    struct hatch_mesh *made;
    struct hatch_err err;
    cmd_check(HATCH_ALLOC(&args->scratch, &parts, node->mesh_count, &err), name, &err);
    cmd_check(HATCH_ALLOC(&args->scratch, &made, node->mesh_count, &err), name, &err);
    for (uint32_t m = 0; m < node->mesh_count; m++)
        parts[m] = (struct hatch_coarse_part){&meshes[m].mesh, errors->vertices[node->first_mesh + m],
                                              errors->cosines[node->first_mesh + m]};
    cmd_check(hatch_coarse_make_loosely(parts, node->mesh_count, &args->keep, &args->scratch, made, &err), name, &err);
    for (uint32_t m = 0; m < node->mesh_count; m++) {
        errors->vertices[node->first_mesh + m] = NULL;
        if (made[m].face_count == 0)
            continue;
        meshes[m].mesh = made[m];
        meshes[m].file_vertices = made[m].vertex_count;
        meshes[m].numbers = NULL;
        meshes[m].curves = (struct hatch_curves){0}; /* they lie on the old faces */
    }
    hatch_arena_rewind(&args->scratch, mark);
}

void cmd_coarsen(struct cmd_args *args, const char *name, const struct hatch_needs *needs, enum cmd_fields fields,
                 struct hatch_scene *scene)
{
    struct errors errors = {.scene = scene,
                            .regions = &needs->regions,
                            .px = ERROR_PX * needs->tolerance,
                            .shade = SHADE * needs->tolerance};
    struct hatch_scene_extent extent;
    struct hatch_err err;
    uint64_t before = count_faces(scene);
    cmd_check(hatch_scene_find_extent(scene, &args->keep, &args->scratch, &extent, &err), name, &err);
    cmd_check(HATCH_ALLOC(&args->keep, &errors.vertices, scene->mesh_count, &err), name, &err);
    cmd_check(HATCH_ALLOC(&args->keep, &errors.cosines, scene->mesh_count, &err), name, &err);
    errors.extent = &extent;
    errors.unseen = extent.diagonal * UNSEEN_SHARE;
    cmd_add_normals(args, name, scene);
    for (uint32_t n = 0; n < scene->node_count; n++)
        if (may_coarsen(scene, &scene->nodes[n], fields))
            begin_errors(args, name, &scene->nodes[n], &errors);
    each_face(args, name, scene, lower_errors, &errors);
    for (uint32_t n = 0; n < scene->node_count; n++)
        if (scene->nodes[n].mesh_count > 0 && errors.vertices[scene->nodes[n].first_mesh])
            coarsen_node(args, name, &scene->nodes[n], &errors, &scene->meshes[scene->nodes[n].first_mesh]);
    cmd_note("%llu of %llu faces left out: the others show the same within %.3g pixels",
             (unsigned long long)(before - count_faces(scene)), (unsigned long long)before,
             ERROR_PX * needs->tolerance);
}

/* Per mesh and face: whether a view shows it. */
struct seen {
    const struct hatch_needs_regions *regions;
    uint8_t **faces;
};

static void mark_seen(void *context, uint32_t mesh, uint32_t face, const double corners[3][3])
{
    const struct seen *seen = context;
    if (hatch_needs_px(seen->regions, corners) > 0)
        seen->faces[mesh][face] = 1;
}

/* Makes a mesh of some faces.
 *   seen  per face; those of which it is `wanted` are taken */
static enum hatch_status take_faces(const struct hatch_mesh *from, const uint8_t *seen, uint8_t wanted,
                                    uint32_t face_count, struct hatch_arena *arena, struct hatch_arena *scratch,
                                    struct hatch_mesh *made, struct hatch_err *err)
{
    uint32_t *number, *origin, count = 0;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    HATCH_TRY(HATCH_ALLOC(scratch, &number, from->vertex_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &origin, from->vertex_count, err));
    for (size_t c = 0; c < 3 * (size_t)from->face_count; c++)
        if (seen[c / 3] == wanted)
            number[from->indices[c]] = 1;
    for (uint32_t v = 0; v < from->vertex_count; v++)
        if (number[v]) {
            number[v] = count;
            origin[count++] = v;
        }
    HATCH_TRY(hatch_mesh_gather(from, origin, count, face_count, arena, made, err));
    uint32_t *index = made->indices;
    for (size_t c = 0; c < 3 * (size_t)from->face_count; c++)
        if (seen[c / 3] == wanted)
            *index++ = number[from->indices[c]];
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

/* Divides a mesh; returns the number of meshes that it becomes, of which the last may be unseen.
 *   to  out: room for two */
static uint32_t split(struct cmd_args *args, const char *name, const struct hatch_needs *needs,
                      const struct hatch_scene_mesh *from, const uint8_t *seen, struct hatch_scene_mesh *to)
{
    struct hatch_err err;
    uint32_t shown = 0, all = from->mesh.face_count;
    for (uint32_t f = 0; f < all; f++)
        shown += seen[f];
    to[0] = to[1] = *from;
    if (from->unseen_tolerance > 0) { /* as other views left it: coarser than a part that is seen */
        if (shown > all / 2)
            cmd_check(hatch_fail(&err, HATCH_BAD_INPUT,
                                 "%u faces that these views show are as coarse as those that no view shows: "
                                 "begin with the full scene",
                                 shown),
                      name, &err);
        return 1;
    }
    for (uint32_t i = 0; i < 2 && shown > 0 && shown < all; i++) {
        cmd_check(take_faces(&from->mesh, seen, i == 0, i == 0 ? shown : all - shown, &args->keep, &args->scratch,
                             &to[i].mesh, &err),
                  name, &err);
        to[i].curves = (struct hatch_curves){0};
        to[i].file_vertices = to[i].mesh.vertex_count;
        to[i].numbers = NULL;
    }
    to[shown > 0].unseen_tolerance = shown < all ? (float)needs->tolerance : 0;
    return shown > 0 && shown < all ? 2 : 1;
}

void cmd_split_unseen(struct cmd_args *args, const char *name, const struct hatch_needs *needs,
                      struct hatch_scene *scene)
{
    struct seen seen = {.regions = &needs->regions};
    struct hatch_scene_mesh *meshes;
    struct hatch_err err;
    uint32_t *first, count = 0;
    uint64_t unseen = 0, all = count_faces(scene);
    cmd_check(HATCH_ALLOC(&args->keep, &seen.faces, scene->mesh_count, &err), name, &err);
    cmd_check(HATCH_ALLOC(&args->keep, &first, (size_t)scene->mesh_count + 1, &err), name, &err);
    cmd_check(HATCH_ALLOC(&args->keep, &meshes, 2 * (size_t)scene->mesh_count, &err), name, &err);
    for (uint32_t m = 0; m < scene->mesh_count; m++)
        cmd_check(HATCH_ALLOC(&args->keep, &seen.faces[m], scene->meshes[m].mesh.face_count, &err), name, &err);
    each_face(args, name, scene, mark_seen, &seen);
    for (uint32_t m = 0; m < scene->mesh_count; m++) {
        first[m] = count;
        count += split(args, name, needs, &scene->meshes[m], seen.faces[m], &meshes[count]);
        unseen += meshes[count - 1].unseen_tolerance > 0 ? meshes[count - 1].mesh.face_count : 0;
    }
    first[scene->mesh_count] = count;
    hatch_scene_renumber(scene, first);
    scene->meshes = meshes;
    scene->mesh_count = count;
    scene->rounding = (float)needs->tolerance;
    cmd_note("no view shows %llu of %llu faces", (unsigned long long)unseen, (unsigned long long)all);
}

/* Largest scale of each mesh. */
struct scales {
    const struct hatch_needs_regions *regions;
    double *px;
};

static void raise_px(void *context, uint32_t mesh, uint32_t face, const double corners[3][3])
{
    const struct scales *scales = context;
    (void)face;
    scales->px[mesh] = fmax(scales->px[mesh], hatch_needs_px(scales->regions, corners));
}

void cmd_mesh_px(struct cmd_args *args, const char *name, const struct hatch_needs *needs,
                 const struct hatch_scene *scene, double *px)
{
    struct scales scales = {&needs->regions, px};
    for (uint32_t m = 0; m < scene->mesh_count; m++)
        px[m] = 0;
    each_face(args, name, scene, raise_px, &scales);
    for (uint32_t m = 0; m < scene->mesh_count; m++)
        if (scene->meshes[m].unseen_tolerance > 0)
            px[m] = 0;
}
