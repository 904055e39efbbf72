// Draws ink where the texture's rank is below the tone: its values are thresholds, each covering an equal share of the
// surface (section 4.2). TABLES are those of HATCH_ZOOM_RANK.
#include "frame/amounts.glsl"
#include "solid/zoom.glsl"

out vec4 o_color;

// Returns the share of the fragment that is under ink. step: change of the rank to the next fragment
float covered(float rank, float step, float tone)
{
    return clamp((tone * (1.0 + step) - rank) / step, 0.0, opacity);
}

void main()
{
    base_holes();
    vec2 asked = amounts();
    Cycle cycle = cycle_here();
    float rank = values_here(solid_of_material(), cycle).r;
    float step = clamp(length(vec2(dFdx(rank), dFdy(rank))), 0.01, 0.7);
    float dark = covered(rank, step, asked.x), light = covered(1.0 - rank, step, asked.y);
    o_color = vec4(own_ink_on_paper(vec3(dark), vec3(light)), opacity);
}
