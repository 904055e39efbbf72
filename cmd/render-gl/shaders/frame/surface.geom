// Passes faces on as they are. Drivers may divide and clip otherwise after a geometry stage than without
// one, and depths have to be equal to those of techniques that have one.
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

void main()
{
    for (int i = 0; i < 3; i++) {
        gl_Position = gl_in[i].gl_Position;
        EmitVertex();
    }
    EndPrimitive();
}
