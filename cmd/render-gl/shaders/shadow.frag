// Depth alone; holes let light through.
#include "frame.glsl"
#include "base.glsl"

void main()
{
    base_holes();
}
