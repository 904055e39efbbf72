// The material's texture as tone (BASE_TONE), and its holes (BASE_HOLES); BASE_TEXTURE with either.
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

void base_holes()
{
#ifdef BASE_HOLES
    if (texture(base_texture, v_base_texcoord).a < base.z)
        discard;
#endif
}
