/* Brushes with an image: those of a style whose strokes have a grain, or come from a picture. */
#include <math.h>

#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/texture.h"
#include "render-gl/technique/strokes/strokes.h"

#define PROFILE_LEAST 0.4 /* least mean alpha of a profile, in that of the whole brush: ends do not get wider */

static GLuint upload(const struct hatch_image *image, GLint wrap)
{
    static const float whole = 1;
    const bool any = image->pixels != NULL;
    GLuint texture = gpu_texture_2d(GL_R16F, any ? image->width : 1, any ? image->height : 1);
    glTextureSubImage2D(texture, 0, 0, 0, any ? (GLsizei)image->width : 1, any ? (GLsizei)image->height : 1, GL_RED,
                        GL_FLOAT, any ? image->pixels : &whole);
    glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_S, wrap);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_T, wrap);
    return texture;
}

/* Computes the mean alpha across the brush at evenly spaced places along it.
 *   ink  mean ink of the pen that draws with it */
static void find_profile(const struct rptam_stroke *stroke, double ink, float profile[BRUSH_PROFILE])
{
    const struct hatch_image *alpha = &stroke->alpha;
    const struct hatch_image none = {.pixels = NULL};
    double mean = rptam_mean_ink(alpha, &none), grain = ink * rptam_mean_ink(alpha, &stroke->grain) / mean;
    for (uint32_t k = 0; k < BRUSH_PROFILE; k++) {
        uint32_t x = k * (alpha->width - 1) / (BRUSH_PROFILE - 1);
        double sum = 0;
        for (uint32_t y = 0; y < alpha->height; y++)
            sum += (double)alpha->pixels[(size_t)y * alpha->width + x];
        profile[k] = (float)(grain * fmax(sum / alpha->height, PROFILE_LEAST * mean));
    }
}

void strokes_take_brush(struct strokes_state *state)
{
    const struct rptam_stroke *stroke = &state->seeds.source.stroke;
    state->has_brush = stroke->varied;
    if (!state->has_brush || state->brush[0])
        return;
    state->brush[0] = upload(&stroke->alpha, GL_CLAMP_TO_EDGE);
    state->brush[1] = upload(&stroke->grain, GL_REPEAT);
}

double strokes_use_brush(const struct strokes_state *state, bool even)
{
    const struct hatch_stroke_pen *pen = &state->seeds.source.drawing.pen;
    double pressure = (1 - 0.5 * (double)pen->pressure) * hatch_profile_mean(&pen->look.pressure),
           grain = state->has_brush ? 1 : 1 - 0.5 * (double)pen->grain;
    float profile[BRUSH_PROFILE];
    double mean = 0;
    for (uint32_t k = 0; k < BRUSH_PROFILE; k++)
        profile[k] = even ? 1 : (float)(pressure * grain);
    if (state->has_brush && !even)
        find_profile(&state->seeds.source.stroke, pressure, profile);
    glProgramUniform1fv(state->extrude->name, UNIFORM_PROFILE, BRUSH_PROFILE, profile);
    for (uint32_t k = 0; k < BRUSH_PROFILE; k++)
        mean += (double)profile[k] / BRUSH_PROFILE;
    if (state->has_brush)
        glProgramUniform1f(state->ribbon->name, UNIFORM_BRUSH, (float)rptam_options.stroke_px[0]);
    return mean;
}

void strokes_bind_brush(const struct strokes_state *state)
{
    for (uint32_t i = 0; i < 2 && state->has_brush; i++)
        gpu_texture_bind(UNIT_TECHNIQUE + 1 + i, state->brush[i], 0);
}
