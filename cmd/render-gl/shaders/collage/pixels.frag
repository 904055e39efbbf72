// Takes the strip of each pixel from the sample nearest to its middle.
layout(binding = UNIT_SOURCE) uniform sampler2D strips;
layout(location = UNIFORM_C) uniform int pixel_side; // samples along it
out vec4 o_strip; // as collage/away.frag reads it

void main()
{
    vec2 own = texelFetch(strips, ivec2(gl_FragCoord.xy) * pixel_side + pixel_side / 2, 0).xy;
    o_strip = vec4(own.x, 0.0, 1.0, own.y);
}
