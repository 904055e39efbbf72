/* Preloaded into render-gl: writes the source of each shader stage, as passed to the driver, to a file in the folder
 * $SHADERS, named by its hash and with the suffix of its stage. */
#include <epoxy/gl.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

/* libepoxy calls through a pointer of its own, which the first call resolves and replaces. */
static PFNGLSHADERSOURCEPROC next;

static const char *ending(GLuint shader)
{
    GLint kind = 0;
    glGetShaderiv(shader, GL_SHADER_TYPE, &kind);
    return kind == GL_VERTEX_SHADER     ? "vert"
           : kind == GL_GEOMETRY_SHADER ? "geom"
           : kind == GL_COMPUTE_SHADER  ? "comp"
                                        : "frag";
}

/* FNV-1a */
static uint64_t hash(const GLchar *text, GLint length)
{
    uint64_t sum = 0xcbf29ce484222325;
    for (GLint i = 0; i < length; i++)
        sum = (sum ^ (unsigned char)text[i]) * 0x100000001b3;
    return sum;
}

static void APIENTRY keep(GLuint shader, GLsizei count, const GLchar *const *text, const GLint *length)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%016" PRIx64 ".%s", getenv("SHADERS"), hash(*text, *length), ending(shader));
    FILE *file = fopen(path, "w");
    if (!file || fwrite(*text, 1, (size_t)*length, file) != (size_t)*length || fclose(file) != 0)
        abort();
    epoxy_glShaderSource = next;
    glShaderSource(shader, count, text, length);
    next = epoxy_glShaderSource;
    epoxy_glShaderSource = keep;
}

__attribute__((constructor)) static void begin(void)
{
    next = epoxy_glShaderSource;
    epoxy_glShaderSource = keep;
}
