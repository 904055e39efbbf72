#include "render-gl/frame/canvas.h"

#include <assert.h>
#include <stdio.h>

#include "render-gl/frame/pass.h"
#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/texture.h"

enum hatch_status canvas_make(uint32_t width, uint32_t height, uint32_t side, struct gpu_programs *programs,
                              struct canvas *canvas, struct hatch_err *err)
{
    static const struct gpu_stages average = {.vertex = "canvas/screen.vert", .fragment = "canvas/average.frag"};
    static const struct gpu_stages present = {.vertex = "canvas/screen.vert", .fragment = "canvas/present.frag"};
    const struct gpu_target_form samples = {
        .width = side * width, .height = side * height, .outputs = {GL_RGBA16F}, .depth = GL_DEPTH_COMPONENT32F};
    const struct gpu_target_form means = {.width = width, .height = height, .outputs = {GL_RGBA16F}};
    struct canvas made = {.width = width, .height = height, .side = side};
    char defines[32];
    snprintf(defines, sizeof defines, "#define SAMPLES_SIDE %u\n", side);
    HATCH_TRY(gpu_program_get(programs, &average, defines, &made.average, err));
    HATCH_TRY(gpu_program_get(programs, &present, "", &made.present, err));
    enum hatch_status status = gpu_target_make(&samples, &made.samples, err);
    if (status == HATCH_OK && side > 1)
        status = gpu_target_make(&means, &made.means, err);
    if (status != HATCH_OK) {
        canvas_free(&made);
        return status;
    }
    glTextureParameteri(made.samples.outputs[0], GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    *canvas = made;
    canvas->picture = side > 1 ? &canvas->means : &canvas->samples;
    return HATCH_OK;
}

static void copy(GLuint from, const struct gpu_program *program, const struct frame_pass *pass)
{
    gpu_texture_bind(UNIT_TONES, from, 0);
    frame_pass_begin(pass);
    frame_pass_screen(program);
}

void canvas_resolve(const struct canvas *canvas)
{
    if (canvas->side > 1)
        copy(canvas->samples.outputs[0], canvas->average, &(struct frame_pass){.target = &canvas->means});
}

void canvas_present(const struct canvas *canvas)
{
    const struct gpu_target window = {.form = {.width = canvas->width, .height = canvas->height}};
    copy(canvas->picture->outputs[0], canvas->present, &(struct frame_pass){.target = &window});
}

void canvas_read(const struct canvas *canvas, struct gpu_rectangle from, struct hatch_image *image, uint32_t x,
                 uint32_t y)
{
    assert(image->channel_count == 3 && x + from.width <= image->width && y + from.height <= image->height);
    float *corner = image->pixels + 3 * ((size_t)(image->height - y - from.height) * image->width + x);
    gpu_target_read(canvas->picture, 0, from, GL_RGB, GL_FLOAT, image->width, corner);
    /* OpenGL's first row is the lowest, an image's first row is the highest. */
    for (size_t low = 0, high = from.height - 1; low < high; low++, high--)
        for (size_t i = 0; i < 3 * (size_t)from.width; i++) {
            float *a = corner + 3 * low * image->width + i, *b = corner + 3 * high * image->width + i;
            float swap = *a;
            *a = *b;
            *b = swap;
        }
}

void canvas_read_samples(const struct canvas *canvas, float *rgba)
{
    const struct gpu_rectangle all = {0, 0, canvas->samples.form.width, canvas->samples.form.height};
    gpu_target_read(&canvas->samples, 0, all, GL_RGBA, GL_FLOAT, 0, rgba);
}

void canvas_free(struct canvas *canvas)
{
    gpu_target_free(&canvas->samples);
    gpu_target_free(&canvas->means);
    *canvas = (struct canvas){.picture = NULL};
}
