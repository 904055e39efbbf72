/* manual_shader SHADER FILE ...: draws with a fragment shader that has the function hatch of tampack(1), and with the
 * KTX2 files of a map as its textures tam0, tam1 and so on. Prints, for eleven tones, the tone and the mean of the ink.
 */
#include <epoxy/gl.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/arena.h"
#include "io/texture/container.h"
#include "render-gl/gpu/context.h"

#define DIE(...) (fprintf(stderr, __VA_ARGS__), exit(1))

static struct hatch_arena keep;
static struct hatch_err err;

static struct hatch_bytes read_file(const char *path)
{
    FILE *file = fopen(path, "rb");
    size_t room = (size_t)1 << 24;
    char *text = HATCH_NEW(&keep, char, room, &err);
    size_t size = file && text ? fread(text, 1, room - 1, file) : 0;
    if (!size || fclose(file) != 0)
        DIE("%s: cannot read\n", path);
    return (struct hatch_bytes){(const uint8_t *)text, size};
}

static GLuint compile(GLenum kind, const char *const *text, GLsizei count)
{
    char said[4096] = "";
    GLint compiled = 0;
    GLuint shader = glCreateShader(kind);
    glShaderSource(shader, count, text, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    glGetShaderInfoLog(shader, sizeof said, NULL, said);
    if (!compiled)
        DIE("%s\n", said);
    return shader;
}

static GLuint link_program(const char *shader)
{
    static const char *const corners =
        "#version 330\nvoid main()\n{\n    gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, "
        "gl_VertexID == 2 ? 3 : -1, 0, 1);\n}\n";
    const char *const text[] = {"#version 330\n", shader,
                                "uniform float darkness;\nuniform vec2 size;\nout vec4 color;\nvoid main()\n{\n"
                                "    color = vec4(hatch(darkness, gl_FragCoord.xy / size));\n}\n"};
    GLint linked = 0;
    GLuint program = glCreateProgram();
    glAttachShader(program, compile(GL_VERTEX_SHADER, &corners, 1));
    glAttachShader(program, compile(GL_FRAGMENT_SHADER, text, 3));
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!linked)
        DIE("the shader cannot be linked\n");
    glUseProgram(program);
    return program;
}

static void set(GLuint program, const char *name, float value)
{
    glUniform1f(glGetUniformLocation(program, name), value);
}

/* The values of the keys that all files have. */
struct metadata {
    float tones, darkest, ink_is;
};

/* Reads the texture of a file, with its levels, into the texture unit of that number. */
static void load(const char *path, GLuint unit, struct metadata *metadata)
{
    struct hatch_bytes file = read_file(path);
    struct hatch_texels texture;
    const char *const *keys;
    GLuint name;
    if (hatch_ktx2_read(file, &keep, &texture, &err) != HATCH_OK ||
        hatch_ktx2_read_keys(file, &keep, &keys, &err) != HATCH_OK)
        DIE("%s: %s\n", path, err.text);
    const char *tones = hatch_texels_value(keys, "hatch:tone"), *ink = hatch_texels_value(keys, "hatch:ink");
    if (texture.channels != 4 || !tones || !ink)
        DIE("%s: not of layout rgb\n", path);
    char *end;
    for (float tone; tone = strtof(tones, &end), end != tones; tones = end) {
        metadata->tones++;
        metadata->darkest = tone;
    }
    metadata->ink_is = strtof(ink, NULL);
    glGenTextures(1, &name);
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, name);
    for (uint32_t level = 0; level < texture.level_count; level++)
        glTexImage2D(GL_TEXTURE_2D, (GLint)level, GL_RGBA8, (GLsizei)(texture.width >> level),
                     (GLsizei)(texture.height >> level), 0, GL_RGBA, GL_UNSIGNED_BYTE, texture.texels[level]);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, (GLint)texture.level_count - 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
}

#define SIDE 128

/* Makes a target of one channel that holds numbers over 1, too. */
static void make_target(void)
{
    GLuint target, frame, vertices;
    glGenTextures(1, &target);
    glActiveTexture(GL_TEXTURE31);
    glBindTexture(GL_TEXTURE_2D, target);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, SIDE, SIDE, 0, GL_RED, GL_FLOAT, NULL);
    glGenFramebuffers(1, &frame);
    glBindFramebuffer(GL_FRAMEBUFFER, frame);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target, 0);
    glGenVertexArrays(1, &vertices);
    glBindVertexArray(vertices);
    glViewport(0, 0, SIDE, SIDE);
}

static double mean_of(GLuint program, float darkness)
{
    static float pixels[SIDE * SIDE];
    double sum = 0;
    set(program, "darkness", darkness);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glReadPixels(0, 0, SIDE, SIDE, GL_RED, GL_FLOAT, pixels);
    for (size_t i = 0; i < SIDE * SIDE; i++)
        sum += (double)pixels[i];
    return sum / (SIDE * SIDE);
}

int main(int argc, char **argv)
{
    struct gpu_context context = {0};
    struct metadata metadata = {0, 0, -1};
    hatch_arena_init(&keep, (size_t)1 << 30);
    if (argc < 3 || gpu_context_open_headless(&context, 2, &err) != HATCH_OK)
        DIE("%s\n", argc < 3 ? "want a shader and files" : err.text);
    GLuint program = link_program((const char *)read_file(argv[1]).data);
    for (int i = 2; i < argc; i++) {
        char name[16];
        snprintf(name, sizeof name, "tam%d", i - 2);
        load(argv[i], (GLuint)(i - 2), &metadata);
        glUniform1i(glGetUniformLocation(program, name), i - 2);
    }
    set(program, "tones", metadata.tones);
    set(program, "darkest", metadata.darkest);
    set(program, "ink_is", metadata.ink_is);
    glUniform2f(glGetUniformLocation(program, "size"), SIDE, SIDE);
    make_target();
    for (int i = 0; i <= 10; i++) {
        float darkness = (float)i / 10 * metadata.darkest;
        printf("%.4f %.4f\n", (double)darkness, mean_of(program, darkness));
    }
    if (glGetError() != GL_NO_ERROR)
        DIE("OpenGL reports an error\n");
    gpu_context_close(&context);
    hatch_arena_free(&keep);
    return 0;
}
