/* Reading the scene of a job. */
#include "render-gl/mode/job.h"

#include "scene/ground.h"
#include "scene/row.h"
#include "shared/scene.h"

/* Names the scene after its file; a row of several is named after the first. */
static void name_scene(struct job *job)
{
    struct cmd_args *args = &job->args;
    struct hatch_buffer name = {.arena = &args->keep};
    struct hatch_err err;
    int others = args->operand_count - 1;
    job->name = cmd_input_name(job->options->scene_path);
    if (others < 1)
        return;
    cmd_check(hatch_buffer_print(&name, &err, "%s and %d more%c", job->name, others, '\0'), NULL, &err);
    job->name = (const char *)name.data;
}

/* Reads a scene and turns it upright; warns if it seems to need this and --up is not given. */
static void load_one(struct job *job, const char *path, struct hatch_scene *scene, struct hatch_mesh_notes *notes)
{
    const struct options *options = job->options;
    struct hatch_err err;
    cmd_read_scene_silently(&job->args, path, CMD_SCENE_CLEANED, scene, notes, NULL);
    if (!options_is_given("up"))
        cmd_warn_up(cmd_input_name(path), scene);
    cmd_check(hatch_scene_turn_up(scene, options->up, &job->args.keep, &err), cmd_input_name(path), &err);
}

static void load_row(struct job *job, uint32_t count, bool stand, struct hatch_mesh_notes *notes)
{
    struct cmd_args *args = &job->args;
    struct hatch_err err;
    struct hatch_scene *scenes;
    uint32_t meshes = 0;
    cmd_check(HATCH_ALLOC(&args->keep, &scenes, count, &err), NULL, &err);
    cmd_check(HATCH_ALLOC(&args->keep, &job->mesh_end, count, &err), NULL, &err);
    for (uint32_t i = 0; i < count; i++) {
        load_one(job, args->operands[i], &scenes[i], notes);
        job->mesh_end[i] = meshes += scenes[i].mesh_count;
    }
    cmd_check(hatch_scene_join_row(scenes, count, stand, &args->keep, &args->scratch, &job->values, &err), job->name,
              &err);
}

/* Removes the faces of meshes whose base colour has an alpha below the cutoff, since no part of them is visible. */
static void drop_transparent(struct hatch_scene *scene, struct hatch_mesh_notes *notes)
{
    for (uint32_t i = 0; i < scene->mesh_count; i++) {
        struct hatch_scene_mesh *mesh = &scene->meshes[i];
        const struct hatch_material *material = mesh->material == HATCH_NONE ? NULL : &scene->materials[mesh->material];
        if (!material || !(material->base_color[3] < (material->outline ? 0.5f : material->alpha_cutoff)))
            continue;
        mesh->mesh.face_count = 0;
        notes->transparent_dropped++;
    }
}

/* Reads the operands into one scene; several scenes are put in a row. Drops meshes that are wholly transparent, adds
 * the ground of --ground and missing normals, and joins lapped patches (hatch_patches_join). */
static void load_all(struct job *job, struct hatch_mesh_notes *notes)
{
    struct cmd_args *args = &job->args;
    struct hatch_scene *scene = &job->values;
    const char *name = job->name;
    uint32_t count = (uint32_t)args->operand_count;
    double ground = job->options->ground;
    uint32_t *numbers;
    struct hatch_err err;
    if (count > 1)
        load_row(job, count, ground > 0, notes);
    else
        load_one(job, job->options->scene_path, scene, notes);
    if (job->options->needs)
        cmd_check(hatch_scene_measure(scene, NULL, &args->scratch, &job->rest, &err), name, &err);
    drop_transparent(scene, notes);
    hatch_scene_doubt(scene, &args->scratch, notes);
    job_set_span(job);
    if (ground > 0)
        cmd_check(hatch_scene_add_ground(scene, &job->span, ground, &args->keep, &args->scratch, &err), name, &err);
    for (uint32_t i = 0; i < scene->mesh_count; i++)
        cmd_check(hatch_mesh_add_normals(&args->keep, &args->scratch, &scene->meshes[i].mesh, CMD_CREASE_RAD, &err),
                  name, &err);
    cmd_check(hatch_patches_join(scene, &args->keep, &args->scratch, &job->patches, &numbers, &err), name, &err);
    for (uint32_t i = 0; job->mesh_end && i < count; i++)
        if (job->mesh_end[i] > 0)
            job->mesh_end[i] = numbers[job->mesh_end[i] - 1] + 1;
}

void job_check_faces(const struct job *job, const struct hatch_mesh_notes *notes)
{
    const struct hatch_scene *scene = &job->values;
    struct hatch_err err;
    bool any = notes->transparent_dropped > 0;
    for (uint32_t n = 0; n < scene->node_count && !any; n++)
        for (uint32_t i = 0; i < scene->nodes[n].mesh_count; i++)
            any = any || scene->meshes[scene->nodes[n].first_mesh + i].mesh.face_count > 0;
    if (any)
        return;
    hatch_fail(&err, HATCH_BAD_INPUT, "the scene has no faces%s",
               notes->primitives_skipped    ? ", only points or lines"
               : notes->primitives_unplaced ? ": primitives with no POSITION"
                                            : "");
    cmd_die(job->name, &err);
}

void job_load(struct job *job, struct hatch_mesh_notes *notes)
{
    name_scene(job);
    load_all(job, notes);
}
