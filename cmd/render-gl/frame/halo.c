#include "render-gl/frame/halo.h"

#include <math.h>

#include "render-gl/frame/pass.h"
#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/gpu/texture.h"

/* Edges are found in two steps. Cells are squares of samples, and blocks are squares of cells. The first step finds the
 * edge nearest to the eye in each cell, the second one the depth of the nearest edge in each block. */
#define BLOCK 8u             /* cells along a block's side; the same as in shaders/halo/halo.glsl */
#define REACH_MAX_CELLS 12.0 /* greatest width of haloes in cells: for wider haloes, cells become larger */
/* Smallest jump of depth that gets a halo, in half heights of the picture at the nearer depth. Haloes fade in from here
 * to twice this. */
#define JUMP_MIN 0.015

/* std140 layout; the same as block Halo of shaders/halo/halo.glsl. */
struct halo_block {
    float sizes[4]; /* in samples: width of haloes, a cell's side, a pixel's side; 0 */
    float depth[4]; /* factors from differences and from ratios of depth to half heights of the picture; JUMP_MIN; 0 */
};

static const char defines[] = "#define HALOES 1\n";

static uint32_t divide_rounding_up(uint32_t whole, uint32_t part)
{
    return (whole + part - 1) / part;
}

/* Runs one of the two steps: draws into a transient target with a shader that reads the textures bound so far, and
 * binds the result to a texture unit. */
static enum hatch_status reduce(const char *fragment, const struct gpu_target_form *form, GLuint unit,
                                struct gpu_programs *programs, struct frame_targets *targets, struct hatch_err *err)
{
    const struct gpu_stages stages = {.vertex = "canvas/screen.vert", .fragment = fragment};
    const struct gpu_program *program;
    const struct gpu_target *target;
    HATCH_TRY(gpu_program_get(programs, &stages, defines, &program, err));
    HATCH_TRY(frame_target(targets, form, &target, err));
    frame_pass_begin(&(struct frame_pass){.target = target});
    frame_pass_screen(program);
    gpu_texture_bind(unit, target->outputs[0], 0);
    return HATCH_OK;
}

/* Draws the haloes of the edges found over the canvas's colour. The framebuffer has no depth, because shaders read it.
 */
static void cover(struct halo *halo, const struct canvas *canvas, const struct gpu_program *program, const float rgb[3],
                  uint32_t blocks)
{
    struct gpu_target colors = canvas->samples;
    if (!halo->framebuffer)
        glCreateFramebuffers(1, &halo->framebuffer);
    colors.framebuffer = halo->framebuffer;
    glNamedFramebufferTexture(colors.framebuffer, GL_COLOR_ATTACHMENT0, colors.outputs[0], 0);
    frame_pass_begin(&(struct frame_pass){.target = &colors, .blend = FRAME_BLEND_OVER_COLOR});
    glProgramUniform3fv(program->name, UNIFORM_A, 1, rgb);
    frame_pass_quads(program, 0, (GLsizei)blocks);
}

enum hatch_status halo_draw(struct halo *halo, const struct canvas *canvas, const struct hatch_view *view,
                            double reach_px, const float rgb[3], struct gpu_programs *programs,
                            struct frame_targets *targets, struct hatch_err *err)
{
    static const struct gpu_stages stages = {.vertex = "halo/halo.vert", .fragment = "halo/halo.frag"};
    double reach = reach_px * canvas->side, half = 1 / view->half_height;
    uint32_t cell = (uint32_t)fmax(canvas->side, ceil(reach / REACH_MAX_CELLS));
    const struct gpu_target_form cells = {.width = divide_rounding_up(canvas->samples.form.width, cell),
                                          .height = divide_rounding_up(canvas->samples.form.height, cell),
                                          .outputs = {GL_RGBA32F}};
    const struct gpu_target_form blocks = {.width = divide_rounding_up(cells.width, BLOCK),
                                           .height = divide_rounding_up(cells.height, BLOCK),
                                           .outputs = {GL_R32F}};
    const struct halo_block block = {.sizes = {(float)reach, (float)cell, (float)canvas->side, 0},
                                     .depth = {view->orthographic ? (float)(half * (view->far - view->near)) : 0.0f,
                                               view->orthographic ? 0.0f : (float)half, (float)JUMP_MIN,
                                               (float)hatch_view_depth_shift(view)}};
    const struct gpu_program *program;
    HATCH_TRY(gpu_program_get(programs, &stages, defines, &program, err));
    gpu_block_update(&halo->buffer, BLOCK_HALOES, &block, sizeof block);
    gpu_texture_bind(UNIT_HALO_DEPTHS, canvas->samples.depth, 0);
    HATCH_TRY(reduce("halo/cells.frag", &cells, UNIT_HALO_CELLS, programs, targets, err));
    HATCH_TRY(reduce("halo/blocks.frag", &blocks, UNIT_HALO_BLOCKS, programs, targets, err));
    cover(halo, canvas, program, rgb, blocks.width * blocks.height);
    return HATCH_OK;
}

void halo_free(struct halo *halo)
{
    glDeleteBuffers(1, &halo->buffer);
    glDeleteFramebuffers(1, &halo->framebuffer);
    *halo = (struct halo){.buffer = 0};
}
