// Draws a picture over the canvas, by its alpha.
layout(binding = UNIT_SOURCE) uniform sampler2D picture;
out vec4 o_color;

void main()
{
    o_color = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
}
