// Passes on faces unchanged. Drivers may compute depth differently with a geometry stage, and the depth of surfaces
// must equal that of techniques that have such a stage.
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
