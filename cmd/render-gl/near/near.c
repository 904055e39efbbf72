#include "render-gl/near/near.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "render-gl/near/parts.h"

#define NEAREST 0x1p-60 /* the near plane of an eye on the surface */

static void open_near(struct near *near, uint64_t max_memory)
{
    static const struct {
        GLint size;
        GLenum type;
        GLuint offset;
    } inputs[] = {{3, GL_FLOAT, offsetof(struct near_vertex, place)},
                  {2, GL_FLOAT, offsetof(struct near_vertex, uv)},
                  {3, GL_FLOAT, offsetof(struct near_vertex, weight)},
                  {3, GL_UNSIGNED_INT, offsetof(struct near_vertex, corner)},
                  {4, GL_UNSIGNED_INT, offsetof(struct near_vertex, origin[0])},
                  {4, GL_UNSIGNED_INT, offsetof(struct near_vertex, origin[1])}};
    hatch_arena_init(&near->kept, max_memory);
    hatch_arena_init(&near->posed, max_memory);
    hatch_arena_init(&near->frame, max_memory);
    glCreateBuffers(1, &near->buffer);
    glCreateTextures(GL_TEXTURE_BUFFER, 3, near->views);
    glCreateVertexArrays(1, &near->array);
    glVertexArrayVertexBuffer(near->array, 0, near->buffer, 0, sizeof(struct near_vertex));
    for (GLuint i = 0; i < sizeof inputs / sizeof *inputs; i++) {
        glEnableVertexArrayAttrib(near->array, i);
        if (inputs[i].type == GL_FLOAT)
            glVertexArrayAttribFormat(near->array, i, inputs[i].size, GL_FLOAT, GL_FALSE, inputs[i].offset);
        else
            glVertexArrayAttribIFormat(near->array, i, inputs[i].size, GL_UNSIGNED_INT, inputs[i].offset);
        glVertexArrayAttribBinding(near->array, i, 0);
    }
    near->is_open = true;
}

/* Half of the picture's diagonal and a little more, orthographic. */
static double half_diagonal(const struct hatch_view *view)
{
    return 1.1 * view->half_height * hypot(1, view->aspect);
}

static struct near_frame frame_of(const struct gpu_scene *scene, const struct hatch_view *view,
                                  const struct hatch_tile *tile, uint32_t number)
{
    double reach = hatch_view_float_error(view, tile) / NEAR_PIXELS;
    return (struct near_frame){.scene = scene,
                               .view = view,
                               .reach = view->orthographic ? reach : fmax(reach, 8 * HATCH_VIEW_NEAR),
                               .half = half_diagonal(view),
                               .number = number,
                               .nearest = INFINITY};
}

/* The ranges between the faces that are left out. */
static enum hatch_status set_ranges(const struct near_faces *faces, const struct near_choice *choice,
                                    struct hatch_arena *arena, struct near_cut *cut, struct hatch_err *err)
{
    cut->counts = HATCH_NEW(arena, GLsizei, choice->near_count + (size_t)1, err);
    cut->offsets = cut->counts ? HATCH_NEW(arena, const void *, choice->near_count + (size_t)1, err) : NULL;
    if (!cut->offsets)
        return HATCH_LIMIT;
    uint32_t begin = 0;
    for (uint32_t i = 0; i <= choice->near_count; i++) {
        uint32_t end = i < choice->near_count ? choice->near_faces[i] : faces->count;
        if (end > begin) {
            cut->counts[cut->range_count] = (GLsizei)(3 * (end - begin));
            cut->offsets[cut->range_count++] = (const void *)(3 * sizeof(uint32_t) * (size_t)begin);
        }
        begin = end + 1;
    }
    return HATCH_OK;
}

static enum hatch_status cut_item(struct near *near, struct near_frame *frame, const struct near_wish *wish,
                                  uint32_t index, const struct near_choice choices[2], struct hatch_buffer *buffer,
                                  struct hatch_err *err)
{
    const struct gpu_item *item = &frame->scene->items[index];
    struct near_cut *cuts[2] = {&near->items[index].surface, &near->items[index].patches};
    struct near_faces lists[2];
    int list_count = near_lists(frame->scene, item, lists);
    for (int which = 0; which < list_count; which++) {
        struct near_cut *cut = cuts[which];
        size_t begin = buffer->size / sizeof(struct near_vertex);
        cut->is_cut = choices[0].near_count > 0;
        if (!cut->is_cut)
            continue;
        HATCH_TRY(set_ranges(&lists[which], &choices[which], &near->frame, cut, err));
        HATCH_TRY(near_cut_faces(frame, wish, item, &near->shapes[index], &lists[which], &choices[which], buffer, err));
        cut->first = (GLint)begin;
        cut->count = (GLsizei)(buffer->size / sizeof(struct near_vertex) - begin);
    }
    return HATCH_OK;
}

/* Finds each item's near faces; choices: two an item. */
static enum hatch_status choose(struct near *near, struct near_frame *frame, struct near_choice *choices,
                                struct hatch_err *err)
{
    const struct gpu_scene *scene = frame->scene;
    for (uint32_t i = 0; i < scene->item_count; i++) {
        const struct gpu_item *item = &scene->items[i];
        struct near_faces lists[2];
        if (!near_touches(frame, item))
            continue;
        HATCH_TRY(near_shape_make(scene, item, &near->kept, &near->posed, &near->shapes[i], err));
        int list_count = near_lists(scene, item, lists);
        for (int which = 0; which < list_count; which++)
            HATCH_TRY(near_choose(frame, item, &near->shapes[i], &lists[which], which, &near->kept, &near->frame,
                                  &choices[2 * (size_t)i + (size_t)which], err));
    }
    return HATCH_OK;
}

static void forget_pose(struct near *near, const struct gpu_scene *scene)
{
    if (near->pose_number == scene->pose_number)
        return;
    for (uint32_t i = 0; near->shapes && i < scene->item_count; i++)
        near->shapes[i].positions = NULL;
    hatch_arena_free(&near->posed);
    near->pose_number = scene->pose_number;
}

static bool touches_any(const struct near_frame *frame)
{
    for (uint32_t i = 0; i < frame->scene->item_count; i++)
        if (near_touches(frame, &frame->scene->items[i]))
            return true;
    return false;
}

enum hatch_status near_begin(struct near *near, const struct gpu_scene *scene, const struct near_wish *wish,
                             struct hatch_view *view, uint64_t max_memory, struct hatch_err *err)
{
    struct near_frame frame = frame_of(scene, view, wish->tile, near->frame_number + 1);
    near->items = NULL;
    near->plane = view->near;
    if (!touches_any(&frame))
        return HATCH_OK;
    if (!near->is_open)
        open_near(near, max_memory);
    near->frame_number++;
    forget_pose(near, scene);
    hatch_arena_free(&near->frame);
    if (!near->shapes)
        near->shapes = HATCH_NEW(&near->kept, struct near_shape, scene->item_count, err);
    struct near_choice *choices = HATCH_NEW(&near->frame, struct near_choice, 2 * (size_t)scene->item_count, err);
    if (!near->shapes || !choices)
        return HATCH_LIMIT;
    HATCH_TRY(choose(near, &frame, choices, err));
    if (view->near_is_own && !view->orthographic)
        view->near = near->plane = fmax(fmin(HATCH_VIEW_NEAR, frame.nearest / 8), NEAREST);
    if (!wish->pieces)
        return HATCH_OK;
    struct hatch_buffer buffer = {.arena = &near->frame};
    near->items = HATCH_NEW(&near->frame, struct near_item, scene->item_count, err);
    enum hatch_status status = near->items ? HATCH_OK : HATCH_LIMIT;
    for (uint32_t i = 0; status == HATCH_OK && i < scene->item_count; i++)
        status = cut_item(near, &frame, wish, i, choices + 2 * (size_t)i, &buffer, err);
    if (status != HATCH_OK) {
        near->items = NULL;
        return status;
    }
    hatch_view_lens(view, wish->tile, near->lens);
    glNamedBufferData(near->buffer, (GLsizeiptr)buffer.size, buffer.data, GL_STREAM_DRAW);
    return HATCH_OK;
}

const struct near_item *near_find(const struct near *near, uint32_t item)
{
    return near->items && near->items[item].surface.is_cut ? &near->items[item] : NULL;
}

void near_use(const struct near *near, const struct gpu_scene *scene, const struct gpu_item *item)
{
    const GLuint vertices = item->posed ? item->posed : scene->meshes[item->mesh].vertices;
    const GLuint buffers[3] = {vertices, item->spans, item->repeats};
    for (GLuint i = 0; i < 3; i++) {
        glTextureBuffer(near->views[i], GL_R32F, buffers[i] ? buffers[i] : vertices);
        glBindTextureUnit(NEAR_UNIT + i, near->views[i]);
    }
    glUniformMatrix4fv(NEAR_UNIFORM_LENS, 1, GL_FALSE, near->lens);
    glUniform4f(NEAR_UNIFORM_HAS, item->spans ? 1.0f : 0.0f, item->repeats ? 1.0f : 0.0f, item->repeat[0],
                item->repeat[1]);
}

void near_free(struct near *near)
{
    if (!near->is_open)
        return;
    hatch_arena_free(&near->kept);
    hatch_arena_free(&near->posed);
    hatch_arena_free(&near->frame);
    glDeleteBuffers(1, &near->buffer);
    glDeleteTextures(3, near->views);
    glDeleteVertexArrays(1, &near->array);
    *near = (struct near){.is_open = false};
}
