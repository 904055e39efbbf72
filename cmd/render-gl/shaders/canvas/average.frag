// Computes the mean of a pixel's SAMPLES_SIDE by SAMPLES_SIDE samples. A filtered read at the corner where four samples
// meet returns the mean of these four.
layout(binding = UNIT_TONES) uniform sampler2D samples;
out vec4 o_color;

void main()
{
    vec2 corner = floor(gl_FragCoord.xy) * float(SAMPLES_SIDE);
    vec3 sum = vec3(0.0);
#if SAMPLES_SIDE % 2 == 0
    vec2 size = vec2(textureSize(samples, 0));
    for (int y = 1; y < SAMPLES_SIDE; y += 2)
        for (int x = 1; x < SAMPLES_SIDE; x += 2)
            sum += 4.0 * textureLod(samples, (corner + vec2(x, y)) / size, 0.0).rgb;
#else
    for (int y = 0; y < SAMPLES_SIDE; y++)
        for (int x = 0; x < SAMPLES_SIDE; x++)
            sum += texelFetch(samples, ivec2(corner) + ivec2(x, y), 0).rgb;
#endif
    o_color = vec4(sum / float(SAMPLES_SIDE * SAMPLES_SIDE), 1.0);
}
