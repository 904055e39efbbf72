/* Finds near faces. */
#include <math.h>

#include "math/box.h"
#include "math/vector.h"
#include "near/subdivide.h"
#include "near/parts.h"

/* Computes the vector from the eye to a point; for an orthographic view, the vector from the view axis, as coordinates
 * to the right and up. */
static void from_eye(const struct hatch_near_frame *frame, const double point[3], double out[3])
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

/* Returns the distance within which an item's faces are near. It increases with the size of the item's texture
 * coordinates, because their rounding errors are then visible from further away. */
static double reach_of(const struct hatch_near_frame *frame, const struct hatch_item *item)
{
    const struct hatch_unit_scene *scene = frame->scene;
    double scale = 1 / scene->bounds.radius;
    if (!item->deformed) {
        scale = 0;
        for (int c = 0; c < 3; c++)
            for (int r = 0; r < 3; r++)
                scale += (double)item->to_unit[4 * c + r] * (double)item->to_unit[4 * c + r] / 3;
        scale = sqrt(scale);
    }
    double reach = frame->reach * fmax(1, 0.5 * item->uv_reach * scale);
    if (!frame->view->orthographic)
        return reach;
    return reach > 1 ? frame->half_diagonal : 0;
}

static bool sphere_touches(const struct hatch_near_frame *frame, const struct hatch_near_sphere *sphere, double reach)
{
    double at[3];
    from_eye(frame, sphere->center, at);
    return hatch_vec_length(at) - sphere->radius < reach;
}

int hatch_near_lists(const struct hatch_near_frame *frame, uint32_t item,
                     struct hatch_near_target lists[HATCH_NEAR_LISTS])
{
    const struct hatch_unit_mesh *mesh = &frame->scene->meshes[frame->scene->items[item].mesh];
    for (int list = 0; list < HATCH_NEAR_LISTS; list++)
        lists[list] = (struct hatch_near_target){
            .item = &frame->scene->items[item], .shape = &frame->near->shapes[item], .list = list};
    lists[HATCH_NEAR_SURFACE].faces = (struct hatch_near_faces){
        mesh->surface->indices, mesh->patches ? mesh->patches->vertex_of : NULL, mesh->surface->face_count};
    lists[HATCH_NEAR_PATCHES].faces = (struct hatch_near_faces){mesh->mesh->indices, NULL, mesh->mesh->face_count};
    return mesh->patches ? HATCH_NEAR_LISTS : 1;
}

static void corner_in_unit(const struct hatch_unit_scene *scene, const struct hatch_near_shape *shape, uint32_t vertex,
                           double point[3])
{
    hatch_bounds_to_unit(&scene->bounds, shape->positions + 3 * (size_t)vertex, point);
}

static struct hatch_near_sphere sphere_around(const double low[3], const double high[3])
{
    struct hatch_near_sphere sphere;
    double half[3];
    for (int k = 0; k < 3; k++) {
        sphere.center[k] = 0.5 * low[k] + 0.5 * high[k];
        half[k] = 0.5 * high[k] - 0.5 * low[k];
    }
    sphere.radius = hatch_vec_length(half);
    return sphere;
}

bool hatch_near_touches(const struct hatch_near_frame *frame, const struct hatch_item *item)
{
    const struct hatch_near_sphere sphere = sphere_around(item->low, item->high);
    double reach = reach_of(frame, item), square = 0;
    for (int k = 0; k < 3 && !frame->view->orthographic; k++) {
        double eye = frame->view->eye[k], out = fmax(fmax(item->low[k] - eye, eye - item->high[k]), 0);
        square += out * out;
    }
    return sqrt(square) < reach && sphere_touches(frame, &sphere, reach);
}

static void set_block(const struct hatch_unit_scene *scene, const struct hatch_near_shape *shape,
                      const struct hatch_near_faces *faces, size_t first, struct hatch_near_sphere *sphere)
{
    struct hatch_box box = {.any = false};
    for (size_t i = 0; i < 3 * HATCH_NEAR_BLOCK && first + i / 3 < faces->count; i++) {
        double at[3];
        corner_in_unit(scene, shape, hatch_near_corner(faces, first + i / 3, i % 3), at);
        hatch_box_add(&box, at);
    }
    *sphere = sphere_around(box.low, box.high);
}

enum hatch_status hatch_near_shape_make(struct hatch_near_frame *frame, uint32_t item, struct hatch_err *err)
{
    const struct hatch_unit_scene *scene = frame->scene;
    const struct hatch_item *from = &scene->items[item];
    struct hatch_near_shape made = frame->near->shapes[item];
    struct hatch_near_target lists[HATCH_NEAR_LISTS];
    struct hatch_arena *posed = &frame->near->posed;
    struct hatch_pose pose = scene->pose; /* hatch_pose_vertices writes to its scratch arrays only */
    if (made.positions)
        return HATCH_OK;
    HATCH_TRY(HATCH_ALLOC(posed, &made.positions, 3 * (size_t)scene->meshes[from->mesh].mesh->vertex_count, err));
    hatch_pose_vertices(&pose, from->node, from->mesh, made.positions, NULL);
    int list_count = hatch_near_lists(frame, item, lists);
    for (int list = 0; list < list_count; list++) {
        const struct hatch_near_faces *faces = &lists[list].faces;
        size_t blocks = (faces->count + (size_t)HATCH_NEAR_BLOCK - 1) / HATCH_NEAR_BLOCK;
        HATCH_TRY(HATCH_ALLOC(posed, &made.blocks[list], blocks, err));
        for (size_t block = 0; block < blocks; block++)
            set_block(scene, &made, faces, HATCH_NEAR_BLOCK * block, &made.blocks[list][block]);
    }
    frame->near->shapes[item] = made;
    return HATCH_OK;
}

/* Welds the vertices of an item. */
static enum hatch_status make_points(const struct hatch_mesh *mesh, struct hatch_arena *kept,
                                     struct hatch_near_shape *shape, struct hatch_err *err)
{
    uint32_t count, *points;
    HATCH_TRY(HATCH_ALLOC(kept, &points, mesh->vertex_count, err));
    HATCH_TRY(HATCH_ALLOC(kept, &shape->marks, mesh->vertex_count, err));
    HATCH_TRY(hatch_mesh_weld(mesh, kept, points, &count, err));
    shape->points = points;
    return HATCH_OK;
}

/* Returns whether a face is near, and updates frame->nearest. */
static bool face_is_near(struct hatch_near_frame *frame, const struct hatch_near_shape *shape,
                         const struct hatch_near_faces *faces, size_t face, double reach)
{
    double unit[3], corner[3][3];
    for (size_t k = 0; k < 3; k++) {
        corner_in_unit(frame->scene, shape, hatch_near_corner(faces, face, k), unit);
        from_eye(frame, unit, corner[k]);
    }
    double distance = hatch_piece_distance((const double(*)[3])corner);
    frame->nearest = fmin(frame->nearest, distance);
    return distance < reach;
}

/* Marks the points of a near face, and extends the box of marked points. */
static void mark_face(const struct hatch_near_frame *frame, const struct hatch_near_shape *shape,
                      const struct hatch_near_faces *faces, size_t face, struct hatch_box *marked)
{
    for (size_t k = 0; k < 3; k++) {
        uint32_t vertex = hatch_near_corner(faces, face, k);
        double unit[3];
        shape->marks[shape->points[vertex]] = frame->near->frame_number;
        corner_in_unit(frame->scene, shape, vertex, unit);
        hatch_box_add(marked, unit);
    }
}

static bool sphere_meets(const struct hatch_near_sphere *sphere, const struct hatch_box *marked)
{
    double square = 0;
    for (int k = 0; k < 3; k++) {
        double out = fmax(fmax(marked->low[k] - sphere->center[k], sphere->center[k] - marked->high[k]), 0);
        square += out * out;
    }
    return marked->any && sqrt(square) <= sphere->radius + 1e-6;
}

static uint32_t block_end(const struct hatch_near_faces *faces, uint32_t begin)
{
    return faces->count - begin < HATCH_NEAR_BLOCK ? faces->count : begin + HATCH_NEAR_BLOCK;
}

/* Chooses the near faces, and the faces that share a point with one of them. */
static void choose_ring(const struct hatch_near_frame *frame, const struct hatch_near_target *target,
                        const struct hatch_box *marked, struct hatch_near_choice *choice)
{
    const struct hatch_near_shape *shape = target->shape;
    const struct hatch_near_faces *faces = &target->faces;
    for (uint32_t begin = 0; begin < faces->count; begin = block_end(faces, begin)) {
        if (!sphere_meets(&shape->blocks[target->list][begin / HATCH_NEAR_BLOCK], marked))
            continue;
        for (uint32_t face = begin; face < block_end(faces, begin); face++) {
            bool touches = false;
            for (size_t k = 0; k < 3; k++)
                touches |= shape->marks[shape->points[hatch_near_corner(faces, face, k)]] == frame->near->frame_number;
            if (touches)
                choice->piece_faces[choice->piece_count++] = face;
        }
    }
}

/* Allocates room for all faces of the blocks within reach.
 *   box  not NULL: for all faces of the blocks that meet this box, instead */
static enum hatch_status make_room(const struct hatch_near_frame *frame, const struct hatch_near_target *target,
                                   double reach, const struct hatch_box *box, uint32_t **faces, struct hatch_err *err)
{
    const struct hatch_near_sphere *blocks = target->shape->blocks[target->list];
    size_t count = 0;
    for (uint32_t i = 0; i < (target->faces.count + HATCH_NEAR_BLOCK - 1) / HATCH_NEAR_BLOCK; i++)
        count += box ? sphere_meets(&blocks[i], box) : sphere_touches(frame, &blocks[i], reach);
    return HATCH_ALLOC(&frame->near->frame, faces, HATCH_NEAR_BLOCK * count, err);
}

enum hatch_status hatch_near_choose(struct hatch_near_frame *frame, const struct hatch_near_target *target,
                                    struct hatch_near_choice *choice, struct hatch_err *err)
{
    struct hatch_near_shape *shape = target->shape;
    const struct hatch_near_faces *faces = &target->faces;
    struct hatch_box marked = {.any = false};
    double reach = reach_of(frame, target->item);
    *choice = (struct hatch_near_choice){.near_count = 0};
    HATCH_TRY(make_room(frame, target, reach, NULL, &choice->near_faces, err));
    for (uint32_t begin = 0; begin < faces->count; begin = block_end(faces, begin)) {
        if (!sphere_touches(frame, &shape->blocks[target->list][begin / HATCH_NEAR_BLOCK], reach))
            continue;
        for (uint32_t face = begin; face < block_end(faces, begin); face++)
            if (face_is_near(frame, shape, faces, face, reach))
                choice->near_faces[choice->near_count++] = face;
    }
    if (!choice->near_count)
        return HATCH_OK;
    if (!shape->points)
        HATCH_TRY(make_points(frame->scene->meshes[target->item->mesh].mesh, &frame->near->kept, shape, err));
    for (uint32_t i = 0; i < choice->near_count; i++)
        mark_face(frame, shape, faces, choice->near_faces[i], &marked);
    HATCH_TRY(make_room(frame, target, reach, &marked, &choice->piece_faces, err));
    choose_ring(frame, target, &marked, choice);
    return HATCH_OK;
}
