// Draws lines over the picture by their coverage.
layout(binding = UNIT_TONES) uniform sampler2D coverage;
layout(location = UNIFORM_A) uniform vec3 color;
out vec4 o_color;

void main()
{
    float share = texelFetch(coverage, ivec2(gl_FragCoord.xy), 0).r;
    if (share <= 0.0)
        discard;
    o_color = vec4(color, share);
}
