// Smooth noise along strokes, from -1 to 1, and the grain of paper.
uint mix_bits(uint x)
{
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    return x ^ x >> 16;
}

float hash_unit(uint x)
{
    return float(mix_bits(x) >> 8) * (2.0 / 16777216.0) - 1.0;
}

float wave_noise(uint stroke, float at)
{
    float cell = floor(at), from = at - cell;
    uint number = stroke + uint(int(cell)) * 0x9e3779b9u;
    return mix(hash_unit(number), hash_unit(number + 0x9e3779b9u), from * from * (3.0 - 2.0 * from));
}

// Returns noise whose waves keep about the same length in pixels at any scale: it fades from one octave to the next.
// octave: binary logarithm of waves per unit of `at`
float stroke_noise(uint stroke, float at, float octave)
{
    float low = floor(octave);
    return mix(wave_noise(stroke + uint(int(low)), at * exp2(low)),
               wave_noise(stroke + uint(int(low) + 1), at * exp2(low + 1.0)), octave - low);
}

// Returns noise that is fixed to the paper, 0 .. 1: that of grains about two pixels wide.
float paper_grain(vec2 at)
{
    vec2 cell = floor(0.6 * at), from = smoothstep(0.0, 1.0, 0.6 * at - cell);
    uint number = uint(int(cell.x)) * 0x9e3779b9u + uint(int(cell.y)) * 0x85ebca6bu;
    float low = mix(hash_unit(number), hash_unit(number + 0x9e3779b9u), from.x);
    float high = mix(hash_unit(number + 0x85ebca6bu), hash_unit(number + 0x9e3779b9u + 0x85ebca6bu), from.x);
    return 0.5 + 0.5 * mix(low, high, from.y);
}
