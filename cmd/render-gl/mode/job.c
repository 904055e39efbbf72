#include "render-gl/mode/job.h"

#include "math/angle.h"
#include "render-gl/mode/needs/technique.h"
#include "render-gl/scene/attributes.h"
#include "render-gl/scene/material.h"
#include "render-gl/scene/normals.h"
#include "render-gl/scene/pose.h"
#include "view/exposure.h"
#include "shared/map.h"
#include "shared/scene.h"

#define WINDOW_MOMENTS                                                                                                 \
    65u /* times, besides those of keys, at which the bounds of a window's animation are measured                      \
         */

/* Finds the file of a mesh: returns its name, and in *index the number of the mesh there. */
static const char *file_of(const struct job *job, uint32_t *index)
{
    uint32_t file = 0;
    if (!job->mesh_end)
        return job->name;
    while (*index >= job->mesh_end[file])
        file++;
    *index -= file ? job->mesh_end[file - 1] : 0;
    return cmd_input_name(job->args.operands[file]);
}

/* Fails if a mesh has no texture coordinates.
 *   why  ends the message: who needs them, and what to do */
static enum hatch_status check_texcoords(const struct job *job, const char *why, const char **file,
                                         struct hatch_err *err)
{
    const struct hatch_scene *scene = &job->values;
    for (uint32_t i = 0; i < scene->mesh_count; i++)
        if (scene->meshes[i].mesh.face_count && !hatch_mesh_find(&scene->meshes[i].mesh, "TEXCOORD_0", 2)) {
            *file = file_of(job, &i);
            return hatch_fail(err, HATCH_BAD_INPUT, "primitive %u has no texture coordinates, %s", i, why);
        }
    return HATCH_OK;
}

static void check_animation(const struct job *job)
{
    struct hatch_err err;
    if (job->options->animation_given && job->options->animation >= job->values.animation_count)
        cmd_check(hatch_fail(&err, HATCH_BAD_INPUT, "animation %u does not exist: the scene has %u, numbered from 0",
                             job->options->animation, job->values.animation_count),
                  job->name, &err);
}

static void warn_if_still(const struct job *job)
{
    const struct options *options = job->options;
    if (options->frames > 1 && !options->turntable && !params_differ(options) && !job->values.animation_count)
        cmd_warn(job->name, "the scene has no animation: all frames are alike without --turntable or --animate");
}

static void warn_without_lights(const struct job *job)
{
    static const struct hatch_key_light beside = {.replaces = false};
    if (options_is_given("exposure") && hatch_lights_are_key_alone(&job->values, &beside))
        cmd_warn(job->name, "the scene has no lights: --exposure changes nothing");
}

/* Returns whether a mesh has no strokes though it is shown. */
static bool is_bare(const struct hatch_scene_mesh *mesh)
{
    return mesh->mesh.face_count > 0 && mesh->curves.count == 0 && !(mesh->unseen_tolerance > 0);
}

/* Warns of meshes that the technique leaves blank, once for each file, and of the ground. */
static void warn_without_strokes(const struct job *job)
{
    const struct hatch_scene *scene = &job->values;
    const bool ground = job->options->ground > 0; /* the last mesh */
    uint32_t count = scene->mesh_count - ground, first = 0;
    if (!(job->options->technique->features & TECHNIQUE_TRACED))
        return;
    for (uint32_t file = 0; first < count; file++) {
        uint32_t end = job->mesh_end ? job->mesh_end[file] : count, bare = 0;
        for (uint32_t i = first; i < end; i++)
            bare += is_bare(&scene->meshes[i]);
        if (bare > 0)
            cmd_warn(job->mesh_end ? cmd_input_name(job->args.operands[file]) : job->name,
                     "%u %s blank: make them with strokegen", bare,
                     cmd_plural(bare, "mesh has no strokes and stays", "meshes have no strokes and stay"));
        first = end;
    }
    if (ground)
        cmd_warn(job->name, "the plane of --ground has no strokes: --technique %s draws no shadows on it",
                 job->options->technique->name);
}

/* Warns of strokes that do not nest, and of columns and colours that the technique does not draw. */
static void warn_of_map(struct cmd_args *args, const struct options *options, const struct hatch_tam *map)
{
    const char *name = cmd_input_name(options->map_path);
    cmd_warn_nesting(args, name, map);
    if (map->color && options_paint(options))
        cmd_warn(name, "--look watercolor paints the map's colours in those of the inks");
    if (map->color && options->technique->extra == &asset_strokes)
        cmd_warn(name, "the map's colours are not drawn; --technique %s draws them",
                 technique_find(TECHNIQUE_ALL_COLUMNS)->name);
    if (options->technique->asset != &asset_six_columns)
        return;
    if (map->tones > ASSET_SIX_COLUMNS_MAX)
        cmd_warn(name, "only %u of the map's %u columns are drawn; --technique %s draws all", ASSET_SIX_COLUMNS_MAX,
                 map->tones, technique_find(TECHNIQUE_ALL_COLUMNS)->name);
    if (map->color && !options_paint(options))
        cmd_warn(name, "the map's colours are drawn in grey; --technique %s draws them",
                 technique_find(TECHNIQUE_ALL_COLUMNS)->name);
}

/* Exits with a message if the asset is not of the kind that the technique, or --probe, reads. */
static void check_asset(const struct job *job)
{
    const struct options *options = job->options;
    const struct asset_kind *kind = options->probe ? &asset_six_columns : technique_asset(options->technique);
    struct hatch_err err;
    if (!kind || kind->is(&job->asset))
        return;
    hatch_fail(&err, HATCH_BAD_INPUT, "%s%s needs %s, this is %s", options->probe ? "--probe" : "technique ",
               options->probe ? "" : options->technique->name, kind->name,
               asset_is_map(&job->asset) ? "a tonal art map" : "another texture");
    cmd_die(cmd_input_name(options->map_path), &err);
}

/* Returns whether strokes are drawn in the colours of their map or volume, if it has some. */
static bool draws_colors(const struct options *options)
{
    const struct asset_kind *kind = technique_asset(options->technique);
    return !options->probe && !options_paint(options) && (kind == &asset_columns || kind == &asset_volume);
}

static void read_asset(struct job *job)
{
    const struct options *options = job->options;
    asset_read(&job->args, options->map_path, &job->asset);
    check_asset(job);
    if (asset_is_map(&job->asset))
        warn_of_map(&job->args, options, &job->asset.map);
    if (asset_is_colored(&job->asset) && draws_colors(options) && frame_ink_mode(&options->inks) != FRAME_INK_DARKENS)
        cmd_warn(cmd_input_name(options->map_path),
                 "a light ink draws strokes in its own colour, not in those of the map");
    job->assets.asset = &job->asset;
}

struct technique_instance *job_open(struct job *job, const struct technique *technique, struct hatch_err *err)
{
    struct technique_instance *instance = job->instances;
    while (instance->technique && instance->technique != technique)
        instance++;
    if (instance->technique)
        return instance;
    if (technique_open(instance, technique, &job->args, err) != HATCH_OK)
        return NULL;
    if (technique->read)
        technique->read(&job->context, instance);
    return instance;
}

enum hatch_status job_check(struct job *job, const struct technique *technique, const char **file,
                            struct hatch_err *err)
{
    const struct technique_instance *instance = job_open(job, technique, err);
    *file = job->name;
    HATCH_TRY(instance ? HATCH_OK : HATCH_LIMIT);
    if (technique->check)
        HATCH_TRY(technique->check(&job->values, job->patches, err));
    return instance->texcoords_for ? check_texcoords(job, instance->texcoords_for, file, err) : HATCH_OK;
}

struct technique_instance *job_use(struct job *job, const struct technique *technique)
{
    struct hatch_err err;
    struct technique_instance *instance = job_open(job, technique, &err);
    cmd_check(instance ? technique_prepare(&job->context, instance, &err) : HATCH_LIMIT, NULL, &err);
    return instance;
}

/* Opens all techniques whose options were given: a window may switch to them, and errors in their files should be
 * reported at the start. */
static void open_techniques(struct job *job)
{
    struct hatch_err err;
    for (size_t i = 0; techniques[i]; i++)
        for (const struct cmd_option *row = techniques[i]->options; row && row->name; row++)
            if (options_is_given(row->name))
                cmd_check(job_open(job, techniques[i], &err) ? HATCH_OK : HATCH_LIMIT, NULL, &err);
}

void job_read(struct job *job)
{
    const struct options *options = job->options;
    struct hatch_mesh_notes notes = {0};
    struct hatch_err err;
    const char *file;
    job->context = (struct technique_context){.frame = &job->frame,
                                              .assets = &job->assets,
                                              .args = &job->args,
                                              .view = &job->first_view,
                                              .height_px = options->height,
                                              .side = options->side};
    job_load(job, &notes);
    open_techniques(job);
    if (options_paint(options))
        job->context.look = look_read(&job->args, LOOK_WATERCOLOR, true, &job->look);
    if (options->map_path)
        read_asset(job);
    if (!options->vectors || options->technique->curves) {
        enum hatch_status status = job_check(job, options->technique, &file, &err);
        cmd_check(status, file, &err);
    }
    job_check_faces(job, &notes);
    cmd_warn_mesh(job->name, &notes);
    warn_if_still(job);
    warn_without_lights(job);
    warn_without_strokes(job);
}

static double time_of(const struct job *job, uint32_t frame)
{
    return job->options->time_s + (double)frame / job->options->rate;
}

void job_set_span(struct job *job)
{
    const struct options *options = job->options;
    check_animation(job);
    bool moves = options->animated && job->values.animation_count;
    struct hatch_film film = {.animation = moves ? options->animation : HATCH_NONE,
                              .begin_s = options->time_s,
                              .rate = options->rate,
                              .frames = options->frames};
    double duration_s = moves ? (double)job->values.animations[options->animation].duration_s : 0;
    if (options->window && duration_s > 0) {
        film.rate = (WINDOW_MOMENTS - 1) / duration_s;
        film.frames = WINDOW_MOMENTS;
    }
    struct hatch_err err;
    cmd_check(hatch_film_span(&job->values, &film, &job->args.keep, &job->span, &err), job->name, &err);
}

/* Makes the view that the options describe, with the aspect of fixed_view. */
static enum hatch_status make_view(struct job *job, struct hatch_pose *pose, const struct hatch_bounds *bounds,
                                   struct hatch_view *view, struct hatch_err *err)
{
    const struct hatch_view_choice choice = options_view(job->options);
    const struct hatch_framing framing = {&job->span, bounds, job->fixed_view.aspect};
    return hatch_view_make(&choice, pose, &framing, &job->args.scratch, view, err);
}

static void open_context(struct job *job)
{
    const struct options *options = job->options;
    struct hatch_err err;
    cmd_check(job->open_window ? job->open_window(&job->gpu, options->width, options->height, &err)
                               : gpu_context_open_headless(&job->gpu, job->args.threads, &err),
              NULL, &err);
    cmd_note("%s", job->gpu.device);
    if (options->anisotropy > (double)job->gpu.anisotropy_max)
        cmd_note("the driver limits --anisotropy to %g", (double)job->gpu.anisotropy_max);
}

/* Measures the scene and finds the view of all frames. */
static void measure_scene(struct job *job, struct hatch_bounds *bounds)
{
    const struct options *options = job->options;
    struct hatch_arena *keep = &job->args.keep, *scratch = &job->args.scratch;
    const char *name = job->name;
    struct hatch_pose pose;
    struct hatch_err err;
    cmd_check(hatch_pose_make(&job->values, keep, &pose, &err), name, &err);
    cmd_check(hatch_pose_bounds(&pose, &job->span, scratch, bounds, &err), name, &err);
    job->empty = bounds->empty;
    if (job->empty)
        cmd_warn(name, "the scene has no visible faces");
    job->fixed_view.aspect = (double)options->width / options->height;
    cmd_check(make_view(job, &pose, bounds, &job->fixed_view, &err), name, &err);
}

/* Opens the GL context, and uploads meshes and materials. */
static void upload_scene(struct job *job)
{
    const struct options *options = job->options;
    struct hatch_arena *keep = &job->args.keep, *scratch = &job->args.scratch;
    const char *name = job->name;
    struct hatch_bounds bounds;
    struct hatch_err err;
    measure_scene(job, &bounds);
    uint32_t left_out = options->light_given ? 0 : hatch_lights_left_out(&job->values);
    if (left_out)
        cmd_warn(name, "%u %s left out: at most %u are used", left_out, cmd_plural(left_out, "light is", "lights are"),
                 HATCH_LIGHTS_MAX);
    open_context(job);
    cmd_check(scene_upload(&job->values, job->patches, &bounds, keep, scratch, &job->scene, &err), name, &err);
    material_upload(&job->args, name, options->textures, job->gpu.size_max_px, &job->scene);
    if (options->pixel_light)
        normals_upload(&job->args, name, job->gpu.size_max_px, &job->scene);
    if (options->modulate_path)
        material_modulate(&job->args, options->modulate_path, job->gpu.size_max_px, &job->scene);
}

enum hatch_status job_make_lines(struct job *job, uint32_t kinds, struct hatch_err *err)
{
    const struct options *options = job->options;
    const struct line_overlay_style style = {
        .lines = {.kinds = kinds, .width_px = options->line_px, .crease_rad = options->crease_deg * HATCH_RADIANS},
        .color = {options->line_color[0], options->line_color[1], options->line_color[2]},
        .haloes = options->halo_px > 0};
    HATCH_TRY(line_overlay_make(&job->lines, &job->scene, &style, &job->frame.programs, &job->args, err));
    job->has_lines = true;
    return HATCH_OK;
}

struct picture job_picture(struct job *job, struct technique_instance *instance)
{
    return (struct picture){.context = &job->context,
                            .instance = instance,
                            .lines = job->has_lines ? &job->lines : NULL,
                            .draws_lines = job->has_lines && options_draw_lines(job->options, instance->technique)};
}

void job_set_darkest(struct job *job, const struct technique_instance *instance)
{
    struct options *options = job->options;
    if (options->tone_range_given)
        return;
    bool reads = options->map_path && technique_asset(instance->technique);
    if (options->map_path)
        options->tone_range[1] = (double)asset_darkest(&job->asset);
    if (instance->technique->darkest && !reads)
        options->tone_range[1] = instance->technique->darkest(instance);
}

/* Sets how often the map repeats over each surface; for --needs, how often one that is large enough does. */
static enum hatch_status set_repeats(struct job *job, struct hatch_err *err)
{
    const struct hatch_uv_repeat how = {.repeat = job->options->repeat,
                                        .view = &job->first_view,
                                        .height_px = job->options->height,
                                        .size_px =
                                            job->options->needs ? NEEDS_SIZE_PX : asset_whole_size_px(&job->asset),
                                        .levels = job->options->needs ? NEEDS_LEVELS : asset_whole_levels(&job->asset)};
    return scene_set_repeats(&job->scene, &how, &job->args.keep, &job->args.scratch, err);
}

void job_prepare(struct job *job)
{
    struct options *options = job->options;
    struct hatch_arena *scratch = &job->args.scratch;
    struct hatch_err err;
    upload_scene(job);
    job->frame = (struct frame){.programs = {.folder = options->shader_folder, .scratch = scratch},
                                .scene = &job->scene,
                                .size_max_px = job->gpu.size_max_px};
    hatch_arena_init(&job->frame.programs.keep, job->args.max_memory);
    job->assets.limits = (struct asset_limits){job->gpu.size_max_px, (float)options->anisotropy};
    if (options->line_kinds)
        cmd_check(job_make_lines(job, options->line_kinds, &err), NULL, &err);
    job_set_darkest(job, job_open(job, options->technique, &err));
    job_set_frame(job, 0, &job->first_view);
    if (!(options->exposure > 0)) {
        cmd_check(hatch_auto_exposure(&job->scene.unit, &job->span, &job->first_view,
                                      options->pixel_light || options->shadows, scratch, &options->exposure, &err),
                  job->name, &err);
        job_set_frame(job, 0, &job->first_view);
    }
    options_style(options, &job->frame.style);
    if (options->map_path || options->needs)
        cmd_check(set_repeats(job, &err), job->name, &err);
    job_use(job, options->technique);
}

void job_prepare_without_gpu(struct job *job)
{
    struct hatch_bounds bounds;
    struct hatch_err err;
    measure_scene(job, &bounds);
    cmd_check(hatch_unit_scene_make(&job->values, job->patches, &bounds, &job->args.keep, &job->scene.unit, &err),
              job->name, &err);
    material_find_holes(&job->args, job->name, &job->scene.unit);
    job_set_frame(job, 0, &job->first_view);
}

/* Poses the scene: on the GPU, too, where it has been uploaded. */
static enum hatch_status pose_scene(struct job *job, double time_s, struct hatch_err *err)
{
    if (job->scene.items)
        return scene_set_pose(&job->scene, job->span.animation, time_s, &job->args.scratch, err);
    hatch_unit_scene_pose(&job->scene.unit, job->span.animation, time_s);
    return HATCH_OK;
}

void job_view(struct job *job, double time_s, struct hatch_view *view)
{
    const struct hatch_view_choice choice = options_view(job->options);
    const struct hatch_pose_span now = {.animation = job->span.animation, .times_s = &time_s, .moments = 1};
    struct hatch_unit_scene *unit = &job->scene.unit;
    struct hatch_err err;
    *view = job->fixed_view;
    if (!hatch_view_is_fixed(&choice, &job->values))
        cmd_check(make_view(job, &unit->pose, &unit->bounds, view, &err), job->name, &err);
    if (options_is_given("zoom") && !(job->middle.distance > 0))
        cmd_check(
            hatch_view_find_middle(&unit->pose, &now, &unit->bounds, view, &job->args.scratch, &job->middle, &err),
            job->name, &err);
    if (job->options->zoom < 1 || job->options->zoom > 1)
        hatch_view_zoom(&job->middle, job->options->zoom, view);
}

enum hatch_status job_refresh(struct job *job, struct technique_instance *instance, uint32_t subjects,
                              struct hatch_err *err)
{
    const struct hatch_view_choice choice = options_view(job->options);
    struct hatch_unit_scene *unit = &job->scene.unit;
    if (subjects & 1u << PARAM_TECHNIQUE && instance->technique->changed) {
        double begin_ms = cmd_elapsed_ms();
        HATCH_TRY(instance->technique->changed(&job->context, instance, err));
        job_set_darkest(job, instance);
        job->changes++;
        job->changes_ms += cmd_elapsed_ms() - begin_ms;
    }
    options_style(job->options, &job->frame.style);
    job->lines.lines.style.width_px = job->options->line_px;
    if (subjects & 1u << PARAM_CAMERA && hatch_view_is_fixed(&choice, &job->values))
        HATCH_TRY(make_view(job, &unit->pose, &unit->bounds, &job->fixed_view, err));
    return HATCH_OK;
}

void job_set_frame(struct job *job, uint32_t frame, struct hatch_view *view)
{
    const struct options *options = job->options;
    struct hatch_err err;
    struct technique_instance *instance = job_open(job, options->technique, &err);
    uint32_t subjects = options->frames > 1 ? params_move(options, (double)frame / (options->frames - 1)) : 0;
    cmd_check(job_refresh(job, instance, subjects, &err), NULL, &err);
    cmd_check(pose_scene(job, time_of(job, frame), &err), job->name, &err);
    job_view(job, time_of(job, frame), view);
    if (options->turntable)
        hatch_view_turn(view, -360 * HATCH_RADIANS * frame / options->frames);
}

uint32_t job_set_film_frame(struct job *job, uint32_t frame, job_foresee *foresee, void *data, struct hatch_view *view)
{
    const struct options *options = job->options;
    const bool depends = options->frames > 1 && options->technique->foresee;
    struct hatch_err err;
    for (; depends && job->foreseen < options->frames && job->foreseen <= frame + TECHNIQUE_AHEAD; job->foreseen++) {
        job_set_frame(job, job->foreseen, view);
        cmd_check(foresee(data, job->foreseen + 1, view, &err), NULL, &err);
    }
    job_set_frame(job, frame, view);
    return depends ? frame + 1 : 0;
}

void job_make_canvas(struct job *job, struct canvas *canvas)
{
    const struct options *options = job->options;
    struct hatch_err err;
    cmd_check(picture_canvas(&job->frame, options->width, options->height, options->side, canvas, &err), NULL, &err);
}

void job_end(struct job *job)
{
    for (size_t i = 0; i < sizeof job->instances / sizeof *job->instances; i++)
        technique_close(&job->instances[i]);
    look_free(&job->look);
    line_overlay_free(&job->lines);
    assets_free(&job->assets);
    frame_free(&job->frame);
    scene_free(&job->scene);
    gpu_context_close(&job->gpu);
}
