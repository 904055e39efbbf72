#include "render-gl/frame/near.h"

#include <stddef.h>

#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/gpu/texture.h"

static void make_array(struct near *near)
{
    static const struct gpu_attribute attributes[] = {
        {ATTRIBUTE_PLACE, 3, GL_FLOAT, offsetof(struct hatch_near_vertex, position)},
        {ATTRIBUTE_FROM, 3, GL_FLOAT, offsetof(struct hatch_near_vertex, place)},
        {ATTRIBUTE_WEIGHT, 3, GL_FLOAT, offsetof(struct hatch_near_vertex, weight)},
        {ATTRIBUTE_CORNER, 3, GL_UNSIGNED_INT, offsetof(struct hatch_near_vertex, corner)},
        {ATTRIBUTE_ORIGIN_U, 4, GL_UNSIGNED_INT, offsetof(struct hatch_near_vertex, origin[0])},
        {ATTRIBUTE_ORIGIN_V, 4, GL_UNSIGNED_INT, offsetof(struct hatch_near_vertex, origin[1])},
        {ATTRIBUTE_ORIGIN_W, 4, GL_UNSIGNED_INT, offsetof(struct hatch_near_vertex, origin[2])}};
    glCreateBuffers(1, &near->buffer);
    glCreateTextures(GL_TEXTURE_BUFFER, NEAR_VIEWS, near->views);
    glCreateVertexArrays(1, &near->array);
    gpu_array_attach(near->array, 0, near->buffer, sizeof(struct hatch_near_vertex), attributes,
                     sizeof attributes / sizeof *attributes);
}

enum hatch_status near_begin(struct near *near, const struct scene *scene, const struct hatch_near_options *options,
                             struct hatch_view *view, struct hatch_err *err)
{
    HATCH_TRY(hatch_near_find(&near->found, &scene->unit, options, view, err));
    if (!near->found.items)
        return HATCH_OK;
    for (uint32_t i = 0; i < scene->unit.item_count; i++)
        if (hatch_near_item_at(&near->found, i)) {
            size_t vertices = scene->unit.meshes[scene->unit.items[i].mesh].mesh->vertex_count;
            HATCH_TRY(gpu_check_texels(vertices * sizeof(struct scene_vertex) / sizeof(float),
                                       "vertices of a mesh that is near the eye", err));
        }
    if (!near->array)
        make_array(near);
    hatch_view_projection(view, options->tile, near->clip_from_camera);
    glNamedBufferData(near->buffer, (GLsizeiptr)(sizeof *near->found.vertices * near->found.vertex_count),
                      near->found.vertices, GL_STREAM_DRAW);
    return HATCH_OK;
}

void near_use(const struct near *near, const struct scene *scene, uint32_t index)
{
    const struct scene_item *item = &scene->items[index];
    const struct hatch_item *unit = &scene->unit.items[index];
    const GLuint vertices = item->posed ? item->posed : scene->meshes[unit->mesh].vertices;
    const GLuint buffers[3] = {vertices, item->uv_tangents, item->repeats};
    for (GLuint i = 0; i < 3; i++) {
        glTextureBuffer(near->views[i], GL_R32F, buffers[i] ? buffers[i] : vertices);
        glBindTextureUnit(UNIT_PIECES + i, near->views[i]);
    }
    if (scene->meshes[unit->mesh].charts) {
        glTextureBuffer(near->views[NEAR_VIEW_CHARTS], GL_R32UI, scene->meshes[unit->mesh].charts);
        glBindTextureUnit(UNIT_CHARTS, near->views[NEAR_VIEW_CHARTS]);
    }
    glUniformMatrix4fv(UNIFORM_CLIP_FROM_CAMERA, 1, GL_FALSE, near->clip_from_camera);
    glUniform4f(UNIFORM_PIECES, item->uv_tangents ? 1.0f : 0.0f, item->repeats ? 1.0f : 0.0f, unit->repeat[0],
                unit->repeat[1]);
}

void near_free(struct near *near)
{
    hatch_near_free(&near->found);
    glDeleteBuffers(1, &near->buffer);
    glDeleteTextures(NEAR_VIEWS, near->views);
    glDeleteVertexArrays(1, &near->array);
    *near = (struct near){.array = 0};
}
