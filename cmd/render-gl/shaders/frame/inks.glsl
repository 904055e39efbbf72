// Returns the colour of paper under ink. dark, light: coverage by the two inks in each colour channel, 0 .. 1.
vec3 ink_on_paper(vec3 dark, vec3 light)
{
    return paper.rgb + dark * (ink.rgb - paper.rgb) + light * (light_ink.rgb - paper.rgb);
}
