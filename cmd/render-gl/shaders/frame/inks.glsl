// Ink on paper. amounts are shares of the area, per colour channel.
vec3 ink_on_paper(vec3 dark, vec3 light)
{
    return paper.rgb + dark * (ink.rgb - paper.rgb) + light * (light_ink.rgb - paper.rgb);
}
