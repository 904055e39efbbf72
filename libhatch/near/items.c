#include "near/parts.h"

#define NEAREST 0x1p-60 /* least distance of the near plane, for an eye that is on a surface */

/* Returns half the picture's diagonal plus a margin, for an orthographic view. */
static double half_diagonal(const struct hatch_view *view)
{
    return 1.1 * view->half_height * hypot(1, view->aspect);
}

static struct hatch_near_frame frame_of(struct hatch_near *near, const struct hatch_unit_scene *scene,
                                        const struct hatch_near_options *options, const struct hatch_view *view)
{
    double reach = hatch_view_float_error(view, options->tile) / HATCH_NEAR_PIXELS;
    return (struct hatch_near_frame){.near = near,
                                     .scene = scene,
                                     .options = options,
                                     .view = view,
                                     .reach = view->orthographic ? reach : fmax(reach, 8 * HATCH_VIEW_NEAR),
                                     .half_diagonal = half_diagonal(view),
                                     .nearest = INFINITY};
}

/* Sets the ranges of the index buffer that contain no near faces. */
static enum hatch_status set_ranges(const struct hatch_near_faces *faces, const struct hatch_near_choice *choice,
                                    struct hatch_arena *arena, struct hatch_near_cut *cut, struct hatch_err *err)
{
    HATCH_TRY(HATCH_ALLOC(arena, &cut->counts, choice->near_count + (size_t)1, err));
    HATCH_TRY(HATCH_ALLOC(arena, &cut->offsets, choice->near_count + (size_t)1, err));
    uint32_t begin = 0;
    for (uint32_t i = 0; i <= choice->near_count; i++) {
        uint32_t end = i < choice->near_count ? choice->near_faces[i] : faces->count;
        if (end > begin) {
            cut->counts[cut->range_count] = (int)(3 * (end - begin));
            cut->offsets[cut->range_count++] = (const void *)(3 * sizeof(uint32_t) * (size_t)begin);
        }
        begin = end + 1;
    }
    return HATCH_OK;
}

static enum hatch_status cut_item(struct hatch_near_frame *frame, uint32_t item,
                                  const struct hatch_near_choice choices[HATCH_NEAR_LISTS], struct hatch_buffer *buffer,
                                  struct hatch_err *err)
{
    struct hatch_near *near = frame->near;
    struct hatch_near_cut *cuts[HATCH_NEAR_LISTS] = {&near->items[item].surface, &near->items[item].patches};
    struct hatch_near_target lists[HATCH_NEAR_LISTS];
    int list_count = hatch_near_lists(frame, item, lists);
    for (int list = 0; list < list_count && choices[0].near_count > 0; list++) {
        struct hatch_near_cut *cut = cuts[list];
        size_t begin = buffer->size / sizeof(struct hatch_near_vertex);
        cut->is_cut = true;
        HATCH_TRY(set_ranges(&lists[list].faces, &choices[list], &near->frame, cut, err));
        HATCH_TRY(hatch_near_cut_faces(frame, &lists[list], &choices[list], buffer, err));
        cut->first = (int)begin;
        cut->count = (int)(buffer->size / sizeof(struct hatch_near_vertex) - begin);
    }
    return HATCH_OK;
}

/* Finds the near faces of each item.
 *   choices  out: HATCH_NEAR_LISTS per item */
static enum hatch_status choose(struct hatch_near_frame *frame, struct hatch_near_choice *choices,
                                struct hatch_err *err)
{
    for (uint32_t i = 0; i < frame->scene->item_count; i++) {
        struct hatch_near_target lists[HATCH_NEAR_LISTS];
        if (!hatch_near_touches(frame, &frame->scene->items[i]))
            continue;
        HATCH_TRY(hatch_near_shape_make(frame, i, err));
        int list_count = hatch_near_lists(frame, i, lists);
        for (int list = 0; list < list_count; list++)
            HATCH_TRY(
                hatch_near_choose(frame, &lists[list], &choices[HATCH_NEAR_LISTS * (size_t)i + (size_t)list], err));
    }
    return HATCH_OK;
}

static enum hatch_status cut_all(struct hatch_near_frame *frame, const struct hatch_near_choice *choices,
                                 struct hatch_err *err)
{
    struct hatch_near *near = frame->near;
    struct hatch_buffer buffer = {.arena = &near->frame};
    near->items = HATCH_NEW(&near->frame, struct hatch_near_item, frame->scene->item_count, err);
    enum hatch_status status = near->items ? HATCH_OK : HATCH_LIMIT;
    for (uint32_t i = 0; status == HATCH_OK && i < frame->scene->item_count; i++)
        status = cut_item(frame, i, choices + HATCH_NEAR_LISTS * (size_t)i, &buffer, err);
    if (status != HATCH_OK)
        near->items = NULL;
    near->vertices = (struct hatch_near_vertex *)buffer.data;
    near->vertex_count = buffer.size / sizeof(struct hatch_near_vertex);
    return status;
}

/* Drops the data of the previous pose if the pose has changed. */
static void drop_old_pose(struct hatch_near *near, const struct hatch_unit_scene *scene)
{
    if (near->pose_number == scene->pose_number)
        return;
    for (uint32_t i = 0; near->shapes && i < scene->item_count; i++)
        near->shapes[i].positions = NULL;
    hatch_arena_free(&near->posed);
    near->pose_number = scene->pose_number;
}

static bool touches_any(const struct hatch_near_frame *frame)
{
    for (uint32_t i = 0; i < frame->scene->item_count; i++)
        if (hatch_near_touches(frame, &frame->scene->items[i]))
            return true;
    return false;
}

static void begin_frame(struct hatch_near *near, const struct hatch_unit_scene *scene, uint64_t max_memory)
{
    if (!near->is_open) {
        hatch_arena_init(&near->kept, max_memory);
        hatch_arena_init(&near->posed, max_memory);
        hatch_arena_init(&near->frame, max_memory);
        near->is_open = true;
    }
    near->frame_number++;
    drop_old_pose(near, scene);
    hatch_arena_free(&near->frame);
}

enum hatch_status hatch_near_find(struct hatch_near *near, const struct hatch_unit_scene *scene,
                                  const struct hatch_near_options *options, struct hatch_view *view,
                                  struct hatch_err *err)
{
    struct hatch_near_frame frame = frame_of(near, scene, options, view);
    near->items = NULL;
    near->vertex_count = 0;
    if (!touches_any(&frame))
        return HATCH_OK;
    begin_frame(near, scene, options->max_memory);
    struct hatch_near_choice *choices;
    if (!near->shapes)
        HATCH_TRY(HATCH_ALLOC(&near->kept, &near->shapes, scene->item_count, err));
    HATCH_TRY(HATCH_ALLOC(&near->frame, &choices, HATCH_NEAR_LISTS * (size_t)scene->item_count, err));
    HATCH_TRY(choose(&frame, choices, err));
    if (view->near_is_automatic && !view->orthographic)
        view->near = fmax(fmin(HATCH_VIEW_NEAR, frame.nearest / 8), NEAREST);
    return options->places != HATCH_NEAR_NONE ? cut_all(&frame, choices, err) : HATCH_OK;
}

const struct hatch_near_item *hatch_near_item_at(const struct hatch_near *near, uint32_t item)
{
    return near->items && near->items[item].surface.is_cut ? &near->items[item] : NULL;
}

void hatch_near_free(struct hatch_near *near)
{
    if (near->is_open) {
        hatch_arena_free(&near->kept);
        hatch_arena_free(&near->posed);
        hatch_arena_free(&near->frame);
    }
    *near = (struct hatch_near){.is_open = false};
}
