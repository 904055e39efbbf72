#include "render-gl/job.h"

#include "shared/map.h"
#include "shared/scene.h"
#include "render-gl/material.h"
#include "render-gl/meter.h"
#include "render-gl/normals.h"
#include "render-gl/picture.h"
#include "render-gl/repeat.h"

#define TWO_PI 6.28318530717958648
#define FIELD_SHADE 0.2 /* of the tone, so that marks stand out */
#define SPAN_MOMENTS 9  /* at which an animation's extent is measured */

/* Dies where the options ask for what the scene does not have. */
static void check_scene(const struct job *job)
{
    const struct options *options = &job->options;
    const char *name = cmd_input_name(options->scene_path);
    struct hatch_err err;
    if (options->technique == TECHNIQUE_PATCHES)
        cmd_check(load_check_patches(&job->scene, job->patches, &err), name, &err);
    if (technique_draws_strokes(techniques[options->technique]))
        cmd_check(load_check_texcoords(&job->scene, &err), name, &err);
    if (options->animation_given && options->animation >= job->scene.animation_count) {
        hatch_fail(&err, HATCH_BAD_INPUT, "animation %u: the scene has %u", options->animation,
                   job->scene.animation_count);
        cmd_die(name, &err);
    }
}

/* As when somebody takes --frames for a film of a scene in which nothing moves. */
static void warn_of_stillness(const struct job *job)
{
    const struct options *options = &job->options;
    if (options->frames > 1 && !options->turntable && !options->change_count && !job->scene.animation_count)
        cmd_warn(cmd_input_name(options->scene_path),
                 "no animation: all frames are alike without --turntable or --animate");
}

/* What is wrong with a map, and what a technique that packs six grey columns leaves out of it. */
static void warn_of_map(struct cmd_args *args, const struct options *options, const struct hatch_tam *map)
{
    cmd_warn_nesting(args, cmd_input_name(options->map_path), map);
    if (techniques[options->technique]->columns != COLUMNS_SIX)
        return;
    if (map->tones > COLUMNS_SIX_MOST)
        cmd_warn(cmd_input_name(options->map_path),
                 "%u of the map's %u columns are drawn, spread over it; tam-triple draws all", COLUMNS_SIX_MOST,
                 map->tones);
    if (map->color)
        cmd_warn(cmd_input_name(options->map_path), "the map's colours are drawn grey; tam-triple draws them");
}

/* Dies where the file is of another kind than the technique, or --probe, reads. */
static void check_strokes(const struct job *job)
{
    const struct options *options = &job->options;
    enum columns_form form = techniques[options->technique]->columns;
    bool map = job->map.tones > 0, wants_map = form == COLUMNS_SIX || form == COLUMNS_ARRAY || options->probe;
    struct hatch_err err;
    if (form == COLUMNS_NONE ? map || !options->probe : wants_map ? map : form == job->fine.form)
        return;
    hatch_fail(&err, HATCH_BAD_INPUT, "%s%s wants %s, this is %s", options->probe ? "--probe" : "technique ",
               options->probe ? "" : techniques[options->technique]->name,
               columns_name(options->probe ? COLUMNS_SIX : form), map ? "a tonal art map" : "another texture");
    cmd_die(cmd_input_name(options->map_path), &err);
}

/* What strokes are read from: a map, or a texture that was made of one. */
static void read_strokes(struct job *job)
{
    const struct options *options = &job->options;
    const char *name = cmd_input_name(options->map_path);
    struct hatch_bytes file = cmd_read(&job->args, options->map_path);
    struct hatch_err err;
    if (fine_is(file))
        cmd_check(fine_read(file, &job->args.keep, &job->args.scratch, &job->fine, &err), name, &err);
    else
        cmd_parse_map(&job->args, name, file, &job->map);
    check_strokes(job);
    if (job->map.tones)
        warn_of_map(&job->args, options, &job->map);
}

/* How the strokes' images repeat over surfaces. */
static enum hatch_status set_repeat(struct job *job, const struct hatch_view *view, struct hatch_err *err)
{
    const struct options *options = &job->options;
    bool map = job->map.tones > 0;
    return repeat_set(&job->gpu, options->repeat, view, options->height, map ? job->map.size_px : job->fine.size_px,
                      map ? job->map.levels : job->fine.levels, &job->args.scratch, err);
}

void job_read(struct job *job)
{
    const struct options *options = &job->options;
    struct hatch_mesh_notes notes = {0};
    load_scene(&job->args, job->args.operands, (uint32_t)job->args.operand_count, options->ground, &job->scene,
               &job->patches, &notes);
    if (techniques[options->technique]->seeds || options->seeds.path)
        job_read_seeds(job);
    if (options->map_path)
        read_strokes(job);
    check_scene(job);
    cmd_warn_mesh(cmd_input_name(options->scene_path), &notes);
    warn_of_stillness(job);
}

static double time_of(const struct job *job, uint32_t frame)
{
    return job->options.time_s + (double)frame / job->options.rate;
}

/* All frames share one unit scene and one framing, so that a framing camera stands still. */
static void set_span(struct job *job)
{
    const struct options *options = &job->options;
    bool moves = options->animated && job->scene.animation_count;
    job->span = (struct hatch_pose_span){.animation = moves ? options->animation : HATCH_NONE,
                                         .begin_s = options->time_s,
                                         .end_s = time_of(job, options->frames - 1)};
    if (moves && options->window)
        job->span.end_s = (double)job->scene.animations[options->animation].duration_s;
    moves = moves && job->span.end_s > job->span.begin_s;
    job->span.moments = moves ? SPAN_MOMENTS : 1;
}

static void open_context(struct job *job)
{
    const struct options *options = &job->options;
    struct hatch_err err;
    enum hatch_status status = options->window
                                   ? context_open_window(&job->context, options->width, options->height, &err)
                                   : context_open_headless(&job->context, job->args.threads, &err);
    cmd_check(status, NULL, &err);
    cmd_note("%s", job->context.device);
    if (options->style.anisotropy > job->context.anisotropy_max)
        cmd_note("the driver filters with anisotropy %g at most", (double)job->context.anisotropy_max);
}

static void upload(struct job *job)
{
    const struct options *options = &job->options;
    const char *name = cmd_input_name(options->scene_path);
    struct hatch_arena *keep = &job->args.keep, *scratch = &job->args.scratch;
    struct hatch_err err;
    struct hatch_bounds bounds;
    struct hatch_pose pose;
    set_span(job);
    cmd_check(hatch_pose_make(&job->scene, keep, &pose, &err), name, &err);
    cmd_check(hatch_pose_bounds(&pose, &job->span, scratch, &bounds, &err), name, &err);
    if (bounds.empty)
        cmd_warn(name, "the scene shows no faces");
    uint32_t left_out = options->style.light.wanted ? 0 : frame_lights_left_out(&job->scene);
    if (left_out)
        cmd_warn(name, "%u lights are left out: %u are the most", left_out, LIGHTS_MAX);
    cmd_check(hatch_view_make(&options->view, &pose, &job->span, &bounds, (double)options->width / options->height,
                              scratch, &job->fixed_view, &err),
              name, &err);
    open_context(job);
    cmd_check(scene_upload(&job->scene, job->patches, &bounds, keep, scratch, &job->gpu, &err), name, &err);
    material_upload(&job->args, name, options->style.base_tone && !options->modulate_path, job->context.size_max_px,
                    &job->gpu);
    if (options->style.pixel_light)
        normals_upload(&job->args, name, job->context.size_max_px, &job->gpu);
    if (options->modulate_path)
        material_modulate(&job->args, options->modulate_path, job->context.size_max_px, &job->gpu);
}

enum hatch_status job_make_lines(struct job *job, uint32_t kinds, struct hatch_err *err)
{
    struct line_style style = job->options.lines;
    style.kinds = kinds;
    HATCH_TRY(lines_make(&job->gpu, &style, &job->renderer.shaders, job->args.max_memory, &job->args.keep,
                         &job->args.scratch, &job->lines, err));
    job->renderer.lines = &job->lines;
    return HATCH_OK;
}

void job_prepare(struct job *job)
{
    const struct options *options = &job->options;
    struct hatch_arena *scratch = &job->args.scratch;
    struct hatch_err err;
    upload(job);
    job->renderer = (struct renderer){.shaders = {options->shader_folder, scratch},
                                      .style = options->style,
                                      .map = job->map.tones ? &job->map : NULL,
                                      .fine = job->fine.form != COLUMNS_NONE ? &job->fine : NULL,
                                      .rptam = job->renderer.rptam,
                                      .all_seeds = options->seeds.all,
                                      .scene = &job->gpu,
                                      .size_max_px = job->context.size_max_px};
    if (options->lines.kinds)
        cmd_check(job_make_lines(job, options->lines.kinds, &err), NULL, &err);
    if (options->map_path && !options->high_given)
        job->renderer.style.curve.high =
            (double)(job->map.tones ? job->map.target[job->map.tones - 1] : job->fine.darkest);
    if (job->renderer.rptam)
        job_set_darkest(job);
    struct hatch_view view;
    job_set_frame(job, 0, &view);
    if (!(options->style.curve.exposure > 0))
        cmd_check(meter_exposure(&job->gpu, &view, scratch, &job->renderer.style.curve.exposure, &err),
                  cmd_input_name(options->scene_path), &err);
    if (options->map_path)
        cmd_check(set_repeat(job, &view, &err), cmd_input_name(options->scene_path), &err);
    if (options->technique == TECHNIQUE_FIELD) {
        cmd_check(field_make(&job->gpu, &view, options->height, &job->renderer.shaders, &job->args.keep, scratch,
                             &job->field, &err),
                  cmd_input_name(options->scene_path), &err);
        job->renderer.field = &job->field;
        job->renderer.style.curve.high *= FIELD_SHADE;
    }
    cmd_check(renderer_prepare(&job->renderer, (uint32_t)options->technique, scratch, &err), NULL, &err);
}

void job_view(struct job *job, double time_s, struct hatch_view *view)
{
    struct hatch_err err;
    *view = job->fixed_view;
    if (!hatch_view_is_fixed(&job->options.view, &job->scene))
        cmd_check(hatch_view_make(&job->options.view, &job->gpu.pose, &job->span, &job->gpu.bounds, view->aspect,
                                  &job->args.scratch, view, &err),
                  cmd_input_name(job->options.scene_path), &err);
    const struct hatch_pose_span now = {.animation = job->span.animation, .begin_s = time_s, .moments = 1};
    if (job->options.zoom != 1)
        cmd_check(
            hatch_view_zoom(&job->gpu.pose, &now, &job->gpu.bounds, job->options.zoom, &job->args.scratch, view, &err),
            cmd_input_name(job->options.scene_path), &err);
}

void job_set_frame(struct job *job, uint32_t frame, struct hatch_view *view)
{
    const struct options *options = &job->options;
    struct hatch_err err;
    if (options->frames > 1)
        params_move(job, (double)frame / (options->frames - 1));
    cmd_check(job_refresh(job, &err), NULL, &err);
    cmd_check(scene_set_pose(&job->gpu, job->span.animation, time_of(job, frame), &job->args.scratch, &err),
              cmd_input_name(options->scene_path), &err);
    job_view(job, time_of(job, frame), view);
    if (options->turntable)
        hatch_view_turn(view, -TWO_PI * frame / options->frames);
}

void job_make_target(struct job *job, struct target *target)
{
    const struct options *options = &job->options;
    struct hatch_err err;
    cmd_check(picture_target(options->width, options->height, options->side, &job->renderer, target, &err), NULL, &err);
}

void job_end(struct job *job)
{
    lines_free(&job->lines);
    field_free(&job->field);
    renderer_free(&job->renderer);
    material_free(&job->gpu);
    scene_free(&job->gpu);
    context_close(&job->context);
    for (int i = 0; i < 2; i++)
        hatch_arena_free(&job->source.arenas[i]);
}
