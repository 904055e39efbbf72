// Passes faces on unchanged. Drivers may compute depth differently with a geometry stage, and the depth here must equal
// that of techniques that have one.
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
