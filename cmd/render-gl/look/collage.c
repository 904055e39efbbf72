/* The look of collages (section 4.3): strips of paper, one for each band of tone, with white borders. Strips in which
 * no disk fits that shows paper between the borders are given to the strips beside them. */
#include <math.h>

#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/texture.h"
#include "render-gl/look/passes.h"

#define DISK 2.2   /* radius of that disk, in widths of borders */
#define REACH 3.0  /* how far from its core a strip can gain pixels, in radii (collage/nearest.frag) */
#define WIDEST 1.4 /* greatest width of a border, relative to the usual (collage/bands.frag) */

enum { PIXELS, AWAY, CORES, NEAREST, JOIN, PASTE, PASS_COUNT };
static const struct look_pass passes[PASS_COUNT] = {
    [PIXELS] = {"pixels", "collage/pixels.frag", {GL_RGBA32F}, true, LOOK_NUMBER},
    [AWAY] = {"borders", "collage/away.frag", {GL_RGBA32F}, true, LOOK_ALONG | LOOK_RADIUS},
    [CORES] = {"cores", "collage/cores.frag", {GL_RGBA32F}, true, LOOK_RADIUS},
    [NEAREST] = {"cores", "collage/nearest.frag", {GL_RGBA32F}, true, LOOK_RADIUS | LOOK_NUMBER},
    [JOIN] = {"join", "collage/join.frag", {GL_RGBA32F}, true, LOOK_RADIUS | LOOK_NUMBER},
    [PASTE] = {"paste", "collage/paste.frag", {0}, false, LOOK_NUMBER}};

static struct frame_shading shading_of_papers(const struct look *look)
{
    struct frame_shading shading = look->shading;
    shading.stages.fragment = "collage/paper.frag";
    shading.passes[0].name = "paper";
    return shading;
}

enum hatch_status look_collage_prepare(struct look *look, struct frame *frame, struct hatch_err *err)
{
    const struct frame_shading papers = shading_of_papers(look);
    HATCH_TRY(frame_shader_prepare(frame, &papers, look->defines, &look->papers, err));
    return look_passes_compile(look, frame, passes, PASS_COUNT, err);
}

/* Finds the nearest core of each pixel.
 *   away    distances from the edges of strips
 *   target  out */
static enum hatch_status find_cores(struct look_drawing drawing, const struct gpu_target *away,
                                    const struct gpu_target **target, struct hatch_err *err)
{
    const struct gpu_target *steps[2];
    struct look_uniforms uniforms = {.radius = DISK * look_options.border_px};
    GLint jump = 1;
    while (2 * jump <= REACH * uniforms.radius)
        jump *= 2;
    gpu_texture_bind(UNIT_SOURCE, away->outputs[0], 0);
    HATCH_TRY(look_pass_add(drawing, &passes[CORES], &uniforms, &steps[0], err));
    HATCH_TRY(look_pass_target(drawing, &passes[NEAREST], &steps[1], err));
    gpu_texture_bind(UNIT_TECHNIQUE + 1, away->outputs[0], 0);
    *target = steps[0];
    for (uint32_t i = 1; jump > 0; i++, jump /= 2) {
        uniforms.number = jump;
        gpu_texture_bind(UNIT_SOURCE, (*target)->outputs[0], 0);
        *target = steps[i % 2];
        HATCH_TRY(look_pass_run(drawing, &passes[NEAREST], &uniforms, *target, err));
    }
    return HATCH_OK;
}

/* Finds the strip of each pixel, and how far the pixel is from its edge.
 *   strips  the bands of samples
 *   target  out */
static enum hatch_status cut_strips(struct look_drawing drawing, const struct gpu_target *strips,
                                    const struct gpu_target **target, struct hatch_err *err)
{
    const struct gpu_target *pixels, *away, *cores, *joined;
    const double border = look_options.border_px;
    const struct look_uniforms uniforms = {.radius = border, .number = (GLint)drawing.frame->request.canvas->side};
    gpu_texture_bind(UNIT_SOURCE, strips->outputs[0], 0);
    HATCH_TRY(look_pass_add(drawing, &passes[PIXELS], &uniforms, &pixels, err));
    HATCH_TRY(look_pass_both(drawing, &passes[AWAY], pixels->outputs[0], DISK * border, &away, err));
    HATCH_TRY(find_cores(drawing, away, &cores, err));
    gpu_texture_bind(UNIT_SOURCE, cores->outputs[0], 0);
    gpu_texture_bind(UNIT_TECHNIQUE + 2, strips->outputs[0], 0);
    HATCH_TRY(look_pass_add(drawing, &passes[JOIN], &uniforms, &joined, err));
    return look_pass_both(drawing, &passes[AWAY], joined->outputs[0], WIDEST * border, target, err);
}

enum hatch_status look_collage_draw(struct look_drawing drawing, struct hatch_err *err)
{
    const struct canvas *canvas = drawing.frame->request.canvas;
    const struct frame_shading shading = shading_of_papers(drawing.look);
    const struct look_uniforms uniforms = {.number = (GLint)canvas->side};
    struct gpu_target_form form = {.width = canvas->samples.form.width,
                                   .height = canvas->samples.form.height,
                                   .outputs = {GL_RG32F},
                                   .depth = GL_DEPTH_COMPONENT32F};
    const struct gpu_target *strips, *away, *papers;
    HATCH_TRY(look_draw_items(drawing, &form, &drawing.look->shading, &drawing.look->shader, &strips, err));
    HATCH_TRY(cut_strips(drawing, strips, &away, err));
    form.width /= canvas->side;
    form.height /= canvas->side;
    form.outputs[0] = GL_RGBA16F;
    gpu_texture_bind(UNIT_TECHNIQUE + 1, away->outputs[0], 0);
    HATCH_TRY(look_draw_items(drawing, &form, &shading, &drawing.look->papers, &papers, err));
    gpu_texture_bind(UNIT_SOURCE, papers->outputs[0], 0);
    gpu_texture_bind(UNIT_TECHNIQUE + 2, strips->outputs[0], 0);
    gpu_texture_bind(UNIT_TECHNIQUE + 4, strips->depth, 0);
    return look_pass_run(drawing, &passes[PASTE], &uniforms, NULL, err);
}

uint32_t look_collage_reach_px(void)
{
    return (uint32_t)ceil(((REACH + 1) * DISK + WIDEST) * look_options.border_px) + 2;
}
