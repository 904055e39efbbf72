// First pass of the watercolour: amounts of ink, and the texture's values, for the passes over the image.
#include "frame/amounts.glsl"
#include "solid/zoom.glsl"

layout(location = 0) out vec4 o_wash;  // amounts of dark and light ink; 1
layout(location = 2) out vec4 o_ink;
layout(location = 1) out vec4 o_grain; // rank of the texture; its large variation, wobble along x and y, -1 .. 1

void main()
{
    base_holes();
    Cycle cycle = cycle_here();
    int solid = solid_of_material();
    o_ink = vec4(own_ink(), 1.0);
    o_wash = vec4(amounts(), 1.0, 1.0);
    o_grain.x = values_here(solid, cycle).r;
    o_grain.y = variation(solid, cycle, vec3(0.37, 0.11, 0.73), 2.0);
    o_grain.z = variation(solid, cycle, vec3(0.5, 0.25, 0.75), 1.0);
    o_grain.w = variation(solid, cycle, vec3(0.15, 0.6, 0.35), 1.0);
}
