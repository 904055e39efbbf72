// Draws depth only, and discards holes, which let light through.
#include "frame/frame.glsl"
#include "frame/base.glsl"

void main()
{
    base_holes();
}
