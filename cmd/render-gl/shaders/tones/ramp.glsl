#include "frame/frame.glsl"

// The weights of columns are computed at the vertices if the tone is known there.
#if !defined(PIXEL_LIGHT) && !defined(BASE_TONE)
#define WEIGHTS_AT_VERTICES 1
#endif

// Computes the weights of six columns for an amount of ink. Between the tones of two columns, the two are blended.
// Below the tone of the first column, that column is blended with paper; above the tone of the last, it is used alone.
void column_weights(float amount, out vec3 first, out vec3 second)
{
    vec3 a = clamp((amount - ramp_low[0].xyz) * ramp_scale[0].xyz, 0.0, 1.0);
    vec3 b = clamp((amount - ramp_low[1].xyz) * ramp_scale[1].xyz, 0.0, 1.0);
    first = a - vec3(a.yz, b.x);
    second = b - vec3(b.yz, 0.0);
}
