// The mean of a pixel's samples, in linear light; for a screen, encoded.
layout(binding = 0) uniform sampler2D samples;
layout(location = 0) uniform int side;   // samples along a side of a pixel
layout(location = 1) uniform bool encode;
out vec4 o_color;

void main()
{
    ivec2 corner = ivec2(gl_FragCoord.xy) * side;
    vec3 sum = vec3(0.0);
    for (int y = 0; y < side; y++)
        for (int x = 0; x < side; x++)
            sum += texelFetch(samples, corner + ivec2(x, y), 0).rgb;
    vec3 mean = sum / float(side * side);
    if (encode)
        mean = mix(12.92 * mean, 1.055 * pow(max(mean, 0.0), vec3(1.0 / 2.4)) - 0.055,
                   greaterThan(mean, vec3(0.0031308)));
    o_color = vec4(mean, 1.0);
}
