// Reads the material's texture as tone (BASE_TONE), as colour (BASE_COLOR), as holes (BASE_HOLES), or as the outline of
// patches (OUTLINE). BASE_TEXTURE is defined with any of them.
#ifdef BASE_TEXTURE
in vec2 v_base_texcoord;
#endif

float base_light()
{
#ifdef BASE_TONE
    return dot(texture(base_texture, v_base_texcoord).rgb, vec3(0.2126, 0.7152, 0.0722));
#else
    return 1.0;
#endif
}

layout(location = UNIFORM_TINT) uniform vec3 tint; // the material's colour; white where colours are not drawn

// Returns the colour of the surface. coarser: mip levels above that of a sample
vec3 base_color(float coarser)
{
#ifdef BASE_COLOR
    return tint * texture(base_texture, v_base_texcoord, coarser).rgb;
#else
    return tint;
#endif
}

float opacity = 1.0; // opacity of the fragment; set by base_holes()

void base_holes()
{
#ifdef OUTLINE
    opacity = texture(base_texture, v_base_texcoord).r;
#ifdef THRESHOLD
    opacity = clamp(8.0 * opacity - 3.5, 0.0, 1.0);
#endif
    if (opacity <= 0.0)
        discard;
#endif
#ifdef BASE_HOLES
    if (texture(base_texture, v_base_texcoord).a < base.z)
        discard;
#endif
}
