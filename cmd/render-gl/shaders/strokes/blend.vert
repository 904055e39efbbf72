// Sends a fragment, as a point, to the slot of its stroke.
#include "strokes/slots.glsl"

layout(location = ATTRIBUTE_FRAGMENT) in uvec4 fragment; // fragments.glsl
flat out uvec4 v_fragment;

void main()
{
    vec2 at = vec2(texel_of(slot_of(fragment.xy))) + 0.5;
    v_fragment = fragment;
    gl_Position = vec4(2.0 * at / vec2(textureSize(table, 0)) - 1.0, 0.5, 1.0);
}
