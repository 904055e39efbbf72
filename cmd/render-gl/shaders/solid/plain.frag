// Draws surfaces whose reflectance is the texture's, under the light of the tone.
#include "frame/amounts.glsl"
#include "solid/zoom.glsl"

out vec4 o_color;

void main()
{
    base_holes();
    vec2 asked = amounts();
    vec3 grain = mix(vec3(1.0), texture_color(solid_of_material()), marks.x);
    vec3 dark = counts.z == 1 ? grain * asked.x : 1.0 - grain * (1.0 - asked.x); // a light ink shows what is lit
    o_color = vec4(base_color(0.0) * own_ink_on_paper(dark, grain * asked.y), opacity);
}
