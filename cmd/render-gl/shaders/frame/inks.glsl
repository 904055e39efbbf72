// Returns the same coverage in each colour channel, that of the luminance.
vec3 in_grey(vec3 coverage)
{
    return vec3(dot(coverage, vec3(0.2126, 0.7152, 0.0722)));
}

// Returns the colour of paper under ink. dark, light: coverage by the two inks in each colour channel, 0 .. 1. The
// coverage of coloured strokes is 1 minus their colour: a light ink would give them the complementary one, and has its
// own instead.
vec3 ink_on_paper(vec3 dark, vec3 light)
{
    if (counts.z == 1)
        dark = in_grey(dark);
    light = in_grey(light);
    return paper.rgb + dark * (ink.rgb - paper.rgb) + light * (light_ink.rgb - paper.rgb);
}
