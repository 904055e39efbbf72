// Writes which patch lies on top: its number plus 2. Other surfaces write 0, and paper below patches at most 1.
#include "frame/frame.glsl"
#include "frame/base.glsl"

flat in uint v_chart;
out float o_owner;

void main()
{
    base_holes();
#ifdef OUTLINE
    if (opacity < 0.5)
        discard;
    o_owner = float(v_chart + 2u);
#else
    o_owner = 0.0;
#endif
}
