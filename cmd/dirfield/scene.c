/* The meshes of a scene, one after another. */
#include "shared/needs/meshes.h"
#include "shared/surface.h"
#include "dirfield.h"
#include "io/glb/glb.h"

struct run {
    struct cmd_args *args;
    const struct dirfield_options *options;
    const char *input;
    struct cmd_file *files;
    struct hatch_scene scene;
    uint64_t vertices; /* that all meshes of the file have */
    struct dirfield_job *jobs;
    struct dirfield_report report;
    struct dirfield_arrows arrows;
    double faces, undirected_faces; /* the latter in bodies without a principal direction */
    uint64_t singularities;
};

static void make_jobs(struct run *run)
{
    struct hatch_err err;
    for (uint32_t i = 0; i < run->scene.mesh_count; i++) { /* before meshes without an area are left out */
        run->scene.meshes[i].file_first = run->vertices;
        run->vertices += dirfield_vertex_count(&run->scene.meshes[i]);
    }
    const struct hatch_surface *surfaces = cmd_make_surfaces(run->args, run->input, &run->scene);
    uint32_t count = run->scene.mesh_count;
    cmd_check(HATCH_ALLOC(&run->args->keep, &run->jobs, count, &err), NULL, &err);
    for (uint32_t i = 0; i < count; i++) {
        run->jobs[i] =
            (struct dirfield_job){cmd_input_name(run->input), i, &run->scene.meshes[i], &surfaces[i], .share = 0};
        run->faces += surfaces[i].face_count;
    }
    for (uint32_t i = 0; i < count; i++)
        run->jobs[i].share = surfaces[i].face_count / run->faces;
    dirfield_find_poses(run->args, &run->scene, run->jobs);
}

static void begin_reports(struct run *run)
{
    uint32_t points = 0;
    for (uint32_t i = 0; i < run->scene.mesh_count; i++)
        points += run->jobs[i].surface->point_count;
    dirfield_report_begin(&run->report, run->args, points);
    if (run->files[DIRFIELD_ARROWS].output)
        dirfield_arrows_begin(&run->arrows, run->args);
}

/* Returns the number of faces in bodies without a principal direction, whose confidence is 0 everywhere. */
static double count_undirected_faces(const struct dirfield_job *job)
{
    const struct hatch_surface *surface = job->surface;
    double faces = 0;
    for (uint32_t first = 0, c = 0; c < surface->component_count; first = c) {
        double body_faces = 0;
        bool directed = false;
        for (; c < surface->component_count && surface->components[c].body == surface->components[first].body; c++) {
            const struct hatch_component *component = &surface->components[c];
            for (uint32_t p = component->first_point; p < component->first_point + component->point_count; p++)
                directed = directed || job->field.confidence[p] > 0;
            body_faces += component->face_count;
        }
        faces += directed ? 0 : body_faces;
    }
    return faces;
}

static void process(struct run *run, struct dirfield_job *job)
{
    hatch_arena_init(&job->work, run->args->max_memory);
    dirfield_solve(run->args, run->options, job);
    cmd_attach_field(run->args, job->name, job->surface, job->field.direction, job->field.confidence, job->mesh);
    if (run->files[DIRFIELD_REPORT].output)
        dirfield_report_add(&run->report, job);
    if (run->files[DIRFIELD_ARROWS].output)
        dirfield_arrows_add(&run->arrows, job);
    run->undirected_faces += count_undirected_faces(job);
    run->singularities += job->singular.count;
    hatch_arena_free(&job->work);
}

static void print_notes(const struct run *run)
{
    if (run->undirected_faces > 0)
        cmd_warn(cmd_input_name(run->input),
                 "%.3g %% of the faces are in bodies without a principal direction: planes have that of their "
                 "straight edges, others (spheres) lie across the longest side of the bounding box, with confidence 0",
                 100 * run->undirected_faces / run->faces);
    cmd_note("%llu %s", (unsigned long long)run->singularities,
             cmd_plural(run->singularities, "singularity", "singularities"));
}

static void set_content(struct cmd_file *file, struct hatch_bytes bytes)
{
    file->data = bytes.data;
    file->size = bytes.size;
}

static void encode(struct run *run, double surfaces_ms)
{
    struct hatch_err err;
    struct hatch_buffer glb = {.arena = &run->args->keep};
    cmd_check(hatch_glb_write_scene(&run->scene, run->options->comment, &run->args->scratch, &glb, &err),
              cmd_input_name(run->input), &err);
    set_content(&run->files[DIRFIELD_MESH], (struct hatch_bytes){glb.data, glb.size});
    if (run->files[DIRFIELD_REPORT].output)
        set_content(&run->files[DIRFIELD_REPORT], dirfield_report_end(&run->report, surfaces_ms));
    if (run->files[DIRFIELD_ARROWS].output)
        set_content(&run->files[DIRFIELD_ARROWS], dirfield_arrows_end(&run->arrows));
}

void dirfield_run(struct cmd_args *args, const struct dirfield_options *options, const char *input,
                  struct cmd_file files[DIRFIELD_FILES])
{
    struct run run = {.args = args, .options = options, .input = input, .files = files};
    struct hatch_needs needs;
    const char *name = cmd_input_name(input);
    cmd_read_scene_to_write(args, input, true, &run.scene);
    cmd_warn_up(name, &run.scene);
    cmd_warn_strokes(name, &run.scene);
    cmd_refuse_lapped(name, &run.scene);
    if (options->needs) {
        cmd_read_needs_and_regions(args, options->needs, &needs);
        cmd_check_needs(args, options->needs, name, &needs, &run.scene);
        cmd_coarsen(args, name, &needs, CMD_FIELDS_ANEW, &run.scene);
    }
    double begun_ms = cmd_elapsed_ms();
    make_jobs(&run);
    double surfaces_ms = cmd_elapsed_ms() - begun_ms;
    if (options->constraints)
        dirfield_read_constraints(args, options->constraints, options->needs ? 0 : run.vertices, run.jobs,
                                  run.scene.mesh_count);
    begin_reports(&run);
    for (uint32_t i = 0; i < run.scene.mesh_count; i++)
        process(&run, &run.jobs[i]);
    if (options->needs)
        cmd_split_unseen(args, name, &needs, &run.scene);
    encode(&run, surfaces_ms);
    print_notes(&run);
}
