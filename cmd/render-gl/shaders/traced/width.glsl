// The width of a stroke at a point in the picture: libhatch/curve/width.h, where the law is explained.
const float FADE = 2.0, HALF = 0.5, GAIN = 1.039721, SPARE = 1.4, WIDEST = 2.4;

float ink_beyond(float factor)
{
    return factor < FADE ? HALF * (2.0 * log(FADE / factor) - (FADE - factor)) : 0.0;
}

// hatch_stroke_grazing
float grazing_factor(float scale, float facing_scale, float grazing)
{
    return sqrt(sqrt(1.0 + pow(grazing * facing_scale / max(scale, 1e-9 * facing_scale), 4.0)));
}

// Returns the width of a whole stroke in pixels, the share of it that is drawn, and by what factor strokes are sparser
// than wanted.
// pen: width in pixels, thin; densest: greatest threshold, and the factor of those beyond; denser: grazing_factor;
// dots: sparse strokes have more dots, and are no wider
vec3 width_law(vec2 pen, float tone, float threshold, float scale, vec2 densest, float denser, bool dots)
{
    float whole = pen.x * (pen.y + (1.0 - pen.y) * 2.0 * tone), wanted = tone * scale / (GAIN * whole);
    denser = max(min(denser, densest.x / (FADE * max(wanted, 1e-30))), 1.0);
    whole /= denser;
    wanted *= denser;
    float drawn = max(min(wanted, densest.x / SPARE), 1e-30), factor = densest.x / drawn;
    float lacking = (ink_beyond(factor) - ink_beyond(densest.y * factor) / densest.y) / GAIN;
    float sparser = wanted / drawn / (1.0 - lacking), ratio = drawn / threshold;
    float share = clamp(min(HALF + (1.0 - HALF) * (ratio - 1.0), HALF * (2.0 * ratio - 1.0)), 0.0, 1.0);
    return vec3(whole * (dots ? 1.0 : min(sparser, WIDEST)), share, sparser);
}
