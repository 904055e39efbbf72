// Copies the painted pixels to all samples of the canvas, with the depth of the scene.
#include "solid/image.glsl"

out vec4 o_color;

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy);
    o_color = texelFetch(blurred, here / side_samples(), 0);
    gl_FragDepth = texelFetch(depths, here, 0).x;
}
