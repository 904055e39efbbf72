// For --needs: writes the amounts of both inks, 1 / w and the item's index plus 1; and the number of the face in two
// parts, with the binary logarithm of the pixels per tile of a map as aim() of tones/tones.glsl counts
// them for the finest level: by the shorter axis of a pixel's footprint, or by half of the longer one.
#include "frame/amounts.glsl"

in vec2 v_texcoord;
layout(location = 0) out vec4 o_tone;
layout(location = 1) out vec4 o_face;

void main()
{
    vec2 asked = amounts(), x = dFdx(v_texcoord), y = dFdy(v_texcoord);
    float area = x.x * y.y - x.y * y.x, longer = max(max(dot(x, x), dot(y, y)), 1e-30);
    base_holes();
    o_tone = vec4(asked, gl_FragCoord.w, float(item + 1u));
    float octave = -0.5 * log2(max(longer / 4.0, area * area / longer));
    o_face = vec4(float(gl_PrimitiveID & 0xfff), float(gl_PrimitiveID >> 12), octave, 0.0);
}
