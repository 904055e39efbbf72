/* Which faces are near. */
#include <math.h>
#include <string.h>

#include "math/box.h"
#include "math/vector.h"
#include "near/pieces.h"
#include "render-gl/near/parts.h"

/* From the eye; for an orthographic view from the axis of the picture. */
static void from_eye(const struct near_frame *frame, const double point[3], double out[3])
{
    double from[3];
    const struct hatch_view *view = frame->view;
    for (int k = 0; k < 3; k++)
        from[k] = point[k] - view->eye[k];
    if (!view->orthographic) {
        hatch_vec_copy(from, out);
        return;
    }
    out[0] = hatch_vec_dot(from, view->right);
    out[1] = hatch_vec_dot(from, view->up);
    out[2] = 0;
}

/* How much farther than usual an item's texture coordinates reach. */
static double reach_of(const struct near_frame *frame, const struct gpu_item *item)
{
    const struct gpu_scene *scene = frame->scene;
    double scale = 1 / scene->bounds.radius;
    if (!item->posed) {
        scale = 0;
        for (int c = 0; c < 3; c++)
            for (int r = 0; r < 3; r++)
                scale += (double)item->to_unit[4 * c + r] * (double)item->to_unit[4 * c + r] / 3;
        scale = sqrt(scale);
    }
    double reach = frame->reach * fmax(1, 0.5 * item->uv_reach * scale);
    if (!frame->view->orthographic)
        return reach;
    return reach > 1 ? frame->half : 0;
}

static bool ball_touches(const struct near_frame *frame, const struct near_ball *ball, double reach)
{
    double at[3];
    from_eye(frame, ball->center, at);
    return hatch_vec_length(at) - ball->radius < reach;
}

int near_lists(const struct gpu_scene *scene, const struct gpu_item *item, struct near_faces lists[2])
{
    const struct gpu_mesh *mesh = &scene->meshes[item->mesh];
    const struct hatch_mesh *joined = &scene->scene->meshes[item->mesh].mesh;
    lists[0] = (struct near_faces){mesh->surface->indices, mesh->patches ? mesh->patches->vertex_of : NULL,
                                   mesh->surface->face_count};
    lists[1] = (struct near_faces){joined->indices, NULL, joined->face_count};
    return mesh->patches ? 2 : 1;
}

static void corner_in_unit(const struct gpu_scene *scene, const struct near_shape *shape, uint32_t vertex,
                           double point[3])
{
    for (int k = 0; k < 3; k++)
        point[k] = (shape->positions[3 * (size_t)vertex + (size_t)k] - scene->bounds.center[k]) / scene->bounds.radius;
}

static struct near_ball ball_around(const double low[3], const double high[3])
{
    struct near_ball ball;
    double half[3];
    for (int k = 0; k < 3; k++) {
        ball.center[k] = 0.5 * low[k] + 0.5 * high[k];
        half[k] = 0.5 * high[k] - 0.5 * low[k];
    }
    ball.radius = hatch_vec_length(half);
    return ball;
}

bool near_touches(const struct near_frame *frame, const struct gpu_item *item)
{
    const struct near_ball ball = ball_around(item->low, item->high);
    double reach = reach_of(frame, item), square = 0;
    for (int k = 0; k < 3 && !frame->view->orthographic; k++) {
        double eye = frame->view->eye[k], out = fmax(fmax(item->low[k] - eye, eye - item->high[k]), 0);
        square += out * out;
    }
    return sqrt(square) < reach && ball_touches(frame, &ball, reach);
}

static void set_block(const struct gpu_scene *scene, const struct near_shape *shape, const struct near_faces *faces,
                      size_t first, struct near_ball *ball)
{
    struct hatch_box box = {.any = false};
    for (size_t i = 0; i < 3 * NEAR_BLOCK && first + i / 3 < faces->count; i++) {
        double at[3];
        corner_in_unit(scene, shape, near_corner(faces, first + i / 3, i % 3), at);
        hatch_box_add(&box, at);
    }
    *ball = ball_around(box.low, box.high);
}

static enum hatch_status make_posed(const struct gpu_scene *scene, const struct gpu_item *item,
                                    struct hatch_arena *posed, struct near_shape *shape, struct hatch_err *err)
{
    struct near_shape made = *shape;
    struct near_faces lists[2];
    struct hatch_pose pose = scene->pose;
    made.positions = HATCH_NEW(posed, double, 3 * (size_t)scene->scene->meshes[item->mesh].mesh.vertex_count, err);
    if (!made.positions)
        return HATCH_LIMIT;
    hatch_pose_vertices(&pose, item->node, item->mesh, made.positions, NULL);
    int list_count = near_lists(scene, item, lists);
    for (int which = 0; which < list_count; which++) {
        size_t blocks = (lists[which].count + (size_t)NEAR_BLOCK - 1) / NEAR_BLOCK;
        made.blocks[which] = HATCH_NEW(posed, struct near_ball, blocks, err);
        if (!made.blocks[which])
            return HATCH_LIMIT;
        for (size_t block = 0; block < blocks; block++)
            set_block(scene, &made, &lists[which], NEAR_BLOCK * block, &made.blocks[which][block]);
    }
    *shape = made;
    return HATCH_OK;
}

enum hatch_status near_shape_make(const struct gpu_scene *scene, const struct gpu_item *item, struct hatch_arena *kept,
                                  struct hatch_arena *posed, struct near_shape *shape, struct hatch_err *err)
{
    size_t count = scene->scene->meshes[item->mesh].mesh.vertex_count;
    if (item->repeats && shape->repeats_set != item->repeats_set) {
        shape->repeats = HATCH_NEW(kept, float, 2 * count, err);
        if (!shape->repeats)
            return HATCH_LIMIT;
        glGetNamedBufferSubData(item->repeats, 0, (GLsizeiptr)(2 * sizeof(float) * count), shape->repeats);
    }
    if (!item->repeats)
        shape->repeats = NULL;
    shape->repeats_set = item->repeats_set;
    return shape->positions ? HATCH_OK : make_posed(scene, item, posed, shape, err);
}

static enum hatch_status make_points(const struct hatch_mesh *mesh, struct hatch_arena *kept, struct near_shape *shape,
                                     struct hatch_err *err)
{
    uint32_t count, *points = HATCH_NEW(kept, uint32_t, mesh->vertex_count, err);
    shape->marks = points ? HATCH_NEW(kept, uint32_t, mesh->vertex_count, err) : NULL;
    if (!shape->marks)
        return HATCH_LIMIT;
    HATCH_TRY(hatch_mesh_weld(mesh, kept, points, &count, err));
    shape->points = points;
    return HATCH_OK;
}

static bool face_is_near(struct near_frame *frame, const struct near_shape *shape, const struct near_faces *faces,
                         size_t face, double reach)
{
    double unit[3], corner[3][3];
    for (size_t k = 0; k < 3; k++) {
        corner_in_unit(frame->scene, shape, near_corner(faces, face, k), unit);
        from_eye(frame, unit, corner[k]);
    }
    double distance = hatch_piece_distance((const double(*)[3])corner);
    frame->nearest = fmin(frame->nearest, distance);
    return distance < reach;
}

static void mark_face(const struct near_frame *frame, const struct near_shape *shape, const struct near_faces *faces,
                      size_t face, struct hatch_box *marked)
{
    for (size_t k = 0; k < 3; k++) {
        uint32_t vertex = near_corner(faces, face, k);
        double unit[3];
        shape->marks[shape->points[vertex]] = frame->number;
        corner_in_unit(frame->scene, shape, vertex, unit);
        hatch_box_add(marked, unit);
    }
}

static bool ball_meets(const struct near_ball *ball, const struct hatch_box *marked)
{
    double square = 0;
    for (int k = 0; k < 3; k++) {
        double out = fmax(fmax(marked->low[k] - ball->center[k], ball->center[k] - marked->high[k]), 0);
        square += out * out;
    }
    return marked->any && sqrt(square) <= ball->radius + 1e-6;
}

static uint32_t block_end(const struct near_faces *faces, uint32_t begin)
{
    return faces->count - begin < NEAR_BLOCK ? faces->count : begin + NEAR_BLOCK;
}

/* Near faces, and those that share a point with one. */
static void choose_ring(const struct near_frame *frame, const struct near_shape *shape, const struct near_faces *faces,
                        int which, const struct hatch_box *marked, struct near_choice *choice)
{
    for (uint32_t begin = 0; begin < faces->count; begin = block_end(faces, begin)) {
        if (!ball_meets(&shape->blocks[which][begin / NEAR_BLOCK], marked))
            continue;
        for (uint32_t face = begin; face < block_end(faces, begin); face++) {
            bool touches = false;
            for (size_t k = 0; k < 3; k++)
                touches |= shape->marks[shape->points[near_corner(faces, face, k)]] == frame->number;
            if (touches)
                choice->piece_faces[choice->piece_count++] = face;
        }
    }
}

/* Room for all the faces of the blocks that a ball, or a box where there is one, touches. */
static enum hatch_status make_room(const struct near_frame *frame, const struct near_ball *blocks, uint32_t face_count,
                                   double reach, const struct hatch_box *box, struct hatch_arena *arena,
                                   uint32_t **faces, struct hatch_err *err)
{
    size_t count = 0;
    for (uint32_t i = 0; i < (face_count + NEAR_BLOCK - 1) / NEAR_BLOCK; i++)
        count += box ? ball_meets(&blocks[i], box) : ball_touches(frame, &blocks[i], reach);
    *faces = HATCH_NEW(arena, uint32_t, NEAR_BLOCK * count, err);
    return *faces ? HATCH_OK : HATCH_LIMIT;
}

enum hatch_status near_choose(struct near_frame *frame, const struct gpu_item *item, struct near_shape *shape,
                              const struct near_faces *faces, int which, struct hatch_arena *kept,
                              struct hatch_arena *arena, struct near_choice *choice, struct hatch_err *err)
{
    const struct near_ball *blocks = shape->blocks[which];
    struct hatch_box marked = {.any = false};
    double reach = reach_of(frame, item);
    *choice = (struct near_choice){.near_count = 0};
    HATCH_TRY(make_room(frame, blocks, faces->count, reach, NULL, arena, &choice->near_faces, err));
    for (uint32_t begin = 0; begin < faces->count; begin = block_end(faces, begin)) {
        if (!ball_touches(frame, &blocks[begin / NEAR_BLOCK], reach))
            continue;
        for (uint32_t face = begin; face < block_end(faces, begin); face++)
            if (face_is_near(frame, shape, faces, face, reach))
                choice->near_faces[choice->near_count++] = face;
    }
    if (!choice->near_count)
        return HATCH_OK;
    if (!shape->points)
        HATCH_TRY(make_points(&frame->scene->scene->meshes[item->mesh].mesh, kept, shape, err));
    for (uint32_t i = 0; i < choice->near_count; i++)
        mark_face(frame, shape, faces, choice->near_faces[i], &marked);
    HATCH_TRY(make_room(frame, blocks, faces->count, reach, &marked, arena, &choice->piece_faces, err));
    choose_ring(frame, shape, faces, which, &marked, choice);
    return HATCH_OK;
}
