// Draws ink where the texture's rank is below the tone: its values are thresholds, each covering an equal share of the
// surface (section 4.2). TABLES are those of HATCH_ZOOM_RANK.
#include "frame/amounts.glsl"
#include "solid/zoom.glsl"

out vec4 o_color;

// Returns the share of the fragment that is under ink: of its ranks, step around that in its middle, those below the
// tone. Ranks below 0 are reflected to above it, and those above 1 to below 1, so that ranks stay evenly distributed.
float covered(float rank, float step, float tone)
{
    float low = rank - 0.5 * step, high = rank + 0.5 * step;
    float below = max(min(high, tone) - max(low, -tone), 0.0) + max(high - (2.0 - tone), 0.0);
    return min(below / step, opacity);
}

void main()
{
    base_holes();
    vec2 asked = amounts();
    float rank = values_here(solid_of_material()).r;
    float step = clamp(length(vec2(dFdx(rank), dFdy(rank))), 0.01, 0.7);
    float dark = covered(rank, step, asked.x), light = covered(1.0 - rank, step, asked.y);
    o_color = vec4(own_ink_on_paper(vec3(dark), vec3(light)), opacity);
}
