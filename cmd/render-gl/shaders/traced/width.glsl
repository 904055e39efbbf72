// The width of a stroke at a point in the picture: libhatch/curve/width.h, where the law is explained.
const float FADE = 0.5877867; // logarithm of HATCH_STROKE_FADE
const float GAIN = 1.058634;

// pen: width in pixels, thin, full
float whole_px(vec3 pen, float tone)
{
    return pen.x * mix(pen.y, 1.0, min(tone / pen.z, 1.0));
}

float width_px(vec3 pen, float tone, float threshold, float scale)
{
    float whole = whole_px(pen, tone), wanted = tone * scale / (GAIN * whole);
    return whole * clamp(0.5 + 0.5 / FADE * log(max(wanted, 1e-30) / threshold), 0.0, 1.0);
}
