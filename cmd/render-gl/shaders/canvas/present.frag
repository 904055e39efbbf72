// Copies the picture to the window, encoded as sRGB.
layout(binding = UNIT_TONES) uniform sampler2D picture;
out vec4 o_color;

void main()
{
    vec3 color = clamp(texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb, 0.0, 1.0);
    vec3 bright = 1.055 * pow(color, vec3(1.0 / 2.4)) - 0.055;
    o_color = vec4(mix(12.92 * color, bright, greaterThan(color, vec3(0.0031308))), 1.0);
}
