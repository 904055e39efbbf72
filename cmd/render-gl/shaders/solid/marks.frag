// First pass of the watercolour: amounts of ink, and the texture's values, for the passes over the image. With PICTURE
// the amounts are those of a picture that is there.
#include "frame/amounts.glsl"
#include "solid/zoom.glsl"

#define COARSER 2.0 // mip levels: washes show no fine detail of a material's texture
#define SMOOTH 3.0  // mip levels: borders that wobble are not frayed

#ifndef PICTURE
layout(location = 0) out vec4 o_wash;  // amounts of dark and light ink; 1
#endif
layout(location = 2) out vec4 o_ink;   // colour of the ink or, with COLORS, of the surface; 1
layout(location = 1) out vec4 o_grain; // rank of the texture; two large variations, -1 .. 1

void main()
{
    base_holes();
    Cycle cycle = cycle_here();
    int solid = solid_of_material();
#ifdef COLORS
    o_ink = vec4(base_color(COARSER), 1.0);
#else
    o_ink = vec4(own_ink(), 1.0);
#endif
#ifndef PICTURE
    o_wash = vec4(amounts(), 1.0, 1.0);
#endif
    o_grain.x = values_here(solid).r;
    o_grain.y = variation(solid, cycle, vec3(0.5, 0.25, 0.75), 2.0, SMOOTH);
    o_grain.z = variation(solid, cycle, vec3(0.15, 0.6, 0.35), 2.0, SMOOTH);
}
