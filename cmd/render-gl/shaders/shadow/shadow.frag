// Draws depth only; holes let light through.
#include "frame/frame.glsl"
#include "frame/base.glsl"

void main()
{
    base_holes();
}
