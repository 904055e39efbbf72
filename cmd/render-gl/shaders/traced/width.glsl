// The width of a stroke at a point in the picture: libhatch/curve/width.h, where the law is explained.
const float HALF = 0.75, GAIN = 1.213008, SPARE = 1.65, WIDEST = 2.4;

// Returns the width of a whole stroke in pixels, the share of it that is drawn, and by what factor strokes are sparser
// than wanted.
// pen: width in pixels, thin; dots: sparse strokes have more dots, and are no wider
vec3 width_law(vec2 pen, float tone, float threshold, float scale, float densest, bool dots)
{
    float whole = pen.x * (pen.y + (1.0 - pen.y) * 2.0 * tone), wanted = tone * scale / (GAIN * whole);
    float sparser = max(SPARE * wanted / densest, 1.0);
    wanted /= dots ? sparser : min(sparser, WIDEST);
    whole *= dots ? 1.0 : min(sparser, WIDEST);
    float ratio = wanted / threshold;
    float share = clamp(min(HALF + (1.0 - HALF) * (ratio - 1.0), HALF * (2.0 * ratio - 1.0)), 0.0, 1.0);
    return vec3(whole, share, sparser);
}
