#include "render-gl/gpu/program.h"

#include <stdio.h>
#include <string.h>

#include "base/bytes.h"
#include "shared/cmd.h"
#include "render-gl/gpu/shader_files.h"

#define INCLUDES_MAX 16u
#define NAME_MAX_BYTES 64u

/* The text of a stage while it is put together from files. The index of a file is its number in #line directives. */
struct stage_text {
    const struct gpu_programs *programs;
    struct hatch_buffer text;
    uint32_t file_count;
    char files[INCLUDES_MAX][NAME_MAX_BYTES];
};

static enum hatch_status find_text(const struct gpu_programs *programs, const char *name, struct hatch_bytes *text,
                                   struct hatch_err *err)
{
    if (programs->folder) {
        char path[4096];
        snprintf(path, sizeof path, "%s/%s", programs->folder, name);
        if (cmd_try_read(programs->scratch, path, text, err) != HATCH_OK)
            return hatch_fail_at(err, "shader %s: ", path);
        return HATCH_OK;
    }
    for (const struct shader_file *file = shader_files; file->name; file++)
        if (strcmp(file->name, name) == 0) {
            *text = (struct hatch_bytes){(const uint8_t *)file->text, strlen(file->text)};
            return HATCH_OK;
        }
    return hatch_fail(err, HATCH_BAD_INPUT, "shader %s: there is no such built-in file", name);
}

/* Extracts the file name from an #include line; from any other line, an empty name. */
static void included_name(const char *line, size_t length, char name[NAME_MAX_BYTES])
{
    static const char directive[] = "#include \"";
    size_t start = sizeof directive - 1;
    name[0] = '\0';
    if (length <= start || memcmp(line, directive, start) != 0)
        return;
    const char *end = memchr(line + start, '"', length - start);
    size_t size = end ? (size_t)(end - line) - start : 0;
    if (size > 0 && size < NAME_MAX_BYTES) {
        memcpy(name, line + start, size);
        name[size] = '\0';
    }
}

static bool has_file(const struct stage_text *stage, const char *name)
{
    for (uint32_t i = 0; i < stage->file_count; i++)
        if (strcmp(stage->files[i], name) == 0)
            return true;
    return false;
}

static enum hatch_status add_file(struct stage_text *stage, const char *name, struct hatch_err *err)
{
    struct hatch_bytes text;
    if (has_file(stage, name))
        return HATCH_OK;
    if (stage->file_count == INCLUDES_MAX)
        return hatch_fail(err, HATCH_BAD_INPUT, "shader %s: a stage includes more than %u files", name, INCLUDES_MAX);
    HATCH_TRY(find_text(stage->programs, name, &text, err));
    uint32_t number = stage->file_count++;
    snprintf(stage->files[number], NAME_MAX_BYTES, "%s", name);
    HATCH_TRY(hatch_buffer_print(&stage->text, err, "#line 1 %u\n", number));
    const char *at = (const char *)text.data, *end = at + text.size;
    for (unsigned line = 1; at < end; line++) {
        const char *newline = memchr(at, '\n', (size_t)(end - at));
        const char *next = newline ? newline + 1 : end;
        char included[NAME_MAX_BYTES];
        included_name(at, (size_t)(next - at), included);
        if (included[0]) {
            HATCH_TRY(add_file(stage, included, err));
            HATCH_TRY(hatch_buffer_print(&stage->text, err, "#line %u %u\n", line + 1, number));
        } else {
            HATCH_TRY(hatch_buffer_add(&stage->text, at, (size_t)(next - at), err));
        }
        at = next;
    }
    return HATCH_OK;
}

/* Fails with the first line of the compiler's log. It may begin with the numbers of the file and of the line there, as
 * in "0:12(5): error: ..." (Mesa) or "0(12) : error C0000: ..." (NVIDIA), and names the severity, both of which are cut
 * off.
 *   stage  NULL: the log is the linker's */
static enum hatch_status fail_with_log(const struct stage_text *stage, const char *what, const char *log,
                                       struct hatch_err *err)
{
    unsigned file = 0, line = 0;
    const char *error = strstr(log, "error"), *colon = error ? strchr(error, ':') : NULL;
    const char *reason = colon && colon < log + strcspn(log, "\n") ? colon + 1 + strspn(colon + 1, " ") : log;
    bool placed = stage && sscanf(log, "%u%*[:(]%u", &file, &line) == 2 && file < stage->file_count;
    if (placed)
        return hatch_fail_quoting(err, HATCH_BAD_INPUT, reason, "shader %s, line %u: the driver refuses it",
                                  stage->files[file], line);
    return hatch_fail_quoting(err, HATCH_BAD_INPUT, reason, "shader %s: the driver refuses it", what);
}

static enum hatch_status compile(const struct gpu_programs *programs, GLenum kind, const char *name,
                                 const char *defines, GLuint program, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(programs->scratch);
    struct stage_text stage = {.programs = programs, .text = {.arena = programs->scratch}};
    enum hatch_status status =
        hatch_buffer_print(&stage.text, err, "#version 450 core\n%s%s", shader_bindings, defines);
    if (status == HATCH_OK)
        status = add_file(&stage, name, err);
    if (status == HATCH_OK) {
        GLuint shader = glCreateShader(kind);
        const GLchar *text = (const GLchar *)stage.text.data;
        GLint length = (GLint)stage.text.size, good = 0;
        glShaderSource(shader, 1, &text, &length);
        glCompileShader(shader);
        glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
        char log[240] = "";
        if (!good) {
            glGetShaderInfoLog(shader, (GLsizei)sizeof log, NULL, log);
            status = fail_with_log(&stage, name, log, err);
        } else {
            glAttachShader(program, shader);
        }
        glDeleteShader(shader);
    }
    hatch_arena_rewind(programs->scratch, mark);
    return status;
}

static enum hatch_status build(const struct gpu_programs *programs, const struct gpu_stages *stages,
                               const char *defines, GLuint program, struct hatch_err *err)
{
    const struct {
        GLenum kind;
        const char *name;
    } each[] = {{GL_VERTEX_SHADER, stages->vertex},
                {GL_GEOMETRY_SHADER, stages->geometry},
                {GL_FRAGMENT_SHADER, stages->fragment},
                {GL_COMPUTE_SHADER, stages->compute}};
    for (size_t i = 0; i < sizeof each / sizeof *each; i++)
        if (each[i].name)
            HATCH_TRY(compile(programs, each[i].kind, each[i].name, defines, program, err));
    GLint good = 0;
    char log[240] = "";
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &good);
    if (good)
        return HATCH_OK;
    glGetProgramInfoLog(program, (GLsizei)sizeof log, NULL, log);
    return fail_with_log(NULL, stages->fragment ? stages->fragment : stages->compute, log, err);
}

static enum hatch_status make(const struct gpu_programs *programs, const struct gpu_stages *stages, const char *defines,
                              GLuint *program, struct hatch_err *err)
{
    GLuint made = glCreateProgram();
    enum hatch_status status = build(programs, stages, defines, made, err);
    if (status == HATCH_OK)
        *program = made;
    else
        glDeleteProgram(made);
    return status;
}

static bool is_file(const char *a, const char *b)
{
    return a == b || (a && b && strcmp(a, b) == 0);
}

static bool is_made_of(const struct gpu_program *program, const struct gpu_stages *stages, const char *defines)
{
    return is_file(program->stages.vertex, stages->vertex) && is_file(program->stages.geometry, stages->geometry) &&
           is_file(program->stages.fragment, stages->fragment) && is_file(program->stages.compute, stages->compute) &&
           strcmp(program->defines, defines) == 0;
}

enum hatch_status gpu_program_get(struct gpu_programs *programs, const struct gpu_stages *stages, const char *defines,
                                  const struct gpu_program **program, struct hatch_err *err)
{
    struct gpu_program *found = programs->first;
    while (found && !is_made_of(found, stages, defines))
        found = found->next;
    if (!found) {
        char *kept = hatch_arena_text(&programs->keep, defines, strlen(defines), err);
        found = kept ? HATCH_NEW(&programs->keep, struct gpu_program, 1, err) : NULL;
        if (!found)
            return HATCH_LIMIT;
        if (!programs->no_attributes)
            glCreateVertexArrays(1, &programs->no_attributes);
        *found = (struct gpu_program){
            .no_attributes = programs->no_attributes, .stages = *stages, .defines = kept, .next = programs->first};
        HATCH_TRY(make(programs, stages, defines, &found->name, err));
        programs->first = found;
    }
    *program = found;
    return HATCH_OK;
}

enum hatch_status gpu_programs_reload(struct gpu_programs *programs, struct hatch_err *err)
{
    enum hatch_status status = HATCH_OK;
    for (struct gpu_program *program = programs->first; program && status == HATCH_OK; program = program->next)
        status = make(programs, &program->stages, program->defines, &program->fresh, err);
    for (struct gpu_program *program = programs->first; program; program = program->next) {
        GLuint spare = status == HATCH_OK ? program->name : program->fresh;
        program->name = status == HATCH_OK ? program->fresh : program->name;
        program->fresh = 0;
        glDeleteProgram(spare);
    }
    return status;
}

void gpu_programs_free(struct gpu_programs *programs)
{
    for (const struct gpu_program *program = programs->first; program; program = program->next)
        glDeleteProgram(program->name);
    glDeleteVertexArrays(1, &programs->no_attributes);
    programs->no_attributes = 0;
    programs->first = NULL;
    hatch_arena_free(&programs->keep);
}
